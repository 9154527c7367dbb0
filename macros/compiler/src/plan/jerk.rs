//! Third derivatives of outputs `with jerk`.
//!
//! In: the stages of a mechanism, and the motion of an output. Out: [`Jerks`]: for each block upstream of the output a linear system for
//! the third derivatives of its unknowns, and those of the output's components. Not done here: printing.
//!
//! ```text
//! q⃛ of a computed unknown    derivative of its acceleration along the motion
//! x⃛ of a block r(x) = 0      r_x x⃛ = −d³r/dt³ at x⃛ = 0
//! ```

use super::outputs::OutputCode;
use super::schedule;
use super::stage::{Iteration, Stage};
use super::words::Words;
use crate::expr::{Arena, Expr, Jets, Leaf, Seed, Substitution, derivative};
use crate::model::{Method, Model};
use crate::system::{OutputMotion, System};
use std::collections::BTreeSet;

/// The third derivatives of outputs with jerk.
#[derive(Default)]
pub(super) struct JerksOf {
    /// By output.
    pub(super) of_outputs: Vec<Option<Jerks>>,
    /// By slice.
    pub(super) of_slices: Vec<Option<Jerks>>,
}

impl JerksOf {
    pub(super) fn new(
        arena: &mut Arena,
        model: &Model,
        system: &System,
        stages: &[Stage],
        slices: &[OutputMotion],
        motions: &[OutputMotion],
    ) -> JerksOf {
        let n = system.coordinates.len();
        let mut jerks = |has_jerk: bool, motion: &OutputMotion| has_jerk.then(|| Jerks::new(arena, n, stages, motion));
        let of_outputs = model.outputs.iter().zip(motions).map(|(output, motion)| jerks(output.derivatives == 3, motion)).collect();
        let methods = model.methods.iter().filter(|method| method.is_slice);
        let has_jerk = |method: &Method| method.members.first().is_some_and(|member| model.outputs[*member].derivatives == 3);
        let of_slices = methods.zip(slices).map(|(method, motion)| jerks(has_jerk(method), motion)).collect();
        JerksOf { of_outputs, of_slices }
    }
}

/// Third derivatives of the components of an output.
#[derive(Clone, Debug)]
pub(super) struct Jerks {
    /// In order; each may contain third derivatives that an earlier one gives.
    pub(super) systems: Vec<JerkSystem>,
    pub(super) components: Vec<Expr>,
    zero: Expr,
}

/// The linear system for the third derivatives of a block.
#[derive(Clone, Debug)]
pub(super) struct JerkSystem {
    /// Indices in q.
    pub(super) unknowns: Vec<usize>,
    /// r_x by rows.
    pub(super) jacobian: Vec<Vec<Expr>>,
    /// Right-hand side.
    pub(super) sides: Vec<Expr>,
}

impl Jerks {
    /// Differentiates an output over `n` unknowns, and what is upstream of it, once more along the motion.
    pub(super) fn new(arena: &mut Arena, n: usize, stages: &[Stage], output: &OutputMotion) -> Jerks {
        let rates = (0..n as u32).map(Some).collect();
        let mut work = Differentiator { arena, jets: Jets::along(Seed::motion(rates).with_jerks()) };
        let components: Vec<Expr> = output.components.iter().map(|[_, _, acceleration]| work.rate(*acceleration)).collect();
        let mut needed = numbers(work.arena, &components);
        let mut upstream = Vec::new();
        for stage in stages.iter().rev() {
            if !stage.unknowns().iter().any(|unknown| needed.contains(unknown)) {
                continue;
            }
            let sides = match stage {
                Stage::Explicit { motion, .. } => vec![work.rate(motion[2])],
                Stage::Block(system) => work.sides(system),
                Stage::Check { .. } => continue,
            };
            needed.extend(numbers(work.arena, &sides));
            upstream.push((stage, sides));
        }
        upstream.reverse();
        in_order(arena, upstream, &components)
    }

