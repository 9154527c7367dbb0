//! Which joints have a load for each of their bodies.

use crate::compile;
use crate::plan::LoadKind;

/// The names of the loads of the joint `j`, which acts on bodies in a pose without symmetries.
fn loads(text: &str) -> Vec<(String, bool)> {
    let compiled = compile(text.parse().expect("tokens")).unwrap_or_else(|refusals| panic!("{text}: {refusals:?}"));
    let named = compiled.plan.loads.expect("loads").named.into_iter().filter(|load| load.name.local.starts_with('j'));
    named.map(|load| (load.name.local, matches!(load.kind, LoadKind::Joint(_)))).collect()
}

fn in_plane(joint: &str) -> Vec<(String, bool)> {
    loads(&format!(
        "mechanism Pair {{
            body a {{ point P = (0.3m, 0.2m);  axis u = (3, 1);  mass = 1kg;  inertia = 0.1kgm2;  start position = (1m, 2m);  start angle = 40deg; }}
            body b {{ point Q = (-0.4m, 0.5m);  mass = 2kg;  inertia = 0.3kgm2;  start angle = 10deg; }}
            drive of_x = drive_x(a.position, 1m + 0.1m_s * t);
            drive of_y = drive_y(a.position, 2m);
            drive of_angle = drive_angle(a, 40deg + 1rad_s * t);
            {joint}
        }}"
    ))
}

fn in_space(joint: &str) -> Vec<(String, bool)> {
    loads(&format!(
        "mechanism Pair in space {{
            ground {{ axis s = (1, 2, 3); }}
            body a {{ axis s = (1, 2, 3);  point P = (0.3m, 0.2m, -0.6m);  axis u = (3, 1, 2);  mass = 1kg;  inertia = (0.1kgm2, 0.12kgm2, 0.13kgm2); }}
            body b {{ point Q = (-0.4m, 0.5m, 0.1m);  axis v = (1, -1, 4);  mass = 2kg;  inertia = (0.3kgm2, 0.4kgm2, 0.5kgm2); }}
            joint hinge = revolute((1m, 2m, 3m), ground.s, a.position, a.s);
            drive of_angle = drive_rotation(hinge, 40deg + 1rad_s * t);
            {joint}
        }}"
    ))
}

#[test]
fn joints_of_two_bodies_load_them_oppositely() {
    let alone = vec![("j".to_owned(), true)];
    for joint in [
        "joint j = revolute(a.P, b.Q);  drive x = drive_angle(b, 10deg);",
        "joint j = translational(a.u, a.P, b.Q);  drive x = drive_x(b.Q, 2m);",
        "joint j = weld(a.P, b.Q, 0.3rad);",
        "joint j = distance(a.P, b.Q, 0.9m);  drive x = drive_angle(b, 10deg);  drive y = drive_x(b.Q, 1.5m);",
        "joint j = point_on_line(a.P, a.u, b.Q);  drive x = drive_angle(b, 10deg);  drive y = drive_x(b.Q, 2m);",
        "joint j = revolute_translational(a.P, a.u, b.Q, 0.2m);  drive x = drive_angle(b, 10deg);  drive y = drive_x(b.Q, 2m);",
        "joint j = relative_angle(a, b, 0.3rad);  drive x = drive_x(b.Q, 2m);  drive y = drive_y(b.Q, 1m);",
        "joint j = belt(a, b, 1, 1);  drive x = drive_x(b.Q, 2m);  drive y = drive_y(b.Q, 1m);",
        "joint j = gear_pair(a, b, 2, -2);  drive x = drive_x(b.Q, 2m);  drive y = drive_y(b.Q, 1m);",
        "joint j = { b.Q == a.P; }  drive x = drive_angle(b, 10deg);",
    ] {
        let found = in_plane(joint);
        // An equation written out names no body on which its load would be stated.
        assert!(found == alone || joint.contains('{') && found == [("j".to_owned(), false)], "{joint}: {found:?}");
    }
    for joint in [
        "joint j = revolute(a.P, a.u, b.Q, b.v);  drive x = drive_rotation(j, 10deg);",
        "joint j = cylindrical(a.P, a.u, b.Q, b.v);  drive x = drive_rotation(j, 10deg);  drive y = drive_translation(j, 0.2m);",
        "joint j = translational(a.P, a.u, b.Q, b.v);  drive y = drive_translation(j, 0.2m);",
        "joint j = screw(a.P, a.u, b.Q, b.v, 10mm);  drive x = drive_rotation(j, 10deg);",
        "joint j = weld(a.P, a.u, b.Q, b.v);",
        "joint j = spherical(a.P, b.Q);  freedom x = b.angular_velocity from (1rad_s, 2rad_s, 3rad_s);",
    ] {
        assert_eq!(in_space(joint), alone, "{joint}");
    }
}

#[test]
fn gears_racks_belts_and_differentials_have_a_load_for_each_body() {
    let shares = |names: &[&str]| names.iter().map(|name| ((*name).to_owned(), false)).collect::<Vec<_>>();
    let placed = "drive x = drive_x(b.Q, 2m);  drive y = drive_y(b.Q, 1m);";
    assert_eq!(in_plane(&format!("joint j = gear_pair(a, b, 1, 3);  {placed}")), shares(&["j", "j_on_a"]));
    assert_eq!(in_plane(&format!("joint j = belt(a, b, 2, 1);  {placed}")), shares(&["j", "j_on_a"]));
    let of_rack = "joint j = rack_pinion(b, a.P, (1, 0), (0m, 0m), 0.2m);  drive x = drive_x(b.Q, 2m);  drive y = drive_y(b.Q, 1m);";
    assert_eq!(in_plane(of_rack), shares(&["j", "j_on_b"]));
    let third = "body c { mass = 1kg; inertia = 1kgm2; }  joint o = revolute((5m, 0m), c.position);";
    assert_eq!(
        in_plane(&format!("{third}  joint j = planetary(a, b, c, 20, 60);  {placed}  drive z = drive_angle(c, 0rad);")),
        shares(&["j", "j_on_a", "j_on_b"])
    );
    let on_carrier = format!("{third}  joint j = gear_pair(b, c, 1, 2, carrier: a);  {placed}  drive z = drive_angle(c, 0rad);");
    assert_eq!(in_plane(&on_carrier), shares(&["j", "j_on_b", "j_on_c"]));
    let pressed = "joint j = involute_mesh(b.position, c.position, 1m, 2m, 0deg, carrier: a);";
    assert_eq!(in_plane(&format!("{third}  {pressed}  {placed}  drive z = drive_angle(c, 0rad);")), shares(&["j", "j_on_a", "j_on_b"]));
}
