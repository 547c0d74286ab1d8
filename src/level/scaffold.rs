//! New folders for levels: made, copied, renamed. Each is made under a hidden name, which no list of levels shows, and gets its own when it
//! is whole.

use super::document::{Document, Table};
use super::name::judge_name;
use super::problem::quoted;
use crate::files::{self, create_folder, put};
use std::fs;
use std::io;
use std::path::Path;

/// How many names of one stem are tried.
const MOST_NAMES: usize = 1000;

/// The files of a new level: a room of 1280 × 720 pixels with a floor, a ledge and an objective on it.
pub const FILES: [(&str, &str); 14] = [
    (
        "constants.csv",
        "# All settings; width and height (pixels) are not needed once there is a background.png. silver and gold (s) and one mark\n\
         # (mark_hits, mark_fuel, mark_pushes or mark_speed) are what the level's medals ask for.\n\
         name,value\ntitle,{name}\ngravity,15\ngravity_x,0\nair_density,1.2041\noptimal_time,60\nmetre,30\nrest_speed,0\nfriction,1\nexperiment,0\nsilver,30\ngold,15\nmark_hits,0\nwidth,1280\nheight,720\n",
    ),
    (
        "player.csv",
        "# The ship: its centre in pixels (it is 51 high), kg, fuel units, N.\n\
         x,y,mass,fuel,thrust,air,vx,vy,angle,material,drag,restitution\n150,650,100,500,2500,TRUE,0,0,0,Asphalt,1.15,0\n",
    ),
    (
        "world.csv",
        "# Solid rectangles by their top left corner. Materials: Asphalt, Steel, Ice, Rubber, Wood, Glass, Trampoline.\n\
         # one_way: the side from which it is solid (top, bottom, left, right); belt: m/s; breaks: N·s; name: for switches.\n\
         x,y,width,height,material,one_way,belt,breaks,name\n0,680,1280,40,Asphalt\n840,440,440,30,Wood\n560,560,120,15,Steel,top\n",
    ),
    (
        "objects.csv",
        "# Things that move: a PNG's path from the project's folder, or box:WIDTHxHEIGHT, or ball:WIDTHxHEIGHT.\n\
         x,y,image,mass,drag,circular,restitution,vx,vy,material,weightless\n600,660,box:40x40,50,1.05,FALSE,0.2,0,0,Wood,FALSE\n",
    ),
    (
        "objectives.csv",
        "# PLAYER,x,y,width,height,hold: where the ship must be, and for how many seconds. PHYS,…: the same for a key object.\n\
         # Further columns of these: order (1, 2, …: one after the other); of PHYS also r,g,b: only keys of that colour.\n\
         # OBJECT,x,y,image,mass,r,g,b,restitution,drag,vx,vy,material,weightless: a key object.\n\
         PLAYER,1120,430,100,10,1\n",
    ),
    ("obstacles.csv", "# Death boxes.\nx,y,width,height\n900,660,120,20\n"),
    (
        "hazards.csv",
        "# Air streams: the source block, how far it blows (one of the two; negative: left or up), the force in N.\n\
         # shaded: whether it ends at the first solid in its way; name: for switches.\n\
         x,y,width,height,stream_width,stream_height,force_x,force_y,shaded,name\n400,660,80,20,0,-200,0,-400,FALSE,fan\n",
    ),
    (
        "fluids.csv",
        "# Zones of thick liquid: kg/m³, Pa·s, colour.\n\
         x,y,width,height,density,viscosity,r,g,b\n0,560,80,120,900,50,120,90,40\n",
    ),
    (
        "movers.csv",
        "# Blocks that move: way points (top left corners), m/s or s for the whole way, waits and easings in s; route: back, round, once.\n\
         x,y,width,height,way_points,speed,period,wait,ease,route,material,one_way,belt,name\n\
         240,560,90,20,240 380; 400 380,3,,0.5,0.5,back,Steel,,0,\n",
    ),
    ("doors.csv", "# Doors, opened by switches.\nx,y,width,height,name,material\n1000,300,20,140,gate,Steel\n"),
    (
        "switches.csv",
        "# What works doors, movers, streams and belts by their names (!name: the other way round): plates that weigh N, or areas.\n\
         # by: any, ship, key, object; stays: held, latched, toggled.\n\
         x,y,width,height,works,weight,by,stays\n60,360,60,60,gate,,ship,latched\n760,640,60,40,!fan,,object,held\n",
    ),
    (
        "gravity.csv",
        "# Zones with a gravity of their own, N/kg, which adds to that of the level.\nx,y,width,height,field_x,field_y\n860,60,120,200,0,-12\n",
    ),
    ("pods.csv", "# Fuel to be picked up.\nx,y,width,height,fuel\n700,620,30,40,100\n"),
    (
        "texts.csv",
        "# Words in the level: top left corner and size in pixels, colour. Words with a comma stand in quotes.\n\
         x,y,size,text,r,g,b\n100,480,24,\"Space: thrust, arrows: rotate\",230,235,242\n",
    ),
];

