//! Loads in closed form against a dense solution of the same equations.

mod accelerations;
mod shares;
mod squares;

use super::loads::state_at_start;
use crate::compile;
use crate::expr::{Leaf, Substitution, Values, evaluate};
use crate::linear::dense;
use crate::numeric::at_defaults;

/// A four-bar with masses.
const FOUR_BAR: &str = "mechanism FourBar {
    gravity = (0, -9.81m_s2);
    ground { point D = (4m, 0m); }
    body crank   { point B = (1m, 0m);    mass = 1kg;    center = (0.5m, 0.1m);   inertia = 0.1kgm2; }
    body coupler { point C = (3.5m, 0m);  mass = 3.5kg;  center = (1.75m, -0.2m);  inertia = 4kgm2;  start angle = 60deg; }
    body rocker  { point C = (3m, 0m);    mass = 3kg;    center = (1.5m, 0m);   inertia = 2kgm2;  start angle = 100deg; }
    joint a = revolute(ground.position, crank.position);
    joint b = revolute(crank.B, coupler.position);
    joint c = revolute(coupler.C, rocker.C);
    joint d = revolute(rocker.position, ground.D);
    DRIVEN
}";

/// A plate on three legs with a driven crank each: the forces of all legs follow from each other.
const PLATE: &str = "mechanism Plate {
    gravity = (0, -9.81m_s2);
    body plate { point A = (-1m, -0.6m);  point B = (1m, -0.6m);  point C = (0m, 1.2m);  mass = 2kg;  inertia = 1kgm2;  start angle = 5deg; }
    body one   { point E = (1.5m, 0m);  mass = 1kg;  inertia = 0.3kgm2; }
    body two   { point E = (1.5m, 0m);  mass = 1kg;  inertia = 0.3kgm2; }
    body three { point E = (1.5m, 0m);  mass = 1kg;  inertia = 0.3kgm2; }
    body leg_1 { point E = (1.6m, 0m);  mass = 0.5kg;  center = (0.8m, 0m);  inertia = 0.2kgm2;  start angle = 100deg; }
    body leg_2 { point E = (1.6m, 0m);  mass = 0.5kg;  center = (0.8m, 0m);  inertia = 0.2kgm2;  start angle = -140deg; }
    body leg_3 { point E = (1.6m, 0m);  mass = 0.5kg;  center = (0.8m, 0m);  inertia = 0.2kgm2;  start angle = -30deg; }
    joint o1 = revolute((-3m, -2m), one.position);
    joint o2 = revolute((3m, -2m), two.position);
    joint o3 = revolute((0m, 3.5m), three.position);
    joint k1 = revolute(one.E, leg_1.position);
    joint k2 = revolute(two.E, leg_2.position);
    joint k3 = revolute(three.E, leg_3.position);
    joint p1 = revolute(leg_1.E, plate.A);
    joint p2 = revolute(leg_2.E, plate.B);
    joint p3 = revolute(leg_3.E, plate.C);
    drive turn_1 = drive_angle(one, 20deg + 5deg * sin(1rad_s * t));
    drive turn_2 = drive_angle(two, 120deg);
    drive turn_3 = drive_angle(three, 200deg);
}";

/// Two wheels on a carrier that floats: the multipliers of their gear joint act along the axes of the carrier.
const GEARS: &str = "mechanism Gears in space {
    gravity = (0m_s2, 0m_s2, -9.81m_s2);
    body carrier { axis first = (0, 0, 1);  axis second = (0, 1, 0);  mass = 5kg;  inertia = (0.3kgm2, 0.3kgm2, 0.3kgm2);  TURNED }
    body first { mass = 2kg;  inertia = (0.05kgm2, 0.06kgm2, 0.07kgm2);  start position = (400mm, 0mm, 100mm);  TURNED }
    body second { mass = 3kg;  inertia = (0.1kgm2, 0.1kgm2, 0.1kgm2);  start position = (-300mm, 500mm, 0mm);  TURNED }
    joint gears = gear_joint(carrier, first, second, carrier.first, carrier.second, 2.5);
    freedom glide = rate(carrier.position) from (1m_s, -0.5m_s, 2m_s);
    freedom tumble = carrier.angular_velocity from (1rad_s, 2rad_s, -1.5rad_s);
    freedom spin = dot(carrier.first, first.angular_velocity - carrier.angular_velocity) from 4rad_s;
}";

/// Three hinges one after the other, the last with its axes against each other.
const ARM: &str = "mechanism Arm in space {
    gravity = (0m_s2, 0m_s2, -9.81m_s2);
    ground { axis z = (0, 0, 1); }
    body one { axis z = (0, 0, 1);  axis next = (0, 1, 0);  point P = (0.1m, 0m, 0.3m);
        mass = 3kg;  center = (0m, 0.1m, 0.2m);  inertia = (0.1kgm2, 0.2kgm2, 0.25kgm2); }
    body two { axis z = (0, 0, 1);  axis next = (1, 0, 0);  point P = (0.2m, 0.5m, 0m);
        mass = 2kg;  center = (0.1m, 0.2m, 0m);  inertia = (0.05kgm2, 0.03kgm2, 0.05kgm2); }
    body three { axis z = (0, -1, 0);  mass = 1kg;  center = (0m, 0.1m, 0.3m);  inertia = (0.02kgm2, 0.02kgm2, 0.01kgm2);  TURNED }
    joint a = revolute(ground.position, ground.z, one.position, one.z);
    joint b = revolute(one.P, one.next, two.position, two.z);
    joint c = revolute(two.P, two.next, three.position, three.z);
    drive of_a = drive_rotation(a, 0.3rad + 0.8rad * sin(1rad_s * t));
    drive of_b = drive_rotation(b, 0.5rad - 0.4rad * sin(2rad_s * t));
    drive of_c = drive_rotation(c, 0.7rad + 1rad_s * t);
}";

