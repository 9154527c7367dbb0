//! The motion over the whole range: its end, compared with the law of cosines.

use super::{Random, accepted, four_bar, start};
use reuleaux_compiler::diag::{AssemblyFact, Fact};

/// Angle in rad at which the crank of a four-bar stops when it turns anticlockwise from an angle, if it stops.
fn stop([ground, crank, coupler, rocker]: [f64; 4], from: f64) -> Option<f64> {
    let turn = core::f64::consts::TAU;
    // At the limits, the distance between the end of the crank and the rocker's pivot is the sum or the difference of coupler and rocker.
    let at = |reach: f64| ((ground * ground + crank * crank - reach * reach) / (2.0 * ground * crank)).acos();
    let limits = [at(coupler + rocker), at((coupler - rocker).abs())];
    let angles = limits.into_iter().filter(|angle| angle.is_finite()).flat_map(|angle| [angle, -angle]);
    angles.map(|angle| from + (angle - from).rem_euclid(turn)).min_by(f64::total_cmp)
}

/// The single fact for which a mechanism is refused because its motion ends, with or without a declared range.
fn refused(source: &str) -> Fact {
    super::refused(&format!("#[closure(deny)] {source}"))
}

/// Reported end of a motion: time, and angle of the only drive.
fn end(fact: &Fact) -> (f64, f64) {
    match fact {
        Fact::Assembly(AssemblyFact::MotionEnds { time, driven, .. }) => match driven.as_slice() {
            [only] => (*time, only.value.expect("the angle is known").0),
            _ => panic!("{fact}"),
        },
        _ => panic!("{fact}"),
    }
}

#[test]
fn a_crank_stops_where_the_law_of_cosines_says() {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let (mut stopped, mut turning) = (0, 0);
    while stopped < 200 || turning < 50 {
        let lengths = [(); 4].map(|()| random.between(80.0, 400.0));
        let [ground, crank, coupler, rocker] = lengths;
        let degrees = random.between(-180.0, 180.0);
        let angle = degrees.to_radians();
        let reach = (ground * ground + crank * crank - 2.0 * ground * crank * angle.cos()).sqrt();
        let longest = lengths.iter().copied().fold(0.0, f64::max);
        if reach > coupler + rocker - 2.0 || reach < (coupler - rocker).abs() + 2.0 || longest * 2.0 > lengths.iter().sum::<f64>() - 1.0 {
            continue;
        }
        let source = four_bar(lengths, degrees, "start angle = 80deg;");
        match stop(lengths, angle) {
            Some(stop) if stop - angle > 1e-3 => {
                let (time, at) = end(&refused(&source));
                assert!((time - (stop - angle)).abs() <= 1e-9 * (stop - angle), "{time} s instead of {} s in {source}", stop - angle);
                assert!((at - stop).abs() <= 1e-9, "{at} instead of {stop} in {source}");
                stopped += 1;
            }
            Some(_) => {}
            None => {
                let compiled = accepted(&source);
                assert!((start(&compiled, "crank.angle") - angle).abs() <= 1e-12);
                assert_eq!(compiled.motion.reached, [0.0, core::f64::consts::TAU], "{source}");
                turning += 1;
            }
        }
    }
}

/// A crank that pushes a slider along a line offset from its pivot, in mm and degrees.
fn slider_crank([crank, rod, offset]: [f64; 3], degrees: f64, items: &str) -> String {
    format!(
        "mechanism Slider {{ ground {{ point G = (0mm, {offset}mm); axis u = (1, 0); }} body crank {{ point A = ({crank}mm, 0mm); }}
            body rod {{ point B = ({rod}mm, 0mm); }} body slider {{ start position = (1m, {offset}mm); }}
            joint o = revolute(ground.position, crank.position); joint a = revolute(crank.A, rod.position);
            joint b = revolute(rod.B, slider.position); joint way = translational(ground.u, ground.G, slider.position);
            drive input = drive_angle(crank, ({degrees}) * 1deg + 2rad_s * t); {items} }}"
    )
}

