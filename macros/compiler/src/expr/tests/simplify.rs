use std::collections::BTreeSet;

use super::formula::{Tree, parse};
use super::random::Random;
use super::samples::samples;
use super::{Point, expr};
use crate::expr::{Arena, Binary, Leaf, RULES, Unary};

/// Name, before, after.
const LAWS: &[(&str, &str, &str)] = &[
    ("constants_add", "1/2 + 1/3", "5/6"),
    ("constants_add", "pi + pi/2", "3*pi/2"),
    ("constants_subtract", "0.3 - 0.1", "0.2"),
    ("constants_multiply", "2*pi", "pi + pi"),
    ("constants_multiply", "0.1*10", "1"),
    ("constants_divide", "pi/pi", "1"),
    ("constants_negate", "-(3)", "0 - 3"),
    ("constants_have_roots", "sqrt(2.25)", "1.5"),
    ("constants_have_roots", "sqrt(pi*pi)", "pi"),
    ("constants_have_signs", "abs(-3)", "3"),
    ("constants_have_signs", "sign(-3)", "-1"),
    ("constants_have_signs", "sign(0)", "0"),
    ("constants_decide", "if(1/3, 1/2, x, y)", "x"),
    ("constants_decide", "if(pi, pi, x, y)", "y"),
    ("factors_are_sorted", "x*2", "2*x"),
    ("factors_are_sorted", "y*x", "x*y"),
    ("terms_are_sorted", "2 + x", "x + 2"),
    ("terms_are_sorted", "y + x", "x + y"),
    ("zero_is_neutral_in_sums", "x + 0", "x"),
    ("zero_is_neutral_in_differences", "x - 0", "x"),
    ("zero_minus_is_negation", "0 - x", "-x"),
    ("equals_vanish", "sin(x) - sin(x)", "0"),
    ("equals_double", "x + x", "2*x"),
    ("equals_double", "3*x + 3*x", "6*x"),
    ("one_is_neutral_in_products", "1*x", "x"),
    ("one_is_neutral_in_quotients", "x/1", "x"),
    ("zero_absorbs_factors", "0*x", "0"),
    ("zero_absorbs_divisors", "0/x", "0"),
    ("roots_of_squares_meet", "sqrt(x*x + y*y)*sqrt(x*x + y*y)", "x*x + y*y"),
    ("equal_branches_need_no_choice", "if(x, y, z, z)", "z"),
    ("nothing_is_less_than_itself", "if(x, x, y, z)", "z"),
    ("minus_minus_is_plus", "-(-x)", "x"),
    ("negated_difference_turns", "-(x - y)", "y - x"),
    ("plus_minus_is_minus", "x + (-y)", "x - y"),
    ("plus_minus_is_minus", "x + (-2)", "x - 2"),
    ("leading_minus_goes_behind", "(-x) + y", "y - x"),
    ("minus_of_minus_is_plus", "x - (-y)", "x + y"),
    ("minus_of_minus_is_plus", "x - (-2)", "x + 2"),
    ("minus_leaves_differences", "(-x) - y", "-(x + y)"),
    ("minus_leaves_differences", "(-2) - x", "-(x + 2)"),
    ("minus_leaves_left_factors", "(-x)*y", "-(x*y)"),
    ("minus_leaves_left_factors", "(-x)*(-y)", "x*y"),
    ("minus_leaves_left_factors", "(-2)*x", "-(2*x)"),
    ("minus_leaves_left_factors", "(-1)*x", "-x"),
    ("minus_leaves_right_factors", "x*(-y)", "-(x*y)"),
    ("minus_leaves_dividends", "(-x)/y", "-(x/y)"),
    ("minus_leaves_dividends", "(-2)/x", "-(2/x)"),
    ("minus_leaves_divisors", "x/(-y)", "-(x/y)"),
    ("minus_leaves_divisors", "x/(-3)", "-(x/3)"),
    ("odd_functions_pass_minus", "sin(-x)", "-sin(x)"),
    ("odd_functions_pass_minus", "tan(-x)", "-tan(x)"),
    ("odd_functions_pass_minus", "asin(-1)", "-pi/2"),
    ("odd_functions_pass_minus", "atan(-x)", "-atan(x)"),
    ("odd_functions_pass_minus", "sign(-x)", "-sign(x)"),
    ("even_functions_drop_minus", "cos(-x)", "cos(x)"),
    ("even_functions_drop_minus", "abs(-x)", "abs(x)"),
    ("divisor_two_to_n_is_a_factor", "x/4", "0.25*x"),
    ("divisor_two_to_n_is_a_factor", "(2*x)/2", "x"),
    ("divisor_two_to_n_is_a_factor", "x/0.5", "2*x"),
    ("constant_factors_meet", "2*(3*x)", "6*x"),
    ("constant_factors_meet", "(1/3)*(3*x)", "x"),
    ("constant_divisors_meet", "(x/3)/5", "x/15"),
    ("sine_at_known_angles", "sin(0)", "0"),
    ("sine_at_known_angles", "sin(7*pi)", "0"),
    ("sine_at_known_angles", "sin(pi/6)", "1/2"),
    ("sine_at_known_angles", "sin(3*pi/2)", "-1"),
    ("sine_at_known_angles", "sin(7*pi/6)", "-1/2"),
    ("cosine_at_known_angles", "cos(0)", "1"),
    ("cosine_at_known_angles", "cos(pi/2)", "0"),
    ("cosine_at_known_angles", "cos(2*pi/3)", "-1/2"),
    ("cosine_at_known_angles", "cos(pi/3)", "1/2"),
    ("tangent_at_known_angles", "tan(pi)", "0"),
    ("tangent_at_known_angles", "tan(pi/4)", "1"),
    ("tangent_at_known_angles", "tan(3*pi/4)", "-1"),
    ("arcs_of_known_values", "asin(1/2)", "pi/6"),
    ("arcs_of_known_values", "acos(-1)", "pi"),
    ("arcs_of_known_values", "acos(-1/2)", "2*pi/3"),
    ("arcs_of_known_values", "atan(1)", "pi/4"),
    ("exponential_of_zero", "exp(0)", "1"),
    ("logarithm_of_one", "ln(1)", "0"),
    ("absolute_value_once", "abs(abs(x))", "abs(x)"),
];

