//! Components, parts, loops and arrays.

crate::refusals! {
    // Names in loops.
    item body_without_index: "for i in 0..2 { body «b» {} }" => "every round of the loop would declare another `b`\nhelp: write `b[i]`";
    item point_without_index: "body b { for i in 0..2 { point «P» = (i * 1m, 0m); } }" => "every round of the loop would declare another `P`\nhelp: write `P[i]`";
    item joint_without_index: "for i in 0..2 { joint «j» = revolute(ground.C, crank.A); }" => "every round of the loop would declare another `j`\nhelp: write `j[i]`";
    item declared_before_the_loop: "body b[0] {} for i in 0..2 { body «b»[i] {} }" => "`b[0]` is declared twice: here, and outside of this loop or in another round of it\nhelp: count on from there, as in `[i + 1]`";
    mechanism array_as_in_c: "mechanism M { ground { axis u = (1, 0); } body «link»[3] {} joint h = revolute(ground.position, link[0].position); for i in 0..3 { drive d[i] = drive_angle(link[i], 1rad); } }" => "there is a body `link[3]` but no `link[0]`\nhelp: the indices of an array run from 0 without gaps; 3 of them are written `for i in 0..3 { body link[i] … }`";
    item index_of_one_loop_of_two: "for i in 0..2 { for j in 0..2 { body «b»[i] {} } }" => "`b[0]` is declared twice\nhelp: every loop around it needs an index of its own, such as `[j]`";
    item body_of_an_array_twice: "body b[0] {} body «b»[0] {}" => "the name `b[0]` is taken: a body has it\nhelp: choose another name";
    item array_with_a_single_name: "body b {} body «b»[0] {}" => "the name `b[0]` is taken: a body has it\nhelp: choose another name";
    item output_of_an_array_twice: "output o[0] = 1; output «o»[0] = 2;" => "the name `o[0]` is taken: another output has it\nhelp: choose another name";
    item variable_with_a_taken_name: "for «crank» in 0..2 {}" => "the name `crank` is taken: a body has it\nhelp: choose another name";
    item variable_of_another_loop: "for i in 0..2 { for «i» in 0..2 {} }" => "the name `i` is taken: the variable of another loop has it\nhelp: choose another name";
    item variable_with_a_meaning: "for «t» in 0..2 {}" => "`t` has a meaning of its own in expressions\nhelp: choose another name, such as `t_1`";
    // Indices and ranges.
    item index_out_of_range: "body b[0] {} body b[1] {} output o = b[«2»].x;" => "there is no `b[2]`\nnote: there are `b[0]` to `b[1]`";
    item index_out_of_range_in_a_loop: "for i in 0..3 { body b[i] {} } for i in 0..3 { joint j[i] = revolute(b[«i + 1»].position, b[0].position); }" => "there is no `b[3]`\nnote: in `j[2]`\nnote: there are `b[0]` to `b[2]`";
    item index_out_of_a_small_range: "body b[0] {} output o = b[«-1»].x;" => "there is no `b[-1]`\nnote: there is `b[0]` only";
    item point_out_of_range: "body b { point P[0] = (0m, 0m); } output o = b.P[«1»];" => "there is no `b.P[1]`\nnote: there is `b.P[0]` only";
    item second_index_out_of_range: "for i in 0..2 { for j in 0..2 { body b[i][j] {} } } output o = b[1][«2»].x;" => "there is no `b[1][2]`\nnote: there are `b[1][0]` to `b[1][1]`";
    item negative_index: "for i in 0..2 { body b[«i - 1»] {} }" => "an index counts from 0, this one is -1\nnote: here `i` is 0";
    item gap: "body «b»[0] {} body b[2] {}" => "there is a body `b[2]` but no `b[1]`\nhelp: the indices of an array run from 0 without gaps";
    item array_from_one: "for i in 1..=3 { body «b»[i] {} }" => "there is a body `b[1]` but no `b[0]`\nhelp: the indices of an array run from 0 without gaps";
    item ragged_array: "for i in 0..3 { for j in 0..i { body «b»[i][j] {} } }" => "there is a body `b[1][0]` but no `b[0][0]`\nhelp: the indices of an array run from 0 without gaps";
    item index_with_a_unit: "body b[«1mm»] {}" => "expected a whole number, found `1mm`\nnote: indices and ranges are made of whole numbers, `let`s and loop variables with + - * / %";
    item index_of_a_fraction: "body b[«7 / 2»] {}" => "expected a whole number, found `7 / 2`\nnote: indices and ranges are made of whole numbers, `let`s and loop variables with + - * / %";
    item index_of_a_length: "body b[«double»] {}" => "expected a whole number, found a length (m)\nnote: indices and ranges are made of whole numbers, `let`s and loop variables with + - * / %";
    item index_of_a_body: "body b[«crank»] {}" => "expected a whole number, found a body\nnote: indices and ranges are made of whole numbers, `let`s and loop variables with + - * / %";
    item index_by_a_function: "body b[«sin(0)»] {}" => "expected a whole number, found this\nnote: indices and ranges are made of whole numbers, `let`s and loop variables with + - * / %";
    item remainder_by_zero: "body b[«1 % 0»] {}" => "expected a whole number, found `1 % 0`\nnote: indices and ranges are made of whole numbers, `let`s and loop variables with + - * / %";
    item remainder_of_a_length: "output o = «length» % 2;" => "expected a whole number, found a length (m)\nnote: indices and ranges are made of whole numbers, `let`s and loop variables with + - * / %";
    item range_over_a_parameter: "param n: Number = 3; for i in 0..«n» { body b[i] {} }" => "how many there are cannot change at run time\nhelp: declare the number with `let`, such as `let count = 6;`";
    item range_backwards: "for i in «3..1» { body b[i] {} }" => "this loop runs over nothing: from 3 to below 1\nhelp: a loop counts upwards: write `1..=3`";
    item range_of_nothing: "for i in «2..2» { body b[i] {} }" => "this loop runs over nothing: from 2 to below 2\nhelp: for 2 alone write `2..=2`";
    item range_without_end: "for i in 0 «{» body b[i] {} }" => "expected `..` or `..=` and the end of the range, found `{`\nhelp: write `for i in 0..3 { … }`";
    item range_too_long: "for i in «0..1000000» { body b[i] {} }" => "this loop has 1000000 rounds, at most 10000 are possible";
    item name_in_a_range_is_unknown: "for i in 0..«legs» { body b[i] {} }" => "nothing is called `legs` here";
    item array_without_index: "body b[0] {} output o = «b».x;" => "`b` is an array\nhelp: say which one, such as `b[0]`";
    item array_as_an_argument: "body b[0] {} joint j = parallel(crank, «b»);" => "`b` is an array\nhelp: say which one, such as `b[0]`";
    item array_with_one_index_of_two: "for i in 0..2 { for j in 0..2 { body b[i][j] {} } } output o = «b[0]».x;" => "`b[0]` is an array\nhelp: say which one, such as `b[0][0]`";
    item array_without_index_in_a_loop: "for i in 0..2 { body b[i] {} } for k in 0..2 { output o[k] = «b».x; }" => "`b` is an array\nnote: in `o[0]`\nhelp: say which one, such as `b[k]`";
    item part_as_in_java: "component Leg() { body b {} } part leg = «new» Leg();" => "a component is called without `new`\nhelp: write `part leg = Leg();`";
    item part_without_parentheses: "component Leg() { body b {} } part leg = Leg«;»" => "expected `(` and the arguments of the component, found `;`\nhelp: one without arguments is called with `()`";
    item index_of_no_array: "output o = crank[«0»].x;" => "a body has no index\nhelp: take `[…]` away";
    item index_too_many: "body b[0] {} output o = b[0][«0»].x;" => "a body has no further index\nhelp: take the last `[…]` away";
    item let_with_an_index_in_equations: "joint j = { let a[«0»] = 1; crank.x == a; }" => "`a` cannot have an index: there are no arrays among equations\nhelp: declare the array in the mechanism";
    item start_in_a_loop: "body b { for i in 0..2 { «start» angle = 0; } }" => "a body starts once: `start` cannot be repeated\nhelp: move it out of the loop";
    item outputs_with_and_without_velocities: "output «o»[0] = crank.angle / 1s; output o[1] = crank.angular_velocity;" => "the outputs `o` measure different things\nhelp: give outputs of another kind another name";
    item outputs_of_two_kinds: "output «o»[0] = crank.x; output o[1] = crank.A;" => "the outputs `o` measure different things\nhelp: give outputs of another kind another name";
    // Components.
    item component_is_unknown: "part p = «Leg»();" => "no component is called `Leg`\nhelp: declare it with `component Leg(…) { … }`";
    item component_is_mistyped: "component Leg() {} part p = «Log»();" => "no component is called `Log`\nhelp: did you mean `Leg`?";
    item constraint_as_a_component: "part p = «revolute»(ground.O, crank.O);" => "`revolute` is a constraint, not a component\nhelp: write `joint name = revolute(…);`";
    item function_of_the_mechanism_is_mistyped_in_a_component: "component Leg(P: Point) { body b { point A = («lfit»(0rad), 0m); } joint j = revolute(P, b.A); } part leg = Leg(ground.C);" => "no function is called `lfit`\nnote: in `leg.b.A`\nhelp: did you mean `lift`?";
    item component_as_a_constraint: "component Leg() {} joint p = «Leg»();" => "`Leg` is a component, not a constraint\nhelp: write `part name = Leg(…);`";
    item component_twice: "component Leg() {} component «Leg»() {}" => "the name `Leg` is taken: another component has it\nhelp: choose another name";
    item component_of_itself: "component Leg() { part p = «Leg»(); } part q = Leg();" => "the component `Leg` contains itself, and so without end\nhelp: let each part take the one before as an argument: `for i in 1..n { part name[i] = Leg(name[i - 1].end); }`";
    item components_of_each_other: "component A() { part p = B(); } component B() { part p = «A»(); } part q = A();" => "the component `A` contains itself, and so without end\nhelp: let each part take the one before as an argument: `for i in 1..n { part name[i] = A(name[i - 1].end); }`";
    item component_with_a_generated_name: "component «State»() {}" => "a component cannot be called `State`: a generated type would have that name\nhelp: choose another name";
    item component_with_the_name_of_a_slice: "component «ForTip»() {}" => "a component cannot be called `ForTip`: a generated type would have that name\nhelp: choose another name";
    item component_with_the_name_of_what_is_prepared: "component «Prepared»() {}" => "a component cannot be called `Prepared`: a generated type would have that name\nhelp: choose another name";
    item component_with_the_name_of_loads: "component «Loads»() {}" => "a component cannot be called `Loads`: a generated type would have that name\nhelp: choose another name";
    item component_with_the_name_of_points: "component «Points»() {}" => "a component cannot be called `Points`: a generated type would have that name\nhelp: choose another name";
    item component_in_a_component: "component Leg() { «component» Foot() {} }" => "`component` stands in the mechanism itself, not in a component or a loop\nhelp: move it out";
    item ground_in_a_component: "component Leg() { «ground» { } }" => "`ground` stands in the mechanism itself, not in a component or a loop\nhelp: move it out; a component takes points and axes of ground as parameters, such as `P: Point` and `a: Axis`";
    item parameter_of_a_component_twice: "component Leg(P: Point, «P»: Axis) {}" => "the name `P` is taken: another parameter has it\nhelp: choose another name";
    item kind_is_mistyped: "component Leg(P: «Pint») {}" => "no parameter can take `Pint`\nhelp: did you mean `Point`?";
    item default_before_none: "component Leg(a: Length = 1m, «b»: Length) {}" => "`b` needs a default, since the parameter before it has one\nhelp: put it before those with a default";
    item name_of_an_argument: "component Leg(P: Point) { body «P» {} } part p = Leg(ground.O);" => "the name `P` is taken: an argument has it\nhelp: choose another name";
    // Arguments.
    item too_few_arguments: "component Leg(P: Point, Q: Point) {} part p = «Leg»(ground.O);" => "`Leg` takes 2 arguments, found 1: `Q` is missing\nnote: `Leg(P: Point, Q: Point)`";
    item too_many_arguments: "component Leg(P: Point) {} part p = Leg(ground.O, «ground.C»);" => "`Leg` takes 1 argument, found 2\nnote: `Leg(P: Point)`";
    item argument_is_mistyped: "component Leg(pivot: Point) {} part p = Leg(«pivo»: ground.O);" => "`Leg` has no parameter `pivo`\nhelp: did you mean `pivot`?\nnote: `Leg(pivot: Point)`";
    item body_for_a_point: "component Leg(P: Point) {} part p = Leg(«crank»);" => "`P` of `Leg` takes a point, found a body\nhelp: write `crank.A`, or `crank.position` for its origin";
    item angle_for_a_length: "component Leg(a: Length) {} part p = Leg(«3deg»);" => "`a` of `Leg` is a length (m), found an angle (rad)";
    item arguments_in_a_circle: "component Leg(a: Length) { let b = 2 * «a»; } part p = Leg(q.b); part q = Leg(p.b);" => "`a` depends on itself, by way of `q.b`, `q.a` and `p.b`\nnote: in `p.b`";
    // Scope of a component.
    item body_outside_of_a_component: "component Leg() { joint j = absolute_angle(«crank», 0); } part p = Leg();" => "a component does not see `crank`, a body outside of it\nnote: in `p.j`\nhelp: take what it needs as an argument, such as `P: Point` or `b: Body`";
    item loop_outside_of_a_component: "component Leg() { let a = 2 * «i»; } for i in 0..2 { part p[i] = Leg(); }" => "nothing is called `i` here\nnote: in `p[0].a`";
    item mistake_in_a_component_is_said_once: "component Leg(P: Point) { body b {} joint j = revolute(P, «b»); } for i in 0..5 { part leg[i] = Leg(ground.O); }" => "`Q` of `revolute` takes a point, found a body\nnote: in `leg[0].j`\nhelp: write `b.position`";
    item mistake_in_one_part_of_many: "component Leg(a: Length) { body b {} body c {} joint j = distance(b.position, c.position, «a»); } for i in 0..5 { part leg[i] = Leg((3 - i) * 1mm); }" => "a distance of zero cannot be differentiated where it holds: use `revolute`, in space `spherical`, to keep two points together\nnote: in `leg[3].j`";
    item name_in_a_part_is_mistyped: "component Leg() { body foot {} } part p = Leg(); output o = p.«foat».x;" => "`p` has no `foat`\nhelp: did you mean `foot`?";
    item unlike_parts: "component Leg(n: Number) { for i in 0..n { body b[i] {} } } part p = Leg(1); part «q» = Leg(2);" => "`q` has not the same bodies, parameters, parts and outputs as the first `Leg`\nhelp: how many there are of something in a component cannot depend on its arguments";
    item outputs_of_one_name: "component Leg() { output toe = 1; } part leg = Leg(); output «leg_toe» = 2;" => "the name `leg_toe` is taken: another output has it\nhelp: choose another name";
    item default_of_a_part_is_not_constant: "component Leg(a: Length) { param b: Length = «a»; } part p = Leg(length);" => "the default of a parameter is a constant: numbers, units, `pi` and functions of them\nnote: in `p.b`\nhelp: a quantity that follows from others is declared with `let`";
    item requirement_of_an_argument: "component Leg(a: Length) { body b {} body c {} joint j = distance(b.position, c.position, «0 * a»); } part p = Leg(1m);" => "a distance of zero cannot be differentiated where it holds: use `revolute`, in space `spherical`, to keep two points together\nnote: in `p.j`";
    // Components that are not used, and gaps.
    item mistake_in_a_component_that_is_not_used: "component Arm(P: Point) { body limb {} joint j = revolute(P, «limb»); }" => "`Q` of `revolute` takes a point, found a body\nnote: in `Arm.j`\nhelp: write `limb.position`";
    item dimensions_in_a_component_that_is_not_used: "component Arm(a: Length) { let b = «a + 1deg»; }" => "cannot add an angle (rad) to a length (m)\nnote: in `Arm.b`\nhelp: an arc is a radius times an angle";
    item name_in_a_component_that_is_not_used: "component Arm(B: Body) { output o = «lim».x; }" => "nothing is called `lim` here\nnote: in `Arm.o`";
    item part_in_a_component_that_is_not_used: "component Arm(P: Point) { part hand = Hand(«limb»); } component Hand(P: Point) { body palm {} joint j = weld(P, palm.position); }" => "nothing is called `limb` here\nnote: in `Arm.hand`";
    item zero_in_a_component_that_is_not_used: "component Arm(P: Point) { body limb {} joint j = distance(P, limb.position, «0mm»); }" => "a distance of zero cannot be differentiated where it holds: use `revolute`, in space `spherical`, to keep two points together\nnote: in `Arm.j`";
    item index_in_an_array_with_a_gap: "joint j[0] = translational(ground.u, ground.O, ram.B); joint j[2] = translational(ground.u, ground.O, ram.B); drive d = drive_along(j[«1»], 1mm);" => "there is no `j[1]`\nnote: there are `j[0]` and `j[2]`";
    // A mistake in every part is reported for the first part only.
    mechanism joint_doubled_in_a_component: "mechanism Row { component Leg() { body b {} joint o = revolute(ground.position, b.position); joint «p» = revolute(b.position, ground.position); drive d = drive_angle(b, 1rpm * t); } for i in 0..4 { part leg[i] = Leg(); } }" => "`leg[0].p` demands the same as `leg[0].o`\nhelp: take one of them away";
    mechanism joint_doubled_in_a_loop: "mechanism Row { for i in 0..4 { body b[i] {} joint o[i] = revolute(ground.position, b[i].position); joint «p»[i] = revolute(b[i].position, ground.position); drive d[i] = drive_angle(b[i], 1rpm * t); } }" => "`p[0]` demands the same as `o[0]`\nhelp: take one of them away";
    mechanism nothing_at_the_default_in_a_component: "mechanism Row { component Leg() { param r: Length = 0mm; body b {} joint o = distance(ground.position, b.position, «r»); } for i in 0..4 { part leg[i] = Leg(); } }" => "a distance of zero cannot be differentiated where it holds: use `revolute`, in space `spherical`, to keep two points together\nnote: it is 0 at the declared defaults";
}

