//! Expressions that are valid, and often mean something else.

/// The doubts of a mechanism with a body `b` and these items.
fn doubts(ambient: &str, items: &str) -> Vec<String> {
    let source = format!("#[equations_only] mechanism M {ambient} {{ {items} body b {{ }} output place = b.position; }}");
    let compiled = reuleaux_compiler::compile(source.parse().expect("tokens")).unwrap_or_else(|refusals| panic!("{items}: {refusals:?}"));
    compiled.model.doubts.iter().map(|warning| warning.doubt.to_string()).collect()
}

fn plane(items: &str) -> Vec<String> {
    doubts("", items)
}

#[test]
fn powers_of_numbers_with_units_are_doubted() {
    let raised = |written: &str, meaning: &str, instead: &str| {
        vec![format!("`{written}` raises the number, too: it is `{meaning}`\nhelp: write `{instead}`, or `{meaning}` if it is meant")]
    };
    assert_eq!(plane("param a: Area = 20mm^2;"), raised("20mm^2", "(20mm)^2", "20mm2"));
    assert_eq!(plane("let a = 60min^-1;"), raised("60min^-1", "(60min)^-1", "60rpm"));
    assert_eq!(plane("let a = 5s^-1;"), raised("5s^-1", "(5s)^-1", "5 / 1s"));
    assert_eq!(plane("let a = 5mm^3;"), raised("5mm^3", "(5mm)^3", "5 * 1mm^3"));
    for sure in ["let a = (20mm)^2;", "let a = 1mm^2;", "let a = 20^2;", "let a = 20mm2;"] {
        assert_eq!(plane(sure), Vec::<String>::new(), "{sure}");
    }
}

#[test]
fn turns_as_angles_are_doubted() {
    let turns = "`f * t` counts turns, and as an angle it is taken in radians\nhelp: write `1turn * f * t`, or give an `AngularVelocity` instead of a \
                 `Frequency`";
    assert_eq!(plane("param f: Frequency = 5; let s = sin(f * t);"), [turns]);
    assert_eq!(plane("param f: Frequency = 5; let s = sin(2 * pi * f * t);"), Vec::<String>::new());
    assert_eq!(plane("param f: Frequency = 5; drive d = drive_angle(b, f * t);"), [turns]);
    assert_eq!(plane("param f: Frequency = 5; drive d = drive_angle(b, 1turn * f * t);"), Vec::<String>::new());
    let speed = "`1 / 0.5s` is a number of radians a second\nhelp: write `120rpm` for as many turns, or `rad_s` if radians are meant";
    assert_eq!(plane("param w: AngularVelocity = 1/0.5s;"), [speed]);
    for sure in ["param w: AngularVelocity = 2rad / 1s;", "param f: Frequency = 1/0.5s;", "param w: AngularVelocity = 2rad_s;"] {
        assert_eq!(plane(sure), Vec::<String>::new(), "{sure}");
    }
    let periods = |written: &str, instead: &str| vec![format!("`{written}` is taken in radians\nhelp: write `{instead}`")];
    assert_eq!(plane("param T: Time = 1s; drive d = drive_angle(b, t / T);"), periods("t / T", "1turn * t / T"));
    assert_eq!(plane("param T: Time = 1s; drive d = drive_angle(b, 360 * t / T);"), periods("360 * t / T", "360deg * t / T"));
    assert_eq!(plane("drive d = drive_angle(b, t / 2s);"), periods("t / 2s", "1turn * t / 2s"));
    assert_eq!(plane("drive d = drive_angle(b, 90 * t / 1s);"), periods("90 * t / 1s", "90deg * t / 1s"));
    assert_eq!(plane("drive d = drive_angle(b, 3000 * t / 60s);"), periods("3000 * t / 60s", "3000rpm * t"));
    assert_eq!(plane("drive d = drive_angle(b, 360 * t / 60s);"), periods("360 * t / 60s", "360deg * t / 60s"));
    let rise =
        "`cycloidal(t / 2s)` leads from 0 to 1, and as an angle to 1 rad\nhelp: write `90deg * cycloidal(t / 2s)` for a quarter of a turn";
    assert_eq!(plane("drive d = drive_angle(b, cycloidal(t / 2s));"), [rise]);
    for sure in ["t / 1s", "2 * t / 1s", "90deg * cycloidal(t / 2s)", "1turn * t / 2s"] {
        assert_eq!(plane(&format!("drive d = drive_angle(b, {sure});")), Vec::<String>::new(), "{sure}");
    }
    for sure in ["1turn * t / T", "360deg * t / T", "2 * pi * t / T", "3rad * t / T"] {
        assert_eq!(plane(&format!("param T: Time = 1s; drive d = drive_angle(b, {sure});")), Vec::<String>::new(), "{sure}");
    }
}

