//! The equations of a mechanism in space as declared: on positions and quaternions, by the speeds v and ω of each body.
//!
//! ```text
//! Φ_u = (∂Φ/∂r, ∂Φ/∂turns)      six columns a body, in the axes of ground
//! ν   = −Φ_t
//! γ   = −d²/ds² Φ(r + s v, exp(s ω) A, t + s) at s = 0
//! ```

use super::rows::{Differentiation, Row};
use super::{Equation, Level};
use crate::expr::{Arena, Expr, Leaf, Lookup, Seed, Substitution};
use crate::model::{DECLARED, Model, declared_coordinate, declared_rates};
use crate::quantity::{Role, SpeedRole};

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
}

/// Coordinates of a body, and speeds.
const EACH: [usize; 2] = [Role::SPACE.len(), SpeedRole::SPACE.len()];

/// Differentiates every residual of a model in space.
pub(super) fn declared(model: &Model) -> DeclaredEquations {
    let mut arena = model.arena.clone();
    let mut equations = equations(model, &mut arena, Row::declared(model).collect::<Vec<_>>().iter());
    let (bodies, quantities) = (model.bodies.len(), model.space.quantities.len());
    let (coordinates, speeds) = (EACH[0] * bodies + quantities, EACH[1] * bodies);
    renumber(&mut arena, &mut equations, coordinates.max(speeds));
    DeclaredEquations { arena, coordinates, speeds, equations }
}

/// The equations of rows of a model in space by the speeds of its bodies, with marks.
pub(super) fn equations<'a>(model: &Model, arena: &mut Arena, rows: impl Iterator<Item = &'a Row>) -> Vec<Equation> {
    let bodies = model.bodies.len();
    let by = |speed: usize| {
        let (body, at) = (speed / EACH[1], speed % EACH[1]);
        if at < 3 { Leaf::Coordinate(declared_coordinate(body, at)) } else { Leaf::turns_of(body)[at - 3] }
    };
    let seed = Seed::constant_speeds(declared_rates(EACH[0] * bodies)).numbered_from(DECLARED);
    let mut derivatives = Differentiation::new((0..EACH[1] * bodies).map(by), seed, DECLARED);
    let mut equations = Vec::new();
    for row in rows {
        let touched = touched(arena, row.residual, bodies);
        let columns = touched.into_iter().flat_map(|body| EACH[1] * body..EACH[1] * (body + 1));
        equations.push(derivatives.of(arena, row, columns));
    }
    equations
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
fn renumber(arena: &mut Arena, equations: &mut [Equation], count: usize) {
    let mut numbered = Substitution::new();
    let mut known = Lookup::default();
    for number in 0..count as u32 {
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
}
