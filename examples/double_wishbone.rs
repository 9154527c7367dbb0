//! A double wishbone suspension: camber and toe of a front wheel over its travel.
//!
//! ```text
//!    ═══o────o C            the upright hangs on two ball joints, B and C, at the ends of the wishbones, and
//!            ║ ┌┐           is kept from rotating about them by the tie rod to T, whose other end S the steering
//!            ╠═││ W         holds still
//!    ══o─────o B└┘
//! ```
//!
//! Every point follows in closed form from the angle of the lower wishbone: C is the intersection of its circle about the upper hinge
//! with the sphere about B, T is the intersection of three spheres about B, C and S, and B, C and T determine the upright.
//!
//! Coordinates are those of the stationary car: x forward, y to the left, z up. Camber is the angle by which the wheel leans outward at
//! its top, toe the angle by which its front points inward.
//!
//! Source of the terms: W. F. Milliken and D. L. Milliken, Race Car Vehicle Dynamics, chapter 17.

use std::error::Error;

use reuleaux::mechanism;
use reuleaux::nalgebra::{Matrix3, Rotation3, Unit, Vector3};
use reuleaux::picture::Drawable;
use reuleaux::view::View;
use reuleaux_examples::{figure, play, round, steps, still};

mechanism! {
    /// The left front wheel of a car, moved up and down by a test rig.
    #[picture]
    pub mechanism Wishbones in space {
        /// Amplitude of the wheel's vertical motion.
        param travel: Length = 80mm;
        /// Height of the inner end of the tie rod.
        param rack_height: Length = 206mm;

        ground {
            point lower = (120mm, 400mm, 180mm);
            axis lower_hinge = (-280, 0, 10);
            point upper = (80mm, 450mm, 425mm);
            axis upper_hinge = (-180, 0, -15);
            point S = (-120mm, 420mm, rack_height);
            axis x = (1, 0, 0);
            axis y = (0, 1, 0);
            axis z = (0, 0, 1);
        }
        // All frames are parallel to that of the stationary car.
        body lower {
            point hinge = (120mm, 400mm, 180mm);
            axis hinge_line = (-280, 0, 10);
            point B = (5mm, 750mm, 170mm);
        }
        body upper {
            point hinge = (80mm, 450mm, 425mm);
            axis hinge_line = (-180, 0, -15);
            point C = (-15mm, 715mm, 450mm);
        }
        body upright {
            point B = (5mm, 750mm, 170mm);
            point C = (-15mm, 715mm, 450mm);
            point T = (-110mm, 735mm, 200mm);
            point W = (0mm, 780mm, 300mm);
            axis spindle = (0, 1, 0);
        }

        joint lower_hinge = revolute(ground.lower, ground.lower_hinge, lower.hinge, lower.hinge_line);
        joint upper_hinge = revolute(ground.upper, ground.upper_hinge, upper.hinge, upper.hinge_line);
        joint lower_ball = spherical(lower.B, upright.B);
        joint upper_ball = spherical(upper.C, upright.C);
        joint tie_rod = distance(ground.S, upright.T, sqrt((10mm)^2 + (315mm)^2 + (206mm - 200mm)^2));
        drive bench = drive_z(upright.W, 300mm + travel * sin(1rad_s * t));

        output rise = upright.W.z - 300mm;
        output camber = -asin(dot(upright.spindle, ground.z));
        output toe = atan2(dot(upright.spindle, ground.x), dot(upright.spindle, ground.y));
        output lower_angle = lower_hinge.angle;
        output B = upright.B;
        output C = upright.C;
        output T = upright.T;
        output W = upright.W;
    }
}

type State = WishbonesState<f64>;

/// Hard points of the stationary car (m), as in the declaration.
const LOWER: Vector3<f64> = Vector3::new(0.12, 0.4, 0.18);
const UPPER: Vector3<f64> = Vector3::new(0.08, 0.45, 0.425);
const B: Vector3<f64> = Vector3::new(0.005, 0.75, 0.17);
const C: Vector3<f64> = Vector3::new(-0.015, 0.715, 0.45);
const T: Vector3<f64> = Vector3::new(-0.11, 0.735, 0.2);
const W: Vector3<f64> = Vector3::new(0.0, 0.78, 0.3);

fn main() -> Result<(), Box<dyn Error>> {
    let mechanism = Wishbones::default();
    let quarter = std::f64::consts::FRAC_PI_2;
    let mut travel: Vec<State> = mechanism.sweep(steps(0.0, -quarter, 40)).collect::<Result<_, _>>()?;
    travel.reverse();
    travel.pop();
    travel.extend(mechanism.sweep(steps(0.0, quarter, 40)).collect::<Result<Vec<State>, _>>()?);
    let low = Wishbones { rack_height: 0.196, ..mechanism };
    let steered: Vec<State> = low.sweep(steps(0.0, quarter, 40)).collect::<Result<_, _>>()?;

    for (m, states) in [(&mechanism, &travel), (&low, &steered)] {
        assert_places(m, states);
    }
    print(&mechanism, &travel);
    let figured = view(&mechanism, travel).over("travel of the wheel", "mm", |state| mechanism.rise(state).value * 1e3);
    figure("double_wishbone", &figured, 40, &[0, 80])?;
    // From the front of the car.
    still("double_wishbone_front", &figured.seen_from([1.0, 0.0, 0.0]), 40, &[0, 80])?;
    let whole: Vec<State> = mechanism.sweep(steps(0.0, 4.0 * quarter, 80)).collect::<Result<_, _>>()?;
    play("double_wishbone", &view(&mechanism, whole))
}

