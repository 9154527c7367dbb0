reuleaux::mechanism! {
    pub mechanism Linkage {
        use elsewhere::Crank;
        part crank = Crank((0mm, 0mm), (1, 0));
    }
}

fn main() {
    let _ = Linkage::default().solve(0.5).unwrap();
}
