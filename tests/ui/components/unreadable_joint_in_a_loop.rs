reuleaux::mechanism! {
    pub mechanism Pendulums {
        ground { point O = (0m, 0m); }
        for i in 0..2 {
            param speed[i]: AngularVelocity = 60rpm;
            body arm[i] { point O = (0m, 0m); mass = 1kg; inertia = 1kgm2; }
            joint pin[i] = revolute(ground.O arm[i].O);
            slice drive motor[i] = drive_angle(arm[i], speed[i] * t);
        }
    }
}

fn main() {
    let pendulums = Pendulums { speed: [1.0, 2.0] };
    let state = pendulums.solve(0.1).unwrap();
    let loads = pendulums.loads(&state);
    let _ = [loads.pin_0().force.x, loads.motor_1().effort, pendulums.load_of_motor_1(&state).power];
    let _ = [state.arm()[1].angle, pendulums.energy(&state).kinetic];
}
