//! Evaluated by the interpreter, with all numbers as literals, so that constants are folded in exact arithmetic.

use reuleaux_tests::common::interpreter::Interpreter;
use reuleaux_tests::common::reference::{Value, file, list, text};
use reuleaux_tests::common::text::{declaration, unit};

use super::{all, instant, share};

#[test]
fn literals_are_the_reference_for_every_type() {
    let file = file("unit_constraints.json");
    let mut largest: Vec<(&str, f64)> = Vec::new();
    for case in list(&file["cases"]) {
        let kind = text(&case["constraint"]["type"]);
        let share = share(case, &interpreted(case), &all(case));
        match largest.last_mut() {
            Some(last) if last.0 == kind => last.1 = last.1.max(share),
            _ => largest.push((kind, share)),
        }
    }
    for (kind, share) in largest {
        println!("{kind}: largest error {share:.2} of what is allowed");
    }
}

fn interpreted(case: &Value) -> reuleaux_tests::common::declared::Rows {
    let text = declaration(&unit(case), "Unit", "#[equations_only]");
    Interpreter::of(&text).rows(&[], &instant(case), &[])
}
