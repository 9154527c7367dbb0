reuleaux::mechanism! {
    pub mechanism Cam {
        body tappet { }
        joint guide = absolute_angle(tappet, 0);
        joint rail = absolute_x(tappet.position, 0mm);
        drive cam = drive_y(tappet.position, table(t, [(0s, 0mm), (1s, 12mm), (2s, 5mm), (3s, 0mm)]));
        output stroke = tappet.y with jerk;
        slice output ratio = rate(tappet.y) / 1m_s;
    }
}

fn main() {
    let cam = Cam::default();
    let state = cam.solve(0.5).unwrap();
    let ratio: reuleaux::ValueAndRate<f64> = cam.ratio(&cam.solve_for_ratio().solve(0.5).unwrap());
    println!("{} {}", cam.stroke(&state).jerk, ratio.rate + cam.ratio(&state).value);
}
