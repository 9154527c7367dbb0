reuleaux::mechanism! {
    pub mechanism FourBar {
        param length: Length = 100mm;
        ground { point C = (400mm, 0mm); }
        body crank { point A = (100mm, 0mm); }
        body coupler { point B = (length, 0mm); }
        body rocker { point B = (150mm, 0mm); }
        joint o = revolute(ground.position, crank.position);
        joint a = revolute(crank.A, coupler.position);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.position, ground.C);
        drive input = drive_angle(crank, 60rpm * t);
        output tip = coupler.B;
    }
}

fn main() {
    let mechanism = FourBar { length: 0.2, ..Default::default() };
    let state = mechanism.solve(0.5).unwrap();
    let _ = [mechanism.tip(&state).value.x, state.rocker().angle];
}
