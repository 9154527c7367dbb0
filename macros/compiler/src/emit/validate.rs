//! The generated check of parameters: each is finite, lies within its bounds, and meets what the joints demand.

use super::expression::{local, place};
use super::functions::Emitter;
use super::routine::Lines;
use crate::expr::Leaf;
use crate::model::{Bounds, Parameter, Requirement};
use crate::syntax::ast::Relation;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

impl Emitter<'_> {
    /// Conditions on parameters
    pub(super) fn validate(&self) -> TokenStream {
        let Lines { steps, results, .. } = self.lines(&self.plan.requirements);
        let (finite, bounded) = (self.finite(), self.bounded());
        let checks = self.model.requirements.iter().zip(results.chunks(2)).map(|(requirement, sides)| {
            let (lhs, rhs) = (&sides[0], &sides[1]);
            let (zero, one) = (quote!(T::of(0.0)), quote!(T::of(1.0)));
            // Written without comparison operators, which not every number type has; what cannot be compared fails.
            let less = quote!(T::select_less(#lhs, #rhs, #one, #zero));
            let greater = quote!(T::select_less(#rhs, #lhs, #one, #zero));
            let fails = match requirement.relation {
                Relation::Different => quote!(#less + #greater == #zero),
                Relation::Equal => quote!((#lhs) != (#rhs)),
                Relation::Less => quote!(#less == #zero),
                Relation::Greater => quote!(#greater == #zero),
                Relation::LessOrEqual => quote!(#less == #zero && (#lhs) != (#rhs)),
                Relation::GreaterOrEqual => quote!(#greater == #zero && (#lhs) != (#rhs)),
            };
            let Culprit { name, value, unit, why } = self.parameter_in(requirement, lhs);
            quote! {
                if #fails {
                    return ::core::result::Result::Err(::reuleaux::ParameterOutOfRange { name: #name, value: #value, unit: #unit, why: #why });
                }
            }
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
                #(#checks)*
                ::core::result::Result::Ok(())
            }
        }
    }

    /// Every parameter is finite; x − x is 0 for every finite x and NaN for all others, over any number type.
    fn finite(&self) -> TokenStream {
        let refused = |name: &TokenStream, value: &TokenStream, unit: &TokenStream| {
            quote! {
                if (#value - #value) != T::of(0.0) {
                    return ::core::result::Result::Err(::reuleaux::ParameterOutOfRange {
                        name: #name,
                        value: #value,
                        unit: #unit,
                        why: "it must be finite",
                    });
                }
            }
        };
        self.each_of(&self.model.parameters.iter().collect::<Vec<_>>(), refused)
    }

    /// Every parameter lies within its declared bounds; those with the same ones are checked together.
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
            self.each_of(&parameters, |name, value, unit| {
                let (zero, one) = (quote!(T::of(0.0)), quote!(T::of(1.0)));
                let less = |lhs: TokenStream, rhs: TokenStream| quote!(T::select_less(#lhs, #rhs, #one, #zero));
                let from = bounds.from.map(|from| {
                    let less = less(quote!(#value), real(from));
                    quote!(#less == #one)
                });
                let to = bounds.to.map(|to| match bounds.is_inclusive {
                    true => {
                        let greater = less(real(to), quote!(#value));
                        quote!(#greater == #one)
                    }
                    false => {
                        let less = less(quote!(#value), real(to));
                        quote!(#less == #zero)
                    }
                });
                let fails = from.into_iter().chain(to);
                quote! {
                    if #(#fails)||* {
                        return ::core::result::Result::Err(::reuleaux::ParameterOutOfRange { name: #name, value: #value, unit: #unit, why: #why });
                    }
                }
            })
        };
        known.into_iter().map(checked).collect()
    }

    /// A check of some parameters by name, value and unit.
    fn each_of(&self, parameters: &[&Parameter], check: impl Fn(&TokenStream, &TokenStream, &TokenStream) -> TokenStream) -> TokenStream {
        let known = parameters.iter().map(|parameter| {
            let (path, place, unit) = (&parameter.name.path, place(&parameter.name.path), parameter.dim.unit());
            (quote!(#path), quote!(self.#place), quote!(#unit))
        });
        // One by one they read better; those of parts may be very many.
        if self.model.layout.parts.len() == 1 && self.model.parameters.iter().all(|parameter| parameter.name.indices.is_empty()) {
            return known.map(|(name, value, unit)| check(&name, &value, &unit)).collect();
        }
        let (name, value, unit) = (local("name"), local("value"), local("unit"));
        let all = known.map(|(name, value, unit)| quote!((#name, #value, #unit)));
        let check = check(&quote!(#name), &quote!(#value), &quote!(#unit));
        quote!(for (#name, #value, #unit) in [#(#all),*] { #check })
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
            return Culprit { name: only.name.to_string(), value, unit, why: format!("{why} (`{joint}`)") };
        }
        let names: Vec<String> = parameters.iter().map(|parameter| format!("`{}`", parameter.name)).collect();
        let follows = if names.is_empty() { String::new() } else { format!(" (it follows from {})", names.join(", ")) };
        Culprit { name: joint.clone(), value: lhs.clone(), unit: requirement.dim.unit(), why: format!("{why}{follows}") }
    }
}

/// What to name where a requirement is not met.
struct Culprit {
    name: String,
    value: TokenStream,
    unit: String,
    why: String,
}

/// A constant of the number type.
fn real(value: f64) -> TokenStream {
    let (sign, size) = (value.is_sign_negative().then(|| quote!(-)), Literal::f64_unsuffixed(value.abs()));
    quote!(T::of(#sign #size))
}
