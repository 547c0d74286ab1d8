//! Dashed lines.

use super::layout::Vec2;

/// The pieces of a dashed path through `corners`: the lengths of a pattern (canvas units) are drawn and left out in turn, also round
/// corners. Without a pattern the path is whole.
pub fn dashes(corners: &[Vec2], pattern: &[f32]) -> Vec<(Vec2, Vec2)> {
    let mut pieces = Vec::new();
    let (mut index, mut left) = (0, pattern.first().copied().unwrap_or(f32::INFINITY));
    for pair in corners.windows(2) {
        let (from, to) = (pair[0], pair[1]);
        let (length, mut at) = (from.distance(to), 0.0);
        let along = |way: f32| from + (to - from) * (way / length);
        while at < length {
            // A piece takes a little at least, so that rounding cannot stall the loop.
            let end = (at + left.max(0.01)).min(length);
            if index % 2 == 0 {
                pieces.push((along(at), along(end)));
            }
            left -= end - at;
            if left <= 1e-3 {
                index = (index + 1) % pattern.len();
                left = pattern[index];
            }
            at = end;
        }
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dashes_go_on_round_corners() {
        let corners = [Vec2::ZERO, Vec2::new(5.0, 0.0), Vec2::new(5.0, 7.0)];
        let drawn: f32 = dashes(&corners, &[4.0, 2.0]).iter().map(|(from, to)| from.distance(*to)).sum();
        assert!((drawn - 8.0).abs() < 0.1, "{drawn}");
        assert!(dashes(&[Vec2::ONE, Vec2::ONE], &[4.0, 2.0]).is_empty());
        assert_eq!(dashes(&corners, &[]), [(corners[0], corners[1]), (corners[1], corners[2])]);
    }
}
