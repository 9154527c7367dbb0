//! What becomes of parameters that are far from their defaults, or where they make no sense.

mod bounds;
mod far;
