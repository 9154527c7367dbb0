reuleaux::mechanism! {
    pub mechanism Row {
        ground { axis bore = (1, 0); }
        for i in 0..4 { part engine[i] = Engine(80mm - i * 20mm); }

        component Engine(rod_length: Length) {
            body crank  { point pin = (50mm, 0mm); }
            body rod    { point wrist = (rod_length, 0mm); }
            body piston { }
            joint axle = revolute(ground.position, crank.position);
            joint big_end = revolute(crank.pin, rod.position);
            joint small_end = revolute(rod.wrist, piston.position);
            joint guide = translational(ground.bore, ground.position, piston.position);
            drive motor = drive_angle(crank, 90deg + 60rpm * t);
            output stroke = piston.x;
        }
    }
}

fn main() {
    let row = Row::default();
    let state = row.solve(0.5).unwrap();
    let _ = [row.engine_stroke(&state)[1].value, state.engine()[0].piston().position.x];
}
