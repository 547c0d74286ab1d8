//! The source of the loader's bytes; images as it needs them: whether a path stays in the project, and a PNG's size; and winds that solids shade.

use super::types::{AirStream, Look};
use super::{numbers::PixelScale, problem::quoted};
use crate::{files, physics::Aabb, words::tr};
use std::path::{Path, PathBuf};
use std::{collections::BTreeMap, io};

/// The picture behind a level, in its folder.
pub const BACKGROUND: &str = "background.png";

/// A level's folder and its project, as the loader asks for their files.
pub trait Files {
    /// A file of the level folder, by name. Errors: [`io::ErrorKind::NotFound`] where there is none; any other where it cannot be read.
    fn level_file(&self, name: &str) -> io::Result<Vec<u8>>;
    /// A file of the project, by its path from the project's folder with forward slashes.
    fn project_file(&self, path: &str) -> io::Result<Vec<u8>>;

    /// The names of all files of the level folder, where they can be listed.
    fn names(&self) -> Vec<String> {
        Vec::new()
    }

    /// The names of all files in its folder `flights`, where they can be listed.
    fn flights(&self) -> Vec<String> {
        Vec::new()
    }
}

/// The longest side of a picture, pixels: what graphics cards draw.
const MOST_SIDE: u32 = 16_384;
/// The most pixels of a picture: 32 MiB when it is unpacked. A PNG of a few kilobytes can unfold to gigabytes.
const MOST_PIXELS: u64 = 1 << 23;
const STAND_IN: &str = "box:40x40";
/// The most pixels of a level's pictures and background together: 48 MiB, several times as much with the copies of a graphics driver.
const MOST_PIXELS_IN_ALL: u64 = 12 << 20;

/// Words for the found and for the expected.
pub(super) type PictureRefusal = (String, String);

/// An object's look and its width and height in pixels.
pub(super) type PictureShape = (Look, f64, f64);

pub(super) struct Images<'a> {
    files: &'a dyn Files,
    known: BTreeMap<String, Result<(f64, f64), PictureRefusal>>,
    /// Of all known images together, and the background.
    pub pixels: u64,
    /// The shape of an object whose image is missing; without it such an object is refused.
    pub stand_in: Option<&'static str>,
}

impl<'a> Images<'a> {
    /// With `stand_ins` a box stands in for every missing image.
    pub fn new(files: &'a dyn Files, stand_ins: bool) -> Self {
        Self { files, known: BTreeMap::new(), pixels: 0, stand_in: stand_ins.then_some(STAND_IN) }
    }

    /// The shape of an `image` cell: `box:40x40`, `ball:40x40`, or a PNG's path from the project root.
    pub fn look(&mut self, cell: &str, scale: PixelScale) -> Result<PictureShape, PictureRefusal> {
        for (prefix, look) in [("box:", Look::Box), ("ball:", Look::Ball)] {
            if let Some(size) = cell.get(..prefix.len()).filter(|start| start.eq_ignore_ascii_case(prefix)) {
                let refusal = || (quoted(cell), tr!("{prefix}WIDTHxHEIGHT in pixels, such as {prefix}40x40", prefix));
                let (width, height) = plain_size(&cell[size.len()..], scale).ok_or_else(refusal)?;
                return Ok((look, width, height));
            }
        }
        let is_shape = |(shape, _): &(&str, &str)| shape.len() > 1 && shape.chars().all(char::is_alphabetic);
        if let Some((shape, _)) = cell.split_once(':').filter(is_shape) {
            let found = tr!("{cell}, with the unknown shape {shape}", cell = quoted(cell), shape = quoted(shape));
            return Err((found, tr("box:40x40, ball:40x40 or a PNG's path").into()));
        }
        let path = project_path(cell)?;
        let (files, pixels) = (self.files, &mut self.pixels);
        let read = || {
            // A level's own pictures go with its folder.
            let own = files.level_file(&path);
            let missing = own.as_ref().is_err_and(|error| error.kind() == io::ErrorKind::NotFound);
            let size = png_size(if missing { files.project_file(&path) } else { own }, cell)?;
            *pixels += (size.0 * size.1) as u64;
            if *pixels > MOST_PIXELS_IN_ALL {
                let found = tr!("{cell}, with which the level's pictures have {pixels} pixels", cell = quoted(cell), pixels);
                return Err((found, tr!("pictures of at most {most} pixels in all", most = MOST_PIXELS_IN_ALL)));
            }
            Ok(size)
        };
        let (width, height) = self.known.entry(path.clone()).or_insert_with(read).clone()?;
        for side in [width, height] {
            scale.size().parse(&side.to_string()).map_err(|expected| (tr!("an image side of {side} pixels", side), expected))?;
        }
        Ok((Look::Image(PathBuf::from(path)), width, height))
    }
}

