//! Accelerations, loads and motions of states that were changed, or whose parameters were.

use reuleaux::{Integrator, Stopped, mechanism};

mechanism! {
    /// A weight on a rod that is carried by another one.
    mechanism Rods {
        param length: Length = 0.5m;
        param speed: AngularVelocity = 2rad_s;
        gravity = (0, -10m_s2);
        body upper { point E = (length, 0m); }
        body lower { mass = 1kg;  center = (0.5m, 0m); }
        joint shoulder = revolute(ground.position, upper.position);
        joint elbow = weld(upper.E, lower.position);
        freedom swing = upper.angle from 0rad at speed;
    }
}

/// A weight of 1 kg, a rod's length and 0.5 m away: r φ̈ = −g cos φ, and the shoulder bears m (g sin φ + r φ̇²) along the rod.
#[test]
fn accelerations_and_loads_are_those_of_other_parameters_and_speeds() {
    let short = Rods::default();
    let mut state = short.initial_state().unwrap();
    // Other parameters alone, other speeds alone, and both.
    for (length, speed, is_touched) in [(0.5, 2.0, false), (1.5, 2.0, false), (1.5, -3.0, true), (0.8, 4.0, true)] {
        let rods = Rods { length, speed: 2.0 };
        if is_touched {
            state.0.qd[2] = speed;
        }
        let loads = rods.accelerate_with_loads(&mut state).unwrap();
        let radius = length + 0.5;
        let lower = state.lower();
        assert_eq!((lower.position.x, lower.velocity.y), (length, length * speed));
        assert!((lower.angular_acceleration + 10.0 / radius).abs() < 1e-14, "{lower:?}");
        assert!((lower.acceleration.x + length * speed * speed).abs() < 1e-13, "{lower:?}");
        let force = loads.shoulder().force;
        assert!((force.x + radius * speed * speed).abs() < 1e-13 && force.y.abs() < 1e-13, "{force}");
    }
}

mechanism! {
    /// A weight on a slope of 3 : 4, whose height is the freedom.
    mechanism Slope {
        gravity = (0, -9.81m_s2);
        body weight { mass = 2kg; }
        joint slope = translational((0.6, 0.8), (0m, 0m), weight.position);
        freedom height = weight.y from 1m;
    }
}

/// g sin² α is the acceleration of the height.
#[test]
fn a_weight_on_a_slope_rebounds() {
    let (slope, fall) = (Slope::default(), 9.81 * 0.64);
    let (mut state, mut integrator) = (slope.initial_state().unwrap(), Integrator::new(1e-9));
    assert!(slope.advance_until(&mut state, 5.0, &mut integrator, |state| state.weight().position.y).unwrap());
    let speed = (2.0_f64 * fall).sqrt();
    assert!((state.weight().velocity.y + speed).abs() < 1e-9 && (state.t - speed / fall).abs() < 1e-9);
    state.0.qd[1] = speed;
    slope.accelerate(&mut state).unwrap();
    assert!((state.weight().velocity.y - speed).abs() < 1e-15);
    assert!((state.weight().velocity.x - 0.75 * speed).abs() < 1e-15);
    let until = state.t + 0.2;
    slope.advance(&mut state, until, &mut integrator).unwrap();
    assert!((state.weight().position.y - (0.2 * speed - 0.02 * fall)).abs() < 1e-9);
}

mechanism! {
    /// Two wheels in mesh; the freedom is the turn of the second.
    mechanism Wheels {
        param speed: AngularVelocity = 1rad_s;
        body one { mass = 1kg;  inertia = 0.1kgm2; }
        body two { mass = 1kg;  inertia = 0.3kgm2; }
        joint left = revolute(ground.position, one.position);
        joint right = revolute((1m, 0m), two.position);
        joint mesh = gear_pair(one, two, 1, 2);
        freedom turn = two.angle from 0rad at speed;
    }
}

