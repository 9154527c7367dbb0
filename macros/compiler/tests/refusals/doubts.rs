//! Numbers, shapes and starts that are valid and probably meant otherwise cause a warning; what is surely meant causes none.

/// Lengths without a unit cause a warning if they are out of proportion, and only then.
#[test]
fn bare_lengths_out_of_proportion_are_doubted() {
    let doubts = |length: &str, items: &str| -> Vec<String> {
        let source = format!(
            "mechanism M {{ {items} body b {{ point A = ({length}, 0mm); point B = (100mm, 0); }}
                joint o = revolute(ground.position, b.position); drive d = drive_angle(b, 60rpm * t); }}"
        );
        let compiled = reuleaux_compiler::compile(source.parse().expect("the source consists of tokens")).expect("it is valid");
        compiled.model.doubts.iter().map(|warning| warning.doubt.to_string()).collect()
    };
    let doubt = |number: &str| {
        let words = "has no unit: it is # m, where no other length exceeds 100 mm\nhelp: write `#mm`, or `#m` if it is meant";
        format!("`{number}` {}", words.replace('#', number))
    };
    assert_eq!(doubts("350", ""), [doubt("350")]);
    assert_eq!(doubts("-350", "param l: Length = 20;"), [doubt("20"), doubt("350")]);
    assert_eq!(
        doubts("1mm", "for i in 0..2 { body c[i] { point P = (42, 0mm); } joint w[i] = weld(ground.position, c[i].P); }"),
        [doubt("42")]
    );
    for meant in ["350mm", "350m", "0.35", "2", "4.9", "100mm * 350"] {
        assert_eq!(doubts(meant, ""), [""; 0], "{meant}");
    }
}

#[test]
fn sines_of_bare_numbers_that_are_rather_degrees_are_doubtful() {
    let doubts = |factor: &str| {
        let source = format!(
            "mechanism M {{ let k = {factor}; body b {{ point A = (1m, 0m); }} joint o = revolute(ground.position, b.position);
             drive d = drive_angle(b, k * 60rpm * t); }}"
        );
        let compiled = reuleaux_compiler::compile(source.parse().expect("the source consists of tokens")).expect("it is valid");
        compiled.model.doubts.iter().map(|warning| warning.doubt.to_string()).collect::<Vec<String>>()
    };
    let said = |call: &str, number: &str, instead: &str| {
        vec![format!("`{number}` has no unit: it is {number} rad\nhelp: write `{instead}`, or `{call}({number}rad)` if it is meant")]
    };
    assert_eq!(doubts("sin(30)"), said("sin", "30", "sin(30deg)"));
    assert_eq!(doubts("cos(-45)"), said("cos", "-45", "cos(-45deg)"));
    assert_eq!(doubts("2 * tan(7)"), said("tan", "7", "tan(7deg)"));
    for sure in ["sin(6)", "sin(30deg)", "cos(0.5)", "sin(30rad)", "exp(30)"] {
        assert_eq!(doubts(sure), Vec::<String>::new(), "{sure}");
    }
}

