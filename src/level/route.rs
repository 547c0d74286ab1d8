//! The routes of movers: from way points to a path, and how long each leg takes.

use crate::physics::{DVec2, Leg, Path};

/// The motion of a mover at the end of its path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Route {
    /// It goes back through its way points, for ever.
    Back,
    /// It goes straight to its start and begins again, for ever.
    Round,
    /// It stays there.
    Once,
}

/// s. The shortest wait, easing or leg: the engine refuses shorter ones.
pub(super) const SHORTEST: f64 = 1e-3;

/// Either its speed or its time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MoverPace {
    /// Between its easings, m/s.
    Speed(f64),
    /// For the whole route, waits included, s.
    Period(f64),
}

/// How a mover goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RouteShape {
    pub route: Route,
    pub pace: MoverPace,
    /// At each stop, s.
    pub wait: f64,
    /// To get to its speed, and to stop, s.
    pub ease: f64,
}

/// The path from the first stop through the others, which differ from their neighbours.
/// Errors: the shortest possible period, s, where the given one is too short.
pub(super) fn path(stops: &[DVec2], manner: RouteShape) -> Result<Path, f64> {
    let RouteShape { route, wait, ease, .. } = manner;
    let moves = moves(stops, route);
    let speed = speed(&moves, manner)?;
    let mut legs = Vec::new();
    let mut leg = |duration: f64, velocity: DVec2, acceleration: DVec2| {
        if duration > 0.0 {
            legs.push(Leg { duration, velocity, acceleration });
        }
    };
    for step in moves {
        let cruise = step.length() / speed - ease;
        // A move too short for its speed is all easing.
        let (cruise, velocity) =
            if cruise < SHORTEST && ease > 0.0 { (0.0, step / ease) } else { (cruise, step / (cruise + ease)) };
        let pull = if ease > 0.0 { velocity / ease } else { DVec2::ZERO };
        leg(wait, DVec2::ZERO, DVec2::ZERO);
        leg(ease, DVec2::ZERO, pull);
        leg(cruise, velocity, DVec2::ZERO);
        leg(ease, velocity, -pull);
    }
    Ok(Path { legs, repeats: route != Route::Once })
}

/// From stop to stop, in order, m.
fn moves(stops: &[DVec2], route: Route) -> Vec<DVec2> {
    let there = stops.windows(2).map(|pair| pair[1] - pair[0]);
    let back = there.clone().rev().map(|step| -step);
    match (route, stops) {
        (Route::Once, _) => there.collect(),
        (Route::Round, [first, .., last]) if first != last => there.chain([*first - *last]).collect(),
        (Route::Round, _) => there.collect(),
        (Route::Back, _) => there.chain(back).collect(),
    }
}

/// m/s.
fn speed(moves: &[DVec2], RouteShape { pace, wait, ease, .. }: RouteShape) -> Result<f64, f64> {
    let period = match pace {
        MoverPace::Speed(speed) => return Ok(speed),
        MoverPace::Period(period) => period,
    };
    let all: f64 = moves.iter().map(|step| step.length()).sum();
    let shortest = moves.iter().map(|step| step.length()).fold(f64::INFINITY, f64::min);
    // Each move takes its length over the speed, and one easing; the shortest still has to get to the speed.
    let standing = moves.len() as f64 * (wait + ease);
    let fastest = shortest / (ease + SHORTEST);
    let least = standing + all / fastest;
    if period < least { Err(least) } else { Ok(all / (period - standing)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STOPS: [DVec2; 3] = [DVec2::new(1.0, 1.0), DVec2::new(7.0, 1.0), DVec2::new(7.0, 4.0)];

    fn manner(route: Route, pace: MoverPace) -> RouteShape {
        RouteShape { route, pace, wait: 0.5, ease: 1.0 }
    }

    fn duration(path: &Path) -> f64 {
        path.legs.iter().map(|leg| leg.duration).sum()
    }

    fn end(path: &Path) -> DVec2 {
        path.legs.iter().map(|leg| (leg.velocity + leg.acceleration * (0.5 * leg.duration)) * leg.duration).sum()
    }

    #[test]
    fn every_way_takes_its_length_over_the_speed_and_an_easing() {
        for (route, seconds, ends) in [
            (Route::Once, 2.0 * 1.5 + 9.0 / 2.0, DVec2::new(6.0, 3.0)),
            (Route::Back, 4.0 * 1.5 + 18.0 / 2.0, DVec2::ZERO),
            (Route::Round, 3.0 * 1.5 + (9.0 + 45f64.sqrt()) / 2.0, DVec2::ZERO),
        ] {
            let path = path(&STOPS, manner(route, MoverPace::Speed(2.0))).unwrap();
            assert!((duration(&path) - seconds).abs() < 1e-12, "{route:?}");
            assert!(end(&path).distance(ends) < 1e-12, "{route:?}");
            assert_eq!(path.repeats, route != Route::Once);
        }
    }

    #[test]
    fn a_period_gives_the_speed() {
        let timed = path(&STOPS, manner(Route::Back, MoverPace::Period(15.0))).unwrap();
        assert_eq!(timed, path(&STOPS, manner(Route::Back, MoverPace::Speed(2.0))).unwrap());
        let least = path(&STOPS, manner(Route::Back, MoverPace::Period(1.0))).unwrap_err();
        assert!((duration(&path(&STOPS, manner(Route::Back, MoverPace::Period(least))).unwrap()) - least).abs() < 1e-9);
    }

    #[test]
    fn what_is_too_short_for_its_speed_is_eased_all_the_way() {
        let short = [DVec2::ZERO, DVec2::new(0.5, 0.0)];
        let path = path(&short, manner(Route::Once, MoverPace::Speed(2.0))).unwrap();
        assert_eq!(path.legs.len(), 3);
        assert_eq!(path.legs[1].acceleration, DVec2::new(0.5, 0.0));
        assert!(end(&path).distance(short[1]) < 1e-15);
    }
}
