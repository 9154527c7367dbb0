reuleaux::mechanism! {
    pub mechanism Crank {
        body crank { point A = (100mm, 0mm); }
        joint hinge = revolute(ground.position, crank.position);
        drive input = drive_angle(crank, 60rpm * t);
        output crank = crank with jerk;
    }
}

fn main() {
    Crank::default().solve(0.5).unwrap();
}
