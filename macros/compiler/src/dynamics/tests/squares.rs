//! Squares of sines and cosines in sums of products.

use crate::dynamics::squares::folded;
use crate::expr::{Arena, Exact, Expr, Leaf};

/// sin q, cos q, sin p, cos p.
fn circles(arena: &mut Arena) -> [[Expr; 2]; 2] {
    [0, 1].map(|number| {
        let angle = arena.leaf(Leaf::Coordinate(number));
        [arena.sin(angle), arena.cos(angle)]
    })
}

/// one · two + three · four
fn products(arena: &mut Arena, [one, two, three, four]: [Expr; 4]) -> Expr {
    let (left, right) = (arena.mul(one, two), arena.mul(three, four));
    arena.add(left, right)
}

#[test]
fn the_inertia_of_a_turning_bar_is_a_number() {
    let mut arena = Arena::new();
    let [[sine, cosine], _] = circles(&mut arena);
    // A centre at (a, b) of the body moves by −(a sin q + b cos q) and a cos q − b sin q.
    let [a, b] = [(7, 4), (-1, 5)].map(|(above, below)| arena.constant(Exact::ratio(above, below).expect("a small number")));
    let x = products(&mut arena, [a, sine, b, cosine]);
    let minus_b = arena.neg(b);
    let y = products(&mut arena, [a, cosine, minus_b, sine]);
    let sum = products(&mut arena, [x, x, y, y]);
    // 49/16 + 1/25
    let wanted = arena.constant(Exact::ratio(1241, 400).expect("a small number"));
    assert_eq!(folded(&mut arena, sum), wanted);
}

#[test]
fn parameters_are_kept_as_factors() {
    let mut arena = Arena::new();
    let [[sine, cosine], [other, _]] = circles(&mut arena);
    let length = arena.leaf(Leaf::Parameter(0));
    let [x, y] = [sine, cosine].map(|part| arena.mul(length, part));
    let squares = products(&mut arena, [x, x, y, y]);
    let sum = arena.add(squares, other);
    let square = arena.square(length);
    let found = folded(&mut arena, sum);
    let (one, two) = (arena.add(square, other), arena.add(other, square));
    assert!(found == one || found == two);
}

#[test]
fn sums_without_squares_of_one_angle_stay_as_they_are() {
    let mut arena = Arena::new();
    let [[sine, cosine], [of_other, cosine_of_other]] = circles(&mut arena);
    let neighbours = products(&mut arena, [sine, of_other, cosine, cosine_of_other]);
    let squares_of_two = products(&mut arena, [sine, sine, cosine_of_other, cosine_of_other]);
    let three = arena.integer(3);
    let heavy = arena.mul(three, sine);
    let unequal = products(&mut arena, [heavy, sine, cosine, cosine]);
    for sum in [neighbours, squares_of_two, unequal] {
        assert_eq!(folded(&mut arena, sum), sum);
    }
}
