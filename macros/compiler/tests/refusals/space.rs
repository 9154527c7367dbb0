//! Space: names that belong to the plane and vice versa, components, axes, hinges that over-constrain.

/// A body on a hinge to ground; `$rest` adds one item.
macro_rules! hinge {
    ($rest:literal) => {
        concat!(
            "mechanism Hinge in space {
                ground { axis z = (0, 0, 1); }
                body b { axis z = (0, 0, 1); point A = (1m, 0m, 0m); }
                joint a = revolute(ground.position, ground.z, b.position, b.z); ",
            $rest,
            "}"
        )
    };
}

/// The same with a motor.
macro_rules! driven {
    ($rest:literal) => {
        concat!(
            "mechanism Hinge in space {
                ground { axis z = (0, 0, 1); }
                body b { axis z = (0, 0, 1); point A = (1m, 0m, 0m); }
                joint a = revolute(ground.position, ground.z, b.position, b.z); drive m = drive_rotation(a, 60rpm * t); ",
            $rest,
            "}"
        )
    };
}

/// The same in the plane.
macro_rules! plane {
    ($rest:literal) => {
        concat!(
            "mechanism Hinge {
                ground { axis u = (1, 0); } body b { point A = (1m, 0m); }
                joint a = revolute(ground.position, b.position); ",
            $rest,
            "}"
        )
    };
}

/// A planar four-bar whose hinges are joints of space; `$rest` closes it.
macro_rules! four_bar {
    ($rest:literal) => {
        concat!(
            "mechanism FourBar in space {
                ground { axis z = (0, 0, 1); point C = (400mm, 0mm, 0mm); }
                body crank { axis z = (0, 0, 1); point A = (100mm, 0mm, 0mm); }
                body coupler { axis z = (0, 0, 1); point B = (350mm, 0mm, 0mm); }
                body rocker { axis z = (0, 0, 1); point B = (300mm, 0mm, 0mm); point D = (300mm, 0mm, 10mm); start orientation = turn((0, 0, 1), 70deg); }
                joint o = revolute(ground.position, ground.z, crank.position, crank.z);
                joint a = revolute(crank.A, crank.z, coupler.position, coupler.z);
                joint c = revolute(ground.C, ground.z, rocker.position, rocker.z);
                drive input = drive_rotation(o, 60rpm * t); ",
            $rest,
            "}"
        )
    };
}

/// The same, with axes on coupler and rocker that are a little askew.
macro_rules! tilted {
    ($rest:literal) => {
        concat!(
            "mechanism FourBar in space {
                ground { axis z = (0, 0, 1); point C = (400mm, 0mm, 0mm); }
                body crank { axis z = (0, 0, 1); point A = (100mm, 0mm, 0mm); }
                body coupler { axis z = (0, 0, 1); axis w = (0, 0.02, 1); point B = (350mm, 0mm, 0mm); }
                body rocker { axis z = (0, 0, 1); axis w = (0, 0.02, 1); point B = (300mm, 0mm, 0mm); start orientation = turn((0, 0, 1), 70deg); }
                joint o = revolute(ground.position, ground.z, crank.position, crank.z);
                joint a = revolute(crank.A, crank.z, coupler.position, coupler.z);
                joint c = revolute(ground.C, ground.z, rocker.position, rocker.z);
                drive input = drive_rotation(o, 60rpm * t); ",
            $rest,
            "}"
        )
    };
}

/// Sarrus' linkage, which lifts a platform in a straight line; `$rest` closes the second of its chains.
macro_rules! sarrus {
    ($rest:literal) => {
        concat!(
            "mechanism Sarrus in space {
                ground { axis x = (1, 0, 0); axis y = (0, 1, 0); point P = (0mm, -200mm, 0mm); point Q = (-200mm, 0mm, 0mm); }
                body platform { axis x = (1, 0, 0); axis y = (0, 1, 0); point P = (0mm, -200mm, 0mm); point Q = (-200mm, 0mm, 0mm); start z = 360mm; }
                body lower { axis x = (1, 0, 0); point P = (0mm, 300mm, 0mm); start orientation = turn((1, 0, 0), 143deg); }
                body upper { axis x = (1, 0, 0); point P = (0mm, 300mm, 0mm); start position = (0mm, -440mm, 180mm); start orientation = turn((1, 0, 0), 37deg); }
                body inner { axis y = (0, 1, 0); point Q = (300mm, 0mm, 0mm); start orientation = turn((0, 1, 0), -143deg); }
                body outer { axis y = (0, 1, 0); point Q = (300mm, 0mm, 0mm); start position = (-440mm, 0mm, 180mm); start orientation = turn((0, 1, 0), -37deg); }
                joint a = revolute(ground.P, ground.x, lower.position, lower.x);
                joint b = revolute(lower.P, lower.x, upper.position, upper.x);
                joint c = revolute(upper.P, upper.x, platform.P, platform.x);
                joint d = revolute(ground.Q, ground.y, inner.position, inner.y);
                joint e = revolute(inner.Q, inner.y, outer.position, outer.y);
                drive lift = drive_rotation(a, 143deg - 5deg * sin(1rad_s * t)); ",
            $rest,
            "}"
        )
    };
}

