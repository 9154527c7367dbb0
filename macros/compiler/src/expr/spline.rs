//! Tables of measured values as cubic splines with a continuous second derivative.

/// Extrapolation outside the range of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ends {
    /// Periodic repetition.
    Periodic,
    /// Straight line along the end tangent; the second derivative is zero at the ends.
    Linear,
    /// Constant end value; the slope is zero at the ends.
    Hold,
}

/// A cubic spline: on `[knots[i], knots[i+1]]`, with d = x − knots\[i\], it is
/// c0 + d (c1 + d (c2 + d c3)).
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// At least two abscissae, strictly increasing.
    pub knots: Vec<f64>,
    /// One row for each interval.
    pub coefficients: Vec<[f64; 4]>,
    /// Extrapolation outside the knots.
    pub ends: Ends,
}

impl Table {
    /// The spline through `(x, y)` pairs with strictly increasing x, at least two of them; for
    /// [`Ends::Periodic`] the last y equals the first.
    ///
    /// The slopes m_i at the knots solve
    /// m_{i−1}/h_{i−1} + 2 m_i (1/h_{i−1} + 1/h_i) + m_{i+1}/h_i = 3 (s_{i−1}/h_{i−1} + s_i/h_i)
    /// with the secant slopes s_i; the matrix is diagonally dominant, so elimination without
    /// pivoting is stable. Reference: de Boor, A Practical Guide to Splines, chapter IV.
    pub(crate) fn through(points: &[(f64, f64)], ends: Ends) -> Table {
        let intervals = points.len() - 1;
        let knots: Vec<f64> = points.iter().map(|point| point.0).collect();
        let widths: Vec<f64> = points.windows(2).map(|pair| pair[1].0 - pair[0].0).collect();
        let secants: Vec<f64> = points.windows(2).zip(&widths).map(|(pair, width)| (pair[1].1 - pair[0].1) / width).collect();
        let slopes = slopes(&widths, &secants, ends);
        let row = |i: usize| {
            let (width, secant) = (widths[i], secants[i]);
            let (left, right) = (slopes[i], slopes[i + 1]);
            [points[i].1, left, (3.0 * secant - 2.0 * left - right) / width, (left + right - 2.0 * secant) / (width * width)]
        };
        Table { knots, coefficients: (0..intervals).map(row).collect(), ends }
    }

    /// Value, first and second derivative. The runtime's `Table` does the same operations.
    pub fn evaluate(&self, x: f64) -> [f64; 3] {
        let (first, last) = (self.knots[0], self.knots[self.knots.len() - 1]);
        if x.is_nan() {
            return [x; 3];
        }
        let x = match self.ends {
            Ends::Periodic => x - (last - first) * libm::floor((x - first) / (last - first)),
            Ends::Linear if x < first => return self.tangent(0, first, x),
            Ends::Linear if x > last => return self.tangent(self.coefficients.len() - 1, last, x),
            Ends::Hold if x < first => return [self.polynomial(0, first)[0], 0.0, 0.0],
            Ends::Hold if x > last => return [self.polynomial(self.coefficients.len() - 1, last)[0], 0.0, 0.0],
            _ => x,
        };
        let after = self.knots.partition_point(|knot| *knot <= x);
        self.polynomial(after.saturating_sub(1).min(self.coefficients.len() - 1), x)
    }

    fn polynomial(&self, interval: usize, x: f64) -> [f64; 3] {
        let [c0, c1, c2, c3] = self.coefficients[interval];
        let d = x - self.knots[interval];
        [c0 + d * (c1 + d * (c2 + d * c3)), c1 + d * (2.0 * c2 + d * (3.0 * c3)), 2.0 * c2 + d * (6.0 * c3)]
    }

    fn tangent(&self, interval: usize, end: f64, x: f64) -> [f64; 3] {
        let [value, slope, _] = self.polynomial(interval, end);
        [value + (x - end) * slope, slope, 0.0]
    }
}

