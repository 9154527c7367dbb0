#![deny(deprecated)]

reuleaux::mechanism! {
    pub mechanism Lifter {
        use elsewhere::{at_height, lifted as raised};
        body crank { point A = (100mm, 0mm); }
        body foot { point P = (0mm, 0mm); }
        joint hinge = revolute(ground.position, crank.position);
        joint upright = absolute_angle(foot, 0);
        joint sideways = absolute_x(foot.position, 0mm);
        joint height = at_height(foot.P, 20mm);
        drive input = drive_angle(crank, 60rpm * t);
    }
}

fn main() {
    let _ = Lifter::default().solve(0.5);
}
