//! A gear joint, revolutes, a general multi-point constraint and drives on the same bodies: every row of them has its multiplier.
//!
//! ```text
//! M u̇ + Jᵀ λ = Q,   J u̇ = γ      u = (v, ω) of each body, solved here densely, from Newton's and Euler's laws
//! ```
//!
//! Rows are written down as velocities, with their rates where nothing accelerates: γ is minus that rate.

use reuleaux::nalgebra::{DMatrix, DVector, Matrix3, Vector3};
use reuleaux::{Integrator, SpatialBody, mechanism};

mechanism! {
    /// n0 to n2 are the nodes of the gear joint; n3 hinges on n2, n4 is held by nothing but the constraint and a drive.
    pub(crate) mechanism SharedNodes in space {
        gravity = (0m_s2, 0m_s2, -9.81m_s2);
        ground { point O = (0.1m, 0.2m, 0m);  axis z = (0, 0, 1) from (1, 0, 0); }
        body n0 {
            point O = (-0.05m, 0.02m, 0m);  axis z = (0, 0, 1) from (1, 0, 0);
            axis r1 = (0, 0, 1) from (1, 0, 0);  axis r2 = (0, 0.6, 0.8) from (1, 0, 0);
            mass = 2kg;  center = (0.03m, -0.02m, 0.01m);  inertia = (0.02kgm2, 0.03kgm2, 0.025kgm2) along turn((1, 2, 3), 40deg);
        }
        body n1 {
            axis s = (0, 0.3, 1) from (1, 0, 0);
            mass = 0.8kg;  center = (0m, 0.01m, 0m);  inertia = (0.003kgm2, 0.003kgm2, 0.005kgm2);
            start position = (0.25m, 0.2m, 0.1m);
        }
        body n2 {
            axis b = (1, 0, 0) from (0, 1, 0);  point P = (0.1m, 0m, 0.05m);
            mass = 1.1kg;  inertia = (0.006kgm2, 0.007kgm2, 0.004kgm2, 0.0005kgm2, 0kgm2, 0.0002kgm2);
            start position = (0.05m, 0.3m, 0.15m);
        }
        body n3 {
            axis b = (1, 0, 0) from (0, 1, 0);  axis s = (0, 1, 0.5) from (1, 0, 0);
            mass = 0.5kg;  center = (0.04m, 0.03m, 0m);  inertia = (0.001kgm2, 0.002kgm2, 0.0015kgm2);
            start position = (0.15m, 0.3m, 0.2m);
        }
        body n4 {
            axis s = (0.1, 0, 1) from (1, 1, 0);
            mass = 1.4kg;  inertia = (0.02kgm2, 0.03kgm2, 0.015kgm2, 0kgm2, 0.002kgm2, 0.001kgm2);
            start position = (0.5m, 0.3m, 0.8m);  start orientation = turn((1, 0, 1), 30deg);
        }
        joint axle = revolute(ground.O, ground.z, n0.O, n0.z);
        joint gears = gear_joint(n0, n1, n2, n0.r1, n0.r2, -1.6, mass: 0.2kg, inertia: 0.001kgm2);
        joint hinge = revolute(n2.P, n2.b, n3.position, n3.b);
        drive turn = drive_rotation(axle, 0.3rad * sin(4rad_s * t));
        joint row = {
            0.4m * dot(x_axis(n1.s), n1.angular_velocity) / 1rad - 2 * dot(z_axis(n4.s), rate(n4.position))
                + 0.7m * dot(y_axis(n3.s), n3.angular_velocity) / 1rad + 0.5 * dot((0, 1, 0), rate(n2.position)) == 0m_s;
        }
        drive push = drive_x(n4.position, 0.5m + 0.2m_s * t + 0.1m_s2 * t^2);
        force motor = motor(n0.r1, n1, 0.5Nm);
        force spring = spring_damper(n3.position, n4.position, stiffness: 60N_m, rest: 0.5m, damping: 0.7Ns_m);
        freedom wheel = dot(n1.angular_velocity - n0.angular_velocity, z_axis(n0.r1)) from 4rad_s;
        freedom swing = dot(n3.angular_velocity - n2.angular_velocity, z_axis(n2.b)) from -2rad_s;
        freedom spin = n4.angular_velocity from (1rad_s, 0.5rad_s, -0.7rad_s);
        freedom fall = dot((0, 1, 0), rate(n4.position)) from 0.4m_s;
    }
}

const BODIES: usize = 5;

/// A vector with its rate at accelerations that vanish.
#[derive(Clone, Copy)]
struct Moving([Vector3<f64>; 2]);

