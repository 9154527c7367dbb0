//! Tables are cubic splines with a continuous second derivative, the same in the compiler and in the runtime.

use fastrand::Rng;
use reuleaux_compiler::model::{Function, Table};
use reuleaux_tests::common::declared::{Declared, Instant};
use reuleaux_tests::laws::{POINTS, Tables};

use crate::random::between;

const ENDS: [&str; 3] = ["periodic", "linear", "hold"];

/// Points with increasing x; the last y equals the first.
fn points(rng: &mut Rng) -> Vec<(f64, f64)> {
    let mut x = between(rng, -5.0, 5.0);
    let mut points: Vec<(f64, f64)> = Vec::new();
    for _ in 0..rng.usize(2..12) {
        points.push((x, between(rng, -2.0, 2.0)));
        x += between(rng, 0.05, 1.0);
    }
    let height = points[0].1;
    points.push((x, height));
    points
}

/// The spline that the compiler builds from points.
fn table(points: &[(f64, f64)], ends: &str) -> Table {
    let list: Vec<String> = points.iter().map(|(x, y)| format!("({x:?}, {y:?})")).collect();
    let text = format!(
        "#[equations_only] pub mechanism OfTable {{ body b {{}} drive d = {{ b.angle == table(t / 1s, [{}], {ends}); }} }}",
        list.join(", ")
    );
    let compiled = reuleaux_compiler::compile(text.parse().unwrap()).unwrap_or_else(|refusals| panic!("{}\n{text}", refusals[0].fact));
    let [Function::Table(table)] = compiled.model.functions.as_slice() else { panic!("one table") };
    table.clone()
}

/// Fifty tables with each kind of end.
fn tables() -> impl Iterator<Item = (Vec<(f64, f64)>, &'static str, Table)> {
    let mut rng = Rng::with_seed(7);
    (0..150).map(move |index| {
        let (points, ends) = (points(&mut rng), ENDS[index % 3]);
        let table = table(&points, ends);
        (points, ends, table)
    })
}

/// Value and derivatives of a cubic at distance d.
fn cubic([c0, c1, c2, c3]: [f64; 4], d: f64) -> [f64; 3] {
    [c0 + d * (c1 + d * (c2 + d * c3)), c1 + d * (2.0 * c2 + d * 3.0 * c3), 2.0 * c2 + d * 6.0 * c3]
}

/// Allowed differences of value and derivatives: in a second derivative over the shortest interval, 0.05, terms of up to 4 / 0.05² cancel.
const ALLOWED: [f64; 3] = [1e-13, 1e-11, 1e-9];

fn assert_same(what: &str, left: [f64; 3], right: [f64; 3]) {
    for order in 0..3 {
        assert!((left[order] - right[order]).abs() <= ALLOWED[order], "{what}: {left:?} {right:?}");
    }
}

#[test]
fn tables_go_through_their_points() {
    for (points, ends, table) in tables() {
        for (x, y) in &points {
            assert!((table.evaluate(*x)[0] - y).abs() <= 1e-13, "{ends} at {x}");
        }
    }
}

#[test]
fn second_derivative_is_continuous() {
    for (_, ends, table) in tables() {
        for (i, pair) in table.coefficients.windows(2).enumerate() {
            assert_same(ends, cubic(pair[0], table.knots[i + 1] - table.knots[i]), cubic(pair[1], 0.0));
        }
    }
}

#[test]
fn periodic_tables_repeat() {
    for (_, _, table) in tables().filter(|(_, ends, _)| *ends == "periodic") {
        let (last, n) = (table.coefficients.len() - 1, table.knots.len());
        assert_same("seam", cubic(table.coefficients[last], table.knots[n - 1] - table.knots[last]), cubic(table.coefficients[0], 0.0));
        let (first, period) = (table.knots[0], table.knots[n - 1] - table.knots[0]);
        for turn in [-7.0, -1.0, 1.0, 12.0] {
            let x = first + 0.37 * period;
            assert_same("turn", table.evaluate(x), table.evaluate(x + turn * period));
        }
    }
}

