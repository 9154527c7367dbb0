//! Dense matrices of registers: pivots differ from lane to lane, so that each lane has its own factors.

use nalgebra::{SMatrix, SVector};
use reuleaux::{DetSign, Factors, Float, Linear, Real};

use super::Wide;
use super::register::matrix_of_lane;

/// The factors of each lane's matrix; None where it is not finite.
#[derive(Clone, Copy, Debug)]
pub struct LaneFactors<W: Wide<L>, const K: usize, const L: usize>([Option<Factors<W::Lane, K>>; L]);

impl<W: Wide<L>, const K: usize, const L: usize> LaneFactors<W, K, L> {
    /// Applies a function to the factors of each lane, with a default where there are none.
    fn each<R>(&self, what: impl Fn(usize, &Factors<W::Lane, K>) -> R, without: impl Fn() -> R) -> [R; L] {
        core::array::from_fn(|lane| self.0[lane].as_ref().map_or_else(&without, |factors| what(lane, factors)))
    }

    fn each_solution(
        &self,
        b: &SVector<W, K>,
        solve: impl Fn(&Factors<W::Lane, K>, &SVector<W::Lane, K>) -> SVector<W::Lane, K>,
    ) -> SVector<W, K> {
        let nothing = || SVector::from_element(Real::of(f64::NAN));
        let lanes = self.each(|lane, factors| solve(factors, &b.map(|entry| entry.to_lanes()[lane])), nothing);
        SVector::from_fn(|k, _| W::from_lanes(core::array::from_fn(|lane| lanes[lane][k])))
    }
}

impl<W: Wide<L>, const K: usize, const L: usize> Linear<W, K> for LaneFactors<W, K, L> {
    type Matrix = SMatrix<W, K, K>;

    fn factor(matrix: &SMatrix<W, K, K>) -> Result<Self, usize> {
        Ok(Self(core::array::from_fn(|lane| Factors::factor(&matrix_of_lane(matrix, lane)).ok())))
    }

    fn dense(matrix: &SMatrix<W, K, K>) -> SMatrix<W, K, K> {
        *matrix
    }

    fn solve_regular(&self, b: &SVector<W, K>) -> SVector<W, K> {
        self.each_solution(b, Factors::solve)
    }

    fn solve(&self, b: &SVector<W, K>) -> SVector<W, K>
    where
        W: Float,
    {
        self.solve_regular(b)
    }

    fn solve_refined(&self, b: &SVector<W, K>) -> SVector<W, K> {
        self.each_solution(b, Factors::solve_refined)
    }

    fn error_amplification(&self, sizes: &SVector<W, K>, reciprocals: &SVector<W, K>) -> W {
        let of_lane = |vector: &SVector<W, K>, lane: usize| vector.map(|entry| entry.to_lanes()[lane]);
        let amplification =
            |lane: usize, factors: &Factors<W::Lane, K>| factors.error_amplification(&of_lane(sizes, lane), &of_lane(reciprocals, lane));
        W::from_lanes(self.each(amplification, || Real::of(f64::NAN)))
    }

    fn det_sign(&self) -> W::Signs {
        W::from_signs(self.each(|_, factors| Linear::det_sign(factors), || DetSign::Positive))
    }

    fn is_regular(&self) -> W::Mask {
        W::mask_from_lanes(self.each(|_, factors| Linear::is_regular(factors), || false))
    }
}
