//! Stages of the solution for q, q̇ and q̈, as expressions.

use super::routine::Cost;
use crate::expr::{Arena, Expr, Leaf};

/// One stage of the solution for q, q̇ and q̈.
#[derive(Clone, Debug)]
pub enum Stage {
    /// A computed unknown.
    Explicit {
        /// Index in q.
        unknown: usize,
        /// Where it comes from.
        origin: Origin,
        /// Value, rate and acceleration.
        motion: [Expr; 3],
    },
    /// Unknowns that are solved together.
    Block(Iteration),
    /// An equation that is checked instead of solved.
    Check {
        /// Index in Φ.
        equation: usize,
        /// Left minus right side.
        residual: Expr,
        /// Rounding scales of the residual: sum of the magnitudes of its terms, and derivatives by lengths and by angles, whose own errors
        /// show in it.
        sizes: [Expr; 3],
    },
}

/// Where a computed unknown comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// The equation with this index in Φ determines it.
    Equation(usize),
    /// It is a direction cosine of a body that hangs, directly or through others, from this one.
    Orientation(usize),
    /// It is a component of an output.
    Output,
}

impl Stage {
    /// Unknowns that the stage computes.
    pub(super) fn unknowns(&self) -> &[usize] {
        match self {
            Stage::Explicit { unknown, .. } => std::slice::from_ref(unknown),
            Stage::Block(system) => &system.unknowns,
            Stage::Check { .. } => &[],
        }
    }

    /// True if time or an input occurs in its expressions.
    pub(super) fn depends_on_time(&self, arena: &Arena) -> bool {
        arena.leaves_of(&self.results()).into_iter().any(Leaf::is_of_time)
    }

    /// All results of the stage.
    pub(super) fn results(&self) -> Vec<Expr> {
        match self {
            Stage::Explicit { motion, .. } => motion.to_vec(),
            Stage::Check { residual, sizes, .. } => [*residual].into_iter().chain(*sizes).collect(),
            Stage::Block(Iteration { residuals, jacobian, sizes, rates, accelerations, jerks, .. }) => {
                [residuals, sizes, rates, accelerations].into_iter().chain(jacobian).chain([jerks]).flatten().copied().collect()
            }
        }
    }
}

impl Iteration {
    /// The system with other unknowns, equations and expressions; expressions in the order of [`Stage::results`].
    pub(super) fn with(&self, unknowns: Vec<usize>, equations: Vec<usize>, results: &[Expr]) -> Iteration {
        let k = self.residuals.len();
        let mut lists = results.chunks(k.max(1)).map(<[Expr]>::to_vec);
        let mut next = || lists.next().unwrap_or_default();
        let [residuals, sizes, rates, accelerations] = [next(), next(), next(), next()];
        let (elimination, quaternions) = (self.elimination.clone(), self.quaternions.clone());
        let jacobian = lists.by_ref().take(k).collect();
        let jerks = lists.next().unwrap_or_default();
        Iteration { unknowns, equations, residuals, sizes, elimination, rates, accelerations, jerks, jacobian, quaternions }
    }
}

/// A system solved by Newton's method.
#[derive(Clone, Debug)]
pub struct Iteration {
    /// Indices in q.
    pub unknowns: Vec<usize>,
    /// Indices in Φ.
    pub equations: Vec<usize>,
    /// r
    pub residuals: Vec<Expr>,
    /// r_x by rows; of the columns by [`quaternions`](Self::quaternions) those of M, where r_x = M D.
    pub jacobian: Vec<Vec<Expr>>,
    /// Indices among the unknowns of quaternions that the linear system replaces by their norm and three turns.
    pub quaternions: Vec<[usize; 4]>,
    /// Rounding scales of r: sums of the magnitudes of its terms.
    pub sizes: Vec<Expr>,
    /// Elimination of its Jacobian, if not in closed form.
    pub elimination: Option<Box<Elimination>>,
    /// Right-hand side of the velocity equation.
    pub rates: Vec<Expr>,
    /// Right-hand side of the acceleration equation.
    pub accelerations: Vec<Expr>,
    /// Right-hand side of the equation of third derivatives, where an output asks for them.
    pub jerks: Vec<Expr>,
}

/// A fixed order of elimination. Indices are those in the block.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Elimination {
    /// Row and column of each entry of the Jacobian that is not always zero, row by row.
    pub pattern: Vec<(usize, usize)>,
    /// Row of each pivot.
    pub rows: Vec<usize>,
    /// Column of each pivot.
    pub columns: Vec<usize>,
    /// Row and column of each entry of L and U, by pivot number, row by row.
    pub factors: Vec<(usize, usize)>,
    /// For each pivot, true if it is the constant 1 or −1, so that no division is needed.
    pub is_unit: Vec<bool>,
    /// Operations of one factorisation.
    pub cost: Cost,
}
