reuleaux::mechanism! {
    pub mechanism Crank {
        body crank { point A = (100mm, 0mm); }
        joint hinge = revolute(ground.position, crank.position);
        drive input = drive_angle(crank, 60rpm * t);
    }
}

fn main() {
    let crank = Crank::default();
    let _ = crank.sweep(0.0..1.0);
}
