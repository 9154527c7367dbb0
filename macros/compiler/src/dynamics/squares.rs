//! Sums of products in which squares of the sine and the cosine of one angle meet.
//!
//! ```text
//! a sin²x + a cos²x = a
//! ```
//!
//! The inertia of a body that turns about a fixed axis does not depend on its angle: its centre's speeds along two axes, squared and added,
//! say so by this law alone.

use crate::expr::{Arena, Binary, Exact, Expr, Lookup, Node, Unary};
use std::collections::BTreeMap;

/// Sums of more products than this stay as they are.
const MOST_PRODUCTS: usize = 64;

/// The same for products of more factors.
const MOST_FACTORS: usize = 16;

/// A sum of products: factors in ascending order, and the number before them.
type Products = BTreeMap<Vec<Expr>, Exact>;

/// The same value with squares of sines and cosines added up, if that takes fewer operations.
pub(super) fn folded(arena: &mut Arena, expr: Expr) -> Expr {
    let Some(mut products) = products(arena, expr) else { return expr };
    let mut is_folded = false;
    while let Some((ones, other, rest)) = products.keys().find_map(|factors| pair(arena, &products, factors)) {
        let Some(number) = products.remove(&ones) else { return expr };
        products.remove(&other);
        if add(&mut products, rest, number).is_none() {
            return expr;
        }
        is_folded = true;
    }
    if !is_folded {
        return expr;
    }
    let sum = written(arena, &products);
    if operations(arena, sum) < operations(arena, expr) { sum } else { expr }
}

/// For a product with the square of a sine: itself, the one with the square of the cosine instead if it has the same number, and the rest
/// of both.
fn pair(arena: &Arena, products: &Products, factors: &[Expr]) -> Option<(Vec<Expr>, Vec<Expr>, Vec<Expr>)> {
    factors.windows(2).enumerate().filter(|(_, two)| two[0] == two[1]).find_map(|(at, two)| {
        let Node::Unary(Unary::Sin, angle) = *arena.node(two[0]) else { return None };
        let rest = [&factors[..at], &factors[at + 2..]].concat();
        let is_match = |other: &&Vec<Expr>| {
            products[*other] == products[factors] && {
                let mut left = rest.clone();
                let mut cosines = Vec::new();
                for factor in other.iter() {
                    match left.iter().position(|own| own == factor) {
                        Some(place) => _ = left.remove(place),
                        None => cosines.push(*factor),
                    }
                }
                left.is_empty() && cosines.len() == 2 && cosines.iter().all(|one| *arena.node(*one) == Node::Unary(Unary::Cos, angle))
            }
        };
        products.keys().find(is_match).map(|other| (factors.to_vec(), other.clone(), rest))
    })
}

/// An expression as a sum of products; `None` if there are too many, or if a number does not fit.
fn products(arena: &Arena, root: Expr) -> Option<Products> {
    let is_factor = |node: &Node| match node {
        Node::Unary(function, _) => *function != Unary::Neg,
        Node::Binary(function, ..) => *function == Binary::Atan2,
        _ => true,
    };
    let mut known: Lookup<Expr, Products> = Lookup::default();
    for expr in arena.reachable_above(&[root], is_factor) {
        let of = |part: Expr| known.get(&part).cloned();
        let alone = Products::from([(vec![expr], Exact::ONE)]);
        let found = match *arena.node(expr) {
            Node::Constant(value) => scaled(Products::from([(Vec::new(), Exact::ONE)]), value)?,
            Node::Unary(Unary::Neg, a) => scaled(of(a)?, Exact::integer(-1))?,
            Node::Binary(Binary::Add, a, b) => sum(of(a)?, of(b)?)?,
            Node::Binary(Binary::Sub, a, b) => sum(of(a)?, scaled(of(b)?, Exact::integer(-1))?)?,
            Node::Binary(Binary::Mul, a, b) => product(&of(a)?, &of(b)?)?,
            Node::Binary(Binary::Div, a, b) => match arena.as_constant(b) {
                Some(number) => scaled(of(a)?, Exact::ONE.checked_div(number)?)?,
                None => alone,
            },
            _ => alone,
        };
        known.insert(expr, found);
    }
    known.remove(&root)
}

fn scaled(products: Products, number: Exact) -> Option<Products> {
    let scaled = products.into_iter().map(|(factors, own)| Some((factors, own.checked_mul(number)?)));
    scaled.filter(|product| product.as_ref().is_none_or(|(_, number)| !number.is_zero())).collect()
}

fn sum(mut one: Products, two: Products) -> Option<Products> {
    for (factors, number) in two {
        add(&mut one, factors, number)?;
    }
    Some(one)
}

fn product(one: &Products, two: &Products) -> Option<Products> {
    let mut all = Products::new();
    for (left, number) in one {
        for (right, other) in two {
            let mut factors = [left.as_slice(), right].concat();
            if factors.len() > MOST_FACTORS {
                return None;
            }
            factors.sort_unstable();
            add(&mut all, factors, number.checked_mul(*other)?)?;
        }
    }
    Some(all)
}

/// Adds a product; `None` if there are too many.
fn add(products: &mut Products, factors: Vec<Expr>, number: Exact) -> Option<()> {
    let before = products.remove(&factors).unwrap_or(Exact::ZERO);
    let after = before.checked_add(number)?;
    if !after.is_zero() {
        products.insert(factors, after);
    }
    (products.len() <= MOST_PRODUCTS).then_some(())
}

fn written(arena: &mut Arena, products: &Products) -> Expr {
    let mut sum = arena.integer(0);
    for (factors, number) in products {
        let mut term = arena.integer(1);
        for factor in factors {
            term = arena.mul(term, *factor);
        }
        let number = arena.constant(*number);
        term = arena.mul(number, term);
        sum = arena.add(sum, term);
    }
    sum
}

/// Number of sums and products.
fn operations(arena: &Arena, root: Expr) -> usize {
    let is_operation = |expr: &Expr| matches!(arena.node(*expr), Node::Binary(..) | Node::Unary(Unary::Neg, _));
    arena.reachable(&[root]).iter().filter(|expr| is_operation(expr)).count()
}
