//! A mechanism with a freedom and an imported kind, in a crate without the standard library under its name.
#![no_std]

extern crate std as standard;

mod kinds {
    reuleaux::constraint! {
        /// Two points stay together.
        pub(crate) constraint pin(P: Point, Q: Point) {
            P == Q;
        }
    }
}

mod pendulum {
    reuleaux::mechanism! {
        pub(crate) mechanism Pendulum {
            use crate::kinds::pin;
            gravity = (0, -9.81m_s2);
            body bob { mass = 1kg;  center = (0m, -1m);  inertia = 0.1kgm2; }
            joint pivot = pin(ground.position, bob.position);
            freedom swing = bob.angle from 0.1rad;
        }
    }
}

fn main() {
    let pendulum = pendulum::Pendulum::default();
    let mut state = pendulum.initial_state().unwrap();
    pendulum.step(&mut state, 0.01).unwrap();
    assert!(state.bob().angular_velocity < 0.0);
}