/// Slopes at the knots.
fn slopes(widths: &[f64], secants: &[f64], ends: Ends) -> Vec<f64> {
    let n = widths.len();
    let inner = |i: usize, before: usize| {
        let (a, b) = (1.0 / widths[before], 1.0 / widths[i]);
        (a, 2.0 * (a + b), b, 3.0 * (secants[before] * a + secants[i] * b))
    };
    if ends == Ends::Periodic {
        return periodic_slopes(&(0..n).map(|i| inner(i, (i + n - 1) % n)).collect::<Vec<_>>());
    }
    let mut rows: Vec<(f64, f64, f64, f64)> = (1..n).map(|i| inner(i, i - 1)).collect();
    let (start, end) = match ends {
        Ends::Hold => ((0.0, 1.0, 0.0, 0.0), (0.0, 1.0, 0.0, 0.0)),
        _ => ((0.0, 2.0, 1.0, 3.0 * secants[0]), (1.0, 2.0, 0.0, 3.0 * secants[n - 1])),
    };
    rows.insert(0, start);
    rows.push(end);
    tridiagonal(&rows)
}

/// Solves a tridiagonal system; each row is (below, diagonal, above, right-hand side).
fn tridiagonal(rows: &[(f64, f64, f64, f64)]) -> Vec<f64> {
    let mut reduced: Vec<(f64, f64)> = Vec::with_capacity(rows.len());
    for (i, (below, diagonal, above, right)) in rows.iter().enumerate() {
        let (factor, value) = if i == 0 { (0.0, 0.0) } else { reduced[i - 1] };
        let pivot = diagonal - below * factor;
        reduced.push((above / pivot, (right - below * value) / pivot));
    }
    let mut solution = vec![0.0; rows.len()];
    for i in (0..rows.len()).rev() {
        let next = if i + 1 < rows.len() { solution[i + 1] } else { 0.0 };
        solution[i] = reduced[i].1 - reduced[i].0 * next;
    }
    solution
}

/// Solves a cyclic tridiagonal system by one rank-one correction (Sherman and Morrison); the first
/// slope is repeated at the end.
fn periodic_slopes(rows: &[(f64, f64, f64, f64)]) -> Vec<f64> {
    let n = rows.len();
    if n < 3 {
        return small_periodic_slopes(rows);
    }
    // The corner entries are (0, n-1) = below of the first row and (n-1, 0) = above of the last.
    let (corner_right, corner_left) = (rows[0].0, rows[n - 1].2);
    let gamma = -rows[0].1;
    let mut main = rows.to_vec();
    main[0].1 -= gamma;
    main[n - 1].1 -= corner_left * corner_right / gamma;
    let mut correction = main.clone();
    for (i, row) in correction.iter_mut().enumerate() {
        row.3 = if i == 0 {
            gamma
        } else if i == n - 1 {
            corner_left
        } else {
            0.0
        };
    }
    let (mut solution, column) = (tridiagonal(&main), tridiagonal(&correction));
    let numerator = solution[0] + corner_right * solution[n - 1] / gamma;
    let factor = numerator / (1.0 + column[0] + corner_right * column[n - 1] / gamma);
    for (value, change) in solution.iter_mut().zip(&column) {
        *value -= factor * change;
    }
    solution.push(solution[0]);
    solution
}

/// One or two intervals, where the neighbours on both sides are the same knot.
fn small_periodic_slopes(rows: &[(f64, f64, f64, f64)]) -> Vec<f64> {
    if rows.len() == 1 {
        // A single interval with equal ends is a constant.
        return vec![0.0, 0.0];
    }
    let [(a0, d0, b0, r0), (a1, d1, b1, r1)] = [rows[0], rows[1]];
    let (off0, off1) = (a0 + b0, a1 + b1);
    let determinant = d0 * d1 - off0 * off1;
    let (first, second) = ((r0 * d1 - off0 * r1) / determinant, (d0 * r1 - off1 * r0) / determinant);
    vec![first, second, first]
}
