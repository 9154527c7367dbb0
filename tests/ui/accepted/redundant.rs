//! A redundant joint is accepted if it is declared as redundant, also in loops and parts.

reuleaux::mechanism! {
    /// A slide between two guides, with pins that hold it once more.
    pub mechanism Slides {
        let slides = 2;
        ground { axis way = (1, 0); for i in 0..slides { point O[i] = (0mm, i * 1m); } }
        for i in 0..slides { part slide[i] = Slide(ground.O[i], ground.way); }

        component Slide(O: Point, way: Axis) {
            param travel: Length = 50mm;
            body slider { point S = (0mm, 100mm);  start x = 200mm; }
            joint guide = translational(way, O, slider.position);
            redundant joint level = { 2 * slider.angle == 0; }
            for i in 0..2 { redundant joint rail[i] = { (i + 1) * slider.S.y == (i + 1) * (O.y + 100mm); } }
            drive push = drive_distance(O, slider.position, 200mm + travel * sin(1rad_s * t));
        }
        output last = slide[1].slider;
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let slides = Slides::default();
    assert_eq!(Slides::<f64>::EQUATIONS - Slides::<f64>::COORDINATES, 6);
    let state = slides.solve(1.0)?;
    assert!(slides.phi(&state.q, 1.0).amax() < 1e-15);
    let _ = slides.last(&state).position;
    Ok(())
}
