reuleaux::mechanism! {
    pub mechanism Crank {
        body crank { point A = (100mm, 0mm); }
        joint o = revolute(ground.position, crank.position);
        drive input = drive_angle(crank, 1rad * sqrt(t / 1s));
        output tip = crank.A;
    }
}

fn main() {
    let mechanism = Crank::default();
    let state = mechanism.solve(0.5).unwrap();
    let _ = [mechanism.tip(&state).value.x, state.crank().angle];
}
