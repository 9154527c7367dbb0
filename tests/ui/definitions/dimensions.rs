reuleaux::constraint! {
    /// Here is one mistake.
    pub constraint wobble(P: Point, height: Angle) { P.y == height; }
}

reuleaux::mechanism! {
    pub mechanism Crank {
        use crate::wobble;
        body crank {}
        joint place = { crank.position == (0mm, 0mm); }
        joint law = wobble(crank.position, 1mm);
    }
}

fn main() {
    let _: f64 = Crank::default().solve(0.5).unwrap().crank().angle;
}
