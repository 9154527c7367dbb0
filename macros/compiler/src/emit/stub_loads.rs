//! The loads that a refused mechanism promises.

use super::literal::number;
use crate::library;
use crate::quantity::Ambient;
use crate::syntax::ast::{Item, JointBody, JointItem, Mechanism, Statement, Task};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};
use std::collections::BTreeSet;

/// The loads, with the joints and drives of the mechanism itself.
pub(super) fn loads(tree: &Mechanism, state: &Ident, visibility: &TokenStream, body: &TokenStream) -> (TokenStream, TokenStream) {
    let (loads, mut taken) = (format_ident!("{}Loads", tree.name), BTreeSet::new());
    let of_joint = match tree.ambient {
        Ambient::Plane => quote!(::reuleaux::PlanarLoad<T>),
        Ambient::Space => quote!(::reuleaux::SpatialLoad<T>),
    };
    let known = tree.items.iter().filter_map(|item| match item {
        Item::Joint(joint) if joint.indices.is_empty() && !joint.is_freedom() && taken.insert(&joint.name) => {
            Some((joint, if joint.is_drive { quote!(::reuleaux::DriveLoad<T>) } else { of_joint.clone() }))
        }
        Item::Force(force) if force.indices.is_empty() && taken.insert(&force.name) => Some((force, force_type(tree.ambient, force)?)),
        _ => None,
    });
    let (mut methods, mut alone) = (TokenStream::new(), TokenStream::new());
    for (joint, kind) in known {
        let (name, own) = (&joint.name, format_ident!("load_of_{}", joint.name));
        methods.extend(quote!(pub fn #name(&self) -> #kind { #body }));
        if joint.is_slice {
            alone.extend(quote!(pub fn #own(&self, _: &#state<T>) -> #kind { #body }));
        }
    }
    let energy = (tree.task != Task::Motion).then(|| quote!(pub fn energy(&self, _: &#state<T>) -> ::reuleaux::Energy<T> { #body }));
    let function = quote! {
        pub fn loads(&self, _: &#state<T>) -> #loads<T> { #body }
        #energy
        #alone
    };
    let of_loads = quote! {
        #[doc(hidden)]
        #[allow(dead_code)]
        #visibility struct #loads<T = ::core::primitive::f64>(::reuleaux::Loads<T, 0, 0>);
        #[allow(missing_docs, dead_code, clippy::all)]
        impl<T: ::reuleaux::Real> #loads<T> { #methods }
        impl<T> ::core::ops::Deref for #loads<T> {
            type Target = ::reuleaux::Loads<T, 0, 0>;
            fn deref(&self) -> &Self::Target { &self.0 }
        }
    };
    (function, of_loads)
}

/// The type of a force, as far as the number of its vectors is known.
fn force_type(ambient: Ambient, force: &JointItem) -> Option<TokenStream> {
    let of_law;
    let statements = match &force.body {
        JointBody::Equations(statements) => statements,
        JointBody::Of { kind, .. } => {
            of_law = library::find(&kind.to_string(), ambient)?;
            &of_law.statements
        }
        _ => return None,
    };
    let count = |is_torque: bool| {
        let own = |statement: &&Statement| matches!(statement, Statement::Apply(applied) if applied.is_torque == is_torque);
        number(statements.iter().filter(own).count())
    };
    let (forces, torques) = (count(false), count(true));
    Some(match ambient {
        Ambient::Plane => quote!(::reuleaux::PlanarForce<T, #forces, #torques>),
        Ambient::Space => quote!(::reuleaux::SpatialForce<T, #forces, #torques>),
    })
}
