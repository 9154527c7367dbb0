//! Suggestions for mistyped names.

use crate::quantity::{unit, units};

/// Longest name that gets a suggestion; a longer one was not typed by a person.
const LONGEST: usize = 60;

/// Words that other programs add to the names of joints and forces.
const ADDED: [&str; 9] = ["joint", "joints", "constraint", "force", "object", "connector", "mate", "element", "pair"];

/// Words of the language with their synonyms elsewhere.
const SYNONYMS: [(&str, &[&str]); 114] = [
    ("Point", &["position", "location", "place"]),
    ("Number", &["f32", "f64", "float", "double", "real", "scalar", "int", "integer", "i32", "i64", "u32", "u64", "usize"]),
    ("Length", &["m", "mm", "cm", "distance", "position", "displacement", "millimeter", "millimetre", "meter", "metre"]),
    ("Angle", &["deg", "degree", "degrees", "rad", "radian", "radians", "rotation"]),
    ("Time", &["s", "sec", "second", "seconds", "duration", "period"]),
    ("Mass", &["kg", "kilogram", "weight"]),
    ("Velocity", &["m_s", "speed", "linear_velocity"]),
    ("AngularVelocity", &["rad_s", "rpm", "omega", "angular_speed", "angular_rate", "rotationspeed", "angularspeed"]),
    ("Force", &["n", "newton", "newtons", "load"]),
    ("Stiffness", &["springrate", "spring_rate", "springconstant", "spring_constant", "springstiffness", "rate_of_spring"]),
    ("Damping", &["dampingcoefficient", "damping_coefficient", "damper_rate", "viscous_damping"]),
    ("Torque", &["nm", "moment", "energy", "work"]),
    ("Inertia", &["kgm2", "momentofinertia", "moment_of_inertia"]),
    ("body", &["rigidbody", "solid", "link", "bar", "rigid", "member", "bodie"]),
    ("ground", &["frame", "base", "world", "fixed"]),
    ("param", &["constant", "parameter", "var", "variable"]),
    ("input", &["command", "setpoint", "signal"]),
    ("let", &["const", "static", "def"]),
    ("function", &["fn", "func", "law"]),
    ("joint", &["constraint", "connect", "pair"]),
    ("drive", &["driver", "motor", "actuator", "motion"]),
    ("output", &["request", "trace", "measure", "sensor", "result"]),
    ("start", &["initial", "guess", "init"]),
    ("mass", &["weight", "m"]),
    ("angular_velocity", &["omega", "spin", "angular_speed", "rotation_rate"]),
    ("rate", &["d_dt", "deriv", "vel", "vx", "vy", "vz", "velocity", "speed", "derivative", "ddt", "dt", "der", "diff"]),
    ("cross", &["cross_product", "vector_product"]),
    ("dot", &["dot_product", "scalar_product", "inner_product"]),
    ("angle", &["phi", "theta", "rotation"]),
    ("position", &["pos", "origin", "center", "centre"]),
    ("stiffness", &["k", "spring_constant"]),
    ("rest", &["l0", "free_length", "length"]),
    ("damping", &["c", "d"]),
    ("center", &["centre", "cm", "com", "cog", "cg", "centroid", "center_of_mass", "centre_of_mass"]),
    ("inertia", &["moment_of_inertia", "i", "j", "ixx", "iyy", "izz", "jzz"]),
    ("rolling_disk", &["rolling_disc", "rolling_wheel", "wheel_contact", "rolling", "roll", "rolling_contact"]),
    ("rolling_ball", &["rolling_sphere"]),
    ("knife_edge", &["skate", "blade"]),
    ("screw", &["lead_screw", "ball_screw", "helical", "helix"]),
    ("point_on_line", &["pin_slot", "pin_in_slot", "inline", "in_line", "point_on_axis"]),
    ("point_on_plane", &["in_plane", "inplane"]),
    ("perpendicular_axes", &["perpendicular"]),
    ("point", &["marker", "vertex", "location", "anchor", "node", "place"]),
    ("axis", &["direction", "vector"]),
    ("spherical", &["ball", "ball_joint", "globe"]),
    ("universal", &["hooke", "cardan", "u_joint", "gimbal"]),
    ("constant_velocity", &["homokinetic", "rzeppa", "cv_joint", "convel"]),
    ("cylindrical", &["cylinder"]),
    (
        "drive_rotation",
        &["rotation_driver", "drive_rotate", "drive_velocity", "drive_angular_velocity", "drive_speed", "drive_rate", "rotate"],
    ),
    (
        "drive_rotation",
        &["drive_motor", "drive_hinge", "drive_revolute", "drive_rotary", "drive_joint", "drive_crank", "drive_rpm", "rotation"],
    ),
    (
        "drive_angle",
        &["drive_motor", "drive_hinge", "drive_revolute", "drive_rotary", "drive_joint", "drive_crank", "drive_rpm", "rotation"],
    ),
    (
        "drive_translation",
        &[
            "drive_slider",
            "drive_slide",
            "drive_prismatic",
            "drive_linear",
            "drive_piston",
            "drive_stroke",
            "drive_cylinder",
            "drive_displacement",
        ],
    ),
    (
        "drive_along",
        &[
            "drive_slider",
            "drive_slide",
            "drive_prismatic",
            "drive_linear",
            "drive_piston",
            "drive_stroke",
            "drive_translational",
            "drive_displacement",
        ],
    ),
    ("drive_distance", &["drive_cylinder", "drive_length", "drive_ram"]),
    ("drive_x", &["drive_point", "drive_position", "drive_xy", "drive_xyz", "drive_path"]),
    (
        "distance",
        &[
            "fixed_distance",
            "constant_distance",
            "rigid_link",
            "tie",
            "tie_rod",
            "link_rod",
            "massless_rod",
            "rope",
            "cable",
            "point_on_circle",
            "wire",
        ],
    ),
    ("belt", &["timing_belt", "toothed_belt", "crossed_belt", "belt_drive", "chain_drive", "cable_drive"]),
    ("planetary", &["epicyclic", "planetary_gear", "planetary_gears"]),
    ("revolute", &["continuous", "concentric", "coincident", "turning", "pin", "hinge", "pivot", "rotary", "rotational"]),
    (
        "translational",
        &["translate", "telescopic", "telescope", "linear_guide", "linear_bearing", "prismatic", "slider", "slide", "linear", "sliding"],
    ),
    ("weld", &["ground", "anchor", "lock", "bonded", "rigid", "fixed", "fix", "clamp"]),
    ("drive_relative_angle", &["motor", "actuator", "servo"]),
    (
        "gear_pair",
        &[
            "bevel_gear",
            "bevel_gears",
            "worm_gear",
            "worm",
            "bevel",
            "gearbox",
            "harmonic_drive",
            "common_gear",
            "coupler",
            "gear",
            "gears",
            "spur",
        ],
    ),
    ("involute_mesh", &["gear_mesh", "gears_mesh", "spur_gears", "spur_gear", "involute", "involute_gears", "teeth", "tooth"]),
    ("rack_pinion", &["rack", "pinion"]),
    ("m", &["meter", "meters", "metre", "metres"]),
    ("mm", &["millimeter", "millimeters", "millimetre", "millimetres"]),
    ("cm", &["centimeter", "centimeters", "centimetre", "centimetres"]),
    ("in", &["inch", "inches"]),
    ("ft", &["foot", "feet"]),
    ("rad", &["radian", "radians"]),
    ("deg", &["degree", "degrees"]),
    ("turn", &["rev", "revs", "revolution", "revolutions", "turns"]),
    ("s", &["sec", "secs", "second", "seconds"]),
    ("ms", &["msec", "millisecond", "milliseconds"]),
    ("kg", &["kilogram", "kilograms", "kilogramme", "kilogrammes", "kgs"]),
    ("g", &["gram", "grams", "gramme", "grammes"]),
    ("N", &["newton", "newtons"]),
    ("rpm", &["rev_min", "r_min"]),
    ("Ns_m", &["n_s"]),
    ("lbf", &["pound_force"]),
    ("min", &["minute", "minutes"]),
    ("h", &["hour", "hours", "hr"]),
    ("t", &["time"]),
    ("spring_damper", &["spring_damper_parallel", "linear_spring_damper"]),
    (
        "spring",
        &[
            "translational_spring",
            "linear_spring",
            "compression_spring",
            "tension_spring",
            "extension_spring",
            "coil_spring",
            "leaf_spring",
        ],
    ),
    (
        "motor",
        &["torque_source", "torque", "moment", "drive_torque", "servo", "motor_torque", "constant_torque", "dc_motor", "rotational_motor"],
    ),
    ("actuator", &["force_source", "force", "thrust", "drive_force", "linear_actuator", "linear_motor"]),
    ("actuator", &["pressure", "gas_pressure", "piston_pressure", "hydraulic", "hydraulic_cylinder", "pneumatic_cylinder"]),
    ("damper", &["dashpot", "linear_damper", "viscous", "viscous_damper", "damping_force", "shock_absorber"]),
    ("drag", &["air_drag", "air_resistance", "wind"]),
    (
        "torsion_spring",
        &["spring_torsional", "rotational_spring", "rotary_spring", "torsional_spring", "angular_spring", "torsion_bar", "spiral_spring"],
    ),
    ("torsion_damper", &["rotational_damper", "rotary_damper", "torsional_damper", "angular_damper", "viscous_friction"]),
    ("gas_spring", &["gas", "gas_strut", "gas_shock", "gas_piston", "strut"]),
    ("constant_force", &["constant_force_spring", "force_spring", "preload", "pretension", "tension"]),
    ("nonlinear_spring", &["progressive_spring", "spring_by_law", "spring_by_table", "spring_curve"]),
    ("nonlinear_torsion_spring", &["nonlinear_rotational_spring", "progressive_torsion_spring"]),
    ("bushing", &["bush", "silent_block", "rubber_bush", "rubber_mount", "engine_mount", "mount"]),
    ("friction", &["coulomb", "coulomb_friction", "dry_friction", "sliding_friction"]),
    ("torsion_friction", &["hinge_friction", "joint_friction", "bearing_friction", "rotational_friction", "friction_torque", "brake"]),
    ("stop", &["stopper", "bump_stop", "bumper", "buffer", "end_stop", "hard_stop", "limit"]),
    ("torsion_stop", &["rotational_stop", "rotational_hard_stop", "angular_stop", "angle_stop", "hinge_stop", "joint_stop", "joint_limit"]),
    ("stop_along", &["contact", "impact", "floor", "wall"]),
    ("smooth_step", &["step", "step5", "smoothstep", "heaviside"]),
    ("harmonic", &["simple_harmonic", "shm"]),
    ("cycloidal", &["cycloid"]),
    ("modified_sine", &["modsine", "mod_sine", "modified_sinusoidal", "modified_sinusoid"]),
    ("modified_trapezoidal", &["modtrap", "mod_trap", "modified_trapezoid", "trapezoid", "trapezoidal"]),
    ("polynomial_345", &["poly345", "poly_345", "polynomial_5", "quintic"]),
    ("polynomial_4567", &["poly4567", "poly_4567", "polynomial_7", "septic"]),
    ("torsion_spring_damper", &["tspdp", "rotational_spring_damper"]),
    ("freedom", &["dof", "degree_of_freedom"]),
    ("drive_rotation", &["motion", "rotational_motion", "joint_motion", "hinge_motion"]),
    (
        "drive_angle",
        &[
            "motion",
            "rotational_motion",
            "joint_motion",
            "hinge_motion",
            "drive_velocity",
            "drive_angular_velocity",
            "drive_speed",
            "drive_rate",
            "rotate",
        ],
    ),
];

