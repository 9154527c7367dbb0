//! One step on the way to q, q̇ and q̈, as expressions.

use super::routine::Cost;
use crate::expr::{Arena, Expr, Leaf};

/// One step on the way to q, q̇ and q̈.
#[derive(Clone, Debug)]
pub enum Stage {
    /// An unknown that is computed.
    Explicit {
        /// Its index in q.
        unknown: usize,
        /// Index in Φ of the equation that gives it.
        equation: usize,
        /// Value, rate and acceleration.
        motion: [Expr; 3],
    },
    /// Unknowns that are found together.
    Block(Iteration),
    /// An equation that must hold of itself.
    Check {
        /// Index in Φ.
        equation: usize,
        /// Its left minus its right side.
        residual: Expr,
        /// What its rounding errors are a share of: its terms, and how much it changes with lengths, and with angles, whose own errors
        /// it shows.
        sizes: [Expr; 3],
    },
}

impl Stage {
    /// The unknowns that it finds.
    pub(super) fn unknowns(&self) -> &[usize] {
        match self {
            Stage::Explicit { unknown, .. } => std::slice::from_ref(unknown),
            Stage::Block(system) => &system.unknowns,
            Stage::Check { .. } => &[],
        }
    }

    /// Time itself is in its expressions.
    pub(super) fn depends_on_time(&self, arena: &Arena) -> bool {
        self.results().iter().any(|result| arena.leaves(*result).contains(&Leaf::Time))
    }

    /// Everything that is computed for it.
    pub(super) fn results(&self) -> Vec<Expr> {
        match self {
            Stage::Explicit { motion, .. } => motion.to_vec(),
            Stage::Check { residual, sizes, .. } => [*residual].into_iter().chain(*sizes).collect(),
            Stage::Block(Iteration { residuals, jacobian, sizes, rates, accelerations, .. }) => {
                [residuals, sizes, rates, accelerations].into_iter().chain(jacobian).flatten().copied().collect()
            }
        }
    }
}

impl Iteration {
    /// The system with other unknowns, equations and expressions, these in the order of [`Stage::results`].
    pub(super) fn with(&self, unknowns: Vec<usize>, equations: Vec<usize>, results: &[Expr]) -> Iteration {
        let k = self.residuals.len();
        let mut lists = results.chunks(k.max(1)).map(<[Expr]>::to_vec);
        let mut next = || lists.next().unwrap_or_default();
        let [residuals, sizes, rates, accelerations] = [next(), next(), next(), next()];
        let elimination = self.elimination.clone();
        Iteration { unknowns, equations, residuals, sizes, elimination, rates, accelerations, jacobian: lists.collect() }
    }
}

/// A system that Newton's method solves.
#[derive(Clone, Debug)]
pub struct Iteration {
    /// Indices in q.
    pub unknowns: Vec<usize>,
    /// Indices in Φ.
    pub equations: Vec<usize>,
    /// r
    pub residuals: Vec<Expr>,
    /// r_x by rows
    pub jacobian: Vec<Vec<Expr>>,
    /// What the rounding errors of r are a share of: the sum of the magnitudes of its terms.
    pub sizes: Vec<Expr>,
    /// How its Jacobian is eliminated, if not in closed form.
    pub elimination: Option<Box<Elimination>>,
    /// Right side of the velocity equation.
    pub rates: Vec<Expr>,
    /// Right side of the acceleration equation.
    pub accelerations: Vec<Expr>,
}

/// A fixed order of elimination. Indices are those in the block.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Elimination {
    /// Row and column of each entry of the Jacobian that is not always zero, row by row.
    pub pattern: Vec<(usize, usize)>,
    /// The row of each pivot.
    pub rows: Vec<usize>,
    /// The column of each pivot.
    pub columns: Vec<usize>,
    /// Row and column of each entry of L and U, by number of the pivot, row by row.
    pub factors: Vec<(usize, usize)>,
    /// Whether each pivot is the number 1 or −1, so that nothing is divided by it.
    pub is_unit: Vec<bool>,
    /// Operations of one factorisation.
    pub cost: Cost,
}
