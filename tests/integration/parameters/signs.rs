//! Coefficients of linear equations that change their sign between the defaults and the parameters: there is one solution on either side.

use reuleaux::mechanism;

mechanism! {
    /// Two gears; the second number of teeth is given with the opposite sign.
    mechanism Geared {
        param ratio: Number = 2;
        body a { }
        body b { }
        joint o = revolute(ground.position, a.position);
        joint p = revolute((100mm, 0mm), b.position);
        joint m = gear_pair(a, b, 1, -ratio);
        drive d = drive_angle(a, 30deg + 10rad_s * t);
    }
}

mechanism! {
    /// A crank that is driven through a factor which may be zero, and through it a rocker with two assemblies.
    mechanism Levered {
        param factor: Number = 2;
        ground { point C = (400mm, 0mm); }
        body a { point A = (100mm, 0mm); }
        body b { }
        body coupler { point B = (350mm, 0mm); }
        body rocker { point B = (300mm, 0mm); start angle = 70deg; }
        joint o = revolute(ground.position, a.position);
        joint p = revolute(ground.position, b.position);
        joint m = { factor * a.angle == b.angle; }
        joint c = revolute(a.A, coupler.position);
        joint e = revolute(coupler.B, rocker.B);
        joint f = revolute(rocker.position, ground.C);
        drive d = drive_angle(b, 0.3rad + 0.5rad_s * t);
        output toggle = rocker.angle - coupler.angle;
    }
}

mechanism! {
    /// A double crank behind gears: what follows it has as many turns as it.
    mechanism Dragged {
        param teeth: Number = 20;
        param wheel: Number = 40;
        ground { point D = (50mm, 0mm); }
        body pinion   { }
        body crank    { point A = (150mm, 0mm); }
        body coupler  { point B = (180mm, 0mm); }
        body follower { point B = (160mm, 0mm);  start angle = 60deg; }
        joint p = revolute((-60mm, 0mm), pinion.position);
        joint o = revolute(ground.position, crank.position);
        joint mesh = gear_pair(pinion, crank, teeth, wheel);
        joint a = revolute(crank.A, coupler.position);
        joint b = revolute(coupler.B, follower.B);
        joint c = revolute(follower.position, ground.D);
        drive d = drive_angle(pinion, 0.3rad + 1rad_s * t);
    }
}

/// A double crank on the pinion of a rack, which turns ever less as its radius grows.
macro_rules! rolled {
    ($name:ident, radius $radius:literal, start $start:literal) => {
        mechanism! {
            #[allow(far_start)]
            mechanism $name {
                param radius: Length = $radius;
                param aside: Length = 0mm;
                ground { point D = (50mm, 0mm); }
                body rack     { }
                body crank    { point A = (150mm, 0mm); }
                body coupler  { point B = (180mm, 0mm); }
                body follower { point B = (160mm, 0mm);  start angle = $start; }
                joint guide = translational((1, 0), (0mm, 0mm), rack.position);
                joint o = revolute(ground.position, crank.position);
                joint mesh = rack_pinion(crank, rack.position, (1, 0), (0mm, 0mm), radius);
                joint a = revolute(crank.A, coupler.position);
                joint b = revolute(coupler.B, follower.B);
                joint c = revolute(follower.position, ground.D);
                drive d = drive_x(rack.position, 1m + aside);
            }
        }
    };
}

rolled!(Rolled, radius 20mm, start 106deg);
rolled!(Slowed, radius 0.1mm, start 60deg);

/// Whole turns are counted on either way; an offset that changes its sign beside the radius does not keep them from arriving.
#[test]
fn long_turns_are_counted_whatever_their_speed() {
    let turned = |radius: f64, aside: f64| Rolled { radius, aside }.solve(0.0).unwrap_or_else(|failure| panic!("{radius} m: {failure}"));
    let declared = turned(20e-3, 0.0);
    // The one on the way over zero, on which the pinion turns faster and faster, and those through infinite radii.
    for (radius, aside) in [(2e-3, 0.0), (0.5, 0.0), (-20e-3, 0.0), (-20e-3, 0.5), (-5e-3, -0.3)] {
        let state = turned(radius, aside);
        let right = -(1.0 + aside) / radius;
        assert!((state.crank().angle - right).abs() <= 1e-13 * right.abs(), "{radius} m");
        // The follower turns as often as the crank.
        let by = [state.follower().angle - declared.follower().angle, state.crank().angle - declared.crank().angle];
        assert!((by[0] - by[1]).abs() < 3.0, "{radius} m: {by:?}");
    }
}

/// At the declared radius a pinion turns by ten thousand radians, and almost not at all at the given one.
#[test]
fn a_way_that_begins_with_many_turns_arrives() {
    let state = Slowed { radius: 1.0, aside: 0.0 }.solve(0.0).unwrap_or_else(|failure| panic!("{failure}"));
    assert!(f64::abs(state.crank().angle + 1.0) < 1e-14);
}

#[test]
fn gears_turn_either_way() {
    for ratio in [2.0_f64, 0.1, -0.1, -2.0, -7.5] {
        let geared = Geared { ratio };
        for t in [0.0, 0.7, 3.0] {
            let state = geared.solve(t).unwrap_or_else(|failure| panic!("{ratio}: {failure}"));
            let right = (std::f64::consts::PI / 6.0 + 10.0 * t) / ratio;
            assert!(
                (state.b().angle - right).abs() <= 4.0 * f64::EPSILON * right.abs(),
                "{ratio}, {t} s: {}, not {right}",
                state.b().angle
            );
        }
    }
}

/// The angle of the rocker against the coupler keeps its sign: it is the assembly that was declared.
#[test]
fn a_factor_changes_its_sign_beside_a_loop() {
    for factor in [2.0_f64, 0.5, -0.5, -20.0, -40.0] {
        let levered = Levered { factor };
        for t in [0.0, 0.7, 3.0] {
            let state = levered.solve(t).unwrap_or_else(|failure| panic!("{factor}: {failure}"));
            let right = (0.3 + 0.5 * t) / factor;
            assert!((state.a().angle - right).abs() <= 8.0 * f64::EPSILON, "{factor}, {t} s: {}, not {right}", state.a().angle);
            assert!(levered.toggle(&state).value.sin() > 0.1, "{factor}, {t} s");
        }
    }
}

/// The crank is led to the same angle by other teeth, and by time at the declared ones.
#[test]
fn what_gears_turn_keeps_its_assembly_and_its_turns() {
    let declared = Dragged::default();
    for wheel in [-40.0, -20.0, -1.0, -0.2, 0.2, 1.0, 400.0] {
        let ratio = -20.0 / wheel;
        let led = Dragged { wheel, ..declared }.solve(0.1).unwrap_or_else(|failure| panic!("{wheel}: {failure}"));
        let crank = ratio * 0.4;
        assert!((led.crank().angle - crank).abs() <= 4.0 * f64::EPSILON * crank.abs(), "{wheel}: {}", led.crank().angle);
        let waited = declared.solve(crank / -0.5 - 0.3).unwrap_or_else(|failure| panic!("{wheel}: {failure}"));
        let off = [led.follower().angle - waited.follower().angle, led.coupler().angle - waited.coupler().angle];
        assert!(off.iter().all(|off| off.abs() <= 1e-13 * crank.abs().max(1.0)), "{wheel}: {off:?}");
    }
    let teeth = Dragged { teeth: -20.0, ..declared }.solve(0.1).unwrap();
    let wheel = Dragged { wheel: -40.0, ..declared }.solve(0.1).unwrap();
    assert!((teeth.follower().angle - wheel.follower().angle).abs() <= 1e-14);
}
