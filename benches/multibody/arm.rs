//! An arm of six hinges with the dimensions and masses of the UR5, as data.

use std::f64::consts::TAU;

use super::{Joint, Law, Model};

/// Denavit and Hartenberg's d in m.
pub const D: [f64; 6] = [0.089159, 0.0, 0.0, 0.10915, 0.09465, 0.0823];
/// Denavit and Hartenberg's a in m.
pub const A: [f64; 6] = [0.0, -0.425, -0.39225, 0.0, 0.0, 0.0];
/// The twist in quarter turns.
pub const TWIST: [i8; 6] = [1, 0, 0, 1, -1, 0];
/// Masses in kg.
pub const MASSES: [f64; 6] = [3.7, 8.393, 2.275, 1.219, 1.219, 0.1879];
/// Mass centres in the frames of their links, in m.
pub const CENTERS: [[f64; 3]; 6] = [
    [0.0, -0.02561, 0.00193],
    [0.2125, 0.0, 0.11336],
    [0.11993, 0.0, 0.0265],
    [0.0, -0.0018, 0.01634],
    [0.0, 0.0018, 0.01634],
    [0.0, 0.0, -0.001159],
];
/// Principal moments of inertia about the mass centres, in kg m².
pub const INERTIAS: [[f64; 3]; 6] = [
    [0.0084, 0.0064, 0.0084],
    [0.0078, 0.21, 0.21],
    [0.0016, 0.0462, 0.0462],
    [0.0016, 0.0016, 0.0009],
    [0.0016, 0.0016, 0.0009],
    [0.0001, 0.0001, 0.0001],
];
/// Offset (rad), amplitude (rad), frequency (1/s) and phase (rad) of the laws of the angles.
pub const DRIVES: [[f64; 4]; 6] =
    [[0.3, 0.8, 1.0, 0.0], [-1.2, 0.5, 1.0, 0.4], [1.1, 0.6, 2.0, 1.0], [-0.7, 0.7, 1.0, 1.5], [0.9, 0.9, 2.0, 2.2], [0.2, 1.1, 1.0, 0.9]];

/// The arm, driven.
#[must_use]
pub fn model(name: &str) -> Model {
    let mut model = Model::new(name);
    let (mut place, mut twist) = ([0.0; 3], 0.0);
    for (k, [offset, amplitude, frequency, phase]) in DRIVES.into_iter().enumerate() {
        let link = model.hang(&format!("link {}", k + 1), k.checked_sub(1), &[Joint::Turn(2)], &[offset]);
        let straight = 1.0 - f64::abs(twist);
        (link.place, link.turned) = (place, [[1.0, 0.0, 0.0], [0.0, straight, -twist], [0.0, twist, straight]]);
        (link.center, link.mass, link.inertia) = (CENTERS[k], MASSES[k], INERTIAS[k]);
        (place, twist) = ([A[k], 0.0, D[k]], f64::from(TWIST[k]));
        model.drives.push((k, Law::Harmonic(offset, amplitude, TAU * frequency, phase)));
    }
    model
}
