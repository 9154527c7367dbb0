//! Nonsensical numbers.

crate::refusals! {
    item roller_without_radius: "joint a = cam_roller(crank.O, ram.B, «0mm», lift);" => "the radius of the roller is not positive: for a follower without a roller use `cam_knife`";
    mechanism an_axis_that_vanishes_at_the_defaults: "mechanism Way { param ax: Number = 0; ground { axis «u» = (ax, 0); } body s {} joint g = translational(ground.u, ground.position, s.position); drive m = drive_x(s.position, 1m * sin(1rad_s * t)); }" => "an axis of length zero has no direction\nnote: it is 0 at the declared defaults";
    item distance_below_zero: "joint a = distance(ground.O, crank.A, «-5mm»);" => "a distance is not negative";
    item distance_of_zero: "joint a = distance(ground.O, crank.A, «0mm»);" => "a distance of zero cannot be differentiated where it holds: use `revolute`, in space `spherical`, to keep two points together";
    item distance_of_a_zero_parameter: "param zero: Length = 0mm; joint a = distance(ground.O, crank.A, «zero»);" => "a distance of zero cannot be differentiated where it holds: use `revolute`, in space `spherical`, to keep two points together\nnote: it is 0 at the declared defaults";
    item absolute_distance_of_zero: "joint a = absolute_distance(crank.A, (0mm, 0mm), «0»);" => "a distance of zero cannot be differentiated where it holds: use `revolute` to keep a point in place";
    item gear_without_radius: "joint a = gear_pair(crank, ram, 1, «0»);" => "a gear without radius or teeth turns nothing: the ratio of a gear pair may not be zero";
    item mesh_without_radius: "joint a = involute_mesh(crank.O, ram.B, «0mm», 20mm, 0deg);" => "a gear without radius turns nothing: the pitch radius of a gear may not be zero";
    item mesh_without_second_radius: "joint a = involute_mesh(crank.O, ram.B, 20mm, b: «0mm», line: 0deg);" => "a gear without radius turns nothing: the pitch radius of a gear may not be zero";
    item mesh_of_a_gear_as_large_as_its_ring: "joint a = involute_mesh(crank.O, ram.B, 20mm, «-20mm», 0deg);" => "a gear as large as its ring gear does not roll in it: the sum of the signed pitch radii may not be zero";
    item mesh_of_radial_flanks: "joint a = involute_mesh(crank.O, ram.B, 20mm, 30mm, 0deg, «0deg»);" => "a pressure angle is positive: teeth with radial flanks are no involutes";
    item mesh_without_base_circles: "joint a = involute_mesh(crank.O, ram.B, 20mm, 30mm, 0deg, «90deg»);" => "a pressure angle is less than a right angle: the base circle has a radius";
    item mesh_on_no_side: "joint a = «involute_mesh»(crank.O, ram.B, 20mm, 30mm, 0deg, side: 2);" => "the side of a mesh is 1 where the gear of `A` drives to the left, and -1 where it drives to the right";
    item gear_without_radius_by_name: "joint a = gear_pair(crank, ram, a: «0mm», b: 1mm);" => "a gear without radius or teeth turns nothing: the ratio of a gear pair may not be zero";
    item pinion_without_radius: "joint a = rack_pinion(crank, ram.B, ground.u, ground.C, «0mm»);" => "a pinion without radius moves nothing: the radius of a rack and pinion may not be zero";
    item pulley_without_radius: "joint a = belt(crank, ram, «0mm», 10mm);" => "a pulley without radius turns nothing: the radius of a belt's pulley may not be zero";
    item axis_without_direction: "body b { axis u = «(0, 0)»; }" => "the axis `u` has no direction: both components are zero\nhelp: write `(1, 0)` for the direction of x";
    item division_by_zero: "output b = length / «0»;" => "division by zero";
    item division_by_hidden_zero: "output b = length / «(1mm - 1mm)»;" => "division by zero";
    item vector_by_zero: "output b = crank.A / «0»;" => "division by zero";
    item default_is_infinite: "param a: Number = «-ln(0)»;" => "the default is not a finite number";
    item default_is_no_number: "param a: Number = «sqrt(-1)»;" => "the default is not a finite number";
    item default_from_a_parameter: "param a: Length = «2 * length»;" => "the default of a parameter is a constant: numbers, units, `pi` and functions of them\nhelp: a quantity that follows from others is declared with `let`";
    item default_from_time: "param a: Time = 2 * «t»;" => "the default of a parameter does not change with time: `t` cannot be used in it\nhelp: write `let name = …;` for a law";
    item number_too_large: "param a: Length = «1e60mm»;" => "`1e60mm` cannot be kept exactly\nnote: in m, rad, s and kg, numbers lie between 1e-16 and 1e36, those of few digits down to 1e-36";
    item number_too_small: "param a: Length = «1e-35mm»;" => "`1e-35mm` cannot be kept exactly\nnote: in m, rad, s and kg, numbers lie between 1e-16 and 1e36, those of few digits down to 1e-36";
    item number_too_small_for_its_digits: "param a: Length = «1.23456789012345678901e-20m»;" => "`1.23456789012345678901e-20m` cannot be kept exactly\nnote: in m, rad, s and kg, numbers lie between 1e-16 and 1e36, those of few digits down to 1e-36";
    item a_start_that_is_no_number: "body b { start x = «1mm * sqrt(-1)»; }" => "the start value is not a finite number";
    item a_start_that_is_no_number_at_the_defaults: "body b { start angle = «asin(length / 50mm)»; }" => "the start value is not a finite number";
    item a_point_that_is_no_number: "body b { point P = «(1mm * ln(-2), 0mm)»; }" => "a coordinate of the point is not a finite number";
    item a_point_at_infinity: "param off: Angle = 0deg; body b { point P = «(1mm, 1mm * tan(90deg + off))»; }" => "a coordinate of the point is not a finite number";
    item an_axis_at_infinity: "body b { axis u = «(1, tan(-270deg))»; }" => "a component of the axis is not a finite number";
    item a_default_at_infinity: "param a: Number = «tan(450deg)»;" => "the default is not a finite number";
    item point_that_moves: "body b { point P = «(crank.x, 0mm)»; }" => "a point or an axis may depend on parameters only, not on what moves\nhelp: a point is written in the frame of its body, and joints bring points of two bodies together; what moves along a body is a body of its own";
    item point_in_time: "body b { point P = (1mm / 1s * «t», 0mm); }" => "a point or an axis does not change with time: `t` cannot be used in it\nhelp: declare a body with drives, such as `drive lift = drive_y(base.position, …);`, and write its points and axes in their place";
    item start_in_time: "body b { start angle = speed * «t»; }" => "a start value does not change with time: `t` cannot be used in it";
    item start_that_moves: "body b { start angle = «crank.angle»; }" => "a start value may depend on parameters only, not on what moves\nhelp: write where it is about";
    item function_of_time: "function f(a: Angle) -> Length = 1mm / 1s * «t»;" => "a function of one variable does not change with time: `t` cannot be used in it";
    item function_without_argument: "function f(Angle) -> Length = «2mm»;" => "a function written here names its argument\nhelp: write `function name(x: Angle) -> Length = …;`, or give the path of a Rust function";
    item equality_in_a_choice: "output b = if «length == 1» { 1 } else { 2 };" => "equality of measured numbers is an accident\nhelp: compare with `<`, `<=`, `>` or `>=`";
    item list_outside_a_table: "output b = «[1, 2]»;" => "a list can only be an argument of `table`, `spline` or `segments`\nhelp: a vector is written `(x, y)`, in space `(x, y, z)`; of an array each element has a line of its own, `let a[0] = …;`";
    item table_of_no_list: "output b = table(crank.angle, «5»);" => "expected a list of pairs, such as `[(0deg, 0mm), (90deg, 5mm)]`";
    item table_of_no_pairs: "output b = table(crank.angle, [«1», 2]);" => "expected a pair, such as `(90deg, 5mm)`";
    item table_of_triples: "output b = table(crank.angle, [«(0deg, 1mm, 2mm)»]);" => "expected a pair, such as `(90deg, 5mm)`";
    item table_of_one: "output b = table(crank.angle, «[(0deg, 1mm)]»);" => "a table needs at least 2 pairs, found 1";
    item table_that_does_not_increase: "output b = table(crank.angle, [(0deg, 1mm), (90deg, 2mm), («45deg», 3mm)]);" => "the first numbers of a table must increase from pair to pair: 45° comes after 90°";
    item table_that_repeats_an_abscissa: "output b = table(crank.angle, [(0deg, 1mm), («0deg», 2mm)]);" => "the first numbers of a table must increase from pair to pair: 0° comes after 0°";
    item periodic_table_with_a_jump: "output b = table(crank.angle, [(0deg, 1mm), (180deg, 5mm), «(360deg, 2mm)»], periodic);" => "a periodic table ends with the value it begins with: it begins with 1 mm and ends with 2 mm";
    item table_of_a_parameter: "output b = table(crank.angle, [(0deg, 1mm), (90deg, «length»)]);" => "an entry of a table is a constant: numbers, units, `pi` and functions of them\nhelp: multiply the table by what changes";
    item table_with_unknown_ends: "output b = table(crank.angle, [(0deg, 1mm), (90deg, 2mm)], «cyclic»);" => "outside its range a table is `periodic`, `linear` or `hold`, not `cyclic`";
    item spline_with_too_few: "output b = «spline»(crank.angle);" => "`spline` takes 2 or 3 arguments, found 1\nnote: `spline(x, [(x0, y0), (x1, y1), …], periodic)`";
    item spline_of_no_list: "output b = spline(crank.angle, «5»);" => "expected a list of pairs, such as `[(0deg, 0mm), (90deg, 5mm)]`";
    item spline_of_one: "output b = spline(crank.angle, «[(0deg, 1mm)]»);" => "a spline needs at least 2 pairs, found 1";
    item spline_that_goes_back: "output b = spline(crank.angle, [(0deg, 1mm), (90deg, 2mm), («45deg», 3mm)]);" => "the first numbers of a spline must increase from pair to pair: 45° comes after 90°";
    item periodic_spline_with_a_jump: "output b = spline(crank.angle, [(0deg, 1mm), «(360deg, 2mm)»], periodic);" => "a periodic spline ends with the value it begins with: it begins with 1 mm and ends with 2 mm";
    item spline_of_a_parameter: "output b = spline(crank.angle, [(0deg, 1mm), (90deg, «length»)]);" => "an entry of a spline is a constant: numbers, units, `pi` and functions of them\nhelp: multiply the spline by what changes";
    item spline_with_unknown_ends: "output b = spline(crank.angle, [(0deg, 1mm), (90deg, 2mm)], «linear»);" => "a spline is `periodic`, rests at both ends, `hold`, or has a velocity and an acceleration at each\nhelp: write `[(v0, a0), (v1, a1)]`, the derivatives at the first and at the last point";
    item spline_with_one_end: "output b = spline(crank.angle, [(0deg, 1mm), (90deg, 2mm)], «[(0, 0)]»);" => "a spline is `periodic`, rests at both ends, `hold`, or has a velocity and an acceleration at each\nhelp: write `[(v0, a0), (v1, a1)]`, the derivatives at the first and at the last point";
    item spline_that_ends_with_a_length: "output b = spline(crank.angle, [(0deg, 1mm), (90deg, 2mm)], [(0, 0), («2kg», 0)]);" => "expected a quantity in m/rad, found a mass (kg)";
    item spline_through_too_many: "output b = «spline»(t / 1s, [(0, 0), (1, 0), (2, 0), (3, 0), (4, 0), (5, 0), (6, 0), (7, 0), (8, 0), (9, 0), (10, 0), (11, 0), (12, 0), (13, 0), (14, 0), (15, 0), (16, 0), (17, 0), (18, 0), (19, 0), (20, 0), (21, 0), (22, 0), (23, 0), (24, 0), (25, 0), (26, 0), (27, 0), (28, 0), (29, 0), (30, 0), (31, 0), (32, 0), (33, 0), (34, 0), (35, 0), (36, 0), (37, 0), (38, 0), (39, 0), (40, 0), (41, 0), (42, 0), (43, 0), (44, 0), (45, 0), (46, 0), (47, 0), (48, 0), (49, 0), (50, 0), (51, 0), (52, 0), (53, 0), (54, 0), (55, 0), (56, 0), (57, 0), (58, 0), (59, 0), (60, 0), (61, 0), (62, 0), (63, 0), (64, 0)]);" => "a spline goes through 64 points at most, found 65\nhelp: `table` takes any number of points";
    item spline_beyond_all_numbers: "output b = «spline»(t / 1s, [(0, 0), (1, 1e-36)]);" => "the numbers of this spline are too small or too large to be kept\nnote: in m, rad, s and kg, they lie between 1e-16 and 1e36";
    item spline_through_points_at_uneven_distances: "output b = «spline»(t / 1s, [(0, 0), (1e-6, 1), (999, 3)]);" => "the spline overshoots so far between its points that its digits run out\nhelp: give points at more even distances, or take a `table`";
    item law_of_too_many_shares: "output b = «scca»(t / 1s, 0.6, 0.5);" => "`scca(u, b, c)` has shares b and c of the duration that are not negative and at most 1 together, found 0.6 and 0.5";
    item law_of_a_negative_share: "output b = «scca»(t / 1s, -1/4, 0.5);" => "`scca(u, b, c)` has shares b and c of the duration that are not negative and at most 1 together, found -0.25 and 0.5";
    item law_of_one_share: "output b = «scca»(t / 1s, 0.5);" => "`scca` takes 3 arguments, found 2";
    item law_of_a_share_that_changes: "output b = scca(t / 1s, 0.5, «length / 1m»);" => "a share of `scca` is a constant: numbers, units, `pi` and functions of them";
    item law_of_a_length: "output b = scca(«length», 0.5, 0.5);" => "expected a pure number, found a length (m)";
    item segment_by_a_law_with_an_argument: "output b = segments(crank.angle, 40mm, [rise(5mm, 90deg, «cycloidal(t)»)]);" => "expected the name of a law, such as `cycloidal` or a function of a number, `scca(b, c)` or `spline([…])`";
    item segment_by_a_spline_that_does_not_arrive: "output b = segments(crank.angle, 40mm, [rise(5mm, 90deg, «spline»([(0, 0), (1, 0.5)]))]);" => "the law of a segment goes from 0 to 1 while its argument does, and `spline` goes from 0 to 0.5";
    item segments_without_a_list: "output b = «segments»(crank.angle, 40mm);" => "`segments` takes 3 or 4 arguments, found 2\nnote: `segments(x, y0, [rise(height, duration, law), dwell(duration), …], periodic)`";
    item segments_of_no_list: "output b = segments(crank.angle, 40mm, «rise(5mm, 90deg, cycloidal)»);" => "expected a list of segments, such as `[rise(5mm, 90deg, cycloidal), dwell(30deg)]`";
    item segments_of_nothing: "output b = segments(crank.angle, 40mm, «[]»);" => "expected a list of segments, such as `[rise(5mm, 90deg, cycloidal), dwell(30deg)]`";
    item segments_with_unknown_ends: "output b = segments(crank.angle, 40mm, [dwell(360deg)], «cyclic»);" => "a program of segments is `periodic` or holds its ends, `hold`";
    item segments_of_an_unknown_word: "output b = segments(crank.angle, 40mm, [«lower»(5mm, 90deg, cycloidal)]);" => "a segment is `rise(height, duration, law)`, `fall(height, duration, law)` or `dwell(duration)`";
    item segments_with_a_return: "output b = segments(crank.angle, 40mm, [rise(5mm, 90deg, cycloidal), «return»(5mm, 90deg, cycloidal)]);" => "expected an expression, found `return`\nhelp: a segment that goes down is `fall(height, duration, law)`";
    item law_by_its_short_name: "output b = segments(crank.angle, 40mm, [rise(5mm, 90deg, «modsine»)]);" => "no function is called `modsine`\nhelp: did you mean `modified_sine`?";
    item law_by_another_name: "output b = 5mm * «trapezoid»(crank.angle / 90deg);" => "no function is called `trapezoid`\nhelp: did you mean `modified_trapezoidal`?";
    item polynomial_by_its_short_name: "output b = 5mm * «poly345»(crank.angle / 90deg);" => "no function is called `poly345`\nhelp: did you mean `polynomial_345`?";
    item segments_of_a_number: "output b = segments(crank.angle, 40mm, [«5mm»]);" => "a segment is `rise(height, duration, law)`, `fall(height, duration, law)` or `dwell(duration)`";
    item segment_without_law: "output b = segments(crank.angle, 40mm, [«rise»(5mm, 90deg)]);" => "`rise` takes 3 arguments, found 2\nnote: `rise(height, duration, law)`, with a law such as `cycloidal`";
    item dwell_with_height: "output b = segments(crank.angle, 40mm, [«dwell»(5mm, 90deg)]);" => "`dwell` takes 1 argument, found 2\nnote: `dwell(duration)`";
    item segment_with_a_number_for_its_law: "output b = segments(crank.angle, 40mm, [rise(5mm, 90deg, «0.5»)]);" => "expected the name of a law, such as `cycloidal` or a function of a number, `scca(b, c)` or `spline([…])`";
    item segment_of_another_dimension: "output b = segments(crank.angle, 40mm, [rise(«5deg», 90deg, cycloidal)]);" => "expected a length (m), found an angle (rad)";
    item segment_that_lasts_for_a_length: "output b = segments(crank.angle, 40mm, [rise(5mm, «90mm», cycloidal)]);" => "expected an angle (rad), found a length (m)";
    item segment_that_moves: "output b = segments(crank.angle, 40mm, [rise(«ram.x», 90deg, cycloidal)]);" => "a segment may depend on parameters only, not on what moves\nhelp: what moves along a body is a body of its own";
    item segment_by_a_law_of_lengths: "output b = segments(crank.angle, 40mm, [rise(5mm, 90deg, «lift»)]);" => "expected a pure number, found a length (m)";
    item segment_by_a_law_that_does_not_arrive: "output b = segments(crank.angle, 40mm, [rise(5mm, 90deg, «sin»)]);" => "the law of a segment goes from 0 to 1 while its argument does, and `sin` goes from 0 to 0.8415";
    item segment_without_duration: "output b = segments(crank.angle, 40mm, [rise(5mm, 90deg, cycloidal), dwell(«0deg»), fall(5mm, 270deg, cycloidal)], periodic);" => "the duration of a segment is positive, found 0°";
    item segment_backwards: "output b = segments(crank.angle, 40mm, [rise(5mm, 90deg, cycloidal), dwell(«-30deg»)]);" => "the duration of a segment is positive, found -30°";
    item segments_short_of_a_turn: "output b = segments(crank.angle, 40mm, [rise(5mm, 90deg, cycloidal), dwell(30deg), fall(5mm, «120deg», cycloidal)], periodic);" => "a periodic program fills one turn, and these segments fill 240°, 120° less\nhelp: add `dwell(120deg)`";
    item segments_over_a_turn: "output b = segments(crank.angle, 40mm, [rise(5mm, 100deg, cycloidal), dwell(30.5deg), fall(5mm, 120deg, cycloidal), dwell(«120deg»)], periodic);" => "a periodic program fills one turn, and these segments fill 370.5°, 10.5° more";
    item segments_that_end_higher: "output b = segments(crank.angle, 40mm, [rise(5mm, 90deg, cycloidal), dwell(30deg), fall(«4.8mm», 120deg, cycloidal), dwell(120deg)], periodic);" => "a periodic program ends at the height at which it begins, this one 0.2 mm above it";
    item segments_that_end_lower: "output b = segments(crank.angle, 40mm, [rise(5mm, 90deg, cycloidal), dwell(30deg), fall(«7mm», 120deg, cycloidal), dwell(120deg)], periodic);" => "a periodic program ends at the height at which it begins, this one 2 mm below it";
    item segments_with_a_jump_of_velocity: "output b = segments(crank.angle, 40mm, [dwell(30deg), «rise»(5mm, 90deg, linear), dwell(30deg)]);" => "the velocity jumps at 30°: `dwell` ends with 0 mm per degree and `linear` begins with 0.05556 mm per degree\nhelp: `half_cycloidal_start` goes from rest to a constant velocity, `half_cycloidal_end` back to rest";
    item segments_that_begin_with_a_jump: "output b = segments(crank.angle, 40mm, [«rise»(5mm, 100deg, linear), rise(2.5mm, 100deg, half_cycloidal_end)]);" => "the velocity jumps at 0°: the rest ends with 0 mm per degree and `linear` begins with 0.05 mm per degree\nhelp: `half_cycloidal_start` goes from rest to a constant velocity, `half_cycloidal_end` back to rest";
    item segments_with_a_jump_between_turns: "output b = segments(crank.angle, 40mm, [«rise»(2.5mm, 90deg, half_cycloidal_end), fall(2.5mm, 270deg, cycloidal)], periodic);" => "the velocity jumps at 0°: `cycloidal` ends with 0 mm per degree and `half_cycloidal_end` begins with 0.05556 mm per degree\nhelp: `half_cycloidal_start` goes from rest to a constant velocity, `half_cycloidal_end` back to rest";
    item modified_trapezoidal_is_a_function: "output b = «modified_trapezoidal» + 1;" => "expected a number or a vector, found a function\nhelp: give it its argument, as in `f(x)`";
    mechanism a_length_in_millimetres_without_unit: "mechanism M { ground { point C = (400mm, 0mm); } body crank { point A = (100mm, 0mm); } body coupler { point B = (350, 0); } body rocker { point B = (300mm, 0mm); start angle = 70deg; } joint o = revolute(ground.position, crank.position); joint a = revolute(crank.A, coupler.position); joint b = revolute(coupler.B, rocker.B); joint «c» = revolute(rocker.position, ground.C); drive d = drive_angle(crank, 60rpm * t); }" => "`c` stays open by 349400 mm when `o`, `a` and `b` are closed\nnote: `crank` (100 mm) + `ground` (400 mm) + `rocker` (300 mm) is 349200 mm short of `coupler` (350000 mm)\nhelp: change a length or a place: no value of `d` helps\nnote: `350` has no unit: it is 350 m, where no other length exceeds 400 mm\nhelp: write `350mm`, or `350m` if it is meant";
    item drive_of_a_hinge: "drive b = drive_angle(«hinge», 2rad);" => "`b` of `drive_angle` takes a body, found a `revolute` joint\nhelp: write `crank`";
    item angle_of_a_slide: "drive b = drive_angle(«slide», 2rad);" => "`b` of `drive_angle` takes a body, found a `translational` joint\nhelp: write `drive_along(slide, law)`";
    item angle_for_a_body: "drive b = drive_angle(«crank.angle», 2rad);" => "`b` of `drive_angle` takes a body, found a number\nhelp: write `crank`";
    item drive_of_a_hinge_between_bodies: "body rod { } joint pin = revolute(crank.A, rod.position); drive b = drive_angle(«pin», 2rad);" => "`b` of `drive_angle` takes a body, found a `revolute` joint\nhelp: write `drive_relative_angle(crank, rod, …)`";
    item program_that_lacks_a_quotient: "output b = segments(crank.angle, 40mm, [rise(12mm, 360deg / 7, cycloidal), dwell(4 * 360deg / 7), fall(12mm, «360deg / 7», cycloidal)], periodic);" => "a periodic program fills one turn, and these segments fill 308.571429°, 51.428571° less";
    item coordinate_for_an_axis_in_the_plane: "joint a = translational(«crank.x», ground.C, ram.B);" => "`u` of `translational` takes an axis, found a number\nhelp: write `(1, 0)` for the direction of x";
}

