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
