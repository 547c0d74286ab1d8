//! The ship's picture: a compact lander, nose up, painted in unit coordinates (−1 … 1 across its 1.7 m box). All of it lies in the
//! circle that touches the box from inside: the box does not turn with the ship, and nothing drawn may leave it at any angle.

use super::paint::Pixels;

const SHELL: [u8; 3] = [0xF4, 0xF6, 0xFA];
const SHELL_SHADE: [u8; 3] = [0xB4, 0xBF, 0xD0];
const BELLY: [u8; 3] = [0x5A, 0x68, 0x80];
const BELLY_SHADE: [u8; 3] = [0x3C, 0x48, 0x5C];
const TRIM: [u8; 3] = [0xFF, 0x9F, 0x1C];
const OUTLINE: [u8; 3] = [0x1B, 0x22, 0x30];
const GLASS: [u8; 3] = [0x2B, 0x6C, 0xB8];
const GLINT: [u8; 3] = [0xBF, 0xE3, 0xFF];

/// Width of the dark line round the hull.
const RIM: f32 = 0.04;
/// Where the shell ends and the belly begins.
const WAIST: f32 = 0.30;

/// `size` is width and height, pixels.
pub fn ship(size: usize) -> Pixels {
    let mut p = Pixels::new(size, size, OUTLINE);
    // Fins: they give the tail its width and tell it from the nose.
    p.fill(|x, y| fin(x.abs(), y, 0.0), |_, _| OUTLINE);
    p.fill(|x, y| fin(x.abs(), y, RIM), |x, _| if x > 0.0 { [0xE0, 0x86, 0x10] } else { TRIM });
    // The nozzle, wider at its mouth.
    p.fill(|x, y| nozzle(x, y, 0.0), |_, _| OUTLINE);
    p.fill(|x, y| nozzle(x, y, RIM), |x, _| mix([0x8A, 0x97, 0xAD], BELLY_SHADE, x * 2.0 + 0.5));
    // The hull: belly below the waist, shell above, a trim band between, an orange tip on the nose.
    p.fill(|x, y| hull(x, y, 0.0), |_, _| OUTLINE);
    p.fill(|x, y| hull(x, y, RIM) && y > WAIST, |x, _| mix(BELLY, BELLY_SHADE, x * 0.8 + 0.4));
    p.fill(|x, y| hull(x, y, RIM) && y <= WAIST, |x, _| mix(SHELL, SHELL_SHADE, x * 1.1 - 0.05));
    p.fill(|x, y| hull(x, y, RIM) && (WAIST - 0.06..WAIST + 0.08).contains(&y), |_, _| TRIM);
    p.fill(|x, y| hull(x, y, RIM) && y < -0.62, |x, _| mix(TRIM, [0xD9, 0x7A, 0x08], x * 2.0 + 0.3));
    // The window.
    p.fill(|x, y| round(x, y + 0.17, 0.315), |_, _| OUTLINE);
    p.fill(|x, y| round(x, y + 0.17, 0.26), |x, y| mix(GLASS, [0x14, 0x33, 0x66], (x + y + 0.17) * 1.6 + 0.5));
    p.fill(|x, y| round(x + 0.09, y + 0.27, 0.075), |_, _| GLINT);
    p
}

fn round(x: f32, y: f32, radius: f32) -> bool {
    x * x + y * y < radius * radius
}

/// An egg with its narrow end up, from the tip of the nose to above the nozzle.
fn hull(x: f32, y: f32, inset: f32) -> bool {
    let upper = y < 0.16;
    let (height, power, blunt) = if upper { (1.13 - inset * 1.6, 2.2, 0.64) } else { (0.66 - inset, 2.6, 0.5) };
    let along = (y - 0.16).abs() / height;
    along < 1.0 && x.abs() < (0.76 - inset) * (1.0 - along.powf(power)).powf(blunt)
}

fn nozzle(x: f32, y: f32, inset: f32) -> bool {
    (0.70..0.955 - inset).contains(&y) && x.abs() < 0.15 + (y - 0.70) * 0.2 - inset
}

/// The right fin, a swept quadrilateral.
fn fin(x: f32, y: f32, inset: f32) -> bool {
    let corners = [(0.50, -0.06), (0.89, 0.36), (0.72, 0.64), (0.30, 0.74)];
    (0..4).all(|i| {
        let ((ax, ay), (bx, by)) = (corners[i], corners[(i + 1) % 4]);
        let (dx, dy) = (bx - ax, by - ay);
        (dx * (y - ay) - dy * (x - ax)) / dx.hypot(dy) > inset
    })
}