/// Numbers with more digits than can be stored exactly keep their significant digits.
#[test]
fn many_digits_are_read() {
    for number in [
        "0.1234567890123456789012345678901234mm",
        "1234567890.123456789012345678901234mm",
        "3.1415926535897932384626433832795028841971693993751mm",
        "57.29577951308232087679815481410517033240547246656432deg",
        "0x1F",
        "1.5e-17m",
    ] {
        let source = format!("mechanism M {{ let a = {number}; body b {{ }} joint w = weld(ground.position, b.position); }}");
        let refused = reuleaux_compiler::compile(source.parse().expect("the source consists of tokens"));
        assert!(refused.is_ok(), "{number}: {:?}", refused.err());
    }
}

/// Lengths without a unit cause a warning if they are out of proportion, and only then.
#[test]
fn bare_lengths_out_of_proportion_are_doubted() {
    let doubts = |length: &str, items: &str| -> Vec<String> {
        let source = format!(
            "mechanism M {{ {items} body b {{ point A = ({length}, 0mm); point B = (100mm, 0); }}
                joint o = revolute(ground.position, b.position); drive d = drive_angle(b, 60rpm * t); }}"
        );
        let compiled = reuleaux_compiler::compile(source.parse().expect("the source consists of tokens")).expect("it is valid");
        compiled.model.doubts.iter().map(|warning| warning.doubt.to_string()).collect()
    };
    let doubt = |number: &str| {
        let words = "has no unit: it is # m, where no other length exceeds 100 mm\nhelp: write `#mm`, or `#m` if it is meant";
        format!("`{number}` {}", words.replace('#', number))
    };
    assert_eq!(doubts("350", ""), [doubt("350")]);
    assert_eq!(doubts("-350", "param l: Length = 20;"), [doubt("20"), doubt("350")]);
    assert_eq!(
        doubts("1mm", "for i in 0..2 { body c[i] { point P = (42, 0mm); } joint w[i] = weld(ground.position, c[i].P); }"),
        [doubt("42")]
    );
    for meant in ["350mm", "350m", "0.35", "2", "4.9", "100mm * 350"] {
        assert_eq!(doubts(meant, ""), [""; 0], "{meant}");
    }
}

