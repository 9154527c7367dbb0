//! Test cases encoded as bytes: any bytes are a case, and the same bytes always give the same case.

use reuleaux::Float;

/// A reader of bytes, which returns zeros after the last byte.
#[derive(Clone, Debug)]
pub(crate) struct Bytes<'a> {
    rest: &'a [u8],
    /// Largest magnitude of finite numbers.
    largest: f64,
}

/// Edge cases of `f64`, including those of `f32`.
const EDGES: [f64; 32] = [
    0.0,
    -0.0,
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::MAX,
    f64::MIN,
    f64::MIN_POSITIVE,
    5e-324,
    -5e-324,
    1e300,
    -1e300,
    1e-300,
    1e160,
    -1e160,
    1e-160,
    1e100,
    1e60,
    f32::MAX as f64,
    f32::MIN_POSITIVE as f64,
    1e-45,
    1e30,
    1e20,
    1e-20,
    1e16,
    9_007_199_254_740_993.0,
    1e10,
    -1e10,
    1e-10,
    86400.0,
    f64::EPSILON,
    1.0 + f64::EPSILON,
];

impl<'a> Bytes<'a> {
    /// Reads from the first byte on; finite numbers are limited to ±`largest`.
    #[must_use]
    pub(crate) fn new(bytes: &'a [u8], largest: f64) -> Self {
        Self { rest: bytes, largest }
    }

    /// True after the last byte.
    #[must_use]
    pub(crate) fn is_empty(&self) -> bool {
        self.rest.is_empty()
    }

    /// The next byte.
    pub(crate) fn next(&mut self) -> u8 {
        let (first, rest) = self.rest.split_first().unwrap_or((&0, &[]));
        self.rest = rest;
        *first
    }

    /// A whole number below `end`.
    pub(crate) fn below(&mut self, end: usize) -> usize {
        usize::from(self.next()) % end
    }

    /// True with probability 1/`times`.
    pub(crate) fn is_one_in(&mut self, times: usize) -> bool {
        self.below(times) == times - 1
    }

    /// A number from −1 to 1.
    pub(crate) fn share(&mut self) -> f64 {
        let [high, low] = [self.next(), self.next()];
        f64::from(i16::from_be_bytes([high, low])) / 32768.0
    }

    /// A number near another one or far from it, or an edge case, possibly infinite or NaN.
    pub(crate) fn number<T: Float>(&mut self, near: T) -> T {
        let value = near.to_f64();
        let number = match self.below(8) {
            0 => value,
            1 => value * (1.0 + 0.1 * self.share()),
            2 => value + self.share(),
            3 => value * 100.0 * self.share(),
            4 => 10.0 * self.share(),
            5 => value * 10_f64.powi(i32::from(self.next()) - 128),
            _ => EDGES[self.below(EDGES.len())],
        };
        T::of(if number.is_finite() { number.clamp(-self.largest, self.largest) } else { number })
    }
}
