//! Redundant and contradictory equations, found numerically.

use reuleaux_compiler::diag::{Fact, SystemFact};

/// A parallelogram with a third crank at C, whose end belongs at R on the rod; `$rest` adds the redundant joint.
macro_rules! third_crank {
    ($rest:literal) => {
        concat!(
            "mechanism P { param middle: Length = 500mm;
                ground { point A = (0m, 0m); point B = (2m, 0m); point C = (1m, 0m); }
                body crank { point P = (500mm, 0mm); } body rod { point Q = (2m, 0m); point R = (1m, 0m); }
                body rocker { point P = (500mm, 0mm); } body third { point P = (middle, 0mm); point S = (501mm, 0mm); point T = (499mm, 0mm); }
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

/// Refused with these words, at the marked token.
macro_rules! refused {
    ($($frame:ident $name:ident: $source:literal => $words:literal;)*) => {
        $(#[test] fn $name() { crate::mechanism($frame!($source), $words); })*
    };
}

refused! {
    third_crank a_third_crank_holds_once_too_often: "joint «f» = revolute(rod.R, third.P); drive i = drive_angle(crank, 60deg + 1rad_s * t);" => "1 of the 2 equations of `f` adds nothing: it follows from `a`, `b`, `c`, `d` and `e` in every position tried\nhelp: write `redundant joint` for `joint`: what is needed of it is solved, the rest is checked";
    third_crank a_third_crank_instead_of_a_drive: "joint «f» = revolute(rod.R, third.P);" => "1 of the 2 equations of `f` adds nothing: it follows from `a`, `b`, `c`, `d` and `e` in every position tried\nnote: `crank.angle`, `rocker.angle` and `third.angle` remain free\nhelp: let it hold or drive one of them instead";
    third_crank a_third_crank_of_another_length: "joint «f» = revolute(rod.R, third.S); drive i = drive_angle(crank, 60deg + 1rad_s * t);" => "`f` contradicts the other joints: with all of them closed it is 1 mm off\nnote: it joins `rod` and `third`\nhelp: what is held twice must fit: change a measure, or take it away";
    third_crank a_third_crank_that_is_shorter: "joint «f» = revolute(rod.R, third.T); drive i = drive_angle(crank, 60deg + 1rad_s * t);" => "`f` contradicts the other joints: with all of them closed it is 1 mm off\nnote: it joins `rod` and `third`\nhelp: what is held twice must fit: change a measure, or take it away";
    third_crank a_redundant_crank_of_another_length: "redundant joint «f» = revolute(rod.R, third.S); drive i = drive_angle(crank, 60deg + 1rad_s * t);" => "`f` contradicts the other joints: with all of them closed it is 1 mm off\nnote: it joins `rod` and `third`\nhelp: a redundant joint must fit as well: change a measure, or take it away";
    third_crank a_rod_between_cranks_that_turn_alike: "redundant joint f = revolute(rod.R, third.P); drive i = drive_angle(crank, 60deg + 1rad_s * t); joint «g» = distance(crank.P, rocker.P, 2m);" => "`g` adds nothing: its equation follows from `c` and `d` in every position tried\nhelp: take it away, or write `redundant joint` for `joint` to keep it as a check";
    slider_crank a_doubled_hinge: "joint «c» = revolute(slider.position, rod.C);" => "`c` demands the same as `b`\nhelp: take one of them away";
    slider_crank a_doubled_hinge_as_equations: "joint «c» = { slider.x == rod.C.x; 2 * slider.y == 2 * rod.B.y; }" => "`c` adds nothing: `b` says the same\nhelp: take `c` away, or write `redundant joint` for `joint` to keep it as a check";
    slider_crank a_doubled_hinge_elsewhere: "joint «c» = revolute(rod.position, crank.E);" => "`c` contradicts the other joints: with all of them closed it is 10 mm off\nnote: it joins `crank` and `rod`\nhelp: what is held twice must fit: change a measure, or take it away";
    slider_crank a_loop_closed_twice: "joint «c» = distance(crank.A, slider.position, 2m);" => "`c` adds nothing: its equation follows from `a` and `b` in every position tried\nhelp: take it away, or write `redundant joint` for `joint` to keep it as a check";
    slider_crank a_driven_slider_with_two_guides: "joint «h» = translational(ground.u, ground.Q, slider.Q);" => "`h` adds nothing: both its equations follow from `g` in every position tried\nhelp: take it away, or write `redundant joint` for `joint` to keep it as a check";
    slider_crank a_second_guide_beside_the_first: "joint «h» = translational(ground.u, ground.R, slider.Q);" => "`h` contradicts the other joints: with all of them closed it is 10 mm off\nhelp: what is held twice must fit: change a measure, or take it away";
    slider_crank a_second_guide_askew: "joint «h» = translational(ground.u, ground.Q, slider.Q, 5deg);" => "`h` contradicts `g`: it demands `slider.angle` = 5°, `g` demands 0°\nhelp: take one of them away";
    slider_crank two_equal_constraints: "joint «h» = { 2 * slider.angle == 0; }" => "`h` adds nothing: `g` says the same\nhelp: take `h` away, or write `redundant joint` for `joint` to keep it as a check";
    slider_crank a_joint_that_is_needed: "body pin {} redundant joint «p» = revolute(rod.D, pin.position); joint q = parallel(rod, pin);" => "`p` is not redundant: none of its equations follows from others\nnote: without it `pin.x` and `pin.y` are free\nhelp: write `joint` for `redundant joint`";
    slider_crank a_redundant_drive: "redundant «drive» h = drive_angle(rod, 0);" => "expected `joint`: only a joint can be redundant, found `drive`";
}

crate::refusals! {
    mechanism a_distance_between_points_that_coincide: "mechanism Two { body a { point E = (100mm, 0mm); } body b { point E = (80mm, 0mm); } joint o = revolute((0mm, 0mm), a.position); joint e = weld(a.E, b.E); joint «stiff» = distance(a.E, b.E, 10mm); drive m = drive_angle(a, 1rad_s * t); }" => "`stiff` contradicts the other joints: with all of them closed it is 10 mm off\nnote: it joins `a` and `b`\nhelp: what is held twice must fit: change a measure, or take it away";
    mechanism sliders_in_a_ring: "mechanism S { body one { axis u = (1, 0); } body two {} joint a = translational((1, 0), ground.position, one.position); joint b = translational(one.u, one.position, two.position); joint «c» = point_on_line(ground.position, (1, 0), two.position); drive i = drive_x(one.position, 100mm * sin(1rad_s * t)); }" => "`c` adds nothing: its equation follows from `a` and `b` in every position tried\nnote: `two.x` remains free\nhelp: let it hold or drive it instead";
    mechanism angles_round_a_loop: "mechanism S { body one { axis u = (1, 0); } body two {} joint a = revolute(ground.position, one.position); joint b = revolute(one.position, two.position); joint c = parallel(one, two); joint «d» = { sin(one.angle) * cos(two.angle) == cos(one.angle) * sin(two.angle); } }" => "`d` adds nothing: its equation follows from `c` in every position tried\nnote: `one.angle` and `two.angle` remain free\nhelp: let it hold or drive one of them instead";
    mechanism a_redundant_guide_that_holds_at_the_start_only: "mechanism W { ground { point far = (3m, 0m); } body crank { point P = (100mm, 0mm); } joint o = revolute(ground.position, crank.position); redundant joint «r» = absolute_y(crank.P, 100mm); drive m = drive_angle(crank, 90deg + 1rad_s * t); }" => "`r` contradicts the other joints: with all of them closed it is, at t = 0.05 s, 0.125 mm off\nhelp: a redundant joint must fit as well: change a measure, or take it away";
    mechanism an_angle_prescribed_twice: "mechanism D { body one {} body two {} joint o = revolute(ground.position, one.position); joint p = revolute(one.position, two.position); joint r = relative_angle(one, two, 30deg); joint «s» = relative_angle(one, two, 40deg); drive i = drive_angle(one, 1rad_s * t); }" => "`s` contradicts `r`: it demands `two.angle - one.angle` = 40°, `r` demands 30°\nhelp: take one of them away";
    mechanism gears_in_a_ring: "mechanism G { body a {} body b {} body c {} joint ra = revolute(ground.position, a.position); joint rb = revolute((1m, 0m), b.position); joint rc = revolute((2m, 0m), c.position); joint g = gear_pair(a, b, 20, 40); joint h = gear_pair(b, c, 40, 20); joint «k» = gear_pair(a, c, 20, -20); drive i = drive_angle(a, 1rad_s * t); }" => "`k` adds nothing: `g` and `h` say the same\nhelp: take `k` away, or write `redundant joint` for `joint` to keep it as a check";
    mechanism involute_gears_in_a_ring: "mechanism G { body a {} body b {} body c {} body d {} joint ra = revolute(ground.position, a.position); joint rb = revolute((2m, 0m), b.position); joint rc = revolute((2m, 2m), c.position); joint rd = revolute((0m, 2m), d.position); joint e = involute_mesh(a.position, b.position, 1m, 1m, 0deg); joint f = involute_mesh(b.position, c.position, 1m, 1m, 90deg); joint g = involute_mesh(c.position, d.position, 1m, 1m, 180deg); joint «h» = involute_mesh(d.position, a.position, 1m, 1m, -90deg); drive i = drive_angle(a, 1rad_s * t); }" => "`h` adds nothing: its equation follows from `ra`, `rb`, `rc`, `rd`, `e`, `f` and 1 more in every position tried\nhelp: take it away, or write `redundant joint` for `joint` to keep it as a check";
    mechanism redundant_gears_that_lock: "mechanism G { body a {} body b {} body c {} joint ra = revolute(ground.position, a.position); joint rb = revolute((1m, 0m), b.position); joint rc = revolute((2m, 0m), c.position); joint g = gear_pair(a, b, 20, 40); joint h = gear_pair(b, c, 40, 20); redundant joint «k» = gear_pair(a, c, 20, 20); drive i = drive_angle(a, 1rad_s * t); }" => "`k` contradicts the other joints: with all of them closed it is, at t = 0.05 s, 5.73° off\nnote: it joins `a` and `c`\nhelp: a redundant joint must fit as well: change a measure, or take it away";
    mechanism a_drive_of_a_length_that_is_fixed: "mechanism R { body arm { point P = (1m, 0m); start angle = 30deg; } joint o = revolute(ground.position, arm.position); drive «m» = drive_distance(ground.position, arm.P, 1m + 1mm_s * t); }" => "`m` has nothing to drive: `o` holds already what it would move\nhelp: `arm.angle` is left free: drive that instead";
    mechanism a_drive_of_what_stays_level: "mechanism L { ground { point C = (2m, 0m); } body crank { point A = (500mm, 0mm); start angle = 60deg; } body rod { point B = (2m, 0m); } body rocker { point B = (500mm, 0mm); start angle = 60deg; } joint a = revolute(ground.position, crank.position); joint b = revolute(crank.A, rod.position); joint c = revolute(rod.B, rocker.B); joint d = revolute(ground.C, rocker.position); drive «m» = drive_angle(rod, 1rad_s * t); }" => "`m` has nothing to drive: `a`, `b`, `c` and `d` hold already what it would move\nhelp: `crank.angle` and `rocker.angle` are left free: drive one of them instead";
    mechanism a_structure_held_once_more: "mechanism A7 {  ground{point C=(400mm,0mm); point D=(200mm,-100mm);} body crank{point A=(100mm,0mm); start angle=60deg;} body coupler{point B=(350mm,0mm); point M=(170mm,0mm); point N=(100mm,0mm);} body rocker{point B=(300mm,0mm); start angle=70deg;} body s1{point P=(240mm,0mm);start angle=90deg;} body s2{point P=(250mm,0mm);start angle=90deg;} joint o=revolute(ground.position,crank.position); joint a=revolute(crank.A,coupler.position); joint b=revolute(coupler.B,rocker.B); joint c=revolute(rocker.position,ground.C); joint d=revolute(ground.D,s1.position); joint e=revolute(s1.P,coupler.M); joint f=revolute(ground.D,s2.position); joint «g»=revolute(s2.P,coupler.N); }" => "`g` contradicts the other joints: with all of them closed it is 2.47 mm off\nnote: it joins `coupler` and `s2`\nhelp: what is held twice must fit: change a measure, or take it away";
    mechanism a_redundant_distance_too_long_by_a_hair: "mechanism R { body arm { point P = (100mm, 0mm); } joint o = revolute(ground.position, arm.position); redundant joint «d» = distance(ground.position, arm.P, 100.00001mm); drive i = drive_angle(arm, 1rad_s * t); }" => "`d` contradicts the other joints: with all of them closed it is 0.00001 mm off\nhelp: a redundant joint must fit as well: change a measure, or take it away";
    // All hinges meet in one point: the axes b and c come to within 90° − 3 atan(0.1) = 72.87° of each other.
    mechanism a_spherical_loop_that_stays_open: "mechanism S in space { ground { axis a = (1, 0, 0) from (0, 1, 0); axis d = (0, 1, 0) from (0, 0, 1); } body crank { axis a = (1, 0, 0) from (0, 1, 0); axis b = (1, 0.1, 0) from (0, 0, 1); } body coupler { axis b = (1, 0, 0) from (0, 0, 1); axis c = (1, 0.1, 0) from (0, 0, 1); } body rocker { axis c = (1, 0, 0) from (0, 0, 1); axis d = (1, 0.1, 0) from (0, 0, 1); } joint o = revolute(ground.position, ground.a, crank.position, crank.a); joint a = revolute(crank.position, crank.b, coupler.position, coupler.b); joint c = revolute(ground.position, ground.d, rocker.position, rocker.d); redundant joint «b» = revolute(coupler.position, coupler.c, rocker.position, rocker.c); drive input = drive_rotation(o, 60rpm * t); }" => "`b` contradicts the other joints: with all of them closed it is 72.9° off\nnote: it joins `crank`, `coupler` and `rocker`\nhelp: a redundant joint must fit as well: change a measure, or take it away";
    mechanism redundant_guides_far_away: "mechanism G { ground { axis u = (1, 0); point O = (10000m, 0m); point Q = (10000m, 301mm); } body s { point Q = (0mm, 300mm); } joint g = translational(ground.u, ground.O, s.position); redundant joint «h» = translational(ground.u, ground.Q, s.Q); drive i = drive_x(s.position, 10000m + 100mm * sin(1rad_s * t)); }" => "`h` contradicts the other joints: with all of them closed it is 1 mm off\nhelp: a redundant joint must fit as well: change a measure, or take it away";
    mechanism redundant_gears_that_lock_later: "mechanism G { body a {} body b {} body c {} joint ra = revolute(ground.position, a.position); joint rb = revolute((1m, 0m), b.position); joint rc = revolute((2m, 0m), c.position); joint g = gear_pair(a, b, 20, 40); joint h = gear_pair(b, c, 40, 20); redundant joint «k» = gear_pair(a, c, 20, 20); drive i = drive_angle(a, 1rad * polynomial_345((t - 5s) / 1s)); }" => "`k` contradicts the other joints: it fits at the start, but not when the drives move on\nnote: it joins `a` and `c`\nhelp: a redundant joint must fit as well: change a measure, or take it away";
    mechanism drive_inside_of_a_triangle: "mechanism Triangle { body one { point P = (3m, 0m); } body two { point P = (2m, 0m); start angle = 30deg; } body three { point P = (2m, 0m); start angle = 150deg; } joint o = revolute(ground.position, one.position); joint a = revolute(one.position, two.position); joint b = revolute(two.P, three.P); joint c = revolute(one.P, three.position); drive «i» = drive_relative_angle(one, two, 60rpm * t); }" => "`i` has nothing to drive: `a`, `b` and `c` hold already what it would move\nhelp: `one.angle`, `two.angle` and `three.angle` are left free: drive one of them instead";
    mechanism marked_in_a_loop: "mechanism L { for i in 0..3 { body b[i] {} redundant joint «o»[i] = revolute((i * 1m, 0m), b[i].position); drive d[i] = drive_angle(b[i], 1rad_s * t); } }" => "`o[0]` is not redundant: none of its equations follows from others\nnote: without it `b[0].x` and `b[0].y` are free\nhelp: write `joint` for `redundant joint`";
    mechanism a_weld_and_a_hinge: "mechanism W { body a { point P = (1m, 0m); } joint w = weld(ground.position, a.position); joint «h» = revolute((1m, 0.2m), a.P); }" => "`h` contradicts the other joints: with all of them closed it is 200 mm off\nhelp: what is held twice must fit: change a measure, or take it away";
    mechanism a_joint_that_repeats_itself: "mechanism C { body crank {} joint o = revolute(ground.position, crank.position); joint «p» = { crank.angle == 0; 2 * crank.angle == 0; } }" => "1 of the 2 equations of `p` adds nothing: it follows from the rest of it where the mechanism stands\nhelp: say it once";
    mechanism a_drive_on_what_is_locked: "mechanism L { ground { point C = (2m, 0m); } body crank { point A = (500mm, 0mm); start angle = 60deg; } body rod { point B = (2m, 0m); } body rocker { point B = (500mm, 0mm); } joint a = revolute(ground.position, crank.position); joint b = revolute(crank.A, rod.position); joint c = revolute(rod.B, rocker.B); joint d = revolute(ground.C, rocker.position); drive «two» = drive_angle(rod, 0deg * (t / 1s)); }" => "`two` has nothing to drive: `a`, `b`, `c` and `d` hold already what it would move\nhelp: `crank.angle` and `rocker.angle` are left free: drive one of them instead";
}

fn accepted(source: &str) -> reuleaux_compiler::Compiled {
    reuleaux_compiler::compile(source.parse().expect("tokens")).expect("nothing is wrong")
}

/// Checked equations, by joint and number.
fn checked(source: &str) -> Vec<String> {
    let compiled = accepted(source);
    let name = |equation: &usize| {
        let equation = &compiled.system.equations[*equation];
        format!("{}.{}", compiled.model.joints[equation.joint].name, equation.row + 1)
    };
    compiled.structure.checked.iter().map(name).collect()
}

/// With the pin's y equation solved, the third crank would be singular in its upright position; with the x equation, only where the
/// parallelogram is singular too.
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

/// Two redundant joints, one of which suffices.
#[test]
fn of_two_redundant_joints_one_is_kept() {
    let source = "mechanism S { body plate { point R = (1m, 0m); } joint a = revolute((0m, 0m), plate.position);
        redundant joint b = absolute_y(plate.R, 0mm); redundant joint c = absolute_angle(plate, 0); }";
    assert_eq!(checked(source).len(), 1);
}

/// Asserts that a mechanism is not refused for redundancy.
fn is_no_redundancy(source: &str) {
    let refusals = reuleaux_compiler::compile(source.parse().expect("tokens")).err().unwrap_or_default();
    for refusal in refusals {
        assert!(
            !matches!(
                refusal.fact,
                Fact::System(SystemFact::FollowsFrom { .. })
                    | Fact::System(SystemFact::NotRedundant { .. })
                    | Fact::System(SystemFact::CannotHold { .. })
            ),
            "{}",
            refusal.fact
        );
    }
}

/// A parallelogram with its links in line may fold either way: its start is singular, not redundant.
#[test]
fn what_is_singular_in_one_position_only_is_not_redundant() {
    let drive = "drive i = drive_angle(crank, 1rad_s * t);";
    is_no_redundancy(
        &third_crank!("").replace("third.position);}", &format!("third.position); joint f = parallel(crank, third); {drive}}}")),
    );
    let change_point = format!("redundant joint f = revolute(rod.R, third.P); {drive}");
    is_no_redundancy(&third_crank!("").replace("third.position);}", &format!("third.position);{change_point}}}")));
}

/// A four-bar with a strut from ground to the middle of its coupler.
const STRUCTURE: &str = "mechanism Frame { ground { point C = (4m, 0m); point E = (2m, -1m); }
    body crank { point A = (1m, 0m); start angle = 60deg; } body coupler { point B = (3.5m, 0m); point E = (1m, 0m); }
    body rocker { point B = (3m, 0m); start angle = 70deg; } body strut { point F = (2.2m, 0m); start angle = 100deg; }
    joint o = revolute(ground.position, crank.position); joint a = revolute(crank.A, coupler.position);
    joint b = revolute(coupler.B, rocker.B); joint c = revolute(rocker.position, ground.C);
    joint d = revolute(ground.E, strut.position); joint e = revolute(strut.F, coupler.E); more }";

#[test]
fn a_structure_is_no_redundancy_and_its_drive_is_a_matter_of_mobility() {
    assert_eq!(checked(&STRUCTURE.replace("more", "")), [""; 0]);
    for drive in ["1rad_s * t", "60deg", "60deg + 1rad_s * t"] {
        let driven = STRUCTURE.replace("more", &format!("drive i = drive_angle(crank, {drive});"));
        is_no_redundancy(&driven);
        assert!(reuleaux_compiler::compile(driven.parse().expect("tokens")).is_err());
    }
}

/// One strut turns a four-bar into a frame, two over-constrain it: mobility −1, with and without a drive.
#[test]
fn a_frame_that_is_held_too_often_is_a_matter_of_mobility() {
    let frame = STRUCTURE.replace("more", "joint f = distance(ground.C, coupler.E, 2.5m); more");
    for more in ["", "drive i = drive_angle(crank, 1rad_s * t);"] {
        let source = frame.replace("more", more);
        is_no_redundancy(&source);
        assert!(reuleaux_compiler::compile(source.parse().expect("tokens")).is_err());
    }
}

/// Eight links; two of them seem redundant but are not.
#[test]
fn the_cell_of_peaucellier_has_no_joint_too_many() {
    let source =
        "mechanism Peaucellier { ground { point O = (0m, 0m); point Q = (1m, 0m); } body arm { point D = (1m, 0m); start angle = 20deg; }
        body l1 { point A = (3m, 0m); start angle = 40deg; } body l2 { point C = (3m, 0m); start angle = 0deg; }
        body s1 { point D = (1.5m, 0m); } body s2 { point D = (1.5m, 0m); }
        body s3 { point P = (1.5m, 0m); start angle = -20deg; } body s4 { point P = (1.5m, 0m); start angle = 50deg; }
        joint q = revolute(ground.Q, arm.position); joint o1 = revolute(ground.O, l1.position); joint o2 = revolute(ground.O, l2.position);
        joint a1 = revolute(l1.A, s1.position); joint d1 = revolute(s1.D, arm.D); joint c1 = revolute(l2.C, s2.position);
        joint d2 = revolute(s2.D, arm.D); joint a2 = revolute(l1.A, s3.position); joint c2 = revolute(l2.C, s4.position);
        joint p = revolute(s3.P, s4.P); drive turn = drive_angle(arm, 20deg + 0.3 * sin(1rad_s * t)); }";
    assert_eq!(checked(source), [""; 0]);
    // Its point P moves on a straight line, so that a slide on this line is redundant.
    let line = source.replace("drive turn", "redundant joint line = absolute_x(s3.P, 3.375m); drive turn");
    assert_eq!(checked(&line), ["line.1"]);
    let curve = source.replace("drive turn", "redundant joint line = absolute_x(s3.P, 3.376m); drive turn");
    assert!(reuleaux_compiler::compile(curve.parse().expect("tokens")).is_err());
}

/// Duplicated hinges of random four-bars, written differently: each is refused by name, or kept as a check if declared as redundant.
#[test]
fn every_hinge_that_is_doubled_is_named() {
    let mut seed = 0x9e37_79b9_7f4a_7c15_u64;
    let mut random = |from: f64, to: f64| {
        seed = seed.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
        from + (to - from) * ((seed >> 11) as f64 / (1_u64 << 53) as f64)
    };
    for _ in 0..12 {
        let (crank, rocker, turned) = (random(0.3, 1.0), random(2.2, 3.0), random(-90.0, 90.0));
        let coupler = random(5.2 - rocker, 3.8);
        let hinges =
            [("ground.O", "crank.position"), ("crank.A", "coupler.position"), ("coupler.B", "rocker.B"), ("rocker.position", "ground.C")];
        let four_bar = |last: &str| {
            let [o, a, b, c] = hinges.map(|(one, two)| format!("revolute({one}, {two})"));
            format!(
                "mechanism FourBar {{ ground {{ point O = (0m, 0m); point C = (4 * cos({turned:.3}deg) * 1m, 4 * sin({turned:.3}deg) * 1m); }}
                body crank {{ point A = ({crank:.4}m, 0m); start angle = {turned:.3}deg + 40deg; }} body coupler {{ point B = ({coupler:.4}m, 0m); start angle = {turned:.3}deg; }}
                body rocker {{ point B = ({rocker:.4}m, 0m); start angle = {turned:.3}deg + 100deg; }}
                joint o = {o}; joint a = {a}; joint b = {b}; joint c = {c};
                drive input = drive_angle(crank, {turned:.3}deg + 40deg + 1rad_s * t); {last} }}"
            )
        };
        for (joint, (one, two)) in ["o", "a", "b", "c"].into_iter().zip(hinges) {
            let again = |word: &str| format!("{word} again = {{ 3 * {one}.x == 3 * {two}.x; 2 * {two}.y == 2 * {one}.y; }}");
            let refusals = reuleaux_compiler::compile(four_bar(&again("joint")).parse().expect("tokens")).expect_err("held twice");
            let said: Vec<String> = refusals.iter().map(|refusal| refusal.fact.to_string()).collect();
            assert_eq!(said.len(), 1, "{said:?}");
            assert!(said[0].starts_with(&format!("`again` adds nothing: `{joint}` says the same")), "{said:?}");
            assert_eq!(checked(&four_bar(&again("redundant joint"))), ["again.1", "again.2"]);
        }
    }
}

