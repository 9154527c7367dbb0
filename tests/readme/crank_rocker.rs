use reuleaux::mechanism;

mechanism! {
    /// A Grashof crank-rocker turned at constant speed.
    pub mechanism CrankRocker {
        param speed: AngularVelocity = 60rpm;
        param crank_length: Length = 100mm;

        ground {
            point O = (0mm, 0mm);
            point C = (400mm, 0mm);
        }
        body crank   { point O = (0mm, 0mm);  point A = (crank_length, 0mm); }
        body coupler { point A = (0mm, 0mm);  point B = (350mm, 0mm);  point P = (175mm, 80mm); }
        body rocker  { point C = (0mm, 0mm);  point B = (300mm, 0mm);  start angle = 70deg; }

        joint o = revolute(ground.O, crank.O);
        joint a = revolute(crank.A, coupler.A);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.C, ground.C);
        drive input = drive_angle(crank, speed * t);

        output tip = coupler.P;
        output transmission = rocker.angle - coupler.angle;
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mechanism = CrankRocker { crank_length: 0.12, ..Default::default() };
    println!("crank °   rocker °        tip (mm)           tip (m/s)          tip (m/s²)");
    for state in mechanism.sweep((0..=6).map(|sixth| f64::from(sixth) / 6.0)) {
        let state = state?;
        let tip = mechanism.tip(&state);
        let (crank, rocker) = (state.crank().angle.to_degrees(), state.rocker().angle.to_degrees());
        let (place, velocity, acceleration) = (tip.value * 1e3, tip.rate, tip.acceleration);
        println!(
            "{crank:7.1}   {rocker:8.3}   {:7.2} {:7.2}   {:8.4} {:8.4}   {:8.3} {:8.3}",
            place.x, place.y, velocity.x, velocity.y, acceleration.x, acceleration.y
        );
    }
    Ok(())
}
