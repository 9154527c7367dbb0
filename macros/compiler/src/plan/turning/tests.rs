use super::super::jerk::by_components;
use super::super::stage::{Iteration, Stage};
use super::super::stages::stages;
use crate::compile;
use crate::expr::{Arena, Expr, Values, evaluate};
use crate::numeric::at_defaults;

/// A platform on six legs.
const STEWART: &str = "mechanism Stewart in space {
    ground { for k in 0..6 { point B[k] = (1m * cos(60deg * k + 10deg), 1m * sin(60deg * k + 10deg), 0.1m * cos(90deg * k)); } }
    body platform {
        for k in 0..6 { point P[k] = (0.6m * cos(60deg * k - 30deg * (-1)^k), 0.6m * sin(60deg * k - 30deg * (-1)^k), 0m); }
        start position = (0m, 0m, 1m);
    }
    for k in 0..6 { drive leg[k] = drive_distance(ground.B[k], platform.P[k], 1.2m + 0.01m * k); }
}";

/// A free body with a flap, and with a link whose cross it carries; points of all are held at distances.
const FLAP: &str = "mechanism Flap in space {
    ground { point A = (1m, 0m, 0m);  point B = (0m, 1m, 0m);  point C = (-1m, -0.2m, 0m);  point D = (0.3m, -1m, 0m);  point E = (0m, 0m, 2m); }
    body plate {
        point A = (0.5m, 0m, 0.1m);  point B = (0m, 0.5m, 0m);  point C = (-0.5m, 0m, 0m);  point D = (0m, -0.4m, 0m);  point H = (0.4m, 0.4m, 0m);
        point K = (0m, 0m, 0.2m);  axis h = (1, -1, 0);  axis x = (1, 0, 0);
        start position = (0m, 0m, 1m);
    }
    body flap { axis h = (1, -1, 0);  point T = (0.2m, 0.3m, 0.1m);  start position = (0.4m, 0.4m, 1m); }
    body link { axis z = (0, 1, 0);  point K = (0m, 0m, 0m);  point E = (0m, 0m, 0.9m);  point F = (0.2m, 0.1m, 0.4m);  start position = (0m, 0m, 1.2m); }
    joint hinge = revolute(plate.H, plate.h, flap.position, flap.h);
    joint pins = universal(plate.K, plate.x, link.K, link.z);
    joint ball = spherical(link.E, ground.E);
    drive a = drive_distance(ground.A, plate.A, 1.2m);
    drive b = drive_distance(ground.B, plate.B, 1.15m);
    drive c = drive_distance(ground.C, plate.C, 1.1m);
    drive d = drive_distance(ground.D, plate.D, 1.2m);
    drive e = drive_distance(ground.A, flap.T, 1.4m);
    drive f = LAST;
    output tip = link.F;
}";

/// 2 e and 2 vec(δe ē) by the components of δe.
fn rows([w, x, y, z]: [f64; 4]) -> [[f64; 4]; 4] {
    [[w, x, y, z], [-x, w, -z, y], [-y, z, w, -x], [-z, -y, x, w]].map(|row| row.map(|entry| 2.0 * entry))
}

/// Asserts that M D is r_x where the coordinates have these values.
fn agrees(arena: &mut Arena, system: &Iteration, values: &Values) {
    let k = system.unknowns.len();
    let by_turns: Vec<Expr> = system.jacobian.iter().flatten().copied().collect();
    let by_components: Vec<Expr> = by_components(arena, system).into_iter().flatten().collect();
    let [turned, exact] = [by_turns, by_components].map(|roots| evaluate(arena, &roots, values));
    for row in 0..k {
        let mut product = turned[row * k..][..k].to_vec();
        for columns in &system.quaternions {
            let e = columns.map(|column| values.coordinates[system.unknowns[column]]);
            let square: f64 = e.iter().map(|part| part * part).sum();
            let of = |j: usize| if j == 0 { 1.0 } else { 1.0 / square };
            for (k, column) in columns.iter().enumerate() {
                let parts = columns.iter().zip(rows(e)).enumerate();
                product[*column] = parts.map(|(j, (from, by))| turned[row * system.unknowns.len() + from] * by[k] * of(j)).sum();
            }
        }
        let known = &exact[row * k..][..k];
        let size = known.iter().fold(1.0, |size: f64, entry| size.max(entry.abs()));
        let off = product.iter().zip(known).map(|(one, two)| (one - two).abs()).fold(0.0, f64::max);
        assert!(off <= 1e-13 * size, "row {row} is {product:?} instead of {known:?}");
    }
}

/// The last distance is from the link, or from the body: then the link is held by its two joints alone.
const LAST: [&str; 2] = ["drive_distance(ground.B, link.F, 1.7m)", "drive_distance(ground.C, plate.D, 1.42m)"];

#[test]
fn columns_by_turns_are_those_by_components_of_quaternions() {
    let flaps = LAST.map(|last| FLAP.replace("LAST", last));
    for (declaration, links) in [(STEWART, 0), (&flaps[0], 0), (&flaps[1], 1)] {
        let compiled = compile(declaration.parse().expect("tokens")).expect("a valid mechanism");
        assert_eq!(compiled.system.space.links.len(), links, "{declaration}");
        let mut arena = compiled.system.arena.clone();
        let blocks = stages(&mut arena, &compiled.system, &compiled.structure, &[]).0;
        let is_turning =
            |stage: Stage| if let Stage::Block(system) = stage { Some(system).filter(|one| !one.quaternions.is_empty()) } else { None };
        let turning: Vec<Iteration> = blocks.into_iter().filter_map(is_turning).collect();
        assert_eq!(turning.len(), 1, "one block turns");
        // Not of length one.
        for pose in 0..8 {
            let away = |(k, value): (usize, &f64)| value + 0.1 * f64::sin((3 * pose + 5 * k) as f64);
            let coordinates: Vec<f64> = compiled.assembly.start.iter().enumerate().map(away).collect();
            at_defaults(&compiled.model, &compiled.system, |numeric| {
                agrees(&mut arena, &turning[0], &Values { coordinates: &coordinates, ..numeric.known });
            });
        }
    }
}
