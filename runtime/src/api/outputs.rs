//! All outputs of a mechanism as one list of numbers, with their names and units.

use core::ops::Deref;

use nalgebra::SVector;

use crate::number::Real;
use crate::state::{Motion, MotionWithJerk, PlanarBody, SpatialBody, State, ValueAndRate};

/// A mechanism of `N` coordinates whose outputs have `K` components altogether: `#[outputs]` before its declaration implements this trait.
///
/// ```
/// use reuleaux::{Mechanism, Motion, Outputs, mechanism};
///
/// mechanism! {
///     #[outputs]
///     mechanism Crank {
///         param length: Length = 2m;
///         body crank { point A = (length, 0m); }
///         joint pivot = revolute(ground.position, crank.position);
///         drive motor = drive_angle(crank, 1rad_s * t);
///         output angle = crank.angle;
///         output pin = crank.A;
///     }
/// }
///
/// const PIN_Y: usize = Crank::<f64>::OUTPUTS.index("pin.y").unwrap();      // a compile error if there is no `pin.y`
///
/// let crank = Crank::default();
/// let state = crank.solve(0.0)?;
/// let outputs: [Motion<f64>; 3] = crank.outputs(&state);
/// assert_eq!(outputs[PIN_Y], Motion::new(0.0, 2.0, 0.0));
///
/// // The same index in derivatives: ∂ẏ/∂length = 1.
/// let (varied, state) = crank.derivatives(&state, |crank| [&mut crank.length])?;
/// assert_eq!(varied.outputs(&CrankState(state))[PIN_Y].rate.by, [1.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[diagnostic::on_unimplemented(message = "`{Self}` has no list of its outputs", note = "write `#[outputs]` before its declaration")]
pub trait Outputs<T, const N: usize, const K: usize> {
    /// The generated state.
    type State: Deref<Target = State<T, N>>;

    /// Names and units of the components, in the order of [`outputs`](Self::outputs).
    const OUTPUTS: OutputNames<K>;

    /// The components of all outputs in the order of their declaration, each with its first three derivatives in time.
    ///
    /// A point has the components x and y, and z in space; a body x, y and its angle, in space x, y, z and its direction cosines. An output
    /// that contains velocities has no acceleration, and one declared without `with jerk` has no third derivative: there they are NaN.
    fn outputs_with_jerk(&self, state: &Self::State) -> [MotionWithJerk<T>; K];

    /// As [`outputs_with_jerk`](Self::outputs_with_jerk), without the third derivative.
    fn outputs(&self, state: &Self::State) -> [Motion<T>; K] {
        self.outputs_with_jerk(state).map(MotionWithJerk::motion)
    }
}

/// Names and units of the components of outputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OutputNames<const K: usize>(pub [OutputName; K]);

/// Name and units of one component of an output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct OutputName {
    /// The output and its component: `"tip.x"`.
    pub name: &'static str,
    /// The units of value, rate, acceleration and jerk; empty for a pure number, [`NO_UNIT`](Self::NO_UNIT) for a derivative that the output
    /// does not have.
    pub units: [&'static str; 4],
}

impl OutputName {
    /// In place of the unit of a derivative that an output does not have.
    pub const NO_UNIT: &'static str = "\u{2013}";

    /// True if the output has an acceleration: it contains no velocities.
    #[must_use]
    pub const fn has_acceleration(&self) -> bool {
        self.has(2)
    }

    /// True if the output has a third derivative: it is declared `with jerk`.
    #[must_use]
    pub const fn has_jerk(&self) -> bool {
        self.has(3)
    }

    /// True if the output has the derivative of this order.
    const fn has(&self, order: usize) -> bool {
        !is_same(self.units[order].as_bytes(), Self::NO_UNIT.as_bytes())
    }
}

impl<const K: usize> OutputNames<K> {
    /// The index of a component, by its name.
    #[must_use]
    pub const fn index(&self, name: &str) -> Option<usize> {
        let mut index = 0;
        while index < K {
            if is_same(self.0[index].name.as_bytes(), name.as_bytes()) {
                return Some(index);
            }
            index += 1;
        }
        None
    }
}

