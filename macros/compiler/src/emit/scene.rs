//! The generated scene of a state, from which it is drawn at run time.

use super::expression::{Printer, local};
use super::functions::Emitter;
use super::literal::{number, signed};
use super::routine::{RoutinePrinter, lines};
use crate::expr::Expr;
use crate::model::Joint;
use crate::model::sketch::{Instantiation, JointArgument, LocalVector};
use crate::plan::SceneCode;
use crate::quantity::{Ambient, Axis, Dim, Role};
use crate::system::cosine;
use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::{quote, quote_spanned};
use std::collections::BTreeMap;

impl Emitter<'_> {
    /// The trait `Sketch`, if the mechanism is declared with `#[picture]`
    pub(super) fn drawable(&self) -> Option<TokenStream> {
        let (word, code) = (self.model.requests.picture.as_ref()?, self.plan.scene.as_ref()?);
        let RoutinePrinter { reads, steps, results } = self.sketched(&code.numbers);
        let printed = code.numbers.results.iter().copied().zip(results).collect();
        let composer = SceneComposer { emitter: self, code, printed };
        let (scene, q, t, name) = (local("scene"), local("q"), local("t"), self.model.name.to_string().replace("r#", ""));
        let has_drive = self.system.frames.is_empty() && self.model.joints.iter().any(Joint::is_driven);
        let nu = has_drive.then(|| {
            let nu = local("nu");
            quote!(let #nu = self.nu(#q, #t);)
        });
        let (bodies, points, joints, outputs) = (composer.bodies(), composer.points(), composer.joints(), composer.outputs());
        let body = quote! {
            let (#q, #t) = (&state.q, state.t);
            #nu
            #reads
            #steps
            let mut #scene = __picture::Scene::new(#name);
            #bodies
            #points
            #joints
            #outputs
            #scene
        };
        Some(implementation(word, &self.model.name, self.system.width(), &body))
    }

    fn sketched(&self, routine: &crate::plan::Routine) -> RoutinePrinter {
        lines(self.model, &self.model.sketch.arena, routine)
    }
}

/// Implements `Sketch`, for `Drawable`. Its one path into the runtime has the span of `#[picture]`, where rustc says which feature is missing.
pub(crate) fn implementation(word: &Ident, name: &Ident, n: usize, body: &TokenStream) -> TokenStream {
    let (import, n, allowed) = (quote_spanned!(word.span()=> use ::reuleaux::picture as __picture;), number(n), super::allowed());
    quote! {
        const _: () = {
            #import
            #allowed
            impl<T: ::reuleaux::Float> __picture::Sketch<T, #n> for #name<T> {
                fn sketch(&self, state: &::reuleaux::State<T, #n>) -> __picture::Scene { #body }
            }
        };
    }
}

/// Prints the calls that compose a scene.
struct SceneComposer<'a> {
    emitter: &'a Emitter<'a>,
    code: &'a SceneCode,
    /// Numbers that are not constant.
    printed: BTreeMap<Expr, TokenStream>,
}

