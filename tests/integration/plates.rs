//! A plate on three cylinders has neighbouring assemblies with the same sign of the determinant: none is mistaken for another.

use reuleaux::{Cause, mechanism};
use reuleaux_tests::samples;

mechanism! {
    /// A plate held by three cylinders, whose branch ends at 0.0065656 s.
    #[closure(start)]
    mechanism Plate {
        ground { point A = (11mm, -155mm);  point B = (-204mm, 196mm);  point C = (289mm, 75mm); }
        body plate {
            point a = (-106mm, 134mm);  point b = (179mm, -18mm);  point c = (133mm, 145mm);
            start position = (92mm, -69mm);  start angle = 76deg;
        }
        drive first = drive_distance(ground.A, plate.a, 76.6mm + 63.1mm * sin(12.566370614359172rad_s * t));
        drive second = drive_distance(ground.B, plate.b, 370.1mm - 57.1mm * sin(6.283185307179586rad_s * t));
        drive third = drive_distance(ground.C, plate.c, 306.4mm - 60.3mm * sin(6.283185307179586rad_s * t));
    }
}

#[test]
fn a_plate_ends_at_its_dead_point_in_however_many_steps() {
    let plate = Plate::default();
    for end in [0.0236, 0.02, 0.03].into_iter().take(samples(1, 3)) {
        for steps in (1..=60).chain([100, 1000, 10_000].into_iter().take(samples(2, 3))) {
            let times = (0..=steps).map(|step| end * f64::from(step) / f64::from(steps));
            let failure = plate.sweep(times).find_map(Result::err).unwrap_or_else(|| panic!("{steps} steps go on to {end} s"));
            assert!(matches!(failure.cause, Cause::Singular { .. }), "{steps} steps: {failure}");
            assert!((failure.time - 0.006_565_6).abs() < 1e-7, "{steps} steps: {failure}");
            let last = failure.last.expect("it began");
            assert!(last.t <= failure.time && failure.time - last.t < 1e-9, "{steps} steps: last at {}", last.t);
        }
        let failure = plate.solve(end).expect_err("it is behind the dead point");
        assert!((failure.time - 0.006_565_6).abs() < 1e-7, "{failure}");
    }
}

mechanism! {
    /// A plate whose branch ends shortly after the start and shortly before it.
    #[closure(off)]
    mechanism Cylinders {
        for i in 0..3 {
            param x[i]: Length = 0;  param y[i]: Length = 0;  param u[i]: Length = 0;  param v[i]: Length = 0;
            param length[i]: Length = 0;  param stroke[i]: Length = 0;  param frequency[i]: AngularVelocity = 0;  param phase[i]: Angle = 0;
        }
        ground { for i in 0..3 { point A[i] = (x[i], y[i]); } }
        body plate { for i in 0..3 { point P[i] = (u[i], v[i]); } }
        for i in 0..3 { drive cylinder[i] = drive_distance(ground.A[i], plate.P[i], length[i] + stroke[i] * sin(frequency[i] * t + phase[i])); }
    }
}

/// The reference ends come from an independent continuation with proof.
#[test]
fn a_fold_microseconds_away_is_found_at_once() {
    let plate = Cylinders {
        x: [-0.19863637082840407, -0.040251815062978424, -0.13118587342370508],
        y: [0.35216587860532855, -0.2796646688094684, 0.18426541559154241],
        u: [0.21505865518973238, -0.11372585666351381, 0.12356442405875717],
        v: [-0.058337130328609405, -0.16124012376468258, 0.08683184258802712],
        length: [0.8395634409550663, 0.33308065743800647, 0.4932738571520102],
        stroke: [0.14599891504281629, 0.1150722779207019, 0.028061950232131042],
        frequency: [12.566370614359172, 18.84955592153876, 12.566370614359172],
        phase: [-2.0063029160785573, 0.0, 1.9464611001221508],
    };
    let start = plate.solve_near(0.0, &[0.22861825034547667, 0.09838692459484638, -0.6764737424603271].into()).unwrap();
    assert!(plate.solve_from(1e-6, &start).is_ok());
    for (t, end) in [(1e-5_f64, 6.089994854759e-6_f64), (-1e-5, -3.788481266168e-6)] {
        let failure = plate.solve_from(t, &start).unwrap_err();
        assert!(matches!(failure.cause, Cause::Singular { .. }), "{failure}");
        // Between the ends, 1e-5 s apart, the drives move by about 40 m/s² · (5e-6 s)² / 2: roundings of 2e-16 m shift the ends by 1e-12
        // s.
        assert!((failure.time - end).abs() < 1e-12, "{:e}", failure.time - end);
    }
}
