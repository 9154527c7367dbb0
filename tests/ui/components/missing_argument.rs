reuleaux::mechanism! {
    pub mechanism Walker {
        part leg = Leg();
        component Leg(pin: Point) {
            body bar { point X = (0mm, 0mm); }
            joint x = weld(pin, bar.X);
        }
    }
}

fn main() {
    let state = Walker::default().solve(1.0).unwrap();
    println!("{}", state.leg().bar().angle);
}
