reuleaux::constraint! {
    constraint rolling(P: Point, Q: Point) { P == Q; }
}

reuleaux::mechanism! {
    #[picture]
    pub mechanism Crank {
        use rolling;
        param length: Length = 100mm;
        body crank { point A = (length, 0mm); }
        joint hinge = rolling((0mm, 0mm), crank.position);
        drive input = drive_angle(crank, 60rpm * t);
        output tip = crank.A;
    }
}

fn main() {
    let mechanism = Crank { length: 0.2, ..Default::default() };
    let state = mechanism.solve(0.5).unwrap();
    let _ = reuleaux::picture::Drawable::picture(&mechanism, &state);
    let _ = [mechanism.tip(&state).value.x, state.crank().angle];
}
