//! Third derivatives of outputs in space, against closed forms.

use core::f64::consts::TAU;

use num_dual::{Dual3_64, DualNum, third_derivative};
use reuleaux::nalgebra::Vector3;
use reuleaux::{MotionWithJerk, mechanism};

use crate::near;

type Outcome = Result<(), Box<dyn std::error::Error>>;

mechanism! {
    /// A crank turns a slide that runs across its plane, by a rod with a ball at one end and a universal joint at the other.
    mechanism AcrossCrank in space {
        ground { point O = (0mm, 100mm, 120mm);  axis x = (1, 0, 0) from (0, 1, 0); }
        body crank { point O = (0mm, 0mm, 0mm);  axis x = (1, 0, 0) from (0, 1, 0);  point A = (0mm, 0mm, 80mm); }
        body rod   { point A = (0mm, 0mm, 0mm);  point B = (300mm, 0mm, 0mm);  axis y = (0, 1, 0);  start position = (0mm, 100mm, 200mm); }
        body slide { point B = (0mm, 0mm, 0mm);  axis x = (1, 0, 0);  axis z = (0, 0, 1);  start position = (200mm, 0mm, 0mm); }
        joint axle = revolute(ground.O, ground.x, crank.O, crank.x);
        joint ball = spherical(crank.A, rod.A);
        joint fork = universal(rod.B, rod.y, slide.B, slide.z);
        joint rail = translational(ground.position, ground.x, slide.B, slide.x);
        drive turn = drive_rotation(axle, 0.2rad + 3rad_s * t + 1rad_s2 * t^2);

        slice output stroke = slide.position.x with jerk;
        output middle = 0.5 * (rod.A + rod.B) with jerk;
        slice output pin = rod.A with jerk;
        /// A point beside the rod.
        slice output side = rod.A + 0.1m * rod.y with jerk;
    }
}

/// Pin of the crank.
fn pin(t: Dual3_64) -> [Dual3_64; 3] {
    let angle = t * 3.0 + t * t + 0.2;
    [angle * 0.0, -angle.sin() * 0.08 + 0.1, angle.cos() * 0.08 + 0.12]
}

/// Position of the slide.
fn stroke(t: Dual3_64) -> Dual3_64 {
    let [_, y, z] = pin(t);
    (-y * y - z * z + 0.09).sqrt()
}

/// A point beside the rod: its y axis is perpendicular to the rod and to the slide's z axis.
fn side(t: Dual3_64) -> [Dual3_64; 3] {
    let [px, py, pz] = pin(t);
    let along = [stroke(t) - px, -py];
    let length = (along[0] * along[0] + along[1] * along[1]).sqrt();
    [px - along[1] / length * 0.1, py + along[0] / length * 0.1, pz]
}

#[track_caller]
fn is_motion(found: MotionWithJerk<Vector3<f64>>, expected: impl Fn(usize) -> (f64, f64, f64, f64)) {
    for axis in 0..3 {
        let (value, rate, acceleration, jerk) = expected(axis);
        near(found.value[axis], value, 1e-13);
        near(found.rate[axis], rate, 1e-12);
        near(found.acceleration[axis], acceleration, 1e-11);
        near(found.jerk[axis], jerk, 1e-10);
    }
}

#[test]
fn the_jerk_of_a_spatial_slider_crank_is_that_of_its_triangle() -> Outcome {
    let mechanism = AcrossCrank::default();
    let (strokes, pins, sides) = (mechanism.solve_for_stroke(), mechanism.solve_for_pin(), mechanism.solve_for_side());
    let times = || (0..30).map(|step| 0.07 * f64::from(step));
    let slices = strokes.sweep(times()).zip(pins.sweep(times())).zip(sides.sweep(times()));
    for (state, ((of_stroke, of_pin), of_side)) in mechanism.sweep(times()).zip(slices) {
        let (state, of_stroke, of_pin, of_side) = (state?, of_stroke?.output(), of_pin?.output(), of_side?.output());
        let t = state.t;
        for found in [mechanism.stroke(&state), of_stroke] {
            let (value, rate, acceleration, jerk) = third_derivative(stroke, t);
            near(found.value, value, 1e-13);
            near(found.rate, rate, 1e-12);
            near(found.acceleration, acceleration, 1e-11);
            near(found.jerk, jerk, 1e-10);
        }
        let middle = |axis: usize| third_derivative(|t| (pin(t)[axis] + [stroke(t), t * 0.0, t * 0.0][axis]) * 0.5, t);
        is_motion(mechanism.middle(&state), middle);
        for found in [mechanism.pin(&state), of_pin] {
            is_motion(found, |axis| third_derivative(|t| pin(t)[axis], t));
        }
        for found in [mechanism.side(&state), of_side] {
            is_motion(found, |axis| third_derivative(|t| side(t)[axis], t));
        }
    }
    Ok(())
}

