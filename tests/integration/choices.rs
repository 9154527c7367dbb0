//! A long `if` inside of a block that is iterated, in one place and in shared code, with all its derivatives.

use reuleaux::{Stages, mechanism};

/// Where the law changes, in rad, and how the slide goes with the arm.
fn law(angle: f64) -> f64 {
    let wave = |rate: f64| 0.3 + 0.03 * (rate * (angle - 1.0)).sin() * (angle - 1.0).exp();
    if angle < 1.0 { wave(2.0) } else { wave(1.0) }
}

mechanism! {
    /// An arm and a slide, whose places depend on each other by a law in two pieces; a link of changing length moves both.
    mechanism Alone {
        body arm { point A = (0.1m, 0m);  start angle = 50deg; }
        body slide { point P = (0m, 0.1m);  start x = 0.28m; }
        joint axle = revolute(ground.position, arm.position);
        joint guide = translational((1, 0), (0m, 0.1m), slide.P);
        let since = arm.angle / 1rad - 1;
        joint law = {
            slide.x == 0.3m + 30mm * (if arm.angle < 1rad { sin(2 * since) * exp(since) } else { sin(since) * exp(since) });
        }
        drive link = drive_distance(arm.A, slide.P, 0.235m + 20mm * sin(1rad_s * t));
        output x = slide.x with jerk;
    }
}

mechanism! {
    /// The same sixteen times, so that code is shared.
    mechanism Many {
        for i in 0..16 {
            body arm[i] { point A = (0.1m, 0m);  start angle = 50deg; }
            body slide[i] { point P = (0m, 0.1m);  start x = 0.28m; }
            joint axle[i] = revolute(ground.position, arm[i].position);
            joint guide[i] = translational((1, 0), (0m, 0.1m), slide[i].P);
            joint law[i] = {
                slide[i].x == 0.3m + 30mm * (if arm[i].angle < 1rad {
                    sin(2 * (arm[i].angle / 1rad - 1)) * exp(arm[i].angle / 1rad - 1)
                } else {
                    sin(arm[i].angle / 1rad - 1) * exp(arm[i].angle / 1rad - 1)
                });
            }
            drive link[i] = drive_distance(arm[i].A, slide[i].P, 0.235m + 20mm * sin(1rad_s * (t + i * 0.3s)));
        }
    }
}

#[test]
fn both_pieces_are_followed_with_all_derivatives() {
    let alone = Alone::default();
    let mut state = alone.solve(0.0).expect("a state");
    let mut angles = [f64::INFINITY, f64::NEG_INFINITY];
    for k in 0..=60 {
        let t = f64::from(k) / 10.0;
        alone.advance(&mut state, t).expect("a state");
        let (arm, slide) = (state.arm(), state.slide());
        let (sine, cosine) = arm.angle.sin_cos();
        let way = [slide.position.x - 0.1 * cosine, 0.1 - 0.1 * sine];
        assert!((slide.position.x - law(arm.angle)).abs() < 1e-15);
        assert!((way[0].hypot(way[1]) - 0.235 - 0.02 * t.sin()).abs() < 1e-15);
        angles = [angles[0].min(arm.angle), angles[1].max(arm.angle)];
        // The pieces meet at 1 rad, with a kink.
        let h = 1e-4;
        let [before, after] = [t - h, t + h].map(|t| alone.solve_near(t, &state.q).expect("a state"));
        if [&before, &after].iter().any(|other| (other.arm().angle < 1.0) != (arm.angle < 1.0)) {
            continue;
        }
        let [one, two] = [&before, &after].map(|state| alone.x(state));
        let x = alone.x(&state);
        assert!((x.rate - (two.value - one.value) / (2.0 * h)).abs() < 1e-7);
        assert!((x.acceleration - (two.rate - one.rate) / (2.0 * h)).abs() < 1e-6);
        assert!((x.jerk - (two.acceleration - one.acceleration) / (2.0 * h)).abs() < 1e-5);
    }
    assert!(angles[0] < 0.95 && angles[1] > 1.05, "{angles:?}");
}

