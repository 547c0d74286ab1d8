//! Links: a force between two bodies, or a body and a place.

use crate::physics::data::domain::{DefError, MOST_DAMPING, MOST_STIFFNESS, expect};
use crate::physics::data::{Body, LinkDef, LinkLaw, Magnet, Pose, Spring, first, refill};
use crate::physics::forces::kind::ForceKind;
use glam::DVec2;

/// Rate × time of a part of a tick, at most, where links are stiff. Larger: things on stiff links are thrown off; smaller: more parts.
const REACH: f64 = 1.0;

impl Spring {
    /// F = k·(ℓ − L) + c·ℓ′ along its length ℓ on the first end, pulling where that is longer than L, N (Hooke 1678).
    #[inline]
    fn force(&self, apart: DVec2, parting: DVec2) -> DVec2 {
        let along = apart.normalize_or_zero();
        apart * self.stiffness + along * (self.damping * along.dot(parting) - self.stiffness * self.length)
    }
}

impl LinkLaw {
    /// On the first end, N; `apart` (m) leads to the other end and grows by `parting` (m/s). `above`: as above [`LinkLaw::border`], on either side.
    #[inline]
    pub(crate) fn force(&self, above: bool, apart: DVec2, parting: DVec2) -> DVec2 {
        match self {
            Self::Spring(spring) => spring.force(apart, parting),
            Self::Rope(rope) if above => rope.force(apart, parting),
            Self::Rope(_) => DVec2::ZERO,
            // F = s/ℓ² at a distance ℓ; nearer it falls evenly to 0 at none, as gravity does inside a ball of even density.
            Self::Magnet(Magnet { strength, nearest }) => {
                let distance = if above { apart.length() } else { *nearest };
                apart * (strength / (distance * distance * distance)).clamp(-f64::MAX, f64::MAX)
            }
        }
    }

    /// The energy that it holds at that distance (m) of its ends, J; of a magnet 0, whose work no figure counts.
    pub fn energy(&self, distance: f64) -> f64 {
        let of = |spring: &Spring, distance: f64| 0.5 * spring.stiffness * (distance - spring.length).powi(2);
        match self {
            Self::Spring(spring) => of(spring, distance),
            Self::Rope(rope) => of(rope, distance.max(rope.length)),
            Self::Magnet(_) => 0.0,
        }
    }

    /// The law bends where this is 0: of a rope the smaller one of its stretch and of its pull in stretches, m, above 0 where it pulls.
    pub(crate) fn border(&self, apart: DVec2, parting: DVec2) -> f64 {
        match self {
            Self::Spring(_) => 1.0,
            Self::Rope(Spring { length, stiffness, damping }) => {
                let (stretch, rate) = (apart.length() - length, apart.normalize_or_zero().dot(parting));
                stretch.min((stiffness * stretch + damping * rate) / (stiffness + damping).max(f64::MIN_POSITIVE))
            }
            Self::Magnet(magnet) => apart.length() - magnet.nearest,
        }
    }

    /// The kind under which its force is listed.
    pub const fn kind(&self) -> ForceKind {
        match self {
            Self::Spring(_) => ForceKind::Spring,
            Self::Rope(_) => ForceKind::Tension,
            Self::Magnet(_) => ForceKind::Magnetic,
        }
    }

    /// Its greatest stiffness, N/m, and damping, N·s/m.
    pub(crate) fn rates(&self) -> [f64; 2] {
        match self {
            Self::Spring(spring) | Self::Rope(spring) => [spring.stiffness, spring.damping],
            Self::Magnet(Magnet { strength, nearest }) => [2.0 * strength.abs() / (nearest * nearest * nearest), 0.0],
        }
    }
}

/// A link as it is now.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Link {
    pub(crate) def: LinkDef,
    /// With its present length.
    pub(crate) law: LinkLaw,
    pub(crate) on: bool,
    pub(crate) winds: bool,
    /// Its ends have touched, if it is one that waits for that.
    pub(crate) begun: bool,
    pub(crate) broken: bool,
    /// The rate of the fastest motion that it may give one of its ends, together with the links there are, 1/s.
    pub(crate) fastest: f64,
}

