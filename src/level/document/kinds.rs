//! What a level is made of, as an author adds and edits it: the tables, the kinds of rows in them, what a new row holds, and the unit of
//! each column. Which columns there are is the loader's own list.

use crate::level::table::{Column, Layout};
use crate::level::{blocks, extras, rows};

macro_rules! tables {
    ($($name:ident $layout:expr),* $(,)?) => {
        /// A CSV file of a level.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[allow(missing_docs)] // Named like the files.
        pub enum Table { $($name),* }

        impl Table {
            /// All of them, in the order in which problems are listed.
            pub const ALL: &[Self] = &[$(Self::$name),*];

            pub(super) const fn layout(self) -> Layout {
                match self { $(Self::$name => $layout),* }
            }
        }
    };
}
tables! {
    Constants rows::CONSTANTS, Player rows::PLAYER, World blocks::WORLD, Objects rows::OBJECTS, Objectives rows::BLOCKS,
    Obstacles rows::OBSTACLES, Hazards rows::HAZARDS, Movers blocks::MOVERS, Doors blocks::DOORS, Switches blocks::SWITCHES,
    Gravity extras::GRAVITY, Pods extras::PODS, Decoration extras::DECORATION, Fluids rows::FLUIDS, Texts rows::TEXTS,
}

impl Table {
    /// The file's name.
    pub const fn file(self) -> &'static str {
        self.layout().file
    }

    /// The table of that file.
    pub fn of_file(file: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|table| table.file() == file)
    }

    pub(super) const fn index(self) -> usize {
        self as usize
    }
}

/// A kind of thing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// A setting of the level: it has no place.
    Setting,
    /// The ship.
    Ship,
    /// A solid block.
    Solid,
    /// A block that moves.
    Mover,
    /// A block that a switch opens.
    Door,
    /// What works others.
    Switch,
    /// What moves freely.
    Object,
    /// A key object.
    Key,
    /// Where the ship has to be.
    Pad,
    /// Where a key object has to be.
    KeyPad,
    /// A death box.
    Deadly,
    /// An air stream.
    Stream,
    /// A liquid.
    Fluid,
    /// A zone of gravity.
    Gravity,
    /// Fuel.
    Pod,
    /// A picture that nothing touches.
    Picture,
    /// Words.
    Text,
}

impl Kind {
    /// Those that can be added, in the order in which they are offered.
    pub const ADDED: [Self; 15] = [
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
        Self::Text,
        Self::Picture,
    ];

    /// What it is called.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Setting => "Setting",
            Self::Ship => "Ship",
            Self::Solid => "Block",
            Self::Mover => "Mover",
            Self::Door => "Door",
            Self::Switch => "Switch",
            Self::Object => "Object",
            Self::Key => "Key object",
            Self::Pad => "Ship's pad",
            Self::KeyPad => "Key's pad",
            Self::Deadly => "Death box",
            Self::Stream => "Air stream",
            Self::Fluid => "Liquid",
            Self::Gravity => "Gravity zone",
            Self::Pod => "Fuel pod",
            Self::Picture => "Picture",
            Self::Text => "Words",
        }
    }

    /// The file that its rows are in.
    pub const fn table(self) -> Table {
        match self {
            Self::Setting => Table::Constants,
            Self::Ship => Table::Player,
            Self::Solid => Table::World,
            Self::Mover => Table::Movers,
            Self::Door => Table::Doors,
            Self::Switch => Table::Switches,
            Self::Object => Table::Objects,
            Self::Key | Self::Pad | Self::KeyPad => Table::Objectives,
            Self::Deadly => Table::Obstacles,
            Self::Stream => Table::Hazards,
            Self::Fluid => Table::Fluids,
            Self::Gravity => Table::Gravity,
            Self::Pod => Table::Pods,
            Self::Picture => Table::Decoration,
            Self::Text => Table::Texts,
        }
    }

    /// The kind of a row by its table and first cell; `None` where that is none.
    pub(super) fn of(table: Table, first: &str) -> Option<Self> {
        match table {
            Table::Constants => Some(Self::Setting),
            Table::Player => Some(Self::Ship),
            Table::World => Some(Self::Solid),
            Table::Movers => Some(Self::Mover),
            Table::Doors => Some(Self::Door),
            Table::Switches => Some(Self::Switch),
            Table::Objects => Some(Self::Object),
            Table::Obstacles => Some(Self::Deadly),
            Table::Hazards => Some(Self::Stream),
            Table::Fluids => Some(Self::Fluid),
            Table::Gravity => Some(Self::Gravity),
            Table::Pods => Some(Self::Pod),
            Table::Decoration => Some(Self::Picture),
            Table::Texts => Some(Self::Text),
            Table::Objectives => match first.to_ascii_uppercase().as_str() {
                "PLAYER" => Some(Self::Pad),
                "PHYS" => Some(Self::KeyPad),
                "OBJECT" => Some(Self::Key),
                _ => None,
            },
        }
    }

    pub(super) const fn layout(self) -> Layout {
        match self {
            Self::Key => rows::KEY_OBJECTS,
            _ => self.table().layout(),
        }
    }

    pub(super) fn columns(self) -> Vec<Column> {
        self.layout().columns().collect()
    }

    /// The names of its columns, in the documented order, and whether each has to be filled.
    pub fn column_names(self) -> Vec<(&'static str, bool)> {
        self.layout().columns().map(|column| (column.name, column.required)).collect()
    }

    /// Whether its x and y are those of its centre.
    pub const fn by_centre(self) -> bool {
        matches!(self, Self::Ship | Self::Object | Self::Key)
    }

    /// What a new one holds besides its place and size.
    pub(super) const fn fresh(self) -> &'static [(&'static str, &'static str)] {
        match self {
            Self::Setting | Self::Ship | Self::Solid | Self::Deadly => &[],
            Self::Mover => &[("speed", "2"), ("wait", "1"), ("ease", "0.5")],
            Self::Door => &[],
            Self::Switch => &[("by", "ship"), ("stays", "held")],
            Self::Object => &[("mass", "50"), ("drag", "1.05"), ("circular", "FALSE"), ("restitution", "0.2")],
            Self::Key => &[
                ("kind", "OBJECT"),
                ("mass", "50"),
                ("r", "240"),
                ("g", "170"),
                ("b", "40"),
                ("restitution", "0.2"),
                ("drag", "1.05"),
            ],
            Self::Pad => &[("kind", "PLAYER"), ("hold", "1")],
            Self::KeyPad => &[("kind", "PHYS")],
            Self::Stream => &[("stream_width", "0"), ("force_x", "0"), ("force_y", "-600")],
            Self::Fluid => &[("density", "900"), ("viscosity", "20")],
            Self::Gravity => &[("field_x", "0"), ("field_y", "-20")],
            Self::Pod => &[("fuel", "100")],
            Self::Picture => &[("layer", "behind")],
            Self::Text => &[("text", "Words")],
        }
    }

    /// Width and height of a new one that is not drawn but put down, pixels.
    pub const fn usual_size(self) -> (f64, f64) {
        match self {
            Self::Solid => (160.0, 40.0),
            Self::Mover => (120.0, 20.0),
            Self::Door => (20.0, 120.0),
            Self::Switch => (60.0, 60.0),
            Self::Object | Self::Key => (40.0, 40.0),
            Self::Pad | Self::KeyPad => (120.0, 10.0),
            Self::Deadly => (120.0, 20.0),
            Self::Stream => (80.0, 20.0),
            Self::Fluid | Self::Gravity => (200.0, 120.0),
            Self::Pod => (30.0, 40.0),
            Self::Text => (200.0, 24.0),
            Self::Setting | Self::Ship | Self::Picture => (51.0, 51.0),
        }
    }
}

