//! The list of all outputs, for `#[outputs]`.

use super::functions::Emitter;
use super::literal::number;
use super::{allowed, docs, state_path};
use proc_macro2::{Ident, TokenStream};
use quote::quote;

impl Emitter<'_> {
    /// Names and units of the components of all outputs, and the trait `Outputs`
    pub(super) fn listing(&self) -> TokenStream {
        // Without outputs a mechanism that is not solved has no state.
        if self.model.requests.outputs.is_none() || !self.model.task.is_determined() && self.model.outputs.is_empty() {
            return quote!();
        }
        let members = self.model.methods.iter().flat_map(|method| &method.members);
        let components = members.flat_map(|member| docs::components(self.system, &self.model.outputs[*member]));
        let names: Vec<TokenStream> = components.map(output_name).collect();
        let methods: Vec<&Ident> = self.model.methods.iter().map(|method| &method.name).collect();
        let (name, n, count) = (&self.model.name, number(self.system.width()), number(names.len()));
        let (state, allowed) = (state_path(name), allowed());
        quote! {
            #allowed
            impl<T: ::reuleaux::Real> #name<T> {
                /// Names and units of the components of all outputs, in the order of [`Outputs::outputs`](::reuleaux::Outputs::outputs).
                pub const OUTPUTS: ::reuleaux::OutputNames<#count> = ::reuleaux::OutputNames([#(#names),*]);
            }
            #allowed
            impl<T: ::reuleaux::Real> ::reuleaux::Outputs<T, #n, #count> for #name<T> {
                type State = #state<T>;
                const OUTPUTS: ::reuleaux::OutputNames<#count> = Self::OUTPUTS;
                fn outputs_with_jerk(&self, state: &#state<T>) -> [::reuleaux::MotionWithJerk<T>; #count] {
                    ::reuleaux::listed(|visit| { #(::reuleaux::Output::each(&self.#methods(state), visit);)* })
                }
            }
        }
    }
}

/// Name and units of a component of an output.
pub(super) fn output_name((name, units): (String, [String; 4])) -> TokenStream {
    quote!(::reuleaux::OutputName { name: #name, units: [#(#units),*] })
}
