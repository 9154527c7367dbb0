//! Numbers that vary between the pieces of one shape: a progression if they form one, else a table.

use super::expression::{local, named};
use super::literal::{number, signed};
use crate::plan::{Column, Shape, Words};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

/// The tables of one shape. Generated code is inside a function or loop with the number of the piece as `piece`.
pub(super) struct Columns {
    count: usize,
    listed: Vec<Vec<u32>>,
}

impl Columns {
    pub(super) fn new(count: usize) -> Columns {
        Columns { count, listed: Vec::new() }
    }

    /// The value of a column for the piece at hand, of type `usize`.
    pub(super) fn place(&mut self, column: &Column<u32>) -> TokenStream {
        let (piece, row) = (local("piece"), local("row"));
        match column {
            Column::Same(value) => number(*value as usize),
            Column::Steps(first, step) => {
                let (first, step) = (number(*first as usize), number(*step as usize));
                quote!(#first + #step * #piece)
            }
            Column::Listed(values) => {
                let known = self.listed.iter().position(|other| other == values);
                let index = number(known.unwrap_or(self.listed.len()));
                if known.is_none() {
                    self.listed.push(values.clone());
                }
                quote!(#row[#index] as ::core::primitive::usize)
            }
        }
    }

    /// The table behind all places, and its row for the piece at hand.
    pub(super) fn tables(&self) -> TokenStream {
        if self.listed.is_empty() {
            return quote!();
        }
        let (rows, row, piece) = (constant("ROWS"), local("row"), local("piece"));
        let (width, count) = (self.listed.len(), self.count);
        let lines = (0..count).map(|piece| {
            let entries = self.listed.iter().map(|column| Literal::u32_unsuffixed(column[piece]));
            quote!([#(#entries),*])
        });
        quote! {
            static #rows: [[::core::primitive::u32; #width]; #count] = [#(#lines),*];
            let #row = &#rows[#piece];
        }
    }

    /// Numbers and parameters that differ, by their names in the lines of the shape.
    pub(super) fn inputs(&mut self, shape: &Shape, words: &Words) -> TokenStream {
        let (data, piece) = (constant("DATA"), local("piece"));
        let (width, count) = (shape.data.len(), self.count);
        let lines = (0..count).map(|piece| {
            let entries = shape.data.iter().map(|column| signed(column[piece]));
            quote!([#(#entries),*])
        });
        let names = (0..width).map(|index| local(&format!("d{index}")));
        let indices = (0..width).map(number);
        let table = (width > 0).then(|| {
            quote! {
                static #data: [[f64; #width]; #count] = [#(#lines),*];
                #(let #names = T::of(#data[#piece][#indices]);)*
            }
        });
        let mut parameters = TokenStream::new();
        for (slot, column) in shape.parameters.iter().enumerate() {
            if !matches!(column, Column::Same(_)) {
                let (name, place) = (local(&format!("p{slot}")), self.parameter(column, words));
                parameters.extend(quote!(let #name = #place;));
            }
        }
        quote!(#table #parameters)
    }

    /// A parameter that differs: the fields have the same path but for their indices, or else they are listed.
    fn parameter(&mut self, column: &Column<u32>, words: &Words) -> TokenStream {
        let names: Vec<String> = (0..self.count).map(|piece| words.parameter(column.at(piece))).collect();
        let paths: Vec<Vec<&str>> = names.iter().map(|name| name.split(['[', ']']).collect()).collect();
        let fixed = |path: &Vec<&str>| path.iter().step_by(2).map(|part| (*part).to_owned()).collect::<Vec<String>>();
        let first = fixed(&paths[0]);
        if first.len() < 2 || paths.iter().any(|path| fixed(path) != first) {
            let (all, piece) = (names.iter().map(|name| named(name)), local("piece"));
            return quote!([#(#all),*][#piece]);
        }
        let mut tokens = named(&first[0]);
        for (rank, part) in first.iter().enumerate().skip(1) {
            let indices = paths.iter().map(|path| path[2 * rank - 1].parse().unwrap_or(0)).collect();
            let index = self.place(&Column::of(indices));
            tokens.extend(quote!([#index]));
            for field in part.split('.').filter(|field| !field.is_empty()) {
                let field = super::identifier(field);
                tokens.extend(quote!(.#field));
            }
        }
        tokens
    }
}

/// The name of a table.
fn constant(name: &str) -> Ident {
    local(name)
}
