//! Functions of other languages, with their equivalents here.

/// Names of functions, the reason why there is none of these names, if it is not obvious, and what to write.
const FUNCTIONS: [(&[&str], &str, &str); 50] = [
    (&["ramp"], "", "write a rate by the time since it begins, `2rad_s * max(t - 1s, 0s)`; `linear(t / 1s)` rises from 0 to 1"),
    (&["pow", "powi", "powf", "power", "sqr", "square", "squared"], "", "a power is written `a^b`"),
    (&["cbrt"], "", "for x > 0 it is the power `x^(1/3)`"),
    (&["hypot"], "", "write `sqrt(a^2 + b^2)`"),
    (&["length", "len", "mag", "magnitude", "modulus"], "", "the length of a vector is `norm(v)`"),
    (&["normalize", "normalise", "normalized", "unit_vector"], "", "the direction of a vector is `unit(v)`"),
    (&["vec", "vec2", "vec3", "vector", "point"], "", "a vector is written `(x, y)`, in space `(x, y, z)`"),
    (
        &["angle"],
        "",
        "the angle of a body in the plane is `body.angle`, between two it is `b.angle - a.angle`, that of a vector `direction(v)`; in space a hinge has one, `hinge.angle`",
    ),
    (&["time", "now"], "", "the time is `t`"),
    (&["akispl", "cubspl"], "", "write `spline(x, [(x0, y0), (x1, y1), (x2, y2)])`"),
    (
        &["impact", "bistop"],
        ": a stop is a force between bodies",
        "write `force name = stop_along(P, u, Q, limit, force, depth);`, where `limit` is the smallest distance of `Q` from `P` along `u`",
    ),
    (&["shf"], "", "write `a * sin(w * t + phase) + b`"),
    (&["dm", "dx", "dy", "dz"], "", "the distance of two points is `norm(Q - P)`, a component of it `Q.x - P.x`"),
    (&["ax", "ay", "az"], "", "the angle between two bodies is `b.angle - a.angle` in the plane, in space that of a hinge, `hinge.angle`"),
    (&["wx", "wy", "wz", "wm"], "", "write `body.angular_velocity`, in space with a component, `body.angular_velocity.z`"),
    (&["vm", "vr", "vx", "vy", "vz"], "", "the velocity of a point is `rate(P)`, that of a distance `rate(norm(Q - P))`"),
    (&["acceleration", "accel", "ddot"], "", "an output is given with its rate and its acceleration; equations and forces contain none"),
    (&["jerk"], "", "write `output name = … with jerk;` for the third derivative of an output"),
    (&["integral", "integrate"], "", "add up the values of an output over a sweep, in Rust"),
    (
        &["sign", "signum", "sgn", "copysign"],
        ": it jumps at zero, where no derivative exists",
        "write `x / sqrt(x^2 + w^2)`, smooth over a small `w`, or `if x < 0 { -1 } else { 1 }`",
    ),
    (
        &["floor", "ceil", "round", "trunc", "fract", "fmod", "mod", "modulo", "rem"],
        ": it jumps, where no derivative exists",
        "write `wrap(x)` for an angle within half a turn, or a law that repeats, such as `segments(…, periodic)`",
    ),
    (
        &["pulse", "square_wave", "sawtooth"],
        ": it jumps, where no derivative exists",
        "write a law that repeats, such as `segments(…, periodic)`, or `if x < 0 { a } else { b }`",
    ),
    (&["if_else", "ifelse", "iif", "iff", "select", "choose"], "", "write `if x < 0 { a } else { b }`"),
    (&["clamp", "clip", "sat", "saturate", "saturation", "limit"], "", "write `min(max(x, low), high)`"),
    (&["lerp", "mix"], "", "write `a + (b - a) * u`"),
    (
        &["interp", "interp1", "interp1d", "interpolate", "lookup", "piecewise", "pchip", "akima"],
        "",
        "write `table(x, [(x0, y0), (x1, y1), (x2, y2)])`, which is smooth",
    ),
    (&["poly", "polyval", "polynomial"], "", "write it out, such as `a + b * x + c * x^2`"),
    (
        &["minimum_jerk", "min_jerk", "s_curve", "scurve", "trapezoidal_velocity", "point_to_point"],
        "",
        "write a law that leads from 0 to 1, such as `height * polynomial_345(t / 2s)`",
    ),
    (
        &["rot", "rotx", "roty", "rotz", "rot_x", "rot_y", "rot_z", "rotate", "rotate_x", "rotate_y", "rotate_z", "rotation", "axis_angle"],
        "",
        "an orientation is a turn about an axis, such as `turn((0, 0, 1), 30deg)`, or a product of turns",
    ),
    (&["rise", "fall", "dwell"], ": it is a segment of a law", "write `segments(t, 0mm, [rise(10mm, 1s, cycloidal), dwell(1s)])`"),
    (
        &["cubic", "septic", "parabolic", "sinusoidal"],
        "",
        "laws from 0 to 1 are `linear`, `harmonic`, `cycloidal`, `modified_sine`, `modified_trapezoidal`, `polynomial_345` and `polynomial_4567`",
    ),
    (&["polar", "cis"], "", "write `(r * cos(angle), r * sin(angle))`"),
    (
        &["rpy", "euler", "euler_angles", "quaternion", "quat"],
        "",
        "an orientation is a product of turns, such as `turn((0, 0, 1), yaw) * turn((0, 1, 0), pitch)`",
    ),
    (&["log"], "", "the natural logarithm is `ln(x)`"),
    (&["log10"], "", "write `ln(x) / ln(10)`"),
    (&["log2"], "", "write `ln(x) / ln(2)`"),
    (&["sinh"], "", "write `(exp(x) - exp(-x)) / 2`"),
    (&["cosh"], "", "write `(exp(x) + exp(-x)) / 2`"),
    (&["tanh"], "", "write `x / sqrt(1 + x^2)`, which leads from -1 to 1 as smoothly"),
    (&["sum"], "", "write `a + b`; a sum over an array is `let s[0] = x[0]; for i in 1..n { let s[i] = s[i - 1] + x[i]; }`"),
    (
        &["deg", "degrees", "to_degrees", "rad2deg"],
        ": angles have no unit inside a mechanism",
        "an angle in degrees is written `60deg`; outputs are in rad, and `.to_degrees()` is written in Rust",
    ),
    (
        &["jacobian", "gradient", "partial"],
        ": derivatives are computed for a state, in Rust",
        "write `mechanism.derivatives(&state)` there",
    ),
    (
        &["rand", "random", "randn", "noise"],
        ": a mechanism moves in the same way each time",
        "declare an `input` or a `param`, and give its value in Rust",
    ),
    (&["dirac", "impulse"], ": no force is infinite", "let a freedom begin with a rate, as in `freedom q = arm.angle at 3rad_s;`"),
    (&["cot"], "", "write `1 / tan(x)`"),
    (&["sindeg", "cosdeg", "tandeg", "sind", "cosd", "tand"], ": an angle has its unit", "write `sin(30deg)`"),
    (&["sec", "csc"], "", "write `1 / cos(x)` or `1 / sin(x)`"),
    (&["dist", "distance_between"], "", "the distance of two points is `norm(Q - P)`"),
    (
        &["kinetic_energy", "potential_energy", "total_energy", "ke", "pe"],
        ": energies are computed for a state, in Rust",
        "write `mechanism.energy(&state)` there, with `kinetic` and `potential`",
    ),
    (&["rad", "radians", "to_radians", "deg2rad"], "", "an angle in degrees has a unit, such as `30deg`; of a number it is `x * 1deg`"),
];

/// The reason and what to write instead of a function of another language; `None` for a name that is not in the table.
pub(crate) fn foreign(name: &str) -> Option<(&'static str, &'static str)> {
    let name = name.to_lowercase();
    FUNCTIONS.iter().find(|(names, ..)| names.contains(&name.as_str())).map(|(_, reason, instead)| (*reason, *instead))
}
