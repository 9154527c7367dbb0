//! Linear dependence of rows, tested at several poses of a mechanism at once.
//!
//! In: one matrix per pose, all with the same rows and columns. Out: a set of independent rows, and for every other row the rows of which
//! it is a combination. A row counts as dependent if it is dependent at most poses: at a single, singular pose even independent rows may
//! become dependent.
//!
//! ```text
//! v = r − V Vᵀ r        component of a row r orthogonal to the orthonormal rows V, by Gram-Schmidt, applied twice
//! ```
//!
//! Reference: Giraud, Langou, Rozložník (2005), The loss of orthogonality in the Gram-Schmidt orthogonalization process: twice is enough.

/// Rows of unit length, or zero.
pub(crate) type Matrix = Vec<Vec<f64>>;

/// A unit row is dependent if the length of its component orthogonal to the other rows is below this. Poses are closed to rounding, so that
/// a real dependence shows to about ten digits; a mechanism that is to be built stays away from singular configurations by more than 1e-6.
pub(crate) const DEPENDENT: f64 = 1e-7;

/// Coefficients of a linear combination count as zero below this fraction of the largest.
const ABSENT: f64 = 1e-6;

/// Lower bound of the orthogonal component when rows are compared over many poses, so that one bad pose does not decide.
const FAINTEST: f64 = 1e-3;

/// Basis of independent rows, at all poses.
pub(crate) struct Basis<'a> {
    poses: &'a [Matrix],
    spans: Vec<Span>,
}

/// Basis of the rows at one pose.
#[derive(Clone, Default)]
struct Span {
    /// Orthonormal vectors.
    vectors: Vec<Vec<f64>>,
    /// Row from which each vector was made.
    members: Vec<usize>,
    /// Coefficients of each vector as a combination of the members up to its own.
    shares: Vec<Vec<f64>>,
}

impl<'a> Basis<'a> {
    /// An empty basis.
    pub(crate) fn new(poses: &'a [Matrix]) -> Basis<'a> {
        Basis { poses, spans: vec![Span::default(); poses.len()] }
    }

    /// Length of the component of a row orthogonal to the basis, at each pose.
    fn left(&self, row: usize) -> impl Iterator<Item = f64> {
        self.poses.iter().zip(&self.spans).map(move |(pose, span)| length(&span.beside(&pose[row]).0))
    }

    /// True if the row is independent of the basis, at most poses.
    pub(crate) fn lacks(&self, row: usize) -> bool {
        let independent = self.left(row).filter(|left| *left > DEPENDENT).count();
        2 * independent > self.poses.len()
    }

    /// Smallest component of a row orthogonal to the basis, over all poses.
    pub(crate) fn adds(&self, row: usize) -> f64 {
        self.left(row).fold(1.0, f64::min)
    }

    /// Score of a row as the next member of the basis: Σ ln of its orthogonal component, over all poses.
    pub(crate) fn fitness(&self, row: usize) -> f64 {
        self.left(row).map(|left| left.max(FAINTEST).ln()).sum()
    }

    /// Adds a row to the basis.
    pub(crate) fn take(&mut self, row: usize) {
        for (pose, span) in self.poses.iter().zip(&mut self.spans) {
            span.take(row, &pose[row]);
        }
    }

    /// Adds a row if it is independent of the basis; true if it was added.
    pub(crate) fn takes(&mut self, row: usize) -> bool {
        let lacks = self.lacks(row);
        if lacks {
            self.take(row);
        }
        lacks
    }

    /// Members of the basis on which a row depends, at any pose.
    pub(crate) fn sources(&self, row: usize) -> Vec<usize> {
        let mut sources: Vec<usize> = Vec::new();
        for (pose, span) in self.poses.iter().zip(&self.spans) {
            let (rest, parts) = span.beside(&pose[row]);
            if length(&rest) <= DEPENDENT {
                sources.extend(span.made_of(&parts));
            }
        }
        sources.sort_unstable();
        sources.dedup();
        sources
    }

    /// Columns that the basis does not determine: the null space of its rows has a component along them.
    pub(crate) fn free(&self, columns: usize) -> Vec<usize> {
        let is_free = |column: &usize| {
            let mut unit = vec![0.0; columns];
            unit[*column] = 1.0;
            let poses = self.spans.iter().filter(|span| length(&span.beside(&unit).0) > ABSENT.sqrt()).count();
            2 * poses > self.spans.len()
        };
        (0..columns).filter(is_free).collect()
    }
}

impl Span {
    /// Component of a row orthogonal to the vectors, and its coordinates along them.
    fn beside(&self, row: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let mut rest = row.to_vec();
        let mut parts = vec![0.0; self.vectors.len()];
        for _ in 0..2 {
            for (part, vector) in parts.iter_mut().zip(&self.vectors) {
                let along: f64 = rest.iter().zip(vector).map(|(a, b)| a * b).sum();
                rest.iter_mut().zip(vector).for_each(|(a, b)| *a -= along * b);
                *part += along;
            }
        }
        (rest, parts)
    }

    fn take(&mut self, row: usize, values: &[f64]) {
        let (mut vector, parts) = self.beside(values);
        let size = length(&vector);
        if size <= DEPENDENT {
            // Singular pose.
            return;
        }
        vector.iter_mut().for_each(|entry| *entry /= size);
        let mut shares = self.sum(&parts);
        shares.iter_mut().for_each(|share| *share /= -size);
        shares.push(1.0 / size);
        self.vectors.push(vector);
        self.members.push(row);
        self.shares.push(shares);
    }

    /// Rewrites a combination of vectors as a combination of members.
    fn sum(&self, parts: &[f64]) -> Vec<f64> {
        let mut sum = vec![0.0; self.members.len()];
        for (part, shares) in parts.iter().zip(&self.shares) {
            sum.iter_mut().zip(shares).for_each(|(total, share)| *total += part * share);
        }
        sum
    }

    /// Members with a nonzero coefficient in a combination of vectors.
    fn made_of(&self, parts: &[f64]) -> Vec<usize> {
        let sum = self.sum(parts);
        let largest = sum.iter().fold(0.0, |largest: f64, share| largest.max(share.abs()));
        self.members.iter().zip(&sum).filter(|(_, share)| share.abs() > ABSENT * largest).map(|(member, _)| *member).collect()
    }
}

fn length(vector: &[f64]) -> f64 {
    vector.iter().map(|entry| entry * entry).sum::<f64>().sqrt()
}
