reuleaux::mechanism! {
    pub mechanism FourBar {
        param speed: AngularVelocity = 60rpm;
        ground { point C = (400mm, 0mm); }
        body crank { point A = (100mm, 0mm); }
        body coupler { point B = (350mm, 0mm); point M = (175mm, 80mm); }
        body rocker { point B = (300mm, 0mm); start angle = 70deg; }
        joint o = revolute(ground.position, crank.position);
        joint a = revolute(crank.A, coupler.position);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.position, ground.C);
        drive input = drive_angle(crank, speed * t);
        joint strut = distance(coupler.M, ground.position, 200mm);
        output tip = coupler.M;
    }
}

fn main() {
    let mechanism = FourBar { speed: 5.0 };
    let state = mechanism.solve(0.5).unwrap();
    let _ = [mechanism.tip(&state).value.x, state.crank().angle];
}
