//! Exact elimination on rows whose dependence is known.

use super::dependent;
use crate::expr::tests::random::Random;
use crate::expr::{Arena, Expr, Leaf};

#[test]
fn rows_that_follow_from_others_are_found_with_the_others_and_what_is_left() {
    let mut random = Random::new(0xfeed_5eed_cafe_0001);
    for _ in 0..300 {
        let mut arena = Arena::new();
        let unknowns: Vec<Expr> = (0..5).map(|index| arena.leaf(Leaf::Coordinate(index))).collect();
        let mut sum = |arena: &mut Arena, terms: &[Expr]| {
            let zero = arena.integer(0);
            terms.iter().fold(zero, |sum, term| {
                let factor = arena.integer(random.below(7) as i64 + 1);
                let product = arena.mul(factor, *term);
                arena.add(sum, product)
            })
        };
        // Three rows that do not depend on each other, since each has a coordinate to itself; then one of two of them.
        let own: Vec<Expr> = (0..3).map(|row| sum(&mut arena, &[unknowns[row], unknowns[3], unknowns[4]])).collect();
        let follows = sum(&mut arena, &[own[2], own[0]]);
        let (shift, parameter) = (arena.integer(11), arena.leaf(Leaf::Parameter(0)));
        let (shifted, moved) = (arena.add(follows, shift), arena.sub(follows, parameter));
        for (row, left, terms) in [(follows, 0.0, 0), (shifted, 11.0, 0), (moved, 0.0, 1)] {
            let found = dependent(&arena, &[(0, own[0]), (1, own[1]), (2, own[2]), (3, row)]);
            let [found] = found.as_slice() else { panic!("{found:?}") };
            assert_eq!((found.row, found.others.iter().copied().collect::<Vec<_>>()), (3, vec![0, 2]));
            assert_eq!((found.left.constant.to_f64(), found.left.fixed.len()), (left, terms));
        }
    }
}
