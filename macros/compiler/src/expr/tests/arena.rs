use std::collections::BTreeSet;

use super::expr;
use crate::expr::{Arena, Exact, Jets, Leaf, Seed, derivative, evaluate, show};

#[test]
fn the_same_node_has_the_same_place() {
    let mut arena = Arena::new();
    let first = expr(&mut arena, "sin(x)*y + f(t)");
    let size = arena.len();
    assert_eq!(expr(&mut arena, "f(t) + y*sin(x)"), first);
    assert_eq!(arena.len(), size);
}

#[test]
fn children_are_older_than_parents() {
    let mut arena = Arena::new();
    let root = expr(&mut arena, "if(x, y, sqrt(x*x + y*y), atan2(x, f(y)))");
    let order = arena.reachable(&[root]);
    assert!(order.is_sorted() && order.last() == Some(&root));
    for &parent in &order {
        assert!(arena.node(parent).children().all(|child| child < parent));
    }
}

#[test]
fn what_is_reachable_is_listed_once() {
    let mut arena = Arena::new();
    let (a, b) = (expr(&mut arena, "x*y"), expr(&mut arena, "x*y + x"));
    let unused = expr(&mut arena, "z");
    let found = arena.reachable(&[b, a, b]);
    assert_eq!(found.len(), 4);
    assert!(!found.contains(&unused));
    assert_eq!(arena.reachable(&[]), []);
}

#[test]
fn leaves_are_what_an_expression_depends_on() {
    let mut arena = Arena::new();
    let root = expr(&mut arena, "x*y + sin(t) - x*p*0");
    let expected = BTreeSet::from([Leaf::Time, Leaf::Coordinate(0), Leaf::Coordinate(1)]);
    assert_eq!(arena.leaves(root), expected);
}

#[test]
fn powers_are_products() {
    let mut arena = Arena::new();
    let x = expr(&mut arena, "x");
    for (exponent, product) in [(0, "1"), (1, "x"), (2, "x*x"), (3, "x*(x*x)"), (5, "x*((x*x)*(x*x))"), (-1, "1/x"), (-2, "1/(x*x)")] {
        assert_eq!(arena.power(x, exponent), expr(&mut arena, product), "{exponent}");
    }
    let two = arena.integer(2);
    let kibi = arena.power(two, -10);
    assert_eq!(arena.as_constant(kibi), Exact::ratio(1, 1024));
    arena.power(x, i32::MIN);
}

#[test]
fn exact_or_not_folded() {
    let mut arena = Arena::new();
    let large = Exact::ratio(1 << 119, 1).unwrap();
    let large = arena.constant(large);
    let four = arena.integer(4);
    let product = arena.mul(large, four);
    assert_eq!(arena.as_constant(product), None);
    let sum = expr(&mut arena, "1 + pi");
    assert_eq!(arena.as_constant(sum), None);
    let found = evaluate(&arena, &[product, sum], &super::Point::random(&mut super::random::Random::new(3)).values());
    assert_eq!(found, [libm::ldexp(1.0, 121), 1.0 + std::f64::consts::PI]);
}

#[test]
fn deep_expressions_do_not_overflow_the_stack() {
    let mut arena = Arena::new();
    let x = expr(&mut arena, "x");
    let mut root = x;
    for _ in 0..30_000 {
        let sine = arena.sin(root);
        root = arena.add(sine, x);
    }
    let slope = derivative(&mut arena, root, Leaf::Coordinate(0));
    let [_, first, _] = Jets::along(Seed::motion((0..8).map(Some).collect())).of(&mut arena, root);
    let point = super::Point::random(&mut super::random::Random::new(4));
    let expected = point.speeds[0] * point.value_of(&arena, slope);
    super::assert_close(point.value_of(&arena, first), expected, 1e-9, "deep");
    let text = show(&arena, root, &|_| "x".to_string(), &|_| String::new());
    assert!(text.chars().count() <= 400);
}
