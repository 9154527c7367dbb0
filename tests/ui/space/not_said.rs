reuleaux::mechanism! {
    pub mechanism Pendulum {
        ground { point O = (0m, 0m, 0m); axis y = (0, 1, 0); }
        body arm { point O = (0m, 0m, 0m); axis y = (0, 1, 0); mass = 1kg; inertia = ball(1m); }
        joint pin = revolute(ground.O, ground.y, arm.O, arm.y);
        drive turn = drive_rotation(pin, 60rpm * t);
    }
}

fn main() {
    let pendulum = Pendulum::default();
    let state = pendulum.solve(0.1).unwrap();
    let loads = pendulum.loads(&state);
    let _ = [loads.pin().force.x, loads.turn().effort, pendulum.energy(&state).kinetic];
    let _ = [state.arm().position.z, loads.pin().torque.z];
}
