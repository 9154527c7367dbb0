/// The orientation of a body follows a law of time: its roll, pitch and yaw against an axis of another body, or of ground.
///
/// ```text
///       z_a
///   ╰────┼───▶ yaw
///        │       ╭
///        o───────┼─── y_a
///   ◀───╱──╮     ╰▶ pitch
///      ╱   │ roll
///    x_a
///
///   R = turn(z_a, yaw) · turn(y_a, pitch) · turn(x_a, roll)      roll first
///   x, y, z: x_a, y_a, z_a turned by R
///
///   2 (x × x_b + y × y_b + z × z_b) / (1 + x · x_b + y · y_b + z · z_b) = 0      3 rows, rad
/// ```
///
/// At yaw = pitch = roll = 0 the two axes and the directions across them (`from`) agree. A turn about one axis is a yaw: take axes `a` and `b`
/// along it. The law may go on over any number of turns, and through a pitch of 90°. The rows are the components of 2 tan(δ/2) n in
/// ground, for the rotation by δ about n from b to where it should be: there is one assembly. Removes three freedoms.
///
/// Degenerate case: δ = 180°. A body starts at its declared `start orientation`, that of ground if none is declared; where the law at t = 0 is
/// half a turn away from it, declare one that is nearer.
///
/// As a load, its power is that of the whole torque on the body of `b`; its effort is the component of this torque along x of ground (N m). The
/// components along x, y and z are those of its multipliers, with the sign changed.
///
/// Reference: Shuster, A survey of attitude representations (1993), on the vector of Rodrigues.
constraint drive_orientation(a: Axis, b: Axis, roll: Angle, pitch: Angle, yaw: Angle) in space {
    require a.body != b.body: "the two axes lie on the same body";
    let front = cos(yaw) * x_axis(a) + sin(yaw) * y_axis(a);
    let left = cos(yaw) * y_axis(a) - sin(yaw) * x_axis(a);
    let up = sin(pitch) * front + cos(pitch) * z_axis(a);
    let x = cos(pitch) * front - sin(pitch) * z_axis(a);
    let y = cos(roll) * left + sin(roll) * up;
    let z = cos(roll) * up - sin(roll) * left;
    let sine = cross(x, x_axis(b)) + cross(y, y_axis(b)) + cross(z, z_axis(b));
    let cosine = dot(x, x_axis(b)) + dot(y, y_axis(b)) + dot(z, z_axis(b));
    2rad * sine / (1 + cosine) == 0;
}
