//! The page of stress tests.

use super::*;
use resultant::lab::stress::Survival;
use resultant::ui::scroll::BAR_WIDTH;
use std::ops::Range;

/// The lines of the table of stress tests: a test, or a method with its test.
fn stress_lines() -> Vec<(String, Option<Survival>)> {
    let stress = kept::charts().unwrap().stress;
    let tests = stress.chunk_by(|a, b| a.test == b.test);
    let lines = tests.flat_map(|rows| {
        let methods = rows.iter().map(|row| (row.method.clone(), Some(row.clone())));
        std::iter::once((rows[0].test.clone(), None)).chain(methods)
    });
    lines.collect()
}

fn stress_panels(sitting: &Sitting) -> [Area; 2] {
    boxes(sitting, theme::panel()).try_into().expect("two panels")
}

fn in_view(sitting: &Sitting) -> Range<usize> {
    let [table, _] = stress_panels(sitting);
    let first_column = |at: &Vec2| at.x < table.min.x + 100.0 && table.contains(*at);
    let last_column = |at: &Vec2| (at.x - table.max().x + 48.0).abs() < 1.0 && table.contains(*at);
    let texts = |column: &dyn Fn(&Vec2) -> bool| -> Vec<String> {
        sitting.texts().into_iter().filter(|(_, at)| column(at)).map(|(text, _)| text).collect()
    };
    let (names, values, lines) = (texts(&first_column), texts(&last_column), stress_lines());
    // The tests of swings have the same methods one after the other; their values differ.
    let is = |from: &usize| {
        lines[*from..].iter().zip(names.iter().zip(&values)).all(|((name, row), (shown, value))| {
            name.starts_with(shown.trim_end_matches('…')) && row.as_ref().is_none_or(|row| row.shown() == *value)
        })
    };
    let from = (0..=lines.len() - names.len()).find(is).expect("lines one after the other");
    from..from + names.len()
}

fn large(sitting: &Sitting) -> Option<usize> {
    let [_, large] = stress_panels(sitting);
    let texts: Vec<String> = sitting.texts().into_iter().filter(|(_, at)| large.contains(*at)).map(|(text, _)| text).collect();
    let [method, test] = [0, 1].map(|i| texts.get(i).map(|text| text.trim_end_matches('…').to_owned()));
    let (method, test) = (method?, test?);
    let is = |row: &Survival| row.method.starts_with(&method) && row.test.starts_with(&test);
    stress_lines().iter().position(|(_, row)| row.as_ref().is_some_and(is))
}

#[test]
fn the_table_has_every_stress_test_and_scrolls() {
    let mut sitting = lab_at("Stress tests");
    let all = stress_lines().len();
    assert_eq!(in_view(&sitting).start, 0);
    let mut seen = in_view(&sitting).end;
    while seen < all {
        let next = in_view(sitting.press(Key::Down));
        assert_eq!(next.end, seen + 1, "line by line");
        seen = next.end;
    }
    assert_eq!(in_view(sitting.press(Key::Down)).end, all, "never past the end");
    assert_eq!(in_view(sitting.press(Key::Home)).start, 0);
}

#[test]
fn the_failures_in_view_are_drawn_within_a_second_and_the_one_pointed_at_is_told() {
    let mut sitting = lab_at("Stress tests");
    let lines = stress_lines();
    for key in [Key::Home, Key::PageDown, Key::End] {
        sitting.press(key).wait(1.0);
        let ([table, _], grounds) = (stress_panels(&sitting), boxes(&sitting, theme::ground()));
        let pictures = grounds.into_iter().filter(|area| table.contains(area.centre()) && area.size.x > BAR_WIDTH);
        let pictures: Vec<f32> = pictures.map(|area| area.centre().y).collect();
        let pitch = (table.size.y - 16.0) / in_view(&sitting).len() as f32;
        for (place, line) in in_view(&sitting).enumerate() {
            let y = table.min.y + 8.0 + (place as f32 + 0.5) * pitch;
            let drawn = pictures.iter().any(|other| (other - y).abs() < 1.0);
            let refused = |row: &Survival| row.shipped && row.test.starts_with("nonsense");
            let expected = lines[line].1.as_ref().is_some_and(|row| !refused(row));
            assert_eq!(drawn, expected, "{:?}", lines[line]);
        }
    }
    sitting.press(Key::Home).point_at(Vec2::ZERO);
    assert_eq!(large(&sitting), Some(1), "the first method, below the name of its test");
    let [table, _] = stress_panels(&sitting);
    let told: Vec<Option<usize>> =
        (0..200).map(|i| large(sitting.point_at(table.min + Vec2::new(table.size.x - 100.0, 8.0 + 2.0 * i as f32)))).collect();
    let in_view = in_view(&sitting);
    assert!((in_view.start + 1..in_view.end - 2).all(|line| told.contains(&Some(line))), "{told:?}");
}
