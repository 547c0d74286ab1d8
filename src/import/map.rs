//! The layers of a map, one after the other, as rows of a level's tables.

use super::SourceFile;
use super::tiled::{self, Properties, class, flag, list, number, properties, text};
use crate::level::schema::{Kind, SETTINGS, Table};
use crate::{files, level::BACKGROUND, physics::DVec2};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// Of a tile's global number; the bits above say how it is turned.
pub const NUMBER: u32 = 0x0fff_ffff;
/// A group of layers within more groups than this is refused.
const DEEPEST: usize = 32;
const SOLID: &str = "solid";

pub type CellTexts = BTreeMap<String, String>;

pub struct LevelRow {
    pub kind: Kind,
    pub cells: CellTexts,
    /// The file, layer and object.
    pub origin: String,
}

/// A tile of a set.
pub struct MapTile {
    pub class: String,
    pub properties: Properties,
    /// Its own picture, with its size in pixels.
    pub picture: Option<(PathBuf, DVec2)>,
}

#[derive(Default)]
pub struct Reader {
    pub path: PathBuf,
    shown: String,
    pub rows: Vec<LevelRow>,
    pub pictures: BTreeMap<String, Vec<u8>>,
    pub problems: Vec<String>,
    pub left: Vec<String>,
    pub sources: Vec<SourceFile>,
    copied: BTreeMap<PathBuf, String>,
    pub tiles: BTreeMap<u32, MapTile>,
    /// Of the map's grid, pixels.
    tile: DVec2,
}

/// A layer's place in the tree of layers.
pub struct Within<'a> {
    pub layer: &'a Value,
    pub origin: String,
    pub offset: DVec2,
}

impl Reader {
    pub fn new(path: &Path) -> Self {
        Self { path: path.to_owned(), shown: path.display().to_string(), ..Self::default() }
    }

    pub fn read(&mut self) {
        let Some(map) = self.open(&self.path.clone(), &self.shown.clone()) else { return };
        let side = |name| number(&map, name).unwrap_or(0.0);
        self.tile = DVec2::new(side("tilewidth"), side("tileheight"));
        if text(&map, "orientation") != "orthogonal" {
            let found = format!("found {:?}, expected an orthogonal map", text(&map, "orientation"));
            return self.refuse(&self.shown.clone(), &found);
        }
        if flag(&map, "infinite", false) {
            return self.refuse(&self.shown.clone(), "found an infinite map, expected one with a size");
        }
        let size = DVec2::new(side("width"), side("height")) * self.tile;
        for set in list(&map, "tilesets") {
            self.tileset(set);
        }
        self.settings(&map, size);
        self.layers(&map, &self.shown.clone(), DVec2::ZERO, 0);
        if self.problems.is_empty() && self.rows.iter().all(|row| row.kind.table() == Table::Constants) {
            let expected =
                "expected objects whose class is a table, such as player or objectives, or tiles with the property solid";
            self.refuse(&self.shown.clone(), &format!("found nothing of a level, {expected}"));
        }
    }

    pub fn refuse(&mut self, place: &str, problem: &str) {
        self.problems.push(format!("{place}: {problem}"));
    }

    /// A file of Tiled's, which a place of the map names.
    pub fn open(&mut self, path: &Path, place: &str) -> Option<Value> {
        self.sources.push(SourceFile::now(path));
        let shown = path.display();
        let place = if place == self.shown { String::new() } else { format!("{place}: ") };
        let read = files::read_text(path, files::INPUTS).map_err(|error| error.to_string());
        let parsed = read.and_then(|text| tiled::parse(&text).map_err(|error| format!("found no map ({error})")));
        parsed.map_err(|error| self.problems.push(format!("{place}{shown}: {error}"))).ok()
    }

    /// Beside the file that names it.
    pub fn beside(&self, base: &Path, name: &str) -> PathBuf {
        base.parent().unwrap_or(&self.path).join(name.replace('\\', "/"))
    }

