/// A torque between two bodies in space, about an axis of the first: a motor, a brake, a load.
///
/// ```text
///      a ──▶  ┌───────┐      ╭─
///   ══════════╡       ╞══════╪══════ b
///             └───────┘      ╰─▶ T
///
///   T z_a on the body of `b`, −T z_a on the body of `a`
/// ```
///
/// The torque may depend on time, on speeds and on anything else. Degenerate case: none.
///
/// Reference: Haug, section 9.5.
force motor(a: Axis, b: Body, torque: Torque) in space {
    require a.body != b: "a motor turns one body against another one";
    let line = torque * z_axis(a);
    on b: line;
    on a.body: -line;
}
