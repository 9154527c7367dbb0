//! Outputs at change points, where states are extrapolated from both sides, against closed forms.

use reuleaux::mechanism;

use crate::near;

type Outcome = Result<(), Box<dyn std::error::Error>>;

mechanism! {
    /// An isosceles slider-crank: the end of the rod moves on a straight line, also where crank and rod stand across the way.
    mechanism Isosceles {
        ground { axis way = (1, 0); }
        body crank { point A = (120mm, 0mm); }
        body rod   { point B = (120mm, 0mm);  point P = (-120mm, 0mm);  start angle = -60deg; }
        body slide { }
        joint o = revolute(ground.position, crank.position);
        joint a = revolute(crank.A, rod.position);
        joint b = revolute(rod.B, slide.position);
        joint guide = translational(ground.way, ground.position, slide.position);
        drive motor = drive_angle(crank, 60deg + 1rad_s * t + 0.3rad_s2 * t^2);
        slice output end = rod.P with jerk;
        slice output product = rate(rod.P.y) * rate(rod.angle) / 1m_s;
        output whole = rod.P with jerk;
        output crank = crank.A with jerk;
    }
}

/// When the crank stands at 90°: t + 0.3 t² = 30°.
fn upright() -> f64 {
    let sixth = core::f64::consts::FRAC_PI_6;
    2.0 * sixth / (1.0 + (1.0 + 1.2 * sixth).sqrt())
}

#[test]
fn slices_have_third_derivatives_and_velocities_at_a_change_point() -> Outcome {
    let isosceles = Isosceles::default();
    let t = upright();
    let (speed, gain) = (1.0 + 0.6 * t, 0.6);
    // P at height 2 r sin θ, at rest across: its third derivative at 90° is −3 · 2 r θ̇ θ̈.
    let end = isosceles.end(&isosceles.solve_for_end().solve(t)?);
    near(end.jerk.y, -3.0 * 0.24 * speed * gain, 1e-9);
    near(end.jerk.x, 0.0, 1e-5);
    near(end.acceleration.y, -0.24 * speed * speed, 1e-9);
    // 2 r cos θ θ̇ · −θ̇, with the rate 2 r θ̇³ at 90°.
    for t in [t, t + 1e-9] {
        let product = isosceles.product(&isosceles.solve_for_product().solve(t)?);
        near(product.value, 0.24 * speed.powi(3) * (t - upright()), 1e-11);
        near(product.rate, 0.24 * speed.powi(3), 1e-7);
    }
    Ok(())
}

#[test]
fn third_derivatives_that_have_lost_all_digits_are_no_numbers() -> Outcome {
    let isosceles = Isosceles::default();
    let state = isosceles.solve(upright())?;
    assert!(isosceles.whole(&state).jerk.x.is_nan(), "{:?}", isosceles.whole(&state));
    // The crank follows from the law alone.
    let (speed, gain) = (1.0 + 0.6 * upright(), 0.6);
    near(isosceles.crank(&state).jerk.y, -3.0 * 0.12 * speed * gain, 1e-12);
    // A condition of about 200 leaves seven digits.
    let state = isosceles.solve(upright() - 0.004)?;
    near(isosceles.whole(&state).jerk.x, 0.0, 1e-5);
    Ok(())
}
