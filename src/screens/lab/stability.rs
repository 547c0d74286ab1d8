//! The methods' regions of stability in the complex plane of z = h·λ. The player picks out one of them.

use super::body;
use crate::draw::layout::{Area, Frame};
use crate::lab::stability::{Region, regions};
use crate::screens::{Input, Key, Toolbar};
use crate::view::plane::Plane;

const KEYS: [Key; 2] = [Key::Escape, Key::Down];
const TITLE: f32 = 40.0;
const WORDS: f32 = 56.0;

#[derive(Debug, Default)]
pub struct StabilityPage {
    /// Computed when the page first opens.
    regions: Vec<Region>,
    picked: Option<usize>,
    pointed: Option<usize>,
    toolbar: Toolbar,
}

impl StabilityPage {
    /// True where the player leaves the lab.
    pub(super) fn update(&mut self, input: &Input) -> bool {
        if self.regions.is_empty() {
            self.regions = regions();
        }
        let pressed = self.toolbar.update(input, &KEYS);
        // No region stands before the first and after the last.
        let places = self.regions.len() + 1;
        let further = |picked: Option<usize>, by: usize| ((picked.map_or(0, |picked| picked + 1) + by) % places).checked_sub(1);
        if pressed == Some(1) {
            self.picked = further(self.picked, 1);
        } else if input.pressed(Key::Up) {
            self.picked = further(self.picked, places - 1);
        }
        let plane = self.plane(&input.frame);
        self.pointed = (0..self.regions.len()).find(|line| plane.legend(line + 1).contains(input.pointer));
        if input.click && self.pointed.is_some() {
            self.picked = if self.picked == self.pointed { None } else { self.pointed };
        }
        pressed == Some(0)
    }

    /// Methods whose step is the same at any moment.
    pub fn regions(&self) -> &[Region] {
        &self.regions
    }

    /// The region of the legend's line under the pointer, or else the chosen one.
    pub fn picked(&self) -> Option<usize> {
        self.pointed.or(self.picked)
    }

    pub fn plane(&self, frame: &Frame) -> Plane {
        let body = body(frame);
        Plane::of(Area::new(body.min.x, body.min.y + TITLE, body.size.x, body.size.y - TITLE - WORDS))
    }

    pub const fn toolbar(&self) -> &Toolbar {
        &self.toolbar
    }
}

mod drawing {
    use super::StabilityPage;
    use crate::draw::Canvas;
    use crate::draw::layout::{BUTTON_TEXT, DETAILS, TEXT, Vec2};
    use crate::lab::stability_diagram::TITLE;
    use crate::view::{plane, theme, widgets};

    impl StabilityPage {
        pub(in crate::screens::lab) fn draw(&self, canvas: &Canvas) {
            let place = self.plane(canvas.frame());
            let (middle, widest) = (place.panel.centre().x, place.panel.size.x);
            let title = Vec2::new(middle, place.panel.min.y - 20.0);
            widgets::fitted(canvas, TITLE, title, widest, &[BUTTON_TEXT, TEXT], theme::text());
            plane::draw(canvas, &place, self.regions(), self.picked());
            for (words, down) in plane::WORDS.iter().zip([18.0, 42.0]) {
                widgets::fitted(
                    canvas,
                    words,
                    Vec2::new(middle, place.panel.max().y + down),
                    widest,
                    &[TEXT, DETAILS],
                    theme::text(),
                );
            }
            self.toolbar.draw(canvas, &[("Back", "Esc"), ("Method", "↓")]);
        }
    }
}