/// Dimensions with their usual names.
const USUAL: [(&str, &[&str]); 9] = [
    ("Angle", &["theta", "phi", "psi", "alpha", "beta", "gamma", "angle", "θ", "φ", "ψ", "α", "β", "γ"]),
    ("AngularVelocity", &["omega", "w", "rpm", "ω"]),
    ("Length", &["l", "length", "r", "radius", "width", "height", "stroke", "pitch", "offset", "distance"]),
    ("Mass", &["m", "mass"]),
    ("Stiffness", &["k", "stiffness"]),
    ("Damping", &["damping"]),
    ("Force", &["f", "force", "load"]),
    ("Torque", &["torque", "moment"]),
    ("Number", &["ratio", "n", "teeth"]),
];

/// The dimension that a number of this name usually has, whatever digits follow: `l2` is a length.
pub(crate) fn usual_dimension(name: &str) -> Option<&'static str> {
    let stem = name.trim_end_matches(|end: char| end.is_ascii_digit() || end == '_').to_lowercase();
    USUAL.iter().find(|(_, names)| names.contains(&stem.as_str())).map(|(dimension, _)| *dimension)
}

/// True for a word that is the known one elsewhere, or itself.
pub(crate) fn is_synonym(known: &str, word: &str) -> bool {
    known == word || SYNONYMS.iter().any(|(name, others)| *name == known && others.contains(&word))
}

