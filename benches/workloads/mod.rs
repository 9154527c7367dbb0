//! The mechanisms that are measured, a page each: its declaration, the same as data, and what one would write by hand for it.
//!
//! W1 to W4 fall into blocks of two unknowns at most. The last two do not fall apart at all.

mod cams;
mod chain;
mod four_bar;
mod hexagon;
mod jansen;
mod six_bar;
mod slider_crank;

pub use cams::cams;
pub use chain::Chain10;
pub use four_bar::FourBar;
pub use jansen::Jansen;
pub use slider_crank::SliderCrank;

use crate::contender::{Contender, Entry};
use crate::linkage::Linkage;

/// Makes a contender.
pub type Make = fn() -> Box<dyn Contender>;

/// A mechanism and everything that follows it.
pub struct Workload {
    /// As data.
    pub linkage: Linkage,
    /// The mechanism generated from its declaration.
    pub generated: Make,
    /// How that one is solved.
    pub plan: fn() -> reuleaux::Plan,
    /// All contenders; ratios are to the first.
    pub contenders: fn(&Linkage) -> Vec<Entry>,
}

/// Names of contenders, which the table and the picture share.
pub mod name {
    /// Generated from the declaration.
    pub const GENERATED: &str = "reuleaux";
    /// `mechanism!`, for the tracked point alone.
    pub const ALONE: &str = "reuleaux, the output alone";
    /// By hand, nothing iterated.
    pub const CLOSED: &str = "dyads in closed form";
    /// By hand, nothing iterated, with the angles of all bodies.
    pub const CLOSED_WHOLE: &str = "dyads in closed form, all bodies";
    /// By hand, iterated.
    pub const ANGLES: &str = "Newton on the loop angles";
    /// All coordinates.
    pub const ABSOLUTE_PREDICTED: &str = "absolute coordinates, LU, predictor";
    /// All coordinates, from the position before.
    pub const ABSOLUTE: &str = "absolute coordinates, LU";
    /// A sketch solver.
    pub const EZPZ: &str = "ezpz";
}

/// Residuals in m or rad at which the Newton contenders stop.
const TOLERANCES: [f64; 3] = [1e-4, 1e-8, 1e-12];

/// All workloads.
#[must_use]
pub fn all() -> Vec<Workload> {
    let mut all = vec![four_bar::workload(), slider_crank::workload(), jansen::workload()];
    all.extend(chain::workloads());
    all.extend([six_bar::workload(), hexagon::workload()]);
    all
}

/// A contender of the generated mechanism, its plan, and Newton's method on all of its coordinates.
macro_rules! generated {
    ($mechanism:ident, $state:ident, $output:ident) => {
        fn generated() -> Box<dyn $crate::contender::Contender> {
            let output = |mechanism: &$mechanism, state: &_| mechanism.$output(&$state(Clone::clone(state)));
            Box::new($crate::contender::Generated::new($mechanism::default(), output))
        }

        fn plan() -> reuleaux::Plan {
            $mechanism::<f64>::PLAN
        }
    };
}
pub(crate) use generated;

/// The generated one that solves only the unknowns upstream of the tracked point, whose components are the last in its state.
macro_rules! alone {
    ($mechanism:ident, $solve_for:ident) => {
        $crate::contender::Entry::new(
            $crate::workloads::name::ALONE,
            $crate::contender::Generated::new($mechanism::default().$solve_for(), |_, state| state.point(state.q.len() - 2)),
        )
    };
}
pub(crate) use alone;

/// The contenders that are made from the declaration: the generated one, and Newton's method on all of its coordinates.
macro_rules! declared {
    ($mechanism:ident, $state:ident, $output:ident, $solve_for:ident, $factor:ident) => {{
        use $crate::contender::Entry;
        use $crate::hand::{Absolute, $factor};
        use $crate::workloads::{TOLERANCES, name};
        let absolute = |is_predicted| {
            move |tolerance| {
                let output = |mechanism: &$mechanism, state: &_| mechanism.$output(&$state(Clone::clone(state)));
                Absolute::<$factor, _, _>::new($mechanism::default(), output, is_predicted, tolerance)
            }
        };
        let mut entries = vec![
            Entry { name: name::GENERATED, tolerance: None, contender: generated() },
            $crate::workloads::alone!($mechanism, $solve_for),
        ];
        entries.extend(Entry::each(name::ABSOLUTE_PREDICTED, &TOLERANCES, absolute(true)));
        entries.extend(Entry::each(name::ABSOLUTE, &TOLERANCES, absolute(false)));
        entries
    }};
}
pub(crate) use declared;

/// The sketch solver, where it is compiled in.
fn sketch(linkage: &Linkage) -> Vec<Entry> {
    #[cfg(feature = "ezpz")]
    return Entry::each(name::EZPZ, &TOLERANCES[1..], |tolerance| crate::sketch::Sketch::new(linkage.clone(), tolerance)).collect();
    #[cfg(not(feature = "ezpz"))]
    {
        let _ = linkage;
        Vec::new()
    }
}
