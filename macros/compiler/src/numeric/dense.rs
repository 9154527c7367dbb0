//! Factors of a small dense matrix, with the sign of its determinant.

/// P A = L U by elimination with pivots from the column.
pub(crate) struct Factors {
    lu: Vec<Vec<f64>>,
    order: Vec<usize>,
    /// Of the determinant; 0 of a singular matrix.
    pub(crate) sign: f64,
    /// ln |det A|
    pub(crate) size: f64,
}

impl Factors {
    /// `None` where an entry is no number.
    pub(crate) fn new(mut a: Vec<Vec<f64>>) -> Option<Factors> {
        let n = a.len();
        let (mut sign, mut size) = (1.0, 0.0);
        let mut order: Vec<usize> = (0..n).collect();
        for k in 0..n {
            let pivot = (k..n).max_by(|one, two| a[*one][k].abs().total_cmp(&a[*two][k].abs()))?;
            if pivot != k {
                a.swap(k, pivot);
                order.swap(k, pivot);
                sign = -sign;
            }
            let (done, rest) = a.split_at_mut(k + 1);
            let pivot = done[k][k];
            if !pivot.is_finite() {
                return None;
            }
            sign *= if pivot == 0.0 { 0.0 } else { pivot.signum() };
            size += pivot.abs().ln();
            for row in rest {
                if row[k] != 0.0 {
                    row[k] /= pivot;
                    let multiplier = row[k];
                    row[k + 1..].iter_mut().zip(&done[k][k + 1..]).for_each(|(entry, above)| *entry -= multiplier * above);
                }
            }
        }
        Some(Factors { lu: a, order, sign, size })
    }

    /// A⁻¹ b; `None` of a singular matrix.
    pub(crate) fn solve(&self, b: &[f64]) -> Option<Vec<f64>> {
        let n = b.len();
        let mut x: Vec<f64> = self.order.iter().map(|row| b[*row]).collect();
        for k in 0..n {
            let known: f64 = (0..k).map(|j| self.lu[k][j] * x[j]).sum();
            x[k] -= known;
        }
        for k in (0..n).rev() {
            let known: f64 = (k + 1..n).map(|j| self.lu[k][j] * x[j]).sum();
            x[k] = (x[k] - known) / self.lu[k][k];
        }
        x.iter().all(|value| value.is_finite()).then_some(x)
    }
}
