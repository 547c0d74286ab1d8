//! The picture of a method's failure, beside its line of a table or with its axes; the Lab's charts on sheets of SVG.

use super::{diagram, places::DiagramPlaces, plane, plane::Plane, timeline};
use crate::draw::layout::{Area, DETAILS, TEXT, Vec2};
use crate::draw::{Canvas, Colour, Style};
use crate::lab::stability::{Region, TITLE};
use crate::number::{power, short, step};
use crate::{draw::chart::Decades, physics::SOURCES, view::lanes::sheet, words::tr};
use crate::{lab::curve::ANOTHER_BUILD, lab::curve::Measured, lab::savings::Saving, lab::savings::TITLE as TITLE_OF_SAVINGS};
use crate::{lab::stress::picture::FailurePicture, lab::stress::picture::Polyline, view::theme, view::widgets};

/// Above and below a large picture's plot: the names of its axes and their ends.
const TOP: f32 = 44.0;
const BOTTOM: f32 = 32.0;

/// Without words.
pub fn small(canvas: &Canvas, area: Area, picture: &FailurePicture, colour: Colour) {
    canvas.rounded(area, 3.0, theme::ground());
    lines(canvas, area.inset(2.0), picture, (colour, 1.5));
}

/// With names and ends of the axes.
pub fn large(canvas: &Canvas, area: Area, picture: &FailurePicture, colour: Colour) {
    let text = canvas.frame().text_height(DETAILS);
    let top = TOP.max(2.4 * text);
    let plot = Area::new(area.min.x, area.min.y + top, area.size.x, area.size.y - top - BOTTOM);
    canvas.rounded(plot, 0.0, theme::ground());
    canvas.rounded_edge(plot, 0.0, 1.0, theme::solid());
    lines(canvas, plot, picture, (colour, 2.0));
    let ((from, to), (least, most)) = picture.window();
    let words = Style::new(TEXT, theme::text()).middle();
    let quiet = Style::new(DETAILS, theme::quiet()).middle();
    let up = widgets::cut(canvas, tr(picture.up), plot.size.x, words);
    canvas.text(&up, Vec2::new(plot.min.x, plot.min.y - (1.65 * text).max(32.0)), words);
    let span = tr!("from {least} to {most}", least = short(least), most = short(most));
    canvas.text(&span, Vec2::new(plot.min.x, plot.min.y - (0.55 * text).max(10.0)), quiet);
    let foot = plot.max().y + 14.0;
    canvas.text(&short(from), Vec2::new(plot.min.x, foot), quiet);
    canvas.text(&short(to), Vec2::new(plot.max().x, foot), quiet.right());
    canvas.text(tr(picture.across), Vec2::new(plot.centre().x, foot + 4.0), words.centred());
}

fn lines(canvas: &Canvas, area: Area, picture: &FailurePicture, (colour, width): (Colour, f32)) {
    let across = |(from, to): (f64, f64), colour: Colour| {
        let ends: Polyline = vec![(f64::NEG_INFINITY, from), (f64::INFINITY, to)];
        if let [low, high] = picture.parts(&[ends])[0].as_slice() {
            let (top, foot) = (area.part((0.0, high.1)).y, area.part((0.0, low.1)).y);
            canvas.rounded(Area::new(area.min.x, top, area.size.x, (foot - top).max(1.0)), 0.0, colour);
        }
    };
    if let Some(solid) = picture.solid {
        across(solid, theme::solid());
    }
    if let Some(right) = picture.right {
        across(right, theme::good().faded(0.25));
    }
    let stroke = |lines: &[Polyline], colour: Colour, width: f32| {
        for line in picture.parts(lines) {
            line.windows(2).for_each(|pair| canvas.line(area.part(pair[0]), area.part(pair[1]), width, colour));
        }
    };
    stroke(&picture.exact, theme::good(), 1.0);
    stroke(&picture.found, colour, width);
}

/// Height of the words below a sheet's drawing, px.
const FOOT: f32 = 60.0;

/// A scene of the Lab: work to the right, error upwards.
pub fn measured(measured: &Measured) -> String {
    sheet(tr(&measured.title), 0.0, |canvas, panel| {
        let plot = DiagramPlaces::of(panel, measured, canvas.frame());
        diagram::draw(canvas, &plot, measured, diagram::Picked::default());
        let quiet = Style::new(DETAILS, theme::quiet()).middle().right();
        let note = if measured.is_stale() { ANOTHER_BUILD } else { &measured.note };
        canvas.text(tr(note), Vec2::new(plot.area.max().x, plot.area.min.y - 22.0), quiet);
    })
}

/// A scene of the Lab over time; `None` without a recording.
pub fn over_time(measured: &Measured) -> Option<String> {
    let over_time = measured.over_time.as_ref()?;
    let title = tr!("{title}: over time, step {step}", title = tr(&measured.title), step = step(over_time.step));
    Some(sheet(&title, 0.0, |canvas, panel| {
        let followed = timeline::followed(measured, over_time);
        timeline::draw(canvas, &DiagramPlaces::of(panel, &followed, canvas.frame()), (&followed, over_time), None);
    }))
}

/// The stability regions of methods.
pub fn stability(regions: &[Region]) -> String {
    sheet(tr(TITLE), FOOT, |canvas, panel| {
        plane::draw(canvas, &Plane::of(panel, canvas.frame()), regions, None);
        for (words, down) in plane::WORDS.iter().zip([18.0, 42.0]) {
            let middle = Vec2::new(panel.centre().x, panel.max().y + down);
            widgets::fitted(canvas, tr(words), middle, panel.size.x, &[TEXT, DETAILS], theme::text());
        }
    })
}

