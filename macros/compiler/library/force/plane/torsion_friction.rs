/// Dry friction in a hinge in the plane: Coulomb's law for a given torque, made smooth about zero speed.
///
/// ```text
///        ╱ two
///       ╱ ╮
///      ╱  │ T
///     ╱  ◀╯
///   (▒)──────────── one
///
///   T = −torque ω / √(ω² + transition²) on `two`, −T on `one`      ω = φ̇_two − φ̇_one
/// ```
///
/// `torque` (N m) is that of Coulomb's law, coefficient · normal force · radius of the pin, or that of a brake; it may depend on time, places
/// and speeds. A constant one must not be negative. Where a varying one is negative, there is no friction. At the speed `transition` the
/// friction is 71 % of it, at seven times it 99 %. It does not stick: under a smaller torque the hinge creeps. Where `transition` is small
/// against the speeds of the motion, use `Integrator::stiff`. Degenerate case: a transition of zero, which is refused.
///
/// Reference for laws of friction and what smooth ones can do: Marques, Flores, Pimenta Claro and Lankarani (2016), A survey and comparison of
/// several friction force models for dynamic analysis of multibody mechanical systems.
force torsion_friction(one: Body, two: Body, torque: Torque, transition: AngularVelocity) in plane {
    require one != two: "a torsion friction acts between two bodies";
    require torque >= 0: "a torque of friction is not negative";
    require transition > 0: "friction needs a speed of transition above zero";
    let turning = two.angular_velocity - one.angular_velocity;
    let slowed = max(torque, 0) * turning / sqrt(turning^2 + transition^2);
    on two: -slowed;
    on one: slowed;
}
