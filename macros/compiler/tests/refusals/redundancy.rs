//! Equations that follow from others or contradict them, by numbers.

/// A parallelogram with a third crank at C, R its place on the rod; what is held twice is to come.
macro_rules! third_crank {
    ($rest:literal) => {
        concat!(
            "mechanism P { param middle: Length = 500mm;
                ground { point A = (0m, 0m); point B = (2m, 0m); point C = (1m, 0m); }
                body crank { point P = (500mm, 0mm); } body rod { point Q = (2m, 0m); point R = (1m, 0m); }
                body rocker { point P = (500mm, 0mm); } body third { point P = (middle, 0mm); point S = (501mm, 0mm); }
                joint a = revolute(ground.A, crank.position); joint b = revolute(ground.B, rocker.position);
                joint c = revolute(crank.P, rod.position); joint d = revolute(rod.Q, rocker.P);
                joint e = revolute(ground.C, third.position);",
            $rest,
            "}"
        )
    };
}

/// A slider-crank with one more item.
macro_rules! slider_crank {
    ($rest:literal) => {
        concat!(
            "mechanism S {
                ground { axis u = (1, 0); axis v = (1, 1mrad / 1rad); point P = (0m, 0m); point Q = (0m, 300mm); point R = (0m, 310mm); }
                body crank { point A = (1m, 0m); point E = (1m, 10mm); } body rod { point B = (2m, 0m); point C = (2m, 0m); point D = (1m, 0m); }
                body slider { point Q = (0m, 300mm); }
                joint o = revolute(ground.P, crank.position); joint a = revolute(crank.A, rod.position);
                joint b = revolute(rod.B, slider.position); joint g = translational(ground.u, ground.P, slider.position);
                drive i = drive_angle(crank, 1rad_s * t + 1rad);",
            $rest,
            "}"
        )
    };
}

