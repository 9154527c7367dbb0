#![deny(unused_variables)]

reuleaux::mechanism! {
    pub mechanism Crank {
        param length: Length = 100mm;
        param speed: AngularVelocity = 60rpm;
        body crank { point A = (length, 0mm); }
        joint hinge = revolute(ground.position, crank.position);
        drive input = drive_angle(crank, 60rpm * t);
        output tip = crank.A;
    }
}

fn main() {
    let mechanism = Crank { length: 0.2, speed: 1.0 };
    let _ = mechanism.tip(&mechanism.solve(0.5).unwrap());
}
