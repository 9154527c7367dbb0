reuleaux::mechanism! {
    pub mechanism Linkage {
        use elsewhere::Chain;
        component Link(P: Point) {
            body bar {}
            joint pin = revolute(P, bar.position);
            drive turn = drive_angle(bar, 0);
        }
        part chain = Chain((0mm, 0mm));
        part link = Link(chain.last.position);
    }
}

fn main() {
    let _ = Linkage::default().solve(0.5).unwrap();
}
