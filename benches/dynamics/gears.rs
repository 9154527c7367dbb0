//! D7: the gear joint of multi-point constraints: two nodes at fixed places on a carrier that floats, turning in a fixed ratio about axes of it.

use reuleaux::nalgebra::{Cholesky, Matrix3, SMatrix, SVector, Vector3};
use reuleaux::{Dynamics, Integrator, Real, SpatialBody, mechanism};
use reuleaux_benches::multibody::forces::solved;
use reuleaux_tests::common::twofold::Twofold;

use crate::case::{ACCELERATIONS, BOTH, Case, Entry, HAND, STATES, exact_in};

mechanism! {
    /// Three nodes with the same inertia about every axis.
    pub(crate) mechanism Gears in space {
        gravity = (0m_s2, 0m_s2, -9.81m_s2);
        body carrier {
            axis first = (0, 0, 1);  axis second = (0, 1, 0);
            mass = 5kg;  inertia = (0.3kgm2, 0.3kgm2, 0.3kgm2);
        }
        body first { mass = 2kg;  inertia = (0.05kgm2, 0.05kgm2, 0.05kgm2);  start position = (400mm, 0mm, 100mm); }
        body second { mass = 3kg;  inertia = (0.1kgm2, 0.1kgm2, 0.1kgm2);  start position = (-300mm, 500mm, 0mm); }
        joint gears = gear_joint(carrier, first, second, carrier.first, carrier.second, 2.5);
        force motor = { on first: (0.3Nm, -0.2Nm, 0.5Nm); }
        freedom glide = rate(carrier.position) from (1m_s, -0.5m_s, 2m_s);
        freedom tumble = carrier.angular_velocity from (1rad_s, 2rad_s, -1.5rad_s);
        freedom spin = dot(carrier.first, first.angular_velocity - carrier.angular_velocity) from 4rad_s;
    }
}

mechanism! {
    /// The same with equations between positions.
    pub(crate) mechanism Hinged in space {
        gravity = (0m_s2, 0m_s2, -9.81m_s2);
        body carrier {
            axis first = (0, 0, 1);  axis second = (0, 1, 0);
            point at_first = (400mm, 0mm, 100mm);  point at_second = (-300mm, 500mm, 0mm);
            mass = 5kg;  inertia = (0.3kgm2, 0.3kgm2, 0.3kgm2);
        }
        body first {
            axis first = (0, 0, 1);  start position = (400mm, 0mm, 100mm);
            mass = 2kg;  inertia = (0.05kgm2, 0.05kgm2, 0.05kgm2);
        }
        body second {
            axis second = (0, 1, 0);  start position = (-300mm, 500mm, 0mm);
            mass = 3kg;  inertia = (0.1kgm2, 0.1kgm2, 0.1kgm2);
        }
        joint one = revolute(carrier.at_first, carrier.first, first.position, first.first);
        joint two = revolute(carrier.at_second, carrier.second, second.position, second.second);
        joint mesh = gear_pair(one.angle, two.angle, 2.5, 1);
        force motor = { on first: (0.3Nm, -0.2Nm, 0.5Nm); }
        freedom glide = rate(carrier.position) from (1m_s, -0.5m_s, 2m_s);
        freedom tumble = carrier.angular_velocity from (1rad_s, 2rad_s, -1.5rad_s);
        freedom spin = one.angle from 0rad at 4rad_s;
    }
}

/// By hand, without use of the structure.
const COMPLEMENT: &str = "by hand, Schur's complement by Cholesky";

type Vector = Vector3<f64>;

const RATIO: f64 = 2.5;
/// Of carrier and nodes (kg, kg m²).
const MASSES: [f64; 3] = [5.0, 2.0, 3.0];
const INERTIAS: [f64; 3] = [0.3, 0.05, 0.1];
/// On the first node, in ground (N m).
const TORQUE: Vector = Vector::new(0.3, -0.2, 0.5);
const FALL: Vector = Vector::new(0.0, 0.0, -9.81);

/// A state.
#[derive(Clone, Copy)]
struct Input {
    /// From the carrier to the nodes.
    places: [Vector; 2],
    /// The axes of the carrier.
    axes: [Vector; 3],
    velocities: [Vector; 3],
    spins: [Vector; 3],
}

/// Accelerations of carrier and nodes, angular ones, and forces and torques on the nodes.
type Found = ([Vector; 3], [Vector; 3], [Vector; 2], [Vector; 2]);

