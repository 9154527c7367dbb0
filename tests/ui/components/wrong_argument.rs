reuleaux::mechanism! {
    pub mechanism Walker {
        body crank { point X = (15mm, 0mm); }
        joint axle = revolute(ground.position, crank.position);
        drive motor = drive_angle(crank, 1rad_s * t);
        for i in 0..2 { part leg[i] = Leg(crank.X, 50mm * i); }
        component Leg(pin: Point, turn: Angle) {
            body bar { point X = (0mm, 0mm); }
            joint x = revolute(pin, bar.X);
            drive swing = drive_angle(bar, turn);
        }
    }
}

fn main() {}
