//! What can be solved alone: the slice upstream of an output, and what moves of a mechanism that rests in part.

use super::arrays::{array_at, array_type};
use super::expression::local;
use super::functions::Emitter;
use super::stages::{Shelf, number, results, stages_of};
use super::{docs, docs_or, failure, plan_constant, solving};
use crate::model::Method;
use crate::plan::Slice;
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};

impl Emitter<'_> {
    /// A type for each method of outputs
    pub(super) fn slices(&self) -> TokenStream {
        self.model.methods.iter().zip(&self.plan.slices).map(|(method, slice)| self.slice(method, slice)).collect()
    }

    fn slice(&self, method: &Method, slice: &Slice) -> TokenStream {
        let (mechanism, visibility) = (&self.model.name, &self.model.visibility);
        let word = method.name.to_string();
        let word = word.trim_start_matches("r#");
        let name = slice_name(mechanism, &self.model.methods, word);
        let [state, failure_name] =
            ["State", "Failure"].map(|what| slice_name(&format_ident!("{mechanism}{what}"), &self.model.methods, word));
        let (solve_for, stages) = (format_ident!("solve_for_{word}", span = Span::call_site()), local(&format!("stages_for_{word}")));
        let shelf = Shelf::new(&slice.held, &[], format!("for_{word}_"));
        let (description, constants) = (self.description(&name, &shelf, word), self.lists(&slice.solution, &shelf));
        let (body, kernels) = self.solving(&slice.solution.solving, &shelf);
        let plan = plan_constant(self.model, self.system, &slice.solution);
        let (n, whole) = (slice.held.len(), self.system.coordinates.len());
        let (t, pass) = (local("t"), local("pass"));
        let (argument, to, result) = results(&slice.solution.solving, n);
        let of_trait = stages_of(&slice.solution.solving, n, &quote!(self.0.#stages(#t, #pass, #argument)));
        let page =
            format!("What is upstream of the output `{word}` of [`{mechanism}`], and nothing else, made by [`{mechanism}::{solve_for}`].");
        let method_page =
            format!("The mechanism for the output `{word}` alone: whatever is not upstream of it is not solved, nor compiled.");
        let failure = failure(&failure_name, &name.to_string(), visibility, n);
        let solving = solving(&name, &quote!(#state), n, false);
        let value = self.slice_state(method, &state, slice);
        quote! {
            #[automatically_derived]
            #[allow(clippy::all, clippy::pedantic, clippy::nursery, non_snake_case, dead_code)]
            impl<T: ::reuleaux::Real> #mechanism<T> {
                #[doc = #method_page]
                #[must_use]
                pub fn #solve_for(&self) -> #name<T> { #name(*self) }
            }
            #[doc = #page]
            #[derive(Clone, Copy, Debug, PartialEq)]
            #[allow(non_camel_case_types, dead_code)]
            #visibility struct #name<T = ::core::primitive::f64>(pub #mechanism<T>);
            #[allow(clippy::all, clippy::pedantic, clippy::nursery)]
            impl<T: ::reuleaux::Real> #name<T> { #plan }
            #[automatically_derived]
            impl<T: ::reuleaux::Real> ::reuleaux::Family<T> for #name<T> {
                type Over<T2: ::reuleaux::Real> = #name<T2>;
                fn gather<T2: ::reuleaux::Real, const LANES: ::core::primitive::usize>(each: [&Self; LANES], combine: impl ::core::ops::Fn([T; LANES]) -> T2) -> #name<T2> {
                    #name(::reuleaux::Family::gather(each.map(|slice| &slice.0), combine))
                }
            }
            #kernels
            #[automatically_derived]
            #[allow(clippy::all, clippy::pedantic, clippy::nursery, non_snake_case, unused_variables, unused_parens, dead_code)]
            impl<T: ::reuleaux::SolverReal> #mechanism<T> {
                #[doc(hidden)]
                #[inline(always)]
                fn #stages(&self, #t: T, #pass: &mut ::reuleaux::Solver<'_, T, #n>, #to) -> #result { #body }
            }
            #description
            #[automatically_derived]
            impl<T: ::reuleaux::SolverReal> ::reuleaux::Stages<T, #n> for #name<T> {
                #constants
                fn interpolated(&self, lambda: T) -> ::core::option::Option<Self> {
                    ::core::option::Option::map(::reuleaux::Stages::<T, #whole>::interpolated(&self.0, lambda), Self)
                }
                #of_trait
            }
            #failure
            #solving
            #value
        }
    }

    /// Names, start and size: those of the mechanism, as far as they belong to the slice.
    fn description(&self, name: &Ident, shelf: &Shelf, output: &str) -> TokenStream {
        let (mechanism, whole, n) = (&self.model.name, self.system.coordinates.len(), shelf.held.len());
        let coordinates = shelf.held.iter().map(|unknown| match self.system.coordinates.get(*unknown) {
            Some(_) => {
                let index = number(*unknown);
                quote!(<#mechanism<T> as ::reuleaux::Description<T, #whole>>::COORDINATES[#index])
            }
            None => {
                let component = format!("component {}", unknown - whole + 1);
                quote!(::reuleaux::Coordinate { body: #output, name: #component, kind: ::reuleaux::CoordinateKind::Length })
            }
        });
        let start = shelf.held.iter().map(|unknown| {
            let index = number(*unknown);
            if *unknown < whole { quote!(start[#index]) } else { quote!(T::of(0.0)) }
        });
        quote! {
            #[automatically_derived]
            impl<T: ::reuleaux::Real> ::reuleaux::Description<T, #n> for #name<T> {
                const NAME: &'static ::core::primitive::str = <#mechanism<T> as ::reuleaux::Description<T, #whole>>::NAME;
                const COORDINATES: &'static [::reuleaux::Coordinate] = &[#(#coordinates),*];
                const ROWS: &'static [::reuleaux::Row] = <#mechanism<T> as ::reuleaux::Description<T, #whole>>::ROWS;
                fn start(&self) -> ::reuleaux::nalgebra::SVector<T, #n> {
                    let start = self.0.start();
                    ::core::convert::From::from([#(#start),*])
                }
                fn characteristic_length(&self) -> T { self.0.characteristic_length() }
                fn validate(&self) -> ::core::result::Result<(), ::reuleaux::ParameterOutOfRange<T>> { self.0.validate() }
            }
        }
    }

    /// The state of a slice, which has the output.
    fn slice_state(&self, method: &Method, state: &Ident, slice: &Slice) -> TokenStream {
        let Some(first) = method.members.first().map(|member| &self.model.outputs[*member]) else { return quote!() };
        let (width, kind, value): (usize, TokenStream, fn(TokenStream) -> TokenStream) = match first.components.len() {
            0 => (3, quote!(::reuleaux::PlanarBody<T>), |place| quote!(self.0.planar_body(#place))),
            1 => (1, quote!(::reuleaux::Motion<T>), |place| quote!(self.0.coordinate(#place))),
            _ => (2, quote!(::reuleaux::Motion<::reuleaux::nalgebra::Vector2<T>>), |place| quote!(self.0.point(#place))),
        };
        let (visibility, name, n) = (&self.model.visibility, &method.name, slice.held.len());
        let begin = n - width * method.members.len();
        let places: Vec<usize> = (0..method.members.len()).map(|member| begin + width * member).collect();
        let (value, kind) = (array_at(&places, &method.sizes, value), array_type(kind, &method.sizes));
        let docs = docs_or(&method.docs, &docs::output(method, first));
        let first_line = format!("A state of the slice for `{name}`: the output, and what the next state is found from.");
        quote! {
            #[doc = #first_line]
            #[derive(Clone, Debug, PartialEq)]
            #[allow(non_camel_case_types, dead_code)]
            #visibility struct #state<T = ::core::primitive::f64>(pub ::reuleaux::State<T, #n>);
            #[automatically_derived]
            #[allow(clippy::all, clippy::pedantic, clippy::nursery, non_snake_case, dead_code)]
            impl<T: ::reuleaux::Real> #state<T> {
                #docs
                #[must_use]
                pub fn #name(&self) -> #kind { #value }
            }
            #[automatically_derived]
            impl<T> ::core::ops::Deref for #state<T> {
                type Target = ::reuleaux::State<T, #n>;
                fn deref(&self) -> &Self::Target { &self.0 }
            }
        }
    }

    /// A step in which only what moves is solved, and the type that it is solved by; nothing where all of it moves.
    pub(super) fn moving(&self) -> (TokenStream, TokenStream) {
        let Some(slice) = &self.plan.moving else { return (quote!(), quote!()) };
        let (mechanism, whole, n) = (&self.model.name, self.system.coordinates.len(), slice.held.len());
        let name = format_ident!("{}Moving", mechanism, span = Span::call_site());
        let shelf = Shelf::new(&slice.held, &slice.given, "moving_".to_owned());
        let (body, kernels) = self.solving(&slice.solution.solving, &shelf);
        let (description, constants) = (self.description(&name, &shelf, ""), self.lists(&slice.solution, &shelf));
        let (count, places) = (slice.given.len(), slice.given.iter().map(|unknown| number(*unknown)));
        let held = slice.held.iter().map(|unknown| Literal::usize_unsuffixed(*unknown));
        let (t, pass, given, stages) = (local("t"), local("pass"), local("given"), local("stages_of_what_moves"));
        let (argument, to, result) = results(&slice.solution.solving, n);
        let of_trait = stages_of(&slice.solution.solving, n, &quote!(self.0.#stages(&self.1, #t, #pass, #argument)));
        let step = quote! {
            fn partial_step(&self, state: &mut ::reuleaux::State<T, #whole>, t: T) -> ::core::option::Option<::core::primitive::bool>
            where
                T: ::reuleaux::Float,
            {
                const HELD: [::core::primitive::usize; #n] = [#(#held),*];
                let moving = #name(*self, [#(state.q[#places]),*]);
                ::core::option::Option::Some(::reuleaux::step_in_part(&moving, state, &HELD, ::reuleaux::Stages::<T, #whole>::parameter_hash(self), t))
            }
        };
        let part = quote! {
            /// What moves of a mechanism that rests in part, with what it needs to know of the rest.
            #[derive(Clone, Copy)]
            #[doc(hidden)]
            struct #name<T>(#mechanism<T>, [T; #count]);
            #kernels
            #[automatically_derived]
            #[allow(clippy::all, clippy::pedantic, clippy::nursery, non_snake_case, unused_variables, unused_parens)]
            impl<T: ::reuleaux::SolverReal> #mechanism<T> {
                #[doc(hidden)]
                #[inline(always)]
                fn #stages(&self, #given: &[T; #count], #t: T, #pass: &mut ::reuleaux::Solver<'_, T, #n>, #to) -> #result { #body }
            }
            #description
            #[automatically_derived]
            impl<T: ::reuleaux::SolverReal> ::reuleaux::Stages<T, #n> for #name<T> {
                #constants
                #of_trait
            }
        };
        (step, part)
    }
}

/// The type of a slice, `CrankRockerForTip`; outputs whose names differ in case only keep it.
pub(super) fn slice_name(mechanism: &Ident, methods: &[Method], output: &str) -> Ident {
    let is_alone = methods.iter().filter(|other| camel(&other.name.to_string()) == camel(output)).count() <= 1;
    let tail = if is_alone { camel(output) } else { format!("_{output}") };
    format_ident!("{}For{}", mechanism, tail, span = Span::call_site())
}

/// `coupler_tip` as `CouplerTip`.
fn camel(name: &str) -> String {
    let capital = |word: &str| {
        let mut letters = word.chars();
        letters.next().map(|first| first.to_uppercase().collect::<String>() + letters.as_str()).unwrap_or_default()
    };
    name.split('_').map(capital).collect()
}
