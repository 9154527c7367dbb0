//! Suggested corrections, from the found and the expected kind.

use super::{Kind, Wanted};
use crate::quantity::{Ambient, Dim};

/// For a value of the wrong kind; empty if there is no suggestion.
pub(super) fn of_kind(wanted: &Wanted, found: &Kind, ambient: Ambient) -> &'static str {
    let is_plane = ambient == Ambient::Plane;
    match (wanted, found) {
        (Wanted::Quantity(of), Kind::Axis) if !is_plane && ["Angle", "Length"].contains(&of.as_str()) => {
            "\nhelp: write the name of the joint about or along this axis"
        }
        (Wanted::Number | Wanted::NumberOrVector | Wanted::Quantity(_), Kind::Body) if is_plane => {
            "\nhelp: its coordinates are `.x`, `.y` and `.angle`, its place is `.position`"
        }
        (Wanted::Number | Wanted::NumberOrVector | Wanted::Quantity(_), Kind::Body) => {
            "\nhelp: its coordinates are `.x`, `.y` and `.z`, its place is `.position`; angles are those of joints, `joint.angle`"
        }
        (Wanted::NumberVectorOrPoint, Kind::Body) => {
            "\nhelp: write `rate(body.position)` for the velocity of its origin, or `body.angular_velocity`"
        }
        (Wanted::Number | Wanted::Quantity(_), Kind::Point | Kind::Vector | Kind::Axis) if is_plane => {
            "\nhelp: its components are `.x` and `.y`, its length is `norm(…)`"
        }
        (Wanted::Number | Wanted::Quantity(_), Kind::Point | Kind::Vector | Kind::Axis) => {
            "\nhelp: its components are `.x`, `.y` and `.z`, its length is `norm(…)`"
        }
        (Wanted::Number | Wanted::NumberOrVector | Wanted::Quantity(_), Kind::Function) => "\nhelp: give it its argument, as in `f(x)`",
        (Wanted::VectorOrPoint | Wanted::NumberOrVector | Wanted::Number | Wanted::NumberVectorOrPoint, Kind::Joint | Kind::JointOf(_))
            if is_plane =>
        {
            "\nhelp: in the plane, angles are those of bodies: write `body.angle`, or a difference of two"
        }
        (Wanted::NumberOrVector | Wanted::Number | Wanted::NumberVectorOrPoint, Kind::JointOf(kind)) => match kind.as_str() {
            "revolute" => "\nhelp: write `joint.angle`",
            "universal" => "\nhelp: write `joint.angle_a` or `joint.angle_b`",
            "translational" => "\nhelp: write `joint.displacement`",
            "cylindrical" | "screw" => "\nhelp: write `joint.angle` or `joint.displacement`",
            _ => "",
        },
        (Wanted::Number | Wanted::NumberOrVector, Kind::Joint) => "\nhelp: what it was made with has values, as in `joint.P`",
        (Wanted::Function, Kind::Number) => "\nhelp: a product is written with `*`",
        (Wanted::VectorOrPoint | Wanted::Vector, Kind::Number) if is_plane => "\nhelp: write both components, `(x, y)`",
        (Wanted::VectorOrPoint | Wanted::Vector, Kind::Number) => "\nhelp: write all components, `(x, y, z)`",
        (Wanted::VectorOrPoint | Wanted::Point, Kind::Body) => "\nhelp: its place is `.position`",
        (Wanted::Point, Kind::Number) if is_plane => "\nhelp: write `(x, y)` for a place in ground, `body.P` for a point of a body",
        (Wanted::Point, Kind::Number) => "\nhelp: write `(x, y, z)` for a place in ground, `body.P` for a point of a body",
        (Wanted::Point, Kind::Vector) if is_plane => "\nhelp: declare `point P = (x, y);` in the body that it belongs to",
        (Wanted::Point, Kind::Vector) => "\nhelp: declare `point P = (x, y, z);` in the body that it belongs to",
        (Wanted::Axis, Kind::Body) => "\nhelp: write one of its axes, as in `body.z`",
        (Wanted::Axis, Kind::JointOf(_) | Kind::Joint) => "\nhelp: write an axis that it was made with, as in `joint.a`",
        (Wanted::Body, Kind::Axis | Kind::Point) => "\nhelp: write the name of the body alone",
        (Wanted::Axis, Kind::Number) if is_plane => "\nhelp: write `(1, 0)` for the direction of x",
        (Wanted::Axis, _) if !is_plane => "\nhelp: write `(1, 0, 0)` for the direction of x",
        (Wanted::NumberVectorOrPoint, Kind::Orientation) => {
            "\nhelp: write `body.angular_velocity`, or `rate(joint.angle)` for the rate of one angle"
        }
        (Wanted::Body, Kind::Number) => "\nhelp: write the name of a body, or `ground`",
        (Wanted::NumberOrVector, Kind::Orientation) => {
            "\nhelp: orientations are multiplied, and one stands before the vector that it turns"
        }
        (Wanted::JointOf(_), Kind::JointOf(_)) => "",
        (Wanted::JointOf(_), _) => "\nhelp: write the name of the joint",
        _ => "",
    }
}

