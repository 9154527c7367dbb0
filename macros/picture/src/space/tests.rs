//! Spatial drawings: direction of view, contacts of wheels, symbols. No scene causes a panic.

use super::placed::Placed;
use super::vector::{UP, Vec3, vec3};
use super::view::{Camera, clearance};
use super::wheels::Wheels;
use crate::tests::{Chance, samples};
use crate::{Film, GROUND, Pose, Scene, Undrawable, animation, frames};
use core::f64::consts::PI;

const EYE: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Rotation about z.
fn about_z(angle: f64) -> [[f64; 3]; 3] {
    let (sine, cosine) = libm::sincos(angle);
    [[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]]
}

fn best(scene: &Scene) -> (Placed, Camera) {
    let placed = Placed::of(scene).expect("everything has a place");
    let camera = Camera::best(std::slice::from_ref(&placed));
    (placed, camera)
}

/// Gives a joint its points and axes.
fn hinge(scene: &mut Scene, name: &str, kind: &str, [p, q]: [(&str, [f64; 3]); 2], axis: [f64; 3]) {
    scene.joint(name, kind).point("P", p.0, p.1).axis("a", p.0, axis).point("Q", q.0, q.1).axis("b", q.0, axis);
}

/// A crank and a rod connected by a ball joint.
fn crank(angle: f64) -> Scene {
    let mut scene = Scene::new("Crank");
    scene.body("crank", Pose::space([0.0; 3], about_z(angle)));
    scene.body("rod", Pose::space([0.3 * libm::cos(angle), 0.3 * libm::sin(angle), 0.0], EYE));
    scene.point("rod", [0.1, 0.1, -0.4]);
    hinge(&mut scene, "axle", "revolute", [(GROUND, [0.0; 3]), ("crank", [0.0; 3])], [0.0, 0.0, 1.0]);
    scene.joint("ball", "spherical").point("P", "crank", [0.3, 0.0, 0.0]).point("Q", "rod", [0.0; 3]);
    let motor = scene.drive("motor", "drive_rotation", 1.0);
    motor.joint("angle", "angle", |angle| {
        angle.axis("a", GROUND, [0.0, 0.0, 1.0]).axis("b", "crank", [0.0, 0.0, 1.0]);
    });
    scene
}

#[test]
fn a_projection_keeps_right_angles_and_the_upright() {
    let camera = Camera::new(-1.0, 0.5);
    for (one, two) in [(camera.right, camera.up), (camera.up, camera.toward), (camera.toward, camera.right)] {
        assert!(one.dot(two).abs() < 1e-15 && (one.norm() - 1.0).abs() < 1e-15);
    }
    let up = camera.project(UP);
    assert!(up.x.abs() < 1e-15 && (up.y - libm::cos(0.5)).abs() < 1e-15);
    assert!(camera.project(camera.toward).norm() < 1e-15);
    // Right, up and the direction towards the eye form a right-handed frame.
    assert!((camera.right.cross(camera.up) - camera.toward).norm() < 1e-15);
}

#[test]
fn points_in_line_with_the_usual_view_are_seen_apart() {
    let usual = Camera::new(-PI / 3.0, 26.0 * PI / 180.0).toward;
    let mut scene = Scene::new("Line");
    scene.body("link", Pose::space([0.0; 3], EYE));
    for part in [0.0, 0.5, 1.0] {
        scene.point("link", [usual.x * part, usual.y * part, usual.z * part]);
    }
    let (placed, camera) = best(&scene);
    assert!(clearance(&placed, &camera) > 0.1);
    assert_eq!(scene.clearance(), Ok(clearance(&placed, &camera)));
}

#[test]
fn no_axis_of_a_joint_is_seen_as_a_point() {
    for (azimuth, height) in [(-60, 26), (-52, 32), (30, 26), (120, 20)] {
        let degrees = PI / 180.0;
        let along = Camera::new(f64::from(azimuth) * degrees, f64::from(height) * degrees).toward;
        let mut scene = crank(0.7);
        hinge(&mut scene, "pin", "revolute", [("crank", [0.1, 0.0, 0.0]), ("rod", [0.0; 3])], [along.x, along.y, along.z]);
        let (placed, camera) = best(&scene);
        let axes = placed.joints.iter().filter_map(|joint| joint.given.axis("a"));
        assert!(axes.map(|of| of.at.dot(camera.toward).abs()).fold(0.0, f64::max) < 0.95, "{azimuth}, {height}");
    }
}

