//! A file of its kind's largest size is read in work proportional to its length, however it is made. Before there were limits, the work
//! grew with the square of the length.

use crate::support::Memory;
use cpu_time::ThreadTime;
use resultant::lab::charts::Charts;
use resultant::lab::drawing::picture;
use resultant::lab::{kept, report};
use resultant::scores::board;
use resultant::{files, game, level};
use std::hint::black_box;
use std::path::Path;

/// The most that reading a text may cost, in passes over its bytes. The dearest one here costs a tenth of it; quadratic work cost a pass
/// for every few bytes.
const MOST_PASSES: f64 = 4000.0;
/// The measured passes go over this many bytes: far more than the grain of the clock.
const MEASURED: usize = 16 << 20;

/// The answer of `read`, and the assertion that it cost few passes over the text. The clock counts this thread's time on the processor,
/// which goes on only while the thread runs.
#[allow(clippy::disallowed_methods)] // two measures of one thread's own time are compared
fn quick<T>(what: &str, text: &str, read: impl FnOnce() -> T) -> T {
    let begun = ThreadTime::now();
    let answer = read();
    let taken = begun.elapsed();
    let times = MEASURED.div_ceil(text.len()) as u32;
    let begun = ThreadTime::now();
    for _ in 0..times {
        black_box(black_box(text).bytes().fold(0_u32, |sum, byte| sum.wrapping_mul(31).wrapping_add(byte.into())));
    }
    let passes = taken.div_duration_f64(begun.elapsed() / times);
    assert!(passes < MOST_PASSES, "{what} cost {passes:.0} passes over its {} bytes", text.len());
    answer
}

fn filled(row: &str, bytes: u64) -> String {
    row.repeat(bytes as usize / row.len())
}

#[test]
fn scores() {
    // The last one leaves each line end within quotes, whether the line begins so or not.
    for row in ["\"", "\"\n", "\"\"\"\n", ",\"", "a\n", "a,1\n", "\n", ",", "\"\",", "\"\r", "\"a\"b\"\n", "\"\"x\",\"\n"] {
        let text = filled(row, files::SCORES);
        quick(&format!("{row:?}"), &text, || board::read(Path::new("1.csv"), text.as_bytes()));
    }
    let users: String = (0..25_000).map(|i| format!("user{i},{}\n", i + 1)).collect();
    let (board, damage) = quick("users", &users, || board::read(Path::new("1.csv"), users.as_bytes()));
    assert_eq!((board.rows().len(), damage.len()), (25_000, 0));
}

#[test]
fn level_tables() {
    let size = files::LEVEL_TABLE;
    let half = size / 2;
    let wide = |columns: &str, row: &str| format!("x,y,width,height{}\n{}", filled(columns, half), filled(row, half));
    let tables = [
        ("world.csv", filled("0,0,1,1\n", size)),
        ("world.csv", filled("x\n", size)),
        ("world.csv", filled(",1", size)),
        ("world.csv", filled(";", size)),
        ("world.csv", wide(",a", "1,1,1,1\n")),
        ("world.csv", wide(",a,x", "1,1\n")),
        ("world.csv", format!("x,y,width,height{}\n{}", ",a".repeat(190), filled("1\n", half))),
        ("texts.csv", filled("\"", size)),
        ("texts.csv", filled("\"\"x\",\"\n", size)),
        ("objectives.csv", filled("PLAYER,1,1,1,1\n", size)),
        ("objects.csv", filled("100,100,box:9x9,1,1,TRUE,0\n", size)),
        ("objects.csv", filled("100,100,a.png,1,1,TRUE,0\n", size)),
        ("constants.csv", filled("gravity,1\n", size)),
        ("hazards.csv", filled("0,0,1,1,1,0,1,1\n", size)),
    ];
    for (file, text) in tables {
        let begins: String = text.lines().next().unwrap_or_default().chars().take(40).collect();
        let all = vec![
            (file, text.clone()),
            ("constants.csv", "width,3000\nheight,3000\n".to_owned()),
            ("player.csv", "1500,1500,100,500,3000\n".to_owned()),
            ("objectives.csv", "PLAYER,10,10,20,20\n".to_owned()),
        ];
        let problems = quick(&begins, &text, || level::read("l", &Memory(all))).map_or_else(|problems| problems.len(), |_| 0);
        assert!(problems <= 1001, "{begins}: {problems} problems");
    }
}

#[test]
fn inputs() {
    for row in ["x\n", "1,0,0,0,0\n", ",", "#\n", "\n"] {
        let text = format!("{}\n{}", game::HEADER, filled(row, files::INPUTS / 8));
        let _ = quick(row, &text, || game::Inputs::parse("in.csv", &text));
        let _ = quick(row, &text, || game::Replay::parse("in.csv", &text));
    }
}