/// Refused in these words, under the word between the marks.
macro_rules! refused {
    ($($frame:ident $name:ident: $source:literal => $words:literal;)*) => {
        $(#[test] fn $name() { crate::mechanism($frame!($source), $words); })*
    };
}

refused! {
    third_crank a_third_crank_holds_once_too_often: "joint «f» = revolute(rod.R, third.P); drive i = drive_angle(crank, 60deg + 1rad_s * t);" => "1 of the 2 equations of `f` adds nothing: it follows from `a`, `b`, `c`, `d` and `e` in every position\nhelp: write `redundant joint` for `joint`: what is needed of it is solved, the rest is checked";
    third_crank a_third_crank_instead_of_a_drive: "joint «f» = revolute(rod.R, third.P);" => "1 of the 2 equations of `f` adds nothing: it follows from `a`, `b`, `c`, `d` and `e` in every position\nnote: `crank.angle`, `rocker.angle` and `third.angle` remain free\nhelp: let it hold or drive one of them instead";
    third_crank a_third_crank_of_another_length: "joint «f» = revolute(rod.R, third.S); drive i = drive_angle(crank, 60deg + 1rad_s * t);" => "`f` contradicts the other joints: with all of them closed it is 1 mm off\nnote: it joins `rod` and `third`\nhelp: what is held twice must fit: change a measure, or take it away";
    third_crank a_redundant_crank_of_another_length: "redundant joint «f» = revolute(rod.R, third.S); drive i = drive_angle(crank, 60deg + 1rad_s * t);" => "`f` contradicts the other joints: with all of them closed it is 1 mm off\nnote: it joins `rod` and `third`\nhelp: a redundant joint must fit as well: change a measure, or take it away";
    third_crank a_rod_between_cranks_that_turn_alike: "redundant joint f = revolute(rod.R, third.P); drive i = drive_angle(crank, 60deg + 1rad_s * t); joint «g» = distance(crank.P, rocker.P, 2m);" => "`g` adds nothing: its equation follows from `c` and `d` in every position\nhelp: take it away, or write `redundant joint` for `joint` to keep it as a check";
    slider_crank a_doubled_hinge: "joint «c» = revolute(slider.position, rod.C);" => "`c` demands the same as `b`\nhelp: take one of them away";
    slider_crank a_doubled_hinge_as_equations: "joint «c» = { slider.x == rod.C.x; 2 * slider.y == 2 * rod.B.y; }" => "`c` adds nothing: both its equations follow from `b` in every position\nhelp: take it away, or write `redundant joint` for `joint` to keep it as a check";
    slider_crank a_doubled_hinge_elsewhere: "joint «c» = revolute(rod.position, crank.E);" => "`c` contradicts the other joints: with all of them closed it is 10 mm off\nnote: it joins `crank` and `rod`\nhelp: what is held twice must fit: change a measure, or take it away";
    slider_crank a_loop_closed_twice: "joint «c» = distance(crank.A, slider.position, 2m);" => "`c` adds nothing: its equation follows from `a` and `b` in every position\nhelp: take it away, or write `redundant joint` for `joint` to keep it as a check";
    slider_crank a_driven_slider_with_two_guides: "joint «h» = translational(ground.u, ground.Q, slider.Q);" => "`h` adds nothing: both its equations follow from `g` in every position\nhelp: take it away, or write `redundant joint` for `joint` to keep it as a check";
    slider_crank a_second_guide_beside_the_first: "joint «h» = translational(ground.u, ground.R, slider.Q);" => "`h` contradicts the other joints: with all of them closed it is 10 mm off\nhelp: what is held twice must fit: change a measure, or take it away";
    slider_crank a_second_guide_askew: "joint «h» = translational(ground.u, ground.Q, slider.Q, 5deg);" => "`h` contradicts the other joints: with all of them closed it is 5° off\nhelp: what is held twice must fit: change a measure, or take it away";
    slider_crank two_equal_constraints: "joint «h» = { 2 * slider.angle == 0; }" => "`h` adds nothing: its equation follows from `g` in every position\nhelp: take it away, or write `redundant joint` for `joint` to keep it as a check";
    slider_crank a_joint_that_is_needed: "body pin {} redundant joint «p» = revolute(rod.D, pin.position); joint q = parallel(rod, pin);" => "`p` is not redundant: none of its equations follows from others\nnote: without it `pin.x` and `pin.y` are free\nhelp: write `joint` for `redundant joint`";
    slider_crank a_redundant_drive: "redundant «drive» h = drive_angle(rod, 0);" => "expected `joint`: only a joint can be redundant, found `drive`";
}

crate::refusals! {
    mechanism sliders_in_a_ring: "mechanism S { body one { axis u = (1, 0); } body two {} joint a = translational((1, 0), ground.position, one.position); joint b = translational(one.u, one.position, two.position); joint «c» = point_on_line(ground.position, (1, 0), two.position); drive i = drive_x(one.position, 100mm * sin(1rad_s * t)); }" => "`c` adds nothing: its equation follows from `a` and `b` in every position\nnote: `two.x` remains free\nhelp: let it hold or drive it instead";
    mechanism angles_round_a_loop: "mechanism S { body one { axis u = (1, 0); } body two {} joint a = revolute(ground.position, one.position); joint b = revolute(one.position, two.position); joint c = parallel(one, two); joint «d» = { sin(one.angle) * cos(two.angle) == cos(one.angle) * sin(two.angle); } }" => "`d` adds nothing: its equation follows from `c` in every position\nnote: `one.angle` and `two.angle` remain free\nhelp: let it hold or drive one of them instead";
    mechanism a_drive_on_what_is_locked: "mechanism L { ground { point C = (2m, 0m); } body crank { point A = (500mm, 0mm); start angle = 60deg; } body rod { point B = (2m, 0m); } body rocker { point B = (500mm, 0mm); } joint a = revolute(ground.position, crank.position); joint b = revolute(crank.A, rod.position); joint c = revolute(rod.B, rocker.B); joint d = revolute(ground.C, rocker.position); drive «two» = drive_angle(rod, 0deg * (t / 1s)); }" => "`two` adds nothing: its equation follows from `a`, `b`, `c` and `d` in every position\nnote: `crank.angle` and `rocker.angle` remain free\nhelp: let it hold or drive one of them instead";
}

fn accepted(source: &str) -> reuleaux_compiler::Compiled {
    reuleaux_compiler::compile(source.parse().expect("tokens")).expect("nothing is wrong")
}

/// The equations that are checked, by joint and number.
fn checked(source: &str) -> Vec<String> {
    let compiled = accepted(source);
    let name = |equation: &usize| {
        let equation = &compiled.system.equations[*equation];
        format!("{}.{}", compiled.model.joints[equation.joint].name, equation.row + 1)
    };
    compiled.structure.checked.iter().map(name).collect()
}

/// With y of the pin the third crank would be singular where it stands upright, with x only where the parallelogram is.
#[test]
fn what_is_solved_is_what_is_least_often_singular() {
    let drive = "redundant joint f = revolute(rod.R, third.P); drive i = drive_angle(crank, 60deg + 1rad_s * t);";
    assert_eq!(checked(&third_crank!("").replace("third.position);}", &format!("third.position);{drive}}}"))), ["f.2"]);
}

#[test]
fn a_redundant_joint_may_be_checked_as_a_whole() {
    assert_eq!(checked(slider_crank!("redundant joint h = translational(ground.u, ground.Q, slider.Q);")), ["h.1", "h.2"]);
    assert_eq!(checked(slider_crank!("redundant joint c = revolute(slider.position, rod.B);")), ["c.1", "c.2"]);
    assert_eq!(checked(slider_crank!("redundant joint c = distance(crank.A, slider.position, 2m);")), ["c.1"]);
}

/// Two joints of which either would do.
#[test]
fn of_two_redundant_joints_one_is_kept() {
    let source = "mechanism S { body plate { point R = (1m, 0m); } joint a = revolute((0m, 0m), plate.position);
        redundant joint b = absolute_y(plate.R, 0mm); redundant joint c = absolute_angle(plate, 0); }";
    assert_eq!(checked(source).len(), 1);
}

#[test]
fn what_is_singular_in_one_position_only_is_not_redundant() {
    let change_point = "redundant joint f = revolute(rod.R, third.P); drive i = drive_angle(crank, 1rad_s * t);";
    assert_eq!(checked(&third_crank!("").replace("third.position);}", &format!("third.position);{change_point}}}"))).len(), 1);
}
