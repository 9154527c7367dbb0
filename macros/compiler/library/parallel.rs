/// Two bodies do not turn against each other: `relative_angle` with the angle 0.
///
/// ```text
///      ╱ i              ╱ j
///     ╱                ╱
///    ╱ ) φ_i          ╱ ) φ_j
///   ╱_______ x       ╱_______ x
///
///   φ_j − φ_i = 0                              1 row, rad
/// ```
constraint parallel(i: Body, j: Body) {
    require i != j: "a body cannot turn against itself";
    j.angle == i.angle;
}
