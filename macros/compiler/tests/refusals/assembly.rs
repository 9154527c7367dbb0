//! Mechanisms that do not assemble at their declared defaults, or not uniquely; `tests/assembly` tests the numbers.

/// A four-bar on a ground of 400 mm, with a crank of 100 mm; links and the drive follow.
macro_rules! four_bar {
    ($($name:ident: $links:literal => $words:literal;)*) => {
        $(#[test] fn $name() {
            let frame = "ground { point C = (400mm, 0mm); } body crank { point A = (100mm, 0mm); }
                joint o = revolute(ground.position, crank.position); joint a = revolute(crank.A, coupler.position);
                joint b = revolute(coupler.B, rocker.B);";
            crate::mechanism(&format!("mechanism FourBar {{ {frame} {} }}", $links), $words);
        })*
    };
}

four_bar! {
    links_are_too_short: "body coupler { point B = (100mm, 0mm); } body rocker { point B = (150mm, 0mm); } joint «c» = revolute(rocker.position, ground.C); drive input = drive_angle(crank, 1rad_s * t);"
        => "`c` stays open by 50 mm when `o`, `a` and `b` are closed\nnote: `crank` (100 mm) + `coupler` (100 mm) + `rocker` (150 mm) is 50 mm short of `ground` (400 mm)\nhelp: change a length or a place: no value of `input` helps";
    a_link_is_too_long: "body coupler { point B = (900mm, 0mm); } body rocker { point B = (150mm, 0mm); } joint «c» = revolute(rocker.position, ground.C); drive input = drive_angle(crank, 1rad_s * t);"
        => "`c` stays open by 450 mm when `o`, `a` and `b` are closed\nnote: `crank` (100 mm) + `ground` (400 mm) + `rocker` (150 mm) is 250 mm short of `coupler` (900 mm)\nhelp: change a length or a place: no value of `input` helps";
    links_are_too_short_for_this_angle: "body coupler { point B = (180mm, 0mm); } body rocker { point B = (150mm, 0mm); } joint «c» = revolute(rocker.position, ground.C); drive input = drive_angle(crank, 180deg + 1rad_s * t);"
        => "`c` stays open by 170 mm when `o`, `a` and `b` are closed\nnote: `coupler` (180 mm) + `rocker` (150 mm) is 170 mm short of the distance from `a` to `c` (500 mm)\nhelp: change a length or a place, or let `input` have another value at t = 0";
    nothing_tells_two_assemblies_apart: "body coupler { point B = (350mm, 0mm); } body «rocker» { point B = (300mm, 0mm); } joint c = revolute(rocker.position, ground.C); drive input = drive_angle(crank, 1rad_s * t);"
        => "two assemblies are equally near: `rocker.angle` = 108.6° or -108.6°\nhelp: write `start angle = 109deg;` in `body rocker`";
    a_start_between_two_assemblies: "body coupler { point B = (350mm, 0mm); } body «rocker» { point B = (300mm, 0mm); start angle = 180deg; } joint c = revolute(rocker.position, ground.C); drive input = drive_angle(crank, 1rad_s * t);"
        => "two assemblies are equally near the declared start: `rocker.angle` = 108.6° or -108.6°\nhelp: write `start angle = 109deg;` in `body rocker`";
    a_parallelogram_at_its_change_point: "body coupler { point B = (400mm, 0mm); } body rocker { point B = (100mm, 0mm); } joint c = revolute(rocker.position, ground.C); drive «input» = drive_angle(crank, 1rad_s * t);"
        => "the start is singular: `coupler` and `rocker` are in line at t = 0\nnote: two assemblies meet there, and how fast `coupler` and `rocker` are moving is not determined\nhelp: let `input` have another value at t = 0";
    a_rocker_at_its_dead_point: "body coupler { point B = (150mm, 0mm); } body rocker { point B = (150mm, 0mm); } joint c = revolute(rocker.position, ground.C); drive «input» = drive_angle(crank, 1rad_s * t);"
        => "the start is singular: `coupler` and `rocker` are in line at t = 0\nnote: two assemblies meet there, and how fast `coupler` and `rocker` are moving is not determined\nhelp: let `input` have another value at t = 0";
}

four_bar! {
    a_range_that_is_too_long: "range t in 0s..350ms; body coupler { point B = (150mm, 0mm); } body rocker { point B = (300mm, 0mm); start angle = 100deg; } joint c = revolute(rocker.position, ground.C); drive «input» = drive_angle(crank, 60rpm * t);"
        => "`crank` stops at 114° at t = 0.3166 s: `c` cannot stay closed beyond that\nnote: `coupler` and `rocker` are in line there\nhelp: end the range before it, `range t in 0s..0.31s;`, or change a length";
    a_range_that_begins_too_early: "range t in -350ms..0.1s; body coupler { point B = (150mm, 0mm); } body rocker { point B = (300mm, 0mm); start angle = 100deg; } joint c = revolute(rocker.position, ground.C); drive «input» = drive_angle(crank, 60rpm * t);"
        => "`crank` stops at -114° at t = -0.3166 s: `c` cannot stay closed beyond that\nnote: `coupler` and `rocker` are in line there\nhelp: end the range before it, `range t in -0.31s..0.1s;`, or change a length";
}