/// The charts that come with the game, one file of them replaced.
fn charts(name: &str, text: &str) -> Result<Charts, String> {
    let kept = kept::charts().unwrap().files();
    Charts::read(|file| {
        let (_, kept) = kept.iter().find(|(kept, _)| kept == file).ok_or_else(|| format!("{file}: not found"))?;
        Ok(if file == name { text.to_owned() } else { kept.clone() })
    })
}

#[test]
fn chart_files() {
    const POINTS: &str = "method,origin,version,step,work,spread,error\n";
    let methods: String = (0..1000).map(|i| format!("m{i},lab,v,0.1,5,0,0.1\n")).collect();
    for (rows, told) in [
        (filled("m,lab,v,0.1,5,0,0.1\n", files::CHART), "fall.csv:2002: found a row more, expected at most 2000 below the head"),
        (methods, "fall.csv:66: column \"method\": found \"m64\", expected at most 64 methods"),
    ] {
        let text = format!("{POINTS}{rows}");
        assert_eq!(quick(told, &text, || charts("fall.csv", &text)).unwrap_err(), told);
    }
    let lines = format!("{POINTS}{}", filled("\n", files::CHART));
    assert!(quick("lines", &lines, || charts("fall.csv", &lines)).is_ok());
    let scenes: String = (0..100).map(|_| "fall,t,e,w,1,1,true,,\n").collect();
    let told =
        charts("scenes.csv", &format!("scene,title,error,work,tolerance,shipped_step,alike,note,over_time\n{scenes}")).unwrap_err();
    assert_eq!(told, "scenes.csv:66: found a scene more, expected at most 64");
}

#[test]
fn numbers_beyond_all_axes_are_refused() {
    let head = kept::PEERS_HEAD.join(",");
    let text = format!("{head}\nfall,other,1,,0.1,1.8e308,0,0.1,0,0\n");
    let told = kept::peer_rows(kept::PEERS, &text).unwrap_err();
    assert!(told.ends_with("expected a number above 0, from 1e-100 to 1e100"), "{told}");
    // At the ends of the accepted range everything is drawn, with few marks.
    let mut diagrams = Vec::new();
    let far = ["other,1,,1e-100,1e-100,0,0.1", "another,1,,1e100,1e100,0,1e308", "third,1,,1,1,0,1e-308"];
    let far: String = far.into_iter().map(|row| format!("pile-100,{row},0,0\n")).collect();
    kept::add_peers(&kept::peer_rows(kept::PEERS, &format!("{head}\n{far}")).unwrap(), &mut diagrams).unwrap();
    let charts = Charts { diagrams, ..Charts::default() };
    let svg = picture::measured(&charts.diagrams[0]);
    assert!(svg.len() < 100_000 && !svg.contains("NaN") && !svg.contains("inf"), "{}", svg.len());
    assert!(report::summary(&charts, &[]).len() < 100_000);
}

#[test]
fn the_table_of_pi_wants_a_row_a_step() {
    let head = "method,origin,version,step,work,spread,error\n";
    let ragged = "N = 0,lab,v,0.1,1,0,0\nN = 0,lab,v,0.01,1,0,0\nN = 1,lab,v,0.1,1,0,0\n";
    let told = charts("pi.csv", &format!("{head}{ragged}")).unwrap_err();
    assert_eq!(told, "pi.csv: found other steps at \"N = 1\" than at \"N = 0\", expected the same");
    let other_steps = "N = 0,lab,v,0.1,1,0,0\nN = 1,lab,v,0.2,1,0,0\n";
    assert!(charts("pi.csv", &format!("{head}{other_steps}")).is_err());
    let even = charts("pi.csv", &format!("{head}N = 0,lab,v,0.1,1,0,0\nN = 1,lab,v,0.1,2,0,1\n")).unwrap();
    assert!(report::summary(&even, &[]).contains("| 1/10 s | 0 | 1 |"));
    // Also where charts do not come from files.
    let mut ragged = even;
    let pi = ragged.diagrams.iter_mut().find(|measured| measured.name == resultant::lab::curve::PI).unwrap();
    pi.curves[1].points.clear();
    assert!(report::summary(&ragged, &[]).contains("| 1/10 s | 0 | 1 |"));
    let text = filled("N = 0,lab,v,0.1,1,0,0\n", 100);
    assert!(charts("pi.csv", &format!("{head}{text}")).is_ok());
}
