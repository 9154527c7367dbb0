//! The generated way to solve a mechanism: stage by stage.

use super::allowed;
use super::block::{BlockPrinter, Origins};
use super::docs::coordinate_name;
use super::expression::{local, named};
use super::functions::Emitter;
use super::literal::{number, vector_type};
use crate::plan::{Solution, Solving, StraightLine, Summary, Words, tested};
use crate::quantity::{Dim, Role};
use crate::system::Equation;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;
use std::collections::{BTreeMap, BTreeSet};

impl Emitter<'_> {
    /// The runtime's trait `Stages`.
    pub(super) fn stages(&self) -> TokenStream {
        let (name, n) = (&self.model.name, self.system.width());
        if !self.model.task.is_solved() {
            return quote!();
        }
        let Some(solution) = &self.plan.solution else { return quote!() };
        let shelf = StateLayout::whole(n);
        let (toward, lists, improved) = (self.toward(), self.lists(solution, &shelf), self.improved());
        let (body, kernels) = self.solving(&solution.solving, &shelf);
        let (step, moving) = self.moving();
        let (body, prepared) = self.prepared(body);
        let mark = self.mark(solution);
        let stages = stages_of(&solution.solving, n, &body);
        let (n, allowed) = (number(n), allowed());
        quote! {
            #kernels
            #allowed
            impl<T: ::reuleaux::SolverReal> ::reuleaux::Stages<T, #n> for #name<T> {
                #lists
                #toward
                #improved
                #step
                #mark
                #stages
            }
            #moving
            #prepared
        }
    }

    /// Properties of single unknowns for the runtime
    pub(super) fn lists(&self, solution: &Solution, shelf: &StateLayout) -> TokenStream {
        let (angles, iterated) = (self.computed_angles(solution, shelf), iterated(solution, shelf));
        let unsure = unsure(solution, shelf);
        let (tested, unique) = (self.tested(solution, shelf), self.unique(solution, shelf));
        quote! {
            #angles
            #tested
            #iterated
            #unique
            const MAY_BE_NON_FINITE: ::core::option::Option<&'static [::core::primitive::usize]> = ::core::option::Option::Some(&[#unsure]);
        }
    }

    /// The same of a slice
    pub(super) fn lists_of_slice(&self, solution: &Solution, shelf: &StateLayout) -> TokenStream {
        let (angles, iterated) = (self.computed_angles(solution, shelf), iterated(solution, shelf));
        let (unsure, tested, unique) = (unsure(solution, shelf), self.tested(solution, shelf), self.unique(solution, shelf));
        quote!(#angles #tested #iterated #unique const MAY_BE_NON_FINITE: &'static [::core::primitive::usize] = &[#unsure];)
    }

    /// The first unknowns of blocks with one solution, if there are any, and parameters that can change the signs of their determinants
    fn unique(&self, solution: &Solution, shelf: &StateLayout) -> Option<TokenStream> {
        let blocks = solution.stages.iter().filter_map(|stage| match stage {
            Summary::Block { unknowns, is_linear: true, .. } => unknowns.first(),
            _ => None,
        });
        let first: Vec<Literal> = blocks.filter_map(|unknown| shelf.place(*unknown)).map(Literal::usize_unsuffixed).collect();
        (!first.is_empty() && !self.model.parameters.is_empty())
            .then(|| quote!(const UNIQUE: &'static [::core::primitive::usize] = &[#(#first),*];))
    }

    /// The binary links, and whether equations are verified, where there are any. Mechanisms with slices have no links.
    fn tested(&self, solution: &Solution, shelf: &StateLayout) -> TokenStream {
        let links = self.system.space.links.iter().filter_map(|body| shelf.place(self.system.entries_of(*body).start));
        let links: Vec<Literal> = links.map(Literal::usize_unsuffixed).collect();
        let links = (!links.is_empty()).then(|| quote!(const LINKS: &'static [::core::primitive::usize] = &[#(#links),*];));
        let is_redundant = solution.stages.iter().any(|stage| matches!(stage, Summary::Check(_)));
        let is_redundant = is_redundant.then(|| {
            quote!(
                const IS_REDUNDANT: ::core::primitive::bool = true;
            )
        });
        quote!(#links #is_redundant)
    }

    /// Computed angles that move
    fn computed_angles(&self, solution: &Solution, shelf: &StateLayout) -> TokenStream {
        let is_angle = |unknown: usize| self.system.coordinates.get(unknown).is_some_and(|unknown| unknown.role == Role::Angle);
        let angle = |stage: &Summary| match *stage {
            Summary::Explicit { unknown, moves: true } if is_angle(unknown) => shelf.place(unknown).map(Literal::usize_unsuffixed),
            _ => None,
        };
        let angles = solution.stages.iter().filter_map(angle);
        quote!(const COMPUTED_ANGLES: &'static [::core::primitive::usize] = &[#(#angles),*];)
    }

    /// The body of `stages`, and the functions that it calls
    pub(super) fn solving(&self, solving: &Solving, shelf: &StateLayout) -> (TokenStream, TokenStream) {
        match solving {
            Solving::Straight(lines) => (self.straight(lines, shelf), quote!()),
            Solving::Shared(kernels) => (self.in_order(kernels, shelf), self.kernels(kernels, shelf)),
        }
    }

    /// Parameters between the defaults and these
    pub(super) fn toward(&self) -> TokenStream {
        if self.model.parameters.is_empty() {
            return quote!();
        }
        quote! {
            fn interpolated(&self, lambda: T) -> ::core::option::Option<Self> {
                ::reuleaux::between(&Self::with_defaults(), self, lambda)
            }
        }
    }

    /// The hash that distinguishes sets of parameters, if constant unknowns are kept from the state before
    fn mark(&self, solution: &Solution) -> TokenStream {
        let can_rest = matches!(&solution.solving, Solving::Shared(kernels) if kernels.can_rest);
        if self.plan.moving.is_none() && !can_rest || self.model.parameters.is_empty() {
            return quote!();
        }
        let hash = self.parameter_hash();
        quote! {
            fn parameter_hash(&self) -> ::core::primitive::u64
            where
                T: ::reuleaux::Float,
            {
                #hash
            }
        }
    }

    /// The hash of all parameters; where states are read and written, also of the declaration.
    pub(super) fn parameter_hash(&self) -> TokenStream {
        let words = Words::new(self.model, self.system);
        // Unknowns that depend on inputs of a state move.
        let moving = if self.model.holds_inputs() { self.model.of_inputs() } else { BTreeSet::new() };
        let is_meant = |number: &usize| !moving.contains(number);
        let all = (0..self.model.parameters.len()).filter(is_meant).map(|number| named(&words.parameter(number as u32)));
        let name = &self.model.name;
        match &self.model.requests.serde {
            Some(_) => quote!(::reuleaux::parameter_hash_of::<T>(#name::<T>::__DECLARATION, &[#(#all),*])),
            None => quote!(::reuleaux::parameter_hash::<T>(&[#(#all),*])),
        }
    }

    /// A guess improved with all equations
    fn improved(&self) -> TokenStream {
        if self.system.declared.is_some() {
            return quote!();
        }
        let (n, of_q) = (number(self.system.coordinates.len()), vector_type(self.system.coordinates.len()));
        let checked: BTreeSet<usize> = self.plan.checked.iter().copied().collect();
        let improved = if checked.is_empty() {
            quote!(::reuleaux::refined_guess_at_once(self, t, guess))
        } else {
            let solved = (0..self.system.equations.len()).filter(|equation| !checked.contains(equation)).map(Literal::usize_unsuffixed);
            quote! {
                const SOLVED: [::core::primitive::usize; #n] = [#(#solved),*];
                ::reuleaux::refined_guess_by_rows(self, &SOLVED, t, guess)
            }
        };
        quote! {
            fn refined_guess(&self, t: T, guess: &#of_q) -> #of_q
            where
                T: ::reuleaux::Float,
            {
                #improved
            }
        }
    }

    /// All stages one after the other
    fn straight(&self, lines: &StraightLine, shelf: &StateLayout) -> TokenStream {
        let indices: Vec<Index> = (0..lines.unknowns.len()).map(|unknown| self.index_on(unknown, shelf)).collect();
        let equations: Vec<TokenStream> = (0..self.system.equations.len()).map(number).collect();
        let origins = self.origins(lines.unknowns.len());
        let printer = BlockPrinter {
            model: self.model,
            arena: &self.plan.arena,
            lines,
            unknowns: &indices,
            equations: &equations,
            kept: &[],
            origins: Some(&origins),
        };
        let given = shelf.given.iter().enumerate().map(|(index, unknown)| {
            let (name, given, index) = (local(&lines.unknowns[*unknown][0]), local("given"), number(index));
            quote!(let #name = #given[#index];)
        });
        let parts = printer.parts();
        let column = |order: usize| -> Vec<Ident> { shelf.held.iter().map(|unknown| local(&lines.unknowns[*unknown][order])).collect() };
        let (q, qd, qdd) = (column(0), column(1), column(2));
        quote! {
            #(#given)*
            #parts
            ::core::result::Result::Ok(::reuleaux::Coordinates {
                q: ::core::convert::From::from([#(#q),*]),
                qd: ::core::convert::From::from([#(#qd),*]),
                qdd: ::core::convert::From::from([#(#qdd),*]),
            })
        }
    }

    /// Names of `n` unknowns and of all equations in the declaration.
    fn origins(&self, n: usize) -> Origins {
        let joint = |equation: &Equation| {
            let joint = &self.model.joints[equation.joint];
            format!("{} ({})", joint.name, joint.kind)
        };
        Origins {
            coordinates: (0..n).map(|unknown| coordinate_name(self.model, self.system, unknown)).collect(),
            joints: self.system.equations.iter().map(joint).collect(),
        }
    }

    /// An unknown by its index in q; components of outputs, which follow, are never solved for.
    pub(super) fn index(&self, unknown: usize) -> Index {
        let is_length = self.system.coordinates.get(unknown).is_some_and(|unknown| unknown.role.dim() == Dim::LENGTH);
        let body = self.system.coordinates.get(unknown).map(|unknown| self.model.bodies[unknown.body].name.local.clone());
        Index { place: number(unknown), kind: kind(is_length), is_length, body: body.unwrap_or_default() }
    }

    /// An unknown by its place on a shelf.
    fn index_on(&self, unknown: usize, shelf: &StateLayout) -> Index {
        Index { place: number(shelf.place(unknown).unwrap_or(0)), ..self.index(unknown) }
    }
}

/// Destination of the results of stages: returned, or written to an argument if they are many; name of the argument, argument, and return type.
pub(super) fn results(solving: &Solving, n: usize) -> (TokenStream, TokenStream, TokenStream) {
    let (found, n) = (local("found"), number(n));
    match solving {
        Solving::Straight(_) => {
            (quote!(), quote!(), quote!(::core::result::Result<::reuleaux::Coordinates<T, #n>, ::reuleaux::StepError<T>>))
        }
        Solving::Shared(_) => {
            let result = quote!(::core::result::Result<(), ::reuleaux::StepError<T>>);
            (quote!(#found), quote!(#found: &mut ::reuleaux::Values<T, #n>), result)
        }
    }
}

/// The method `stages` of the trait.
pub(super) fn stages_of(solving: &Solving, n: usize, body: &TokenStream) -> TokenStream {
    let (t, pass) = (local("t"), local("pass"));
    let (_, to, result) = results(solving, n);
    let n = number(n);
    let pass = quote!(#pass: &mut ::reuleaux::Solver<'_, T, #n>);
    match solving {
        Solving::Straight(_) => quote! {
            #[inline(always)]
            fn stages(&self, #t: T, #pass) -> #result { #body }
        },
        Solving::Shared(_) => quote! {
            const IN_PLACE: ::core::primitive::bool = true;
            #[inline(always)]
            fn stages_in_place(&self, #t: T, #pass, #to) -> #result { #body }
            fn stages(
                &self,
                t: T,
                pass: &mut ::reuleaux::Solver<'_, T, #n>,
            ) -> ::core::result::Result<::reuleaux::Coordinates<T, #n>, ::reuleaux::StepError<T>> {
                let mut found = ::reuleaux::Values::zero();
                self.stages_in_place(t, pass, &mut found)?;
                ::core::result::Result::Ok(found.coordinates())
            }
        },
    }
}

/// Where a state holds which unknowns.
pub(super) struct StateLayout {
    /// The unknowns in order.
    pub(super) held: Vec<usize>,
    /// Unknowns whose values are given.
    pub(super) given: Vec<usize>,
    /// Begins the names of functions.
    pub(super) prefix: String,
    places: BTreeMap<usize, usize>,
}

impl StateLayout {
    pub(super) fn new(held: &[usize], given: &[usize], prefix: String) -> StateLayout {
        let places = held.iter().enumerate().map(|(place, unknown)| (*unknown, place)).collect();
        StateLayout { held: held.to_vec(), given: given.to_vec(), prefix, places }
    }

    /// All unknowns, each at its own index.
    pub(super) fn whole(n: usize) -> StateLayout {
        StateLayout::new(&(0..n).collect::<Vec<usize>>(), &[], String::new())
    }

    /// Where an unknown is held.
    pub(super) fn place(&self, unknown: usize) -> Option<usize> {
        self.places.get(&unknown).copied()
    }
}

/// Kind of quantity of an unknown.
fn kind(is_length: bool) -> TokenStream {
    if is_length { quote!(::reuleaux::CoordinateKind::Length) } else { quote!(::reuleaux::CoordinateKind::Angle) }
}

/// An unknown in generated code.
pub(super) struct Index {
    /// Its index in q.
    pub(super) place: TokenStream,
    /// Kind of its quantity.
    pub(super) kind: TokenStream,
    /// It is no angle.
    pub(super) is_length: bool,
    /// Its body.
    pub(super) body: String,
}

/// Unknowns that may be found to be no finite numbers
fn unsure(solution: &Solution, shelf: &StateLayout) -> TokenStream {
    let tested = tested(&solution.unsure, |unknown| shelf.place(unknown).is_some());
    let unsure = tested.iter().filter_map(|unknown| shelf.place(*unknown)).map(Literal::usize_unsuffixed);
    quote!(#(#unsure),*)
}

/// Unknowns that are iterated
fn iterated(solution: &Solution, shelf: &StateLayout) -> TokenStream {
    let blocks = solution.stages.iter().filter_map(|stage| match stage {
        Summary::Block { unknowns, .. } => Some(unknowns),
        Summary::Explicit { .. } | Summary::Check(_) => None,
    });
    let unknowns = blocks.flatten().filter_map(|unknown| shelf.place(*unknown)).map(Literal::usize_unsuffixed);
    quote!(const ITERATED: &'static [::core::primitive::usize] = &[#(#unknowns),*];)
}
