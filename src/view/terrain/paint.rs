//! Draws the terrain: the mass, its materials, the drafting, its edge, and the light on it.

use super::light::{Lit, RockMesh, cast};
use super::silhouette::{Corner, RockEdge, Silhouette};
use super::{Dimension, RIM, ROCK, Tint, dimensions, frame, hatching, kind, mass};
use crate::draw::layout::{Area, DETAILS, Vec2};
use crate::draw::{Canvas, Colour, Quads, Style};
use crate::level::{Landscape, Level, SHIP_HALF};
use crate::physics::{Aabb, DVec2, Material};
use crate::view::art::{self, Tile, rock::face_of};
use crate::view::{camera::Viewport, sky, theme};

/// Opacity of rock over an author's picture; materials are more opaque, so that they stay distinct.
const ROCK_OVER_PICTURE: f32 = 0.45;
const MATERIAL_OVER_PICTURE: f32 = 0.85;
/// Depth of light from outside in the rock, m.
const LIT_DEPTH: f64 = 1.2;
/// Widths of an upward edge and of the others, canvas units.
const TOP_WIDTH: f32 = 2.6;
const SIDE_WIDTH: f32 = 1.7;
/// Opacities of the ink.
const HATCHING: f32 = 0.24;
const DIMENSION: f32 = 0.5;
/// Margin of dimension lines to the level's edge, m.
const BORDER: f64 = 0.5;
/// The reach of a lamp in a ceiling, m, half the angle of its cone (rad), and its light.
const CONE: (f64, f32) = (11.0, 0.36);
const CONE_LIGHT: f32 = 0.26;
/// The most fixed lights, whose light is computed once.
const MOST_LAMPS: usize = 1000;

pub struct Terrain {
    pub(in crate::view) mass: Silhouette,
    /// The edges of each kind but plain rock.
    seams: Vec<RockEdge>,
    strokes: Vec<(DVec2, DVec2)>,
    dimensions: Vec<(Dimension, String)>,
    pub tint: Tint,
    /// Boxes that cast shadows.
    opaque: Vec<Aabb>,
    lit: Vec<Vec<Lit>>,
    over_picture: bool,
    /// The boxes without solid ground, or with glass alone, m.
    open: Vec<Aabb>,
    /// Places of lamps in the ceilings over pads, m.
    ceiling_lamps: Vec<DVec2>,
    rock: RockMesh,
}

impl Terrain {
    /// `lamps` are the boxes that glow all the time, each with its reach (m); `texts` are the areas of words.
    pub fn new(level: &Level, lamps: impl Iterator<Item = (Aabb, f64)>, texts: &[Aabb], over_picture: bool) -> Self {
        let mass = mass(level);
        let glass = kind("Glass");
        let solid = level.world.iter().filter(|it| it.is_rock() && kind(it.material.name) != glass).map(|it| it.bounds);
        let opaque: Vec<Aabb> = solid.chain(level.streams.iter().map(|stream| stream.source)).collect();
        let sources = level.streams.iter().map(|stream| stream.source);
        // The window's edge cuts off what is drafted there.
        let inner = Aabb::new(level.bounds().min + BORDER, level.bounds().max - BORDER);
        let taken: Vec<Aabb> = texts.iter().copied().chain(sources).chain(frame(&level.bounds(), &inner)).collect();
        let seams = (ROCK + 1..Material::ALL.len())
            .flat_map(|kind| Silhouette::new(&mass.pieces().filter(|piece| piece.1 == kind).collect::<Vec<_>>()).edges.to_vec());
        let dimensions = dimensions(&mass, ROCK, &taken);
        let tint = Tint::of(level.landscape, &level.name);
        let storeys = (level.storeys && tint.world.is_some()).then_some(level.size.y);
        Self {
            seams: seams.collect(),
            strokes: hatching(&mass, ROCK),
            dimensions: dimensions.into_iter().map(|dimension| (dimension, metres(dimension.length()))).collect(),
            tint: Tint { storeys, ..tint },
            lit: lamps.take(MOST_LAMPS).map(|(bounds, reach)| cast(&mass.edges, &bounds, reach, &opaque)).collect(),
            opaque,
            open: mass.open(&level.bounds(), glass),
            ceiling_lamps: ceiling_lamps(level, &mass),
            rock: RockMesh::default(),
            mass,
            over_picture,
        }
    }

    /// The box of the open space, m.
    pub fn rooms(&self) -> Option<Aabb> {
        self.mass.edges.iter().map(RockEdge::bounds).reduce(|all, edge| all.union(&edge))
    }

