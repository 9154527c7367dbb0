//! S4: a double wishbone suspension with a rack, whose wheel centre is moved up and down.

use std::f64::consts::TAU;

use reuleaux::nalgebra::{Matrix3, Vector3};
use reuleaux::{SpatialBody, mechanism};
use reuleaux_benches::multibody::{Cut, Joint, Law, Model, transposed};

use crate::Workload;
use crate::follower::{Entry, HAND, HAND_FAST, Hand, Point, Runtime, Standard, Trigonometry, Turning, declared};

mechanism! {
    /// A wheel that is moved up and down, and steered; frames lie in the mass centres.
    pub mechanism Wishbones in space {
        let lower_arm = (200mm, 350mm, -20mm);
        let upper_arm = (170mm, 250mm, 20mm);
        let lower_reach = dot(lower_arm, unit((400, 20, 10)));
        let upper_reach = dot(upper_arm, unit((300, 20, -10)));
        let lower_out = sqrt(dot(lower_arm, lower_arm) - lower_reach^2);
        let upper_out = sqrt(dot(upper_arm, upper_arm) - upper_reach^2);
        let rod = norm((-10mm, 320mm, -10mm));

        ground {
            point lower = (-200mm, 400mm, 200mm);  axis lower_hinge = (400, 20, 10) from (200, 350, -20);
            point upper = (-150mm, 450mm, 500mm);  axis upper_hinge = (300, 20, -10) from (170, 250, 20);
            point rack = (150mm, 400mm, 250mm);    axis y = (0, 1, 0);
        }
        body lower {
            axis hinge = (1, 0, 0) from (0, 1, 0);
            point O = (-lower_reach / 2, -lower_out / 2, 0mm);  point B = (lower_reach / 2, lower_out / 2, 0mm);
        }
        body upper {
            axis hinge = (1, 0, 0) from (0, 1, 0);
            point O = (-upper_reach / 2, -upper_out / 2, 0mm);  point C = (upper_reach / 2, upper_out / 2, 0mm);
        }
        body upright {
            point B = (0mm, -50mm, -120mm);  point C = (20mm, -100mm, 220mm);  point T = (140mm, -80mm, -60mm);
            start position = (0mm, 800mm, 300mm);
        }
        body rack { axis y = (0, 1, 0);  axis x = (1, 0, 0);  start position = (150mm, 410mm, 250mm); }
        body tie_rod {
            axis z = (0, 0, 1);  point S = (0mm, -160mm, 0mm);  point T = (0mm, rod - 160mm, 0mm);
            start position = (145mm, 565mm, 245mm);
        }

        joint lower_hinge = revolute(ground.lower, ground.lower_hinge, lower.O, lower.hinge);
        joint upper_hinge = revolute(ground.upper, ground.upper_hinge, upper.O, upper.hinge);
        joint lower_ball = spherical(lower.B, upright.B);
        joint upper_ball = spherical(upper.C, upright.C);
        joint rail = translational(ground.rack, ground.y, rack.position, rack.y);
        joint inner = universal(rack.position, rack.x, tie_rod.S, tie_rod.z);
        joint outer = spherical(tie_rod.T, upright.T);
        drive bench = drive_z(upright.position, 300mm + 80mm * sin(1turn * t / 1s));
        drive steering = drive_translation(rail, 20mm * sin(2turn * t / 1s + 0.5rad));
    }
}

/// Hard points at rest (m): ends of the hinges' axes, balls, ends of the tie rod, wheel centre.
const LOWER: [Vector3<f64>; 2] = [Vector3::new(-0.2, 0.4, 0.2), Vector3::new(0.2, 0.42, 0.21)];
const UPPER: [Vector3<f64>; 2] = [Vector3::new(-0.15, 0.45, 0.5), Vector3::new(0.15, 0.47, 0.49)];
const B: Vector3<f64> = Vector3::new(0.0, 0.75, 0.18);
const C: Vector3<f64> = Vector3::new(0.02, 0.7, 0.52);
const S: Vector3<f64> = Vector3::new(0.15, 0.4, 0.25);
const T: Vector3<f64> = Vector3::new(0.14, 0.72, 0.24);
const W: Vector3<f64> = Vector3::new(0.0, 0.8, 0.3);
/// Mass centre of the tie rod along it.
const ALONG: f64 = 0.16;
/// Height of the wheel centre, and displacement of the rack: offset, amplitude, frequency, phase.
const HEIGHT: [f64; 4] = [0.3, 0.08, TAU, 0.0];
const RACK: [f64; 4] = [0.0, 0.02, 2.0 * TAU, 0.5];

