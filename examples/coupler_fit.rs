//! Synthesis: which four-bar traces a given curve? Six lengths are fitted to twenty-four points of the curve, by the limited-memory
//! method of Broyden, Fletcher, Goldfarb and Shanno (crate `argmin`).
//!
//! The curve is that of a four-bar with lengths unknown to the search, which must recover them. Derivatives by the lengths come with each
//! state, each at about the cost of a step; differences, which are tried as well, need twelve more sweeps for each gradient.

use std::cell::Cell;
use std::error::Error;
use std::time::Instant;

use argmin::core::{CostFunction, Executor, Gradient as Slope, State as _};
use argmin::solver::linesearch::MoreThuenteLineSearch;
use argmin::solver::quasinewton::LBFGS;
use reuleaux::picture::{Drawable, GROUND};
use reuleaux::view::View;
use reuleaux::{Mechanism, mechanism};
use reuleaux_examples::{Place, apex, carried, largest_difference, place, polar, round, show, steps};

mechanism! {
    /// A crank-rocker of any lengths, with a tip that traces a curve.
    #[picture]
    pub mechanism Curve {
        param ground_length: Length = 400mm;
        param crank_length: Length = 100mm;
        param coupler_length: Length = 350mm;
        param rocker_length: Length = 300mm;
        param along: Length = 175mm;
        param across: Length = 80mm;

        ground { point O = (0mm, 0mm);  point C = (ground_length, 0mm); }
        body crank   { point A = (crank_length, 0mm); }
        body coupler { point B = (coupler_length, 0mm);  point P = (along, across); }
        body rocker  { point B = (rocker_length, 0mm);  start angle = 70deg; }

        joint o = revolute(ground.O, crank.position);
        joint a = revolute(crank.A, coupler.position);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.position, ground.C);
        drive input = drive_angle(crank, 60rpm * t);

        output tip = coupler.P;
    }
}

/// Lengths in the order of the declaration, in m.
type Lengths = [f64; 6];

/// Lengths that the search must recover.
const SOUGHT: Lengths = [0.42, 0.105, 0.34, 0.31, 0.19, 0.09];

/// Points on the curve.
const POINTS: u32 = 24;

fn with([ground_length, crank_length, coupler_length, rocker_length, along, across]: Lengths) -> Curve {
    Curve { ground_length, crank_length, coupler_length, rocker_length, along, across }
}

fn lengths(of: &[f64]) -> Lengths {
    std::array::from_fn(|i| of[i])
}

fn times() -> impl Iterator<Item = f64> {
    steps(0.0, 1.0, POINTS).take(POINTS as usize)
}

/// The curve by plane geometry.
fn target() -> Vec<Place> {
    let [ground, crank, coupler, rocker, along, across] = SOUGHT;
    let tip = |t: f64| {
        let pin = polar(crank, std::f64::consts::TAU * t);
        let end = apex(pin, place(ground, 0.0), coupler, rocker);
        carried(place(along, across), pin, place(coupler, 0.0), end)
    };
    times().map(tip).collect()
}

/// Half the sum of the squared distances between the tip and the points, in m².
struct Fit {
    target: Vec<Place>,
    with_derivatives: bool,
    sweeps: Cell<usize>,
}

impl Fit {
    /// The sum for these lengths.
    fn sum(&self, of: Lengths) -> Result<f64, argmin::core::Error> {
        self.sweeps.set(self.sweeps.get() + 1);
        let mut sum = 0.0;
        let curve = with(of);
        for (state, point) in curve.sweep(times()).zip(&self.target) {
            sum += 0.5 * (curve.tip(&state?).value - point).norm_squared();
        }
        Ok(sum)
    }

    /// Its derivative by each length, from the derivatives of the tip.
    fn slope(&self, of: Lengths) -> Result<Vec<f64>, argmin::core::Error> {
        self.sweeps.set(self.sweeps.get() + 1);
        let mut slope = vec![0.0; 6];
        let curve = with(of);
        for (state, point) in curve.sweep(times()).zip(&self.target) {
            let state = state?;
            let (varied, state) = curve.derivatives(&state, |curve| {
                let Curve { ground_length, crank_length, coupler_length, rocker_length, along, across } = curve;
                [ground_length, crank_length, coupler_length, rocker_length, along, across]
            })?;
            let tip = varied.tip(&CurveState(state)).value;
            let off = [tip.x.value - point.x, tip.y.value - point.y];
            for (k, slope) in slope.iter_mut().enumerate() {
                *slope += off[0] * tip.x.by[k] + off[1] * tip.y.by[k];
            }
        }
        Ok(slope)
    }