/// A rod with its centre at the origin reaches half of its length to both sides.
#[test]
fn rods_without_a_centre_are_doubted_where_a_point_lies_at_their_length() {
    let doubts = |ambient: &str, body: &str| {
        let source = format!(
            "#[equations_only] mechanism M {ambient} {{ param long: Length = 400mm;
                body b {{ mass = 1kg; {body} }} output place = b.position; }}"
        );
        let compiled = reuleaux_compiler::compile(source.parse().expect("tokens")).expect("a body with its mass");
        compiled.model.doubts.iter().map(|warning| warning.doubt.to_string()).collect::<Vec<String>>()
    };
    let said = |point: &str, center: &str, origin: &str| {
        vec![format!(
            "`b` has its centre of mass at its origin, so that its rod ends at half the distance of `{point}`\n\
             help: write `center = {center};`, or `center = {origin};` if the origin is meant"
        )]
    };
    assert_eq!(doubts("", "point A = (300mm, 0mm); inertia = rod(300mm);"), said("A", "(300mm / 2, 0m)", "(0m, 0m)"));
    assert_eq!(doubts("", "point O = (0m, 0m); point B = (long, 0mm); inertia = rod(long);"), said("B", "(long / 2, 0m)", "(0m, 0m)"));
    let in_space = "point A = (300mm, 0mm, 0mm); inertia = rod(300mm);";
    assert_eq!(doubts("in space", in_space), said("A", "(300mm / 2, 0m, 0m)", "(0m, 0m, 0m)"));
    assert_eq!(doubts("", "point A = (0mm, -300mm); inertia = rod(300mm);"), said("A", "(0m, -300mm / 2)", "(0m, 0m)"));
    assert_eq!(doubts("", "point A = (-long, 0mm); inertia = rod(long);"), said("A", "(-long / 2, 0m)", "(0m, 0m)"));
    for sure in [
        "point A = (300mm, 0mm); center = (0mm, 0mm); inertia = rod(300mm);",
        "point A = (300mm, 0mm); center = (150mm, 0mm); inertia = rod(300mm);",
        "point A = (150mm, 0mm); inertia = rod(300mm);",
        "point A = (300mm, 40mm); inertia = rod(300mm);",
        "point A = (300mm, 0mm); inertia = disk(300mm);",
        "axis u = (1, 0); inertia = rod(1m);",
    ] {
        assert_eq!(doubts("", sure), Vec::<String>::new(), "{sure}");
    }
}

/// Numbers in the place of quantities, wherever they stand.
#[test]
fn bare_numbers_in_the_place_of_quantities_are_doubted() {
    let doubts = |items: &str| {
        let source = format!(
            "mechanism M {{ ground {{ axis up = (0, 1); point top = (0mm, 400mm); }} body b {{ mass = 1kg; start y = 100mm; }}
                joint g = translational(ground.up, ground.position, b.position); {items} }}"
        );
        let compiled =
            reuleaux_compiler::compile(source.parse().expect("tokens")).unwrap_or_else(|refusals| panic!("{items}: {refusals:?}"));
        compiled.model.doubts.iter().map(|warning| warning.doubt.to_string()).collect::<Vec<String>>()
    };
    let angle =
        |number: &str| format!("`{number}` has no unit: it is {number} rad\nhelp: write `{number}deg`, or `{number}rad` if it is meant");
    let length = |number: &str| {
        let told = format!("`{number}` has no unit: it is {number} m, where no other length exceeds 400 mm");
        format!("{told}\nhelp: write `{number}mm`, or `{number}m` if it is meant")
    };
    let driven = "drive d = drive_y(b.position, 100mm);";
    let with = |items: &str| doubts(&format!("{driven} {items}"));
    assert_eq!(doubts("force s = spring(ground.top, b.position, stiffness: 1000N_m, rest: 200); freedom y = b.y;"), [length("200")]);
    assert_eq!(with("output far = if b.y < 300 { 1 } else { 2 };"), [length("300")]);
    assert_eq!(with("output far = b.y - 90;"), [length("90")]);
    assert_eq!(with("param swing: Angle = 30; output wave = sin(swing);"), [angle("30")]);
    assert_eq!(with("param swing: Angle = 1rad in 0..=360; output wave = sin(swing);"), [angle("360")]);
    let wheel = "body wheel { } joint axle = revolute(ground.position, wheel.position);";
    let turned = |law: &str| with(&format!("{wheel} drive turn = drive_angle(wheel, {law});"));
    assert_eq!(turned("90 * cycloidal(t / 1s)"), [angle("90")]);
    assert_eq!(turned("if t < 1s { 90 } else { 2rad }"), [angle("90")]);
    // Beside the variable of a loop, or by a name.
    let in_loop = |law: &str| {
        with(&format!(
            "for i in 0..2 {{ body wheel[i] {{ }} joint axle[i] = revolute(ground.position, wheel[i].position); drive turn[i] = drive_angle(wheel[i], {law}); }}"
        ))
    };
    assert_eq!(in_loop("1rad_s * t + 120 * i"), [angle("120")]);
    assert_eq!(in_loop("45deg + (i + 1) * 90"), [angle("90")]);
    assert_eq!(with("let phase = 90; output wave = sin(phase) + cos(phase);"), [angle("90")]);
    assert_eq!(with("param phase: Number = 120; output wave = sin(phase * 1.5);"), [""; 0]);
    assert_eq!(with(&format!("let phase = 120; {wheel} drive turn = drive_angle(wheel, 1rad_s * t + phase);")), [angle("120")]);
    assert_eq!(
        with("param phase: Number = 120; output wave = sin(phase);"),
        ["`120` has no unit: it is 120 rad where it is an angle\nhelp: write `phase: Angle = 120deg`"]
    );
    // A component has names of its own.
    let two =
        "component C() { let phase = 12deg; body c { } joint o = revolute(ground.position, c.position); drive x = drive_angle(c, phase); }";
    assert_eq!(with(&format!("let phase = 90; output n = phase + 1; {two} part c = C();")), [""; 0]);
    assert_eq!(in_loop("1rad_s * t + 120deg * i + 2 * pi * i / 12"), [""; 0]);
    let table =
        "drive turn = drive_angle(wheel, 1rad_s * t); output lift = table(wheel.angle, [(0, 0mm), (90, 5mm), (360, 0mm)], periodic);";
    assert_eq!(with(&format!("{wheel} {table}")), [angle("360")]);
    let motor = |speed: &str| with(&format!("{wheel} param speed: AngularVelocity = {speed}; drive turn = drive_angle(wheel, speed * t);"));
    let words = "`1500` has no unit: it is 1500 rad/s, 14324 rpm\nhelp: write `1500rpm`, or `1500rad_s` if it is meant";
    assert_eq!(motor("1500"), [words]);
    for sure in [motor("60"), motor("1500rpm"), turned("2 * cycloidal(t / 1s)"), with("output far = b.y - 2;")] {
        assert_eq!(sure, Vec::<String>::new());
    }
}

