//! Captions and labels of pictures in the documentation.
#![cfg(feature = "picture")]

use reuleaux_compiler::{Compiled, compile};

fn compiled(items: &str) -> Compiled {
    let text = format!("pub mechanism Test {{ {items} }}");
    compile(text.parse().expect("tokens")).expect("a mechanism")
}

#[test]
fn links_in_line_are_drawn_a_little_later() {
    let words = |angle: &str| {
        let engine = format!(
            "ground {{ point O = (0mm, 0mm); axis bore = (1, 0); }}
            body crank {{ point A = (50mm, 0mm); }} body rod {{ point B = (200mm, 0mm); start angle = 0deg; }} body piston {{ }}
            joint main = revolute(ground.O, crank.position); joint big_end = revolute(crank.A, rod.position);
            joint small_end = revolute(rod.B, piston.position); joint guide = translational(ground.bore, ground.O, piston.position);
            drive motor = drive_angle(crank, {angle} + 2rad_s * t);"
        );
        compiled(&engine).picture.words().to_owned()
    };
    let later = words("0rad");
    assert!(later.starts_with("At the declared defaults, at t = 0.") && later.ends_with("s: at t = 0 parts lie on each other."), "{later}");
    assert_eq!(words("1rad"), "Assembled at the declared defaults, at t = 0.");
}

#[test]
fn arrows_know_which_way_a_drive_goes() {
    let heads = |law: &str| {
        let wheel = format!("body wheel {{ }} joint o = revolute(ground.position, wheel.position); drive d = drive_angle(wheel, {law});");
        let compiled = compiled(&wheel);
        let svg = compiled.picture.svg().expect("it is assembled");
        let arrow = svg.lines().find(|line| line.contains("<title>d: drive_angle of wheel</title>")).expect("an arrow");
        arrow.matches("class=\"s\"").count()
    };
    assert_eq!([heads("3rad_s * t"), heads("-2rad_s * t"), heads("1rad")], [1, 1, 2]);
}

#[test]
fn names_are_shown_without_the_marks_of_raw_identifiers() {
    let wheel = "body r#type { } joint r#fn = revolute(ground.position, r#type.position); drive d = drive_angle(r#type, 1rad_s * t);";
    let compiled = compiled(wheel);
    let svg = compiled.picture.svg().expect("it is assembled");
    assert!(svg.contains("<title>fn: revolute of ground and type</title>") && !svg.contains("r#"), "{svg}");
}
