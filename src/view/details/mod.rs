//! The details overlay: a box for each body in view, tied to it by a thin line, free-body arrows with labels, and a legend. The pointer lights a line
//! and its partner of the third law. This file lays out; `drawing` draws. A box's text is kept letter by letter: the drawing shows it, tests read it.

mod drawing;

use super::boxes::{self, BoxWish};
use super::facts::{ArrowKind, BodyFacts, FactRow, Value, facts, quantities};
use super::focus::{Focus, answer, partner};
use super::free_body::{ArrowLayout, ArrowSubject, Ground, head_area, place_labels, reaches};
use super::hud::{HudLayout, landmarks, velocity_tip};
use super::scale::{Label, Steady};
use super::{camera::Viewport, mechanisms, world};
use crate::draw::layout::{Area, DETAILS, Frame, GRID, LINE, MONO_ADVANCE, Vec2};
use crate::game::{Game, SHIP};
use crate::physics::{Aabb, BodyId, DVec2, Source};
use crate::{level::Text, words::tr};
pub use drawing::LegendNote;

/// Inside a box's edge, canvas units: above and below less than in a panel, for boxes can be many.
const PADDING: Vec2 = Vec2::new(1.5 * GRID, 0.75 * GRID);
/// About the mean width of a letter of the sans face, in heights of the text.
const WORDS_ADVANCE: f32 = 0.5;
/// Margin around places that no box may cover, canvas units.
const CLEAR: f32 = 2.0;
/// The pointer picks an arrow up to this far away, canvas units.
const NEAR: f32 = 7.0;
/// Room below and beside the pointer for the note on its line, canvas units.
const POINTER: f32 = 20.0;

#[derive(Clone, Copy, Debug)]
pub struct Looking<'a> {
    /// Drawn centres of the bodies, m.
    pub centres: &'a [DVec2],
    pub focus: &'a Focus,
    /// Canvas units.
    pub pointer: Option<Vec2>,
    /// Whether the legend lists the parts of the model.
    pub model: bool,
    /// Whether the ship bears the arrow of its velocity.
    pub velocity: bool,
}

#[derive(Clone, Debug)]
pub struct PlacedBox {
    pub text: BoxText,
    pub area: Area,
    object: Vec2,
}

impl PlacedBox {
    /// The place of a line, from the box's left edge to its right one.
    pub fn line(&self, line: usize) -> Area {
        let height = (self.area.size.y - 2.0 * PADDING.y) / (self.text.lines.len() + 1) as f32;
        Area::new(self.area.min.x, self.area.min.y + PADDING.y + (line + 1) as f32 * height, self.area.size.x, height)
    }
}

#[derive(Default)]
pub struct Details {
    pub boxes: Vec<PlacedBox>,
    pub arranged: ArrowLayout,
    pub labels: Vec<Label>,
    /// Of mechanisms.
    pub names: Vec<(String, Area)>,
    pub legend: LegendNote,
    /// The note on the partner of the pointer's line.
    pub tip: Option<LegendNote>,
    /// The lit lines: the body, and the index among its full facts.
    pub lit: Vec<(BodyId, usize)>,
    lit_places: Vec<Area>,
    pub left_out: usize,
    /// The offset of each body's box from its middle in the frame before: the box stays there.
    before: Vec<Option<Vec2>>,
    full: Option<usize>,
    scale: Steady,
    /// The followed body, and the bodies that exert a force on it, or did so last.
    partners: (Option<BodyId>, Vec<BodyId>),
}

