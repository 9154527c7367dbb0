//! Warnings: the declaration is accepted.
//!
//! Macros cannot warn on stable Rust. Like other crates, this module uses a deprecated constant at the tokens in question, so that
//! rustc warns with the note of the constant. `#[allow(deprecated)]` silences it.

use super::{Fact, Range};
use proc_macro2::{Ident, TokenStream};
use quote::quote;

/// A warning, and the source range it is about.
#[derive(Clone, Debug)]
pub struct Warning {
    /// The doubtful fact, with its numbers.
    pub doubt: Doubt,
    /// Source range.
    pub range: Range,
}

/// A valid declaration that may not be meant.
#[derive(Clone, Debug, PartialEq)]
pub enum Doubt {
    /// The nearest assembly is far from a declared start.
    FarStart {
        /// The body, or the angle or displacement of a joint.
        what: String,
        /// `angle` or `position` of a body; that of a joint, `hinge.angle`.
        coordinate: String,
        /// Assembled value, with units.
        found: String,
        /// Declared value.
        declared: String,
        /// Difference between the two.
        apart: String,
        /// Drive that determines the value, whatever is declared.
        drive: Option<String>,
        /// Suggested declaration.
        instead: String,
    },
    /// In space, the orientation of a body in the nearest assembly is far from its declared one.
    FarOrientation {
        /// Path of the body.
        body: String,
        /// An angle of a joint that differs, `hinge.angle`, and its assembled value with the unit; none if the axes of the joint differ.
        angle: Option<(String, String)>,
        /// Angle between the two orientations.
        apart: String,
        /// Drive that determines the angle, whatever is declared.
        drive: Option<String>,
        /// Suggested orientation.
        instead: String,
    },
    /// A length without a unit is in metres, and out of proportion.
    BareLength {
        /// The number as written.
        number: String,
        /// The longest length with a unit.
        longest: String,
    },
    /// An angle without a unit that is more than a turn in radians.
    BareAngle {
        /// Its use.
        of: AngleOf,
        /// The number as written.
        number: String,
    },
    /// An angular velocity without a unit that is rather meant in revolutions per minute.
    BareSpeed {
        /// The number as written.
        number: String,
    },
    /// A power that applies to a number with its unit.
    RaisedNumber {
        /// The power as written.
        written: String,
        /// The same with parentheses.
        meaning: String,
        /// With the power of the unit alone.
        instead: String,
    },
    /// A frequency times the time, which counts turns, as an angle.
    TurnsAsAngle {
        /// The product as written.
        written: String,
    },
    /// A product of an input and the time, which jumps with the input.
    InputByTime {
        /// The input.
        input: String,
    },
    /// Free fall of an unusual size.
    UnusualGravity {
        /// Its size, with units.
        found: String,
        /// The vertical component to type.
        instead: &'static str,
    },
    /// Free fall where no body has a mass.
    GravityWithoutMass,
    /// An inertia of a body much larger than all lengths.
    WideInertia {
        /// The body.
        body: String,
        /// Radius of gyration.
        radius: String,
        /// The longest length with a unit.
        longest: String,
    },
    /// A rod along x in a body with a point at its length in another direction.
    RodAcross {
        /// The body.
        body: String,
        /// The point.
        point: String,
        /// The inertia, as it may be written.
        instead: String,
    },
    /// A disk across z in a body whose only axis is another one.
    DiskAcross {
        /// The body.
        body: String,
        /// Its axis.
        axis: String,
        /// The inertia, as it may be written.
        instead: String,
    },
    /// A universal joint whose axes lie in line.
    ShaftsForArms {
        /// The joint.
        joint: String,
    },
    /// A negative stiffness or damping of a spring or a damper.
    NegativeCoefficient {
        /// The number as written.
        written: String,
        /// True for a damping.
        is_damping: bool,
    },
    /// A negative length of a spring without load, or of what a drive makes longer.
    NegativeRest {
        /// The length as written.
        written: String,
        /// What has it.
        of: &'static str,
    },
    /// A quantity with a unit that is converted to radians or to degrees once more.
    ConvertedTwice {
        /// The product as written.
        written: String,
        /// The same without the conversion.
        instead: String,
    },
    /// A program of a whole turn after which the follower stays at rest.
    ProgramEnds {
        /// The function.
        function: String,
    },
    /// A law from 0 to 1 as the law of an angle.
    RiseOfOne {
        /// The law as written.
        written: String,
    },
    /// A number in the place of the angle in which gears mesh.
    NumberAsPhase {
        /// The number as written.
        written: String,
        /// The constraint.
        gears: String,
    },
    /// A percentage as a coefficient of friction.
    PercentageOfFriction {
        /// The number as written.
        written: String,
        /// The number as it may be written.
        instead: String,
    },
    /// Free fall as on earth that points upwards.
    GravityUpwards {
        /// The component as written.
        written: String,
    },
    /// A number by a time as an angular velocity.
    TurnsAsSpeed {
        /// The quotient as written.
        written: String,
        /// The same number of turns a minute.
        in_rpm: String,
    },
    /// The time by a period, which counts turns, as an angle.
    PeriodsAsAngle {
        /// The quotient as written.
        written: String,
        /// As it may be written.
        instead: String,
    },
    /// A point called `center` in a body with a mass.
    PointCalledCenter {
        /// The body.
        body: String,
    },
    /// A rod whose centre is the origin of its body does not reach a point at the distance of its length.
    CenteredRod {
        /// The body.
        body: String,
        /// The point.
        point: String,
        /// The middle of the rod, as it may be written.
        center: String,
        /// The origin, as it may be written.
        origin: String,
    },
    /// The surface of a cam cannot be made.
    Undercut {
        /// The joint.
        joint: String,
        /// Direction in the cam.
        angle: String,
        /// Radius of curvature of the pitch curve there, for a flat face of the outline.
        radius: String,
        /// Radius of the roller, if there is one.
        roller: Option<String>,
    },
    /// Gears are too far apart for their radii, or too close to each other.
    GearsApart {
        /// The joint.
        joint: String,
        /// Distance between their axes.
        distance: String,
        /// Distance that the radii demand.
        needed: String,
        /// True if one of them has its teeth inside.
        is_internal: bool,
    },
    /// An angle with a factor for degrees as an output.
    DegreesInOutput {
        /// The output as written.
        written: String,
        /// The angle.
        angle: String,
    },
    /// A planetary train whose carrier is given as its ring gear.
    CarrierAsRing {
        /// The body in the place of the ring gear.
        carrier: String,
        /// The call in the right order.
        instead: String,
    },
    /// The ring gear of a planetary train is not larger than its sun gear.
    RingInsideSun {
        /// The joint.
        joint: String,
        /// Teeth or radius of the ring gear.
        ring: String,
        /// Teeth or radius of the sun gear.
        sun: String,
    },
    /// An expression that probably means something else.
    Unlikely {
        /// Name of the warning.
        name: &'static str,
        /// The sentence about it.
        flaw: String,
        /// What to write, as a sentence.
        help: String,
    },
    /// The motion ends before it has repeated itself as a whole.
    MotionEnds(Box<Fact>),
    /// Nothing is used of a definition or a bundle that `use` brings in. rustc's own lint would suggest to delete half of the item.
    UnusedImport {
        /// Its name in the mechanism.
        name: String,
    },
}

