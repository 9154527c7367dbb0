//! Systems that can be solved alone: the slice upstream of an output, and the moving part of a mechanism that rests in part.

use super::arrays::{array_at, array_type};
use super::expression::local;
use super::functions::Emitter;
use super::listing::output_name;
use super::literal::{number, vector_type};
use super::outputs::in_whole;
use super::stages::{StateLayout, results, stages_of};
use super::{allowed, docs, placed, plan_constant, state_path};
use crate::model::Method;
use crate::plan::{Slice, Solving};
use crate::system::COSINES;
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};

impl Emitter<'_> {
    /// The methods `solve_for_…` and their types
    pub(super) fn slices(&self) -> (TokenStream, TokenStream) {
        let slices = self.model.methods.iter().filter(|method| method.is_slice).zip(&self.plan.slices).enumerate();
        slices.map(|(number, (method, slice))| (self.solve_for(method), self.slice(number, method, slice))).unzip()
    }

    fn solve_for(&self, method: &Method) -> TokenStream {
        let word = plain(&method.name);
        let solve_for = format_ident!("solve_for_{word}", span = Span::call_site());
        let name = slice_name(&self.model.name, &self.model.methods, &word);
        let page = docs::line(&format!(
            "The mechanism for the output `{word}` alone: whatever is not upstream of it is not solved, nor compiled."
        ));
        let function = placed(method.name.span(), quote!(pub fn #solve_for(&self) -> #name<T> { ::reuleaux::Slice::of(*self) }));
        quote!(#page #[must_use] #function)
    }

    fn slice(&self, number_of_slice: usize, method: &Method, slice: &Slice) -> TokenStream {
        let Some(first) = method.members.first().map(|member| &self.model.outputs[*member]) else { return quote!() };
        let (mechanism, visibility, word) = (&self.model.name, &self.model.visibility, plain(&method.name));
        let [name, state] = ["", "State"].map(|what| slice_name(&format_ident!("{mechanism}{what}"), &self.model.methods, &word));
        let shelf = StateLayout::new(&slice.held, &[], format!("for_{word}_"));
        let (body, kernels) = self.solving(&slice.solution.solving, &shelf);
        let (plan, lists) = (plan_constant(self.model, self.system, &slice.solution), self.lists_of_slice(&slice.solution, &shelf));
        let (width, value): (usize, fn(TokenStream) -> TokenStream) = match first.components.len() {
            0 if !self.system.frames.is_empty() => (3 + COSINES, |place| quote!(state.spatial_body(#place, #place + 3))),
            0 => (3, |place| quote!(state.planar_body(#place))),
            3 => (3, |place| quote!(state.point_in_space(#place))),
            1 => (1, |place| quote!(state.coordinate(#place))),
            _ => (2, |place| quote!(state.point(#place))),
        };
        let components = width * method.members.len();
        let value = |place: TokenStream| {
            let motion = value(place.clone());
            match first.derivatives {
                // A state holds velocities as rates,
                1 => quote!(#motion.of_rate()),
                // and third derivatives as accelerations.
                3 => {
                    let jerk = value(quote!(#place + #components));
                    quote!(#motion.with_jerk(#jerk.acceleration))
                }
                _ => motion,
            }
        };
        let components = if first.derivatives == 3 { 2 * components } else { components };
        let places: Vec<usize> = (0..method.members.len()).map(|member| slice.held.len() - components + width * member).collect();
        let (value, kind) = (array_at(&places, &method.sizes, value), array_type(self.output_type(first), &method.sizes));
        let (outputs, components) = self.components_of(method, components);
        let upstream = upstream(&slice.solution.solving, slice.held.len(), &body);
        let [n, whole, order] = [slice.held.len(), self.system.width(), number_of_slice].map(number);
        let held = slice.held.iter().map(|unknown| number(*unknown));
        let page = docs::line(&format!(
            "What is upstream of the output `{word}` of [`{mechanism}`], and nothing else, made by [`{mechanism}::solve_for_{word}`]."
        ));
        let page_of_state = docs::line(&format!("A state of [`{name}`]: the output, and what the next state is found from."));
        let (allowed, whole_state, in_whole) = (allowed(), state_path(mechanism), in_whole(number_of_slice));
        quote! {
            #page
            #[allow(non_camel_case_types, dead_code)]
            #visibility type #name<T = ::core::primitive::f64> = ::reuleaux::Slice<#mechanism<T>, T, #order, #n, #whole>;
            #page_of_state
            #[allow(non_camel_case_types, dead_code)]
            #visibility type #state<T = ::core::primitive::f64> = ::reuleaux::SliceState<#mechanism<T>, T, #order, #n, #whole>;
            #kernels
            #allowed
            impl<T: ::reuleaux::SolverReal> ::reuleaux::Sliced<T, #order, #n, #whole> for #mechanism<T> {
                type Value = #kind;
                #plan
                const HELD: [::core::primitive::usize; #n] = [#(#held),*];
                const OUTPUTS: &'static [::reuleaux::OutputName] = &[#(#outputs),*];
                const COMPONENTS: &'static [::reuleaux::Coordinate] = &[#(#components),*];
                #lists
                fn output(state: &::reuleaux::State<T, #n>) -> Self::Value { #value }
                #upstream
            }
            #allowed
            impl<T: ::reuleaux::Real> ::reuleaux::HasOutput<#mechanism<T>, #order> for #whole_state<T> {
                type Value = #kind;
                fn output_of(&self, mechanism: &#mechanism<T>) -> Self::Value { mechanism.#in_whole(self) }
            }
        }
    }

    /// Names and units of the components of an output, and the entries of the state that hold them: the components, and if they are twice as many
    /// their third derivatives.
    fn components_of(&self, method: &Method, entries: usize) -> (Vec<TokenStream>, Vec<TokenStream>) {
        let outputs: Vec<(String, [String; 4])> =
            method.members.iter().flat_map(|member| docs::components(self.system, &self.model.outputs[*member])).collect();
        let is_of_velocities = method.members.iter().any(|member| self.model.outputs[*member].derivatives == 1);
        let entry = |entry: usize| {
            let name = outputs.get(entry % outputs.len()).map_or("", |output| output.0.as_str());
            let (whole, part) = name.rsplit_once('.').unwrap_or((name, "value"));
            match entry < outputs.len() {
                true if is_of_velocities => quote!(::reuleaux::Coordinate::velocity(#whole, #part)),
                // Entries of a rotation matrix.
                true if part.len() == 3 && part.starts_with('a') && part.ends_with(['1', '2', '3']) => {
                    quote!(::reuleaux::Coordinate::number(#whole, #part))
                }
                true => quote!(::reuleaux::Coordinate::length(#whole, #part)),
                false => quote!(::reuleaux::Coordinate::jerk(#whole, #part)),
            }
        };
        let entries = (0..entries).map(entry).collect();
        (outputs.into_iter().map(output_name).collect(), entries)
    }

    /// Names, start and size of the moving part: those of the mechanism, as far as they belong to it.
    fn description(&self, name: &Ident, shelf: &StateLayout) -> TokenStream {
        let (mechanism, whole) = (&self.model.name, number(self.system.width()));
        let of_mechanism = quote!(<#mechanism<T> as ::reuleaux::Description<T, #whole>>);
        let held = || shelf.held.iter().map(|unknown| number(*unknown));
        let coordinates = held().map(|index| quote!(#of_mechanism::COORDINATES[#index]));
        let start = held().map(|index| quote!(start[#index]));
        let (of_q, n) = (vector_type(shelf.held.len()), number(shelf.held.len()));
        quote! {
            impl<T: ::reuleaux::Real> ::reuleaux::Description<T, #n> for #name<T> {
                const NAME: &'static ::core::primitive::str = #of_mechanism::NAME;
                const COORDINATES: &'static [::reuleaux::Coordinate] = &[#(#coordinates),*];
                const ROWS: &'static [::reuleaux::Row] = #of_mechanism::ROWS;
                fn start(&self) -> #of_q {
                    let start = self.0.start();
                    ::core::convert::From::from([#(#start),*])
                }
                fn characteristic_length(&self) -> T { self.0.characteristic_length() }
                fn validate(&self) -> ::core::result::Result<(), ::reuleaux::ParameterOutOfRange<T>> { self.0.validate() }
            }
        }
    }

    /// A step that solves the moving part only, and the type of that part; nothing if everything moves.
    pub(super) fn moving(&self) -> (TokenStream, TokenStream) {
        let Some(slice) = &self.plan.moving else { return (quote!(), quote!()) };
        let (mechanism, n) = (&self.model.name, slice.held.len());
        let name = format_ident!("{}Moving", mechanism, span = Span::call_site());
        let shelf = StateLayout::new(&slice.held, &slice.given, "moving_".to_owned());
        let (body, kernels) = self.solving(&slice.solution.solving, &shelf);
        let (description, constants) = (self.description(&name, &shelf), self.lists(&slice.solution, &shelf));
        let (count, places) = (number(slice.given.len()), slice.given.iter().map(|unknown| number(*unknown)));
        let held = slice.held.iter().map(|unknown| Literal::usize_unsuffixed(*unknown));
        let (t, pass, given, stages) = (local("t"), local("pass"), local("given"), local("stages_of_what_moves"));
        let (argument, to, result) = results(&slice.solution.solving, n);
        let of_trait = stages_of(&slice.solution.solving, n, &quote!(self.0.#stages(&self.1, #t, #pass, #argument)));
        let ([whole, n], allowed) = ([self.system.width(), n].map(number), allowed());
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
            /// The moving part of a mechanism that rests in part, with the numbers that it takes from the rest.
            #[derive(Clone, Copy)]
            #[doc(hidden)]
            struct #name<T>(#mechanism<T>, [T; #count]);
            #kernels
            #allowed
            impl<T: ::reuleaux::SolverReal> #mechanism<T> {
                #[doc(hidden)]
                #[inline(always)]
                fn #stages(&self, #given: &[T; #count], #t: T, #pass: &mut ::reuleaux::Solver<'_, T, #n>, #to) -> #result { #body }
            }
            #description
            impl<T: ::reuleaux::SolverReal> ::reuleaux::Stages<T, #n> for #name<T> {
                #constants
                #of_trait
            }
        };
        (step, part)
    }
}

/// The function of the trait `Sliced` that solves.
fn upstream(solving: &Solving, n: usize, body: &TokenStream) -> TokenStream {
    let (t, pass) = (local("t"), local("pass"));
    let (_, to, result) = results(solving, n);
    let n = number(n);
    let pass = quote!(#pass: &mut ::reuleaux::Solver<'_, T, #n>);
    match solving {
        Solving::Straight(_) => quote!(#[inline(always)] fn upstream(&self, #t: T, #pass) -> #result { #body }),
        Solving::Shared(_) => quote! {
            const IN_PLACE: ::core::primitive::bool = true;
            #[inline(always)]
            fn upstream_in_place(&self, #t: T, #pass, #to) -> #result { #body }
        },
    }
}

/// The name of an output, whether it is raw or not.
pub(crate) fn plain(name: &Ident) -> String {
    name.to_string().trim_start_matches("r#").to_owned()
}

/// The type of a slice, `CrankRockerForTip`; outputs whose names differ in case only keep it.
pub(crate) fn slice_name(mechanism: &Ident, methods: &[Method], output: &str) -> Ident {
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
