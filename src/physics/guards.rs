//! How often the engine had to give something up: a sequence cut short, a search repeated, a tick taken in one step. Nothing of that is silent.

macro_rules! guards {
    ($($(#[$doc:meta])* $name:ident),* $(,)?) => {
        /// How often each guard of the engine acted, since the world began. In ordinary scenes all but the first three are zero, in small ones
        /// also of the dense method; what is [relaxed](Self::friction_relaxed) and [parted](Self::sweeps_ended) in large piles is counted, too.
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
        pub struct Guards {
            $($(#[$doc])* pub $name: u64,)*
        }

        impl Guards {
            /// Every guard by its name, in the order in which they stand here.
            pub fn all(&self) -> impl Iterator<Item = (&'static str, u64)> {
                [$((stringify!($name), self.$name)),*].into_iter()
            }

            /// Adds what another count holds.
            pub(crate) fn add(&mut self, other: &Self) {
                $(self.$name += other.$name;)*
            }
        }
    };
}

guards! {
    /// Ticks of islands that were taken in one step of the dense method from the start.
    dense_ticks,
    /// Ticks of islands whose rest was, because too many events fell into them.
    budgets_used_up,
    /// Searches for neighbours that were repeated, because a body went further than foreseen.
    islands_grown,
    /// Sequences of bounces at one instant that were cut short: the rest of their impacts were plastic.
    impacts_made_plastic,
    /// Contacts that bounced with loss so often at one instant that they bounce no more (inelastic collapse).
    collapses,
    /// Pairs of bodies that bounced with loss so often in a tick that they bounce no more.
    rattles,
    /// Bodies that bounced so often in a tick on a surface that moves that they bounce no more.
    pumping,
    /// Bodies that parted by a rounding from what they rest on so often in a tick that they were let go.
    clinging_given_up,
    /// Groups of contacts whose friction on floors and on walls, each of which decides about the other, did not settle within its rounds:
    /// some rub less than they could.
    friction_unsettled,
    /// Flows through liquids whose last part was one implicit step, because they had taken all their steps.
    flows_ended_early,
    /// Flights of one body through so many streams that the rest of a tick went with the force that it had come to.
    flights_cut_short,
    /// Surfaces stopped because they would have squeezed something; for a whole tick where islands did not agree within their rounds on when.
    surfaces_stopped,
    /// Dense: steps of islands solved again because a hit threw a body further than contacts were looked for.
    steps_grown,
    /// Dense: steps of islands whose bodies were kept within what was looked for in the end.
    kept_within_reach,
    /// Dense: how often the grips of stacks did not settle, or would have driven, and were relaxed contact by contact.
    friction_relaxed,
    /// Dense: steps of islands in which friction would have driven, and was left out.
    friction_left_out,
    /// Dense: steps of islands in which what still closed side by side did not settle within its sweeps.
    sweeps_ended,
    /// Dense: pairs that were expected to pass each other and would have met: solved again.
    corners_met,
    /// Dense: coordinates that were put back to where they were.
    put_back,
    /// Dense: steps of islands that would have gained energy.
    energy_taken_out,
    /// Dense: bodies squeezed between surfaces.
    squeezed,
}
