reuleaux::mechanism! {
    pub mechanism Walker {
        body crank { point X = (15mm, 0mm); }
        joint axle = revolute(ground.position, crank.position);
        drive motor = drive_angle(crank, 1rad_s * t);
        part leg = Leg();
        component Leg() {
            body bar { point X = (0mm, 0mm); }
            joint x = weld(crank.X, bar.X);
        }
    }
}

fn main() {}
