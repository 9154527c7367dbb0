//! Large and absurd declarations: each is refused with a single fitting message, after work that does not grow with its numbers.

use proc_macro2::TokenStream;
use std::str::FromStr;

const TOO_MANY: &str = "loops and parts make more than 100000 items\nnote: every round of a loop counts, also of one with nothing in it";
const TOO_LARGE: &str =
    "the equations grow beyond 200000 operations here\nhelp: a function that calls others several times is written out at every call";

crate::refusals! {
    item a_grid_of_parameters: "for i in 0..400 { for «j» in 0..400 { param x[i][j]: Length = 1mm; } } let q = x[399][399];" => "loops and parts make more than 100000 items\nnote: every round of a loop counts, also of one with nothing in it";
    item a_grid_of_outputs: "for i in 0..400 { for «j» in 0..400 { output x[i][j] = crank.A; } }" => "loops and parts make more than 100000 items\nnote: every round of a loop counts, also of one with nothing in it";
    item points_without_end: "body b { for i in 0..1000 { for j in 0..1000 { for k in 0..1000 { point «P»[i][j][k] = (1mm, 1mm); } } } }" => "loops and parts make more than 100000 items\nnote: every round of a loop counts, also of one with nothing in it";
    item empty_loops_in_a_body: "body b { for i in 0..300 { for j in 0..300 { for «k» in 0..300 { } } } }" => "loops and parts make more than 100000 items\nnote: every round of a loop counts, also of one with nothing in it";
    item empty_loops: "for i in 0..10000 { for j in 0..10000 { for «k» in 0..10000 { } } }" => "loops and parts make more than 100000 items\nnote: every round of a loop counts, also of one with nothing in it";
    item loops_in_many_bodies: "for b in 0..1000 { body x[b] { for «i» in 0..1000 { } } }" => "loops and parts make more than 100000 items\nnote: every round of a loop counts, also of one with nothing in it";
    item a_range_beyond_all: "for i in «0..9223372036854775807» { }" => "this loop has 9223372036854775807 rounds, at most 10000 are possible";
    item a_range_over_everything: "for i in «-9223372036854775807..=9223372036854775807» { }" => "this loop has 18446744073709551615 rounds, at most 10000 are possible";
    item a_whole_number_beyond_all: "for i in 0..«99999999999999999999» { }" => "`99999999999999999999` is too large: an index or the end of a range stays below 2^63";
    item an_index_beyond_all: "let a[«18446744073709551616»] = 1;" => "`18446744073709551616` is too large: an index or the end of a range stays below 2^63";
    item the_least_number_turned_round: "let a = 0 - 9223372036854775807 - 1; let b[«-a»] = 1;" => "`-(-9223372036854775808)` is too large: an index or the end of a range stays below 2^63";
    item a_product_beyond_all: "let b[«9223372036854775807 * 2»] = 1;" => "`9223372036854775807 * 2` is too large: an index or the end of a range stays below 2^63";
    item the_last_whole_number: "for i in 9223372036854775807..=9223372036854775807 { let a[i] = «zebra»; }" => "nothing is called `zebra` here\nnote: in `a[9223372036854775807]`";
}

#[test]
fn loops_in_loops_have_a_limit() {
    let loops = |depth: usize| (0..depth).map(|depth| format!("for i{depth} in 0..2 {{ ")).collect::<String>() + &"} ".repeat(depth);
    assert_eq!(refusals(&loops(17)), [TOO_MANY]);
    assert_eq!(refusals(&format!("body b {{ {} }}", loops(17))), [TOO_MANY]);
}

/// Each component has two parts of the previous one.
fn doubling(levels: usize, last: &str) -> String {
    let level = |level: usize| format!("component C{}() {{ part a = C{level}(); part b = C{level}(); }} ", level + 1);
    format!("component C0() {{ }} {} {last}", (0..levels).map(level).collect::<String>())
}

#[test]
fn parts_that_double_have_a_limit() {
    assert_eq!(refusals(&doubling(18, "part p = C18();")), [TOO_MANY]);
    let deep = "parts are nested more than 20 deep\nhelp: declare the innermost parts in the mechanism, beside the others";
    assert_eq!(refusals(&doubling(25, "part p = C25();")), [deep]);
}

/// Components used by no part are visited once, including the components in them.
#[test]
fn unused_components_are_gone_through_once() {
    let tokens =
        TokenStream::from_str(&format!("mechanism M {{ {} body b {{ }} joint j = weld(ground.position, b.position); }}", doubling(14, "")));
    assert!(reuleaux_compiler::compile(tokens.expect("the source consists of tokens")).is_ok());
}

#[test]
fn functions_that_double_have_a_limit() {
    let level = |level: usize| format!("function f{}(x: Angle) -> Number = f{level}(x + 1deg) + f{level}(x + 2deg);", level + 1);
    let levels = (0..40).map(level).collect::<String>();
    let first = "function f0(x: Angle) -> Number = sin(x);";
    let refusals = refusals(&format!("{first} {levels} output o = f40(crank.angle);"));
    assert_eq!(refusals, [TOO_LARGE]);
    // A mistake in the innermost function is reported once.
    let first = "function f0(x: Angle) -> Number = «zebra»;";
    crate::item(&format!("{first} {levels} output o = f40(crank.angle);"), "nothing is called `zebra` here");
}

