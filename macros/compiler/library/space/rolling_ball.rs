/// A ball rolls on a plane of another body without sliding.
///
/// ```text
///        _________
///      ╱           ╲        ▲ a
///     │      Q      │       │
///     │      │ radius       │
///      ╲_____│_____╱        │
///   ▔▔▔▔▔▔▔▔▔P▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔
///
///   P = r_Q − radius n                                   the contact, n = z_a
///   c = v_j + ω_j × (P − r_j) − v_i − ω_i × (P − r_i)    velocity of the ball's material against the plane's
///   x_a · c = 0,  y_a · c = 0,  n · c = 0                3 rows of velocities, m/s
/// ```
///
/// `a` is the normal of the plane, `Q` the centre of the ball. Degenerate case: none.
///
/// Reference: Haug, section 9.3; Neimark and Fufaev, Dynamics of Nonholonomic Systems, chapter 1.
constraint rolling_ball(a: Axis, Q: Point, radius: Length) in space {
    require a.body != Q.body: "the ball and its plane are the same body";
    let n = z_axis(a);
    let P = Q - radius * n;
    let own = rate(Q.body.position) + cross(Q.body.angular_velocity, P - Q.body.position);
    let other = rate(a.body.position) + cross(a.body.angular_velocity, P - a.body.position);
    across(a, own - other) == 0;
    dot(n, own - other) == 0;
}
