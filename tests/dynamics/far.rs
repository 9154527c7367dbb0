//! Initial states at parameters far from the declared ones.

use reuleaux::{Stopped, mechanism};
use reuleaux_tests::samples;

/// A four-bar whose crank is released or driven.
macro_rules! four_bar {
    ($name:ident, $($motion:tt)*) => {
        mechanism! {
            #[closure(start)]
            mechanism $name {
                param angle: Angle = 0.3rad;
                param crank_length: Length = 0.1m;
                param coupler_length: Length = 0.35m;
                param rocker_length: Length = 0.3m;
                param ground_length: Length = 0.4m;
                ground { point C = (ground_length, 0mm); }
                body crank { point A = (crank_length, 0mm); mass = 1kg; inertia = 0.1kgm2; }
                body coupler { point B = (coupler_length, 0mm); }
                body rocker { point B = (rocker_length, 0mm); start angle = 100deg; }
                joint o = revolute(ground.position, crank.position);
                joint c = revolute(ground.C, rocker.position);
                joint b = revolute(coupler.B, rocker.B);
                joint a = revolute(crank.A, coupler.position);
                $($motion)*
            }
        }
    };
}

four_bar!(Released, freedom turn = crank.angle from angle;);
four_bar!(Driven, drive turn = drive_angle(crank, angle + 1rad_s * t););

mechanism! {
    /// A body far away, of which the lengths of the mechanism know nothing.
    mechanism Satellite {
        param height: Length = 7000000m;
        param along: Velocity = 7500m_s;
        body probe { mass = 100kg; inertia = 20kgm2; }
        freedom x = probe.x from height;
        freedom y = probe.y from 0m at along;
        freedom turn = probe.angle from 0rad at 0.1rad_s;
    }
}

#[test]
fn lengths_may_change_by_any_amount() {
    for height in [6.6e6, -4.2e7, 1e12, 0.0] {
        let state = Satellite { height, ..Satellite::default() }.initial_state().unwrap_or_else(|stopped| panic!("{height}: {stopped}"));
        assert!((state.probe().position.x - height).abs() <= 1e-15 * height.abs(), "{height}: {}", state.probe().position.x);
    }
}

/// Angles of coupler and rocker by either; `None` if it is refused.
fn both([angle, crank_length, coupler_length, rocker_length, ground_length]: [f64; 5]) -> [Option<[f64; 2]>; 2] {
    let released = Released { angle, crank_length, coupler_length, rocker_length, ground_length }.initial_state();
    let driven = Driven { angle, crank_length, coupler_length, rocker_length, ground_length }.solve(0.0);
    [
        released.ok().map(|state| [state.coupler().angle, state.rocker().angle]),
        driven.ok().map(|state| [state.coupler().angle, state.rocker().angle]),
    ]
}

/// Along the line from the defaults, the tip of the rocker stays on one side of the line from the crank's pin to the rocker's pivot, as long as that is
/// neither longer than coupler and rocker together nor shorter than their difference.
#[test]
fn parameters_far_away_keep_the_assembly_of_the_start() {
    for parameters in [
        [-7.5412, 0.2086, 0.4462, 0.3068, 0.5655],
        [-4.0, 0.1719, 0.39, 0.1886, 0.3929],
        [-5.3555, 0.2266, 0.3535, 0.3856, 0.574],
        [3.3825, 0.2058, 0.3141, 0.2898, 0.3992],
        [-7.2, 0.085, 0.29, 0.17, 0.45],
        [2500.0, 0.1, 0.35, 0.3, 0.4],
    ] {
        let [angle, crank, coupler, rocker, ground]: [f64; 5] = parameters;
        let (x, y) = (ground - crank * angle.cos(), -crank * angle.sin());
        let line = x.hypot(y);
        // At the pivot, between the line to the pin and the rocker. The rocker is turned to the right of it, seen from the pivot.
        let between = ((rocker * rocker + line * line - coupler * coupler) / (2.0 * rocker * line)).acos();
        let right = (-y).atan2(-x) - between;
        let [found, _] = both(parameters);
        let Some([_, found]) = found else { panic!("{parameters:?}: it closes all the way") };
        assert!(((found - right) / 2.0).sin().abs() < 1e-9, "{parameters:?}: {found}, not {right}");
    }
}

