//! States as pictures.

use reuleaux_picture::Scene;
#[cfg(feature = "view")]
use reuleaux_view::View;
use std::string::String;

#[cfg(feature = "view")]
use super::outputs::Outputs;
#[cfg(feature = "view")]
use crate::number::Float;
use crate::state::{HasState, State};

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
/// let svg = pendulum.picture(&pendulum.solve(0.5)?);
/// assert!(svg.starts_with("<svg"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait Drawable<T, const N: usize>: Sketch<T, N> {
    /// The scene of a state with these parameters. The state need not be solved.
    fn scene(&self, state: &impl HasState<T, N>) -> Scene {
        self.sketch(state.as_state())
    }

    /// The drawing of a state as inline SVG; at the defaults, the drawing on the type's page. If it cannot be drawn, a sentence with the
    /// reason.
    fn picture(&self, state: &impl HasState<T, N>) -> String {
        self.scene(state).svg()
    }

    /// An animated picture of states in the order of their times: a page with plots, or an SVG; see [`View`].
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
    ///         drive swing = drive_angle(bob, -90deg + 1rad * sin(t * 2rad_s));
    ///         output P = bob.P;
    ///     }
    /// }
    ///
    /// let pendulum = Pendulum::default();
    /// let states = pendulum.sweep((0..60).map(|step| f64::from(step) * 0.05)).collect::<Result<Vec<_>, _>>()?;
    /// let view = pendulum
    ///     .view(states)
    ///     .trace("path of P", |state| pendulum.P(state).value)
    ///     .plot("angle", "°", |state| state.bob().angle.to_degrees());
    /// assert!(view.to_html()?.contains("<title>Pendulum</title>"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// The states may be those of `sweep` and `advance`, or references to a [`State`].
    #[cfg(feature = "view")]
    fn view<S>(&self, states: impl IntoIterator<Item = S>) -> View<S>
    where
        S: Shown<T, N>,
        T: Float,
        Self: Sized,
    {
        let states: std::vec::Vec<S> = states.into_iter().collect();
        let title: String = states.first().map(|state| self.sketch(state).name().into()).unwrap_or_default();
        View::new(&title, states, |state| state.t.to_f64(), |state| self.sketch(state))
    }

    /// As [`view`](Self::view), with diagrams of all outputs, for a mechanism that is declared with `#[outputs]` as well: lengths in mm, angles in
    /// degrees, and components of the same output and unit in one diagram. Third derivatives are not shown.
    ///
    /// ```
    /// use reuleaux::mechanism;
    /// use reuleaux::picture::Drawable;
    ///
    /// mechanism! {
    ///     #[picture]
    ///     #[outputs]
    ///     mechanism Crank {
    ///         body crank { point A = (50mm, 0mm); }
    ///         joint axle = revolute(ground.position, crank.position);
    ///         drive motor = drive_angle(crank, 60rpm * t);
    ///         output angle = crank.angle;
    ///         output pin = crank.A;
    ///     }
    /// }
    ///
    /// let crank = Crank::default();
    /// let states = crank.sweep((0..60).map(|step| f64::from(step) / 60.0)).collect::<Result<Vec<_>, _>>()?;
    /// let page = crank.view_outputs(states).to_html()?;
    /// assert!(page.contains("pin.x") && page.contains("pin.y"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[cfg(feature = "view")]
    fn view_outputs<const K: usize>(&self, states: impl IntoIterator<Item = Self::State>) -> View<Self::State>
    where
        Self: Outputs<T, N, K> + Sized,
        T: Float,
    {
        let mut view = self.view(states);
        for (index, component) in Self::OUTPUTS.0.iter().enumerate() {
            let (unit, per_unit) = shown(component.units[0]);
            let of = |state: &Self::State| self.outputs(state)[index].value.to_f64() * per_unit;
            let is_of_diagram = index.checked_sub(1).is_some_and(|before| {
                let before = &Self::OUTPUTS.0[before];
                before.units[0] == component.units[0] && output(before.name) == output(component.name)
            });
            view = if is_of_diagram { view.and(component.name, of) } else { view.plot(component.name, unit, of) };
        }
        view
    }
}

/// The unit of diagrams for a unit of outputs, and how many of it these are.
#[cfg(feature = "view")]
fn shown(unit: &str) -> (&str, f64) {
    match unit {
        "m" => ("mm", 1e3),
        "rad" => ("°", 1_f64.to_degrees()),
        unit => (unit, 1.0),
    }
}

/// The output of a component, `tip` of `tip.x`; the names of outputs of parts have dots of their own.
#[cfg(feature = "view")]
fn output(component: &str) -> &str {
    match component.rsplit_once('.') {
        Some((output, "x" | "y" | "z" | "angle")) => output,
        Some((output, entry)) if entry.len() == 3 && entry.starts_with('a') && entry[1..].parse::<u8>().is_ok() => output,
        _ => component,
    }
}

impl<M: Sketch<T, N>, T, const N: usize> Drawable<T, N> for M {}

/// The scene of each state of a mechanism, which the macro generates.
#[doc(hidden)]
#[diagnostic::on_unimplemented(message = "`{Self}` cannot be drawn at run time", note = "write `#[picture]` before its declaration")]
pub trait Sketch<T, const N: usize> {
    fn sketch(&self, state: &State<T, N>) -> Scene;
}

/// A state of any mechanism with `N` coordinates, or a reference to one.
#[cfg(feature = "view")]
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no state that can be shown",
    note = "a sweep gives a `Result` for each time: write `sweep(…).collect::<Result<Vec<_>, _>>()?`"
)]
pub trait Shown<T, const N: usize>: core::ops::Deref<Target = State<T, N>> {}

#[cfg(feature = "view")]
impl<S: core::ops::Deref<Target = State<T, N>>, T, const N: usize> Shown<T, N> for S {}
