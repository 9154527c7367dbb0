reuleaux::mechanism! {
    pub mechanism Feed {
        param length: Length = 100mm;
        body crank { point A = (length, 0mm); }
        body bench {}
        joint hinge = revolute((0mm, 0mm), crank.position);
        joint rail = translational((1, 0), (0mm, 0mm), bench.position);
        drive input = drive_angle(crank);
        drive feed = drive_along(rail, 10mm_s * t);
    }
}

fn main() {
    let mechanism = Feed { length: 0.2, ..Default::default() };
    let state = mechanism.solve(0.5).unwrap();
    let _ = [state.crank().angle, state.bench().position.x];
}
