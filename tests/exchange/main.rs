//! Data in and out: parameters, states and results as text.

mod attributes;
mod csv;
mod errors;
mod points;
mod serial;
