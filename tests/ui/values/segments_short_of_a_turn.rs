reuleaux::mechanism! {
    pub mechanism Crank {
        param length: Length = 100mm;
        body crank { point A = (length, 0mm); }
        joint hinge = revolute((0mm, 0mm), crank.position);
        drive input = drive_angle(crank, 60rpm * t);
        output tip = crank.A;
        output lift = segments(crank.angle, 0mm, [rise(5mm, 180deg, cycloidal), fall(5mm, 90deg, cycloidal)], periodic);
    }
}

fn main() {
    let mechanism = Crank { length: 0.2, ..Default::default() };
    let state = mechanism.solve(0.5).unwrap();
    let _ = [mechanism.tip(&state).value.x, state.crank().angle];
}
