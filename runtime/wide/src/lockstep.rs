//! Mechanisms of one declaration that advance together.

use nalgebra::SVector;
use reuleaux::for_lanes::step_lanes;
use reuleaux::{DetSign, Failure, Family, Mask, Mechanism, Stages, State};

use super::Wide;

/// `L` mechanisms of one declaration, one in each lane of `W`, with the states they have reached.
///
/// Four crank lengths along the same times:
///
/// ```
/// use reuleaux::Real as _;
/// use reuleaux_wide::{F64x4, Lockstep};
///
/// reuleaux::mechanism! {
///     /// A crank-rocker with a crank of any length.
///     mechanism CrankRocker {
///         param crank_length: Length = 100mm;
///         ground { point O = (0mm, 0mm);  point C = (400mm, 0mm); }
///         body crank   { point O = (0mm, 0mm);  point A = (crank_length, 0mm); }
///         body coupler { point A = (0mm, 0mm);  point B = (350mm, 0mm); }
///         body rocker  { point C = (0mm, 0mm);  point B = (300mm, 0mm);  start angle = 70deg; }
///         joint o = revolute(ground.O, crank.O);
///         joint a = revolute(crank.A, coupler.A);
///         joint b = revolute(coupler.B, rocker.B);
///         joint c = revolute(rocker.C, ground.C);
///         drive input = drive_angle(crank, 60rpm * t);
///         output pin = rocker.B;
///     }
/// }
///
/// let cranks = [0.08, 0.1, 0.12, 0.14].map(|crank_length| CrankRocker { crank_length });
/// let mut four = Lockstep::<_, F64x4, 4, 9>::new(cranks, [0.0; 4]);
/// let mut highest = F64x4::splat(0.0);
/// for step in 1..=200 {
///     four.advance([f64::from(step) / 200.0; 4]);
///     // Outputs are computed for all lanes at once as well.
///     let pin = four.mechanism().pin(&CrankRockerState(four.state().clone()));
///     highest = highest.max(pin.value.y);
/// }
/// assert!((0..4).all(|lane| four.lane(lane).is_ok()));
/// assert!(highest.to_array().iter().all(|height| *height > 0.25 && *height <= 0.3));
/// ```
///
/// One mechanism at four times is the same with four times and the same mechanism four times:
/// `Lockstep::new([mechanism; 4], [0.0, 0.25, 0.5, 0.75])`.
#[derive(Clone, Debug)]
pub struct Lockstep<M: Family<W::Lane>, W: Wide<L>, const L: usize, const N: usize> {
    each: [M; L],
    wide: M::Over<W>,
    state: State<W, N>,
    branches: [W::Signs; N],
    /// The lanes that have not failed.
    moving: W::Mask,
    ended: [Option<Failure<W::Lane, N>>; L],
}

impl<M, W, const L: usize, const N: usize> Lockstep<M, W, L, N>
where
    M: Family<W::Lane> + Mechanism<W::Lane, N>,
    M::Over<W>: Stages<W, N>,
    W: Wide<L>,
{
    /// Assembles each mechanism at its own time (s), as [`Mechanism::solve`] does.
    #[must_use]
    pub fn new(each: [M; L], times: [W::Lane; L]) -> Self {
        let wide = M::gather(each.each_ref(), W::from_lanes);
        let nothing = SVector::from_element(W::of(f64::NAN));
        let (state, ended) = (State::new(W::from_lanes(times), nothing, nothing, nothing), core::array::from_fn(|_| None));
        let mut this = Self { each, wide, state, branches: [W::from_signs([DetSign::Positive; L]); N], moving: W::Mask::of(true), ended };
        for (lane, t) in times.into_iter().enumerate() {
            match this.each[lane].solve(t) {
                Ok(state) => this.put(lane, &state),
                Err(failure) => this.end(lane, failure),
            }
        }
        this
    }

    /// Advances each mechanism to its own time (s), on its branch. One that fails keeps its last state and does not move again;
    /// [`lane`](Self::lane) returns the reason.
    #[inline]
    pub fn advance(&mut self, times: [W::Lane; L]) {
        let t = W::from_lanes(times);
        let found = step_lanes(&self.wide, &mut self.state, &self.branches, t, self.moving);
        if !found.all() {
            self.finish(times, W::mask_to_lanes(found));
        }
    }

    /// Ends a lane with a failure.
    fn end(&mut self, lane: usize, failure: Failure<W::Lane, N>) {
        self.ended[lane] = Some(failure);
        self.moving = W::mask_from_lanes(self.ended.each_ref().map(Option::is_none));
    }

    /// Advances one by one the mechanisms whose warm step failed.
    #[cold]
    #[inline(never)]
    fn finish(&mut self, times: [W::Lane; L], found: [bool; L]) {
        for lane in 0..L {
            if found[lane] || self.ended[lane].is_some() {
                continue;
            }
            let mut state = self.pick(lane);
            match self.each[lane].advance(&mut state, times[lane]) {
                Ok(()) => self.put(lane, &state),
                Err(failure) => self.end(lane, failure),
            }
        }
    }

    /// The mechanism of all lanes, for its outputs.
    pub const fn mechanism(&self) -> &M::Over<W> {
        &self.wide
    }

    /// The states of all lanes, for outputs; a lane that has ended keeps its last state, or NaN if it had none. Its `branch` is
    /// that of
    /// the first lane.
    pub const fn state(&self) -> &State<W, N> {
        &self.state
    }

    /// The state of one lane, or why it has ended.
    ///
    /// # Errors
    /// The failure that ended it.
    ///
    /// # Panics
    /// If there is no such lane.
    pub fn lane(&self, lane: usize) -> Result<State<W::Lane, N>, &Failure<W::Lane, N>> {
        self.ended[lane].as_ref().map_or_else(|| Ok(self.pick(lane)), Err)
    }

    fn pick(&self, lane: usize) -> State<W::Lane, N> {
        self.state.map(|number| number.to_lanes()[lane], self.branches.map(|signs| W::to_signs(signs)[lane]))
    }

    fn put(&mut self, lane: usize, from: &State<W::Lane, N>) {
        self.state.merge(from, |number: &mut W, value| {
            let mut lanes = number.to_lanes();
            lanes[lane] = value;
            *number = W::from_lanes(lanes);
        });
        for (signs, side) in self.branches.iter_mut().zip(from.branch) {
            let mut lanes = W::to_signs(*signs);
            lanes[lane] = side;
            *signs = W::from_signs(lanes);
        }
        if lane == 0 {
            self.state.branch = from.branch;
        }
    }
}
