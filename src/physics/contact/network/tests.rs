//! The contact network against answers by hand, and against the conditions of the minimum on random graphs.
use crate::physics::contact::network::*;
use crate::random::Random;

/// Bodies of (mass, force) in a line along the axis, one after the other.
fn line(bodies: &[(f64, f64)], links: &[(u32, u32, Carries)]) -> Network {
    let still: Vec<_> = links.iter().map(|&(lo, hi, carries)| (lo, hi, carries, 0.0)).collect();
    on_moving_ground(bodies, &still)
}

/// The same where each link to the ground knows how that moves.
fn on_moving_ground(bodies: &[(f64, f64)], links: &[(u32, u32, Carries, f64)]) -> Network {
    let mut network = Network::default();
    for &(mass, force) in bodies {
        network.nodes.push(NetworkNode { mass, force, acceleration: f64::NAN });
    }
    for &(lo, hi, carries, ground) in links {
        network.link(lo, hi, carries, ground);
    }
    network.solve();
    network
}

fn accelerations(network: &Network) -> Vec<f64> {
    network.nodes.iter().map(|node| node.acceleration).collect()
}

#[test]
fn a_column_rests_exactly_and_each_link_carries_all_above() {
    let masses = [1.0, 1e4, 0.5, 3.0];
    let bodies = masses.map(|m| (m, m * 9.81));
    let links: Vec<_> = (0..4).map(|i| (i, if i < 3 { i + 1 } else { GROUND }, Carries::Push)).collect();
    let network = line(&bodies, &links);
    assert_eq!(accelerations(&network), [0.0; 4]);
    let mut load = 0.0;
    for (link, mass) in network.links.iter().zip(masses) {
        load += mass * 9.81;
        assert_eq!(link.flow, load);
    }
}

/// A gram beside forty kilograms: to the last digits of its own forces, not of theirs. One lies on it, one is held by both.
#[test]
fn what_is_light_beside_something_heavy_is_in_balance() {
    let (heavy, force) = (43.7, 43.7 * 9.81);
    for pull in [1.23e-10, -1.23e-10, 0.0] {
        let bodies = [(heavy, force), (1e-3, 1e-3 * force / heavy + pull), (1e-3, pull)];
        let tie = Carries::UpTo(1.0);
        let links = [(1, 0, Carries::Push), (2, 1, tie), (0, 2, tie)];
        let network = line(&bodies, &links);
        for (i, node) in network.nodes.iter().enumerate() {
            let flows = network.links.iter().map(|link| match i as u32 {
                i if i == link.lo => -link.flow,
                i if i == link.hi => link.flow,
                _ => 0.0,
            });
            let left = node.force + flows.sum::<f64>() - node.mass * node.acceleration;
            let own = node.force.abs().max(node.mass * node.acceleration.abs());
            assert!(left.abs() <= 4.0 * FORCE_TOLERANCE * own, "{pull} N, node {i}: {left} N of {own} N");
        }
    }
}

/// What could be carried is no reason to go by itself: by what is as light, or lighter, or not light.
#[test]
fn what_is_light_stays_with_what_can_carry_it() {
    let (push, grip) = (Carries::Push, Carries::UpTo(1.0));
    for mass in [1e-3, 2e-3] {
        let bodies = [(mass, 1e-10), (1e-3, 0.0), (43.7, 428.7)];
        let network = line(&bodies, &[(0, 1, push), (1, 2, push), (1, 2, grip), (2, GROUND, Carries::UpTo(500.0))]);
        assert_eq!(accelerations(&network), [0.0; 3], "{mass} kg");
    }
    let network = line(&[(10.0, 1e-16), (5.0, 30.0)], &[(0, 1, Carries::UpTo(50.0)), (1, GROUND, Carries::UpTo(70.0))]);
    assert_eq!(accelerations(&network), [0.0; 2]);
    assert_eq!(network.links[0].flow, 1e-16);
    // And what nothing holds goes.
    let network = line(&[(1e-3, -1e-10), (43.7, 428.7)], &[(0, 1, push), (1, GROUND, push), (1, GROUND, Carries::UpTo(500.0))]);
    assert_eq!(accelerations(&network), [-1e-10 / 1e-3, 0.0]);
}

#[test]
fn what_pulls_away_parts_and_what_presses_moves_as_one() {
    // The first pushes the second; the third runs ahead of them.
    let links = [(0, 1, Carries::Push), (1, 2, Carries::Push)];
    let network = line(&[(2.0, 10.0), (3.0, 0.0), (1.0, 7.0)], &links);
    assert_eq!(accelerations(&network), [2.0, 2.0, 7.0]);
    assert_eq!((network.links[0].flow, network.links[1].flow), (6.0, 0.0));
}

#[test]
fn a_load_on_two_supports_is_shared_equally() {
    let links = [(0, 1, Carries::Push), (0, 2, Carries::Push), (1, GROUND, Carries::Push), (2, GROUND, Carries::Push)];
    let network = line(&[(4.0, 40.0), (1.0, 10.0), (1.0, 10.0)], &links);
    assert_eq!(network.links.iter().map(|link| link.flow).collect::<Vec<_>>(), [20.0, 20.0, 30.0, 30.0]);
}