    fn tileset(&mut self, set: &Value) {
        let first = number(set, "firstgid").unwrap_or(1.0) as u32;
        let source = text(set, "source");
        let path = self.beside(&self.path, source);
        let own = if source.is_empty() { None } else { self.open(&path, &format!("{}: tileset", self.shown)) };
        let (set, base) = own.as_ref().map_or((set, self.path.clone()), |own| (own, path));
        for tile in list(set, "tiles") {
            let side = |name| number(tile, name).unwrap_or(0.0);
            let image = text(tile, "image");
            let size = DVec2::new(side("imagewidth"), side("imageheight"));
            let picture = (!image.is_empty()).then(|| (self.beside(&base, image), size));
            let tiles = MapTile { class: class(tile).to_owned(), properties: properties(tile), picture };
            self.tiles.insert(first.saturating_add(side("id") as u32), tiles);
        }
    }

    fn settings(&mut self, map: &Value, size: DVec2) {
        let mut all: CellTexts = properties(map).into_iter().map(|(name, (value, _))| (name, value)).collect();
        for (name, side) in [("width", size.x), ("height", size.y)] {
            all.entry(name.to_owned()).or_insert_with(|| side.to_string());
        }
        for (name, value) in all {
            let origin = format!("{}: property {name:?}", self.shown);
            if let Some(setting) = SETTINGS.iter().find(|setting| setting.name.eq_ignore_ascii_case(&name)) {
                let cells =
                    [("name", setting.name), ("value", value.as_str())].map(|(column, cell)| (column.to_owned(), cell.to_owned()));
                self.rows.push(LevelRow { kind: Kind::Setting, cells: cells.into(), origin });
            } else {
                let names: Vec<&str> = SETTINGS.iter().map(|setting| setting.name).collect();
                self.refuse(&origin, &format!("found no setting of a level, expected one of {}", names.join(", ")));
            }
        }
    }

    fn layers(&mut self, of: &Value, place: &str, offset: DVec2, depth: usize) {
        for layer in list(of, "layers") {
            let origin = format!("{place}: layer {:?}", text(layer, "name"));
            if !flag(layer, "visible", true) {
                self.left.push(format!("{origin}: left out, as it is hidden"));
                continue;
            }
            let by = |name| number(layer, name).unwrap_or(0.0);
            let within = Within { layer, origin, offset: offset + DVec2::new(by("offsetx"), by("offsety")) };
            match text(layer, "type") {
                "group" if depth < DEEPEST => self.layers(layer, &within.origin, within.offset, depth + 1),
                "group" => self.refuse(&within.origin, &format!("found groups in groups, expected at most {DEEPEST}")),
                "tilelayer" => self.tile_layer(&within),
                "imagelayer" => self.image_layer(&within),
                _ => self.objects(&within),
            }
        }
    }

    fn image_layer(&mut self, Within { layer, origin, offset }: &Within) {
        let path = self.beside(&self.path, text(layer, "image"));
        if text(layer, "image").is_empty() {
            return self.left.push(format!("{origin}: left out, as it has no picture"));
        }
        if text(layer, "name").eq_ignore_ascii_case("background") {
            self.copied.insert(path.clone(), BACKGROUND.to_owned());
        }
        let Some(image) = self.picture(&path, origin) else { return };
        if image != BACKGROUND {
            let place = [("x", offset.x), ("y", offset.y)].map(|(column, value)| (column.to_owned(), value.to_string()));
            let mut cells: CellTexts = place.into_iter().chain([("image".to_owned(), image)]).collect();
            self.fill(&mut cells, Kind::Picture.schema(), &properties(layer), origin);
            self.rows.push(LevelRow { kind: Kind::Picture, cells, origin: origin.clone() });
        }
    }

    /// The name under which a picture lies in the level's folder.
    pub fn picture(&mut self, path: &Path, origin: &str) -> Option<String> {
        if let Some(known) = self.copied.get(path).filter(|known| self.pictures.contains_key(*known)) {
            return Some(known.clone());
        }
        let own = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let (stem, ending) = own.rsplit_once('.').unwrap_or((&own, ""));
        if !ending.eq_ignore_ascii_case("png") {
            self.refuse(origin, &format!("found the picture {own:?}, expected a PNG image"));
            return None;
        }
        let names = (1..).map(|n: u32| if n == 1 { format!("{stem}.png") } else { format!("{stem}-{n}.png") });
        let taken = |name: &String| name != BACKGROUND && !self.pictures.contains_key(name);
        let name = self.copied.get(path).cloned().or_else(|| names.into_iter().find(taken))?;
        self.sources.push(SourceFile::now(path));
        match files::read(path, files::PICTURE) {
            Ok(bytes) => _ = self.pictures.insert(name.clone(), bytes),
            Err(error) => self.refuse(origin, &format!("the picture {}: {error}", path.display())),
        }
        self.copied.insert(path.to_owned(), name.clone());
        Some(name)
    }

