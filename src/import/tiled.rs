//! Files of the map editor Tiled as JSON values in the form of its own JSON format (doc.mapeditor.org, "JSON Map Format"): `.tmj` as it is,
//! `.tmx`, `.tsx` and `.tx` by the names that both formats share. Numbers of XML stay texts, which [`number`] reads as well.

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use flate2::read::{GzDecoder, ZlibDecoder};
use roxmltree::{Document, Node};
use serde_json::{Map, Value};
use std::{collections::BTreeMap, io::Read};

/// The most tiles of a layer.
const MOST_TILES: u64 = 4 << 20;

/// Errors: in words, with the line where there is one.
pub fn parse(text: &str) -> Result<Value, String> {
    if text.trim_start().starts_with('<') {
        let document = Document::parse(text).map_err(|error| error.to_string())?;
        return Ok(element(document.root_element()));
    }
    serde_json::from_str(text).map_err(|error| error.to_string())
}

/// Where the children of an element go in JSON, as a list; others are one value by their own name.
fn listed(name: &str) -> Option<&'static str> {
    match name {
        "layer" | "objectgroup" | "imagelayer" | "group" => Some("layers"),
        "tileset" => Some("tilesets"),
        "object" => Some("objects"),
        "tile" => Some("tiles"),
        _ => None,
    }
}

fn element(node: Node) -> Value {
    let mut map = Map::new();
    let texts = |node: &Node| node.descendants().filter_map(|inner| inner.text().filter(|_| inner.is_text())).collect::<String>();
    for attribute in node.attributes() {
        map.insert(attribute.name().to_owned(), attribute.value().into());
    }
    match node.tag_name().name() {
        "layer" => _ = map.insert("type".to_owned(), "tilelayer".into()),
        name @ ("objectgroup" | "imagelayer" | "group") => _ = map.insert("type".to_owned(), name.into()),
        "data" if node.children().any(|tile| tile.has_tag_name("tile")) => {
            let tiles = node.children().filter(|tile| tile.has_tag_name("tile"));
            let gids = tiles.map(|tile| Value::from(tile.attribute("gid").and_then(|gid| gid.parse::<u32>().ok()).unwrap_or(0)));
            map.insert("data".to_owned(), gids.collect());
            return map.into();
        }
        "data" | "text" => _ = map.insert("data".to_owned(), texts(&node).into()),
        _ => {}
    }
    for child in node.children().filter(Node::is_element) {
        let name = child.tag_name().name();
        match (name, listed(name)) {
            ("properties", _) => {
                let property = |property: Node| {
                    let mut of = element(property);
                    of.as_object_mut()?.entry("value").or_insert_with(|| texts(&property).into());
                    Some(of)
                };
                let all = child.children().filter(|node| node.has_tag_name("property")).filter_map(property);
                map.insert(name.to_owned(), all.collect());
            }
            // A layer's data stand beside their encoding in JSON; an image is its path beside its size.
            ("data", _) => map.extend(element(child).as_object_mut().map(std::mem::take).unwrap_or_default()),
            ("image", _) => {
                map.insert("image".to_owned(), child.attribute("source").unwrap_or_default().into());
                for side in ["width", "height"] {
                    map.extend(child.attribute(side).map(|value| (format!("image{side}"), value.into())));
                }
            }
            (_, Some(list)) => {
                let all = map.entry(list).or_insert_with(|| Value::Array(Vec::new()));
                all.as_array_mut().into_iter().for_each(|all| all.push(element(child)));
            }
            _ => _ = map.insert(name.to_owned(), element(child)),
        }
    }
    map.into()
}

pub fn number(of: &Value, name: &str) -> Option<f64> {
    let value = of.get(name)?;
    value.as_f64().or_else(|| value.as_str()?.trim().parse().ok()).filter(|number: &f64| number.is_finite())
}

pub fn text<'a>(of: &'a Value, name: &str) -> &'a str {
    of.get(name).and_then(Value::as_str).unwrap_or_default()
}

pub fn list<'a>(of: &'a Value, name: &str) -> &'a [Value] {
    of.get(name).and_then(Value::as_array).map_or(&[], Vec::as_slice)
}

/// Whether something is so, in either format; XML says it by 1, or by an element.
pub fn flag(of: &Value, name: &str, usual: bool) -> bool {
    match of.get(name) {
        None | Some(Value::Null) => usual,
        Some(Value::Bool(flag)) => *flag,
        Some(Value::String(text)) => text == "1" || text == "true",
        Some(Value::Number(number)) => number.as_f64() != Some(0.0),
        Some(_) => true,
    }
}

/// What an object or tile is: its class, in most versions of Tiled under the name of type.
pub fn class(of: &Value) -> &str {
    let class = text(of, "class");
    if class.is_empty() { text(of, "type") } else { class }
}

/// By name the text of the value, and its type.
pub type Properties = BTreeMap<String, (String, String)>;

/// Custom properties. Those of a class of one's own are no text, and are left out.
pub fn properties(of: &Value) -> Properties {
    let plain = |property: &Value| {
        let value = match property.get("value")? {
            Value::String(text) => text.clone(),
            Value::Bool(_) | Value::Number(_) => property.get("value")?.to_string(),
            _ => return None,
        };
        Some((text(property, "name").to_owned(), (value, text(property, "type").to_owned())))
    };
    list(of, "properties").iter().filter(|property| text(property, "type") != "class").filter_map(plain).collect()
}

/// The global numbers of a layer's tiles, row by row. Errors: in words, found and expected.
pub fn tiles(layer: &Value) -> Result<Vec<u32>, String> {
    let side = |name| number(layer, name).filter(|side| (0.0..1e6).contains(side)).map_or(0, |side| side as u64);
    let count = side("width") * side("height");
    if count > MOST_TILES {
        return Err(format!("found {count} tiles, expected at most {MOST_TILES}"));
    }
    let tiles: Vec<u32> = match layer.get("data") {
        Some(Value::Array(all)) => all.iter().map(|gid| gid.as_u64().unwrap_or(0) as u32).collect(),
        Some(Value::String(data)) if text(layer, "encoding") != "base64" => {
            data.split(',').map(|gid| gid.trim().parse().unwrap_or(0)).collect()
        }
        Some(Value::String(data)) => unpacked(data, text(layer, "compression"), count)?,
        _ => Vec::new(),
    };
    if tiles.len() as u64 != count {
        return Err(format!("found {} tiles, expected {count} by its width and height", tiles.len()));
    }
    Ok(tiles)
}

fn unpacked(data: &str, compression: &str, count: u64) -> Result<Vec<u32>, String> {
    let letters: String = data.split_whitespace().collect();
    let packed = BASE64_STANDARD.decode(letters).map_err(|error| format!("found data that are no base64 ({error})"))?;
    // A byte more than there can be shows that there are too many.
    let most = 4 * count + 1;
    let mut bytes = Vec::new();
    let read = match compression {
        "" => packed.as_slice().take(most).read_to_end(&mut bytes),
        "zlib" => ZlibDecoder::new(packed.as_slice()).take(most).read_to_end(&mut bytes),
        "gzip" => GzDecoder::new(packed.as_slice()).take(most).read_to_end(&mut bytes),
        other => return Err(format!("found tiles compressed by {other:?}, expected CSV, plain base64, zlib or gzip")),
    };
    read.map_err(|error| format!("found data that cannot be unpacked ({error})"))?;
    Ok(bytes.as_chunks::<4>().0.iter().map(|gid| u32::from_le_bytes(*gid)).collect())
}
