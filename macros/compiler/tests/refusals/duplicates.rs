//! Names already taken.

crate::refusals! {
    item parameter_twice: "param «length»: Length = 1m;" => "the name `length` is taken: a parameter has it\nhelp: choose another name";
    item body_twice: "body «crank» {}" => "the name `crank` is taken: a body has it\nhelp: choose another name";
    item body_with_a_parameters_name: "body «speed» {}" => "the name `speed` is taken: a parameter has it\nhelp: choose another name";
    item joint_twice: "joint «hinge» = revolute(ground.C, crank.A);" => "the name `hinge` is taken: a joint has it\nhelp: choose another name";
    item drive_with_a_joints_name: "drive «slide» = drive_x(crank.A, 1mm);" => "the name `slide` is taken: a joint has it\nhelp: choose another name";
    item let_twice: "let «double» = 2;" => "the name `double` is taken: a `let` has it\nhelp: choose another name";
    item function_twice: "function «lift»(a: Angle) -> Length = 1mm;" => "the name `lift` is taken: a function has it\nhelp: choose another name";
    item output_twice: "output «tip» = crank.O;" => "the name `tip` is taken: another output has it\nhelp: choose another name";
    item point_twice: "body b { point P = (0mm, 0mm); point «P» = (1mm, 0mm); }" => "`b` has another `P` already\nhelp: choose another name";
    item axis_with_a_points_name: "body b { point P = (0mm, 0mm); axis «P» = (1, 0); }" => "`b` has another `P` already\nhelp: choose another name";
    item start_twice: "body b { start angle = 0; start «angle» = 1; }" => "the start of `b` gives `angle` twice\nhelp: take one away";
    item start_by_position_and_x: "body b { start position = (0mm, 0mm); start «x» = 1mm; }" => "the start of `b` gives `x` twice\nhelp: take one away; `position` is both `x` and `y`";
    mechanism range_twice: "mechanism M { range t in 0s..1s; «range» t in 0s..2s; body b { } joint j = revolute(ground.position, b.position); drive d = drive_angle(b, 1rad_s * t); }" => "there is one range of time only\nhelp: take one of them away";
    item ground_twice: "«ground» { point D = (0mm, 0mm); }" => "there is one ground only\nhelp: put all its points and axes into one `ground { … }`";
    item uses_of_a_parameter_and_body_are_not_refused_as_well: "body «speed» { point P = (0mm, 0mm); } output b = speed.P; output c = speed.Q.x;" => "the name `speed` is taken: a parameter has it\nhelp: choose another name";
    item uses_of_an_array_and_body_are_not_refused_as_well: "body b { point P = (0mm, 0mm); } body «b»[0] { point Q = (0mm, 0mm); } output o = b[0].Q; output p = b.Q;" => "the name `b[0]` is taken: a body has it\nhelp: choose another name";
    item uses_of_a_doubled_point_are_not_refused_as_well: "body b { point P = (0mm, 0mm); axis «P» = (1, 0); } joint j = translational(b.P, b.position, crank.A);" => "`b` has another `P` already\nhelp: choose another name";
}
