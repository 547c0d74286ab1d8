//! `resultant import`: maps of the editor Tiled as levels, again and again, or refused by layer and object.

use crate::support::program::{Data, Ran};
use crate::support::tiled::{map, object, things};
use std::io::{BufRead, BufReader, Write};
use std::process::Stdio;

fn imported(data: &Data, file: &str, text: &str) -> Ran {
    let path = data.write(file, text);
    data.resultant(&["import", &path])
}

fn table(data: &Data, path: &str) -> String {
    std::fs::read_to_string(data.path(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

#[test]
fn objects_become_rows_and_solid_tiles_few_blocks() {
    let data = Data::new();
    let ran = imported(&data, "cave.tmj", &map(&things().join(",")));
    assert!(ran.status == 0 && ran.out.contains("cave: 7 files"), "{}{}", ran.out, ran.err);
    assert!(ran.err.contains("layer \"flowers\": left out"), "{}", ran.err);
    assert_eq!(table(&data, "levels/cave/world.csv"), "x,y,width,height,material\n960,512,320,192,Wood\n0,704,1280,64,Wood\n");
    assert_eq!(table(&data, "levels/cave/player.csv"), "x,y,mass,fuel,thrust\n96,600,100,500,2500\n");
    assert_eq!(table(&data, "levels/cave/objectives.csv"), "PLAYER,1000,502,120,10,1\n");
    let crate_ = "x,y,image,mass,drag,circular,restitution,name\n320,682,box:40x44,50,1.05,false,0.2,crate\n";
    assert_eq!(table(&data, "levels/cave/objects.csv"), crate_);
    assert!(table(&data, "levels/cave/movers.csv").contains("500,600,90,20,500 300,2\n"));
    assert_eq!(table(&data, "levels/cave/constants.csv"), "name,value\ngravity,12.5\nheight,768\nwidth,1280\n");
    assert_eq!(data.resultant(&["check", "cave"]).status, 0);
}

#[test]
fn the_xml_of_a_map_is_the_same_level() {
    let head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<map version=\"1.10\" orientation=\"orthogonal\" width=\"4\" height=\"3\" tilewidth=\"300\" \
                tileheight=\"300\" infinite=\"0\">\n <tileset firstgid=\"1\" source=\"rock.tsx\"/>\n";
    let objects = "<objectgroup id=\"2\" name=\"goals\" class=\"objectives\"><object id=\"1\" x=\"1000\" y=\"590\" width=\"100\" height=\"10\"/></objectgroup>
        <objectgroup id=\"3\" name=\"things\"><object id=\"2\" type=\"player\" x=\"100\" y=\"500\"><properties><property name=\"mass\" type=\"float\" value=\"100\"/>
        <property name=\"fuel\" value=\"500\"/><property name=\"thrust\" value=\"2500\"/></properties><point/></object>
        <object id=\"3\" class=\"texts\" x=\"10\" y=\"20\" width=\"200\" height=\"30\"><text pixelsize=\"24\" color=\"#ff1020\">Up, up &amp; away</text></object>
        <object id=\"4\" class=\"links\" x=\"0\" y=\"0\"><properties><property name=\"kind\" value=\"spring\"/><property name=\"a\" value=\"ship\"/>
        <property name=\"stiffness\" value=\"5\"/></properties><polyline points=\"0,0 400,50\"/></object></objectgroup>\n</map>\n";
    let tiles = "<tileset name=\"rock\" tilewidth=\"300\" tileheight=\"300\" tilecount=\"1\" columns=\"1\"><tile id=\"0\"><properties>
        <property name=\"solid\" type=\"bool\" value=\"true\"/><property name=\"material\" value=\"Ice\"/><property name=\"sound\" value=\"dull\"/></properties></tile></tileset>";
    let gids = [0_u32, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0x8000_0001, 1];
    let bytes: Vec<u8> = gids.iter().flat_map(|gid| gid.to_le_bytes()).collect();
    let packed = |bytes: &[u8]| base64::Engine::encode(&base64::prelude::BASE64_STANDARD, bytes);
    let zlib = {
        let mut encoder = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::default());
        encoder.write_all(&bytes).unwrap();
        packed(&encoder.finish().unwrap())
    };
    let csv = gids.map(|gid| gid.to_string()).join(",");
    let single: String = gids.iter().map(|gid| format!("<tile gid=\"{gid}\"/>")).collect();
    for data_of_tiles in [
        format!("<data encoding=\"csv\">\n{csv}\n</data>"),
        format!("<data encoding=\"base64\">{}</data>", packed(&bytes)),
        format!("<data encoding=\"base64\" compression=\"zlib\">\n   {zlib}\n</data>"),
        format!("<data>{single}</data>"),
    ] {
        let data = Data::new();
        data.write("rock.tsx", tiles);
        let layer = format!("<layer id=\"1\" name=\"rock\" width=\"4\" height=\"3\">{data_of_tiles}</layer>");
        let ran = imported(&data, "hill.tmx", &format!("{head}{layer}{objects}"));
        assert_eq!((ran.status, ran.err.as_str()), (0, ""), "{}", ran.out);
        assert_eq!(table(&data, "levels/hill/world.csv"), "x,y,width,height,material\n0,600,1200,300,Ice\n");
        assert_eq!(table(&data, "levels/hill/objectives.csv"), "PLAYER,1000,590,100,10\n");
        assert!(table(&data, "levels/hill/texts.csv").ends_with("10,20,24,\"Up, up & away\",255,16,32\n"));
        assert!(table(&data, "levels/hill/links.csv").contains("spring,ship,400 50,5"));
    }
}

#[test]
fn what_is_refused_is_named_by_layer_and_object_and_nothing_is_written() {
    let data = Data::new();
    let all = things();
    let with = |more: String| [&all[..], &[more]].concat().join(",");
    let place = [300.0, 100.0, 40.0, 40.0];
    let thing = |class: &str, own: &[(&str, &str)]| with(object(9, class, place, own));
    let mass = [("mass", "50"), ("drag", "1"), ("circular", "false"), ("restitution", "0.2")];
    for (objects, told) in [
        (thing("Enemy", &[]), "layer \"things\": object 9: found the class \"Enemy\", expected one of player, world, "),
        (thing("world", &[("colour", "red")]), "layer \"things\": object 9: found the property \"colour\", expected the columns x"),
        (with(object(9, "world", place, &[]).replace("\"rotation\":0", "\"rotation\":30")), "object 9: found a rotation of 30°"),
        (thing("objects", &mass[1..]), "layer \"things\": object 9: column \"mass\": found nothing, expected "),
        (with(object(9, "objects", [300.0, 690.0, 40.0, 40.0], &mass)), "layer \"things\": object 9: column "),
        (thing("objectives", &[("kind", "HALT")]), "object 9: found another kind, expected one of PLAYER, PHYS, OBJECT"),
        (thing("decoration", &[("image", "tree.jpg")]), "cave.tmj"),
        (all[..1].join(","), "expected "),
    ] {
        let ran = imported(&data, "cave.tmj", &map(&objects));
        assert!(ran.status == 2 && ran.out.is_empty() && ran.err.contains(told), "{told}: {}", ran.err);
        assert!(ran.err.lines().all(|line| line.contains("cave.tmj")), "{}", ran.err);
    }
    let whole = map(&all.join(","));
    for (text, told) in [
        (whole.replace("orthogonal", "isometric"), "found \"isometric\", expected an orthogonal map"),
        (whole[..300].to_owned(), "found no map"),
        ("<map".to_owned(), "found no map"),
        (map(""), "cave.tmj"),
        (whole.replace("\"height\":24,\"x\"", "\"height\":25,\"x\""), "layer \"ground\": found 960 tiles, expected 1000"),
        (whole.replace("\"gravity\"", "\"gravitation\""), "property \"gravitation\": found no setting of a level"),
    ] {
        let ran = imported(&data, "cave.tmj", &text);
        assert!(ran.status == 2 && ran.err.contains(told), "{told}: {}", ran.err);
    }
    assert!(!data.path("levels/cave").exists());
    assert_eq!(data.resultant(&["import", "nowhere.tmj"]).status, 2);
    let path = data.write("a b.tmj", &whole);
    assert!(data.resultant(&["import", &path]).err.contains("--as NAME"));
    assert_eq!(data.resultant(&["import", &path, "--as", "ab"]).status, 0);
}

#[test]
fn pictures_are_copied_where_they_are_png() {
    let data = Data::new();
    let ball = std::fs::read(concat!(env!("CARGO_MANIFEST_DIR"), "/assets/sprites/ball.png")).unwrap();
    std::fs::create_dir_all(data.path("art/more")).unwrap();
    std::fs::write(data.path("art/ball.png"), &ball).unwrap();
    std::fs::write(data.path("art/more/ball.png"), &ball).unwrap();
    let side = u32::from_be_bytes(ball[16..20].try_into().unwrap());
    let sets = format!(
        "\"tilesets\":[{{\"firstgid\":7,\"name\":\"art\",\"tiles\":[{{\"id\":2,\"image\":\"art/ball.png\",\"imagewidth\":{side},\"imageheight\":{side},
          \"type\":\"objects\",\"properties\":[{{\"name\":\"circular\",\"type\":\"bool\",\"value\":true}}]}}]}}],\"layers\""
    );
    let mass = [("mass", "50"), ("drag", "1"), ("restitution", "0.2")];
    let tile = object(5, "", [300.0, 400.0, f64::from(side), f64::from(side)], &mass).replace("\"id\":5", "\"id\":5,\"gid\":9");
    let image = |file: &str| {
        format!("{{\"type\":\"imagelayer\",\"name\":\"far\",\"image\":\"{file}\",\"offsetx\":50,\"offsety\":60,\"x\":0,\"y\":0}}")
    };
    let with = |layer: &str| {
        let text = map(&[&things()[..], std::slice::from_ref(&tile)].concat().join(",")).replacen("\"layers\"", &sets, 1);
        text.replacen("{\"type\":\"tilelayer\"", &format!("{layer},{{\"type\":\"tilelayer\""), 1)
    };
    let ran = imported(&data, "cave.tmj", &with(&image("art/more/ball.png")));
    assert_eq!(ran.status, 0, "{}", ran.err);
    assert!(table(&data, "levels/cave/decoration.csv").contains("50,60,ball.png"));
    let middle = (300.0 + f64::from(side) / 2.0, 400.0 - f64::from(side) / 2.0);
    assert!(table(&data, "levels/cave/objects.csv").contains(&format!("{},{},ball-2.png,50,1,true,0.2", middle.0, middle.1)));
    assert_eq!(std::fs::read(data.path("levels/cave/ball-2.png")).unwrap(), ball);
    let ran = imported(&data, "cave.tmj", &with(&image("art/sky.jpg")));
    assert!(ran.err.contains("layer \"far\": found the picture \"sky.jpg\", expected a PNG image"), "{}", ran.err);
}

#[test]
fn a_further_import_replaces_its_own_files_alone() {
    let data = Data::new();
    assert_eq!(imported(&data, "cave.tmj", &map(&things().join(","))).status, 0);
    data.write("levels/cave/flights/gold.replay.csv", "mine\n");
    data.write("levels/cave/hints.csv", "text\nMine\n");
    let ran = imported(&data, "cave.tmj", &map(&things()[..3].join(",")).replace("12.5", "9"));
    assert_eq!(ran.status, 0, "{}", ran.err);
    assert!(!data.path("levels/cave/movers.csv").exists());
    assert!(table(&data, "levels/cave/constants.csv").contains("gravity,9\n"));
    assert_eq!(table(&data, "levels/cave/hints.csv"), "text\nMine\n");
    assert!(data.path("levels/cave/flights/gold.replay.csv").exists());
    data.level("own", "", &[("player.csv", "mine\n")]);
    let ran = imported(&data, "own.tmj", &map(&things().join(",")));
    assert!(ran.status == 2 && ran.err.contains("found a level that no import made"), "{}", ran.err);
    assert_eq!(table(&data, "levels/own/player.csv"), "mine\n");
}

#[test]
fn a_watched_map_is_imported_whenever_it_is_saved() {
    let data = Data::new();
    let path = data.write("cave.tmj", &map(&things().join(",")));
    let mut child = data.command(&["import", &path, "--watch"]).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let mut out = BufReader::new(child.stdout.take().unwrap()).lines();
    let mut err = BufReader::new(child.stderr.take().unwrap()).lines();
    assert!(out.next().unwrap().unwrap().contains("cave: 7 files"));
    data.write("cave.tmj", "{ half a map");
    assert!(err.by_ref().any(|line| line.unwrap().contains("found no map")));
    data.write("cave.tmj", &map(&things()[..3].join(",")));
    assert!(out.next().unwrap().unwrap().contains("cave: 6 files"));
    child.kill().unwrap();
    child.wait().unwrap();
}
