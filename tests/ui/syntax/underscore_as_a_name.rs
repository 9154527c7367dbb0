reuleaux::mechanism! {
    pub mechanism Crank {
        body crank { point A = (100mm, 0mm); }
        joint hinge = revolute((0mm, 0mm), crank.position);
        drive input = drive_angle(crank, 60rpm * t);
        output tip = crank.A;
        body _ { point B = (100mm, 0mm); }
        joint hub = weld(_.position, crank.A);
        output end = _.B;
    }
}

fn main() {
    let mechanism = Crank::default();
    let state = mechanism.solve(0.5).unwrap();
    let _ = [mechanism.tip(&state).value.x, state.crank().angle];
}
