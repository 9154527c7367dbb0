//! Elements of random mechanisms: cranks, dyads, gears, belts, racks and slides, each attached to existing bodies.
//!
//! Every element has as many equations as coordinates and is well away from its dead points at t = 0, so that the mechanism has a unique
//! assembly near its start.

use super::model::{Model, Place, Sort, Vector, between, length, one, sum, turned, way};
use fastrand::Rng;
use std::f64::consts::PI;

/// Smallest distance of a dyad from its stretched or folded configuration, relative to the distance that it spans.
const MARGIN: f64 = 0.15;

/// Smallest distance that a dyad spans, m.
const NEAREST: f64 = 0.02;

const DYAD: &str = "component Dyad(P: Point, Q: Point, a: Length, b: Length, one: Angle, other: Angle) { \
    body first { axis u = (0.8, 0.6); point end = (a, 0mm); start angle = one; } \
    body second { axis u = (0.8, 0.6); point end = (b, 0mm); start angle = other; } \
    joint p = revolute(P, first.position); joint q = revolute(Q, second.position); joint knee = revolute(first.end, second.end); }";

/// A mechanism of random elements in random order, with at least a crank and a dyad.
pub(super) fn random(rng: &mut Rng) -> Model {
    let mut model = Model { says_where: rng.u8(..4) > 0, ..Model::default() };
    ground(&mut model, rng);
    crank(&mut model, rng);
    while !dyad(&mut model, rng, false) {}
    for _ in 0..rng.usize(..4) {
        match rng.u8(..10) {
            0 => crank(&mut model, rng),
            1 | 2 => drop(dyad(&mut model, rng, false)),
            3 => drop(dyad(&mut model, rng, true)),
            4 | 5 => slider_dyad(&mut model, rng),
            6 => meshing(&mut model, rng),
            7 => rack(&mut model, rng),
            8 => slide(&mut model, rng),
            _ => row(&mut model, rng),
        }
    }
    output(&mut model, rng);
    rng.shuffle(&mut model.items);
    model
}

/// Ground with some points and an axis.
fn ground(model: &mut Model, rng: &mut Rng) {
    let ground = model.body("ground", [0.0, 0.0], 0.0, &[]);
    let points: Vec<String> = (0..4)
        .map(|index| {
            let (name, at) = (format!("G{index}"), [between(rng, -0.4, 0.4), between(rng, -0.4, 0.4)]);
            model.place(ground, &name, at);
            format!("point {name} = {};", model.pair(rng, at))
        })
        .collect();
    model.item(Sort::Other, "ground", &format!("ground {{ {} axis u = (1, 0); }}", points.join(" ")), &[]);
}

/// `body name { … }` with one or two points and sometimes a start.
fn body(model: &mut Model, rng: &mut Rng, words: &[&str], origin: Vector, angle: f64, follows: &[usize], start: &str) -> usize {
    let name = model.name(rng, words);
    let body = model.body(&name, origin, angle, follows);
    let mut text = format!("body {name} {{ axis u = (0.8, 0.6);");
    for point in ["A", "B"].iter().take(rng.usize(1..3)) {
        let at = [between(rng, 0.05, 0.2), between(rng, -0.1, 0.1)];
        model.place(body, point, at);
        text += &format!(" point {point} = {};", model.pair(rng, at));
    }
    // The given part of the start; completed if the model declares all positions.
    text += &format!(" {start}");
    if model.says_where && !start.contains("start position") {
        text += &format!(" start position = {};", model.pair(rng, origin));
    }
    if model.says_where && !start.contains("start angle") {
        text += &format!(" start angle = {};", degrees(angle));
    }
    model.item(Sort::Body, &name, &format!("{text} }}"), &[body]);
    body
}

fn somewhere(model: &Model, rng: &mut Rng) -> Place {
    one(rng, &model.places).clone()
}

fn path(model: &Model, body: usize) -> String {
    model.bodies[body].path.clone()
}

fn degrees(angle: f64) -> String {
    format!("{:.0}deg", angle.to_degrees())
}

/// A body that turns about a point of another one by a law of time.
fn crank(model: &mut Model, rng: &mut Rng) {
    let hinge = if model.bodies.len() == 1 { one(rng, &model.places).clone() } else { somewhere(model, rng) };
    let (phase, speed) = (between(rng, -PI, PI).to_degrees().round().to_radians(), rng.i32(5..100));
    let body = body(model, rng, &["crank", "arm", "Lever", "wheel"], hinge.at, phase, &[hinge.body], "");
    let name = path(model, body);
    model.joint(rng, &format!("revolute({}, {name}.position)", hinge.path), &[hinge.body, body]);
    // The angle of a crank on a gear that has turned would be declared only up to whole turns; it is therefore driven relative to ground.
    model.drive(rng, &format!("drive_angle({name}, {} + {speed}rpm * t)", degrees(phase)), &[body]);
}

