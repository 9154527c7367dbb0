//! Parameters and their bounds, and values written or read in the wrong place.

crate::refusals! {
    item bounds_without_a_unit: "param r: Length = «100mm» in 50..150;" => "the default, 100 mm, does not lie in 50 m .. 150 m\nhelp: `150` has no unit: write `150mm`";
    item number_type_for_a_dimension: "param a: «f64» = 300mm;" => "no dimension is called `f64`\nhelp: did you mean `Length`?";
    item number_type_for_a_number: "param a: «f64» = 3;" => "no dimension is called `f64`\nhelp: did you mean `Number`?";
    item default_below_its_bounds: "param r: Length = «4mm» in 5mm..=50mm;" => "the default, 4 mm, does not lie in 5 mm ..= 50 mm\nhelp: widen the range, or take a default within";
    item default_at_an_excluded_end: "param r: Length = «50mm» in 5mm..50mm;" => "the default, 50 mm, does not lie in 5 mm .. 50 mm\nhelp: widen the range, or take a default within";
    item default_above_its_bounds: "param r: Angle = «100deg» in ..90deg;" => "the default, 100 deg, does not lie in .. 90 deg\nhelp: widen the range, or take a default within";
    item bounds_the_wrong_way_round: "param r: Length = 10mm in «50mm..=5mm»;" => "no value lies in 50 mm ..= 5 mm\nhelp: the lesser value stands first";
    item bounds_of_nothing: "param r: Length = 10mm in «10mm..10mm»;" => "no value lies in 10 mm .. 10 mm\nhelp: write `..=` where the greatest value is allowed";
    item bound_of_another_dimension: "param r: Length = 10mm in 5mm..=«50deg»;" => "expected a length (m), found an angle (rad)";
    item bound_that_is_not_constant: "param r: Length = 10mm in 5mm..=«length»;" => "the bound of a parameter is a constant: numbers, units, `pi` and functions of them\nhelp: what depends on other parameters is a `require` in a constraint";
    item bound_in_time: "param r: Time = 10s in 5s..=«t»;" => "the bound of a parameter does not change with time: `t` cannot be used in it";
    item bound_that_is_not_finite: "param r: Number = 1 in «ln(0)»..2;" => "the bound is not a finite number";
    item bounds_without_dots: "param r: Length = 10mm in 5mm«;»" => "expected `..` or `..=` and the greatest value, found `;`";
    item bounds_without_ends: "param r: Length = 10mm in ..«;»" => "expected the greatest value, found `;`";
    item inclusive_bounds_without_an_end: "param r: Length = 10mm in 5mm..=«;»" => "expected the greatest value, found `;`";
    item bounds_in_a_part: "component Arm(P: Point) { param r: Length = «1mm» in 2mm..; body limb {} joint j = revolute(P, limb.position); } part arm = Arm(ground.O);" => "the default, 1 mm, does not lie in 2 mm ..\nnote: in `arm.r`\nhelp: widen the range, or take a default within";
    item bounds_in_an_array: "for i in 0..3 { param r[i]: Length = «i * 1mm» in 1mm..; }" => "the default, 0 m, does not lie in 1 mm ..\nnote: in `r[0]`\nhelp: widen the range, or take a default within";
    item range_of_something_else: "range «x» in 0s..1s;" => "expected `t in from..to`, found `x`\nhelp: a range is one of time: write `range t in 0s..1s;`";
    item range_without_a_last_time: "range t in «0s..»;" => "a range of time has two ends\nhelp: write `range t in 0s..1s;`";
    item range_without_a_first_time: "range t in «..1s»;" => "a range of time has two ends\nhelp: write `range t in 0s..1s;`";
    item range_the_wrong_way_round: "range t in «1s..0s»;" => "no value lies in 1 s .. 0 s\nhelp: the lesser value stands first";
    item range_of_another_dimension: "range t in 0s..«90deg»;" => "expected a time (s), found an angle (rad)";
    item range_that_moves: "range t in 0s..«1s * crank.angle / 1rad»;" => "the end of a range of time may depend on parameters only, not on what moves\nhelp: what moves along a body is a body of its own";
    item range_that_is_not_finite: "range t in 0s..«1s * ln(0)»;" => "the end of a range of time is not a finite number";
    item range_in_a_loop: "for i in 0..2 { «range» t in 0s..1s; }" => "`range` stands in the mechanism itself, not in a component or a loop\nhelp: move it out";
    item coordinate_of_a_point: "body b { point A = («100deg», 0mm); }" => "a coordinate of a point is a length (m), found an angle (rad)\nhelp: write `100mm`";
    item coordinate_of_a_place: "joint j = revolute((1mm, «2kg»), crank.A);" => "a coordinate of a point is a length (m), found a mass (kg)\nhelp: write `2mm`";
    item coordinate_of_a_start: "body b { start position = («speed», 0mm); }" => "a coordinate of a point is a length (m), found an angular velocity (rad/s)";
    item unit_with_a_letter_too_many: "param r: Length = «100mmm»;" => "no unit is called `mmm`\nhelp: did you mean `100mm`?";
    item output_read: "output twice = 2 * «tip».x;" => "`tip` is an output: it is read from Rust, not in the declaration\nhelp: name its value with `let tip = …;` and give that out with `output tip = tip;`";
    item output_of_a_part_read: "component Arm(P: Point) { body limb {} joint j = revolute(P, limb.position); output end = limb.position; } part arm = Arm(ground.O); output e = arm.«end».x;" => "`end` is an output: it is read from Rust, not in the declaration\nhelp: name its value with `let end = …;` and give that out with `output end = end;`";
    item parameter_given_as_an_argument: "component Arm(P: Point) { param r: Length = 1mm; body limb {} joint j = revolute(P, limb.position); } part arm = Arm(ground.O, «r»: 2mm);" => "`r` is a parameter in `Arm`, not an argument of it\nhelp: it is set in Rust, `mechanism.arm.r = …`; to set it here, declare `component Arm(…, r: …)`";
}
