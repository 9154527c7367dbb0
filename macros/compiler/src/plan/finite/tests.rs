use super::super::stage::{Origin, Stage};
use super::{tested, unsure};
use crate::expr::{Arena, Expr, Leaf, Unary};

/// What is tested of unknowns with these values.
fn tested_of(arena: &mut Arena, values: &[Expr], held: impl Fn(usize) -> bool) -> Vec<usize> {
    let zero = arena.integer(0);
    let stage = |(unknown, value): (usize, &Expr)| Stage::Explicit { unknown, origin: Origin::Output, motion: [*value, zero, zero] };
    let stages: Vec<Stage> = values.iter().enumerate().map(stage).collect();
    tested(&unsure(arena, &stages), held)
}

fn coordinates(arena: &mut Arena) -> [Expr; 3] {
    [0, 1, 2].map(|index| arena.leaf(Leaf::Coordinate(index)))
}

#[test]
fn one_unknown_is_enough_for_a_pole() {
    let mut arena = Arena::default();
    let [a, b, c] = coordinates(&mut arena);
    let sum = arena.add(a, b);
    let (first, second) = (arena.div(a, sum), arena.div(b, sum));
    let other = arena.div(a, c);
    let both = arena.mul(second, other);
    assert_eq!(tested_of(&mut arena, &[sum, first, second, other, both], |_| true), [1, 3]);
    // The pole is shown by the next of those that are held.
    assert_eq!(tested_of(&mut arena, &[sum, first, second, other, both], |unknown| unknown != 1), [2, 3]);
}

#[test]
fn a_quotient_hides_the_poles_of_its_divisor() {
    let mut arena = Arena::default();
    let [a, b, c] = coordinates(&mut arena);
    let inverse = arena.div(a, b);
    let more = arena.add(inverse, c);
    let hidden = arena.div(c, more);
    // 0 where b is 0.
    assert_eq!(tested_of(&mut arena, &[hidden, inverse], |_| true), [0, 1]);
    assert_eq!(tested_of(&mut arena, &[inverse, hidden], |_| true), [0, 1]);
}

#[test]
fn a_choice_and_an_exponential_show_no_poles_of_their_operands() {
    let mut arena = Arena::default();
    let [a, b, c] = coordinates(&mut arena);
    let inverse = arena.div(a, b);
    let chosen = arena.select(c, a, inverse, c);
    let power = arena.unary(Unary::Exp, inverse);
    assert_eq!(tested_of(&mut arena, &[chosen, power], |_| true), [1, 0]);
    assert_eq!(tested_of(&mut arena, &[chosen, power, inverse], |_| true), [1, 2]);
    // A square root shows its own domain and the poles under it.
    let root = arena.sqrt(inverse);
    assert_eq!(tested_of(&mut arena, &[root, inverse], |_| true), [0]);
}

#[test]
fn unknowns_of_values_from_outside_are_all_tested() {
    let mut arena = Arena::default();
    let [a, ..] = coordinates(&mut arena);
    let length = arena.leaf(Leaf::Parameter(0));
    let (product, square) = (arena.mul(length, a), arena.square(length));
    assert_eq!(tested_of(&mut arena, &[length, product, square, a], |_| true), [0, 1, 2]);
}
