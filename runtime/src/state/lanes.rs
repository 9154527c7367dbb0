//! Conversions between a state of several lanes and the states of single lanes.

use super::{Extrapolation, State, Values};
use crate::number::{DetSign, Real};

impl<T: Real, const N: usize> State<T, N> {
    /// The state over another number type, converted number by number, on the given branch. It counts as not solved.
    #[doc(hidden)]
    #[must_use]
    pub fn map<U: Real>(&self, of: impl Fn(T) -> U, branch: [DetSign; N]) -> State<U, N> {
        let Values { t, q, qd, qdd, condition, iterations, .. } = &self.values;
        let values = Values {
            t: of(*t),
            q: q.map(&of),
            qd: qd.map(&of),
            qdd: qdd.map(&of),
            branch,
            condition: of(*condition),
            iterations: *iterations,
        };
        let extrapolation = Extrapolation { span: of(self.extrapolation.span), rest: self.extrapolation.rest.map(&of) };
        State { values, parameter_hash: 0, extrapolation }
    }

    /// Merges another state into this one, number by number. The branch is kept; of the two numbers of iterations the larger one is
    /// taken.
    #[doc(hidden)]
    pub fn merge<U: Real>(&mut self, other: &State<U, N>, merge: impl Fn(&mut T, U)) {
        let State { values: Values { t, q, qd, qdd, condition, iterations, .. }, extrapolation, .. } = self;
        merge(t, other.t);
        merge(condition, other.condition);
        merge(&mut extrapolation.span, other.extrapolation.span);
        *iterations = (*iterations).max(other.iterations);
        for (own, others) in [(q, &other.q), (qd, &other.qd), (qdd, &other.qdd), (&mut extrapolation.rest, &other.extrapolation.rest)] {
            own.iter_mut().zip(others.iter()).for_each(|(own, &other)| merge(own, other));
        }
    }
}