/// Refused with these words, at the marked token.
macro_rules! refused {
    ($($frame:ident $name:ident: $source:literal => $words:literal;)*) => {
        $(#[test] fn $name() { crate::mechanism($frame!($source), $words); })*
    };
}

refused! {
    driven a_perpendicular_in_space: "output o = «perp»(b.A);" => "`perp` is for the plane; in space write `cross(axis, v)`";
    driven a_direction_in_space: "output o = «direction»(b.A);" => "`direction` is for the plane; in space write `joint.angle`, or `atan2` of two dot products";
    hinge a_drive_of_the_plane_in_space: "drive m = «drive_angle»(b, 60rpm * t);" => "`drive_angle` is for the plane; in space write `drive_rotation(joint, law)`";
    driven a_joint_of_the_plane_in_space: "joint c = «absolute_angle»(b, 0deg);" => "`absolute_angle` is for the plane; in space write an equation of `joint.angle`, or `absolute_orientation(a, b)`";
    driven a_start_angle_in_space: "body c { start «angle» = 30deg; }" => "a body in space does not start with `angle`\nnote: it starts with `x`, `y`, `z`, `position` or `orientation`, such as `start orientation = turn((0, 0, 1), 30deg);`";
    driven a_start_of_a_joint_by_its_name: "start «a» = 30deg;" => "`a` is no angle and no displacement of a joint\nhelp: write `start a.angle = 30deg;`; where a body starts is told in the body, as in `start position = …;`";
    driven a_start_of_a_sum: "start «a.angle + 1rad» = 30deg;" => "`a.angle + 1rad` is no angle and no displacement of a joint\nhelp: write `start joint.angle = 30deg;`; where a body starts is told in the body, as in `start position = …;`";
    driven a_start_of_no_joint: "start «angle» = 30deg;" => "`angle` lacks its joint\nhelp: write `start joint.angle = …;`";
    driven a_start_of_a_body_outside: "start «position» = (1m, 0m, 0m);" => "a start outside bodies is that of a joint\nhelp: write `start position = …;` in `body b { … }`";
    driven a_start_of_a_named_body_outside: "start «b.orientation» = turn((0, 0, 1), 30deg);" => "a start outside bodies is that of a joint\nhelp: write `start orientation = …;` in `body b { … }`";
    driven a_start_of_a_joint_in_a_body: "body c { start «a».angle = 30deg; }" => "a body declares its own start, and that of a joint stands outside bodies\nhelp: move it out of the body";
    driven a_turn_about_no_direction: "output o = turn(«(0, 0, 0)», 30deg) * b.A;" => "the axis `(0, 0, 0)` has no direction: all components are zero\nhelp: write `(1, 0, 0)` for the direction of x";
    driven a_joint_along_no_direction: "body c {} joint d = point_on_line(ground.position, «(0m, 0m, 0m)», c.position);" => "the axis `(0m, 0m, 0m)` has no direction: all components are zero\nhelp: write `(1, 0, 0)` for the direction of x";
    driven two_starts_of_a_joint: "start a.angle = 30deg; start «a.angle» = 31deg;" => "the start of `a` gives `angle` twice\nhelp: take one away";
    driven a_start_of_a_joint_in_mm: "start a.angle = «30mm»;" => "expected an angle (rad), found a length (m)";
    driven a_start_of_a_joint_that_moves: "start a.angle = «a.angle»;" => "a start value may depend on parameters only, not on what moves\nhelp: write where it is about";
    driven a_start_with_the_orientation_of_another: "body c { start orientation = «b.orientation * turn((0, 0, 1), 30deg)»; }" => "a start value may depend on parameters only, not on what moves\nhelp: write where it is about";
    driven an_orientation_that_is_an_angle: "joint c = { «b.orientation == 30deg»; }" => "cannot equate an orientation with a number\nhelp: an orientation is a product of turns, such as `turn((0, 0, 1), 30deg)`";
    driven an_orientation_after_a_vector: "output o = (1, 0, 0) * «b.orientation»;" => "expected a number or a vector, found an orientation\nhelp: orientations are multiplied, and one stands before the vector that it turns";
    driven an_orientation_as_an_output: "output o = «b.orientation»;" => "an output is a number, a vector, a point or a body that moves, found an orientation\nhelp: write `state.body().orientation()` in the program; `body.orientation * (1, 0, 0)` is a direction";
    driven a_start_without_axis: "body c { start orientation = «30deg»; }" => "expected an orientation, such as `turn((0, 0, 1), 30deg)`, found a number";
    driven a_turn_with_its_arguments_the_other_way_round: "body c { start orientation = turn(«30deg», (0, 0, 1)); }" => "`turn` takes its axis first\nhelp: write `turn((0, 0, 1), 30deg)`";
    driven a_point_of_two_components: "body c { point P = «(1m, 0m)»; }" => "a vector in space has 3 components, found 2\nhelp: write the third, which is 0 in the plane of x and y";
    driven an_axis_of_two_components: "body c { axis u = «(0, 1)»; }" => "a vector in space has 3 components, found 2\nhelp: write the third, which is 0 in the plane of x and y";
    driven coordinates_without_parentheses_in_space: "body c { point P = «5mm», -6mm, 7mm; }" => "the coordinates of a point stand in parentheses\nhelp: write `(5mm, -6mm, 7mm)`";
    driven an_axis_that_is_a_number: "body c { } joint j = revolute(b.A, «3», c.position, (0, 0, 1));" => "`a` of `revolute` takes an axis, found a number\nhelp: write `(1, 0, 0)` for the direction of x";
    driven a_point_that_is_a_number: "body c { } joint j = spherical(«5m», c.position);" => "`P` of `spherical` takes a point, found a number\nhelp: write `(x, y, z)` for a place in ground, `body.P` for a point of a body";
    driven a_start_that_is_a_number: "body c { start position = «5m»; }" => "expected a vector or a point, found a number\nhelp: write all components, `(x, y, z)`";
    driven the_sine_of_an_axis: "output o = sin(«b.z»);" => "expected a number, found an axis\nhelp: its components are `.x`, `.y` and `.z`, its length is `norm(…)`";
    driven a_body_where_a_number_is_wanted: "output o = 2 * «b»;" => "expected a number or a vector, found a body\nhelp: its coordinates are `.x`, `.y` and `.z`, its place is `.position`; angles are those of joints, `joint.angle`";
    driven a_zero_direction_of_two_components: "body c { axis u = (0, 0, 1) from «(1, 0)»; }" => "a vector in space has 3 components, found 2\nhelp: write the third, which is 0 in the plane of x and y";
    driven a_redundant_joint_that_nothing_can_close: "body c { axis z = (0, 0, 1); axis w = (0, 0.02, 1); } joint q = revolute(b.A, b.z, c.position, c.z); drive n = drive_rotation(q, 60rpm * t); redundant joint «r» = parallel_axes(c.w, b.z);" => "`r` contradicts the other joints: with all of them closed it is 1.15° off\nhelp: a redundant joint must fit as well: change a measure, or take it away";
    driven a_start_of_two_components: "body c { start position = «(0m, 1m)»; }" => "a vector in space has 3 components, found 2\nhelp: write the third, which is 0 in the plane of x and y";
    driven angles_from_along_the_axis: "body c { axis u = (0, 0, 1) from «(0, 0, 2)»; }" => "angles about `u` are counted from a direction across it, and this one has no part across it\nhelp: write a direction across it, such as `from (1, 0, 0)`";
    driven angles_from_nowhere: "body c { axis u = (0, 0, 1) from «(0, 0, 0)»; }" => "angles about `u` are counted from a direction across it, and this one has no part across it\nhelp: write a direction across it, such as `from (1, 0, 0)`";
    driven an_axis_in_space_without_direction: "body c { axis u = «(0, 0, 0)»; }" => "the axis `u` has no direction: all components are zero\nhelp: write `(1, 0, 0)` for the direction of x";
    hinge a_point_that_equals_a_number: "drive m = { «b.A == 1m»; }" => "cannot equate a point with a number\nhelp: write `.x`, `.y` or `.z` for one component, or `(x, y, z)` on the other side for all";
    driven a_vector_and_a_number_in_space: "output o = «b.A + 1m»;" => "cannot add or subtract a vector and a number\nhelp: write the number as a vector, `(x, y, z)`, or take a component, `.x`, `.y` or `.z`";
    hinge an_angle_of_a_ball_joint: "joint c = spherical(ground.position, b.position); drive m = drive_rotation(c.«angle», 60rpm * t);" => "a `spherical` joint has no `angle`\nnote: it has `P` and `Q`";
    hinge a_speed_of_a_hinge: "joint c = revolute(ground.position, ground.z, b.position, b.z); drive m = drive_rotation(c.angle, 60rpm * t); output w = c.«angular_velocity»;" => "a `revolute` joint has no `angular_velocity`\nhelp: write `rate(hinge.angle)`";
    plane three_components_in_the_plane: "body c { point P = «(1m, 0m, 0m)»; }" => "a vector in the plane has 2 components, found 3\nhelp: for a mechanism in space write `mechanism Name in space { … }`";
    plane a_zero_direction_in_the_plane: "body c { axis u = (1, 0) from «(0, 1)»; }" => "`from` is for mechanisms in space: write `mechanism Name in space { … }`, or leave it out in the plane";
    plane a_displacement_along_an_axis_in_the_plane: "output o = «along»(ground.u, b.A);" => "`along` is for mechanisms in space: write `mechanism Name in space { … }`, or in the plane `dot(u, v)` and `cross(u, v)`";
    plane a_joint_of_space_in_the_plane: "joint c = «spherical»(ground.position, b.A);" => "`spherical` is for mechanisms in space: write `mechanism Name in space { … }`, or in the plane `revolute(P, Q)`";
    plane a_drive_of_space_in_the_plane: "drive m = «drive_rotation»(a, 60rpm * t);" => "`drive_rotation` is for mechanisms in space: write `mechanism Name in space { … }`, or in the plane `drive_angle(body, law)`";
    four_bar four_parallel_hinges: "joint «b» = revolute(coupler.B, coupler.z, rocker.B, rocker.z);" => "3 of the 5 equations of `b` add nothing: they follow from `o`, `a` and `c` in every position tried\nhelp: in a loop a spherical and a cylindrical joint in place of two revolutes demand no more than is needed; or write `redundant joint` for `joint`: what is needed of it is solved, the rest is checked";
    four_bar parallel_hinges_that_do_not_meet: "redundant joint «b» = revolute(coupler.B, coupler.z, rocker.D, rocker.z);" => "`b` contradicts the other joints: with all of them closed it is 10 mm off\nnote: it joins `crank`, `coupler` and `rocker`\nhelp: a redundant joint must fit as well: change a measure, or take it away";
    four_bar hinges_without_axes: "joint b = «revolute»(coupler.B, rocker.B);" => "`revolute` takes axes beside points: `a` and `b` are missing\nhelp: write `revolute(coupler.B, coupler.z, rocker.B, rocker.z)`\nnote: `revolute(P: Point, a: Axis, Q: Point, b: Axis)`";
    four_bar hinges_without_points: "joint b = «revolute»(coupler.z, rocker.z);" => "`revolute` takes points beside axes: `P` and `Q` are missing\nhelp: write `revolute(coupler.position, coupler.z, rocker.position, rocker.z)`\nnote: `revolute(P: Point, a: Axis, Q: Point, b: Axis)`";
    four_bar a_plane_without_its_normal: "body plate { point P = (1m, 0m, 0m); } joint b = «planar»(plate.P, rocker.B);" => "`planar` takes axes beside points: `a` and `b` are missing\nhelp: write `planar(plate.P, plate.z, rocker.B, rocker.z)`, with `axis z = (0, 0, 1);` in `plate`\nnote: `planar(P: Point, a: Axis, Q: Point, b: Axis, offset: Length = …)`";
    four_bar a_line_without_its_direction: "joint b = «point_on_line»(coupler.B, rocker.B);" => "`point_on_line` takes the axis beside points: `a` is missing\nhelp: write `point_on_line(coupler.B, coupler.z, rocker.B)`\nnote: `point_on_line(P: Point, a: Axis, Q: Point)`";
    tilted four_parallel_hinges_but_for_one: "joint «b» = revolute(coupler.B, coupler.w, rocker.B, rocker.z);" => "the axes of `a` and `b` are 1.15° apart on `coupler`, those of `o` and `c` are parallel: such a loop of hinges locks\nhelp: parallel axes were probably meant: give `coupler` parallel axes for `a` and `b`";
    tilted a_redundant_hinge_askew: "redundant joint «b» = revolute(coupler.B, coupler.w, rocker.B, rocker.z);" => "the axes of `a` and `b` are 1.15° apart on `coupler`, those of `o` and `c` are parallel: such a loop of hinges locks\nhelp: parallel axes were probably meant: give `coupler` parallel axes for `a` and `b`";
    tilted a_hinge_askew_on_both_sides: "joint «b» = revolute(coupler.B, coupler.w, rocker.B, rocker.w);" => "the axis of `b` is 1.15° askew on `coupler` and `rocker`, those of `o`, `a` and `c` are parallel: such a loop of hinges locks\nhelp: parallel axes were probably meant: give `coupler` and `rocker` parallel axes for `b`";
    tilted a_redundant_hinge_askew_on_both_sides: "redundant joint «b» = revolute(coupler.B, coupler.w, rocker.B, rocker.w);" => "the axis of `b` is 1.15° askew on `coupler` and `rocker`, those of `o`, `a` and `c` are parallel: such a loop of hinges locks\nhelp: parallel axes were probably meant: give `coupler` and `rocker` parallel axes for `b`";
    sarrus six_hinges_of_sarrus: "joint «f» = revolute(outer.Q, outer.y, platform.Q, platform.y);" => "1 of the 5 equations of `f` adds nothing: it follows from `a`, `b`, `c`, `d` and `e` in every position tried\nhelp: in a loop a spherical and a cylindrical joint in place of two revolutes demand no more than is needed; or write `redundant joint` for `joint`: what is needed of it is solved, the rest is checked";
}

crate::refusals! {
    mechanism a_screw_without_a_lead: "mechanism Jack in space { ground { axis z = (0, 0, 1); } body nut { axis z = (0, 0, 1); } joint s = screw(ground.position, ground.z, nut.position, nut.z, «0mm»); drive d = drive_rotation(s, 1rad_s * t); }" => "a screw without a lead does not advance: write `revolute`, or the way of one turn";
    mechanism a_velocity_at_the_start: "mechanism Top in space { body top { start «omega» = 3rad_s; } }" => "a body does not start with `omega`: a velocity at the start is that of a freedom\nhelp: write `freedom name = hinge.angle from 0deg at 3rad_s;` with the angle at the start";
    mechanism an_elbow_up_or_down: "mechanism FourBar in space { ground { axis z = (0, 0, 1); point C = (400mm, 0mm, 0mm); } body crank { axis z = (0, 0, 1); point A = (100mm, 0mm, 0mm); } body «coupler» { axis z = (0, 0, 1); point B = (350mm, 0mm, 0mm); } body rocker { axis z = (0, 0, 1); point B = (300mm, 0mm, 0mm); } joint o = revolute(ground.position, ground.z, crank.position, crank.z); joint a = spherical(crank.A, coupler.position); joint b = cylindrical(coupler.B, coupler.z, rocker.B, rocker.z); joint c = revolute(ground.C, ground.z, rocker.position, rocker.z); drive input = drive_rotation(o, 60rpm * t); }" => "two assemblies are equally near: `b.angle` = 54.31° or -54.31°\nhelp: write `start orientation = turn((0, 0, 1), 54deg);` in `body coupler`";
    mechanism a_platform_above_or_below: "mechanism Tripod in space { ground { point A = (1m, 0m, 0m); point B = (-0.5m, 0.866m, 0m); point C = (-0.5m, -0.866m, 0m); } body «p» { point A = (0.5m, 0m, 0m); point B = (-0.25m, 0.433m, 0m); point C = (-0.25m, -0.433m, 0m); } drive a = drive_distance(ground.A, p.A, 1m); drive b = drive_distance(ground.B, p.B, 1m); drive c = drive_distance(ground.C, p.C, 1m); drive d = drive_distance(ground.A, p.B, 1.4m); drive e = drive_distance(ground.B, p.C, 1.4m); drive f = drive_distance(ground.C, p.A, 1.4m); }" => "two assemblies are equally near: `p.z` = 803.9 mm or -803.9 mm\nhelp: write `start z = 803.9mm;` in `body p`";
    mechanism no_space_and_no_plane: "mechanism S in «air» { body b { } }" => "expected `space` or `plane`, found `air`";
    mechanism a_hinge_without_motor: "mechanism «S» in space { ground { axis z = (0, 0, 1); } body b { axis z = (0, 0, 1); } joint a = revolute(ground.position, ground.z, b.position, b.z); }" => "`S` has mobility 1, but no drive\nnote: 6 freedoms of bodies and 5 equations of joints\nhelp: drive `a.angle`, such as `drive input = drive_rotation(a, 60rpm * t);`";
    constraint a_word_of_space_in_a_definition_of_the_plane: "constraint c(P: Point, a: Axis, Q: Point) { «along»(a, Q - P) == 0; }" => "`along` is for mechanisms in space: write `mechanism Name in space { … }`, or in the plane `dot(u, v)` and `cross(u, v)`";
    constraint a_word_of_the_plane_in_a_definition_of_space: "constraint c(P: Point, a: Axis, Q: Point) in space { dot(«perp»(a), Q - P) == 0; }" => "`perp` is for the plane; in space write `cross(axis, v)`";
    mechanism two_hinges_whose_axes_do_not_agree: "mechanism M in space { ground { axis z = (0, 0, 1); axis w = (0, 1, 1); point B = (1m, 0m, 1m); } body arm { axis z = (0, 0, 1); axis w = (0, 1, 1); axis x = (1, 0, 0); point B = (1m, 0m, 1m); } joint one = revolute(ground.position, ground.z, arm.position, arm.z); joint «two» = revolute(ground.B, ground.w, arm.B, arm.z); }" => "`two` contradicts `one`: their axes are 45° apart on `ground` and 0° on `arm`\nhelp: give both joints the same axes, or take one of them away";
    mechanism two_hinges_askew: "mechanism M in space { ground { axis z = (0, 0, 1); axis w = (0, 1, 1); point B = (1m, 0m, 1m); } body arm { axis z = (0, 0, 1); axis w = (0, 1, 1); axis x = (1, 0, 0); point B = (1m, 0m, 1m); } joint one = revolute(ground.position, ground.z, arm.position, arm.z); joint «two» = revolute(ground.B, ground.w, arm.B, arm.w); drive d = drive_rotation(one, 1rpm * t); }" => "`one` and `two` hold `ground` and `arm` together: nothing turns about two axes 45° apart\nhelp: take one of them away, or write `weld` for both";
    mechanism two_parallel_hinges: "mechanism M in space { ground { axis z = (0, 0, 1); axis w = (0, 1, 1); point B = (1m, 0m, 1m); } body arm { axis z = (0, 0, 1); axis w = (0, 1, 1); axis x = (1, 0, 0); point B = (1m, 0m, 1m); } joint one = revolute(ground.position, ground.z, arm.position, arm.z); joint «two» = revolute(ground.B, ground.z, arm.B, arm.z); drive d = drive_rotation(one, 1rpm * t); }" => "`two` demands in part what `one` says: its equations 3, 4 and 5 of 5 add nothing\nhelp: take one of them away, or demand less with it, or write `redundant joint` for `joint` to keep it as a check";
    mechanism an_angle_of_the_wrong_axis: "mechanism M in space { ground { axis y = (0, 1, 0); } body arm { axis y = (0, 1, 0); axis x = (1, 0, 0); axis w = (1, 2, 0); mass = 1kg; inertia = (1kgm2, 1kgm2, 1kgm2); } joint hinge = revolute(ground.position, ground.y, arm.position, arm.y); drive d = drive_rotation(hinge, 1rad_s * t); output «bad» = joint_angle(ground.y, arm.x); }" => "`bad` takes the angle of an axis of `arm` against one of `ground`, and joints keep them 90° apart\nhelp: take two axes of one direction, such as those of the joint between them";
    mechanism a_spring_on_the_wrong_axis: "mechanism M in space { ground { axis y = (0, 1, 0); } body arm { axis y = (0, 1, 0); axis x = (1, 0, 0); axis w = (1, 2, 0); mass = 1kg; inertia = (1kgm2, 1kgm2, 1kgm2); } joint hinge = revolute(ground.position, ground.y, arm.position, arm.y); force «coil» = torsion_spring(ground.y, arm.w, 5Nm_rad, 0deg); freedom q = hinge.angle; }" => "`coil` takes the angle of an axis of `arm` against one of `ground`, and joints keep them 26.57° apart\nhelp: take two axes of one direction, such as those of the joint between them";
    mechanism a_damper_on_the_wrong_axis: "mechanism M in space { ground { axis y = (0, 1, 0); } body arm { axis y = (0, 1, 0); axis x = (1, 0, 0); axis w = (1, 2, 0); mass = 1kg; inertia = (1kgm2, 1kgm2, 1kgm2); } joint hinge = revolute(ground.position, ground.y, arm.position, arm.y); force «friction» = torsion_damper(ground.y, arm.x, 1Nms); freedom q = hinge.angle; }" => "`friction` takes the angle of an axis of `arm` against one of `ground`, and joints keep them 90° apart\nhelp: take two axes of one direction, such as those of the joint between them";
    mechanism a_rate_about_the_wrong_axis: "mechanism M in space { ground { axis y = (0, 1, 0); } body arm { axis y = (0, 1, 0); axis x = (1, 0, 0); axis w = (1, 2, 0); mass = 1kg; inertia = (1kgm2, 1kgm2, 1kgm2); } joint hinge = revolute(ground.position, ground.y, arm.position, arm.y); drive d = drive_rotation(hinge, 1rad_s * t); output «spin» = rate(joint_angle(ground.y, arm.x)); }" => "`spin` takes the angle of an axis of `arm` against one of `ground`, and joints keep them 90° apart\nhelp: take two axes of one direction, such as those of the joint between them";
    mechanism a_damper_on_the_wrong_axis_behind_a_spring: "mechanism M in space { ground { axis y = (0, 1, 0); } body arm { axis y = (0, 1, 0); axis x = (1, 0, 0); axis w = (1, 2, 0); mass = 1kg; inertia = (1kgm2, 1kgm2, 1kgm2); } joint hinge = revolute(ground.position, ground.y, arm.position, arm.y); force link = spring(ground.position, arm.position, 1N_m); force «friction» = torsion_damper(ground.y, arm.x, 1Nms); freedom q = hinge.angle; }" => "`friction` takes the angle of an axis of `arm` against one of `ground`, and joints keep them 90° apart\nhelp: take two axes of one direction, such as those of the joint between them";
    mechanism a_name_for_an_angle_of_the_wrong_axis: "mechanism M in space { ground { axis y = (0, 1, 0); } body arm { axis y = (0, 1, 0); axis x = (1, 0, 0); axis w = (1, 2, 0); mass = 1kg; inertia = (1kgm2, 1kgm2, 1kgm2); } joint hinge = revolute(ground.position, ground.y, arm.position, arm.y); let «turn_of_x» = joint_angle(ground.y, arm.x); drive d = drive_rotation(hinge, 1rad_s * t); output out = turn_of_x; }" => "`turn_of_x` takes the angle of an axis of `arm` against one of `ground`, and joints keep them 90° apart\nhelp: take two axes of one direction, such as those of the joint between them";
    mechanism an_axis_that_a_hinge_keeps_from_perpendicular: "mechanism M in space { ground { axis z = (0, 0, 1); } body a { axis z = (0, 0, 1); axis u = (sin(30deg), 0, cos(30deg)); } joint o = revolute(ground.position, ground.z, a.position, a.z); joint «tie» = perpendicular_axes(a.u, ground.z); }" => "`tie` contradicts `o`: where `o` holds, it is off by 60°\nhelp: take one of them away";
    mechanism an_axis_that_a_guide_keeps_elsewhere: "mechanism M in space { ground { axis z = (0, 0, 1); axis w = (0, 1, 1); } body arm { axis z = (0, 0, 1); axis w = (1, 0, 0); } body leg { axis z = (0, 0, 1); axis w = (1, 0, 0); } joint one = translational(ground.position, ground.z, arm.position, arm.z); joint «two» = translational(arm.position, arm.w, leg.position, leg.w); joint three = parallel_axes(ground.w, leg.z); }" => "`two` contradicts `one` and `three`: where `one` and `three` hold, it is off by 45°\nhelp: take one of them away";
    mechanism cross_product_of_axes: "mechanism M in space { ground { axis z = (0, 0, 1); } body arm { axis z = (0, 0, 1); point P = (1m, 0m, 0m); } joint c = { «cross(ground.z, arm.z) == 0»; arm.position == ground.position; } drive d = drive_x(arm.P, 1m * sin(1rad_s * t)); }" => "a cross product in space has three rows, and where it vanishes two of them say it all\nhelp: write `across(ground.z, arm.z) == 0;`, which has two rows, or `joint c = parallel_axes(ground.z, arm.z);`";
    mechanism cross_product_with_a_direction: "mechanism M in space { ground { axis z = (0, 0, 1); } body arm { axis z = (0, 0, 1); point P = (1m, 0m, 0m); } joint c = { «cross(arm.P - ground.position, (1, 0, 0)) == (0m, 0m, 0m)»; } drive d = drive_x(arm.P, 1m * sin(1rad_s * t)); }" => "a cross product in space has three rows, and where it vanishes two of them say it all\nhelp: write `across((1, 0, 0), arm.P - ground.position) == 0;`, which has two rows";
    mechanism cross_product_of_vectors: "mechanism M in space { ground { axis z = (0, 0, 1); } body arm { axis z = (0, 0, 1); point P = (1m, 0m, 0m); } joint c = { let u = arm.P - arm.position; «cross(u, arm.P) == 0»; } drive d = drive_x(arm.P, 1m * sin(1rad_s * t)); }" => "a cross product in space has three rows, and where it vanishes two of them say it all\nhelp: write `across(axis, v) == 0;` with an axis of a body, or `dot` with two axes across it";
    mechanism space_that_is_not_declared: "mechanism «M» { ground { axis z = (0, 0, 1); } body arm { axis z = (0, 0, 1); } joint one = revolute(ground.position, ground.z, arm.position, arm.z); drive d = drive_rotation(one, 60rpm * t); }" => "`M` has words and vectors of space, and a mechanism is in the plane where it does not say `in space`\nhelp: write `mechanism M in space { … }`";
    mechanism a_drive_of_a_cross: "mechanism M in space { body arm { axis y = (0, 1, 0); } joint hook = universal(ground.position, (1, 0, 0), arm.position, arm.y); drive d = drive_rotation(«hook», 60rpm * t); }" => "`drive_rotation` takes one angle, and a `universal` joint has two\nhelp: write `angle_a` or `angle_b` after its name";
    mechanism a_spring_between_the_arms_of_a_cross: "mechanism M in space { body arm { axis y = (0, 1, 0); mass = 1kg; inertia = (1kgm2, 1kgm2, 1kgm2); } joint hook = universal(ground.position, (1, 0, 0), arm.position, arm.y); freedom a = hook.angle_a; freedom b = hook.angle_b; force «f» = torsion_spring(hook.a, hook.b, 3Nm_rad, 0deg); }" => "`f` takes the angle of an axis of `arm` against one of `ground`, and joints keep them 90° apart\nhelp: take two axes of one direction, such as those of the joint between them";
    mechanism a_drive_of_a_ball: "mechanism M in space { body arm { axis z = (0, 0, 1); } joint ball = spherical(ground.position, arm.position); drive d = drive_rotation(«ball», 60rpm * t); }" => "`drive_rotation` takes an angle, and a `spherical` joint has none\nhelp: take a `revolute`, `cylindrical` or `screw` joint, or `joint_angle(a, b)` of two axes for the joint";
    mechanism a_rotation_of_a_guide: "mechanism M in space { body arm { axis z = (0, 0, 1); } joint rail = translational(ground.position, (0, 0, 1), arm.position, arm.z); drive d = drive_rotation(«rail», 60rpm * t); }" => "`drive_rotation` takes an angle, and a `translational` joint has none\nhelp: write `drive_translation(rail, …)`, or take a `revolute`, `cylindrical` or `screw` joint";
    mechanism a_rotation_of_a_body: "mechanism M in space { body arm { axis z = (0, 0, 1); } joint hinge = revolute(ground.position, (0, 0, 1), arm.position, arm.z); drive d = drive_rotation(«arm», 60rpm * t); }" => "`angle` of `drive_rotation` takes a number (Angle), found a body\nhelp: write `hinge`";
    mechanism two_screws_on_a_slide: "mechanism Jack in space { ground { axis z = (0, 0, 1); } body spindle { axis z = (0, 0, 1); } body nut { axis z = (0, 0, 1); } joint outer = screw(ground.position, ground.z, spindle.position, spindle.z, 5mm); joint «inner» = screw(spindle.position, spindle.z, nut.position, nut.z, -4mm); joint guide = translational(ground.position, ground.z, nut.position, nut.z); drive motor = drive_rotation(outer, 1turn * t / 1s); }" => "4 of the 5 equations of `inner` add nothing: they follow from `outer` and `guide` in every position tried\nhelp: where other joints hold its bodies in line, the one equation of a screw is `rack_pinion(angle, P, a, Q, radius)`; or write `redundant joint` for `joint`: what is needed of it is solved, the rest is checked";
    mechanism an_orientation_driven_in_the_plane: "mechanism M { body a { } joint h = revolute(ground.position, a.position); drive d = «drive_orientation»(a, 0deg, 0deg, 1rad_s * t); }" => "`drive_orientation` is for mechanisms in space: write `mechanism Name in space { … }`, or in the plane `drive_angle(body, law)`";
    mechanism pulley_without_radius_in_space: "mechanism Hinge in space { ground { axis z = (0, 0, 1); } body b { axis z = (0, 0, 1); point A = (1m, 0m, 0m); } joint a = revolute(ground.position, ground.z, b.position, b.z); body c { axis z = (0, 0, 1); } joint d = revolute(ground.position, ground.z, c.position, c.z); joint strap = belt(a, d, «0mm», 10mm); }" => "a pulley without radius turns nothing: the radius of a belt's pulley may not be zero";
    mechanism a_belt_of_bodies_in_space: "mechanism Hinge in space { ground { axis z = (0, 0, 1); } body b { axis z = (0, 0, 1); point A = (1m, 0m, 0m); } joint a = revolute(ground.position, ground.z, b.position, b.z); body c { axis z = (0, 0, 1); } joint d = revolute(ground.position, ground.z, c.position, c.z); joint strap = belt(«b», d, 20mm, 10mm); }" => "`one` of `belt` takes a number (Angle), found a body\nhelp: write `a`";
    mechanism a_coupling_of_two_bodies: "mechanism Hinge in space { ground { axis z = (0, 0, 1); } body b { axis z = (0, 0, 1); point A = (1m, 0m, 0m); } joint a = revolute(ground.position, ground.z, b.position, b.z); body c { axis x = (1, 0, 0); } joint d = constant_velocity(«b.A», c.x, c.position, c.x); }" => "the first point and the first shaft of a constant-velocity joint belong to one body\nhelp: take a point of `c`, or an axis of `b`";
    mechanism a_coupling_of_one_body: "mechanism Hinge in space { ground { axis z = (0, 0, 1); } body b { axis z = (0, 0, 1); point A = (1m, 0m, 0m); } joint a = revolute(ground.position, ground.z, b.position, b.z); joint d = constant_velocity(b.A, b.z, «b.position», b.z); }" => "the two points of a constant-velocity joint lie on the same body\nhelp: take a point of another body";
    mechanism a_gas_spring_without_gas: "mechanism Hinge in space { ground { axis z = (0, 0, 1); } body b { axis z = (0, 0, 1); point A = (1m, 0m, 0m); } joint a = revolute(ground.position, ground.z, b.position, b.z); drive m = drive_rotation(a, 60rpm * t); force f = gas_spring((2m, 0m, 0m), b.A, 200N, 300mm, «0mm»); }" => "a gas spring without a column of gas has no force";
    mechanism a_chain_of_hooke_joints: "mechanism Shafts in space { ground { axis x = (1, 0, 0); point end = (400mm, 0mm, 0mm); } body input { axis x = (1, 0, 0); axis arm = (0, 0, 1); } body middle { axis arm = (0, 1, 0); point end = (400mm, 0mm, 0mm); } body output { axis x = (1, 0, 0); axis arm = (0, 0, 1); } joint bearing = revolute(ground.position, ground.x, input.position, input.x); joint near = universal(input.position, input.arm, middle.position, middle.arm); joint far = universal(middle.end, middle.arm, output.position, output.arm); joint «end» = revolute(ground.end, ground.x, output.position, output.x); drive motor = drive_rotation(bearing, 60rpm * t); }" => "1 of the 5 equations of `end` adds nothing: it follows from `bearing`, `near` and `far` in every position tried\nhelp: a cylindrical joint in its place demands no more than is needed; or write `redundant joint` for `joint`: what is needed of it is solved, the rest is checked";
    mechanism a_bearing_whose_place_is_held: "mechanism Shafts in space { ground { axis x = (1, 0, 0); point end = (400mm, 0mm, 0mm); } body input { axis x = (1, 0, 0); axis arm = (0, 0, 1); point end = (400mm, 0mm, 0mm); } body output { axis x = (1, 0, 0); axis arm = (0, 1, 0); } joint bearing = revolute(ground.position, ground.x, input.position, input.x); joint hooke = universal(input.end, input.arm, output.position, output.arm); joint «end» = revolute(ground.end, ground.x, output.position, output.x); drive motor = drive_rotation(bearing, 60rpm * t); }" => "3 of the 5 equations of `end` add nothing: they follow from `bearing` and `hooke` in every position tried\nhelp: where other joints hold the place of a bearing, `parallel_axes(a, b)` holds its direction alone; or write `redundant joint` for `joint`: what is needed of it is solved, the rest is checked";
    mechanism coordinate_for_an_axis: "mechanism M in space { ground { axis z = (0, 0, 1); } body one { } joint h = revolute(ground.position, ground.z, one.position, «one.z»); drive d = drive_rotation(h, 1rad_s * t); }" => "`b` of `revolute` takes an axis, and `one.z` is a coordinate\nhelp: declare `axis z = (0, 0, 1);` in `one`: then `one.z` is this axis";
    mechanism direction_of_ground_for_an_axis_of_a_body: "mechanism M in space { body one { } joint h = revolute(ground.position, (0, 0, 1), one.position, «(0, 0, 1)»); drive d = drive_rotation(h, 1rad_s * t); }" => "the second point and the second axis of a revolute joint belong to one body\nhelp: declare an axis in `one`, such as `axis z = (0, 0, 1);`, and write `one.z`";
}

crate::refusals! {
    mechanism a_start_of_a_joint_in_the_plane: "mechanism M { body b {} joint h = revolute(ground.position, b.position); start «b.angle» = 30deg; drive d = drive_angle(b, 1rad_s * t); }" => "a start in the plane is that of a body\nhelp: write `start angle = …;` in `body b { … }`";
    mechanism a_start_of_a_joint_by_its_name_in_the_plane: "mechanism M { body lever {} joint h = revolute(ground.position, lever.position); start «h.angle» = 30deg; drive d = drive_angle(lever, 1rad_s * t); }" => "a start in the plane is that of a body\nhelp: write `start angle = …;` in `body lever { … }`";
    mechanism an_orientation_by_three_angles: "mechanism M in space { body c { start orientation = «(10deg, 20deg, 30deg)»; } }" => "an orientation is a product of turns, found three angles\nhelp: write `turn((1, 0, 0), 10deg) * turn((0, 1, 0), 20deg) * turn((0, 0, 1), 30deg)`, where each turn is about an axis that the turns before it have turned";
    mechanism an_axis_behind_the_point_of_another_body: "mechanism M in space { ground { axis u = (1, 0, 0); } body crank { axis v = (1, 0, 0); } joint o = «revolute»(ground.position, crank.position, ground.u); drive d = drive_rotation(o, 60rpm * t); }" => "`revolute` takes the axis beside points: `a` is missing\nhelp: write `revolute(ground.position, ground.u, crank.position, crank.v)`\nnote: `revolute(P: Point, a: Axis, Q: Point, b: Axis)`";
    mechanism a_turn_about_a_letter: "mechanism M in space { body c { start orientation = turn(«z», 30deg); } }" => "nothing is called `z` here\nhelp: write `body.z` for a coordinate, `(0, 0, 1)` for the direction of z";
    mechanism cylinder_between_two_balls: "mechanism M in space { ground { axis y = (0, -1, 0); point C = (0mm, 0mm, -300mm); } body boom { axis y = (0, -1, 0); point L = (300mm, 0mm, 0mm); } body «tube» { axis z = (0, 0, 1); } body rod { axis z = (0, 0, 1); } joint hinge = revolute(ground.position, ground.y, boom.position, boom.y); joint foot = spherical(ground.C, tube.position); joint slide = translational(tube.position, tube.z, rod.position, rod.z); joint head = spherical(rod.position, boom.L); drive cylinder = drive_translation(slide, 430mm + 10mm * sin(1rad_s * t)); }" => "`tube` and `rod` can turn about the line from `foot` to `head`: each holds them by one point, and nothing else does\nhelp: make one of the joints `universal`, or write `distance(…)` of the two points instead of the bodies, for a length that is driven `drive_distance(…)`";
    mechanism ball_with_a_mass: "mechanism «M» in space { body b { mass = 1kg; inertia = (1kgm2, 1kgm2, 1kgm2); } joint s = spherical(ground.position, b.position); }" => "`M` has mobility 3, but no drive\nnote: 6 freedoms of bodies and 3 equations of joints\nnote: `b` is joined to one neighbour only\nhelp: add 3 drives or joints, for `b.orientation`\nhelp: what follows from forces is a freedom, such as `freedom name = b.angular_velocity;`";
    mechanism motor_of_a_joint: "mechanism M in space { ground { axis z = (0, 0, 1); } body b { axis z = (0, 0, 1); mass = 1kg; inertia = (1kgm2, 1kgm2, 1kgm2); } joint o = revolute(ground.position, ground.z, b.position, b.z); force f = «motor»(o, 3Nm); freedom s = o.angle; }" => "`motor` takes an axis and a body in the place of a joint\nhelp: write `motor(o.a, b, 3Nm)`\nnote: `motor(a: Axis, b: Body, torque: Torque)`";
    mechanism misspelled_function_of_the_plane: "mechanism M in space { body a { point P = (1m, 0m, 0m); } output q = «prep»(a.P); }" => "no function is called `prep`\nhelp: `perp` is for the plane; in space write `cross(axis, v)`";
    mechanism misspelled_function_of_space: "mechanism M { body a { axis u = (1, 0); } output q = «joint_angel»(a.u, a.u); }" => "no function is called `joint_angel`\nhelp: `joint_angle` is for mechanisms in space: write `mechanism Name in space { … }`, or in the plane a difference of angles, `b.angle - a.angle`";
}
