reuleaux::mechanism! {
    pub mechanism Linkage {
        use elsewhere::columns;
        use elsewhere::hanging;
        body top {}
        joint upright = absolute_angle(top, 0);
        joint height = below((0mm, 0mm), top.position, 30mm);
        joint side = left_of((0mm, 0mm), top.position, 0);
    }
}

fn main() {
    let _ = Linkage::default().solve(0.5).unwrap();
}
