//! Newton's and Euler's equations of a body whose speeds are ω in its own axes, where inertia and centre of mass are constant.
//!
//! ```text
//! translation     m (a + A (ω̇ × c + ω × (ω × c)) − g) − Σ F                               in the axes of ground
//! rotation        I ω̇ + ω × I ω + c × m (Aᵀ (a − g) + ω̇ × c + ω × (ω × c)) − Σ p × Aᵀ F − Σ Aᵀ T     in the axes of the body
//! ```

use super::dynamics::{axes, gyroscopic, inertia_times, number};
use crate::expr::{Arena, Expr, Leaf, Triple, combination, cross, derivative, dot};
use crate::model::{Force, Mass, Model};

/// The unbalanced force, and the unbalanced torque about the axes of the body.
///
/// * `first`: given, the number of the first of its three speeds.
pub(super) fn unbalanced(model: &Model, arena: &mut Arena, body: usize, first: u32) -> [Expr; 6] {
    let zero = arena.integer(0);
    let axes = axes(arena, body);
    let (mut force, mut torque) = ([zero; 3], [zero; 3]);
    let own = OwnMotion::new(model, arena, body, first);
    for mass in &model.bodies[body].masses {
        let (pull, moment) = own.unbalanced(arena, &axes, mass);
        (force, torque) = (sum(arena, force, pull), sum(arena, torque, moment));
    }
    for Force { point, parts, .. } in model.forces.iter().filter(|force| force.body == Some(body)) {
        let parts = [parts[0], parts[1], parts[2]];
        let along = axes.map(|axis| dot(arena, axis, parts));
        let moment = match point {
            None => along,
            Some(point) => {
                force = difference(arena, force, parts);
                cross(arena, [point[0], point[1], point[2]], along)
            }
        };
        torque = difference(arena, torque, moment);
    }
    [force[0], force[1], force[2], torque[0], torque[1], torque[2]]
}

/// ∂V/∂φ of an energy, where φ is a turn about an axis of the body.
pub(super) fn slope(arena: &mut Arena, energy: Expr, body: usize, axis: usize) -> Expr {
    let about = axes(arena, body)[axis];
    let slopes = Leaf::turns_of(body).map(|turn| derivative(arena, energy, turn));
    dot(arena, about, slopes)
}

/// Motion of a body, without its declared forces.
struct OwnMotion {
    /// a − g, in ground.
    falling: Triple,
    /// ω
    spin: Triple,
    /// ω̇
    change: Triple,
}

impl OwnMotion {
    fn new(model: &Model, arena: &mut Arena, body: usize, first: u32) -> OwnMotion {
        let zero = arena.integer(0);
        let gravity = model.gravity.clone().unwrap_or_else(|| vec![zero; 3]);
        let falling = [0, 1, 2].map(|k| {
            let a = arena.leaf(Leaf::Acceleration(number(model, body, k)));
            arena.sub(a, gravity[k])
        });
        let [spin, change] = [Leaf::Speed, Leaf::Acceleration].map(|leaf| [0, 1, 2].map(|k| arena.leaf(leaf(first + k))));
        OwnMotion { falling, spin, change }
    }

    /// Force in ground and torque in the axes of the body that one of its masses needs.
    fn unbalanced(&self, arena: &mut Arena, axes: &[Triple; 3], mass: &Mass) -> (Triple, Triple) {
        let zero = arena.integer(0);
        let weight = mass.mass.unwrap_or(zero);
        let center = mass.center.as_ref().map_or([zero; 3], |list| [list[0], list[1], list[2]]);
        let swing = cross(arena, self.spin, center);
        let (tangential, inward) = (cross(arena, self.change, center), cross(arena, self.spin, swing));
        let relative = sum(arena, tangential, inward);
        let in_ground = combination(arena, relative, *axes);
        let whole = sum(arena, self.falling, in_ground);
        let force = whole.map(|part| arena.mul(weight, part));
        let falling = axes.map(|axis| dot(arena, axis, self.falling));
        let own = sum(arena, falling, relative);
        let own = own.map(|part| arena.mul(weight, part));
        let mut torque = cross(arena, center, own);
        if let Some(inertia) = &mass.inertia {
            let (growth, gyroscopic) = (inertia_times(arena, inertia, self.change), gyroscopic(arena, inertia, self.spin));
            let euler = sum(arena, growth, gyroscopic);
            torque = sum(arena, torque, euler);
        }
        (force, torque)
    }
}

fn sum(arena: &mut Arena, a: Triple, b: Triple) -> Triple {
    [0, 1, 2].map(|k| arena.add(a[k], b[k]))
}

fn difference(arena: &mut Arena, a: Triple, b: Triple) -> Triple {
    [0, 1, 2].map(|k| arena.sub(a[k], b[k]))
}
