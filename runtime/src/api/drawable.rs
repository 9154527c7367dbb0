//! States as pictures.

use reuleaux_picture::Scene;
use std::string::String;

use crate::state::State;

/// A mechanism whose states can be drawn: `#[picture]` before its declaration implements this trait.
///
/// ```
/// use reuleaux::mechanism;
/// use reuleaux::picture::Drawable;
///
/// mechanism! {
///     #[picture]
///     mechanism Pendulum {
///         body bob { point P = (1m, 0m); }
///         joint pivot = revolute(ground.position, bob.position);
///         drive swing = drive_angle(bob, -90deg + 1rad_s * t);
///     }
/// }
///
/// let pendulum = Pendulum::default();
/// let state = pendulum.solve(0.5)?;
/// let svg = pendulum.picture(&state);
/// assert!(svg.starts_with("<svg"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[diagnostic::on_unimplemented(message = "`{Self}` cannot be drawn at run time", note = "write `#[picture]` before its declaration")]
pub trait Drawable<T, const N: usize> {
    /// The mechanism at a state, with these parameters. The state need not be a solved one.
    fn scene(&self, state: &State<T, N>) -> Scene;

    /// The drawing of a state as inline SVG: at the defaults that of the type's page. Where there is nothing to draw, a sentence says why.
    fn picture(&self, state: &State<T, N>) -> String {
        self.scene(state).svg()
    }
}