impl SceneComposer<'_> {
    fn bodies(&self) -> TokenStream {
        let system = self.emitter.system;
        let at = |index: usize| {
            let (q, index) = (local("q"), number(index));
            quote!(#q[#index].to_f64())
        };
        let coordinate = |body: usize, role: Role| {
            let index = system.coordinates.iter().position(|unknown| unknown.body == body && unknown.role == role);
            index.map_or(quote!(0.0), at)
        };
        let scene = local("scene");
        let body = |(index, body): (usize, &crate::model::Body)| {
            let name = body.name.unraw();
            if !system.frames.is_empty() {
                let position = [0, 1, 2].map(|axis| at(Ambient::Space.first_coordinate(index) + axis));
                let rotation = [0, 1, 2].map(|row| {
                    let entries = [0, 1, 2].map(|column| at(system.coordinates.len() + cosine(index, row, column)));
                    quote!([#(#entries),*])
                });
                return quote!(#scene.body(#name, __picture::Pose::space([#(#position),*], [#(#rotation),*])););
            }
            let [x, y, angle] = [Role::Position(Axis::X), Role::Position(Axis::Y), Role::Angle].map(|role| coordinate(index, role));
            quote!(#scene.body(#name, __picture::Pose::plane(#x, #y, #angle));)
        };
        self.emitter.model.bodies.iter().enumerate().map(body).collect()
    }

    fn points(&self) -> TokenStream {
        let scene = local("scene");
        let points = self.emitter.model.sketch.points.iter().map(|point| {
            let (body, at) = self.fixed(point.at);
            quote!(#scene.point(#body, #at);)
        });
        points.collect()
    }

    fn outputs(&self) -> TokenStream {
        let scene = local("scene");
        let outputs = self.emitter.model.sketch.outputs.iter().map(|output| {
            let (name, (body, at)) = (&output.name, self.fixed(output.at));
            quote!(#scene.output(#name, #body, #at);)
        });
        outputs.collect()
    }

    fn joints(&self) -> TokenStream {
        let Emitter { model, system, .. } = self.emitter;
        let scene = local("scene");
        let joint = |(index, (joint, made)): (usize, (&Joint, &Instantiation))| {
            let (name, kind, arguments) = (joint.name.unraw(), &made.kind, self.arguments(made));
            let bodies = system.bodies_of(index).into_iter().map(|body| model.drawn_name(Some(body)));
            let rate = joint.is_drive.then(|| {
                if let Some(rate) = model.sketch.rates.get(index) {
                    return rate.map_or_else(|| quote!(::core::primitive::f64::NAN), |rate| self.number(rate));
                }
                // The equations of a freedom are not those of a state.
                if joint.freedom.is_some() {
                    return quote!(::core::primitive::f64::NAN);
                }
                let (nu, row) = (local("nu"), number(system.first_of(index)));
                quote!(#nu[#row].to_f64())
            });
            match rate {
                Some(rate) => quote!(#scene.drive(#name, #kind, #rate).of(&[#(#bodies),*])#arguments;),
                None => quote!(#scene.joint(#name, #kind).of(&[#(#bodies),*])#arguments;),
            }
        };
        let force = |(name, made): &(String, Instantiation)| {
            let (kind, arguments, bodies) = (&made.kind, self.arguments(made), made.bodies().map(|body| model.drawn_name(body)));
            quote!(#scene.joint(#name, #kind).of(&[#(#bodies),*])#arguments;)
        };
        model.joints.iter().zip(&model.sketch.joints).enumerate().map(joint).chain(model.sketch.forces.iter().map(force)).collect()
    }

    /// `.point("P", "crank", [0.1, 0.0])` …
    fn arguments(&self, made: &Instantiation) -> TokenStream {
        let argument = |(name, argument): &(String, JointArgument)| match argument {
            JointArgument::Point(at) => {
                let (body, at) = self.fixed(*at);
                quote!(.point(#name, #body, #at))
            }
            JointArgument::Axis(along) => {
                let (body, along) = self.fixed(*along);
                quote!(.axis(#name, #body, #along))
            }
            JointArgument::Body(body) => {
                let body = self.emitter.model.drawn_name(*body);
                quote!(.body(#name, #body))
            }
            JointArgument::Number(value, dim) => {
                let value = self.number(*value);
                if *dim == Dim::LENGTH { quote!(.length(#name, #value)) } else { quote!(.number(#name, #value)) }
            }
            JointArgument::Function(value) => {
                let function = self.function(*value);
                quote!(.function(#name, #function))
            }
            JointArgument::Joint(made) => {
                let (kind, arguments, joint) = (&made.kind, self.arguments(made), local("joint"));
                quote!(.joint(#name, #kind, |#joint| { #joint #arguments; }))
            }
        };
        made.arguments.iter().map(argument).collect()
    }

    /// A body, and components in its frame.
    fn fixed(&self, at: LocalVector) -> (String, TokenStream) {
        let parts = at.local.iter().map(|part| self.number(*part));
        (self.emitter.model.drawn_name(at.body), quote!([#(#parts),*]))
    }

    fn number(&self, value: Expr) -> TokenStream {
        let names = BTreeMap::new();
        let printer = Printer { arena: &self.emitter.model.sketch.arena, names: &names, turn: "sin_cos" };
        match printer.constant(value).filter(|value| value.is_finite()) {
            Some(value) => signed(value),
            None => double(self.printed.get(&value)),
        }
    }

    fn function(&self, value: Expr) -> TokenStream {
        let printed = self.code.functions.get(&value).map(|routine| self.emitter.sketched(routine));
        let Some(RoutinePrinter { reads, steps, results }) = printed else { return quote!(|_| ::core::primitive::f64::NAN) };
        let (variable, t, value) = (local("variable"), local("t"), double(results.first()));
        quote!(|#variable| { let #t = T::of(#variable); #reads #steps #value })
    }
}

/// A value as a double.
fn double(value: Option<&TokenStream>) -> TokenStream {
    value.map_or(quote!(::core::primitive::f64::NAN), |value| {
        // `self.length` needs no parentheses, a sum does.
        let is_operator = |tree: TokenTree| matches!(tree, TokenTree::Punct(punct) if punct.as_char() != '.');
        if value.clone().into_iter().any(is_operator) { quote!((#value).to_f64()) } else { quote!(#value.to_f64()) }
    })
}