crate::refusals! {
    mechanism a_crank_that_cannot_turn: "#[closure(deny)] mechanism FourBar { ground { point C = (400mm, 0mm); } body crank { point A = (100mm, 0mm); } joint o = revolute(ground.position, crank.position); joint a = revolute(crank.A, coupler.position); joint b = revolute(coupler.B, rocker.B); body coupler { point B = (150mm, 0mm); } body rocker { point B = (300mm, 0mm); start angle = 100deg; } joint c = revolute(rocker.position, ground.C); drive «input» = drive_angle(crank, 60rpm * t); }"
        => "`crank` stops at 114° at t = 0.3166 s: `c` cannot stay closed beyond that\nnote: `coupler` and `rocker` are in line there\nnote: no `range` is declared, so it is followed until everything repeats itself, to t = 1 s\nhelp: write `range t in 0s..0.31s;` if it is to go no further, or change a length";
    mechanism slider_out_of_reach: "mechanism Slider { ground { axis u = (1, 0); point P = (0mm, 120mm); } body crank { point A = (50mm, 0mm); } body rod { point B = (90mm, 0mm); } body piston {} joint o = revolute(ground.position, crank.position); joint a = revolute(crank.A, rod.position); joint b = revolute(rod.B, piston.position); joint «c» = translational(ground.u, ground.P, piston.position); drive input = drive_angle(crank, 1rad_s * t); }"
        => "`c` stays open by 30 mm when `o`, `a` and `b` are closed\nnote: `rod` (90 mm) is 30 mm shorter than the distance of `a` from the line of `c` (120 mm)\nhelp: change a length or a place, or let `input` have another value at t = 0";
    mechanism wheels_too_far_apart: "mechanism Idler { param r: Length = 40mm; ground { point B = (170mm, 0mm); } body idler { } joint one = distance(ground.position, idler.position, 2 * r); joint «two» = distance(ground.B, idler.position, 2 * r); drive input = drive_angle(idler, 1rad_s * t); }"
        => "`two` stays open by 10 mm when `one` is closed\nnote: `one` (80 mm) + `two` (80 mm) is 10 mm short of `ground` (170 mm)\nhelp: change a length or a place";
    mechanism tilted_too_far: "mechanism Slider { ground { axis u = (1, 0); } body crank { point A = (50mm, 0mm); } body rod { point B = (100mm, 0mm); } body piston {} joint o = revolute(ground.position, crank.position); joint a = revolute(crank.A, rod.position); joint b = revolute(rod.B, piston.position); joint c = translational(ground.u, ground.position, piston.position); joint «tilt» = absolute_angle(rod, 40deg); }"
        => "`tilt` stays open by 10° when `o`, `a`, `b` and `c` are closed\nhelp: change a length or a place";
    mechanism driven_at_its_dead_point: "mechanism Slider { ground { axis u = (1, 0); } body crank { point A = (50mm, 0mm); } body rod { point B = (150mm, 0mm); } body piston {} joint o = revolute(ground.position, crank.position); joint a = revolute(crank.A, rod.position); joint b = revolute(rod.B, piston.position); joint c = translational(ground.u, ground.position, piston.position); drive «input» = drive_x(piston.position, 200mm + 10mm_s * t); }"
        => "the start is singular: `crank` and `rod` are in line at t = 0\nnote: two assemblies meet there, and how fast `crank` and `rod` are moving is not determined\nhelp: let `input` have another value at t = 0";
    mechanism a_place_on_either_side: "mechanism Peg { ground { point F = (-150mm, 0mm); point G = (150mm, 0mm); } body «peg» { } joint one = distance(ground.F, peg.position, 250mm); joint two = distance(ground.G, peg.position, 250mm); joint level = absolute_angle(peg, 0); }"
        => "two assemblies are equally near: `peg.y` = 200 mm or -200 mm\nhelp: write `start position = (0mm, 200mm);` in `body peg`";
    mechanism one_of_many: "mechanism Row { ground { for i in 0..5 { point C[i] = (400mm, 0mm); } } for i in 0..5 { body crank[i] { point A = (100mm, 0mm); } body coupler[i] { point B = (300mm - i * 50mm, 0mm); start angle = 40deg; } body rocker[i] { point B = (300mm - i * 50mm, 0mm); start angle = 120deg; } joint o[i] = revolute(ground.position, crank[i].position); joint a[i] = revolute(crank[i].A, coupler[i].position); joint b[i] = revolute(coupler[i].B, rocker[i].B); joint «c»[i] = revolute(rocker[i].position, ground.C[i]); drive input[i] = drive_angle(crank[i], 90deg + 1rad_s * t); } }"
        => "`c[2]` stays open by 12.31 mm when `o[2]`, `a[2]` and `b[2]` are closed\nnote: `coupler[2]` (200 mm) + `rocker[2]` (200 mm) is 12.31 mm short of the distance from `a[2]` to `c[2]` (412.3 mm)\nhelp: change a length or a place, or let `input[2]` have another value at t = 0";
    mechanism an_equation_out_of_range: "mechanism Wave { body b {} joint o = revolute((0mm, 0mm), b.position); joint «s» = { sin(b.angle) == 1.5; } }"
        => "`s` stays open by 0.5 when `o` is closed\nhelp: change a length or a place";
    mechanism word_of_closure: "#[closure(«alow»)] mechanism Crank { body crank {} }" => "`#[closure(…)]` takes one of `deny`, `start`, `allow` and `off`\nhelp: did you mean `allow`?";
    mechanism no_word_of_closure: "#[«closure»] mechanism Crank { body crank {} }" => "`#[closure(…)]` takes one of `deny`, `start`, `allow` and `off`";
    mechanism word_of_allow: "#[allow(«far_star»)] mechanism Crank { body crank {} }" => "`#[allow(…)]` takes the word `far_start` here\nhelp: did you mean `far_start`?\nnote: a lint of Rust is allowed for the module in which the mechanism stands";
    mechanism lint_of_rust: "#[allow(«dead_code»)] mechanism Crank { body crank {} }" => "`#[allow(…)]` takes the word `far_start` here\nnote: a lint of Rust is allowed for the module in which the mechanism stands";
    mechanism closure_twice: "#[closure(off)] #[«closure»(allow)] mechanism Crank { body crank {} }" => "`#[closure]` stands here twice\nhelp: take one of them away";
    mechanism a_link_too_short_by_a_hair: "mechanism Tri { ground { point C = (500mm, 0mm); } body a { point P = (300mm, 0mm); } body b { point P = (199.9999mm, 0mm); start angle = 5deg; } joint o = revolute(ground.position, a.position); joint p = revolute(a.P, b.P); joint «q» = revolute(ground.C, b.position); }" => "`q` stays open by 0.0001 mm when `o` and `p` are closed\nnote: `a` (300 mm) + `b` (199.9999 mm) is 0.0001 mm short of `ground` (500 mm)\nhelp: change a length or a place";
    mechanism a_square_that_vanishes: "mechanism N { body «crank» { point A = (1m, 0m); point B = (1m, 1m); } joint o = revolute(ground.position, crank.position); joint i = { (crank.angle - 1rad) * (crank.angle - 1rad) == 0; } }" => "the start is singular: `crank` stands at a dead point at t = 0\nnote: two assemblies meet there, and how fast `crank` is moving is not determined\nhelp: change a length or a place";
    mechanism a_cosine_at_its_largest: "mechanism N { body crank { point A = (1m, 0m); point B = (1m, 1m); } joint o = revolute(ground.position, crank.position); drive «i» = { cos(crank.angle) == 1; } }" => "the start is singular: `crank` stands at a dead point at t = 0\nnote: two assemblies meet there, and how fast `crank` is moving is not determined\nhelp: let `i` have another value at t = 0";
    mechanism a_root_that_begins_in_zero: "mechanism N { body crank { point A = (1m, 0m); point B = (1m, 1m); } joint o = revolute(ground.position, crank.position); drive «i» = drive_angle(crank, 1rad * sqrt(t / 1s)); }" => "the equation of `i` has no finite first and second derivative by time at t = 0\nhelp: a root of what vanishes there has none: take a law that begins smoothly";
    mechanism a_law_without_a_value: "mechanism N { body crank {} joint o = revolute(ground.position, crank.position); drive «i» = drive_angle(crank, 1rad * ln(t / 1s)); }" => "the equation of `i` has no value at t = 0: a root of something negative, a division by zero or a number beyond 1e308\nhelp: let `i` have another value at t = 0";
    mechanism a_joint_without_a_value: "mechanism N { body crank {} joint o = revolute(ground.position, crank.position); body ram {} joint r = translational((1, 0), ground.position, ram.position); drive i = drive_angle(crank, t * 1rad_s); joint «s» = { ram.x == 1mm * sqrt(crank.angle - 1); } }" => "the equation of `s` has no value near the start: a root of something negative, a division by zero or a number beyond 1e308\nhelp: declare a `start` at which it has one, or let `i` have another value at t = 0";
}
