reuleaux::mechanism! {
    pub mechanism Chain {
        for i in 0..3 { body link[i] { point A = (0m, 0m);  point B = (1m, 0m); } }
        joint first = revolute(ground.position, link[0].A);
        for i in 1..3 { joint pin[i] = revolute(link[i - 1].B, link[i + 1].A); }
        for i in 0..3 { drive turn[i] = drive_angle(link[i], 1rad_s * t); }
    }
}

fn main() {
    let state = Chain::default().solve(1.0).unwrap();
    println!("{}", state.link()[2].angle);
}