/// A row of parallelograms with an additional bar in its middle.
fn row(bars: usize, more: &str) -> String {
    format!(
        "mechanism Row {{ let bars = {bars}; ground {{ for i in 0..=bars {{ point P[i] = (i * 100mm, 0mm); }} }}
        for i in 0..=bars {{ body crank[i] {{ point A = (50mm, 0mm); start angle = 80deg; }} }}
        for i in 0..bars {{ body coupler[i] {{ point B = (100mm, 0mm); }} }}
        for i in 0..=bars {{ joint axle[i] = revolute(ground.P[i], crank[i].position); }}
        for i in 0..bars {{ joint a[i] = revolute(crank[i].A, coupler[i].position); joint b[i] = revolute(coupler[i].B, crank[i + 1].A); }}
        body extra {{ point A = (100mm, 0mm); }} joint e1 = revolute(crank[1].A, extra.position);
        {more} drive motor = drive_angle(crank[0], 80deg + 5deg * sin(1rad_s * t)); }}"
    )
}

/// Small systems are tested as a whole, large ones by subsystem.
#[test]
fn a_bar_too_many_is_found_in_a_row_of_any_length() {
    for bars in [4, 9, 10, 20, 40] {
        assert_eq!(checked(&row(bars, "redundant joint e2 = revolute(extra.A, crank[2].A);")).len(), 1, "{bars} bars");
        let refusals = reuleaux_compiler::compile(row(bars, "joint e2 = revolute(extra.A, crank[2].A);").parse().expect("tokens"));
        let said: Vec<String> = refusals.expect_err("a bar too many").iter().map(|refusal| refusal.fact.to_string()).collect();
        assert_eq!(said.len(), 1, "{said:?}");
        assert!(
            said[0].starts_with("1 of the 2 equations of `e2` adds nothing: it follows from `a[1]`, `b[1]` and `e1`"),
            "{bars} bars: {said:?}"
        );
    }
}

