//! Mechanisms declared for the compiler and, as text, for its interpreter.

use std::fmt::Debug;

use reuleaux::nalgebra::{SVector, Vector2};
use reuleaux::{Equations, Motion, Real};

/// A time, a configuration and its rates, in SI units.
#[derive(Clone, Debug, Default)]
pub struct Instant {
    /// t
    pub t: f64,
    /// q
    pub q: Vec<f64>,
    /// q̇
    pub qd: Vec<f64>,
    /// q̈; used by outputs only.
    pub qdd: Vec<f64>,
}

/// All equations of a mechanism, evaluated at an instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Rows {
    /// Φ
    pub phi: Vec<f64>,
    /// Φ_q, row by row.
    pub jacobian: Vec<Vec<f64>>,
    /// ν
    pub nu: Vec<f64>,
    /// γ
    pub gamma: Vec<f64>,
}

/// A declaration in both forms.
pub trait Declared: Copy + Debug {
    /// Tokens compiled by `mechanism!`.
    const TEXT: &'static str;

    /// The mechanism with its parameters set by name, in SI units.
    fn with(number: &mut dyn FnMut(&str) -> f64) -> Self;

    /// Number of equations and of coordinates.
    fn size() -> (usize, usize);

    /// The emitted Φ, Φ_q, ν, γ.
    fn rows(&self, at: &Instant) -> Rows;

    /// Stored entries of Φ_q with row and column.
    fn entries(&self, at: &Instant) -> Vec<((usize, usize), f64)>;

    /// Φ and Φ_q from the function that returns both.
    fn linearized(&self, at: &Instant) -> (Vec<f64>, Vec<Vec<f64>>);

    /// The emitted Φ over another number type.
    fn phi_over<T: Real>(&self, q: &[T], t: T) -> Vec<T>;

    /// Value, rate and acceleration of every component of every output, over any number type.
    fn outputs_over<T: Real>(&self, state: Moving<T>) -> Vec<[T; 3]>;

    /// Outputs in doubles.
    fn outputs(&self, at: &Instant) -> Vec<[f64; 3]> {
        self.outputs_over(Moving { t: at.t, q: at.q.clone(), qd: at.qd.clone(), qdd: at.qdd.clone() })
    }
}

/// A time and a configuration with first and second rates.
#[derive(Clone, Debug)]
pub struct Moving<T> {
    /// t
    pub t: T,
    /// q
    pub q: Vec<T>,
    /// q̇
    pub qd: Vec<T>,
    /// q̈
    pub qdd: Vec<T>,
}

