reuleaux::mechanism! {
    pub mechanism Crank {
        body crank { point A = (100mm, 0mm); point B = (100mm, 50mm); }
        joint o = revolute(ground.position, crank.position);
        joint arm = { dot(crank.B - crank.A, crank.B - crank.A) == 50mm * 50mm; }
        drive input = drive_angle(crank, 60rpm * t);
        output tip = crank.A;
    }
}

fn main() {
    let mechanism = Crank::default();
    let state = mechanism.solve(0.5).unwrap();
    let _ = [mechanism.tip(&state).value.x, state.crank().angle];
}
