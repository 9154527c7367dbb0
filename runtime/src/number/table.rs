//! Cubic splines through given points. In: knots and coefficients made by the compiler. Out: value and two derivatives.

/// A piecewise cubic with continuous second derivative.
///
/// On the interval [`knots[i]`, `knots[i + 1]`] its value is c0 + d (c1 + d (c2 + d c3)) with d = x − `knots[i]`
/// and \[c0, c1, c2, c3\] = `coefficients[i]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Table {
    /// Places of the given points, strictly increasing; two at least.
    pub knots: &'static [f64],
    /// One polynomial per interval, one fewer than there are knots.
    pub coefficients: &'static [[f64; 4]],
    /// The continuation outside the first and the last knot.
    pub ends: Ends,
    /// The numbers for evaluation in `f32`.
    pub single: Single,
}

/// The numbers of a [`Table`] for evaluation in `f32`, computed at compile time, so that no doubles are needed at run time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Single {
    /// Each knot as a sum of two: the nearest `f32` and the remainder.
    pub knots: &'static [[f32; 2]],
    /// The nearest `f32` of each coefficient.
    pub coefficients: &'static [[f32; 4]],
    /// Last knot − first knot as a sum of two.
    pub period: [f32; 2],
}

impl Single {
    /// The knots of a table, each as a sum of two.
    #[must_use]
    pub const fn knots<const K: usize>(knots: &[f64; K]) -> [[f32; 2]; K] {
        let mut split = [[0.0; 2]; K];
        let mut i = 0;
        while i < K {
            split[i] = halves(knots[i]);
            i += 1;
        }
        split
    }

    /// The coefficients of a table, rounded.
    #[must_use]
    pub const fn coefficients<const I: usize>(coefficients: &[[f64; 4]; I]) -> [[f32; 4]; I] {
        let mut rounded = [[0.0; 4]; I];
        let mut i = 0;
        while i < I {
            let [c0, c1, c2, c3] = coefficients[i];
            rounded[i] = [c0 as f32, c1 as f32, c2 as f32, c3 as f32];
            i += 1;
        }
        rounded
    }

    /// The period of a table as a sum of two.
    #[must_use]
    pub const fn period<const K: usize>(knots: &[f64; K]) -> [f32; 2] {
        if K == 0 { [0.0; 2] } else { halves(knots[K - 1] - knots[0]) }
    }
}

/// The nearest `f32` and the remainder.
const fn halves(value: f64) -> [f32; 2] {
    let high = value as f32;
    let low = (value - high as f64) as f32;
    [high, if low.is_finite() { low } else { 0.0 }]
}

/// Extrapolation of a [`Table`] outside its knots.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ends {
    /// Periodic with period last knot − first knot.
    Periodic,
    /// Linear along the end tangent; the spline is natural, so that the second derivative is continuous at the ends too.
    Linear,
    /// Constant value of the nearer end, with both derivatives zero; the spline has horizontal end tangents.
    Hold,
}

impl Table {
    /// Value, first and second derivative at `x`. NaN for NaN and for a table without an interval.
    ///
    /// These operations, in this order, are the definition that the compiler's interpreter repeats:
    ///
    /// ```text
    /// Periodic: x ← x − period · floor((x − first) / period),   period = last − first
    /// i = number of knots ≤ x, less one, clamped to the intervals (after rounding, x may lie just outside)
    /// d = x − knots[i];   v = c0 + d·(c1 + d·(c2 + d·c3));   v' = c1 + d·(2·c2 + d·(3·c3));   v" = 2·c2 + d·(6·c3)
    /// Linear, x beyond an end e:  v(e) + v'(e)·(x − e),  v'(e),  0
    /// Hold,   x beyond an end e:  v(e),  0,  0
    /// ```
    #[must_use]
    pub fn evaluate(&self, x: f64) -> (f64, f64, f64) {
        let (Some(&first), Some(&last)) = (self.knots.first(), self.knots.last()) else {
            return (f64::NAN, f64::NAN, f64::NAN);
        };
        let end = if x < first { first } else { last };
        let outside = x < first || x > last;
        match self.ends {
            Ends::Periodic => {
                let period = last - first;
                self.cubic(x - period * libm::floor((x - first) / period))
            }
            Ends::Linear if outside => {
                let (value, slope, _) = self.cubic(end);
                (value + slope * (x - end), slope, 0.0)
            }
            Ends::Hold if outside => (self.cubic(end).0, 0.0, 0.0),
            Ends::Linear | Ends::Hold => self.cubic(x),
        }
    }

    /// Third derivative at `x`: constant between knots; at a knot, that of the following interval.
    pub(crate) fn third_derivative(&self, x: f64) -> f64 {
        let (Some(&first), Some(&last)) = (self.knots.first(), self.knots.last()) else { return f64::NAN };
        let x = match self.ends {
            Ends::Periodic => x - (last - first) * libm::floor((x - first) / (last - first)),
            Ends::Linear | Ends::Hold if x < first || x > last => return 0.0,
            Ends::Linear | Ends::Hold => x,
        };
        let interval = self.knots.partition_point(|&knot| knot <= x).min(self.coefficients.len()).saturating_sub(1);
        self.coefficients.get(interval).map_or(f64::NAN, |[_, _, _, c3]| 6.0 * c3)
    }