mechanism! {
    /// A nut on a spindle; the freedom is its height.
    mechanism Spindle in space {
        ground { axis z = (0, 0, 1); }
        body spindle { axis z = (0, 0, 1);  mass = 1kg;  inertia = (0.1kgm2, 0.1kgm2, 0.02kgm2); }
        body nut { axis z = (0, 0, 1);  mass = 1kg;  inertia = (0.1kgm2, 0.1kgm2, 0.1kgm2); }
        joint bearing = revolute(ground.position, ground.z, spindle.position, spindle.z);
        joint guide = translational(ground.position, ground.z, nut.position, nut.z);
        joint thread = { nut.position.z == 20mm * (bearing.angle / 360deg); }
        freedom height = nut.position.z from 0m at 0.1m_s;
    }
}

/// Three times the speed of a freedom is nine times the energy.
#[test]
fn speeds_follow_from_a_freedom_that_is_not_integrated() {
    let wheels = Wheels::default();
    let mut state = wheels.initial_state().unwrap();
    let before = wheels.energy(&state).kinetic;
    state.0.qd[5] *= 3.0;
    wheels.accelerate(&mut state).unwrap();
    assert!((state.two().angular_velocity - 3.0).abs() < 1e-15);
    assert!((wheels.energy(&state).kinetic - 9.0 * before).abs() < 1e-14 * before);

    let spindle = Spindle::default();
    let mut state = spindle.initial_state().unwrap();
    let before = spindle.energy(&state).kinetic;
    // Behind x, y and z of the spindle, and x and y of the nut.
    state.0.qd[5] = 0.3;
    // The loads of a state that was changed are those of the settled one.
    spindle.accelerate_with_loads(&mut state).unwrap();
    assert!((state.nut().velocity.z - 0.3).abs() < 1e-15);
    assert!((spindle.energy(&state).kinetic - 9.0 * before).abs() < 1e-13 * before);
}

mechanism! {
    /// A slider-crank without gravity.
    mechanism Engine {
        param rod: Length = 150mm;
        body crank { point A = (50mm, 0mm);  mass = 0.5kg;  inertia = 2e-3kgm2; }
        body conrod { start angle = -20deg;  point B = (rod, 0mm);  mass = 0.3kg;  center = (50mm, 0mm);  inertia = 1e-3kgm2; }
        body piston { mass = 0.4kg; }
        joint main = revolute(ground.position, crank.position);
        joint pin = revolute(crank.A, conrod.position);
        joint wrist = revolute(conrod.B, piston.position);
        joint bore = translational((1, 0), (0m, 0m), piston.position);
        freedom turn = crank.angle from 90deg at 3rad_s;
    }
}

/// A loop is closed again, in its speeds and in its positions.
#[test]
fn a_loop_follows_from_a_freedom_that_was_changed() {
    let engine = Engine::default();
    let (mut state, mut integrator) = (engine.initial_state().unwrap(), Integrator::new(1e-10));
    assert!(engine.advance_until(&mut state, 2.0, &mut integrator, |state| state.piston().position.x - 0.12).unwrap());
    let (before, energy) = (state.clone(), engine.energy(&state).kinetic);
    state.0.qd[2] *= -0.5;
    engine.accelerate(&mut state).unwrap();
    for entry in 0..state.qd.len() {
        let wanted = -0.5 * before.qd[entry];
        assert!((state.qd[entry] - wanted).abs() <= 1e-14 * (1.0 + wanted.abs()), "{entry}: {} {wanted}", state.qd[entry]);
    }
    assert!((engine.energy(&state).kinetic - 0.25 * energy).abs() < 1e-13 * energy);
    // Back to where it was with half of the speed: twice the time.
    let until = state.t + 2.0 * before.t;
    engine.advance(&mut state, until, &mut integrator).unwrap();
    let start = engine.initial_state().unwrap();
    assert!((state.crank().angle - start.crank().angle).abs() < 1e-8, "{}", state.crank().angle);

    // Other positions: (x − r cos φ)² + (r sin φ)² = l².
    let closed = |state: &EngineState, rod: f64| {
        let (x, angle) = (state.piston().position.x, state.crank().angle);
        ((x - 0.05 * angle.cos()).hypot(0.05 * angle.sin()) - rod).abs() < 1e-15
    };
    state.0.q[2] = 2.0;
    engine.accelerate(&mut state).unwrap();
    assert!(state.crank().angle == 2.0 && closed(&state, 0.15));
    // Another rod.
    let longer = Engine { rod: 0.151 };
    let (angle, speed) = (state.crank().angle, state.crank().angular_velocity);
    longer.accelerate(&mut state).unwrap();
    assert!(closed(&state, 0.151) && (state.crank().angle - angle).abs() < 1e-15);
    assert!((state.crank().angular_velocity - speed).abs() < 1e-13);
    let mut unclosed = before.clone();
    let until = before.t + 0.1;
    longer.advance(&mut unclosed, until, &mut integrator).unwrap();
    assert!(closed(&unclosed, 0.151));
    // One that reaches nowhere.
    let mut kept = before.clone();
    let stopped = Engine { rod: 0.02 }.advance(&mut kept, until, &mut integrator).unwrap_err();
    assert!(matches!(stopped, Stopped::StaysOpen { .. }) && stopped.to_string().contains("cannot be closed"), "{stopped}");
    assert_eq!(kept, before);
    // Not a number.
    kept.0.q[2] = f64::NAN;
    assert!(matches!(engine.accelerate(&mut kept), Err(Stopped::NotFinite { .. })));
}