/// Comparison in constants.
const fn is_same(a: &[u8], b: &[u8]) -> bool {
    if a.len() != b.len() {
        return false;
    }
    let mut index = 0;
    while index < a.len() {
        if a[index] != b[index] {
            return false;
        }
        index += 1;
    }
    true
}

/// The result of a generated method for an output.
#[doc(hidden)]
pub trait Output<T> {
    /// Visits its components in order. Derivatives that it does not have are NaN.
    fn each(&self, visit: &mut dyn FnMut(MotionWithJerk<T>));
}

/// A list of the components that are visited.
#[doc(hidden)]
pub fn listed<T: Real, const K: usize>(visit: impl FnOnce(&mut dyn FnMut(MotionWithJerk<T>))) -> [MotionWithJerk<T>; K] {
    let mut list = [Motion::at(T::of(0.0)).with_jerk(T::of(0.0)); K];
    let mut places = list.iter_mut();
    visit(&mut |component| {
        if let Some(place) = places.next() {
            *place = component;
        }
    });
    list
}

impl<T: Real> Output<T> for MotionWithJerk<T> {
    fn each(&self, visit: &mut dyn FnMut(MotionWithJerk<T>)) {
        visit(*self);
    }
}

impl<T: Real> Output<T> for Motion<T> {
    fn each(&self, visit: &mut dyn FnMut(MotionWithJerk<T>)) {
        visit(self.with_jerk(T::of(f64::NAN)));
    }
}

impl<T: Real> Output<T> for ValueAndRate<T> {
    fn each(&self, visit: &mut dyn FnMut(MotionWithJerk<T>)) {
        Motion { value: self.value, rate: self.rate, acceleration: T::of(f64::NAN) }.each(visit);
    }
}

impl<T: Real, const D: usize> Output<T> for MotionWithJerk<SVector<T, D>> {
    fn each(&self, visit: &mut dyn FnMut(MotionWithJerk<T>)) {
        for i in 0..D {
            visit(MotionWithJerk { value: self.value[i], rate: self.rate[i], acceleration: self.acceleration[i], jerk: self.jerk[i] });
        }
    }
}

impl<T: Real, const D: usize> Output<T> for Motion<SVector<T, D>> {
    fn each(&self, visit: &mut dyn FnMut(MotionWithJerk<T>)) {
        for i in 0..D {
            Motion { value: self.value[i], rate: self.rate[i], acceleration: self.acceleration[i] }.each(visit);
        }
    }
}

impl<T: Real, const D: usize> Output<T> for ValueAndRate<SVector<T, D>> {
    fn each(&self, visit: &mut dyn FnMut(MotionWithJerk<T>)) {
        for i in 0..D {
            ValueAndRate { value: self.value[i], rate: self.rate[i] }.each(visit);
        }
    }
}

impl<T: Real> Output<T> for PlanarBody<T> {
    fn each(&self, visit: &mut dyn FnMut(MotionWithJerk<T>)) {
        Motion { value: self.position, rate: self.velocity, acceleration: self.acceleration }.each(visit);
        Motion { value: self.angle, rate: self.angular_velocity, acceleration: self.angular_acceleration }.each(visit);
    }
}

impl<T: Real> Output<T> for SpatialBody<T> {
    fn each(&self, visit: &mut dyn FnMut(MotionWithJerk<T>)) {
        Motion { value: self.position, rate: self.velocity, acceleration: self.acceleration }.each(visit);
        let (zero, one) = (T::of(0.0), T::of(1.0));
        let columns = [[one, zero, zero], [zero, one, zero], [zero, zero, one]].map(|axis| self.vector(axis.into()));
        for i in 0..3 {
            for Motion { value, rate, acceleration } in &columns {
                Motion { value: value[i], rate: rate[i], acceleration: acceleration[i] }.each(visit);
            }
        }
    }
}

impl<T, O: Output<T>, const L: usize> Output<T> for [O; L] {
    fn each(&self, visit: &mut dyn FnMut(MotionWithJerk<T>)) {
        for one in self {
            one.each(visit);
        }
    }
}