    /// Draws the part in view. The words of dimensions lie on the layer's top, beside those labels and that display.
    pub fn draw(&self, view: &Viewport, canvas: &Canvas, taken: &[Area]) {
        self.draw_mass(view, canvas);
        let mut quads = Quads::default();
        self.draw_hatching(view, canvas.frame().pixel, &mut quads);
        self.draw_dimensions(view, canvas, taken, &mut quads);
        canvas.quads(quads);
        self.draw_edges(view, canvas);
        for lamp in self.ceiling_lamps.iter().filter(|_| !RockMesh::is_plain(view)) {
            let (low, high) = (DVec2::new(-0.3, -0.14), DVec2::new(0.3, 0.0));
            let body = view.rect(&Aabb::new(*lamp + low, *lamp + high));
            art::halo(canvas, body, 16.0, sky::LAMP.faded(0.35));
            canvas.rectangle(body, sky::LAMP);
        }
    }

    /// The colour of an edge: the light of the level's world falls on one side.
    fn rim(&self, edge: &RockEdge) -> Colour {
        let tint = self.tint.at(edge.bounds().centre().y);
        let plain = material_edge(Material::ALL[edge.kind].name).unwrap_or(tint.edge);
        match tint.rim.filter(|_| edge.kind == ROCK) {
            Some((rim, towards)) => {
                let facing = -edge.inward.dot(towards) as f32;
                if facing > 0.0 { plain.mixed(rim, facing) } else { plain.mixed(tint.deep, 0.45 * -facing) }
            }
            None => plain,
        }
    }

    /// `index` counts the lamps of [`Self::new`].
    pub fn draw_lamp(&self, index: usize, colour: Colour, (view, canvas): (&Viewport, &Canvas)) {
        if let Some(lit) = self.lit.get(index) {
            draw_lit(lit, colour, (view, canvas));
        }
    }

    /// The light of a moving point (m), up to `reach` metres far.
    pub fn draw_moving_light(&self, at: DVec2, reach: f64, colour: Colour, (view, canvas): (&Viewport, &Canvas)) {
        let source = Aabb::around(at, DVec2::ZERO);
        if Aabb::around(at, DVec2::splat(reach)).touches(&view.visible(), 0.0) {
            draw_lit(&cast(&self.mass.edges, &source, reach, &self.opaque), colour, (view, canvas));
        }
    }

    fn draw_mass(&self, view: &Viewport, canvas: &Canvas) {
        let visible = view.visible();
        let (rock, material) = if self.over_picture { (ROCK_OVER_PICTURE, MATERIAL_OVER_PICTURE) } else { (1.0, 1.0) };
        // All of the rock, then all of the rest: a change between plain and painted shapes costs a draw call.
        let in_view = || self.mass.pieces().filter(|(bounds, _)| bounds.overlaps(&visible, 0.0));
        if RockMesh::is_plain(view) {
            for (bounds, _) in in_view().filter(|(_, kind)| *kind == ROCK) {
                for strip in self.tint.strips(&bounds) {
                    let tint = self.tint.at(strip.centre().y);
                    canvas.rectangle(view.rect(&strip), tint.deep.mixed(tint.lit, 0.5).faded(rock));
                }
            }
        } else {
            let mut cells = self.rock.show(false, &self.mass, &self.open, &self.tint, view);
            if self.over_picture {
                cells.iter_mut().flat_map(|(quad, _)| &mut quad.colours).for_each(|colour| *colour = colour.faded(rock));
            }
            match self.tint.world {
                Some(world) => canvas.textured(face_of(world), cells),
                None => canvas.quads(Quads(cells.into_iter().map(|(quad, _)| quad).collect())),
            }
        }
        for (bounds, kind) in in_view().filter(|(_, kind)| *kind != ROCK) {
            art::fill(canvas, Tile::Material(Material::ALL[kind].name), &bounds, view, Colour::WHITE.faded(material));
        }
        // Beyond the rock round a level that is smaller than the window there is more of it.
        let level = view.level();
        let (all, size) = (view.rect(&Aabb::new(level.min - RIM, level.max + RIM)), canvas.size());
        let around = [
            Area::new(0.0, 0.0, size.x, all.min.y),
            Area::new(0.0, all.max().y, size.x, size.y - all.max().y),
            Area::new(0.0, all.min.y, all.min.x, all.size.y),
            Area::new(all.max().x, all.min.y, size.x - all.max().x, all.size.y),
        ];
        for area in around.into_iter().filter(|area| area.size.x > 0.0 && area.size.y > 0.0) {
            canvas.rectangle(area, self.tint.deep);
        }
        let width = canvas.frame().pixel.max(1.5);
        for edge in self.seams.iter().filter(|edge| edge.bounds().touches(&visible, 0.0)) {
            draw_side(edge, width, Colour::hex(0x05070A).faded(0.55), (view, canvas));
        }
    }

