reuleaux::mechanism! {
    pub mechanism Crank {
        body crank { point A = (100mm, 0mm); }
        joint hinge = revolute((0mm, 0mm), crank.position);
        drive input = drive_angle(crank, 60rpm * t);
        output tip = crank.A;
        component ForTip(root: Point) {
            param length: Length = 1m;
            body needle { point tip = (length, 0m); }
            joint w = weld(root, needle.position);
        }
        part pointer = ForTip(crank.A);
    }
}

fn main() {
    let mechanism = Crank::default();
    let state = mechanism.solve(0.5).unwrap();
    let _ = [mechanism.tip(&state).value.x, state.crank().angle];
}
