//! Inputs where nothing changes with time, beside slices and freedoms, and names that they take.

use crate::refusals;

refusals! {
    item input_in_a_point:
        "input way: Length; body b { point P = («way», 0mm); }"
        => "a point or an axis does not change with time: the input `way` cannot be used in it";
    item input_in_a_joint:
        "input theta: Angle; joint j = absolute_angle(crank, 2 * «theta»);"
        => "a joint does not change with time, the input `theta` is for drives\nhelp: write `drive j = …;` for `joint j = …;`";
    item input_in_a_joint_by_way_of_a_let:
        "input theta: Angle; let twice = 2 * theta; joint j = absolute_angle(crank, «twice»);"
        => "a joint does not change with time, the input `theta` is for drives\nhelp: write `drive j = …;` for `joint j = …;`";
    item element_of_an_array_in_a_joint:
        "for i in 0..2 { input q[i]: Angle; } joint j = absolute_angle(crank, «q»[1]);"
        => "a joint does not change with time, the input `q` is for drives\nhelp: write `drive j = …;` for `joint j = …;`";
    item input_in_a_component:
        "component Leg(P: Point) { input «knee»: Angle; body b { } joint j = revolute(P, b.position); }"
        => "`input` stands in the mechanism itself, not in a component\nhelp: move it out";
    item body_called_inputs:
        "input theta: Angle; body «inputs» { }"
        => "the inputs of a mechanism are its field `inputs`\nhelp: choose another name";
    item component_called_inputs:
        "input theta: Angle; component «Inputs»(P: Point) { body b { } joint j = revolute(P, b.position); } part p = Inputs(ground.O);"
        => "a component cannot be called `Inputs`: a generated type would have that name\nhelp: choose another name";
    item input_without_a_dimension:
        "input theta«;»"
        => "expected `:` and a dimension such as `Length`, found `;`\nhelp: write the dimension behind the name, as in `name: Length = …;`";
    item input_of_another_dimension:
        "input way: Length; drive d = drive_angle(crank, «way»);"
        => "`C` of `drive_angle` is an angle (rad), found a length (m)";
    item start_out_of_bounds:
        "input theta: Angle = «40deg» in 0deg..=30deg;"
        => "the default, 40 deg, does not lie in 0 deg ..= 30 deg\nhelp: widen the range, or take a default within";
    mechanism slice_beside_an_input:
        "mechanism Crank {
            input theta: Angle;
            body crank { point A = (100mm, 0mm); }
            joint hinge = revolute(ground.position, crank.position);
            drive d = drive_angle(crank, theta);
            slice output «tip» = crank.A;
        }"
        => "`tip` cannot be solved for alone: what the input `theta` was is kept in whole states\nhelp: write `output` for `slice output`";
}

#[test]
fn a_drive_by_an_input_closes_at_its_start_only() {
    let source = |start: &str| {
        format!(
            "mechanism Rocker {{
                input theta: Angle = {start};
                ground {{ point C = (400mm, 0mm); }}
                body arm {{ point A = (300mm, 0mm); }}
                body coupler {{ point B = (100mm, 0mm); }}
                body rocker {{ point B = (350mm, 0mm);  start angle = 110deg; }}
                joint o = revolute(ground.position, arm.position);
                joint a = revolute(arm.A, coupler.position);
                joint b = revolute(coupler.B, rocker.B);
                joint c = revolute(rocker.position, ground.C);
                drive d = drive_angle(arm, theta);
            }}"
        )
    };
    let compiled = |start: &str| reuleaux_compiler::compile(source(start).parse().expect("the source consists of tokens"));
    assert!(compiled("60deg").is_ok());
    let refusals = compiled("10deg").expect_err("the arm is too low for the loop to close");
    assert!(refusals[0].fact.to_string().contains("open by"), "{}", refusals[0].fact);
}
