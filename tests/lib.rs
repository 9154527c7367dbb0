//! Shared parts of the tests: reference numbers, declarations that both the compiler and its interpreter read, and the comparison of
//! doubles with decimal strings.

pub mod common {
    //! Reading, declaring, evaluating.

    pub mod all;
    pub mod decimal;
    pub mod declared;
    pub mod interpreter;
    pub mod reference;
    pub mod text;
    pub mod twofold;
}
mod samples;

pub mod blocks;
pub mod branches;
pub mod laws;
pub mod library;
pub mod mechanisms;
// Parameters have capitals, as points do: rustc must not warn about them.
#[deny(non_snake_case)]
pub mod stress;
pub mod units;

pub use samples::samples;
