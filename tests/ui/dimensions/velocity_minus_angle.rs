reuleaux::mechanism! {
    pub mechanism Crank {
        body crank { point A = (100mm, 0mm); }
        joint hinge = revolute(ground.position, crank.position);
        drive input = drive_angle(crank, 60rpm * t);
        output lead = crank.angle - crank.angular_velocity;
    }
}

fn main() {
    let crank = Crank::default();
    println!("{}", crank.lead(&crank.solve(0.5).unwrap()).value);
}
