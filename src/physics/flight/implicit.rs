//! Implicit steps through liquids, where drag takes a body to the speed of its place long before the step ends: an L-stable Rosenbrock method of
//! fifth order with an embedded one of fourth (G. Di Marzo, *RODAS5(4)*, 1993; Hairer, Wanner, *Solving Ordinary Differential Equations II*, IV.7).

use crate::physics::{data::body::Pose, forces::liquid::Regime, forces::liquid::Slopes};
use glam::{DMat2, DVec2};

/// One step of `h` seconds under a `constant` acceleration (m/s²), in a law with these slopes where it begins; and its error, m.
pub(crate) fn step(regime: &Regime, constant: DVec2, slopes: &Slopes, (x, v): Pose, h: f64) -> (Pose, f64) {
    // Each stage is implicit by 0.19 of the step.
    let (part, per_time) = (h * 0.19, 1.0 / h);
    let inverse = (DMat2::from_diagonal(DVec2::splat(1.0 / part)) - slopes.speed - slopes.place * part).inverse();
    let (mut ways, mut gains) = ([DVec2::ZERO; COUPLINGS.len()], [DVec2::ZERO; COUPLINGS.len()]);
    let mut at = (x, v);
    for i in 0..COUPLINGS.len() {
        at = match PLACES.get(i) {
            Some(places) => (0..i).fold((x, v), |at, j| (at.0 + ways[j] * places[j], at.1 + gains[j] * places[j])),
            None => (at.0 + ways[i - 1], at.1 + gains[i - 1]),
        };
        let taken = |sum: Pose, j: usize| (sum.0 + ways[j] * COUPLINGS[i][j], sum.1 + gains[j] * COUPLINGS[i][j]);
        let (way, gain) = (0..i).fold((DVec2::ZERO, DVec2::ZERO), taken);
        let way = at.1 + way * per_time;
        let gain = regime.pull(constant, at.0, at.1) + gain * per_time;
        gains[i] = inverse * (gain + slopes.place * (way * part));
        ways[i] = (way + gains[i]) * part;
    }
    let last = COUPLINGS.len() - 1;
    let mut end = (at.0 + ways[last], at.1 + gains[last]);
    // Drag alone turns no body round: the speed left is less than the error.
    if constant.x == 0.0 && end.1.x * v.x < 0.0 {
        end.1.x = 0.0;
    }
    (end, ways[last].abs().max((gains[last] * h).abs()).max_element())
}

/// How much of the stages before it a stage is taken from, and how much of them it takes over.
const PLACES: [&[f64]; 6] = [
    &[],
    &[2.0],
    &[3.040_894_194_418_781, 1.041_747_909_077_569],
    &[2.576_417_536_461_461, 1.622_083_060_776_64, -0.908_966_856_026_453_2],
    &[2.760_842_080_225_597, 1.446_624_659_844_071, -0.303_698_008_455_373_8, 0.287_749_860_032_544_3],
    &[-14.096_407_730_512_59, 6.925_207_756_232_704, -41.475_108_932_107_28, 2.343_771_018_586_405, 24.132_152_291_960_62],
];
#[rustfmt::skip]
const COUPLINGS: [&[f64]; 8] = [
    &[],
    &[-10.313_238_851_339_93],
    &[-21.048_231_176_500_03, -7.234_992_135_176_716],
    &[32.227_515_418_533_23, -4.943_732_386_540_191, 19.449_220_310_418_79],
    &[-20.698_655_795_900_63, -8.816_374_604_402_768, 1.260_436_877_740_897, -0.749_564_761_378_714_6],
    &[-46.220_043_527_112_57, -17.495_348_628_574_72, -289.638_958_289_205_7, 93.608_554_004_009_06, 318.382_253_421_214_7],
    &[34.200_137_334_729_35, -14.155_354_027_176_9, 57.823_356_409_884, 25.833_629_854_123_65, 1.408_950_972_071_624, -6.551_835_421_242_162],
    &[42.570_767_422_911_01, -13.807_706_720_179_97, 93.989_384_324_271_24, 18.779_196_337_145_03, -31.583_591_872_233_7,
      -6.685_968_952_921_985, -5.810_979_938_412_932],
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::data::aabb::Aabb;
    use crate::physics::data::body::{Body, BodyDef};
    use crate::physics::data::def::FluidDef;
    use crate::physics::flight::liquid::flow;
    use crate::physics::forces::media::Media;

    /// 2 kg that leave 900 kg/m³ for the air at their terminal speed: of fifth order, and stable where an explicit step is ten times too long.
    #[test]
    fn a_step_leads_where_many_short_ones_do() {
        let zone = Aabb::new(DVec2::new(-50.0, 0.0), DVec2::new(50.0, 30.0));
        let media = Media::new(10.0, 1.2, (&[], &[]), vec![FluidDef { zone, density: 900.0, viscosity: 0.5 }]);
        let def = BodyDef {
            position: DVec2::new(0.0, 0.45),
            velocity: DVec2::new(0.0, -3.0),
            mass: 2.0,
            drag: 1.0,
            ..BodyDef::default()
        };
        let mut body = Body::new(&def);
        let settle = media.law(&body, DVec2::ZERO, 0.02);
        (body.position, body.velocity) = flow(&media, &body, &settle, 0.02);
        let law = media.law(&body, DVec2::ZERO, 0.04);
        let regime = law.regime(&media, &body, body.position);
        let pose = (body.position, body.velocity);
        let slopes = regime.slopes(pose.0, pose.1);
        let off = |h: f64| (step(&regime, law.constant, &slopes, pose, h).0.0 - flow(&media, &body, &law, h).0).length();
        let rate = -slopes.speed.col(1).y;
        assert!(rate * 0.02 > 30.0, "{rate} 1/s");
        assert!(off(0.04) < 1e-6 && off(0.04) > 15.0 * off(0.02), "{} m, {} m in half the time", off(0.04), off(0.02));
    }
}
