//! Newton's and Euler's equations of each body: the forces that joints and drives have to supply.
//!
//! ```text
//! f = M u̇ − Q,    Φ_uᵀ λ = −f
//! translation     m (a_C − g) − Σ F                     a_C: the acceleration of the centre of mass
//! rotation        I ω̇ + ω × I ω + c × m (a_C − g) − Σ (r_P − r) × F − Σ T      about the origin of the body, c = r_C − r
//! ```
//!
//! In the axes of ground, three for each body in the plane and six in space, in the order of the speeds.

use super::spin_axes;
use crate::expr::{Arena, Expr, Leaf, Spin, Triple, combination, cross, derivative, dot};
use crate::model::{Force, Mass, Model, declared_coordinate, declared_speed};
use crate::quantity::Ambient;

/// f of every body; `None` if there is neither a mass nor a force.
///
/// * `spins`: given, for each body in space the speeds that are components of ω. Of such a body the torques are those about the axes of its
///   spin.
pub(super) fn unbalanced(model: &Model, arena: &mut Arena, spins: &[Option<Spin>]) -> Option<Vec<Expr>> {
    let has_mass = model.bodies.iter().any(|body| !body.masses.is_empty());
    if !has_mass && model.forces.is_empty() && model.energies.is_empty() {
        return None;
    }
    let work = (0..model.bodies.len()).flat_map(|body| match model.ambient {
        Ambient::Plane => in_plane(model, arena, body).to_vec(),
        Ambient::Space => spin_axes::unbalanced(model, arena, body, spins).unwrap_or_else(|| in_space(model, arena, body)).to_vec(),
    });
    let mut work: Vec<Expr> = work.collect();
    for energy in model.energies.iter().filter(|energy| energy.rate.is_none()) {
        add_slopes(model, arena, energy.value, (spins, &mut work));
    }
    Some(work)
}

/// Adds ∂V/∂q of an energy: by the coordinates in the plane, by positions and turns of bodies in space.
fn add_slopes(model: &Model, arena: &mut Arena, energy: Expr, (spins, work): (&[Option<Spin>], &mut [Expr])) {
    let each = if model.ambient == Ambient::Space { 6 } else { 3 };
    for (at, sum) in work.iter_mut().enumerate() {
        let (body, offset) = (at / each, at % each);
        if let Some(spin) = spins.get(body).copied().flatten().filter(|_| offset >= 3) {
            let slope = spin_axes::slope(arena, energy, (body, spin), offset - 3);
            *sum = arena.add(*sum, slope);
            continue;
        }
        let by = match model.ambient {
            Ambient::Plane => Leaf::Coordinate(number(model, body, offset)),
            Ambient::Space if offset < 3 => Leaf::Coordinate(declared_coordinate(body, offset)),
            Ambient::Space => Leaf::turns_of(body)[offset - 3],
        };
        let slope = derivative(arena, energy, by);
        *sum = arena.add(*sum, slope);
    }
}

/// Number of the coordinate, speed or acceleration of a body at an offset.
pub(super) fn number(model: &Model, body: usize, offset: usize) -> u32 {
    match model.ambient {
        Ambient::Plane => (model.bodies[body].first + offset) as u32,
        Ambient::Space => declared_speed(body, offset),
    }
}

fn in_plane(model: &Model, arena: &mut Arena, body: usize) -> [Expr; 3] {
    let zero = arena.integer(0);
    let speed = arena.leaf(Leaf::Speed(number(model, body, 2)));
    let [ax, ay, turning] = [0, 1, 2].map(|offset| arena.leaf(Leaf::Acceleration(number(model, body, offset))));
    let inward = arena.square(speed);
    let gravity = model.gravity.clone().unwrap_or_else(|| vec![zero; 2]);
    let [mut fx, mut fy, mut torque] = [zero; 3];
    for declared in &model.bodies[body].masses {
        let mass = declared.mass.unwrap_or(zero);
        let center = declared.center.clone().unwrap_or_else(|| vec![zero; 2]);
        let c = turned_in_plane(model, arena, body, &center);
        // a_C − g
        let across = [arena.neg(c[1]), c[0]];
        let a = [(ax, 0), (ay, 1)].map(|(a, k)| {
            let (along, centripetal) = (arena.mul(across[k], turning), arena.mul(c[k], inward));
            let a = arena.add(a, along);
            let a = arena.sub(a, centripetal);
            arena.sub(a, gravity[k])
        });
        let force = a.map(|a| arena.mul(mass, a));
        let inertia = declared.inertia.as_ref().map_or(zero, |inertia| inertia[0]);
        let spin = arena.mul(inertia, turning);
        let moment = cross_in_plane(arena, c, force);
        let own = arena.add(spin, moment);
        [fx, fy, torque] = [(fx, force[0]), (fy, force[1]), (torque, own)].map(|(sum, part)| arena.add(sum, part));
    }
    for force in model.forces.iter().filter(|force| force.body == Some(body)) {
        match &force.point {
            None => torque = arena.sub(torque, force.parts[0]),
            Some(point) => {
                let arm = turned_in_plane(model, arena, body, point);
                let parts = [force.parts[0], force.parts[1]];
                fx = arena.sub(fx, parts[0]);
                fy = arena.sub(fy, parts[1]);
                let moment = cross_in_plane(arena, arm, parts);
                torque = arena.sub(torque, moment);
            }
        }
    }
    [fx, fy, torque]
}

