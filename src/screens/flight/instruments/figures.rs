//! The table of momentum, energy and work: of the followed object, of the one compared with it and of both; else of all.

use super::Stage;
use crate::game::{Game, body_title};
use crate::instruments::ledger::{Account, EnergyState, MOST_BODIES, WorkLedger, ground};
use crate::number::{QuantityScale, scalar, seconds};
use crate::physics::{BodyId, DVec2, ForceKind, Impulse};
use crate::view::{focus::Focus, theme};
use crate::{draw::Colour, level::Level, ui::input::Input, words::tr};

/// Ticks of reading in a frame at most, where the table opens late in a flight.
const AHEAD: u64 = 600;
/// A work below this part of the largest one is rounding.
const ROUNDING: f64 = 1e-10;

/// The sum of all works: the gain of kinetic energy.
pub const GAINED: &str = "= kinetic gained";

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    Quantity,
    /// The sum of the lines above.
    Sum,
    /// A heading or a remark.
    Words,
    Force(ForceKind),
    Impact,
}

#[derive(Clone, Debug, PartialEq)]
pub struct FigureLine {
    pub name: String,
    pub subject: Subject,
    /// One a column, with its unit; empty in a line of words.
    pub values: Vec<String>,
}

#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    pub columns: Vec<String>,
    pub lines: Vec<FigureLine>,
    pub bars: Vec<FigureBar>,
}

/// A kind of energy, J, or a part of the momentum, N·s, as bars, one a column.
#[derive(Clone, Debug, PartialEq)]
pub struct FigureBar {
    pub name: &'static str,
    pub unit: &'static str,
    pub colour: Colour,
    pub values: Vec<f64>,
}

#[derive(Clone, Debug, Default)]
pub struct Figures {
    ledger: WorkLedger,
    /// From where work and losses count; `None`: from the start.
    base: Option<FiguresBase>,
    /// Of each body at the moment on the screen, J.
    energies: Vec<f64>,
    /// The height at which potential energy is zero, m, y down; `None`: the level's edge.
    zero: Option<f64>,
    holds_zero: bool,
    /// The accounts are up to date with the moment on the screen.
    is_read: bool,
    table: Table,
}

#[derive(Clone, Debug)]
struct FiguresBase {
    tick: u64,
    accounts: Vec<Account>,
    /// Of each body, J.
    energies: Vec<f64>,
}

/// The followed and the compared body, or the one under the camera while the player follows none.
pub fn in_focus(focus: &Focus, game: &Game) -> Vec<BodyId> {
    let there = |body: &BodyId| body.index() < game.world().bodies().len();
    let followed = focus.followed.filter(there).unwrap_or(game.lead());
    std::iter::once(followed).chain(focus.compared.filter(there)).collect()
}

impl Figures {
    pub fn update(&mut self, stage: &Stage) {
        self.is_read = self.ledger.go(stage.history, stage.game.ticks(), AHEAD);
        self.energies = energies(stage.game);
        self.table = self.tabulate(stage);
    }

    pub const fn table(&self) -> &Table {
        &self.table
    }

    /// Counts work from the moment on the screen, once all ticks before it are read, or from the flight's start.
    pub fn count_from(&mut self, now: Option<u64>) {
        let base = |tick| FiguresBase { tick, accounts: self.ledger.accounts.to_vec(), energies: self.energies.clone() };
        self.base = now.filter(|_| self.is_read).map(base);
    }

    /// Where potential energy is zero, m.
    pub fn zero(&self, level: &Level) -> DVec2 {
        let ground = ground(level);
        DVec2::new(ground.x, self.zero.unwrap_or(ground.y))
    }

    /// Potential energy is zero at the height of a place, m, y down.
    pub const fn set_zero(&mut self, height: f64) {
        self.zero = Some(height);
    }

    /// The pointer takes the line of the zero, and moves it. True where the click or the drag is its own; `near` is in m.
    pub fn drag_zero(&mut self, input: &Input, level: &Level, (near, free): (f64, bool)) -> bool {
        let Some(place) = input.place.filter(|_| level.gravity != 0.0) else { return self.holds_zero };
        let takes = free && input.click && (place.y - self.zero(level).y).abs() <= near;
        self.holds_zero = takes || self.holds_zero && input.holding;
        if self.holds_zero {
            self.set_zero(place.y);
        }
        self.holds_zero
    }

