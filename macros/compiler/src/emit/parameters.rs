//! The generated structs of parameters: that of the mechanism, and one for each component that has any.

use super::arrays::{array_from, array_type};
use super::expression::local;
use super::literal::real;
use super::{allowed, docs, docs_or, serial};
use crate::hints::is_of_generated_type;
use crate::model::{Component, Field, Layout, Model, Of, Part};
use crate::system::System;
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

/// The structs of a mechanism.
pub(crate) struct Parameters<'a> {
    layout: &'a Layout,
    mechanism: &'a Ident,
    /// Which components have parameters, themselves or in their parts.
    has_any: Vec<bool>,
}

/// What keeps the types of a component that was refused for its name, in a stub, apart from those whose name it has.
pub(super) fn apart(component: &Ident) -> &'static str {
    if is_of_generated_type(&component.to_string()) { "Refused" } else { "" }
}

/// The other number type of a function over two: not the mechanism, whatever it is called.
pub(crate) fn over(mechanism: &Ident) -> Ident {
    Ident::new(if mechanism == "T2" { "T3" } else { "T2" }, Span::call_site())
}

impl<'a> Parameters<'a> {
    pub(crate) fn new(layout: &'a Layout, mechanism: &'a Ident) -> Parameters<'a> {
        Parameters { layout, mechanism, has_any: holders(layout, Of::Parameter) }
    }

    /// The struct of a component, `WalkerLeg`.
    fn structure(&self, component: usize) -> Ident {
        match &self.layout.components[component].name {
            None => self.mechanism.clone(),
            Some(name) => format_ident!("{}{}{}", self.mechanism, apart(name), name, span = name.span()),
        }
    }

    /// The fields of the struct of a component, each with its number in the layout.
    fn fields(&self, component: usize) -> impl Iterator<Item = (usize, &'a Field)> {
        let is_field = |field: &Field| match field.of {
            Of::Parameter | Of::Input => true,
            Of::Part(inner) => self.has_any[inner],
            Of::Body | Of::Output => false,
        };
        self.layout.components[component].fields.iter().enumerate().filter(move |(_, field)| is_field(field))
    }

    /// Name and type of each field.
    pub(crate) fn types(&self, component: usize) -> Vec<(&'a Ident, TokenStream)> {
        let of_field = |(_, field): (usize, &'a Field)| {
            let element = match field.of {
                Of::Part(inner) => {
                    let structure = self.structure(inner);
                    quote!(#structure<T>)
                }
                Of::Input => quote!(::reuleaux::Motion<T>),
                _ => quote!(T),
            };
            (&field.name, array_type(element, &field.sizes))
        };
        self.fields(component).map(of_field).collect()
    }

    /// The components that have a struct of their own, by number.
    pub(crate) fn structures(&self) -> impl Iterator<Item = (usize, Ident)> {
        (1..self.layout.components.len())
            .filter(|component| self.has_any[*component])
            .map(|component| (component, self.structure(component)))
    }

    /// Names of parameters may have capitals, as those of points have; rustc would warn of such fields.
    pub(super) fn capitals(&self, component: usize) -> Option<TokenStream> {
        let is_capital = self.fields(component).any(|(_, field)| field.name.to_string().contains(char::is_uppercase));
        is_capital.then(|| quote!(#[allow(non_snake_case)]))
    }

    /// Fields with their documentation.
    pub(super) fn documented(&self, model: &Model, component: usize) -> TokenStream {
        let part = self.layout.parts.iter().find(|part| part.component == component);
        let fields = self.fields(component).zip(self.types(component)).map(|((number, field), (name, kind))| {
            let first = part.and_then(|part| part.members[number].first()).copied();
            let known = match (field.of, first.and_then(|first| model.parameters.get(first))) {
                (Of::Parameter, Some(parameter)) => docs::parameter(parameter),
                (Of::Input, Some(parameter)) => docs::input(parameter),
                (Of::Part(inner), _) if self.is_of_inputs(inner) => {
                    "The inputs that `phi`, `nu`, `gamma` and the functions of traits read; those that solve take theirs as an argument."
                        .to_owned()
                }
                _ => format!("The parameters of `{name}`."),
            };
            let docs = docs_or(&field.docs, &known);
            let (passed, listed) = (&field.docs.passed, serial::listed(model.requests.serde.as_ref(), &field.sizes));
            quote!(#docs #listed #passed pub #name: #kind,)
        });
        quote!(#(#fields)*)
    }

    /// The structs of components.
    pub(super) fn components(&self, model: &Model, system: &System) -> TokenStream {
        let values = docs::default_values(model, system);
        let visibility = &model.visibility;
        let structure = |(component, name): (usize, Ident)| {
            let declared = &self.layout.components[component];
            let docs = docs_or(&declared.docs, &self.page(declared));
            let fields = self.documented(model, component);
            let defaults = self.component_defaults(component, &name, &values);
            let (allowed, gathering) = (allowed(), self.gathering(component, &name));
            let between = self.is_of_inputs(component).then(|| self.between(component));
            // States hold inputs, so that the struct stands beside theirs.
            let is_apart = model.holds_inputs() && self.is_of_inputs(component);
            let structure = (!is_apart).then(|| {
                let capitals = self.capitals(component);
                let (passed, serial) =
                    (&declared.docs.passed, serial::derived(model.requests.serde.as_ref(), Some(&name).filter(|_| !defaults.is_empty())));
                quote! {
                    #docs
                    #[derive(Clone, Copy, Debug, PartialEq)]
                    #serial
                    #capitals
                    #passed
                    #visibility struct #name<T = ::core::primitive::f64> { #fields }
                }
            });
            quote! {
                #structure
                #defaults
                #allowed
                impl<T: ::reuleaux::Real> #name<T> { #gathering #between }
            }
        };
        self.structures().map(structure).collect()
    }

    /// The struct of inputs, for the module of the state.
    pub(super) fn inputs(&self, model: &Model) -> TokenStream {
        let of_inputs = self.structures().filter(|(component, _)| self.is_of_inputs(*component)).map(|(component, name)| {
            let (page, fields) = (docs::line(&self.page(&self.layout.components[component])), self.documented(model, component));
            let serial = serial::derived(model.requests.serde.as_ref(), None);
            quote! {
                #page
                #[derive(Clone, Copy, Debug, PartialEq)]
                #serial
                pub struct #name<T = ::core::primitive::f64> { #fields }
            }
        });
        of_inputs.collect()
    }

    /// True for the struct of inputs.
    fn is_of_inputs(&self, component: usize) -> bool {
        self.layout.components[component].fields.iter().any(|field| field.of == Of::Input)
    }

    fn page(&self, component: &Component) -> String {
        if component.fields.iter().any(|field| field.of == Of::Input) {
            return format!("The inputs of a `{}`, each with its rate and its acceleration.", self.mechanism);
        }
        let name = component.name.as_ref().map(Ident::to_string).unwrap_or_default();
        format!("The parameters of a `{name}` in [`{}`].", self.mechanism)
    }

    /// A component whose parts all have the same defaults has them itself.
    fn component_defaults(&self, component: usize, name: &Ident, values: &[f64]) -> TokenStream {
        // All inputs must be given: an omitted one would be forgotten.
        if self.is_of_inputs(component) {
            return quote!();
        }
        let Some(literal) = self.common(component, values) else { return quote!() };
        let allowed = allowed();
        quote! {
            impl ::core::default::Default for #name<::core::primitive::f64> {
                fn default() -> Self { Self::with_defaults() }
            }
            #allowed
            impl<T: ::reuleaux::Real> #name<T> {
                /// The parameters at their declared defaults, over any number type.
                #[must_use]
                pub fn with_defaults() -> Self { #literal }
            }
        }
    }

    /// The defaults that all parts of a component have.
    fn common(&self, component: usize, values: &[f64]) -> Option<TokenStream> {
        let parts = self.layout.parts.iter().filter(|part| part.component == component);
        let mut literals = parts.map(|part| self.literal(part, &quote!(Self), values));
        let first = literals.next()?;
        let text = first.to_string();
        literals.all(|other| other.to_string() == text).then_some(first)
    }

    /// The defaults of the mechanism.
    pub(super) fn defaults(&self, values: &[f64]) -> TokenStream {
        self.layout.parts.first().map(|part| self.fields_of(part, values)).unwrap_or_default()
    }

    fn literal(&self, part: &Part, name: &TokenStream, values: &[f64]) -> TokenStream {
        let fields = self.fields_of(part, values);
        quote!(#name { #fields })
    }

    fn fields_of(&self, part: &Part, values: &[f64]) -> TokenStream {
        let field = |(number, field): (usize, &Field)| {
            let element = |member: &usize| match field.of {
                Of::Part(inner) => {
                    let structure = self.structure(inner);
                    self.literal(&self.layout.parts[*member], &quote!(#structure), values)
                }
                Of::Input => {
                    let [value, rate, acceleration] = [0, 1, 2].map(|order| real(values.get(member + order).copied().unwrap_or_default()));
                    quote!(::reuleaux::Motion { value: #value, rate: #rate, acceleration: #acceleration })
                }
                _ => real(values.get(*member).copied().unwrap_or_default()),
            };
            let (name, value) = (&field.name, array_from(part.members[number].iter().map(element).collect(), &field.sizes));
            quote!(#name: #value,)
        };
        self.fields(part.component).map(field).collect()
    }
}

impl Parameters<'_> {
    /// Every field combined from those of several, for `Family`.
    pub(super) fn gathered(&self, component: usize) -> TokenStream {
        // In the mechanism's own function the names are written by hand.
        let name = |name: &str| if component == 0 { Ident::new(name, Span::call_site()) } else { local(name) };
        let (each, combine, one) = (name("each"), name("combine"), local("one"));
        let field = |(_, field): (usize, &Field)| {
            let (name, rounds) = (&field.name, (0..field.sizes.len()).map(|rank| local(&format!("i{rank}"))).collect::<Vec<_>>());
            let place = quote!(#one.#name #([#rounds])*);
            let element = match field.of {
                Of::Part(inner) => {
                    let structure = self.structure(inner);
                    let combine = if component == 0 { quote!(&#combine) } else { quote!(#combine) };
                    quote!(#structure::gathered(#each.map(|#one| &#place), #combine))
                }
                Of::Input => {
                    let part = |part: TokenStream| quote!(#part: #combine(#each.map(|#one| #place.#part)));
                    let parts = [quote!(value), quote!(rate), quote!(acceleration)].map(part);
                    quote!(::reuleaux::Motion { #(#parts),* })
                }
                _ => quote!(#combine(#each.map(|#one| #place))),
            };
            let value = rounds.iter().rev().fold(element, |inner, round| quote!(::core::array::from_fn(|#round| #inner)));
            quote!(#name: #value,)
        };
        self.fields(component).map(field).collect()
    }

    /// The same as a function of a component.
    fn gathering(&self, component: usize, name: &Ident) -> TokenStream {
        let (each, combine) = (local("each"), local("combine"));
        let fields = self.gathered(component);
        quote! {
            #[doc(hidden)]
            #[inline]
            fn gathered<T2: ::reuleaux::Real, const LANES: ::core::primitive::usize>(
                #each: [&Self; LANES],
                #combine: &impl ::core::ops::Fn([T; LANES]) -> T2,
            ) -> #name<T2> {
                #name { #fields }
            }
        }
    }
}

impl Parameters<'_> {
    /// Inputs on their way from some to others, for the runtime.
    fn between(&self, component: usize) -> TokenStream {
        let (from, to, h, share) = (local("from"), local("to"), local("h"), local("share"));
        let field = |(_, field): (usize, &Field)| {
            let (name, rounds) = (&field.name, (0..field.sizes.len()).map(|rank| local(&format!("i{rank}"))).collect::<Vec<_>>());
            let place = quote!(#name #([#rounds])*);
            let element = quote!(::reuleaux::Motion::between(&#from.#place, &#to.#place, #h, #share));
            let value = rounds.iter().rev().fold(element, |inner, round| quote!(::core::array::from_fn(|#round| #inner)));
            quote!(#name: #value,)
        };
        let fields: TokenStream = self.fields(component).map(field).collect();
        quote! {
            #[doc(hidden)]
            fn between(#from: &Self, #to: &Self, #h: [T; 2], #share: T) -> Self { Self { #fields } }
        }
    }
}

/// Which components hold something of a kind, themselves or in their parts.
pub(super) fn holders(layout: &Layout, what: Of) -> Vec<bool> {
    let mut found = vec![false; layout.components.len()];
    // A part stands after the mechanism or part that contains it, but a component may be used before another that it contains.
    for _ in 0..layout.components.len() {
        let before = found.clone();
        for (component, declared) in layout.components.iter().enumerate() {
            found[component] |= declared.fields.iter().any(|field| match field.of {
                Of::Part(inner) => before[inner],
                Of::Input => what == Of::Parameter,
                of => of == what,
            });
        }
        if before == found {
            break;
        }
    }
    found
}
