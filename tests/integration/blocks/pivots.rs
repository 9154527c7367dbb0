//! Pivots of a block in its fixed order, or in the order of its rows if there is none, by the interpreter.

use reuleaux_compiler::compile;
use reuleaux_compiler::expr::{Evaluator, Expr, Values};
use reuleaux_compiler::plan::{Elimination, Solving, StageCode};

/// The elimination of a mechanism's largest block.
pub(super) struct Pivots {
    pattern: Vec<(usize, usize)>,
    rows: Vec<usize>,
    columns: Vec<usize>,
    entries: Evaluator,
}

impl Pivots {
    /// Pivots of a declaration's largest block.
    pub(super) fn of(text: &str) -> Self {
        let compiled = compile(text.parse().expect("tokens")).unwrap_or_else(|_| panic!("a mechanism: {text}"));
        let Solving::Straight(lines) = compiled.plan.solution.expect("a mechanism that is solved").solving else {
            panic!("straight lines")
        };
        let blocks = lines.parts.into_iter().filter_map(|part| if let StageCode::Block(block) = part { Some(block) } else { None });
        let block = blocks.max_by_key(|block| block.system.unknowns.len()).expect("a block");
        let size = block.system.unknowns.len();
        let in_order: Vec<usize> = (0..size).collect();
        let full = || (0..size).flat_map(|i| (0..size).map(move |j| (i, j))).collect();
        let (pattern, rows, columns) = match block.system.elimination.map(|elimination| *elimination) {
            Some(Elimination { pattern, rows, columns, .. }) => (pattern, rows, columns),
            None => (full(), in_order.clone(), in_order),
        };
        let entries: Vec<Expr> = pattern.iter().map(|(i, j)| block.system.jacobian[*i][*j]).collect();
        Self { pattern, rows, columns, entries: Evaluator::new(&compiled.plan.arena, &entries) }
    }

    /// K
    pub(super) fn size(&self) -> usize {
        self.rows.len()
    }

    /// Pivots at these parameters, time and coordinates.
    pub(super) fn at(&mut self, parameters: &[f64], time: f64, coordinates: &[f64]) -> Vec<f64> {
        let Self { pattern, rows, columns, entries } = self;
        let functions = |_: u32, _: f64| [f64::NAN; 3];
        let mut found = vec![f64::NAN; pattern.len()];
        entries.run(&Values { time, parameters, coordinates, speeds: &[], accelerations: &[], functions: &functions }, &mut found);
        let size = rows.len();
        let mut matrix = vec![vec![0.0; size]; size];
        for ((row, column), value) in pattern.iter().zip(found) {
            let place = |list: &[usize], index| list.iter().position(|entry| *entry == index).expect("a pivot in each row and column");
            matrix[place(rows, *row)][place(columns, *column)] = value;
        }
        for k in 0..size {
            let (above, below) = matrix.split_at_mut(k + 1);
            for row in below {
                let multiplier = row[k] / above[k][k];
                if multiplier != 0.0 {
                    row.iter_mut().zip(&above[k]).skip(k + 1).for_each(|(entry, source)| *entry -= multiplier * source);
                }
            }
        }
        (0..size).map(|k| matrix[k][k]).collect()
    }
}