#[test]
fn angles_in_degrees_are_doubted() {
    let degrees = "`b.angle * 180 / pi` is an angle, and outputs of angles are in rad: it is 57 times too large\nhelp: write `b.angle / 1deg` for \
                   the number of degrees, or `.to_degrees()` in Rust";
    assert_eq!(plane("output a = b.angle * 180 / pi;"), [degrees]);
    for sure in [
        "output a = b.angle;",
        "output a = 180 / pi;",
        "output a = b.angle * 90 / pi;",
        "output a = sin(b.angle) * 180 / pi;",
        "output a = b.angle * 180Nm / pi;",
    ] {
        assert_eq!(plane(sure), Vec::<String>::new(), "{sure}");
    }
}

#[test]
fn arguments_of_gears_are_doubted() {
    let swapped =
        "`carrier` is in the place of the ring gear\nhelp: write `planetary(sun, ring, carrier, …)`: sun gear, ring gear, carrier";
    let train = |bodies: &str| {
        plane(&format!("body sun {{}} body ring {{}} body carrier {{}} body ring_carrier {{}} joint p = planetary({bodies}, 24, 72);"))
    };
    assert_eq!(train("sun, carrier, ring"), [swapped]);
    for sure in ["sun, ring, carrier", "sun, ring_carrier, ring", "carrier, ring, sun"] {
        assert_eq!(train(sure), Vec::<String>::new(), "{sure}");
    }
    let phase = |written: &str, gears: &str| {
        vec![format!(
            "`{written}` is `c` of `{gears}`, the angle in which the gears mesh at the start, and no size of a gear\nhelp: take it away: two sizes \
             belong to `{gears}`, and pressure angles do not matter; or write `c: {written}`"
        )]
    };
    let pair = |sizes: &str| plane(&format!("body c {{}} joint g = gear_pair(b, c, {sizes});"));
    assert_eq!(pair("20, 40, 20deg"), phase("20deg", "gear_pair"));
    assert_eq!(pair("20, 40, 60"), phase("60", "gear_pair"));
    let thirds = plane("body sun {} body ring {} body carrier {} joint p = planetary(sun, ring, carrier, 20, 40, 60);");
    assert_eq!(thirds, phase("60", "planetary"));
    for sure in ["20, 40", "20, 40, 0", "20, 40, 30deg", "20, 40, c: 20deg"] {
        assert_eq!(pair(sure), Vec::<String>::new(), "{sure}");
    }
}

#[test]
fn coefficients_and_lengths_of_forces_are_doubted() {
    let pad = |coefficient: &str| {
        let pad = "friction(ground.position, (1, 0), c.position, 20N, «», 1mm_s)".replace("«»", coefficient);
        plane(&format!("body c {{ mass = 1kg; }} force f = {pad};"))
    };
    let percentage = "a coefficient of friction of 20 is rare\nhelp: write `0.2` for 20 per cent";
    assert_eq!(pad("20"), [percentage]);
    assert_eq!(pad("0.2"), Vec::<String>::new());
    let spring = |force: &str| plane(&format!("body c {{ point P = (1m, 0m); mass = 1kg; }} force k = {force};"));
    let meant = "help: take the minus away, or name the number with `let` if it is meant";
    let pushes = format!("`-200N_m` pushes away from rest\n{meant}");
    assert_eq!(spring("spring((5m, 0m), c.P, -200N_m, rest: 1m)"), [pushes.as_str()]);
    assert_eq!(spring("torsion_spring(ground, c, stiffness: -5Nm_rad, rest: 0deg)"), [pushes.replace("200N_m", "5Nm_rad")]);
    let damping = format!("`-3Ns_m` drives the motion instead of damping it\n{meant}");
    assert_eq!(spring("damper((5m, 0m), c.P, -3Ns_m)"), [damping.as_str()]);
    assert_eq!(spring("torsion_damper(ground, c, -3Nms_rad)"), [damping.replace("3Ns_m", "3Nms_rad")]);
    let rest = format!("`-1m` is negative, and no rest length is\n{meant}");
    let distance = format!("`-1m` is negative, and no distance is\n{meant}");
    let rod = |law: &str| plane(&format!("body c {{ point P = (1m, 0m); }} drive e = drive_distance((5m, 0m), c.P, {law});"));
    for law in ["-1m - 2mm_s * t", "-1m", "-1m + 2mm * sin(1rad_s * t)"] {
        assert_eq!(rod(law), [distance.as_str()], "{law}");
    }
    for sure in ["1m - 2mm_s * t", "-1m + 3m", "-1m + 2mm_s * t + 3m", "-1m + (3m + 2mm_s * t)", "-1m + 3m * cos(1rad_s * t)"] {
        assert_eq!(rod(sure), Vec::<String>::new(), "{sure}");
    }
    assert_eq!(spring("spring((5m, 0m), c.P, 200N_m, rest: -1m)"), [rest.as_str()]);
    for sure in ["spring((5m, 0m), c.P, 200N_m, rest: 1m)", "actuator((5m, 0m), c.P, -200N)", "torsion_spring(ground, c, 5Nm_rad, -3deg)"] {
        assert_eq!(spring(sure), Vec::<String>::new(), "{sure}");
    }
}

