//! Undeclared names.

crate::refusals! {
    item name_is_mistyped: "output b = «lenght»;" => "nothing is called `lenght` here\nhelp: did you mean `length`?";
    item name_is_unknown: "output b = «wheel»;" => "nothing is called `wheel` here";
    item unit_by_itself: "drive b = drive_angle(crank, 2 * 1rad/«ms» * t);" => "nothing is called `ms` here\nhelp: a unit belongs to a number, as in `1ms`; that of a rate is one word, as in `1rad_s`";
    item body_is_mistyped: "joint a = revolute(«crnk».A, ground.C);" => "nothing is called `crnk` here\nhelp: did you mean `crank`?";
    item point_is_mistyped: "body c { point Pin = (0mm, 0mm); } output b = c.«Pim»;" => "`c` has no `Pim`\nhelp: did you mean `Pin`?";
    item point_is_unknown: "output b = crank.«Z»;" => "`crank` has no `Z`\nnote: it has `O`, `A`, `v`, `position`, `angle`, `x`, `y` and `angular_velocity`";
    item point_without_its_body: "joint a = revolute(ground.C, «A»);" => "nothing is called `A` here\nhelp: did you mean `crank.A`?";
    item angle_is_mistyped: "output b = crank.«angel»;" => "`crank` has no `angel`\nhelp: did you mean `angle`?";
    item component_of_a_point: "output b = crank.A.«z»;" => "a point has no `z`\nnote: it has `x`, `y` and `body`";
    item component_of_a_number: "output b = length.«x»;" => "a number has no `x`";
    item argument_of_a_joint: "drive b = drive_x(slide.«R», 1mm * t / 1s);" => "a `translational` joint has no `R`\nnote: it has `u`, `P`, `Q` and `c`";
    item constraint_is_mistyped: "joint a = «revolut»(ground.C, crank.A);" => "no constraint is called `revolut`\nhelp: did you mean `revolute`?";
    item constraint_is_unknown: "joint a = «homokinetic»(ground.C, crank.A);" => "no constraint is called `homokinetic`\nnote: there are `revolute`, `translational`, `weld`, `distance`, `point_on_line`, `revolute_translational`, `relative_angle`, `parallel`, `absolute_x`, `absolute_y`, `absolute_angle`, `absolute_distance` and 14 more\nhelp: bring in your own with `use path::to::homokinetic;`";
    item function_is_mistyped: "output b = «sine»(crank.angle);" => "no function is called `sine`\nhelp: did you mean `sin`?";
    item function_is_unknown: "output b = «sinc»(crank.angle);" => "no function is called `sinc`\nhelp: did you mean `sin`?";
    item own_function_is_mistyped: "output b = «lif»(crank.angle);" => "no function is called `lif`\nhelp: did you mean `lift`?";
    item constraint_as_a_function: "output b = «revolute»(ground.O, crank.O);" => "`revolute` is a constraint, not a function\nhelp: write `joint name = revolute(…);`";
    item number_as_a_function: "output b = «length»(2);" => "expected a function, found a number\nhelp: a product is written with `*`";
    item unit_is_mistyped: "param a: Length = «100furlong»;" => "no unit is called `furlong`\nnote: there are `m`, `cm`, `mm`, `um`, `km`, `in`, `ft`, `rad`, `mrad`, `deg`, `turn`, `s`, `ms`, `us`, `min`, `h`, `kg`, `g`, `rpm`, `rad_s`, `deg_s`, `rad_s2`, `deg_s2`, `m_s`, `mm_s`, `m_s2`, `mm_s2`, `mm2`, `m2`, `N`, `kN`, `Nm`, `Nmm`, `kgm2`, `N_m`, `N_mm`, `kN_m`, `Ns_m`, `Nm_rad`, `Nms`, `Nms_rad`, `W`, `kW`, `Pa`, `kPa`, `bar` and `MPa`";
    item unit_is_near: "param a: Length = «100mn»;" => "no unit is called `mn`\nhelp: did you mean `100mm`?";
    item unit_is_written_out: "param a: Length = «100milimeter»;" => "no unit is called `milimeter`\nhelp: did you mean `100mm`?";
    item unit_is_in_the_plural: "param a: Angle = «5degrees»;" => "no unit is called `degrees`\nhelp: did you mean `5deg`?";
    item constraint_by_another_name: "joint a = «pin»(ground.C, crank.A);" => "no constraint is called `pin`\nhelp: did you mean `revolute`?";
    item slide_by_another_name: "joint a = «prismatic»(ground.C, crank.A);" => "no constraint is called `prismatic`\nhelp: did you mean `translational`?";
    item power_as_a_function: "output b = «powi»(length, 2);" => "no function is called `powi`\nhelp: a power is written `a^b`";
    item hertz_is_ambiguous: "param a: AngularVelocity = «2Hz»;" => "no unit is called `Hz`\nhelp: for a speed of rotation write `rpm` or `rad_s`, for a frequency `1/0.5s`";
    item dimension_is_mistyped: "param a: «Lenght» = 100mm;" => "no dimension is called `Lenght`\nhelp: did you mean `Length`?";
    item dimension_is_unknown: "param a: «Voltage» = 100;" => "no dimension is called `Voltage`\nnote: there are `Number`, `Length`, `Angle`, `Time`, `Mass`, `Area`, `Velocity`, `Acceleration`, `AngularVelocity`, `AngularAcceleration`, `Frequency`, `Force`, `Torque`, `Inertia`, `Stiffness`, `Damping`, `Pressure` and `Power`";
    item start_is_unknown: "body b { start «speed» = 1; }" => "a body does not start with `speed`\nnote: it starts with `x`, `y`, `position` or `angle`";
    item start_is_mistyped: "body b { start «angel» = 1; }" => "a body does not start with `angel`\nhelp: did you mean `angle`?\nnote: it starts with `x`, `y`, `position` or `angle`";
    item named_argument_is_mistyped: "joint a = gear_pair(crank, ram, 1, 2, «carier»: ground);" => "`gear_pair` has no parameter `carier`\nhelp: did you mean `carrier`?\nnote: `gear_pair(i: Body, j: Body, a: Quantity, b: Quantity, c: Quantity = …, carrier: Body = …)`";
    item let_depends_on_itself: "let a = 1 + b; let b = 2 * «a»;" => "`a` depends on itself, by way of `b`";
    item point_depends_on_itself: "body b { point «P» = (b.P.x, 0mm); }" => "`P` depends on itself";
    item joint_depends_on_itself: "drive a = drive_along(«a», 1mm);" => "`a` depends on itself";
    item function_calls_itself: "function f(x: Angle) -> Length = 2 * «f(x)»;" => "the function `f` calls itself\nnote: functions are written out where they are called; this would not end";
    item functions_call_each_other: "function f(x: Angle) -> Length = 2 * g(x); function g(x: Angle) -> Length = «f(x)»;" => "the function `f` calls itself\nnote: functions are written out where they are called; this would not end";
    item name_with_a_meaning: "param «pi»: Length = 1m;" => "`pi` has a meaning of its own in expressions\nhelp: choose another name";
    item name_of_a_builtin: "body «dot» {}" => "`dot` has a meaning of its own in expressions\nhelp: choose another name";
    item output_with_a_generated_name: "output «solve» = crank.x;" => "an output cannot be called `solve`: a generated function has that name\nhelp: choose another name";
    item slice_of_a_body: "slice «body» wheel {}" => "expected `output`, `joint`, `drive` or `force` after `slice`, found `body`";
    item output_with_the_name_of_a_slice: "slice output far = crank.x; output «solve_for_far» = crank.x;" => "an output cannot be called `solve_for_far`: a generated function has that name\nhelp: choose another name";
    item point_called_angle: "body b { point «angle» = (0mm, 0mm); }" => "`angle` has a meaning of its own in expressions\nhelp: choose another name";
    item uses_of_a_name_with_a_meaning_are_not_refused_as_well: "body «table» { point P = (0mm, 0mm); } joint a = revolute(table.P, crank.A); output b = table(crank.angle, [(0deg, 1mm), (90deg, 2mm)]);" => "`table` has a meaning of its own in expressions\nhelp: choose another name";
    item uses_of_a_body_called_ground_are_not_refused_as_well: "body «ground» { point P = (0mm, 0mm); } joint a = revolute(ground.P, crank.A);" => "`ground` is what stands still\nhelp: its points go into `ground { … }`, without `body`; all else has another name";
    item uses_of_a_parameter_called_t_are_not_refused_as_well: "param «t»: Length = 1mm; body b { point P = (t, 0mm); }" => "`t` has a meaning of its own in expressions\nhelp: choose another name";
}
