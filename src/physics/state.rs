//! The state of a world, the records of its last tick, and how often the engine had to give something up: a sequence cut short, a search repeated,
//! a tick taken in one step. Nothing of that is silent.

use crate::physics::data::{Body, BodyId, Contact, Impulse, Obstacle, Surface};
use crate::physics::forces::{ForceManager, Links, Media};
use glam::DVec2;

/// What happened during the last tick, for rules, view and sound.
#[derive(Clone, Debug, PartialEq)]
pub enum Event {
    /// Two things hit each other.
    Impact {
        /// The body that hit.
        a: BodyId,
        /// What it hit.
        b: Obstacle,
        /// The middle of the shared edge, m.
        point: DVec2,
        /// Unit vector from `b` towards `a`.
        normal: DVec2,
        /// Closing speed along the normal just before, m/s, > 0.
        speed: f64,
    },
    /// A surface squeezes a body against something that cannot give way. The surface waits for the rest of the tick.
    Crushed {
        /// The body.
        body: BodyId,
        /// The surface.
        by: u32,
        /// ½mv²/(h/2), N: the mean force that crushes half of its smaller side h at the speed v at which the surfaces close.
        force: f64,
    },
    /// A larger force than it bears has broken a link.
    Snapped {
        /// Its number.
        link: u32,
    },
    /// The ends of a link that waits for it have touched: it acts from now on.
    Hooked {
        /// Its number.
        link: u32,
    },
}

/// How many bodies each method took through the last tick.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Methods {
    /// At rest, and not looked at.
    pub asleep: u32,
    /// By the formula of free flight.
    pub free: u32,
    /// From event to event.
    pub by_events: u32,
    /// In one dense step.
    pub in_one_step: u32,
}

impl Methods {
    /// Every method by its name, in the order in which they stand here.
    pub fn all(&self) -> impl Iterator<Item = (&'static str, u32)> {
        let Self { asleep, free, by_events, in_one_step } = *self;
        [("asleep", asleep), ("free", free), ("by events", by_events), ("in one step", in_one_step)].into_iter()
    }
}

#[derive(Clone, Debug)]
pub(crate) struct State {
    pub bodies: Vec<Body>,
    pub forces: Vec<ForceManager>,
    pub links: Links,
    pub surfaces: Vec<Surface>,
    pub media: Media,
    pub rest_speed: f64,
    /// Contacts at the end of the last tick. Items are bodies, and surfaces from the number of bodies on.
    pub contacts: Vec<Contact>,
    pub known: Vec<bool>,
    pub ticks: u64,
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Records {
    /// Length of the last tick, or of the last part of it, s, and its begin since that of the tick.
    pub dt: f64,
    pub since: f64,
    /// Flows that had ended early before the last tick.
    pub flows_cut_short: u64,
    pub events: Vec<Event>,
    pub impulses: Vec<Impulse>,
    /// Body, time (s) and place (m) of each corner of a path, in the order of the times.
    pub corners: Vec<(u32, f64, DVec2)>,
    pub guards: Guards,
    pub methods: Methods,
    pub followed: u64,
}

macro_rules! guards {
    ($($(#[$doc:meta])* $name:ident),* $(,)?) => {
        /// How often each guard of the engine acted, since the world began. In ordinary scenes all but the first three are zero; in large
        /// piles [`Self::friction_unsettled`] is not.
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
        pub struct Guards {
            $($(#[$doc])* pub $name: u64,)*
        }

        impl Guards {
            /// Every guard by its name, in the order in which they stand here.
            pub fn all(&self) -> impl Iterator<Item = (&'static str, u64)> {
                [$((stringify!($name), self.$name)),*].into_iter()
            }

            pub(crate) fn add(&mut self, other: &Self) {
                $(self.$name += other.$name;)*
            }
        }
    };
}

guards! {
    /// Ticks of islands that one step of the crowd's method took from the start.
    dense_ticks,
    /// Ticks of islands that such a step took from their start, because too many events fell into them.
    budgets_used_up,
    /// Searches for neighbours that were repeated, because a body went further than the search had reached.
    islands_grown,
    /// Bounces that ended before their speed did: too many hits fell into a tenth of a millisecond.
    bounces_ended,
    /// Bodies that parted by a rounding from their support so often in a tick that they were let go.
    clinging_given_up,
    /// Flights whose last part was one step: through a liquid after all their steps, or through too many streams. Bodies that crossed too many
    /// borders of streams in a tick, and kept the streams that they felt.
    flows_cut_short,
    /// Surfaces that stopped for a body that they would have squeezed: for the rest of a tick, or for a whole one where islands did not agree
    /// within their rounds on when.
    surfaces_stopped,
    /// Groups of contacts whose friction on two axes did not settle within its rounds. Some contacts rub less than they could.
    friction_unsettled,
    /// Coordinates that a crowd's step put back, bodies that it kept within its search, and pairs that met at a corner and were solved again.
    put_back,
    /// Steps of crowds that would have gained energy.
    energy_taken_out,
}
