//! Mistakes of grammar.

crate::refusals! {
    item a_unit_in_brackets: "let a = «100»[mm];" => "a unit stands right behind its number, without brackets\nhelp: write `100mm`";
    item a_joint_without_its_word: "«pin» = revolute(ground.C, ram.B);" => "an item begins with its kind, and has a name\nhelp: write `joint pin = revolute(…);`";
    item a_drive_without_its_word: "«turn» = drive_angle(ram, 60rpm * t);" => "an item begins with its kind, and has a name\nhelp: write `drive turn = drive_angle(…);`";
    item a_value_without_its_word: "«radius» = 100mm;" => "an item begins with its kind, and has a name\nhelp: write `let radius = …;`";
    item a_value_with_a_type: "«double» radius = 100mm;" => "an item begins with its kind, and has a name\nhelp: write `let radius = …;`";
    item a_comment_of_matlab: "«%» a comment" => "expected an item: `param`, `input`, `let`, `ground`, `body`, `joint`, `drive`, `freedom`, `force`, `energy`, `gravity`, `start`, `output`, `range`, `part`, `for`, `component`, `function` or `use`, found `%`\nhelp: a comment begins with `//`";
    item a_body_from_a_component: "body leg «=» Leg(1m);" => "expected `{` and the points of the body, found `=`\nhelp: write `body name { … }`; a part that is made of a component is `part name = Component(…);`";
    item a_start_without_its_word: "body b { «angle» = 70deg; }" => "`angle` is no item of a body\nhelp: write `start angle = …;` for about where the body is at t = 0";
    item two_conditions_in_words: "let a = if length > 1m «and» length < 2m { 1 } else { 2 };" => "expected `{ value }`, found `and`\nhelp: a choice has one condition: choose twice, as in `if a < b { if c < d { x } else { y } } else { y }`";
    item a_chain_of_comparisons: "let a = if 1m < length «<» 2m { 1 } else { 2 };" => "expected `{ value }`, found `<`\nhelp: a choice has one condition: choose twice, as in `if a < b { if c < d { x } else { y } } else { y }`";
    item a_joint_with_bounds: "joint pin = revolute(ground.C, ram.B) «in» -90deg..90deg;" => "bounds belong to a parameter, as in `param a: Length = 1m in 0m..;`\nhelp: forces that end a motion are `stop`, `stop_along` and `torsion_stop`";
    item a_closure: "drive b = drive_angle(ram, «|»t| 60rpm * t);" => "a law is an expression of `t`, not a closure\nhelp: write `60rpm * t`";
    item a_percentage: "param ratio: Number = «20%»;" => "`%` is the rest of a division\nhelp: write `0.2`";
    item a_cast: "let a = 2 «as» f64;" => "all numbers are real ones\nhelp: write `2`";
    item a_unit_in_an_exponent: "let a = 2 * «10^3g»;" => "a unit belongs to the number before it, here to the exponent\nhelp: write `1e3g`";
    item named_values_of_a_shape: "body c { mass = 1kg; inertia = disk(«radius»: 60mm); }" => "values in parentheses have no names here\nhelp: write `60mm`";
    item bounds_in_brackets: "param a: Length = 1m in «[500mm, 2m]»;" => "bounds stand on both sides of `..=`\nhelp: write `in 500mm..=2m`";
    item a_start_behind_a_comma: "freedom swing = ram.angle«,» 30deg;" => "the value at t = 0 stands behind `from`\nhelp: write `ram.angle from 30deg`";
    item a_condition_as_an_item: "«require» length > 0;" => "`require` is no item of a mechanism\nhelp: bounds of a parameter stand behind it, as in `param a: Length = 100mm in 50mm..;`";
    item an_array_as_in_c: "body «link»[3] { point P = (1m, 0m); }" => "there is a body `link[3]` but no `link[0]`\nhelp: the indices of an array run from 0 without gaps; 3 of them are written `for i in 0..3 { body link[i] … }`";
    item two_conditions_each_in_parentheses: "output b = if «(t > 0s)» && (t < 1s) { 1 } else { 2 };" => "a choice has one condition\nhelp: choose twice, as in `if a < b { if c < d { x } else { y } } else { y }`";
    item a_number_before_parentheses: "let a = «2(»1mm + 2mm);" => "an operator is missing between `2` and `(`\nhelp: write `2 * (…)`";
    item bounds_in_parentheses: "param a: Length = «100mm (»50mm..150mm);" => "the bounds of a parameter stand behind `in`\nhelp: write `100mm in 50mm..=150mm`";
    item an_output_in_a_unit: "output b = crank.x «in» mm;" => "values are in SI, and no unit is chosen for them\nhelp: take `in mm` away; outputs are converted in Rust";
    item an_absolute_value_in_bars: "output b = «|»crank.x|;" => "expected an expression, found `|`\nhelp: write `abs(x)`, or `norm(v)` of a vector";
    item a_rate_before_a_start_by_their_words: "freedom b = crank.angle at «30deg from 3rad_s»;" => "the value at t = 0 stands before the rate\nhelp: write `crank.angle from 30deg at 3rad_s`";
    item a_cotangent: "output b = «cot»(crank.angle);" => "no function is called `cot`\nhelp: write `1 / tan(x)`";
    item kinetic_energy: "output b = «kinetic_energy»(crank);" => "no function is called `kinetic_energy`: energies are computed for a state, in Rust\nhelp: write `mechanism.energy(&state)` there, with `kinetic` and `potential`";
    item unit_behind_parentheses: "param a: Length = «(100 + 20)mm»;" => "a unit stands behind a number, and `mm` behind parentheses\nhelp: write `(100 + 20) * 1mm`";
    item condition_in_parentheses: "output b = if «(t < 1s)» { 1 } else { 2 };" => "a condition has no parentheses\nhelp: write `if a < b { x } else { y }`";
    item two_conditions_in_parentheses: "output b = if «(t > 0s && t < 1s)» { 1 } else { 2 };" => "a choice has one condition\nhelp: choose twice, as in `if a < b { if c < d { x } else { y } } else { y }`";
    item array_of_a_dimension: "param a: «[Length; 3]»;" => "`[Length; 3]` is no dimension: arrays are declared by a loop\nhelp: write `for i in 0..3 { param name[i]: Length = 100mm; }`";
    item unit_with_a_point: "force f = { on crank: «3N.m»; };" => "a unit is one word, and `3N.m` is several\nhelp: write `3Nm`";
    item semicolon_is_missing: "param a: Length = 10mm «param» b: Length = 20mm;" => "expected `;`, found `param`\nhelp: end what stands before it with `;`";
    mechanism semicolon_is_missing_at_the_end: "mechanism Crank { param a: Length = 10mm «}»" => "expected `;`, found the end\nhelp: end what stands before it with `;`";
    item dimension_is_missing: "param a «=» 10mm;" => "expected `:` and a dimension such as `Length`, found `=`\nhelp: write the dimension behind the name, as in `name: Length = …;`";
    item default_is_missing: "param a: Length«;»" => "expected `=` and the default of the parameter, found `;`\nhelp: each parameter has a default, as in `param name: Length = 50mm;`";
    item name_is_missing: "param «:» Length = 10mm;" => "expected the name of the parameter, found `:`";
    item name_is_a_keyword: "joint «in» = revolute(ground.O, crank.O);" => "`in` is a word of Rust and cannot be a name\nhelp: write `in_`";
    item keyword_that_is_used_as_a_name: "body «async» { point B = (1m, 0m); } joint weld = weld(async.position, async.B); output end = async.B;" => "`async` is a word of Rust and cannot be a name\nhelp: write `async_`";
    item keyword_since_2024: "body «gen» { point B = (1m, 0m); }" => "`gen` is a word of Rust and cannot be a name\nhelp: write `gen_`";
    item underscore_that_is_used_as_a_name: "body «_» { point B = (1m, 0m); } joint weld = weld(_.position, crank.O);" => "expected the name of the body, found `_`";
    item item_is_unknown: "«parm» a: Length = 10mm;" => "`parm` is no item of a mechanism\nhelp: did you mean `param`?\nnote: items are `param`, `input`, `let`, `ground`, `body`, `joint`, `drive`, `freedom`, `force`, `energy`, `gravity`, `start`, `output`, `range`, `part`, `for`, `component`, `function` and `use`";
    item item_is_no_word: "«5» a: Length = 10mm;" => "expected an item: `param`, `input`, `let`, `ground`, `body`, `joint`, `drive`, `freedom`, `force`, `energy`, `gravity`, `start`, `output`, `range`, `part`, `for`, `component`, `function` or `use`, found `5`";
    item item_of_a_body_is_unknown: "body b { «pointt» P = (0mm, 0mm); }" => "`pointt` is no item of a body\nhelp: did you mean `point`?\nnote: a body has `point`, `axis`, `start`, `mass`, `center` and `inertia`";
    item body_without_braces: "body b«;»" => "expected `{` and the points of the body, found `;`\nhelp: write `body name { … }`, a name is one word; a body without points is `body name {}`";
    item sections_of_a_body_with_colons: "body b { point B = (1m, 0m); mass«:» 2kg; }" => "expected `=`, found `:`\nhelp: a value stands behind `=`; only parameters and inputs have `:` and a dimension before it";
    item start_of_no_coordinate: "body b { point B = (1m, 0m); start «=» 200mm; }" => "expected `x`, `y`, `angle` or `position`, found `=`\nhelp: say of which coordinate, as in `start x = 200mm;` or `start position = (200mm, 0mm);`";
    item point_outside_a_body: "«point» Z = (0mm, 0mm);" => "`point` belongs in ground or in a body\nhelp: write it there, as in `ground { point Z = …; }`";
    item axis_outside_a_body: "«axis» u = (1, 0);" => "`axis` belongs in ground or in a body\nhelp: write it there, as in `ground { axis u = …; }`";
    item mass_of_ground: "ground { «mass» = 3kg; }" => "ground does not move: its `mass` would change nothing\nhelp: take it away, or write it in a body";
    item centre_of_a_body: "body b { point B = (1m, 0m); «centre» = (0.5m, 0m); }" => "`centre` is no item of a body\nhelp: did you mean `center`?";
    item mass_twice: "body b { point B = (1m, 0m); mass = 1kg; «mass» = 2kg; inertia = rod(1m); }" => "`b` gives `mass` twice\nhelp: take one away";
    item sum_of_terms: "output b = «sum»(crank.x, crank.y);" => "no function is called `sum`\nhelp: write `a + b`; a sum over an array is `let s[0] = x[0]; for i in 1..n { let s[i] = s[i - 1] + x[i]; }`";
    item degrees_of_an_output: "output b = «deg»(crank.angle);" => "no function is called `deg`: angles have no unit inside a mechanism\nhelp: an angle in degrees is written `60deg`; outputs are in rad, and `.to_degrees()` is written in Rust";
    item angle_of_a_hinge_in_the_plane: "joint j = revolute(ground.O, crank.O); output b = j.«angle»;" => "a `revolute` joint has no `angle` in the plane\nhelp: bodies have one: write a difference, such as `rod.angle - crank.angle`";
    item component_of_a_point_by_index: "output b = crank.O[«0»];" => "a point has no index\nhelp: its components are `.x` and `.y`, in space `.z` too";
    item equal_sign_is_missing: "output b «crank»;" => "expected `=`, found `crank`";
    item operand_is_missing: "output b = 2 * «;»" => "expected an expression, found `;`";
    item plus_before_a_number: "output b = «+»5;" => "expected an expression, found `+`";
    item operator_is_unknown: "output b = 5 «&» 2;" => "expected an operator or `;`, found `&`";
    item power_is_a_caret: "output b = length«**»2;" => "`**` is no operator\nhelp: a power is written `a^b`";
    item functions_are_no_methods: "output b = crank.angle.«sin»();" => "there are no methods here\nhelp: write `sin(value)` for `value.sin()`";
    item operator_between_number_and_name: "let a = 180mm + «2 length»;" => "an operator is missing between `2` and `length`\nhelp: write `2 * length`";
    item unit_stands_behind_its_number: "param a: Length = «120 mm»;" => "a unit stands right behind its number\nhelp: write `120mm`";
    item text_is_no_number: "param a: Length = «\"120mm\"»;" => "expected a number, found a string\nhelp: a quantity is a number with its unit right behind it, such as `120mm`";
    item comma_is_missing: "joint a = revolute(ground.C «crank».A);" => "expected `,` or `)`, found `crank`";
    item call_is_missing: "joint a = revolute«;»" => "expected `(` and the arguments, found `;`";
    item constraint_by_its_path: "joint a = «crate::rolling»(crank);" => "a joint names its constraint by a single word\nhelp: write `use crate::rolling;` above, and `rolling(…)` here";
    item equation_with_a_single_equal_sign: "joint a = { crank.x «=» 0; }" => "an equation is written with `==`\nhelp: write `lhs == rhs;`";
    item equation_without_right_side: "joint a = { crank.x == «;» }" => "expected an expression, found `;`";
    item choice_without_else: "output b = if length < 1 { 1 }«;»" => "expected `else { value }`, found `;`";
    item choice_without_relation: "output b = if length «{» 1 } else { 2 };" => "expected a relation such as `<` or `!=`, found `{`";
    item pair_without_parentheses: "body b { point P = «0mm», 0mm; }" => "the coordinates of a point stand in parentheses\nhelp: write `(0mm, 0mm)`";
    item comma_after_a_point: "body b { point P = (0mm, 0mm)«,» point Q = (0mm, 1mm); }" => "expected `;`, found `,`\nhelp: `;` ends each item, `,` stands between arguments";
    item empty_parentheses: "output b = «()»;" => "expected an expression, found `()`";
    item field_is_no_number: "output b = crank.«5»;" => "expected a name after `.`, found `5`";
    item function_of_two: "function f(a: Angle«,» b: Angle) -> Length = 1mm;" => "a function here has one argument\nhelp: what else it depends on is a `param` or a `let`, which it sees";
    item function_without_result: "function f(a: Angle) «=» 1mm;" => "expected `->` and the dimension of the value, found `=`";
    item exponent_of_a_dimension: "param a: Length^«99» = 1;" => "the exponent of a dimension is at most 6";
    item attribute_is_unknown: "#[«inline»] output b = crank.x;" => "`#[inline]` is not known here\nhelp: doc comments may stand before any item, `#[equations_only]`, `#[integrated]`, `#[closure(…)]`, `#[allow(far_start)]`, `#[picture]`, `#[serde]`, `#[outputs]` and `#[points]` before `mechanism`, `#[velocity]` before `joint` and `drive`";
    item attribute_removes_a_field: "#[«cfg»(all())] param a: Length = 3mm;" => "`#[cfg]` is not known here\nhelp: doc comments may stand before any item, `#[equations_only]`, `#[integrated]`, `#[closure(…)]`, `#[allow(far_start)]`, `#[picture]`, `#[serde]`, `#[outputs]` and `#[points]` before `mechanism`, `#[velocity]` before `joint` and `drive`";
    item option_of_a_mechanism_at_a_parameter: "#[«points»] param a: Length = 3mm;" => "`#[points]` is not known here\nhelp: doc comments may stand before any item, `#[equations_only]`, `#[integrated]`, `#[closure(…)]`, `#[allow(far_start)]`, `#[picture]`, `#[serde]`, `#[outputs]` and `#[points]` before `mechanism`, `#[velocity]` before `joint` and `drive`";
    item serde_at_a_body: "#[«serde»(rename = \"c\")] body b { }" => "`#[serde]` is not known here\nhelp: doc comments may stand before any item, `#[equations_only]`, `#[integrated]`, `#[closure(…)]`, `#[allow(far_start)]`, `#[picture]`, `#[serde]`, `#[outputs]` and `#[points]` before `mechanism`, `#[velocity]` before `joint` and `drive`";
    item two_equal_signs: "let a «=»= 3mm;" => "expected `=`, found `==`\nhelp: a name gets its value with `=`; `==` stands between the sides of an equation";
    item number_without_its_first_digit: "param a: Length = «.»5m;" => "expected an expression, found `.`\nhelp: a number begins with a digit, such as `0.5`";
    item joint_without_a_name: "joint «revolute»(ground.C, crank.A);" => "a joint has a name of its own\nhelp: write `joint name = revolute(…);`";
    item joint_without_any_name: "joint «=» revolute(ground.C, crank.A);" => "expected the name of the joint, found `=`\nhelp: write `joint name = …`";
    item drive_without_a_name: "drive «drive_angle»(crank, 1rad_s * t);" => "a drive has a name of its own\nhelp: write `drive name = drive_angle(…);`";
    item let_that_changes: "let «mut» a = 3mm;" => "nothing here changes\nhelp: take `mut` away; what is to be set at run time is a `param`";
    item public_item: "«pub» param a: Length = 3mm;" => "all of a mechanism is as public as the mechanism\nhelp: take `pub` away";
    item body_by_another_name: "«link» b { point P = (0mm, 0mm); }" => "`link` is no item of a mechanism\nhelp: write `body b { … }`";
    item function_as_in_rust: "«fn» f(x: Angle) -> Length = 1mm;" => "`fn` is no item of a mechanism\nhelp: did you mean `function`?\nnote: items are `param`, `input`, `let`, `ground`, `body`, `joint`, `drive`, `freedom`, `force`, `energy`, `gravity`, `start`, `output`, `range`, `part`, `for`, `component`, `function` and `use`";
    item power_as_a_method: "output b = length.«powi»(2);" => "there are no methods here\nhelp: a power is written `a^b`";
    item glob_use: "use crate::«*»;" => "expected the name of a constraint or `{ … }`, found `*`";
    mechanism keyword_is_misspelled: "pub «mechansim» Crank { body crank {} }" => "expected `mechanism Name { … }`, found `mechansim`";
    mechanism mechanism_without_a_name: "pub mechanism «{» body crank {} }" => "expected the name of the mechanism, found `{`";
    mechanism mechanism_without_items: "pub mechanism Crank«;»" => "expected `{` and the items of the mechanism, found `;`";
    mechanism nothing_follows: "#[equations_only] mechanism Crank { body crank {} joint a = { crank.x == 0; } } «mechanism» Rocker {}" => "nothing may follow the mechanism\nhelp: write one `mechanism!` for each mechanism";
    mechanism option_is_unknown: "#[«equation_only»] mechanism Crank { body crank {} }" => "`#[equation_only]` is not known here\nhelp: doc comments may stand before any item, `#[equations_only]`, `#[integrated]`, `#[closure(…)]`, `#[allow(far_start)]`, `#[picture]`, `#[serde]`, `#[outputs]` and `#[points]` before `mechanism`, `#[velocity]` before `joint` and `drive`";
    mechanism option_twice: "#[serde] #[serde(default)] #[«serde»] mechanism Crank { body crank {} }" => "`#[serde]` stands here twice\nhelp: take one of them away";
    item remainder_of_an_angle: "output q = «(1rad_s * t) % 360deg»;" => "`%` takes whole numbers, as in an index\nhelp: `wrap(angle)` is an angle without its whole turns, from -180° to 180°";
    item remainder_by_a_turn: "output q = «crank.angle % (2 * pi)»;" => "`%` takes whole numbers, as in an index\nhelp: `wrap(angle)` is an angle without its whole turns, from -180° to 180°";
    item joint_as_a_drive: "drive knee = «revolute»(crank.A, ram.B);" => "`revolute` is a joint, and no argument of it can follow a law\nhelp: write `joint knee = revolute(…);`";
    item decimal_comma_in_a_point: "body b { point P = «(60,5mm, 0mm)»; }" => "a vector in the plane has 2 components, found 3\nhelp: write a decimal point, `60.5mm`";
    item comment_of_another_language: "«#» the slider\noutput q = crank.x;" => "`#` begins an attribute, such as `#[picture]`\nhelp: a comment begins with `//`";
    item comma_after_an_item: "let far = 3mm«,» output q = crank.x + far;" => "expected `;`, found `,`\nhelp: `;` ends each item, `,` stands between arguments";
    item comma_between_points: "body b { point P = (0mm, 0mm)«,» point Q = (1mm, 0mm); }" => "expected `;`, found `,`\nhelp: `;` ends each item, `,` stands between arguments";
    item decimal_comma: "let far = 60«,»5mm;" => "expected `;`, found `,`\nhelp: write a decimal point, as in `60.5mm`";
    item output_without_a_name: "output «crank.A.x»;" => "an output has a name of its own\nhelp: write `output name = crank.A.x;`";
    item output_of_an_expression_without_a_name: "output «2 * crank.x»;" => "an output has a name of its own\nhelp: write `output name = 2 * crank.x;`";
    item output_with_a_dimension: "output q: «Angle» = crank.angle;" => "an output has the dimension of its value\nhelp: write `output q = …;`";
    item two_conditions: "let a = if length > 1mm «&»& speed > 1rpm { 1mm } else { 2mm };" => "a choice has one condition\nhelp: choose twice, as in `if a < b { if c < d { x } else { y } } else { y }`";
    item choice_of_another_language: "let a = length «>» 1mm ? 1mm : 2mm;" => "a comparison is no value\nhelp: write `if a < b { x } else { y }` for a choice";
    item semicolon_after_a_body: "body b { }«;»" => "this `;` ends nothing\nhelp: take it away";
    item drive_without_its_keyword: "«drive_angle»(crank, speed * t);" => "a drive has a name of its own\nhelp: write `drive name = drive_angle(…);`";
    item joint_without_its_keyword: "«revolute»(crank.A, ram.B);" => "a joint has a name of its own\nhelp: write `joint name = revolute(…);`";
    item force_without_its_keyword: "«spring» tie = (crank.A, ram.B);" => "a force has a name of its own\nhelp: write `force name = spring(…);`";
    item point_without_its_keyword: "body b { «B» = (1mm, 2mm); }" => "`B` is no item of a body\nhelp: write `point B = (…);` for a point";
    item point_like_a_field: "body b { «B»: (1mm, 2mm); }" => "`B` is no item of a body\nhelp: write `point B = (…);` for a point";
    item force_without_parentheses: "force f = { at crank.A: «-100N», 0N; }" => "the coordinates of a force stand in parentheses\nhelp: write `(-100N, 0N)`";
    item unit_raised_to_a_power: "let a = «3m_s»^2;" => "`3m_s^2` raises the number with its unit to a power\nhelp: the unit is `3m_s2`; a square is `(3m_s)^2`";
    item constant_of_rust: "drive a = drive_angle(ram, «std::f64::consts::PI» * 1rad);" => "`std::f64::consts::PI` is a constant of Rust\nhelp: write `pi`";
    item body_misspelt: "«bodie» b { }" => "`bodie` is no item of a mechanism\nhelp: did you mean `body`?\nnote: items are `param`, `input`, `let`, `ground`, `body`, `joint`, `drive`, `freedom`, `force`, `energy`, `gravity`, `start`, `output`, `range`, `part`, `for`, `component`, `function` and `use`";
    item operator_missing_after_a_unit: "drive second = drive_angle(crank, «60rpm t»);" => "an operator is missing between `60rpm` and `t`\nhelp: write `60rpm * t`";
    item unit_apart_after_an_exponent: "param width: Length = «1e-3 m»;" => "a unit stands right behind its number\nhelp: write `1e-3m`";
    item unit_apart: "param stiffness: Torque = «5N m»;" => "a unit stands right behind its number\nhelp: write `5Nm`";
    item starts_in_a_block: "start «{» crank.angle = 30deg; }" => "expected a value of a joint, such as `hinge.angle`, found `{`\nhelp: write `start angle = …;` in the body, or `start hinge.angle = …;` for a joint in space";
    item point_as_a_call: "body b { point P«(»1m, 0m); }" => "expected `=`, found `(`\nhelp: write `point P = (…);` for a point, `function f(x: Angle) -> Length = …;` for a function";
    item braces_without_equal_sign: "joint a «{» crank.x == 0; }" => "expected `=` before the braces, found `{`";
    item arguments_in_braces: "joint a = revolute «{» ground.O, crank.O };" => "expected `(` and the arguments, found `{`\nhelp: arguments stand in parentheses";
    item drive_of_an_angle: "drive «crank.angle» = 1rad_s * t;" => "a drive has a name of its own\nhelp: write `drive name = { crank.angle == …; }`";
    item drive_of_a_place: "drive «ram.B.x» = 1m_s * t;" => "a drive has a name of its own\nhelp: write `drive name = { ram.B.x == …; }`";
    item choice_as_in_c: "drive d = drive_angle(crank, t «<» 1s ? 1rad : 2rad);" => "a comparison is no value\nhelp: write `if a < b { x } else { y }` for a choice";
    item angle_at_a_time: "output b = crank.«angle»(t);" => "`angle` is a value, not a method\nhelp: write `.angle` without parentheses, for its value at t";
    item energy_without_a_name: "energy «=» 3;" => "expected the name of the energy, found `=`\nhelp: write `energy name = …`";
    item force_without_any_name: "force «=» { on crank: 5Nm; };" => "expected the name of the force, found `=`\nhelp: write `force name = …`";
    item freedom_without_any_name: "freedom «=» crank.angle;" => "expected the name of the freedom, found `=`\nhelp: write `freedom name = …`";
    item function_without_argument: "function f «=» 3mm;" => "expected `(argument: Dimension)`, found `=`\nhelp: write `function name(x: Angle) -> Length = …;`, or `let name = …;` for a value without an argument";
    item force_before_its_point: "force pull = «(0N, -5N)» at crank.A;" => "a force stands after its point, a torque after its body\nhelp: write `force pull = { at crank.A: (0N, -5N); }`";
    item torque_before_its_body: "force pull = «5Nm» on crank;" => "a force stands after its point, a torque after its body\nhelp: write `force pull = { on crank: 5Nm; }`";
    item output_with_velocity: "output b = crank.A with «velocity»;" => "expected `jerk` after `with`, found `velocity`\nhelp: an output has its rate and its acceleration already: write it without `with`";
    item choice_with_then: "output b = if length < 1 «then» 1 else 2;" => "expected `{ value }`, found `then`\nhelp: write `if a < b { x } else { y }`";
    item function_in_braces: "function f(x: Angle) -> Length «{» 2mm * x }" => "expected `=`, found `{`\nhelp: a value stands behind `=`, without braces";
    item output_with_jerks: "output b = crank.A with «jerks»;" => "expected `jerk` after `with`, found `jerks`\nhelp: did you mean `jerk`?";
    item parameter_without_dimension: "param a«;»" => "expected `:` and a dimension such as `Length`, found `;`\nhelp: write the dimension behind the name, as in `name: Length = …;`";
    item start_of_a_body_in_braces: "body b { start «{» angle = 10deg; } }" => "expected `x`, `y`, `angle` or `position`, found `{`\nhelp: say of which coordinate, as in `start x = 200mm;` or `start position = (200mm, 0mm);`";
}