/// Two wheels on ground, with the given numbers of teeth.
fn wheels(axes: [[f64; 3]; 2], places: [[f64; 3]; 2], teeth: [f64; 2]) -> Scene {
    let mut scene = Scene::new("Wheels");
    for ((name, axis), at) in ["one", "two"].into_iter().zip(axes).zip(places) {
        scene.body(name, Pose::space(at, EYE));
        hinge(&mut scene, &format!("axle_{name}"), "revolute", [(GROUND, at), (name, [0.0; 3])], axis);
    }
    let mesh = scene.joint("mesh", "gear_pair");
    for ((name, body), axis) in ["one", "two"].into_iter().zip(["one", "two"]).zip(axes) {
        mesh.joint(name, "angle", |angle| {
            angle.axis("a", GROUND, axis).axis("b", body, axis);
        });
    }
    mesh.number("a", teeth[0]).number("b", teeth[1]);
    scene
}

fn of_wheels(scene: &Scene) -> Vec<(Vec3, f64)> {
    Wheels::of(&Placed::of(scene).expect("everything has a place")).wheels.iter().map(|wheel| (wheel.at, wheel.radius)).collect()
}

#[test]
fn spur_gears_touch_by_their_ratio() {
    let (up, places) = ([0.0, 0.0, 1.0], [[0.0; 3], [0.13, 0.0, 0.04]]);
    let radii = |teeth: [f64; 2]| of_wheels(&wheels([up, up], places, teeth)).iter().map(|wheel| wheel.1).collect::<Vec<_>>();
    let is_near = |found: &[f64], wanted: [f64; 2]| found.iter().zip(wanted).all(|(found, wanted)| (found - wanted).abs() < 1e-12);
    assert!(is_near(&radii([10.0, 16.0]), [0.05, 0.08]));
    assert!(is_near(&radii([10.0, -36.0]), [0.05, 0.18]));
    // Both wheels lie in one plane.
    assert!(of_wheels(&wheels([up, up], places, [1.0, 1.0])).iter().all(|wheel| wheel.0.z.abs() < 1e-12));
}