/// One rigid body of all, about its mass centre, with one spin: three equations for its turning.
#[inline(always)]
fn by_hand(input: &Input) -> Found {
    let [m0, m1, m2] = MASSES;
    let [j0, j1, j2] = INERTIAS;
    let [p1, p2] = input.places;
    let (r1, r2) = (input.axes[2], input.axes[1]);
    let omega = input.spins[0];
    let spin = r1.dot(&(input.spins[1] - omega));
    let center = p1 * (m1 / (m0 + m1 + m2)) + p2 * (m2 / (m0 + m1 + m2));
    let arms = [-center, p1 - center, p2 - center];
    let share = r1 * j1 - r2 * (RATIO * j2);
    let per_share = 1.0 / (j1 + RATIO * RATIO * j2);
    // Moments of inertia xx, yy, zz, yz, zx, xy, less the part that the spin takes.
    let mut squares = share.component_mul(&share) * -per_share + Vector::repeat(j0 + j1 + j2);
    let mut products = Vector::new(share.y * share.z, share.z * share.x, share.x * share.y) * -per_share;
    let mut momentum = share * spin;
    for (mass, arm) in MASSES.into_iter().zip(arms) {
        let square = arm.component_mul(&arm);
        squares += Vector::new(square.y + square.z, square.z + square.x, square.x + square.y) * mass;
        products -= Vector::new(arm.y * arm.z, arm.z * arm.x, arm.x * arm.y) * mass;
        momentum += arm.cross(&omega.cross(&arm)) * mass;
    }
    let side = TORQUE - omega.cross(&momentum) - share * (TORQUE.dot(&r1) * per_share);
    let cofactors = squares.yzx().component_mul(&squares.zxy()) - products.component_mul(&products);
    let mixed = products.yzx().component_mul(&products.zxy()) - products.component_mul(&squares);
    let (first, second, third) = (
        Vector::new(cofactors.x, mixed.z, mixed.y),
        Vector::new(mixed.z, cofactors.y, mixed.x),
        Vector::new(mixed.y, mixed.x, cofactors.z),
    );
    let per = 1.0 / (squares.x * cofactors.x + products.z * mixed.z + products.y * mixed.y);
    let turning = Vector::new(first.dot(&side), second.dot(&side), third.dot(&side)) * per;
    let spinning = (TORQUE.dot(&r1) - share.dot(&turning)) * per_share;
    let moved = arms.map(|arm| FALL + turning.cross(&arm) + omega.cross(&omega.cross(&arm)));
    let one = turning + r1 * spinning + omega.cross(&r1) * spin;
    let two = turning - (r2 * spinning + omega.cross(&r2) * spin) * RATIO;
    (moved, [turning, one, two], [(moved[1] - FALL) * m1, (moved[2] - FALL) * m2], [one * j1 - TORQUE, two * j2])
}

/// A node, a factor and an axis.
type Term = (usize, f64, Vector);

/// Rows by velocities and angular velocities of carrier and nodes, and their γ.
fn rows(input: &Input) -> (SMatrix<f64, 11, 18>, SVector<f64, 11>) {
    let (mut rows, mut gamma) = (SMatrix::<f64, 11, 18>::zeros(), SVector::<f64, 11>::zeros());
    let omega = input.spins[0];
    for node in 0..2 {
        let (own, first) = (node + 1, 3 * node);
        rows.fixed_view_mut::<3, 3>(first, 0).copy_from(&-Matrix3::identity());
        rows.fixed_view_mut::<3, 3>(first, 3 * own).copy_from(&Matrix3::identity());
        rows.fixed_view_mut::<3, 3>(first, 9).copy_from(&input.places[node].cross_matrix());
        gamma.fixed_rows_mut::<3>(first).copy_from(&omega.cross(&(input.velocities[own] - input.velocities[0])));
    }
    let [x, y, z] = input.axes;
    let terms: [(usize, [Term; 2]); 5] = [
        (6, [(1, RATIO, z), (2, 1.0, y)]),
        (7, [(1, 1.0, x), (2, 0.0, x)]),
        (8, [(1, 1.0, y), (2, 0.0, x)]),
        (9, [(2, 1.0, z), (1, 0.0, x)]),
        (10, [(2, 1.0, x), (1, 0.0, x)]),
    ];
    for (row, terms) in terms {
        for (node, factor, axis) in terms {
            let (axis, change) = (axis * factor, omega.cross(&axis) * factor);
            for k in 0..3 {
                rows[(row, 9 + 3 * node + k)] += axis[k];
                rows[(row, 9 + k)] -= axis[k];
            }
            gamma[row] -= change.dot(&(input.spins[node] - omega));
        }
    }
    (rows, gamma)
}

/// Forces and torques besides those of the joint.
fn acting() -> SVector<f64, 18> {
    let mut acting = SVector::<f64, 18>::zeros();
    for (node, mass) in MASSES.into_iter().enumerate() {
        acting.fixed_rows_mut::<3>(3 * node).copy_from(&(FALL * mass));
    }
    acting.fixed_rows_mut::<3>(12).copy_from(&TORQUE);
    acting
}

