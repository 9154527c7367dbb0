reuleaux::mechanism! {
    pub mechanism Wheels {
        for i in 1..=3 {
            body wheel[i] { point O = (0m, 0m); }
            joint axle[i] = revolute(ground.position, wheel[i].O);
            drive turn[i] = drive_angle(wheel[i], 1rad_s * t * i);
        }
    }
}

fn main() {
    let state = Wheels::default().solve(1.0).unwrap();
    println!("{}", state.wheel()[2].angle);
}
