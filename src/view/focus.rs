//! Whom the details tell of: all that are in view, one that is followed, or two that are compared; and how long arrows are drawn.

use crate::physics::BodyId;

/// How often arrows can be made longer or shorter: each time by √2.
const MOST: i8 = 24;

/// What is picked out of a game.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Focus {
    followed: Option<BodyId>,
    compared: Option<BodyId>,
    longer: i8,
}

impl Focus {
    /// Whether a body has its box and its arrows: all have where none is followed.
    pub fn shows(&self, body: BodyId) -> bool {
        self.followed.is_none() || self.followed == Some(body) || self.compared == Some(body)
    }

    /// Who is followed.
    pub const fn followed(&self) -> Option<BodyId> {
        self.followed
    }

    /// Whom that one is compared with.
    pub const fn compared(&self) -> Option<BodyId> {
        self.compared
    }

    /// Goes on from one of so many bodies to the next: from all to the ship, through the others, and back to all.
    pub fn next(&mut self, bodies: usize) {
        let next = self.followed.map_or(0, |body| body.index() + 1);
        *self = Self { followed: u32::try_from(next).ok().filter(|_| next < bodies).map(BodyId), compared: None, ..*self };
    }

    /// Follows a body, or compares it with the one that is followed; nobody, where it is none or already followed alone.
    pub fn pick(&mut self, body: Option<BodyId>, compare: bool) {
        *self = match (body, self.followed) {
            (Some(other), Some(followed)) if compare && other != followed => Self { compared: Some(other), ..*self },
            (body, followed) if body == followed && self.compared.is_none() => Self { followed: None, ..*self },
            (body, _) => Self { followed: body, compared: None, ..*self },
        };
    }

    /// Draws arrows longer or shorter by so many times √2.
    pub fn lengthen(&mut self, by: i8) {
        self.longer = (self.longer + by).clamp(-MOST, MOST);
    }

    /// How many times as long arrows are drawn.
    pub fn length(&self) -> f64 {
        2f64.powf(0.5 * f64::from(self.longer))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bodies_are_followed_one_after_the_other_and_compared_by_pairs() {
        let mut focus = Focus::default();
        let body = BodyId;
        assert!(focus.shows(body(0)) && focus.shows(body(7)));
        let mut met = Vec::new();
        for _ in 0..4 {
            focus.next(3);
            met.push(focus.followed());
        }
        assert_eq!(met, [Some(body(0)), Some(body(1)), Some(body(2)), None]);
        focus.pick(Some(body(1)), true);
        assert_eq!((focus.followed(), focus.compared()), (Some(body(1)), None), "with nobody to compare it is followed");
        focus.pick(Some(body(2)), true);
        assert!(focus.shows(body(1)) && focus.shows(body(2)) && !focus.shows(body(0)));
        focus.pick(Some(body(2)), false);
        assert_eq!((focus.followed(), focus.compared()), (Some(body(2)), None));
        focus.pick(Some(body(2)), false);
        assert_eq!(focus, Focus::default());
    }

    #[test]
    fn arrows_grow_by_halves_of_a_doubling_and_not_for_ever() {
        let mut focus = Focus::default();
        focus.lengthen(2);
        assert!((focus.length() - 2.0).abs() < 1e-12);
        (0..100).for_each(|_| focus.lengthen(-1));
        assert!((focus.length() - 2f64.powi(-12)).abs() < 1e-12);
    }
}
