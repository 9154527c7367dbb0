/// A blade moves along its edge only: a skate, a sledge, a wheel that is light enough to be left out.
///
/// ```text
///               ▲ b
///               │
///   ◀──  ═══════Q═══════  ──▶
///                            on
///
///   z_b · c = 0                                          1 row of velocities, m/s
///   c = v_j + ω_j × (r_Q − r_j) − v_i − ω_i × (r_Q − r_i)
/// ```
///
/// `b` is the lateral direction of the blade, `Q` its point, and `on` the body that it moves on. Degenerate case: none.
///
/// Reference: Neimark and Fufaev, Dynamics of Nonholonomic Systems, chapter 1.
constraint knife_edge(on: Body, Q: Point, b: Axis) in space {
    require Q.body == b.body: "point and lateral direction of a blade belong to one body";
    require on != b.body: "the blade and what it moves on are the same body";
    let own = rate(Q.body.position) + cross(Q.body.angular_velocity, Q - Q.body.position);
    let other = rate(on.position) + cross(on.angular_velocity, Q - on.position);
    dot(z_axis(b), own - other) == 0;
}
