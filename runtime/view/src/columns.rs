//! Integer columns with one entry for each frame, as text: differences as variable-length quantities in base 64, the encoding of source
//! maps. A slowly varying column takes one letter for each frame; equal columns are stored once.

use std::collections::BTreeMap;

const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Continuation bit of a six-bit digit.
const MORE: u64 = 32;

/// Columns by number.
#[derive(Clone, Debug, Default)]
pub(crate) struct Columns {
    pub(crate) all: Vec<Vec<i64>>,
    known: BTreeMap<Vec<i64>, usize>,
}

impl Columns {
    /// The number of a column; a new column is added.
    pub(crate) fn number(&mut self, column: &[i64]) -> usize {
        if let Some(number) = self.known.get(column) {
            return *number;
        }
        let number = self.all.len();
        self.known.insert(column.to_vec(), number);
        self.all.push(column.to_vec());
        number
    }
}

/// A column as text.
pub(crate) fn encode(column: &[i64]) -> String {
    let mut text = String::with_capacity(column.len());
    let mut before = 0_i64;
    for value in column {
        quantity(&mut text, value.wrapping_sub(before));
        before = *value;
    }
    text
}

/// Zigzag encoding: the sign in the lowest bit, then digits of five bits, the lowest first.
fn quantity(text: &mut String, value: i64) {
    let mut rest = (value.unsigned_abs() << 1) | u64::from(value < 0);
    loop {
        let (digit, above) = (rest & (MORE - 1), rest >> 5);
        let more = if above > 0 { MORE } else { 0 };
        text.push(char::from(DIGITS[usize::try_from(digit | more).unwrap_or(0)]));
        if above == 0 {
            return;
        }
        rest = above;
    }
}
