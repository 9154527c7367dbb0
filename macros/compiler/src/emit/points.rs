//! The motions of declared points and axes, for `#[points]`.

use super::functions::Emitter;
use super::literal::number;
use super::routine::{RoutinePrinter, lines};
use super::{allowed, docs, open, placed, state_path};
use crate::model::sketch::NamedPoint;
use crate::plan::Routine;
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

/// The name of the generated struct.
pub(crate) fn type_name(mechanism: &Ident) -> Ident {
    format_ident!("{}Points", mechanism, span = Span::call_site())
}

/// The struct, and the function that returns it.
pub(crate) fn structure(name: &Ident, visibility: &TokenStream, state: &TokenStream, methods: &TokenStream) -> TokenStream {
    let (points, page) = (type_name(name), format!("The points and axes of a [`{name}`] in a state."));
    let (allowed, open) = (allowed(), open());
    let page = docs::line(&page);
    quote! {
        #page
        #[derive(Clone, Copy, Debug)]
        #allowed
        #visibility struct #points<'a, T = ::core::primitive::f64> {
            mechanism: &'a #name<T>,
            state: &'a #state<T>,
        }
        #allowed
        impl<T: ::reuleaux::Real> #name<T> {
            /// The motions of declared points and axes in a state, each computed when it is called.
            #[must_use]
            pub fn points<'a>(&'a self, state: &'a #state<T>) -> #points<'a, T> { #points { mechanism: self, state } }
        }
        #allowed
        #open
        impl<T: ::reuleaux::Real> #points<'_, T> { #methods }
    }
}

impl Emitter<'_> {
    /// The struct with a method for each point and axis
    pub(super) fn points(&self) -> TokenStream {
        let Some(routines) = self.plan.marks.as_ref().filter(|_| self.model.task.is_determined()) else { return quote!() };
        let sketch = &self.model.sketch;
        let kinds = sketch.points.iter().map(|_| false).chain(sketch.axes.iter().map(|_| true));
        let marks = sketch.points.iter().chain(&sketch.axes).zip(kinds).zip(routines);
        let methods: TokenStream = marks.map(|((mark, is_axis), routine)| self.moving_mark(mark, is_axis, routine)).collect();
        structure(&self.model.name, &self.model.visibility, &state_path(&self.model.name), &methods)
    }

    fn moving_mark(&self, mark: &NamedPoint, is_axis: bool, routine: &Routine) -> TokenStream {
        let mut routine = routine.clone();
        for name in routine.names.values_mut().filter(|name| name.starts_with("self.")) {
            name.insert_str("self.".len(), "mechanism.");
        }
        let RoutinePrinter { steps, results, .. } = lines(self.model, &self.model.sketch.arena, &routine);
        let (what, unit, method) = if is_axis { ("axis", "", "vector") } else { ("point", " (m)", "point") };
        let (vector, method) = (if results.len() == 2 { quote!(Vector2) } else { quote!(Vector3) }, Ident::new(method, Span::call_site()));
        let vector = quote!(::reuleaux::nalgebra::#vector);
        let (body, owner) = match mark.at.body.map(|body| &self.model.bodies[body].name) {
            Some(name) => (name.local.clone(), self.model.drawn_name(mark.at.body)),
            None => ("ground".to_owned(), "ground".to_owned()),
        };
        let own = mark.name.replace("r#", "");
        let name = format_ident!("{body}_{}", own.replace('[', "_").replace(']', ""));
        let page = docs::line(&format!("The {what} `{own}` of `{owner}`{unit}, in ground, with its first and second derivative in time."));
        let local = quote!(#vector::new(#(#results),*));
        let motion = match mark.at.body.map(|body| (body, self.model.ambient.first_coordinate(body))) {
            None => quote!(::reuleaux::Motion::fixed(#local)),
            Some((_, place)) if self.system.frames.is_empty() => {
                let place = number(place);
                quote!(self.state.planar_body(#place).#method(#local))
            }
            Some((body, place)) => {
                let (place, orientation) = (number(place), number(self.system.entries_of(body).start));
                quote!(self.state.spatial_body(#place, #orientation).#method(#local))
            }
        };
        let function = placed(mark.span, quote!(pub fn #name(&self) -> ::reuleaux::Motion<#vector<T>> { #steps #motion }));
        quote!(#page #[must_use] #function)
    }
}
