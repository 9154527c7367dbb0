//! Detects declarations that are meant in space but lack the keyword.
//!
//! In: the tree. Out: at most one refusal, instead of one for every vector. The test counts vector literals and names of spatial items;
//! if most of them belong to the plane, the others are reported as mistakes of their own elsewhere.

use crate::diag::{Diag, ValueFact};
use crate::library;
use crate::quantity::Ambient;
use crate::syntax::ast::{ComponentItem, Expression, ExpressionKind, FrameItem, Item, JointBody, Marks, Mechanism, Statement};

/// Number of occurrences that suggest space, and of those that suggest the plane.
#[derive(Default)]
struct Evidence {
    space: usize,
    plane: usize,
    /// True if an occurrence has no meaning in the plane, whatever names are imported.
    is_certain: bool,
}

/// Refuses a planar mechanism in which most vectors have three components, or a component that `constraint!` checks.
pub(crate) fn is_meant(tree: &Mechanism, diag: &mut Diag) -> Option<()> {
    if means_space(tree) {
        let is_component = checked(tree).is_some();
        return diag.refuse(&tree.name, ValueFact::MeansSpace { name: tree.name.to_string(), is_component });
    }
    Some(())
}

/// True for a planar mechanism in which most vectors have three components.
pub(crate) fn means_space(tree: &Mechanism) -> bool {
    let mut found = Evidence::default();
    found.items(checked(tree).map_or(&tree.items, |component| &component.items));
    tree.ambient == Ambient::Plane && found.is_certain && found.space > found.plane && found.space > 1
}

/// The imported component whose name the mechanism has: that is how `constraint!` checks it.
fn checked(tree: &Mechanism) -> Option<&ComponentItem> {
    tree.items.iter().find_map(|item| match item {
        Item::Component(component) if component.home.is_some() && component.head.name == tree.name => Some(&**component),
        _ => None,
    })
}

impl Evidence {
    fn items(&mut self, items: &[Item]) {
        for item in items {
            match item {
                Item::Ground(frame) | Item::Body(frame) => self.frame(frame),
                Item::Joint(joint) | Item::Force(joint) => self.joint(&joint.body),
                Item::Gravity(gravity) => self.vector(&gravity.value),
                Item::For(repeated) => self.items(&repeated.items),
                Item::Component(component) if component.home.is_none() => self.items(&component.items),
                _ => {}
            }
        }
    }

    fn frame(&mut self, frame: &FrameItem) {
        self.marks(&frame.marks);
        for start in &frame.starts {
            match start.what.to_string().as_str() {
                "orientation" | "z" => self.surely_space(),
                "angle" => self.plane += 1,
                _ => self.vector(&start.value),
            }
        }
    }

    fn marks(&mut self, marks: &Marks) {
        marks.single.iter().for_each(|mark| self.vector(&mark.value));
        marks.loops.iter().for_each(|repeated| self.marks(&repeated.items));
    }

    fn joint(&mut self, body: &JointBody) {
        match body {
            JointBody::Of { kind, arguments } => {
                self.space += usize::from(library::is_elsewhere(&kind.to_string(), Ambient::Plane));
                self.plane += usize::from(library::is_elsewhere(&kind.to_string(), Ambient::Space));
                arguments.iter().for_each(|argument| self.vector(&argument.value));
            }
            JointBody::Equations(statements) => statements.iter().for_each(|statement| match statement {
                Statement::Apply(applied) => self.vector(&applied.value),
                Statement::Equation(lhs, rhs) => [lhs, rhs].into_iter().for_each(|side| self.vector(side)),
                Statement::Let(_) | Statement::Require(_) | Statement::Potential(_) | Statement::Add(_) => {}
            }),
            JointBody::Freedom(_) | JointBody::Energy(_) | JointBody::Value(_) => {}
        }
    }

    fn surely_space(&mut self) {
        self.space += 1;
        self.is_certain = true;
    }

    fn vector(&mut self, value: &Expression) {
        match &value.kind {
            ExpressionKind::Tuple(items) if items.len() == 3 => self.surely_space(),
            ExpressionKind::Tuple(items) if items.len() == 2 => self.plane += 1,
            _ => {}
        }
    }
}
