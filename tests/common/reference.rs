//! Reference values from files, computed elsewhere with 60 digits.

use std::fs;
use std::path::{Path, PathBuf};

pub use serde_json::Value;

use super::decimal::Decimal;

/// The folder with the reference values: `shared/reference` beside the repository if it exists, with all files, otherwise the copies that
/// come with the tests.
#[must_use]
pub fn folder() -> PathBuf {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR"));
    let shared = tests.join("../../shared/reference");
    if shared.is_dir() { shared } else { tests.join("reference") }
}

/// The file of this name.
///
/// # Panics
/// If it is missing or not JSON.
#[must_use]
pub fn file(name: &str) -> Value {
    read(&folder().join(name))
}

/// All JSON files in a folder, with their names without extension, in alphabetical order.
///
/// # Panics
/// If the folder is missing.
#[must_use]
pub fn files(of: &str) -> Vec<(String, Value)> {
    let entries = fs::read_dir(folder().join(of)).unwrap_or_else(|error| panic!("{of}: {error}"));
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "json"));
    paths.sort();
    paths.iter().map(|path| (path.file_stem().unwrap_or_default().to_string_lossy().into_owned(), read(path))).collect()
}

fn read(path: &Path) -> Value {
    let text = fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Elements of a list.
///
/// # Panics
/// If the value is not a list.
#[must_use]
pub fn list(value: &Value) -> &[Value] {
    value.as_array().unwrap_or_else(|| panic!("{value} is not a list"))
}

/// A text.
///
/// # Panics
/// If the value is not a text.
#[must_use]
pub fn text(value: &Value) -> &str {
    value.as_str().unwrap_or_else(|| panic!("{value} is not a text"))
}

/// A number that is exactly a double.
///
/// # Panics
/// If the value is not a number.
#[must_use]
pub fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is not a number"))
}

/// A list of numbers that are exactly doubles.
#[must_use]
pub fn numbers(value: &Value) -> Vec<f64> {
    list(value).iter().map(number).collect()
}

/// A list of decimal strings.
#[must_use]
pub fn decimals(value: &Value) -> Vec<Decimal> {
    list(value).iter().map(|entry| Decimal::parse(text(entry))).collect()
}

/// Largest error relative to the largest entry of the reference; the absolute error if that is zero.
///
/// # Panics
/// If the lengths differ.
#[must_use]
pub fn relative_error(found: &[f64], reference: &[Decimal]) -> f64 {
    assert_eq!(found.len(), reference.len());
    let largest = reference.iter().map(|entry| entry.value.abs()).fold(0.0, f64::max);
    let error = found.iter().zip(reference).map(|(x, entry)| entry.error_of(*x)).fold(0.0, worse);
    if largest == 0.0 { error } else { error / largest }
}

/// The greater of the two; NaN if either is NaN.
#[must_use]
pub fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}
