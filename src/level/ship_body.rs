//! The ship's body as it is drawn, which red destroys; solids, pads, keys and zones act on the box around it.

use crate::physics::{Aabb, DVec2};

/// Its corners with the nose up, m from its centre, clockwise: the convex hull of the hull, the fins and the nozzle of the picture. All of
/// them lie in the circle that touches the box from inside.
pub const SHIP_BODY: [DVec2; 15] = [
    DVec2::new(0.0, -0.8245),
    DVec2::new(0.1445, -0.786),
    DVec2::new(0.3145, -0.6732),
    DVec2::new(0.4632, -0.5066),
    DVec2::new(0.5738, -0.3035),
    DVec2::new(0.7565, 0.306),
    DVec2::new(0.612, 0.544),
    DVec2::new(0.1709, 0.8118),
    DVec2::new(-0.1709, 0.8118),
    DVec2::new(-0.612, 0.544),
    DVec2::new(-0.7565, 0.306),
    DVec2::new(-0.5738, -0.3035),
    DVec2::new(-0.4632, -0.5066),
    DVec2::new(-0.3145, -0.6732),
    DVec2::new(-0.1445, -0.786),
];

/// The corners of [`SHIP_BODY`] at an angle, degrees clockwise.
pub fn ship_body(angle: f64) -> [DVec2; SHIP_BODY.len()] {
    let DVec2 { x: sin, y } = nose(angle);
    SHIP_BODY.map(|corner| DVec2::new(corner.x * -y - corner.y * sin, corner.x * sin + corner.y * -y))
}

/// Whether a convex body, given by its corners about its centre in order, touches `target` anywhere while the centre moves straight from
/// `from` to `to`. The centres at which the two touch make a convex polygon whose sides have the normals of the body's sides, turned round,
/// and of the target's: the segment is clipped by one after the other (Cyrus and Beck 1978), which is exact at any speed. Touching
/// counts, and so does a gap of less than `slop`, m.
pub fn sweep_touches(corners: &[DVec2], from: DVec2, to: DVec2, target: &Aabb, slop: f64) -> bool {
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    let meets = |outward: DVec2| {
        let reach = corners.iter().map(|corner| outward.dot(*corner)).fold(f64::NEG_INFINITY, f64::max);
        let nearest = DVec2::select(outward.cmpge(DVec2::ZERO), target.min, target.max).dot(outward);
        // The depth of the body's farthest corner behind the target's nearest one at the start, and its growth.
        let (deep, deeper) = (reach + outward.dot(from) - nearest + slop * outward.length(), outward.dot(to - from));
        if deeper > 0.0 {
            enter = enter.max(-deep / deeper);
        } else if deeper < 0.0 {
            leave = leave.min(-deep / deeper);
        }
        (deeper != 0.0 || deep >= 0.0) && enter <= leave
    };
    let sides = (0..corners.len()).map(|i| (corners[(i + 1) % corners.len()] - corners[i]).perp() * -1.0);
    [DVec2::X, DVec2::NEG_X, DVec2::Y, DVec2::NEG_Y].into_iter().chain(sides).all(meets)
}

/// The unit vector that points `angle` degrees clockwise from straight up. Whole quarter turns are taken out before the sine and
/// the cosine, so that right angles are exact and many turns cost no digits.
pub fn nose(angle: f64) -> DVec2 {
    let quarters = (angle / 90.0).round();
    let (sin, cos) = libm::sincos((angle - quarters * 90.0).to_radians());
    match quarters.rem_euclid(4.0) as u8 {
        0 => DVec2::new(sin, -cos),
        1 => DVec2::new(cos, sin),
        2 => DVec2::new(-sin, cos),
        _ => DVec2::new(-cos, -sin),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nose_points_where_the_angle_says() {
        let half = std::f64::consts::FRAC_1_SQRT_2;
        for (angle, expected) in [
            (0.0, DVec2::new(0.0, -1.0)),
            (90.0, DVec2::new(1.0, 0.0)),
            (180.0, DVec2::new(0.0, 1.0)),
            (270.0, DVec2::new(-1.0, 0.0)),
            (-90.0, DVec2::new(-1.0, 0.0)),
            (-360_000.0, DVec2::new(0.0, -1.0)),
        ] {
            assert_eq!(nose(angle), expected, "{angle} degrees");
        }
        for (angle, expected) in
            [(45.0, DVec2::new(half, -half)), (-45.0, DVec2::new(-half, -half)), (585.0, DVec2::new(-half, half))]
        {
            assert!(nose(angle).distance(expected) < 1e-15, "{angle} degrees: {}", nose(angle));
        }
        for angle in (-720..720).map(|tenth| f64::from(tenth) * 0.7) {
            let (sin, cos) = angle.to_radians().sin_cos();
            assert!(nose(angle).distance(DVec2::new(sin, -cos)) < 1e-14, "{angle} degrees");
        }
    }
}