    /// The same for the level flown once more.
    #[must_use]
    pub fn flown_again(&self) -> Self {
        Self { zero: self.zero, ..Self::default() }
    }

    /// The flight was left at that tick: later readings are void.
    pub fn back_to(&mut self, tick: u64) {
        self.ledger.back_to(tick);
        self.base = self.base.take().filter(|base| base.tick <= tick);
    }

    /// J, summed over those bodies.
    fn work(&self, bodies: &[BodyId]) -> Account {
        let done = |id: &BodyId| {
            let account = self.ledger.accounts[id.index()];
            self.base.as_ref().map_or(account, |base| account.since(&base.accounts[id.index()]))
        };
        bodies.iter().map(done).fold(Account::default(), |sum, account| sum.plus(&account))
    }

    fn tabulate(&self, stage: &Stage) -> Table {
        let (game, bodies) = (stage.game, stage.game.world().bodies().len());
        let seen = in_focus(stage.focus, game);
        let mut groups: Vec<Vec<BodyId>> = seen.iter().map(|id| vec![*id]).collect();
        let mut columns: Vec<String> = groups.iter().map(|group| body_title(game.level(), group[0])).collect();
        // Two compared bodies are a system of their own: others would mix in.
        let all: Vec<BodyId> = (game.lead().0..bodies as u32).map(BodyId).collect();
        if seen.len() == 2 {
            groups.push(seen);
            columns.push(tr("Both").to_owned());
        } else if stage.focus.followed.is_none() && all.len() > 1 {
            groups.push(all);
            columns.push(tr("All").to_owned());
        }
        let zero = self.zero(game.level());
        let state = |group: &Vec<BodyId>| {
            group.iter().map(|id| EnergyState::above(zero, game, *id)).fold(EnergyState::default(), std::ops::Add::add)
        };
        let at_base = self.base.as_ref().map_or_else(|| energies(stage.history.start()), |base| base.energies.clone());
        let lost = |group: &Vec<BodyId>| -> f64 {
            group.iter().map(|id| at_base.get(id.index()).map_or(0.0, |before| before - self.energies[id.index()])).sum()
        };
        let states: Vec<EnergyState> = groups.iter().map(state).collect();
        let line = |name: &'static str, subject, of: &dyn Fn(&EnergyState) -> f64, unit| Number {
            name,
            subject,
            values: states.iter().map(of).collect(),
            unit,
        };
        let words = |words: String| FigureLine { name: words, subject: Subject::Words, values: Vec::new() };
        let elastic = states.iter().any(|state| state.elastic != 0.0);
        let bar = |name: &'static str, unit, colour, of: &dyn Fn(&EnergyState) -> f64| FigureBar {
            name,
            unit,
            colour,
            values: states.iter().map(of).collect(),
        };
        let mut bars = vec![
            bar(tr("Kinetic"), "J", theme::VELOCITY, &|state| state.kinetic),
            bar(tr("Potential"), "J", theme::force(ForceKind::Weight), &|state| state.potential),
        ];
        bars.extend(elastic.then(|| bar(tr("Elastic"), "J", theme::force(ForceKind::Spring), &|state| state.elastic)));
        let lost: Vec<f64> = groups.iter().map(lost).collect();
        bars.push(FigureBar { name: tr("Lost"), unit: "J", colour: theme::bad(), values: lost.clone() });
        bars.push(bar(tr("Momentum x"), "N·s", theme::IMPACT, &|state| state.momentum.x));
        let upwards = states.iter().any(|state| state.momentum.y != 0.0);
        bars.extend(upwards.then(|| bar(tr("Momentum y"), "N·s", theme::IMPACT, &|state| -state.momentum.y)));
        let mut states_of_all = vec![
            line(tr("Momentum x"), Subject::Quantity, &|state| state.momentum.x, "N·s"),
            line(tr("Momentum y"), Subject::Quantity, &|state| -state.momentum.y, "N·s"),
            line(tr("Kinetic energy"), Subject::Quantity, &|state| state.kinetic, "J"),
            line(tr("Potential energy"), Subject::Quantity, &|state| state.potential, "J"),
        ];
        states_of_all.extend(elastic.then(|| line(tr("Elastic energy"), Subject::Quantity, &|state| state.elastic, "J")));
        states_of_all.push(line(tr(if elastic { "Sum of all" } else { "Sum of both" }), Subject::Sum, &EnergyState::sum, "J"));
        states_of_all.push(Number { name: tr("Lost"), subject: Subject::Quantity, values: lost, unit: "J" });
        let (mut lines, mut numbers) = (written(states_of_all), Vec::new());
        let heading = match (self.is_read, bodies > MOST_BODIES) {
            (true, _) => {
                let works: Vec<Account> = groups.iter().map(|group| self.work(group)).collect();
                numbers.extend(work_lines(&works));
                let tick = self.base.as_ref().map_or(stage.history.start().ticks(), |base| base.tick);
                tr!("Work from {time} s on", time = seconds(tick, game.tick_rate()))
            }
            (false, true) => tr("Work: too many objects").to_owned(),
            (false, false) => tr("Work: reading …").to_owned(),
        };
        lines.extend([words(self.zero_level(game)), words(heading)]);
        lines.extend(written(numbers));
        Table { columns, lines, bars }
    }

    fn zero_level(&self, game: &Game) -> String {
        let level = game.level();
        if let Some(zero) = self.zero.filter(|_| level.gravity != 0.0) {
            return tr!("zero {height} above the bottom", height = scalar(level.size.y - zero, "m"));
        }
        let sign = |strength: f64| if strength == 0.0 { 0 } else { strength.signum() as i8 };
        let side = match (sign(level.gravity), sign(level.gravity_x)) {
            (0, 0) => return tr("no gravity").to_owned(),
            (1, 0) => tr("bottom"),
            (1, 1) => tr("bottom right"),
            (1, _) => tr("bottom left"),
            (0, 1) => tr("right"),
            (0, _) => tr("left"),
            (_, 0) => tr("top"),
            (_, 1) => tr("top right"),
            _ => tr("top left"),
        };
        tr!("zero at the level's {side}", side)
    }
}

