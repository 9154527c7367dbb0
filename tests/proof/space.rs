//! Enclosures of bodies in space, beside whose rotation matrix a state holds ω and ω̇, and of outputs that are velocities or have a jerk.

use reuleaux::nalgebra::SVector;
use reuleaux::{Enclosure, Family, Mechanism, Stages, State, mechanism};

mechanism! {
    /// A wheel on a hinge: its orientation is computed.
    mechanism Wheel in space {
        ground { axis x = (1, 0, 0); }
        body wheel { axis x = (1, 0, 0); }
        joint bearing = revolute(ground.position, ground.x, wheel.position, wheel.x);
        drive motor = drive_rotation(bearing, 1rad_s * t + 0.25rad_s2 * t^2);
        slice output alone = wheel;
    }
}

mechanism! {
    /// A plate on six rods: its quaternion is iterated.
    mechanism Plate in space {
        param a: Length = 300mm;
        body plate {
            start position = (0mm, 0mm, 300mm);
            point P[0] = (100mm, 0mm, 0mm);  point P[1] = (100mm, 10mm, 0mm);  point P[2] = (-50mm, 90mm, 0mm);
            point P[3] = (-60mm, 85mm, 0mm);  point P[4] = (-50mm, -90mm, 0mm);  point P[5] = (-45mm, -95mm, 0mm);
        }
        drive d[0] = drive_distance((150mm, -100mm, 0mm), plate.P[0], a + 20mm * sin(1rad_s * t));
        drive d[1] = drive_distance((150mm, 100mm, 0mm), plate.P[1], a + 20mm * sin(2rad_s * t));
        drive d[2] = drive_distance((10mm, 180mm, 0mm), plate.P[2], a - 15mm * sin(1rad_s * t));
        drive d[3] = drive_distance((-160mm, 80mm, 0mm), plate.P[3], a + 10mm * sin(3rad_s * t));
        drive d[4] = drive_distance((-160mm, -80mm, 0mm), plate.P[4], a);
        drive d[5] = drive_distance((10mm, -180mm, 0mm), plate.P[5], a + 20mm * sin(1rad_s * t));
    }
}

mechanism! {
    /// Outputs that are no coordinates.
    mechanism Press {
        body lever { point A = (80mm, 0mm); }
        body link { point B = (250mm, 0mm); }
        body ram { }
        joint pivot = revolute(ground.position, lever.position);
        joint pin = revolute(lever.A, link.position);
        joint eye = revolute(link.B, ram.position);
        joint bed = translational((1, 0), ground.position, ram.position);
        drive hand = drive_angle(lever, 20deg + 1rad_s * t + 0.3rad * sin(2rad_s * t));
        slice output advantage = rate(lever.angle) / rate(ram.x);
        slice output jerky = ram.x with jerk;
        slice output speed = rate(link.B);
    }
}

/// Bounds are about rounding errors, and a polished state differs by as much; both also for a state that is off.
fn is_bounded_and_polished<M, const N: usize>(mechanism: &M, state: &State<f64, N>)
where
    M: Mechanism<f64, N> + Family<f64>,
    M::Over<Enclosure>: Stages<Enclosure, N>,
{
    let within = |one: &SVector<f64, N>, other: &SVector<f64, N>, allowed: f64| {
        let size = one.amax().max(1.0);
        one.iter().zip(other).all(|(one, other)| (one - other).abs() <= allowed * size)
    };
    let bound = mechanism.error_bound(state).expect("bounds");
    let none = SVector::<f64, N>::from_element(0.0);
    assert!([&bound.q, &bound.qd, &bound.qdd].into_iter().all(|bound| within(&none, bound, 1e-13)), "{bound:?}");
    assert_eq!(mechanism.certify(state).expect("a certificate").within, bound);

    let mut polished = state.clone();
    mechanism.polish(&mut polished).expect("digits");
    let pairs = [(&state.q, &polished.q), (&state.qd, &polished.qd), (&state.qdd, &polished.qdd)];
    assert!(pairs.into_iter().all(|(one, other)| within(one, other, 1e-13)), "{state:?}, polished {polished:?}");

    let off = 1e-7;
    let mut other = State::new(state.t, state.q, state.qd, state.qdd.map(|entry| entry + off));
    let bound = mechanism.error_bound(&other).expect("bounds");
    assert!(bound.qdd.iter().all(|bound| (bound - off).abs() < 1e-11), "{bound:?}");
    mechanism.polish(&mut other).expect("digits");
    assert!(within(&state.qdd, &other.qdd, 1e-13), "{:?}, not {:?}", other.qdd, state.qdd);
}

#[test]
fn bodies_in_space_keep_their_angular_velocity() {
    for t in [0.0, 0.5, 1.7] {
        let (wheel, plate) = (Wheel::default(), Plate::default());
        let state = wheel.solve(t).expect("a state");
        is_bounded_and_polished(&wheel, &state);
        is_bounded_and_polished(&plate, &plate.solve(t).expect("a state"));
        let slice = wheel.solve_for_alone();
        is_bounded_and_polished(&slice, &slice.solve(t).expect("a state"));
        let mut polished = state.clone();
        wheel.polish(&mut polished.0).expect("digits");
        assert!((polished.wheel().angular_velocity.x - 1.0 - 0.5 * t).abs() < 1e-15 && polished.wheel().angular_acceleration.x == 0.5);
    }
}

#[test]
fn outputs_of_slices_keep_their_velocities_and_jerks() {
    let press = Press::default();
    for t in [0.3, 0.7, 1.9] {
        let slice = press.solve_for_advantage();
        is_bounded_and_polished(&slice, &slice.solve(t).expect("a state"));
        let slice = press.solve_for_jerky();
        is_bounded_and_polished(&slice, &slice.solve(t).expect("a state"));
        let slice = press.solve_for_speed();
        is_bounded_and_polished(&slice, &slice.solve(t).expect("a state"));
    }
}
