//! A plate on three cylinders has assemblies of the same sign of the determinant next to each other: none is taken for another.

use reuleaux::{Cause, Mechanism, mechanism};

mechanism! {
    /// A plate held by three cylinders, whose branch ends at 0.0065656 s.
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
    for end in [0.0236, 0.02, 0.03] {
        for steps in (1..=60).chain([100, 1000, 10_000]) {
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
