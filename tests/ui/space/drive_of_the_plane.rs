reuleaux::mechanism! {
    pub mechanism Hinge in space {
        ground { axis z = (0, 0, 1); }
        body arm { axis z = (0, 0, 1); }
        joint axle = revolute(ground.position, ground.z, arm.position, arm.z);
        drive motor = drive_angle(arm, 60rpm * t);
    }
}

fn main() {
    let state = Hinge::default().solve(0.5).unwrap();
    let _ = state.arm().position;
}
