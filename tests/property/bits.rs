//! The interpreter defines the meaning of an expression; emitted code returns the same doubles, bit for bit.

use reuleaux_compiler::library;
use reuleaux_compiler::quantity::Ambient;
use reuleaux_tests::common::all::{FUNCTIONS, Visitor, visit};
use reuleaux_tests::common::declared::Declared;
use reuleaux_tests::common::interpreter::Interpreter;

use crate::random::{generator, instant, mechanism};

/// Number of random states per declaration.
const STATES: usize = 1000;

#[test]
fn emitted_code_and_interpreter_agree_bit_for_bit() {
    let mut compared = Compared::default();
    visit(&mut compared);
    println!("{} doubles compared, {} of them not numbers", compared.doubles, compared.not_numbers);
    // Few of the compared values may be undefined.
    assert!(compared.not_numbers * 1000 < compared.doubles);
}

#[test]
fn every_constraint_and_every_function_of_the_library_is_compared() {
    let mut texts = Texts(String::new());
    visit(&mut texts);
    for name in library::constraints(Ambient::Plane).chain(library::functions()) {
        assert!(texts.call(name), "{name} is in no declaration");
    }
}

#[derive(Default)]
struct Compared {
    doubles: usize,
    not_numbers: usize,
}

impl Compared {
    fn compare<'a>(&mut self, what: &str, emitted: impl IntoIterator<Item = &'a f64>, interpreted: impl IntoIterator<Item = &'a f64>) {
        let (mut emitted, mut interpreted) = (emitted.into_iter(), interpreted.into_iter());
        loop {
            match (emitted.next(), interpreted.next()) {
                (None, None) => return,
                (Some(x), Some(y)) => {
                    self.doubles += 1;
                    self.not_numbers += usize::from(x.is_nan());
                    // The payload of a NaN is not specified.
                    assert!(x.to_bits() == y.to_bits() || (x.is_nan() && y.is_nan()), "{what}: {x:e} emitted, {y:e} interpreted");
                }
                _ => panic!("{what}: not as many entries"),
            }
        }
    }
}

impl Visitor for Compared {
    fn visit<D: Declared>(&mut self, name: &'static str) {
        let (mut rng, mut interpreter) = (generator(name), Interpreter::of(D::TEXT));
        assert_eq!(D::size(), interpreter.size, "{name}");
        for _ in 0..STATES {
            let (mechanism, parameters) = mechanism::<D>(&mut rng);
            let at = instant(&mut rng, D::size().1);
            assert!(parameters.iter().map(|parameter| &parameter.0).eq(&interpreter.parameters), "{name}");
            let values: Vec<f64> = parameters.iter().map(|parameter| parameter.1).collect();
            let (emitted, interpreted) = (mechanism.rows(&at), interpreter.rows(&values, &at, &FUNCTIONS));
            self.compare(&format!("{name} Φ"), &emitted.phi, &interpreted.phi);
            self.compare(&format!("{name} ν"), &emitted.nu, &interpreted.nu);
            self.compare(&format!("{name} γ"), &emitted.gamma, &interpreted.gamma);
            self.compare(&format!("{name} Φ_q"), emitted.jacobian.iter().flatten(), interpreted.jacobian.iter().flatten());
            let (phi, jacobian) = mechanism.linearized(&at);
            self.compare(&format!("{name} Φ with Φ_q"), &phi, &interpreted.phi);
            self.compare(&format!("{name} Φ_q with Φ"), jacobian.iter().flatten(), interpreted.jacobian.iter().flatten());
            let entries = mechanism.entries(&at);
            assert!(entries.iter().map(|entry| &entry.0).eq(&interpreter.pattern), "{name}: other places");
            let outputs = (mechanism.outputs(&at), interpreter.outputs(&values, &at, &FUNCTIONS));
            self.compare(&format!("{name} outputs"), outputs.0.iter().flatten(), outputs.1.iter().flatten());
        }
    }
}

struct Texts(String);

impl Texts {
    /// True if a call of this name occurs: the name stands before a parenthesis and is not the end of another name.
    fn call(&self, name: &str) -> bool {
        let is_part = |letter: char| letter.is_alphanumeric() || letter == '_';
        self.0.match_indices(&format!("{name}(")).any(|(place, _)| !self.0[..place].ends_with(is_part))
    }
}

impl Visitor for Texts {
    fn visit<D: Declared>(&mut self, _: &'static str) {
        self.0.extend(D::TEXT.split_whitespace());
    }
}
