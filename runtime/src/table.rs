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
    /// What holds outside the first and the last knot.
    pub ends: Ends,
}

/// How a [`Table`] goes on outside its knots.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ends {
    /// It repeats with period last knot − first knot.
    Periodic,
    /// It goes on along the tangent; made from a natural spline, so the second derivative is continuous there too.
    Linear,
    /// It keeps the value of the nearer end, with both derivatives zero; made from a spline with horizontal ends.
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

    /// Third derivative at `x`: constant from knot to knot, and at a knot that of the interval behind it.
    pub(crate) fn third_derivative(&self, x: f64) -> f64 {
        let (_, _, before) = self.evaluate(x);
        let (Some(&first), Some(&last)) = (self.knots.first(), self.knots.last()) else { return f64::NAN };
        let outside = !before.is_finite() || x < first || x > last;
        let x = match self.ends {
            Ends::Periodic => x - (last - first) * libm::floor((x - first) / (last - first)),
            Ends::Linear | Ends::Hold if outside => return 0.0,
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
