//! Hash maps of nodes and indices, the most frequent lookups of the compiler.
//!
//! ```text
//! h ← (h + word) · 0xf1357aea2e62a9c5      for each word of a key; at last the high bits, which depend on all of it, become the low ones
//! ```
//!
//! The default hash function guards against keys that are chosen to collide. Keys of the compiler are not, and that function takes a sixth of the
//! time of compilation where the compiler is not optimised, as in builds with the default profile.
//!
//! Reference: Knuth, The Art of Computer Programming, volume 3, section 6.4; a multiplier without short patterns is that of Steele and Vigna (2022).

use std::collections::{HashMap, HashSet};
use std::hash::{BuildHasherDefault, Hasher};

/// A hash map that is only looked up: the order of its entries is arbitrary and must not reach the output.
pub(crate) type Lookup<K, V> = HashMap<K, V, BuildHasherDefault<Multiplied>>;

/// A hash set of which the order is arbitrary.
pub(crate) type Members<K> = HashSet<K, BuildHasherDefault<Multiplied>>;

const FACTOR: u64 = 0xf135_7aea_2e62_a9c5;

/// Number of bits by which the hash is rotated at last.
const ROTATED: u32 = 26;

/// A hash by multiplication.
#[derive(Clone, Copy, Default)]
pub(crate) struct Multiplied(u64);

impl Hasher for Multiplied {
    fn write(&mut self, bytes: &[u8]) {
        for chunk in bytes.chunks(8) {
            let mut word = [0; 8];
            word[..chunk.len()].copy_from_slice(chunk);
            self.write_u64(u64::from_le_bytes(word));
        }
    }

    fn write_u8(&mut self, word: u8) {
        self.write_u64(u64::from(word));
    }

    fn write_u32(&mut self, word: u32) {
        self.write_u64(u64::from(word));
    }

    fn write_u64(&mut self, word: u64) {
        self.0 = self.0.wrapping_add(word).wrapping_mul(FACTOR);
    }

    fn write_u128(&mut self, word: u128) {
        self.write_u64(word as u64);
        self.write_u64((word >> 64) as u64);
    }

    fn write_usize(&mut self, word: usize) {
        self.write_u64(word as u64);
    }

    fn write_isize(&mut self, word: isize) {
        self.write_u64(word as u64);
    }

    fn finish(&self) -> u64 {
        self.0.rotate_left(ROTATED)
    }
}
