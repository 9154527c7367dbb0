reuleaux::mechanism! {
    pub mechanism Crank {
        body crank { point A = (100mm, 0mm); }
        joint hinge = revolute(ground.position, crank.position);
        drive input = drive_angle(crank, 60rpm * t);
        output speed = rate(crank.A.x);
    }
}

fn main() {
    let crank = Crank::default();
    println!("{}", crank.speed(&crank.solve(0.5).unwrap()).acceleration);
}