/// A vector fixed in a body in the plane, in ground.
fn turned_in_plane(model: &Model, arena: &mut Arena, body: usize, local: &[Expr]) -> [Expr; 2] {
    let angle = arena.leaf(Leaf::Coordinate(number(model, body, 2)));
    let (sine, cosine) = (arena.sin(angle), arena.cos(angle));
    let (cx, sy) = (arena.mul(cosine, local[0]), arena.mul(sine, local[1]));
    let (sx, cy) = (arena.mul(sine, local[0]), arena.mul(cosine, local[1]));
    [arena.sub(cx, sy), arena.add(sx, cy)]
}

fn cross_in_plane(arena: &mut Arena, a: [Expr; 2], b: [Expr; 2]) -> Expr {
    let (left, right) = (arena.mul(a[0], b[1]), arena.mul(a[1], b[0]));
    arena.sub(left, right)
}

fn in_space(model: &Model, arena: &mut Arena, body: usize) -> [Expr; 6] {
    let zero = arena.integer(0);
    let three = |list: &Option<Vec<Expr>>| list.as_ref().map_or([zero; 3], |list| [list[0], list[1], list[2]]);
    let leaves = |arena: &mut Arena, leaf: fn(u32) -> Leaf, first: usize| -> Triple {
        [0, 1, 2].map(|k| arena.leaf(leaf(number(model, body, first + k))))
    };
    let speed = leaves(arena, Leaf::Speed, 3);
    let (a, turning) = (leaves(arena, Leaf::Acceleration, 0), leaves(arena, Leaf::Acceleration, 3));
    let gravity = three(&model.gravity);
    let (mut force, mut torque) = ([zero; 3], [zero; 3]);
    for declared in &model.bodies[body].masses {
        let c = arena.turned(body, three(&declared.center));
        let swing = cross(arena, speed, c);
        let (along, inward) = (cross(arena, turning, c), cross(arena, speed, swing));
        let mass = declared.mass.unwrap_or(zero);
        let own: Triple = [0, 1, 2].map(|k| {
            let sum = arena.add(along[k], inward[k]);
            let a = arena.add(a[k], sum);
            let a = arena.sub(a, gravity[k]);
            arena.mul(mass, a)
        });
        let (euler, moment) = (euler(arena, declared, body, speed, turning), cross(arena, c, own));
        for k in 0..3 {
            let about = arena.add(euler[k], moment[k]);
            (force[k], torque[k]) = (arena.add(force[k], own[k]), arena.add(torque[k], about));
        }
    }
    for Force { point, parts, .. } in model.forces.iter().filter(|force| force.body == Some(body)) {
        let parts = [parts[0], parts[1], parts[2]];
        let moment = match point {
            None => parts,
            Some(point) => {
                let arm = arena.turned(body, [point[0], point[1], point[2]]);
                force = [0, 1, 2].map(|k| arena.sub(force[k], parts[k]));
                cross(arena, arm, parts)
            }
        };
        torque = [0, 1, 2].map(|k| arena.sub(torque[k], moment[k]));
    }
    [force[0], force[1], force[2], torque[0], torque[1], torque[2]]
}

/// ½ Σ m v_C² + ω · I ω
pub(super) fn kinetic(model: &Model, arena: &mut Arena) -> Expr {
    let mut twice = arena.integer(0);
    let masses = model.bodies.iter().enumerate().flat_map(|(body, declared)| declared.masses.iter().map(move |mass| (body, mass)));
    for (body, declared) in masses {
        let zero = arena.integer(0);
        let each = if model.ambient == Ambient::Space { 3 } else { 2 };
        let center = declared.center.clone().unwrap_or_else(|| vec![zero; each]);
        let c = arm(model, arena, body, &center);
        let speed = |arena: &mut Arena, offset: usize| arena.leaf(Leaf::Speed(number(model, body, offset)));
        let origin: Vec<Expr> = (0..each).map(|k| speed(arena, k)).collect();
        let inertia = declared.inertia.as_ref();
        let (across, spinning) = match model.ambient {
            Ambient::Plane => {
                let turning = speed(arena, 2);
                let back = arena.neg(c[1]);
                let across = [back, c[0]].map(|part| arena.mul(turning, part)).to_vec();
                let square = arena.square(turning);
                (across, arena.mul(inertia.map_or(zero, |inertia| inertia[0]), square))
            }
            Ambient::Space => {
                let turning = [3, 4, 5].map(|k| speed(arena, k));
                let across = cross(arena, turning, [c[0], c[1], c[2]]).to_vec();
                let spinning = inertia.map_or(zero, |inertia| {
                    let axes = axes(arena, body);
                    let turning = axes.map(|axis| dot(arena, axis, turning));
                    let spin = inertia_times(arena, inertia, turning);
                    dot(arena, turning, spin)
                });
                (across, spinning)
            }
        };
        let mut square = zero;
        for (origin, across) in origin.into_iter().zip(across) {
            let part = arena.add(origin, across);
            let part = arena.square(part);
            square = arena.add(square, part);
        }
        let moving = arena.mul(declared.mass.unwrap_or(zero), square);
        for part in [moving, spinning] {
            twice = arena.add(twice, part);
        }
    }
    let two = arena.integer(2);
    arena.div(twice, two)
}

