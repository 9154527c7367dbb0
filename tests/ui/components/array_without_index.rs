reuleaux::mechanism! {
    pub mechanism Wheels {
        for i in 0..3 {
            body wheel[i] { point O = (0m, 0m); }
            joint axle[i] = revolute(ground.position, wheel.O);
            drive turn[i] = drive_angle(wheel[i], 1rad_s * t * i);
        }
    }
}

fn main() {}