/// A declared name is never read as a unit.
#[test]
fn declared_names_are_no_units() {
    let source = "mechanism M { let s = 2; let m = 3; body b { point A = (3m / s, 0mm); mass = 1kg; inertia = 1kgm2; }
        joint o = revolute(ground.position, b.position); force f = { at b.A: (5N * m, 0N); } freedom q = b.angle; }";
    let refused = reuleaux_compiler::compile(source.parse().expect("the source consists of tokens")).err();
    assert!(refused.is_none(), "{refused:?}");
}

#[test]
fn sines_of_bare_numbers_that_are_rather_degrees_are_doubtful() {
    let doubts = |factor: &str| {
        let source = format!(
            "mechanism M {{ let k = {factor}; body b {{ point A = (1m, 0m); }} joint o = revolute(ground.position, b.position);
             drive d = drive_angle(b, k * 60rpm * t); }}"
        );
        let compiled = reuleaux_compiler::compile(source.parse().expect("the source consists of tokens")).expect("it is valid");
        compiled.model.doubts.iter().map(|warning| warning.doubt.to_string()).collect::<Vec<String>>()
    };
    let said = |call: &str, number: &str, instead: &str| {
        vec![format!("`{number}` has no unit: it is {number} rad\nhelp: write `{instead}`, or `{call}({number}rad)` if it is meant")]
    };
    assert_eq!(doubts("sin(30)"), said("sin", "30", "sin(30deg)"));
    assert_eq!(doubts("cos(-45)"), said("cos", "-45", "cos(-45deg)"));
    assert_eq!(doubts("2 * tan(7)"), said("tan", "7", "tan(7deg)"));
    for sure in ["sin(6)", "sin(30deg)", "cos(0.5)", "sin(30rad)", "exp(30)"] {
        assert_eq!(doubts(sure), Vec::<String>::new(), "{sure}");
    }
}

