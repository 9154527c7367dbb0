reuleaux::mechanism! {
    pub mechanism Machine {
        param middle: Length = 499mm;
        ground { point A = (0m, 0m);  point B = (2m, 0m);  point C = (1m, 0m); }
        body crank  { point P = (500mm, 0mm);  start angle = 60deg; }
        body rod    { point Q = (2m, 0m);  point R = (1m, 0m); }
        body rocker { point P = (500mm, 0mm); }
        body third  { point P = (middle, 0mm); }
        joint a = revolute(ground.A, crank.position);
        joint b = revolute(ground.B, rocker.position);
        joint c = revolute(crank.P, rod.position);
        joint d = revolute(rod.Q, rocker.P);
        joint e = revolute(ground.C, third.position);
        joint f = revolute(rod.R, third.P);
        drive input = drive_angle(crank, 60deg + 10rpm * t);
        output tip = crank.P;
    }
}

fn main() {
    let mechanism = Machine { middle: 0.2, ..Default::default() };
    let state = mechanism.solve(0.5).unwrap();
    let _ = [mechanism.tip(&state).value.x, state.crank().angle];
}