/// Known name nearest to a mistyped one, if it is similar enough.
pub(crate) fn nearest<'a>(typed: &str, known: impl Iterator<Item = &'a str>) -> Option<String> {
    let letters = |text: &str| text.chars().flat_map(char::to_lowercase).take(LONGEST + 1).collect::<Vec<char>>();
    let typed = letters(typed);
    if typed.len() > LONGEST {
        return None;
    }
    // Any two single letters are one replacement apart; that does not make them similar.
    let limit = if typed.len() < 2 { 0 } else { (typed.len() / 3).max(1) };
    let errors_in_synonym = |name: &str| {
        let others = SYNONYMS.iter().filter(|(known, _)| *known == name).flat_map(|(_, others)| others.iter());
        let errors = others.map(|other| distance(&typed, &other.chars().collect::<Vec<char>>())).min()?;
        // One typing error in a long word.
        (errors <= typed.len() / 6).then_some(errors)
    };
    let scored = known.filter_map(|name| {
        if let Some(errors) = errors_in_synonym(name) {
            return Some(((0, errors), name));
        }
        let letters = letters(name);
        let excess = letters.len().abs_diff(typed.len());
        let distance = if excess <= limit { distance(&typed, &letters) } else { excess };
        (distance <= limit).then_some(((distance, excess), name))
    });
    // Of equally near names the first declared one is taken, so that messages are the same on every run.
    scored.min_by_key(|(score, _)| *score).map(|(_, name)| name.to_owned())
}