    /// The same from central differences.
    fn difference(&self, of: Lengths) -> Result<Vec<f64>, argmin::core::Error> {
        let h = 1e-6;
        let moved = |k: usize, by: f64| {
            let mut of = of;
            of[k] += by;
            self.sum(of)
        };
        (0..6).map(|k| Ok((moved(k, h)? - moved(k, -h)?) / (2.0 * h))).collect()
    }
}

impl CostFunction for &Fit {
    type Param = Vec<f64>;
    type Output = f64;
    fn cost(&self, of: &Vec<f64>) -> Result<f64, argmin::core::Error> {
        self.sum(lengths(of))
    }
}

impl Slope for &Fit {
    type Param = Vec<f64>;
    type Gradient = Vec<f64>;
    fn gradient(&self, of: &Vec<f64>) -> Result<Vec<f64>, argmin::core::Error> {
        if self.with_derivatives { self.slope(lengths(of)) } else { self.difference(lengths(of)) }
    }
}

/// The lengths found, the number of sweeps, and the time in seconds.
fn fitted(with_derivatives: bool) -> Result<(Lengths, usize, f64), argmin::core::Error> {
    let fit = Fit { target: target(), with_derivatives, sweeps: Cell::new(0) };
    let Curve { ground_length, crank_length, coupler_length, rocker_length, along, across } = Curve::default();
    let start = vec![ground_length, crank_length, coupler_length, rocker_length, along, across];
    let solver = LBFGS::new(MoreThuenteLineSearch::new(), 6).with_tolerance_grad(1e-12)?.with_tolerance_cost(0.0)?;
    let begin = Instant::now();
    let result = Executor::new(&fit, solver).configure(|state| state.param(start).max_iters(500)).run()?;
    let found = result.state().get_best_param().ok_or(argmin::core::Error::msg("no lengths"))?;
    Ok((lengths(found), fit.sweeps.get(), begin.elapsed().as_secs_f64()))
}

fn main() -> Result<(), Box<dyn Error>> {
    let (found, sweeps, seconds) = fitted(true)?;
    let (_, sweeps_of_differences, seconds_of_differences) = fitted(false)?;
    println!("lengths found (mm): {:.6?}", found.map(|length| 1e3 * length));
    println!("with derivatives: {sweeps} sweeps; with differences: {sweeps_of_differences}");
    println!("{:.1} times fewer, in {:.1} times less time", sweeps_of_differences as f64 / sweeps as f64, seconds_of_differences / seconds);
    let off = largest_difference(found.into_iter().zip(SOUGHT));
    assert!(off < 1e-7, "off by {off} m");
    assert!(3 * sweeps < sweeps_of_differences, "{sweeps} of {sweeps_of_differences}");

    let (first, last) = (with([0.4, 0.1, 0.35, 0.3, 0.175, 0.08]), with(found));
    let times = || steps(0.0, 1.0, 5 * POINTS);
    let [before, after] = [first.sweep(times()).collect::<Result<Vec<_>, _>>()?, last.sweep(times()).collect::<Result<Vec<_>, _>>()?];
    let states = before.into_iter().zip(after);
    let given = |angle: f64| {
        let step = angle.to_degrees() * f64::from(POINTS) / 360.0;
        if (step - step.round()).abs() < 1e-6 { target()[step.round() as usize % target().len()].y * 1e3 } else { f64::NAN }
    };
    let view = View::new("Four-bar fitted to a curve", states, |(_, state)| state.t, |(_, state)| last.scene(state))
        .over("crank", "°", |(_, state)| state.crank().angle.to_degrees())
        .trace("curve before", |(state, _)| first.tip(state).value)
        .trace("after", |(_, state)| last.tip(state).value)
        .plot("height of the tip before", "mm", |(state, _)| first.tip(state).value.y * 1e3)
        .and("after", |(_, state)| last.tip(state).value.y * 1e3)
        .against("given", |(_, state)| given(state.crank().angle));
    // The given points.
    let dot = |at: &Place| round(0.003).into_iter().map(|corner| at + corner).collect::<Vec<_>>();
    let view = target().iter().fold(view, |view, at| view.outline(GROUND, dot(at)));
    show("coupler_fit", &view, 20, &[])
}
