//! Quantities that do not fit their place.

crate::refusals! {
    item angle_for_a_length: "param a: Length = «30deg»;" => "expected a length (m), found an angle (rad)";
    item length_for_an_angle: "body b { start angle = «30mm»; }" => "expected an angle (rad), found a length (m)";
    item angle_added_to_a_length: "output b = «length + crank.angle»;" => "cannot add an angle (rad) to a length (m)\nhelp: an arc is a radius times an angle";
    item length_subtracted_from_a_time: "output b = «t - length»;" => "cannot subtract a length (m) from a time (s)";
    item sine_of_a_length: "output b = sin(«length»);" => "expected an angle (rad), found a length (m)";
    item arc_sine_of_a_length: "output b = asin(«length»);" => "expected a pure number, found a length (m)";
    item root_of_a_length_is_no_length: "let a: Length = «sqrt(length)»;" => "expected a length (m), found a quantity in m^(1/2)";
    item exponential_of_a_time: "output b = exp(«t»);" => "expected a pure number, found a time (s)";
    item minimum_of_unlike: "output b = «min(length, crank.angle)»;" => "cannot compare a length (m) with an angle (rad)\nhelp: an arc is a radius times an angle";
    item angular_velocity_is_no_frequency: "param f: Frequency = «60rpm»;" => "expected a frequency (1/s), found an angular velocity (rad/s)";
    item square_of_an_angle_is_no_angle: "param a: Angle = «2deg * 3deg»;" => "expected an angle (rad), found a quantity in rad²";
    item argument_of_a_joint: "drive a = drive_x(crank.A, «speed * t»);" => "`C` of `drive_x` is a length (m), found an angle (rad)";
    item argument_of_a_drive: "drive a = drive_angle(crank, «speed»);" => "`C` of `drive_angle` is an angle (rad), found an angular velocity (rad/s)\nhelp: multiply the rate by `t`";
    item argument_of_a_function: "output b = lift(«length»);" => "expected an angle (rad), found a length (m)";
    item value_of_a_function: "function f(a: Angle) -> Length = «sin(a)»;" => "expected a length (m), found a pure number";
    item function_of_another_argument: "function f(a: Length) -> Length = a; joint c = cam_knife(crank.O, ram.B, «f»);" => "expected a function of an angle (rad), found a function of a length (m)";
    item point_of_angles: "body b { point P = «(1deg, 2deg)»; }" => "a coordinate of a point is a length (m), found an angle (rad)\nhelp: write `(1mm, 2mm)`";
    item vector_of_unlike: "output b = «(length, crank.angle)»;" => "cannot make one vector of a length (m) and an angle (rad)\nhelp: an arc is a radius times an angle";
    item vector_and_number: "output b = «crank.A + 2»;" => "cannot add or subtract a vector and a number\nhelp: write the number as a vector, `(x, y)`, or take a component, `.x` or `.y`";
    item vector_times_vector: "output b = «crank.A * ram.B»;" => "there is more than one product of vectors\nhelp: write `dot(a, b)` or `cross(a, b)`";
    item number_by_vector: "output b = «2 / crank.A»;" => "nothing can be divided by a vector\nhelp: write `norm(v)` for its length";
    item equation_of_unlike: "joint a = { «crank.x == crank.angle»; }" => "cannot equate a length (m) with an angle (rad)\nhelp: an arc is a radius times an angle";
    item equation_of_vector_and_number: "joint a = { «crank.A == 0»; }" => "cannot equate a point with a number\nhelp: write `.x` or `.y` for one component, or `(x, y)` on the other side for both";
    item comparison_of_unlike: "output b = if «length < t» { 1 } else { 2 };" => "cannot compare a length (m) with a time (s)";
    item choice_of_unlike: "output b = «if length < 1 { length } else { t }»;" => "cannot choose between a length (m) and a time (s)";
    item power_of_a_length: "output b = length^«speed»;" => "expected a pure number, found an angular velocity (rad/s)";
    item odd_power_of_a_length: "output b = «length^0.3»;" => "a length (m) can only be raised to a number that is written out, a multiple of 1/6\nhelp: divide it by a quantity of its kind, and raise the ratio";
    item exponent_with_a_dimension: "output b = 2^«length»;" => "expected a pure number, found a length (m)";
    item table_of_unlike: "output b = table(crank.angle, [(0deg, 0mm), («90mm», 5mm)]);" => "expected an angle (rad), found a length (m)";
    item column_of_unlike: "output b = table(crank.angle, [(0deg, 0mm), (90deg, «5deg»)]);" => "expected a length (m), found an angle (rad)";
    item gear_of_radius_and_teeth: "joint a = «gear_pair»(crank, ram, 20mm, 10deg);" => "in `gear_pair`: cannot add a quantity in rad² to a quantity in m·rad\nnote: here `a` is a length (m), `b` is an angle (rad), `c` is a pure number";
    item body_for_a_point: "joint a = revolute(ground.O, «crank»);" => "`Q` of `revolute` takes a point, found a body\nhelp: write `crank.O`";
    item point_for_a_body: "drive a = drive_angle(«crank.A», speed * t);" => "`b` of `drive_angle` takes a body, found a point\nhelp: write `crank`";
    item number_for_a_point: "joint a = revolute(ground.O, «5mm»);" => "`Q` of `revolute` takes a point, found a number\nhelp: write `(x, y)` for a place in ground, `body.P` for a point of a body";
    item point_for_an_axis: "joint a = translational(«ground.O», ground.C, ram.B);" => "`u` of `translational` takes an axis, found a point\nhelp: write `(1, 0)`";
    item number_for_a_function: "joint a = cam_knife(crank.O, ram.B, «5mm»);" => "`R` of `cam_knife` takes a function of one variable, found a number\nhelp: declare one, such as `function name(x: Angle) -> Length = …;`";
    item joint_of_another_kind: "drive a = drive_along(«hinge», 5mm);" => "`slide` of `drive_along` takes a `translational` joint, found a `revolute` joint";
    item output_of_ground: "output b = «ground»;" => "an output is a number, a vector, a point or a body that moves, found ground";
    item output_of_a_function: "output b = «lift»;" => "an output is a number, a vector, a point or a body that moves, found a function";
    item negative_body: "output b = -«crank»;" => "expected a number or a vector, found a body\nhelp: its coordinates are `.x`, `.y` and `.angle`, its place is `.position`";
    item time_for_a_length: "drive a = drive_x(crank.A, «t»);" => "`C` of `drive_x` is a length (m), found a time (s)\nhelp: multiply the time by a rate in m/s";
    item point_for_a_joint: "drive a = drive_along(«crank.A», 5mm);" => "`slide` of `drive_along` takes a `translational` joint, found a point\nhelp: write the name of the joint";
    item length_equated_with_a_speed: "joint a = { «crank.x == 5mm_s»; }" => "cannot equate a length (m) with a velocity (m/s)\nhelp: multiply the rate by `t`";
}
