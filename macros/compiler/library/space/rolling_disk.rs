/// A thin disk rolls on a plane of another body without sliding.
///
/// ```text
///         ╲        ▁▁ b    ▲ a
///          ╲   ▁──▔        │
///           Q─▔            │
///            ╲ radius      │
///             ╲            │
///   ▔▔▔▔▔▔▔▔▔▔▔P▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔
///
///   P = r_Q + radius u,  u = (z_b (z_b · n) − n)/|…|     the contact, n = z_a
///   c = v_j + ω_j × (P − r_j) − v_i − ω_i × (P − r_i)    velocity of the disk's material against the plane's
///   x_a · c = 0,  y_a · c = 0,  n · c = 0                3 rows of velocities, m/s
/// ```
///
/// `a` is the normal of the plane, `Q` and `b` centre and axis of the disk. Degenerate case: a disk that lies flat touches everywhere, and
/// the contact is not defined.
///
/// Reference: Haug, section 9.3; Neimark and Fufaev, Dynamics of Nonholonomic Systems, chapter 1.
constraint rolling_disk(a: Axis, Q: Point, b: Axis, radius: Length) in space {
    require Q.body == b.body: "centre and axis of a disk belong to one body";
    require a.body != b.body: "the disk and its plane are the same body";
    let n = z_axis(a);
    let z = z_axis(b);
    let P = Q + radius * unit(z * dot(z, n) - n);
    let own = rate(Q.body.position) + cross(Q.body.angular_velocity, P - Q.body.position);
    let other = rate(a.body.position) + cross(a.body.angular_velocity, P - a.body.position);
    across(a, own - other) == 0;
    dot(n, own - other) == 0;
}