#[test]
fn linear_ends_are_straight() {
    for (points, _, table) in tables().filter(|(_, ends, _)| *ends == "linear") {
        for (place, _) in [points[0], points[points.len() - 1]] {
            let [value, slope, second] = table.evaluate(place);
            assert!(second.abs() <= ALLOWED[2]);
            let far = if place == points[0].0 { place - 3.0 } else { place + 3.0 };
            assert_same("outside", table.evaluate(far), [value + slope * (far - place), slope, 0.0]);
        }
    }
}

#[test]
fn hold_ends_stand_still() {
    for (points, _, table) in tables().filter(|(_, ends, _)| *ends == "hold") {
        for (place, height) in [points[0], points[points.len() - 1]] {
            assert!(table.evaluate(place)[1].abs() <= ALLOWED[1]);
            let far = if place == points[0].0 { place - 3.0 } else { place + 3.0 };
            assert_same("outside", table.evaluate(far), [height, 0.0, 0.0]);
        }
    }
}

#[test]
fn compiler_and_runtime_agree_bit_for_bit() {
    let mut rng = Rng::with_seed(11);
    for (_, ends, table) in tables() {
        let runtime = emitted(&table, ends);
        let special = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, -0.0, 1e300, -1e300, 1e17];
        let inside: Vec<f64> = (0..200).map(|_| between(&mut rng, -12.0, 18.0)).collect();
        let near = table.knots.iter().flat_map(|knot| [knot.next_down(), *knot, knot.next_up()]);
        for x in special.into_iter().chain(inside).chain(near) {
            let ([a, b, c], (d, e, f)) = (table.evaluate(x), runtime.evaluate(x));
            for (compiled, run) in [(a, d), (b, e), (c, f)] {
                assert!(compiled.to_bits() == run.to_bits() || (compiled.is_nan() && run.is_nan()), "{ends} at {x:e}: {compiled} {run}");
            }
        }
    }
}

/// Slopes of the spline through the points for each kind of end, computed independently from second derivatives: the moments M solve
/// h₀ M₀ + 2 (h₀ + h₁) M₁ + h₁ M₂ = 6 (s₁ − s₀), by Gaussian elimination.
fn moments(points: &[(f64, f64)], ends: &str) -> Vec<f64> {
    let n = points.len();
    let width = |i: usize| points[i + 1].0 - points[i].0;
    let secant = |i: usize| (points[i + 1].1 - points[i].1) / width(i);
    let mut rows = vec![vec![0.0; n + 1]; n];
    for i in 1..n - 1 {
        (rows[i][i - 1], rows[i][i], rows[i][i + 1]) = (width(i - 1), 2.0 * (width(i - 1) + width(i)), width(i));
        rows[i][n] = 6.0 * (secant(i) - secant(i - 1));
    }
    let last = n - 1;
    match ends {
        "periodic" => {
            // M₀ = M_last, and the equation across the seam.
            (rows[0][0], rows[0][last]) = (1.0, -1.0);
            (rows[last][0], rows[last][1]) = (2.0 * (width(0) + width(last - 1)), width(0));
            rows[last][last - 1] += width(last - 1);
            rows[last][n] = 6.0 * (secant(0) - secant(last - 1));
        }
        "linear" => (rows[0][0], rows[last][last]) = (1.0, 1.0),
        _ => {
            (rows[0][0], rows[0][1], rows[0][n]) = (2.0, 1.0, 6.0 * secant(0) / width(0));
            (rows[last][last], rows[last][last - 1], rows[last][n]) = (2.0, 1.0, -6.0 * secant(last - 1) / width(last - 1));
        }
    }
    for k in 0..n {
        let pivot = (k..n).max_by(|i, j| rows[*i][k].abs().total_cmp(&rows[*j][k].abs())).unwrap();
        rows.swap(k, pivot);
        let row = rows[k].clone();
        for i in (0..n).filter(|i| *i != k) {
            let factor = rows[i][k] / row[k];
            for (entry, above) in rows[i].iter_mut().zip(&row).skip(k) {
                *entry -= factor * above;
            }
        }
    }
    (0..n).map(|i| rows[i][n] / rows[i][i]).collect()
}

#[test]
fn second_derivatives_are_those_of_an_independent_solution() {
    for (points, ends, table) in tables() {
        for (i, moment) in moments(&points, ends).into_iter().enumerate().take(points.len() - 1) {
            let found = 2.0 * table.coefficients[i][2];
            assert!((found - moment).abs() <= 1e-10 * (1.0 + moment.abs()), "{ends} at point {i} of {points:?}: {found} {moment}");
        }
    }
}