/// Use of a number as an angle.
#[derive(Clone, Debug, PartialEq)]
pub enum AngleOf {
    /// The start of an angle.
    Start,
    /// The constant law of a drive.
    Law,
    /// `sin`, `cos` or `tan`.
    Function(String),
    /// An argument of a component.
    Argument,
    /// A part of one of these.
    Part,
    /// The default of a parameter that is a number.
    Parameter(String),
}

impl Warning {
    /// Tokens that trigger the lint `deprecated`.
    pub(crate) fn to_tokens(&self) -> TokenStream {
        let name = match self.doubt {
            Doubt::FarStart { .. } | Doubt::FarOrientation { .. } => "far_start",
            Doubt::BareLength { .. } => "bare_length",
            Doubt::BareAngle { .. } => "bare_angle",
            Doubt::BareSpeed { .. } => "bare_speed",
            Doubt::RaisedNumber { .. } => "raised_number",
            Doubt::TurnsAsAngle { .. } => "turns_as_angle",
            Doubt::InputByTime { .. } => "input_by_time",
            Doubt::UnusualGravity { .. } => "unusual_gravity",
            Doubt::GravityWithoutMass => "gravity_without_mass",
            Doubt::WideInertia { .. } => "wide_inertia",
            Doubt::RodAcross { .. } => "rod_across",
            Doubt::ShaftsForArms { .. } => "shafts_for_arms",
            Doubt::DiskAcross { .. } => "disk_across",
            Doubt::NegativeCoefficient { .. } => "negative_coefficient",
            Doubt::NegativeRest { .. } => "negative_rest",
            Doubt::ConvertedTwice { .. } => "converted_twice",
            Doubt::ProgramEnds { .. } => "program_ends",
            Doubt::RiseOfOne { .. } => "rise_of_one",
            Doubt::NumberAsPhase { .. } => "number_as_phase",
            Doubt::PercentageOfFriction { .. } => "percentage_of_friction",
            Doubt::GravityUpwards { .. } => "gravity_upwards",
            Doubt::TurnsAsSpeed { .. } => "turns_as_speed",
            Doubt::PeriodsAsAngle { .. } => "periods_as_angle",
            Doubt::PointCalledCenter { .. } => "point_called_center",
            Doubt::CenteredRod { .. } => "centered_rod",
            Doubt::Undercut { .. } => "undercut",
            Doubt::GearsApart { .. } => "gears_apart",
            Doubt::DegreesInOutput { .. } => "degrees_in_output",
            Doubt::CarrierAsRing { .. } => "carrier_as_ring",
            Doubt::RingInsideSun { .. } => "ring_inside_sun",
            Doubt::Unlikely { name, .. } => name,
            Doubt::MotionEnds(_) => "motion_ends",
            Doubt::UnusedImport { .. } => "unused_import",
        };
        let (name, words) = (Ident::new(name, self.range.first), self.doubt.to_string());
        quote! {
            const _: () = {
                #[deprecated(note = #words)]
                #[allow(non_upper_case_globals)]
                const #name: () = ();
                #name
            };
        }
    }
}

/// Tokens that trigger the lint `unused_variables`, with its help to write `_name`.
pub(crate) fn of_unused(names: &[&Ident]) -> TokenStream {
    let each = names.iter().map(|name| {
        quote! {
            #[allow(non_snake_case)]
            const _: () = { let #name = [(); 0]; };
        }
    });
    quote!(#(#each)*)
}
