//! Balance of forces and inertia in the speeds of the unknowns, if motion follows from forces.
//!
//! ```text
//! f_k = Σ ∂v/∂u_k · F + ∂ω/∂u_k · T      F, T: M u̇ − Q of a body, about its origin
//! V   = Σ V_i + Σ U_j − Σ m g · r_C       U: potentials of forces
//! P   = Σ F · v_P + T · ω + ∂V_i/∂t + dU_j/dt      F, T: of the forces declared
//! ```

use super::dynamics;
use crate::expr::{Arena, Expr, Leaf, Spin, cross, derivative};
use crate::model::{Energy, Force, Model, declared_coordinate};
use crate::quantity::Ambient;

/// Forces by speed, and energies.
#[derive(Clone, Debug)]
pub struct Balance {
    /// M u̇ − Q, by speed.
    pub forces: Vec<Expr>,
    /// Potential energy, of gravity and as declared.
    pub potential: Expr,
    /// Power of the forces declared, and rate of the potential where nothing moves.
    pub power: Expr,
}

impl Balance {
    /// In the declared coordinates, by the speeds of bodies; torques on a body in `spins` are those about the axes of its spin.
    pub(super) fn declared(model: &Model, arena: &mut Arena, spins: &[Option<Spin>]) -> Balance {
        let zero = arena.integer(0);
        let each = if model.ambient == Ambient::Space { 6 } else { 3 };
        let forces = dynamics::unbalanced(model, arena, spins).unwrap_or_else(|| vec![zero; each * model.bodies.len()]);
        let [potential, power] = energies(model, arena);
        Balance { forces, potential, power }
    }

    /// Every expression, as `of` writes it.
    pub(super) fn map(mut self, mut of: impl FnMut(Expr) -> Expr) -> Balance {
        self.forces.iter_mut().chain([&mut self.potential, &mut self.power]).for_each(|expr| *expr = of(*expr));
        self
    }

    /// By the rates of unknowns in space, of which the first are the positions of the bodies.
    pub(super) fn by_unknowns(mut self, arena: &mut Arena, frames: &[usize], unknowns: usize) -> Balance {
        let zero = arena.integer(0);
        let mut forces = vec![zero; unknowns];
        for (body, frame) in frames.iter().enumerate() {
            let (position, speed) = (Ambient::Space.first_coordinate(body), Ambient::Space.first_speed(body));
            for axis in 0..Ambient::Space.components() {
                forces[position + axis] = self.forces[speed + axis];
                let spin = arena.frame(*frame).velocity[axis];
                let torque = self.forces[speed + Ambient::Space.components() + axis];
                if let Some(Spin { first, .. }) = arena.spin(*frame) {
                    let own = first as usize + axis;
                    forces[own] = arena.add(forces[own], torque);
                    continue;
                }
                for leaf in arena.leaves(spin) {
                    let Leaf::Speed(number) = leaf else { continue };
                    let slope = derivative(arena, spin, leaf);
                    let part = arena.mul(slope, torque);
                    forces[number as usize] = arena.add(forces[number as usize], part);
                }
            }
        }
        self.forces = forces;
        self
    }
}

/// V and P.
pub(super) fn energies(model: &Model, arena: &mut Arena) -> [Expr; 2] {
    let mut potential = potential(model, arena);
    let mut power = power(model, arena, potential);
    for Energy { value, rate } in &model.energies {
        if let Some(rate) = rate {
            potential = arena.add(potential, *value);
            power = arena.add(power, *rate);
        }
    }
    [potential, power]
}

/// Σ V_i − Σ m g · r_C
fn potential(model: &Model, arena: &mut Arena) -> Expr {
    let mut sum = arena.integer(0);
    for energy in model.energies.iter().filter(|energy| energy.rate.is_none()) {
        sum = arena.add(sum, energy.value);
    }
    let Some(gravity) = &model.gravity else { return sum };
    let zero = arena.integer(0);
    let masses = model.bodies.iter().enumerate().flat_map(|(body, declared)| declared.masses.iter().map(move |mass| (body, mass)));
    for (body, declared) in masses {
        let Some(mass) = declared.mass else { continue };
        let center = declared.center.clone().unwrap_or_else(|| vec![zero; gravity.len()]);
        let arm = dynamics::arm(model, arena, body, &center);
        for (axis, (along, g)) in arm.into_iter().zip(gravity).enumerate() {
            let origin = arena.leaf(Leaf::Coordinate(coordinate(model, body, axis)));
            let place = arena.add(origin, along);
            let height = arena.mul(*g, place);
            let energy = arena.mul(mass, height);
            sum = arena.sub(sum, energy);
        }
    }
    sum
}

/// Σ F · v_P + T · ω + ∂V/∂t
fn power(model: &Model, arena: &mut Arena, potential: Expr) -> Expr {
    let of_forces = model.forces.iter().fold(arena.integer(0), |sum, force| add_power(model, arena, sum, force));
    // Inputs are functions of time.
    let change = derivative(arena, potential, Leaf::Time);
    arena.add(of_forces, change)
}

/// The force and torque vectors of each declared force, and its power.
pub(super) fn pushes(model: &Model, arena: &mut Arena) -> Vec<Vec<Expr>> {
    let of_each = (0..model.declared_forces.len()).map(|number| {
        let own = || model.forces.iter().filter(|force| force.of == number);
        let power = own().fold(arena.integer(0), |sum, force| add_power(model, arena, sum, force));
        own().flat_map(|force| force.parts.iter().copied()).chain([power]).collect()
    });
    of_each.collect()
}

/// Adds the power of a force, term by term; ground does not move.
fn add_power(model: &Model, arena: &mut Arena, mut sum: Expr, force: &Force) -> Expr {
    let Force { body: Some(body), point, parts, .. } = force else { return sum };
    let arm = point.as_ref().map(|point| dynamics::arm(model, arena, *body, point));
    let speeds: Vec<Expr> = match (model.ambient, arm) {
        (Ambient::Plane, None) => vec![speed(model, arena, *body, 2)],
        (Ambient::Plane, Some(arm)) => {
            let turning = speed(model, arena, *body, 2);
            let across = [arena.neg(arm[1]), arm[0]].map(|part| arena.mul(part, turning));
            along(model, arena, *body, &across)
        }
        (Ambient::Space, None) => (3..6).map(|k| speed(model, arena, *body, k)).collect(),
        (Ambient::Space, Some(arm)) => {
            let spin = [3, 4, 5].map(|k| speed(model, arena, *body, k));
            let across = cross(arena, spin, [arm[0], arm[1], arm[2]]);
            along(model, arena, *body, &across)
        }
    };
    for (part, speed) in parts.iter().zip(speeds) {
        let term = arena.mul(*part, speed);
        sum = arena.add(sum, term);
    }
    sum
}

/// Velocity of a body's origin, and the rest of a point's.
fn along(model: &Model, arena: &mut Arena, body: usize, rest: &[Expr]) -> Vec<Expr> {
    let parts = rest.iter().enumerate().map(|(axis, rest)| {
        let origin = speed(model, arena, body, axis);
        arena.add(origin, *rest)
    });
    parts.collect()
}

fn speed(model: &Model, arena: &mut Arena, body: usize, offset: usize) -> Expr {
    arena.leaf(Leaf::Speed(dynamics::number(model, body, offset)))
}

fn coordinate(model: &Model, body: usize, axis: usize) -> u32 {
    match model.ambient {
        Ambient::Plane => dynamics::number(model, body, axis),
        Ambient::Space => declared_coordinate(body, axis),
    }
}