/// Two bars with three pins between two points; true if there was room for them.
fn dyad(model: &mut Model, rng: &mut Rng, is_part: bool) -> bool {
    let (p, q) = (somewhere(model, rng), somewhere(model, rng));
    let (span, base) = (length(way(p.at, q.at)), direction(way(p.at, q.at)));
    if span < NEAREST || p.body == q.body {
        return false;
    }
    let a = span * between(rng, 0.6, 1.5);
    let (shortest, longest) = ((1.0 + MARGIN) * span - a, a + (1.0 - MARGIN) * span);
    let b = between(rng, shortest.max(a - (1.0 - MARGIN) * span).max(0.2 * span), longest);
    // Law of cosines, with the knee on either side.
    let side = if rng.bool() { 1.0 } else { -1.0 };
    let at_p = base + side * ((a * a + span * span - b * b) / (2.0 * a * span)).acos();
    let knee = sum(p.at, turned([a, 0.0], at_p));
    let at_q = direction(way(q.at, knee));
    let follows = [p.body, q.body];
    if is_part {
        if !model.items.iter().any(|item| item.name == "Dyad") {
            model.item(Sort::Other, "Dyad", DYAD, &[]);
        }
        let name = model.name(rng, &["dyad", "leg"]);
        let first = model.body(&format!("{name}.first"), p.at, at_p, &follows);
        let second = model.body(&format!("{name}.second"), q.at, at_q, &follows);
        let (a, b, one, other) = (model.length(rng, a), model.length(rng, b), degrees(at_p), degrees(at_q));
        let text = format!("part {name} = Dyad({}, {}, {a}, b: {b}, one: {one}, other: {other});", p.path, q.path);
        model.item(Sort::Other, &name, &text, &[first, second]);
        model.places.push(Place { path: format!("{name}.first.end"), body: first, at: knee });
        return true;
    }
    let mut bar = |from: &Place, angle: f64, length: f64, model: &mut Model| {
        let end = model.pair(rng, [length, 0.0]);
        let start = format!("point end = {end}; start angle = {};", degrees(angle));
        let body = body(model, rng, &["rod", "link", "bar", "coupler"], from.at, angle, &follows, &start);
        let name = path(model, body);
        model.joint(rng, &format!("revolute({}, {name}.position)", from.path), &[from.body, body]);
        body
    };
    let (first, second) = (bar(&p, at_p, a, model), bar(&q, at_q, b, model));
    let ends = format!("revolute({}.end, {}.end)", path(model, first), path(model, second));
    model.joint(rng, &ends, &[first, second]);
    true
}

/// A bar from a point to a slider on a line of another body.
fn slider_dyad(model: &mut Model, rng: &mut Rng) {
    let (p, line) = (somewhere(model, rng), somewhere(model, rng));
    let (along, angle) = (axis(model, line.body), model.bodies[line.body].angle);
    let out = way(line.at, p.at);
    let foot = out[0] * along[0] + out[1] * along[1];
    let height = (along[0] * out[1] - along[1] * out[0]).abs();
    let rod = height * 1.3 + between(rng, 0.05, 0.25);
    let offset = (rod * rod - height * height).sqrt() * if rng.bool() { 1.0 } else { -1.0 };
    let at = sum(line.at, [along[0] * (foot + offset), along[1] * (foot + offset)]);
    let follows = [p.body, line.body];
    let (end, place) = (model.pair(rng, [rod, 0.0]), model.pair(rng, at));
    let leaning = direction(way(p.at, at));
    let start = format!("point end = {end}; start angle = {};", degrees(leaning));
    let bar = body(model, rng, &["rod", "link", "conrod"], p.at, leaning, &follows, &start);
    let slider = body(model, rng, &["piston", "slider", "collar"], at, angle, &follows, &format!("start position = {place};"));
    let (bar_name, slider_name) = (path(model, bar), path(model, slider));
    model.joint(rng, &format!("revolute({}, {bar_name}.position)", p.path), &[p.body, bar]);
    model.joint(rng, &format!("revolute({bar_name}.end, {slider_name}.position)"), &[bar, slider]);
    let guide = format!("translational({}.u, {}, Q: {slider_name}.position)", path(model, line.body), line.path);
    model.joint(rng, &guide, &[line.body, slider]);
}

