//! The loads of single joints, drives and forces: read from all loads, or computed alone.

use super::functions::Emitter;
use super::literal::number;
use super::loads::{are_steady, motion};
use super::routine::{RoutinePrinter, fast_lines};
use super::{docs, identifier, placed, state_path};
use crate::plan::{LoadKind, LoadsCode, NamedLoad};
use crate::quantity::Ambient;
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

/// How a load is read from multipliers and actions.
struct Reading {
    page: String,
    kind: TokenStream,
    call: TokenStream,
}

impl Emitter<'_> {
    /// One method for each joint, each drive and each force.
    pub(super) fn methods_of_loads(&self, code: &LoadsCode) -> TokenStream {
        let method = |load: &NamedLoad| {
            let Reading { page, kind, call } = self.reading(load, load.multipliers.start, load.actions.start);
            let (page, name) = (docs::line(&page), identifier(&load.name.local));
            let function = placed(load.name.word.span(), quote!(pub fn #name(&self) -> #kind { self.loads.#call }));
            quote!(#page #[must_use] #function)
        };
        code.named.iter().map(method).collect()
    }

    /// The function that computes one load.
    pub(super) fn load_alone(&self, load: &NamedLoad, code: &LoadsCode) -> TokenStream {
        let (own, state) = (identifier(&load.name.local), state_path(&self.model.name));
        let name = Ident::new(&format!("load_of_{}", load.name.local), Span::call_site());
        // Joints and drives are read from their actions alone.
        let read = match load.kind {
            LoadKind::Joint(_) | LoadKind::Share { .. } | LoadKind::Drive => &NamedLoad { multipliers: 0..0, ..load.clone() },
            _ => load,
        };
        let Reading { page, kind, call } = self.reading(read, 0, 0);
        let page = docs::line(&format!("{page} The same as `loads(state).{}()`, with what others need left out.", load.name.local));
        let body = match &load.alone {
            Some(routine) => {
                let RoutinePrinter { reads, steps, results } = fast_lines(self.model, &code.arena, routine);
                let (multipliers, rest) = results.split_at(read.multipliers.len());
                let (actions, checks) = rest.split_at(load.actions.len());
                let (m, width, motion, are_steady) = (number(multipliers.len()), number(actions.len()), motion(), are_steady(checks));
                let refreshed = match load.kind {
                    LoadKind::Force(_) => None,
                    _ => self.refreshed(&quote!(::reuleaux::Loads::<T, #m, #width>::unknown().#call)),
                };
                let watch = (!checks.is_empty()).then(|| {
                    quote! {
                        if !(#are_steady) {
                            return self.loads(state).#own();
                        }
                    }
                });
                quote! {
                    #refreshed
                    #motion
                    #reads
                    #steps
                    #watch
                    let multipliers = ::core::convert::From::from([#(#multipliers),*]);
                    let actions = ::core::convert::From::from([#(#actions),*]);
                    ::reuleaux::Loads::<T, #m, #width>::unique(multipliers, actions).#call
                }
            }
            None => quote!(self.loads(state).#own()),
        };
        let function = placed(load.name.word.span(), quote!(pub fn #name(&self, state: &#state<T>) -> #kind { #body }));
        quote!(#page #[must_use] #function)
    }

    /// How a load is read where its multipliers and its actions begin at these places.
    fn reading(&self, load: &NamedLoad, first: usize, at: usize) -> Reading {
        let name = &load.name;
        let path = match self.model.ambient {
            Ambient::Plane => "Planar",
            Ambient::Space => "Spatial",
        };
        let count = load.multipliers.len();
        let (from, to, place) = (number(first), number(first + count), number(at));
        match &load.kind {
            LoadKind::Drive => Reading {
                page: format!("What the drive `{name}` has to do."),
                kind: quote!(::reuleaux::DriveLoad<T>),
                call: quote!(drive(#from..#to, #place)),
            },
            LoadKind::Joint(body) | LoadKind::Share { body, .. } => {
                let (kind, method) = (format_ident!("{path}Load"), format_ident!("{}", path.to_lowercase()));
                let has_no_opposite = matches!(load.kind, LoadKind::Share { .. }).then(|| quote!(, false));
                let of = if matches!(load.kind, LoadKind::Share { is_stated: false, .. }) { "the body's origin" } else { "its point" };
                let body = &self.model.bodies[*body].name;
                let page = format!("What the joint `{name}` does to `{body}`: the force at {of}, and the torque about it, in ground.");
                Reading { page, kind: quote!(::reuleaux::#kind<T #has_no_opposite>), call: quote!(#method(#from..#to, #place)) }
            }
            // Equations between angles of other joints act nowhere in particular.
            LoadKind::Equations => {
                let count = number(count);
                Reading {
                    page: format!("Multipliers of `{name}`, by equation."),
                    kind: quote!([T; #count]),
                    call: quote!(multipliers_from(#from)),
                }
            }
            LoadKind::Force(parts) => self.reading_of_force(load, parts, at, path),
        }
    }

    fn reading_of_force(&self, load: &NamedLoad, parts: &[(bool, Option<usize>)], mut at: usize, path: &str) -> Reading {
        let (mut forces, mut torques) = (Vec::new(), Vec::new());
        let mut words = Vec::new();
        for (is_torque, body) in parts {
            let body = body.map_or_else(|| "ground".to_owned(), |body| self.model.bodies[body].name.to_string());
            let (list, what) = if *is_torque { (&mut torques, "torques") } else { (&mut forces, "forces") };
            words.push(format!("`{what}[{}]` on `{body}`", list.len()));
            list.push(number(at));
            at += match (self.model.ambient, is_torque) {
                (Ambient::Plane, true) => 1,
                (Ambient::Plane, false) => 2,
                (Ambient::Space, _) => 3,
            };
        }
        let (kind, method) = (format_ident!("{path}Force"), format_ident!("{}_force", path.to_lowercase()));
        let (of_forces, of_torques, power) = (number(forces.len()), number(torques.len()), number(at));
        Reading {
            page: format!("What the force `{}` does, in ground: {}.", load.name, words.join(", ")),
            kind: quote!(::reuleaux::#kind<T, #of_forces, #of_torques>),
            call: quote!(#method([#(#forces),*], [#(#torques),*], #power)),
        }
    }
}
