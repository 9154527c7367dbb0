//! Pictures of mechanisms that move: states in, one file out, the same bytes on every run and every machine.
//!
//! * [`View::to_html`]: a page with the textbook drawing, which plays, and diagrams of any quantities beside it. Everything is in the page;
//!   it asks for nothing from anywhere. Cursors stand at the moment shown, whose values can be read; the pointer drags through diagrams.
//!   Keys: space, arrows, home and end, plus and minus. Light and dark; narrow and wide; on paper without controls.
//! * [`View::animated_svg`]: the drawing alone, as one SVG that moves by itself without scripts, for a README.
//! * [`View::svg_frames`], and `View::png_frames` with the feature `png`: a file for each state.
//!
//! Mechanisms of `reuleaux` make a view by `mechanism.view(states)`, a method of the trait `Drawable`; this crate knows scenes only, so that
//! `reuleaux` can depend on it. States may come from a sweep, or be recorded as a motion is integrated.
//!
//! ```
//! use reuleaux_picture::{GROUND, Pose, Scene};
//! use reuleaux_view::View;
//!
//! let angle = |time: &f64| 0.5 * time.sin() - 1.57;
//! let pendulum = |time: &f64| {
//!     let mut scene = Scene::new("Pendulum");
//!     scene.body("bob", Pose::plane(0.0, 0.0, angle(time)));
//!     scene.point("bob", [1.0, 0.0]);
//!     scene.joint("pivot", "revolute").point("P", GROUND, [0.0, 0.0]).point("Q", "bob", [0.0, 0.0]);
//!     scene
//! };
//! let times = (0..100).map(|step| 0.0628 * f64::from(step));
//! let view = View::new("Pendulum", times, |time| *time, pendulum)
//!     .trace("bob", |time| [angle(time).cos(), angle(time).sin()])
//!     .plot("angle", "rad", |time| angle(time))
//!     .plot("angular velocity", "rad/s", |time| 0.5 * time.cos());
//! let (page, svg) = (view.to_html()?, view.animated_svg()?);
//! assert!(page.starts_with("<!DOCTYPE html>") && svg.starts_with("<svg"));
//! # Ok::<(), reuleaux_view::Unviewable>(())
//! ```
//!
//! Only states that were computed are shown, each as it would be drawn alone, in one view for all. For smooth motion there should be 60
//! of them for each second that it plays.
//!
//! # How a motion is written
//!
//! ```text
//! Scenes ─Film─▶ marks of each frame ─template─▶ elements and columns ─▶ page, animation, frames
//! ```
//!
//! Marks of equal kind in different frames are one element: its texts stand once, and its numbers, in tenths of a unit of the picture,
//! are columns. Columns are stored as differences in base 64, mostly one letter for each frame, and equal ones once. Elements that come
//! and go, or pass in front of each other, are listed in the order in which they are painted. This holds in the plane and in space alike,
//! and nothing in it knows a symbol.
//!
//! # Sizes and times
//!
//! `runtime/view/browser/run` makes these pages, looks at them in a headless Chromium, and measures. Two cores of a shared machine without
//! a graphics card, 1280 × 800 pixels:
//!
//! | mechanism | states | plotted curves | page | animated SVG | frames a second | script and layout for each |
//! | --- | --- | --- | --- | --- | --- | --- |
//! | four-bar | 1000 | 2 | 157 kB | 35 kB | 60 | 1.8 to 2.5 ms |
//! | slider-crank | 181 | 3 | 93 kB | 19 kB | | |
//! | Stewart platform | 241 | 4 | 135 kB | 304 kB | 60 | 2.2 to 3.3 ms |
//! | chain of ten four-bars | 601 | 2 | 130 kB | 64 kB | 60 | 2.1 to 2.7 ms |
//! | double pendulum | 361 | 4 | 109 kB | 19 kB | | |
//!
//! Of each page 51 kB are uPlot, by Leon Sorokin, which draws the diagrams; it is vendored with its licence (MIT) in `assets/uplot`.
//! A page without diagrams is without it.

#![deny(missing_docs)]
#![forbid(unsafe_code)]

mod animation;
mod columns;
mod json;
mod page;
#[cfg(feature = "png")]
mod pixels;
mod point;
mod recording;
mod still;
mod template;
mod tokens;
mod unviewable;
mod view;

pub use point::Point;
pub use unviewable::Unviewable;
pub use view::View;

#[cfg(test)]
mod tests;
