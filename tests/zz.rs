use resultant::lab::methods::{motion::*, bounce, chain::sweeps_needed};
use resultant::lab::stress::{motion as m, bouncing as b};
use resultant::lab::scenes::bouncing;
use resultant::lab::reference;
use resultant::physics::DVec2;
#[test] fn zz() {
    for g in [9.81, 15.0] { for vy in [20.0, -20.0] { for w in [4.0,-4.0] {
    let law = Law { constant: DVec2::new(0.0, g), drag: 0.05, wind: DVec2::new(w, 0.0) };
    let s = Point { x: DVec2::ZERO, v: DVec2::new(20.0, vy) };
    let e = reference::drag_in_two_dimensions(&law, s, 3.0).x;
    let err = |st: Step, h: f64| (follow(st, &law, s, 3.0, h).x - e).length();
    for st in [semi_implicit_euler as Step, strang, rk4] { println!("{g} {vy} {w}: {:e} {:e} {:e}", err(st, 1.0/15.0), err(st, 1.0/60.0), err(st, 1.0/240.0)); }
    }}}
    for r in [10.0, 100.0, 1000.0] { println!("R {r} {:?}", sweeps_needed(&[1.0, r], 0.01, 10000)); }
    for n in [2, 5, 10, 20, 50] { println!("N {n} {:?}", sweeps_needed(&vec![1.0; n], 0.01, 10000)); }
    for z in [0.5,0.99, 1.01, 1.3, 1.38, 1.40, 1.45, 1.46,1.47,1.48, 1.5, 2.0, 2.05, 2.06,2.07, 2.1, 3.0] { println!("z {z} euler {:?} {:?} rk4 {:?} {:?}", m::fall(explicit_euler, z, 0.0), m::fall(explicit_euler, z, 0.9), m::fall(rk4, z, 0.0), m::fall(rk4, z, 0.9)); }
    for u in [24.0, 24.9, 48.5, 50.0] { let v = m::gust(explicit_euler, u); println!("gust {u} {:?}", &v[..3]); }
    println!("jitter {}", b::jitter(bounce::every_tick, 0.8));
    for (n, f) in bouncing::METHODS { println!("{n}: zeno {} minute {}", b::end_by_hand(f, 0.9), b::minute_by_hand(f, 1.0/60.0)); }
    println!("end {} engine {}", bouncing::series_end(0.9), b::end_by_engine(0.9));
    println!("event loop {}", bounce::event_loop((1.0,0.0), 9.81, 0.9, 60.0, 1_000_000));
    use resultant::lab::methods::friction::*;
    for h in [1.0/60.0, 1.0/120.0] { println!("slide {h}: sign {:?} clamp {:?} exact {}", b::slide(by_sign, h), b::slide(clamped, h), 100.0/(2.0*b::brake())); }
    for f in [semi_implicit_euler_f32 as Step] { for d in [1e6, 1e7, 2e7] { println!("drift {d} {}", resultant::lab::stress::robustness::drift(f, d)); } }
    for d in [1e3, 1e6, 1e7,1e9] { println!("ship drift {d} {:e}", resultant::lab::stress::robustness::shipped_drift(d)); }
    println!("cradle {:?}", resultant::lab::stress::contacts::cradle_by_hand(resultant::lab::methods::impact::at_once, 3));
    for (n, x) in resultant::lab::stress::robustness::nonsense_bodies() { println!("{n}: {} {}", resultant::lab::stress::robustness::naive_takes(&x), resultant::lab::stress::robustness::shipped_refuses(&x)); }
}
#[test] fn z2() {
    use resultant::lab::stress as s;
    for t in [s::bouncing::zeno as fn()->Vec<s::Survival>, s::robustness::nonsense, s::contacts::simultaneous_impacts] { for r in t() { println!("{r:?}"); } }
    for z in [1.3,1.35, 1.36,1.37, 1.38, 1.39, 1.392, 1.394, 1.4] { println!("{z} {:?} {:?}", m::fall(rk4, z, 0.0), m::fall(rk4, z, 0.9999)); }
}