/// The drive of a joint that cannot be the argument of another drive.
pub(super) fn of_drive(definition: &str, found: &Kind) -> Option<&'static str> {
    match (definition, found) {
        ("drive_angle" | "drive_relative_angle", Kind::JointOf(kind)) if kind == "translational" => Some("drive_along(slide, law)"),
        ("drive_along", Kind::JointOf(kind)) if kind == "revolute" => Some("drive_angle(body, law)"),
        _ => None,
    }
}

/// The force about an axis that corresponds to one along a line between points.
pub(super) fn about_an_axis(definition: &str, found: &Kind) -> Option<&'static str> {
    match definition {
        _ if *found != Kind::Axis => None,
        "spring" => Some("torsion_spring"),
        "damper" => Some("torsion_damper"),
        "spring_damper" => Some("torsion_spring_damper"),
        "actuator" => Some("motor"),
        "friction" => Some("torsion_friction"),
        "nonlinear_spring" => Some("nonlinear_torsion_spring"),
        "stop" | "stop_along" => Some("torsion_stop"),
        _ => None,
    }
}

/// What takes the place of a word of space in the plane, as the end of a sentence.
pub(super) fn in_plane(word: &str) -> &'static str {
    match word {
        "spherical" | "universal" | "constant_velocity" => "in the plane `revolute(P, Q)`",
        "cylindrical" | "screw" => "in the plane `translational(u, P, Q)`",
        "drive_rotation" | "drive_orientation" => "in the plane `drive_angle(body, law)`",
        "drive_translation" => "in the plane `drive_along(guide, law)`",
        "point_on_plane" => "in the plane `point_on_line(P, u, Q)`",
        "parallel_axes" => "in the plane `parallel(i, j)`",
        "perpendicular_axes" => "in the plane `relative_angle(i, j, 90deg)`",
        "absolute_orientation" => "in the plane `absolute_angle(b, c)`",
        "rolling_disk" | "rolling_ball" => "in the plane an equation, `{ wheel.x == -radius * wheel.angle; }`",
        "knife_edge" => "in the plane an equation, `{ cross(blade.edge, rate(blade.position)) == 0m_s; }`",
        "gear_joint" => "in the plane `gear_pair(i, j, a, b)`",
        "rack_and_pinion_joint" | "guided_rack_and_pinion_joint" => "in the plane `rack_pinion(pinion, rack, u, origin, R)`",
        "differential_joint" | "differential_joint_on_bearings" => "in the plane `differential(i, j, k)`",
        "along" | "across" => "in the plane `dot(u, v)` and `cross(u, v)`",
        "joint_angle" => "in the plane a difference of angles, `b.angle - a.angle`",
        "x_axis" | "y_axis" | "z_axis" => "in the plane `unit(u)` of an axis and `perp(unit(u))`",
        _ => "leave it out in the plane",
    }
}

/// What takes the place of a word of the plane in space.
pub(super) fn in_space(word: &str) -> &'static str {
    match word {
        "perp" => "`cross(axis, v)`",
        "direction" => "`joint.angle`, or `atan2` of two dot products",
        "drive_angle" | "drive_relative_angle" => "`drive_rotation(joint, law)`",
        "drive_along" => "`drive_translation(joint, law)`",
        "absolute_angle" | "relative_angle" | "parallel" => "an equation of `joint.angle`, or `absolute_orientation(a, b)`",
        "revolute_translational" => "`point_on_plane(P, a, Q, offset)`",
        "absolute_distance" => "`distance(P, Q, c)`",
        "involute_mesh" => "`gear_pair(one, two, a, b)` of the angles of two joints, without the force between the teeth",
        "cam_knife" | "cam_roller" | "cam_flat" => {
            "the motion of the follower over the cam's angle, `{ guide.displacement == lift(shaft.angle); }`"
        }
        _ if word.starts_with(char::is_uppercase) => "a component of your own",
        _ => "an equation of your own",
    }
}

