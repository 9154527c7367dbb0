//! Which rows depend on which, at several poses of a mechanism at once.
//!
//! In: a matrix for each pose, all with the same rows and columns. Out: rows that are independent, and for any other row which of
//! these it is made of. A row counts as dependent if it is so at most poses: a single pose may be a special one, at which even
//! independent rows fall together.
//!
//! ```text
//! v = r − V Vᵀ r        what is left of a row r beside the orthonormal rows V, by Gram and Schmidt, twice
//! ```
//!
//! Reference: Giraud, Langou, Rozložník (2005), The loss of orthogonality in the Gram-Schmidt orthogonalization process: twice is
//! enough.

/// Rows of unit length, or of none.
pub(crate) type Matrix = Vec<Vec<f64>>;

/// A row of unit length of which less than this is left beside others depends on them. Poses are closed to rounding, and a
/// dependence that is real then shows to some ten digits, while a mechanism that is to be built stays away from singular
/// positions by more than a millionth.
pub(crate) const DEPENDENT: f64 = 1e-7;

/// A share of a combination below this is none.
const ABSENT: f64 = 1e-6;

/// What is left of a row counts up to this when rows are compared over many poses, so that one bad pose does not decide.
const FAINTEST: f64 = 1e-3;

/// Independent rows.
pub(crate) struct Basis<'a> {
    poses: &'a [Matrix],
    spans: Vec<Span>,
}

/// The rows at one pose.
#[derive(Clone, Default)]
struct Span {
    /// Orthonormal.
    vectors: Vec<Vec<f64>>,
    /// The row that each vector was made for.
    members: Vec<usize>,
    /// Each vector as a sum of the members up to its own.
    shares: Vec<Vec<f64>>,
}

impl<'a> Basis<'a> {
    /// No rows yet.
    pub(crate) fn new(poses: &'a [Matrix]) -> Basis<'a> {
        Basis { poses, spans: vec![Span::default(); poses.len()] }
    }

    /// What is left of a row beside those taken, at each pose.
    fn left(&self, row: usize) -> impl Iterator<Item = f64> {
        self.poses.iter().zip(&self.spans).map(move |(pose, span)| length(&span.beside(&pose[row]).0))
    }

    /// The row does not follow from those taken.
    pub(crate) fn lacks(&self, row: usize) -> bool {
        let independent = self.left(row).filter(|left| *left > DEPENDENT).count();
        2 * independent > self.poses.len()
    }

    /// What a row adds to those taken at the pose where it adds least.
    pub(crate) fn adds(&self, row: usize) -> f64 {
        self.left(row).fold(1.0, f64::min)
    }

    /// How well a row goes with those taken, over all poses: the logarithm of what is left of it.
    pub(crate) fn fitness(&self, row: usize) -> f64 {
        self.left(row).map(|left| left.max(FAINTEST).ln()).sum()
    }

    /// Takes a row.
    pub(crate) fn take(&mut self, row: usize) {
        for (pose, span) in self.poses.iter().zip(&mut self.spans) {
            span.take(row, &pose[row]);
        }
    }

    /// Takes a row if it does not follow from those taken; whether it did.
    pub(crate) fn takes(&mut self, row: usize) -> bool {
        let lacks = self.lacks(row);
        if lacks {
            self.take(row);
        }
        lacks
    }

    /// The rows taken from which another one follows, at one pose or another.
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

    /// The columns that the rows taken leave free.
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
    /// What is left of a row, and its parts along the vectors.
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
            // A special pose.
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

    /// A sum of vectors as a sum of members.
    fn sum(&self, parts: &[f64]) -> Vec<f64> {
        let mut sum = vec![0.0; self.members.len()];
        for (part, shares) in parts.iter().zip(&self.shares) {
            sum.iter_mut().zip(shares).for_each(|(total, share)| *total += part * share);
        }
        sum
    }

    /// The members in a sum of vectors.
    fn made_of(&self, parts: &[f64]) -> Vec<usize> {
        let sum = self.sum(parts);
        let largest = sum.iter().fold(0.0, |largest: f64, share| largest.max(share.abs()));
        self.members.iter().zip(&sum).filter(|(_, share)| share.abs() > ABSENT * largest).map(|(member, _)| *member).collect()
    }
}

fn length(vector: &[f64]) -> f64 {
    vector.iter().map(|entry| entry * entry).sum::<f64>().sqrt()
}
