//! A level in small: what a card shows of it.

use crate::level::{Landscape, Level, ObjectiveKind, SHIP_HALF};
use crate::physics::{Aabb, DVec2};

/// The most things of a kind that are shown, the largest ones: a card has no room for more, and a page has fifteen cards.
const MOST: usize = 160;

/// What a shape stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MiniaturePart {
    /// What is solid.
    Solid,
    /// A thick liquid.
    Liquid([u8; 3]),
    /// Where an air stream blows.
    Stream,
    /// A death box.
    Deadly,
    /// Where the ship has to go.
    PlayerObjective,
    /// Where a key object has to go.
    PhysicsObjective,
    /// A physics object.
    Object,
    /// A key object, in its colour.
    Key([u8; 3]),
    /// The ship.
    Ship,
}

/// The shapes of a level, m, in the order in which they are drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Miniature {
    /// The level's size, m.
    pub size: DVec2,
    /// What is where.
    pub shapes: Vec<(Aabb, MiniaturePart)>,
    /// Its world's colours.
    pub landscape: Option<Landscape>,
}

impl Miniature {
    /// The level in small.
    pub fn of(level: &Level) -> Self {
        let mut shapes = Vec::new();
        let mut add = |kind: Vec<(Aabb, MiniaturePart)>| {
            let mut kind = kind;
            let area = |shape: &(Aabb, MiniaturePart)| shape.0.size().element_product();
            kind.sort_by(|a, b| area(b).total_cmp(&area(a)));
            kind.truncate(MOST);
            shapes.extend(kind);
        };
        add(level.streams.iter().map(|stream| (stream.zone, MiniaturePart::Stream)).collect());
        add(level.fluids.iter().map(|fluid| (fluid.zone, MiniaturePart::Liquid(fluid.colour))).collect());
        add(level.world.iter().map(|solid| (solid.bounds, MiniaturePart::Solid)).collect());
        let blocks = level.movers.iter().map(|mover| &mover.solid).chain(&level.doors);
        add(blocks.map(|block| (block.bounds, MiniaturePart::Solid)).collect());
        add(level.streams.iter().map(|stream| (stream.source, MiniaturePart::Solid)).collect());
        add(level.obstacles.iter().map(|deadly| (*deadly, MiniaturePart::Deadly)).collect());
        let objective = |kind| match kind {
            ObjectiveKind::Player => MiniaturePart::PlayerObjective,
            ObjectiveKind::Physics => MiniaturePart::PhysicsObjective,
        };
        add(level.objectives.iter().map(|it| (it.bounds, objective(it.kind))).collect());
        let object = |key: Option<[u8; 3]>| key.map_or(MiniaturePart::Object, MiniaturePart::Key);
        add(level.objects.iter().map(|it| (Aabb::around(it.position, it.size * 0.5), object(it.key))).collect());
        let ship = level.ship_plays().then(|| (Aabb::around(level.player.position, SHIP_HALF), MiniaturePart::Ship));
        add(ship.into_iter().collect());
        Self { size: level.size, shapes, landscape: level.landscape }
    }
}

mod drawing {
    use super::{Miniature, MiniaturePart};
    use crate::draw::layout::{Area, Vec2};
    use crate::draw::{Canvas, Colour, Quads};
    use crate::physics::DVec2;
    use crate::view::sky::{self, WorldPalette};
    use crate::view::terrain::Tint;
    use crate::view::theme;

    /// What can be acted upon is drawn at least this large, canvas units: a ship in a level of kilometres is still to be seen.
    const LEAST: f32 = 4.0;

    impl Miniature {
        /// Draws the level in its tint as large as it fits, in the middle of the area.
        pub fn draw(&self, tint: &Tint, canvas: &Canvas, area: Area) {
            let scale = (f64::from(area.size.x) / self.size.x).min(f64::from(area.size.y) / self.size.y);
            let paper = Area::around(area.centre(), (self.size * scale).as_vec2());
            canvas.rounded(paper, 2.0, theme::ground());
            if let Some(landscape) = self.landscape.filter(|_| !theme::is_plain()) {
                let mut quads = Quads::default();
                sky::gradient(&mut quads, paper, WorldPalette::of(landscape).sky);
                canvas.quads(quads);
            }
            canvas.rounded_edge(paper.inset(-1.0), 2.0, 1.0, tint.heavy);
            let point = |metres: DVec2| paper.min + (metres * scale).as_vec2().clamp(Vec2::ZERO, paper.size);
            for (bounds, part) in &self.shapes {
                let (a, b) = (point(bounds.min), point(bounds.max));
                let least = if matches!(part, MiniaturePart::Solid | MiniaturePart::Liquid(_) | MiniaturePart::Stream) {
                    canvas.frame().pixel
                } else {
                    LEAST
                };
                let size = (b - a).max(Vec2::splat(least).min(paper.size));
                let min = ((a + b - size) / 2.0).clamp(paper.min, paper.max() - size);
                canvas.rectangle(Area::new(min.x, min.y, size.x, size.y), colour(*part, tint));
            }
        }
    }

    fn colour(part: MiniaturePart, tint: &Tint) -> Colour {
        let own = |[r, g, b]: [u8; 3]| Colour::of([r, g, b]);
        match part {
            MiniaturePart::Solid => tint.map,
            MiniaturePart::Liquid(colour) => own(colour).faded(0.55),
            MiniaturePart::Stream => theme::text().faded(0.16),
            MiniaturePart::Deadly => theme::bad(),
            MiniaturePart::PlayerObjective => theme::player_objective(),
            MiniaturePart::PhysicsObjective => theme::physics_objective(),
            MiniaturePart::Object => theme::text(),
            MiniaturePart::Key(colour) => own(colour),
            MiniaturePart::Ship => theme::text(),
        }
    }
}