/// Declares a mechanism for `mechanism!` and as text.
///
/// Parameters are single words for name, dimension and default; a mechanism with outputs names its state.
#[macro_export]
macro_rules! declared {
    ($(#[$($attribute:tt)*])* $name:ident ($($parameter:ident: $dim:tt = $default:tt),* $(,)?) { $($items:tt)* }
        $(outputs $state:ident { $($output:ident = [$($value:tt)*];)* })?
    ) => {
        ::reuleaux::mechanism! {
            $(#[$($attribute)*])*
            pub mechanism $name {
                $(param $parameter: $dim = $default;)*
                $($items)*
                $($(
                    /// An output.
                    slice output $output = $($value)*;
                )*)?
            }
        }
        #[allow(clippy::needless_update, unused_mut, unused_variables)]
        impl $crate::common::declared::Declared for $name {
            const TEXT: &'static str = stringify! {
                $(#[$($attribute)*])*
                pub mechanism $name {
                    $(param $parameter: $dim = $default;)*
                    $($items)*
                    $($(output $output = $($value)*;)*)?
                }
            };
            fn with(number: &mut dyn FnMut(&str) -> f64) -> Self {
                Self { $($parameter: number(stringify!($parameter)),)* ..Self::default() }
            }
            fn size() -> (usize, usize) {
                (Self::EQUATIONS, Self::COORDINATES)
            }
            fn rows(&self, at: &$crate::common::declared::Instant) -> $crate::common::declared::Rows {
                $crate::common::declared::rows(self, at)
            }
            fn entries(&self, at: &$crate::common::declared::Instant) -> Vec<((usize, usize), f64)> {
                let entries = self.jacobian_entries(&$crate::common::declared::vector(&at.q), at.t);
                Self::JACOBIAN_PATTERN.into_iter().zip(entries).collect()
            }
            fn linearized(&self, at: &$crate::common::declared::Instant) -> (Vec<f64>, Vec<Vec<f64>>) {
                $crate::common::declared::linearized(self, at)
            }
            fn phi_over<T: ::reuleaux::Real>(&self, q: &[T], t: T) -> Vec<T> {
                let lifted = $name::<T> { $($parameter: T::of(self.$parameter),)* ..$name::<T>::with_defaults() };
                $crate::common::declared::phi(&lifted, q, t)
            }
            fn outputs_over<T: ::reuleaux::Real>(&self, state: $crate::common::declared::Moving<T>) -> Vec<[T; 3]> {
                let lifted = $name::<T> { $($parameter: T::of(self.$parameter),)* ..$name::<T>::with_defaults() };
                let mut parts = Vec::new();
                $(
                    let state = $state($crate::common::declared::state(&state));
                    $(parts.extend($crate::common::declared::Parts::parts(lifted.$output(&state)));)*
                )?
                parts
            }
        }
    };
}

/// Components of an output.
pub trait Parts<T> {
    /// Value, rate and acceleration of each component.
    fn parts(self) -> Vec<[T; 3]>;
}

impl<T: Real> Parts<T> for Motion<T> {
    fn parts(self) -> Vec<[T; 3]> {
        vec![[self.value, self.rate, self.acceleration]]
    }
}

impl<T: Real> Parts<T> for Motion<Vector2<T>> {
    fn parts(self) -> Vec<[T; 3]> {
        [0, 1].map(|i| [self.value[i], self.rate[i], self.acceleration[i]]).into()
    }
}

/// A slice as a vector of its length.
#[must_use]
pub fn vector<T: Real, const N: usize>(values: &[T]) -> SVector<T, N> {
    assert_eq!(values.len(), N);
    SVector::from_fn(|i, _| values[i])
}

/// The emitted Φ, Φ_q, ν, γ.
pub fn rows<E: Equations<f64, M, N>, const M: usize, const N: usize>(mechanism: &E, at: &Instant) -> Rows {
    let (q, qd) = (vector(&at.q), vector(&at.qd));
    let jacobian = mechanism.jacobian(&q, at.t);
    Rows {
        phi: mechanism.phi(&q, at.t).as_slice().to_vec(),
        jacobian: jacobian.row_iter().map(|row| row.iter().copied().collect()).collect(),
        nu: mechanism.nu(&q, at.t).as_slice().to_vec(),
        gamma: mechanism.gamma(&q, &qd, at.t).as_slice().to_vec(),
    }
}

/// Φ and Φ_q from the function that returns both.
pub fn linearized<E: Equations<f64, M, N>, const M: usize, const N: usize>(mechanism: &E, at: &Instant) -> (Vec<f64>, Vec<Vec<f64>>) {
    let (phi, jacobian) = mechanism.linearize(&vector(&at.q), at.t);
    (phi.as_slice().to_vec(), jacobian.row_iter().map(|row| row.iter().copied().collect()).collect())
}

/// Φ over any number type.
pub fn phi<T: Real, E: Equations<T, M, N>, const M: usize, const N: usize>(mechanism: &E, q: &[T], t: T) -> Vec<T> {
    mechanism.phi(&vector(q), t).as_slice().to_vec()
}

/// An unsolved state at which outputs can be evaluated.
#[must_use]
pub fn state<T: Real, const N: usize>(at: &Moving<T>) -> reuleaux::State<T, N> {
    reuleaux::State::new(at.t, vector(&at.q), vector(&at.qd), vector(&at.qdd))
}
