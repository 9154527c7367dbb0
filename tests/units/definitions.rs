//! Formulas of the reference that the library writes differently, defined by `constraint!` as a user would.

use crate::pairs;

reuleaux::constraint! {
    /// A slider after Haug: unnormalised axes, required to be parallel.
    pub constraint slider(u: Axis, P: Point, v: Axis, Q: Point) {
        dot(perp(u), Q - P) == 0;
        dot(perp(u), v) == 0;
    }

    /// A point on a line with an unnormalised direction.
    pub constraint pin_in_slot(u: Axis, P: Point, Q: Point) {
        dot(perp(u), Q - P) == 0;
    }

    /// Two gears with moving centres: the line of centres rotates with the mean of the gears' angles.
    pub constraint gear_pair_centers(P: Point, Q: Point, r: Length, s: Length, a: Angle, b: Angle) {
        let sum = r * (P.body.angle + a) + s * (Q.body.angle + b) - s * pi;
        let direction_of_centers = sum / (r + s);
        (Q - P).x * sin(direction_of_centers) == (Q - P).y * cos(direction_of_centers);
    }
}

pairs! {$ i j
    #[doc = "A slider after Haug."]
    haug_translational (
        point_i_x: Length, point_i_y: Length, axis_i_x: Number, axis_i_y: Number,
        point_j_x: Length, point_j_y: Length, axis_j_x: Number, axis_j_y: Number
    )
    on i { point P = (point_i_x, point_i_y);  axis u = (axis_i_x, axis_i_y); }
    on j { point Q = (point_j_x, point_j_y);  axis v = (axis_j_x, axis_j_y); }
    use crate::units::slider;
    joint it = slider($i.u, $i.P, $j.v, $j.Q);
}
pairs! {$ i j
    #[doc = "A point on a line whose direction is not normalised."]
    haug_point_on_line (
        point_i_x: Length, point_i_y: Length, axis_i_x: Number, axis_i_y: Number, point_j_x: Length, point_j_y: Length
    )
    on i { point P = (point_i_x, point_i_y);  axis u = (axis_i_x, axis_i_y); }
    on j { point Q = (point_j_x, point_j_y); }
    use crate::units::pin_in_slot;
    joint it = pin_in_slot($i.u, $i.P, $j.Q);
}
pairs! {$ i j
    #[doc = "Two gears whose centres may move."]
    moving_gears (
        point_i_x: Length, point_i_y: Length, point_j_x: Length, point_j_y: Length,
        radius_i: Length, radius_j: Length, angle_i0: Angle, angle_j0: Angle
    )
    on i { point P = (point_i_x, point_i_y); }
    on j { point Q = (point_j_x, point_j_y); }
    use crate::units::gear_pair_centers;
    joint it = gear_pair_centers($i.P, $j.Q, radius_i, radius_j, angle_i0, angle_j0);
}
