//! The generated way to solve a mechanism of many stages of few shapes: one function for each shape.

use super::block::{BlockPrinter, pair};
use super::columns::Columns;
use super::expression::local;
use super::functions::Emitter;
use super::literal::{number, signed};
use super::stages::{Index, StateLayout};
use super::{allowed, docs};
use crate::expr::{Leaf, Node};
use crate::plan::{Column, Kernel, Kernels, Round, StageCode, Words};
use crate::quantity::Role;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;
use std::collections::BTreeMap;

impl Emitter<'_> {
    /// The body of `stages`: one call after the other
    pub(super) fn in_order(&self, kernels: &Kernels, shelf: &StateLayout) -> TokenStream {
        let (angles, rank) = (number(self.angles(shelf).count()), self.ranks(shelf));
        let (t, pass, found, turns, piece) = (local("t"), local("pass"), local("found"), local("turns"), local("piece"));
        let call = |kernel: usize| {
            let name = name(shelf, kernel);
            quote!(self.#name(#piece, #t, #pass, #found, &mut #turns)?)
        };
        let calls = match kernels.rounds() {
            Some(rounds) => rounds.iter().map(|round| repeated(round, &piece, call)).collect(),
            None => one_by_one(&kernels.order, kernels.kernels.len(), &piece, call),
        };
        let constants = kernels.constants.iter().filter_map(|(unknown, value)| {
            let (place, value) = (Literal::usize_unsuffixed(shelf.place(*unknown)?), signed(*value));
            Some(quote!((#place, #value)))
        });
        let given = shelf.given.iter().enumerate().filter_map(|(index, unknown)| {
            let (given, index, place) = (local("given"), number(index), number(shelf.place(*unknown)?));
            Some(quote!((#found.q[#place], #found.qd[#place], #found.qdd[#place]) = (#given[#index], T::of(0.0), T::of(0.0));))
        });
        // The moving parts may turn by angles that rest.
        let is_angle = |unknown: &&usize| self.system.coordinates.get(**unknown).is_some_and(|unknown| unknown.role == Role::Angle);
        let turned = shelf.given.iter().filter(is_angle).filter_map(|unknown| {
            let (place, rank) = (number(shelf.place(*unknown)?), number(*rank.get(unknown)?));
            Some(quote!(#turns[#rank] = #found.q[#place].fast_sin_cos();))
        });
        quote! {
                const CONSTANTS: &[(::core::primitive::usize, ::core::primitive::f64)] = &[#(#constants),*];
                if #pass.is_cold_start() {
                    for (unknown, value) in CONSTANTS {
                        (#found.q[*unknown], #found.qd[*unknown], #found.qdd[*unknown]) = (T::of(*value), T::of(0.0), T::of(0.0));
                    }
                }
                #(#given)*
                let mut #turns = [(T::of(0.0), T::of(1.0)); #angles];
                #(#turned)*
                #calls
                ::core::result::Result::Ok(())
        }
    }

    /// One function for each shape
    pub(super) fn kernels(&self, kernels: &Kernels, shelf: &StateLayout) -> TokenStream {
        let name = &self.model.name;
        let ranks = self.ranks(shelf);
        let kernel = |(number, kernel): (usize, &Kernel)| self.kernel(number, kernel, shelf, &ranks, kernels.can_rest);
        let functions = kernels.kernels.iter().enumerate().map(kernel);
        let allowed = allowed();
        quote! {
            #allowed
            impl<T: ::reuleaux::SolverReal> #name<T> { #(#functions)* }
        }
    }

    /// The angles that are held.
    fn angles<'a>(&'a self, shelf: &'a StateLayout) -> impl Iterator<Item = usize> + 'a {
        let is_angle = |unknown: &usize| self.system.coordinates.get(*unknown).is_some_and(|unknown| unknown.role == Role::Angle);
        shelf.held.iter().copied().filter(is_angle)
    }

    /// Where the sine and cosine of each angle are kept.
    fn ranks(&self, shelf: &StateLayout) -> BTreeMap<usize, usize> {
        self.angles(shelf).enumerate().map(|(rank, unknown)| (unknown, rank)).collect()
    }

    fn kernel(&self, index: usize, kernel: &Kernel, shelf: &StateLayout, ranks: &BTreeMap<usize, usize>, can_rest: bool) -> TokenStream {
        let (n, angles) = (number(shelf.held.len()), number(ranks.len()));
        let mut columns = Columns::new(kernel.shape.count);
        let mut turned = BTreeMap::new();
        for slot in kernel.kept.iter().chain(kernel.lines.turned.iter().map(|(slot, _)| slot)) {
            let rank = |unknown: u32| ranks.get(&(unknown as usize)).copied().unwrap_or(0) as u32;
            let rank = columns.place(&kernel.shape.unknowns[*slot].mapped(kernel.shape.count, rank));
            turned.insert(*slot, rank);
        }
        let unknowns: Vec<Index> = kernel
            .shape
            .unknowns
            .iter()
            .map(|column| {
                let place = column.mapped(kernel.shape.count, |unknown| shelf.place(unknown as usize).unwrap_or(0) as u32);
                let first = self.index(column.at(0) as usize);
                // The numbers of the first piece are not those of the others.
                let body = first.body.chars().filter(|letter| !letter.is_ascii_digit()).collect::<String>().replace("__", "_");
                Index { place: columns.place(&place), body: body.trim_matches('_').to_owned(), ..first }
            })
            .collect();
        let equations: Vec<TokenStream> = kernel.equations.iter().map(|column| columns.place(column)).collect();
        let printer = BlockPrinter {
            model: self.model,
            arena: &kernel.shape.arena,
            lines: &kernel.lines,
            unknowns: &unknowns,
            equations: &equations,
            kept: &kernel.kept,
            origins: None,
        };
        let inputs = columns.inputs(&kernel.shape, &Words::new(self.model, self.system));
        let (parts, reads, writes) = (printer.parts(), reads(kernel, &unknowns, &turned), writes(kernel, &printer, &turned));
        let rest = if can_rest { rest(kernel, &unknowns, &turned) } else { quote!() };
        let (t, pass, found, turns) = (local("t"), local("pass"), local("found"), local("turns"));
        let (tables, name, piece, page) = (columns.tables(), name(shelf, index), local("piece"), self.kernel_page(kernel));
        quote! {
            #page
            #[inline]
            fn #name(
                &self,
                #piece: ::core::primitive::usize,
                #t: T,
                #pass: &mut ::reuleaux::Solver<'_, T, #n>,
                #found: &mut ::reuleaux::Values<T, #n>,
                #turns: &mut [(T, T); #angles],
            ) -> ::core::result::Result<(), ::reuleaux::StepError<T>> {
                #tables
                #rest
                #inputs
                #reads
                #parts
                #writes
                ::core::result::Result::Ok(())
            }
        }
    }
}

impl Emitter<'_> {
    /// Results of a kernel, by the names of its first piece.
    fn kernel_page(&self, kernel: &Kernel) -> TokenStream {
        let coordinate = |slot: &usize| docs::coordinate_name(self.model, self.system, kernel.shape.unknowns[*slot].at(0) as usize);
        let equation = |column: &Column<u32>| docs::equation_name(self.model, self.system, column.at(0) as usize);
        let mut found: Vec<String> = kernel.found.iter().map(coordinate).collect();
        // The cosines of an orientation have one name.
        found.dedup();
        let equations: Vec<String> = kernel.equations.iter().map(equation).collect();
        let mut page = match (found.join(", "), equations.join(", ")) {
            (found, from) if from.is_empty() => found,
            (found, from) if found.is_empty() => format!("{from}: it must hold"),
            (found, from) => format!("{found} from {from}"),
        };
        match kernel.shape.count - 1 {
            0 => {}
            1 => page += "; 1 more of the same shape",
            more => page += &format!("; {more} more of the same shape"),
        }
        docs::line(&(page + "."))
    }
}

/// Shapes that take turns, as a loop
fn repeated(round: &Round, piece: &Ident, call: impl Fn(usize) -> TokenStream) -> TokenStream {
    let (times, last) = (number(round.pieces(0)), number(round.pieces(0) - 1));
    let calls = round.shapes.iter().enumerate().map(|(place, shape)| {
        let call = call(*shape);
        if round.pieces(place) < round.pieces(0) { quote!(if #piece < #last { #call; }) } else { quote!(#call;) }
    });
    quote!(for #piece in 0..#times { #(#calls)* })
}

/// Shapes in an order that is a table
fn one_by_one(order: &[usize], count: usize, piece: &Ident, call: impl Fn(usize) -> TokenStream) -> TokenStream {
    let (length, pieces) = (number(order.len()), number(count));
    let order = order.iter().map(|shape| Literal::usize_unsuffixed(*shape));
    let arms = (0..count).map(|shape| {
        let (pattern, call) = (Literal::usize_unsuffixed(shape), call(shape));
        quote!(#pattern => #call,)
    });
    quote! {
        static ORDER: [::core::primitive::u16; #length] = [#(#order),*];
        let mut pieces = [0; #pieces];
        for &shape in &ORDER {
            let #piece = pieces[shape as ::core::primitive::usize];
            pieces[shape as ::core::primitive::usize] += 1;
            match shape {
                #(#arms)*
                _ => {}
            }
        }
    }
}

fn name(shelf: &StateLayout, kernel: usize) -> Ident {
    local(&format!("shape_{}{kernel}", shelf.prefix))
}

/// A block whose inputs rest where they were is left where it was.
fn rest(kernel: &Kernel, unknowns: &[Index], ranks: &BTreeMap<usize, TokenStream>) -> TokenStream {
    let is_timed = kernel.shape.arena.all().any(|expr| matches!(kernel.shape.arena.node(expr), Node::Leaf(leaf) if leaf.is_of_time()));
    if is_timed || !matches!(kernel.lines.parts.as_slice(), [StageCode::Block(_)]) {
        return quote!();
    }
    let (pass, found, turns, last) = (local("pass"), local("found"), local("turns"), local("last"));
    let inputs = (0..unknowns.len()).filter(|slot| !kernel.found.contains(slot)).map(|slot| &unknowns[slot].place);
    let own: Vec<&TokenStream> = kernel.found.iter().map(|slot| &unknowns[*slot].place).collect();
    let positions = (0..own.len()).map(number);
    let kept = kernel.found.iter().enumerate().filter(|(_, slot)| kernel.kept.contains(slot)).map(|(position, slot)| {
        let (rank, position) = (&ranks[slot], number(position));
        quote!(#turns[#rank] = #last[#position].fast_sin_cos();)
    });
    quote! {
        if let ::core::option::Option::Some(#last) = #pass.resting(#found, &[#(#inputs),*], [#(#own),*]) {
            #(#found.q[#own] = #last[#positions];)*
            #(#kept)*
            return ::core::result::Result::Ok(());
        }
    }
}

/// Values of unknowns from other kernels.
fn reads(kernel: &Kernel, unknowns: &[Index], ranks: &BTreeMap<usize, TokenStream>) -> TokenStream {
    let (found, turns) = (local("found"), local("turns"));
    let mut tokens = TokenStream::new();
    for expr in kernel.shape.arena.all() {
        let Node::Leaf(leaf) = *kernel.shape.arena.node(expr) else { continue };
        let (slot, order, vector) = match leaf {
            Leaf::Coordinate(slot) => (slot as usize, 0, "q"),
            Leaf::Speed(slot) => (slot as usize, 1, "qd"),
            Leaf::Acceleration(slot) => (slot as usize, 2, "qdd"),
            Leaf::Time | Leaf::Parameter(_) | Leaf::Input { .. } | Leaf::Datum(_) | Leaf::Turn(_) | Leaf::Jerk(_) => continue,
        };
        if !kernel.found.contains(&slot) {
            let (name, vector, place) = (local(&kernel.lines.unknowns[slot][order]), local(vector), &unknowns[slot].place);
            tokens.extend(quote!(let #name = #found.#vector[#place];));
        }
    }
    for (slot, names) in &kernel.lines.turned {
        let (pair, rank) = (pair(names), &ranks[slot]);
        tokens.extend(quote!(let #pair = #turns[#rank];));
    }
    tokens
}

/// Results of the kernel.
fn writes(kernel: &Kernel, printer: &BlockPrinter, ranks: &BTreeMap<usize, TokenStream>) -> TokenStream {
    let (found, turns) = (local("found"), local("turns"));
    let mut tokens = TokenStream::new();
    for slot in &kernel.found {
        let place = &printer.unknowns[*slot].place;
        let [q, qd, qdd] = kernel.lines.unknowns[*slot].each_ref().map(|name| local(name));
        tokens.extend(quote!(#found.q[#place] = #q; #found.qd[#place] = #qd; #found.qdd[#place] = #qdd;));
        if !kernel.kept.contains(slot) {
            continue;
        }
        let rank = &ranks[slot];
        let in_block = kernel.lines.parts.iter().enumerate().find_map(|(number, part)| match part {
            StageCode::Block(block) => block.system.unknowns.iter().position(|unknown| unknown == slot).map(|position| (number, position)),
            StageCode::Explicit { .. } | StageCode::Check { .. } => None,
        });
        tokens.extend(match in_block {
            Some((block, position)) => {
                let (solved, position) = (printer.solved(block), number(position));
                quote!(#turns[#rank] = #solved.sin_cos[#position];)
            }
            None => quote!(#turns[#rank] = #q.fast_sin_cos();),
        });
    }
    tokens
}