fn mix(a: [u8; 3], b: [u8; 3], t: f32) -> [u8; 3] {
    let t = t.clamp(0.0, 1.0);
    std::array::from_fn(|i| (f32::from(a[i]) * (1.0 - t) + f32::from(b[i]) * t).round() as u8)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::DVec2;

    /// How far the picture reaches along both axes when it is turned, in halves of its box: to the far corners of every pixel that shows
    /// anything, and half a pixel more, over which filtering spreads it.
    fn reaches(picture: &Pixels, degrees: f32) -> [f32; 4] {
        let size = picture.size().0;
        let (sin, cos) = degrees.to_radians().sin_cos();
        let mut reaches = [0.0_f32; 4];
        for y in 0..size {
            for x in (0..size).filter(|&x| picture.at(x, y)[3] > 0) {
                for (dx, dy) in [(-0.5, -0.5), (1.5, -0.5), (-0.5, 1.5), (1.5, 1.5)] {
                    let place = |pixel: usize, by: f32| (pixel as f32 + by) / size as f32 * 2.0 - 1.0;
                    let (u, v) = (place(x, dx), place(y, dy));
                    let (across, down) = (u * cos - v * sin, u * sin + v * cos);
                    for (reach, far) in reaches.iter_mut().zip([-across, across, -down, down]) {
                        *reach = reach.max(far);
                    }
                }
            }
        }
        reaches
    }

    #[test]
    fn nothing_drawn_of_the_ship_leaves_its_box_at_any_angle_and_it_fills_it_well() {
        let pixels = super::super::SHIP;
        for picture in [ship(pixels), ship(pixels).halved()] {
            for degrees in (0..360).step_by(5) {
                for reach in reaches(&picture, degrees as f32) {
                    assert!((0.75..=1.0).contains(&reach), "at {degrees}° it reaches {reach} of half its box");
                }
            }
        }
    }

    #[test]
    fn what_red_kills_is_what_is_drawn_within_half_a_pixel() {
        use crate::level::{SHIP_BODY, SHIP_HALF, SHIP_PIXELS};
        const HALF_A_PIXEL: f64 = 0.5;
        let picture = ship(super::super::SHIP);
        let size = picture.size().0;
        // Pixels of the box that is 51 of them wide, from its centre.
        let pixels = |i: usize| ((i as f64 + 0.5) / size as f64 - 0.5) * SHIP_PIXELS;
        let drawn: Vec<DVec2> = (0..size * size)
            .filter(|i| picture.at(i % size, i / size)[3] > 127)
            .map(|i| DVec2::new(pixels(i % size), pixels(i / size)))
            .collect();
        let body = SHIP_BODY.map(|corner| corner / SHIP_HALF.x * (SHIP_PIXELS / 2.0));
        for (i, from) in body.iter().enumerate() {
            let to = body[(i + 1) % body.len()];
            let outward = (*from - to).perp().normalize();
            let reach = drawn.iter().map(|pixel| outward.dot(*pixel)).fold(f64::NEG_INFINITY, f64::max);
            let off = reach - outward.dot(*from);
            assert!(off.abs() <= HALF_A_PIXEL, "side {i}: the picture reaches {off} pixels beyond it");
            let turn = (to - *from).perp_dot(body[(i + 2) % body.len()] - to);
            assert!(turn > 0.0, "corner {i} is not convex");
            let nearest = drawn.iter().map(|pixel| pixel.distance(*from)).fold(f64::INFINITY, f64::min);
            assert!(nearest <= HALF_A_PIXEL, "corner {i}: the picture is {nearest} pixels away");
            assert!(from.length() <= SHIP_PIXELS / 2.0, "corner {i} leaves the box when it turns");
        }
    }

    #[test]
    fn the_nose_differs_from_the_tail_and_left_mirrors_right() {
        let picture = ship(102);
        for y in 0..102 {
            for x in 0..51 {
                assert_eq!(picture.at(x, y)[3], picture.at(101 - x, y)[3]);
            }
        }
        let wide = |y: usize| (0..102).filter(|&x| picture.at(x, y)[3] > 127).count();
        assert!(wide(8) + 20 < wide(80), "nose {} px, tail {} px", wide(8), wide(80));
    }
}
