//! Nested arrays of generated types.

use super::columns::Columns;
use super::expression::local;
use crate::plan::Column;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// `[[element; 3]; 6]` for sizes 6 and 3; the element itself without sizes.
pub(crate) fn array_type(element: TokenStream, sizes: &[usize]) -> TokenStream {
    sizes.iter().rev().fold(element, |inner, size| {
        let size = Literal::usize_unsuffixed(*size);
        quote!([#inner; #size])
    })
}

/// An array whose elements are computed; in `element` the number of the element is `piece`.
pub(super) fn array_of(element: TokenStream, sizes: &[usize]) -> TokenStream {
    let piece = local("piece");
    match sizes {
        [] => element,
        [_] => quote!(::core::array::from_fn(|#piece| #element)),
        _ => {
            let rounds: Vec<_> = (0..sizes.len()).map(|rank| local(&format!("i{rank}"))).collect();
            let mut number = quote!(0);
            for (round, size) in rounds.iter().zip(sizes) {
                let size = Literal::usize_unsuffixed(*size);
                number = quote!((#number) * #size + #round);
            }
            let inner = quote!({ let #piece = #number; #element });
            rounds.iter().rev().fold(inner, |inner, round| quote!(::core::array::from_fn(|#round| #inner)))
        }
    }
}

/// An array with an element for each place; `element` is given the place.
pub(super) fn array_at(places: &[usize], sizes: &[usize], element: impl Fn(TokenStream) -> TokenStream) -> TokenStream {
    if let ([], [place]) = (sizes, places) {
        let place = Literal::usize_unsuffixed(*place);
        return element(quote!(#place));
    }
    let mut columns = Columns::new(places.len());
    let place = columns.place(&Column::of(places.iter().map(|place| *place as u32).collect()));
    let (element, tables) = (element(place), columns.tables());
    if sizes.is_empty() || tables.is_empty() {
        return array_of(element, sizes);
    }
    array_of(quote!({ #tables #element }), sizes)
}

/// Elements in order as nested arrays; many equal ones are written once.
pub(super) fn array_from(elements: Vec<TokenStream>, sizes: &[usize]) -> TokenStream {
    let Some((size, inner)) = sizes.split_first() else { return elements.into_iter().next().unwrap_or_default() };
    let each = inner.iter().product::<usize>().max(1);
    let rows: Vec<TokenStream> = elements.chunks(each).map(|row| array_from(row.to_vec(), inner)).collect();
    let first = rows.first().map(TokenStream::to_string);
    if rows.len() > 1 && rows.iter().all(|row| Some(row.to_string()) == first) {
        let (first, size) = (&rows[0], Literal::usize_unsuffixed(*size));
        return quote!([#first; #size]);
    }
    quote!([#(#rows),*])
}