impl Details {
    /// `covered` are the panels on the screen besides the head-up display.
    pub fn arrange(&mut self, game: &Game, looking: &Looking, covered: &[Area], view: &Viewport, frame: &Frame) {
        self.before.resize(looking.centres.len(), None);
        self.remember_partners(game, looking.focus);
        let shown = self.shown(game, looking, view);
        let pointed = self.pointed(looking.pointer);
        let subject = |id: BodyId| ArrowSubject { facts: facts(game, id), object: view.exact(&bounds(game, looking, id)) };
        let mut subjects: Vec<ArrowSubject> = shown.iter().map(|&id| subject(id)).collect();
        let (away, places) = self.light(game, &subjects, pointed, subject);
        self.lit_places = places.iter().map(|bounds| view.exact(bounds)).collect();
        subjects.extend(away.into_iter().filter(|away| away.object.gap(&frame.area()) < 0.0));
        let boxed = &subjects[..shown.len()];

        let never = self.never(game, looking, view, frame);
        let panels: Vec<Area> = HudLayout::shown(frame, game).into_iter().chain(covered.iter().copied()).collect();
        let ground = Ground { window: frame.area(), never: &never, panels: &panels };
        let reaches = reaches(&subjects, &ground);
        let scale = self.scale.update(game, (looking.focus, &shown), view.scale, [&reaches[0], &reaches[1]]);
        self.arranged.arrange(&subjects, &scale, view.scale, &ground);

        let mut taken: Vec<Area> = panels;
        taken.extend(&never);
        taken.extend(self.arranged.arrows.iter().map(|arrow| head_area(arrow.from, arrow.to, arrow.shown)));
        let firm = taken.clone();
        let words = || game.level().texts.iter().map(|text| words_area(text, view));
        let objects = Self::moving(game, looking, view);
        let kept_clear: Vec<Area> = objects.chain(self.arranged.arrows.iter().map(|arrow| arrow.area())).chain(words()).collect();
        self.place_legend(game, (&scale, looking), frame, (&taken, &kept_clear));
        taken.extend(self.legend.area);
        self.place_boxes(boxed, frame, (&taken, &firm), &kept_clear);
        taken.extend(self.boxes.iter().map(|placed| placed.area));
        let text = frame.text_height(DETAILS);
        let width = |name: &str| tr(name).chars().count() as f32 * MONO_ADVANCE * text;
        taken.extend(words());
        self.labels = place_labels(&self.arranged.arrows, text * 1.1, width, frame.area(), &taken);
        taken.extend(self.labels.iter().map(|label| label.area));
        self.names = world::place(world::in_view(game, view), text, frame.area(), &mut taken);
        self.place_tip(looking.pointer, frame, &taken);
    }

    /// Keeps the bodies that exert a force or an impact on the followed one, until others do.
    fn remember_partners(&mut self, game: &Game, focus: &Focus) {
        if self.partners.0 != focus.followed {
            self.partners = (focus.followed, Vec::new());
        }
        let Some(followed) = focus.followed.filter(|id| id.index() < game.world().bodies().len()) else { return };
        let causes = facts(game, followed).rows.into_iter().flat_map(|row| row.causes);
        let bodies: Vec<_> = causes.filter_map(|cause| if let Source::Body(body) = cause { Some(body) } else { None }).collect();
        if !bodies.is_empty() {
            self.partners.1 = bodies;
        }
    }

    /// The bodies in view with boxes, nearest to the focus first: they choose first; a followed body brings its partners, an idle ship has none.
    fn shown(&self, game: &Game, looking: &Looking, view: &Viewport) -> Vec<BodyId> {
        let (centres, visible, focus) = (looking.centres, view.visible(), looking.focus);
        let in_play = |id: &BodyId| match focus.followed {
            Some(_) => focus.shows(*id) || self.partners.1.contains(id),
            None => *id != SHIP || game.level().ship_plays(),
        };
        let ids = (0..centres.len() as u32).map(BodyId).filter(in_play);
        let mut shown: Vec<BodyId> = ids.filter(|&id| bounds(game, looking, id).touches(&visible, 0.0)).collect();
        let lead = centres[focus.followed.filter(|id| id.index() < centres.len()).unwrap_or(game.lead()).index()];
        let from_lead = |id: &BodyId| centres[id.index()].distance_squared(lead);
        shown.sort_by(|a, b| from_lead(a).total_cmp(&from_lead(b)));
        shown
    }

