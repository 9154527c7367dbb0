//! S5: N loops in a row, each of an axle, a coupler with a ball and a cross, and the next axle, which lies askew. Every other loop is the one
//! before it from behind.

use std::f64::consts::{FRAC_PI_2, TAU};

use reuleaux::nalgebra::Vector3;
use reuleaux::{Real, SpatialBody, mechanism};
use reuleaux_benches::multibody::{Block, Cut, Joint, Law, Model, STRAIGHT, applied, product, transposed, turn};
use reuleaux_tests::common::twofold::Twofold;

use crate::Workload;
use crate::follower::{Entry, Follower, HAND, HAND_FAST, Runtime, Standard, Trigonometry, Turning, declared, resting};
use crate::rocker::{Axle, coupled, rocked};

macro_rules! chain {
    ($name:ident, $state:ident, $loops:literal, $module:ident) => {
        mod $module {
            use super::*;

            mechanism! {
                /// Loops in a row; frames lie in the mass centres.
                #[allow(far_start)]
                pub(super) mechanism $name in space {
                    let loops = $loops;
                    let length = 2m;
                    let arm[0] = 1m;
                    let arm[1] = 1.2m;
                    // About where the arms of the two kinds of axles are at the beginning.
                    let start[0] = 90deg;
                    let start[1] = -134deg;

                    // How the next axle is turned, how the one before it is, and how far it is away.
                    let there[0] = (cos(0.3), sin(0.5) * sin(0.3), -cos(0.5) * sin(0.3));
                    let there[1] = (0, cos(0.5), sin(0.5));
                    let there[2] = (sin(0.3), -sin(0.5) * cos(0.3), cos(0.5) * cos(0.3));
                    let back[0] = (cos(0.3), 0, sin(0.3));
                    let back[1] = (sin(0.5) * sin(0.3), cos(0.5), -sin(0.5) * cos(0.3));
                    let back[2] = (-cos(0.5) * sin(0.3), sin(0.5), cos(0.5) * cos(0.3));
                    let way = (2m, 0.3m, 0.5m);

                    // Axes and places of the axles; from the second one on the outer arm is ahead of the inner one.
                    let x[0] = (1, 0, 0);  let y[0] = (0, 1, 0);  let z[0] = (0, 0, 1);  let o[0] = (0m, 0m, 0m);
                    for k in 0..=loops { let ahead[k] = if k < 1 { 0rad } else { 0.35rad }; }
                    for k in 0..loops {
                        let u[k] = x[k] * cos(ahead[k]) + y[k] * sin(ahead[k]);
                        let v[k] = y[k] * cos(ahead[k]) - x[k] * sin(ahead[k]);
                        for i in 0..3 { let g[k][i] = (1 - k % 2) * there[i] + (k % 2) * back[i]; }
                        let x[k + 1] = u[k] * g[k][0].x + v[k] * g[k][0].y + z[k] * g[k][0].z;
                        let y[k + 1] = u[k] * g[k][1].x + v[k] * g[k][1].y + z[k] * g[k][1].z;
                        let z[k + 1] = u[k] * g[k][2].x + v[k] * g[k][2].y + z[k] * g[k][2].z;
                        let from[k] = u[k] * way.x + v[k] * way.y + z[k] * way.z;
                        let to[k] = x[k + 1] * way.x + y[k + 1] * way.y + z[k + 1] * way.z;
                        let o[k + 1] = o[k] + (1 - k % 2) * from[k] - (k % 2) * to[k];
                    }

                    ground {
                        for k in 0..=loops {
                            point O[k] = (o[k].x, o[k].y, o[k].z);
                            axis z[k] = (z[k].x, z[k].y, z[k].z) from (x[k].x, x[k].y, x[k].z);
                        }
                    }
                    for k in 0..=loops {
                        let out[k] = x[k] * cos(start[k % 2]) + y[k] * sin(start[k % 2]);
                        let aside[k] = y[k] * cos(start[k % 2]) - x[k] * sin(start[k % 2]);
                        body axle[k] {
                            axis z = (0, 0, 1) from (1, 0, 0);  axis y = (0, 1, 0);
                            point O = (-0.5m, 0m, 0m);
                            point A = (arm[k % 2] * cos(ahead[k]) - 0.5m, arm[k % 2] * sin(ahead[k]), 0m);
                            point B = (arm[k % 2] - 0.5m, 0m, 0m);
                            start position = o[k] + 0.5m * out[k];
                            start orientation = turn((0, 0, 1), atan2(out[k].y, out[k].x)) * turn((0, 1, 0), -asin(out[k].z))
                                * turn((1, 0, 0), atan2(aside[k].z, z[k].z));
                        }
                        joint pivot[k] = revolute(ground.O[k], ground.z[k], axle[k].O, axle[k].z);
                    }
                    for k in 0..loops {
                        let A[k] = o[k] + arm[k % 2] * (out[k] * cos(ahead[k]) + aside[k] * sin(ahead[k]));
                        let B[k] = o[k + 1] + arm[1 - k % 2] * out[k + 1];
                        let along[k] = unit(B[k] - A[k]);
                        let over[k] = unit(cross(aside[k + 1], along[k]));
                        let across[k] = cross(over[k], along[k]);
                        body coupler[k] {
                            axis z = (0, 0, 1);  point A = (-length / 2, 0m, 0m);  point B = (length / 2, 0m, 0m);
                            start position = (A[k] + B[k]) / 2;
                            start orientation = turn((0, 0, 1), atan2(along[k].y, along[k].x)) * turn((0, 1, 0), -asin(along[k].z))
                                * turn((1, 0, 0), atan2(across[k].z, over[k].z));
                        }
                        joint ball[k] = spherical(axle[k].A, coupler[k].A);
                        joint cross_pin[k] = universal(axle[k + 1].B, axle[k + 1].y, coupler[k].B, coupler[k].z);
                    }
                    drive motor = drive_rotation(pivot[0], 90deg + 0.6rad * sin(1turn * t / 1s));
                }
            }

            pub(super) fn workload() -> Workload {
                Workload {
                    model: model($loops),
                    contenders: || {
                        vec![
                            Entry::new(HAND_FAST, Row::new($loops, closed::<Runtime>)),
                            Entry::new(HAND, Row::new($loops, closed::<Standard>)),
                            declared!($name, $state, |state| [&state.axle()[..], &state.coupler()[..]].concat()),
                        ]
                    },
                }
            }
        }
    };
}

