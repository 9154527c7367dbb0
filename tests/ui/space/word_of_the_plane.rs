reuleaux::mechanism! {
    pub mechanism Hinge in space {
        ground { axis z = (0, 0, 1); }
        body arm { axis z = (0, 0, 1);  point tip = (100mm, 0mm, 0mm); }
        joint axle = revolute(ground.position, ground.z, arm.position, arm.z);
        drive motor = drive_rotation(axle, 60rpm * t);
        output heading = direction(arm.tip - ground.position);
    }
}

fn main() {
    let hinge = Hinge::default();
    let state = hinge.solve(0.5).unwrap();
    let _ = (hinge.heading(&state), state.arm().position);
}