/// `from 50` is 50 m, and `at 3000` 3000 rad/s.
#[test]
fn bare_starts_of_freedoms_are_doubted() {
    let doubts = |freedoms: &str| {
        let source = format!("mechanism M {{ body b {{ mass = 1kg; inertia = 1kgm2; point P = (100mm, 0mm); }} {freedoms} }}");
        let compiled =
            reuleaux_compiler::compile(source.parse().expect("tokens")).unwrap_or_else(|refusals| panic!("{freedoms}: {refusals:?}"));
        compiled.model.doubts.iter().map(|warning| warning.doubt.to_string()).collect::<Vec<String>>()
    };
    let far = "`50` has no unit: it is 50 m, where no other length exceeds 100 mm\nhelp: write `50mm`, or `50m` if it is meant";
    assert_eq!(doubts("freedom x = b.x from 50; freedom y = b.y; freedom turn = b.angle;"), [far]);
    let fast = "`3000` has no unit: it is 3000 rad/s, 28648 rpm\nhelp: write `3000rpm`, or `3000rad_s` if it is meant";
    assert_eq!(doubts("freedom x = b.position; freedom turn = b.angle from 0 at 3000;"), [fast]);
    assert_eq!(doubts("freedom x = b.position from (1, 2); freedom turn = b.angle from 0 at 60;"), Vec::<String>::new());
}