chain!(ChainOf1, ChainOf1State, 1, of_1);
chain!(ChainOf10, ChainOf10State, 10, of_10);
chain!(ChainOf100, ChainOf100State, 100, of_100);

pub(crate) fn workloads() -> [Workload; 3] {
    [of_1::workload(), of_10::workload(), of_100::workload()]
}

const ARMS: [f64; 2] = [1.0, 1.2];
const COUPLER: f64 = 2.0;
/// From the inner arm of an axle, from the second one on, to its outer arm (rad).
const AHEAD: f64 = 0.35;
/// Amplitude of the first axle (rad).
const SWING: f64 = 0.6;

/// Places and matrices by rows of all axles.
fn frames(loops: usize) -> Vec<([f64; 3], [[f64; 3]; 3])> {
    let of = |value: f64| Twofold::of(value);
    let there = product(turn(0, of(0.5)), turn(1, of(0.3)));
    let (mut place, mut matrix) = ([of(0.0); 3], STRAIGHT.map(|row| row.map(of)));
    let mut frames = vec![(place, matrix)];
    for k in 0..loops {
        let outer = if k == 0 { matrix } else { product(matrix, turn(2, of(AHEAD))) };
        let is_forward = k % 2 == 0;
        matrix = product(outer, if is_forward { there } else { transposed(there) });
        let way = applied(if is_forward { outer } else { matrix }, [2.0, 0.3, 0.5].map(of));
        place = std::array::from_fn(|i| if is_forward { place[i] + way[i] } else { place[i] - way[i] });
        frames.push((place, matrix));
    }
    frames.into_iter().map(|(place, matrix)| (place.map(|entry| entry.high), matrix.map(|row| row.map(|entry| entry.high)))).collect()
}