    fn moving<'a>(game: &'a Game, looking: &'a Looking, view: &'a Viewport) -> impl Iterator<Item = Area> + 'a {
        let bodies = (0..looking.centres.len() as u32).map(|id| bounds(game, looking, BodyId(id)));
        bodies
            .chain(mechanisms::movers(game))
            .filter(|bounds| bounds.touches(&view.visible(), 0.0))
            .map(|bounds| view.exact(&bounds))
    }

    /// Places that nothing may cover: the ship, hazards and goals in view, and the tip of the ship's velocity.
    fn never(&self, game: &Game, looking: &Looking, view: &Viewport, frame: &Frame) -> Vec<Area> {
        let seen = landmarks(game.level()).chain([bounds(game, looking, SHIP)]);
        let ship = (game.world().body(SHIP).velocity, looking.centres[SHIP.index()]);
        let tip = if looking.velocity { velocity_tip(ship.0, ship.1, view) } else { None };
        seen.map(|bounds| view.exact(&bounds).inset(-CLEAR)).chain(tip).filter(|area| area.gap(&frame.area()) < 0.0).collect()
    }

    /// The line under the pointer in the frame before: in a box or by its arrow.
    fn pointed(&self, pointer: Option<Vec2>) -> Option<(BodyId, usize)> {
        let pointer = pointer?;
        if let Some(placed) = self.boxes.iter().find(|placed| placed.area.contains(pointer)) {
            let line = (0..placed.text.lines.len()).find(|&line| placed.line(line).contains(pointer))?;
            return Some((placed.text.body, placed.text.lines[line].row));
        }
        let far = self.arranged.arrows.iter().map(|arrow| (arrow.distance(pointer), arrow));
        let (_, arrow) = far.filter(|(far, _)| *far <= NEAR).min_by(|a, b| a.0.total_cmp(&b.0))?;
        Some((arrow.body, arrow.row))
    }

    /// Lights the pointer's line and its partner. Returns partners without a box, made by `subject`, and the places of those that are no bodies, m.
    fn light(
        &mut self,
        game: &Game,
        subjects: &[ArrowSubject],
        pointed: Option<(BodyId, usize)>,
        subject: impl Fn(BodyId) -> ArrowSubject,
    ) -> (Vec<ArrowSubject>, Vec<Aabb>) {
        (self.tip, self.lit) = (None, Vec::new());
        let mut away = Vec::new();
        let of = |body: BodyId| subjects.iter().map(|subject| &subject.facts).find(|facts| facts.body == body);
        let Some((own, row)) = pointed.and_then(|(body, row)| Some((of(body)?, row))) else {
            return (away, Vec::new());
        };
        let line = own.rows.get(row);
        let Some((partner, (shown, _))) = line.and_then(|line| Some((partner(game, own, line)?, line.exerted()?))) else {
            return (away, Vec::new());
        };
        self.lit.push((own.body, row));
        for body in partner.bodies {
            if let Some(facts) = of(body) {
                self.lit.extend(answer(facts, shown, own.body, &own.rows[row].causes).map(|row| (body, row)));
                continue;
            }
            let mut other = subject(body);
            if let Some(row) = answer(&other.facts, shown, own.body, &own.rows[row].causes) {
                other.facts.rows = vec![other.facts.rows.swap_remove(row)];
                self.lit.push((body, 0));
                away.push(other);
            }
        }
        self.tip = Some(LegendNote { lines: partner.words, area: None });
        (away, partner.places)
    }

    /// As many full boxes as fit, for the first bodies, and short ones; the search begins at the last number, for it seldom changes.
    /// The first body always has one, if need be in the place of the legend, beside what is `firm`.
    fn place_boxes(&mut self, subjects: &[ArrowSubject], frame: &Frame, (taken, firm): (&[Area], &[Area]), kept_clear: &[Area]) {
        let texts: Vec<_> = subjects.iter().map(|subject| [false, true].map(|short| BoxText::new(&subject.facts, short))).collect();
        let sizes: Vec<[Vec2; 2]> = texts.iter().map(|texts| [0, 1].map(|short| texts[short].size(frame))).collect();
        let try_full = |full: usize| {
            let wish = |(i, subject): (usize, &ArrowSubject)| BoxWish {
                object: subject.object,
                size: sizes[i][usize::from(i >= full)],
                before: self.before[subject.facts.body.index()],
            };
            boxes::place(&subjects.iter().enumerate().map(wish).collect::<Vec<_>>(), frame.area(), taken, kept_clear)
        };
        let fits = |places: &[Option<Area>]| places.iter().all(Option::is_some);
        let mut full = self.full.unwrap_or(subjects.len()).clamp(1, subjects.len().max(1));
        let mut best = try_full(full);
        // Half as many at a time: a crowd that comes into view must not take a frame.
        while !fits(&best) && full > 1 {
            full = full * 2 / 3;
            best = try_full(full);
        }
        if fits(&best) && full < subjects.len() {
            let more = try_full(full + 1);
            if fits(&more) {
                (full, best) = (full + 1, more);
            }
        }
        if let (Some(None), Some(first)) = (best.first(), subjects.first()) {
            let alone = |short: usize, beside: &[Area]| {
                let wish = BoxWish { object: first.object, size: sizes[0][short], before: self.before[first.facts.body.index()] };
                boxes::place(&[wish], frame.area(), beside, &[])[0]
            };
            let area = alone(0, firm).or_else(|| alone(1, taken)).or_else(|| alone(1, firm));
            self.legend.area.take_if(|legend| area.is_some_and(|area| area.gap(legend) < 0.0));
            full = usize::from(area.is_some_and(|area| area.size == sizes[0][0]));
            let beside: Vec<Area> = taken.iter().copied().chain(area).collect();
            let wish = |(it, sizes): (&ArrowSubject, &[Vec2; 2])| BoxWish { object: it.object, size: sizes[1], before: None };
            let rest: Vec<BoxWish> = subjects.iter().zip(&sizes).skip(1).map(wish).collect();
            best = [area].into_iter().chain(boxes::place(&rest, frame.area(), &beside, kept_clear)).collect();
        }
        self.full = Some(full.max(1));
        self.left_out = best.iter().filter(|place| place.is_none()).count();
        self.before.fill(None);
        self.boxes.clear();
        for (i, ((place, [long, short]), ArrowSubject { facts, object })) in best.into_iter().zip(texts).zip(subjects).enumerate() {
            if let Some(area) = place {
                self.before[facts.body.index()] = Some(area.min - object.centre());
                self.boxes.push(PlacedBox { text: if i < full { long } else { short }, area, object: object.centre() });
            }
        }
    }

    /// The note on the partner: near the pointer, beside everything or, without room, above the boxes.
    fn place_tip(&mut self, pointer: Option<Vec2>, frame: &Frame, taken: &[Area]) {
        if let (Some(tip), Some(pointer)) = (&mut self.tip, pointer) {
            let object = Area::around(pointer, Vec2::splat(POINTER));
            let wish = BoxWish { object, size: LegendNote::size(&tip.lines, frame), before: None };
            tip.area = boxes::place(&[wish], frame.area(), taken, &[])[0]
                .or_else(|| boxes::place(&[wish], frame.area(), &[object], &[])[0]);
        }
    }
}

