//! The generated state: named access to bodies, and views of parts.

use super::arrays::{array_at, array_type};
use super::literal::number;
use super::parameters::{apart, holders};
use super::{allowed_at_places, docs, docs_or, placed, state_name};
use crate::model::{Field, Layout, Of, Part};
use crate::quantity::Ambient;
use crate::syntax::plain;
use crate::system::COSINES;
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

/// The accessors of a mechanism's state and of the views of its parts.
pub(crate) struct Accessors<'a> {
    layout: &'a Layout,
    mechanism: &'a Ident,
    visibility: &'a TokenStream,
    /// Which components have bodies, themselves or in their parts.
    has_any: Vec<bool>,
    /// Body of every accessor in a stub.
    body: Option<&'a TokenStream>,
    /// In space: where the orientations begin in a state.
    orientations: Option<usize>,
}

impl<'a> Accessors<'a> {
    pub(crate) fn new(
        layout: &'a Layout,
        mechanism: &'a Ident,
        visibility: &'a TokenStream,
        body: Option<&'a TokenStream>,
    ) -> Accessors<'a> {
        Accessors { layout, mechanism, visibility, has_any: holders(layout, Of::Body), body, orientations: None }
    }

    /// The same in space, where orientations begin at an index of the state.
    pub(crate) fn in_space(self, orientations: Option<usize>) -> Accessors<'a> {
        Accessors { orientations, ..self }
    }

    fn ambient(&self) -> Ambient {
        if self.orientations.is_some() { Ambient::Space } else { Ambient::Plane }
    }

    /// A body of a state, by the place of its origin.
    fn view_of(&self, state: TokenStream, place: TokenStream) -> TokenStream {
        body_view(&state, &place, self.orientations)
    }

    /// The view of a component's part, `WalkerStateLeg`.
    fn view(&self, component: usize) -> Ident {
        let name = self.layout.components[component].name.as_ref();
        let name = name.map(|name| format!("{}{}", apart(name), plain(name))).unwrap_or_default();
        format_ident!("{}State{}", self.mechanism, name)
    }

    /// The accessors of the mechanism's own bodies and parts, as methods of its state.
    pub(crate) fn of_mechanism(&self) -> TokenStream {
        self.of(0, |place| self.view_of(quote!(self.0), place), |view, place| quote!(#view { state: &self.0, first: #place }))
    }

    /// The views of parts, over a state of `n` coordinates.
    pub(crate) fn views(&self, n: usize) -> TokenStream {
        let (visibility, state) = (self.visibility, state_name(self.mechanism));
        let view = |component: usize| {
            let (view, declared) = (self.view(component), &self.layout.components[component]);
            let page = format!("A `{}` in a [`{state}`].", declared.name.as_ref().map(Ident::to_string).unwrap_or_default());
            let (page, allowed, n) = (docs::line(&page), allowed_at_places(), number(n));
            let accessors = self.of(
                component,
                |place| self.view_of(quote!(self.state), quote!(self.first + #place)),
                |view, place| quote!(#view { state: self.state, first: self.first + #place }),
            );
            quote! {
                #page
                #[derive(Clone, Copy, Debug, PartialEq)]
                #[allow(dead_code)]
                #visibility struct #view<'a, T = ::core::primitive::f64> {
                    #[doc(hidden)]
                    state: &'a ::reuleaux::State<T, #n>,
                    #[doc(hidden)]
                    first: ::core::primitive::usize,
                }
                #allowed
                impl<'a, T: ::reuleaux::Real> #view<'a, T> { #accessors }
            }
        };
        (1..self.layout.components.len()).filter(|component| self.has_any[*component]).map(view).collect()
    }

    fn of(
        &self,
        component: usize,
        body: impl Fn(TokenStream) -> TokenStream,
        part: impl Fn(Ident, TokenStream) -> TokenStream,
    ) -> TokenStream {
        let Some(first) = self.layout.parts.iter().find(|part| part.component == component) else { return quote!() };
        let lifetime = if component == 0 { quote!('_) } else { quote!('a) };
        let accessor = |(number, field): (usize, &Field)| {
            let name = &field.name;
            let (known, kind, value) = match field.of {
                Of::Body => {
                    let what = if self.orientations.is_some() { "orientation" } else { "angle (rad)" };
                    let known =
                        format!("{} place of its frame's origin (m) and {what}, with their rates.", called("body", "bodies", field));
                    let kind =
                        if self.orientations.is_some() { quote!(::reuleaux::SpatialBody<T>) } else { quote!(::reuleaux::PlanarBody<T>) };
                    let places = self.places(first, &first.members[number], |body| body);
                    (known, kind, array_at(&places, &field.sizes, &body))
                }
                Of::Part(inner) if self.has_any[inner] => {
                    let view = self.view(inner);
                    let places = self.places(first, &first.members[number], |part| self.layout.parts[part].first);
                    let value = array_at(&places, &field.sizes, |place| part(view.clone(), place));
                    (format!("{} its bodies and parts.", called("part", "parts", field)), quote!(#view<#lifetime, T>), value)
                }
                _ => return quote!(),
            };
            let (docs, kind, value) = (docs_or(&field.docs, &known), array_type(kind, &field.sizes), self.body.unwrap_or(&value));
            let function = placed(name.span(), quote!(pub fn #name(&self) -> #kind { #value }));
            quote!(#docs #[must_use] #function)
        };
        self.layout.components[component].fields.iter().enumerate().map(accessor).collect()
    }

    /// Where the coordinates of some bodies begin, from the first of a part's own.
    fn places(&self, part: &Part, members: &[usize], body: impl Fn(usize) -> usize) -> Vec<usize> {
        members.iter().map(|member| self.ambient().first_coordinate(body(*member) - part.first)).collect()
    }
}

/// A body of a state, by the place of its origin, and in space by where orientations begin.
pub(super) fn body_view(state: &TokenStream, place: &TokenStream, orientations: Option<usize>) -> TokenStream {
    match orientations.map(number) {
        Some(first) => {
            let each = number(COSINES / Ambient::Space.components());
            quote!(#state.spatial_body(#place, #first + #each * (#place)))
        }
        None => quote!(#state.planar_body(#place)),
    }
}

/// ``The body `crank`:`` or ``The bodies `crank[0]` to `crank[4]`:``
fn called(one: &str, many: &str, field: &Field) -> String {
    if field.sizes.is_empty() {
        return format!("The {one} `{}`:", field.name);
    }
    let index = |of: fn(usize) -> usize| field.sizes.iter().map(|size| format!("[{}]", of(*size))).collect::<String>();
    format!("The {many} `{0}{1}` to `{0}{2}`:", field.name, index(|_| 0), index(|size| size - 1))
}