/// The unit of a column; empty where it has none.
pub fn unit(column: &str) -> &'static str {
    match column {
        "x" | "y" | "width" | "height" | "size" | "stream_width" | "stream_height" | "way_points" => "px",
        "mass" => "kg",
        "thrust" | "force_x" | "force_y" | "weight" => "N",
        "fuel" => "units",
        "vx" | "vy" | "speed" | "belt" | "rest_speed" | "mark_speed" => "m/s",
        "angle" => "°",
        "hold" | "period" | "wait" | "ease" | "optimal_time" | "silver" | "gold" => "s",
        "breaks" => "N·s",
        "field_x" | "field_y" | "gravity" | "gravity_x" => "N/kg",
        "density" | "air_density" => "kg/m³",
        "viscosity" => "Pa·s",
        "restitution" | "experiment" => "0–1",
        "r" | "g" | "b" => "0–255",
        "metre" => "px/m",
        "mark_fuel" => "%",
        _ => "",
    }
}

/// The words that a column may hold, the usual one first; none where it is free.
pub fn choices(column: &str) -> &'static [&'static str] {
    match column {
        "material" => &["Asphalt", "Steel", "Ice", "Rubber", "Wood", "Glass", "Trampoline"],
        "air" => &["TRUE", "FALSE"],
        "circular" | "shaded" | "weightless" => &["FALSE", "TRUE"],
        "one_way" => &["", "top", "bottom", "left", "right"],
        "route" => &["back", "round", "once"],
        "by" => &["any", "ship", "key", "object"],
        "stays" => &["held", "latched", "toggled"],
        "layer" => &["behind", "front"],
        _ => &[],
    }
}

/// The settings that constants.csv can hold, with what holds where it says nothing.
pub const SETTINGS: [(&str, &str); 17] = [
    ("title", "the name"),
    ("width", ""),
    ("height", ""),
    ("gravity", "15"),
    ("gravity_x", "0"),
    ("air_density", "1.2041"),
    ("optimal_time", "60"),
    ("metre", "30"),
    ("rest_speed", "0"),
    ("friction", "1"),
    ("experiment", "0"),
    ("silver", ""),
    ("gold", ""),
    ("mark_hits", ""),
    ("mark_fuel", ""),
    ("mark_pushes", ""),
    ("mark_speed", ""),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::level::constants;
    use crate::physics::Material;

    #[test]
    fn what_is_offered_is_what_the_loader_knows() {
        let known: Vec<&str> = constants::names().collect();
        assert!(SETTINGS.iter().all(|(name, _)| known.contains(name)) && known.len() == SETTINGS.len());
        assert!(choices("material").iter().all(|name| Material::named(name).is_some()));
        assert_eq!(choices("material").len(), Material::ALL.len());
        for kind in Kind::ADDED {
            let columns = kind.column_names();
            assert!(kind.fresh().iter().all(|(name, _)| columns.iter().any(|(column, _)| column == name)), "{kind:?}");
            let first = kind.fresh().first().map_or("", |(_, text)| text);
            assert_eq!(Kind::of(kind.table(), first), Some(kind));
        }
    }
}
