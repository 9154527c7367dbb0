//! Angles of joints that place no body, where the declared start is far from the assembly.

use reuleaux::mechanism;

mechanism! {
    /// A spherical four-bar; a wheel turns with the angle between coupler and rocker.
    #[allow(far_start)]
    mechanism Spherical in space {
        ground {
            axis a = (0, 0, 1) from (1, 0, 0);  axis d = (sin(80deg), 0, cos(80deg)) from (0, 1, 0);
            point W = (1m, 0m, 0m);
        }
        body crank { axis a = (0, 0, 1) from (1, 0, 0);  axis b = (sin(25deg), 0, cos(25deg)) from (0, 1, 0); }
        body coupler { axis b = (0, 0, 1) from (0, 1, 0);  axis c = (sin(70deg), 0, cos(70deg)) from (0, 1, 0); }
        body rocker {
            axis c = (0, 0, 1) from (0, 1, 0);  axis d = (sin(75deg), 0, cos(75deg)) from (0, 1, 0);
            start orientation = turn((0, 1, 0), 40deg);
        }
        body wheel { axis a = (0, 0, 1) from (1, 0, 0); }
        joint o = revolute(ground.position, ground.a, crank.position, crank.a);
        joint j1 = revolute(crank.position, crank.b, coupler.position, coupler.b);
        joint j2 = parallel_axes(coupler.c, rocker.c);
        joint j3 = revolute(ground.position, ground.d, rocker.position, rocker.d);
        joint w = revolute(ground.W, ground.a, wheel.position, wheel.a);
        joint gears = gear_pair(w.angle, j2.angle, 1, 1);
        drive motor = drive_rotation(o, 30deg - 2rad_s * t);
        output angle = j2.angle;
        output turned = w.angle;
        output at_sine = dot(cross(z_axis(coupler.c), x_axis(coupler.c)), x_axis(rocker.c));
        output at_cosine = dot(x_axis(coupler.c), x_axis(rocker.c));
    }
}

/// The distance of an angle from zero, whole turns aside.
fn off(angle: f64) -> f64 {
    let turns = angle / core::f64::consts::TAU;
    (turns - turns.round()).abs() * core::f64::consts::TAU
}

#[test]
fn an_angle_and_a_wheel_geared_to_it_are_those_of_the_axes() {
    let mechanism = Spherical::default();
    for state in mechanism.sweep((0..40).map(|k| 0.05 * f64::from(k))) {
        let state = state.expect("a state");
        let between = mechanism.at_sine(&state).value.atan2(mechanism.at_cosine(&state).value);
        let (angle, turned) = (mechanism.angle(&state).value, mechanism.turned(&state).value);
        assert!(off(angle - between) < 1e-13, "t = {}: {angle} instead of {between}", state.t);
        assert!(off(turned + between) < 1e-13, "t = {}: {turned} instead of {}", state.t, -between);
    }
}