/// Formulas that must not be simplified although they resemble a law.
const REFUSED: &[&str] = &[
    "x/x",
    "0/0",
    "1/0",
    "sqrt(x)*sqrt(x)",
    "sqrt(x*x)",
    "sqrt(x*x - y*y)*sqrt(x*x - y*y)",
    "sin(x)*sin(x) + cos(x)*cos(x)",
    "x*y + x*z",
    "(x + y) - x",
    "(x + 1) + 1",
    "2*(x/3)",
    "(2*x)/3",
    "x/0/0",
    "sqrt(2)",
    "sin(1)",
    "1 + pi",
    "tan(pi/2)",
    "if(3, pi, x, y)",
];

/// An arena in which `x`, `y`, `z` are created in this order.
fn arena() -> Arena {
    let mut arena = Arena::new();
    for leaf in ["x", "y", "z"] {
        expr(&mut arena, leaf);
    }
    arena
}

#[test]
fn laws_rewrite_before_into_after() {
    for &(name, before, after) in LAWS {
        let mut arena = arena();
        let rule = RULES.iter().find(|rule| rule.name == name);
        let rule = rule.unwrap_or_else(|| panic!("no rule is called {name}"));
        let node = parse(before).node(&mut arena);
        let found = (rule.rewrite)(&mut arena, &node);
        let expected = expr(&mut arena, after);
        assert_eq!(found, Some(expected), "{name}: {before} = {after}");
        assert_eq!(expr(&mut arena, before), expected, "{before} = {after}");
    }
}

#[test]
fn every_law_is_tested() {
    let names: BTreeSet<&str> = RULES.iter().map(|rule| rule.name).collect();
    assert_eq!(names.len(), RULES.len(), "two rules have one name");
    // Vectors have no formula: see the tests of frames.
    let of_frames = ["one_frame_keeps_angles"];
    let tested: BTreeSet<&str> = LAWS.iter().map(|law| law.0).chain(of_frames).collect();
    assert_eq!(names.difference(&tested).collect::<Vec<_>>(), Vec::<&&str>::new());
}

#[test]
fn what_loses_accuracy_is_left_alone() {
    for text in REFUSED {
        let mut arena = arena();
        let node = parse(text).node(&mut arena);
        let built = arena.build(node);
        assert_eq!(*arena.node(built), node, "{text}");
    }
}