/// The piston strikes, and strikes again: each time the crank keeps nine tenths of its speed.
#[test]
fn a_loop_rebounds_many_times() {
    let engine = Engine::default();
    let (mut state, mut integrator) = (engine.initial_state().unwrap(), Integrator::new(1e-10));
    let mut energy = engine.energy(&state).kinetic;
    let mut before = 0.0;
    for _ in 0..20 {
        let until = state.t + 50.0;
        assert!(engine.advance_until(&mut state, until, &mut integrator, |state| state.piston().position.x - 0.12).unwrap());
        assert!(state.t > before + 1e-3 && (engine.energy(&state).kinetic / energy - 1.0).abs() < 1e-8, "{}", state.t);
        (before, energy) = (state.t, 0.81 * energy);
        state.0.qd[2] *= -0.9;
        engine.accelerate(&mut state).unwrap();
        assert!((engine.energy(&state).kinetic / energy - 1.0).abs() < 1e-8);
    }
}

/// Small changes count in single precision, too.
#[test]
fn a_small_change_counts_in_single_precision() {
    let wheels = Wheels::<f32> { speed: 5e-4 };
    let mut state = wheels.initial_state().unwrap();
    state.0.qd[5] = -4e-4;
    wheels.accelerate(&mut state).unwrap();
    assert!((state.two().angular_velocity + 4e-4).abs() < 1e-10 && (state.one().angular_velocity.abs() - 8e-4).abs() < 1e-9);
    // A rod that is longer by a thousandth.
    let engine = Engine::<f32> { rod: 0.15 };
    let mut state = engine.initial_state().unwrap();
    Engine::<f32> { rod: 0.15015 }.accelerate(&mut state).unwrap();
    let (x, angle) = (state.piston().position.x, state.crank().angle);
    assert!(((x - 0.05 * angle.cos()).hypot(0.05 * angle.sin()) - 0.15015).abs() < 1e-7);
}

mechanism! {
    /// A cart that is driven along its own direction.
    #[integrated]
    mechanism Cart {
        param push: Velocity = 2m_s;
        param turn: AngularVelocity = 0.5rad_s;
        body cart { axis ahead = (1, 0);  mass = 1kg;  inertia = 1kgm2;  start position = (0m, 0m);  start angle = 0rad; }
        joint wheel = { cross(cart.ahead, rate(cart.position)) == 0m_s; }
        drive motor = { dot(cart.ahead, rate(cart.position)) == push; }
        freedom heading = cart.angle from 0rad at turn;
    }
}

/// Along a circle, and then, faster, along one of one and a half times its radius.
#[test]
fn a_driven_speed_may_be_changed_on_the_way() {
    let mut cart = Cart::default();
    let (mut state, mut integrator) = (cart.initial_state().unwrap(), Integrator::new(1e-10));
    cart.advance(&mut state, 1.0, &mut integrator).unwrap();
    cart.push = 3.0;
    cart.advance(&mut state, 2.0, &mut integrator).unwrap();
    let (one, two) = (0.5_f64, 1.0_f64);
    let x = 4.0 * one.sin() + 6.0 * (two.sin() - one.sin());
    let y = 4.0 * (1.0 - one.cos()) + 6.0 * (one.cos() - two.cos());
    let cart = state.cart();
    assert!((cart.position.x - x).abs() < 1e-9 && (cart.position.y - y).abs() < 1e-9, "{cart:?} {x} {y}");
    assert!((cart.velocity.norm() - 3.0).abs() < 1e-13);
}

