//! Joints that say nothing, or what only a drive may say.

crate::refusals! {
    item time_in_a_joint: "joint a = absolute_angle(crank, speed * «t»);" => "a joint does not change with time, `t` is for drives\nhelp: write `drive a = …;` for `joint a = …;`";
    item time_behind_a_let: "let angle = speed * t; joint a = absolute_angle(crank, «angle»);" => "a joint does not change with time, `t` is for drives\nhelp: write `drive a = …;` for `joint a = …;`";
    item time_in_an_equation: "joint a = { crank.angle == speed * «t»; }" => "a joint does not change with time, `t` is for drives\nhelp: write `drive a = …;` for `joint a = …;`";
    item time_behind_a_let_in_an_equation: "let angle = speed * t; joint a = { «crank.angle == angle»; }" => "a joint does not change with time, `t` is for drives\nhelp: write `drive a = …;` for `joint a = …;`";
    item equation_of_nothing: "joint a = { «length == 2 * length»; }" => "the equation of `a` does not depend on the position of any body";
    item second_equation_of_nothing: "joint a = { crank.x == 0; «length == 1m»; }" => "equation 2 of 2 of `a` does not depend on the position of any body";
    item difference_of_the_same: "joint a = { «crank.x - crank.x == 0»; }" => "the equation of `a` does not depend on the position of any body";
    item joint_between_points_of_ground: "joint a = «point_on_line»(ground.C, ground.u, ground.O);" => "`a` joins ground to ground, and ground does not move\nhelp: give `point_on_line` at least one body, or a point or an axis of one";
    item no_equations: "joint «a» = {}" => "`a` has no equations\nhelp: write `lhs == rhs;`";
    item revolute_on_one_body: "joint a = revolute(crank.O, «crank.A»);" => "the two points of a revolute joint lie on the same body\nhelp: take a point of another body";
    item distance_on_one_body: "joint a = distance(crank.O, «crank.A», 100mm);" => "the two points of a distance constraint lie on the same body\nhelp: take a point of another body";
    item weld_of_one_body: "joint a = weld(crank.O, «crank.A»);" => "the two points of a weld lie on the same body\nhelp: take a point of another body";
    item line_on_two_bodies: "joint a = point_on_line(crank.A, «(1, 0)», ram.B);" => "the axis and the first point of a line do not lie on the same body\nhelp: take an axis of `crank`, such as `crank.v`";
    item line_on_a_body_without_an_axis: "joint a = point_on_line(ram.B, «ground.u», crank.A);" => "the axis and the first point of a line do not lie on the same body\nhelp: give `ram` an `axis`, and take it here";
    item line_at_a_distance_on_two_bodies: "joint a = revolute_translational(ground.O, «crank.v», ram.B, 1mm);" => "the axis and the first point of a line do not lie on the same body\nhelp: take an axis of `ground`, such as `ground.u`";
    item slide_on_two_bodies: "joint a = translational(«(1, 0)», crank.A, ram.B);" => "the axis and the first point of a translational joint do not lie on the same body\nhelp: take an axis of `crank`, such as `crank.v`";
    item face_and_normal_on_two_bodies: "joint a = cam_flat(crank.O, ram.B, «(0, 1)», lift);" => "the normal and the point of the face do not lie on the same follower\nhelp: give `ram` an `axis`, and take it here";
    item centre_on_a_body: "joint a = absolute_distance(ram.B, «crank.A», 100mm);" => "the centre of an absolute distance does not lie on ground: use `distance` between two bodies";
    item differential_of_one_shaft: "joint a = differential(crank, «crank», ram);" => "the two shafts of a differential are the same body";
    item gear_with_itself: "joint a = gear_pair(crank, «crank», 1, 2);" => "a gear cannot mesh with itself";
    mechanism start_of_ground: "mechanism Crank { ground { start «angle» = 0; } body crank {} }" => "ground does not move: it has no start values\nhelp: a frame that stands elsewhere is a body with a `weld`";
    mechanism named_as_the_number_type: "mechanism «T» { body crank {} }" => "`T` is the number type of generated code\nhelp: choose another name for the mechanism";
    mechanism no_bodies: "mechanism «Crank» { param length: Length = 1m; }" => "`Crank` has no bodies\nhelp: declare one with `body name { … }`";
    mechanism drive_is_missing: "mechanism «Crank» { body crank {} joint o = revolute((0mm, 0mm), crank.position); }" => "`Crank` has mobility 1, but no drive\nnote: 3 coordinates and 2 equations of joints\nhelp: drive `crank.angle`, such as `drive input = drive_angle(crank, 60rpm * t);`";
    mechanism nothing_holds: "mechanism Crank { body crank {} body «rod» {} joint o = revolute((0mm, 0mm), crank.position); }" => "nothing holds `rod`: it is in no equation\nhelp: join it to ground or to another body, such as `joint name = revolute(crank.position, rod.position);`, or take it away";
    mechanism drive_too_many: "mechanism Crank { body crank {} joint o = revolute((0mm, 0mm), crank.position); drive a = drive_angle(crank, t * 1rpm); drive «b» = drive_angle(crank, t * 2rpm); }" => "two drives on one freedom: `a` and `b`\nnote: both determine `crank.angle`\nhelp: take one of the drives away";
    mechanism two_drives_on_one_freedom: "mechanism Crank { body crank { point A = (1m, 0m); } body wheel {} joint o = revolute((0mm, 0mm), crank.position); joint a = revolute(crank.A, wheel.position); drive i = drive_angle(crank, t * 1rpm); drive «j» = drive_angle(crank, t * 2rpm); }" => "two drives on one freedom: `i` and `j`\nnote: both determine `crank.angle`\nhelp: `wheel.angle` is left free: drive that instead";
    mechanism an_identity: "mechanism N { body crank { point A = (1m, 0m); point B = (1m, 1m); } joint o = revolute(ground.position, crank.position); joint «d» = { sin(crank.angle) * sin(crank.angle) + cos(crank.angle) * cos(crank.angle) == 1; } drive i = drive_angle(crank, 1rad_s * t); }" => "the equation of `d` does not depend on the position of any body";
    mechanism an_identity_that_does_not_hold: "mechanism N { body crank { point A = (1m, 0m); point B = (1m, 1m); } joint o = revolute(ground.position, crank.position); joint «d» = { sin(crank.angle) * sin(crank.angle) + cos(crank.angle) * cos(crank.angle) == 2; } drive i = drive_angle(crank, 1rad_s * t); }" => "the equation of `d` does not depend on the position of any body";
    mechanism a_distance_within_one_body: "mechanism N { body crank { point A = (1m, 0m); point B = (1m, 1m); } joint o = revolute(ground.position, crank.position); joint «d» = { dot(crank.A - crank.B, crank.A - crank.B) == 1m * 1m; } drive i = drive_angle(crank, 1rad_s * t); }" => "the equation of `d` does not depend on the position of any body";
    mechanism an_identity_instead_of_a_drive: "mechanism N { body crank { point A = (1m, 0m); point B = (1m, 1m); } joint o = revolute(ground.position, crank.position); joint «d» = { crank.angle + 1rad == 1rad; dot(crank.A - crank.B, crank.A - crank.B) == 1m * 1m; } }" => "equation 2 of 2 of `d` does not depend on the position of any body";
}