/// A rod with its centre at the origin reaches half of its length to both sides.
#[test]
fn rods_without_a_centre_are_doubted_where_a_point_lies_at_their_length() {
    let doubts = |ambient: &str, body: &str| {
        let source = format!(
            "#[equations_only] mechanism M {ambient} {{ param long: Length = 400mm;
                body b {{ mass = 1kg; {body} }} output place = b.position; }}"
        );
        let compiled = reuleaux_compiler::compile(source.parse().expect("tokens")).expect("a body with its mass");
        compiled.model.doubts.iter().map(|warning| warning.doubt.to_string()).collect::<Vec<String>>()
    };
    let said = |point: &str, center: &str, origin: &str| {
        vec![format!(
            "`b` has its centre of mass at its origin, so that its rod ends at half the distance of `{point}`\n\
             help: write `center = {center};`, or `center = {origin};` if the origin is meant"
        )]
    };
    assert_eq!(doubts("", "point A = (300mm, 0mm); inertia = rod(300mm);"), said("A", "(300mm / 2, 0m)", "(0m, 0m)"));
    assert_eq!(doubts("", "point O = (0m, 0m); point B = (long, 0mm); inertia = rod(long);"), said("B", "(long / 2, 0m)", "(0m, 0m)"));
    let in_space = "point A = (300mm, 0mm, 0mm); inertia = rod(300mm);";
    assert_eq!(doubts("in space", in_space), said("A", "(300mm / 2, 0m, 0m)", "(0m, 0m, 0m)"));
    assert_eq!(doubts("", "point A = (0mm, -300mm); inertia = rod(300mm);"), said("A", "(0m, -300mm / 2)", "(0m, 0m)"));
    assert_eq!(doubts("", "point A = (-long, 0mm); inertia = rod(long);"), said("A", "(-long / 2, 0m)", "(0m, 0m)"));
    for sure in [
        "point A = (300mm, 0mm); center = (0mm, 0mm); inertia = rod(300mm);",
        "point A = (300mm, 0mm); center = (150mm, 0mm); inertia = rod(300mm);",
        "point A = (150mm, 0mm); inertia = rod(300mm);",
        "point A = (300mm, 40mm); inertia = rod(300mm);",
        "point A = (300mm, 0mm); inertia = disk(300mm);",
        "axis u = (1, 0); inertia = rod(1m);",
    ] {
        assert_eq!(doubts("", sure), Vec::<String>::new(), "{sure}");
    }
}

