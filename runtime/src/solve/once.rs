//! Cold starts of blocks of one to three unknowns, the most frequent ones. They are compiled with this crate, once for each size and
//! number type.
//!
//! Rust compiles a generic function where its types become known, which is in the crate of the user, for each mechanism. So functions of
//! known types stand here, and the types of a block are compared with theirs.

use core::any::Any;

use nalgebra::{SMatrix, SVector};

use super::block::{self, Outcome, Start};
use crate::linear::{Linear, Small};
use crate::newton::{Iterate, Part, Scale, StepError};
use crate::number::Float;

/// The functions that are compiled here, and the choice among them.
macro_rules! compiled {
    ($($function:ident: $float:ident, $size:literal;)*) => {
        $(
            fn $function(
                part: &Part<'_, $float, Small<$float, $size>, $size>,
                start: &Start<$float, $size>,
            ) -> Outcome<$float, Small<$float, $size>, $size> {
                block::solved(part, start)
            }
        )*

        /// Solves a block.
        pub(super) fn solved<T: Float, L: Linear<T, K>, const K: usize>(part: &Part<'_, T, L, K>, start: &Start<T, K>) -> Outcome<T, L, K> {
            // The conditions are constants, so that the last line is compiled for other blocks only.
            $(
                if const { L::IS_SMALL && K == $size && T::IS_PRIMITIVE && size_of::<T>() == size_of::<$float>() } {
                    return known(part, start, $function).unwrap_or(Err(StepError::Far));
                }
            )*
            block::solved(part, start)
        }
    };
}

compiled! {
    one: f64, 1;
    two: f64, 2;
    three: f64, 3;
    one_single: f32, 1;
    two_single: f32, 2;
    three_single: f32, 3;
}

/// A cold start that is compiled here.
type Compiled<F, const S: usize> = fn(&Part<'_, F, Small<F, S>, S>, &Start<F, S>) -> Outcome<F, Small<F, S>, S>;

/// The outcome of `solve`, if T, L and K are F, `Small<F, S>` and S.
fn known<T: Float, L: Linear<T, K>, F: Float, const K: usize, const S: usize>(
    part: &Part<'_, T, L, K>,
    start: &Start<T, K>,
    solve: Compiled<F, S>,
) -> Option<Outcome<T, L, K>> {
    let evaluate = |iterate: &Iterate<F, S>| {
        let linearized = same(iterate).and_then(|iterate| owned((part.evaluate)(iterate)));
        linearized.unwrap_or_else(|| (SVector::from_element(F::of(f64::NAN)), SMatrix::from_element(F::of(f64::NAN))))
    };
    let known: Part<'_, F, Small<F, S>, S> = Part {
        evaluate: &evaluate,
        block: same(part.block)?,
        scale: same::<_, Scale<F, S>>(&part.scale)?.clone(),
        sizes: *same(&part.sizes)?,
        rows: part.rows,
        coordinates: part.coordinates,
    };
    owned(solve(&known, same(start)?))
}

/// A reference to A as one to B, if both are one type.
fn same<A: Any, B: Any>(value: &A) -> Option<&B> {
    (value as &dyn Any).downcast_ref()
}

/// A value of type A as one of type B, if both are one type.
fn owned<A: Any, B: Any>(value: A) -> Option<B> {
    (&mut Some(value) as &mut dyn Any).downcast_mut::<Option<B>>()?.take()
}
