/// Dry friction of a slide: Coulomb's law for a given normal force, made smooth about zero speed.
///
/// ```text
///              u ──▶       │ normal
///                        ┌─▼─┐
///   ──────P──────────────┤ Q ├──▶ v
///                   F ◀══└───┘
///
///   F = −coefficient normal v / √(v² + transition²), F u on the body of `Q` at Q, −F u on that of `P` at the same place
///   v = d/dt u · (r_Q − r_P)
/// ```
///
/// The slide moves along `u`, an axis of the body of `P`, of unit length here. `normal` (N) is a value of one's own, such as the weight or the force
/// of a clamp, and may depend on time, places and speeds. A constant one must not be negative. Where a varying one is negative, there is no friction.
/// The loads of joints are not known to forces. Several pads have one force each. At the speed `transition` the friction is 71 % of Coulomb's, at
/// three times it 95 %, and at seven times it 99 %.
///
/// It does not stick: a load below coefficient · normal makes the slide creep, at a speed below `transition` where it is less than 71 % of
/// that. Take as `transition` a speed that counts as standing still. Where it is small against the speeds of the motion, use `Integrator::stiff`,
/// whose steps become long again once the slide stands.
/// For friction between two points, such as the seals of a cylinder that swings, write
/// `actuator(P, Q, -F * rate(norm(Q - P)) / sqrt(rate(norm(Q - P))^2 + transition^2))`.
///
/// Degenerate case: a transition of zero, which is refused.
///
/// Reference for laws of friction and what smooth ones can do: Marques, Flores, Pimenta Claro and Lankarani (2016), A survey and comparison of
/// several friction force models for dynamic analysis of multibody mechanical systems.
force friction(P: Point, u: Axis, Q: Point, normal: Force, coefficient: Number, transition: Velocity) {
    require P.body == u.body: "the first point and the axis of a friction belong to one body";
    require P.body != Q.body: "the two points of a friction lie on the same body";
    require normal >= 0: "a normal force presses, and is not negative";
    require coefficient >= 0: "a coefficient of friction is not negative";
    require transition > 0: "friction needs a speed of transition above zero";
    let d = Q - P;
    let v = rate(dot(unit(u), d));
    // One that varies may become negative: then nothing presses.
    let force = coefficient * max(normal, 0) * v / sqrt(v^2 + transition^2) * unit(u);
    at Q: -force;
    at P: force;
    on P.body: cross(d, force);
}
