use reuleaux::mechanism;

mechanism! {
    mechanism Wheel {
        body wheel { point rim = (1m, 0m); }
        joint axle = revolute(ground.position, wheel.positon);
        drive motor = drive_angle(wheel, 60rpm * t);
        slice output rim = wheel.rim;
    }
}

fn main() {
    let wheel = Wheel::default().prepared();
    let rim = wheel.solve_for_rim();
    let mut state = rim.solve(0.0).unwrap();
    rim.advance(&mut state, 0.1).unwrap();
    println!("{}", state.output().value.x);
}
