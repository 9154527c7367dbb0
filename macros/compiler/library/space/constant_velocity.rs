/// Two points stay together, and two shafts turn together, whatever the angle between them: a constant-velocity joint (homokinetic, Rzeppa).
///
/// ```text
///                         ╱╱ b, θ_b
///                        ╱╱
///      a ──▶ ╭─         ╱╱ ) β
///   ═════════╪═════════(●)─ ─ ─ ─
///            ╰─▶ θ_a  P = Q
///
///   r_P − r_Q = 0                                                     3 rows, m
///   ½ (1 + z_a · z_b) (x_a · y_b − y_a · x_b)
///     − ½ (x_a · z_b) (z_a · y_b) + ½ (y_a · z_b) (z_a · x_b) = 0     1 row
/// ```
///
/// `a` and `b` are the shafts, each an axis of its body, both in the direction in which the power goes: in line they point the same way.
/// x, y and z are their unit vectors, x towards the direction that the axis is declared with (`from`). The row says that b stands to a as if
/// it had been bent out of line about a direction across both shafts, and not turned: with the bend β, and θ_a and θ_b the angles of
/// the shafts, both counted from the plane of the shafts, the row is (1 + cos β) sin (θ_a − θ_b) = 0. x_a · y_b − y_a · x_b has
/// the same value, but it loses its digits where 1 + cos β is small. Removes four freedoms.
///
/// The row also holds with one shaft half a turn on. Of these two assemblies, which transmit the same, the one nearest to the declared
/// `start orientation` is taken. Degenerate case: where the shafts point against each other, β = 180°, they have no plane, and the row's
/// derivative vanishes; near it, the angles are as accurate as the direction of that plane, which is off by about ε / (π − β).
///
/// Reference: Hunt, Constant-velocity shaft couplings: a general theory (1973).
constraint constant_velocity(P: Point, a: Axis, Q: Point, b: Axis) in space {
    require P.body == a.body: "the first point and the first shaft of a constant-velocity joint belong to one body";
    require Q.body == b.body: "the second point and the second shaft of a constant-velocity joint belong to one body";
    require P.body != Q.body: "the two points of a constant-velocity joint lie on the same body";
    P == Q;
    (1 + dot(z_axis(a), z_axis(b))) / 2 * (dot(x_axis(a), y_axis(b)) - dot(y_axis(a), x_axis(b)))
        == (dot(x_axis(a), z_axis(b)) * dot(z_axis(a), y_axis(b)) - dot(y_axis(a), z_axis(b)) * dot(z_axis(a), x_axis(b))) / 2;
}
