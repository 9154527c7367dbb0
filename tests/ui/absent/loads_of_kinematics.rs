reuleaux::mechanism! {
    pub mechanism Crank {
        body crank { point pin = (50mm, 0mm); }
        joint pivot = revolute(ground.position, crank.position);
        drive motor = drive_angle(crank, 60rpm * t);
    }
}

fn main() {
    let crank = Crank::default();
    let Ok(state) = crank.solve(0.5) else { return };
    let torque = crank.loads(&state).motor().effort;
}