pub(crate) fn workload() -> Workload {
    let mut model = Model::new("S4 double wishbone");
    let law = |[offset, amplitude, omega, phase]: [f64; 4]| Law::Harmonic(offset, amplitude, omega, phase);
    let rows = |arm: &Arm| std::array::from_fn(|i| arm.axes.map(|axis| axis[i]));
    let arms = [Arm::new(LOWER, B), Arm::new(UPPER, C)];
    for (name, arm) in ["lower", "upper"].into_iter().zip(&arms) {
        let body = model.hang(name, None, &[Joint::Turn(0)], &[0.0]);
        (body.place, body.turned, body.center) = (arm.place.into(), rows(arm), [0.5 * arm.reach, 0.5 * arm.out, 0.0]);
    }
    let upright = model.hang("upright", Some(0), &[Joint::Turn(2), Joint::Turn(1), Joint::Turn(0)], &[0.07, -0.01, 0.0]);
    (upright.place, upright.turned) = ([arms[0].reach, arms[0].out, 0.0], transposed(rows(&arms[0])));
    upright.center = (W - B).into();
    model.hang("rack", None, &[Joint::Shift(1)], &[0.0]).place = S.into();
    model.hang("tie rod", Some(3), &[Joint::Turn(0), Joint::Turn(2)], &[-0.03, 0.03]).center = [0.0, ALONG, 0.0];
    let of_upright = |point: Vector3<f64>| (Some(2), (point - B).into());
    model.cuts = vec![
        Cut::Meet(of_upright(C), (Some(1), [arms[1].reach, arms[1].out, 0.0])),
        Cut::Meet(of_upright(T), (Some(4), [0.0, (T - S).norm(), 0.0])),
        Cut::Height(of_upright(W), law(HEIGHT)),
    ];
    model.drives.push((5, law(RACK)));
    model.close();
    Workload { model, contenders }
}

fn contenders() -> Vec<Entry> {
    let [fast, plain] = [(); 2].map(|()| Corner::new());
    let start = fast.start();
    vec![
        Entry::new(HAND_FAST, Hand::new(start.clone(), move |memory, t| fast.followed::<Runtime>(memory, t))),
        Entry::new(HAND, Hand::new(start, move |memory, t| plain.followed::<Standard>(memory, t))),
        declared!(Wishbones, WishbonesState, |state| {
            vec![state.lower(), state.upper(), state.upright(), state.rack(), state.tie_rod()]
        }),
    ]
}

/// A wishbone at rest: a place on its hinge, its frame with x along the hinge, and its ball in it.
struct Arm {
    place: Vector3<f64>,
    axes: [Vector3<f64>; 3],
    reach: f64,
    out: f64,
}

impl Arm {
    fn new([place, end]: [Vector3<f64>; 2], ball: Vector3<f64>) -> Self {
        let (x, arm) = ((end - place).normalize(), ball - place);
        let reach = arm.dot(&x);
        let y = (arm - x * reach).normalize();
        Self { place, axes: [x, y, x.cross(&y)], reach, out: arm.dot(&y) }
    }

    /// Its frame after a turn, at rest.
    #[inline(always)]
    fn turned(&self, (sine, cosine): (f64, f64)) -> [Vector3<f64>; 3] {
        let [x, y, z] = self.axes;
        [x, y * cosine + z * sine, z * cosine - y * sine]
    }

    /// The ball in this frame, and how far and where it goes with the angle.
    #[inline(always)]
    fn ball(&self, [x, y, z]: &[Vector3<f64>; 3]) -> Ball {
        let outwards = y * self.out;
        Ball { place: self.place + x * self.reach + outwards, outwards, ahead: z * self.out }
    }

    #[inline(always)]
    fn body(&self, axes: [Vector3<f64>; 3], ball: &Ball, rate: f64, turning: f64) -> SpatialBody<f64> {
        let x = axes[0];
        let center = Point { p: (self.place + ball.place) * 0.5, v: ball.velocity(rate) * 0.5, a: ball.acceleration(rate, turning) * 0.5 };
        Turning { axes, omega: x * rate, alpha: x * turning }.body(&center)
    }
}

