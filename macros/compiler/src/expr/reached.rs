//! Nodes reached in an arena, in the order of their indices.

use super::Expr;

/// Bits of a word.
const WORD: usize = u64::BITS as usize;

/// A set of nodes: a bit for each, and a bit for each word that is not zero.
pub(super) struct Reached {
    nodes: Vec<u64>,
    words: Vec<u64>,
}

impl Reached {
    /// An empty set for nodes with indices below `end`.
    pub(super) fn new(end: usize) -> Reached {
        let words = end.div_ceil(WORD);
        Reached { nodes: vec![0; words], words: vec![0; words.div_ceil(WORD)] }
    }

    /// Adds a node; true if it is new.
    pub(super) fn takes(&mut self, expr: Expr) -> bool {
        let word = expr.index() / WORD;
        let bit = 1 << (expr.index() % WORD);
        let is_new = self.nodes[word] & bit == 0;
        self.nodes[word] |= bit;
        self.words[word / WORD] |= 1 << (word % WORD);
        is_new
    }

    /// The nodes in the order of their indices, `count` of them.
    pub(super) fn in_order(&self, count: usize) -> Vec<Expr> {
        let mut found = Vec::with_capacity(count);
        for (number, words) in self.words.iter().enumerate() {
            each_bit(*words, |word| {
                let word = number * WORD + word;
                each_bit(self.nodes[word], |node| found.push(Expr((word * WORD + node) as u32)));
            });
        }
        found
    }
}

/// Calls a function with the position of each bit that is set.
fn each_bit(mut bits: u64, mut call: impl FnMut(usize)) {
    while bits != 0 {
        call(bits.trailing_zeros() as usize);
        bits &= bits - 1;
    }
}
