//! Names have no effect.

use fastrand::Rng;
use proptest::prelude::*;
use reuleaux_tests::common::interpreter::Interpreter;

use super::cases;
use super::loader::{declaration, items, values};
use crate::random::instant;

/// Names in the declaration: of bodies, an axis, joints, parameters, `let`s, a function, an output.
const NAMES: [&str; 14] =
    ["boom", "barrel", "rod", "link", "along", "cylinder", "lifting", "tilting", "reach", "swing", "phase", "stroke", "length", "tip"];

/// The text with `tail` appended to every word that is one of the names.
fn renamed(text: &str, tail: &str) -> String {
    let is_in_word = |letter: char| letter.is_alphanumeric() || letter == '_';
    let ends = text.split_inclusive(|letter| !is_in_word(letter));
    let rename = |piece: &str| {
        let word = piece.trim_end_matches(|letter| !is_in_word(letter));
        if NAMES.contains(&word) { format!("{word}_{tail}{}", &piece[word.len()..]) } else { piece.to_owned() }
    };
    ends.map(rename).collect()
}

proptest! {
    #![proptest_config(cases(48))]

    #[test]
    fn names_change_nothing(seed: u64, tail in "[a-z0-9_]{0,6}x") {
        let text = declaration(&items());
        let (mut one, mut two) = (Interpreter::of(&text), Interpreter::of(&renamed(&text, &tail)));
        prop_assert_ne!(&one.parameters, &two.parameters);
        let (parameters, at) = (values(&one.parameters), instant(&mut Rng::with_seed(seed), 12));
        prop_assert_eq!(one.rows(&parameters, &at, &[]), two.rows(&parameters, &at, &[]));
        prop_assert_eq!(one.outputs(&parameters, &at, &[]), two.outputs(&parameters, &at, &[]));
        prop_assert_eq!(one.start, two.start);
    }
}
