//! Rules that replace a node about to be built by a simpler expression.
//!
//! The arena tries the rules in this order for each new node and simplifies their results in the same way, so that no rule matches
//! anywhere in a finished expression. This terminates, because each rule removes an operation, moves a minus outward, or sorts two
//! operands.
//!
//! A rule never costs accuracy: the new form has at most as many roundings as the old one, for
//! all finite operands (0 · x is taken as 0). Hence nothing here distributes, reassociates a
//! sum, or cancels x/x or √x². The sign of a zero may change.

mod constants;
mod frames;
mod functions;
mod identities;
mod signs;

use super::{Arena, Expr, Node};

/// Returns the replacement of a node, or `None` if the law does not apply.
pub type Rewrite = fn(&mut Arena, &Node) -> Option<Expr>;

/// One law of simplification.
#[derive(Clone, Copy, Debug)]
pub struct Rule {
    /// Name of the law.
    pub name: &'static str,
    /// Formula of the law; a, b, x are any expressions, c is a constant.
    pub law: &'static str,
    /// Applies the law.
    pub rewrite: Rewrite,
}

const fn rule(name: &'static str, law: &'static str, rewrite: Rewrite) -> Rule {
    Rule { name, law, rewrite }
}

/// All laws, in the order in which they are tried.
pub const RULES: &[Rule] = &[
    // Exact arithmetic, where the result fits.
    rule("constants_add", "c₁ + c₂ = c", constants::add),
    rule("constants_subtract", "c₁ − c₂ = c", constants::subtract),
    rule("constants_multiply", "c₁ · c₂ = c", constants::multiply),
    rule("constants_divide", "c₁ / c₂ = c", constants::divide),
    rule("constants_negate", "−(c) = c′", constants::negate),
    rule("constants_have_roots", "√c² = |c|", constants::take_root),
    rule("constants_have_signs", "|c|, sign c", constants::take_sign),
    rule("constants_decide", "c₁ < c₂ ? a : b", constants::decide),
    // One order of operands; the rules below rely on it.
    rule("factors_are_sorted", "x · c = c · x", identities::sort_factors),
    rule("terms_are_sorted", "c + x = x + c", identities::sort_terms),
    // Neutral and absorbing elements.
    rule("zero_is_neutral_in_sums", "x + 0 = x", identities::add_zero),
    rule("zero_is_neutral_in_differences", "x − 0 = x", identities::subtract_zero),
    rule("zero_minus_is_negation", "0 − x = −x", identities::subtract_from_zero),
    rule("equals_vanish", "x − x = 0", identities::subtract_itself),
    rule("equals_double", "x + x = 2 · x", identities::add_itself),
    rule("one_is_neutral_in_products", "1 · x = x", identities::multiply_by_one),
    rule("one_is_neutral_in_quotients", "x / 1 = x", identities::divide_by_one),
    rule("zero_absorbs_factors", "0 · x = 0", identities::multiply_by_zero),
    rule("zero_absorbs_divisors", "0 / x = 0, x not 0", identities::divide_zero),
    rule("roots_of_squares_meet", "√(a² + b²) · √(a² + b²) = a² + b²", identities::square_root_of_squares),
    rule("one_frame_keeps_angles", "A s · A t = s · t, A orthogonal", frames::dot),
    rule("equal_branches_need_no_choice", "a < b ? x : x = x", identities::equal_branches),
    rule("nothing_is_less_than_itself", "x < x ? a : b = b", identities::equal_sides),
    // Minus signs move outward and combine. A negative constant counts as a negated positive one.
    rule("minus_minus_is_plus", "−(−x) = x", signs::negate_negation),
    rule("negated_difference_turns", "−(a − b) = b − a", signs::negate_difference),
    rule("plus_minus_is_minus", "a + (−b) = a − b", signs::add_negation),
    rule("leading_minus_goes_behind", "(−a) + b = b − a", signs::add_to_negation),
    rule("minus_of_minus_is_plus", "a − (−b) = a + b", signs::subtract_negation),
    rule("minus_leaves_differences", "(−a) − b = −(a + b)", signs::subtract_from_negation),
    rule("minus_leaves_left_factors", "(−a) · b = −(a · b)", signs::left_factor),
    rule("minus_leaves_right_factors", "a · (−b) = −(a · b)", signs::right_factor),
    rule("minus_leaves_dividends", "(−a) / b = −(a / b)", signs::dividend),
    rule("minus_leaves_divisors", "a / (−b) = −(a / b)", signs::divisor),
    rule("odd_functions_pass_minus", "f(−x) = −f(x), f odd", signs::odd_function),
    rule("even_functions_drop_minus", "f(−x) = f(x), f even", signs::even_function),
    // Constants are combined if that saves a rounding.
    rule("divisor_two_to_n_is_a_factor", "x / 2ⁿ = 2⁻ⁿ · x", constants::divide_by_power_of_two),
    rule("constant_factors_meet", "c₁ · (c₂ · x) = c · x", constants::merge_factors),
    rule("constant_divisors_meet", "(x / c₁) / c₂ = x / c", constants::merge_divisors),
    // Functions at special points.
    rule("sine_at_known_angles", "sin c = 0, ±1/2, ±1", functions::sine),
    rule("cosine_at_known_angles", "cos c = 0, ±1/2, ±1", functions::cosine),
    rule("tangent_at_known_angles", "tan c = 0, ±1", functions::tangent),
    rule("arcs_of_known_values", "asin, acos, atan of 0, 1/2, 1", functions::arcs),
    rule("exponential_of_zero", "exp 0 = 1", functions::exponential),
    rule("logarithm_of_one", "ln 1 = 0", functions::logarithm),
    rule("absolute_value_once", "abs(abs x) = abs x", functions::absolute),
];