/// `40x40` in any case, both sides accepted sizes.
fn plain_size(text: &str, scale: PixelScale) -> Option<(f64, f64)> {
    let (width, height) = text.split_once(['x', 'X'])?;
    let side = |text: &str| scale.size().parse(text.trim()).ok();
    Some((side(width)?, side(height)?))
}

/// The path with forward slashes, if it cannot lead out of the project on any system.
fn project_path(cell: &str) -> Result<String, PictureRefusal> {
    let expected = tr("a PNG's path from the level's or the project's folder, or box:40x40, or ball:40x40");
    if cell.is_empty() {
        return Err((tr("nothing").into(), expected.into()));
    }
    let path = cell.replace('\\', "/");
    let leaves = path.starts_with('/') || path.contains([':', '\0']) || path.split('/').any(|part| part == "..");
    if leaves { Err((tr!("{cell}, which leads out of the project", cell = quoted(cell)), expected.into())) } else { Ok(path) }
}

/// Width and height in pixels, both > 0; `name` is the author's. Errors: no such file, unreadable, no PNG, or one that unfolds to too many pixels.
pub(super) fn png_size(bytes: io::Result<impl AsRef<[u8]>>, name: &str) -> Result<(f64, f64), PictureRefusal> {
    let expected = || tr("a PNG image").to_owned();
    let bytes = bytes.map_err(|error| match error.kind() {
        io::ErrorKind::NotFound => (tr!("no file {file}", file = quoted(name)), expected()),
        _ => (tr!("{file}, which cannot be read ({error})", file = quoted(name), error), expected()),
    })?;
    if let Some(kind) = other_picture(bytes.as_ref()) {
        return Err((tr!("{file}, which is a {kind} picture", file = quoted(name), kind), expected()));
    }
    let damaged = |_| (tr!("{file}, which is no PNG or is damaged", file = quoted(name)), expected());
    let mut decoder = png::Decoder::new(io::Cursor::new(bytes.as_ref()));
    // Texts and profiles beside the picture could unfold to any size.
    decoder.set_ignore_text_chunk(true);
    decoder.set_ignore_iccp_chunk(true);
    let head = decoder.read_header_info().map_err(damaged)?;
    let (width, height) = (head.width, head.height);
    if width.max(height) > MOST_SIDE || u64::from(width) * u64::from(height) > MOST_PIXELS {
        let (most, side) = (MOST_PIXELS, MOST_SIDE);
        let expected = tr!("a PNG image of at most {most} pixels, none of its sides above {side}", most, side);
        return Err((tr!("{file} of {width} × {height} pixels", file = quoted(name), width, height), expected));
    }
    // All chunks and their checksums, without unpacking the picture: a file that was cut short is refused here, not when it is drawn.
    decoder.read_info().and_then(|mut reader| reader.finish()).map_err(damaged)?;
    Ok((f64::from(width), f64::from(height)))
}