fn refusals(item: &str) -> Vec<String> {
    let source = format!(
        "mechanism M {{ body crank {{ }} joint o = revolute(ground.position, crank.position); drive d = drive_angle(crank, 1rad_s * t); {item} }}"
    );
    let refused = reuleaux_compiler::compile(TokenStream::from_str(&source).expect("the source consists of tokens"));
    refused.err().unwrap_or_default().iter().map(|refusal| refusal.fact.to_string()).collect()
}

#[test]
fn many_unknown_names_are_each_refused() {
    for [one, words] in [
        ["let a# = zebra#;", "nothing is called `zebra#` here"],
        ["let a# = crank.zebra#;", "`crank` has no `zebra#`\nnote: it has `position`, `angle`, `x`, `y` and `angular_velocity`"],
        [
            "let a# = zebra#(1);",
            "no function is called `zebra#`\nhelp: declare it, such as `function zebra#(x: Angle) -> Length = …;`; a function of Rust is declared by its path, `function zebra#(Angle) -> Length = crate::zebra#;`",
        ],
        [
            "joint j# = zebra#(crank);",
            "no constraint is called `zebra#`\nnote: there are `revolute`, `translational`, `weld`, `distance`, `point_on_line`, `revolute_translational`, `relative_angle`, `parallel`, `absolute_x`, `absolute_y`, `absolute_angle`, `absolute_distance` and 15 more\nhelp: bring in your own with `use path::to::zebra#;`",
        ],
        ["part p# = Zebra#();", "no component is called `Zebra#`\nhelp: declare it with `component Zebra#(…) { … }`"],
    ] {
        let numbered = |text: &str, number: usize| text.replace('#', &number.to_string());
        let said = refusals(&(0..2000).map(|number| numbered(one, number)).collect::<String>());
        assert_eq!(said, (0..2000).map(|number| numbered(words, number)).collect::<Vec<_>>());
    }
    let long = "q".repeat(20_000);
    assert_eq!(refusals(&format!("let a = {long}; let b{long} = 1;")), [format!("nothing is called `{long}` here")]);
}

#[test]
fn what_there_is_is_listed_in_part() {
    let points = (0..2000).map(|number| format!("point P{number} = (1mm, 1mm); ")).collect::<String>();
    let listed = (0..12).map(|number| format!("`P{number}`")).collect::<Vec<_>>().join(", ");
    let words = format!("`plate` has no `corner`\nnote: it has {listed} and 1993 more");
    assert_eq!(refusals(&format!("body plate {{ {points} }} joint w = weld(crank.position, plate.corner);")), [words]);
}

#[test]
fn long_numbers_are_refused() {
    let words = |number: &str| format!("`{}…` has more than 400 digits\nhelp: of a number, 17 digits are as good as all", &number[..30]);
    for number in
        ["1".repeat(100_000), format!("0x{}", "f".repeat(100_000)), format!("0.{}", "1".repeat(100_000)), format!("1e{}", "9".repeat(1000))]
    {
        for item in [format!("let a = {number};"), format!("for i in 0..{number} {{ }}"), format!("param a: Length^{number} = 1;")] {
            assert_eq!(refusals(&item), [words(&number)], "{}", &item[..30]);
        }
    }
    for item in
        ["let a = 1e999999999;", "let a = 2^2^2^2^2^2^2^2^2;", "output o = (crank.angle / 1rad)^2147483647;", "let a = 0e999999999;"]
    {
        let refused = refusals(item);
        assert!(refused.iter().all(|words| words.starts_with("`1e999999999` cannot be kept exactly")), "{refused:?}");
    }
}

#[test]
fn long_formulas_have_a_limit() {
    let words = "this has more than 200 operations one after the other\nhelp: name parts of it with `let`";
    assert_eq!(refusals(&format!("let a = 1{};", " + 1".repeat(100_000))), [words]);
    assert_eq!(refusals(&format!("let a = crank{};", "[0]".repeat(5000))), [words]);
    assert!(refusals(&format!("let a = 1{};", " + 1".repeat(199))).is_empty());
}

/// A crank with 10 000 joints identical to its own.
///
/// This takes the compiler 1.5 s and rustc 1 s, instead of 4 s and more than a minute. There is no picture for a mechanism this large,
/// since all positions would have to be compared with each other.
#[test]
fn redundant_joints_may_be_many() {
    let source = "mechanism M { body crank { } joint o = revolute(ground.position, crank.position); drive d = drive_angle(crank, 1rad_s * t); \
         for i in 0..4000 { redundant joint r[i] = revolute(ground.position, crank.position); } }";
    let compiled = reuleaux_compiler::compile(TokenStream::from_str(source).expect("tokens")).expect("it is right");
    // Each joint is an iteration of a loop, not a line of its own.
    assert!(matches!(compiled.plan.linearize, reuleaux_compiler::plan::Code::Grouped(_)));
    assert_eq!(compiled.plan.checked.len(), 8000);
    assert_eq!(compiled.picture.words(), "There is no picture: in one of 4002 joints nothing could be told apart.");
}