mechanism! {
    /// A disk, which rolls.
    mechanism Coin in space {
        gravity = (0m_s2, 0m_s2, -9.81m_s2);
        ground { axis n = (0, 0, 1); }
        body coin {
            axis z = (0, 0, 1);  mass = 0.5kg;  inertia = (0.01kgm2, 0.01kgm2, 0.02kgm2);
            start position = (0m, 0m, 0.2m);  start orientation = turn((1, 0, 0), 80deg);
        }
        joint contact = rolling_disk(ground.n, coin.position, coin.z, 0.2m);
        freedom spin = coin.angular_velocity from (0.1rad_s, 0.3rad_s, 3rad_s);
    }
}

#[test]
fn a_coin_goes_on_rolling_when_its_spin_is_changed() {
    let coin = Coin::default();
    let mut state = coin.initial_state().unwrap();
    coin.advance(&mut state, 0.3, &mut Integrator::new(1e-10)).unwrap();
    let (before, energy) = (state.coin(), coin.energy(&state).kinetic);
    // The rates of the four components of its quaternion, which stand behind its position.
    for entry in 3..7 {
        state.0.qd[entry] *= 1.3;
    }
    coin.accelerate(&mut state).unwrap();
    let after = state.coin();
    assert!((after.angular_velocity - 1.3 * before.angular_velocity).norm() < 1e-12);
    assert!((after.velocity - 1.3 * before.velocity).norm() < 1e-12);
    assert!((coin.energy(&state).kinetic - 1.69 * energy).abs() < 1e-12 * energy);
    coin.advance(&mut state, 0.6, &mut Integrator::new(1e-10)).unwrap();
}

/// A call that takes no time computes accelerations anew, too.
#[test]
fn a_call_without_time_counts() {
    let mut rods = Rods::default();
    let mut state = rods.initial_state().unwrap();
    rods.length = 1.5;
    let now = state.t;
    rods.advance(&mut state, now, &mut Integrator::new(1e-9)).unwrap();
    assert!((state.lower().angular_acceleration + 5.0).abs() < 1e-14);
    let states: Vec<_> = rods.sweep_from(&state, [now, now + 1e-9], Integrator::new(1e-9)).map(Result::unwrap).collect();
    assert!((states[0].lower().angular_acceleration - states[1].lower().angular_acceleration).abs() < 1e-6);
}

mechanism! {
    /// A block on a spring whose stiffness has bounds.
    mechanism Bounded {
        param k: Stiffness = 10N_m in 1N_m..=100N_m;
        body block { mass = 1kg; }
        joint rail = translational((1, 0), (0m, 0m), block.position);
        force spring = spring((0m, 0m), block.position, stiffness: k);
        freedom slide = block.x from 1m;
    }
}

/// Also where the state is one of another stiffness.
#[test]
fn a_parameter_out_of_its_bounds_moves_nothing() {
    let (state, weak) = (Bounded::default().initial_state().expect("a state"), Bounded { k: 0.5 });
    let begun = || state.clone();
    let refused = [
        weak.initial_state().err(),
        weak.accelerate(&mut begun()).err(),
        weak.accelerate_with_loads(&mut begun()).err(),
        weak.step(&mut begun(), 0.1).err(),
        weak.advance(&mut begun(), 0.1, &mut Integrator::new(1e-9)).err(),
        weak.sweep_from(&begun(), [0.1], Integrator::new(1e-9)).next().and_then(Result::err),
    ];
    for (number, refused) in refused.into_iter().enumerate() {
        assert!(matches!(refused, Some(Stopped::ParameterOutOfRange(parameter)) if parameter.name == "k"), "{number}: {refused:?}");
    }
}
