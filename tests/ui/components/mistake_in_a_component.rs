reuleaux::mechanism! {
    pub mechanism Walker {
        body crank { point X = (15mm, 0mm); }
        joint axle = revolute(ground.position, crank.position);
        drive motor = drive_angle(crank, 1rad_s * t);
        for i in 0..6 { part leg[i] = Leg(crank.X); }
        component Leg(pin: Point) {
            param length: Length = 50mm;
            body bar { point X = (0mm, 0mm);  point U = (length, 0mm); }
            joint x = revolute(pin, bar.X);
            drive turn = drive_angle(bar, 2 * length);
            output end = bar.U;
        }
    }
}

fn main() {
    let mut walker = Walker::default();
    walker.leg[5].length = 0.06;
    let state = walker.solve(1.0).unwrap();
    println!("{} {}", state.leg()[3].bar().angle, walker.leg_end(&state)[0].value.x);
}
