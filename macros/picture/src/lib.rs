//! Textbook drawings of plane mechanisms: a [`Scene`] in, SVG out, the same bytes on every run and every machine.
//!
//! Bodies are bars and plates, joints the symbols of ISO 3952, drives arrows. The macros of `reuleaux` draw the pictures on the pages of
//! generated types with this crate; with the feature `picture` of `reuleaux` programs draw any state of a mechanism.
//!
//! ```text
//! Scene ─place─▶ PlacedScene (m) ─draw─▶ Canvas (shapes) ─labels─▶ words in their places ─svg─▶ text
//! ```
//!
//! A scene may also be put together by hand:
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
//! Nothing here panics, whatever the numbers: what cannot be drawn is an [`Undrawable`], or a sentence in place of the picture.

#![deny(missing_docs)]
#![forbid(unsafe_code)]

mod cams;
mod canvas;
mod clearance;
mod drawing;
mod drives;
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
mod svg;
mod undrawable;
mod view;
mod wheels;

pub use picture::{Label, Picture, animation, frames};
pub use scene::{GROUND, Joint, Pose, Scene, Vector};
pub use undrawable::Undrawable;

#[cfg(test)]
mod tests;
