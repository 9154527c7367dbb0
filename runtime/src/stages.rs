//! How a mechanism is solved: stage by stage, or all at once.

use nalgebra::SVector;

use crate::pass::{Pass, Stop};
use crate::problem::Block;
use crate::{Equations, Lanes, names};

/// Position, velocity and acceleration of all coordinates.
pub struct Coordinates<T, const N: usize> {
    /// q in m and rad.
    pub q: SVector<T, N>,
    /// q̇ in m/s and rad/s.
    pub qd: SVector<T, N>,
    /// q̈ in m/s² and rad/s².
    pub qdd: SVector<T, N>,
}

/// The way a mechanism is solved. Emitted code goes block by block; the provided way takes all equations as one system, and is
/// what a mechanism written by hand gets with an empty `impl`.
pub trait Stages<T: Lanes, const N: usize>: Equations<T, N, N> {
    /// The angles that are computed rather than iterated. Those that are iterated never go far in one step; of these it is checked
    /// that they came to where they were expected.
    const COMPUTED_ANGLES: &'static [usize] = &[];

    /// The unknowns that are iterated, of which a prediction is needed.
    const ITERATED: &'static [usize] = &ALL;

    /// The mechanism with parameters that are this share of the way from their declared defaults, for which
    /// [`start`](Equations::start) is assembled, to these. None if they are the defaults, or have none.
    fn toward(&self, share: T) -> Option<Self>
    where
        Self: Sized,
    {
        let _ = share;
        None
    }

    /// q, q̇ and q̈ at time `t` (s).
    ///
    /// # Errors
    /// Why there are none near what the pass sets out from.
    fn stages(&self, t: T, pass: &mut Pass<'_, T, N>) -> Result<Coordinates<T, N>, Stop<T>> {
        let all = core::array::from_fn(|index| index);
        let kinds = core::array::from_fn(|index| names::coordinate(Self::COORDINATES, index).kind);
        let block = Block { unknowns: all, equations: all, kinds, turns: [false; N] };
        let solved = pass.large(&block, [T::of(0.0); N], |place| {
            let (phi, jacobian) = self.linearize(&place.x, t);
            (phi.data.0[0], jacobian.transpose().data.0)
        })?;
        let q = SVector::from(solved.x);
        let rates = |b: SVector<T, N>| SVector::from(solved.rates(b.data.0[0]));
        let qd = rates(self.nu(&q, t));
        let qdd = rates(self.gamma(&q, &qd, t));
        Ok(Coordinates { q, qd, qdd })
    }
}

/// The first indices there are; those beyond the number of coordinates are passed over.
static ALL: [usize; MOST] = {
    let mut indices = [0; MOST];
    let mut index = 0;
    while index < MOST {
        indices[index] = index;
        index += 1;
    }
    indices
};

/// Of a mechanism written by hand, as many unknowns as this get a better prediction.
const MOST: usize = 256;
