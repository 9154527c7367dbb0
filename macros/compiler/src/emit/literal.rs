//! Numbers as tokens, as a person would write them: without a suffix, very large and very small ones with an exponent.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// A whole number.
pub(crate) fn number(value: usize) -> TokenStream {
    let literal = Literal::usize_unsuffixed(value);
    quote!(#literal)
}

/// A double with its sign; one that is not finite is written as zero.
pub(super) fn signed(value: f64) -> TokenStream {
    let size = size(if value.is_finite() { value.abs() } else { 0.0 });
    if value.is_sign_negative() { quote!(-#size) } else { quote!(#size) }
}

/// A constant of the number type.
pub(super) fn real(value: f64) -> TokenStream {
    if value.is_nan() {
        return quote!(T::of(<::core::primitive::f64>::NAN));
    }
    if value.is_infinite() {
        let limit = if value > 0.0 { quote!(INFINITY) } else { quote!(NEG_INFINITY) };
        return quote!(T::of(<::core::primitive::f64>::#limit));
    }
    let value = signed(value);
    quote!(T::of(#value))
}

/// A double that is not negative, in the fewest digits that give it back.
fn size(value: f64) -> Literal {
    let literal = Literal::f64_unsuffixed(value);
    // `1e-17` rather than `0.00000000000000001`.
    let is_handy = value == 0.0 || (1e-6..1e16).contains(&value);
    if is_handy { literal } else { format!("{value:e}").parse().unwrap_or(literal) }
}

/// A vector of `n` numbers.
pub(crate) fn vector_type(n: usize) -> TokenStream {
    let n = number(n);
    quote!(::reuleaux::Vector<T, #n>)
}

/// A matrix of `m` rows and `n` columns.
pub(crate) fn matrix_type(m: usize, n: usize) -> TokenStream {
    let (m, n) = (number(m), number(n));
    quote!(::reuleaux::Matrix<T, #m, #n>)
}