#[test]
fn shared_code_gives_the_same() {
    let (many, alone) = (Many::default(), Alone::default());
    let mut state = many.solve(0.0).expect("a state");
    let mut each: Vec<_> = (0..16).map(|i| alone.solve(0.3 * f64::from(i)).expect("a state")).collect();
    for k in 1..=60 {
        let t = f64::from(k) / 10.0;
        many.advance(&mut state, t).expect("a state");
        for (i, other) in each.iter_mut().enumerate() {
            alone.advance(other, t + 0.3 * i as f64).expect("a state");
            let (arm, slide) = (state.arm()[i], state.slide()[i]);
            assert!((slide.position.x - law(arm.angle)).abs() < 1e-15);
            assert!((arm.angle - other.arm().angle).abs() < 1e-13);
            assert!((slide.velocity.x - other.slide().velocity.x).abs() < 1e-13);
            assert!((slide.acceleration.x - other.slide().acceleration.x).abs() < 1e-12);
        }
    }
}

mechanism! {
    /// One law reads the other wheel in a condition, the other one in terms that cancel: neither has a derivative by it.
    mechanism Read {
        body reading { }
        body cancelling { }
        body read { }
        joint first = revolute(ground.position, reading.position);
        joint second = revolute((1m, 0m), cancelling.position);
        joint third = revolute((2m, 0m), read.position);
        drive by_condition = drive_angle(reading, (if read.angle < 1rad { 0.1rad } else { 0.2rad }) + 3rad_s * t);
        drive by_terms = drive_angle(cancelling, 2rad_s * t + 0.6 * 0.8 * read.angle - 0.8 * 0.6 * read.angle);
        drive law = drive_angle(read, 1rad_s * t);
    }
}

#[test]
fn a_law_may_depend_on_a_later_drive_without_a_derivative() {
    for t in [0.3, 0.9, 1.1, 2.0] {
        let state = Read::default().solve(t).expect("a state");
        let step = if t < 1.0 { 0.1 } else { 0.2 };
        assert!((state.reading().angle - step - 3.0 * t).abs() < 1e-15 && (state.cancelling().angle - 2.0 * t).abs() < 1e-15);
        assert_eq!(state.reading().angular_velocity, 3.0);
    }
}

mechanism! {
    /// A law in two pieces that meet, chosen by the angle that it drives.
    #[closure(off)]
    mechanism OfItself {
        body b { }
        joint pivot = revolute(ground.position, b.position);
        drive law = drive_angle(b, if b.angle < 1rad { 1rad_s * t } else { 1rad + 2rad_s * (t - 1s) });
    }
}

mechanism! {
    /// Two places by linear equations, one of which is chosen by one of them.
    #[closure(off)]
    mechanism OfBoth {
        param most: Length = 1m;
        body a { }
        body b { }
        joint turned_a = absolute_angle(a, 0);
        joint turned_b = absolute_angle(b, 0);
        joint height_a = absolute_y(a.position, 0m);
        joint height_b = absolute_y(b.position, 0m);
        joint sum = { a.x + b.x == most; }
        drive difference = { a.x - b.x == if a.x > 0.4m { 0.5m + 0.01m_s * t } else { 0.1m + 0.01m_s * t }; }
    }
}

mechanism! {
    /// Two laws that are chosen by each other.
    #[closure(off)]
    mechanism OfEachOther {
        body a { }
        body b { }
        joint pivot_a = revolute(ground.position, a.position);
        joint pivot_b = revolute((1m, 0m), b.position);
        drive law_a = drive_angle(a, (if b.angle < 1rad { 0.1rad } else { 0.2rad }) + 1rad_s * t);
        drive law_b = drive_angle(b, (if a.angle < 0.05rad { 0.3rad } else { 0.9rad }) + 2rad_s * t);
    }
}

/// The only solutions.
#[test]
fn choices_by_unknowns_of_their_own_block_are_solved() {
    for (t, wanted) in [(0.5, [0.5, 1.0]), (1.5, [2.0, 2.0]), (2.0, [3.0, 2.0])] {
        let state = OfItself::default().solve(t).expect("a state");
        assert!((state.b().angle - wanted[0]).abs() < 1e-15 && (state.b().angular_velocity - wanted[1]).abs() < 1e-15, "t = {t}");
    }
    assert!(<OfBoth as Stages<f64, 6>>::UNIQUE.is_empty(), "a choice may have several solutions");
    for most in [1.0_f64, 1.5] {
        let state = OfBoth { most }.solve(0.0).expect("a state");
        let wanted = [most + 0.5, most - 0.5].map(|twice| 0.5 * twice);
        assert!((state.a().position.x - wanted[0]).abs() < 1e-15 && (state.b().position.x - wanted[1]).abs() < 1e-15);
    }
    let state = OfEachOther::default().solve(0.1).expect("a state");
    assert!((state.a().angle - 0.3).abs() < 1e-15 && (state.b().angle - 1.1).abs() < 1e-15);
}
