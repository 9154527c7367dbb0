reuleaux::mechanism! {
    pub mechanism Crank {
        body crank { point A = (100mm, 0mm); mass = 1kg; center = (50mm, 0mm); inertia = 0.001kgm2; }
        body rod { point B = (200mm, 0mm); }
        joint hinge = revolute(ground.position, crank.position);
        joint hinge = revolute(crank.A, rod.position);
        joint guide = absolute_y(rod.B, 0mm);
        drive motor = drive_angle(crank, 60rpm * t);
    }
}

fn main() {
    let mechanism = Crank::default();
    let state = mechanism.solve(0.5).unwrap();
    let _ = mechanism.loads(&state).hinge().force;
}