/// Components may have joints of the same name, each with its own mistake.
#[test]
fn joints_of_one_name_in_two_components_are_both_told() {
    let repeated = "body b {} joint o = revolute(ground.position, b.position); joint p = revolute(b.position, ground.position);";
    let follows = "body b {} joint o = revolute(ground.position, b.position); joint p = { b.x == 0; 2 * b.y == 0; }";
    for (body, words) in [(repeated, "demands the same as"), (follows, "adds nothing")] {
        let parts = "for i in 0..2 { part leg[i] = Leg(); part arm[i] = Arm(); }";
        let source = format!("mechanism Row {{ component Leg() {{ {body} }} component Arm() {{ {body} }} {parts} }}");
        let refusals = reuleaux_compiler::compile(source.parse().expect("tokens")).expect_err("joints are doubled");
        let said: Vec<String> = refusals.iter().map(|refusal| refusal.fact.to_string()).collect();
        assert_eq!(said.len(), 2, "{said:?}");
        for (said, joint) in said.iter().zip(["`leg[0].p`", "`arm[0].p`"]) {
            assert!(said.starts_with(joint) && said.contains(words), "{said}");
        }
    }
}

/// Two violated conditions of one joint are two mistakes.
#[test]
fn two_numbers_of_a_joint_that_are_wrong_are_both_told() {
    let leg = "component Leg() { param a: Number = 0; body b {} body c {} joint g = gear_pair(b, c, a, 2 * a); }";
    let source = format!("mechanism Row {{ {leg} for i in 0..2 {{ part leg[i] = Leg(); }} }}");
    let refusals = reuleaux_compiler::compile(source.parse().expect("tokens")).expect_err("a gear has no teeth");
    assert_eq!(refusals.len(), 2, "{refusals:?}");
}
