//! Messages of failures.

mod common;

use common::four_bar::{CRANK_ROCKER, Driven, FourBar};
use reuleaux::nalgebra::{SMatrix, SVector};
use reuleaux::{
    Cause, Coordinate, Coordinates, Culprit, Description, Equations, Mechanism, ParameterOutOfRange, Row, Solver, Stages, StepError,
};

/// The crank-rocker driven at the rocker, which swings outwards into its dead point.
const ROCKER_DRIVEN: FourBar = FourBar { driven: Driven::Rocker, from: 2.1, speed: -1.0, start: [-0.5, 1.0, 2.1], ..CRANK_ROCKER };

#[test]
fn dead_point_is_reported_not_divided_by() {
    for steps in [1, 3, 100, 10_000] {
        let results: Vec<_> = ROCKER_DRIVEN.sweep((0..=steps).map(|k| 2.0 * f64::from(k) / f64::from(steps))).collect();
        let failure = results.last().unwrap().as_ref().unwrap_err();
        println!("{failure}");
        let Cause::Singular { row, coordinate, condition } = failure.cause else { panic!("{failure}") };
        assert!(["a", "input"].contains(&row.joint), "{failure}");
        assert_eq!((coordinate.body, coordinate.name), ("crank", "angle"));
        assert!(condition > 1e6, "{condition:e}");

        // At the dead point crank and coupler are in line: cosine rule for the rocker's angle.
        let reach: f64 = CRANK_ROCKER.crank + CRANK_ROCKER.coupler;
        let FourBar { ground, rocker, .. } = CRANK_ROCKER;
        let cosine = (reach.powi(2) - ground.powi(2) - rocker.powi(2)) / (2.0 * ground * rocker);
        let dead = ROCKER_DRIVEN.from - cosine.acos();
        // Close to the dead point, where the relative error of a rate would reach a quarter.
        assert!((failure.time - dead).abs() <= 1e-14 && failure.time >= dead - 4e-15, "{} {dead}", failure.time);
        let last = failure.last.as_ref().unwrap();
        assert!((last.t - dead).abs() <= 1e-14);
        assert!(last.q.iter().chain(&last.qd).chain(&last.qdd).all(|x| x.is_finite()));
        assert!(results[..results.len() - 1].iter().all(Result::is_ok));
    }
}

#[test]
fn impossible_lengths_do_not_close() {
    let long = FourBar { ground: 2.0, ..CRANK_ROCKER };
    let failure = long.solve(0.0).unwrap_err();
    let Cause::DoesNotClose { row, gap, .. } = failure.cause else { panic!("{failure}") };
    assert_eq!(row.unit, "m");
    assert!((0.01..2.0).contains(&gap));
    assert_eq!(failure.last, None);
    let sentence = failure.to_string();
    println!("{sentence}");
    assert!(sentence.starts_with("`FourBar` was not assembled at t = 0 s: where the search ended, joint `"), "{sentence}");
    assert!(!sentence.ends_with('.'));
}

#[test]
fn a_linkage_that_opens_on_the_way_ends_at_its_dead_point() {
    // Not a Grashof linkage: the crank cannot make a full turn.
    let rocking = FourBar { crank: 0.3, coupler: 0.3, rocker: 0.25, ground: 0.5, start: [0.3, 1.0, 2.0], ..CRANK_ROCKER };
    let failure = rocking.solve(1.0).unwrap_err();
    println!("{failure}");
    assert!(matches!(failure.cause, Cause::Singular { .. }), "{failure}");
    assert!(failure.time > 0.0 && failure.time < 1.0 && failure.last.is_some());
}

#[test]
fn not_a_number_is_named() {
    let broken = FourBar { rocker: f64::NAN, ..CRANK_ROCKER };
    let failure = broken.solve(0.0).unwrap_err();
    println!("{failure}");
    let Cause::NotFinite { of: Culprit::Row(row) } = failure.cause else { panic!("{failure}") };
    assert_eq!((row.joint, row.index), ("b", 1));

    for value in [f64::NAN, f64::INFINITY, f64::MAX, f64::MIN_POSITIVE, -0.0, 1e200, 1e-300] {
        for broken in [
            FourBar { ground: value, ..CRANK_ROCKER },
            FourBar { crank: value, ..CRANK_ROCKER },
            FourBar { coupler: value, ..CRANK_ROCKER },
            FourBar { from: value, ..CRANK_ROCKER },
            FourBar { speed: value, ..CRANK_ROCKER },
            FourBar { start: [value; 3], ..CRANK_ROCKER },
        ] {
            let _ = broken.solve(0.5).map_err(|failure| failure.to_string());
        }
        let time = if value.abs() > 1.0 && value.is_finite() { f64::NAN } else { value };
        assert_eq!(CRANK_ROCKER.solve(time).is_ok(), time.is_finite());
    }
    assert_eq!(CRANK_ROCKER.solve(f64::INFINITY).unwrap_err().cause, Cause::NotFinite { of: Culprit::Time });
}

