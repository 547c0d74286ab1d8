//! Colours and marks that the editor's panes share.

use crate::draw::layout::{Area, Vec2};
use crate::draw::{Canvas, Colour, Image};
use crate::level::document::Kind;
use crate::view::theme;
use std::collections::BTreeMap;
use std::path::PathBuf;

/// The pictures by path, read when they are first drawn; `None`: the file is no picture.
pub type Sheets = BTreeMap<PathBuf, Option<Image>>;

/// The colour of a kind: the game's, where it has one.
pub fn colour(kind: Kind) -> Colour {
    let of = |r, g, b| Colour::of([r, g, b]);
    match kind {
        Kind::Setting | Kind::Hint | Kind::Text => theme::text(),
        Kind::Ship => theme::text(),
        Kind::Solid => theme::solid_top(),
        Kind::Mover => of(120, 150, 190),
        Kind::Door => of(190, 140, 90),
        Kind::Switch => of(110, 200, 220),
        Kind::Object => theme::quiet(),
        Kind::Key => theme::accent(),
        Kind::Pad => theme::player_objective(),
        Kind::KeyPad => theme::physics_objective(),
        Kind::Link => of(204, 121, 167),
        Kind::Deadly => theme::bad(),
        Kind::Stream => of(150, 170, 200),
        Kind::Fluid => of(70, 130, 190),
        Kind::Gravity => of(150, 110, 210),
        Kind::Pod => theme::good(),
        Kind::Picture => of(140, 140, 140),
    }
}

pub fn material(name: &str) -> Colour {
    let of = |r, g, b| Colour::of([r, g, b]);
    match name.to_ascii_lowercase().as_str() {
        "steel" => of(92, 106, 124),
        "ice" => of(120, 160, 180),
        "rubber" => of(48, 50, 58),
        "wood" => of(112, 84, 60),
        "glass" => of(88, 122, 128),
        "trampoline" => of(96, 60, 92),
        _ => theme::solid(),
    }
}

/// A rectangle's edge, inside it: at least a pixel of the window.
pub fn edge(canvas: &Canvas, area: Area, width: f32, colour: Colour) {
    canvas.rectangle_edge(area, width.max(canvas.frame().pixel), colour);
}

/// An arrow of 32 canvas units around a point, along a unit vector.
pub fn arrow(canvas: &Canvas, middle: Vec2, along: Vec2, colour: Colour) {
    let (tip, tail) = (middle + along * 16.0, middle - along * 16.0);
    canvas.line(tail, tip - along * 6.0, 2.0, colour);
    let side = Vec2::new(-along.y, along.x) * 5.0;
    canvas.convex(&[tip, tip - along * 9.0 + side, tip - along * 9.0 - side], colour);
}
