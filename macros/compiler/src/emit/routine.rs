//! Straight lines as statements.

use super::expression::{Printer, local};
use super::literal::number;
use crate::expr::{Arena, Leaf};
use crate::model::{Function, Model, Name};
use crate::plan::{Routine, Step};
use proc_macro2::{Ident, TokenStream};
use quote::quote;
use std::borrow::Cow;

/// The statements of a routine, and an expression for each result.
pub(super) struct RoutinePrinter {
    /// Reads of coordinates, rates and accelerations.
    pub(super) reads: TokenStream,
    /// Steps in order.
    pub(super) steps: TokenStream,
    /// One expression for each result.
    pub(super) results: Vec<TokenStream>,
}

/// Prints a routine that reads `q`, `qd`, `qdd` and `t`.
pub(super) fn lines(model: &Model, arena: &Arena, routine: &Routine) -> RoutinePrinter {
    routine_with(model, arena, routine, reads(routine, number, TOGETHER), "sin_cos")
}

/// The same in a function of a state, whose inputs are those of the state.
pub(super) fn lines_of_state(model: &Model, arena: &Arena, routine: &Routine) -> RoutinePrinter {
    routine_with(model, arena, &of_state(model, routine), reads(routine, number, TOGETHER), "sin_cos")
}

/// The same with sines and cosines that are fast, but not the same bits everywhere.
pub(super) fn fast_lines(model: &Model, arena: &Arena, routine: &Routine) -> RoutinePrinter {
    routine_with(model, arena, &of_state(model, routine), reads(routine, number, TOGETHER), "fast_sin_cos")
}

/// Prints a routine where the unknown of a number stands elsewhere.
pub(super) fn lines_at(model: &Model, arena: &Arena, routine: &Routine, place: impl Fn(usize) -> TokenStream) -> RoutinePrinter {
    routine_with(model, arena, routine, reads(routine, place, 1), "sin_cos")
}

/// The same in a function of a state.
pub(super) fn lines_of_state_at(model: &Model, arena: &Arena, routine: &Routine, place: impl Fn(usize) -> TokenStream) -> RoutinePrinter {
    lines_at(model, arena, &of_state(model, routine), place)
}

/// A routine that reads the inputs of the state `state`, if states hold them.
fn of_state<'a>(model: &Model, routine: &'a Routine) -> Cow<'a, Routine> {
    let own = format!("self.{}.", Name::INPUTS);
    if !model.holds_inputs() || !routine.names.values().any(|name| name.starts_with(&own)) {
        return Cow::Borrowed(routine);
    }
    let mut routine = routine.clone();
    for name in routine.names.values_mut() {
        if let Some(input) = name.strip_prefix(&own) {
            *name = format!("state.1.{input}");
        }
    }
    Cow::Owned(routine)
}

fn routine_with(model: &Model, arena: &Arena, routine: &Routine, reads: TokenStream, turn: &'static str) -> RoutinePrinter {
    let printer = Printer { arena, names: &routine.names, turn };
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
    RoutinePrinter { reads, steps, results }
}

/// As many reads of a vector stand in a line: those of a body are together.
const TOGETHER: usize = 3;

fn reads(routine: &Routine, place: impl Fn(usize) -> TokenStream, together: usize) -> TokenStream {
    let mut of_vectors = [("q", Vec::new()), ("qd", Vec::new()), ("qdd", Vec::new())];
    for (expr, leaf) in &routine.leaves {
        let (vector, index) = match *leaf {
            Leaf::Coordinate(index) => (0, index),
            Leaf::Speed(index) => (1, index),
            Leaf::Acceleration(index) => (2, index),
            Leaf::Time | Leaf::Parameter(_) | Leaf::Input { .. } | Leaf::Datum(_) | Leaf::Turn(_) | Leaf::Jerk(_) => continue,
        };
        of_vectors[vector].1.push((index, local(&routine.names[expr])));
    }
    let mut tokens = TokenStream::new();
    for (vector, mut reads) in of_vectors {
        reads.sort_by_key(|(index, _)| *index);
        let vector = local(vector);
        for reads in reads.chunks(together) {
            let (names, places): (Vec<&Ident>, Vec<TokenStream>) = reads.iter().map(|(index, name)| (name, place(*index as usize))).unzip();
            tokens.extend(match names.as_slice() {
                [name] => quote!(let #name = #vector[#(#places)*];),
                _ => quote!(let (#(#names),*) = (#(#vector[#places]),*);),
            });
        }
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
            let (angle, turn) = (printer.operand(*angle), local(printer.turn));
            quote!(let (#sine, #cosine) = #angle.#turn();)
        }
        Step::Call { function, argument, names } => {
            let [value, first, second] = names.each_ref().map(bound);
            match model.functions.get(*function as usize) {
                Some(Function::Rust(path)) => {
                    let argument = printer.expression(*argument);
                    quote!(let (#value, #first, #second): (T, T, T) = #path(#argument);)
                }
                _ => {
                    let (argument, table) = (printer.operand(*argument), local(&format!("TABLE_{function}")));
                    quote!(let (#value, #first, #second) = #argument.table(&Self::#table);)
                }
            }
        }
        Step::Choice { lhs, rhs, members, branches } => {
            let names = members.iter().map(|member| local(&printer.names[member]));
            let [lhs, rhs] = [lhs, rhs].map(|side| printer.expression(*side));
            let [then, otherwise] = branches.each_ref().map(|branch| {
                let steps = branch.steps.iter().map(|step| statement(model, printer, step));
                let results = branch.results.iter().map(|result| printer.expression(*result));
                quote!(|| { #(#steps)* [#(#results),*] })
            });
            quote!(let [#(#names),*] = T::choose_less(#lhs, #rhs, #then, #otherwise);)
        }
    }
}
