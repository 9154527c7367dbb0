//! Constraints between two bodies, either of which may be ground.

/// Declares a constraint between bodies i and j three times: both move, i is ground, j is ground.
///
/// It begins with `$ i j`, so that the joint can be written with `$i` and `$j`.
#[macro_export]
macro_rules! pairs {
    ($d:tt $i:ident $j:ident
        $(#[doc = $doc:literal])*
        $module:ident ($($parameter:ident: $dim:ident),*) on i { $($on_i:tt)* } on j { $($on_j:tt)* } $($joint:tt)*
    ) => {
        $(#[doc = $doc])*
        pub mod $module {
            #![allow(clippy::wildcard_imports)]
            #[allow(unused_imports)]
            use super::*;

            macro_rules! joint {
                ($d name:ident $d $i:ident $d $j:ident $d($d frames:tt)*) => {
                    $crate::declared! {
                        /// The constraint between one pair of frames.
                        #[equations_only]
                        $d name ($($parameter: $dim = 1),*) { $d($d frames)* $($joint)* }
                    }
                };
            }
            joint!(Between $i $j body $i { $($on_i)* } body $j { $($on_j)* });
            joint!(FromGround ground $j ground { $($on_i)* } body $j { $($on_j)* });
            joint!(ToGround $i ground body $i { $($on_i)* } ground { $($on_j)* });

            /// Its rows for a case of the reference.
            #[must_use]
            pub fn rows(
                constraint: &$crate::common::reference::Value,
                at: &$crate::common::declared::Instant,
            ) -> $crate::common::declared::Rows {
                match (constraint["body_i"].as_str(), constraint["body_j"].as_str()) {
                    (Some("ground"), _) => $crate::units::rows_of::<FromGround>(constraint, at),
                    (_, Some("ground")) => $crate::units::rows_of::<ToGround>(constraint, at),
                    _ => $crate::units::rows_of::<Between>(constraint, at),
                }
            }
        }
    };
}

pairs! {$ i j
    #[doc = "Two points stay together."]
    revolute (point_i_x: Length, point_i_y: Length, point_j_x: Length, point_j_y: Length)
    on i { point P = (point_i_x, point_i_y); }
    on j { point Q = (point_j_x, point_j_y); }
    joint it = revolute($i.P, $j.Q);
}
pairs! {$ i j
    #[doc = "A slider, with the library's second row."]
    translational (
        point_i_x: Length, point_i_y: Length, axis_i_x: Number, axis_i_y: Number, point_j_x: Length, point_j_y: Length
    )
    on i { point P = (point_i_x, point_i_y);  axis u = (axis_i_x, axis_i_y); }
    on j { point Q = (point_j_x, point_j_y); }
    joint it = translational($i.u, $i.P, $j.Q);
}
pairs! {$ i j
    #[doc = "Two points keep their distance."]
    distance (point_i_x: Length, point_i_y: Length, point_j_x: Length, point_j_y: Length, distance: Length)
    on i { point P = (point_i_x, point_i_y); }
    on j { point Q = (point_j_x, point_j_y); }
    joint it = distance($i.P, $j.Q, distance);
}
pairs! {$ i j
    #[doc = "A point keeps its signed distance from a line."]
    revolute_translational (
        point_i_x: Length, point_i_y: Length, axis_i_x: Number, axis_i_y: Number, point_j_x: Length, point_j_y: Length, distance: Length
    )
    on i { point P = (point_i_x, point_i_y);  axis u = (axis_i_x, axis_i_y); }
    on j { point Q = (point_j_x, point_j_y); }
    joint it = revolute_translational($i.P, $i.u, $j.Q, distance);
}
pairs! {$ i j
    #[doc = "A pin in a slot."]
    point_on_line (
        point_i_x: Length, point_i_y: Length, axis_i_x: Number, axis_i_y: Number, point_j_x: Length, point_j_y: Length
    )
    on i { point P = (point_i_x, point_i_y);  axis u = (axis_i_x, axis_i_y); }
    on j { point Q = (point_j_x, point_j_y); }
    joint it = point_on_line($i.P, $i.u, $j.Q);
}
pairs! {$ i j
    #[doc = "Two bodies become one."]
    weld (point_i_x: Length, point_i_y: Length, point_j_x: Length, point_j_y: Length, angle: Angle)
    on i { point P = (point_i_x, point_i_y); }
    on j { point Q = (point_j_x, point_j_y); }
    joint it = weld($i.P, $j.Q, angle);
}
pairs! {$ i j
    #[doc = "Two gears on ground; the sign of the second radius tells an internal mesh."]
    gear_pair (radius_i: Length, signed_radius_j: Length, angle_i0: Angle, angle_j0: Angle)
    on i {}
    on j {}
    joint it = gear_pair($i, $j, radius_i, signed_radius_j, c: radius_i * angle_i0 + signed_radius_j * angle_j0);
}
pairs! {$ i j
    #[doc = "A pinion on a rack, which is the carrier."]
    rack_pinion (
        point_i_x: Length, point_i_y: Length, axis_i_x: Number, axis_i_y: Number, point_j_x: Length, point_j_y: Length,
        radius: Length, offset: Length
    )
    on i { point P = (point_i_x, point_i_y);  axis u = (axis_i_x, axis_i_y); }
    on j { point Q = (point_j_x, point_j_y); }
    joint it = rack_pinion($j, $j.Q, $i.u, $i.P, radius, offset);
}
pairs! {$ i j
    #[doc = "A motor between two bodies."]
    drive_relative_angle (
        c0: Angle, c1: Angle, c2: Angle, c3: Angle, c4: Angle, offset: Angle, amplitude: Angle, omega: Number, phase: Angle
    )
    on i {}
    on j {}
    let s = t / 1s;
    drive it = drive_relative_angle($i, $j, c0 + s * (c1 + s * (c2 + s * (c3 + s * c4))) + (offset + amplitude * sin(omega * s + phase)));
}
pairs! {$ i j
    #[doc = "A cylinder between two points."]
    drive_distance (
        point_i_x: Length, point_i_y: Length, point_j_x: Length, point_j_y: Length,
        c0: Length, c1: Length, c2: Length, c3: Length, c4: Length, offset: Length, amplitude: Length, omega: Number, phase: Angle
    )
    on i { point P = (point_i_x, point_i_y); }
    on j { point Q = (point_j_x, point_j_y); }
    let s = t / 1s;
    drive it = drive_distance($i.P, $j.Q, c0 + s * (c1 + s * (c2 + s * (c3 + s * c4))) + (offset + amplitude * sin(omega * s + phase)));
}
