//! Numbers that look random and are the same on every run.

use super::formula::Tree;
use crate::expr::{Binary, Exact, Leaf, Unary};

/// Marsaglia's xorshift generator with 64 bits of state.
pub(crate) struct Random(u64);

impl Random {
    /// A generator for a seed other than 0.
    pub(crate) fn new(seed: u64) -> Self {
        Random(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    /// A whole number from 0 to `end`, without `end`.
    pub(crate) fn below(&mut self, end: u64) -> u64 {
        (self.next() >> 11) % end
    }

    /// A number between two others.
    pub(super) fn between(&mut self, low: f64, high: f64) -> f64 {
        let unit = (self.next() >> 11) as f64 / (1_u64 << 53) as f64;
        low + unit * (high - low)
    }

    fn one_of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len() as u64) as usize]
    }

    /// A formula at most `depth` operations deep, rich in what the rules look for.
    pub(super) fn tree(&mut self, depth: u32) -> Tree {
        if depth == 0 || self.below(8) == 0 {
            return self.operand();
        }
        let mut below = || Box::new(self.tree(depth - 1));
        let (a, b, c, d) = (below(), below(), below(), below());
        match self.below(16) {
            0..=2 => Tree::Unary(Unary::Neg, a),
            3 => Tree::Unary(self.one_of(UNARY), a),
            4 => Tree::Select([a, b, c, d]),
            5 => Tree::Unary(self.one_of(&[Unary::Abs, Unary::Sign]), a),
            // Equal operands are rare by chance.
            6 => Tree::Binary(self.one_of(BINARY), a.clone(), a),
            _ => Tree::Binary(self.one_of(BINARY), a, b),
        }
    }

    fn operand(&mut self) -> Tree {
        if self.below(2) == 0 {
            let leaf = Leaf::Coordinate(self.below(3) as u32);
            return Tree::Leaf(leaf);
        }
        let (above, below) = (self.below(9) as i128 - 4, self.one_of(&[1, 1, 1, 2, 3, 10, 12]));
        let ratio = Exact::ratio(above, below).unwrap_or(Exact::ZERO);
        let angle = self.below(4) == 0;
        Tree::Constant(if angle { ratio.checked_mul(Exact::PI).unwrap_or(ratio) } else { ratio })
    }
}

const BINARY: &[Binary] = &[Binary::Add, Binary::Add, Binary::Sub, Binary::Sub, Binary::Mul, Binary::Mul, Binary::Div, Binary::Atan2];

const UNARY: &[Unary] = &[Unary::Sqrt, Unary::Sin, Unary::Cos, Unary::Tan, Unary::Asin, Unary::Acos, Unary::Atan, Unary::Exp, Unary::Ln];