/// The axis of a disk is z, that of a wheel often another one.
#[test]
fn disks_across_the_only_axis_are_doubted() {
    let doubts = |body: &str| {
        let source = format!("#[equations_only] mechanism M in space {{ body b {{ mass = 1kg; {body} }} output place = b.position; }}");
        let compiled = reuleaux_compiler::compile(source.parse().expect("tokens")).expect("a body with its mass");
        compiled.model.doubts.iter().map(|warning| warning.doubt.to_string()).collect::<Vec<String>>()
    };
    let across = |shape: &str, turn: &str| {
        vec![format!("the axis of `{shape}` lies along z, but `n` of `b` lies across it\nhelp: write `inertia = {shape} along {turn};`")]
    };
    assert_eq!(doubts("axis n = (1, 0, 0); inertia = disk(200mm);"), across("disk(200mm)", "turn((0, 1, 0), 90deg)"));
    assert_eq!(doubts("axis n = (0, -1, 0); inertia = cylinder(20mm, 1m);"), across("cylinder(20mm, 1m)", "turn((1, 0, 0), 90deg)"));
    for sure in [
        "axis n = (0, 0, 1); inertia = disk(200mm);",
        "axis n = (1, 0, 0); axis m = (0, 0, 1); inertia = disk(200mm);",
        "axis n = (1, 0, 1); inertia = disk(200mm);",
        "axis n = (1, 0, 0); inertia = disk(200mm) along turn((0, 1, 0), 90deg);",
        "axis n = (1, 0, 0); inertia = ball(200mm);",
    ] {
        assert_eq!(doubts(sure), Vec::<String>::new(), "{sure}");
    }
}

/// The arms of a cross are at right angles; shafts are in line.
#[test]
fn shafts_for_the_arms_of_a_universal_joint_are_told() {
    let shafts = "`hooke` is given two axes in line, as shafts are; those of a universal joint are the arms of its cross, at right angles\n\
                  help: declare them across the shafts, such as `axis arm = (0, 0, 1);` in one body and `axis arm = (0, 1, 0);` in the other";
    let source = |one: &str, two: &str, start: &str| {
        format!(
            "mechanism M in space {{
                param bend: Angle = 20deg;
                ground {{ axis x = (1, 0, 0); axis out = (cos(bend), sin(bend), 0); }}
                body one {{ axis x = (1, 0, 0); axis arm = (0, 0, 1); }}
                body two {{ axis x = (1, 0, 0); axis arm = (0, 1, 0); axis up = (0, 0, 1); start orientation = {start}; }}
                joint bearing = revolute(ground.position, ground.x, one.position, one.x);
                joint hooke = universal(one.position, one.{one}, two.position, two.{two});
                joint seat = parallel_axes(ground.out, two.x);
                drive motor = drive_rotation(bearing, 60rpm * t);
            }}"
        )
    };
    let compile = |one: &str, two: &str, start: &str| reuleaux_compiler::compile(source(one, two, start).parse().expect("tokens"));
    let refused = compile("x", "x", "turn((0, 0, 1), 20deg)").expect_err("shafts that are to be at right angles");
    let words: Vec<String> = refused.iter().map(|refusal| refusal.fact.message()).collect();
    assert!(words.iter().all(|words| words.contains(shafts)), "{words:?}");
    compile("arm", "arm", "turn((0, 0, 1), 20deg)").expect("a shaft with a bend");
    // An error about other joints keeps its help.
    let other =
        "body lever { } joint pivot = spherical(ground.position, lever.position); drive swing = drive_x(lever.position, 1m * t / 1s);";
    let other = source("x", "x", "turn((0, 0, 1), 20deg)").replace("drive motor", &format!("{other} drive motor"));
    let refused = reuleaux_compiler::compile(other.parse().expect("tokens")).expect_err("a ball that holds a place");
    let told = refused.iter().filter(|refusal| refusal.fact.message().contains(shafts));
    assert!(told.into_iter().all(|refusal| !refusal.fact.message().contains("lever")), "{refused:?}");
}

