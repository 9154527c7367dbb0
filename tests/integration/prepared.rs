//! Quantities that depend on parameters only are computed once for each set of parameters.

use reuleaux::{SimdReal, mechanism};

mechanism! {
    /// A slide on an incline, pushed by a crank through a rod.
    pub mechanism Incline {
        param incline: Angle = 20deg;
        param crank_length: Length = 100mm;
        param rod_length: Length = 300mm;
        let way = (cos(incline), sin(incline));
        body crank { point A = (crank_length, 0mm); }
        body rod { point A = (0mm, 0mm); point B = (rod_length, 0mm); start angle = incline; }
        body slide { }
        joint o = revolute(ground.position, crank.position);
        joint a = revolute(crank.A, rod.A);
        joint b = revolute(rod.B, slide.position);
        joint guide = translational(way, ground.position, slide.position, incline);
        drive input = drive_angle(crank, 60rpm * t);
        output travel = dot(slide.position, way);
    }
}

/// x along the incline: a cos(φ − β) + √(l² − a² sin²(φ − β)).
fn travel(mechanism: &Incline, t: f64) -> f64 {
    let angle = std::f64::consts::TAU * t - mechanism.incline;
    let across = mechanism.crank_length * angle.sin();
    mechanism.crank_length * angle.cos() + (mechanism.rod_length * mechanism.rod_length - across * across).sqrt()
}

#[test]
fn a_prepared_mechanism_is_the_mechanism() {
    let mechanism = Incline { incline: 0.6, crank_length: 0.12, ..Incline::default() };
    let prepared = mechanism.prepared();
    let (mut one, mut other) = (mechanism.solve(0.0).unwrap(), prepared.solve(0.0).unwrap());
    for k in 1..=50 {
        let t = f64::from(k) / 50.0;
        mechanism.advance(&mut one, t).unwrap();
        prepared.advance(&mut other, t).unwrap();
        assert_eq!(one, other);
        assert!((mechanism.travel(&other).value - travel(&mechanism, t)).abs() <= 1e-15);
    }
    let times = || (0..=50).map(|k| f64::from(k) / 50.0);
    let swept: Vec<_> = mechanism.sweep(times()).map(|state| state.unwrap()).collect();
    assert_eq!(swept.last(), Some(&other));
    assert_eq!(prepared.sweep(times()).map(|state| state.unwrap()).collect::<Vec<_>>(), swept);
}

#[test]
fn an_angle_that_is_a_parameter_is_turned_once() {
    let mechanism = Incline::default();
    let debug = format!("{:?}", mechanism.prepared());
    let (sine, cosine) = (mechanism.incline.fast_sin_cos().0, mechanism.incline.fast_sin_cos().1);
    assert!(debug.contains(&format!("{sine:?}")) && debug.contains(&format!("{cosine:?}")), "{debug}");
}

mechanism! {
    /// The same comparison of parameters chooses what is computed once and what is computed at each time.
    mechanism Latched {
        param short: Length = 100mm;
        param long: Length = 120mm;
        let gain = if short < long { sin(3 * short / long) * exp(short / long) } else { cos(short / long) };
        body slide { point P = (0m, 0.1m); }
        joint guide = translational((1, 0), (0m, 0.1m), slide.P);
        drive law = drive_x(slide.P, 10mm * gain + 10mm * (if short < long { sin(1rad_s * t) } else { cos(2rad_s * t) }));
    }
}

mechanism! {
    /// The same comparison again, within its own branches.
    mechanism Within {
        param short: Length = 100mm;
        param long: Length = 120mm;
        let gain = if short < long { sin(3 * short / long) * exp(short / long) } else { cos(short / long) };
        body slide { point P = (0m, 0.1m); }
        joint guide = translational((1, 0), (0m, 0.1m), slide.P);
        drive law = drive_x(slide.P, if short < long { 10mm * gain * sin(1rad_s * t) } else { 10mm * gain * cos(2rad_s * t) });
    }
}

#[test]
fn a_comparison_of_parameters_chooses_within_its_own_branches() {
    for (short, long) in [(0.1_f64, 0.12_f64), (0.12, 0.1)] {
        let prepared = Within { short, long }.prepared();
        for t in [0.0, 0.5, 1.0] {
            let exact = if short < long {
                0.01 * (3.0 * short / long).sin() * (short / long).exp() * f64::sin(t)
            } else {
                0.01 * (short / long).cos() * f64::cos(2.0 * t)
            };
            let found = prepared.solve(t).unwrap();
            assert_eq!(found, Within { short, long }.solve(t).unwrap());
            assert!((found.slide().position.x - exact).abs() <= 1e-16, "{} instead of {exact}", found.slide().position.x);
        }
    }
}

#[test]
fn a_comparison_of_parameters_chooses_before_and_after() {
    for (short, long) in [(0.1_f64, 0.12_f64), (0.12, 0.1)] {
        let prepared = Latched { short, long }.prepared();
        for t in [0.0, 0.5, 1.0] {
            let exact = if short < long {
                0.01 * (3.0 * short / long).sin() * (short / long).exp() + 0.01 * f64::sin(t)
            } else {
                0.01 * (short / long).cos() + 0.01 * f64::cos(2.0 * t)
            };
            let found = prepared.solve(t).unwrap();
            assert_eq!(found, Latched { short, long }.solve(t).unwrap());
            let found = found.slide().position.x;
            assert!((found - exact).abs() <= 1e-16, "{found} instead of {exact}");
        }
    }
}
