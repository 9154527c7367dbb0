//! What one would write by hand for one mechanism: dyads in closed form, Newton's method on the angles of loops, and Newton's
//! method on all coordinates with a matrix library.

mod absolute;
mod angles;
mod dyads;

pub use absolute::{Absolute, Dynamic, Static};
pub use angles::{Angles, Loops, Pair, Term};
pub use dyads::{Bar, Closed, Crank, Law, Point, Whole, dyad, fixed};
