//! Large numbers of parts: the size of the generated code does not grow with them.

use std::str::FromStr;

use proc_macro2::TokenStream;
use reuleaux::mechanism;

/// Pairs of links on a row of pivots, moved by one crank.
fn row(legs: usize) -> TokenStream {
    let source = format!(
        "pub mechanism Row {{
            param speed: AngularVelocity = 1rad_s;
            let legs = {legs};
            ground {{ for i in 0..=legs {{ point P[i] = (i * 1m, 0m); }} }}
            body crank {{ point A = (1m, 0m); }}
            joint axle = revolute(ground.P[0], crank.position);
            drive motor = drive_angle(crank, 30deg + speed * t);
            component Leg(pivot: Point, pin: Point) {{
                param reach: Length = 700m;
                body upper {{ point U = (reach, 0m);  start angle = 1rad;  start position = (0m, 0m); }}
                body lower {{ point U = (700m, 0m);  start angle = 2rad;  start position = (0m, 0m); }}
                joint hip = revolute(pivot, upper.position);
                joint knee = revolute(upper.U, lower.U);
                joint foot = revolute(pin, lower.position);
                output knee = upper.U;
            }}
            for i in 0..legs {{ part leg[i] = Leg(ground.P[i + 1], crank.A); }}
        }}"
    );
    TokenStream::from_str(&source).expect("the source consists of tokens")
}

/// Number of occurrences of a word.
fn count(tokens: TokenStream, word: &str) -> usize {
    let of_tree = |tree: proc_macro2::TokenTree| match tree {
        proc_macro2::TokenTree::Group(group) => count(group.stream(), word),
        tree => usize::from(tree.to_string() == word),
    };
    tokens.into_iter().map(of_tree).sum()
}

#[test]
fn functions_do_not_grow_in_number_with_parts() {
    let functions = |legs: usize| count(reuleaux_compiler::mechanism(row(legs)), "fn");
    assert_eq!(functions(200), functions(100));
}

#[test]
fn five_hundred_parts_stand_one_after_the_other() {
    let compiled = reuleaux_compiler::compile(row(500)).expect("the row is accepted");
    let names: Vec<&str> = compiled.model.bodies.iter().map(|body| body.name.path.as_str()).collect();
    assert_eq!((names.len(), names[1], names[2], names[1000]), (1001, "leg[0].upper", "leg[0].lower", "leg[499].lower"));
    let locals: std::collections::BTreeSet<&str> = compiled.model.bodies.iter().map(|body| body.name.local.as_str()).collect();
    assert_eq!(locals.len(), names.len());
}

#[test]
fn names_of_generated_code_stay_apart() {
    let source = "#[equations_only] mechanism Odd { body a[0] {} body a_0 {} joint j = revolute(a[0].position, a_0.position); }";
    let compiled =
        reuleaux_compiler::compile(TokenStream::from_str(source).expect("the source consists of tokens")).expect("it is accepted");
    let locals: Vec<&str> = compiled.model.bodies.iter().map(|body| body.name.local.as_str()).collect();
    // What is written as it is called keeps its name.
    assert_eq!(locals, ["a_0_", "a_0"]);
}

mechanism! {
    /// Two cylinders on one crank.
    mechanism Cylinders {
        body crank { point pin = (40mm, 0mm); }
        joint axle = revolute(ground.position, crank.position);
        drive motor = drive_angle(crank, 3rad_s * t);
        for i in 0..2 { part cylinder[i] = Cylinder(crank.pin, 120deg * i); }
        component Cylinder(pin: Point, toward: Angle) {
            param rod: Length = 150mm;
            body link { point wrist = (rod, 0mm);  start angle = toward; }
            body piston { }
            joint big = revolute(pin, link.position);
            joint small = revolute(link.wrist, piston.position);
            joint bore = translational((cos(toward), sin(toward)), ground.position, piston.position, toward);
        }
    }
}

#[test]
fn the_part_whose_link_shrinks_to_nothing_is_named() {
    for part in 0..2 {
        let mut cylinders = Cylinders::default();
        cylinders.cylinder[part].rod = -0.15;
        let failure = cylinders.solve(0.0).expect_err("no rod of this length").to_string();
        let told = format!("does not determine `cylinder[{part}].link.angle`");
        assert!(failure.contains(&told), "{failure}");
    }
}
