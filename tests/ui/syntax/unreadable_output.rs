reuleaux::mechanism! {
    pub mechanism Pendulum {
        gravity = (0, -9.81m_s2);
        ground { point O = (0m, 0m); }
        body arm { point O = (0m, 0m); point E = (1m, 0m); mass = 1kg; inertia = 1kgm2; }
        joint pin = revolute(ground.O, arm.O);
        drive turn = drive_angle(arm, 60rpm * t);
        slice output tip = arm.E +;
    }
}

fn main() {
    let pendulum = Pendulum::default();
    let tip = pendulum.solve_for_tip();
    let state = tip.solve(0.1).unwrap();
    let _ = pendulum.tip(&state).value.x;
}
