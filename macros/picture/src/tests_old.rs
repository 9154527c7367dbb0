//! What pictures say must be true: radii, contacts, directions, and which configuration is seen.

use super::cams::cams;
use super::plane::{Place, Rectangle, hull, is_inside, place};
use super::pose::pose;
use super::scene::Scene;
use super::wheels::Wheels;
use crate::{Compiled, compile};

fn compiled(items: &str) -> Compiled {
    let text = format!("pub mechanism Test {{ {items} }}");
    compile(text.parse().expect("tokens")).expect("a mechanism")
}

fn scene(items: &str) -> Scene {
    let compiled = compiled(items);
    pose(&compiled.model, &compiled.system, &compiled.assembly).expect("everything has a place").1
}

fn radii(items: &str) -> Vec<f64> {
    Wheels::of(&scene(items)).wheels.iter().map(|wheel| (wheel.radius * 1e9).round() / 1e9).collect()
}

const TWO_WHEELS: &str = "ground { point A = (0mm, 0mm); point B = (100mm, 0mm); } body one { } body two { }
    joint a = revolute(ground.A, one.position); joint b = revolute(ground.B, two.position);
    drive motor = drive_angle(one, 1rad_s * t);";

#[test]
fn gears_touch_by_their_ratio() {
    assert_eq!(radii(&format!("{TWO_WHEELS} joint mesh = gear_pair(one, two, 20, 60);")), [0.025, 0.075]);
    assert_eq!(radii(&format!("{TWO_WHEELS} joint mesh = gear_pair(one, two, 20, -60);")), [0.05, 0.15]);
}

#[test]
fn pulleys_keep_their_own_radii() {
    assert_eq!(radii(&format!("{TWO_WHEELS} joint strap = belt(one, two, 20mm, 35mm);")), [0.02, 0.035]);
}

#[test]
fn a_planetary_train_fills_its_ring() {
    let items = "ground { point O = (0mm, 0mm); } body sun { } body ring { } body arm { point A = (42mm, 0mm); } body planet { }
        joint s = revolute(ground.O, sun.position); joint r = revolute(ground.O, ring.position);
        joint k = revolute(ground.O, arm.position); joint p = revolute(arm.A, planet.position);
        joint willis = planetary(sun, ring, arm, 24, 60); joint mesh = gear_pair(sun, planet, 24, 18, carrier: arm);
        drive motor = drive_angle(sun, 1rad_s * t); drive brake = drive_angle(ring, 0);";
    assert_eq!(radii(items), [0.024, 0.018, 0.06]);
}

#[test]
fn a_rack_moves_with_the_rim_that_it_touches() {
    let items = |radius: &str| {
        format!(
            "ground {{ point D = (0mm, 50mm); axis way = (1, 0); }} body rack {{ }} body wheel {{ }}
            joint d = revolute(ground.D, wheel.position);
            joint way = translational(ground.way, ground.position, rack.position);
            joint teeth = rack_pinion(wheel, rack.position, ground.way, ground.position, {radius});
            drive motor = drive_angle(wheel, 1rad_s * t);"
        )
    };
    let contact = |radius: &str| {
        let Place { x, y } = Wheels::of(&scene(&items(radius))).racks[0].1.contact;
        [x, y].map(|part| (part * 1e9).round() / 1e9)
    };
    // Turning to the left, the top of a wheel goes to the left.
    assert_eq!(contact("25mm"), [0.0, 0.075]);
    assert_eq!(contact("-25mm"), [0.0, 0.025]);
}

#[test]
fn a_follower_touches_its_cam() {
    let items = "function R(psi: Angle) -> Length = 30mm + 8mm * cos(psi);
        ground { point O = (0mm, 0mm); axis up = (0, 1); } body cam { } body follower { start position = (0mm, 45mm); }
        joint shaft = revolute(ground.O, cam.position);
        joint guide = translational(ground.up, ground.O, follower.position);
        joint touch = cam_roller(cam.position, follower.position, 6mm, R);
        drive motor = drive_angle(cam, 0.7rad + 1rad_s * t);";
    let cams = cams(&scene(items));
    let nearest = cams[0].outline.iter().map(|at| (*at - cams[0].at).norm()).fold(f64::INFINITY, f64::min);
    assert!((nearest - 6e-3).abs() < 2e-4, "the roller's centre is {nearest} from the surface");
}

#[test]
fn links_in_line_are_drawn_a_little_later() {
    let crank = |angle: &str| {
        format!(
            "ground {{ point O = (0mm, 0mm); axis bore = (1, 0); }}
            body crank {{ point A = (50mm, 0mm); }} body rod {{ point B = (200mm, 0mm); start angle = 0deg; }} body piston {{ }}
            joint main = revolute(ground.O, crank.position); joint big_end = revolute(crank.A, rod.position);
            joint small_end = revolute(rod.B, piston.position); joint guide = translational(ground.bore, ground.O, piston.position);
            drive motor = drive_angle(crank, {angle} + 2rad_s * t);"
        )
    };
    let time = |angle: &str| {
        let compiled = compiled(&crank(angle));
        pose(&compiled.model, &compiled.system, &compiled.assembly).expect("everything has a place").0.time
    };
    assert!(time("0rad") > 0.0);
    assert_eq!(time("1rad"), 0.0);
}

#[test]
fn arrows_know_which_way_a_drive_goes() {
    let rate = |law: &str| {
        scene(&format!("body wheel {{ }} joint o = revolute(ground.position, wheel.position); drive d = drive_angle(wheel, {law});")).joints
            [1]
        .rate
    };
    assert_eq!([rate("3rad_s * t"), rate("-2rad_s * t"), rate("1rad")], [3.0, -2.0, 0.0]);
}

#[test]
fn a_hull_has_the_outer_corners_only() {
    let corners = [(0.0, 0.0), (2.0, 0.0), (1.0, 0.5), (2.0, 2.0), (0.0, 2.0), (1.0, 0.0)].map(|(x, y)| place(x, y));
    let hull = hull(&corners);
    assert_eq!(hull, [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)].map(|(x, y)| place(x, y)));
    assert!(is_inside(&hull, place(1.0, 1.0)) && !is_inside(&hull, place(3.0, 1.0)));
}

#[test]
fn a_segment_crosses_a_box_also_without_an_end_in_it() {
    let frame = Rectangle::centred(Place::default(), place(2.0, 2.0));
    assert!(frame.is_crossed(place(-3.0, 0.0), place(3.0, 0.5)));
    assert!(frame.is_crossed(place(0.0, 0.0), place(0.5, 0.5)));
    assert!(!frame.is_crossed(place(-3.0, 0.0), place(0.0, 3.0)));
}
