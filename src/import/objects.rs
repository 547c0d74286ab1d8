//! The objects of a map as rows.

use super::map::{CellTexts, LevelRow, NUMBER, Reader, Within, stem, table};
use super::tiled::{Properties, class, flag, list, number, properties, text};
use crate::level::schema::{Column, Kind, RowSchema, Table};
use crate::physics::DVec2;
use serde_json::Value;

impl Reader {
    pub fn objects(&mut self, within: &Within) {
        let table = table(text(within.layer, "class"));
        let mut without = 0;
        for object in list(within.layer, "objects").iter().filter(|object| flag(object, "visible", true)) {
            let name = text(object, "name").to_owned();
            let name = if name.is_empty() { String::new() } else { format!(" {name:?}") };
            let origin = format!("{}: object {}{name}", within.origin, number(object, "id").unwrap_or(0.0));
            if object.get("template").is_some() {
                self.refuse(&origin, "found a template, expected an object of its own, which Detach makes");
                continue;
            }
            let gid = number(object, "gid").unwrap_or(0.0) as u32;
            let of_tile = self.tiles.get(&(gid & NUMBER)).map(|tile| tile.class.clone()).unwrap_or_default();
            let word = Some(class(object)).filter(|class| !class.is_empty()).unwrap_or(&of_tile).to_owned();
            match (super::map::table(&word), table) {
                (Some(table), _) => self.object(table, object, gid, within, &origin),
                (None, Some(table)) if word.is_empty() => self.object(table, object, gid, within, &origin),
                (None, _) if word.is_empty() => without += 1,
                (None, _) => {
                    let tables: Vec<&str> = Table::ALL.iter().skip(1).map(|table| stem(*table)).collect();
                    self.refuse(&origin, &format!("found the class {word:?}, expected one of {}", tables.join(", ")));
                }
            }
        }
        if without > 0 {
            self.left.push(format!("{}: {without} objects left out, as neither they nor the layer name a table", within.origin));
        }
    }

    fn object(&mut self, table: Table, object: &Value, gid: u32, within: &Within, origin: &str) {
        let tile = self.tiles.get(&(gid & NUMBER));
        let (of_tile, picture) = tile.map_or_else(Default::default, |tile| (tile.properties.clone(), tile.picture.clone()));
        let mut own = properties(object);
        let several = table.kinds().len() > 1;
        let kind = match several.then(|| own.remove("kind")).flatten() {
            Some((word, _)) => table.kinds().iter().find(|kind| kind.schema().tag.eq_ignore_ascii_case(&word)),
            None => table.kinds().first(),
        };
        let Some(kind) = kind.copied() else {
            let tags: Vec<&str> = table.kinds().iter().map(|kind| kind.schema().tag).collect();
            return self.refuse(origin, &format!("found another kind, expected one of {}", tags.join(", ")));
        };
        let by = |name| number(object, name).unwrap_or(0.0);
        if by("rotation") != 0.0 {
            return self.refuse(origin, &format!("found a rotation of {}°, expected none", by("rotation")));
        }
        let size = DVec2::new(by("width"), by("height"));
        // A tile stands on its place.
        let at = within.offset + DVec2::new(by("x"), by("y")) - if gid == 0 { DVec2::ZERO } else { DVec2::new(0.0, size.y) };
        let schema = kind.schema();
        let mut cells = CellTexts::new();
        let has = |column: &str| schema.columns.iter().any(|own| own.name == column);
        if !schema.tag.is_empty() {
            cells.insert("kind".to_owned(), schema.tag.to_owned());
        }
        let place = if kind.by_centre() { at + size * 0.5 } else { at };
        for (column, value) in [("x", place.x), ("y", place.y), ("width", size.x), ("height", size.y)] {
            if has(column) {
                cells.insert(column.to_owned(), value.to_string());
            }
        }
        self.shape((object, at, size), kind, &mut cells);
        let name = text(object, "name");
        if has("name") && !name.is_empty() {
            cells.insert("name".to_owned(), name.to_owned());
        }
        if has("image") && !own.contains_key("image") {
            if gid == 0 {
                let shape = if object.get("ellipse").is_some() { "ball" } else { "box" };
                cells.insert("image".to_owned(), format!("{shape}:{}x{}", size.x, size.y));
            } else {
                let Some((path, own)) = picture.filter(|_| gid <= NUMBER) else {
                    return self.refuse(origin, "found a tile of a sheet or a turned one, expected a tile with its own picture");
                };
                if own != size {
                    let sizes = format!("{} × {} pixels, expected {} × {}, as the picture has", size.x, size.y, own.x, own.y);
                    return self.refuse(origin, &format!("found a tile of {sizes}"));
                }
                let Some(image) = self.picture(&path, origin) else { return };
                cells.insert("image".to_owned(), image);
            }
        }
        let known = of_tile.into_iter().filter(|(name, _)| has(name) || is_colour(name) && has("r"));
        self.fill(&mut cells, schema, &known.collect(), origin);
        self.fill(&mut cells, schema, &own, origin);
        self.rows.push(LevelRow { kind, cells, origin: origin.to_owned() });
    }