#[test]
fn a_crank_stops_where_its_rod_stands_upright() {
    let mut random = Random(0x2545_f491_4f6c_dd1d);
    let (mut stopped, mut turning) = (0, 0);
    while stopped < 40 || turning < 20 {
        let [crank, rod] = [random.between(30.0, 100.0), random.between(20.0, 250.0)];
        let (offset, degrees) = (random.between(-40.0, 40.0), random.between(-180.0, 180.0));
        let angle = degrees.to_radians();
        if (crank * angle.sin() - offset).abs() > rod - 2.0 {
            continue;
        }
        // At the limit, the distance between the end of the crank and the line is the length of the rod.
        let sines = [(offset + rod) / crank, (offset - rod) / crank].into_iter().filter(|sine| sine.abs() < 1.0);
        let angles = sines.flat_map(|sine| [sine.asin(), core::f64::consts::PI - sine.asin()]);
        let stop = angles.map(|stop| angle + (stop - angle).rem_euclid(core::f64::consts::TAU)).min_by(f64::total_cmp);
        let source = slider_crank([crank, rod, offset], degrees, "");
        if let Some(stop) = stop {
            let (time, at) = end(&refused(&source));
            assert!(
                (2.0 * time - (stop - angle)).abs() <= 1e-9 * (stop - angle) && (at - stop).abs() <= 1e-9,
                "{time} s, {at} in {source}"
            );
            stopped += 1;
        } else if rod > crank + offset.abs() + 1.0 {
            assert!(accepted(&source).motion.reached[1] > 3.0, "{source}");
            turning += 1;
        }
    }
}

#[test]
fn a_declared_range_is_followed_and_no_more() {
    let stop = (0.9_f64 / 1.0).asin() / 2.0;
    let within = |range: &str| slider_crank([100.0, 90.0, 0.0], 0.0, &format!("range t in {range};"));
    for range in ["0s..0.5s", "0s..=559ms", "-0.5s..0.5s", "-100ms..100ms", "0.1s..0.2s", "0s..1.1rad / 2rad_s"] {
        assert!(accepted(&within(range)).motion.remarks.is_empty(), "{range}");
    }
    for (range, time) in [("0s..0.6s", stop), ("-1s..0.1s", -stop), ("0.56s..0.57s", stop), ("0s..1000s", stop)] {
        let (found, _) = end(&refused(&within(range)));
        assert!((found - time).abs() <= 1e-9 * stop, "{found} s instead of {time} s in {range}");
    }
    // The end of the range may coincide with the end of travel.
    accepted(&within(&format!("0s..{stop:.17}s")));
}

#[test]
fn a_law_that_swings_is_followed_for_its_period() {
    // A crank that oscillates about 0 by more than 64.16° is stopped by its rod of 90 mm.
    let swinging = |degrees: f64| {
        let law = format!("drive input = drive_angle(crank, {degrees}deg * sin(3rad_s * t))");
        slider_crank([100.0, 90.0, 0.0], 0.0, "").replace("drive input = drive_angle(crank, (0) * 1deg + 2rad_s * t)", &law)
    };
    assert_eq!(accepted(&swinging(64.0)).motion.reached, [0.0, core::f64::consts::TAU / 3.0]);
    let stop = (0.9_f64.asin().to_degrees() / 65.0).asin() / 3.0;
    let (time, _) = end(&refused(&swinging(65.0)));
    assert!((time - stop).abs() <= 1e-9 * stop, "{time} s instead of {stop} s");
}

#[test]
fn a_law_that_comes_to_rest_is_followed_until_then() {
    let laws = [
        "harmonic",
        "double_harmonic",
        "cycloidal",
        "half_cycloidal_end",
        "polynomial_345",
        "polynomial_4567",
        "smooth_step",
        "modified_trapezoidal",
        "modified_sine",
    ];
    for law in laws {
        let rising = |degrees: f64| {
            let drive = format!("drive input = drive_angle(crank, {degrees}deg * {law}((t - 1s) / 0.5s))");
            slider_crank([100.0, 90.0, 0.0], 0.0, "").replace("drive input = drive_angle(crank, (0) * 1deg + 2rad_s * t)", &drive)
        };
        let reached = accepted(&rising(64.0)).motion.reached[1];
        assert!((reached - 1.5).abs() <= 1e-12, "{law}: {reached}");
        let (time, angle) = end(&refused(&rising(65.0)));
        assert!((1.25..1.5).contains(&time) && (angle - 0.9_f64.asin()).abs() <= 1e-9, "{law}: {time} s, {angle}");
    }
}