/// What each level, experiment and scene takes a tick, and what it would take with every part: bars from the one to the other.
pub fn savings(rows: &[Saving]) -> String {
    const NAME: f32 = 130.0;
    const FACTOR: f32 = 60.0;
    sheet(tr(TITLE_OF_SAVINGS), FOOT, |canvas, panel| {
        let decades = Decades::around(rows.iter().flat_map(|row| [row.planned.0, row.everything.0]));
        let kinds = rows.chunk_by(|a, b| a.of == b.of);
        let (count, most) = kinds.clone().fold((1, 1), |(count, most), kind| (count + 1, most.max(kind.len() + 1)));
        let (width, pitch) = (panel.size.x / (count - 1).max(1) as f32, panel.size.y / most as f32);
        for (column, kind) in kinds.enumerate() {
            let left = panel.min.x + column as f32 * width;
            for (line, row) in kind.iter().enumerate() {
                let y = panel.min.y + (line as f32 + 0.5) * pitch;
                let style = |colour| Style::new(DETAILS.min(pitch), colour).middle();
                let bar = Area::new(left + NAME, y - 0.35 * pitch, width - NAME - FACTOR, 0.7 * pitch);
                let [own, all] = [row.planned.0, row.everything.0].map(|time| decades.part(time) as f32 * bar.size.x);
                canvas.rounded(Area::new(bar.min.x, bar.min.y, own.max(1.0), bar.size.y), 0.0, theme::accent());
                canvas.rounded(Area::new(bar.min.x + own, bar.min.y, (all - own).max(0.0), bar.size.y), 0.0, theme::solid());
                canvas.text(&row.scene, Vec2::new(bar.min.x - 8.0, y), style(theme::text()).right());
                canvas.text(
                    &format!("× {}", short(row.times())),
                    Vec2::new(bar.min.x + own.max(all) + 6.0, y),
                    style(theme::quiet()),
                );
            }
            for exponent in decades.named(6) {
                let x = left + NAME + decades.part(10f64.powi(exponent)) as f32 * (width - NAME - FACTOR);
                canvas.text(
                    &format!("{} ns", power(exponent)),
                    Vec2::new(x, panel.max().y),
                    Style::new(DETAILS, theme::quiet()).centred(),
                );
            }
        }
        let stale = rows.iter().any(|row| row.version != SOURCES);
        let words = "Bright: as it runs. Dim: what every part would add. Left levels, middle experiments, right scenes of the Lab; logarithmic.";
        let middle = Vec2::new(panel.centre().x, panel.max().y + 42.0);
        let words = tr(if stale { ANOTHER_BUILD } else { words });
        widgets::fitted(canvas, words, middle, panel.size.x, &[TEXT, DETAILS], theme::text());
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draw::chart::CurveOrigin;
    use crate::lab::curve::{CoursePoint, MethodCurve, OverTime, WorkPoint};
    use crate::lab::stability::regions;

    fn assert_words(drawn: &str, words: &[&str]) {
        assert!(words.iter().all(|word| drawn.contains(word)), "{words:?} in {drawn}");
        assert!(!drawn.contains("NaN") && !drawn.contains("inf"));
    }

    fn wild() -> MethodCurve {
        let point = |step, work, error| WorkPoint { step, work, spread: 0.0, error };
        MethodCurve {
            name: "wild".to_owned(),
            origin: CurveOrigin::Lab,
            version: String::new(),
            points: vec![point(0.1, 10.0, f64::NAN), point(0.01, 100.0, 1e-2)],
        }
    }

    #[test]
    fn a_diagram_has_its_words_as_text_and_no_bad_numbers() {
        let ours = vec![WorkPoint { step: 0.01, work: 50.0, spread: 0.0, error: 0.0 }];
        let ours = MethodCurve { name: "ours".to_owned(), origin: CurveOrigin::Shipped, version: String::new(), points: ours };
        let drawn = measured(&Measured::of_curves(vec![wild(), ours]));
        assert_words(&drawn, &["A title", "error, m", "work, ns", "wild", "ours", "as shipped", "blew up", "tolerance"]);
    }

    #[test]
    fn what_blew_up_over_time_is_drawn_without_bad_numbers() {
        let moment = |time, error, energy| CoursePoint { time, error, energy: Some(energy) };
        let moments = vec![moment(1.0, 0.0, 1.0), moment(2.0, f64::NAN, f64::INFINITY), moment(3.0, 1e300, f64::NAN)];
        let course = MethodCurve { name: "wild".into(), origin: CurveOrigin::Lab, version: String::new(), points: moments };
        let followed = Some(OverTime { step: 1.0 / 60.0, courses: vec![course] });
        let mut measured = Measured { over_time: followed, ..Measured::of_curves(vec![wild()]) };
        let drawn = over_time(&measured).expect("it was followed");
        assert_words(&drawn, &["A title: over time, step 1/60 s", "error, m", "energy", "wild", "time, s"]);
        measured.over_time = None;
        assert!(over_time(&measured).is_none());
    }

    #[test]
    fn the_plane_names_every_method() {
        let regions = regions();
        let names: Vec<&str> = regions.iter().map(|region| region.name).collect();
        assert_words(&stability(&regions), &names);
    }
}
