reuleaux::constraint! {
    pub constraint pinned(P: Point, Q: Point) { P.x == Q.x; P.y == Q.y; }
}

reuleaux::mechanism! {
    pub mechanism Linkage {
        use elsewhere::Link;
        use crate::pinned;
        part link = Link((0mm, 0mm), 0);
        body end {}
        joint tip = pinned(link.bar.end, end.position);
        drive turn = drive_angle(end, 0);
    }
}

fn main() {
    let _ = Linkage::default().solve(0.5).unwrap();
}