#[test]
fn a_table_is_followed_from_end_to_end() {
    for (ends, until) in [("linear", 2.0), ("hold", 2.0), ("periodic", 2.0)] {
        let law = |degrees: f64| {
            let table = format!("table(t, [(0s, 0deg), (1s, {degrees}deg), (2s, 0deg)], {ends})");
            let drive = format!("drive input = drive_angle(crank, {table})");
            slider_crank([100.0, 90.0, 0.0], 0.0, "").replace("drive input = drive_angle(crank, (0) * 1deg + 2rad_s * t)", &drive)
        };
        assert_eq!(accepted(&law(60.0)).motion.reached[1], until, "{ends}");
        let (time, angle) = end(&refused(&law(80.0)));
        assert!(time < 1.0 && (angle - 0.9_f64.asin()).abs() <= 1e-9, "{ends}: {time} s, {angle}");
    }
}

#[test]
fn a_length_that_grows_for_ever_is_followed_only_as_far_as_is_said() {
    let arm = |law: &str, items: &str| {
        format!(
            "mechanism Arm {{ body arm {{ point E = (1m, 0m); start angle = 120deg; }} joint c = revolute((1m, 0m), arm.position);
                drive push = drive_distance(ground.position, arm.E, {law}); {items} }}"
        )
    };
    assert_eq!(accepted(&arm("1.9m + 1m_s * t", "")).motion.reached, [0.0, 0.0]);
    // The ground pivot, the arm's pivot and its end are in line.
    let (time, length) = end(&refused(&arm("1.9m + 1m_s * t", "range t in 0s..1s;")));
    assert!((time - 0.1).abs() <= 1e-10 && (length - 2.0).abs() <= 1e-10, "{time} s, {length} m");
    // Where the distance vanishes the arm could move on to either side.
    let through = accepted(&arm("0.5m - 1m_s * t", "range t in 0s..0.6s;").replace("120deg", "150deg"));
    let remarks = through.motion.remarks;
    assert!(remarks.len() == 1 && remarks[0].starts_with("two assemblies meet at t = 0.5 s, `push` at "), "{remarks:?}");
}

#[test]
fn the_second_loop_of_a_six_bar_stops_the_first() {
    let rocker = |[ground, crank, coupler, rocker]: [f64; 4], angle: f64| {
        let (x, y) = (crank * angle.cos() - ground, crank * angle.sin());
        let reach = x.hypot(y);
        let share = (rocker * rocker + reach * reach - coupler * coupler) / (2.0 * rocker * reach);
        y.atan2(x) - share.acos()
    };
    let mut random = Random(0x1234_5678_9abc_def1);
    let mut stopped = 0;
    while stopped < 30 {
        let first = [random.between(350.0, 420.0), random.between(60.0, 120.0), random.between(300.0, 400.0), random.between(250.0, 350.0)];
        let second = [random.between(300.0, 500.0), first[3], random.between(150.0, 450.0), random.between(150.0, 300.0)];
        let grashof = first.iter().copied().fold(0.0, f64::max) + first[1] < first.iter().sum::<f64>() / 2.0 - 10.0;
        // The second loop is driven by the rocker of the first.
        let reach = |time: f64| {
            let angle = rocker(first, time);
            (second[0] * second[0] + second[1] * second[1] - 2.0 * second[0] * second[1] * angle.cos()).sqrt()
        };
        let room = |time: f64| (second[2] + second[3] - reach(time)).min(reach(time) - (second[2] - second[3]).abs());
        if !grashof || room(0.0) < 5.0 {
            continue;
        }
        let steps = 2000;
        let at = |step: i32| core::f64::consts::TAU * f64::from(step) / f64::from(steps);
        // Near-tangent cases are not part of this test.
        if (1..steps).map(at).any(|time| room(time).abs() < 0.05 && room(time - 0.02).signum() == room(time + 0.02).signum()) {
            continue;
        }
        let Some(step) = (1..steps).find(|step| room(at(*step)) < 0.0) else { continue };
        let (mut low, mut high) = (at(step - 1), at(step));
        for _ in 0..60 {
            let middle = (low + high) / 2.0;
            (low, high) = if room(middle) > 0.0 { (middle, high) } else { (low, middle) };
        }
        let [g, a, b, c] = first;
        let [h, _, d, e] = second;
        let source = format!(
            "mechanism Six {{ ground {{ point C = ({g}mm, 0mm); point F = ({g}mm + {h}mm, 0mm); }} body crank {{ point A = ({a}mm, 0mm); }}
                body coupler {{ point B = ({b}mm, 0mm); }} body rocker {{ point B = ({c}mm, 0mm); start angle = {angle}rad; }}
                body rod {{ point D = ({d}mm, 0mm); }} body lever {{ point D = ({e}mm, 0mm); start angle = 80deg; }}
                joint o = revolute(ground.position, crank.position); joint p = revolute(crank.A, coupler.position);
                joint q = revolute(coupler.B, rocker.B); joint r = revolute(ground.C, rocker.position);
                joint s = revolute(rocker.B, rod.position); joint u = revolute(rod.D, lever.D); joint v = revolute(lever.position, ground.F);
                drive input = drive_angle(crank, 1rad_s * t); }}",
            angle = rocker(first, 0.0)
        );
        let (time, _) = end(&refused(&source));
        assert!((time - low).abs() <= 1e-9 * low.max(1.0), "{time} s instead of {low} s in {source}");
        stopped += 1;
    }
}