/// Deeper than realistic, but not deep enough to exhaust the stack.
#[test]
fn nesting_has_a_limit() {
    let words = "this is nested more than 50 deep\nhelp: name parts of it with `let`";
    crate::item(&format!("output b = {}«(»{}1{}){};", "(".repeat(50), "(".repeat(30), ")".repeat(30), ")".repeat(50)), words);
    let words = "this is nested more than 250 deep\nhelp: name parts of it with `let`";
    crate::item(&format!("output b = {}«(»{}1{}){};", "(".repeat(249), "(".repeat(30), ")".repeat(30), ")".repeat(249)), words);
}

/// A chain of names used before their declaration.
#[test]
fn chains_have_a_limit() {
    let chain: Vec<String> = (0..150).map(|link| format!("let a{link} = a{} + 1;", link + 1)).collect();
    crate::item(&format!("{} let a150 = 1 + «nothing»;", chain.join("\n")), "nothing is called `nothing` here");
    let chain: Vec<String> = (0..1000).map(|link| format!("let a{link} = a{} + 1;", link + 1)).collect();
    let text = chain.join("\n").replace("a201 + 1", "«a201 + 1»");
    crate::item(
        &format!("{text} let a1000 = 1;"),
        "this is used before it is declared, and so is what it is made of, more than 400 steps deep\nhelp: declare first what others are made of",
    );
}
