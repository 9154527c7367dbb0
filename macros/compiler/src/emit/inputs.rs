//! The generated functions that solve a mechanism with inputs.

use super::literal::{number, vector_type};
use super::{allowed, state_path};
use crate::model::Model;
use crate::system::System;
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

/// The name of the generated struct of inputs.
pub(crate) fn type_name(mechanism: &Ident) -> Ident {
    format_ident!("{}Inputs", mechanism, span = Span::call_site())
}

/// The functions that solve, each with the inputs as its last argument, and the runtime's trait `Commanded`.
pub(super) fn solve(model: &Model, system: &System) -> TokenStream {
    let (name, state, inputs) = (&model.name, state_path(&model.name), type_name(&model.name));
    let (vector, n) = (vector_type(system.width()), number(system.width()));
    let result = quote!(::core::result::Result<#state<T>, ::reuleaux::Failure<T, #n>>);
    let (allowed, functions) = (allowed(), functions(&state, &inputs, &result, [&vector, &n]));
    quote! {
        #allowed
        impl<T: ::reuleaux::Real> #name<T> {
            /// The mechanism with the inputs of a state, for functions that read them from here: `phi`, `nu`, `gamma` and those of traits.
            #[must_use]
            pub fn with_inputs_of(&self, state: &#state<T>) -> Self { Self { inputs: state.1, ..*self } }
        }
        #allowed
        impl<T: ::reuleaux::Float> #name<T> {
            #functions
            /// The states at these times (s) with these inputs, each followed from the one before.
            pub fn sweep<I: ::core::iter::IntoIterator<Item = (T, #inputs<T>)>>(
                &self,
                times: I,
            ) -> impl ::core::iter::Iterator<Item = #result> + use<'_, T, I> {
                ::core::iter::Iterator::map(::reuleaux::sweep_with_inputs(*self, times), |result| {
                    result.map(|(state, inputs)| #state(state, inputs))
                })
            }
        }
        #allowed
        impl<T: ::reuleaux::Real> ::reuleaux::Commanded<T> for #name<T> {
            type Inputs = #inputs<T>;
            fn inputs(&self) -> #inputs<T> { self.inputs }
            fn at_start(&self) -> Self { Self { inputs: Self::with_defaults().inputs, ..*self } }
            fn with(&self, inputs: #inputs<T>) -> Self { Self { inputs, ..*self } }
            fn between(from: &#inputs<T>, to: &#inputs<T>, h: [T; 2], share: T) -> #inputs<T> { #inputs::between(from, to, h, share) }
        }
    }
}

fn functions(state: &TokenStream, inputs: &Ident, result: &TokenStream, [vector, n]: [&TokenStream; 2]) -> TokenStream {
    quote! {
        /// The state at time `t` (s) with these inputs, on the branch of the declared start, from which it is followed.
        ///
        /// # Errors
        /// Why there is no such state, with the last valid one on the way.
        pub fn solve(&self, t: T, inputs: #inputs<T>) -> #result {
            ::reuleaux::solve_with_inputs(self, t, inputs).map(|state| #state(state, inputs))
        }
        /// The state at time `t` (s) with these inputs that Newton's method finds from a guess of q.
        ///
        /// # Errors
        /// Why there is no such state.
        pub fn solve_near(&self, t: T, guess: &#vector, inputs: #inputs<T>) -> #result {
            let there = Self { inputs, ..*self };
            ::reuleaux::Mechanism::<T, #n>::solve_near(&there, t, guess).map(|state| #state(state, inputs))
        }
        /// The state at time `t` (s) with these inputs, followed from another state.
        ///
        /// # Errors
        /// Why there is no such state, with the last valid one on the way.
        pub fn solve_from(&self, t: T, from: &#state<T>, inputs: #inputs<T>) -> #result {
            let mut state = ::core::clone::Clone::clone(from);
            self.advance(&mut state, t, inputs).map(|()| state)
        }
        /// Takes a state to time `t` (s) and these inputs in place: [`solve_from`](Self::solve_from) without a copy. A state that
        /// cannot be taken there stays as it is.
        ///
        /// Inputs that have jumped are reached by a smooth motion from those of the state, so that the branch is kept.
        ///
        /// # Errors
        /// Why there is no such state, with the last valid one on the way.
        #[inline]
        pub fn advance(&self, state: &mut #state<T>, t: T, inputs: #inputs<T>) -> ::core::result::Result<(), ::reuleaux::Failure<T, #n>> {
            ::reuleaux::advance_with_inputs(self, &mut state.0, &mut state.1, t, inputs)
        }
        /// The same by one warm step, in bounded time: whether that was enough. If not, the state stays as it is.
        #[inline]
        pub fn advance_once(&self, state: &mut #state<T>, t: T, inputs: #inputs<T>) -> ::core::primitive::bool {
            ::reuleaux::advance_once_with_inputs(self, &mut state.0, &mut state.1, t, inputs)
        }
    }
}