impl Moving {
    fn cross(self, other: Self) -> Self {
        let ([a, da], [b, db]) = (self.0, other.0);
        Moving([a.cross(&b), da.cross(&b) + a.cross(&db)])
    }

    fn dot(self, other: Self) -> [f64; 2] {
        let ([a, da], [b, db]) = (self.0, other.0);
        [a.dot(&b), da.dot(&b) + a.dot(&db)]
    }

    fn plus(self, other: Self) -> Self {
        Moving([self.0[0] + other.0[0], self.0[1] + other.0[1]])
    }

    fn less(self, other: Self) -> Self {
        Moving([self.0[0] - other.0[0], self.0[1] - other.0[1]])
    }

    fn parts(self) -> [[f64; 2]; 3] {
        [0, 1, 2].map(|k| [self.0[0][k], self.0[1][k]])
    }

    fn fixed(vector: [f64; 3]) -> Self {
        Moving([Vector3::from(vector), Vector3::zeros()])
    }
}

/// Axis, and the directions x and y across it that begin at `from`.
fn triad(axis: [f64; 3], from: [f64; 3]) -> [[f64; 3]; 3] {
    let z = Vector3::from(axis).normalize();
    let from = Vector3::from(from);
    let x = (from - z * z.dot(&from)).normalize();
    [x.into(), z.cross(&x).into(), z.into()]
}

/// Bodies in a state, with speeds to be put in: those of the state, or others for one column of J.
struct Nodes<'a> {
    bodies: &'a [SpatialBody<f64>; BODIES],
    speeds: &'a DVector<f64>,
}

impl Nodes<'_> {
    /// Speeds of the state; the rate of a direction is that of the motion.
    fn spin_of_state(&self, body: usize) -> Vector3<f64> {
        self.bodies[body].angular_velocity
    }

    fn direction(&self, body: usize, local: [f64; 3]) -> Moving {
        let vector = self.bodies[body].rotation * Vector3::from(local);
        Moving([vector, self.spin_of_state(body).cross(&vector)])
    }

    fn position(&self, body: usize) -> Moving {
        Moving([self.bodies[body].position, self.bodies[body].velocity])
    }

    fn velocity(&self, body: usize) -> Moving {
        Moving([self.speeds.fixed_rows::<3>(6 * body).into_owned(), Vector3::zeros()])
    }

    fn spin(&self, body: usize) -> Moving {
        Moving([self.speeds.fixed_rows::<3>(6 * body + 3).into_owned(), Vector3::zeros()])
    }

    fn velocity_of(&self, body: usize, local: [f64; 3]) -> Moving {
        self.velocity(body).plus(self.spin(body).cross(self.direction(body, local)))
    }

    /// All rows a · u in the order of the declaration, with their rates.
    fn rows(&self) -> Vec<[f64; 2]> {
        let mut rows = Vec::new();
        // The axle on ground: r_O − r_P and the directions across.
        rows.extend(Moving::fixed([0.0; 3]).less(self.velocity_of(0, [-0.05, 0.02, 0.0])).parts());
        let turning = self.spin(0).cross(self.direction(0, [0.0, 0.0, 1.0]));
        rows.extend([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(|across| Moving::fixed(across).dot(turning)));
        // The gear joint.
        let spins = [1, 2].map(|node| self.spin(node).less(self.spin(0)));
        for node in [1, 2] {
            let arm = self.position(node).less(self.position(0));
            rows.extend(self.velocity(node).less(self.velocity(0)).less(self.spin(0).cross(arm)).parts());
        }
        let axes = [triad([0.0, 0.0, 1.0], [1.0, 0.0, 0.0]), triad([0.0, 0.6, 0.8], [1.0, 0.0, 0.0])];
        let [one, two] = [0, 1].map(|k| axes[k].map(|axis| self.direction(0, axis).dot(spins[k])));
        rows.push([0, 1].map(|k| -1.6 * one[2][k] + two[2][k]));
        rows.extend([one[0], one[1], two[0], two[1]]);
        // The hinge.
        rows.extend(self.velocity_of(2, [0.1, 0.0, 0.05]).less(self.velocity(3)).parts());
        let [x, y, _] = triad([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]).map(|axis| (self.direction(2, axis), self.spin(2)));
        let other = self.direction(3, [1.0, 0.0, 0.0]);
        let carried = self.spin(3).cross(other);
        rows.extend([x, y].map(|(across, spin)| {
            let (one, two) = (spin.cross(across).dot(other), across.dot(carried));
            [0, 1].map(|k| one[k] + two[k])
        }));
        // The drive of the axle.
        rows.push(Moving::fixed([0.0, 0.0, 1.0]).dot(self.spin(0)));
        // The constraint.
        let terms = [
            (0.4, self.direction(1, triad([0.0, 0.3, 1.0], [1.0, 0.0, 0.0])[0]).dot(self.spin(1))),
            (-2.0, self.direction(4, triad([0.1, 0.0, 1.0], [1.0, 1.0, 0.0])[2]).dot(self.velocity(4))),
            (0.7, self.direction(3, triad([0.0, 1.0, 0.5], [1.0, 0.0, 0.0])[1]).dot(self.spin(3))),
            (0.5, Moving::fixed([0.0, 1.0, 0.0]).dot(self.velocity(2))),
        ];
        rows.push([0, 1].map(|k| terms.iter().map(|(factor, term)| factor * term[k]).sum()));
        // The drive of a coordinate.
        rows.push(Moving::fixed([1.0, 0.0, 0.0]).dot(self.velocity(4)));
        rows
    }
}

