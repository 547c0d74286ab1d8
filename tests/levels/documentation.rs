//! docs/levels.md holds the tables that the schema makes.

use crate::package;
use resultant::level::schema::documentation;

const BEGIN: &str = "<!-- The tables begin. They are made of src/level/schema. -->\n";
const END: &str = "<!-- The tables end. -->\n";

/// With `BLESS=1` in the environment the test writes the tables into the page.
#[test]
fn the_page_of_levels_has_the_tables_of_the_schema() {
    let path = package().join("docs/levels.md");
    let page = std::fs::read_to_string(&path).unwrap();
    let (before, rest) = page.split_once(BEGIN).expect("the tables begin somewhere");
    let (tables, after) = rest.split_once(END).expect("the tables end somewhere");
    let made = format!("\n{}\n", documentation());
    if std::env::var_os("BLESS").is_some() {
        std::fs::write(&path, format!("{before}{BEGIN}{made}{END}{after}")).unwrap();
        return;
    }
    assert!(tables == made, "docs/levels.md is stale: run `BLESS=1 cargo test --test levels documentation`");
}
