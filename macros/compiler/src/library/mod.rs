//! The standard library: one file per joint, function or force, written in the language itself.
//!
//! A new one is a new file under `library/` and a new line here; no solution depends on its name. The doc comment of each
//! file is its manual page; the rustdoc of the runtime shows all of them.

use crate::diag::Diag;
use crate::quantity::Ambient;
use crate::syntax::{
    self,
    ast::{Definition, FunctionItem, Shared},
};
use proc_macro2::TokenStream;
use std::rc::Rc;
use std::str::FromStr;

macro_rules! pages {
    ($($name:literal),* $(,)?) => { &[$(($name, include_str!(concat!("../../library/", $name, ".rs")))),*] };
}

macro_rules! spatial_pages {
    ($($name:literal),* $(,)?) => { &[$(($name, include_str!(concat!("../../library/space/", $name, ".rs")))),*] };
}

/// Constraints in the plane: name and text of the file.
const CONSTRAINTS: &[(&str, &str)] = pages![
    "revolute",
    "translational",
    "weld",
    "distance",
    "point_on_line",
    "revolute_translational",
    "relative_angle",
    "parallel",
    "absolute_x",
    "absolute_y",
    "absolute_angle",
    "absolute_distance",
    "gear_pair",
    "involute_mesh",
    "rack_pinion",
    "belt",
    "differential",
    "planetary",
    "cam_knife",
    "cam_roller",
    "cam_flat",
    "drive_x",
    "drive_y",
    "drive_angle",
    "drive_relative_angle",
    "drive_distance",
    "drive_along",
];

/// Constraints in space: name and text of the file.
const SPATIAL: &[(&str, &str)] = spatial_pages![
    "spherical",
    "revolute",
    "cylindrical",
    "translational",
    "universal",
    "constant_velocity",
    "screw",
    "planar",
    "weld",
    "point_on_line",
    "point_on_plane",
    "parallel_axes",
    "perpendicular_axes",
    "absolute_z",
    "absolute_orientation",
    "gear_pair",
    "rack_pinion",
    "belt",
    "differential",
    "planetary",
    "drive_rotation",
    "drive_translation",
    "drive_z",
    "drive_orientation",
    "gear_joint",
    "rack_and_pinion_joint",
    "guided_rack_and_pinion_joint",
    "differential_joint",
    "differential_joint_on_bearings",
    "rolling_disk",
    "rolling_ball",
    "knife_edge",
];

macro_rules! force_pages {
    ($($name:literal),* $(,)?) => { &[$(($name, include_str!(concat!("../../library/force/", $name, ".rs")))),*] };
}

macro_rules! force_pages_of {
    ($ambient:literal: $($name:literal),* $(,)?) => {
        &[$(($name, include_str!(concat!("../../library/force/", $ambient, "/", $name, ".rs")))),*]
    };
}

/// Forces, in the plane and in space: name and text of the file.
const FORCES: &[(&str, &str)] = force_pages![
    "spring",
    "damper",
    "spring_damper",
    "nonlinear_spring",
    "actuator",
    "constant_force",
    "gas_spring",
    "stop",
    "stop_along",
    "friction",
    "drag",
];

/// Forces in the plane.
const PLANAR_FORCES: &[(&str, &str)] = force_pages_of![
    "plane": "motor",
    "torsion_spring",
    "torsion_damper",
    "torsion_spring_damper",
    "nonlinear_torsion_spring",
    "torsion_stop",
    "torsion_friction",
    "bushing",
];

/// Forces in space.
const SPATIAL_FORCES: &[(&str, &str)] = force_pages_of![
    "space": "motor",
    "torsion_spring",
    "torsion_damper",
    "torsion_spring_damper",
    "nonlinear_torsion_spring",
    "torsion_stop",
    "torsion_friction",
    "bushing",
];

/// Constraints with one text for the plane and for space.
const BOTH: &[&str] = &["distance", "absolute_x", "absolute_y", "drive_distance", "drive_x", "drive_y"];

/// Functions of one variable: name and text of the file.
const FUNCTIONS: &[(&str, &str)] = pages![
    "harmonic",
    "double_harmonic",
    "double_harmonic_end",
    "cycloidal",
    "half_cycloidal_start",
    "half_cycloidal_end",
    "linear",
    "polynomial_345",
    "polynomial_4567",
    "modified_trapezoidal",
    "modified_sine",
    "smooth_step",
    "wrap",
];

