//! Laws and equations whose speeds jump: what follows from forces is struck, unless nothing with a mass is.

use reuleaux::{Integrator, Stopped, mechanism};

mechanism! {
    /// A pendulum on a trolley that is set in motion at t = 1 s, and a pointer without a mass.
    pub(crate) mechanism Crane {
        param speed: Velocity = 2m_s;
        param begin: Time = 1s;
        param start: Angle = 0.2rad;
        param flywheel: Inertia = 0kgm2;
        gravity = (0, -9.81m_s2);
        body bob { mass = 1kg;  center = (0m, -1m);  inertia = 0.01kgm2; }
        body pointer { }
        body near { }
        body heavy { inertia = flywheel; }
        joint rail = absolute_y(bob.position, 0m);
        joint pin = revolute((5m, 0m), pointer.position);
        drive trolley = drive_x(bob.position, speed * 1s * linear((t - begin) / 1s));
        joint other = revolute((6m, 0m), near.position);
        joint shaft = revolute((7m, 0m), heavy.position);
        drive hand = drive_angle(pointer, 1rad * abs(sin(t * 3rad_s)));
        drive second = drive_angle(near, 10rad_s * abs(t - 1.0001s));
        drive engine = drive_angle(heavy, 100rad_s * t);
        freedom swing = bob.angle from start;
    }
}

mechanism! {
    /// Two wheels whose ratio changes where the first has turned by one rad.
    pub(crate) mechanism Geared {
        param ratio: Number = 3;
        body a { inertia = 1kgm2;  mass = 1kg; }
        body c { inertia = 1kgm2;  mass = 1kg; }
        joint p = revolute((0m, 0m), a.position);
        joint q = revolute((1m, 0m), c.position);
        joint g = { c.angle == if a.angle < 1rad { a.angle } else { ratio * a.angle + (1rad - ratio * 1rad) }; }
        freedom f = a.angle from 0rad at 1rad_s;
    }
}

mechanism! {
    /// A skate whose drives leave nothing to forces; it turns back with a jump.
    #[integrated]
    pub(crate) mechanism Skate {
        body blade { axis edge = (1, 0);  mass = 3kg;  inertia = 0.2kgm2; }
        joint ice = { cross(blade.edge, rate(blade.position)) == 0m_s; }
        drive along = { dot(blade.edge, rate(blade.position)) == 2m_s; }
        drive about = drive_angle(blade, 0.5rad_s * abs(t - 1s));
    }
}

mechanism! {
    /// A drive whose acceleration jumps, and its speed does not.
    pub(crate) mechanism Smooth {
        param begin: Time = 1s;
        param size: Acceleration = 2m_s2;
        param start: Angle = 0.2rad;
        gravity = (0, -9.81m_s2);
        body bob { mass = 1kg;  center = (0m, -1m);  inertia = 0.01kgm2; }
        joint rail = absolute_y(bob.position, 0m);
        drive trolley = drive_x(bob.position, if t < begin { 0m } else { 0.5 * size * (t - begin)^2 });
        freedom swing = bob.angle from start;
    }
}

/// The trolley jerks the pendulum; that the pointer turns back does not matter.
#[test]
fn a_law_that_jerks_a_pendulum_is_refused() {
    for tolerance in [1e-5, 1e-8, 1e-11] {
        for until in [&[3.0][..], &[1.0, 3.0], &[0.7, 1.3]] {
            let crane = Crane::default();
            let mut state = crane.initial_state().expect("a state");
            let mut integrator = Integrator::new(tolerance);
            let stopped = until.iter().find_map(|time| crane.advance(&mut state, *time, &mut integrator).err()).expect("a jump");
            let Stopped::SpeedJumps { time, owner, coordinate } = stopped else { panic!("{stopped}") };
            assert!((time - 1.0).abs() < 1e-12 && owner == "bob" && coordinate == "x", "{stopped}");
            assert!(state.t <= 1.0);
        }
        let still = Crane { speed: 0.0, ..Crane::default() };
        let mut state = still.initial_state().expect("a state");
        still.advance(&mut state, 3.0, &mut Integrator::new(tolerance)).expect("nothing with a mass is struck");
    }
    // Initial values are those after a jump at t = 0.
    let moving = Crane { begin: 0.0, ..Crane::default() };
    let mut state = moving.initial_state().expect("a state");
    moving.advance(&mut state, 0.9, &mut Integrator::new(1e-8)).expect("a motion from speed to speed");
    let stopped = moving.advance(&mut state, 1.1, &mut Integrator::new(1e-8)).expect_err("the trolley stops");
    assert!(matches!(stopped, Stopped::SpeedJumps { time, .. } if (time - 1.0).abs() < 1e-12), "{stopped}");
}

