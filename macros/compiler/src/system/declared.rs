//! The equations of a mechanism in space as declared: on positions and quaternions, by the speeds v and ω of each body.
//!
//! ```text
//! Φ_u = (∂Φ/∂r, ∂Φ/∂turns)      six columns a body, in the axes of ground
//! ν   = −Φ_t
//! γ   = −d²/ds² Φ(r + s v, exp(s ω) A, t + s) at s = 0
//! ```

use super::{Equation, Level, Unbalanced};
use crate::expr::{Arena, Derivatives, Expr, Jets, Leaf, Rate, Seed, Substitution, derivative};
use crate::model::DECLARED;
use crate::model::Model;
use crate::quantity::{Dim, Role};
use std::collections::HashMap;

/// Equations by the coordinates and speeds of bodies in space.
#[derive(Clone, Debug)]
pub struct DeclaredEquations {
    /// All expressions.
    pub arena: Arena,
    /// Number of coordinates: seven for each body, then the angles of joints.
    pub coordinates: usize,
    /// Number of speeds: six for each body.
    pub speeds: usize,
    /// One equation for each row, in the order declared.
    pub equations: Vec<Equation>,
    /// What forces and masses leave to joints and drives.
    pub unbalanced: Option<Unbalanced>,
}

/// Coordinates of a body, and speeds.
const EACH: [usize; 2] = [Role::SPACE.len(), 6];

/// Differentiates every residual of a model in space.
pub(super) fn declared(model: &Model) -> DeclaredEquations {
    let mut arena = model.arena.clone();
    let bodies = model.bodies.len();
    let zero = arena.integer(0);
    let rate = |coordinate: usize| {
        let (body, at) = (coordinate / EACH[0], coordinate % EACH[0]);
        if at < 3 { Rate::Speed(DECLARED + (EACH[1] * body + at) as u32) } else { Rate::Given([zero, zero]) }
    };
    let rates: Vec<Rate> = (0..EACH[0] * bodies).map(rate).collect();
    let mut along = Jets::along(Seed::constant_speeds(rates).numbered_from(DECLARED));
    let mut by_time = Derivatives::new(Leaf::Time);
    let by = |speed: usize| {
        let (body, at) = (speed / EACH[1], speed % EACH[1]);
        if at < 3 { Leaf::Coordinate(DECLARED + (EACH[0] * body + at) as u32) } else { Leaf::Turn((3 * body + at - 3) as u32) }
    };
    let mut by_speed: Vec<Derivatives> = (0..EACH[1] * bodies).map(|speed| Derivatives::new(by(speed))).collect();
    let mut equations = Vec::new();
    for (joint, declared) in model.joints.iter().enumerate() {
        for (row, residual) in declared.residuals.iter().enumerate() {
            let phi = residual.expr;
            let touched = touched(&arena, phi, bodies);
            let mut jacobian = Vec::new();
            if residual.is_velocity {
                let row = velocity_row(&mut arena, &mut along, (joint, row, residual.dim), phi);
                equations.push(row);
                continue;
            }
            for body in touched {
                for (speed, by) in by_speed.iter_mut().enumerate().skip(EACH[1] * body).take(EACH[1]) {
                    let entry = by.of(&mut arena, phi);
                    if !arena.as_constant(entry).is_some_and(|value| value.is_zero()) {
                        jacobian.push((speed, entry));
                    }
                }
            }
            let rate = by_time.of(&mut arena, phi);
            let nu = arena.neg(rate);
            let [_, _, second] = along.of(&mut arena, phi);
            let gamma = arena.neg(second);
            equations.push(Equation { joint, row, dim: residual.dim, level: Level::Position { phi }, jacobian, nu, gamma });
        }
    }
    let quantities = model.space.quantities.len();
    let coordinates = EACH[0] * bodies + quantities;
    let mut unbalanced = super::unbalanced(model, &mut arena);
    renumber(&mut arena, &mut equations, &mut unbalanced, (coordinates, EACH[1] * bodies));
    DeclaredEquations { arena, coordinates, speeds: EACH[1] * bodies, equations, unbalanced }
}

/// A row of velocities r = a · u − b: a, b and γ = ḃ − ȧ · u.
fn velocity_row(arena: &mut Arena, along: &mut Jets, (joint, row, dim): (usize, usize, Dim), residual: Expr) -> Equation {
    let (jacobian, nu) = affine(arena, residual);
    let jacobian = jacobian.into_iter().map(|(speed, entry)| ((speed - DECLARED) as usize, entry)).collect();
    let [_, first, _] = along.of(arena, residual);
    Equation { joint, row, dim, level: Level::Velocity, jacobian, nu, gamma: arena.neg(first) }
}

/// a by number of the speed, and b, of an expression a · u − b.
pub(super) fn affine(arena: &mut Arena, residual: Expr) -> (Vec<(u32, Expr)>, Expr) {
    let zero = arena.integer(0);
    let mut still = Substitution::new();
    let mut factors = Vec::new();
    for leaf in arena.leaves(residual) {
        let Leaf::Speed(number) = leaf else { continue };
        still.replace(leaf, zero);
        let factor = derivative(arena, residual, leaf);
        if factor != zero {
            factors.push((number, factor));
        }
    }
    let rest = still.of(arena, residual);
    (factors, arena.neg(rest))
}

/// Bodies on whose coordinates an expression depends.
fn touched(arena: &Arena, phi: Expr, bodies: usize) -> Vec<usize> {
    let mut touched = vec![false; bodies];
    for leaf in arena.leaves(phi) {
        if let Leaf::Coordinate(number) = leaf
            && let Some(body) = number.checked_sub(DECLARED).map(|number| number as usize / EACH[0])
            && body < bodies
        {
            touched[body] = true;
        }
    }
    (0..bodies).filter(|body| touched[*body]).collect()
}

/// Numbers declared coordinates and speeds from 0, and removes marks.
fn renumber(arena: &mut Arena, equations: &mut [Equation], unbalanced: &mut Option<Unbalanced>, (coordinates, speeds): (usize, usize)) {
    let mut numbered = Substitution::new();
    let mut known = HashMap::new();
    for number in 0..coordinates.max(speeds) as u32 {
        for leaf in [Leaf::Coordinate, Leaf::Speed, Leaf::Acceleration] {
            let new = arena.leaf(leaf(number));
            numbered.replace(leaf(DECLARED + number), new);
        }
    }
    let mut renewed = |expr: Expr| {
        let plain = arena.plain(expr, &mut known);
        numbered.of(arena, plain)
    };
    for equation in equations {
        equation.nu = renewed(equation.nu);
        equation.gamma = renewed(equation.gamma);
        equation.jacobian.iter_mut().for_each(|(_, entry)| *entry = renewed(*entry));
        if let Level::Position { phi } = &mut equation.level {
            *phi = renewed(*phi);
        }
    }
    if let Some(Unbalanced { forces, arms }) = unbalanced {
        forces.iter_mut().chain(arms.iter_mut().flatten().flat_map(|(_, arm)| arm)).for_each(|expr| *expr = renewed(*expr));
    }
}
