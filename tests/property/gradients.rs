//! Derivatives by parameters, compared with hyper-dual numbers: all equations at once, dense, independent of blocks.

use std::cell::Cell;

use reuleaux::nalgebra::{DMatrix, DVector, SMatrix, SVector, Vector2};
use reuleaux::{Equations, Family, Gradient, Mechanism, Motion, Stages, State, mechanism};
use reuleaux_tests::mechanisms::*;
use reuleaux_tests::stress::SmallAndLarge;

use crate::dual::Hyper;

/// Allowed error relative to the largest derivative of its kind, for a condition number of 1.
const ALLOWED: f64 = 1e-14;

/// Allowed error of an output's value, rate or acceleration, relative to its largest component.
const ALLOWED_OF_OUTPUTS: f64 = 1e-11;

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

/// A mechanism over any number type, with some parameters varied, and the number of its parameters.
fn varied<M: Family<f64>, T: reuleaux::Real>(
    mechanism: &M,
    of: impl Fn(f64, bool) -> T,
    varies: impl Fn(usize) -> bool,
) -> (M::Over<T>, usize) {
    let count = Cell::new(0);
    let varied = M::gather([mechanism], |[parameter]| of(parameter, varies(count.replace(count.get() + 1))));
    (varied, count.get())
}

/// Number of parameters differentiated at once: more than a pair, and odd.
const ABREAST: usize = 3;

/// Compares the derivatives by each parameter along a motion.
///
/// * `found_outputs`, `right_outputs`: given, the outputs over either type of numbers, by component.
fn check<M, const N: usize>(
    mechanism: &M,
    end: f64,
    found_outputs: impl Fn(&M::Over<Gradient<f64, ABREAST>>, &State<Gradient<f64, ABREAST>, N>) -> Vec<Vec<[Gradient<f64, ABREAST>; 3]>>,
    right_outputs: impl Fn(&M::Over<Hyper>, &State<Hyper, N>) -> Vec<Vec<[Hyper; 3]>>,
) where
    M: Family<f64> + Mechanism<f64, N>,
    M::Over<Gradient<f64, ABREAST>>: Stages<Gradient<f64, ABREAST>, N>,
    M::Over<Hyper>: Equations<Hyper, N, N>,
{
    let parameters = varied(mechanism, |_, _| 0.0, |_| false).1;
    assert!(parameters > 0);
    let (mut greatest, mut greatest_of_outputs) = (0.0_f64, 0.0_f64);
    let mut reused = None;
    for state in mechanism.sweep((1..=12).map(|step| end * f64::from(step) / 12.0)) {
        let state = state.unwrap_or_else(|failure| panic!("{failure}"));
        for first in (0..parameters).step_by(ABREAST) {
            let count = Cell::new(0);
            let gradient = |value, _| {
                let index = count.replace(count.get() + 1);
                Gradient { value, by: core::array::from_fn(|lane| if index == first + lane { 1.0 } else { 0.0 }) }
            };
            let varied_found = varied(mechanism, gradient, |_| true).0;
            let found = mechanism.derivatives_along(&state, &varied_found).expect("a state");
            let there = reused.get_or_insert_with(|| found.clone());
            mechanism.update_derivatives(&state, &varied_found, there).expect("a state");
            assert!(*there == found, "{}: in place, at {}", M::NAME, state.t);
            let outputs = found_outputs(&varied_found, &found);
            for lane in 0..ABREAST.min(parameters - first) {
                let which = first + lane;
                let hyper = |value, varies| Hyper::new(value, if varies { 1.0 } else { 0.0 }, 0.0);
                let varied = varied(mechanism, hyper, |index| index == which).0;
                let right = reference(&varied, &state);
                for (found, right) in [&found.q, &found.qd, &found.qdd].into_iter().zip(&right) {
                    let (off, size) = ((found.map(|entry| entry.by[lane]) - right).amax(), right.amax());
                    let allowed = ALLOWED * state.condition * size;
                    assert!(off <= allowed, "{} by parameter {which} at {}: off by {off:e} of {size:e}", M::NAME, state.t);
                    if size > 0.0 {
                        greatest = greatest.max(off / size);
                    }
                }
                let with = |vector: &SVector<f64, N>, by: &SVector<f64, N>| vector.zip_map(by, |x, by| Hyper::new(x, by, 0.0));
                let [q, qd, qdd] = &right;
                let there = State::new(Hyper::new(state.t, 0.0, 0.0), with(&state.q, q), with(&state.qd, qd), with(&state.qdd, qdd));
                let rights = right_outputs(&varied, &there);
                assert_eq!(outputs.len(), rights.len());
                for (index, (outputs, rights)) in outputs.iter().zip(&rights).enumerate() {
                    for (part, name) in ["value", "rate", "acceleration"].into_iter().enumerate() {
                        let off = outputs.iter().zip(rights).map(|(found, right)| (found[part].by[lane] - right[part].0.eps1).abs());
                        let sizes = rights.iter().map(|right| right[part].0.eps1.abs());
                        let (off, size) = (off.fold(0.0, f64::max), sizes.fold(0.0, f64::max));
                        let of = format!("{} of output {index} of {} by {which} at {}", name, M::NAME, state.t);
                        // If the derivative is zero, rounding errors of the coordinates remain.
                        let rounding = ALLOWED * state.condition * right[part].amax();
                        assert!(off <= ALLOWED_OF_OUTPUTS * size + rounding, "{of}: off by {off:e} of {size:e}");
                        if size > rounding {
                            greatest_of_outputs = greatest_of_outputs.max(off / size);
                        }
                    }
                }
            }
        }
    }
    println!("{}: {parameters} parameters, off by {greatest:.1e}, outputs by {greatest_of_outputs:.1e} at most", M::NAME);
}

