//! The tolerances that several files of the engine share, each with its unit and what breaks when it changes.

/// m. How much two boxes in contact share along the *other* axis, and the largest gap of a contact at rest; a *hit* needs none, or small bounces lose
/// 3 to 6 % of their energy. Smaller: things catch on the seams of tiles that rounding left proud; larger: corners become visibly round.
pub(crate) const SLOP: f64 = 1e-9;

/// How often in one tick a body that parts by less than [`MICRO_SPEED`] is taken to stay; friction on its other side may draw it away after that.
pub(crate) const MAX_CLINGS: u32 = 32;

/// Turns of a body across borders of streams in a tick, soon after an event. More: they use up the budget; fewer: bounces in narrow ones are missed.
pub(crate) const MOST_BORDERS: u32 = 4;

/// Relative to the largest force of a block: no force left over. Smaller: rounding splits resting blocks; larger: an anvil takes a feather with it.
pub(crate) const FORCE_TOLERANCE: f64 = 1e-12;

/// m/s. Differences of speed that a slide ends with, and in which what meets grazes. Smaller: rounding makes impacts; larger: slow slides end early.
pub(crate) const SPEED_TOLERANCE: f64 = 1e-11;

/// Relative to the faster of two bodies in contact: slower sliding is rounding, which as a slide would end and come back thousands of times a tick.
pub(crate) const SPEED_ROUNDING: f64 = 8.0 * f64::EPSILON;

/// m/s. Things that part more slowly and are pulled together again rest on each other: they would part by 1e-13 m for 0.1 µs, again and again.
pub(crate) const MICRO_SPEED: f64 = 2e-6;

/// Relative distance from the terminal velocity at which a body counts as having reached it: no further steps are needed then.
pub(crate) const TERMINAL_TOLERANCE: f64 = 1e-13;

/// m. Error of one step through a liquid, by its own estimate. Larger: the tick shows in a splash; smaller: more steps for digits nobody sees.
pub(crate) const FLIGHT_TOLERANCE: f64 = 1e-9;

/// Relative to all forces of contacts or links on a body: the rounding of a balance.
pub(crate) const BALANCED: f64 = 1e-9;

/// m. Error of one step of linked bodies, by its estimate, of the row before. Larger: a swing loses over 1e-9 of its energy in a thousand periods.
pub(crate) const LINKED_TOLERANCE: f64 = 1e-14;

/// Shortest steps of linked bodies, in parts of a tick, and s, whatever their error. Shorter: kinks of drag take a millisecond; longer: unstable.
pub(crate) const SHORTEST_LINKED: f64 = 4096.0;
pub(crate) const LONGEST_SHORT: f64 = 1e-6;

/// How often in a tick the bend of a link is sought, times the bodies of its group. More: rattling ropes take long; fewer: some bend at a step's end.
pub(crate) const MOST_BENDS: usize = 512;

/// m. A swing of linked bodies no wider than this is rest. Smaller: what hangs never falls asleep; larger: it stops beside its balance.
pub(crate) const LINKED_ROUNDING: f64 = 1e-12;

/// Rate × time from which steps through a liquid at the speed of the place are implicit. Smaller: more work; larger: stability cuts more short.
pub(crate) const HEAVY_REACH: f64 = 4.0;

/// Rate × time of one Runge–Kutta step, at most, of what bobs: its stability ends at 1.0.
pub(crate) const BOBBING_REACH: f64 = 0.7;

/// Damping ratio afloat at the waterline, per unit of C_d. Smaller: 300 kg on water bob for over a minute; larger: a splash calms within one bob.
pub(crate) const WAVES: f64 = 0.15;

/// Hits of both ends within [`COLLAPSE`] after which a contact bounces no more. More: a collapse of several uses up the budget; fewer: its end comes
/// early, so that friction in it is off.
pub(crate) const MOST_BOUNCES: u32 = 64;

/// s. Longer: fast bodies in a gap lose speed; shorter: what rattles uses up the budget.
pub(crate) const COLLAPSE: f64 = 1e-4;

/// s. Bounces that take no longer go on as one train. Longer: other things end more trains; shorter: more events, which use up the island's budget.
pub(crate) const SHORT_BOUNCE: f64 = 1.0 / 256.0;

/// Hits to come in a tick of something without loss between two others that make a train. More: they use up the island's budget; fewer: no gain.
pub(crate) const MANY_HITS: f64 = 16.0;

/// m/s. Slower hits are not reported as events.
pub(crate) const REPORT_SPEED: f64 = 0.01;

/// Rounds between the two axes when friction on walls and floors depend on each other.
pub(crate) const FRICTION_ROUNDS: u32 = 24;

/// m. Thickness of the level's edges. No speed gets through: impacts are found along the whole path.
pub(crate) const EDGE_THICKNESS: f64 = 100.0;

/// Rate × time of a bounce up to which drag only takes a little off it, and the relative change of the pull within one train. Larger: what it takes
/// is off by more than a tenth; smaller: a light body that bounces in front of something heavy does so a hundred times before a train begins.
pub(crate) const DAMPED_REACH: f64 = 0.1;

/// Events of an island in a tick, however often it grows, for each of its bodies and 108 more. Larger: the worst tick lasts longer; smaller: more
/// ticks take the crowd step.
pub(crate) const EVENTS_OF_A_BODY: u64 = 20;

/// m. How far a cubic may be beside the flow that it follows, and how deep bodies meet. Larger: beside their ways; smaller: ways of more parts.
pub(crate) const STRAY: f64 = 1e-5;

/// Relative difference up to which two approach speeds at one instant are equal. Smaller: the rounding of a place decides which impact is first.
pub(crate) const EQUAL_SPEED: f64 = 1e-10;

/// Relative to the largest force among joined bodies: what pulls at a light one. Smaller: rounding is more; larger: two of a kind are treated apart.
pub(crate) const LIGHT: f64 = 1e-3;

/// Larger islands do with fewer rounds across, and keep friction that turns in a step. Larger: heaps creep; smaller: friction acts a step late.
pub(crate) const MANY: usize = 256;
