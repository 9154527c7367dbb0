//! In a definition, a path beginning with `crate` refers to the crate of the definition.

reuleaux::mechanism! {
    pub mechanism Lift {
        use elsewhere::lifted;
        body cam {}
        body tappet {}
        joint pivot = revolute((0mm, 0mm), cam.position);
        joint upright = absolute_angle(tappet, 0);
        joint guide = absolute_x(tappet.position, 0mm);
        joint contact = lifted(tappet.position, cam);
        drive input = drive_angle(cam, 60rpm * t);
    }
}

fn main() {
    let half_a_turn = Lift::default().solve(0.5).unwrap();
    assert!((half_a_turn.tappet().position.y - 0.02).abs() < 1e-15);
}
