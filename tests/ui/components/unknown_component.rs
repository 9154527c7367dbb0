reuleaux::mechanism! {
    pub mechanism Walker {
        for i in 0..6 { part leg[i] = Log(ground.position); }
        component Leg(pin: Point) {
            body bar { point X = (0mm, 0mm); }
            joint x = weld(pin, bar.X);
        }
    }
}

fn main() {}
