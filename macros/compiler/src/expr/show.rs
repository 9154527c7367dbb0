//! Prints an expression as a formula, given the names of its leaves.
//!
//! The formula is for reading: it shows neither sharing nor the order of association, and operands that make it too long are replaced
//! by `…`.

use super::lookup::Lookup;
use super::{Arena, Binary, Exact, Expr, Leaf, Node, Unary};

/// Longest formula in characters, unless one name is longer.
const LONGEST: usize = 400;

/// Binding strength of a formula, the weakest first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Precedence {
    Negation,
    Sum,
    Product,
    Power,
    Atom,
}

struct Formula {
    text: String,
    level: Precedence,
    // The formula is a power with this base and exponent.
    base: Expr,
    exponent: u32,
}

impl Formula {
    /// The text, in parentheses if it binds less tightly than `level`.
    fn within(&self, level: Precedence) -> Token {
        let text = &self.text;
        Token::Operand(if self.level >= level { text.clone() } else { format!("({text})") })
    }
}

enum Token {
    Sign(&'static str),
    Operand(String),
}

use Token::Sign;

/// The expression as a formula with few parentheses.
#[must_use]
pub fn show(arena: &Arena, root: Expr, name: &dyn Fn(Leaf) -> String, function: &dyn Fn(u32) -> String) -> String {
    let mut formulas = Lookup::default();
    for expr in arena.reachable(&[root]) {
        let formula = compose(arena, expr, &formulas, name, function);
        formulas.insert(expr, formula);
    }
    formulas.remove(&root).map(|formula| formula.text).unwrap_or_default()
}

fn compose(
    arena: &Arena,
    expr: Expr,
    formulas: &Lookup<Expr, Formula>,
    name: &dyn Fn(Leaf) -> String,
    function: &dyn Fn(u32) -> String,
) -> Formula {
    let f = |operand: Expr| &formulas[&operand];
    let whole = |operand: Expr| f(operand).within(Precedence::Negation);
    let (mut base, mut exponent) = (expr, 1);
    let (level, parts) = match *arena.node(expr) {
        Node::Constant(value) => constant(value),
        Node::Leaf(leaf) => (Precedence::Atom, vec![Token::Operand(name(leaf))]),
        Node::Unary(Unary::Neg, a) => (Precedence::Negation, vec![Sign("-"), f(a).within(Precedence::Product)]),
        Node::Unary(function, a) => (Precedence::Atom, vec![Sign(word(function)), Sign("("), whole(a), Sign(")")]),
        Node::Binary(Binary::Mul, a, b) if f(a).base == f(b).base => {
            base = f(a).base;
            exponent = f(a).exponent.saturating_add(f(b).exponent);
            (Precedence::Power, vec![f(base).within(Precedence::Atom), Token::Operand(superscript(exponent))])
        }
        Node::Marked { value, .. } => (f(value).level, vec![Token::Operand(f(value).text.clone())]),
        Node::Binary(function, a, b) => binary(function, f(a), f(b)),
        Node::Select { lhs, rhs, then, otherwise } => (
            Precedence::Negation,
            vec![
                Sign("if "),
                whole(lhs),
                Sign(" < "),
                whole(rhs),
                Sign(" { "),
                whole(then),
                Sign(" } else { "),
                whole(otherwise),
                Sign(" }"),
            ],
        ),
        Node::Call { function: number, order, argument } => {
            let name = function(number) + &primes(order);
            (Precedence::Atom, vec![Token::Operand(name), Sign("("), whole(argument), Sign(")")])
        }
    };
    Formula { text: join(parts), level, base, exponent }
}

fn binary(function: Binary, a: &Formula, b: &Formula) -> (Precedence, Vec<Token>) {
    let infix = |level: Precedence, sign: &'static str, right: Precedence| (level, vec![a.within(level), Sign(sign), b.within(right)]);
    match function {
        Binary::Add => infix(Precedence::Sum, " + ", Precedence::Sum),
        Binary::Sub => infix(Precedence::Sum, " - ", Precedence::Product),
        Binary::Mul => infix(Precedence::Product, "·", Precedence::Product),
        Binary::Div => infix(Precedence::Product, "/", Precedence::Power),
        Binary::Atan2 => {
            let (a, b) = (a.within(Precedence::Negation), b.within(Precedence::Negation));
            (Precedence::Atom, vec![Sign("atan2("), a, Sign(", "), b, Sign(")")])
        }
    }
}

const fn word(function: Unary) -> &'static str {
    match function {
        Unary::Neg => "-",
        Unary::Sqrt => "√",
        Unary::Sin => "sin",
        Unary::Cos => "cos",
        Unary::Tan => "tan",
        Unary::Asin => "asin",
        Unary::Acos => "acos",
        Unary::Atan => "atan",
        Unary::Exp => "exp",
        Unary::Ln => "ln",
        Unary::Abs => "abs",
        Unary::Sign => "sign",
    }
}

