/// The angle of one body against another follows a law of time: a motor between them.
///
/// ```text
///      ╱ j
///     ╱ ◀╮
///    ╱   │ C(t)
///   ╱____│___ i
///
///   φ_j − φ_i − C(t) = 0                       1 row, rad
///   ν = Ċ,  γ = C̈
/// ```
///
/// As a load, its effort is the torque on `j`, and its opposite on `i` (N m, positive to the left); effort · Ċ is the power.
///
/// Reference: Nikravesh, section 4.2.6; Haug, section 3.5.
constraint drive_relative_angle(i: Body, j: Body, C: Angle) {
    require i != j: "a body cannot turn against itself";
    j.angle - i.angle == C;
}
