//! States are bit-identical however this is compiled: at every level of optimisation, with and without AVX2 and FMA, alone and in lanes.
//! `.ci/run` runs this test in several ways.
//!
//! The hashes come from our own output and prove nothing; the equations of the mechanism, tested beside each hash, prove that the numbers
//! are right. A changed hash means that some bit of some state has changed; a commit that changes it gives the reason.
//! `REULEAUX_BITS=print` prints the new hashes.

use reuleaux::{Equations, Float, Real, Scalar, State, mechanism};
use reuleaux_wide::{F32x8, F64x4, Lockstep, Wide};

mechanism! {
    /// Two unknowns, solved in closed form.
    mechanism CrankRocker {
        param crank_length: Length = 100mm;
        ground { point O = (0mm, 0mm); point C = (400mm, 0mm); }
        body crank { point O = (0mm, 0mm); point A = (crank_length, 0mm); }
        body coupler { point A = (0mm, 0mm); point B = (350mm, 0mm); }
        body rocker { point C = (0mm, 0mm); point B = (300mm, 0mm); start angle = 70deg; }
        joint o = revolute(ground.O, crank.O);
        joint a = revolute(crank.A, coupler.A);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.C, ground.C);
        drive input = drive_angle(crank, 60rpm * t);
    }
}

mechanism! {
    /// Four unknowns, by elimination in a fixed order.
    mechanism Platform {
        ground { point O = (-0.5m, -1.5m); point D = (1.2m, -1.1m); point E = (1.5m, -1.3m); }
        body crank { point O = (0m, 0m); point S = (100mm, 0m); }
        body plate { point A = (0m, 0m); point B = (1m, 0m); point C = (0.5m, 0.3m); start position = (0m, 0m); start angle = 0.1rad; }
        body near { point G = (0m, 0m); point P = (1.3m, 0m); }
        body middle { point G = (0m, 0m); point P = (1.5m, 0m); }
        body far { point G = (0m, 0m); point P = (1.5m, 0m); }
        joint o = revolute(ground.O, crank.O);
        joint s = revolute(crank.S, near.G);
        joint d = revolute(ground.D, middle.G);
        joint e = revolute(ground.E, far.G);
        joint a = revolute(near.P, plate.A);
        joint c = revolute(middle.P, plate.C);
        joint b = revolute(far.P, plate.B);
        drive motor = drive_angle(crank, 6rad_s * t);
    }
}

mechanism! {
    /// Every function of the language, with one wheel for each.
    mechanism Functions {
        let s = t / 1s;
        body a { point O = (0m, 0m); }
        body b { point O = (0m, 0m); }
        body c { point O = (0m, 0m); }
        body d { point O = (0m, 0m); }
        joint at_a = revolute(a.O, ground.position);
        joint at_b = revolute(b.O, ground.position);
        joint at_c = revolute(c.O, ground.position);
        joint at_d = revolute(d.O, ground.position);
        drive by_a = drive_angle(a, sin(3 * s) + cos(s)^2 + tan(s / 4));
        drive by_b = drive_angle(b, asin(s / 4) + acos(s / 3) + atan(5 * s) + atan2(s, 1 + s));
        drive by_c = drive_angle(c, exp(-s) + ln(1 + s) + sqrt(2 + s) + abs(s - 3));
        drive by_d = drive_angle(d, table(t, [(0s, 0deg), (0.5s, 90deg), (1s, 180deg), (2s, 300deg)], linear));
    }
}

/// Number of steps of a sweep over one second.
const STEPS: u32 = 200;

fn times<T: Real>() -> impl Iterator<Item = T> {
    (0..=STEPS).map(|step| T::of(f64::from(step) / f64::from(STEPS)))
}

/// Hash of Fowler, Noll and Vo over the bits of q, q̇ and q̈.
struct Hash(u64);

impl Hash {
    fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    fn add<T: Float, const N: usize>(&mut self, state: &State<T, N>) {
        for number in state.q.iter().chain(&state.qd).chain(&state.qdd) {
            for byte in number.bits().to_le_bytes() {
                self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
            }
        }
    }

    /// Compares the hash with the recorded one.
    fn must_be(&self, name: &str, known: u64) {
        if std::env::var_os("REULEAUX_BITS").is_some() {
            println!("{name}: {:#018x}", self.0);
        } else {
            assert_eq!(self.0, known, "{name}: other bits; {:#018x} now", self.0);
        }
    }
}

