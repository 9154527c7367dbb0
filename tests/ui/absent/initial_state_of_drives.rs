reuleaux::mechanism! {
    pub mechanism Crank {
        body crank { point pin = (50mm, 0mm); }
        joint pivot = revolute(ground.position, crank.position);
        drive motor = drive_angle(crank, 60rpm * t);
    }
}

fn main() {
    let crank = Crank::default();
    let state = crank.initial_state();
}
