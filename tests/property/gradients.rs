//! Derivatives by parameters, compared with hyper-dual numbers: all equations at once, dense, independent of blocks.

use std::cell::Cell;

use reuleaux::nalgebra::{DMatrix, DVector, SMatrix, SVector};
use reuleaux::{Equations, Family, Gradient, Mechanism, Stages, State, mechanism};
use reuleaux_tests::mechanisms::*;
use reuleaux_tests::stress::SmallAndLarge;

use crate::dual::Hyper;

/// Allowed error relative to the largest derivative of its kind, for a condition number of 1.
const ALLOWED: f64 = 1e-14;

/// ∂q/∂p, ∂q̇/∂p and ∂q̈/∂p from the differentiated equations.
fn reference<E, const N: usize>(mechanism: &E, state: &State<f64, N>) -> [SVector<f64, N>; 3]
where
    E: Equations<Hyper, N, N>,
{
    let along = |vector: &SVector<Hyper, N>| vector.map(|entry| entry.0.eps1);
    let with = |vector: &SVector<f64, N>, by: &SVector<f64, N>| vector.zip_map(by, |x, by| Hyper::new(x, by, 0.0));
    let times = |jacobian: &SMatrix<Hyper, N, N>, x: &SVector<f64, N>| {
        SVector::<f64, N>::from_fn(|i, _| (0..N).map(|j| jacobian[(i, j)].0.eps1 * x[j]).sum())
    };
    let (still, t) = (state.q.map(|x| Hyper::new(x, 0.0, 0.0)), Hyper::new(state.t, 0.0, 0.0));
    let (phi, jacobian) = mechanism.linearize(&still, t);
    let factors = DMatrix::from_fn(N, N, |i, j| jacobian[(i, j)].0.re).full_piv_lu();
    let solve = |b: SVector<f64, N>| {
        let x = factors.solve(&DVector::from_column_slice(b.as_slice())).expect("a regular Jacobian");
        SVector::<f64, N>::from_column_slice(x.as_slice())
    };
    let q = solve(-along(&phi));
    let there = with(&state.q, &q);
    let (_, jacobian) = mechanism.linearize(&there, t);
    let qd = solve(along(&mechanism.nu(&there, t)) - times(&jacobian, &state.qd));
    let gamma = mechanism.gamma(&there, &with(&state.qd, &qd), t);
    [q, qd, solve(along(&gamma) - times(&jacobian, &state.qdd))]
}

/// A mechanism over any number type, with one parameter varied.
fn varied<M: Family<f64>, T: reuleaux::Real>(mechanism: &M, of: impl Fn(f64, bool) -> T, which: usize) -> (M::Over<T>, usize) {
    let count = Cell::new(0);
    let varied = M::gather([mechanism], |[parameter]| {
        let index = count.replace(count.get() + 1);
        of(parameter, index == which)
    });
    (varied, count.get())
}

/// Compares the derivatives by each parameter along a motion.
fn check<M, const N: usize>(mechanism: &M, end: f64)
where
    M: Family<f64> + Mechanism<f64, N>,
    M::Over<Gradient<f64, 1>>: Stages<Gradient<f64, 1>, N>,
    M::Over<Hyper>: Equations<Hyper, N, N>,
{
    let parameters = varied(mechanism, |_, _| 0.0, 0).1;
    assert!(parameters > 0);
    let mut greatest = 0.0_f64;
    for state in mechanism.sweep((1..=12).map(|step| end * f64::from(step) / 12.0)) {
        let state = state.unwrap_or_else(|failure| panic!("{failure}"));
        for which in 0..parameters {
            let gradient = |value, varies| Gradient { value, by: [if varies { 1.0 } else { 0.0 }] };
            let found = mechanism.derivatives_along(&state, &varied(mechanism, gradient, which).0).expect("a state");
            let hyper = |value, varies| Hyper::new(value, if varies { 1.0 } else { 0.0 }, 0.0);
            let right = reference(&varied(mechanism, hyper, which).0, &state);
            for (found, right) in [&found.q, &found.qd, &found.qdd].into_iter().zip(right) {
                let (off, size) = ((found.map(|entry| entry.by[0]) - right).amax(), right.amax());
                let allowed = ALLOWED * state.condition * size;
                assert!(off <= allowed, "{} by parameter {which} at {}: off by {off:e} of {size:e}", M::NAME, state.t);
                if size > 0.0 {
                    greatest = greatest.max(off / size);
                }
            }
        }
    }
    println!("{}: {parameters} parameters, off by {greatest:.1e} at most", M::NAME);
}