/// A misfit is reported as the distance that a body must move, not as the residual of an equation.
#[test]
fn what_is_off_is_told_in_millimetres() {
    let ties =
        ["distance(crank.A, rocker.B, 340mm)", "{ norm(crank.A - rocker.B) == 340mm; }", "{ 3 * norm(crank.A - rocker.B) == 1020mm; }"];
    for tie in ties {
        let source = format!(
            "mechanism F {{ ground {{ point O = (0mm, 0mm); point C = (400mm, 0mm); }} body crank {{ point A = (100mm, 0mm); }}
            body coupler {{ point B = (350mm, 0mm); }} body rocker {{ point B = (300mm, 0mm); start angle = 70deg; }}
            joint o = revolute(ground.O, crank.position); joint a = revolute(crank.A, coupler.position);
            joint b = revolute(coupler.B, rocker.B); joint c = revolute(rocker.position, ground.C);
            drive input = drive_angle(crank, 60rpm * t); joint tie = {tie}; }}"
        );
        let refusals = reuleaux_compiler::compile(source.parse().expect("tokens")).expect_err("too short");
        let said = refusals[0].fact.to_string();
        assert!(said.contains("with all of them closed it is 10 mm off"), "{tie}: {said}");
    }
}

/// Placeholder defaults prove no redundancy.
#[test]
fn placeholders_are_not_judged_by_their_numbers() {
    let crank = |middle: &str| {
        let drive = "redundant joint f = revolute(rod.R, third.P); drive i = drive_angle(crank, 60deg + 1rad_s * t);";
        let source = third_crank!("").replace("third.position);}", &format!("third.position);{drive}}}"));
        source.replace("middle: Length = 500mm", &format!("middle: Length = {middle}"))
    };
    for middle in ["520mm", "0mm"] {
        assert!(reuleaux_compiler::compile(crank(middle).parse().expect("tokens")).is_err());
        for word in ["allow", "off"] {
            assert_eq!(checked(&format!("#[closure({word})] {}", crank(middle))).len(), 1, "{middle}, {word}");
        }
    }
    let flat = "#[closure(allow)] mechanism F { param l: Length = 0mm; body a { point P = (l, 0mm); } body b { point P = (l, 0mm); }
        joint o = revolute(ground.position, a.position); joint p = revolute(a.P, b.position); joint q = distance(ground.position, b.P, 1m);
        drive i = drive_angle(a, 1rad_s * t); }";
    assert_eq!(checked(flat).len(), 0);
}
