//! Properties of every mechanism, tested at random states.

mod bits;
mod derivatives;
mod dual;
mod gradients;
mod invariance;
mod laws;
mod models;
mod random;
mod segments;
mod tables;