/// For two values that cannot be equated.
pub(super) fn of_equation(one: &Kind, two: &Kind, ambient: Ambient) -> &'static str {
    let is_directed = |kind: &Kind| matches!(kind, Kind::Point | Kind::Vector | Kind::Axis);
    let is_plane = ambient == Ambient::Plane;
    match (one, two) {
        (Kind::Number, other) | (other, Kind::Number) if is_directed(other) && is_plane => {
            "\nhelp: write `.x` or `.y` for one component, or `(x, y)` on the other side for both"
        }
        (Kind::Number, other) | (other, Kind::Number) if is_directed(other) => {
            "\nhelp: write `.x`, `.y` or `.z` for one component, or `(x, y, z)` on the other side for all"
        }
        (Kind::Orientation, _) | (_, Kind::Orientation) => "\nhelp: an orientation is a product of turns, such as `turn((0, 0, 1), 30deg)`",
        (Kind::Body, Kind::Body) if is_plane => "\nhelp: `weld` holds two bodies together; their numbers are `.x`, `.y` and `.angle`",
        (Kind::Body, Kind::Body) => "\nhelp: `weld` holds two bodies together; the place of a body is `.position`",
        (Kind::Body, _) | (_, Kind::Body) if is_plane => "\nhelp: its coordinates are `.x`, `.y` and `.angle`, its place is `.position`",
        (Kind::Body, _) | (_, Kind::Body) => "\nhelp: its place is `.position`; angles are those of joints, `joint.angle`",
        _ => "",
    }
}

/// For a quantity of another dimension than the one that is wanted.
pub(super) fn of_dimension(wanted: Dim, found: Dim) -> &'static str {
    match (wanted, found) {
        (Dim::NUMBER, Dim::ANGLE) => "\nhelp: take the unit away, or divide it by an angle, as in `x / 90deg`",
        (Dim::NUMBER, Dim::TIME) => "\nhelp: divide it by a time, as in `t / 1s`",
        (_, found) if found.is_of_time() => of_dimensions(wanted, found),
        (Dim::INERTIA, Dim::MASS) => {
            "\nhelp: an inertia is a mass by the square of a length, such as `0.003kgm2`, or that of a shape, such as `rod(1m)`"
        }
        (Dim::ANGLE, Dim::TORQUE) => "\nhelp: for a given torque write `force name = motor(…);`, and for the motion `freedom name = …;`",
        (Dim::LENGTH, Dim::FORCE) => {
            "\nhelp: for a given force write `force name = actuator(P, Q, F);`, and for the motion `freedom name = …;`"
        }
        (Dim::TORQUE, found) if Dim::ANGLE == found.times(Dim::TIME) => {
            "\nhelp: a speed is driven by its integral: write `drive name = drive_angle(body, 60rpm * t);`, in space `drive_rotation(joint, 60rpm * t)`; a brake is `torsion_damper(one, two, 0.1Nms_rad)`"
        }
        (Dim::FORCE, found) if Dim::LENGTH == found.times(Dim::TIME) => {
            "\nhelp: a speed is driven by its integral: write `drive name = drive_distance(P, Q, 100mm + 10mm_s * t);`"
        }
        (Dim::MASS, Dim::FORCE) => "\nhelp: a mass is in kg, such as `2kg`; its weight follows from `gravity`",
        (Dim::TORQUE, found) if Dim::TORQUE.times(Dim::ANGLE).per(Dim::TIME) == found => {
            "\nhelp: the factor of an angular velocity is a damping, such as `0.02Nms`"
        }
        (Dim::TORQUE, Dim::FORCE) => "\nhelp: a torque is a force times an arm, such as `5Nm`; a force is written `at point: (0N, -5N);`",
        (Dim::FORCE, Dim::TORQUE) => "\nhelp: a torque is written `on body: 5Nm;`, without a point",
        (wanted, found) if wanted == Dim::MASS.per(Dim::LENGTH) && found == Dim::FORCE.times(Dim::TIME).per(Dim::LENGTH) => {
            "\nhelp: a drag grows with the square of the speed; what grows with the speed is a `damper`"
        }
        (Dim::ANGLE, found) if Dim::ANGLE.times(Dim::TIME) == found => {
            "\nhelp: an angle stands without `t`, a rate is multiplied by `t`, an acceleration such as `2rad_s2` by `t^2`"
        }
        (Dim::LENGTH, found) if Dim::LENGTH.times(Dim::TIME) == found => {
            "\nhelp: a length stands without `t`, a rate is multiplied by `t`, an acceleration such as `2mm_s2` by `t^2`"
        }
        (wanted, Dim::ANGLE) if wanted.times(Dim::TIME) == found => "\nhelp: write a rate, such as `2rad_s`",
        (wanted, Dim::LENGTH) if wanted.times(Dim::TIME) == found => "\nhelp: write a rate, such as `2mm_s`",
        (wanted, found) if wanted == Dim::LENGTH.per(Dim::TIME) && found == Dim::ANGLE.per(Dim::TIME) => {
            "\nhelp: a speed of turning is an `AngularVelocity`"
        }
        (wanted, _) => example(wanted),
    }
}

