//! The motions of declared points and axes, for `#[points]`.

use super::arrays::{array_from, array_type};
use super::functions::Emitter;
use super::literal::number;
use super::routine::{RoutinePrinter, lines};
use super::{allowed, allowed_at_places, docs, identifier, placed, state_path};
use crate::model::sketch::NamedPoint;
use crate::plan::Routine;
use crate::quantity::Ambient;
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};
use std::collections::{BTreeMap, BTreeSet};

/// A point, or an axis, of an array, with its indices.
type Member<'a> = (Vec<usize>, &'a NamedPoint, bool);

/// The name of the generated struct.
pub(crate) fn type_name(mechanism: &Ident) -> Ident {
    format_ident!("{}Points", mechanism, span = Span::call_site())
}

/// The struct, and the function that returns it.
pub(crate) fn structure(name: &Ident, visibility: &TokenStream, state: &TokenStream, methods: &TokenStream) -> TokenStream {
    let (points, page) = (type_name(name), format!("The points and axes of a [`{name}`] in a state."));
    let (allowed, allowed_of_methods) = (allowed(), allowed_at_places());
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
        #allowed_of_methods
        impl<T: ::reuleaux::Real> #points<'_, T> { #methods }
    }
}

impl Emitter<'_> {
    /// The struct with a method for each point and axis
    pub(super) fn points(&self) -> TokenStream {
        let Some(routines) = self.plan.marks.as_ref().filter(|_| self.model.task.is_determined()) else { return quote!() };
        let sketch = &self.model.sketch;
        let kinds = sketch.points.iter().map(|_| false).chain(sketch.axes.iter().map(|_| true));
        let marks: Vec<(&NamedPoint, bool)> = sketch.points.iter().chain(&sketch.axes).zip(kinds).collect();
        let moving = marks.iter().zip(routines).map(|((mark, is_axis), routine)| self.moving_mark(mark, *is_axis, routine));
        let methods: TokenStream = moving.chain(self.arrays_of_marks(&marks)).collect();
        structure(&self.model.name, &self.model.visibility, &state_path(&self.model.name), &methods)
    }

    /// The path of a mark, `leg[3].rod.pin[0]`.
    fn path_of(&self, mark: &NamedPoint) -> String {
        let body = mark.at.body.map_or("ground", |body| &self.model.bodies[body].name.path);
        format!("{body}.{}", mark.name).replace("r#", "")
    }

    /// A method for each array of marks: all those whose paths differ in their indices alone, from 0 on without gaps. An array whose name is
    /// taken has none.
    fn arrays_of_marks(&self, marks: &[(&NamedPoint, bool)]) -> Vec<TokenStream> {
        let mut taken: BTreeSet<String> = marks.iter().map(|(mark, _)| word(&self.path_of(mark))).collect();
        let mut arrays: BTreeMap<String, Vec<Member>> = BTreeMap::new();
        for (mark, is_axis) in marks {
            let (plain, indices) = without_indices(&self.path_of(mark));
            if !indices.is_empty() {
                arrays.entry(plain).or_default().push((indices, mark, *is_axis));
            }
        }
        let arrays = arrays.into_iter().filter(|(plain, _)| taken.insert(word(plain)));
        arrays.filter_map(|(plain, members)| self.array_of_marks(&plain, members)).collect()
    }

    fn array_of_marks(&self, plain: &str, mut members: Vec<Member>) -> Option<TokenStream> {
        members.sort_by(|(one, ..), (other, ..)| one.cmp(other));
        let (last, mark, is_axis) = members.last()?;
        let sizes: Vec<usize> = last.iter().map(|index| index + 1).collect();
        let is_full = members.iter().all(|(_, _, other)| other == is_axis) && members.len() == sizes.iter().product::<usize>();
        if !is_full {
            return None;
        }
        let vector = match self.model.ambient {
            Ambient::Plane => quote!(Vector2),
            Ambient::Space => quote!(Vector3),
        };
        let kind = array_type(quote!(::reuleaux::Motion<::reuleaux::nalgebra::#vector<T>>), &sizes);
        let single = |(_, mark, _): &Member| {
            let name = identifier(&word(&self.path_of(mark)));
            quote!(self.#name())
        };
        let array = array_from(members.iter().map(single).collect(), &sizes);
        let what = if *is_axis { "axes" } else { "points" };
        let page = docs::line(&format!("The motions of all {what} `{plain}`, by their indices."));
        let name = identifier(&word(plain));
        let function = placed(mark.span, quote!(pub fn #name(&self) -> #kind { #array }));
        Some(quote!(#page #[must_use] #function))
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
        let (own, owner) = (mark.name.replace("r#", ""), self.model.drawn_name(mark.at.body));
        let name = identifier(&word(&self.path_of(mark)));
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

/// A path as one word: `leg_3_rod_pin_0` for `leg[3].rod.pin[0]`.
fn word(path: &str) -> String {
    path.replace(['.', '['], "_").replace(']', "")
}

/// A path without its indices, and the indices.
fn without_indices(path: &str) -> (String, Vec<usize>) {
    let (mut plain, mut indices) = (String::new(), Vec::new());
    for piece in path.split('[') {
        match piece.split_once(']').and_then(|(index, rest)| Some((index.parse().ok()?, rest))) {
            Some((index, rest)) => {
                indices.push(index);
                plain += rest;
            }
            None => plain += piece,
        }
    }
    (plain, indices)
}