#[test]
fn forces_along_a_velocity_are_doubted() {
    let driving = |clause: &str, without: &str| {
        let found = format!(
            "`{without}` drives the motion instead of damping it\nhelp: write `-{without}`, or name the number with `let` if it is meant"
        );
        assert_eq!(plane(&format!("body c {{ point P = (1m, 0m); mass = 1kg; }} force f = {{ {clause}; }}")), [found]);
    };
    driving("on c: 0.02Nms * c.angular_velocity", "0.02Nms * c.angular_velocity");
    driving("at c.P: 3Ns_m * rate(c.P)", "3Ns_m * rate(c.P)");
    for sure in ["on c: -0.02Nms * c.angular_velocity", "on c: 0.02Nms * b.angular_velocity", "at c.P: 3Ns_m * rate(b.position)"] {
        assert_eq!(plane(&format!("body c {{ point P = (1m, 0m); mass = 1kg; }} force f = {{ {sure}; }}")), Vec::<String>::new(), "{sure}");
    }
}

#[test]
fn drives_that_jump_are_doubted() {
    let jump = |law: &str| plane(&format!("drive d = drive_angle(b, {law});"));
    let leap = |from: &str, to: &str, law: &str| {
        vec![format!(
            "the drive jumps from {from} to {to} at t = 1s, and no body can move like that\nhelp: move from one to the other gradually, for example with `{law}`; if the jump is intended, name one of the values with `let`"
        )]
    };
    let law = "10deg + (40deg - 10deg) * cycloidal((t - 1s) / 0.5s)";
    for written in ["if t < 1s { 10deg } else { 40deg }", "if 1s <= t { 40deg } else { 10deg }", "if t > 1s { 40deg } else { 10deg }"] {
        assert_eq!(jump(written), leap("10deg", "40deg", law), "{written}");
    }
    assert_eq!(jump("if t < 1s { 0deg } else { 40deg }"), leap("0deg", "40deg", "40deg * cycloidal((t - 1s) / 0.5s)"));
    for sure in ["if t < 1s { 40deg } else { 40deg }", "if t < 1s { 1rad_s * t } else { 1rad }", "if b.x < 1m { 10deg } else { 40deg }"] {
        assert_eq!(jump(sure), Vec::<String>::new(), "{sure}");
    }
}

#[test]
fn rates_of_constants_and_of_inputs_are_doubted() {
    let by_time = "`rate(w) * t` is not `w`: its rate at one instant acts over all the time before it\nhelp: write `w`";
    assert_eq!(plane("input w: Angle; drive d = drive_angle(b, rate(w) * t);"), [by_time]);
    let constant = "`r` does not change with time: its rate is 0\nhelp: a quantity that changes is an `input`";
    assert_eq!(plane("param r: Length = 1m; output v = rate(r);"), [constant]);
    for sure in [
        "input r: Length = 1m; output v = rate(r);",
        "param r: Length = 1m; body c {} joint j = { let r = c.x - b.x; rate(r) == 1m_s; }",
        "param r: Length = 1m; function f(r: Angle) -> Velocity = 1m * rate(r); output v = f(b.angle);",
    ] {
        assert_eq!(plane(sure), Vec::<String>::new(), "{sure}");
    }
    let twice = "`b.angle - c.angle` is an angle already, and `acos` takes a number\nhelp: write `b.angle - c.angle`";
    assert_eq!(plane("body c {} output m = acos(b.angle - c.angle);"), [twice]);
    let jumps = "a change of `w` acts over all the time before it: `w * t` jumps\nhelp: a commanded speed is a `param` of a mechanism that is \
                 `#[integrated]`: see the page on control loops";
    assert_eq!(plane("input w: AngularVelocity; drive d = drive_angle(b, w * t);"), [jumps]);
}