/// A quantity of a dimension whose unit is not the one that comes to mind.
fn example(wanted: Dim) -> &'static str {
    match wanted {
        Dim::STIFFNESS => "\nhelp: a stiffness is a force by a length, such as `20N_m` or `20N / 10mm`",
        Dim::ACCELERATION => "\nhelp: an acceleration is written such as `9.81m_s2`",
        Dim::INERTIA => "\nhelp: an inertia is written such as `0.003kgm2`, or is that of a shape, such as `rod(1m)`",
        wanted if wanted == Dim::FORCE.times(Dim::TIME).per(Dim::LENGTH) => "\nhelp: a damping is a force by a speed, such as `200Ns_m`",
        wanted if wanted == Dim::TORQUE.per(Dim::ANGLE) => "\nhelp: a stiffness of turning is a torque by an angle, such as `5Nm_rad`",
        wanted if wanted == Dim::TORQUE.times(Dim::TIME).per(Dim::ANGLE) => "\nhelp: it is a torque by a speed, such as `0.02Nms_rad`",
        _ => "",
    }
}

/// For the argument of a function of pure numbers or angles.
pub(super) fn of_function(wanted: Dim, found: Dim) -> &'static str {
    match found {
        Dim::LENGTH => "\nhelp: divide it by a length, as in `x / 10mm`",
        found if found.is_of_time() || found == Dim::ANGLE => of_dimension(wanted, found),
        _ => "",
    }
}

/// For two quantities with different dimensions.
pub(super) fn of_dimensions(one: Dim, two: Dim) -> &'static str {
    let is_grown = |of: Dim, grown: Dim| [Dim::LENGTH, Dim::ANGLE, Dim::FORCE, Dim::TORQUE].contains(&of) && of.times(Dim::TIME) == grown;
    if is_grown(one, two) || is_grown(two, one) {
        return "\nhelp: `t` multiplies a rate: divide by a time, as in `stroke / 1s * t`";
    }
    let is_rate = |rate: Dim, of: Dim| rate.times(Dim::TIME) == of && !of.is_of_time();
    if is_rate(one, two) || is_rate(two, one) {
        return "\nhelp: multiply the rate by `t`";
    }
    if one.is_of_time() || two.is_of_time() {
        return match (one, two) {
            (Dim::ANGLE, _) | (_, Dim::ANGLE) => "\nhelp: give `t` a factor with a unit, such as `2rad_s * t`",
            (Dim::LENGTH, _) | (_, Dim::LENGTH) => "\nhelp: give `t` a factor with a unit, such as `2mm_s * t`",
            _ => "\nhelp: give `t` a factor with a unit, such as `2rad_s * t` for an angle, `2mm_s * t` for a length",
        };
    }
    match (one, two) {
        (Dim::LENGTH, Dim::ANGLE) | (Dim::ANGLE, Dim::LENGTH) => "\nhelp: an arc is a radius times an angle",
        (found, Dim::FORCE) | (Dim::FORCE, found) if Dim::FORCE.per(Dim::LENGTH).per(Dim::LENGTH) == found => {
            "\nhelp: a force is a pressure times an area, such as `5bar * 20cm2`"
        }
        (Dim::MASS, Dim::FORCE) | (Dim::FORCE, Dim::MASS) => {
            "\nhelp: a weight is a mass times `9.81m_s2`; `gravity` adds those of all bodies"
        }
        (Dim::NUMBER, Dim::LENGTH) | (Dim::LENGTH, Dim::NUMBER) => "\nhelp: give the number a unit, such as `20mm`",
        _ => "",
    }
}

/// A value in the units of a drawing, `5 mm` or `30°`; other dimensions in SI.
pub(crate) fn quantity(value: f64, dim: Dim) -> String {
    // Twelve decimals, so that the conversion of units preserves decimal fractions.
    let short = |value: f64| format!("{:.12}", value).trim_end_matches('0').trim_end_matches('.').to_owned();
    match dim {
        Dim::ANGLE => format!("{}°", short(value.to_degrees())),
        Dim::LENGTH => format!("{} mm", short(value * 1e3)),
        _ => format!("{value} {}", dim.unit()).trim_end().to_owned(),
    }
}
