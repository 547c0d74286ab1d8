//! The ink of a level: its rock and its paper share one tint, by which a player knows the level again.

use crate::draw::Colour;
use crate::level::Landscape;
use crate::number::hash;
use crate::physics::DVec2;
use crate::view::sky::WorldPalette;
use crate::view::theme;

/// The inks, pale and calm: none is near a colour with a meaning (objectives, hazards, forces are all far more vivid).
const INKS: [Colour; 8] = [
    Colour::hex(0x8FA8CC),
    Colour::hex(0x86B8B4),
    Colour::hex(0xA9A0CF),
    Colour::hex(0xB9AE94),
    Colour::hex(0x9DB48E),
    Colour::hex(0xC09FA6),
    Colour::hex(0x8DB3C9),
    Colour::hex(0xA8AAB4),
];

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tint {
    pub rock: Colour,
    /// The rock on a map of the level, without edges.
    pub map: Colour,
    /// The rock's edge in the light.
    pub edge: Colour,
    /// The light of the level's world on edges that face it, and the unit vector towards it, y down.
    pub rim: Option<(Colour, DVec2)>,
    /// Hatching and dimension lines.
    pub ink: Colour,
    /// Line of the paper every metre.
    pub fine: Colour,
    /// Line of the paper every ten metres.
    pub heavy: Colour,
}

impl Tint {
    /// Of a level's world; without one by its name: numbered levels take the inks in turn, others a hash of the name.
    pub fn of(landscape: Option<Landscape>, name: &str) -> Self {
        match landscape.map(WorldPalette::of) {
            Some(palette) if !theme::is_plain() => Self::from_world(&palette),
            _ => Self::from_name(name),
        }
    }

    fn from_world(palette: &WorldPalette) -> Self {
        let WorldPalette { sky, ink, rock, rim, light, .. } = *palette;
        Self {
            rock,
            map: sky[1].mixed(ink, 0.69),
            edge: ink.mixed(Colour::WHITE, 0.12),
            rim: Some((rim, light)),
            ink,
            fine: ink.faded(0.05),
            heavy: ink.faded(0.11),
        }
    }

    fn from_name(name: &str) -> Self {
        let number: usize = name.parse().unwrap_or_else(|_| hash(name) as usize);
        Self::from_ink(INKS[number.wrapping_sub(1) % INKS.len()])
    }

    fn from_ink(ink: Colour) -> Self {
        Self {
            rock: theme::ground().mixed(ink, 0.17),
            map: theme::ground().mixed(ink, 0.64),
            edge: ink.mixed(Colour::WHITE, 0.12),
            rim: None,
            ink,
            fine: theme::ground().mixed(ink, 0.065),
            heavy: theme::ground().mixed(ink, 0.14),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbered_levels_take_turns_and_a_name_keeps_its_tint() {
        let first: Vec<Tint> = (1..=INKS.len()).map(|i| Tint::of(None, &i.to_string())).collect();
        for (i, tint) in first.iter().enumerate() {
            assert!(!first[..i].contains(tint), "level {} looks like one before it", i + 1);
        }
        assert_eq!(Tint::of(None, "9"), Tint::of(None, "1"));
        assert_eq!(Tint::of(None, "my-level"), Tint::of(None, "my-level"));
        assert_eq!(Tint::of(None, "0").rock.a, 1.0);
    }

    #[test]
    fn words_on_rock_and_its_edge_against_the_air_are_easy_to_see() {
        // Contrast after WCAG 2: (brighter + 0.05) / (darker + 0.05) of relative luminances; words want 4.5, shapes 3.
        let luminance = |c: Colour| {
            let linear = |v: f32| if v <= 0.04045 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) };
            0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b)
        };
        let contrast = |a: Colour, b: Colour| {
            let (a, b) = (luminance(a), luminance(b));
            (a.max(b) + 0.05) / (a.min(b) + 0.05)
        };
        let plain = INKS.map(|ink| (Tint::from_ink(ink), theme::ground()));
        let worlds = Landscape::ALL.map(WorldPalette::of);
        let worlds = worlds.iter().flat_map(|palette| palette.sky.map(|sky| (Tint::from_world(palette), sky)));
        for (tint, sky) in plain.into_iter().chain(worlds) {
            assert!(contrast(theme::text(), tint.rock) > 7.0);
            assert!(contrast(tint.map, sky) > 3.0, "a card");
            assert!(contrast(tint.edge, sky) > 4.5 && contrast(tint.edge, tint.rock) > 3.0);
        }
    }
}