    /// The shade in the air along the rock: it lies on the sky and on liquids.
    pub fn draw_shade(&self, view: &Viewport, canvas: &Canvas) {
        if !self.over_picture && !RockMesh::is_plain(view) {
            let cells = self.rock.show(true, &self.mass, &self.open, &self.tint, view);
            canvas.quads(Quads(cells.into_iter().map(|(quad, _)| quad).collect()));
            for lamp in &self.ceiling_lamps {
                canvas.quads(sky::beam(view.point(*lamp), Vec2::Y, (view.length(CONE.0), CONE.1), sky::LAMP.faded(CONE_LIGHT)));
            }
        }
    }

    /// The height of the ground of the level's world, m: where the ship starts, or under water the lowest ground.
    pub fn floor(&self, level: &Level) -> f64 {
        let lowest = || self.open.iter().map(|bounds| bounds.max.y).fold(0.0, f64::max);
        let dry = level.ship_plays() && level.landscape != Some(Landscape::Water);
        if dry { level.player.position.y + SHIP_HALF.y } else { lowest() }
    }

    /// The parts of the window without solid ground, canvas units.
    pub fn air(&self, view: &Viewport) -> Vec<Area> {
        let visible = view.visible();
        let shown = |bounds: &Aabb| view.rect(&Aabb::new(bounds.min.max(visible.min), bounds.max.min(visible.max)));
        self.open.iter().filter(|bounds| bounds.overlaps(&visible, 0.0)).map(shown).collect()
    }

    fn edges_in_view(&self, view: &Viewport) -> impl Iterator<Item = &RockEdge> {
        let visible = view.visible();
        self.mass.edges.iter().filter(move |edge| edge.bounds().touches(&visible, 0.2))
    }

    fn draw_hatching(&self, view: &Viewport, pixel: f32, quads: &mut Quads) {
        let visible = view.visible();
        for (from, to) in &self.strokes {
            if from.cmpge(visible.min - 1.5).all() && from.cmple(visible.max + 1.5).all() {
                let colour = self.tint.at(from.y).ink.faded(HATCHING);
                quads.stroke([view.point(*from), view.point(*to)], pixel.max(1.2), [colour, colour.faded(0.0)]);
            }
        }
    }

    fn draw_dimensions(&self, view: &Viewport, canvas: &Canvas, taken: &[Area], quads: &mut Quads) {
        let colour = self.tint.ink.faded(DIMENSION);
        let style = Style::new(DETAILS, self.tint.ink.faded(0.85)).mono().centred().middle();
        let (reach, arrow) = (canvas.frame().pixel.max(1.1), 9.0);
        let mut taken = taken.to_vec();
        for (line, words) in self.dimensions.iter().filter(|(line, _)| line.bounds().touches(&view.visible(), 0.0)) {
            let (from, to, back) = (view.point(line.from), view.point(line.to), line.to_edge.normalize_or_zero().as_vec2());
            let way = (to - from).normalize_or_zero();
            let across = way.perp();
            let middle = (from + to) / 2.0;
            let gap = if way.x > 0.5 { canvas.width(words, style) / 2.0 + 8.0 } else { canvas.line_height(DETAILS) * 0.5 + 2.0 };
            let sign = Area::around(middle, Vec2::new(canvas.width(words, style), canvas.line_height(DETAILS)));
            // In a far view the words have no room between the arrows.
            if (to - from).length() < 2.0 * (gap + arrow) || !sign.covers_none(&taken) {
                continue;
            }
            taken.push(sign);
            quads.stroke([from, middle - way * gap], reach, [colour; 2]);
            quads.stroke([middle + way * gap, to], reach, [colour; 2]);
            for (tip, way) in [(from, way), (to, -way)] {
                quads.triangle([tip, tip + way * arrow + across * 3.2, tip + way * arrow - across * 3.2], colour);
                // From a little off the edge to a little beyond the line.
                let edge = back * view.length(line.to_edge.length());
                quads.stroke([tip - back * 6.0, tip + edge - back * 8.0], reach, [colour.faded(0.7), colour.faded(0.35)]);
            }
            canvas.text(words, middle, style);
        }
    }

