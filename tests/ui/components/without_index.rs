reuleaux::mechanism! {
    pub mechanism Chain {
        for i in 0..3 { body link { point A = (0m, 0m); } }
    }
}

fn main() {}