fn bounds(game: &Game, looking: &Looking, id: BodyId) -> Aabb {
    Aabb::around(looking.centres[id.index()], game.world().body(id).half)
}

/// An estimate of the place of a level's words.
fn words_area(text: &Text, view: &Viewport) -> Area {
    let letters = tr(&text.text).chars().count() as f32;
    Area { min: view.point(text.position), size: Vec2::new(letters * WORDS_ADVANCE, 1.0) * view.length(text.size) }
}

/// The least width of a number in characters, so that boxes seldom change their width: "−0.123".
const NUMBER_WIDTH: usize = 6;
/// Characters of the longest unit that is usual.
const UNIT_WIDTH: usize = 4;

#[derive(Clone, Debug, PartialEq)]
pub struct BoxLine {
    pub label: String,
    pub value: String,
    /// The force or impact, where the line has a colour.
    pub shown: Option<ArrowKind>,
    /// Whether the value is zero as written.
    pub nothing: bool,
    /// Index among the body's facts.
    pub row: usize,
}

#[derive(Clone, Debug, PartialEq)]
pub struct BoxText {
    pub body: BodyId,
    pub title: String,
    pub lines: Vec<BoxLine>,
}

impl BoxText {
    /// `short`, without room: heading and resultant.
    pub fn new(facts: &BodyFacts, short: bool) -> Self {
        let values = quantities(&facts.rows, NUMBER_WIDTH);
        let line = |(row, fact): (usize, &FactRow)| BoxLine {
            label: fact.label(),
            value: values[row].clone(),
            shown: fact.shown,
            nothing: fact.value == Value::Vector(DVec2::ZERO),
            row,
        };
        let kept = |row: &(usize, &FactRow)| !short || row.1.shown == Some(ArrowKind::Resultant);
        Self { body: facts.body, title: facts.title.clone(), lines: facts.rows.iter().enumerate().filter(kept).map(line).collect() }
    }

    /// The column at which the numbers begin, characters from the names.
    pub fn column(&self) -> usize {
        self.lines.iter().map(|line| line.label.chars().count() + 1).max().unwrap_or(0)
    }

    /// Its longest line, or the longest usual one, by the number of its lines.
    pub fn size(&self, frame: &Frame) -> Vec2 {
        let text = frame.text_height(DETAILS);
        // Brackets, comma and spaces stand between and around the numbers and their unit.
        let usual = 2 * NUMBER_WIDTH + 5 + UNIT_WIDTH;
        let values = self.lines.iter().map(|line| line.value.trim_end().chars().count()).fold(usual, usize::max);
        let characters = (self.column() + values).max(self.title.chars().count());
        Vec2::new(characters as f32 * MONO_ADVANCE * text, (self.lines.len() + 1) as f32 * text * LINE) + 2.0 * PADDING
    }
}
