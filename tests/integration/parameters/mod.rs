//! Parameters far from their defaults, and invalid parameters.

mod bounds;
mod far;
mod signs;
