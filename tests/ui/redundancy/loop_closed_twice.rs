reuleaux::mechanism! {
    pub mechanism Machine {
        param length: Length = 100mm;
        ground { axis way = (1, 0);  point O = (0mm, 0mm);  point S = (0mm, 100mm); }
        body crank  { point A = (length, 0mm); }
        body rod    { point B = (300mm, 0mm);  point C = (300mm, 2mm); }
        body slider { point S = (0mm, 100mm); }
        joint axle = revolute(ground.O, crank.position);
        joint pin = revolute(crank.A, rod.position);
        joint wrist = revolute(rod.B, slider.position);
        joint guide = translational(ground.way, ground.O, slider.position);
        drive input = drive_angle(crank, 1rad + 60rpm * t);
        joint again = distance(crank.A, slider.position, 300mm);
        output tip = crank.A;
    }
}

fn main() {
    let mechanism = Machine { length: 0.2, ..Default::default() };
    let state = mechanism.solve(0.5).unwrap();
    let _ = [mechanism.tip(&state).value.x, state.crank().angle];
}