    /// The edge, inside the mass: upward edges last and brightest.
    fn draw_edges(&self, view: &Viewport, canvas: &Canvas) {
        let up = |edge: &&RockEdge| edge.inward.y > 0.5;
        for edge in self.edges_in_view(view).filter(|edge| !up(edge)) {
            let bright = self.rim(edge);
            let shade = if Material::ALL[edge.kind].name == "Glass" { 1.0 } else { 0.85 };
            draw_side(edge, SIDE_WIDTH, Colour::new(bright.r * shade, bright.g * shade, bright.b * shade, 1.0), (view, canvas));
        }
        for edge in self.edges_in_view(view).filter(up) {
            draw_side(edge, TOP_WIDTH, self.rim(edge), (view, canvas));
        }
    }
}

/// Lamps in the rock over the start and the goals of a launch site: of its ceilings only those near enough to light them.
fn ceiling_lamps(level: &Level, mass: &Silhouette) -> Vec<DVec2> {
    if level.landscape != Some(Landscape::Launch) || theme::is_plain() {
        return Vec::new();
    }
    let pads = level.objectives.iter().map(|goal| DVec2::new(goal.bounds.centre().x, goal.bounds.min.y));
    let pads = pads.chain(level.ship_plays().then_some(level.player.position));
    let over = |pad: DVec2| {
        let ceilings = mass.edges.iter().filter(|edge| edge.kind == ROCK && edge.inward.y < 0.0 && edge.depth > 0.4);
        let above = ceilings.filter(|it| it.bounds().min.x < pad.x - 0.4 && it.bounds().max.x > pad.x + 0.4 && it.from.y < pad.y);
        let height = above.map(|edge| edge.from.y).fold(f64::MIN, f64::max);
        ((2.5..CONE.0).contains(&(pad.y - height))).then_some(DVec2::new(pad.x, height))
    };
    pads.filter_map(over).collect()
}

/// The brightest colour of a material's edge, which marks it where only its side is in view; `None` for plain rock.
pub fn material_edge(name: &str) -> Option<Colour> {
    Some(match name {
        "Glass" => Colour::hex(0xCDEBFF),
        "Ice" => Colour::hex(0xE4F6FF),
        "Wood" => Colour::hex(0xC9A27C),
        "Rubber" => Colour::hex(0x6B7487),
        "Steel" => Colour::hex(0xB4C2D6),
        "Trampoline" => Colour::hex(0xE39AD0),
        _ => return None,
    })
}

/// A line along an edge, inside the mass, on whole pixels; it goes round corners of the open space.
fn draw_side(edge: &RockEdge, width: f32, colour: Colour, (view, canvas): (&Viewport, &Canvas)) {
    let line = view.rect(&edge.bounds());
    let reaches = |end: usize| if edge.corners[end] == Corner::Inner { width } else { 0.0 };
    // The mass is on the right hand: edges that face up and right begin at their smaller end.
    let (low, high) = if edge.along().element_sum() > 0.0 { (reaches(0), reaches(1)) } else { (reaches(1), reaches(0)) };
    let out = |towards: f64| if towards > 0.0 { 0.0 } else { width };
    let area = if edge.inward.x == 0.0 {
        Area::new(line.min.x - low, line.min.y - out(edge.inward.y), line.size.x + low + high, width)
    } else {
        Area::new(line.min.x - out(edge.inward.x), line.min.y - low, width, line.size.y + low + high)
    };
    canvas.rectangle(area, colour);
}

fn draw_lit(lit: &[Lit], colour: Colour, (view, canvas): (&Viewport, &Canvas)) {
    let visible = view.visible();
    let mut quads = Quads::default();
    for piece in lit {
        let Lit { from, to, inward, depth, strength } = *piece;
        if !Aabb::new(from.min(to), from.max(to)).touches(&visible, LIT_DEPTH) {
            continue;
        }
        let corner = |at: DVec2, deep: f64| view.point(at + inward * deep);
        let [a, b] = strength.map(|s| colour.faded(s));
        let deep = LIT_DEPTH.min(depth * 0.75);
        let half = |c: Colour| c.faded(0.5);
        let corners = [corner(from, 0.0), corner(to, 0.0), corner(to, deep), corner(from, deep)];
        quads.quad(corners, [half(a), half(b), b.faded(0.0), a.faded(0.0)]);
        let line = inward.as_vec2() * TOP_WIDTH;
        quads.quad([corner(from, 0.0), corner(to, 0.0), corner(to, 0.0) + line, corner(from, 0.0) + line], [a, b, b, a]);
    }
    canvas.quads(quads);
}

/// As on a drawing: metres, a decimal only where there is one.
fn metres(length: f64) -> String {
    let tenths = (length * 10.0).round();
    if tenths % 10.0 == 0.0 { format!("{:.0} m", tenths / 10.0) } else { format!("{:.1} m", tenths / 10.0) }
}
