reuleaux::mechanism! {
    pub mechanism Crank {
        param length: Length = 100mm;
    }
}

fn main() {
    let _ = Crank { length: 1.0 }.solve(0.5).unwrap().q;
}
