/// A bushing between two bodies in space: a bush of rubber in an eye, an engine mount.
///
/// ```text
///                ┌───────────────────────┐  i
///                │ ╱╲╱╲╱╲╱╲╱╲╱╲╱╲╱╲╱╲╱╲╱ │
///      a ──▶ ════╪══════════P════════════╪═══▶ z_a
///                │        ╱ Q ═══════════╪═══▶ z_b   j
///                │ ╱╲╱╲╱╲╱╲╱╲╱╲╱╲╱╲╱╲╱╲╱ │
///                └───────────────────────┘
///
///   F = −Σ (stiffness_k d_k + damping_k ḋ_k) k_a on the body of `Q` at Q, −F on that of `P` at the same place      k = x, y, z
///   T = −J (torsion_x θ_x, torsion_y θ_y, torsion_z θ_z) − Σ torsion_damping_k ω_k k_a on the body of `Q`, −T on that of `P`
///   d_k = k_a · (r_Q − r_P)      ω_k = k_a · (ω_j − ω_i)
/// ```
///
/// `P` and the axis `a` belong to body i, `Q` and `b` to body j. The axis lies along the bush, its `from` in the direction x_a; b and its `from` say
/// how body j stands where the bush is not twisted. Stiffness and damping along and about x_a, y_a and z_a, which turn with body i: in N/m and
/// N s/m, in N m/rad and N m s/rad. Unless said, those of y are those of x, as for a round bush, and there is no damping.
///
/// Both angles and displacements may be large. θ = δ n is the vector of the rotation that leads from a to b, by the angle δ about n. The torque is
/// that of the energy ½ Σ torsion_k θ_k²: J v = v + ½ θ × v + (1 − (δ/2) cot(δ/2)) / δ² θ × (θ × v). About one of the three axes alone it is
/// that of a torsion spring, and for small angles that of three. F acts on both bodies at Q: on body i as −F at P and the torque −d × F, so that
/// momentum and angular momentum are kept.
///
/// Degenerate case: at half a turn the rotation has two vectors: the torque jumps, and has no value there. Whole turns are not counted.
///
/// Reference: Masarati and Morandini (2010), Intrinsic deformable joints; Blundell and Harty, The Multibody Systems Approach to Vehicle Dynamics, on
/// bushes.
force bushing(
    P: Point,
    a: Axis,
    Q: Point,
    b: Axis,
    stiffness_x: Stiffness,
    stiffness_y: Stiffness = stiffness_x,
    stiffness_z: Stiffness,
    torsion_x: Torque / Angle,
    torsion_y: Torque / Angle = torsion_x,
    torsion_z: Torque / Angle,
    damping_x: Mass / Time = 0,
    damping_y: Mass / Time = damping_x,
    damping_z: Mass / Time = 0,
    torsion_damping_x: Torque / AngularVelocity = 0,
    torsion_damping_y: Torque / AngularVelocity = torsion_damping_x,
    torsion_damping_z: Torque / AngularVelocity = 0,
) in space {
    require P.body == a.body: "the first point and the first axis of a bushing belong to one body";
    require Q.body == b.body: "the second point and the second axis of a bushing belong to one body";
    require P.body != Q.body: "the two points of a bushing lie on the same body";
    let d = Q - P;
    let x = dot(x_axis(a), d);
    let y = dot(y_axis(a), d);
    let z = dot(z_axis(a), d);
    // sin δ n, and sin²(δ/2)
    let sine_x = (dot(z_axis(a), y_axis(b)) - dot(y_axis(a), z_axis(b))) / 2;
    let sine_y = (dot(x_axis(a), z_axis(b)) - dot(z_axis(a), x_axis(b))) / 2;
    let sine_z = (dot(y_axis(a), x_axis(b)) - dot(x_axis(a), y_axis(b))) / 2;
    let half = (3 - dot(x_axis(a), x_axis(b)) - dot(y_axis(a), y_axis(b)) - dot(z_axis(a), z_axis(b))) / 4;
    // δ / sin δ, and the factor of θ × (θ × v); by their series where both are 0/0. Near half a turn 1 − sin²(δ/2) is rounding, and sin δ is not.
    let sine = sqrt(sine_x^2 + sine_y^2 + sine_z^2);
    let delta = atan2(sine, 1 - 2 * half);
    let ratio = if half < 0.0001 { 1 + 2 * half / 3 + 8 * half^2 / 15 + 16 * half^3 / 35 } else { delta / sine };
    let factor = if half < 0.0001 { 1 / 12 + half / 180 + half^2 / 420 } else { (1 - ratio * (1 - half)) / delta^2 };
    let angle_x: Angle = ratio * sine_x;
    let angle_y: Angle = ratio * sine_y;
    let angle_z: Angle = ratio * sine_z;
    let force_energy = stiffness_x * x^2 + stiffness_y * y^2 + stiffness_z * z^2;
    let torsion_energy = (torsion_x * angle_x^2 + torsion_y * angle_y^2 + torsion_z * angle_z^2) / 1rad;
    potential: 0.5 * force_energy + 0.5 * torsion_energy;
    let elastic = stiffness_x * x * x_axis(a) + stiffness_y * y * y_axis(a) + stiffness_z * z * z_axis(a);
    let viscous = damping_x * rate(x) * x_axis(a) + damping_y * rate(y) * y_axis(a) + damping_z * rate(z) * z_axis(a);
    let pull = elastic + viscous;
    let way = (angle_x * x_axis(a) + angle_y * y_axis(a) + angle_z * z_axis(a)) / 1rad;
    let twist = torsion_x * angle_x * x_axis(a) + torsion_y * angle_y * y_axis(a) + torsion_z * angle_z * z_axis(a);
    let turning = Q.body.angular_velocity - P.body.angular_velocity;
    let slowed_x = torsion_damping_x * dot(x_axis(a), turning) * x_axis(a);
    let slowed_y = torsion_damping_y * dot(y_axis(a), turning) * y_axis(a);
    let slowed_z = torsion_damping_z * dot(z_axis(a), turning) * z_axis(a);
    let torque = twist + cross(way, twist) / 2 + factor * cross(way, cross(way, twist)) + slowed_x + slowed_y + slowed_z;
    at Q: -pull;
    at P: pull;
    on Q.body: -torque;
    on P.body: torque + cross(d, pull);
}