#[test]
fn parameters_are_checked_first() {
    let failure = FourBar { coupler: 0.0, ..CRANK_ROCKER }.solve(0.0).unwrap_err();
    assert_eq!(failure.to_string(), "`FourBar` cannot be solved with `coupler` = 0 m: it must not be zero");
}

#[test]
fn a_sweep_ends_after_a_failure() {
    let mut sweep = CRANK_ROCKER.sweep([0.0, f64::NAN, 0.1]);
    assert!(sweep.next().unwrap().is_ok());
    assert!(sweep.next().unwrap().is_err());
    assert!(sweep.next().is_none() && sweep.next().is_none());
}

/// A slider driven by x = f(t) or, with `TURNS`, a wheel driven by φ = f(t); ν is the given constant, and γ is zero.
struct Slider<const TURNS: bool = false>(fn(f64) -> f64, f64);

impl<const TURNS: bool> Stages<f64, 1> for Slider<TURNS> {
    fn stages(&self, t: f64, pass: &mut Solver<'_, f64, 1>) -> Result<Coordinates<f64, 1>, StepError<f64>> {
        reuleaux::at_once(self, t, pass)
    }

    fn refined_guess(&self, t: f64, guess: &SVector<f64, 1>) -> SVector<f64, 1> {
        reuleaux::refined_guess_at_once(self, t, guess)
    }
}

impl<const TURNS: bool> Description<f64, 1> for Slider<TURNS> {
    const NAME: &'static str = "Slider";
    const COORDINATES: &'static [Coordinate] = &[if TURNS { Coordinate::angle("slider", "x") } else { Coordinate::length("slider", "x") }];
    const ROWS: &'static [Row] = &[Row { joint: "rail", kind: "drive_x", index: 1, of: 1, unit: "m" }];

    fn start(&self) -> SVector<f64, 1> {
        SVector::from([0.0])
    }
    fn characteristic_length(&self) -> f64 {
        1.0
    }
    fn validate(&self) -> Result<(), ParameterOutOfRange<f64>> {
        Ok(())
    }
}

impl<const TURNS: bool> Equations<f64, 1, 1> for Slider<TURNS> {
    fn phi(&self, q: &SVector<f64, 1>, t: f64) -> SVector<f64, 1> {
        SVector::from([q[0] - (self.0)(t)])
    }
    fn jacobian(&self, _: &SVector<f64, 1>, _: f64) -> SMatrix<f64, 1, 1> {
        SMatrix::from([[1.0]])
    }
    fn linearize(&self, q: &SVector<f64, 1>, t: f64) -> (SVector<f64, 1>, SMatrix<f64, 1, 1>) {
        (self.phi(q, t), self.jacobian(q, t))
    }
    fn nu(&self, _: &SVector<f64, 1>, _: f64) -> SVector<f64, 1> {
        SVector::from([self.1])
    }
    fn gamma(&self, _: &SVector<f64, 1>, _: &SVector<f64, 1>, _: f64) -> SVector<f64, 1> {
        SVector::from([0.0])
    }
}

#[test]
fn a_jump_is_not_jumped() {
    let failure = Slider::<false>(|t| if t < 0.3 { 0.0 } else { 7.0 }, 0.0).solve(1.0).unwrap_err();
    println!("{failure}");
    let Cause::BranchLost { coordinate, jump } = failure.cause else { panic!("{failure}") };
    assert_eq!((coordinate.body, jump), ("slider", 7.0));
    assert!((failure.time - 0.3).abs() < 1e-14);
}

#[test]
fn the_end_of_a_law_is_named() {
    let failure = Slider::<false>(|t| (0.25 - t * t).sqrt(), 0.0).solve(1.0).unwrap_err();
    println!("{failure}");
    assert!(matches!(failure.cause, Cause::NotFinite { of: Culprit::Row(_) }));
    assert!((failure.time - 0.5).abs() < 1e-14);
}

#[test]
fn a_long_way_is_followed() {
    let state = Slider::<true>(|t| 1e3 * t, 1e3).solve(1.0).unwrap();
    assert!((state.q[0] - 1e3).abs() <= 1e3 * f64::EPSILON, "{state:?}");
}

