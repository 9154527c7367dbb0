#![deny(unused_variables)]

reuleaux::mechanism! {
    pub mechanism Crank {
        body crank { }
        joint hinge = revolute(ground.position, crank.position);
        drive input = drive_angle(crank, 60rpm * t);
        component Spare(length: Length) {
            body spare { point end = (length, 0mm); }
            joint hinge = revolute(ground.position, spare.position);
        }
    }
}

fn main() {
    let _ = Crank::default().solve(0.5);
}
