//! Newton's and Euler's equations of a body whose speeds are components of ω.
//!
//! ```text
//! translation     m (a + A (ω̇ × c + ω × (ω × c)) − g) − Σ F                               in the axes of ground
//! rotation        I ω̇ + ω × I ω + c × m (Aᵀ (a − g) + ω̇ × c + ω × (ω × c)) − Σ p × Aᵀ F − Σ Aᵀ T     in the axes of the body
//!                 I (ẇ + ω_B × w) − Σ Bᵀ ((A p) × F) − Σ Bᵀ T          ω = B w in the axes B of another body or of ground
//! ```
//!
//! In the axes of the body inertia and centre of mass are constant. A ball has the same inertia along all axes: its ω is taken along those in
//! which the equations between speeds are written most often, where their entries are constant.

use super::dynamics::{gyroscopic, inertia_times, number};
use crate::expr::{Arena, Expr, Leaf, Spin, SpinAxes, Triple, combination, cross, derivative, dot};
use crate::model::{Force, Mass, Model};

/// The unbalanced force, and the unbalanced torque about the axes of the spin.
///
/// * `spins`: given, the speeds of each body that are components of ω; axes are those of bodies.
pub(super) fn unbalanced(model: &Model, arena: &mut Arena, body: usize, spins: &[Option<Spin>]) -> Option<[Expr; 6]> {
    let zero = arena.integer(0);
    let spin = spins.get(body).copied().flatten()?;
    let directions = arena.directions_of(body, spin.axes);
    let (mut force, mut torque) = ([zero; 3], [zero; 3]);
    let own = BodyMotion::new(model, arena, body, spins)?;
    for mass in &model.bodies[body].masses {
        let (pull, moment) = if spin.axes == SpinAxes::Own { own.of_body(arena, &directions, mass) } else { own.of_ball(arena, mass) };
        (force, torque) = (sum(arena, force, pull), sum(arena, torque, moment));
    }
    for Force { point, parts, .. } in model.forces.iter().filter(|force| force.body == Some(body)) {
        let parts = [parts[0], parts[1], parts[2]];
        let along = |arena: &mut Arena, vector: Triple| directions.map(|axis| dot(arena, axis, vector));
        let moment = match point.as_ref().map(|point| [point[0], point[1], point[2]]) {
            None => along(arena, parts),
            Some(point) => {
                force = difference(arena, force, parts);
                if spin.axes == SpinAxes::Own {
                    let parts = along(arena, parts);
                    cross(arena, point, parts)
                } else {
                    let arm = arena.turned(body, point);
                    let moment = cross(arena, arm, parts);
                    along(arena, moment)
                }
            }
        };
        torque = difference(arena, torque, moment);
    }
    Some([force[0], force[1], force[2], torque[0], torque[1], torque[2]])
}

/// ∂V/∂φ of an energy, where φ is a turn about an axis of the spin.
pub(super) fn slope(arena: &mut Arena, energy: Expr, (body, spin): (usize, Spin), axis: usize) -> Expr {
    let about = arena.directions_of(body, spin.axes)[axis];
    let slopes = Leaf::turns_of(body).map(|turn| derivative(arena, energy, turn));
    dot(arena, about, slopes)
}

/// Motion of a body, without its declared forces.
struct BodyMotion {
    /// a − g, in ground.
    falling: Triple,
    /// ω, by its components.
    spin: Triple,
    /// ω̇, by its components along the same axes.
    change: Triple,
}

impl BodyMotion {
    fn new(model: &Model, arena: &mut Arena, body: usize, spins: &[Option<Spin>]) -> Option<BodyMotion> {
        let zero = arena.integer(0);
        let Spin { first, axes } = spins[body]?;
        let gravity = model.gravity.clone().unwrap_or_else(|| vec![zero; 3]);
        let falling = [0, 1, 2].map(|k| {
            let a = arena.leaf(Leaf::Acceleration(number(model, body, k)));
            arena.sub(a, gravity[k])
        });
        let [spin, mut change] = [Leaf::Speed, Leaf::Acceleration].map(|leaf| [0, 1, 2].map(|k| arena.leaf(leaf(first + k))));
        if let SpinAxes::Of(other) = axes {
            let Spin { first, .. } = spins[other]?;
            let turning = [0, 1, 2].map(|k| arena.leaf(Leaf::Speed(first + k)));
            let swing = cross(arena, turning, spin);
            change = sum(arena, change, swing);
        }
        Some(BodyMotion { falling, spin, change })
    }

    /// Force in ground and torque that one of the masses of a ball needs: its centre is the origin, and its inertia the same along all axes.
    fn of_ball(&self, arena: &mut Arena, mass: &Mass) -> (Triple, Triple) {
        let zero = arena.integer(0);
        let [weight, inertia] = [mass.mass, mass.inertia.as_ref().map(|inertia| inertia[0])].map(|number| number.unwrap_or(zero));
        (self.falling.map(|part| arena.mul(weight, part)), self.change.map(|part| arena.mul(inertia, part)))
    }

    /// Force in ground and torque in the axes of the body that one of its masses needs.
    fn of_body(&self, arena: &mut Arena, axes: &[Triple; 3], mass: &Mass) -> (Triple, Triple) {
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