    /// What the shape of an object says beside its place and size: words, the ends of a link, the way of a mover.
    fn shape(&mut self, (object, at, size): (&Value, DVec2, DVec2), kind: Kind, cells: &mut CellTexts) {
        let mut put = |column: &str, value: String| _ = cells.insert(column.to_owned(), value);
        if kind == Kind::Text {
            let words = object.get("text").unwrap_or(&Value::Null);
            let content = Some(text(words, "text")).filter(|text| !text.is_empty()).unwrap_or(text(words, "data"));
            put("text", content.trim().to_owned());
            put("size", number(words, "pixelsize").unwrap_or(if size.y > 0.0 { size.y } else { 16.0 }).to_string());
            if let Some(channels) = channels(text(words, "color")) {
                ["r", "g", "b"].into_iter().zip(channels).for_each(|(column, channel)| put(column, channel.to_string()));
            }
        }
        let points = points(object.get("polyline"));
        if let (Kind::Link, [first, .., last]) = (kind, points.as_slice()) {
            [("a", first), ("b", last)]
                .into_iter()
                .for_each(|(end, point)| put(end, format!("{} {}", at.x + point.x, at.y + point.y)));
        }
    }

    /// The columns that custom properties give.
    pub fn fill(&mut self, cells: &mut CellTexts, schema: &RowSchema, own: &Properties, origin: &str) {
        for (name, (value, of)) in own {
            let column = schema.columns.iter().find(|column| column.name.eq_ignore_ascii_case(name));
            match (column, channels(value).filter(|_| is_colour(name))) {
                (Some(Column { name: "image", .. }), _) if of == "file" || value.to_lowercase().ends_with(".png") => {
                    let path = self.beside(&self.path, value);
                    cells.extend(self.picture(&path, origin).map(|image| ("image".to_owned(), image)));
                }
                (Some(column), _) => _ = cells.insert(column.name.to_owned(), value.clone()),
                (None, Some(channels)) if schema.columns.iter().any(|column| column.name == "r") => {
                    cells.extend(["r", "g", "b"].into_iter().zip(channels).map(|(column, of)| (column.to_owned(), of.to_string())));
                }
                (None, _) => {
                    self.refuse(origin, &format!("found the property {name:?}, expected the columns {}", schema.columns_text()));
                }
            }
        }
    }
}

fn is_colour(name: &str) -> bool {
    ["color", "colour"].iter().any(|word| word.eq_ignore_ascii_case(name))
}

/// Red, green and blue of `#aarrggbb` or `#rrggbb`.
fn channels(colour: &str) -> Option<[u8; 3]> {
    let digits = colour.strip_prefix('#').filter(|digits| matches!(digits.len(), 6 | 8))?;
    let number = u32::from_str_radix(digits, 16).ok()?;
    let [_, r, g, b] = number.to_be_bytes();
    Some([r, g, b])
}

/// `0,0 10,5` of XML, or a list of JSON.
fn points(of: Option<&Value>) -> Vec<DVec2> {
    match of {
        Some(Value::Array(points)) => {
            let point = |point: &Value| Some(DVec2::new(number(point, "x")?, number(point, "y")?));
            points.iter().filter_map(point).collect()
        }
        Some(line) => {
            let point = |pair: &str| {
                let (x, y) = pair.split_once(',')?;
                Some(DVec2::new(x.parse().ok()?, y.parse().ok()?))
            };
            text(line, "points").split_whitespace().filter_map(point).collect()
        }
        None => Vec::new(),
    }
}
