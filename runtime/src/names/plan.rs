//! The plan by which a mechanism is solved, as readable data.

use core::fmt;

/// The stages of a solution, in order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Plan {
    /// Stages in the order of execution.
    pub stages: &'static [PlanStage],
    /// Operations of one state, without those in iterations.
    pub operations: Operations,
}

/// One stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub enum PlanStage {
    /// This coordinate, `"crank.x"`, is computed from those before it.
    Computed(&'static str),
    /// This equation, `"c (2 of 2)"`, follows from others: it is checked, not solved.
    Checked(&'static str),
    /// Coordinates that are iterated together by Newton's method.
    Iterated {
        /// Their names.
        unknowns: &'static [&'static str],
        /// The residual equations, `"b (2 of 2)"`.
        equations: &'static [&'static str],
        /// Operations of one Newton step, without the solution of its linear system.
        operations: Operations,
        /// Operations of one factorisation of its Jacobian; None for the closed form of up to three unknowns.
        elimination: Option<Operations>,
        /// Blocks with the same number share their operations, each applied to its own bodies.
        shape: usize,
    },
}

/// Operation counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Operations {
    /// Additions, subtractions and multiplications.
    pub flops: usize,
    /// Divisions and square roots.
    pub divisions: usize,
    /// Pairs of sine and cosine.
    pub sines: usize,
    /// Other functions.
    pub calls: usize,
}

impl Plan {
    /// Number of distinct shapes of iterated blocks; the size of the compiled code grows with it.
    #[must_use]
    pub fn shapes(&self) -> usize {
        let number = |stage: &PlanStage| if let PlanStage::Iterated { shape, .. } = stage { shape + 1 } else { 0 };
        self.stages.iter().map(number).max().unwrap_or(0)
    }

    /// The number of unknowns of each iterated block, in order.
    pub fn blocks(&self) -> impl Iterator<Item = usize> {
        self.stages.iter().filter_map(|stage| match stage {
            PlanStage::Computed(_) | PlanStage::Checked(_) => None,
            PlanStage::Iterated { unknowns, .. } => Some(unknowns.len()),
        })
    }
}

impl fmt::Display for Plan {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for stage in self.stages {
            match stage {
                PlanStage::Computed(name) => writeln!(f, "compute  {name}")?,
                PlanStage::Checked(name) => writeln!(f, "check    {name}")?,
                PlanStage::Iterated { unknowns, equations, operations, elimination, .. } => {
                    write!(f, "iterate  ")?;
                    list(f, unknowns)?;
                    write!(f, "  from  ")?;
                    list(f, equations)?;
                    write!(f, "  ({operations} each time")?;
                    if let Some(Operations { flops, divisions, .. }) = elimination {
                        write!(f, ", and for its elimination {flops} sums and products, {divisions} divisions")?;
                    }
                    writeln!(f, ")")?;
                }
            }
        }
        write!(f, "besides, once for each state: {}", self.operations)
    }
}

fn list(f: &mut fmt::Formatter<'_>, names: &[&str]) -> fmt::Result {
    for (position, name) in names.iter().enumerate() {
        write!(f, "{}{name}", if position == 0 { "" } else { ", " })?;
    }
    Ok(())
}

impl fmt::Display for Operations {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { flops, divisions, sines, calls } = self;
        write!(f, "{flops} sums and products, {divisions} divisions and roots, {sines} sine-cosine pairs, {calls} other functions")
    }
}