/// More than a turn of radians is rather one of degrees.
#[test]
fn starts_of_angles_without_unit_are_doubted() {
    let doubts = |start: &str, coordinate: &str, from: &str| {
        let source = format!(
            "mechanism M {{ body b {{ point P = (1m, 0m); mass = 1kg; inertia = 1kgm2; {start} }} joint o = revolute(ground.position, b.position);
                freedom q = {coordinate} {from}; }}"
        );
        let compiled = reuleaux_compiler::compile(source.parse().expect("tokens")).expect("a number is an angle");
        compiled.model.doubts.iter().map(|warning| warning.doubt.to_string()).collect::<Vec<String>>()
    };
    let doubt = |number: &str| {
        vec![format!("`{number}` has no unit: it is {number} rad\nhelp: write `{number}deg`, or `{number}rad` if it is meant")]
    };
    assert_eq!(doubts("start angle = 35;", "b.angle", ""), doubt("35"));
    assert_eq!(doubts("start angle = -120;", "b.angle", ""), doubt("-120"));
    assert_eq!(doubts("", "b.angle", "from 60"), doubt("60"));
    for (start, coordinate, from) in [
        ("start angle = 6;", "b.angle", ""),
        ("start angle = 35deg;", "b.angle", "from 35deg"),
        ("", "b.angle", "from 60rad at 90"),
        ("start x = 3;", "b.angle", "from -6"),
    ] {
        assert_eq!(doubts(start, coordinate, from), [""; 0], "{start} {from}");
    }
}

#[test]
fn drives_that_stand_still_at_a_bare_number_are_doubted() {
    let doubts = |source: String| {
        let compiled = reuleaux_compiler::compile(source.parse().expect("tokens")).expect("a number is an angle");
        compiled.model.doubts.iter().map(|warning| warning.doubt.to_string()).collect::<Vec<String>>()
    };
    let plane = |law: &str| {
        format!("mechanism M {{ body b {{ }} joint o = revolute(ground.position, b.position); drive d = drive_angle(b, {law}); }}")
    };
    let space = |law: &str| {
        format!(
            "mechanism M in space {{ body b {{ axis z = (0, 0, 1) from (1, 0, 0); }}
                joint o = revolute((0m, 0m, 0m), (0, 0, 1), b.position, b.z); drive d = drive_rotation(o, {law}); }}"
        )
    };
    let wanted =
        "`60` has no unit: it is 60 rad, at which the drive stands still\nhelp: write `60rpm * t` for a speed, or `60deg` for an angle";
    for source in [plane("60"), space("60")] {
        assert_eq!(doubts(source), [wanted]);
    }
    for sure in ["6", "60deg", "60rad", "60rpm * t", "90deg + 60rpm * t", "3 * sin(60rpm * t) + 6", "sin(60 * t / 1s)"] {
        assert_eq!(doubts(plane(sure)), [""; 0], "{sure}");
    }
    let as_a_part = "`90` has no unit: it is 90 rad\nhelp: write `90deg`, or `90rad` if it is meant";
    for law in ["60rpm * t + 90", "0.5rad - 90", "90 * sin(60rpm * t)", "6 - cos(60rpm * t) * 90", "-(60rpm * t + 90)"] {
        assert_eq!(doubts(plane(law)), [as_a_part], "{law}");
    }
}

/// The doubts of a mechanism with these items.
fn doubts_of(items: &str) -> Vec<String> {
    let compiled = reuleaux_compiler::compile(format!("mechanism M {{ {items} }}").parse().expect("the source consists of tokens"));
    compiled.expect("it is valid").model.doubts.iter().map(|warning| warning.doubt.to_string()).collect()
}

