//! The palette: a physicist's notebook at night. Each colour has one meaning; sizes are in [`crate::draw::layout`].

use crate::{draw::Colour, instruments::chart, physics::ForceKind, settings::Palette};
use std::sync::atomic::{AtomicU8, Ordering};

macro_rules! colours {
    ($($(#[$doc:meta])* $name:ident,)*) => {
        struct Colours {
            $($name: Colour,)*
        }

        $($(#[$doc])*
        pub fn $name() -> Colour {
            colours().$name
        })*
    };
}

colours! {
    ground,
    panel,
    /// Buttons: they stand out from the ground and from panels.
    button,
    /// A button under the pointer, and a selected row.
    panel_hover,
    panel_edge,
    /// Line of the graph paper every metre.
    grid_fine,
    /// Line of the graph paper every ten metres.
    grid_heavy,
    solid,
    solid_top,
    text,
    /// Words of less weight.
    quiet,
    /// The title, the ship's trim, keyboard focus, fuel.
    accent,
    /// Success.
    good,
    /// Damage and death.
    bad,
    /// An objective for the ship; the best score.
    player_objective,
    /// An objective for a key object.
    physics_objective,
}

/// The art direction's palette.
const STANDARD: Colours = Colours {
    ground: Colour::hex(0x10141B),
    panel: Colour::hex(0x1B2230),
    button: Colour::hex(0x212B3D),
    panel_hover: Colour::hex(0x2F3C57),
    panel_edge: Colour::hex(0x2C3648),
    grid_fine: Colour::hex(0x1A2130),
    grid_heavy: Colour::hex(0x232C3D),
    solid: Colour::hex(0x3A4456),
    solid_top: Colour::hex(0x566379),
    text: Colour::hex(0xE6EBF2),
    quiet: Colour::hex(0x93A0B4),
    accent: Colour::hex(0xFF9F1C),
    good: Colour::hex(0x4CC38A),
    bad: Colour::hex(0xF2555A),
    player_objective: Colour::hex(0xF2C744),
    physics_objective: Colour::hex(0xD65DB1),
};

/// Colours with a meaning differ by at least 15 units of CIEDE2000 from each other, from words, rock and ground, in normal sight
/// and in the three common kinds of colour blindness (simulated after Machado, Oliveira and Fernandes, 2009).
const SAFE: Colours = Colours {
    accent: Colour::hex(0xDC7603),
    good: Colour::hex(0x63C09A),
    bad: Colour::hex(0xBA1617),
    player_objective: Colour::hex(0xF7D960),
    physics_objective: Colour::hex(0x9E52A5),
    ..STANDARD
};

/// On black, with white edges.
const HIGH_CONTRAST: Colours = Colours {
    ground: Colour::hex(0x000000),
    panel: Colour::hex(0x000000),
    button: Colour::hex(0x000000),
    panel_hover: Colour::hex(0x20304A),
    panel_edge: Colour::hex(0xC8D2E0),
    grid_fine: Colour::hex(0x10141B),
    grid_heavy: Colour::hex(0x1B2230),
    solid: Colour::hex(0x4A566B),
    solid_top: Colour::hex(0xFFFFFF),
    text: Colour::hex(0xFFFFFF),
    quiet: Colour::hex(0xD5DDE8),
    ..SAFE
};

/// Below the colour of a goal, in every world, and the share of that colour at the plate's top and at its foot.
const PLATE: Colour = Colour::hex(0x0A0D14);
pub const PLATE_FILL: [f32; 2] = [0.10, 0.40];
pub const HAZARD_EDGE: Colour = Colour::hex(0xFF7A7E);

/// The present palette: the view's own state, which the player's setting sets once a frame.
static WORN: AtomicU8 = AtomicU8::new(0);

pub fn wear(palette: Palette) {
    WORN.store(palette as u8, Ordering::Relaxed);
}

fn colours() -> &'static Colours {
    match WORN.load(Ordering::Relaxed) {
        0 => &STANDARD,
        2 => &HIGH_CONTRAST,
        _ => &SAFE,
    }
}

/// Whether worlds have no sky and no colours of their own: in high contrast, and for a projector.
pub fn is_plain() -> bool {
    WORN.load(Ordering::Relaxed) >= Palette::HighContrast as u8
}

/// Whether the pen turns all colours to those for white ([`Colour::on_white`]).
pub fn is_light() -> bool {
    WORN.load(Ordering::Relaxed) == Palette::Projector as u8
}

pub fn plate() -> Colour {
    if is_plain() { colours().ground } else { PLATE }
}

pub const RESULTANT: Colour = Colour::hex(chart::RESULTANT);

/// Velocity and acceleration.
pub const VELOCITY: Colour = Colour::hex(0x2EE6D6);
pub const ACCELERATION: Colour = Colour::hex(0xFF8FB1);

/// An impact: at least 11 units of CIEDE2000 from every force, in normal sight and in the three common kinds of colour blindness (as above).
pub const IMPACT: Colour = Colour::hex(0xAE62FF);

pub const fn force(kind: ForceKind) -> Colour {
    Colour::hex(chart::force(kind))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draw::layout::{Area, Frame, Vec2};
    use crate::draw::{Canvas, Painting, raster};
    use crate::level::{self, Landscape, Level};
    use crate::physics::Aabb;
    use crate::view::art::Pictures;
    use crate::view::camera::{CanvasWindow, Viewport};
    use crate::view::sky::WorldPalette;
    use crate::view::terrain::{Terrain, kind};
    use crate::view::{art, world};
    use std::path::Path;

    /// Colour blindness on linear light, after Machado, Oliveira and Fernandes (2009), full strength: none, protan, deutan, tritan.
    const SIGHTS: [[[f64; 3]; 3]; 4] = [
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
        [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
        [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]],
    ];

    /// CIELAB (D65) of a colour, seen with that sight.
    fn lab(colour: Colour, sight: &[[f64; 3]; 3]) -> [f64; 3] {
        let linear = [colour.r, colour.g, colour.b].map(|c| {
            let c = f64::from(c);
            if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
        });
        let mix = |row: &[f64; 3], of: &[f64; 3]| row.iter().zip(of).map(|(a, b)| a * b).sum::<f64>();
        let [r, g, b] = [0, 1, 2].map(|i| mix(&sight[i], &linear).clamp(0.0, 1.0));
        let f = |t: f64| if t > 216.0 / 24389.0 { t.cbrt() } else { (24389.0 / 27.0 * t + 16.0) / 116.0 };
        let x = f((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047);
        let y = f(0.2126729 * r + 0.7151522 * g + 0.0721750 * b);
        let z = f((0.0193339 * r + 0.1191920 * g + 0.9503041 * b) / 1.08883);
        [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
    }

    /// CIEDE2000, after Sharma, Wu and Dalal (2005).
    fn difference([l1, a1, b1]: [f64; 3], [l2, a2, b2]: [f64; 3]) -> f64 {
        let seventh = |c: f64| (c.powi(7) / (c.powi(7) + 25f64.powi(7))).sqrt();
        let g = 0.5 * (1.0 - seventh((a1.hypot(b1) + a2.hypot(b2)) / 2.0));
        let (a1, a2) = (a1 * (1.0 + g), a2 * (1.0 + g));
        let (c1, c2) = (a1.hypot(b1), a2.hypot(b2));
        let hue = |a: f64, b: f64| b.atan2(a).to_degrees().rem_euclid(360.0);
        let (h1, h2) = (hue(a1, b1), hue(a2, b2));
        let turn = if c1 * c2 == 0.0 { 0.0 } else { (h2 - h1 + 180.0).rem_euclid(360.0) - 180.0 };
        let (dl, dc, dh) = (l2 - l1, c2 - c1, 2.0 * (c1 * c2).sqrt() * (turn / 2.0).to_radians().sin());
        let (l, c, h) = ((l1 + l2) / 2.0, (c1 + c2) / 2.0, if c1 * c2 == 0.0 { h1 + h2 } else { h1 + turn / 2.0 });
        let cos = |degrees: f64| degrees.to_radians().cos();
        let t = 1.0 - 0.17 * cos(h - 30.0) + 0.24 * cos(2.0 * h) + 0.32 * cos(3.0 * h + 6.0) - 0.20 * cos(4.0 * h - 63.0);
        let rotation = 2.0 * seventh(c) * -(60.0 * (-((h.rem_euclid(360.0) - 275.0) / 25.0).powi(2)).exp()).to_radians().sin();
        let of_l = dl / (1.0 + 0.015 * (l - 50.0).powi(2) / (20.0 + (l - 50.0).powi(2)).sqrt());
        let (of_c, of_h) = (dc / (1.0 + 0.045 * c), dh / (1.0 + 0.015 * c * t));
        (of_l * of_l + of_c * of_c + of_h * of_h + rotation * of_c * of_h).sqrt()
    }

    /// Two pairs of the paper's table of test data.
    #[test]
    fn the_difference_of_colours_is_that_of_the_paper() {
        let is = |a, b, expected: f64| assert!((difference(a, b) - expected).abs() < 5e-5, "{}", difference(a, b));
        is([50.0, 2.6772, -79.7751], [50.0, 0.0, -82.7485], 2.0425);
        is([50.0, 2.5, 0.0], [61.0, -5.0, 29.0], 22.8977);
    }

    #[test]
    fn what_carries_a_meaning_is_told_apart_with_every_sight() {
        let of = |c: &Colours| [c.ground, c.solid, c.text, c.good, c.bad, c.player_objective, c.physics_objective, c.accent];
        let light = of(&SAFE).map(Colour::on_white);
        for (colours, least) in [(of(&SAFE), 15.0), (of(&HIGH_CONTRAST), 13.0), (light, 10.0)] {
            for (kind, sight) in SIGHTS.iter().enumerate() {
                let labs = colours.map(|colour| lab(colour, sight));
                for (i, a) in labs.iter().enumerate() {
                    for (j, b) in labs.iter().enumerate().skip(i + 1) {
                        let apart = difference(*a, *b);
                        assert!(apart >= least, "colours {i} and {j} with sight {kind}: {apart:.1}");
                    }
                }
            }
        }
    }

    /// The relative luminance of WCAG 2.
    fn luminance(colour: Colour) -> f64 {
        let part = |c: f32| if c <= 0.04045 { f64::from(c) / 12.92 } else { ((f64::from(c) + 0.055) / 1.055).powf(2.4) };
        0.2126 * part(colour.r) + 0.7152 * part(colour.g) + 0.0722 * part(colour.b)
    }

    #[test]
    fn goals_and_hazards_stand_out_on_their_plates() {
        let contrast = |colour: Colour, ground: Colour| (luminance(colour) + 0.05) / (luminance(ground) + 0.05);
        let on_plate = |colour: Colour| contrast(colour, PLATE.mixed(colour, PLATE_FILL[0]));
        assert!(on_plate(STANDARD.player_objective) >= 8.8, "{}", on_plate(STANDARD.player_objective));
        assert!(on_plate(STANDARD.physics_objective) >= 4.1, "{}", on_plate(STANDARD.physics_objective));
        assert!(contrast(HAZARD_EDGE, PLATE) >= 6.3, "{}", contrast(HAZARD_EDGE, PLATE));
        let words = PLATE.mixed(STANDARD.player_objective, PLATE_FILL[0].midpoint(PLATE_FILL[1]));
        assert!(contrast(STANDARD.text, words) >= 4.5, "{}", contrast(STANDARD.text, words));
    }

    /// The least contrast of words that are not small, and of drawings, is 3 to 1 (WCAG 2); of all words of weight 4.5.
    #[test]
    fn everything_is_dark_on_the_light_ground_of_a_projector() {
        let forces = ForceKind::ALL.map(force).into_iter().chain([RESULTANT, VELOCITY, ACCELERATION, IMPACT]);
        let drawn = forces.chain([SAFE.good, SAFE.bad, SAFE.accent, SAFE.player_objective, SAFE.physics_objective]);
        for ground in [SAFE.ground, SAFE.panel].map(|ground| luminance(ground.on_white())) {
            let contrast = |colour: Colour| (ground + 0.05) / (luminance(colour.on_white()) + 0.05);
            assert!(ground > 0.6 && contrast(SAFE.text) > 9.0 && contrast(SAFE.quiet) > 3.8);
            drawn.clone().for_each(|colour| assert!(contrast(colour) > 2.4, "{colour:?}: {}", contrast(colour)));
            let words = |colour: Colour| (ground + 0.05) / (luminance(colour.words_on_white()) + 0.05);
            drawn.clone().chain([SAFE.quiet]).for_each(|colour| assert!(words(colour) > 4.4, "{colour:?}: {}", words(colour)));
        }
    }

    /// A goal's plate covers at least this share of what is behind it; on the bare sky some pairs would look alike.
    const PLATE_COVER: f32 = 0.8;

    #[test]
    fn what_carries_a_meaning_stands_out_on_a_plate_in_every_world() {
        let meanings = [SAFE.text, SAFE.good, SAFE.bad, SAFE.player_objective, SAFE.physics_objective, SAFE.accent];
        for landscape in Landscape::ALL {
            let WorldPalette { sky, layers, rock, .. } = WorldPalette::of(landscape);
            for ground in sky.iter().map(|(_, tone)| *tone).chain(layers).chain(rock) {
                for (kind, sight) in SIGHTS.iter().enumerate() {
                    for (i, colour) in meanings.iter().enumerate() {
                        let apart = difference(lab(*colour, sight), lab(ground.mixed(PLATE, PLATE_COVER), sight));
                        assert!(apart >= 15.0, "{landscape:?}: colour {i} on {ground:?} with sight {kind}: {apart:.1}");
                    }
                }
            }
        }
    }

    /// Width of the pictures, pixels.
    const WIDTH: usize = 200;

    /// The scenery of a level without goals and bodies: CIELAB of each pixel, and what it shows: air, rock, or a material.
    fn scenery(name: &str) -> Vec<([f64; 3], Option<bool>)> {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let level: Level = level::load(&root.join("levels").join(name), root).unwrap().level;
        let terrain = Terrain::new(&level, std::iter::empty(), &[], false);
        let rooms = terrain.rooms().unwrap();
        let canvas = Canvas::new(Frame::of_window(Vec2::new(1280.0, 720.0)));
        let window = CanvasWindow { size: canvas.size().as_dvec2(), pixel: 1.0 };
        let view = Viewport::of(&Aabb::new(rooms.min - 0.8, rooms.max + 0.8), level.size, window);
        let pictures = Pictures::new(&level, &|_| None);
        world::draw_ground(&level, &terrain, &pictures, (&view, &canvas), 3.0);
        terrain.draw_shade(&view, &canvas);
        terrain.draw(&view, &canvas, &[]);
        let sheet = art::sheet();
        let Painting { bytes, .. } = raster::paint(&canvas, WIDTH, Colour::hex(0), &sheet);
        let air = terrain.air(&view);
        let materials: Vec<Area> =
            level.world.iter().filter(|solid| kind(solid.material.name) != 0).map(|solid| view.rect(&solid.bounds)).collect();
        let pixel = |(i, part): (usize, &[u8])| {
            let at = (Vec2::new((i % WIDTH) as f32, (i / WIDTH) as f32) + 0.5) * (canvas.size().x / WIDTH as f32);
            let in_one = |areas: &[Area]| areas.iter().any(|area| area.contains(at));
            let shows = if in_one(&materials) { None } else { Some(in_one(&air)) };
            (lab(Colour::of([part[0], part[1], part[2]]), &SIGHTS[0]), shows)
        };
        bytes.chunks(4).enumerate().map(pixel).collect()
    }

    /// The mean and the 95th percentile.
    fn spread(values: impl Iterator<Item = f64>) -> (f64, f64) {
        let mut values: Vec<f64> = values.collect();
        values.sort_by(f64::total_cmp);
        (values.iter().sum::<f64>() / values.len() as f64, values[values.len() * 95 / 100])
    }

    /// What moves is lighter than CIE L* 67 and more vivid than a chroma of 50: scenery keeps well below both.
    #[test]
    fn scenery_is_dark_and_calm_and_two_worlds_are_told_apart_at_a_glance() {
        let worlds = ["3", "7", "18", "22", "25"].map(|name| (name, scenery(name)));
        for (name, pixels) in &worlds {
            let of = |air: bool| pixels.iter().filter(move |(_, shows)| *shows == Some(air)).map(|(lab, _)| *lab);
            let all = || of(true).chain(of(false));
            let (mean, high) = spread(all().map(|lab| lab[0]));
            let bright = all().filter(|lab| lab[0] > 60.0).count() as f64 / all().count() as f64;
            assert!(
                (9.0..30.0).contains(&mean) && high <= 52.0 && bright <= 0.03,
                "level {name}: L* {mean:.1}, {high:.1}, {bright:.3}"
            );
            let (mean, high) = spread(of(false).map(|lab| lab[0]));
            assert!((7.0..19.0).contains(&mean) && high <= 42.0, "rock of level {name}: L* {mean:.1}, {high:.1}");
            let (mean, high) = spread(of(true).map(|lab| lab[1].hypot(lab[2])));
            assert!((6.0..30.0).contains(&mean) && high <= 46.0, "air of level {name}: chroma {mean:.1}, {high:.1}");
        }
        for (i, (a, one)) in worlds.iter().enumerate() {
            for (b, other) in &worlds[i + 1..] {
                let apart = one.iter().zip(other).map(|(p, q)| difference(p.0, q.0)).sum::<f64>() / one.len() as f64;
                assert!(apart >= 11.0, "levels {a} and {b} differ by {apart:.1}");
            }
        }
    }
}
