//! One mistake, one refusal, at the guilty token, with these words: the fast counterparts of `tests/ui`.
//!
//! « and » mark the guilty tokens in each source; the marks are removed before it is parsed.

mod arity;
mod assembly;
mod components;
mod definitions;
mod dimensions;
mod doubts;
mod duplicates;
mod forces;
mod freedoms;
mod homes;
mod inputs;
mod joints;
mod limits;
mod masses;
mod mobility;
mod names;
mod otherwise;
mod parameters;
mod redundancy;
mod space;
mod syntax;
mod uses;
mod values;

use proc_macro2::{LineColumn, TokenStream};
use reuleaux_compiler::diag::Refusal;
use std::str::FromStr;

/// A list of tests: name, source, words.
macro_rules! refusals {
    ($($frame:ident $name:ident: $source:literal => $words:literal;)*) => {
        $(#[test] fn $name() { crate::$frame($source, $words); })*
    };
}
pub(crate) use refusals;

/// A valid mechanism with one more item.
fn item(source: &str, words: &str) {
    let rest = "
        #[equations_only]
        pub mechanism Crank {
            param speed: AngularVelocity = 60rpm;
            param length: Length = 100mm;
            let double = 2 * length;
            function lift(a: Angle) -> Length = 5mm * sin(a);
            ground { point O = (0mm, 0mm); point C = (400mm, 0mm); axis u = (1, 0); }
            body crank { point O = (0mm, 0mm); point A = (length, 0mm); axis v = (0, 1); }
            body ram { point B = (0mm, 0mm); }
            joint hinge = revolute(ground.O, crank.O);
            joint slide = translational(ground.u, ground.C, ram.B);
            drive input = drive_angle(crank, speed * t);
            output tip = crank.A;
            ";
    mechanism(&format!("{rest}{source}\n}}"), words);
}

/// A whole mechanism.
fn mechanism(source: &str, words: &str) {
    check(source, words, |tokens| reuleaux_compiler::compile(tokens).err().unwrap_or_default());
}

/// A whole `constraint!` invocation.
fn constraint(source: &str, words: &str) {
    check(source, words, |tokens| reuleaux_compiler::check_constraint(tokens).err().unwrap_or_default());
}

fn check(marked: &str, words: &str, compile: fn(TokenStream) -> Vec<Refusal>) {
    let (source, [start, end]) = unmarked(marked);
    let tokens = TokenStream::from_str(&source).expect("the source consists of tokens");
    let refusals = compile(tokens);
    let said: Vec<String> = refusals.iter().map(|refusal| refusal.fact.to_string()).collect();
    assert_eq!(said, [words], "in\n{marked}");
    let range = refusals[0].range;
    assert_eq!((range.first.start(), range.last.end()), (start, end), "`{words}` lies elsewhere in\n{marked}");
    let guilty = marked.split(['«', '»']).nth(1).and_then(|guilty| guilty.lines().next());
    assert_eq!(Some(refusals[0].underlined(&source)), guilty.or(Some("")), "`{words}` underlines something else in\n{marked}");
}

/// The source without its marks, and their positions.
fn unmarked(marked: &str) -> (String, [LineColumn; 2]) {
    let mut source = String::new();
    let mut place = LineColumn { line: 1, column: 0 };
    let mut places = Vec::new();
    for character in marked.chars() {
        match character {
            '«' | '»' => places.push(place),
            '\n' => place = LineColumn { line: place.line + 1, column: 0 },
            _ => place.column += 1,
        }
        if !matches!(character, '«' | '»') {
            source.push(character);
        }
    }
    (source, places.try_into().expect("one pair of marks"))
}

/// The declarations around the mistakes are valid.
#[test]
fn the_frame_is_accepted() {
    let mut source = String::new();
    let frame = include_str!("main.rs").split("let rest = \"").nth(1).and_then(|rest| rest.split("\";").next());
    source += frame.expect("the frame is in this file");
    let tokens = TokenStream::from_str(&format!("{source} }}")).expect("the frame consists of tokens");
    assert!(reuleaux_compiler::compile(tokens).is_ok());
}