/// Only where all samples are taken, as in `.ci/run`: a million steps take ten seconds without optimisation.
#[test]
fn a_way_that_is_too_long_is_given_up() {
    if std::env::var_os("REULEAUX_SAMPLES").is_none() {
        return;
    }
    let failure = Slider::<true>(|t| 1e9 * t, 1e9).solve(1.0).unwrap_err();
    println!("{failure}");
    assert!(matches!(failure.cause, Cause::TooManySteps { .. }));
    assert!(failure.last.unwrap().t > 1e-6);
}

/// The same equation twice.
struct Redundant;

impl Stages<f64, 2> for Redundant {
    fn stages(&self, t: f64, pass: &mut Solver<'_, f64, 2>) -> Result<Coordinates<f64, 2>, StepError<f64>> {
        reuleaux::at_once(self, t, pass)
    }

    fn refined_guess(&self, t: f64, guess: &SVector<f64, 2>) -> SVector<f64, 2> {
        reuleaux::refined_guess_at_once(self, t, guess)
    }
}

impl Description<f64, 2> for Redundant {
    const NAME: &'static str = "Redundant";
    const COORDINATES: &'static [Coordinate] = &[];
    const ROWS: &'static [Row] = &[];

    fn start(&self) -> SVector<f64, 2> {
        SVector::from([1.0, 0.0])
    }
    fn characteristic_length(&self) -> f64 {
        f64::NAN
    }
    fn validate(&self) -> Result<(), ParameterOutOfRange<f64>> {
        Ok(())
    }
}

impl Equations<f64, 2, 2> for Redundant {
    fn phi(&self, q: &SVector<f64, 2>, _: f64) -> SVector<f64, 2> {
        SVector::from([q[0] - q[1], q[1] - q[0]])
    }
    fn jacobian(&self, _: &SVector<f64, 2>, _: f64) -> SMatrix<f64, 2, 2> {
        SMatrix::from_row_slice(&[1.0, -1.0, -1.0, 1.0])
    }
    fn linearize(&self, q: &SVector<f64, 2>, t: f64) -> (SVector<f64, 2>, SMatrix<f64, 2, 2>) {
        (self.phi(q, t), self.jacobian(q, t))
    }
    fn nu(&self, _: &SVector<f64, 2>, _: f64) -> SVector<f64, 2> {
        SVector::from([0.0; 2])
    }
    fn gamma(&self, _: &SVector<f64, 2>, _: &SVector<f64, 2>, _: f64) -> SVector<f64, 2> {
        SVector::from([0.0; 2])
    }
}

#[test]
fn redundant_rows_are_singular() {
    let failure = Redundant.solve(0.0).unwrap_err();
    println!("{failure}");
    assert!(matches!(failure.cause, Cause::Singular { condition, .. } if condition.is_infinite()), "{failure}");
}

/// A mechanism without coordinates.
struct Empty;

impl Stages<f64, 0> for Empty {
    fn stages(&self, t: f64, pass: &mut Solver<'_, f64, 0>) -> Result<Coordinates<f64, 0>, StepError<f64>> {
        reuleaux::at_once(self, t, pass)
    }

    fn refined_guess(&self, t: f64, guess: &SVector<f64, 0>) -> SVector<f64, 0> {
        reuleaux::refined_guess_at_once(self, t, guess)
    }
}

impl Description<f64, 0> for Empty {
    const NAME: &'static str = "Empty";
    const COORDINATES: &'static [Coordinate] = &[];
    const ROWS: &'static [Row] = &[];

    fn start(&self) -> SVector<f64, 0> {
        SVector::from([])
    }
    fn characteristic_length(&self) -> f64 {
        1.0
    }
    fn validate(&self) -> Result<(), ParameterOutOfRange<f64>> {
        Ok(())
    }
}

impl Equations<f64, 0, 0> for Empty {
    fn phi(&self, _: &SVector<f64, 0>, _: f64) -> SVector<f64, 0> {
        SVector::from([])
    }
    fn jacobian(&self, _: &SVector<f64, 0>, _: f64) -> SMatrix<f64, 0, 0> {
        SMatrix::from([])
    }
    fn linearize(&self, q: &SVector<f64, 0>, t: f64) -> (SVector<f64, 0>, SMatrix<f64, 0, 0>) {
        (self.phi(q, t), self.jacobian(q, t))
    }
    fn nu(&self, _: &SVector<f64, 0>, _: f64) -> SVector<f64, 0> {
        SVector::from([])
    }
    fn gamma(&self, _: &SVector<f64, 0>, _: &SVector<f64, 0>, _: f64) -> SVector<f64, 0> {
        SVector::from([])
    }
}

#[test]
fn nothing_is_solved_as_well() {
    assert_eq!(Empty.sweep([0.0, 1.0, 1e9]).filter(Result::is_ok).count(), 3);
    assert!(Empty.solve(f64::NAN).is_err());
}