/// Evaluates loads at the assembled pose, with rates and accelerations that no motion has.
fn agrees(declaration: &str) {
    let compiled = compile(declaration.parse().expect("tokens")).expect("a valid mechanism");
    let (system, code) = (&compiled.system, compiled.plan.loads.as_ref().expect("loads"));
    let closed = code.closed.as_ref().expect("a closed form");
    let equations = system.loads.as_ref().expect("equations");
    let width = system.width();
    let speeds: Vec<f64> = (0..width).map(|k| (1.3 * k as f64).sin()).collect();
    let accelerations: Vec<f64> = (0..width).map(|k| 3.0 * (0.7 * k as f64).cos()).collect();
    at_defaults(&compiled.model, system, |numeric| {
        let start = state_at_start(numeric, &mut system.arena.clone(), &compiled.assembly);
        let state = Values { coordinates: &start, speeds: &speeds, accelerations: &accelerations, ..numeric.known };
        let found = evaluate(&code.arena, &closed.results, &state);
        let (multipliers, rest) = found.split_at(code.multipliers);
        let (actions, checks) = rest.split_at(code.width);
        assert!(checks.chunks(2).all(|pair| pair[0] > pair[1]), "{checks:?}");
        // Freedoms exert no force: with any accelerations their multipliers balance the rest.
        let count = equations.forces.len();
        let mut matrix = vec![vec![0.0; count]; count];
        for (column, row) in equations.rows.iter().enumerate() {
            let entries: Vec<_> = row.jacobian.iter().map(|(_, entry)| *entry).collect();
            for ((speed, _), value) in row.jacobian.iter().zip(evaluate(&system.arena, &entries, &state)) {
                matrix[*speed][column] = value;
            }
        }
        let right: Vec<f64> = evaluate(&system.arena, &equations.forces, &state).iter().map(|force| -force).collect();
        let wanted = dense::solve(matrix, &right).expect("a regular pose");
        let size = wanted.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
        for (found, wanted) in multipliers.iter().zip(&wanted) {
            assert!((found - wanted).abs() < 1e-12 * size, "{found} {wanted}");
        }
        // Loads of joints, from multipliers as data.
        let (mut arena, mut given) = (code.arena.clone(), Substitution::new());
        for (number, multiplier) in closed.results[..code.multipliers].iter().enumerate() {
            given.replace(Leaf::Datum(number as u32), *multiplier);
        }
        let from_data: Vec<_> = code.actions.results.iter().map(|result| given.of(&mut arena, *result)).collect();
        for (found, wanted) in actions.iter().zip(evaluate(&arena, &from_data, &state)) {
            assert!((found - wanted).abs() < 1e-12 * size, "{found} {wanted}");
        }
    });
}

#[test]
fn loads_of_a_driven_loop_agree_with_a_dense_solution() {
    agrees(&FOUR_BAR.replace("DRIVEN", "drive motor = drive_angle(crank, 0.4rad + 1rad_s * t);"));
}

#[test]
fn loads_of_a_free_loop_agree_with_a_dense_solution() {
    agrees(&FOUR_BAR.replace("DRIVEN", "freedom swing = crank.angle from 0.4rad;"));
}

#[test]
fn loads_of_a_large_block_agree_with_a_dense_solution() {
    agrees(PLATE);
}

#[test]
fn loads_along_axes_agree_with_a_dense_solution_and_need_no_determinant() {
    let text = GEARS.replace("TURNED", "start orientation = turn((1, 2, 3), 40deg);");
    agrees(&text);
    let code = compile(text.parse().expect("tokens")).expect("a valid mechanism").plan.loads.expect("loads");
    assert_eq!(code.closed.expect("a closed form").results.len(), code.multipliers + code.width);
}

#[test]
fn loads_of_hinges_one_after_the_other_need_no_determinant() {
    for turned in ["", "start orientation = turn((0, 0, 1), 90deg);"] {
        let text = ARM.replace("TURNED", turned);
        agrees(&text);
        let code = compile(text.parse().expect("tokens")).expect("a valid mechanism").plan.loads.expect("loads");
        let closed = code.closed.expect("a closed form");
        assert_eq!(closed.results.len(), code.multipliers + code.width);
        assert_eq!((closed.cost.divisions, closed.cost.sines), (0, 0));
    }
}

#[test]
fn redundant_joints_leave_no_closed_form() {
    let text = FOUR_BAR.replace("DRIVEN", "drive motor = drive_angle(crank, 0.4rad + 1rad_s * t);");
    let text = text.replace("drive motor", "redundant joint e = revolute(ground.D, rocker.position); drive motor");
    let compiled = compile(text.parse().expect("tokens")).expect("a valid mechanism");
    assert!(compiled.plan.loads.expect("loads").closed.is_none());
}
