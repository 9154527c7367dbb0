reuleaux::mechanism! {
    pub mechanism Hinge in space {
        param speed: AngularVelocity = 60rpm;
        ground { axis z = (0, 0, 1); }
        body arm { axis z = (0, 0, 1);  point tip = (100mm, 0mm); }
        joint axle = revolute(ground.position, ground.z, arm.position, arm.z);
        drive motor = drive_rotation(axle, speed * t);
        output tip = arm.tip;
    }
}

fn main() {
    let hinge = Hinge { speed: 5.0 };
    let state = hinge.solve(0.5).unwrap();
    let _ = (hinge.tip(&state).value, state.arm().rotation);
}