mechanism! {
    /// A platform on six cylinders: a block of seven unknowns, with a quaternion.
    mechanism Platform in space {
        let phase = 1turn * t / 4s;
        let place = (60mm * sin(phase), 60mm * (1 - cos(phase)), 700mm + 50mm * sin(2 * phase));
        let roll = 15deg * sin(phase);
        let n = unit((1, 2, 2));
        ground {
            for k in 0..3 {
                point B[2 * k] = (600mm * cos(120deg * k - 20deg), 600mm * sin(120deg * k - 20deg), 0mm);
                point B[2 * k + 1] = (600mm * cos(120deg * k + 20deg), 600mm * sin(120deg * k + 20deg), 0mm);
            }
        }
        body platform {
            for k in 0..3 {
                point P[2 * k] = (350mm * cos(120deg * k - 45deg), 350mm * sin(120deg * k - 45deg), -50mm);
                point P[2 * k + 1] = (350mm * cos(120deg * k + 45deg), 350mm * sin(120deg * k + 45deg), -50mm);
            }
            start position = (0mm, 0mm, 700mm);
        }
        for k in 0..3 {
            let p[2 * k] = (350mm * cos(120deg * k - 45deg), 350mm * sin(120deg * k - 45deg), -50mm);
            let p[2 * k + 1] = (350mm * cos(120deg * k + 45deg), 350mm * sin(120deg * k + 45deg), -50mm);
        }
        for i in 0..6 {
            let end[i] = place + p[i] * cos(roll) + cross(n, p[i]) * sin(roll) + n * dot(n, p[i]) * (1 - cos(roll));
            drive leg[i] = drive_distance(ground.B[i], platform.P[i], norm(end[i] - ground.B[i]));
        }
        output middle = platform.position with jerk;
        slice output corner = platform.P[0] with jerk;
    }
}

fn middle(t: Dual3_64) -> [Dual3_64; 3] {
    let phase = t * (TAU / 4.0);
    [phase.sin() * 0.06, -phase.cos() * 0.06 + 0.06, (phase * 2.0).sin() * 0.05 + 0.7]
}

fn corner(t: Dual3_64) -> [Dual3_64; 3] {
    let roll = (t * (TAU / 4.0)).sin() * 15.0_f64.to_radians();
    let (n, angle) = (Vector3::new(1.0, 2.0, 2.0) / 3.0, -45.0_f64.to_radians());
    let p = Vector3::new(0.35 * angle.cos(), 0.35 * angle.sin(), -0.05);
    let (across, along) = (n.cross(&p), n * n.dot(&p));
    let (sine, cosine) = roll.sin_cos();
    let middle = middle(t);
    [0, 1, 2].map(|i| middle[i] + cosine * p[i] + sine * across[i] + (-cosine + 1.0) * along[i])
}

#[test]
fn the_jerk_of_a_platform_is_that_of_its_law() -> Outcome {
    let platform = Platform::default();
    let slice = platform.solve_for_corner();
    let times = || (0..20).map(|step| 0.2 * f64::from(step));
    for (state, alone) in platform.sweep(times()).zip(slice.sweep(times())) {
        let (state, alone) = (state?, alone?);
        is_motion(platform.middle(&state), |axis| third_derivative(|t| middle(t)[axis], state.t));
        for found in [platform.corner(&state), alone.output()] {
            is_motion(found, |axis| third_derivative(|t| corner(t)[axis], state.t));
        }
    }
    Ok(())
}
