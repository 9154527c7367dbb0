//! The loads that a refused mechanism promises.

use crate::emit::identifier;
use crate::emit::literal::number;
use crate::library;
use crate::model::Name;
use crate::quantity::Ambient;
use crate::resolve::Outline;
use crate::syntax::ast::{Definition, Expression, ExpressionKind, Item, JointBody, JointItem, Mechanism, Statement, Task};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use std::collections::BTreeSet;
use std::rc::Rc;

/// The loads of all joints, drives and forces, and those that are computed alone.
pub(super) fn loads(tree: &Mechanism, promised: &Outline, visibility: &TokenStream, body: &TokenStream) -> (TokenStream, TokenStream) {
    let [state, loads] = ["State", "Loads"].map(|what| format_ident!("{}{what}", tree.name));
    let joints = promised.joints.iter().filter(|(_, joint)| !joint.is_freedom()).map(|(name, joint)| (name, joint, false));
    let forces = promised.forces.iter().map(|(name, force)| (name, force, true));
    let (mut methods, mut alone, mut taken) = (TokenStream::new(), TokenStream::new(), BTreeSet::new());
    // What is declared twice has been refused.
    let once = joints.chain(forces).filter(|(name, ..)| taken.insert(&name.path));
    let mut all: Vec<_> = once.map(|(name, item, is_force)| (name.clone(), item, is_force)).collect();
    Name::tell_apart(all.iter_mut().map(|(name, ..)| name).collect());
    for (name, item, is_force) in all {
        let (kind, own) = (load_type(tree, item, is_force), format_ident!("load_of_{}", name.local));
        let name = identifier(&name.local);
        methods.extend(quote!(pub fn #name(&self) -> #kind { #body }));
        if item.is_slice {
            alone.extend(quote!(pub fn #own(&self, _: &#state<T>) -> #kind { #body }));
        }
    }
    let with_motion = match tree.task {
        Task::Motion => quote! {
            pub fn accelerate_with_loads(&self, _: &mut #state<T>) -> ::core::result::Result<#loads<T>, ::reuleaux::Stopped<T>> { #body }
        },
        _ => quote!(pub fn energy(&self, _: &#state<T>) -> ::reuleaux::Energy<T> { #body }),
    };
    let function = quote! {
        pub fn loads(&self, _: &#state<T>) -> #loads<T> { #body }
        #with_motion
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

/// The type of a load, by what the item was probably meant to be: a force of the library is a force, and what changes with time is a drive.
fn load_type(tree: &Mechanism, item: &JointItem, is_force: bool) -> TokenStream {
    let law = match &item.body {
        JointBody::Of { kind, .. } => library::find(&kind.to_string(), tree.ambient),
        _ => None,
    };
    let (is_force, is_drive) = match &law {
        Some(law) if law.is_force => (true, false),
        Some(_) if is_force => (false, moves(item, tree)),
        _ => (is_force, item.is_drive || moves(item, tree)),
    };
    match tree.ambient {
        _ if is_force => force_type(tree.ambient, item, law),
        _ if is_drive => quote!(::reuleaux::DriveLoad<T>),
        Ambient::Plane => quote!(::reuleaux::PlanarLoad<T>),
        Ambient::Space => quote!(::reuleaux::SpatialLoad<T>),
    }
}

/// The type of a force, with as many vectors as its statements say.
fn force_type(ambient: Ambient, force: &JointItem, law: Option<Rc<Definition>>) -> TokenStream {
    let statements: &[Statement] = match (&force.body, &law) {
        (JointBody::Equations(statements), _) => statements,
        (_, Some(law)) => &law.statements,
        _ => &[],
    };
    let count = |is_torque: bool| {
        let own = |statement: &&Statement| matches!(statement, Statement::Apply(applied) if applied.is_torque == is_torque);
        let known = statements.iter().filter(own).count();
        // Some vectors of a force that could not be read may be asked for.
        number(if statements.is_empty() && !matches!(force.body, JointBody::Energy(_)) { UNKNOWN } else { known })
    };
    let (forces, torques) = (count(false), count(true));
    match ambient {
        Ambient::Plane => quote!(::reuleaux::PlanarForce<T, #forces, #torques>),
        Ambient::Space => quote!(::reuleaux::SpatialForce<T, #forces, #torques>),
    }
}

/// Number of vectors of a force whose statements are not known.
const UNKNOWN: usize = 4;

/// True if arguments or equations contain time or an input.
fn moves(item: &JointItem, tree: &Mechanism) -> bool {
    match &item.body {
        JointBody::Of { arguments, .. } => arguments.iter().any(|argument| has_time(&argument.value, tree)),
        JointBody::Equations(statements) => statements
            .iter()
            .any(|statement| matches!(statement, Statement::Equation(one, two) if has_time(one, tree) || has_time(two, tree))),
        _ => false,
    }
}

fn has_time(value: &Expression, tree: &Mechanism) -> bool {
    let has = |part: &Expression| has_time(part, tree);
    match &value.kind {
        ExpressionKind::Path(path) => path
            .name
            .as_ref()
            .is_some_and(|name| name == "t" || tree.items.iter().any(|item| matches!(item, Item::Input(input) if input.name == *name))),
        ExpressionKind::Number { .. } => false,
        ExpressionKind::Field(owner, _) | ExpressionKind::Negative(owner) => has(owner),
        ExpressionKind::Index(one, two) | ExpressionKind::Binary(_, one, two) => has(one) || has(two),
        ExpressionKind::Call(_, items) | ExpressionKind::Tuple(items) | ExpressionKind::List(items) => items.iter().any(has),
        ExpressionKind::If { lhs, rhs, then, otherwise, .. } => [lhs, rhs, then, otherwise].into_iter().any(|part| has(part)),
    }
}