#[test]
fn bevel_gears_roll_on_each_other_about_one_apex() {
    let found = of_wheels(&wheels([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [[0.05, 0.0, 0.0], [0.0, 0.06, 0.0]], [10.0, 16.0]));
    let [(one, r), (two, s)] = found[..] else { panic!("{found:?}") };
    assert!((r / s - 10.0 / 16.0).abs() < 1e-12);
    let rim = |at: Vec3, way: Vec3, radius: f64| at + way * radius;
    let contact = rim(one, vec3(0.0, 1.0, 0.0), r) - rim(two, vec3(1.0, 0.0, 0.0), s);
    assert!(contact.norm() < 1e-12, "{contact:?}");
}

#[test]
fn a_worm_lies_on_the_rim_of_its_wheel() {
    let found = of_wheels(&wheels([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [[0.0, 0.0, 0.08], [0.0, 0.02, 0.0]], [1.0, 30.0]));
    let [(worm, r), (wheel, s)] = found[..] else { panic!("{found:?}") };
    assert!(((worm - wheel).norm() - r - s).abs() < 1e-12 && s > 4.0 * r);
}

#[test]
fn joints_have_their_symbols_and_names() {
    let picture = crank(0.7).draw().expect("a picture");
    let svg = picture.svg();
    let shown: Vec<&str> = picture.labels().iter().map(|label| label.text.as_str()).collect();
    assert!(["crank", "rod", "axle", "ball", "motor"].iter().all(|name| shown.contains(name)), "{shown:?}");
    let line = |title: &str| svg.lines().find(|line| line.contains(title)).unwrap_or_else(|| panic!("{title} in {svg}")).to_owned();
    // A hinge: barrels of ground, of the crank, and of ground again, with the axis.
    let axle = svg.lines().find(|line| line.contains("axle: revolute of ground and crank") && line.matches("<path").count() == 4);
    let axle = axle.expect("a hinge");
    assert_eq!((axle.matches("class=\"k g\"").count(), axle.matches("class=\"k c0\"").count()), (2, 1));
    assert!(svg.contains("<path class=\"a\""));
    // A ball in a socket.
    let ball = line("ball: spherical of crank and rod");
    assert!(ball.contains("<circle class=\"k c1\"") && ball.contains("class=\"f c0\""), "{ball}");
    // The axes of ground, with their length.
    assert!(["x", "y", "z"].iter().all(|name| svg.contains(&format!(">{name}</text>"))) && svg.contains(">axes "));
}

#[test]
fn slides_screws_and_universal_joints_have_their_symbols() {
    let with = |kind: &str, more: f64| {
        let mut scene = crank(0.7);
        hinge(&mut scene, "more", kind, [(GROUND, [0.5, 0.0, 0.0]), ("rod", [more, 0.0, 0.0])], [1.0, 0.0, 0.0]);
        scene.svg()
    };
    let plain = crank(0.7).svg();
    for kind in ["translational", "cylindrical", "screw", "universal", "planar", "weld", "point_on_line", "point_on_plane"] {
        let svg = with(kind, 0.2);
        assert!(svg.len() > plain.len() && svg.contains(&format!("<title>more: {kind} of ground and rod</title>")), "{svg}");
    }
    // The balls of a constant-velocity joint run in a cup.
    let rzeppa = with("constant_velocity", 0.2);
    let line = rzeppa.lines().find(|line| line.contains("<title>more: constant_velocity of ground and rod</title>")).expect("a joint");
    assert!(line.contains("<circle class=\"k c1\"") && line.contains("class=\"f "), "{line}");
    // A condition on directions alone becomes a caption.
    let mut scene = crank(0.7);
    scene.joint("level", "parallel_axes").axis("a", GROUND, [0.0, 0.0, 1.0]).axis("b", "rod", [0.0, 0.0, 1.0]);
    assert!(scene.svg().contains(">level: parallel_axes of ground and rod</text>"));
}

#[test]
fn what_passes_in_front_is_set_off() {
    let mut scene = Scene::new("Cross");
    for (name, at) in [("front", [0.0, -0.5, 0.0]), ("back", [0.0, 0.5, 0.0])] {
        scene.body(name, Pose::space(at, EYE));
    }
    scene.point("front", [-0.5, 0.0, -0.5]);
    scene.point("front", [0.5, 0.0, 0.5]);
    scene.point("back", [-0.5, 0.0, 0.5]);
    scene.point("back", [0.5, 0.0, -0.5]);
    let svg = scene.svg();
    let at = |part: &str| svg.find(part).unwrap_or_else(|| panic!("{part} in {svg}"));
    let halo = at("<path class=\"h\"");
    assert!(halo > at("<title>back</title>"), "{svg}");
    assert!(svg[halo..].contains("class=\"b c0\""));
}

#[test]
fn all_frames_are_seen_from_one_place() {
    let scenes: Vec<Scene> = (0..12).map(|step| crank(f64::from(step) * PI / 6.0)).collect();
    let frames = frames(&scenes).expect("a picture");
    let head = |svg: &str| svg.lines().next().map(ToOwned::to_owned);
    let axes = |svg: &str| svg.lines().rev().take(8).map(ToOwned::to_owned).collect::<Vec<_>>();
    for frame in &frames {
        assert_eq!((head(frame.svg()), axes(frame.svg())), (head(frames[0].svg()), axes(frames[0].svg())));
    }
    assert!(animation(&scenes, 1.0).expect("a picture").contains("<animate"));
}

#[test]
fn a_mechanism_is_seen_from_the_direction_asked_for() -> Result<(), Undrawable> {
    // Right and upwards in the picture, for a point that is moved along x, y and z.
    let root = 0.5_f64.sqrt();
    let isometric = [[root, -1.0 / 6.0_f64.sqrt()], [root, 1.0 / 6.0_f64.sqrt()], [0.0, (2.0 / 3.0_f64).sqrt()]];
    let views = [
        ([0.0, -1.0, 0.0], [[1.0, 0.0], [0.0, 0.0], [0.0, 1.0]]),
        ([0.0, -1e-310, 0.0], [[1.0, 0.0], [0.0, 0.0], [0.0, 1.0]]),
        ([1.7e308, 0.0, 0.0], [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]),
        ([6e-17, 0.0, 1.0], [[1.0, 0.0], [0.0, 1.0], [0.0, 0.0]]),
        ([0.0, 0.0, 0.1], [[1.0, 0.0], [0.0, 1.0], [0.0, 0.0]]),
        ([0.0, 0.0, -1.0], [[1.0, 0.0], [0.0, -1.0], [0.0, 0.0]]),
        ([1.0, -1.0, 1.0], isometric),
    ];
    for (direction, wanted) in views {
        let mut scenes = [0.3, 0.5].map(crank);
        scenes[0].seen_from(direction);
        let film = Film::of(&scenes, &[])?;
        let origin = film.at([0.0; 3]);
        let along = |axis: usize| film.at([0, 1, 2].map(|k| if k == axis { 0.01 } else { 0.0 }));
        let ways = [0, 1, 2].map(|axis| [along(axis)[0] - origin[0], origin[1] - along(axis)[1]]);
        let scale = ways.iter().flatten().map(|way| way * way).sum::<f64>().sqrt() / 2.0_f64.sqrt();
        for (way, wanted) in ways.iter().flatten().zip(wanted.iter().flatten()) {
            assert!((way / scale - wanted).abs() < 1e-9, "{direction:?}: {ways:?}");
        }
    }
    Ok(())
}

#[test]
fn an_axis_towards_the_eye_is_not_shown() {
    for (direction, hidden) in [([0.0, -1.0, 0.0], Some("y")), ([0.0, 0.0, 1.0], Some("z")), ([1.0, -1.0, 1.0], None)] {
        let mut scene = crank(1.0);
        scene.seen_from(direction);
        for name in ["x", "y", "z"] {
            assert_eq!(scene.svg().contains(&format!(">{name}</text>")), Some(name) != hidden, "{name} from {direction:?}");
        }
    }
}

#[test]
fn what_cannot_be_drawn_says_why() {
    for direction in [[0.0; 3], [f64::NAN, 0.0, 1.0], [0.0, f64::INFINITY, 0.0]] {
        let mut unseen = crank(1.0);
        unseen.seen_from(direction);
        assert_eq!(unseen.draw(), Err(Undrawable::Unseen));
        assert!(unseen.svg().contains("There is no picture: the direction of view is zero or not finite."));
    }
    let mut strange = crank(1.0);
    strange.point("crnk", [0.0; 3]);
    assert_eq!(strange.draw(), Err(Undrawable::UnknownBody("crnk".into())));
    assert_eq!(crank(f64::NAN).draw(), Err(Undrawable::Nowhere));
    assert_eq!(frames(&[crank(1.0), crank(f64::INFINITY)]), Err(Undrawable::Nowhere));
}

const KINDS: [&str; 25] = [
    "revolute",
    "cylindrical",
    "translational",
    "screw",
    "universal",
    "constant_velocity",
    "spherical",
    "planar",
    "weld",
    "point_on_line",
    "point_on_plane",
    "parallel_axes",
    "distance",
    "absolute_x",
    "absolute_z",
    "gear_pair",
    "gear_pair",
    "rack_pinion",
    "drive_rotation",
    "drive_translation",
    "drive_distance",
    "drive_x",
    "drive_z",
    "",
    "kind <of> one's \"own\"",
];

const BODIES: [&str; 4] = ["a", "b[1]", "part[2].c", GROUND];

fn vector(chance: &mut Chance, is_wild: bool) -> [f64; 3] {
    let axes = [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0; 3]];
    if chance.next().is_multiple_of(4) { chance.one(&axes) } else { [(); 3].map(|()| chance.number(is_wild)) }
}

fn anything(chance: &mut Chance, is_wild: bool) -> Scene {
    let mut scene = Scene::new("Anything");
    for name in &BODIES[..3] {
        let pose = Pose::space(vector(chance, is_wild), [(); 3].map(|()| vector(chance, is_wild)));
        scene.body(name, if chance.next().is_multiple_of(5) { Pose::plane(0.1, 0.2, 0.3) } else { pose });
    }
    if chance.next().is_multiple_of(3) {
        scene.seen_from(vector(chance, false));
    }
    for _ in 0..chance.next() % 6 {
        let (body, at) = (chance.one(&BODIES), vector(chance, is_wild));
        scene.point(body, at);
        scene.output("out", body, at);
    }
    for number in 0..1 + chance.next() % 7 {
        let (name, kind) = (format!("j[{number}]"), chance.one(&KINDS));
        let rate = chance.number(is_wild);
        let joint = if kind.starts_with("drive") { scene.drive(&name, kind, rate) } else { scene.joint(&name, kind) };
        for name in ["P", "Q"] {
            if !chance.next().is_multiple_of(6) {
                joint.point(name, chance.one(&BODIES), vector(chance, is_wild));
            }
        }
        for name in ["a", "b"] {
            joint.axis(name, chance.one(&BODIES), vector(chance, is_wild));
        }
        for name in ["a", "b", "radius", "lead"] {
            joint.number(name, chance.number(is_wild));
        }
        for name in ["one", "two"].iter().take(1 + (chance.next() % 2) as usize) {
            let (kind, bodies) = (chance.one(&["angle", "angle", "displacement"]), [(); 2].map(|()| chance.one(&BODIES)));
            let vectors = [(); 4].map(|()| vector(chance, is_wild));
            joint.joint(name, kind, |made| {
                made.point("P", bodies[0], vectors[0]).axis("a", bodies[0], vectors[1]);
                made.point("Q", bodies[1], vectors[2]).axis("b", bodies[1], vectors[3]);
            });
        }
    }
    scene
}

#[test]
fn no_scene_leads_to_a_panic() {
    let mut chance = Chance(2);
    let mut drawn = 0;
    let rounds = samples(60, 400);
    for round in 0..rounds {
        // Few wild scenes can be drawn.
        let is_wild = round % 3 == 0;
        let scenes = [(); 2].map(|()| anything(&mut chance, is_wild));
        for scene in &scenes {
            let svg = scene.svg();
            drawn += usize::from(scene.draw().is_ok());
            assert!(svg.ends_with("</svg>\n") && !svg.contains("NaN") && !svg.contains("inf"), "{svg}");
        }
        assert_eq!(frames(&scenes).is_ok(), animation(&scenes, 1.0).is_ok());
    }
    assert!(drawn > rounds, "only {drawn} scenes were drawn");
}
