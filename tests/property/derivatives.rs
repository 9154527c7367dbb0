//! Φ_q, ν and γ are the derivatives of Φ: of the emitted Φ itself, evaluated in hyper-dual numbers.
//!
//! ```text
//! Φ_q   along q + e_j s
//! ν     minus the derivative along t + s
//! γ     minus the second derivative along (q + s q̇, t + s)
//! ```
//!
//! Rate and acceleration of an output are its derivatives along (q + s q̇ + s² q̈ / 2, t + s).

use reuleaux_tests::common::all::{Visitor, visit, visit_defined};
use reuleaux_tests::common::declared::{Declared, Instant, Moving};

use crate::dual::Hyper;
use crate::random::{generator, instant, mechanism};

/// Number of random states per declaration.
const STATES: usize = 100;

/// Allowed difference relative to the largest entry of the row and its second derivative: the rounding errors of both sides.
const ALLOWED: f64 = 500.0 * f64::EPSILON;

#[test]
fn jacobian_nu_and_gamma_are_the_derivatives_of_phi() {
    let mut derived = Derived { largest: 0.0, rows: 0 };
    visit(&mut derived);
    visit_defined(&mut derived);
    println!("{} rows compared, largest relative difference {:e}", derived.rows, derived.largest);
}

#[test]
fn rates_and_accelerations_of_outputs_are_their_derivatives() {
    let mut moved = Moved { largest: 0.0, outputs: 0 };
    visit(&mut moved);
    println!("{} outputs compared, largest relative difference {:e}", moved.outputs, moved.largest);
    assert!(moved.outputs > 0);
}

struct Derived {
    largest: f64,
    rows: usize,
}

/// Φ along q + s `direction`, t + s `rate`.
fn along<D: Declared>(mechanism: &D, at: &Instant, direction: impl Fn(usize) -> f64, rate: f64) -> Vec<Hyper> {
    let q: Vec<Hyper> = at.q.iter().enumerate().map(|(i, x)| Hyper::new(*x, direction(i), direction(i))).collect();
    mechanism.phi_over(&q, Hyper::new(at.t, rate, rate))
}

impl Visitor for Derived {
    fn visit<D: Declared>(&mut self, name: &'static str) {
        let mut rng = generator(name);
        let n = D::size().1;
        for _ in 0..STATES {
            let (mechanism, _) = mechanism::<D>(&mut rng);
            let at = instant(&mut rng, n);
            let rows = mechanism.rows(&at);
            let columns: Vec<Vec<Hyper>> = (0..n).map(|j| along(&mechanism, &at, |i| f64::from(u8::from(i == j)), 0.0)).collect();
            let (in_time, in_motion) = (along(&mechanism, &at, |_| 0.0, 1.0), along(&mechanism, &at, |i| at.qd[i], 1.0));
            for row in 0..rows.phi.len() {
                self.rows += 1;
                // Bound of the row's terms: its entries, and its curvature along each coordinate.
                let entries = rows.jacobian[row].iter().chain([&rows.phi[row], &rows.nu[row], &rows.gamma[row]]).map(|entry| entry.abs());
                let size = 1.0 + entries.chain(columns.iter().map(|column| column[row].0.eps1eps2.abs())).fold(0.0, f64::max);
                let mut compare = |what: &str, found: f64, derived: f64| {
                    let difference = (found - derived).abs() / size;
                    self.largest = self.largest.max(difference);
                    assert!(difference <= ALLOWED, "{name}, {what} of row {row}: {found:e} for {derived:e} at {at:?}");
                };
                compare("Φ", rows.phi[row], in_motion[row].0.re);
                for (column, entry) in rows.jacobian[row].iter().enumerate() {
                    compare("Φ_q", *entry, columns[column][row].0.eps1);
                }
                compare("ν", rows.nu[row], -in_time[row].0.eps1);
                compare("γ", rows.gamma[row], -in_motion[row].0.eps1eps2);
            }
        }
    }
}

struct Moved {
    largest: f64,
    outputs: usize,
}

impl Visitor for Moved {
    fn visit<D: Declared>(&mut self, name: &'static str) {
        let mut rng = generator(name);
        for _ in 0..STATES {
            let (mechanism, _) = mechanism::<D>(&mut rng);
            let at = instant(&mut rng, D::size().1);
            // Outputs depend on q, q̇, q̈ and t; the derivatives of their rates are not tested.
            let constant = |values: &[f64]| values.iter().map(|x| Hyper::new(*x, 0.0, 0.0)).collect();
            let q = (0..at.q.len()).map(|i| Hyper::moving(at.q[i], at.qd[i], at.qdd[i])).collect();
            let moving = Moving { t: Hyper::moving(at.t, 1.0, 0.0), q, qd: constant(&at.qd), qdd: constant(&at.qdd) };
            for (found, [derived, ..]) in mechanism.outputs(&at).into_iter().zip(mechanism.outputs_over(moving)) {
                self.outputs += 1;
                let derived = [derived.0.re, derived.0.eps1, derived.0.eps1eps2];
                let size = 1.0 + found.iter().map(|part| part.abs()).fold(0.0, f64::max);
                for (found, derived) in found.into_iter().zip(derived) {
                    let difference = (found - derived).abs() / size;
                    self.largest = self.largest.max(difference);
                    assert!(difference <= ALLOWED, "{name}: {found:e} for {derived:e} at {at:?}");
                }
            }
        }
    }
}