/// A ball on a circle.
#[derive(Clone, Copy)]
struct Ball {
    place: Vector3<f64>,
    outwards: Vector3<f64>,
    ahead: Vector3<f64>,
}

impl Ball {
    #[inline(always)]
    fn velocity(&self, rate: f64) -> Vector3<f64> {
        self.ahead * rate
    }

    #[inline(always)]
    fn acceleration(&self, rate: f64, turning: f64) -> Vector3<f64> {
        self.ahead * turning - self.outwards * (rate * rate)
    }
}

/// Angles of the wishbones and place of T, each with rates and accelerations.
#[derive(Clone)]
struct Memory {
    t: f64,
    angles: [[f64; 2]; 3],
    joint: [Vector3<f64>; 3],
}

/// Dimensions of the suspension.
struct Corner {
    arms: [Arm; 2],
    /// Squares of distances: of C and T from B, of T from C and from S.
    squares: [f64; 4],
    rod: f64,
    /// W − B in terms of C − B, T − B and their product.
    wheel: [f64; 3],
    /// The inverse of the matrix of those three.
    inverse: Matrix3<f64>,
    /// One over the square of the product.
    per: f64,
}

/// Rows of the matrix of Newton's method, and a motion of all for a unit motion of the lower wishbone.
struct Tangent {
    /// C − B, T − B, T − C, T − S.
    edges: [Vector3<f64>; 4],
    /// One over how the first one grows with the angle of the upper wishbone.
    per_upper: f64,
    /// Columns of the inverse for the rows of the other three.
    columns: [Vector3<f64>; 3],
    /// Derivatives of the wheel's height by the first two.
    height: [Vector3<f64>; 2],
    /// How far the third one grows with the angle of the upper wishbone.
    lever: f64,
    upper: f64,
    joint: Vector3<f64>,
    /// One over the wheel's height for a unit motion.
    per_height: f64,
}

/// Angles of lower and upper wishbone, and T.
type Change = ([f64; 2], Vector3<f64>);

impl Tangent {
    #[inline(always)]
    fn new(of: &Corner, [b, c]: &[Ball; 2], joint: Vector3<f64>, rack: Vector3<f64>) -> Self {
        let edges = [c.place - b.place, joint - b.place, joint - c.place, joint - rack];
        let [w1, w2, e3, e4] = edges;
        let per_upper = 1.0 / w1.dot(&c.ahead);
        let upper = w1.dot(&b.ahead) * per_upper;
        let across = e3.cross(&e4);
        let per = 1.0 / w2.dot(&across);
        let columns = [across * per, e4.cross(&w2) * per, w2.cross(&e3) * per];
        let lever = e3.dot(&c.ahead);
        let moved = columns[0] * w2.dot(&b.ahead) + columns[1] * (lever * upper);
        let [of_c, of_t, across] = of.wheel;
        let height = [Vector3::new(across * w2.y, -across * w2.x, of_c), Vector3::new(-across * w1.y, across * w1.x, of_t)];
        let rise = b.ahead.z + height[0].dot(&(c.ahead * upper - b.ahead)) + height[1].dot(&(moved - b.ahead));
        Self { edges, per_upper, columns, height, lever, upper, joint: moved, per_height: 1.0 / rise }
    }

    /// The change of the unknowns that changes the rows of the four edges and the wheel's height by these numbers.
    #[inline(always)]
    fn solve(&self, [first, second, third, fourth]: [f64; 4], rise: f64, upper_ball: &Ball) -> Change {
        let upper = first * self.per_upper;
        let joint = self.columns[0] * second + self.columns[1] * (third + self.lever * upper) + self.columns[2] * fourth;
        let risen = self.height[0].dot(&upper_ball.ahead) * upper + self.height[1].dot(&joint);
        let lower = (rise - risen) * self.per_height;
        ([lower, upper + self.upper * lower], joint + self.joint * lower)
    }

    /// The same where only the last edge and the height change.
    #[inline(always)]
    fn driven(&self, fourth: f64, rise: f64) -> Change {
        let joint = self.columns[2] * fourth;
        let lower = (rise - self.height[1].dot(&joint)) * self.per_height;
        ([lower, self.upper * lower], joint + self.joint * lower)
    }
}