/// The jump is as large for a pendulum at rest and beside a heavy flywheel.
#[test]
fn a_jump_is_found_from_any_speed_and_beside_any_mass() {
    for start in [0.0, 1e-12, 1e-8, 1e-3, 1.0] {
        for flywheel in [0.0, 1e3, 1e5] {
            let crane = Crane { start, flywheel, ..Crane::default() };
            let mut state = crane.initial_state().expect("a state");
            let stopped = crane.advance(&mut state, 3.0, &mut Integrator::new(1e-9)).expect_err("a jump");
            assert!(matches!(stopped, Stopped::SpeedJumps { time, .. } if (time - 1.0).abs() < 1e-12), "{start}, {flywheel}: {stopped}");
        }
        let single = Crane::<f32> { start: start as f32, ..Crane::with_defaults() };
        let mut state = single.initial_state().expect("a state");
        let stopped = single.advance(&mut state, 3.0, &mut Integrator::new(1e-4)).expect_err("a jump");
        assert!(matches!(stopped, Stopped::SpeedJumps { time, .. } if (time - 1.0).abs() < 1e-5), "{start}: {stopped}");
    }
}

/// An event just before the jump is reached.
#[test]
fn an_event_before_a_jump_is_found() {
    for before in [1e-1, 1e-4, 1e-9] {
        let crane = Crane::default();
        let mut state = crane.initial_state().expect("a state");
        let at = 1.0 - before;
        let found = crane.advance_until(&mut state, 3.0, &mut Integrator::new(1e-9), |state| state.t - at);
        assert!(found.expect("a motion") && (state.t - at).abs() < 1e-15, "{}", state.t);
        let stopped = crane.advance_until(&mut state, 3.0, &mut Integrator::new(1e-9), |state| state.t - 2.0).expect_err("a jump");
        assert!(matches!(stopped, Stopped::SpeedJumps { .. }), "{stopped}");
    }
}

/// Only the acceleration jumps, at any time and however still the pendulum hangs, in numbers of both sizes.
#[test]
fn laws_without_jumps_of_speed_are_followed() {
    for begin in [1.0, 10.0, 100.0] {
        for size in [0.1, 30.0] {
            for start in [0.0, 1e-6, 0.3] {
                let smooth = Smooth { begin, size, start };
                let mut state = smooth.initial_state().expect("a state");
                smooth.advance(&mut state, begin + 0.5, &mut Integrator::new(1e-9)).expect("a motion");
                let smooth = Smooth::<f32> { begin: begin as f32, size: size as f32, start: start as f32 };
                let mut state = smooth.initial_state().expect("a state");
                match smooth.advance(&mut state, begin as f32 + 0.5, &mut Integrator::new(1e-3)) {
                    // In `f32` a step at 100 s may be too short.
                    Ok(()) | Err(Stopped::StepTooShort { .. }) => {}
                    Err(stopped) => panic!("{begin}, {size}, {start}: {stopped}"),
                }
            }
        }
    }
}

#[test]
fn a_ratio_that_jumps_is_refused() {
    for tolerance in [1e-5, 1e-9] {
        let geared = Geared::default();
        let mut state = geared.initial_state().expect("a state");
        let stopped = geared.advance(&mut state, 2.0, &mut Integrator::new(tolerance)).expect_err("a jump");
        let Stopped::SpeedJumps { time, owner: "c", coordinate: "angle" } = stopped else { panic!("{stopped}") };
        assert!((time - 1.0).abs() < 1e-9, "{stopped}");
        let mut state = geared.initial_state().expect("a state");
        geared.advance(&mut state, 0.999, &mut Integrator::new(tolerance)).expect("a motion up to there");
        let stopped = geared.step(&mut state, 0.01).expect_err("a jump in a single step");
        assert!(matches!(stopped, Stopped::SpeedJumps { .. }), "{stopped}");
        let even = Geared { ratio: 1.0 };
        let mut state = even.initial_state().expect("a state");
        even.advance(&mut state, 2.0, &mut Integrator::new(tolerance)).expect("a motion");
        assert!((state.c().angle - 2.0).abs() < 1e-9);
    }
}

