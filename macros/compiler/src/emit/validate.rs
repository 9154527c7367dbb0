//! The generated check of parameters: each is finite, lies within its bounds, and meets the conditions of the joints.

use super::expression::place;
use super::functions::Emitter;
use super::literal::signed;
use super::routine::RoutinePrinter;
use crate::expr::Leaf;
use crate::model::{Bounds, Parameter, Requirement};
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

impl Emitter<'_> {
    /// Conditions on parameters
    pub(super) fn validate(&self) -> TokenStream {
        let RoutinePrinter { steps, results, .. } = self.lines(&self.plan.requirements);
        let (finite, bounded) = (self.finite(), self.bounded());
        let required = self.model.requirements.iter().zip(results.chunks(2)).map(|(requirement, sides)| {
            let (lhs, rhs) = (&sides[0], &sides[1]);
            let relation = Ident::new(&format!("{:?}", requirement.relation), Span::call_site());
            let Culprit { name, value, unit, why } = self.parameter_in(requirement, lhs);
            quote!(::reuleaux::require(#lhs, ::reuleaux::Relation::#relation, #rhs, (#name, #value, #unit), #why)?;)
        });
        quote! {
            /// Whether every parameter is finite, lies within its bounds and meets the demands of the joints.
            ///
            /// # Errors
            /// The first parameter that does not.
            pub fn validate(&self) -> ::core::result::Result<(), ::reuleaux::ParameterOutOfRange<T>> {
                #finite
                #bounded
                #steps
                #(#required)*
                ::core::result::Result::Ok(())
            }
        }
    }

    /// Every parameter is finite
    fn finite(&self) -> TokenStream {
        if self.model.parameters.is_empty() {
            return quote!();
        }
        let parameters = self.model.parameters.iter().map(named);
        quote!(::reuleaux::finite(&[#(#parameters),*])?;)
    }

    /// Every parameter lies within its declared bounds; neighbours with the same ones are checked together.
    fn bounded(&self) -> TokenStream {
        let mut known: Vec<(&Bounds, Vec<&Parameter>)> = Vec::new();
        for parameter in &self.model.parameters {
            let Some(bounds) = &parameter.bounds else { continue };
            match known.last_mut() {
                Some((alike, members)) if *alike == bounds => members.push(parameter),
                _ => known.push((bounds, vec![parameter])),
            }
        }
        let checked = |(bounds, parameters): (&Bounds, Vec<&Parameter>)| {
            let why = format!("it must lie in {}", bounds.text);
            let [from, to] = [bounds.from, bounds.to].map(|end| end.map(signed));
            let range = if bounds.is_inclusive { quote!(#from..=#to) } else { quote!(#from..#to) };
            let parameters = parameters.into_iter().map(named);
            quote!(::reuleaux::within(#range, #why, &[#(#parameters),*])?;)
        };
        known.into_iter().map(checked).collect()
    }

    /// The parameter a requirement is about, or the joint that asks for it.
    fn parameter_in(&self, requirement: &Requirement, lhs: &TokenStream) -> Culprit {
        let parameter = |leaf: &Leaf| match leaf {
            Leaf::Parameter(index) => self.model.parameters.get(*index as usize),
            _ => None,
        };
        let leaves = self.system.arena.leaves(requirement.lhs);
        let parameters: Vec<&Parameter> = leaves.iter().filter_map(parameter).collect();
        let Requirement { joint, why, .. } = requirement;
        if let [only] = parameters.as_slice() {
            let place = place(&only.name.path);
            let (value, unit) = (quote!(self.#place), only.dim.unit());
            return Culprit { name: only.name.told().to_owned(), value, unit, why: format!("{why} (`{joint}`)") };
        }
        let names: Vec<String> = parameters.iter().map(|parameter| format!("`{}`", parameter.name.told())).collect();
        let follows = if names.is_empty() { String::new() } else { format!(" (it follows from {})", names.join(", ")) };
        Culprit { name: joint.clone(), value: lhs.clone(), unit: requirement.dim.unit(), why: format!("{why}{follows}") }
    }
}

/// A parameter by name, value and unit.
fn named(parameter: &Parameter) -> TokenStream {
    let (path, place, unit) = (parameter.name.told(), place(&parameter.name.path), parameter.dim.unit());
    quote!((#path, self.#place, #unit))
}

/// Name in the message if a requirement is not met.
struct Culprit {
    name: String,
    value: TokenStream,
    unit: String,
    why: String,
}
