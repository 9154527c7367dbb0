//! A declaration as text, compiled up to its plan and evaluated by the interpreter, which defines its meaning.

use reuleaux_compiler::compile;
use reuleaux_compiler::expr::{Evaluator, Values};
use reuleaux_compiler::model::Function;

use super::declared::{Instant, Rows};

/// Value, first and second derivative of a function of one variable.
pub type Jet = fn(f64) -> (f64, f64, f64);

/// A compiled declaration with its interpreter.
#[derive(Clone, Debug)]
pub struct Interpreter {
    /// Names of the parameters, in order.
    pub parameters: Vec<String>,
    /// Number of equations and of coordinates.
    pub size: (usize, usize),
    /// Row and column of the Jacobian's entries.
    pub pattern: Vec<(usize, usize)>,
    /// Configuration from which the compiler starts to solve.
    pub start: Vec<f64>,
    functions: Vec<Function>,
    rows: Evaluator,
    outputs: Evaluator,
    number_of_outputs: usize,
}

impl Interpreter {
    /// Compiles a declaration.
    ///
    /// # Panics
    /// If it is refused, with the messages.
    #[must_use]
    pub fn of(text: &str) -> Self {
        let tokens = text.parse().unwrap_or_else(|error| panic!("{error}\n{text}"));
        let compiled = compile(tokens).unwrap_or_else(|refusals| {
            let sentences: Vec<String> = refusals.iter().map(|refusal| refusal.fact.to_string()).collect();
            panic!("{}\n{text}", sentences.join("\n"))
        });
        let (system, model) = (compiled.system, compiled.model);
        let entries = || system.equations.iter().flat_map(|equation| &equation.jacobian);
        let phi = system.equations.iter().map(|equation| equation.phi().expect("a row with a residual"));
        let (nu, gamma) = (system.equations.iter().map(|equation| equation.nu), system.equations.iter().map(|equation| equation.gamma));
        let roots: Vec<_> = phi.chain(entries().map(|entry| entry.1)).chain(nu).chain(gamma).collect();
        let outputs: Vec<_> = system.outputs.iter().flat_map(|output| output.components.iter().flatten().copied()).collect();
        let place = |(row, equation): (usize, &reuleaux_compiler::system::Equation)| {
            equation.jacobian.iter().map(move |(column, _)| (row, *column)).collect::<Vec<_>>()
        };
        Self {
            parameters: model.parameters.iter().map(|parameter| parameter.name.to_string()).collect(),
            size: (system.equations.len(), system.coordinates.len()),
            pattern: system.equations.iter().enumerate().flat_map(place).collect(),
            start: compiled.assembly.start,
            functions: model.functions,
            rows: Evaluator::new(&system.arena, &roots),
            outputs: Evaluator::new(&system.arena, &outputs),
            number_of_outputs: outputs.len(),
        }
    }

    /// Φ, Φ_q, ν and γ. `functions` are the ones that the text names by path.
    ///
    /// # Panics
    /// If a function is missing.
    pub fn rows(&mut self, parameters: &[f64], at: &Instant, functions: &[(&str, Jet)]) -> Rows {
        let ((m, n), entries) = (self.size, self.pattern.len());
        let mut found = vec![f64::NAN; 3 * m + entries];
        run(&mut self.rows, &self.functions, parameters, at, functions, &mut found);
        let mut jacobian = vec![vec![0.0; n]; m];
        for ((row, column), entry) in self.pattern.iter().zip(&found[m..]) {
            jacobian[*row][*column] = *entry;
        }
        let nu = found[m + entries..2 * m + entries].to_vec();
        Rows { phi: found[..m].to_vec(), jacobian, nu, gamma: found[2 * m + entries..].to_vec() }
    }

    /// Value, rate and acceleration of every component of every output.
    pub fn outputs(&mut self, parameters: &[f64], at: &Instant, functions: &[(&str, Jet)]) -> Vec<[f64; 3]> {
        let mut found = vec![f64::NAN; self.number_of_outputs];
        run(&mut self.outputs, &self.functions, parameters, at, functions, &mut found);
        found.chunks(3).map(|part| [part[0], part[1], part[2]]).collect()
    }
}

fn run(evaluator: &mut Evaluator, known: &[Function], parameters: &[f64], at: &Instant, functions: &[(&str, Jet)], found: &mut [f64]) {
    let call = |number: u32, x: f64| match &known[number as usize] {
        Function::Table(table) => table.evaluate(x),
        Function::Rust(path) => {
            let path = path.to_string().replace(' ', "");
            let jet = functions.iter().find(|(name, _)| *name == path).unwrap_or_else(|| panic!("no function `{path}`")).1(x);
            [jet.0, jet.1, jet.2]
        }
    };
    let values = Values { time: at.t, parameters, coordinates: &at.q, speeds: &at.qd, accelerations: &at.qdd, functions: &call };
    evaluator.run(&values, found);
}
