//! Mechanisms called like type parameters of generated code.

#![deny(warnings)]

mod called_t2 {
    reuleaux::mechanism! {
        pub mechanism T2 {
            param length: Length = 1m;
            component Rod(at: Point) {
                param speed: AngularVelocity = 1rad_s;
                body rod { point A = (length, 0m); mass = 1kg; inertia = 1kgm2; }
                joint axle = revolute(at, rod.position);
                slice drive turn = drive_angle(rod, speed * t);
                slice output tip = rod.A;
            }
            part rod = Rod(ground.position);
        }
    }
}

mod called_t3 {
    reuleaux::mechanism! {
        pub mechanism T3 {
            param length: Length = 1m;
            component Rod(at: Point) {
                param speed: AngularVelocity = 1rad_s;
                body rod { point A = (length, 0m); mass = 1kg; inertia = 1kgm2; }
                joint axle = revolute(at, rod.position);
                slice drive turn = drive_angle(rod, speed * t);
                slice output tip = rod.A;
            }
            part rod = Rod(ground.position);
        }
    }
}

mod called_lanes {
    reuleaux::mechanism! {
        pub mechanism LANES {
            param length: Length = 1m;
            component Rod(at: Point) {
                param speed: AngularVelocity = 1rad_s;
                body rod { point A = (length, 0m); mass = 1kg; inertia = 1kgm2; }
                joint axle = revolute(at, rod.position);
                slice drive turn = drive_angle(rod, speed * t);
                slice output tip = rod.A;
            }
            part rod = Rod(ground.position);
        }
    }
}

mod called_i {
    reuleaux::mechanism! {
        pub mechanism I {
            param length: Length = 1m;
            component Rod(at: Point) {
                param speed: AngularVelocity = 1rad_s;
                body rod { point A = (length, 0m); mass = 1kg; inertia = 1kgm2; }
                joint axle = revolute(at, rod.position);
                slice drive turn = drive_angle(rod, speed * t);
                slice output tip = rod.A;
            }
            part rod = Rod(ground.position);
        }
    }
}

mod called_s {
    reuleaux::mechanism! {
        pub mechanism S {
            param length: Length = 1m;
            component Rod(at: Point) {
                param speed: AngularVelocity = 1rad_s;
                body rod { point A = (length, 0m); mass = 1kg; inertia = 1kgm2; }
                joint axle = revolute(at, rod.position);
                slice drive turn = drive_angle(rod, speed * t);
                slice output tip = rod.A;
            }
            part rod = Rod(ground.position);
        }
    }
}

mod called_state {
    reuleaux::mechanism! {
        pub mechanism State {
            param length: Length = 1m;
            component Rod(at: Point) {
                param speed: AngularVelocity = 1rad_s;
                body rod { point A = (length, 0m); mass = 1kg; inertia = 1kgm2; }
                joint axle = revolute(at, rod.position);
                slice drive turn = drive_angle(rod, speed * t);
                slice output tip = rod.A;
            }
            part rod = Rod(ground.position);
        }
    }
}

mod called_loads {
    reuleaux::mechanism! {
        pub mechanism Loads {
            param length: Length = 1m;
            component Rod(at: Point) {
                param speed: AngularVelocity = 1rad_s;
                body rod { point A = (length, 0m); mass = 1kg; inertia = 1kgm2; }
                joint axle = revolute(at, rod.position);
                slice drive turn = drive_angle(rod, speed * t);
                slice output tip = rod.A;
            }
            part rod = Rod(ground.position);
        }
    }
}

mod called_real {
    reuleaux::mechanism! {
        pub mechanism Real {
            param length: Length = 1m;
            component Rod(at: Point) {
                param speed: AngularVelocity = 1rad_s;
                body rod { point A = (length, 0m); mass = 1kg; inertia = 1kgm2; }
                joint axle = revolute(at, rod.position);
                slice drive turn = drive_angle(rod, speed * t);
                slice output tip = rod.A;
            }
            part rod = Rod(ground.position);
        }
    }
}

fn main() {
    let mechanism = called_t2::T2::default();
    let state = mechanism.solve(0.5).unwrap();
    assert_eq!(mechanism.rod_tip(&state).value.x, 0.5_f64.cos());
    assert_eq!(mechanism.loads(&state).rod_turn().effort, 0.0);
    let mechanism = called_t3::T3::default();
    let state = mechanism.solve(0.5).unwrap();
    assert_eq!(mechanism.rod_tip(&state).value.x, 0.5_f64.cos());
    assert_eq!(mechanism.loads(&state).rod_turn().effort, 0.0);
    let mechanism = called_lanes::LANES::default();
    let state = mechanism.solve(0.5).unwrap();
    assert_eq!(mechanism.rod_tip(&state).value.x, 0.5_f64.cos());
    assert_eq!(mechanism.loads(&state).rod_turn().effort, 0.0);
    let mechanism = called_i::I::default();
    let state = mechanism.solve(0.5).unwrap();
    assert_eq!(mechanism.rod_tip(&state).value.x, 0.5_f64.cos());
    assert_eq!(mechanism.loads(&state).rod_turn().effort, 0.0);
    let mechanism = called_s::S::default();
    let state = mechanism.solve(0.5).unwrap();
    assert_eq!(mechanism.rod_tip(&state).value.x, 0.5_f64.cos());
    assert_eq!(mechanism.loads(&state).rod_turn().effort, 0.0);
    let mechanism = called_state::State::default();
    let state = mechanism.solve(0.5).unwrap();
    assert_eq!(mechanism.rod_tip(&state).value.x, 0.5_f64.cos());
    assert_eq!(mechanism.loads(&state).rod_turn().effort, 0.0);
    let mechanism = called_loads::Loads::default();
    let state = mechanism.solve(0.5).unwrap();
    assert_eq!(mechanism.rod_tip(&state).value.x, 0.5_f64.cos());
    assert_eq!(mechanism.loads(&state).rod_turn().effort, 0.0);
    let mechanism = called_real::Real::default();
    let state = mechanism.solve(0.5).unwrap();
    assert_eq!(mechanism.rod_tip(&state).value.x, 0.5_f64.cos());
    assert_eq!(mechanism.loads(&state).rod_turn().effort, 0.0);
}
