//! A mechanism with everything computed that depends on its parameters only.

use super::expression::local;
use super::functions::Emitter;
use super::scene::Scene;
use super::stages::Shelf;
use super::{failure, solving, state_path};
use crate::plan::{Lines, Solution, Solving};
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

impl Emitter<'_> {
    /// The body of `stages`, and the type that keeps what depends on parameters only; none if nothing does.
    pub(super) fn prepared(&self, solution: &Solution, body: TokenStream) -> (TokenStream, TokenStream) {
        let (mechanism, n) = (&self.model.name, self.system.coordinates.len());
        let lines = match &solution.solving {
            Solving::Straight(lines) if !lines.fixed_names.is_empty() => lines,
            _ => return (body, as_it_is(mechanism)),
        };
        let (fixed, stages) = (local("fixed"), local("stages_with"));
        let (t, pass) = (local("t"), local("pass"));
        let (steps, names) = self.fixed(lines);
        let count = names.len();
        let type_name = format_ident!("{}Prepared", mechanism, span = Span::call_site());
        let failure_name = format_ident!("{}Failure", type_name);
        let failure = failure(&failure_name, &type_name.to_string(), &self.model.visibility, n);
        let solving = solving(&type_name, &state_path(mechanism), n, false);
        let lists = self.lists(solution, &Shelf::whole(n));
        let step = self.plan.moving.as_ref().map(|_| {
            quote! {
                fn parameter_hash(&self) -> ::core::primitive::u64
                where
                    T: ::reuleaux::Float,
                {
                    ::reuleaux::Stages::<T, #n>::parameter_hash(&self.mechanism)
                }
                fn partial_step(&self, state: &mut ::reuleaux::State<T, #n>, t: T) -> ::core::option::Option<::core::primitive::bool>
                where
                    T: ::reuleaux::Float,
                {
                    ::reuleaux::Stages::<T, #n>::partial_step(&self.mechanism, state, t)
                }
            }
        });
        let result = quote!(::core::result::Result<::reuleaux::Coordinates<T, #n>, ::reuleaux::StepError<T>>);
        let description = quote!(::reuleaux::Description<T, #n>);
        let visibility = &self.model.visibility;
        let page =
            format!("A [`{mechanism}`] with everything computed that depends on its parameters only, made by [`{mechanism}::prepared`].");
        let types = quote! {
            #[automatically_derived]
            #[allow(clippy::all, clippy::pedantic, clippy::nursery, non_snake_case, unused_variables, unused_parens, dead_code)]
            impl<T: ::reuleaux::SolverReal> #mechanism<T> {
                /// The mechanism with everything computed that depends on its parameters only, for loops that take a state along
                /// with `advance`; `sweep` does so by itself.
                #[must_use]
                pub fn prepared(&self) -> #type_name<T> { #type_name { mechanism: *self, fixed: self.of_parameters() } }
                #[doc(hidden)]
                fn of_parameters(&self) -> [T; #count] { #steps [#(#names),*] }
                #[doc(hidden)]
                #[inline(always)]
                fn #stages(&self, #fixed: &[T; #count], #t: T, #pass: &mut ::reuleaux::Solver<'_, T, #n>) -> #result {
                    let [#(#names),*] = *#fixed;
                    #body
                }
            }
            #[doc = #page]
            #[derive(Clone, Copy, Debug, PartialEq)]
            #[allow(dead_code)]
            #visibility struct #type_name<T = ::core::primitive::f64> {
                mechanism: #mechanism<T>,
                fixed: [T; #count],
            }
            #[automatically_derived]
            impl<T: ::reuleaux::SolverReal> #description for #type_name<T> {
                const NAME: &'static ::core::primitive::str = <#mechanism<T> as #description>::NAME;
                const COORDINATES: &'static [::reuleaux::Coordinate] = <#mechanism<T> as #description>::COORDINATES;
                const ROWS: &'static [::reuleaux::Row] = <#mechanism<T> as #description>::ROWS;
                fn start(&self) -> ::reuleaux::nalgebra::SVector<T, #n> { self.mechanism.start() }
                fn characteristic_length(&self) -> T { self.mechanism.characteristic_length() }
                fn validate(&self) -> ::core::result::Result<(), ::reuleaux::ParameterOutOfRange<T>> { self.mechanism.validate() }
            }
            #[automatically_derived]
            impl<T: ::reuleaux::SolverReal> ::reuleaux::Stages<T, #n> for #type_name<T> {
                #lists
                #step
                fn interpolated(&self, lambda: T) -> ::core::option::Option<Self> {
                    let between = ::reuleaux::Stages::<T, #n>::interpolated(&self.mechanism, lambda);
                    ::core::option::Option::map(between, |mechanism| mechanism.prepared())
                }
                fn refined_guess(&self, t: T, guess: &::reuleaux::nalgebra::SVector<T, #n>) -> ::reuleaux::nalgebra::SVector<T, #n>
                where
                    T: ::reuleaux::Float,
                {
                    ::reuleaux::Stages::<T, #n>::refined_guess(&self.mechanism, t, guess)
                }
                #[inline(always)]
                fn stages(&self, t: T, pass: &mut ::reuleaux::Solver<'_, T, #n>) -> #result { self.mechanism.#stages(&self.fixed, t, pass) }
            }
            #failure
            #solving
        };
        (quote!(self.#stages(&self.of_parameters(), #t, #pass)), types)
    }

    /// The lines for what depends on parameters only, and its names.
    fn fixed(&self, lines: &Lines) -> (TokenStream, Vec<Ident>) {
        let scene = Scene { model: self.model, arena: &self.plan.arena, lines, unknowns: &[], equations: &[], kept: &[] };
        (scene.steps(&lines.names, &lines.fixed), lines.fixed_names.iter().map(|name| local(name)).collect())
    }
}

/// There is nothing to prepare.
fn as_it_is(mechanism: &Ident) -> TokenStream {
    quote! {
        #[automatically_derived]
        #[allow(dead_code)]
        impl<T: ::reuleaux::SolverReal> #mechanism<T> {
            /// The mechanism itself: what depends on its parameters alone is little, or is computed where it is used.
            #[must_use]
            pub fn prepared(&self) -> Self { *self }
        }
    }
}
