//! scratch
use reuleaux::mechanism;
mechanism! {
    /// A shaft.
    pub mechanism Shaft in space {
        ground { axis z = (0, 0, 1); }
        body shaft { axis z = (0, 0, 1); point A = (100mm, 0mm, 0mm); }
        joint axle = revolute(ground.position, ground.z, shaft.position, shaft.z);
        drive motor = drive_rotation(axle, 60rpm * t);
        output tip = shaft.A;
    }
}
mechanism! {
    /// A crank turns a slide that runs across its plane, by a rod with a ball at each end.
    pub mechanism AcrossCrank in space {
        param speed: AngularVelocity = 60rpm;
        ground { point O = (0mm, 100mm, 120mm);  axis x = (1, 0, 0) from (0, 0, 1); axis slide = (1, 0, 0); }
        body crank  { point O = (0mm, 0mm, 0mm);  axis x = (1, 0, 0) from (0, 0, 1);  point A = (0mm, 0mm, 80mm); }
        body rod { point A = (-150mm, 0mm, 0mm); point B = (150mm, 0mm, 0mm); axis y = (0, 1, 0); start position = (100mm, 0mm, 0mm); }
        body slide  { point B = (0mm, 0mm, 0mm);  axis x = (1, 0, 0);  start position = (200mm, 0mm, 0mm); }
        joint axle = revolute(ground.O, ground.x, crank.O, crank.x);
        joint ball = spherical(crank.A, rod.A);
        joint hooke = universal(rod.B, rod.y, slide.B, slide.x);
        joint rail = translational(ground.position, ground.slide, slide.B, slide.x);
        drive turn = drive_rotation(axle, speed * t);
        output stroke = slide.position.x;
    }
}
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let shaft = Shaft::default();
    let state = shaft.solve(0.125)?;
    println!("{:?}", shaft.tip(&state));
    println!("{:?}", state.shaft());
    let m = AcrossCrank::default();
    for s in m.sweep((0..5).map(|k| f64::from(k) * 0.05)) {
        let s = s?;
        println!("{:?} {}", m.stroke(&s), s.rod().rotation);
    }
    println!("{:?}", AcrossCrank::<f64>::PLAN);
    Ok(())
}
