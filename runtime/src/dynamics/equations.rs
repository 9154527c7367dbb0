//! Equations of motion, as emitted code provides them.

use nalgebra::{SMatrix, SVector};

use crate::linear::zeros;
use crate::names::Description;
use crate::number::Scalar;
use crate::state::State;

/// Equations of motion of a mechanism with `N` entries of its state, of which `I` are integrated, `M` equations between them and `R`
/// equations at t = 0. Emitted code implements it.
///
/// Vectors q, q̇ and q̈ have the `N` entries of the state; only the integrated ones are read.
pub trait Dynamics<T: Scalar, const N: usize, const I: usize, const M: usize, const R: usize>: Description<T, N> {
    /// Indices of the integrated coordinates.
    const INTEGRATED: [usize; I];

    /// True for an integrated coordinate in m.
    const IS_LENGTH: [bool; I];

    /// Names of the joints of the equations at t = 0, of which the first are those between integrated coordinates.
    const JOINTS: [&'static str; R];

    /// For each equation at t = 0: whether it counts between positions, and whether it counts between speeds.
    const LEVELS: [[bool; 2]; R];

    /// Number of redundant equations. Which ones depend on the others changes along the motion.
    const REDUNDANT: usize = 0;

    /// If there are any: the dimension of each equation at t = 0, as a power of a length.
    const POWERS: [u8; R] = [0; R];

    /// True if an equation between positions may have a kink, by `if`, `abs`, `min` or `max`. Kinks inside of functions in Rust are not seen.
    const HAS_KINKS: bool = false;

    /// The same of forces, which may also jump.
    const FORCES_HAVE_KINKS: bool = false;

    /// The mechanism with parameters between the declared defaults (λ = 0) and these (λ = 1); `None` if there are no parameters, or they are the
    /// defaults.
    fn interpolated(&self, _lambda: T) -> Option<Self>
    where
        Self: Sized,
    {
        None
    }

    /// Magnitude of the parameter by which the derivatives with this number are taken; 1 if it is 0.
    fn parameter_size(&self, _number: usize) -> T {
        T::of(1.0)
    }

    /// The mechanism with the parameter by which the derivatives with this number are taken changed by `change`, in SI; `None` if there are no
    /// parameters.
    fn varied(&self, _number: usize, _change: T) -> Option<Self>
    where
        Self: Sized,
    {
        None
    }

    /// Φ, J and ν. `found` holds zeros or the equations at another state: entries of J that are always zero are not written.
    fn constraints(&self, q: &SVector<T, N>, t: T, found: &mut Constraints<T, M, I>);

    /// The same for all equations that hold at t = 0.
    fn initial(&self, q: &SVector<T, N>, t: T, found: &mut Constraints<T, R, I>);

    /// By how much a state misses each equation at t = 0, the only function here that reads all its entries: Φ and J u − ν of the equations of freedoms, 0 for those between
    /// integrated coordinates.
    #[doc(hidden)]
    fn departures(&self, _q: &SVector<T, N>, _qd: &SVector<T, N>, _t: T) -> [SVector<T, R>; 2] {
        [zeros(), zeros()]
    }

    /// If a redundant equation does not hold: the joint of the equation with the largest residual, and this residual.
    fn misfit(&self, _q: &SVector<T, N>, _t: T) -> Option<(&'static str, T)> {
        None
    }

    /// The side of each kink on which the configuration is, one bit for each; kinks from the 65th on share bits.
    fn sides(&self, _q: &SVector<T, N>, _t: T) -> u64 {
        0
    }

    /// The same of the kinks of forces.
    fn sides_of_forces(&self, _q: &SVector<T, N>, _qd: &SVector<T, N>, _t: T) -> u64 {
        0
    }

    /// J, γ, M and f, written into zeros or into those of another state.
    fn balance(&self, q: &SVector<T, N>, qd: &SVector<T, N>, t: T, found: &mut Balance<T, M, I>);

    /// u̇ in closed form; `None` if that would be too long, and at configurations where its pivots are too small.
    fn accelerations(&self, _q: &SVector<T, N>, _qd: &SVector<T, N>, _t: T) -> Option<SVector<T, I>> {
        None
    }

    /// The whole state, from its integrated entries.
    fn complete(&self, q: &SVector<T, N>, qd: &SVector<T, N>, qdd: &SVector<T, N>, t: T) -> [SVector<T, N>; 3];

    /// Hash of the parameters.
    fn parameter_hash(&self) -> u64;

    /// True if the accelerations of a state are those of its positions, speeds and these parameters.
    fn is_current(&self, state: &State<T, N>) -> bool {
        state.parameter_hash == self.parameter_hash()
    }

    /// Energies and power in a state.
    fn energy(&self, q: &SVector<T, N>, qd: &SVector<T, N>, t: T) -> Energy<T>;
}

/// A mechanism whose configuration is determined by its drives at every instant; it has no freedoms.
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "`{Self}` has freedoms: forces decide where it is, and no instant can be solved by itself",
    note = "write `initial_state()` for the state at t = 0, and `advance` or `sweep` with an `Integrator` for the motion from there"
)]
pub trait Driven {}

/// Equations between positions and between speeds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constraints<T, const M: usize, const I: usize> {
    /// Φ; 0 for an equation between speeds.
    pub phi: SVector<T, M>,
    /// J, by integrated speed.
    pub jacobian: SMatrix<T, M, I>,
    /// ν
    pub nu: SVector<T, M>,
}

impl<T: Scalar, const M: usize, const I: usize> Constraints<T, M, I> {
    /// Zeros.
    #[inline(always)]
    #[must_use]
    pub fn zero() -> Self {
        Self { phi: zeros(), jacobian: zeros(), nu: zeros() }
    }
}

/// Equations between accelerations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Balance<T, const M: usize, const I: usize> {
    /// J, by integrated speed.
    pub jacobian: SMatrix<T, M, I>,
    /// γ
    pub gamma: SVector<T, M>,
    /// M; its lower triangle counts.
    pub mass: SMatrix<T, I, I>,
    /// f, M u̇ − Q at u̇ = 0.
    pub forces: SVector<T, I>,
}

impl<T: Scalar, const M: usize, const I: usize> Balance<T, M, I> {
    /// Zeros.
    #[inline(always)]
    #[must_use]
    pub fn zero() -> Self {
        Self { jacobian: zeros(), gamma: zeros(), mass: zeros(), forces: zeros() }
    }
}

/// Energies of a mechanism in a state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Energy<T> {
    /// Kinetic energy, in J.
    pub kinetic: T,
    /// Potential energy of gravity, of each `energy` declared, and of forces with a `potential`, as the springs of the library are, in J.
    pub potential: T,
    /// Power of the forces declared with `force`, less what is stored in their potentials, in W, and ∂V/∂t of a potential energy V that depends
    /// on time or on inputs. That of gravity is in the potential energy, that of drives in the loads.
    pub power: T,
}

impl<T: Scalar> Energy<T> {
    /// Kinetic and potential energy, in J: constant as long as drives and forces without a potential do no work.
    #[must_use]
    pub fn total(&self) -> T {
        self.kinetic + self.potential
    }
}