#[test]
fn a_change_point_is_noted_and_not_refused() {
    let source = four_bar([400.0, 100.0, 400.0, 100.0], 45.0, "start angle = 45deg;");
    let followed = accepted(&source).motion;
    assert_eq!(followed.remarks, ["two assemblies meet at t = 2.356 s, `crank` at 180°"]);
}

/// Adds a range of one second.
fn ranged(source: &str) -> String {
    source.replace("drive input", "range t in 0s..1s; drive input")
}

#[test]
fn what_is_not_wanted_is_not_looked_at() {
    let locked = four_bar([400.0, 300.0, 100.0, 350.0], 60.0, "start angle = 110deg;");
    let (time, _) = end(&refused(&locked));
    // Without a declared range, less than a turn may be meant.
    let warned = accepted(&locked).motion;
    assert!(warned.warning.is_some());
    for allowed in [locked.clone(), format!("#[closure(allow)] {locked}"), format!("#[closure(allow)] {}", ranged(&locked))] {
        let followed = accepted(&allowed).motion;
        assert!(followed.remarks[0].starts_with(&format!("`crank` stops at 78.58° at t = {time:.4} s")), "{followed:?}");
    }
    assert!((end(&super::refused(&ranged(&locked))).0 - time).abs() <= 1e-12);
    for word in ["start", "off"] {
        let followed = accepted(&format!("#[closure({word})] {locked}")).motion;
        assert!(followed.remarks.is_empty() && followed.warning.is_none() && followed.reached == [0.0; 2], "{followed:?}");
    }
}

#[test]
fn bounds_at_whose_corners_a_mechanism_locks_are_noted() {
    let source = four_bar([400.0, 100.0, 350.0, 300.0], 30.0, "start angle = 80deg;")
        .replace("mechanism FourBar {", "mechanism FourBar { param length: Length = 350mm in 320mm..=450mm;")
        .replace("point B = (350mm, 0mm)", "point B = (length, 0mm)");
    assert_eq!(accepted(&source.replace("450mm", "380mm")).motion.remarks, [""; 0]);
    // At 610 mm coupler and rocker are folded when the end of the crank is 310 mm from the rocker's pivot: at −22.52°.
    let followed = accepted(&source.replace("450mm", "610mm")).motion;
    assert_eq!(followed.remarks.len(), 1);
    assert!(followed.remarks[0].starts_with("with `length` = 610 mm, `crank` stops at 337.5° at t = 5.367 s"), "{followed:?}");
    assert_eq!(followed.reached, [0.0, core::f64::consts::TAU]);
}
