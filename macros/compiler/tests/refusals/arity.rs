//! Too many arguments, or too few.

crate::refusals! {
    item argument_is_missing: "joint a = «revolute»(ground.O);" => "`revolute` takes 2 arguments, found 1: `Q` is missing\nnote: `revolute(P: Point, Q: Point)`";
    item all_arguments_are_missing: "joint a = «weld»();" => "`weld` takes 2 or 3 arguments, found 0: `P` and `Q` are missing\nnote: `weld(P: Point, Q: Point, c: Angle = …)`";
    item argument_too_many: "joint a = revolute(ground.O, crank.O, «ram.B»);" => "`revolute` takes 2 arguments, found 3\nnote: `revolute(P: Point, Q: Point)`";
    item argument_twice: "joint a = gear_pair(crank, ram, 1, 2, «a»: 3);" => "the argument `a` is given twice: by its place in the order and by its name\nhelp: take one of them away";
    item position_after_name: "joint a = gear_pair(crank, ram, 1, b: 2, «3»);" => "an argument without a name cannot follow one with a name\nhelp: say which one it is, such as `c: …`";
    item builtin_with_too_many: "output b = «sin»(crank.angle, 2);" => "`sin` takes 1 argument, found 2";
    item builtin_with_too_few: "output b = «atan2»(1);" => "`atan2` takes 2 arguments, found 1\nnote: `atan2(y, x)`";
    item own_function_with_too_many: "output b = «lift»(crank.angle, 2);" => "`lift` takes 1 argument, found 2";
    item law_with_too_few: "output b = «harmonic»();" => "`harmonic` takes 1 argument, found 0";
    item table_with_too_few: "output b = «table»(crank.angle);" => "`table` takes 2 or 3 arguments, found 1\nnote: `table(x, [(x0, y0), (x1, y1), …], periodic)`";
    item vector_with_three_components: "output b = «(1, 2, 3)»;" => "a vector in the plane has 2 components, found 3\nhelp: for a mechanism in space write `mechanism Name in space { … }`";
    item point_with_three_components: "body b { point P = «(1mm, 2mm, 3mm)»; }" => "a vector in the plane has 2 components, found 3\nhelp: for a mechanism in space write `mechanism Name in space { … }`";
}