/// The mass of each velocity.
fn masses() -> [f64; 18] {
    std::array::from_fn(|k| if k < 9 { MASSES[k / 3] } else { INERTIAS[k / 3 - 3] })
}

/// Multipliers from L M⁻¹ Lᵀ, and the accelerations.
fn by_complement(input: &Input) -> (SVector<f64, 18>, SVector<f64, 11>) {
    let (rows, gamma) = rows(input);
    let (acting, masses) = (acting(), masses());
    let mut divided = rows;
    for (k, mass) in masses.into_iter().enumerate() {
        divided.column_mut(k).unscale_mut(mass);
    }
    let complement = divided * rows.transpose();
    let factors = Cholesky::new(complement).unwrap_or_else(|| panic!("rows that follow from others"));
    let multipliers = factors.solve(&(gamma - divided * acting));
    let forces = acting + rows.transpose() * multipliers;
    (SVector::from_fn(|k, _| forces[k] / masses[k]), multipliers)
}

/// M ẇ − Lᵀ λ = Q, L ẇ = γ as one dense system.
fn exact(input: &Input) -> Vec<f64> {
    let (rows, gamma) = rows(input);
    let (acting, masses) = (acting(), masses());
    let of = |value: f64| Twofold::of(value);
    let mut matrix = vec![vec![of(0.0); 30]; 29];
    for k in 0..18 {
        (matrix[k][k], matrix[k][29]) = (of(masses[k]), of(acting[k]));
        for row in 0..11 {
            (matrix[k][18 + row], matrix[18 + row][k]) = (of(-rows[(row, k)]), of(rows[(row, k)]));
        }
    }
    for row in 0..11 {
        matrix[18 + row][29] = of(gamma[row]);
    }
    let found = solved(matrix);
    compared(std::array::from_fn(|k| Vector::new(found[3 * k].high, found[3 * k + 1].high, found[3 * k + 2].high)))
}

/// Accelerations and angular accelerations of all nodes.
fn compared(found: [Vector; 6]) -> Vec<f64> {
    found.iter().flat_map(|vector| [vector.x, vector.y, vector.z]).collect()
}

fn input(bodies: &[SpatialBody<f64>; 3]) -> Input {
    let [carrier, first, second] = bodies;
    Input {
        places: [first.position - carrier.position, second.position - carrier.position],
        axes: [0, 1, 2].map(|j| carrier.rotation.column(j).into()),
        velocities: bodies.each_ref().map(|body| body.velocity),
        spins: bodies.each_ref().map(|body| body.angular_velocity),
    }
}

/// A declaration in the states of its motion in a second, beside hand-written ones.
macro_rules! declared {
    ($mechanism:ident, $state:ident, $name:literal) => {{
        let mechanism = $mechanism::default();
        let times = (0..STATES).map(|k| k as f64 / STATES as f64);
        let swept: Result<Vec<$state<f64>>, _> = mechanism.sweep(times, Integrator::new(1e-12)).collect();
        let states = swept.unwrap_or_else(|stopped| panic!("{stopped}"));
        let bodies = |state: &$state<f64>| [state.carrier(), state.first(), state.second()];
        let inputs: Vec<Input> = states.iter().map(|state| input(&bodies(state))).collect();
        let mut case = by_hands($name, inputs);
        case.entries.push(Entry::new(
            ACCELERATIONS,
            states.clone(),
            move |state| mechanism.accelerations(&state.q, &state.qd, state.t),
            |_, found| found.iter().flat_map(|found| found.as_slice()[..0].to_vec()).collect(),
        ));
        case.entries.push(Entry::new(
            BOTH,
            states,
            move |state| mechanism.accelerate_with_loads(state).unwrap_or_else(|stopped| panic!("{stopped}")),
            move |state, _| {
                let bodies = bodies(state);
                let [[a, b, c], [d, e, f]] =
                    [bodies.each_ref().map(|body| body.acceleration), bodies.map(|body| body.angular_acceleration)];
                compared([a, b, c, d, e, f])
            },
        ));
        case
    }};
}

pub(crate) fn cases() -> [Case; 2] {
    [declared!(Gears, GearsState, "D7 gear joint"), declared!(Hinged, HingedState, "D7 as hinges and a gear pair")]
}

/// Hand-written contenders in these states.
fn by_hands(name: &str, inputs: Vec<Input>) -> Case {
    let known = inputs.clone();
    Case {
        name: name.to_owned(),
        exact: exact_in(STATES / 16, move |k| exact(&known[k])),
        given: None,
        entries: vec![
            Entry::new(HAND, inputs.clone(), |input| by_hand(input), |_, ([a, b, c], [d, e, f], ..)| compared([*a, *b, *c, *d, *e, *f])),
            Entry::new(COMPLEMENT, inputs, |input| by_complement(input), |_, (found, _)| found.as_slice().to_vec()),
        ],
    }
}
