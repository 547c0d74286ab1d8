//! Maps of the editor Tiled.

/// Of a map of 40 × 24 tiles of 32 px in JSON: the lower rows and a step are solid, a ship, a goal, a crate, a lift and a rope.
fn layers(objects: &str) -> String {
    let cell = |x: usize, y: usize| u32::from(y >= 22 || x >= 30 && y >= 16) * 7;
    let data: Vec<String> = (0..24 * 40).map(|at| cell(at % 40, at / 40).to_string()).collect();
    let solid = "\"properties\":[{\"name\":\"solid\",\"type\":\"bool\",\"value\":true},{\"name\":\"material\",\"type\":\"string\",\"value\":\"Wood\"}]";
    format!(
        "[{{\"type\":\"tilelayer\",\"name\":\"ground\",\"width\":40,\"height\":24,\"x\":0,\"y\":0,{solid},\"data\":[{}]}},
          {{\"type\":\"tilelayer\",\"name\":\"flowers\",\"width\":1,\"height\":1,\"x\":0,\"y\":0,\"data\":[3]}},
          {{\"type\":\"objectgroup\",\"name\":\"things\",\"objects\":[{objects}]}}]",
        data.join(",")
    )
}

pub fn map(objects: &str) -> String {
    format!(
        "{{\"type\":\"map\",\"orientation\":\"orthogonal\",\"width\":40,\"height\":24,\"tilewidth\":32,\"tileheight\":32,
          \"properties\":[{{\"name\":\"gravity\",\"type\":\"float\",\"value\":12.5}}],\"layers\":{}}}",
        layers(objects)
    )
}

/// An object with a class, a place and custom properties.
pub fn object(id: u32, class: &str, place: [f64; 4], properties: &[(&str, &str)]) -> String {
    let [x, y, width, height] = place;
    let own: Vec<String> = properties
        .iter()
        .map(|(name, value)| format!("{{\"name\":\"{name}\",\"type\":\"string\",\"value\":\"{value}\"}}"))
        .collect();
    let place = format!("\"x\":{x},\"y\":{y},\"width\":{width},\"height\":{height}");
    format!(
        "{{\"id\":{id},\"name\":\"\",\"type\":\"{class}\",{place},\"rotation\":0,\"visible\":true,\"properties\":[{}]}}",
        own.join(",")
    )
}

pub fn things() -> Vec<String> {
    let cells = [("mass", "50"), ("drag", "1.05"), ("circular", "false"), ("restitution", "0.2")];
    vec![
        object(1, "player", [96.0, 600.0, 0.0, 0.0], &[("mass", "100"), ("fuel", "500"), ("thrust", "2500")]),
        object(2, "objectives", [1000.0, 502.0, 120.0, 10.0], &[("hold", "1")]),
        object(3, "objects", [300.0, 660.0, 40.0, 44.0], &cells).replace("\"name\":\"\"", "\"name\":\"crate\""),
        object(4, "movers", [500.0, 600.0, 90.0, 20.0], &[("way_points", "500 300"), ("speed", "2")]),
    ]
}