/// The kind of a picture that is no PNG, by its first bytes.
fn other_picture(bytes: &[u8]) -> Option<&'static str> {
    let begins: [(&[u8], &str); 5] =
        [(&[0xff, 0xd8, 0xff], "JPEG"), (b"GIF8", "GIF"), (b"BM", "BMP"), (b"RIFF", "WebP"), (b"<svg", "SVG")];
    begins.into_iter().find(|(begin, _)| bytes.starts_with(begin)).map(|(_, kind)| kind)
}

/// The bytes of a picture, judged again, as the file may have changed since its level was loaded. Errors: unreadable, no PNG, or too many pixels.
pub fn read_picture(path: &Path) -> io::Result<Vec<u8>> {
    let bytes = files::read(path, files::PICTURE)?;
    let refusal = |(found, expected)| tr!("found {found}, expected {expected}", found, expected);
    let judged = png_size(Ok(&bytes), &path.display().to_string()).map_err(refusal);
    judged.map(|_| bytes).map_err(|refusal| io::Error::new(io::ErrorKind::InvalidData, refusal))
}

/// The zone of a stream that ends, in all of its width, at the first solid before it; `None` where no zone is left.
pub(super) fn shaded(stream: &AirStream, solids: impl Iterator<Item = Aabb>) -> Option<Aabb> {
    let (mut zone, source) = (stream.zone, &stream.source);
    for solid in solids.filter(|solid| solid.overlaps(&stream.zone, 0.0)) {
        // It blows away from its source, along one axis.
        for axis in 0..2 {
            if stream.zone.min[axis] == source.max[axis] {
                zone.max[axis] = zone.max[axis].min(solid.min[axis]);
            } else if stream.zone.max[axis] == source.min[axis] {
                zone.min[axis] = zone.min[axis].max(solid.max[axis]);
            }
        }
    }
    zone.min.cmplt(zone.max).all().then_some(zone)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::DVec2;

    #[test]
    fn paths_stay_in_the_project() {
        assert_eq!(project_path("assets\\a.png"), Ok("assets/a.png".into()));
        assert_eq!(project_path("assets/..a/b..png"), Ok("assets/..a/b..png".into()));
        for path in
            ["../a.png", "assets/../../a.png", "..\\a.png", "/a.png", "\\\\server\\a.png", "C:\\a.png", "c:a.png", "a/..", ""]
        {
            assert!(project_path(path).is_err(), "{path}");
        }
    }

    #[test]
    fn plain_shapes_have_two_sizes() {
        let scale = PixelScale { metre: 30.0 };
        assert_eq!(plain_size("40x20.5", scale), Some((40.0, 20.5)));
        for size in ["40", "40x", "x40", "0x40", "-1x3", "40x40x40", "nanxinf", "1e99x1"] {
            assert_eq!(plain_size(size, scale), None, "{size}");
        }
    }

    fn area(x: f64, y: f64, width: f64, height: f64) -> Aabb {
        Aabb::new(DVec2::new(x, y), DVec2::new(x + width, y + height))
    }

    #[test]
    fn the_first_solid_in_the_way_ends_it() {
        let source = area(10.0, 10.0, 2.0, 2.0);
        let solids = [area(11.5, 2.0, 5.0, 1.0), area(0.0, 4.0, 10.5, 1.0), area(12.0, 6.0, 3.0, 3.0), area(16.0, 11.0, 1.0, 9.0)];
        for (zone, ends) in [
            (area(10.0, 0.0, 2.0, 10.0), area(10.0, 5.0, 2.0, 5.0)),
            (area(12.0, 10.0, 9.0, 2.0), area(12.0, 10.0, 4.0, 2.0)),
            (area(10.0, 12.0, 2.0, 5.0), area(10.0, 12.0, 2.0, 5.0)),
        ] {
            let stream = AirStream { source, zone, force: DVec2::X, name: None };
            assert_eq!(shaded(&stream, solids.into_iter()), Some(ends));
        }
        let stream = AirStream { source, zone: area(10.0, 0.0, 2.0, 10.0), force: DVec2::X, name: None };
        assert_eq!(shaded(&stream, [area(9.0, 8.0, 4.0, 2.0)].into_iter()), None);
    }
}
