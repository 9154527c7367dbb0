//! Joints of the same shape as a loop.

use super::columns::Columns;
use super::expression::local;
use super::functions::Emitter;
use super::routine::{RoutinePrinter, lines_at};
use crate::plan::{Group, Target, Words};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

impl Emitter<'_> {
    /// A loop for each group; `write` puts a value where it belongs.
    pub(super) fn groups(&self, groups: &[Group], write: impl Fn(Target<TokenStream>, &TokenStream) -> TokenStream) -> TokenStream {
        groups.iter().map(|group| self.group(group, &write)).collect()
    }

    fn group(&self, group: &Group, write: impl Fn(Target<TokenStream>, &TokenStream) -> TokenStream) -> TokenStream {
        let mut columns = Columns::new(group.shape.count);
        let places: Vec<TokenStream> = group.shape.unknowns.iter().map(|column| columns.place(column)).collect();
        let RoutinePrinter { reads, steps, results } =
            lines_at(self.model, &group.shape.arena, &group.routine, |unknown| places[unknown].clone());
        let writes: TokenStream = group
            .targets
            .iter()
            .zip(&results)
            .map(|(target, value)| {
                let target = match target {
                    Target::Row(row) => Target::Row(columns.place(row)),
                    Target::Entry(row, column) => Target::Entry(columns.place(row), columns.place(column)),
                };
                write(target, value)
            })
            .collect();
        let inputs = columns.inputs(&group.shape, &Words::new(self.model, self.system));
        let (tables, piece, count) = (columns.tables(), local("piece"), Literal::usize_unsuffixed(group.shape.count));
        quote! {
            for #piece in 0..#count {
                #tables
                #inputs
                #reads
                #steps
                #writes
            }
        }
    }
}