fn skew(v: Vector3<f64>) -> Matrix3<f64> {
    v.cross_matrix()
}

/// Mass, centre and inertia in the axes of each body, with the joint's mass as a second one.
fn masses(body: usize) -> Vec<(f64, Vector3<f64>, Matrix3<f64>)> {
    let six = |[xx, yy, zz, xy, xz, yz]: [f64; 6]| Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
    let turned = || {
        let axis = Vector3::new(1.0, 2.0, 3.0).normalize();
        let (sine, cosine) = f64::to_radians(40.0).sin_cos();
        let rotation = Matrix3::identity() * cosine + skew(axis) * sine + axis * axis.transpose() * (1.0 - cosine);
        rotation * Matrix3::from_diagonal(&Vector3::new(0.02, 0.03, 0.025)) * rotation.transpose()
    };
    let own = match body {
        0 => (2.0, Vector3::new(0.03, -0.02, 0.01), turned()),
        1 => (0.8, Vector3::new(0.0, 0.01, 0.0), six([0.003, 0.003, 0.005, 0.0, 0.0, 0.0])),
        2 => (1.1, Vector3::zeros(), six([0.006, 0.007, 0.004, 0.0005, 0.0, 0.0002])),
        3 => (0.5, Vector3::new(0.04, 0.03, 0.0), six([0.001, 0.002, 0.0015, 0.0, 0.0, 0.0])),
        _ => (1.4, Vector3::zeros(), six([0.02, 0.03, 0.015, 0.0, 0.002, 0.001])),
    };
    let added = (0.2, Vector3::zeros(), Matrix3::identity() * 0.001);
    if body < 3 { vec![own, added] } else { vec![own] }
}

/// M and Q by speed of the bodies.
fn newton_and_euler(bodies: &[SpatialBody<f64>; BODIES]) -> (DMatrix<f64>, DVector<f64>) {
    let (mut m, mut q) = (DMatrix::zeros(6 * BODIES, 6 * BODIES), DVector::zeros(6 * BODIES));
    let mut push = |body: usize, force: Vector3<f64>, torque: Vector3<f64>| {
        let mut own = q.fixed_rows_mut::<3>(6 * body);
        own += force;
        let mut own = q.fixed_rows_mut::<3>(6 * body + 3);
        own += torque;
    };
    for (number, body) in bodies.iter().enumerate() {
        let spin = body.angular_velocity;
        for (mass, center, inertia) in masses(number) {
            let c = body.rotation * center;
            let inertia = body.rotation * inertia * body.rotation.transpose();
            let arm = skew(c);
            let blocks = [(0, 0, Matrix3::identity() * mass), (0, 3, -mass * arm), (3, 0, mass * arm), (3, 3, inertia - mass * arm * arm)];
            for (row, column, block) in blocks {
                let mut own = m.fixed_view_mut::<3, 3>(6 * number + row, 6 * number + column);
                own += block;
            }
            let force = mass * (Vector3::new(0.0, 0.0, -9.81) - spin.cross(&spin.cross(&c)));
            push(number, force, c.cross(&force) - spin.cross(&(inertia * spin)));
        }
    }
    let torque = bodies[0].rotation * Vector3::new(0.0, 0.0, 0.5);
    push(1, Vector3::zeros(), torque);
    push(0, Vector3::zeros(), -torque);
    let way = bodies[4].position - bodies[3].position;
    let along = way.normalize();
    let pull = (60.0 * (way.norm() - 0.5) + 0.7 * along.dot(&(bodies[4].velocity - bodies[3].velocity))) * along;
    push(3, pull, Vector3::zeros());
    push(4, -pull, Vector3::zeros());
    (m, q)
}