/// The files of a room with the ship and nothing else, to be built in the editor.
pub const BARE: [(&str, &str); 2] = [
    ("constants.csv", "name,value\ntitle,{name}\nwidth,1280\nheight,720\n"),
    ("player.csv", "x,y,mass,fuel,thrust\n150,640,100,500,2500\n"),
];

/// Makes `levels/NAME/` with these files, in which `{name}` stands for the name.
///
/// # Errors
/// There is one already, or the disk refuses; nothing is left behind.
pub fn make(levels: &Path, name: &str, files: &[(&str, &str)]) -> io::Result<()> {
    build(levels, name, |folder| {
        files.iter().try_for_each(|(file, text)| put(&folder.join(file), text.replace("{name}", name).as_bytes()))
    })
}

/// Makes `levels/NAME/` with all that is in another level's folder, but for what is hidden and for folders in it.
///
/// # Errors
/// As [`make`].
pub fn copy(from: &Path, levels: &Path, name: &str) -> io::Result<()> {
    build(levels, name, |folder| copy_files(from, folder, |_| true))
}

/// Copies what is wanted of a folder's files, none that is hidden.
fn copy_files(from: &Path, to: &Path, wanted: impl Fn(&str) -> bool) -> io::Result<()> {
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        let (file, path) = (entry.file_name(), entry.path());
        let name = file.to_string_lossy();
        if !name.starts_with('.') && wanted(&name) && fs::metadata(&path)?.is_file() {
            files::copy(&path, &to.join(&file))?;
        }
    }
    Ok(())
}

/// As [`copy`], with the tables as they stand in a document of that level.
///
/// # Errors
/// As [`make`].
pub fn copy_edited(from: &Path, levels: &Path, name: &str, document: &Document) -> io::Result<()> {
    build(levels, name, |folder| {
        copy_files(from, folder, |file| Table::of_file(file).is_none())?;
        let tables = Table::ALL.iter().filter_map(|table| Some((table.file(), document.bytes(*table)?)));
        tables.into_iter().try_for_each(|(file, bytes)| put(&folder.join(file), bytes))
    })
}

/// A name for a level that is made of another one, which no level has: that of the other with what it is behind it.
pub fn free_name(levels: &Path, of: &str, what: &str) -> String {
    let names = |stem: String| (1_u32..).map(move |n| if n == 1 { stem.clone() } else { format!("{stem}-{n}") });
    let free = |name: &String| judge(levels, name).is_ok();
    // Where its name is no word, or as long as one can be, the new one is a plain word.
    let of_its_own = names(format!("{of}-{what}")).take(MOST_NAMES).find(free);
    of_its_own.or_else(|| names(what.to_owned()).find(free)).unwrap_or_default()
}

/// Gives a level's folder another name.
///
/// # Errors
/// There is one of that name already, or the disk refuses; nothing has changed then.
pub fn rename(levels: &Path, from: &str, to: &str) -> io::Result<()> {
    if taken(levels, to).is_some_and(|other| other != from) {
        return Err(io::ErrorKind::AlreadyExists.into());
    }
    fs::rename(levels.join(from), levels.join(to))
}

/// Whether a new level may be called that.
///
/// # Errors
/// Why not, in words.
pub fn judge(levels: &Path, name: &str) -> Result<(), String> {
    judge_name(name).map_err(|fault| format!("{}: expected {}", quoted(name), fault.expected()))?;
    match taken(levels, name) {
        None => Ok(()),
        Some(other) if other == name => Err(format!("{}: there is one of that name already", quoted(name))),
        Some(other) => Err(format!("{}: {} is there already, the same folder on some systems", quoted(name), quoted(&other))),
    }
}

/// What is in `levels` under that name already, in whichever case: on some systems `Tower` and `tower` are one folder.
pub fn taken(levels: &Path, name: &str) -> Option<String> {
    if fs::symlink_metadata(levels.join(name)).is_ok() {
        return Some(name.to_owned());
    }
    let lower = name.to_lowercase();
    let entries = fs::read_dir(levels).into_iter().flatten().flatten();
    entries.filter_map(|entry| entry.file_name().into_string().ok()).find(|other| other.to_lowercase() == lower)
}

/// Makes a level's folder under a name that no level has, in whichever case.
fn build(levels: &Path, name: &str, fill: impl FnOnce(&Path) -> io::Result<()>) -> io::Result<()> {
    if taken(levels, name).is_some() {
        return Err(io::ErrorKind::AlreadyExists.into());
    }
    create_folder(&levels.join(name), fill)
}