    /// Value and derivatives at `x` of the polynomial whose interval contains `x` or lies nearest to it.
    fn cubic(&self, x: f64) -> (f64, f64, f64) {
        let reached = self.knots.partition_point(|&knot| knot <= x);
        let interval = reached.min(self.coefficients.len()).saturating_sub(1);
        let (Some(knot), Some([c0, c1, c2, c3])) = (self.knots.get(interval), self.coefficients.get(interval)) else {
            return (f64::NAN, f64::NAN, f64::NAN);
        };
        let d = x - knot;
        (c0 + d * (c1 + d * (c2 + d * c3)), c1 + d * (2.0 * c2 + d * (3.0 * c3)), 2.0 * c2 + d * (6.0 * c3))
    }
}

impl Table {
    /// Value, first and second derivative at `x` without operations on doubles: the formulas of [`evaluate`](Self::evaluate), where the
    /// distance from a knot, which is stored to the digits of a double, is taken before any multiplication.
    ///
    /// So `x` is used exactly as stored, also near a large knot and after up to 2²³ periods. Only rounding errors of the polynomial
    /// remain: with u = 2⁻²⁴ and d the width of the interval, below 8 u (|c0| + d |c1| + d² |c2| + d³ |c3|) for the value,
    /// 8 u (|c1| + 2 d |c2| + 3 d² |c3|) for the first derivative, and 8 u (2 |c2| + 6 d |c3|) for the second. On a tangent d is the
    /// distance from the end, and the errors of value and slope at the end are added.
    #[must_use]
    pub fn evaluate_single(&self, x: f32) -> (f32, f32, f32) {
        let Single { knots, period, .. } = &self.single;
        let (Some(&first), Some(&last)) = (knots.first(), knots.last()) else { return (f32::NAN, f32::NAN, f32::NAN) };
        let is_before = beyond(x, first) < 0.0;
        let end = if is_before { first } else { last };
        let is_outside = is_before || beyond(x, last) > 0.0;
        match self.ends {
            Ends::Periodic => {
                let near = shifted([x, 0.0], libm::floorf(beyond(x, first) / period[0]), *period);
                // The floor of a rounded quotient may be one period off.
                let turn = if difference(near, first) < 0.0 {
                    -1.0
                } else if difference(near, last) >= 0.0 {
                    1.0
                } else {
                    0.0
                };
                self.cubic_single(shifted(near, turn, *period))
            }
            Ends::Linear if is_outside => {
                let (value, slope, _) = self.cubic_single(end);
                (value + slope * beyond(x, end), slope, 0.0)
            }
            Ends::Hold if is_outside => (self.cubic_single(end).0, 0.0, 0.0),
            Ends::Linear | Ends::Hold => self.cubic_single([x, 0.0]),
        }
    }

    /// Value and derivatives at a place, given as a sum of two, of the polynomial whose interval contains it or lies nearest to it.
    fn cubic_single(&self, x: [f32; 2]) -> (f32, f32, f32) {
        let Single { knots, coefficients, .. } = &self.single;
        let reached = knots.partition_point(|&knot| difference(x, knot) >= 0.0);
        let interval = reached.min(coefficients.len()).saturating_sub(1);
        let (Some(&knot), Some([c0, c1, c2, c3])) = (knots.get(interval), coefficients.get(interval)) else {
            return (f32::NAN, f32::NAN, f32::NAN);
        };
        let d = difference(x, knot);
        (c0 + d * (c1 + d * (c2 + d * c3)), c1 + d * (2.0 * c2 + d * (3.0 * c3)), 2.0 * c2 + d * (6.0 * c3))
    }
}

/// x − knot
fn beyond(x: f32, knot: [f32; 2]) -> f32 {
    difference([x, 0.0], knot)
}

/// a − b; the high parts first, which are mostly close to each other and subtract exactly.
fn difference(a: [f32; 2], b: [f32; 2]) -> f32 {
    (a[0] - b[0]) + (a[1] - b[1])
}

/// x less some whole periods, as a sum of two.
fn shifted(x: [f32; 2], turns: f32, period: [f32; 2]) -> [f32; 2] {
    let [high, low] = product(turns, period[0]);
    let [rest, lost] = sum(x[0], -high);
    sum(rest, lost + (x[1] - low - turns * period[1]))
}

/// a + b as a sum of two, without rounding.
///
/// Reference: Knuth, The Art of Computer Programming, volume 2, section 4.2.2.
fn sum(a: f32, b: f32) -> [f32; 2] {
    let high = a + b;
    let part = high - a;
    [high, (a - (high - part)) + (b - part)]
}

/// a b as a sum of two, without rounding.
///
/// Reference: Dekker (1971), A floating-point technique for extending the available precision.
fn product(a: f32, b: f32) -> [f32; 2] {
    let (high, [a1, a2], [b1, b2]) = (a * b, parts(a), parts(b));
    [high, a2 * b2 - (((high - a1 * b1) - a2 * b1) - a1 * b2)]
}

/// A number as a sum of two with half as many digits.
fn parts(value: f32) -> [f32; 2] {
    let large = 4097.0 * value;
    let high = large - (large - value);
    [high, value - high]
}
