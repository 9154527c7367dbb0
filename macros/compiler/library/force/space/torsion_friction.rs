/// Dry friction in a hinge in space, about a common axis of two bodies: Coulomb's law for a given torque, made smooth about zero speed.
///
/// ```text
///      a ──▶      ▒▒▒▒▒      ╭─  b ──▶
///   ══════════════▒▒▒▒▒══════╪═════════
///                 ▒▒▒▒▒      ╰─▶ θ̇
///
///   T = −torque θ̇ / √(θ̇² + transition²), T z_a on the body of `b`, −T z_a on the body of `a`      θ̇: rate of b against a about z_a
/// ```
///
/// `torque` (N m) is that of Coulomb's law, coefficient · normal force · radius of the pin, or that of a brake; it may depend on time, places
/// and speeds. A constant one must not be negative. Where a varying one is negative, there is no friction. At the speed `transition` the
/// friction is 71 % of it, at seven times it 99 %. It does not stick: under a smaller torque the hinge creeps. Where `transition` is small
/// against the speeds of the motion, use `Integrator::stiff`. The axes have to stay in one direction, as a revolute or cylindrical joint keeps
/// them. Degenerate case: a transition of zero, which is refused.
///
/// Reference for laws of friction and what smooth ones can do: Marques, Flores, Pimenta Claro and Lankarani (2016), A survey and comparison of
/// several friction force models for dynamic analysis of multibody mechanical systems.
force torsion_friction(a: Axis, b: Axis, torque: Torque, transition: AngularVelocity) in space {
    require a.body != b.body: "a torsion friction acts between two bodies";
    require torque >= 0: "a torque of friction is not negative";
    require transition > 0: "friction needs a speed of transition above zero";
    let turning = rate(joint_angle(a, b));
    let line = max(torque, 0) * turning / sqrt(turning^2 + transition^2) * z_axis(a);
    on b.body: -line;
    on a.body: line;
}