fn view(m: &Wishbones, states: Vec<State>) -> View<State> {
    m.view(states)
        .title("Double wishbone suspension")
        .outline("upright", round(0.3).iter().map(|at| W + Vector3::new(at.x, 0.0, at.y)))
        .trace("path of W", |state| m.W(state).value)
        .plot("camber", "°", |state| m.camber(state).value.to_degrees())
        .against("closed form", |state| angles(&exact(m, m.lower_angle(state).value)[4])[0].to_degrees())
        .plot("toe-in", "°", |state| m.toe(state).value.to_degrees())
        .against("closed form", |state| angles(&exact(m, m.lower_angle(state).value)[4])[1].to_degrees())
}

/// `place` rotated by `angle` (rad) about the line through `foot` along `axis`.
fn about(place: Vector3<f64>, foot: Vector3<f64>, axis: Vector3<f64>, angle: f64) -> Vector3<f64> {
    foot + Rotation3::from_axis_angle(&Unit::new_normalize(axis), angle) * (place - foot)
}

/// Position of C on its circle about the upper hinge if B is at `ball`: a cos φ + b sin φ = c, nearest to φ = 0.
fn upper_ball(ball: Vector3<f64>) -> Vector3<f64> {
    let axis = Vector3::new(-180.0, 0.0, -15.0).normalize();
    let arm = C - UPPER;
    let along = axis * axis.dot(&arm);
    let (out, aside, from) = (arm - along, axis.cross(&arm), ball - UPPER - along);
    let c = (from.norm_squared() + out.norm_squared() - (C - B).norm_squared()) / 2.0;
    let (a, b) = (from.dot(&out), from.dot(&aside));
    let around = (c / a.hypot(b)).acos();
    let middle = b.atan2(a);
    let angle = if (middle + around).abs() < (middle - around).abs() { middle + around } else { middle - around };
    UPPER + along + out * angle.cos() + aside * angle.sin()
}

/// A frame determined by three points: the columns of its matrix.
fn frame(places: [Vector3<f64>; 3]) -> Matrix3<f64> {
    let x = (places[1] - places[0]).normalize();
    let z = x.cross(&(places[2] - places[0])).normalize();
    Matrix3::from_columns(&[x, z.cross(&x), z])
}

/// Position of T: at its distances from B, C and the inner end of the tie rod, behind the plane of the three.
fn tie_rod_end(m: &Wishbones, b: Vector3<f64>, c: Vector3<f64>) -> Vector3<f64> {
    let s = Vector3::new(-0.12, 0.42, m.rack_height);
    let rod = 0.01_f64.powi(2) + 0.315_f64.powi(2) + 0.006_f64.powi(2);
    let (axes, far) = (frame([b, c, s]), [(c - b).norm(), (T - B).norm_squared(), (T - C).norm_squared()]);
    let [i, j] = [0, 1].map(|k| axes.column(k).dot(&(s - b)));
    let x = (far[1] - far[2] + far[0] * far[0]) / (2.0 * far[0]);
    let y = (far[1] - rod + i * i + j * j - 2.0 * i * x) / (2.0 * j);
    let z = (far[1] - x * x - y * y).sqrt();
    let sides = [z, -z].map(|z| b + axes * Vector3::new(x, y, z));
    if sides[0].x < sides[1].x { sides[0] } else { sides[1] }
}

/// Positions of B, C, T and W, and the direction of the spindle, at an angle of the lower wishbone (rad).
fn exact(m: &Wishbones, angle: f64) -> [Vector3<f64>; 5] {
    let b = about(B, LOWER, Vector3::new(-280.0, 0.0, 10.0), angle);
    let c = upper_ball(b);
    let t = tie_rod_end(m, b, c);
    let turned = frame([b, c, t]) * frame([B, C, T]).transpose();
    [b, c, t, b + turned * (W - B), turned * Vector3::y()]
}

/// Camber and toe (rad) of a wheel on a spindle.
fn angles(spindle: &Vector3<f64>) -> [f64; 2] {
    [-spindle.z.asin(), spindle.x.atan2(spindle.y)]
}

fn assert_places(m: &Wishbones, states: &[State]) {
    for state in states {
        let [b, c, t, w, spindle] = exact(m, m.lower_angle(state).value);
        let places = [(m.B(state), b), (m.C(state), c), (m.T(state), t), (m.W(state), w)];
        let off = places.iter().map(|(solved, exact)| (solved.value - exact).norm()).fold(0.0, f64::max);
        let [camber, toe] = angles(&spindle);
        let turned = (m.camber(state).value - camber).abs().max((m.toe(state).value - toe).abs());
        assert!(off < 4e-15 && turned < 2e-14, "off by {off:e} m and {turned:e} rad at {} m", m.rise(state).value);
    }
}

fn print(m: &Wishbones, travel: &[State]) {
    println!("wheel mm   camber °   toe-in °   half track mm   camber gain °/m");
    for state in travel.iter().step_by(8) {
        let [camber, toe] = [m.camber(state), m.toe(state)].map(|angle| angle.value.to_degrees());
        let gain = (m.camber(state).rate / m.rise(state).rate).to_degrees();
        println!("{:8.1}   {camber:8.3}   {toe:8.3}   {:13.2}   {gain:8.2}", m.rise(state).value * 1e3, m.W(state).value.y * 1e3);
    }
}