/// Numbers in the place of quantities, wherever they stand.
#[test]
fn bare_numbers_in_the_place_of_quantities_are_doubted() {
    let doubts = |items: &str| {
        let source = format!(
            "mechanism M {{ ground {{ axis up = (0, 1); point top = (0mm, 400mm); }} body b {{ mass = 1kg; start y = 100mm; }}
                joint g = translational(ground.up, ground.position, b.position); {items} }}"
        );
        let compiled =
            reuleaux_compiler::compile(source.parse().expect("tokens")).unwrap_or_else(|refusals| panic!("{items}: {refusals:?}"));
        compiled.model.doubts.iter().map(|warning| warning.doubt.to_string()).collect::<Vec<String>>()
    };
    let angle =
        |number: &str| format!("`{number}` has no unit: it is {number} rad\nhelp: write `{number}deg`, or `{number}rad` if it is meant");
    let length = |number: &str| {
        let told = format!("`{number}` has no unit: it is {number} m, where no other length exceeds 400 mm");
        format!("{told}\nhelp: write `{number}mm`, or `{number}m` if it is meant")
    };
    let driven = "drive d = drive_y(b.position, 100mm);";
    let with = |items: &str| doubts(&format!("{driven} {items}"));
    assert_eq!(doubts("force s = spring(ground.top, b.position, stiffness: 1000N_m, rest: 200); freedom y = b.y;"), [length("200")]);
    assert_eq!(with("output far = if b.y < 300 { 1 } else { 2 };"), [length("300")]);
    assert_eq!(with("output far = b.y - 90;"), [length("90")]);
    assert_eq!(with("param swing: Angle = 30; output wave = sin(swing);"), [angle("30")]);
    assert_eq!(with("param swing: Angle = 1rad in 0..=360; output wave = sin(swing);"), [angle("360")]);
    let wheel = "body wheel { } joint axle = revolute(ground.position, wheel.position);";
    let turned = |law: &str| with(&format!("{wheel} drive turn = drive_angle(wheel, {law});"));
    assert_eq!(turned("90 * cycloidal(t / 1s)"), [angle("90")]);
    assert_eq!(turned("if t < 1s { 90 } else { 2rad }"), [angle("90")]);
    // Beside the variable of a loop, or by a name.
    let in_loop = |law: &str| {
        with(&format!(
            "for i in 0..2 {{ body wheel[i] {{ }} joint axle[i] = revolute(ground.position, wheel[i].position); drive turn[i] = drive_angle(wheel[i], {law}); }}"
        ))
    };
    assert_eq!(in_loop("1rad_s * t + 120 * i"), [angle("120")]);
    assert_eq!(in_loop("45deg + (i + 1) * 90"), [angle("90")]);
    assert_eq!(with("let phase = 90; output wave = sin(phase) + cos(phase);"), [angle("90")]);
    assert_eq!(with("param phase: Number = 120; output wave = sin(phase * 1.5);"), [""; 0]);
    assert_eq!(with(&format!("let phase = 120; {wheel} drive turn = drive_angle(wheel, 1rad_s * t + phase);")), [angle("120")]);
    assert_eq!(
        with("param phase: Number = 120; output wave = sin(phase);"),
        ["`120` has no unit: it is 120 rad where it is an angle\nhelp: write `phase: Angle = 120deg`"]
    );
    // A component has names of its own.
    let two =
        "component C() { let phase = 12deg; body c { } joint o = revolute(ground.position, c.position); drive x = drive_angle(c, phase); }";
    assert_eq!(with(&format!("let phase = 90; output n = phase + 1; {two} part c = C();")), [""; 0]);
    assert_eq!(in_loop("1rad_s * t + 120deg * i + 2 * pi * i / 12"), [""; 0]);
    let table =
        "drive turn = drive_angle(wheel, 1rad_s * t); output lift = table(wheel.angle, [(0, 0mm), (90, 5mm), (360, 0mm)], periodic);";
    assert_eq!(with(&format!("{wheel} {table}")), [angle("360")]);
    let motor = |speed: &str| with(&format!("{wheel} param speed: AngularVelocity = {speed}; drive turn = drive_angle(wheel, speed * t);"));
    let words = "`1500` has no unit: it is 1500 rad/s, 14324 rpm\nhelp: write `1500rpm`, or `1500rad_s` if it is meant";
    assert_eq!(motor("1500"), [words]);
    for sure in [motor("60"), motor("1500rpm"), turned("2 * cycloidal(t / 1s)"), with("output far = b.y - 2;")] {
        assert_eq!(sure, Vec::<String>::new());
    }
}

