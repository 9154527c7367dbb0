//! From a model to unknowns and equations; from here on there are no joints, only their names.
//!
//! In: a [`Model`]. Out: a [`System`]: for every scalar equation Φ, its row of Φ_q, ν and γ as
//! expressions in one arena, and for every output its value, rate and acceleration. Not done
//! here: any decision on how to solve.
//!
//! ```text
//! ν = −Φ_t                 at fixed q
//! γ = −d²/ds² Φ(q + s q̇, t + s) at s = 0
//! ```

mod magnitude;
mod pattern;

use crate::diag::{Diag, Fact};
use crate::expr::{Arena, Derivatives, Expr, Jets, Leaf, Substitution};
use crate::model::{Model, Said};
use crate::quantity::{Dim, Role};
use crate::structure::Pattern;
use std::collections::BTreeMap;

pub(crate) use magnitude::magnitude;

/// Unknowns and equations.
#[derive(Clone, Debug)]
pub struct System {
    /// All expressions.
    pub arena: Arena,
    /// One for each coordinate, in the order of q.
    pub unknowns: Vec<Unknown>,
    /// One for each row, in the order declared.
    pub equations: Vec<Equation>,
    /// Which equation contains which unknown.
    pub pattern: Pattern,
    /// One for each output, in the order declared.
    pub outputs: Vec<OutputMotion>,
    /// The largest of these is the characteristic length: local coordinates of points, or, if all points are origins, the lengths
    /// that joints and drives demand.
    pub lengths: Vec<Expr>,
}

/// One coordinate.
#[derive(Clone, Debug)]
pub struct Unknown {
    /// Index of its body in the model.
    pub body: usize,
    /// Its part in the placement of the body.
    pub role: Role,
    /// Its declared start value, a function of parameters.
    pub start: Option<Expr>,
}

/// One row.
#[derive(Clone, Debug)]
pub struct Equation {
    /// Index of its joint in the model.
    pub joint: usize,
    /// Its number within the joint, from 0.
    pub row: usize,
    /// What Φ measures.
    pub dim: Dim,
    /// Φ; a velocity-level row has none.
    pub phi: Option<Expr>,
    /// The entries of its row of Φ_q that are not identically zero, by unknown.
    pub jacobian: Vec<(usize, Expr)>,
    /// ν
    pub nu: Expr,
    /// γ
    pub gamma: Expr,
}

/// An output's components.
#[derive(Clone, Debug)]
pub struct OutputMotion {
    /// Value, rate and acceleration of each component.
    pub components: Vec<[Expr; 3]>,
}

impl System {
    /// The name of an unknown: `crank.angle`.
    pub(crate) fn name(&self, model: &Model, unknown: usize) -> String {
        let unknown = &self.unknowns[unknown];
        format!("{}.{}", model.bodies[unknown.body].name, unknown.role.name())
    }

    /// The equations of a joint of the model; those of one joint stand together, in the order of joints.
    pub(crate) fn of_joint(&self, joint: usize) -> &[Equation] {
        let first = self.equations.partition_point(|equation| equation.joint < joint);
        let rest = &self.equations[first..];
        &rest[..rest.partition_point(|equation| equation.joint == joint)]
    }
}

