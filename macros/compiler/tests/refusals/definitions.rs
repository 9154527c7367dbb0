//! Mistakes inside `constraint!`.

crate::refusals! {
    constraint row_of_nothing: "constraint c(P: Point, a: Length) { «a == 2 * a»; }" => "the equation of `c` does not depend on the position of any body";
    constraint second_row_of_nothing: "constraint c(P: Point, a: Length) { P.x == a; «a == 1mm»; }" => "equation 2 of 2 of `c` does not depend on the position of any body";
    constraint equation_in_a_force: "force f(P: Point) { «P.x == 1m»; }" => "a force has no equations\nhelp: write `at point: force;` or `on body: torque;`, and equations in a `joint`";
    constraint force_in_a_constraint: "constraint c(P: Point) { at «P»: (1N, 0N); P.x == 1m; }" => "a joint has equations and no forces\nhelp: write `force name = …;` for what pushes or turns, `joint name = …;` for what holds";
    constraint force_of_a_force: "force f(P: Point, k: Stiffness) { at P: «k * (1, 0)»; }" => "expected a force (N), found a stiffness (N/m)";
    constraint no_equations: "constraint «c»(P: Point) { let a = P.x; }" => "`c` has no equations\nhelp: write `lhs == rhs;`";
    constraint time_in_a_definition: "constraint c(P: Point) { P.x == 1mm / 1s * «t»; }" => "`t` is not known in a definition\nhelp: take the law as a parameter, such as `C: Length`, and let a `drive` pass it";
    constraint argument_is_missing: "constraint c(P: Point) { P.x == «radius»; }" => "nothing is called `radius` here\nhelp: take it as an argument, `radius: Length`";
    constraint name_is_mistyped: "constraint c(P: Point, radius: Length) { P.x == «raduis»; }" => "nothing is called `raduis` here\nhelp: did you mean `radius`?";
    constraint kind_is_mistyped: "constraint c(P: «Pont») { P.x == 0; }" => "no parameter can take `Pont`\nhelp: did you mean `Point`?";
    constraint kind_is_unknown: "constraint c(P: «Sphere») { P.x == 0; }" => "no parameter can take `Sphere`\nnote: it takes a `Point`, `Axis`, `Body`, `Quantity`, `Function(…) -> …`, `Joint(…)`, or a dimension such as `Length`";
    constraint joint_kind_is_unknown: "constraint c(j: Joint(«translation»)) { j.P.x == 0; }" => "no constraint is called `translation`\nhelp: did you mean `translational`?";
    constraint field_of_a_joint: "constraint c(j: Joint(translational)) { j.«R».x == 0; }" => "a `translational` joint has no `R`\nnote: it has `u`, `P`, `Q` and `c`";
    constraint dimensions_differ: "constraint c(P: Point, a: Angle) { «P.x == a»; }" => "cannot equate a length (m) with an angle (rad)\nhelp: an arc is a radius times an angle";
    constraint default_of_another_dimension: "constraint c(P: Point, a: Length = «1deg») { P.x == a; }" => "expected a length (m), found an angle (rad)";
    constraint default_of_another_kind: "constraint c(P: Point, b: Body = «0») { P.x == b.x; }" => "the parameter takes a body, its default is a number";
    constraint default_before_none: "constraint c(a: Length = 0, «P»: Point) { P.x == a; }" => "`P` needs a default, since the parameter before it has one\nhelp: put it before those with a default";
    constraint parameter_twice: "constraint c(P: Point, «P»: Point) { P.x == 0; }" => "the name `P` is taken: another parameter has it\nhelp: choose another name";
    constraint parameter_with_a_meaning: "constraint c(P: Point, «t»: Length) { P.x == t; }" => "`t` has a meaning of its own in expressions\nhelp: choose another name, such as `t_1`";
    constraint constraint_twice: "pub constraint c(P: Point) { P.x == 0; } pub constraint «c»(P: Point) { P.y == 0; }" => "the name `c` is taken: another definition has it\nhelp: choose another name";
    constraint constraint_twice_in_a_bundle: "pub bundle all { constraint c(P: Point) { P.x == 0; } constraint «c»(P: Point) { P.y == 0; } }" => "the name `c` is taken: another definition has it\nhelp: choose another name";
    constraint requirement_without_reason: "constraint c(P: Point, a: Length) { require a != 0«;» P.x == a; }" => "expected `:` and a sentence that says why, found `;`";
    constraint requirement_without_relation: "constraint c(P: Point, a: Length) { require a«:» \"why\"; P.x == a; }" => "expected a relation such as `<` or `>=`, found `:`";
    constraint requirement_of_unlike: "constraint c(P: Point, a: Length) { require «a != P»: \"why\"; P.x == a; }" => "cannot compare a number with a point";
    constraint parameter_without_kind: "constraint c(P«)» { P.x == 0; }" => "expected `:` and what the parameter takes, such as `Point` or `Length`, found the end";
    constraint no_constraint: "pub «fn» c(P: Point) { P.x == 0; }" => "expected `constraint name(…) { … }`, found `fn`";
    constraint function_without_result: "constraint c(P: Point, f: Function(Angle)«,» b: Body) { P.x == f(b.angle); }" => "expected `->` and the dimension of the value, found `,`";
    constraint order_of_bodies: "constraint c(b: Body, d: Body) { require «b < d»: \"why\"; b.x == d.x; }" => "bodies have no order\nhelp: compare them with `==` or `!=`";
    constraint empty_bundle: "pub bundle «nothing» {}" => "the bundle `nothing` is empty\nhelp: put `constraint name(…) { … }` or `component Name(…) { … }` into it";
    constraint component_twice: "pub component C(P: Point) { body b {} joint j = revolute(P, b.position); } pub constraint «C»(P: Point) { P.y == 0; }" => "the name `C` is taken: another definition has it\nhelp: choose another name";
    constraint component_of_nothing_outside: "pub component C(P: Point) { body b { point A = («length», 0mm); } joint j = revolute(P, b.A); }" => "nothing is called `length` here\nnote: in `C.b.A`\nhelp: declare it, such as `param length: Length = …;`";
    constraint component_without_its_component: "pub component C(P: Point) { part d = «D»(P); }" => "no component is called `D`\nhelp: declare it with `component D(…) { … }`";
    constraint component_with_a_broken_force: "pub component C(P: Point) { body b {} joint j = revolute(P, b.position); force f = spring(P, b.position, stiffness: 1N_m, «length»: 1m); }" => "`spring` has no parameter `length`\nnote: in `C.f`\nhelp: did you mean `rest`?\nnote: `spring(P: Point, Q: Point, stiffness: Stiffness, rest: Length = …)`";
    constraint component_in_space: "pub component C(P: Point) in space { body b { point A = «(1m, 0m)»; } joint j = spherical(P, b.A); }" => "a vector in space has 3 components, found 2\nnote: in `C.b.A`\nhelp: write the third, which is 0 in the plane of x and y";
    constraint component_that_means_space: "pub component «C»(P: Point) { body b { point A = (1m, 0m, 0m); point B = (0m, 0m, 0m); axis u = (0, 0, 1); } joint j = spherical(P, b.A); }" => "`C` has words and vectors of space, and a component is in the plane where it does not say `in space`\nhelp: write `component C(…) in space { … }`";
    constraint component_beside_one_that_means_space: "pub component A(P: Point) { body b { point A = (1m, 0m); point B = (2m, 0m); point C = (3m, 0m); point D = (3m, 0m); } joint j = revolute(P, b.A); } pub component «C»(P: Point) { body b { point A = (1m, 0m, 0m); point B = (0m, 0m, 0m); axis u = (0, 0, 1); } joint j = spherical(P, b.A); }" => "`C` has words and vectors of space, and a component is in the plane where it does not say `in space`\nhelp: write `component C(…) in space { … }`";
    constraint component_with_a_mistake_in_what_it_calls: "pub component A(P: Point) { part c = C(P); part d = C(P); } pub component C(P: Point) { body b { point A = («size», 0m); } joint j = revolute(P, b.A); }" => "nothing is called `size` here\nnote: in `A.c.b.A`";
    constraint component_with_a_mistyped_function: "pub component C(P: Point, a: Angle) { body b { point A = (1m * «sni»(a), 0m); } joint j = revolute(P, b.A); }" => "no function is called `sni`\nnote: in `C.b.A`\nhelp: did you mean `sin`?";
    constraint component_with_a_mistyped_argument: "pub component C(P: Point, reach: Function(Angle) -> Length) { body b {} joint j = revolute(P, b.position); drive d = drive_angle(b, «raech»(1rad) / 1m * 1rad); }" => "no function is called `raech`\nnote: in `C.d`\nhelp: did you mean `reach`?";
    constraint component_in_no_place: "pub component C(P: Point) in «room» { body b {} }" => "expected `space` or `plane`, found `room`";
    constraint broken_in_a_component: "pub component C(P: Point) { body b { point A = «;» } } pub constraint c(P: Point) { P.x == 0; }" => "expected an expression, found `;`";
    constraint attribute_of_a_component: "#[«inline»] pub component C(P: Point) { body b {} }" => "`#[inline]` is not known here\nhelp: doc comments may stand before any item, `#[equations_only]`, `#[integrated]`, `#[closure(…)]`, `#[allow(far_start)]`, `#[picture]`, `#[serde]`, `#[outputs]` and `#[points]` before `mechanism`, `#[velocity]` before `joint` and `drive`";
    constraint broken_in_a_bundle: "pub bundle all { constraint c(P: Point) { P.x == «;» } constraint d(P: Point) { P.y == 0; } }" => "expected an expression, found `;`";
}
