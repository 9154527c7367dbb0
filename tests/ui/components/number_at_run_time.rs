reuleaux::mechanism! {
    pub mechanism Wheels {
        param count: Number = 3;
        for i in 0..count {
            body wheel[i] { point O = (0m, 0m); }
            joint axle[i] = revolute(ground.position, wheel[i].O);
            drive turn[i] = drive_angle(wheel[i], 1rad_s * t * i);
        }
    }
}

fn main() {}
