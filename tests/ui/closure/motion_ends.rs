reuleaux::mechanism! {
    pub mechanism Rocker {
        range t in 0s..0.25s;
        ground { point C = (400mm, 0mm); }
        body arm { point A = (300mm, 0mm); }
        body coupler { point B = (100mm, 0mm); }
        body rocker { point B = (350mm, 0mm); start angle = 110deg; }
        joint o = revolute(ground.position, arm.position);
        joint a = revolute(arm.A, coupler.position);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.position, ground.C);
        drive input = drive_angle(arm, 60deg - 60rpm * t);
        output tip = coupler.B;
    }
}

fn main() {
    let mechanism = Rocker::default();
    let state = mechanism.solve(0.5).unwrap();
    let _ = [mechanism.tip(&state).value.x, state.rocker().angle];
}
