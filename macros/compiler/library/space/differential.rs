/// A bevel differential: the housing turns with the mean of its two shafts.
///
/// ```text
///              ┌──────┬──────┐ θ_k
///              │  ╲───┴───╱  │
///              │ │╲╲     ╱╱│ │
///   θ_i ═══════╪═╡         ╞═╪═══════ θ_j
///              │ │╱╱     ╲╲│ │
///              │  ╱───┬───╲  │
///              └──────┴──────┘
///
///   (θ_i − θ_k) + ratio (θ_j − θ_k) − c = 0    1 row, rad
/// ```
///
/// `i` and `j` are the angles of the shafts, `k` that of the housing, all against one body about axes that point the same way. Where the
/// shafts are hinged on the housing, their angles are against it already: `k` is left out. Ratio 1 is the symmetric differential,
/// −z_j/z_i a spur differential. Removes one freedom; exact over any number of turns. Degenerate case: a ratio of zero, which is refused.
///
/// Reference: Willis, Principles of Mechanism.
constraint differential(i: Angle, j: Angle, k: Angle = 0, ratio: Number = 1, c: Angle = 0) in space {
    require ratio != 0: "a differential with ratio zero does not turn its second shaft";
    (i - k) + ratio * (j - k) == c;
}