/// A drive finds its start by another way. Where the branch ends on the line from the defaults, either may find an assembly on the same side beyond.
#[test]
fn released_and_driven_mechanisms_start_alike_at_any_parameters() {
    let mut random = fastrand::Rng::with_seed(20);
    let (mut same, mut refused, mut driven_only) = (0, 0, 0);
    for _ in 0..samples(30, 150) {
        let turns = [4.0, 20.0, 80.0][random.usize(0..3)];
        let mut within = |low: f64, high: f64| low + (high - low) * random.f64();
        let parameters = [within(-turns, turns), within(0.05, 0.25), within(0.2, 0.5), within(0.15, 0.45), within(0.25, 0.6)];
        match both(parameters) {
            [Some(released), Some(driven)] => {
                let apart = [0, 1].map(|k| ((released[k] - driven[k]) / 2.0).sin().abs());
                assert!(apart.iter().all(|apart| *apart < 1e-6), "{parameters:?}: {released:?}, not {driven:?}");
                same += 1;
            }
            [None, None] => refused += 1,
            [None, Some(_)] => driven_only += 1,
            [Some(released), None] => panic!("{parameters:?}: released {released:?}"),
        }
    }
    println!("{same} the same, {refused} refused, {driven_only} found by the drive only");
    assert!(same > samples(15, 90) && refused > samples(0, 10) && driven_only < samples(6, 25), "{same} {refused} {driven_only}");
}

/// The loop opens where coupler and rocker are in line: with the crank at 0.3 rad its tip is 350 + 300 mm from the other pivot.
#[test]
fn the_failure_says_where_the_assembly_of_the_start_ends() {
    let longest = 0.65_f64;
    let reach = |crank: f64| (crank.powi(2) + 0.16 - 2.0 * crank * 0.4 * 0.3_f64.cos()).sqrt();
    let (mut low, mut high) = (0.1, 2.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if reach(middle) > longest { high = middle } else { low = middle }
    }
    let share = (low - 0.1) / 1.9;
    match (Released { crank_length: 2.0, ..Released::default() }).initial_state() {
        Err(Stopped::AssemblyEnds { share: said, joint }) => {
            assert!((said - share).abs() < 1e-6, "{said}, not {share}");
            assert!(["a", "b", "c", "o"].contains(&joint), "{joint}");
        }
        other => panic!("{other:?}"),
    }
}

mechanism! {
    /// A nut on a screw whose lead may have the other sign.
    mechanism Screwed in space {
        param lead: Length = 20mm;
        ground { axis z = (0, 0, 1) from (1, 0, 0); }
        body nut { axis z = (0, 0, 1) from (1, 0, 0); mass = 3kg; inertia = (0.01kgm2, 0.01kgm2, 0.002kgm2); }
        joint s = screw(ground.position, ground.z, nut.position, nut.z, lead);
        freedom q = s.angle from 0.5rad at 2rad_s;
    }
}

mechanism! {
    /// A released rack whose pinion is the crank of a four-bar.
    mechanism Racked {
        param radius: Length = 30mm;
        ground { point C = (400mm, 0mm); }
        body rack { mass = 1kg; }
        body pinion { point A = (100mm, 0mm); mass = 1kg; inertia = 0.01kgm2; }
        body coupler { point B = (350mm, 0mm); }
        body rocker { point B = (300mm, 0mm); start angle = 115deg; }
        joint o = revolute(ground.position, pinion.position);
        joint guide = translational((1, 0), (0mm, 0mm), rack.position);
        joint mesh = rack_pinion(pinion, rack.position, (1, 0), (0mm, 0mm), radius);
        joint a = revolute(pinion.A, coupler.position);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.position, ground.C);
        freedom way = rack.x from 10mm at 1m_s;
    }
}

#[test]
fn leads_and_radii_may_have_either_sign() {
    for lead in [0.02_f64, -1e-9, -0.02, -0.5] {
        let state = Screwed { lead }.initial_state().unwrap_or_else(|stopped| panic!("{lead} m: {stopped}"));
        let by_angle = lead / std::f64::consts::TAU;
        let found = [state.nut().position.z, state.nut().velocity.z, state.nut().angular_velocity.z];
        for (found, right) in found.into_iter().zip([0.5 * by_angle, 2.0 * by_angle, 2.0]) {
            assert!((found - right).abs() <= 1e-14 * right.abs(), "{lead} m: {found}, not {right}");
        }
    }
    let mirrored = |radius: f64| Racked { radius }.initial_state().unwrap_or_else(|stopped| panic!("{radius} m: {stopped}"));
    let declared = mirrored(0.03);
    for radius in [-0.03, -3.0, -0.01].into_iter().take(samples(2, 3)) {
        let state = mirrored(radius);
        let right = [-0.01 / radius, -1.0 / radius];
        assert!((state.pinion().angle - right[0]).abs() <= 1e-13 * right[0].abs(), "{radius} m: {}", state.pinion().angle);
        assert!((state.pinion().angular_velocity - right[1]).abs() <= 1e-12 * right[1].abs(), "{radius} m");
        // The loop is assembled on the same side.
        let side = |state: &RackedState<f64>| (state.rocker().angle - state.coupler().angle).sin();
        assert!(side(&state) * side(&declared) > 0.0, "{radius} m");
    }
}