#[test]
fn where_drives_leave_nothing_to_forces_speeds_may_jump() {
    let skate = Skate::default();
    let mut state = skate.initial_state().expect("a state");
    skate.advance(&mut state, 2.0, &mut Integrator::new(1e-9)).expect("a motion");
    // Out and back on two arcs of one radius, v / ω = 4 m, from 0.5 rad to 0 and back.
    let wanted = 2.0 * 4.0 * 0.5_f64.sin();
    assert!((state.blade().angle - 0.5).abs() < 1e-12 && (state.blade().position.x - wanted).abs() < 1e-8, "{}", state.blade().position);
}

/// A kink in the law of the speed is none in the speed: (m c² + I) φ̈ = −m c (g sin φ + ẍ cos φ).
#[test]
fn an_acceleration_that_jumps_is_followed() {
    let smooth = Smooth::default();
    let mut state = smooth.initial_state().expect("a state");
    smooth.advance(&mut state, 3.0, &mut Integrator::new(1e-10)).expect("a motion");
    // Runge and Kutta's method, with the jump between two steps.
    let of = |t: f64, [angle, rate]: [f64; 2]| {
        let pull = if t < 1.0 { 0.0 } else { 2.0 };
        [rate, -(9.81 * angle.sin() + pull * angle.cos()) / 1.01]
    };
    let mut y = [0.2, 0.0];
    let h = 1.0 / 4096.0;
    for step in 0..3 * 4096 {
        // Evaluated between the ends, so that no stage lies across the jump.
        let t = (f64::from(step) + 0.5) * h;
        let moved = |k: [f64; 2], part: f64| [y[0] + part * h * k[0], y[1] + part * h * k[1]];
        let one = of(t, y);
        let two = of(t, moved(one, 0.5));
        let three = of(t, moved(two, 0.5));
        let four = of(t, moved(three, 1.0));
        for i in 0..2 {
            y[i] += h / 6.0 * (one[i] + 2.0 * two[i] + 2.0 * three[i] + four[i]);
        }
    }
    assert!((state.bob().angle - y[0]).abs() < 1e-9, "{} for {}", state.bob().angle, y[0]);
}

mechanism! {
    /// A blade on ice whose speed jumps, and whose edge turns.
    #[integrated]
    pub(crate) mechanism Hurried {
        param first: Velocity = 2m_s;
        param second: Velocity = 1m_s;
        param turning: AngularVelocity = 0rad_s;
        body blade { axis edge = (1, 0); }
        joint ice = { cross(blade.edge, rate(blade.position)) == 0m_s; }
        drive push = { dot(blade.edge, rate(blade.position)) == if t < 0.5s { first } else { second }; }
        drive turn = drive_angle(blade, turning * t);
    }
}

/// No mass feels the jump of a speed that is driven.
#[test]
fn a_speed_that_is_driven_may_jump() {
    for (first, second) in [(2.0, 1.0), (2.0, 1.99), (-3.0, 5.0)] {
        for tolerance in [1e-5, 1e-9, 1e-12] {
            let hurried = Hurried { first, second, ..Default::default() };
            let mut state = hurried.initial_state().expect("a state");
            hurried.advance(&mut state, 1.0, &mut Integrator::new(tolerance)).unwrap_or_else(|stopped| panic!("{second}: {stopped}"));
            let right = 0.5 * (first + second);
            assert!((state.blade().position.x - right).abs() < 1e-14, "{first}, {second}: {}", state.blade().position.x);
        }
    }
    // In a sweep, and until a place is passed.
    let hurried = Hurried::default();
    let times = [0.25, 0.5, 0.75, 1.0];
    let places = hurried.sweep(times, Integrator::new(1e-9)).map(|state| state.expect("a motion").blade().position.x);
    assert!(places.zip([0.5, 1.0, 1.25, 1.5]).all(|(found, right)| (found - right).abs() < 1e-14));
    let mut state = hurried.initial_state().expect("a state");
    let event = |state: &HurriedState<f64>| state.blade().position.x - 1.25;
    let is_found = hurried.advance_until(&mut state, 2.0, &mut Integrator::new(1e-9), event).expect("a motion");
    assert!(is_found && (state.t - 0.75).abs() < 1e-14, "{}", state.t);
    // Along an arc: the chord of each half.
    let (w, first, second) = (0.8, 2.0, 1.0);
    let hurried = Hurried { first, second, turning: w };
    let mut state = hurried.initial_state().expect("a state");
    hurried.advance(&mut state, 1.0, &mut Integrator::new(1e-12)).expect("a motion");
    let middle = 0.5 * w;
    let right = (first * f64::sin(middle) + second * (w.sin() - f64::sin(middle))) / w;
    assert!((state.blade().position.x - right).abs() < 1e-11, "{}, not {right}", state.blade().position.x);
}