/// Of each body, J.
fn energies(game: &Game) -> Vec<f64> {
    (0..game.world().bodies().len() as u32).map(|id| EnergyState::of(game, BodyId(id)).sum()).collect()
}

struct Number {
    name: &'static str,
    subject: Subject,
    values: Vec<f64>,
    unit: &'static str,
}

/// The lines of a sum: each quantity in one unit.
fn written(numbers: Vec<Number>) -> Vec<FigureLine> {
    let largest = |unit: &str| {
        let values = numbers.iter().filter(|line| line.unit == unit).flat_map(|line| &line.values);
        values.fold(0.0, |most: f64, value| most.max(value.abs()))
    };
    let scales: Vec<QuantityScale> = numbers.iter().map(|line| QuantityScale::of(largest(line.unit), line.unit)).collect();
    let line = |(line, scale): (&Number, &QuantityScale)| FigureLine {
        name: line.name.to_owned(),
        subject: line.subject,
        values: line.values.iter().map(|value| format!("{} {}", scale.finer(*value).number(*value), scale.unit())).collect(),
    };
    numbers.iter().zip(&scales).map(line).collect()
}

/// A line for each force that has done any work, for the impacts, and for the sum.
fn work_lines(works: &[Account]) -> Vec<Number> {
    let largest =
        works.iter().flat_map(|work| work.by_force.into_iter().chain([work.by_impacts])).fold(0.0, |a: f64, b| a.max(b.abs()));
    // A work within rounding of the largest reads 0.
    let rounded = |work: f64| if work.abs() <= ROUNDING * largest { 0.0 } else { work };
    let line = |name: &'static str, subject, of: &dyn Fn(&Account) -> f64| Number {
        name,
        subject,
        values: works.iter().map(|work| rounded(of(work))).collect(),
        unit: "J",
    };
    let done = |of: &dyn Fn(&Account) -> f64| works.iter().any(|work| rounded(of(work)) != 0.0);
    let forces = ForceKind::ALL.into_iter().filter(|kind| done(&|work| work.by(*kind)));
    let mut lines: Vec<Number> = forces.map(|kind| line(tr(kind.shown()), Subject::Force(kind), &|work| work.by(kind))).collect();
    if done(&|work| work.by_impacts) {
        lines.push(line(tr(Impulse::NAME), Subject::Impact, &|work| work.by_impacts));
    }
    lines.push(line(tr(GAINED), Subject::Sum, &Account::sum));
    lines
}
