reuleaux::mechanism! {
    pub mechanism Pendulum {
        body arm { point tip = (100mm, 0mm); }
        joint ball = spherical(ground.position, arm.position);
        drive motor = drive_angle(arm, 60rpm * t);
        output tip = arm.tip;
    }
}

fn main() {
    let pendulum = Pendulum::default();
    let state = pendulum.solve(0.5).unwrap();
    let _ = (pendulum.tip(&state), state.arm().angle);
}