/// `from 50` is 50 m, and `at 3000` 3000 rad/s.
#[test]
fn bare_starts_of_freedoms_are_doubted() {
    let doubts = |freedoms: &str| {
        let source = format!("mechanism M {{ body b {{ mass = 1kg; inertia = 1kgm2; point P = (100mm, 0mm); }} {freedoms} }}");
        let compiled =
            reuleaux_compiler::compile(source.parse().expect("tokens")).unwrap_or_else(|refusals| panic!("{freedoms}: {refusals:?}"));
        compiled.model.doubts.iter().map(|warning| warning.doubt.to_string()).collect::<Vec<String>>()
    };
    let far = "`50` has no unit: it is 50 m, where no other length exceeds 100 mm\nhelp: write `50mm`, or `50m` if it is meant";
    assert_eq!(doubts("freedom x = b.x from 50; freedom y = b.y; freedom turn = b.angle;"), [far]);
    let fast = "`3000` has no unit: it is 3000 rad/s, 28648 rpm\nhelp: write `3000rpm`, or `3000rad_s` if it is meant";
    assert_eq!(doubts("freedom x = b.position; freedom turn = b.angle from 0 at 3000;"), [fast]);
    assert_eq!(doubts("freedom x = b.position from (1, 2); freedom turn = b.angle from 0 at 60;"), Vec::<String>::new());
}