/// The names of all constraints of the library that can be used in the plane, or in space.
pub fn constraints<'a>(ambient: Ambient) -> impl Iterator<Item = &'a str> {
    of(ambient).map(|(name, _)| name)
}

/// True for a constraint that exists in the plane but not in space, or vice versa.
pub(crate) fn is_elsewhere(name: &str, ambient: Ambient) -> bool {
    let has = |ambient: Ambient| constraints(ambient).any(|known| known == name);
    !has(ambient) && (has(Ambient::Plane) || has(Ambient::Space))
}

/// The constraints that exist in space alone, for the plane, or in the plane alone, for space.
pub(crate) fn elsewhere<'a>(ambient: Ambient) -> impl Iterator<Item = &'a str> {
    let other = if ambient == Ambient::Plane { Ambient::Space } else { Ambient::Plane };
    constraints(other).filter(move |name| is_elsewhere(name, ambient))
}

/// The names of all forces of the library that can be used in the plane, or in space.
pub fn forces<'a>(ambient: Ambient) -> impl Iterator<Item = &'a str> {
    forces_of(ambient).map(|(name, _)| name)
}

/// Name and text of the forces that can be used in the plane, or in space.
fn forces_of(ambient: Ambient) -> impl Iterator<Item = (&'static str, &'static str)> {
    let own = match ambient {
        Ambient::Plane => PLANAR_FORCES,
        Ambient::Space => SPATIAL_FORCES,
    };
    FORCES.iter().chain(own).copied()
}

/// Name and text of the constraints that can be used in the plane, or in space.
fn of(ambient: Ambient) -> impl Iterator<Item = (&'static str, &'static str)> {
    let own = match ambient {
        Ambient::Plane => CONSTRAINTS,
        Ambient::Space => SPATIAL,
    };
    let both = match ambient {
        Ambient::Plane => &[],
        Ambient::Space => BOTH,
    };
    let shared = CONSTRAINTS.iter().filter(|(name, _)| both.contains(name));
    own.iter().chain(shared).copied()
}

/// The names of all functions of the library.
pub fn functions<'a>() -> impl Iterator<Item = &'a str> {
    FUNCTIONS.iter().map(|(name, _)| *name)
}

/// Name and text of every page of constraints in space.
pub(crate) fn spatial_pages() -> impl Iterator<Item = (&'static str, &'static str)> {
    SPATIAL.iter().copied()
}

/// Name and text of the pages of forces: planar and common ones, or those in space only.
pub(crate) fn force_pages(ambient: Ambient) -> impl Iterator<Item = (&'static str, &'static str)> {
    let pages = forces_of(ambient);
    pages.filter(move |(name, _)| ambient == Ambient::Plane || !FORCES.iter().any(|(both, _)| both == name))
}

/// Name and text of the planar and common pages, constraints first.
pub fn pages() -> impl Iterator<Item = (&'static str, &'static str)> {
    CONSTRAINTS.iter().chain(FUNCTIONS).copied()
}

/// Constraint or force with this name; `None` if there is none in the library.
pub(crate) fn find(name: &str, ambient: Ambient) -> Option<Rc<Definition>> {
    let (_, text) = of(ambient).chain(forces_of(ambient)).find(|(known, _)| *known == name)?;
    let tokens = TokenStream::from_str(text).ok()?;
    // The tests of this crate find a page that does not parse.
    syntax::parse_definition(tokens, &mut Diag::default()).map(Rc::new)
}

/// True for a force of the library, in the plane or in space.
pub(crate) fn is_force(name: &str) -> bool {
    [Ambient::Plane, Ambient::Space].into_iter().any(|ambient| forces(ambient).any(|known| known == name))
}

/// A joint, drive, force or freedom of this kind, as in "a `revolute` joint".
pub(crate) fn described(kind: &str) -> String {
    match kind {
        "energy" => "an `energy`".to_owned(),
        "equation" => "a joint with an equation".to_owned(),
        _ if is_force(kind) => format!("a `{kind}` force"),
        _ if kind.starts_with("drive_") => format!("a `{kind}` drive"),
        _ => format!("a `{kind}` joint"),
    }
}

/// Function with this name; `None` if there is none in the library.
pub(crate) fn function(name: &str) -> Option<Shared<FunctionItem>> {
    syntax::parse_function(tokens(FUNCTIONS, name)?, &mut Diag::default()).map(Shared::new)
}

fn tokens(pages: &[(&str, &str)], name: &str) -> Option<TokenStream> {
    let (_, text) = pages.iter().find(|(known, _)| *known == name)?;
    TokenStream::from_str(text).ok()
}
