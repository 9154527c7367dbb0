#![deny(warnings)]

reuleaux::mechanism! {
    pub mechanism Crank {
        use elsewhere::columns;
        param length: Length = 100mm;
        body crank { point A = (length, 0mm); }
        joint across = left_of((0mm, 0mm), crank.position, 0mm);
        joint up = below((0mm, 0mm), crank.position, d: 0mm);
        drive input = drive_angle(crank, 60rpm * t);
        output tip = crank.A;
    }
}

fn main() {
    let mechanism = Crank { length: 0.2, ..Default::default() };
    let state = mechanism.solve(0.5).unwrap();
    let _ = [mechanism.tip(&state).value.x, state.crank().angle];
}
