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
    item equality_of_fractions: "let n = 3; output b = if «n / 2 == 1» { 1 } else { 2 };" => "equality of measured numbers is an accident\nhelp: compare with `<`, `<=`, `>` or `>=`";
    item equality_of_measures: "output b = if «2mm == 2mm» { 1 } else { 2 };" => "equality of measured numbers is an accident\nhelp: compare with `<`, `<=`, `>` or `>=`";
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

/// A declared name is never read as a unit.
#[test]
fn declared_names_are_no_units() {
    let source = "mechanism M { let s = 2; let m = 3; body b { point A = (3m / s, 0mm); mass = 1kg; inertia = 1kgm2; }
        joint o = revolute(ground.position, b.position); force f = { at b.A: (5N * m, 0N); } freedom q = b.angle; }";
    let refused = reuleaux_compiler::compile(source.parse().expect("the source consists of tokens")).err();
    assert!(refused.is_none(), "{refused:?}");
}
