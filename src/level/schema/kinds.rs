//! The files of a level and the kinds of their rows, as enums: a list of the schemas.

use super::facts::{Column, FileSchema, RowSchema};
use super::{blocks, bodies, settings, zones};
use crate::level::image::BACKGROUND;

macro_rules! files {
    ($($file:ident $schema:path { $($kind:ident $row:path),* })*) => {
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Table { $($file),* }

        impl Table {
            /// All of them, in the order in which problems are listed.
            pub const ALL: &[Self] = &[$(Self::$file),*];

            pub const fn schema(self) -> &'static FileSchema {
                match self { $(Self::$file => &$schema),* }
            }

            pub const fn kinds(self) -> &'static [Kind] {
                match self { $(Self::$file => &[$(Kind::$kind),*]),* }
            }

            pub(in crate::level) const fn rows(self) -> &'static [&'static RowSchema] {
                match self { $(Self::$file => const { &[$(&$row),*] }),* }
            }
        }

        /// A kind of thing: the ship, a block, a setting of the level.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Kind { $($($kind),*),* }

        impl Kind {
            pub const ALL: &[Self] = &[$($(Self::$kind),*),*];

            pub const fn schema(self) -> &'static RowSchema {
                match self { $($(Self::$kind => &$row),*),* }
            }

            pub const fn table(self) -> Table {
                match self { $($(Self::$kind => Table::$file),*),* }
            }
        }
    };
}
files! {
    Constants settings::CONSTANTS { Setting settings::SETTING }
    Player bodies::PLAYER { Ship bodies::SHIP }
    World blocks::WORLD { Solid blocks::SOLID }
    Objects bodies::OBJECTS { Object bodies::OBJECT }
    Objectives bodies::OBJECTIVES { Pad bodies::PAD, KeyPad bodies::KEY_PAD, Key bodies::KEY }
    Obstacles zones::OBSTACLES { Deadly zones::DEADLY }
    Hazards zones::HAZARDS { Stream zones::STREAM }
    Movers blocks::MOVERS { Mover blocks::MOVER }
    Doors blocks::DOORS { Door blocks::DOOR }
    Switches blocks::SWITCHES { Switch blocks::SWITCH }
    Links blocks::LINKS { Link blocks::LINK }
    Gravity zones::GRAVITY { Gravity zones::GRAVITY_ZONE }
    Pods zones::PODS { Pod zones::POD }
    Stars zones::STARS { Star zones::STAR }
    Decoration zones::DECORATION { Picture zones::PICTURE }
    Fluids zones::FLUIDS { Fluid zones::FLUID }
    Texts zones::TEXTS { Text zones::TEXT }
    Hints zones::HINTS { Hint zones::HINT }
}

/// The names of a level's files, in the order in which problems are listed; the picture behind the level stands before the liquids.
pub const FILES: [&str; Table::ALL.len() + 1] = {
    let mut names = [BACKGROUND; Table::ALL.len() + 1];
    let mut index = 0;
    while index < Table::ALL.len() {
        names[index + (index >= Table::Fluids.index()) as usize] = Table::ALL[index].file();
        index += 1;
    }
    names
};

impl Table {
    pub const fn file(self) -> &'static str {
        self.schema().name
    }

    pub fn of_file(file: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|table| table.file() == file)
    }

    pub(in crate::level) fn has(self, is: fn(&Column) -> bool) -> bool {
        self.rows().iter().any(|row| row.columns.iter().any(is))
    }

    pub(in crate::level) const fn index(self) -> usize {
        self as usize
    }
}

impl Kind {
    /// The kinds that can be drawn as boxes, in the order in which the editor offers them.
    pub const ADDED: [Self; 16] = [
        Self::Solid,
        Self::Mover,
        Self::Door,
        Self::Switch,
        Self::Pad,
        Self::KeyPad,
        Self::Key,
        Self::Object,
        Self::Deadly,
        Self::Stream,
        Self::Fluid,
        Self::Gravity,
        Self::Pod,
        Self::Star,
        Self::Text,
        Self::Picture,
    ];

    pub const fn name(self) -> &'static str {
        self.schema().name
    }

    pub(in crate::level) fn of(table: Table, first: &str) -> Option<Self> {
        let is = |kind: &&Self| kind.schema().tag.is_empty() || kind.schema().tag.eq_ignore_ascii_case(first);
        table.kinds().iter().find(is).copied()
    }

    /// Whether its x and y are those of its centre.
    pub const fn by_centre(self) -> bool {
        self.schema().by_centre
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::level::numbers::PixelScale;

    #[test]
    fn every_kind_is_offered_and_a_new_one_fills_columns_that_it_has() {
        let not_added = [Kind::Setting, Kind::Ship, Kind::Hint, Kind::Link];
        assert!(Kind::ALL.iter().all(|kind| Kind::ADDED.contains(kind) != not_added.contains(kind)));
        for kind in Kind::ADDED {
            let RowSchema { columns, fresh, .. } = kind.schema();
            assert!(fresh.iter().all(|(name, _)| columns.iter().any(|column| column.name == *name)), "{kind:?}");
            let first = fresh.first().map_or("", |(_, text)| text);
            assert_eq!(Kind::of(kind.table(), first), Some(kind));
            let usual = columns.iter().filter(|column| !column.choices().is_empty() && !column.required);
            usual.for_each(|column| assert_eq!(column.choices()[0], column.usual, "{kind:?} {}", column.name));
        }
        let metre = settings::SETTINGS.iter().find(|setting| setting.name == "metre").map(|setting| setting.usual);
        assert_eq!(metre, Some(PixelScale::USUAL.metre.to_string().as_str()));
    }
}
