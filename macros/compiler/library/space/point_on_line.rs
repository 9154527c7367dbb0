/// A point stays on a line of another body.
///
/// ```text
///       a ──▶               │ j
///   ═══════P═══════════════(Q)════
///     i    └ displacement ─▶┘
///
///   x_a · d = 0,  y_a · d = 0                  2 rows, m          d = r_Q − r_P
///   displacement = z_a · d
/// ```
///
/// The line goes through `P` along `a`. Removes two freedoms. Degenerate case: both points on the same body, which is refused.
///
/// Reference: Haug, section 9.4.
constraint point_on_line(P: Point, a: Axis, Q: Point) in space {
    require P.body == a.body: "the point and the axis of the line belong to one body";
    require P.body != Q.body: "the line and the point lie on the same body";
    let displacement = along(a, Q - P);
    across(a, Q - P) == 0;
}
