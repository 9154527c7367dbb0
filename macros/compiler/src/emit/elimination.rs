//! The elimination of a large block's Jacobian, in straight lines where these are not too long.
//!
//! Rows and columns go by the number of their pivot: `a_2_0` stands in the row of pivot 2 and the column of pivot 0, and becomes
//! `l_2_0`. Each number is written once, with all that is subtracted from it.

use super::expression::local;
use super::literal::number;
use crate::plan::Elimination;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

/// The runtime's trait `Elimination` for a type that is nothing but a block's order; of its unknowns these are lengths, and these are
/// quaternions.
pub(super) fn elimination(name: &Ident, is_length: Vec<bool>, elimination: &Elimination, quaternions: &[[usize; 4]]) -> TokenStream {
    let [k, entries, factors] = [elimination.rows.len(), elimination.pattern.len(), elimination.factors.len()].map(number);
    let order = order(elimination);
    let lines = EliminationPrinter { order: elimination, is_length };
    let lines = elimination.is_short().then(|| {
        let (eliminate, substitute, product) = (lines.eliminate(), lines.substitute(), lines.product());
        quote!(#eliminate #substitute #product)
    });
    let turns = (!quaternions.is_empty()).then(|| {
        let columns = quaternions.iter().map(|columns| {
            let columns = columns.map(Literal::usize_unsuffixed);
            quote!([#(#columns),*])
        });
        quote!(const QUATERNIONS: &'static [[::core::primitive::usize; 4]] = &[#(#columns),*];)
    });
    quote! {
        struct #name;
        impl<T: ::reuleaux::Real> ::reuleaux::Elimination<T, #k, #entries, #factors> for #name {
            const ORDER: ::reuleaux::Order<#k, #entries, #factors> = #order;
            #turns
            #lines
        }
    }
}

fn order(elimination: &Elimination) -> TokenStream {
    let pairs = |list: &[(usize, usize)]| -> Vec<TokenStream> {
        let pair = |(row, column): &(usize, usize)| {
            let (row, column) = (Literal::usize_unsuffixed(*row), Literal::usize_unsuffixed(*column));
            quote!((#row, #column))
        };
        list.iter().map(pair).collect()
    };
    let numbers = |list: &[usize]| -> Vec<Literal> { list.iter().map(|number| Literal::usize_unsuffixed(*number)).collect() };
    let (pattern, factors) = (pairs(&elimination.pattern), pairs(&elimination.factors));
    let (rows, columns) = (numbers(&elimination.rows), numbers(&elimination.columns));
    quote!(::reuleaux::Order { pattern: [#(#pattern),*], rows: [#(#rows),*], columns: [#(#columns),*], factors: [#(#factors),*] })
}

/// The three functions of one elimination.
struct EliminationPrinter<'a> {
    order: &'a Elimination,
    /// By unknown.
    is_length: Vec<bool>,
}

impl EliminationPrinter<'_> {
    fn eliminate(&self) -> TokenStream {
        let order = self.order;
        let k = order.rows.len();
        let given = order.pattern.iter().map(|place| order.place_of(*place).map(entry));
        let rows = (0..k).map(|i| {
            let (cells, watch) = (order.factors.iter().filter(|(row, _)| *row == i).map(|(_, j)| self.cell(i, *j)), self.watch(i));
            quote!(#(#cells)* #watch)
        });
        let lu = order.factors.iter().map(|place| factor(*place));
        let by_pivot = |stem: &str| -> Vec<Ident> { (0..k).map(|i| numbered(stem, i)).collect() };
        let pivots = (0..k).map(|i| self.weighed(&upper((i, i)), i));
        let (grown, sizes) = (by_pivot("grown"), by_pivot("size"));
        let [k, entries, factors] = [k, order.pattern.len(), order.factors.len()].map(number);
        quote! {
            #[inline(always)]
            fn eliminate(a: &[T; #entries], c: &[T; #k]) -> ::reuleaux::Eliminated<T, #k, #factors> {
                let [#(#given),*] = *a;
                #(#rows)*
                ::reuleaux::Eliminated { lu: [#(#lu),*], pivots: [#(#pivots),*], grown: [#(#grown),*], sizes: [#(#sizes),*] }
            }
        }
    }

    /// One entry of L or U.
    fn cell(&self, i: usize, j: usize) -> TokenStream {
        let is_entry = |i: usize, j: usize| self.order.factors.binary_search(&(i, j)).is_ok();
        let terms = (0..i.min(j)).filter(|k| is_entry(i, *k) && is_entry(*k, j)).map(|k| {
            let (lower, upper) = (lower((i, k)), upper((k, j)));
            quote!(#lower * #upper)
        });
        let terms: Vec<TokenStream> = terms.collect();
        let value = match (self.is_stored(i, j).then(|| entry((i, j))), terms.as_slice()) {
            (Some(entry), _) => quote!(#entry #(- #terms)*),
            (None, [first, rest @ ..]) => quote!(-(#first) #(- #rest)*),
            (None, []) => quote!(T::of(0.0)),
        };
        if j < i {
            let (name, pivot) = (lower((i, j)), numbered("p", j));
            let value = if terms.is_empty() { value } else { quote!((#value)) };
            return quote!(let #name = #value * #pivot;);
        }
        let name = upper((i, j));
        let reciprocal = (i == j).then(|| {
            let pivot = numbered("p", i);
            // 1 and −1 are their own reciprocals.
            if self.order.is_unit[i] { quote!(let #pivot = #name;) } else { quote!(let #pivot = T::of(1.0) / #name;) }
        });
        quote!(let #name = #value; #reciprocal)
    }

    /// The row of |U| c, that of |L| |U| c and that of |A| c.
    fn watch(&self, i: usize) -> TokenStream {
        let (row, grown, size) = (numbered("row", i), numbered("grown", i), numbered("size", i));
        let of_upper = std::iter::once(i).chain(self.order.row(i, false)).map(|j| self.weighed(&upper((i, j)), j));
        let multipliers: Vec<TokenStream> = self
            .order
            .row(i, true)
            .map(|k| {
                let (lower, row) = (lower((i, k)), numbered("row", k));
                quote!(#lower.abs() * #row)
            })
            .collect();
        let of_upper = quote!(let #row = #(#of_upper)+*;);
        if multipliers.is_empty() {
            return quote!(#of_upper let #grown = #row; let #size = #row;);
        }
        let of_matrix = self.order.factors.iter().filter(|(row, column)| *row == i && self.is_stored(i, *column));
        let of_matrix: Vec<TokenStream> = of_matrix.map(|(_, j)| self.weighed(&entry((i, *j)), *j)).collect();
        let of_matrix = if of_matrix.is_empty() { quote!(T::of(0.0)) } else { quote!(#(#of_matrix)+*) };
        quote!(#of_upper let #grown = #(#multipliers)+* + #row; let #size = #of_matrix;)
    }

    /// Its magnitude times the scale of the unknown of its column; the scale of an angle is 1.
    fn weighed(&self, name: &Ident, column: usize) -> TokenStream {
        let unknown = self.order.columns[column];
        let index = Literal::usize_unsuffixed(unknown);
        if self.is_length[unknown] { quote!(#name.abs() * c[#index]) } else { quote!(#name.abs()) }
    }

    fn is_stored(&self, i: usize, j: usize) -> bool {
        self.order.pattern.binary_search(&(self.order.rows[i], self.order.columns[j])).is_ok()
    }

    fn substitute(&self) -> TokenStream {
        let order = self.order;
        let k = order.rows.len();
        let lu = order.factors.iter().map(|place| factor(*place));
        let forward = (0..k).map(|i| {
            let (y, row) = (numbered("y", i), Literal::usize_unsuffixed(order.rows[i]));
            let known: Vec<TokenStream> = order.row(i, true).map(|k| times(&lower((i, k)), &numbered("y", k))).collect();
            if known.is_empty() { quote!(let #y = b[#row];) } else { quote!(let #y = put(b[#row], #(#known)+*);) }
        });
        let back = (0..k).rev().map(|i| {
            let (x, y, pivot) = (numbered("x", i), numbered("y", i), numbered("p", i));
            let known: Vec<TokenStream> = order.row(i, false).map(|j| times(&upper((i, j)), &numbered("x", j))).collect();
            if known.is_empty() { quote!(let #x = #y * #pivot;) } else { quote!(let #x = (#y #(- #known)*) * #pivot;) }
        });
        let x = (0..k).map(|unknown| order.columns.iter().position(|column| *column == unknown).map(|step| numbered("x", step)));
        let (k, factors) = (number(k), number(order.factors.len()));
        quote! {
            #[inline]
            fn substitute(lu: &[T; #factors], b: &[T; #k], put: impl ::core::ops::Fn(T, T) -> T) -> [T; #k] {
                let [#(#lu),*] = *lu;
                #(#forward)*
                #(#back)*
                [#(#x),*]
            }
        }
    }

    fn product(&self) -> TokenStream {
        let (k, entries) = (self.order.rows.len(), self.order.pattern.len());
        let rows = (0..k).map(|i| {
            let terms = self.order.pattern.iter().enumerate().filter(|(_, (row, _))| *row == i).map(|(number, (_, j))| {
                let (number, j) = (Literal::usize_unsuffixed(number), Literal::usize_unsuffixed(*j));
                quote!(a[#number] * x[#j])
            });
            let terms: Vec<TokenStream> = terms.collect();
            if terms.is_empty() { quote!(T::of(0.0)) } else { quote!(#(#terms)+*) }
        });
        let (k, entries) = (number(k), number(entries));
        quote! {
            #[inline]
            fn product(a: &[T; #entries], x: &[T; #k]) -> [T; #k] {
                [#(#rows),*]
            }
        }
    }
}

fn times(one: &Ident, two: &Ident) -> TokenStream {
    quote!(#one * #two)
}

fn numbered(stem: &str, i: usize) -> Ident {
    local(&format!("{stem}_{i}"))
}

fn entry((i, j): (usize, usize)) -> Ident {
    local(&format!("a_{i}_{j}"))
}

fn lower((i, j): (usize, usize)) -> Ident {
    local(&format!("l_{i}_{j}"))
}

fn upper((i, j): (usize, usize)) -> Ident {
    local(&format!("u_{i}_{j}"))
}

/// Stored form of an entry: on the diagonal, the reciprocal of the pivot.
fn factor((i, j): (usize, usize)) -> Ident {
    match i.cmp(&j) {
        std::cmp::Ordering::Less => upper((i, j)),
        std::cmp::Ordering::Equal => numbered("p", i),
        std::cmp::Ordering::Greater => lower((i, j)),
    }
}