/// A (I' ω̇' + ω' × I' ω'), with ω' = Aᵀ ω and ω̇' = Aᵀ ω̇: in the axes of the body, where I' is constant; I ω̇ if inertia is the same about
/// all axes, and in ground if it is the same across one axis z: I ω̇ + (I_z − I) ((z · ω̇) z + (z · ω) ω × z).
fn euler(arena: &mut Arena, declared: &Mass, body: usize, speed: Triple, turning: Triple) -> Triple {
    let zero = arena.integer(0);
    let Some(inertia) = &declared.inertia else { return [zero; 3] };
    if is_about_principal_axes(inertia, zero) && inertia[0] == inertia[1] && inertia[1] == inertia[2] {
        return turning.map(|part| arena.mul(inertia[0], part));
    }
    let axes = axes(arena, body);
    if let Some(axis) = axis_of_symmetry(inertia, zero) {
        let (across, z) = (inertia[(axis + 1) % 3], axes[axis]);
        let more = arena.sub(inertia[axis], across);
        let [spin, growth] = [speed, turning].map(|vector| {
            let along = dot(arena, z, vector);
            arena.mul(more, along)
        });
        let swing = cross(arena, speed, z);
        return [0, 1, 2].map(|k| {
            let terms = [(across, turning[k]), (growth, z[k]), (spin, swing[k])].map(|(a, b)| arena.mul(a, b));
            arena.sum(&terms)
        });
    }
    let [speed, turning] = [speed, turning].map(|vector| axes.map(|axis| dot(arena, axis, vector)));
    let (change, gyroscopic) = (inertia_times(arena, inertia, turning), gyroscopic(arena, inertia, speed));
    let sum = [0, 1, 2].map(|k| arena.add(change[k], gyroscopic[k]));
    combination(arena, sum, axes)
}

/// ω' × I' ω', in the axes of a body; about principal axes by the differences of the moments of inertia.
pub(super) fn gyroscopic(arena: &mut Arena, inertia: &[Expr], spin: Triple) -> Triple {
    if !is_about_principal_axes(inertia, arena.integer(0)) {
        let momentum = inertia_times(arena, inertia, spin);
        return cross(arena, spin, momentum);
    }
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| {
        let (rest, product) = (arena.sub(inertia[j], inertia[i]), arena.mul(spin[i], spin[j]));
        arena.mul(rest, product)
    })
}

/// The principal axis across which the moments of inertia are equal.
fn axis_of_symmetry(inertia: &[Expr], zero: Expr) -> Option<usize> {
    let is_across = |axis: &usize| inertia[(axis + 1) % 3] == inertia[(axis + 2) % 3];
    (0..3).find(|axis| is_about_principal_axes(inertia, zero) && is_across(axis))
}

/// True if the products of inertia vanish.
fn is_about_principal_axes(inertia: &[Expr], zero: Expr) -> bool {
    inertia[3..].iter().all(|product| *product == zero)
}

/// The axes of a body in ground.
pub(super) fn axes(arena: &mut Arena, body: usize) -> [Triple; 3] {
    let (zero, one) = (arena.integer(0), arena.integer(1));
    [0, 1, 2].map(|axis| arena.turned(body, [0, 1, 2].map(|k| if k == axis { one } else { zero })))
}

/// I' v, in the axes of a body.
pub(super) fn inertia_times(arena: &mut Arena, inertia: &[Expr], v: Triple) -> Triple {
    let [xx, yy, zz, xy, xz, yz] = [inertia[0], inertia[1], inertia[2], inertia[3], inertia[4], inertia[5]];
    [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]].map(|row| dot(arena, row, v))
}

/// A vector fixed in a body, in ground: the arm of a joint's point.
pub(super) fn arm(model: &Model, arena: &mut Arena, body: usize, local: &[Expr]) -> Vec<Expr> {
    match model.ambient {
        Ambient::Space => arena.turned(body, [local[0], local[1], local[2]]).to_vec(),
        Ambient::Plane => turned_in_plane(model, arena, body, local).to_vec(),
    }
}