    /// Tiles of one table and of the same cells, merged.
    fn tile_layer(&mut self, within: &Within) {
        let mut own = properties(within.layer);
        let solid = own.remove(SOLID).is_some_and(|(value, _)| value == "true");
        let all = table(text(within.layer, "class")).or(solid.then_some(Table::World));
        let mut areas: BTreeMap<(Kind, CellTexts), BTreeSet<(i64, i64)>> = BTreeMap::new();
        let gids = match tiled::tiles(within.layer) {
            Ok(gids) => gids,
            Err(problem) => return self.refuse(&within.origin, &problem),
        };
        let across = number(within.layer, "width").unwrap_or(1.0) as i64;
        for (at, gid) in (0..).zip(gids).filter(|(_, gid)| gid & NUMBER != 0) {
            let tile = self.tiles.get(&(gid & NUMBER));
            let of_tile = tile.and_then(|tile| {
                let solid = tile.properties.get(SOLID).is_some_and(|(value, _)| value == "true");
                table(&tile.class).or(solid.then_some(Table::World))
            });
            let Some(kind) = of_tile.or(all).and_then(|table| table.kinds().first().copied()) else { continue };
            let column = |name: &str| kind.schema().columns.iter().any(|column| column.name == name);
            let given = tile.into_iter().flat_map(|tile| &tile.properties).filter(|(name, _)| column(name));
            let cells = given.map(|(name, (value, _))| (name.clone(), value.clone())).collect();
            areas.entry((kind, cells)).or_default().insert((at % across, at / across));
        }
        if areas.is_empty() {
            self.left.push(format!("{}: left out, as neither it nor its tiles have the property solid", within.origin));
        }
        for ((kind, of_tile), cells) in areas {
            let mut usual = CellTexts::new();
            self.fill(&mut usual, kind.schema(), &own, &within.origin);
            for [left, top, width, height] in merged(cells) {
                let corner = within.offset + DVec2::new(left as f64, top as f64) * self.tile;
                let size = DVec2::new(width as f64, height as f64) * self.tile;
                let place = [("x", corner.x), ("y", corner.y), ("width", size.x), ("height", size.y)];
                let place = place.map(|(column, value)| (column.to_owned(), value.to_string()));
                let row = usual.clone().into_iter().chain(of_tile.clone()).chain(place).collect();
                let origin = format!("{}: tiles from {left},{top}", within.origin);
                self.rows.push(LevelRow { kind, cells: row, origin });
            }
        }
    }
}

pub fn stem(table: Table) -> &'static str {
    table.file().trim_end_matches(".csv")
}

/// The table that a class means.
pub fn table(word: &str) -> Option<Table> {
    let word = word.trim().trim_end_matches(".csv");
    Table::ALL.iter().copied().find(|table| *table != Table::Constants && stem(*table).eq_ignore_ascii_case(word))
}

/// Few rectangles, each left, top, width and height, that cover just these cells: rows of neighbours, of which equal ones below each other are one.
fn merged(cells: BTreeSet<(i64, i64)>) -> Vec<[i64; 4]> {
    let mut by_row: Vec<(i64, i64)> = cells.into_iter().map(|(x, y)| (y, x)).collect();
    by_row.sort_unstable();
    let mut runs: Vec<[i64; 4]> = Vec::new();
    for (y, x) in by_row {
        match runs.last_mut() {
            Some([left, top, width, _]) if *top == y && *left + *width == x => *width += 1,
            _ => runs.push([x, y, 1, 1]),
        }
    }
    let mut open: BTreeMap<(i64, i64), [i64; 4]> = BTreeMap::new();
    let mut done = Vec::new();
    for [left, top, width, height] in runs {
        match open.get_mut(&(left, width)) {
            Some(above) if above[1] + above[3] == top => above[3] += 1,
            _ => done.extend(open.insert((left, width), [left, top, width, height])),
        }
    }
    done.extend(open.into_values());
    done.sort_unstable_by_key(|[left, top, ..]| (*top, *left));
    done
}
