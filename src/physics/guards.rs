//! How often the engine had to give something up: a sequence cut short, a search repeated, a tick taken in one step. Nothing of that is silent.

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
    /// Bounces that ended before their speed did: the sequence of impacts at one instant, or the hits of one body in one tick, became too long.
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