/// All axles, then all couplers.
fn model(loops: usize) -> Model {
    let mut model = Model::new(&format!("S5 chain of {loops}"));
    for (k, (place, turned)) in frames(loops).into_iter().enumerate() {
        let axle = model.hang("axle", None, &[Joint::Turn(2)], &[[FRAC_PI_2, -2.345][k % 2]]);
        (axle.place, axle.turned, axle.center) = (place, turned, [0.5, 0.0, 0.0]);
    }
    for k in 0..loops {
        let start = [[1.787, 2.32], [3.334, 2.499]][k % 2];
        let coupler = model.hang("coupler", Some(k + 1), &[Joint::Turn(1), Joint::Turn(2)], &start);
        (coupler.place, coupler.center) = ([ARMS[1 - k % 2], 0.0, 0.0], [-0.5 * COUPLER, 0.0, 0.0]);
        let first = coupler.first;
        let ahead = if k == 0 { 0.0 } else { AHEAD };
        let pin = [ARMS[k % 2] * ahead.cos(), ARMS[k % 2] * ahead.sin(), 0.0];
        model.cuts.push(Cut::Meet((Some(k), pin), (Some(loops + 1 + k), [-COUPLER, 0.0, 0.0])));
        model.blocks.push(Block { unknowns: vec![k + 1, first, first + 1], cuts: vec![k] });
    }
    model.drives.push((0, Law::Harmonic(FRAC_PI_2, SWING, TAU, 0.0)));
    model
}

/// The axles of a chain and all its bodies.
struct Row<F> {
    axles: Vec<Axle>,
    step: F,
    bodies: Vec<SpatialBody<f64>>,
}

impl<F: Fn(&[Axle], f64, &mut [SpatialBody<f64>])> Row<F> {
    fn new(loops: usize, step: F) -> Self {
        let axles: Vec<Axle> = frames(loops).into_iter().map(|(place, rows)| Axle::new(place, rows)).collect();
        let mut bodies = vec![resting(); 2 * loops + 1];
        step(&axles, 0.0, &mut bodies);
        Self { axles, step, bodies }
    }
}

impl<F: Fn(&[Axle], f64, &mut [SpatialBody<f64>])> Follower for Row<F> {
    fn restart(&mut self) {}

    #[inline]
    fn step(&mut self, t: f64) {
        (self.step)(&self.axles, t, &mut self.bodies);
    }

    fn bodies(&self) -> Vec<SpatialBody<f64>> {
        self.bodies.clone()
    }
}

/// Loop after loop; no angle is needed but the first.
#[inline(always)]
fn closed<T: Trigonometry>(axles: &[Axle], t: f64, bodies: &mut [SpatialBody<f64>]) {
    let (sine, cosine) = T::of(TAU * t);
    let angle = T::of(FRAC_PI_2 + SWING * sine);
    let mut speeds = [SWING * TAU * cosine, -SWING * TAU * TAU * sine];
    let mut turning = Turning {
        axes: [Vector3::new(angle.1, angle.0, 0.0), Vector3::new(-angle.0, angle.1, 0.0), Vector3::z()],
        omega: Vector3::new(0.0, 0.0, speeds[0]),
        alpha: Vector3::new(0.0, 0.0, speeds[1]),
    };
    let (of_axles, of_couplers) = bodies.split_at_mut(axles.len());
    let [x, y, _] = turning.axes;
    of_axles[0] = turning.body(&axles[0].end([x, y], 0.5, speeds));
    let (mut out, mut ahead) = (x, y);
    let (sine, cosine) = AHEAD.sin_cos();
    let rest = axles.windows(2).zip(&mut of_axles[1..]).zip(of_couplers).enumerate();
    for (k, ((pair, of_axle), of_coupler)) in rest {
        let (inner, outer) = (ARMS[k % 2], ARMS[1 - k % 2]);
        let pin = pair[0].end([out, ahead], inner, speeds);
        (turning, speeds) = rocked(&pair[1], &pin, outer, COUPLER);
        let [x, y, _] = turning.axes;
        let (coupler, center) = coupled(&turning, &pin, &pair[1].end([x, y], outer, speeds), COUPLER, -1.0);
        *of_axle = turning.body(&pair[1].end([x, y], 0.5, speeds));
        *of_coupler = coupler.body(&center);
        (out, ahead) = (x * cosine + y * sine, y * cosine - x * sine);
    }
}
