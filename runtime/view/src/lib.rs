//! Animated pictures of mechanisms: states in, one file out, the same bytes on every run and every machine.
//!
//! * [`View::to_html`]: a page with the animated textbook drawing and with diagrams of any quantities beside it. The page is
//!   self-contained and loads nothing. Cursors in the diagrams mark the moment shown and its values; dragging in a diagram moves through
//!   time. Keys: space, arrows, home and end, plus and minus. The layout follows dark mode and the width of the window; printed pages
//!   omit the controls.
//! * [`View::animated_svg`]: the drawing alone as one animated SVG without scripts, for a README.
//! * [`View::still`]: one state, with other states pale below it, as the plate of a textbook.
//! * `View::figure`, with the feature `figure`: the same with the diagrams below it, for print and for a README.
//! * [`View::svg_frames`], and `View::png_frames` with the feature `png`: a file for each state.
//!
//! Mechanisms of `reuleaux` make a view by `mechanism.view(states)`, a method of the trait `Drawable`; this crate depends on scenes only,
//! so that `reuleaux` can depend on it. States may come from a sweep, or be recorded during an integration.
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
//! Bodies are drawn by their points and joints, springs and dampers of the library by their symbols. [`View::outline`] gives bodies shapes,
//! [`View::spring`] and [`View::damper`] add the symbols of other forces.
//!
//! Only the given states are shown, without interpolation, all in one view. A smooth animation needs 60 states for each second of playing
//! time.
//!
//! # File format
//!
//! ```text
//! Scenes ─Film─▶ marks of each frame ─template─▶ elements and columns ─▶ page, animation, frames
//! ```
//!
//! Marks of one kind in different frames are one element: its texts are stored once, and its numbers, in tenths of a picture unit, are
//! columns. Shapes that are fixed in a body are written once, with columns for position and angle. Columns are stored as differences in base
//! 64, mostly one letter for each frame, and equal columns once. Each frame refers to a list of its elements in paint order, for elements
//! that appear, vanish, or pass in front of each other. The format is the same in the plane and in space, and independent of symbols.
//!
//! # Sizes and times
//!
//! `runtime/view/browser/run` generates these pages, opens them in a headless Chromium, and measures. Two cores of a shared machine
//! without a graphics card, 1280 × 800 pixels:
//!
//! | mechanism | states | plotted curves | page | animated SVG | frames a second | script and layout for each |
//! | --- | --- | --- | --- | --- | --- | --- |
//! | four-bar | 1000 | 2 | 158 kB | 35 kB | 60 | 1.8 to 2.5 ms |
//! | slider-crank | 181 | 4 | 96 kB | 19 kB | | |
//! | Stewart platform | 241 | 4 | 136 kB | 143 kB | 60 | 2.2 to 3.3 ms |
//! | chain of ten four-bars | 601 | 2 | 131 kB | 64 kB | 60 | 2.1 to 2.7 ms |
//! | double pendulum | 361 | 4 | 110 kB | 19 kB | | |
//!
//! Of each page 51 kB are uPlot, by Leon Sorokin, which draws the diagrams; it is vendored with its licence (MIT) in `assets/uplot`.
//! Pages without diagrams omit it.

#![deny(missing_docs)]
#![forbid(unsafe_code)]

mod animation;
mod columns;
#[cfg(feature = "figure")]
mod figure;
mod json;
mod page;
#[cfg(feature = "png")]
mod pixels;
mod point;
mod recording;
mod slots;
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