/// A number: `0.25`, `2/3`, `π/6`.
fn constant(value: Exact) -> (Precedence, Vec<Token>) {
    let (level, text) = magnitude(value.abs());
    if value.signum() < 0 {
        return (Precedence::Negation, vec![Sign("-"), Token::Operand(text)]);
    }
    (level, vec![Token::Operand(text)])
}

/// Formats a number that is not negative. Short decimals stay decimals, other short fractions stay fractions, long numbers are rounded.
fn magnitude(value: Exact) -> (Precedence, String) {
    let (above, below) = (value.numerator(), value.denominator());
    let rounded = || (Precedence::Atom, value.to_f64().to_string());
    let short = above.max(below) < 10_000_000;
    let pi = match value.pi_power() {
        0 if 1_000_000 % below == 0 || !short => return rounded(),
        0 => String::new(),
        1 => "π".to_string(),
        power => format!("π{}", superscript_signed(power)),
    };
    let factor = if above == 1 && !pi.is_empty() { String::new() } else { above.to_string() };
    match (above, below) {
        (1, 1) if value.pi_power() == 1 => (Precedence::Atom, pi),
        (1, 1) => (Precedence::Power, pi),
        (_, 1) => (Precedence::Product, format!("{factor}{pi}")),
        _ => (Precedence::Product, format!("{factor}{pi}/{below}")),
    }
}

/// Joins tokens; the longest operands are replaced by `…` until the formula is short enough.
fn join(mut parts: Vec<Token>) -> String {
    let length = |part: &Token| match part {
        Token::Sign(text) => text.chars().count(),
        Token::Operand(text) => text.chars().count(),
    };
    while parts.len() > 1 && parts.iter().map(length).sum::<usize>() > LONGEST {
        let operands = parts.iter_mut().filter(|part| matches!(part, Token::Operand(_)));
        match operands.max_by_key(|part| length(part)) {
            Some(longest) if length(longest) > 1 => *longest = Token::Operand("…".to_string()),
            _ => break,
        }
    }
    let text = |part: &Token| match part {
        Token::Sign(text) => (*text).to_string(),
        Token::Operand(text) => text.clone(),
    };
    parts.iter().map(text).collect()
}

fn primes(order: u8) -> String {
    match order {
        0 => String::new(),
        1 => "′".to_string(),
        2 => "″".to_string(),
        _ => format!("⁽{}⁾", superscript(u32::from(order))),
    }
}

fn superscript_signed(exponent: i8) -> String {
    let minus = if exponent < 0 { "⁻" } else { "" };
    format!("{minus}{}", superscript(u32::from(exponent.unsigned_abs())))
}

fn superscript(exponent: u32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raised = |c: char| c.to_digit(10).map_or(c, |digit| DIGITS[digit as usize]);
    exponent.to_string().chars().map(raised).collect()
}