impl Link {
    /// Refuses what [`LinkDef`] cannot be, and links too stiff for a body, all of its `others` together.
    pub(crate) fn new(def: LinkDef, bodies: &[Body], others: &[Self]) -> Result<Self, DefError> {
        def.check(bodies)?;
        let mut law = def.law;
        if let LinkLaw::Magnet(magnet) = &mut law {
            magnet.nearest = magnet.nearest.max(def.ends().map(|end| bodies[end.index()].half.element_sum() * 0.5).sum());
        }
        let mut link = Self { def, law, on: true, winds: true, begun: false, broken: false, fastest: 0.0 };
        if !def.hook {
            link.begin(|id| (bodies[id as usize].position, DVec2::ZERO));
        }
        for end in def.ends() {
            let mass = bodies[end.index()].mass;
            let rates = others.iter().filter(|other| other.def.has(end.0)).chain([&link]).map(|link| link.law.rates());
            let [stiffness, damping] = rates.fold([0.0, 0.0], |sum, of| [sum[0] + of[0], sum[1] + of[1]]);
            let found = || format!("a link of {stiffness} N/m and {damping} N·s/m on {mass} kg, all of its links together");
            let reason = || format!("{}, expected at most {MOST_STIFFNESS} N/m and {MOST_DAMPING} N·s/m per kg", found());
            expect(stiffness <= MOST_STIFFNESS * mass && damping <= MOST_DAMPING * mass, reason)?;
            link.fastest = link.fastest.max((2.0 * stiffness / mass).sqrt() + damping / mass);
        }
        Ok(link)
    }

    /// How it began.
    pub const fn def(&self) -> &LinkDef {
        &self.def
    }

    /// Its law, with its present length.
    pub const fn law(&self) -> &LinkLaw {
        &self.law
    }

    /// Whether it has broken.
    pub const fn is_broken(&self) -> bool {
        self.broken
    }

    /// Whether it is on, has begun, and has not broken.
    pub const fn acts(&self) -> bool {
        self.on && self.begun && !self.broken
    }

    pub(crate) fn begin(&mut self, pose_of: impl Fn(u32) -> Pose) {
        self.begun = true;
        if self.def.as_found {
            self.law = self.law.of_length(self.def.apart(pose_of).0.length());
        }
    }

    /// The growth of its length in a tick of `dt` seconds, m/s: no length ends below 0.
    pub(crate) fn growth(&self, dt: f64) -> f64 {
        self.law.length().filter(|_| self.winds && self.acts()).map_or(0.0, |length| self.def.rate.max(-length / dt))
    }

    /// As it was `time` seconds before the end of a tick of `dt` seconds.
    pub(crate) fn sooner(&self, time: f64, dt: f64) -> Self {
        let growth = self.growth(dt);
        let law = self.law.length().filter(|_| growth != 0.0).map(|length| self.law.of_length(length - growth * time));
        Self { law: law.unwrap_or(self.law), ..*self }
    }

    /// The force on one of its bodies, N.
    pub(crate) fn on(&self, body: u32, pose_of: impl Fn(u32) -> Pose) -> DVec2 {
        let (apart, parting) = self.def.apart(pose_of);
        let force = self.law.force(self.law.border(apart, parting) > 0.0, apart, parting);
        if self.def.body.0 == body { force } else { -force }
    }

    pub(crate) fn acts_on(&self, body: u32) -> bool {
        self.acts() && self.def.has(body)
    }
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Links {
    pub all: Vec<Link>,
    /// Bodies that acting links join, directly or over others, group by group, ascending in each; and the range of each group.
    pub members: Vec<u32>,
    pub groups: Vec<(usize, usize)>,
    parents: Vec<u32>,
    by_root: Vec<(u32, u32)>,
}

impl Links {
    pub fn gather(&mut self) {
        let Self { all, members, groups, parents, by_root } = self;
        members.clear();
        let acting = || all.iter().filter(|link| link.acts());
        members.extend(acting().flat_map(|link| link.def.ends()).map(|body| body.0));
        members.sort_unstable();
        members.dedup();
        refill(parents, members.len(), 0);
        (0..).zip(&mut *parents).for_each(|(i, parent)| *parent = i);
        for (a, b) in acting().filter_map(|link| Some((link.def.body.0, link.def.other()?.0))) {
            let [a, b] = [a, b].map(|body| first(parents, members.binary_search(&body).unwrap_or_default()));
            parents[a.max(b)] = a.min(b) as u32;
        }
        by_root.clear();
        by_root.extend((0..members.len()).map(|i| (first(parents, i) as u32, members[i])));
        by_root.sort_unstable();
        groups.clear();
        let mut from = 0;
        for group in by_root.chunk_by(|a, b| a.0 == b.0) {
            groups.push((from, from + group.len()));
            from += group.len();
        }
        members.clear();
        members.extend(by_root.iter().map(|(_, body)| *body));
    }

    /// The number of parts in which a tick of `dt` seconds is taken: the mean force of a stiff link over all of it would throw what touches its ends.
    pub fn parts(&self, dt: f64) -> u32 {
        self.all.iter().map(|link| (link.fastest * dt / REACH).ceil() as u32).fold(1, u32::max)
    }

    /// The force of all links on a body, N.
    pub fn on(&self, body: u32, pose_of: impl Fn(u32) -> Pose) -> DVec2 {
        links_on(&self.all, body, pose_of)
    }
}

pub(crate) fn links_on(links: &[Link], body: u32, pose_of: impl Fn(u32) -> Pose) -> DVec2 {
    links.iter().filter(|link| link.acts_on(body)).map(|link| link.on(body, &pose_of)).sum()
}
