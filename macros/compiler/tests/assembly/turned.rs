//! Starts in space that are turned far away from where a mechanism closes.

use crate::{Random, accepted, refused, samples};
use reuleaux_compiler::diag::{AssemblyFact, Fact};
use std::f64::consts::PI;

type Vector = [f64; 3];

/// A crank and a rocker about parallel hinges, with pins at a height above these, and a rod of 200 mm between the pins. The crank starts upside
/// down.
fn upside_down(height: f64) -> String {
    let far = height.hypot(250.0);
    format!(
        "mechanism Rod in space {{
            ground {{ axis z = (0, 0, 1); point C = (300mm, 0mm, 0mm); }}
            body crank {{ axis z = (0, 0, 1); point A = (80mm, 0mm, {height}mm); start orientation = turn((1, 0, 0), 170deg); }}
            body rocker {{ axis z = (0, 0, 1); point B = (120mm, 0mm, {height}mm); start orientation = turn((0, 0, 1), 140deg); }}
            joint o = revolute(ground.position, ground.z, crank.position, crank.z);
            joint c = revolute(ground.C, ground.z, rocker.position, rocker.z);
            joint rod = distance(crank.A, rocker.B, 200mm);
            drive input = drive_distance(crank.A, ground.C, {far}mm + 10mm_s * t); }}"
    )
}

/// The pin of the crank is 250 mm away from the line of the rocker's hinge, that of the rocker 120 mm. With the hinge of the crank against that
/// of ground, as its start has it, the rod closes while √(200² − (2 height)²) ≥ 250 − 120.
#[test]
fn axes_lie_against_each_other_where_the_start_says_so_and_the_loop_closes() {
    for (height, is_opposed) in [(10.0, true), (60.0, true), (75.0, true), (77.0, false), (150.0, false)] {
        let compiled = accepted(&upside_down(height));
        assert!(compiled.assembly.is_closed);
        assert_eq!(compiled.system.space.has_opposed, is_opposed, "{height} mm");
        // Half a turn away from its start is far.
        assert!(is_opposed || !compiled.assembly.warnings.is_empty(), "{height} mm");
    }
}

/// If the joints do not close in either direction, the declared start is the one that is reported.
#[test]
fn a_rod_that_is_too_short_in_both_directions_is_refused() {
    let source = upside_down(150.0).replace("200mm)", "20mm)");
    assert!(matches!(refused(&source), Fact::Assembly(AssemblyFact::StaysOpen { .. })));
}

/// A vector turned by an angle about an axis of length 1.
fn turned(axis: Vector, angle: f64, v: Vector) -> Vector {
    let (s, c) = angle.sin_cos();
    let along = (0..3).map(|k| axis[k] * v[k]).sum::<f64>();
    let across = cross(axis, v);
    [0, 1, 2].map(|k| c * v[k] + s * across[k] + (1.0 - c) * along * axis[k])
}

fn cross(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|k| a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3])
}

fn written(v: Vector, unit: &str) -> String {
    format!("({}{unit}, {}{unit}, {}{unit})", v[0], v[1], v[2])
}

/// A closed loop of joints in a random position; each body starts turned by up to `off` about a random axis. One drive holds it.
fn random_loop(random: &mut Random, kinds: &[&str], off: f64) -> String {
    let mut vector = |size: f64| [0, 1, 2].map(|_| size * random.between(-1.0, 1.0));
    let unit = |v: Vector| v.map(|part| part / v.iter().map(|part| part * part).sum::<f64>().sqrt());
    let places: Vec<(Vector, Vector, f64)> = (0..kinds.len())
        .map(|body| if body == 0 { ([0.0; 3], [0.0, 0.0, 1.0], 0.0) } else { (vector(0.25), unit(vector(1.0)), PI * vector(1.0)[0]) })
        .collect();
    let mut bodies: Vec<String> = places
        .iter()
        .map(|(place, axis, angle)| {
            let (far, about) = (vector(0.1 * off), unit(vector(1.0)));
            let by = off * (0.85 + vector(0.15)[0]);
            let origin = [0, 1, 2].map(|k| place[k] + far[k]);
            let turns = format!("turn({}, {by}rad) * turn({}, {angle}rad)", written(about, ""), written(*axis, ""));
            format!("start position = {}; start orientation = {turns};", written(origin, "m"))
        })
        .collect();
    bodies[0].clear();
    let mut joints = String::new();
    for (index, kind) in kinds.iter().enumerate() {
        let ends = [index, (index + 1) % kinds.len()];
        let middle = [0, 1, 2].map(|k| (places[ends[0]].0[k] + places[ends[1]].0[k]) / 2.0);
        let (by, axis) = (vector(0.1), unit(vector(1.0)));
        let point = [0, 1, 2].map(|k| middle[k] + by[k]);
        let other = if *kind == "universal" { unit(cross(axis, vector(1.0))) } else { axis };
        let mut call = Vec::new();
        for (end, direction) in ends.into_iter().zip([axis, other]) {
            let (origin, about, angle) = places[end];
            let local = turned(about, -angle, [0, 1, 2].map(|k| point[k] - origin[k]));
            let direction = turned(about, -angle, direction);
            bodies[end] += &format!(" point P{index} = {}; axis a{index} = {};", written(local, "m"), written(direction, ""));
            let name = if end == 0 { "ground".to_owned() } else { format!("b{end}") };
            call.push(format!("{name}.P{index}"));
            call.extend((*kind != "spherical").then(|| format!("{name}.a{index}")));
        }
        joints += &format!("joint j{index} = {kind}({});\n", call.join(", "));
    }
    let eye = vector(0.3);
    let away = (0..3).map(|k| (places[1].0[k] - eye[k]).powi(2)).sum::<f64>().sqrt();
    let moving: String = (1..kinds.len()).map(|body| format!("body b{body} {{ {} }}\n", bodies[body])).collect();
    let drive = format!("drive d = drive_distance({}, b1.position, {away}m + 1mm_s * t);", written(eye, "m"));
    format!("#[closure(start)] mechanism Loop in space {{ ground {{ {} }}\n{moving}{joints}{drive} }}", bodies[0])
}

/// Wherever the bodies start, a loop that closes is closed.
#[test]
fn loops_close_from_any_start() {
    let loops: [&[&str]; 4] = [
        &["revolute", "spherical", "universal", "revolute"],
        &["revolute", "spherical", "cylindrical", "revolute"],
        &["revolute", "cylindrical", "cylindrical", "cylindrical"],
        &["revolute", "cylindrical", "revolute", "cylindrical", "revolute"],
    ];
    let mut random = Random(2026);
    for kinds in loops {
        for off in [3.0, 0.3, 1.2, 2.1].into_iter().take(samples(1, 4)) {
            for _ in 0..3 {
                let compiled = accepted(&random_loop(&mut random, kinds, off));
                assert!(compiled.assembly.is_closed);
            }
        }
    }
}