#[test]
fn free_fall_is_doubted_upwards_without_masses_and_in_other_units() {
    let massless = "gravity acts on masses, and no body has one\nhelp: write `mass = 1kg;` in a body, or take `gravity` away";
    assert_eq!(plane("gravity = (0, -9.81m_s2);"), [massless]);
    let in_a_part = "gravity = (0, -9.81m_s2); component Weight(P: Point) { body w { mass = 1kg; } joint o = revolute(P, w.position); \
                     drive d = drive_angle(w, 1rad_s * t); } part w = Weight((1m, 0m));";
    assert_eq!(plane(in_a_part), Vec::<String>::new());
    let gravity =
        |found: &str| vec![format!("the acceleration of free fall is {found} here, and 9.81 m/s² on Earth\nhelp: write `-9.81m_s2`")];
    assert_eq!(plane("body c { mass = 1kg; } gravity = (0, -9810);"), gravity("9810 m/s²"));
    assert_eq!(plane("body c { mass = 1kg; } gravity = (0, -1.62m_s2);"), Vec::<String>::new());
    let upwards = "gravity points upwards here\nhelp: write `-9.81m_s2`, or name the number with `let` if it is meant";
    assert_eq!(plane("body c { mass = 1kg; } gravity = (0, 9.81m_s2);"), [upwards]);
    assert_eq!(doubts("in space", "body c { mass = 1kg; } gravity = (0, 0, 9.81m_s2);"), [upwards]);
    for sure in ["gravity = (9.81m_s2, 0);", "gravity = (0, 1.62m_s2);", "let g = 9.81m_s2; gravity = (0, g);"] {
        assert_eq!(plane(&format!("body c {{ mass = 1kg; }} {sure}")), Vec::<String>::new(), "{sure}");
    }
}

#[test]
fn masses_that_lie_elsewhere_are_doubted() {
    let wide = "the inertia of `c` is that of its mass at a distance of 86600 mm, where no length exceeds 300 mm\nhelp: a number without a unit is \
                in kg m²; write `kgm2`, `kgcm2` or `kgmm2`";
    let inertia = |inertia: &str| plane(&format!("body c {{ point P = (300mm, 0mm); mass = 2kg; inertia = {inertia}; }}"));
    assert_eq!(inertia("15000"), [wide]);
    for sure in ["0.015", "15000kgm2"] {
        assert_eq!(inertia(sure), Vec::<String>::new());
    }
    let center =
        "`center` is a point here, and the centre of mass of `c` is its origin\nhelp: write `center = (…);` for the centre of mass";
    assert_eq!(plane("body c { mass = 1kg; point center = (1mm, 0mm); }"), [center]);
    for sure in ["point center = (1mm, 0mm); center = (1mm, 0mm);", "point center = (0mm, 0mm);"] {
        assert_eq!(plane(&format!("body c {{ mass = 1kg; {sure} }}")), Vec::<String>::new());
    }
    let rod = |point: &str| {
        doubts("in space", &format!("body c {{ mass = 1kg; point P = {point}; center = (1mm, 0mm, 0mm); inertia = rod(300mm); }}"))
    };
    let across = "a rod lies along x, but `P` of `c` lies across it\nhelp: write `inertia = rod(300mm) along turn((0, 0, 1), 90deg);`";
    assert_eq!(rod("(0mm, 300mm, 0mm)"), [across]);
    assert_eq!(rod("(0mm, 0mm, -300mm)"), [across.replace("(0, 0, 1), 90deg", "(0, 1, 0), 90deg")]);
    assert_eq!(rod("(300mm, 0mm, 0mm)"), Vec::<String>::new());
}