/// Accelerations, multipliers and Jᵀλ of one state.
fn solved(bodies: &[SpatialBody<f64>; BODIES], t: f64) -> (DVector<f64>, DVector<f64>, DMatrix<f64>) {
    let (m, q) = newton_and_euler(bodies);
    let parts = bodies.iter().flat_map(|body| body.velocity.iter().chain(body.angular_velocity.iter()).copied());
    let speeds = DVector::from_iterator(6 * BODIES, parts);
    let rows = Nodes { bodies, speeds: &speeds }.rows();
    let columns = (0..6 * BODIES).map(|k| {
        let mut unit = DVector::zeros(6 * BODIES);
        unit[k] = 1.0;
        DVector::from_vec(Nodes { bodies, speeds: &unit }.rows().into_iter().map(|[value, _]| value).collect())
    });
    let j = DMatrix::from_columns(&columns.collect::<Vec<_>>());
    // The rows of drives are equal to laws: their second derivatives.
    let mut gamma = DVector::from_vec(rows.iter().map(|[_, rate]| -rate).collect());
    let count = gamma.len();
    gamma[count - 3] -= 0.3 * 16.0 * (4.0 * t).sin();
    gamma[count - 1] += 0.2;
    let size = 6 * BODIES + count;
    let mut matrix = DMatrix::zeros(size, size);
    matrix.view_mut((0, 0), (6 * BODIES, 6 * BODIES)).copy_from(&m);
    matrix.view_mut((6 * BODIES, 0), (count, 6 * BODIES)).copy_from(&j);
    matrix.view_mut((0, 6 * BODIES), (6 * BODIES, count)).copy_from(&j.transpose());
    let mut right = DVector::zeros(size);
    right.rows_mut(0, 6 * BODIES).copy_from(&q);
    right.rows_mut(6 * BODIES, count).copy_from(&gamma);
    let found = matrix.full_piv_lu().solve(&right).expect("a regular matrix");
    (found.rows(0, 6 * BODIES).into_owned(), found.rows(6 * BODIES, count).into_owned(), j)
}

#[test]
fn every_row_on_shared_nodes_has_its_multiplier() {
    let mechanism = SharedNodes::default();
    let mut state = mechanism.initial_state().expect("a state");
    let mut integrator = Integrator::new(1e-10);
    for time in [0.0, 0.15, 0.4, 0.8] {
        mechanism.advance(&mut state, time, &mut integrator).expect("a motion");
        let bodies = [state.n0(), state.n1(), state.n2(), state.n3(), state.n4()];
        let (accelerations, multipliers, jacobian) = solved(&bodies, time);
        let parts = bodies.iter().flat_map(|body| body.acceleration.iter().chain(body.angular_acceleration.iter()).copied());
        let found = DVector::from_iterator(6 * BODIES, parts);
        let error = (&found - &accelerations).amax() / accelerations.amax();
        assert!(error < 1e-11, "accelerations at {time} s: {error:e}");
        let loads = mechanism.loads(&state);
        assert!(loads.is_unique.iter().all(|unique| *unique));
        let found = DVector::from_column_slice(loads.multipliers.as_slice());
        let error = (&found - &multipliers).amax() / multipliers.amax();
        assert!(error < 1e-11, "multipliers at {time} s: {error:e}");
        // What joints and drives do is −Jᵀλ: on the body of the last argument, of the gear joint on all, and along driven quantities.
        let part = |first: usize, count: usize, body: usize| {
            let own = -jacobian.rows(first, count).transpose() * multipliers.rows(first, count);
            (own.fixed_rows::<3>(6 * body).into_owned(), own.fixed_rows::<3>(6 * body + 3).into_owned())
        };
        let hinge = (loads.hinge().force, loads.hinge().torque);
        let gears = [loads.gears(), loads.gears_on_n1(), loads.gears_on_n2()].map(|load| (load.force, load.torque));
        let wanted = [part(16, 5, 3), part(5, 11, 0), part(5, 11, 1), part(5, 11, 2)];
        for (found, (force, torque)) in [hinge].into_iter().chain(gears).zip(wanted) {
            assert!((found.0 - force).norm() < 1e-11 * multipliers.amax(), "{} for {force}", found.0);
            assert!((found.1 - torque).norm() < 1e-11 * multipliers.amax(), "{} for {torque}", found.1);
        }
        let (turn, push) = (loads.turn(), loads.push());
        assert!((turn.effort + multipliers[21]).abs() < 1e-11 * multipliers.amax());
        assert!((turn.power - turn.effort * state.n0().angular_velocity.z).abs() < 1e-11 * multipliers.amax());
        assert!((push.power - push.effort * (0.2 + 0.2 * time)).abs() < 1e-11 * multipliers.amax());
    }
}