/// The components of an output, each with its rate and acceleration.
trait Components<T> {
    fn components(&self) -> Vec<[T; 3]>;
}

impl<T: Copy> Components<T> for Motion<T> {
    fn components(&self) -> Vec<[T; 3]> {
        vec![[self.value, self.rate, self.acceleration]]
    }
}

impl<T: Copy> Components<T> for Motion<Vector2<T>> {
    fn components(&self) -> Vec<[T; 3]> {
        (0..2).map(|k| [self.value[k], self.rate[k], self.acceleration[k]]).collect()
    }
}

/// Checks a mechanism with outputs, which are functions over any number type.
macro_rules! check {
    ($mechanism:ident, $state:ident, $end:literal, [$($output:ident),*]) => {
        check(
            &$mechanism::default(),
            $end,
            |m, state| vec![$(m.$output(&$state(state.clone())).components()),*],
            |m, state| vec![$(m.$output(&$state(state.clone())).components()),*],
        );
    };
}

mechanism! {
    /// A six-bar driven at its far link, whose four angles are found together, by elimination in a fixed order.
    mechanism SixBar {
        param crank_length: Length = 1m;
        param link_length: Length = 3.5m;
        param left_length: Length = 2.5m;
        param coupler_length: Length = 4.5m;
        param right_length: Length = 2.75m;
        ground { point B0 = (4m, 0m); point D0 = (4m, 5.5m); }
        body crank { point D = (crank_length, 0m); }
        body link { point C = (link_length, 0m); start position = (5m, 5.5m); start angle = -164.8deg; }
        body left { point A = (left_length, 0m); start angle = 101.3deg; }
        body coupler { point B = (coupler_length, 0m); point C = (coupler_length / 2, 2m); start angle = 3.8deg; }
        body right { point B = (right_length, 0m); start angle = 90deg; }
        joint d0 = revolute(ground.D0, crank.position);
        joint d = revolute(crank.D, link.position);
        joint c = revolute(link.C, coupler.C);
        joint a0 = revolute(ground.position, left.position);
        joint a = revolute(left.A, coupler.position);
        joint b = revolute(coupler.B, right.B);
        joint b0 = revolute(ground.B0, right.position);
        drive input = drive_angle(crank, 1turn * t / 1s);
        output pin = coupler.C;
        output lean = right.angle;
    }
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
    check!(FourBarCrankRocker, FourBarCrankRockerState, 1.0, [interest, transmission]);
    check!(SliderCrank, SliderCrankState, 0.3, [interest, stroke]);
    check!(QuickReturn, QuickReturnState, 1.0, [interest, cut]);
    check!(TheoJansenLeg, TheoJansenLegState, 1.0, [interest, height]);
    check!(HydraulicLoader, HydraulicLoaderState, 1.0, [interest, edge, reach]);
    check!(TwoStageGearTrain, TwoStageGearTrainState, 1.0, [interest, ratio]);
    check!(GearTrainOfPairs, GearTrainOfPairsState, 1.0, [interest]);
    check!(SixBar, SixBarState, 0.9, [pin, lean]);
    check(&SmallAndLarge::default(), 0.3, |_, _| Vec::new(), |_, _| Vec::new());
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

/// Unsolved states and dead points have no derivatives.
#[test]
fn a_state_of_others_is_refused() {
    let cam = Cam::default();
    let mut state = cam.solve(0.3).expect("it moves");
    state.0.q[5] += 0.3;
    let refused = cam.derivatives(&state, |cam| [&mut cam.arm]).expect_err("no state");
    assert!(refused.to_string().contains("Cam"), "{refused}");
}