impl Corner {
    fn new() -> Self {
        let (w1, w2) = (C - B, T - B);
        let product = w1.cross(&w2);
        let inverse = Matrix3::from_columns(&[w1, w2, product]).try_inverse().unwrap_or_else(|| panic!("three points of a line"));
        Self {
            arms: [Arm::new(LOWER, B), Arm::new(UPPER, C)],
            squares: [w1, w2, T - C, T - S].map(|edge| edge.norm_squared()),
            rod: (T - S).norm(),
            wheel: (inverse * (W - B)).into(),
            inverse,
            per: 1.0 / product.norm_squared(),
        }
    }

    /// At t = 0; the second time from angles as they are.
    fn start(&self) -> Memory {
        let mut memory = Memory { t: 0.0, angles: [[0.0; 2]; 3], joint: [T, Vector3::zeros(), Vector3::zeros()] };
        for _ in 0..2 {
            self.followed::<Standard>(&mut memory, 0.0);
        }
        memory
    }

    /// Newton's method from where all would be with the accelerations of the step before.
    #[inline(always)]
    fn followed<F: Trigonometry>(&self, memory: &mut Memory, t: f64) -> [SpatialBody<f64>; 5] {
        let h = t - memory.t;
        let [angles, rates, turnings] = memory.angles;
        let mut angles: [f64; 2] = std::array::from_fn(|k| angles[k] + h * (rates[k] + 0.5 * h * turnings[k]));
        let mut joint = memory.joint[0] + (memory.joint[1] + memory.joint[2] * (0.5 * h)) * h;
        let [height, rack] = [HEIGHT, RACK].map(|law| harmonic::<F>(law, t));
        let place = S + Vector3::new(0.0, rack[0], 0.0);
        let mut turns = F::of_each(angles);
        let (axes, balls, tangent) = loop {
            let axes: [_; 2] = std::array::from_fn(|k| self.arms[k].turned(turns[k]));
            let balls = [self.arms[0].ball(&axes[0]), self.arms[1].ball(&axes[1])];
            let tangent = Tangent::new(self, &balls, joint, place);
            let rows: [f64; 4] = std::array::from_fn(|k| 0.5 * (self.squares[k] - tangent.edges[k].norm_squared()));
            let [w1, w2, ..] = tangent.edges;
            let [of_c, of_t, across] = self.wheel;
            let rise = height[0] - (balls[0].place.z + of_c * w1.z + of_t * w2.z + across * (w1.x * w2.y - w1.y * w2.x));
            let (changes, shift) = tangent.solve(rows, rise, &balls[1]);
            for k in 0..2 {
                angles[k] += changes[k];
                turns[k] = turned(turns[k], changes[k]);
            }
            joint += shift;
            // The next correction would be about the square of this one.
            if changes[0] * changes[0] + shift.norm_squared() < 1e-15 {
                let axes: [_; 2] = std::array::from_fn(|k| self.arms[k].turned(turns[k]));
                let balls = [self.arms[0].ball(&axes[0]), self.arms[1].ball(&axes[1])];
                break (axes, balls, Tangent::new(self, &balls, joint, place));
            }
        };
        let (rates, joint_rate) = tangent.driven(tangent.edges[3].y * rack[1], height[1]);
        let (turnings, joint_turning) = self.accelerations(&tangent, &balls, rates, joint_rate, [height[2], rack[1], rack[2]]);
        *memory = Memory { t, angles: [angles, rates, turnings], joint: [joint, joint_rate, joint_turning] };
        let point = Point { p: joint, v: joint_rate, a: joint_turning };
        let arm = |k: usize| self.arms[k].body(axes[k], &balls[k], rates[k], turnings[k]);
        let [across, along] = [Vector3::new(0.0, rack[1], 0.0), Vector3::new(0.0, rack[2], 0.0)];
        let inner = Point { p: place, v: across, a: along };
        let still = Turning { axes: [Vector3::x(), Vector3::y(), Vector3::z()], omega: Vector3::zeros(), alpha: Vector3::zeros() };
        [arm(0), arm(1), self.upright(&balls, rates, turnings, &point), still.body(&inner), self.tie_rod(&inner, &point)]
    }

