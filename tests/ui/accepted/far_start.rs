//! A start far from the assembly causes a warning, which `#[allow(far_start)]` suppresses.
#![deny(warnings)]

reuleaux::mechanism! {
    #[allow(far_start)]
    mechanism Rocker {
        ground { point C = (400mm, 0mm); }
        body crank   { point A = (100mm, 0mm);  start angle = 90deg; }
        body coupler { point B = (350mm, 0mm); }
        body rocker  { point B = (300mm, 0mm);  start angle = 0.1deg; }
        joint o = revolute(ground.position, crank.position);
        joint a = revolute(crank.A, coupler.position);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.position, ground.C);
        drive input = drive_angle(crank, 60rpm * t);
    }
}

fn main() {
    let _ = Rocker::default().solve(0.0);
}
