//! Valid declarations as a starting point.

use crate::random::Random;
use proc_macro2::TokenStream;
use std::str::FromStr;

/// Macro that a source belongs to.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Kind {
    Mechanism,
    Constraint,
}

/// The example of the README.
const CRANK_ROCKER: &str = "
    /// A Grashof crank-rocker turned at constant speed.
    pub mechanism CrankRocker {
        param speed: AngularVelocity = 60rpm;
        param crank_length: Length = 100mm;
        ground { point O = (0mm, 0mm); point C = (400mm, 0mm); }
        body crank { point O = (0mm, 0mm); point A = (crank_length, 0mm); }
        body coupler { point A = (0mm, 0mm); point B = (350mm, 0mm); point P = (175mm, 80mm); }
        body rocker { point C = (0mm, 0mm); point B = (300mm, 0mm); start angle = 70deg; }
        joint o = revolute(ground.O, crank.O);
        joint a = revolute(crank.A, coupler.A);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.C, ground.C);
        drive input = drive_angle(crank, speed * t);
        output tip = coupler.P;
        output transmission = rocker.angle - coupler.angle;
    }";

/// A cam with a table, functions and laws.
const CAM: &str = "
    #[picture]
    pub mechanism Cam {
        param base: Length = 30mm;
        let lift: Length = 10mm;
        function rise(a: Angle) -> Length = base + table(a, [(0deg, 0mm), (90deg, 5mm), (180deg, 10mm), (360deg, 0mm)], periodic);
        function law(x: Number) -> Number = if x < 0 { 0 } else { if x > 1 { 1 } else { polynomial_345(x) } };
        function measured(Angle) -> Length = crate::cam::measured;
        ground { point O = (0mm, 0mm); axis u = (0, 1); }
        body cam { point O = (0mm, 0mm); }
        body follower { point C = (0mm, 40mm); start position = (0mm, 40mm); }
        joint o = revolute(ground.O, cam.O);
        joint slide = translational(ground.u, ground.O, follower.C);
        joint contact = cam_roller(cam.O, follower.C, 5mm, rise);
        drive turn = drive_angle(cam, 2 * pi * smooth_step(t / 1s) + law(0.5));
        output program = segments(cam.angle, 0mm, [rise(2mm, 90deg, cycloidal), dwell(180deg), fall(2mm, 90deg, law)], periodic);
        output height = follower.y;
        output speed_ratio = measured(cam.angle) / lift;
    }";