/// The name of a kind without the words that other programs add to it: `revolute` for `RevoluteJoint` and `ObjectJointRevolute2D`.
pub(crate) fn stem(name: &str) -> String {
    let mut apart = String::new();
    for letter in name.trim_end_matches("2D").trim_end_matches("3D").chars() {
        if letter.is_uppercase() && !apart.is_empty() && !apart.ends_with('_') {
            apart.push('_');
        }
        apart.extend(letter.to_lowercase());
    }
    let words: Vec<&str> = apart.split('_').filter(|word| !word.is_empty() && !ADDED.contains(word)).collect();
    if words.is_empty() { name.to_owned() } else { words.join("_") }
}

/// Unit nearest to a mistyped one; a letter typed twice is the most likely error.
pub(crate) fn nearest_unit(typed: &str) -> Option<String> {
    let letters: Vec<char> = typed.chars().collect();
    let is_repeated = |at: &usize| *at > 0 && letters[*at] == letters[at - 1];
    let without = |at: usize| letters[..at].iter().chain(&letters[at + 1..]).collect::<String>();
    let shorter = (0..letters.len()).filter(is_repeated).map(without).find(|shorter| unit(shorter).is_some());
    let shorter = shorter.or_else(|| Some(typed.replace('_', "")).filter(|joined| unit(joined).is_some()));
    // `kgm^2` is `kgm2`.
    let shorter = shorter.or_else(|| Some(format!("{typed}2")).filter(|squared| unit(squared).is_some()));
    // A unit with another power is one of another dimension.
    let digits = |text: &str| text.chars().filter(char::is_ascii_digit).collect::<String>();
    shorter.or_else(|| nearest(typed, units().filter(|known| digits(known) == digits(typed))))
}

/// Optimal string alignment distance: insertions, deletions, replacements, swaps of neighbours; a change of case costs nothing.
///
/// Reference: Damerau (1964), A technique for computer detection and correction of spelling errors.
fn distance(one: &[char], two: &[char]) -> usize {
    let mut rows: [Vec<usize>; 3] = [Vec::new(), Vec::new(), (0..=two.len()).collect()];
    for i in 1..=one.len() {
        rows.rotate_left(1);
        let [before, above, row] = &mut rows;
        row.clear();
        row.push(i);
        for j in 1..=two.len() {
            let replaced = above[j - 1] + usize::from(one[i - 1] != two[j - 1]);
            let mut best = replaced.min(above[j] + 1).min(row[j - 1] + 1);
            let swapped = i > 1 && j > 1 && one[i - 1] == two[j - 2] && one[i - 2] == two[j - 1];
            if swapped {
                best = best.min(before[j - 2] + 1);
            }
            row.push(best);
        }
    }
    rows[2][two.len()]
}