    #[inline(always)]
    fn accelerations(&self, of: &Tangent, [b, c]: &[Ball; 2], rates: [f64; 2], joint: Vector3<f64>, driven: [f64; 3]) -> Change {
        let [rise, rack, rack_change] = driven;
        let [w1, w2, e3, e4] = of.edges;
        let (vb, vc) = (b.velocity(rates[0]), c.velocity(rates[1]));
        let (ab, ac) = (b.acceleration(rates[0], 0.0), c.acceleration(rates[1], 0.0));
        let (v1, v2, v3, v4) = (vc - vb, joint - vb, joint - vc, joint - Vector3::new(0.0, rack, 0.0));
        let rows = [
            -v1.norm_squared() - w1.dot(&(ac - ab)),
            w2.dot(&ab) - v2.norm_squared(),
            e3.dot(&ac) - v3.norm_squared(),
            e4.y * rack_change - v4.norm_squared(),
        ];
        let rest = ab.z + of.height[0].dot(&(ac - ab)) - of.height[1].dot(&ab) + 2.0 * self.wheel[2] * (v1.x * v2.y - v1.y * v2.x);
        of.solve(rows, rise - rest, c)
    }

    /// From the motion of three points: ω = ((ẇ₂·w₃) w₁ − (ẇ₁·w₃) w₂ + (ẇ₁·w₂) w₃) / w₃² with w₃ = w₁ × w₂, and ω̇ in the same way.
    #[inline(always)]
    fn upright(&self, [b, c]: &[Ball; 2], rates: [f64; 2], turnings: [f64; 2], joint: &Point) -> SpatialBody<f64> {
        let root = Point { p: b.place, v: b.velocity(rates[0]), a: b.acceleration(rates[0], turnings[0]) };
        let (w1, w2) = (c.place - root.p, joint.p - root.p);
        let w3 = w1.cross(&w2);
        let spun = |v1: Vector3<f64>, v2: Vector3<f64>| (w1 * v2.dot(&w3) - w2 * v1.dot(&w3) + w3 * v1.dot(&w2)) * self.per;
        let (v1, v2) = (c.velocity(rates[1]) - root.v, joint.v - root.v);
        let omega = spun(v1, v2);
        let (a1, a2) = (c.acceleration(rates[1], turnings[1]) - root.a, joint.a - root.a);
        let alpha = spun(a1 - omega.cross(&v1), a2 - omega.cross(&v2));
        let axis = |j: usize| w1 * self.inverse[(0, j)] + w2 * self.inverse[(1, j)] + w3 * self.inverse[(2, j)];
        let turning = Turning { axes: [axis(0), axis(1), axis(2)], omega, alpha };
        turning.body(&root.beside(&turning, w1 * self.wheel[0] + w2 * self.wheel[1] + w3 * self.wheel[2]))
    }

    /// A turn about x and one about z lead to the rod's axis u = (−sin ψ, cos ψ cos φ, cos ψ sin φ).
    #[inline(always)]
    fn tie_rod(&self, inner: &Point, outer: &Point) -> SpatialBody<f64> {
        let per = 1.0 / self.rod;
        let (u, u1, u2) = ((outer.p - inner.p) * per, (outer.v - inner.v) * per, (outer.a - inner.a) * per);
        let n = (u.y * u.y + u.z * u.z).sqrt();
        let per = 1.0 / n;
        let (s, c) = (u.z * per, u.y * per);
        let lift = (c * u1.z - s * u1.y) * per;
        let swing = -u1.x * per;
        let turning = (-u2.x - u.x * swing * swing) * per;
        let lifting = (c * u2.z - s * u2.y - 2.0 * lift * u.x * swing) * per;
        let of = Turning {
            axes: [Vector3::new(n, -u.x * c, -u.x * s), u, Vector3::new(0.0, -s, c)],
            omega: Vector3::new(lift, -s * swing, c * swing),
            alpha: Vector3::new(lifting, -s * turning - lift * c * swing, c * turning - lift * s * swing),
        };
        let center = Point { p: inner.p + u * ALONG, v: inner.v + u1 * ALONG, a: inner.a + u2 * ALONG };
        of.body(&center)
    }
}

/// Value, rate and acceleration.
#[inline(always)]
fn harmonic<F: Trigonometry>([offset, amplitude, omega, phase]: [f64; 4], t: f64) -> [f64; 3] {
    let (sine, cosine) = F::of(omega * t + phase);
    [offset + amplitude * sine, amplitude * omega * cosine, -amplitude * omega * omega * sine]
}

/// Sine and cosine of an angle that has changed by little.
#[inline(always)]
fn turned((sine, cosine): (f64, f64), change: f64) -> (f64, f64) {
    let (by, less) = (change * (1.0 - change * change / 6.0), 0.5 * change * change);
    (sine + cosine * by - sine * less, cosine - sine * by - cosine * less)
}