/// Differentiates every residual and output of a model.
pub(crate) fn assemble(model: &Model, diag: &mut Diag) -> Option<System> {
    let mut arena = model.arena.clone();
    let unknowns = unknowns(model);
    let mut equations = Vec::new();
    let mut by_coordinate: Vec<Derivatives> = (0..unknowns.len()).map(|index| Derivatives::new(Leaf::Coordinate(index as u32))).collect();
    let mut by_time = Derivatives::new(Leaf::Time);
    let mut along = Jets::at_constant_velocity();
    for (joint, declared) in model.joints.iter().enumerate() {
        for (row, residual) in declared.residuals.iter().enumerate() {
            let phi = residual.expr;
            let mut jacobian = Vec::new();
            for leaf in arena.leaves(phi) {
                let Leaf::Coordinate(index) = leaf else { continue };
                let entry = by_coordinate[index as usize].of(&mut arena, phi);
                if !arena.as_constant(entry).is_some_and(|value| value.is_zero()) {
                    jacobian.push((index as usize, entry));
                }
            }
            let rate = by_time.of(&mut arena, phi);
            let nu = arena.neg(rate);
            let [_, _, second] = along.of(&mut arena, phi);
            let gamma = arena.neg(second);
            equations.push(Equation { joint, row, dim: residual.dim, phi: Some(phi), jacobian, nu, gamma });
        }
    }
    let mut motion = Jets::new();
    let outputs = model
        .outputs
        .iter()
        .map(|output| OutputMotion { components: output.components.iter().map(|part| motion.of(&mut arena, *part)).collect() });
    let outputs = outputs.collect();
    let lengths = lengths(&mut arena, model, &unknowns, &equations);
    has_bodies(model, diag);
    no_joint_repeats_another(model, &mut arena, diag);
    let pattern = pattern::pattern(model, &arena, unknowns.len(), &equations);
    diag.is_clean().then_some(System { arena, unknowns, equations, pattern, outputs, lengths })
}

fn unknowns(model: &Model) -> Vec<Unknown> {
    let of_body = |(body, declared): (usize, &crate::model::Body)| {
        declared
            .coordinates
            .iter()
            .map(move |coordinate| Unknown { body, role: coordinate.role, start: coordinate.start })
            .collect::<Vec<_>>()
    };
    model.bodies.iter().enumerate().flat_map(of_body).collect()
}

/// The lengths in the declaration that tell how large the mechanism is.
fn lengths(arena: &mut Arena, model: &Model, unknowns: &[Unknown], equations: &[Equation]) -> Vec<Expr> {
    let is_zero = |length: &Expr| arena.as_constant(*length).is_some_and(|value| value.is_zero());
    if !model.lengths.iter().all(is_zero) {
        return model.lengths.clone();
    }
    let all: Vec<usize> = (0..unknowns.len()).collect();
    let mut at_start = Substitution::new();
    let zero = arena.integer(0);
    at_start.replace(Leaf::Time, zero);
    let mut lengths = Vec::new();
    for equation in equations {
        let Some(phi) = equation.phi.filter(|_| [Dim::LENGTH, Dim::LENGTH.times(Dim::LENGTH)].contains(&equation.dim)) else { continue };
        let terms = magnitude(arena, phi, &all, unknowns);
        let terms = at_start.of(arena, terms);
        lengths.push(if equation.dim == Dim::LENGTH { terms } else { arena.sqrt(terms) });
    }
    lengths
}

fn has_bodies(model: &Model, diag: &mut Diag) {
    if model.bodies.is_empty() {
        diag.refuse::<()>(&model.name, Fact::NoBodies { name: model.name.to_string() });
    }
}

/// A joint whose every equation stands already in another one adds nothing.
fn no_joint_repeats_another(model: &Model, arena: &mut Arena, diag: &mut Diag) {
    if !diag.is_clean() || model.equations_only {
        return;
    }
    let mut said = Said::default();
    let mut owners: BTreeMap<Expr, usize> = BTreeMap::new();
    for (index, joint) in model.joints.iter().enumerate() {
        let earlier: Option<Vec<usize>> = joint.residuals.iter().map(|residual| owners.get(&residual.expr).copied()).collect();
        if let Some(other) = earlier.and_then(|earlier| earlier.first().copied())
            && !joint.is_redundant
            && said.is_new(&joint.name)
        {
            let other = model.joints[other].name.to_string();
            diag.refuse::<()>(&joint.name, Fact::Repeats { joint: joint.name.to_string(), other });
        }
        for residual in &joint.residuals {
            owners.entry(residual.expr).or_insert(index);
            // With its sides exchanged an equation demands the same.
            let exchanged = arena.neg(residual.expr);
            owners.entry(exchanged).or_insert(index);
        }
    }
}
