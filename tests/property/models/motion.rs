//! Compares the reported motion with tiny steps of all equations at once: it continues, or ends at the time that the compiler reports.

use super::{compiled, elements};
use fastrand::Rng;
use reuleaux_compiler::Compiled;
use reuleaux_compiler::diag::{AssemblyFact, Fact};
use reuleaux_compiler::expr::{Evaluator, Expr, Values};
use reuleaux_compiler::model::Function;

/// Smallest number of steps for the whole range.
const STEPS: f64 = 400.0;

/// Largest correction of a prediction, in m or rad.
const SURPRISE: f64 = 0.02;

/// Result for a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Verdict {
    GoesOn,
    Ends,
    /// The compiler makes no statement.
    Open,
}

/// Compares the motion that the compiler reports for a random model with tiny steps.
pub(crate) fn judge(seed: u64) -> Verdict {
    let source = elements::random(&mut Rng::with_seed(seed)).declaration();
    let followed = source.replacen("#[closure(start)]", "#[closure(deny)]", 1);
    let there = |what: &str| format!("seed {seed}: {what}\n{followed}");
    let (end, reached) = match compiled(&followed) {
        Ok(compiled) => (None, compiled.motion.reached[1]),
        Err(refusals) => match &refusals[0].fact {
            Fact::Assembly(AssemblyFact::MotionEnds { time, .. }) => (Some(*time), *time),
            other => panic!("{}", there(&other.to_string())),
        },
    };
    if reached == 0.0 {
        return Verdict::Open;
    }
    let compiled = compiled(&source).unwrap_or_else(|refusals| panic!("{}", there(&refusals[0].fact.to_string())));
    let mut tracker = Tracker::new(&compiled);
    let start = tracker.settle(0.0, compiled.assembly.start.clone()).expect("the start is closed");
    let Some(end) = end else {
        tracker.follow(start, reached).unwrap_or_else(|time| panic!("{}", there(&format!("ends at {time} s, said to reach {reached} s"))));
        return Verdict::GoesOn;
    };
    // The square of the determinant vanishes linearly: its zero follows from two earlier values.
    let gap = 1e-4 * end;
    let at = |time: f64, from: Spot, tracker: &mut Tracker| {
        tracker.follow(from, time).unwrap_or_else(|time| panic!("{}", there(&format!("ends at {time} s already, said to end at {end} s"))))
    };
    let one = at(end - gap, start, &mut tracker);
    let two = at(end - gap / 4.0, one.clone(), &mut tracker);
    let ratio = (2.0 * (two.size - one.size)).exp();
    let found = two.time + ratio * (two.time - one.time) / (1.0 - ratio);
    assert!((found - end).abs() < 0.1 * gap, "{}", there(&format!("ends at {found} s by its determinant, said to end at {end} s")));
    Verdict::Ends
}

/// A solved configuration.
#[derive(Clone)]
struct Spot {
    time: f64,
    q: Vec<f64>,
    rates: Vec<f64>,
    /// Sign of the determinant, and ln |det|.
    sign: f64,
    size: f64,
}

struct Tracker<'a> {
    compiled: &'a Compiled,
    parameters: Vec<f64>,
    evaluator: Evaluator,
    pattern: Vec<(usize, usize)>,
    n: usize,
}

