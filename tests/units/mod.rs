//! The constraint types of `unit_constraints.json`, one declaration for each, with all numbers as parameters.
//!
//! A parameter is named as in the file: `point_i_x` is the first entry of `point_i`, `c2` a coefficient of a law.

mod definitions;
mod pairs;
mod relations;
mod singles;

pub use definitions::*;
pub use pairs::*;
pub use relations::*;
pub use singles::*;

use crate::common::declared::{Declared, Instant, Rows};
use crate::common::reference::{Value, number, text};

/// The rows of a declaration with the numbers of a constraint, at an instant.
pub fn rows_of<D: Declared>(constraint: &Value, at: &Instant) -> Rows {
    D::with(&mut |name| named(constraint, name)).rows(at)
}

/// The number of a parameter, by its name.
fn named(constraint: &Value, name: &str) -> f64 {
    if name == "signed_radius_j" {
        return if text(&constraint["mesh"]) == "external" { 1.0 } else { -1.0 } * number(&constraint["radius_j"]);
    }
    let entry = match (name.rsplit_once('_'), name.strip_prefix("coeff_")) {
        (_, Some(index)) => &constraint["coeffs"][index.parse::<usize>().expect("an index")],
        (Some((list, "x")), _) => &constraint[list][0],
        (Some((list, "y")), _) => &constraint[list][1],
        _ => &constraint[name],
    };
    if entry.is_null() { law(&constraint["f"], name) } else { number(entry) }
}

/// A coefficient of a law of time; 0 if the law has no such term.
///
/// # Panics
/// If the law has terms that the declarations cannot express.
#[must_use]
pub fn law(law: &Value, name: &str) -> f64 {
    match text(&law["law"]) {
        "polynomial" => {
            let coefficients = &law["coeffs"];
            assert!(coefficients[5].is_null(), "a polynomial of degree four at most: {law}");
            name.strip_prefix('c').map_or(0.0, |index| coefficients[index.parse::<usize>().expect("an index")].as_f64().unwrap_or(0.0))
        }
        "harmonic" if name.starts_with('c') => 0.0,
        "harmonic" => number(&law[name]),
        "sum" => {
            let terms = law["terms"].as_array().expect("terms");
            assert!(terms.len() == 2 && terms[0]["law"] != terms[1]["law"], "one term of each kind: {law}");
            terms.iter().map(|term| self::law(term, name)).sum()
        }
        other => panic!("unknown law {other}"),
    }
}