/// Asserts that all equations of position, velocity and acceleration hold, and that angles have their closed-form values.
fn is_right<T: Float, E: Equations<T, N, N>, const N: usize>(equations: &E, state: &State<T, N>, angles: &[(usize, f64)], bound: f64) {
    let (phi, jacobian) = equations.linearize(&state.q, state.t);
    let rest = |lhs: T, rhs: T| (lhs - rhs).to_f64().abs();
    let (nu, gamma) = (equations.nu(&state.q, state.t), equations.gamma(&state.q, &state.qd, state.t));
    for i in 0..N {
        let row = |rates: &reuleaux::nalgebra::SVector<T, N>| (0..N).fold(T::of(0.0), |sum, j| sum + jacobian[(i, j)] * rates[j]);
        assert!(phi[i].to_f64().abs() <= bound, "{i} of Φ: {:?}", phi[i]);
        assert!(rest(row(&state.qd), nu[i]) <= 30.0 * bound, "{i} of the velocities at {:?}", state.t);
        assert!(rest(row(&state.qdd), gamma[i]) <= 1000.0 * bound, "{i} of the accelerations at {:?}", state.t);
    }
    for &(index, angle) in angles {
        assert!((state.q[index].to_f64() - angle).abs() <= 100.0 * bound, "{index} at {:?}: {:?} for {angle}", state.t, state.q[index]);
    }
}

/// Angle of the rocker from the triangle of its pivot, the crank pin and the rocker pin.
fn rocker(t: f64, crank: f64) -> f64 {
    let turn = std::f64::consts::TAU * t;
    let (x, y) = (crank * turn.cos() - 0.4, crank * turn.sin());
    let square = x * x + y * y;
    y.atan2(x).rem_euclid(std::f64::consts::TAU) - ((square + 0.09 - 0.1225) / (0.6 * square.sqrt())).acos()
}

fn functions(t: f64) -> [(usize, f64); 3] {
    [
        (2, (3.0 * t).sin() + t.cos().powi(2) + (t / 4.0).tan()),
        (5, (t / 4.0).asin() + (t / 3.0).acos() + (5.0 * t).atan() + t.atan2(1.0 + t)),
        (8, (-t).exp() + t.ln_1p() + (2.0 + t).sqrt() + (t - 3.0).abs()),
    ]
}

macro_rules! alone {
    ($name:literal, $mechanism:expr, $number:ty, $bound:literal, $angles:expr, $hash:literal) => {{
        let (mechanism, mut hash) = ($mechanism, Hash::new());
        for state in mechanism.sweep(times::<$number>()) {
            let state = state.expect("a state");
            is_right(&mechanism, &state.0, &($angles)(state.t.to_f64()), $bound);
            hash.add(&state.0);
        }
        hash.must_be($name, $hash);
    }};
}

#[test]
fn double_precision_has_the_same_bits() {
    let angle = |t| [(8, rocker(t, 0.1))];
    alone!("crank-rocker", CrankRocker::<f64>::with_defaults(), f64, 1e-14, angle, 0x4acd_2d9a_3efa_045d);
    alone!("platform", Platform::<f64>::with_defaults(), f64, 1e-14, |_| [], 0x56e6_53bb_82a8_1e2b);
    alone!("functions", Functions::<f64>::with_defaults(), f64, 1e-14, functions, 0xbd6d_17e6_fe39_4e60);
}

#[test]
fn single_precision_has_the_same_bits() {
    let angle = |t| [(8, rocker(t, 0.1))];
    alone!("crank-rocker in f32", CrankRocker::<f32>::with_defaults(), f32, 3e-6, angle, 0xfcc4_8210_f6a5_5a65);
    alone!("platform in f32", Platform::<f32>::with_defaults(), f32, 3e-6, |_| [], 0x0f39_f7ca_3670_96b2);
    alone!("functions in f32", Functions::<f32>::with_defaults(), f32, 3e-6, functions, 0x7cd6_adf4_e00b_fa0f);
}

/// Crank-rockers with cranks of several lengths, side by side.
fn in_lanes<W: Wide<L>, const L: usize>(bound: f64) -> Hash
where
    W::Lane: Float,
    CrankRocker<W::Lane>: Equations<W::Lane, 9, 9> + reuleaux::Stages<W::Lane, 9> + reuleaux::Family<W::Lane, Over<W> = CrankRocker<W>>,
    CrankRocker<W>: reuleaux::Stages<W, 9>,
{
    let mut hash = Hash::new();
    let lengths: [f64; L] = core::array::from_fn(|lane| 0.06 + 0.01 * lane as f64);
    let cranks = lengths.map(|length| CrankRocker { crank_length: W::Lane::of(length) });
    let mut all = Lockstep::<CrankRocker<W::Lane>, W, L, 9>::new(cranks, [W::Lane::of(0.0); L]);
    for t in times::<W::Lane>() {
        all.advance([t; L]);
        for (lane, crank) in cranks.iter().enumerate() {
            let state = all.lane(lane).expect("a state");
            is_right(crank, &state, &[(8, rocker(t.to_f64(), crank.crank_length.to_f64()))], bound);
            hash.add(&state);
        }
    }
    hash
}

#[test]
fn lanes_have_the_same_bits() {
    in_lanes::<F64x4, 4>(1e-14).must_be("crank-rockers in f64x4", 0x652f_eac9_046c_edcc);
    in_lanes::<F32x8, 8>(3e-6).must_be("crank-rockers in f32x8", 0xca83_6384_0661_d02b);
}