mechanism! {
    /// A cam given by a table turns a rocker, which moves a slide through a rod.
    mechanism Cam {
        param base: Length = 40mm;
        param arm: Length = 60mm;
        param rod_length: Length = 120mm;
        param speed: AngularVelocity = 60rpm;
        ground { axis rail = (1, 0); }
        function lift(a: Angle) -> Angle = table(a, [(0deg, 10deg), (90deg, 20deg), (180deg, 35deg), (270deg, 15deg), (360deg, 10deg)]);
        body rocker { point A = (0mm, arm); }
        body rod    { point B = (rod_length, base / 10); start angle = -10deg; }
        body slide  { start x = 120mm; }
        joint o = revolute(ground.position, rocker.position);
        joint a = revolute(rocker.A, rod.position);
        joint b = revolute(rod.B, slide.position);
        joint guide = translational(ground.rail, ground.position, slide.position);
        drive turn = drive_angle(rocker, lift(speed * t));
        output place = slide.position.x;
        output mean = (rod.B + rocker.A) / 2;
    }
}

#[test]
fn derivatives_by_every_parameter_are_those_of_all_equations_at_once() {
    check(&FourBarCrankRocker::default(), 1.0);
    check(&SliderCrank::default(), 0.3);
    check(&QuickReturn::default(), 1.0);
    check(&TheoJansenLeg::default(), 1.0);
    check(&HydraulicLoader::default(), 1.0);
    check(&TwoStageGearTrain::default(), 1.0);
    check(&SmallAndLarge::default(), 0.3);
}

/// Derivatives of outputs, including their direct dependence on parameters, compared with fourth-order differences.
#[test]
fn derivatives_of_outputs_are_their_differences() {
    let cam = Cam::default();
    let state = cam.solve(0.3).expect("it moves");
    let (varied, there) =
        cam.derivatives(&state, |cam| [&mut cam.base, &mut cam.arm, &mut cam.rod_length, &mut cam.speed]).expect("a state");
    let there = CamState(there);
    let (place, mean) = (varied.place(&there), varied.mean(&there));
    let found = [place.value, place.rate, place.acceleration, mean.value.x, mean.rate.y, mean.acceleration.y];
    let at = |which: usize, change: f64| {
        let mut cam = cam;
        let parameter = [&mut cam.base, &mut cam.arm, &mut cam.rod_length, &mut cam.speed].into_iter().nth(which).expect("one of four");
        *parameter *= 1.0 + change;
        let state = cam.solve(0.3).expect("it moves");
        let (place, mean) = (cam.place(&state), cam.mean(&state));
        [place.value, place.rate, place.acceleration, mean.value.x, mean.rate.y, mean.acceleration.y]
    };
    let sizes = [cam.base, cam.arm, cam.rod_length, cam.speed];
    for (which, size) in sizes.into_iter().enumerate() {
        let h = 1e-4;
        let [a, b, c, d] = [2.0 * h, h, -h, -2.0 * h].map(|change| at(which, change));
        for (i, found) in found.iter().enumerate() {
            let difference = (8.0 * (b[i] - c[i]) - (a[i] - d[i])) / (12.0 * h * size);
            assert!((found.by[which] - difference).abs() <= 1e-9 * (1.0 + difference.abs()), "{which}, {i}: {found:?}, {difference}");
        }
    }
}

/// Neither an unsolved state nor a dead point has derivatives.
#[test]
fn a_state_of_others_is_refused() {
    let cam = Cam::default();
    let mut state = cam.solve(0.3).expect("it moves");
    state.0.q[5] += 0.3;
    let refused = cam.derivatives(&state, |cam| [&mut cam.arm]).expect_err("no state");
    assert!(refused.to_string().contains("Cam"), "{refused}");
}
