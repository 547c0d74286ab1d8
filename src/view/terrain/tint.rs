//! The ink of a level: its rock and its paper share one tint, by which a player knows the level again.

use crate::draw::Colour;
use crate::number::hash;
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
    /// Hatching and dimension lines.
    pub ink: Colour,
    /// Line of the paper every metre.
    pub fine: Colour,
    /// Line of the paper every ten metres.
    pub heavy: Colour,
}

impl Tint {
    /// By a level's name: numbered levels take the inks in turn, others a hash of the name.
    pub fn of(name: &str) -> Self {
        let number: usize = name.parse().unwrap_or_else(|_| hash(name) as usize);
        Self::from_ink(INKS[number.wrapping_sub(1) % INKS.len()])
    }

    fn from_ink(ink: Colour) -> Self {
        Self {
            rock: theme::ground().mixed(ink, 0.17),
            map: theme::ground().mixed(ink, 0.64),
            edge: ink.mixed(Colour::WHITE, 0.12),
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
        let first: Vec<Tint> = (1..=INKS.len()).map(|i| Tint::of(&i.to_string())).collect();
        for (i, tint) in first.iter().enumerate() {
            assert!(!first[..i].contains(tint), "level {} looks like one before it", i + 1);
        }
        assert_eq!(Tint::of("9"), Tint::of("1"));
        assert_eq!(Tint::of("my-level"), Tint::of("my-level"));
        assert_eq!(Tint::of("0").rock.a, 1.0);
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
        for ink in INKS {
            let tint = Tint::from_ink(ink);
            assert!(contrast(theme::text(), tint.rock) > 7.0);
            assert!(contrast(tint.map, theme::ground()) > 3.0, "a card");
            assert!(contrast(tint.edge, theme::ground()) > 4.5 && contrast(tint.edge, tint.rock) > 3.0);
        }
    }
}
