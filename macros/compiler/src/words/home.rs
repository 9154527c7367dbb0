//! Words of other programs and of workshops, with their equivalents here.

use crate::quantity::Ambient;

/// Equivalent of a word, as a call to type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Home {
    /// A joint of the library, or one of several.
    Joint(&'static [&'static str]),
    /// A drive of the library.
    Drive(&'static str),
    /// A force of the library.
    Force(&'static str),
    /// An equation of one's own.
    Equation,
    /// A body, and joints with others.
    Body,
    /// No item: a body that no joint holds moves freely.
    Nothing,
}

/// Words for what is done with a mechanism, or checked of it, in Rust.
const COMMANDS: [&str; 18] = [
    "solve",
    "solver",
    "simulate",
    "simulation",
    "run",
    "sweep",
    "time",
    "step",
    "plot",
    "animate",
    "animation",
    "integrator",
    "integrate",
    "method",
    "tolerance",
    "print",
    "assert",
    "require",
];

/// True for one of these words.
pub(crate) fn is_command(word: &str) -> bool {
    COMMANDS.contains(&word)
}

/// Words with their equivalents in the plane and in space.
const HOMES: [(&[&str], Home, Home); 32] = [
    (
        &["revolute", "hinge", "pin", "pivot", "rotary", "rotational", "bearing", "connect", "attach"],
        Home::Joint(&["revolute(P, Q)"]),
        Home::Joint(&["revolute(P, a, Q, b)"]),
    ),
    (
        &["translational", "prismatic", "slider", "slide", "sliding", "linear", "guide"],
        Home::Joint(&["translational(u, P, Q)"]),
        Home::Joint(&["translational(P, a, Q, b)"]),
    ),
    (
        &["point_on_line", "slot", "groove", "track", "rail"],
        Home::Joint(&["point_on_line(P, u, Q)"]),
        Home::Joint(&["point_on_line(P, a, Q)"]),
    ),
    (&["fixed", "fix", "weld", "rigid", "clamp"], Home::Joint(&["weld(P, Q)"]), Home::Joint(&["weld(P, a, Q, b)"])),
    (&["gear", "gears", "spur", "mesh", "gear_pair"], Home::Joint(&["gear_pair(i, j, a, b)"]), Home::Joint(&["gear_pair(one, two, a, b)"])),
    (
        &["involute_mesh", "involute", "gear_mesh", "spur_gears", "teeth"],
        Home::Joint(&["involute_mesh(A, B, a, b, line)"]),
        Home::Joint(&["gear_pair(one, two, a, b)"]),
    ),
    (
        &["rack", "pinion", "rack_pinion"],
        Home::Joint(&["rack_pinion(pinion, rack, u, origin, R)"]),
        Home::Joint(&["rack_pinion(angle, P, a, Q, radius)"]),
    ),
    (
        &["rolling", "roll", "rolling_contact", "rolling_wheel"],
        Home::Joint(&["rack_pinion(pinion, rack, u, origin, R)"]),
        Home::Joint(&["rolling_disk(a, Q, b, radius)"]),
    ),
    (
        &["winch", "drum", "hoist", "capstan"],
        Home::Joint(&["rack_pinion(pinion, rack, u, origin, R)"]),
        Home::Joint(&["rack_pinion(angle, P, a, Q, radius)"]),
    ),
    (&["equation", "constraint", "constrain", "equations"], Home::Equation, Home::Equation),
    (&["cam", "follower"], Home::Joint(&["cam_knife(O, F, R)", "cam_roller(O, C, roller, R)", "cam_flat(O, F, n, h)"]), Home::Equation),
    (&["pulley", "belt", "chain", "sprocket"], Home::Joint(&["belt(i, j, a, b)"]), Home::Joint(&["belt(one, two, a, b)"])),
    (&["ball", "ball_joint", "socket", "spherical", "globe"], Home::Joint(&["revolute(P, Q)"]), Home::Joint(&["spherical(P, Q)"])),
    (&["universal", "cardan", "hooke", "u_joint"], Home::Joint(&["revolute(P, Q)"]), Home::Joint(&["universal(P, a, Q, b)"])),
    (
        &["constant_velocity", "homokinetic", "rzeppa", "cv_joint", "cv", "convel"],
        Home::Joint(&["revolute(P, Q)"]),
        Home::Joint(&["constant_velocity(P, a, Q, b)"]),
    ),
    (
        &["floating", "free", "free_joint", "freejoint", "floating_joint", "free_flyer", "freeflyer", "six_dof"],
        Home::Nothing,
        Home::Nothing,
    ),
    (&["cylindrical"], Home::Joint(&["translational(u, P, Q)"]), Home::Joint(&["cylindrical(P, a, Q, b)"])),
    (
        &["screw", "lead_screw", "ball_screw", "helical"],
        Home::Joint(&["translational(u, P, Q)"]),
        Home::Joint(&["screw(P, a, Q, b, lead)"]),
    ),
    (&["distance", "tie_rod", "rigid_link", "rope", "cable"], Home::Joint(&["distance(P, Q, c)"]), Home::Joint(&["distance(P, Q, c)"])),
    (&["motor", "servo"], Home::Drive("drive_angle(b, C)"), Home::Drive("drive_rotation(angle, C)")),
    (&["spring"], Home::Force("spring(P, Q, stiffness)"), Home::Force("spring(P, Q, stiffness)")),
    (
        &["torque", "moment", "drive_torque", "drive_moment", "torque_motor"],
        Home::Force("motor(one, two, torque)"),
        Home::Force("motor(a, b, torque)"),
    ),
    (&["force", "drive_force", "thrust", "actuator"], Home::Force("actuator(P, Q, F)"), Home::Force("actuator(P, Q, F)")),
    (
        &["spring_damper"],
        Home::Force("spring_damper(P, Q, stiffness, rest, damping)"),
        Home::Force("spring_damper(P, Q, stiffness, rest, damping)"),
    ),
    (
        &["torsion_spring", "torsional_spring", "rotational_spring"],
        Home::Force("torsion_spring(one, two, stiffness, rest)"),
        Home::Force("torsion_spring(a, b, stiffness, rest)"),
    ),
    (
        &["friction", "coulomb_friction"],
        Home::Force("friction(P, u, Q, normal, coefficient, transition)"),
        Home::Force("friction(P, u, Q, normal, coefficient, transition)"),
    ),
    (&["stop", "hard_stop"], Home::Force("stop(P, Q, length, force, depth)"), Home::Force("stop(P, Q, length, force, depth)")),
    (
        &["torsion_stop", "joint_limit"],
        Home::Force("torsion_stop(one, two, least, greatest, torque, depth)"),
        Home::Force("torsion_stop(a, b, least, greatest, torque, depth)"),
    ),
    (
        &["contact", "impact", "stop_along"],
        Home::Force("stop_along(P, u, Q, limit, force, depth)"),
        Home::Force("stop_along(P, u, Q, limit, force, depth)"),
    ),
    (&["drag", "air_drag", "air_resistance"], Home::Force("drag(P, factor)"), Home::Force("drag(P, factor)")),
    (&["damper", "dashpot"], Home::Force("damper(P, Q, damping)"), Home::Force("damper(P, Q, damping)")),
    (&["crank", "piston", "link", "bar", "rod", "rocker", "coupler", "lever", "wheel", "plate", "arm", "block"], Home::Body, Home::Body),
];

/// Equivalent of a word; `None` for a word that is not in the table.
pub(crate) fn home(word: &str, ambient: Ambient) -> Option<Home> {
    let word = word.to_lowercase();
    let (_, plane, space) = HOMES.iter().find(|(words, ..)| words.contains(&word.as_str()))?;
    Some(if ambient == Ambient::Plane { *plane } else { *space })
}

#[cfg(test)]
mod tests;