    /// A stage that gives the third derivatives as well, if they are asked for.
    pub(super) fn asked_of(&self, stage: &Stage) -> Stage {
        let mut stage = stage.clone();
        if let Stage::Block(system) = &mut stage
            && let Some(own) = self.systems.iter().find(|own| own.unknowns == system.unknowns)
        {
            system.jerks.clone_from(&own.sides);
        }
        stage
    }

    /// The third derivatives of the components in the place of accelerations.
    pub(super) fn as_accelerations(&self) -> impl Iterator<Item = [Expr; 3]> {
        self.components.iter().map(|jerk| [self.zero, self.zero, *jerk])
    }

    /// Code that computes them from the coordinates, speeds and accelerations of a state.
    pub(super) fn code(&self, arena: &Arena, output: &OutputMotion, words: &Words) -> OutputCode {
        let of_system = |system: &JerkSystem| {
            let results = system.jacobian.iter().flatten().chain(&system.sides).copied().collect();
            let names = system.unknowns.iter().map(|unknown| words.leaf(Leaf::Jerk(*unknown as u32))).collect();
            (names, schedule::routine(arena, results, words))
        };
        let results = output.components.iter().zip(&self.components).flat_map(|(motion, jerk)| motion.iter().chain([jerk])).copied();
        OutputCode { systems: self.systems.iter().map(of_system).collect(), lines: schedule::routine(arena, results.collect(), words) }
    }
}

/// Substitutes the third derivatives that are known by then.
fn in_order(arena: &mut Arena, upstream: Vec<(&Stage, Vec<Expr>)>, components: &[Expr]) -> Jerks {
    let mut known = Substitution::new();
    let mut systems = Vec::new();
    for (stage, sides) in upstream {
        let sides: Vec<Expr> = sides.into_iter().map(|side| known.of(arena, side)).collect();
        let rests = sides.iter().all(|side| arena.as_constant(*side).is_some_and(|value| value.is_zero()));
        match stage {
            Stage::Block(system) if !rests => {
                let (unknowns, jacobian) = (system.unknowns.clone(), by_components(arena, system));
                systems.push(JerkSystem { unknowns, jacobian, sides });
            }
            _ => {
                for (unknown, side) in stage.unknowns().iter().zip(sides) {
                    known.replace(Leaf::Jerk(*unknown as u32), side);
                }
            }
        }
    }
    let components = components.iter().map(|component| known.of(arena, *component)).collect();
    Jerks { systems, components, zero: arena.integer(0) }
}

/// r_x, also by the components of quaternions.
pub(super) fn by_components(arena: &mut Arena, system: &Iteration) -> Vec<Vec<Expr>> {
    let mut jacobian = system.jacobian.clone();
    for (row, residual) in jacobian.iter_mut().zip(&system.residuals) {
        for column in system.quaternions.iter().flatten() {
            row[*column] = derivative(arena, *residual, Leaf::Coordinate(system.unknowns[*column] as u32));
        }
    }
    jacobian
}

/// The unknowns whose third derivatives occur.
fn numbers(arena: &Arena, roots: &[Expr]) -> BTreeSet<usize> {
    let number = |leaf: Leaf| if let Leaf::Jerk(number) = leaf { Some(number as usize) } else { None };
    arena.leaves_of(roots).into_iter().filter_map(number).collect()
}

struct Differentiator<'a> {
    arena: &'a mut Arena,
    jets: Jets,
}

impl Differentiator<'_> {
    /// Derivative along the motion.
    fn rate(&mut self, expr: Expr) -> Expr {
        self.jets.of(self.arena, expr)[1]
    }

    /// −d³r/dt³ with the third derivatives of its unknowns set to zero.
    fn sides(&mut self, system: &Iteration) -> Vec<Expr> {
        let zero = self.arena.integer(0);
        let mut still = Substitution::new();
        for unknown in &system.unknowns {
            still.replace(Leaf::Jerk(*unknown as u32), zero);
        }
        let side = |residual: &Expr| {
            let second = self.jets.of(self.arena, *residual)[2];
            let third = self.rate(second);
            let third = still.of(self.arena, third);
            self.arena.neg(third)
        };
        system.residuals.iter().map(side).collect()
    }
}