#[test]
fn a_tie_holds_up_to_its_limit_and_then_slips_at_it() {
    let held = line(&[(2.0, 9.0)], &[(0, GROUND, Carries::UpTo(9.5))]);
    assert_eq!((accelerations(&held)[0], held.links[0].flow), (0.0, 9.0));
    let slips = line(&[(2.0, 9.0)], &[(0, GROUND, Carries::UpTo(4.0))]);
    assert_eq!((accelerations(&slips)[0], slips.links[0].flow, slips.links[0].cut), (2.5, 4.0, true));
}

#[test]
fn nothing_is_ever_pulled() {
    let network = line(&[(1.0, -5.0), (1.0, 5.0)], &[(0, 1, Carries::Push)]);
    assert_eq!(accelerations(&network), [-5.0, 5.0]);
    assert_eq!(network.links[0].flow, 0.0);
}

/// The conditions that make the answer unique, on random networks: momentum, order, no pulling, limits kept.
#[test]
fn random_networks_satisfy_the_conditions_of_the_minimum() {
    let mut generator = Random(1);
    let mut random = || generator.unit();
    let mut squeezed = 0;
    for round in 0..3000 {
        let n = 2 + (random() * 10.0) as u32;
        let bodies: Vec<_> = (0..n).map(|_| (0.1 + 10.0 * random(), 40.0 * random() - 20.0)).collect();
        let mut links = Vec::new();
        for i in 0..n {
            for j in i + 1..n {
                if random() < 0.3 {
                    links.push((i, j, if random() < 0.6 { Carries::Push } else { Carries::UpTo(8.0 * random()) }, 0.0));
                }
            }
            // In turns: ground that stands still, that moves, and several that move.
            let grounds = [0.0, 3.0, -2.0 + (4.0 * random()).floor()][round % 3];
            let grip = if random() < 0.6 { Carries::Push } else { Carries::UpTo(8.0 * random()) };
            match (random() * 10.0) as u32 {
                0 | 1 => links.push((i, GROUND, grip, grounds)),
                2 => links.push((GROUND, i, grip, grounds)),
                _ => {}
            }
        }
        let network = on_moving_ground(&bodies, &links);
        squeezed += u32::from(!network.squeezed.is_empty());
        if !network.squeezed.is_empty() {
            assert_eq!(round % 3, 2, "only grounds that move differently can squeeze");
            continue;
        }
        let mut net: Vec<f64> = bodies.iter().map(|body| body.1).collect();
        for (link, &(.., ground)) in network.links.iter().zip(&links) {
            let a = |i: u32| if i == GROUND { ground } else { network.nodes[i as usize].acceleration };
            for (end, sign) in [(link.lo, -1.0), (link.hi, 1.0)] {
                if end != GROUND {
                    net[end as usize] += sign * link.flow;
                }
            }
            let gains = a(link.hi) - a(link.lo);
            match link.carries {
                Carries::Push => {
                    assert!(link.flow >= 0.0 && gains >= -1e-12);
                    assert!(link.flow * gains <= 1e-9, "a push across a gap that opens");
                }
                Carries::UpTo(limit) => {
                    assert!(link.flow.abs() <= limit * (1.0 + 1e-12) + 1e-12);
                    assert!(gains.abs() < 1e-12 || (link.flow + limit * gains.signum()).abs() < 1e-9, "slips below its limit");
                }
            }
        }
        for (i, &(mass, _)) in bodies.iter().enumerate() {
            assert!((net[i] - mass * network.nodes[i].acceleration).abs() < 1e-9, "Newton's second law");
        }
    }
    assert!((10..500).contains(&squeezed), "{squeezed}");
}

#[test]
fn a_column_on_a_lift_weighs_more() {
    let bodies = [(2.0, 20.0), (3.0, 30.0)];
    let network = on_moving_ground(&bodies, &[(0, 1, Carries::Push, 0.0), (1, GROUND, Carries::Push, -2.0)]);
    assert_eq!(accelerations(&network), [-2.0, -2.0]);
    assert_eq!((network.links[0].flow, network.links[1].flow), (24.0, 60.0));
}

/// A wall speeds up and pushes a block along a floor that holds it with 8 N.
#[test]
fn a_pushed_block_follows_the_wall_and_slips_on_the_floor() {
    let network = on_moving_ground(&[(2.0, 0.0)], &[(0, GROUND, Carries::UpTo(8.0), 0.0), (GROUND, 0, Carries::Push, 3.0)]);
    assert_eq!((accelerations(&network)[0], network.links[0].flow, network.links[1].flow), (3.0, 8.0, 14.0));
    assert!(network.squeezed.is_empty());
    // The other way round the wall leaves it.
    let network = on_moving_ground(&[(2.0, 0.0)], &[(0, GROUND, Carries::UpTo(8.0), 0.0), (GROUND, 0, Carries::Push, -3.0)]);
    assert_eq!((accelerations(&network)[0], network.links[1].flow), (0.0, 0.0));
}

#[test]
fn what_is_between_grounds_that_close_is_squeezed() {
    let links = [(GROUND, 0, Carries::Push, 1.0), (0, 1, Carries::Push, 0.0), (1, GROUND, Carries::Push, -1.0)];
    assert_eq!(on_moving_ground(&[(1.0, 0.0), (2.0, 5.0)], &links).squeezed, [0, 1]);
}