impl<'a> Tracker<'a> {
    fn new(compiled: &'a Compiled) -> Tracker<'a> {
        let system = &compiled.system;
        let rows: Vec<_> = system.equations.iter().collect();
        let n = rows.len();
        assert_eq!(n, system.coordinates.len());
        let mut roots: Vec<Expr> = rows.iter().filter_map(|row| row.phi()).collect();
        roots.extend(rows.iter().map(|row| row.nu));
        let mut pattern = Vec::new();
        for (index, row) in rows.iter().enumerate() {
            for (column, entry) in &row.jacobian {
                pattern.push((index, *column));
                roots.push(*entry);
            }
        }
        let defaults: Vec<Expr> = compiled.model.parameters.iter().map(|parameter| parameter.default).collect();
        let mut parameters = vec![0.0; defaults.len()];
        let nothing = |_: u32, _: f64| [f64::NAN; 3];
        let values = Values { time: 0.0, parameters: &[], coordinates: &[], speeds: &[], accelerations: &[], functions: &nothing };
        Evaluator::new(&system.arena, &defaults).run(&values, &mut parameters);
        Tracker { compiled, parameters, evaluator: Evaluator::new(&system.arena, &roots), pattern, n }
    }

    /// Φ, Φ_q and ν.
    fn linear(&mut self, time: f64, q: &[f64]) -> (Vec<f64>, Vec<Vec<f64>>, Vec<f64>) {
        let functions = |number: u32, x: f64| match &self.compiled.model.functions[number as usize] {
            Function::Table(table) => table.evaluate(x),
            Function::Rust(_) => [f64::NAN; 3],
        };
        let values = Values { time, parameters: &self.parameters, coordinates: q, speeds: &[], accelerations: &[], functions: &functions };
        let mut found = vec![0.0; 2 * self.n + self.pattern.len()];
        self.evaluator.run(&values, &mut found);
        let mut jacobian = vec![vec![0.0; self.n]; self.n];
        for ((row, column), entry) in self.pattern.iter().zip(&found[2 * self.n..]) {
            jacobian[*row][*column] = *entry;
        }
        (found[..self.n].to_vec(), jacobian, found[self.n..2 * self.n].to_vec())
    }

    /// Newton's method from a good prediction.
    fn settle(&mut self, time: f64, mut q: Vec<f64>) -> Option<Spot> {
        for iteration in 0..10 {
            let (phi, jacobian, nu) = self.linear(time, &q);
            let (step, rates, sign, size) = solve(jacobian, phi, nu)?;
            let most = step.iter().fold(0.0, |most: f64, step| most.max(step.abs()));
            if !most.is_finite() || most > SURPRISE {
                return None;
            }
            q.iter_mut().zip(&step).for_each(|(value, step)| *value -= step);
            if most < 1e-11 || iteration == 9 {
                return (most < 1e-7).then_some(Spot { time, q, rates, sign, size });
            }
        }
        None
    }

    /// Takes tiny steps up to a time; `Err`: the time at which no further step succeeds.
    fn follow(&mut self, start: Spot, until: f64) -> Result<Spot, f64> {
        let (mut here, mut step) = (start, until / STEPS);
        while here.time < until {
            let next = until.min(here.time + step);
            let h = next - here.time;
            let predicted = here.q.iter().zip(&here.rates).map(|(value, rate)| value + h * rate).collect();
            let is_short = |there: &Spot| {
                let off = |i: usize| (there.q[i] - here.q[i] - h / 2.0 * (here.rates[i] + there.rates[i])).abs();
                there.sign == here.sign && (0..here.q.len()).all(|i| off(i) < SURPRISE / 4.0)
            };
            match self.settle(next, predicted).filter(is_short) {
                Some(there) => (here, step) = (there, (1.5 * step).min(until / STEPS)),
                None => step /= 2.0,
            }
            if step < 1e-9 * until {
                return Err(here.time);
            }
        }
        Ok(here)
    }
}

/// x from A x = b, y from A y = c, the sign of det A, and ln |det A|.
fn solve(mut a: Vec<Vec<f64>>, mut b: Vec<f64>, mut c: Vec<f64>) -> Option<(Vec<f64>, Vec<f64>, f64, f64)> {
    let n = b.len();
    let (mut sign, mut size) = (1.0, 0.0);
    for k in 0..n {
        let pivot = (k..n).max_by(|one, two| a[*one][k].abs().total_cmp(&a[*two][k].abs()))?;
        if pivot != k {
            a.swap(k, pivot);
            b.swap(k, pivot);
            c.swap(k, pivot);
            sign = -sign;
        }
        if a[k][k] == 0.0 || !a[k][k].is_finite() {
            return None;
        }
        sign *= a[k][k].signum();
        size += a[k][k].abs().ln();
        let (done, rest) = a.split_at_mut(k + 1);
        for (i, row) in rest.iter_mut().enumerate().filter(|(_, row)| row[k] != 0.0) {
            let multiplier = row[k] / done[k][k];
            row[k..].iter_mut().zip(&done[k][k..]).for_each(|(entry, above)| *entry -= multiplier * above);
            b[k + 1 + i] -= multiplier * b[k];
            c[k + 1 + i] -= multiplier * c[k];
        }
    }
    for right in [&mut b, &mut c] {
        for k in (0..n).rev() {
            let known: f64 = (k + 1..n).map(|j| a[k][j] * right[j]).sum();
            right[k] = (right[k] - known) / a[k][k];
        }
    }
    Some((b, c, sign, size))
}
