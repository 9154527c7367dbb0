use super::expr;
use crate::expr::{Arena, Expr, Leaf, show};

fn shown(arena: &Arena, root: Expr) -> String {
    let name = |leaf: Leaf| match leaf {
        Leaf::Time => "t".to_string(),
        Leaf::Parameter(i) => format!("p{i}"),
        Leaf::Datum(i) | Leaf::Turn(i) => format!("d{i}"),
        Leaf::Input { number, order } => format!("i{number}_{order}"),
        Leaf::Coordinate(i) => ["x", "y", "z"][i as usize % 3].to_string(),
        Leaf::Speed(i) => ["ẋ", "ẏ", "ż"][i as usize % 3].to_string(),
        Leaf::Acceleration(i) => ["ẍ", "ÿ", "z̈"][i as usize % 3].to_string(),
        Leaf::Jerk(i) => ["x⃛", "y⃛", "z⃛"][i as usize % 3].to_string(),
    };
    show(arena, root, &name, &|number| ["lift", "law"][number as usize % 2].to_string())
}

#[test]
fn formulas_have_no_more_parentheses_than_needed() {
    for (written, expected) in [
        ("x + y*z", "x + y·z"),
        ("(x + y)*z", "z·(x + y)"),
        ("x - (y - z)", "x - (y - z)"),
        ("x - (y + z)", "x - (y + z)"),
        ("x + (y + z)", "x + y + z"),
        ("x/(y*z)", "x/(y·z)"),
        ("x*y/z", "x·y/z"),
        ("-(x*y)", "-x·y"),
        ("-(x + y)", "-(x + y)"),
        ("x*x + y*y", "x² + y²"),
        ("(x*x)*x - (x*x)*(x*x)", "x³ - x⁴"),
        ("(x + y)*(x + y)", "(x + y)²"),
        ("sin(x)*sin(x)", "sin(x)²"),
        ("sqrt(x*x + 1)", "√(x² + 1)"),
        ("atan2(x, -y)", "atan2(x, -y)"),
        ("abs(x)/ln(u)", "abs(x)/ln(ẋ)"),
        ("if(x, 1, y, z)", "if x < 1 { y } else { z }"),
        ("2*if(x, 1, y, z)", "2·(if x < 1 { y } else { z })"),
        ("f(x*t) + p", "p0 + lift(x·t)"),
    ] {
        let mut arena = Arena::new();
        // Operands are ordered by creation, so the leaves are created first.
        for leaf in ["p", "x", "y", "z", "t", "u"] {
            expr(&mut arena, leaf);
        }
        let root = expr(&mut arena, written);
        assert_eq!(shown(&arena, root), expected);
    }
}

#[test]
fn numbers_are_shown_as_people_write_them() {
    for (written, expected) in [
        ("0.12", "0.12"),
        ("2/3", "2/3"),
        ("-1/3", "-1/3"),
        ("x*2/3", "2·x/3"),
        ("x*(2/3)", "2/3·x"),
        ("x/pi", "x/π"),
        ("x*(2*pi/3)", "2π/3·x"),
        ("pi/6", "π/6"),
        ("1/pi", "π⁻¹"),
        ("pi*pi", "π²"),
        ("123456789", "123456789"),
        ("1/123456789", "0.000000008100000073710001"),
    ] {
        let mut arena = Arena::new();
        let root = expr(&mut arena, written);
        assert_eq!(shown(&arena, root), expected);
    }
}

#[test]
fn derivatives_of_calls_carry_primes() {
    let mut arena = Arena::new();
    let x = expr(&mut arena, "x");
    for (order, expected) in [(1, "lift′(x)"), (2, "lift″(x)"), (3, "lift⁽³⁾(x)")] {
        let call = arena.call(0, order, x);
        assert_eq!(shown(&arena, call), expected);
    }
}

#[test]
fn what_is_too_long_is_cut() {
    let mut arena = Arena::new();
    let mut root = arena.integer(1);
    for i in 0..200 {
        let leaf = arena.leaf(Leaf::Parameter(i));
        let sine = arena.sin(leaf);
        root = arena.add(sine, root);
    }
    let text = shown(&arena, root);
    assert!(text.contains('…') && text.chars().count() <= 400, "{text}");
    assert_eq!(text.matches('(').count(), text.matches(')').count());
}