/// Equations written inline, and no solver.
const EQUATIONS: &str = "
    #[equations_only]
    mechanism Odd {
        param a: Length = 0.2;
        param n: Number = sqrt(2)^2 + min(1, 2) * max(-3, 2);
        let v = (a, a) * 2 - perp((a, 0mm)) / n;
        body one { point P = (a, -a); axis u = (1, 1); start x = a; start y = -2 * a; }
        body two { point Q = v; axis w = unit((3, 4)); }
        joint ellipse = { let F = (0mm, 0mm); norm(one.P - F) + norm(one.P - (a, 0mm)) == 4 * a; require a > 0: \"a is positive\"; }
        joint angle = { atan2(two.w.y, one.u.x) == sin(acos(0.5))^1.5 * asin(0.1); dot(one.P, two.Q) == cross(one.P, two.Q) * ln(exp(1)) ; }
        drive push = { direction(one.P - two.Q) == 3rad_s * t; }
        output where_ = one.P - two.Q;
        output x = abs(two.x)^1000 * sin(t / 1s)^3;
    }";

/// Gears, belts and a chain of joints.
const GEARS: &str = "
    mechanism Train {
        ground { point O = (0mm, 0mm); point C = (100mm, 0mm); }
        body sun { point O = (0mm, 0mm); }
        body carrier { point O = (0mm, 0mm); point P = (50mm, 0mm); }
        body planet { point P = (0mm, 0mm); }
        joint s = revolute(ground.O, sun.O);
        joint k = revolute(ground.O, carrier.O);
        joint p = revolute(carrier.P, planet.P);
        joint m = gear_pair(sun, planet, 20, 30, carrier: carrier);
        joint r = gear_pair(planet, ground, 30, -80, 0, carrier);
        drive turn = drive_relative_angle(ground, sun, 10rpm * t);
        output ratio = carrier.angle / 1rad;
    }";

/// Components, parts, loops and arrays.
const WALKER: &str = "
    mechanism Walker {
        param speed: AngularVelocity = 1rad_s;
        param trim[0]: Angle = 1deg;
        let legs = 2;
        ground { point O = (0m, 0m); for i in 0..=legs { point V[i] = (i * 1m, 0m); } }
        body crank { point O = (0m, 0m); for i in 0..legs { point X[i] = (10mm * (i + 1), 0m); } }
        component Leg(pivot: Point, pin: Point, turn: Angle = 0deg) {
            param shank: Length = 900mm;
            let half = shank / 2;
            body upper { point V = (0m, 0m); point U = (shank, 0m); axis u = (1, 0); start angle = 1rad + turn; start position = (1m, 0m); }
            body lower { point X = (0m, 0m); point U = (half * 2, 0m); start angle = 2rad; start position = (0m, 0m); }
            joint v = revolute(pivot, upper.V);
            joint x = revolute(pin, lower.X);
            joint u = revolute(upper.U, lower.U);
            part foot = Foot(upper.U, 2);
            output knee = upper.U;
        }
        component Foot(P: Point, n: Number) {
            body toe[0] { point P = (0m, 0m); }
            for k in 1..n { body toe[k] { point P = (k * 10mm, 0m); } joint w[k] = parallel(toe[k - 1], toe[k]); joint r[k] = revolute(P, toe[k].P); }
            joint p = revolute(P, toe[0].P);
            joint a = absolute_angle(toe[0], 0.1 * n * 1rad);
            output toe[0] = toe[0];
        }
        for i in 0..legs { part leg[i] = Leg(ground.V[(i + 1) % legs + 1], crank.X[i], turn: trim[0] * i); }
        for i in 0..2 { for j in 0..2 { let grid[i][j] = i + 2 * j; } }
        joint o = revolute(ground.O, crank.O);
        drive d = drive_angle(crank, speed * t);
        output last = leg[legs - 1].foot.toe[1].P;
        output sum = leg[0].upper.angle + leg[1].upper.angle * grid[1][1];
    }";

/// A parallelogram with a redundant joint.
const COUPLED: &str = "
    pub mechanism Coupled {
        param middle: Length = 500mm;
        ground { point A = (0m, 0m); point B = (2m, 0m); point C = (1m, 0m); }
        body crank { point P = (500mm, 0mm); }
        body rod { point Q = (2m, 0m); point R = (1m, 0m); }
        body rocker { point P = (500mm, 0mm); }
        body third { point P = (middle, 0mm); }
        joint a = revolute(ground.A, crank.position);
        joint b = revolute(ground.B, rocker.position);
        joint c = revolute(crank.P, rod.position);
        joint d = revolute(rod.Q, rocker.P);
        joint e = revolute(ground.C, third.position);
        redundant joint f = revolute(rod.R, third.P);
        redundant joint g[0] = { 2 * rod.angle == 0; crank.x + rod.angle * 1m == 0; }
        drive input = drive_angle(crank, 60deg + 1rad_s * t);
        output lean = third.angle;
    }";

/// Definitions of constraints.
const DEFINITIONS: &str = "
    /// An ellipse.
    pub constraint on_ellipse(P: Point, F: Point, G: Point, a: Length, n: Number = 2) {
        require a > 0: \"an ellipse has an axis\";
        let sum = norm(P - F) + norm(P - G);
        sum == n * a;
    }
    pub(crate) bundle more {
        constraint law(j: Joint(translational), f: Function(Angle) -> Length, b: Body = ground, q: Quantity = 1) { dot(unit(j.u), j.Q - j.P) == f(b.angle) * q; }
        constraint two(P: Point, u: Axis, c: Angle = 0) { P.x == 0; direction(u) - P.body.angle == c; }
    }";

/// Items that are valid in any mechanism.
const ITEMS: &[&str] = &[
    "use crate::library::{rolling, sliding as gliding};",
    "use elsewhere::on_ellipse;",
    "function f0(x: Number) -> Number = x + x; function f1(x: Number) -> Number = f0(x) + f0(x + 1); function f2(x: Number) -> Number = f1(f1(x)) * f1(x); \
     function f3(x: Number) -> Number = f2(f2(x)) / f2(x - 1); function f4(x: Number) -> Number = f3(f3(f3(x))); output explosion = f4(f4(t / 1s));",
    "output power = ((t / 1s)^1000)^1000;",
    "output tower = 2^2^2^2^2^(t / 1s)^2^2;",
    "let a0 = a1 + 1; let a1 = a2 + 1; let a2 = a3 * a0;",
    "output spline = table(t, [(0, 0), (1e-30, 1), (2e-30, 1e30), (1e30, 5)], hold);",
    "body extra { point A = (0mm, 0mm); point B = (1mm, 0mm); } joint e = distance(extra.A, ground.position, 5mm); joint g = weld(extra.A, ground.position);",
    "joint same = { ground.x == 0; }",
    "for i in 0..3 { body many[i] { point P = (i * 1mm, 0mm); } joint hold[i] = weld(many[i].P, ground.position); }",
    "component Pin(P: Point) { body pin { point P = (0mm, 0mm); } joint w = weld(P, pin.P); } for i in 0..2 { for j in 0..2 { part pin[i][j] = Pin((i * 1m, j * 1m)); } }",
    "component A0(n: Number) { part a[0] = A1(n); part a[1] = A1(n + 1); } component A1(n: Number) { for i in 0..2 { part b[i] = A2(2 * n, i); } } \
     component A2(n: Number, m: Number) { for i in 0..9 { for j in 0..9 { let c[i][j] = n * i + m * j; } } } for i in 0..5 { part tree[i] = A0(i); }",
    "for i in 0..9999 { for j in 0..9999 { let huge[i][j] = 1; } }",
    "param zero: Length = 0; joint z = distance((0mm, 0mm), (1mm, 0mm), zero);",
    "output chain = sin(cos(tan(asin(acos(atan(sqrt(exp(ln(abs(t / 1s))))))))));",
];

/// Picks a declaration.
pub(crate) fn pick(random: &mut Random) -> (Kind, TokenStream) {
    let pages: Vec<(&str, &str)> = reuleaux_compiler::library::pages().collect();
    match random.below(10) {
        0 => (Kind::Mechanism, tokens(CRANK_ROCKER)),
        1 => (Kind::Mechanism, tokens(COUPLED)),
        8 | 9 => (Kind::Mechanism, tokens(WALKER)),
        2 => (Kind::Mechanism, tokens(CAM)),
        3 => (Kind::Mechanism, tokens(EQUATIONS)),
        4 => (Kind::Mechanism, tokens(GEARS)),
        5 => (Kind::Constraint, tokens(DEFINITIONS)),
        _ => page(random.of(&pages).1),
    }
}

/// A page of the library as a source of its own.
fn page(text: &str) -> (Kind, TokenStream) {
    let is_function = text.lines().any(|line| line.starts_with("function"));
    if is_function {
        return (
            Kind::Mechanism,
            tokens(&format!(
                "mechanism Law {{ {text}\n body crank {{}} drive place = {{ crank.position == (0mm, 0mm); crank.angle == t * 1rpm; }} }}"
            )),
        );
    }
    (Kind::Constraint, tokens(text))
}

/// A definition of the library.
pub(crate) fn definition(random: &mut Random) -> TokenStream {
    let pages: Vec<(&str, &str)> = reuleaux_compiler::library::pages().collect();
    tokens(random.of(&pages).1)
}

/// Items to be added to a mechanism; occasionally thousands of them.
pub(crate) fn item(random: &mut Random) -> TokenStream {
    match random.below(100) {
        0 => {
            let pairs: Vec<String> = (0..10_000).map(|i| format!("({i}, {})", i % 7)).collect();
            tokens(&format!("output points = table(t, [{}]);", pairs.join(", ")))
        }
        1 => tokens(&format!("output sum = {};", vec!["t"; 190].join(" + "))),
        2 => tokens(&(0..300).map(|i| format!("let c{i} = c{} + 1;", i + 1)).collect::<String>()),
        3 => tokens(&(0..30).map(|i| format!("body b{i} {{ point A = ({i}mm, 0mm); }}")).collect::<String>()),
        _ => tokens(random.of::<&str>(ITEMS)),
    }
}

fn tokens(text: &str) -> TokenStream {
    TokenStream::from_str(text).expect("the corpus consists of tokens")
}

/// The sources are accepted before they are mutated.
#[test]
fn the_corpus_is_accepted() {
    for text in [CRANK_ROCKER, CAM, EQUATIONS, GEARS, COUPLED] {
        accepted(Kind::Mechanism, tokens(text), text);
    }
    accepted(Kind::Constraint, tokens(DEFINITIONS), DEFINITIONS);
    for (_, text) in reuleaux_compiler::library::pages() {
        let (kind, tokens) = page(text);
        accepted(kind, tokens, text);
    }
}

fn accepted(kind: Kind, tokens: TokenStream, text: &str) {
    let refusals = match kind {
        Kind::Mechanism => reuleaux_compiler::compile(tokens).err(),
        Kind::Constraint => reuleaux_compiler::check_constraint(tokens).err(),
    };
    let said: Vec<String> = refusals.into_iter().flatten().map(|refusal| refusal.fact.to_string()).collect();
    assert!(said.is_empty(), "{said:?} in {text}");
}
