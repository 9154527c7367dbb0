reuleaux::mechanism! {
    pub mechanism Machine {
        param length: Length = 500mm;
        ground { point A = (0m, 0m);  point B = (2m, 0m); }
        body crank  { point P = (length, 0mm);  start angle = 60deg; }
        body rod    { point Q = (2m, 0m); }
        body rocker { point P = (length, 0mm); }
        joint a = revolute(ground.A, crank.position);
        joint b = revolute(ground.B, rocker.position);
        joint c = revolute(crank.P, rod.position);
        joint d = revolute(rod.Q, rocker.P);
        drive input = drive_angle(rod, 0);
        output tip = crank.P;
    }
}

fn main() {
    let mechanism = Machine { length: 0.2, ..Default::default() };
    let state = mechanism.solve(0.5).unwrap();
    let _ = [mechanism.tip(&state).value.x, state.crank().angle];
}