#[test]
fn conversions_of_quantities_with_units_are_doubted() {
    let crank = "param speed: AngularVelocity = 600rpm; body b { } joint o = revolute(ground.position, b.position);";
    let law = |law: &str| doubts_of(&format!("{crank} drive d = drive_angle(b, {law});"));
    let output = |output: &str| doubts_of(&format!("{crank} drive d = drive_angle(b, speed * t); output a = {output};"));
    let said = |written: &str, instead: &str| {
        vec![format!("`{written}` converts a quantity that carries its unit already\nhelp: write `{instead}`")]
    };
    for (written, instead) in [
        ("2 * pi * speed * t", "speed * t"),
        ("2 * pi * speed / 60 * t", "speed * t"),
        ("speed * t * pi / 180", "speed * t"),
        ("-20deg * pi / 180 * sin(1rad_s * t)", "-20deg * sin(1rad_s * t)"),
    ] {
        assert_eq!(law(written), said(written, instead), "{written}");
    }
    assert_eq!(output("b.angular_velocity * 60 / (2 * pi)"), said("b.angular_velocity * 60 / (2 * pi)", "b.angular_velocity / 1rpm"));
    assert_eq!(output("sin(b.angle * pi / 180)"), said("b.angle * pi / 180", "b.angle"));
    // A part of a turn, a ratio, a frequency.
    for sure in ["2 * pi * b.angle / 30deg", "b.angle / (2 * pi)", "speed / (2 * pi)", "pi * b.angle", "b.angle / 1deg", "2 * pi * 3"] {
        assert_eq!(output(sure), Vec::<String>::new(), "{sure}");
    }
    // A number that is converted to radians.
    for sure in ["speed * t + 30deg", "2 * pi * 1rad_s * t", "600 * pi / 30 * 1rad_s * t", "30 * pi / 180 * 1rad + speed * t"] {
        assert_eq!(law(sure), Vec::<String>::new(), "{sure}");
    }
    assert_eq!(law("2 * pi * speed * (t - 1s)"), said("2 * pi * speed * (t - 1s)", "speed * (t - 1s)"));
    let own = "component Motor(speed: AngularVelocity) { body b { } joint o = revolute(ground.position, b.position);
        drive d = drive_angle(b, 2 * pi * speed * t); } part one = Motor(3rpm);";
    assert_eq!(doubts_of(own), said("2 * pi * speed * t", "speed * t"));
    let other = "param speed: AngularVelocity = 600rpm; component Motor(speed: Number) { body b { } joint o = revolute(ground.position, b.position);
        drive d = drive_angle(b, 2 * pi * speed * 1rad_s * t); } part one = Motor(3); output w = speed;";
    assert_eq!(doubts_of(other), Vec::<String>::new());
}

#[test]
fn programs_of_a_turn_that_end_are_doubted() {
    let cam = |program: &str| {
        doubts_of(&format!(
            "function lift(psi: Angle) -> Length = segments(psi, 40mm, [{program});
             ground {{ axis up = (0, 1); }} body cam {{ }} body tappet {{ start y = 40mm; }}
             joint o = revolute(ground.position, cam.position);
             joint guide = translational(ground.up, ground.position, tappet.position);
             joint c = cam_knife(cam.position, tappet.position, lift);
             drive d = drive_angle(cam, 60rpm * t);"
        ))
    };
    let said = "`lift` is a program of a whole turn, after which the follower stays at rest\nhelp: write `segments(…, periodic)` if it begins anew \
                with each turn, or `hold` if it does not";
    let turn = "rise(12mm, 120deg, cycloidal), dwell(60deg), fall(12mm, 120deg, cycloidal), dwell(60deg)]";
    assert_eq!(cam(turn), [said]);
    for sure in [format!("{turn}, periodic"), format!("{turn}, hold"), "rise(12mm, 120deg, cycloidal), dwell(60deg)]".to_owned()] {
        assert_eq!(cam(&sure), Vec::<String>::new(), "{sure}");
    }
}

#[test]
fn angles_of_parts_without_a_unit_are_doubted() {
    let parts = |angle: &str| {
        doubts_of(&format!(
            "let n = 5; component Arm(toward: Angle) {{ body b {{ }} joint o = revolute(ground.position, b.position);
                 drive d = drive_angle(b, toward + 1rad_s * t); }}
             for i in 0..n {{ part arm[i] = Arm({angle}); }}"
        ))
    };
    let said = |number: &str| {
        vec![format!("`{number}` has no unit: it is {number} rad\nhelp: write `{number}deg`, or `{number}rad` if it is meant")]
    };
    assert_eq!(parts("72 * i"), said("72"));
    assert_eq!(parts("360 / n * i"), said("360"));
    for sure in ["72deg * i", "2 * pi / n * i", "1turn / n * i"] {
        assert_eq!(parts(sure), Vec::<String>::new(), "{sure}");
    }
}