/// Expressions that are valid, and often meant otherwise.
#[test]
fn expressions_that_are_often_meant_otherwise_are_doubted() {
    let doubts = |ambient: &str, items: &str| {
        let source = format!("#[equations_only] mechanism M {ambient} {{ {items} body b {{ }} output place = b.position; }}");
        let compiled =
            reuleaux_compiler::compile(source.parse().expect("tokens")).unwrap_or_else(|refusals| panic!("{items}: {refusals:?}"));
        compiled.model.doubts.iter().map(|warning| warning.doubt.to_string()).collect::<Vec<String>>()
    };
    let raised = |written: &str, meaning: &str, instead: &str| {
        vec![format!("`{written}` raises the number, too: it is `{meaning}`\nhelp: write `{instead}`, or `{meaning}` if it is meant")]
    };
    let plane = |items: &str| doubts("", items);
    assert_eq!(plane("param a: Area = 20mm^2;"), raised("20mm^2", "(20mm)^2", "20mm2"));
    assert_eq!(plane("let a = 60min^-1;"), raised("60min^-1", "(60min)^-1", "60rpm"));
    assert_eq!(plane("let a = 5s^-1;"), raised("5s^-1", "(5s)^-1", "5 / 1s"));
    assert_eq!(plane("let a = 5mm^3;"), raised("5mm^3", "(5mm)^3", "5 * 1mm^3"));
    for sure in ["let a = (20mm)^2;", "let a = 1mm^2;", "let a = 20^2;", "let a = 20mm2;"] {
        assert_eq!(plane(sure), Vec::<String>::new(), "{sure}");
    }
    let turns = "`f * t` counts turns, and as an angle it is taken in radians\nhelp: write `1turn * f * t`, or give an `AngularVelocity` instead of a \
                 `Frequency`";
    assert_eq!(plane("param f: Frequency = 5; let s = sin(f * t);"), [turns]);
    assert_eq!(plane("param f: Frequency = 5; let s = sin(2 * pi * f * t);"), Vec::<String>::new());
    assert_eq!(plane("param f: Frequency = 5; drive d = drive_angle(b, f * t);"), [turns]);
    assert_eq!(plane("param f: Frequency = 5; drive d = drive_angle(b, 1turn * f * t);"), Vec::<String>::new());
    let massless = "gravity acts on masses, and no body has one\nhelp: write `mass = 1kg;` in a body, or take `gravity` away";
    assert_eq!(plane("gravity = (0, -9.81m_s2);"), [massless]);
    let in_a_part = "gravity = (0, -9.81m_s2); component Weight(P: Point) { body w { mass = 1kg; } joint o = revolute(P, w.position); \
                     drive d = drive_angle(w, 1rad_s * t); } part w = Weight((1m, 0m));";
    assert_eq!(plane(in_a_part), Vec::<String>::new());
    let speed = "`1 / 0.5s` is a number of radians a second\nhelp: write `120rpm` for as many turns, or `rad_s` if radians are meant";
    assert_eq!(plane("param w: AngularVelocity = 1/0.5s;"), [speed]);
    for sure in ["param w: AngularVelocity = 2rad / 1s;", "param f: Frequency = 1/0.5s;", "param w: AngularVelocity = 2rad_s;"] {
        assert_eq!(plane(sure), Vec::<String>::new(), "{sure}");
    }
    let periods = |written: &str, instead: &str| vec![format!("`{written}` is taken in radians\nhelp: write `{instead}`")];
    assert_eq!(plane("param T: Time = 1s; drive d = drive_angle(b, t / T);"), periods("t / T", "1turn * t / T"));
    assert_eq!(plane("param T: Time = 1s; drive d = drive_angle(b, 360 * t / T);"), periods("360 * t / T", "360deg * t / T"));
    assert_eq!(plane("drive d = drive_angle(b, t / 2s);"), periods("t / 2s", "1turn * t / 2s"));
    assert_eq!(plane("drive d = drive_angle(b, 90 * t / 1s);"), periods("90 * t / 1s", "90deg * t / 1s"));
    assert_eq!(plane("drive d = drive_angle(b, 3000 * t / 60s);"), periods("3000 * t / 60s", "3000rpm * t"));
    assert_eq!(plane("drive d = drive_angle(b, 360 * t / 60s);"), periods("360 * t / 60s", "360deg * t / 60s"));
    let rise =
        "`cycloidal(t / 2s)` leads from 0 to 1, and as an angle to 1 rad\nhelp: write `90deg * cycloidal(t / 2s)` for a quarter of a turn";
    assert_eq!(plane("drive d = drive_angle(b, cycloidal(t / 2s));"), [rise]);
    for sure in ["t / 1s", "2 * t / 1s", "90deg * cycloidal(t / 2s)", "1turn * t / 2s"] {
        assert_eq!(plane(&format!("drive d = drive_angle(b, {sure});")), Vec::<String>::new(), "{sure}");
    }
    for sure in ["1turn * t / T", "360deg * t / T", "2 * pi * t / T", "3rad * t / T"] {
        assert_eq!(plane(&format!("param T: Time = 1s; drive d = drive_angle(b, {sure});")), Vec::<String>::new(), "{sure}");
    }
    let degrees = "`b.angle * 180 / pi` is an angle, and outputs of angles are in rad: it is 57 times too large\nhelp: write `b.angle / 1deg` for \
                   the number of degrees, or `.to_degrees()` in Rust";
    assert_eq!(plane("output a = b.angle * 180 / pi;"), [degrees]);
    let swapped =
        "`carrier` is in the place of the ring gear\nhelp: write `planetary(sun, ring, carrier, …)`: sun gear, ring gear, carrier";
    let train = |bodies: &str| {
        plane(&format!("body sun {{}} body ring {{}} body carrier {{}} body ring_carrier {{}} joint p = planetary({bodies}, 24, 72);"))
    };
    assert_eq!(train("sun, carrier, ring"), [swapped]);
    for sure in ["sun, ring, carrier", "sun, ring_carrier, ring", "carrier, ring, sun"] {
        assert_eq!(train(sure), Vec::<String>::new(), "{sure}");
    }
    for sure in [
        "output a = b.angle;",
        "output a = 180 / pi;",
        "output a = b.angle * 90 / pi;",
        "output a = sin(b.angle) * 180 / pi;",
        "output a = b.angle * 180Nm / pi;",
    ] {
        assert_eq!(plane(sure), Vec::<String>::new(), "{sure}");
    }
    let phase = |written: &str, gears: &str| {
        vec![format!(
            "`{written}` is `c` of `{gears}`, the angle in which the gears mesh at the start, and no size of a gear\nhelp: take it away: two sizes \
             belong to `{gears}`, and pressure angles do not matter; or write `c: {written}`"
        )]
    };
    let pair = |sizes: &str| plane(&format!("body c {{}} joint g = gear_pair(b, c, {sizes});"));
    assert_eq!(pair("20, 40, 20deg"), phase("20deg", "gear_pair"));
    assert_eq!(pair("20, 40, 60"), phase("60", "gear_pair"));
    let thirds = plane("body sun {} body ring {} body carrier {} joint p = planetary(sun, ring, carrier, 20, 40, 60);");
    assert_eq!(thirds, phase("60", "planetary"));
    for sure in ["20, 40", "20, 40, 0", "20, 40, 30deg", "20, 40, c: 20deg"] {
        assert_eq!(pair(sure), Vec::<String>::new(), "{sure}");
    }
    let pad = |coefficient: &str| {
        let pad = "friction(ground.position, (1, 0), c.position, 20N, «», 1mm_s)".replace("«»", coefficient);
        plane(&format!("body c {{ mass = 1kg; }} force f = {pad};"))
    };
    let percentage = "a coefficient of friction of 20 is rare\nhelp: write `0.2` for 20 per cent";
    assert_eq!(pad("20"), [percentage]);
    assert_eq!(pad("0.2"), Vec::<String>::new());
    let spring = |force: &str| plane(&format!("body c {{ point P = (1m, 0m); mass = 1kg; }} force k = {force};"));
    let meant = "help: take the minus away, or name the number with `let` if it is meant";
    let pushes = format!("`-200N_m` pushes away from rest\n{meant}");
    assert_eq!(spring("spring((5m, 0m), c.P, -200N_m, rest: 1m)"), [pushes.as_str()]);
    assert_eq!(spring("torsion_spring(ground, c, stiffness: -5Nm_rad, rest: 0deg)"), [pushes.replace("200N_m", "5Nm_rad")]);
    let damping = format!("`-3Ns_m` drives the motion instead of damping it\n{meant}");
    assert_eq!(spring("damper((5m, 0m), c.P, -3Ns_m)"), [damping.as_str()]);
    assert_eq!(spring("torsion_damper(ground, c, -3Nms_rad)"), [damping.replace("3Ns_m", "3Nms_rad")]);
    let rest = format!("`-1m` is a length that no spring has\n{meant}");
    assert_eq!(spring("spring((5m, 0m), c.P, 200N_m, rest: -1m)"), [rest.as_str()]);
    for sure in ["spring((5m, 0m), c.P, 200N_m, rest: 1m)", "actuator((5m, 0m), c.P, -200N)", "torsion_spring(ground, c, 5Nm_rad, -3deg)"] {
        assert_eq!(spring(sure), Vec::<String>::new(), "{sure}");
    }
    let jumps = "a change of `w` acts over all the time before it: `w * t` jumps\nhelp: a commanded speed is a `param` of a mechanism that is \
                 `#[integrated]`: see the page on control loops";
    assert_eq!(plane("input w: AngularVelocity; drive d = drive_angle(b, w * t);"), [jumps]);
    let gravity =
        |found: &str| vec![format!("the acceleration of free fall is {found} here, and 9.81 m/s² on Earth\nhelp: write `9.81m_s2`")];
    assert_eq!(plane("body c { mass = 1kg; } gravity = (0, -9810);"), gravity("9810 m/s²"));
    assert_eq!(plane("body c { mass = 1kg; } gravity = (0, -1.62m_s2);"), Vec::<String>::new());
    let upwards = "gravity points upwards here\nhelp: write `-9.81m_s2`, or name the number with `let` if it is meant";
    assert_eq!(plane("body c { mass = 1kg; } gravity = (0, 9.81m_s2);"), [upwards]);
    assert_eq!(doubts("in space", "body c { mass = 1kg; } gravity = (0, 0, 9.81m_s2);"), [upwards]);
    for sure in ["gravity = (9.81m_s2, 0);", "gravity = (0, 1.62m_s2);", "let g = 9.81m_s2; gravity = (0, g);"] {
        assert_eq!(plane(&format!("body c {{ mass = 1kg; }} {sure}")), Vec::<String>::new(), "{sure}");
    }
    let wide = "the inertia of `c` is that of its mass at a distance of 86600 mm, where no length exceeds 300 mm\nhelp: a number without a unit is \
                in kg m²; write `kgm2`, `kgcm2` or `kgmm2`";
    let inertia = |inertia: &str| plane(&format!("body c {{ point P = (300mm, 0mm); mass = 2kg; inertia = {inertia}; }}"));
    assert_eq!(inertia("15000"), [wide]);
    for sure in ["0.015", "15000kgm2"] {
        assert_eq!(inertia(sure), Vec::<String>::new());
    }
    let center =
        "`center` is a point here, and the centre of mass of `c` is its origin\nhelp: write `center = (…);` for the centre of mass";
    assert_eq!(plane("body c { mass = 1kg; point center = (1mm, 0mm); }"), [center]);
    for sure in ["point center = (1mm, 0mm); center = (1mm, 0mm);", "point center = (0mm, 0mm);"] {
        assert_eq!(plane(&format!("body c {{ mass = 1kg; {sure} }}")), Vec::<String>::new());
    }
    let rod = |point: &str| {
        doubts("in space", &format!("body c {{ mass = 1kg; point P = {point}; center = (1mm, 0mm, 0mm); inertia = rod(300mm); }}"))
    };
    let across = "a rod lies along x, but `P` of `c` lies across it\nhelp: write `inertia = rod(300mm) along turn((0, 0, 1), 90deg);`";
    assert_eq!(rod("(0mm, 300mm, 0mm)"), [across]);
    assert_eq!(rod("(0mm, 0mm, -300mm)"), [across.replace("(0, 0, 1), 90deg", "(0, 1, 0), 90deg")]);
    assert_eq!(rod("(300mm, 0mm, 0mm)"), Vec::<String>::new());
}

