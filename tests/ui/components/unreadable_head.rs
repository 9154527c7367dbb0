reuleaux::mechanism! {
    pub mechanism Pendulums in space {
        ground { point O = (0m, 0m, 0m); axis y = (0, 1, 0); }
        component Pendulum(at Point) {
            body arm { point O = (0m, 0m, 0m); axis y = (0, 1, 0); mass = 1kg; inertia = ball(1m); }
            joint pin = revolute(at, ground.y, arm.O, arm.y);
            slice drive motor = drive_rotation(pin, 60rpm * t);
        }
        part left = Pendulum(ground.O);
    }
}

fn main() {
    let pendulums = Pendulums::default();
    let state = pendulums.solve(0.1).unwrap();
    let loads = pendulums.loads(&state);
    let _ = [loads.left_pin().force.z, loads.left_motor().effort, pendulums.load_of_left_motor(&state).power];
    let _ = state.left().arm().position.z;
}
