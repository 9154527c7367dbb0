//! Redundant joints in space.

use reuleaux::mechanism;

mechanism! {
    /// A four-bar of hinges whose links lie askew in the frames of their bodies.
    pub(crate) mechanism Askew in space {
        ground { axis z = (0, 0, 1) from (1, 0, 0);  point D = (150mm, 0mm, 0mm); }
        body crank   { axis z = (1, 2, 3) from (3, 0, -1);  point B = (30mm, 0mm, -10mm); }
        body coupler { axis z = (2, 1, 2) from (1, 0, -1);  point C = (100mm, 0mm, -100mm); }
        body rocker  {
            axis z = (1, 2, 2) from (0, 1, -1);  point C = (0mm, 100mm, -100mm);
            start position = (150mm, 0mm, 0mm);
        }
        redundant joint a = revolute(ground.position, ground.z, crank.position, crank.z);
        joint b = revolute(crank.B, crank.z, coupler.position, coupler.z);
        joint c = revolute(coupler.C, coupler.z, rocker.C, rocker.z);
        joint d = revolute(ground.D, ground.z, rocker.position, rocker.z);
        start d.angle = 100deg;
        drive motor = drive_rotation(a, 60rpm * t);
        output pin = rocker.C;
    }
}

#[test]
fn a_redundant_hinge_whose_axis_is_askew_in_its_bodies_holds_to_rounding() {
    // C is where the circles of coupler and rocker meet, by mpmath with 40 digits.
    let expected = [
        (0.0, [0.090_811_388_300_841_9, 0.128_439_512_009_063_18]),
        (0.1, [0.106_507_116_791_713_7, 0.134_567_340_429_356_66]),
        (0.37, [0.079_058_677_729_776_56, 0.122_341_034_794_349_76]),
    ];
    let askew = Askew::default();
    for (t, [x, y]) in expected {
        let state = askew.solve(t).expect("a state");
        let pin = askew.pin(&state).value;
        assert!((pin.x - x).abs() < 1e-15 && (pin.y - y).abs() < 1e-15 && pin.z.abs() < 1e-15, "{t}: {pin:?}");
    }
}

mechanism! {
    /// A four-bar in a plane through x that a parameter tilts: the equations that are solved are chosen where it lies in x and y.
    pub(crate) mechanism Tilted in space {
        param tilt: Angle = 0deg;
        let along = (0, -sin(tilt), cos(tilt));
        ground { axis n = along from (1, 0, 0);  point D = (150mm, 0mm, 0mm); }
        body crank   { axis n = (0, 0, 1) from (1, 0, 0);  point B = (40mm, 0mm, 0mm); }
        body coupler { axis n = (0, 0, 1) from (1, 0, 0);  point C = (120mm, 0mm, 0mm); }
        body rocker  { axis n = (0, 0, 1) from (1, 0, 0);  point C = (100mm, 0mm, 0mm); }
        joint a = revolute(ground.position, ground.n, crank.position, crank.n);
        joint b = revolute(crank.B, crank.n, coupler.position, coupler.n);
        redundant joint c = revolute(coupler.C, coupler.n, rocker.C, rocker.n);
        joint d = revolute(ground.D, ground.n, rocker.position, rocker.n);
        start b.angle = 10deg;
        start d.angle = 100deg;
        drive motor = drive_rotation(a, 0.4rad + 1rad_s * t);
        output pin = rocker.C;
    }
}

/// Where the circles of coupler and rocker meet, on the left of the line from the crank pin to the rocker's pivot.
#[test]
fn a_loop_whose_plane_a_parameter_tilts_stays_assembled() {
    for tilt in [0.0, 30.0, 89.0, 91.0, 135.0, 180.0, 200.0, 269.0, 300.0, -120.0_f64] {
        let tilted = Tilted { tilt: tilt.to_radians() };
        for t in [0.0, 0.5] {
            let state = tilted.solve(t).unwrap_or_else(|failure| panic!("{tilt}°: {failure}"));
            let crank = [0.04 * (0.4 + t).cos(), 0.04 * (0.4 + t).sin()];
            let (dx, dy) = (0.15 - crank[0], -crank[1]);
            let square = dx * dx + dy * dy;
            let along = 0.5 + (0.12 * 0.12 - 0.1 * 0.1) / (2.0 * square);
            let across = (0.12 * 0.12 / square - along * along).sqrt();
            let (x, y) = (crank[0] + along * dx - across * dy, crank[1] + along * dy + across * dx);
            let (sine, cosine) = tilt.to_radians().sin_cos();
            let pin = tilted.pin(&state).value;
            let off = [pin.x - x, pin.y - y * cosine, pin.z - y * sine].map(f64::abs).into_iter().fold(0.0, f64::max);
            assert!(off < 1e-15 * state.condition.max(4.0), "{tilt}°, {t} s: {off:e}, condition {}", state.condition);
        }
    }
}

mechanism! {
    /// A slide on two guides, of which the second axis differs from the first in the last digit.
    pub(crate) mechanism Guided in space {
        ground { axis u = (0.6, 0.8, 0) from (0, 0, 1);  axis v = (0.6, 0.8, 0) from (0, 0, 1); }
        body slide {
            axis u = (0.8944271909999159, 0.4472135954999579, 0) from (0, 0, 1);
            axis v = (0.8944271909999159, 0.44721359549995796, 0) from (0, 0, 1);
        }
        joint guide = translational(ground.position, ground.u, slide.position, slide.u);
        redundant joint second = parallel_axes(ground.v, slide.v);
        drive feed = drive_translation(guide, 0.1m + 0.1m_s * t);
    }
}

#[test]
fn a_redundant_row_that_is_a_rounding_error_holds() {
    let at = Guided::default().solve(0.2).expect("the guides fit").slide().position;
    // 0.12 m along (0.6, 0.8, 0)
    assert!((at.x - 0.072).abs() < 1e-15 && (at.y - 0.096).abs() < 1e-15 && at.z.abs() < 1e-15, "{at:?}");
}
