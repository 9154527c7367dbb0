reuleaux::mechanism! {
    pub mechanism Pendulum {
        gravity = (0, -9.81m_s2);
        ground { point O = (0m, 0m); }
        body arm { point O = (0m, 0m); point E = (1m, 0m); mass = 1kg; inertia = 1kgm2; }
        joint pin = revolute(ground.O, arm.O);
        drive turn = drive_angle(arm, 60rpm * t);
        force push = { at arm.E: -100N, 0N; }
    }
}

fn main() {
    let pendulum = Pendulum::default();
    let state = pendulum.solve(0.1).unwrap();
    let loads = pendulum.loads(&state);
    let _ = [loads.pin().force.x, loads.turn().effort, pendulum.energy(&state).kinetic];
    let _ = [loads.push().forces[0].x, loads.push().power];
}