/// A gear or a pulley on ground, turned by another body.
pub(super) fn meshing(model: &mut Model, rng: &mut Rng) {
    let hub = one(rng, &model.places[..4]).clone();
    let turning = rng.usize(1..model.bodies.len());
    let (a, b) = (f64::from(rng.u32(12..80)), f64::from(rng.u32(12..80)));
    let (kind, sign) = *one(rng, &[("gear_pair", -1.0), ("belt", 1.0)]);
    let angle = sign * model.bodies[turning].angle * a / b;
    let wheel = body(model, rng, &["gear", "Wheel", "pulley"], hub.at, angle, &[turning], "");
    let (driver, name) = (path(model, turning), path(model, wheel));
    model.joint(rng, &format!("revolute({}, {name}.position)", hub.path), &[hub.body, wheel]);
    let sizes = if rng.bool() { format!("{a}, {b}") } else { format!("{a}mm, b: {b}mm") };
    model.joint(rng, &format!("{kind}({driver}, {name}, {sizes})"), &[turning, wheel]);
}

/// A rack on ground, pushed by another body.
fn rack(model: &mut Model, rng: &mut Rng) {
    let origin = one(rng, &model.places[..4]).clone();
    let turning = rng.usize(1..model.bodies.len());
    let radius = between(rng, 0.01, 0.05);
    let at = sum(origin.at, [-radius * model.bodies[turning].angle, 0.0]);
    let rack = body(model, rng, &["rack", "ram"], at, 0.0, &[turning], "");
    let (pinion, name, radius) = (path(model, turning), path(model, rack), model.length(rng, radius));
    model.joint(rng, &format!("translational(ground.u, {}, {name}.position)", origin.path), &[0, rack]);
    let mesh = format!("rack_pinion({pinion}, {name}.position, ground.u, {}, {radius})", origin.path);
    model.joint(rng, &mesh, &[turning, rack]);
}

/// A slide along another body, moved by a law of time.
fn slide(model: &mut Model, rng: &mut Rng) {
    let line = somewhere(model, rng);
    let (along, angle, far) = (axis(model, line.body), model.bodies[line.body].angle, between(rng, -0.1, 0.1));
    let at = sum(line.at, [along[0] * far, along[1] * far]);
    let slide = body(model, rng, &["slide", "carriage", "valve"], at, angle, &[line.body], "");
    let name = path(model, slide);
    let guide = format!("translational({}.u, {}, {name}.position)", path(model, line.body), line.path);
    let guide = model.joint(rng, &guide, &[line.body, slide]);
    model.items.last_mut().expect("the joint was added").is_used = true;
    let far = model.length(rng, far);
    model.drive(rng, &format!("drive_along({guide}, {far} + 5mm * sin(1rad_s * t))"), &[slide]);
}

/// A row of cranks on ground, declared by a loop.
fn row(model: &mut Model, rng: &mut Rng) {
    let (name, many, reach) = (model.name(rng, &["lever", "tappet"]), rng.usize(2..5), between(rng, 0.05, 0.15));
    let written = model.length(rng, reach);
    for index in 0..many {
        let (path, at) = (format!("{name}[{index}]"), [0.1 * index as f64, 0.2]);
        let body = model.body(&path, at, (20.0 * index as f64).to_radians(), &[]);
        model.place(body, "end", [reach, 0.0]);
    }
    let text = format!(
        "for i in 0..{many} {{ body {name}[i] {{ axis u = (0.8, 0.6); point end = ({written}, 0mm); start position = (i * 100mm, 200mm); start angle = i * 20deg; }} \
         joint {name}_hub[i] = revolute((i * 100mm, 200mm), {name}[i].position); \
         drive {name}_law[i] = drive_angle({name}[i], i * 20deg + 30rpm * t); }}"
    );
    model.item(Sort::Other, &name, &text, &[]);
}

/// Outputs: the position of a point and the orientation of a body.
fn output(model: &mut Model, rng: &mut Rng) {
    let (place, body) = (somewhere(model, rng), rng.usize(1..model.bodies.len()));
    let name = path(model, body);
    model.item(Sort::Other, "tip", &format!("output tip = {} - {name}.position;", place.path), &[]);
    model.item(Sort::Other, "turn", &format!("output turn = {name}.angle;"), &[]);
}

/// The axis `u` of a body at t = 0: along x in ground, (0.8, 0.6) elsewhere.
fn axis(model: &Model, body: usize) -> Vector {
    turned(if body == 0 { [1.0, 0.0] } else { [0.8, 0.6] }, model.bodies[body].angle)
}

/// Angle of a vector from the x axis.
fn direction([x, y]: Vector) -> f64 {
    y.atan2(x)
}
