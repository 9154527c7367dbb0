//! Straight lines as statements.

use super::expression::{Printer, local};
use super::stages::number;
use crate::expr::{Arena, Leaf};
use crate::model::{Function, Model};
use crate::plan::{Routine, Step};
use proc_macro2::TokenStream;
use quote::quote;

/// The statements of a routine, and an expression for each result.
pub(super) struct Lines {
    /// Reads of coordinates, rates and accelerations.
    pub(super) reads: TokenStream,
    /// Steps in order.
    pub(super) steps: TokenStream,
    /// One expression for each result.
    pub(super) results: Vec<TokenStream>,
}

/// Prints a routine that reads `q`, `qd`, `qdd` and `t`.
pub(super) fn lines(model: &Model, arena: &Arena, routine: &Routine) -> Lines {
    lines_at(model, arena, routine, number)
}

/// The same where the unknown of a number stands elsewhere.
pub(super) fn lines_at(model: &Model, arena: &Arena, routine: &Routine, place: impl Fn(usize) -> TokenStream) -> Lines {
    let printer = Printer { arena, names: &routine.names, turn: "sin_cos" };
    let mut steps = TokenStream::new();
    let mut results = Vec::new();
    let mut printed = 0;
    for (result, after) in routine.results.iter().zip(&routine.after) {
        for step in &routine.steps[printed..*after] {
            steps.extend(statement(model, &printer, step));
        }
        printed = *after;
        results.push(printer.expression(*result));
    }
    Lines { reads: reads(routine, place), steps, results }
}

fn reads(routine: &Routine, place: impl Fn(usize) -> TokenStream) -> TokenStream {
    let mut tokens = TokenStream::new();
    for (expr, leaf) in &routine.leaves {
        let (source, index) = match *leaf {
            Leaf::Coordinate(index) => ("q", index),
            Leaf::Speed(index) => ("qd", index),
            Leaf::Acceleration(index) => ("qdd", index),
            Leaf::Time | Leaf::Parameter(_) | Leaf::Datum(_) => continue,
        };
        let (name, source, place) = (local(&routine.names[expr]), local(source), place(index as usize));
        tokens.extend(quote!(let #name = #source[#place];));
    }
    tokens
}

/// One step as a `let`.
pub(super) fn statement(model: &Model, printer: &Printer, step: &Step) -> TokenStream {
    let bound = |name: &Option<String>| {
        name.as_ref().map_or(quote!(_), |name| {
            let name = local(name);
            quote!(#name)
        })
    };
    match step {
        Step::Value(expr) => {
            let name = local(&printer.names[expr]);
            let value = printer.definition(*expr);
            quote!(let #name = #value;)
        }
        Step::SineCosine { angle, sine, cosine } => {
            let (sine, cosine) = (bound(sine), bound(cosine));
            let angle = printer.expression(*angle);
            let turn = local(printer.turn);
            quote!(let (#sine, #cosine) = (#angle).#turn();)
        }
        Step::Call { function, argument, names } => {
            let [value, first, second] = names.each_ref().map(bound);
            let argument = printer.expression(*argument);
            match model.functions.get(*function as usize) {
                Some(Function::Rust(path)) => quote!(let (#value, #first, #second): (T, T, T) = #path(#argument);),
                _ => {
                    let table = local(&format!("TABLE_{function}"));
                    quote!(let (#value, #first, #second) = (#argument).table(&Self::#table);)
                }
            }
        }
    }
}
