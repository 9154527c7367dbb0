//! The generated loads: multipliers, and the force and torque of every joint and drive.

use super::expression::local;
use super::functions::Emitter;
use super::literal::{number, vector_type};
use super::{allowed, docs, identifier, state_path};
use crate::plan::Code;
use crate::quantity::Ambient;
use crate::system::Unbalanced;
use proc_macro2::{Span, TokenStream};
use quote::{format_ident, quote};

impl Emitter<'_> {
    /// The method `loads`, and what it gives; nothing without masses and forces.
    pub(super) fn loads(&self) -> TokenStream {
        let (Some(codes), Some(unbalanced)) = (&self.plan.unbalanced, self.unbalanced()) else { return quote!() };
        if !self.model.task.is_determined() {
            return quote!();
        }
        let (name, visibility, state) = (&self.model.name, &self.model.visibility, state_path(&self.model.name));
        let loads = format_ident!("{}Loads", name, span = Span::call_site());
        let (m, q, u) = (self.system.constraints().len(), self.declared_coordinates(), unbalanced.forces.len());
        let width: usize = unbalanced.arms.iter().flatten().map(|(_, arm)| arm.len()).sum();
        let functions = self.functions_of_loads(codes, (q, u, width));
        let methods = self.methods_of_loads(unbalanced);
        let coordinates = match self.model.ambient {
            Ambient::Plane => quote!((&state.q, &state.qd, &state.qdd)),
            Ambient::Space => {
                let (bodies, first) = (number(self.model.bodies.len()), number(self.system.coordinates.len()));
                quote!(&::reuleaux::declared_motion(&state.0, #bodies, #first))
            }
        };
        let (m, u, width, allowed) = (number(m), number(u), number(width), allowed());
        let page = docs::line(&format!("Loads of [`{name}`]: multipliers, and what every joint and drive does to its bodies."));
        quote! {
            #allowed
            impl<T: ::reuleaux::Float> #name<T> {
                #functions
                /// The loads in a state: Φ_uᵀ λ = Q − M u̇, solved for the multipliers λ.
                ///
                /// Joints act on their bodies with −Φ_uᵀ λ. Multipliers that redundant joints leave open are those of least norm.
                #[must_use]
                pub fn loads(&self, state: &#state<T>) -> #loads<T> {
                    let (q, qd, qdd) = #coordinates;
                    let (unbalanced, arms) = (self.unbalanced(q, qd, qdd, state.t), self.arms(q, state.t));
                    #loads { loads: ::reuleaux::Loads::of(self.jacobian(q, state.t), self.nu(q, state.t), &unbalanced), arms }
                }
            }
            #page
            #[derive(Clone, Debug, PartialEq)]
            #[allow(dead_code)]
            #visibility struct #loads<T = ::core::primitive::f64> {
                loads: ::reuleaux::Loads<T, #m, #u>,
                arms: ::reuleaux::Vector<T, #width>,
            }
            #allowed
            impl<T: ::reuleaux::Float> #loads<T> { #methods }
            impl<T> ::core::ops::Deref for #loads<T> {
                type Target = ::reuleaux::Loads<T, #m, #u>;
                fn deref(&self) -> &Self::Target { &self.loads }
            }
        }
    }

    fn unbalanced(&self) -> Option<&Unbalanced> {
        self.system.unbalanced.as_ref()
    }

    fn declared_coordinates(&self) -> usize {
        self.system.declared.as_ref().map_or(self.system.coordinates.len(), |declared| declared.coordinates)
    }

    /// M u̇ − Q, and the arms of the joints' points.
    fn functions_of_loads(&self, [forces, arms]: &[Code; 2], (q, u, width): (usize, usize, usize)) -> TokenStream {
        let (of_q, of_u, of_arms) = (vector_type(q), vector_type(u), vector_type(width));
        let (forces, arms) = (self.vector(forces, u), self.vector(arms, width));
        let [q, qd, qdd, t] = ["q", "qd", "qdd", "t"].map(local);
        quote! {
            fn unbalanced(&self, #q: &#of_q, #qd: &#of_u, #qdd: &#of_u, #t: T) -> #of_u { #forces }
            fn arms(&self, #q: &#of_q, #t: T) -> #of_arms { #arms }
        }
    }

    /// One method for each joint and each drive.
    fn methods_of_loads(&self, unbalanced: &Unbalanced) -> TokenStream {
        let (mut first, mut arm) = (0, 0);
        let mut methods = TokenStream::new();
        let equations = self.system.constraints();
        for (index, joint) in self.model.joints.iter().enumerate().filter(|(_, joint)| joint.freedom.is_none()) {
            let count = equations.iter().filter(|equation| equation.joint == index).count();
            let (from, to) = (number(first), number(first + count));
            let name = identifier(&joint.name.local);
            first += count;
            let place = &unbalanced.arms[index];
            let at = number(arm);
            arm += place.as_ref().map_or(0, |(_, arm)| arm.len());
            if joint.is_drive {
                let page = docs::line(&format!("What the drive `{}` has to do.", joint.name));
                methods.extend(quote! {
                    #page
                    #[must_use]
                    pub fn #name(&self) -> ::reuleaux::DriveLoad<T> { self.loads.drive(#from..#to) }
                });
            } else if let Some((body, _)) = place {
                let page = docs::line(&format!(
                    "What the joint `{}` does to `{}`: the force at its point, and the torque about it, in ground.",
                    joint.name, self.model.bodies[*body].name
                ));
                let (kind, method, speed) = match self.model.ambient {
                    Ambient::Plane => (quote!(::reuleaux::PlanarLoad<T>), quote!(planar), number(3 * body)),
                    Ambient::Space => (quote!(::reuleaux::SpatialLoad<T>), quote!(spatial), number(6 * body)),
                };
                methods.extend(quote! {
                    #page
                    #[must_use]
                    pub fn #name(&self) -> #kind { self.loads.#method(#from..#to, #speed, &self.arms, #at) }
                });
            }
        }
        methods
    }
}
