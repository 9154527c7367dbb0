/// A bevel differential: the housing turns with the mean of its two shafts.
///
/// ```text
///             ┌──────┬──────┐ k
///             │  ╲───┴───╱  │
///             │ │╲╲     ╱╱│ │
///   i ════════╪═╡         ╞═╪════════ j
///             │ │╱╱     ╲╲│ │
///             │  ╱───┬───╲  │
///             └──────┴──────┘
///
///   φ_i + φ_j − 2 φ_k − c = 0                  1 row, rad
/// ```
///
/// `i` and `j` are the shafts, `k` the housing. With `ratio` r it is the general one,
/// (φ_i − φ_k) + r (φ_j − φ_k) − c = 0, where r = 1 is the symmetric differential and r = −z_j/z_i a
/// spur differential; r = 0 is refused. Angles are never wrapped.
///
/// Reference: Willis, Principles of Mechanism.
constraint differential(i: Body, j: Body, k: Body, ratio: Number = 1, c: Angle = 0) {
    require ratio != 0: "a differential with ratio zero does not turn its second shaft";
    require i != j: "the two shafts of a differential are the same body";
    require i != k: "the housing of a differential is one of its shafts";
    require j != k: "the housing of a differential is one of its shafts";
    (i.angle - k.angle) + ratio * (j.angle - k.angle) == c;
}
