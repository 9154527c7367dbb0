//! Textbook drawings of mechanisms in the plane and in space: a [`Scene`] in, SVG out, the same bytes on every run and every machine.
//!
//! Bodies are bars and plates, joints the symbols of ISO 3952, drives arrows. The macros of `reuleaux` draw the pictures on the pages of
//! generated types with this crate; with the feature `picture` of `reuleaux` programs draw any state of a mechanism.
//!
//! ```text
//! Scene ─place─▶ PlacedScene (m) ─draw─▶ Canvas (shapes) ─labels─▶ placed labels ─svg─▶ text
//! ```
//!
//! A scene with a vector of three components is spatial. It is drawn in orthographic projection with z upwards. Of a fixed set of view
//! directions it takes the one that keeps distinct points apart and shows no joint axis end on; all frames of a motion share one
//! direction.
//!
//! A scene can also be built by hand:
//!
//! ```
//! use reuleaux_picture::{GROUND, Pose, Scene};
//!
//! let mut scene = Scene::new("Pendulum");
//! scene.body("bob", Pose::plane(0.0, 0.0, -1.2));
//! scene.point("bob", [1.0, 0.0]);
//! scene.joint("pivot", "revolute").point("P", GROUND, [0.0, 0.0]).point("Q", "bob", [0.0, 0.0]);
//! let svg = scene.svg();
//! assert!(svg.contains("<title>pivot: revolute of ground and bob</title>"));
//! ```
//!
//! In space poses are positions with rotation matrices, and points and axes have three components:
//!
//! ```
//! use reuleaux_picture::{GROUND, Pose, Scene};
//!
//! let mut scene = Scene::new("Door");
//! scene.body("leaf", Pose::space([0.0, 0.0, 0.0], [[0.6, -0.8, 0.0], [0.8, 0.6, 0.0], [0.0, 0.0, 1.0]]));
//! scene.point("leaf", [0.9, 0.0, 0.0]);
//! scene.point("leaf", [0.9, 0.0, 2.0]);
//! let up = [0.0, 0.0, 1.0];
//! for (name, height) in [("upper", 1.8), ("lower", 0.2)] {
//!     let hinge = scene.joint(name, "revolute");
//!     hinge.point("P", GROUND, [0.0, 0.0, height]).axis("a", GROUND, up).point("Q", "leaf", [0.0, 0.0, height]).axis("b", "leaf", up);
//! }
//! assert!(scene.svg().contains("<title>upper: revolute of ground and leaf</title>"));
//! ```
//!
//! Nothing here panics, whatever the numbers: a scene that cannot be drawn gives an [`Undrawable`], or a sentence in place of the
//! picture.

#![deny(missing_docs)]
#![forbid(unsafe_code)]

mod cams;
mod canvas;
mod clearance;
mod drawing;
mod drives;
mod element;
mod film;
mod gears;
mod habits;
mod labels;
mod links;
mod picture;
mod pins;
mod placed;
mod plane;
mod scene;
mod slides;
mod space;
mod springs;
mod svg;
mod teeth;
mod undrawable;
mod view;
mod wheels;

pub use film::{Film, Mark};
pub use picture::{Label, Picture, animation, frames};
pub use scene::{GROUND, Joint, Pose, Scene, Vector};
pub use undrawable::Undrawable;

#[cfg(test)]
mod tests;
