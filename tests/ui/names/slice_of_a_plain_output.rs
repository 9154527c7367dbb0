use reuleaux::mechanism;

mechanism! {
    mechanism Wheel {
        body wheel { point rim = (1m, 0m); }
        joint axle = revolute(ground.position, wheel.position);
        drive motor = drive_angle(wheel, 60rpm * t);
        output distant_rim = wheel.rim;
    }
}

fn main() {
    let alone = Wheel::default().solve_for_distant_rim();
    println!("{}", alone.solve(0.0).unwrap().output().value.x);
}