/// The axis of a disk is z, that of a wheel often another one.
#[test]
fn disks_across_the_only_axis_are_doubted() {
    let doubts = |body: &str| {
        let source = format!("#[equations_only] mechanism M in space {{ body b {{ mass = 1kg; {body} }} output place = b.position; }}");
        let compiled = reuleaux_compiler::compile(source.parse().expect("tokens")).expect("a body with its mass");
        compiled.model.doubts.iter().map(|warning| warning.doubt.to_string()).collect::<Vec<String>>()
    };
    let across = |shape: &str, turn: &str| {
        vec![format!("the axis of `{shape}` lies along z, but `n` of `b` lies across it\nhelp: write `inertia = {shape} along {turn};`")]
    };
    assert_eq!(doubts("axis n = (1, 0, 0); inertia = disk(200mm);"), across("disk(200mm)", "turn((0, 1, 0), 90deg)"));
    assert_eq!(doubts("axis n = (0, -1, 0); inertia = cylinder(20mm, 1m);"), across("cylinder(20mm, 1m)", "turn((1, 0, 0), 90deg)"));
    for sure in [
        "axis n = (0, 0, 1); inertia = disk(200mm);",
        "axis n = (1, 0, 0); axis m = (0, 0, 1); inertia = disk(200mm);",
        "axis n = (1, 0, 1); inertia = disk(200mm);",
        "axis n = (1, 0, 0); inertia = disk(200mm) along turn((0, 1, 0), 90deg);",
        "axis n = (1, 0, 0); inertia = ball(200mm);",
    ] {
        assert_eq!(doubts(sure), Vec::<String>::new(), "{sure}");
    }
}

/// The arms of a cross are at right angles; shafts are in line.
#[test]
fn shafts_for_the_arms_of_a_universal_joint_are_told() {
    let shafts = "`hooke` is given two axes in line, as shafts are; those of a universal joint are the arms of its cross, at right angles\n\
                  help: declare them across the shafts, such as `axis arm = (0, 0, 1);` in one body and `axis arm = (0, 1, 0);` in the other";
    let source = |one: &str, two: &str, start: &str| {
        format!(
            "mechanism M in space {{
                param bend: Angle = 20deg;
                ground {{ axis x = (1, 0, 0); axis out = (cos(bend), sin(bend), 0); }}
                body one {{ axis x = (1, 0, 0); axis arm = (0, 0, 1); }}
                body two {{ axis x = (1, 0, 0); axis arm = (0, 1, 0); axis up = (0, 0, 1); start orientation = {start}; }}
                joint bearing = revolute(ground.position, ground.x, one.position, one.x);
                joint hooke = universal(one.position, one.{one}, two.position, two.{two});
                joint seat = parallel_axes(ground.out, two.x);
                drive motor = drive_rotation(bearing, 60rpm * t);
            }}"
        )
    };
    let compile = |one: &str, two: &str, start: &str| reuleaux_compiler::compile(source(one, two, start).parse().expect("tokens"));
    let refused = compile("x", "x", "turn((0, 0, 1), 20deg)").expect_err("shafts that are to be at right angles");
    let words: Vec<String> = refused.iter().map(|refusal| refusal.fact.message()).collect();
    assert!(words.iter().all(|words| words.contains(shafts)), "{words:?}");
    compile("arm", "arm", "turn((0, 0, 1), 20deg)").expect("a shaft with a bend");
    // An error about other joints keeps its help.
    let other =
        "body lever { } joint pivot = spherical(ground.position, lever.position); drive swing = drive_x(lever.position, 1m * t / 1s);";
    let other = source("x", "x", "turn((0, 0, 1), 20deg)").replace("drive motor", &format!("{other} drive motor"));
    let refused = reuleaux_compiler::compile(other.parse().expect("tokens")).expect_err("a ball that holds a place");
    let told = refused.iter().filter(|refusal| refusal.fact.message().contains(shafts));
    assert!(told.into_iter().all(|refusal| !refusal.fact.message().contains("lever")), "{refused:?}");
}

/// More than a turn of radians is rather one of degrees.
#[test]
fn starts_of_angles_without_unit_are_doubted() {
    let doubts = |start: &str, coordinate: &str, from: &str| {
        let source = format!(
            "mechanism M {{ body b {{ point P = (1m, 0m); mass = 1kg; inertia = 1kgm2; {start} }} joint o = revolute(ground.position, b.position);
                freedom q = {coordinate} {from}; }}"
        );
        let compiled = reuleaux_compiler::compile(source.parse().expect("tokens")).expect("a number is an angle");
        compiled.model.doubts.iter().map(|warning| warning.doubt.to_string()).collect::<Vec<String>>()
    };
    let doubt = |number: &str| {
        vec![format!("`{number}` has no unit: it is {number} rad\nhelp: write `{number}deg`, or `{number}rad` if it is meant")]
    };
    assert_eq!(doubts("start angle = 35;", "b.angle", ""), doubt("35"));
    assert_eq!(doubts("start angle = -120;", "b.angle", ""), doubt("-120"));
    assert_eq!(doubts("", "b.angle", "from 60"), doubt("60"));
    for (start, coordinate, from) in [
        ("start angle = 6;", "b.angle", ""),
        ("start angle = 35deg;", "b.angle", "from 35deg"),
        ("", "b.angle", "from 60rad at 90"),
        ("start x = 3;", "b.angle", "from -6"),
    ] {
        assert_eq!(doubts(start, coordinate, from), [""; 0], "{start} {from}");
    }
}

#[test]
fn drives_that_stand_still_at_a_bare_number_are_doubted() {
    let doubts = |source: String| {
        let compiled = reuleaux_compiler::compile(source.parse().expect("tokens")).expect("a number is an angle");
        compiled.model.doubts.iter().map(|warning| warning.doubt.to_string()).collect::<Vec<String>>()
    };
    let plane = |law: &str| {
        format!("mechanism M {{ body b {{ }} joint o = revolute(ground.position, b.position); drive d = drive_angle(b, {law}); }}")
    };
    let space = |law: &str| {
        format!(
            "mechanism M in space {{ body b {{ axis z = (0, 0, 1) from (1, 0, 0); }}
                joint o = revolute((0m, 0m, 0m), (0, 0, 1), b.position, b.z); drive d = drive_rotation(o, {law}); }}"
        )
    };
    let wanted =
        "`60` has no unit: it is 60 rad, at which the drive stands still\nhelp: write `60rpm * t` for a speed, or `60deg` for an angle";
    for source in [plane("60"), space("60")] {
        assert_eq!(doubts(source), [wanted]);
    }
    for sure in ["6", "60deg", "60rad", "60rpm * t", "90deg + 60rpm * t", "3 * sin(60rpm * t) + 6", "sin(60 * t / 1s)"] {
        assert_eq!(doubts(plane(sure)), [""; 0], "{sure}");
    }
    let as_a_part = "`90` has no unit: it is 90 rad\nhelp: write `90deg`, or `90rad` if it is meant";
    for law in ["60rpm * t + 90", "0.5rad - 90", "90 * sin(60rpm * t)", "6 - cos(60rpm * t) * 90", "-(60rpm * t + 90)"] {
        assert_eq!(doubts(plane(law)), [as_a_part], "{law}");
    }
}
