//! Accelerations and loads of states whose parameters or speeds were changed.

use reuleaux::mechanism;

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