#[test]
fn emitted_tables_are_the_splines_through_their_points() {
    for (index, ends) in ENDS.iter().enumerate() {
        let table = table(&POINTS, ends);
        for x in (-80..=120).map(|step| f64::from(step) / 20.0) {
            let at = Instant { t: x, q: vec![0.0; 3], qd: vec![0.0; 3], qdd: vec![0.0; 3] };
            assert_eq!(Tables::default().outputs(&at)[index], table.evaluate(x), "{ends} at {x}");
        }
    }
}

/// The emitted table.
fn emitted(table: &Table, ends: &str) -> reuleaux::Table {
    let knots: Vec<[f32; 2]> = table.knots.iter().map(|knot| reuleaux::Single::knots(&[*knot])[0]).collect();
    let coefficients: Vec<[f32; 4]> = table.coefficients.iter().map(|row| reuleaux::Single::coefficients(&[*row])[0]).collect();
    let [first, last] = [table.knots[0], table.knots[table.knots.len() - 1]];
    reuleaux::Table {
        knots: table.knots.clone().leak(),
        coefficients: table.coefficients.clone().leak(),
        ends: match ends {
            "periodic" => reuleaux::Ends::Periodic,
            "linear" => reuleaux::Ends::Linear,
            _ => reuleaux::Ends::Hold,
        },
        single: reuleaux::Single {
            knots: knots.leak(),
            coefficients: coefficients.leak(),
            period: reuleaux::Single::period(&[first, last]),
        },
    }
}

/// Allowed errors of value and derivatives in `f32`, as documented at `Table::evaluate_single`.
fn allowed(table: &Table, ends: &str, x: f64) -> [f64; 3] {
    let (first, last) = (table.knots[0], table.knots[table.knots.len() - 1]);
    let inside = if ends == "periodic" { first + (x - first).rem_euclid(last - first) } else { x.clamp(first, last) };
    // Rounding may select the adjacent interval, which continues this one.
    let reached = table.knots.partition_point(|knot| *knot <= inside);
    let intervals = reached.saturating_sub(2)..(reached + 1).min(table.coefficients.len());
    let of_interval = |interval: usize| {
        let [c0, c1, c2, c3] = table.coefficients[interval].map(f64::abs);
        let d = table.knots[interval + 1] - table.knots[interval];
        [c0 + d * (c1 + d * (c2 + d * c3)), c1 + d * (2.0 * c2 + d * 3.0 * c3), 2.0 * c2 + d * 6.0 * c3]
    };
    let u = f64::from(f32::EPSILON) / 2.0;
    let mut most = intervals.map(of_interval).fold([0.0; 3], |most: [f64; 3], next| core::array::from_fn(|i| most[i].max(next[i])));
    if ends == "linear" {
        most[0] += most[1] * (x - inside).abs();
    }
    most.map(|size| 8.0 * u * size)
}

#[test]
fn single_precision_is_off_by_rounding_only() {
    let mut rng = Rng::with_seed(11);
    let mut worst = 0.0_f64;
    for (_, ends, table) in tables() {
        let emitted = emitted(&table, ends);
        let knots = table.knots.iter().flat_map(|knot| [*knot as f32, (*knot as f32).next_up(), (*knot as f32).next_down()]);
        let others: Vec<f32> =
            (0..200).map(|number| between(&mut rng, -10.0, 10.0) as f32 * if number % 4 == 0 { 1e4 } else { 1.0 }).collect();
        for x in knots.chain(others) {
            let found = reuleaux::Real::table(x, &emitted);
            let found = [found.0, found.1, found.2].map(f64::from);
            let (exact, allowed) = (table.evaluate(f64::from(x)), allowed(&table, ends, f64::from(x)));
            for order in 0..3 {
                let off = (found[order] - exact[order]).abs();
                worst = worst.max(off / allowed[order]);
                assert!(off <= allowed[order], "{order} of {ends} at {x}: {found:?} for {exact:?}");
            }
        }
    }
    // The bound is tight to a factor of ten.
    assert!(worst > 0.1, "{worst}");
}