#[test]
fn no_rule_matches_in_a_finished_expression() {
    let mut random = Random::new(12);
    let mut arena = Arena::new();
    for _ in 0..3000 {
        random.tree(5).build(&mut arena);
    }
    let size = arena.len();
    for expr in (0..size as u32).map(crate::expr::Expr) {
        let node = *arena.node(expr);
        for rule in RULES {
            assert_eq!((rule.rewrite)(&mut arena, &node), None, "{}: {node:?}", rule.name);
        }
    }
}

#[test]
fn values_do_not_change() {
    let mut random = Random::new(13);
    let mut compared = 0;
    for _ in 0..samples(6_000, 30_000) {
        let tree = random.tree(5);
        let mut point = Point::random(&mut random);
        point.coordinates = point.coordinates.map(|x| x * random.between(-4.0, 4.0));
        let Some((expected, bound)) = reference(&tree, &point) else {
            continue;
        };
        let mut arena = Arena::new();
        let root = tree.build(&mut arena);
        let found = point.value_of(&arena, root);
        let difference = (found - expected).abs();
        assert!(difference <= 4.0 * bound, "{tree:?}: {found} is not {expected} ± {bound}");
        compared += 1;
    }
    // All others have a pole, a kink or a negative root somewhere.
    assert!(compared > samples(2_000, 10_000), "only {compared} were comparable");
}

/// The value of a formula as written, and a bound of its rounding error, to first order.
///
/// `None` if no such bound exists: beside a pole, a kink or the border of a choice.
fn reference(tree: &Tree, point: &Point) -> Option<(f64, f64)> {
    let (value, inherited) = match tree {
        Tree::Constant(value) => (value.to_f64(), 0.0),
        Tree::Leaf(Leaf::Coordinate(i)) => return Some((point.coordinates[*i as usize], 0.0)),
        Tree::Leaf(_) | Tree::Call(..) => return None,
        Tree::Unary(function, a) => {
            let (a, error) = reference(a, point)?;
            let slope = slope_of(*function, a, error)?;
            (function.apply(a), if error == 0.0 { 0.0 } else { slope * error })
        }
        Tree::Binary(function, a, b) => {
            let ((a, da), (b, db)) = (reference(a, point)?, reference(b, point)?);
            let error = match function {
                Binary::Add | Binary::Sub => da + db,
                Binary::Mul => a.abs() * db + b.abs() * da,
                Binary::Div if b.abs() <= 1e3 * db => return None,
                Binary::Div => (da + (a / b).abs() * db) / b.abs(),
                // The negative half axis is where the angle jumps.
                Binary::Atan2 if b <= 1e3 * db && a.abs() <= 1e3 * da => return None,
                Binary::Atan2 => (b.abs() * da + a.abs() * db) / (a * a + b * b),
            };
            (function.apply(a, b), error)
        }
        Tree::Select(operands) => {
            let [lhs, rhs, then, otherwise] = operands.each_ref().map(|o| reference(o, point));
            let ((lhs, dl), (rhs, dr)) = (lhs?, rhs?);
            if (lhs - rhs).abs() <= 1e3 * (dl + dr) && dl + dr > 0.0 {
                return None;
            }
            return if lhs < rhs { then } else { otherwise };
        }
    };
    let error = inherited + 2.0 * f64::EPSILON * value.abs() + f64::MIN_POSITIVE;
    (error.is_finite() && error <= 1e-6 * value.abs().max(1.0)).then_some((value, error))
}

/// Factor by which a function amplifies an error of its operand.
fn slope_of(function: Unary, a: f64, error: f64) -> Option<f64> {
    let away_from = |border: f64| (a - border).abs() > 1e3 * error || error == 0.0;
    let inside = away_from(-1.0) && away_from(1.0);
    let slope = match function {
        Unary::Neg | Unary::Sin | Unary::Cos | Unary::Abs | Unary::Atan => 1.0,
        Unary::Sqrt => 0.5 / away_from(0.0).then(|| a.sqrt())?,
        Unary::Tan => 1.0 + a.tan() * a.tan(),
        Unary::Asin | Unary::Acos => 1.0 / inside.then(|| ((1.0 - a) * (1.0 + a)).sqrt())?,
        Unary::Exp => a.exp(),
        Unary::Ln => 1.0 / away_from(0.0).then_some(a)?,
        Unary::Sign => away_from(0.0).then_some(0.0)?,
    };
    Some(slope)
}
