reuleaux::mechanism! {
    pub mechanism Gears {
        param speed: AngularVelocity = 60rpm;
        for i in 0..4 {
            body gear[i] {}
            joint axle[i] = revolute((i * 100mm, 0mm), gear[i].position);
        }
        for i in 1..4 { joint mesh[i] = gear_pair(gear[i - 1], gear[i], 1, 2); }
        joint level = absolute_angle(gear[2], 30deg);
        joint again = absolute_angle(gear[2], 40deg);
        drive input = drive_angle(gear[0], speed * t);
        output last = gear[3].angle;
    }
}

fn main() {
    let mechanism = Gears { speed: 5.0 };
    let state = mechanism.solve(0.5).unwrap();
    let _ = [mechanism.last(&state).value, state.gear()[1].angle];
}
