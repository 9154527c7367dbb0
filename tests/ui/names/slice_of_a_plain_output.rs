use reuleaux::mechanism;

mechanism! {
    mechanism Wheel {
        body wheel { point rim = (1m, 0m); }
        joint axle = revolute(ground.position, wheel.position);
        drive motor = drive_angle(wheel, 60rpm * t);
        output rim = wheel.rim;
    }
}

fn main() {
    let rim = Wheel::default().solve_for_rim();
    println!("{}", rim.solve(0.0).unwrap().output().value.x);
}
