reuleaux::mechanism! {
    pub mechanism Hub {
        param speed: AngularVelocity = 60rpm;
        for i in 0..3 { body arm[i] {} }
        joint axle = revolute(ground.position, arm[0].position);
        joint one = revolute(arm[0].position, arm[1].position);
        joint two = revolute(arm[1].position, arm[2].position);
        joint three = revolute(arm[2].position, arm[0].position);
        for i in 0..3 { drive turn[i] = drive_angle(arm[i], (i + 1) * speed * t); }
    }
}

fn main() {
    let state = Hub { speed: 5.0 }.solve(0.5).unwrap();
    let _ = state.arm()[1].angle;
}
