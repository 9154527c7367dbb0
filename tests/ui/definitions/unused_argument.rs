#![deny(unused_variables)]

reuleaux::constraint! {
    pub constraint at_height(P: Point, h: Length) { P.y == 100mm; }
}

reuleaux::mechanism! {
    pub mechanism Slide {
        use crate::at_height;
        body slide { }
        joint upright = absolute_angle(slide, 0deg);
        joint rail = at_height(slide.position, 200mm);
        drive input = drive_x(slide.position, 60mm_s * t);
    }
}

fn main() {
    let _ = Slide::default().solve(0.5);
}
