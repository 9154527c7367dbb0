reuleaux::mechanism! {
    pub mechanism Crank {
        use elsewhere::at_height as level;
        param length: Length = 100mm;
        body crank { point A = (length, 0mm); }
        joint height = level(crank.position, 0mm);
        joint place = { crank.x == 0; }
        drive input = drive_angle(crank, 60rpm * t);
        output tip = crank.A;
    }
}

fn main() {
    let mechanism = Crank { length: 0.2, ..Default::default() };
    let state = mechanism.solve(0.5).unwrap();
    let _ = [mechanism.tip(&state).value.x, state.crank().angle];
}
