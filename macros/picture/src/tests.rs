//! Geometry of pictures: radii, contacts, outlines. No scene causes a panic.

use crate::cams::cams;
use crate::drawing::Setting;
use crate::habits::Habits;
use crate::placed::PlacedScene;
use crate::plane::{Place, Rectangle, hull, is_inside, place};
use crate::wheels::Wheels;
use crate::{Film, GROUND, Pose, Scene, Undrawable, animation, frames};

fn placed(scene: &Scene) -> PlacedScene {
    PlacedScene::of(scene).expect("everything has a place")
}

fn radii(scene: &Scene) -> Vec<f64> {
    Wheels::of(&placed(scene)).wheels.iter().map(|wheel| (wheel.radius * 1e9).round() / 1e9).collect()
}

/// Wheels on ground, 100 mm apart.
fn two_wheels() -> Scene {
    let mut scene = Scene::new("Wheels");
    for (name, x) in [("one", 0.0), ("two", 0.1)] {
        scene.body(name, Pose::plane(x, 0.0, 0.0));
        scene.joint(&format!("axle_{name}"), "revolute").point("P", GROUND, [x, 0.0]).point("Q", name, [0.0, 0.0]);
    }
    scene
}

/// A crank, a rod and a piston, the crank at `angle`.
fn engine(angle: f64) -> Scene {
    let (crank, rod) = (0.05, 0.2);
    let (sine, cosine) = libm::sincos(angle);
    let tilt = -libm::asin(crank / rod * sine);
    let mut scene = Scene::new("Engine");
    scene.body("crank", Pose::plane(0.0, 0.0, angle));
    scene.body("rod", Pose::plane(crank * cosine, crank * sine, tilt));
    scene.body("piston", Pose::plane(crank * cosine + rod * libm::cos(tilt), 0.0, 0.0));
    scene.joint("o", "revolute").point("P", GROUND, [0.0, 0.0]).point("Q", "crank", [0.0, 0.0]);
    scene.joint("a", "revolute").point("P", "crank", [crank, 0.0]).point("Q", "rod", [0.0, 0.0]);
    scene.joint("b", "revolute").point("P", "rod", [rod, 0.0]).point("Q", "piston", [0.0, 0.0]);
    let bore = scene.joint("bore", "translational");
    bore.axis("u", GROUND, [1.0, 0.0]).point("P", GROUND, [0.0, 0.0]).point("Q", "piston", [0.0, 0.0]);
    scene.drive("motor", "drive_angle", 1.0).body("b", "crank").number("C", angle);
    scene.output("travel", "piston", [0.0, 0.0]);
    scene
}

#[test]
fn gears_touch_by_their_ratio() {
    let mesh = |teeth: f64| {
        let mut scene = two_wheels();
        scene.joint("mesh", "gear_pair").body("i", "one").body("j", "two").number("a", 20.0).number("b", teeth);
        radii(&scene)
    };
    assert_eq!(mesh(60.0), [0.025, 0.075]);
    assert_eq!(mesh(-60.0), [0.05, 0.15]);
}

#[test]
fn involute_gears_touch_at_their_centre_distance() {
    let mesh = |teeth: f64| {
        let mut scene = two_wheels();
        let mesh = scene.joint("mesh", "involute_mesh");
        mesh.point("A", "one", [0.0, 0.0]).point("B", "two", [0.0, 0.0]).length("a", 0.024).length("b", teeth);
        radii(&scene)
    };
    assert_eq!(mesh(0.072), [0.025, 0.075]);
    assert_eq!(mesh(-0.072), [0.05, 0.15]);
}

/// Distances (rad, in pitches) between the teeth of two wheels where they touch: 1/2 if a tooth is in the middle of a space.
fn apart(wheels: &Wheels, scene: &PlacedScene, [one, two]: [usize; 2], at: Place) -> f64 {
    let offset = |wheel: usize| {
        let wheel = &wheels.wheels[wheel];
        let teeth = wheel.teeth.expect("it has teeth");
        let turned = wheel.body.map_or(0.0, |body| scene.bodies[body].angle);
        let pitches = ((at - wheel.middle).angle() - turned - teeth.angle) * teeth.count / core::f64::consts::TAU;
        // Spaces of an internal gear are half a pitch beside its teeth; its rim passes the contact in the same direction.
        if wheel.is_ring { 0.5 - pitches } else { pitches }
    };
    let sum = offset(one) + offset(two);
    sum - sum.floor()
}

#[test]
fn a_tooth_is_in_a_space() {
    for (teeth, side) in [(60.0, -1.0), (17.0, -1.0), (-60.0, 1.0)] {
        for turn in [0.0, 0.3, -2.0, 40.0] {
            let mut scene = two_wheels();
            scene.bodies[0].pose = Pose::plane(0.0, 0.0, turn);
            scene.bodies[1].pose = Pose::plane(0.1, 0.0, side * turn * 20.0 / f64::abs(teeth));
            scene.joint("mesh", "gear_pair").body("i", "one").body("j", "two").number("a", 20.0).number("b", teeth);
            let placed = placed(&scene);
            let wheels = Wheels::of(&placed);
            let off = apart(&wheels, &placed, [0, 1], wheels.meshes[0].1);
            assert!((off - 0.5).abs() < 1e-9, "{off} of a pitch for {teeth} teeth at {turn}");
            // The teeth stand still in their bodies.
            let known = wheels.wheels[1].teeth.expect("teeth").angle;
            assert!((-1e-9..0.4).contains(&known), "{known}");
        }
    }
}

#[test]
fn lengths_are_no_numbers_of_teeth() {
    let mut scene = two_wheels();
    scene.joint("mesh", "gear_pair").body("i", "one").body("j", "two").length("a", 20.0).length("b", 60.0);
    assert!(Wheels::of(&placed(&scene)).wheels.iter().all(|wheel| wheel.teeth.is_none()));
}

#[test]
fn shapes_of_bodies_are_in_the_picture_and_turn_with_them() {
    let mut scene = engine(0.5);
    scene.outline("piston", [[-0.04, -0.03], [0.04, -0.03], [0.04, 0.5], [-0.04, 0.5]]);
    let film = Film::of(&[scene.clone()], &[]).expect("it is drawn");
    let shape = film.marks(0).into_iter().find(|mark| mark.geometry.iter().any(|(name, _)| *name == "transform"));
    let [left, top, width, height] = film.frame();
    let corner = film.at([scene.bodies[2].pose.position.x, 0.5]);
    assert!((left..left + width).contains(&corner[0]) && (top..top + height).contains(&corner[1]));
    assert_eq!(shape.expect("a shape").title, "piston");
    scene.outline("pistol", [[0.0, 0.0]]);
    assert_eq!(scene.draw().map(|_| ()), Err(Undrawable::UnknownBody("pistol".into())));
    let mut door = Scene::new("Door");
    door.body("leaf", Pose::space([0.0, 0.0, 0.0], [[0.6, -0.8, 0.0], [0.8, 0.6, 0.0], [0.0, 0.0, 1.0]]));
    door.outline("leaf", [[0.0, 0.0, 0.0], [0.9, 0.0, 0.0], [0.9, 0.0, 2.0], [0.0, 0.0, 2.0]]);
    assert!(door.draw().expect("it is drawn").svg().contains("class=\"w c0\""));
}

#[test]
fn springs_and_dampers_are_forces() {
    let mut scene = engine(0.5);
    let before = scene.draw().expect("it is drawn").svg().lines().nth(2).map(str::to_owned);
    let kinds = ["spring", "damper", "spring_damper", "constant_force", "nonlinear_spring", "gas_spring", "stop"];
    for (kind, height) in kinds.into_iter().zip([0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6]) {
        scene.joint(kind, kind).of(&["piston"]).point("P", GROUND, [0.4, height]).point("Q", "piston", [0.0, 0.0]);
    }
    let svg = scene.svg();
    assert_eq!(svg.lines().nth(2).map(str::to_owned), before, "joints are counted without them");
    // Lines of the symbol: a coil; a pot and a piston; both, with bars at their ends.
    let lines = |svg: &str, kind: &str| {
        let before = svg.split_once(&format!("<title>{kind}: {kind} of ")).map(|(before, _)| before.to_owned());
        before.map(|before| before.rsplit("d=\"").next().unwrap_or("").matches('M').count())
    };
    assert_eq!(["spring", "damper", "spring_damper"].map(|kind| lines(&svg, kind)), [Some(1), Some(4), Some(9)], "{svg}");
    assert_eq!(["constant_force", "nonlinear_spring"].map(|kind| lines(&svg, kind)), [Some(1); 2], "{svg}");
    // A pot and a piston, and a block and a plate, each with two rods.
    assert_eq!(["gas_spring", "stop"].map(|kind| lines(&svg, kind)), [Some(4); 2], "{svg}");
    // Between the same points they are side by side.
    scene.joint("strut", "damper").point("Q", GROUND, [0.4, 0.0]).point("P", "piston", [0.0, 0.0]);
    let svg = scene.svg();
    assert!(lines(&svg, "spring") == Some(9) && !svg.contains("<title>strut"), "{svg}");
    assert!(!svg.contains("class=\"d\""));
    // A stop beside a spring is not drawn.
    scene.joint("bump", "stop").point("P", GROUND, [0.4, 0.3]).point("Q", "piston", [0.0, 0.0]);
    let svg = scene.svg();
    assert!(!svg.contains("<title>bump") && lines(&svg, "constant_force") == Some(1) && lines(&svg, "stop") == Some(4), "{svg}");
}

#[test]
fn a_wheel_rolls_on_its_rail() {
    let mut scene = Scene::new("Car");
    scene.body("car", Pose::plane(2.0, 0.7, 0.0));
    scene.body("wheel", Pose::plane(2.0, 0.7, -2.0 / 0.7));
    scene.joint("axle", "revolute").point("P", "car", [0.0, 0.0]).point("Q", "wheel", [0.0, 0.0]);
    let rolling = scene.joint("rolling", "rack_pinion").body("pinion", "wheel").point("rack", "car", [0.0, 0.0]);
    rolling.axis("u", GROUND, [1.0, 0.0]).point("O", GROUND, [0.0, 0.7]).length("R", 0.7);
    let rail = Wheels::of(&placed(&scene)).racks.remove(0).1;
    assert_eq!((rail.body, rail.contact), (None, place(2.0, 0.0)));
}

#[test]
fn pulleys_keep_their_own_radii() {
    let mut scene = two_wheels();
    scene.joint("strap", "belt").body("i", "one").body("j", "two").length("a", 0.02).length("b", 0.035);
    assert_eq!(radii(&scene), [0.02, 0.035]);
}

#[test]
fn a_planetary_train_fills_its_ring() {
    let mut scene = Scene::new("Train");
    for name in ["sun", "ring", "arm"] {
        scene.body(name, Pose::plane(0.0, 0.0, 0.0));
        scene.joint(&format!("on_{name}"), "revolute").point("P", GROUND, [0.0, 0.0]).point("Q", name, [0.0, 0.0]);
    }
    scene.point("arm", [0.042, 0.0]);
    scene.body("planet", Pose::plane(0.042, 0.0, 0.0));
    scene.joint("p", "revolute").point("P", "arm", [0.042, 0.0]).point("Q", "planet", [0.0, 0.0]);
    let willis = scene.joint("willis", "planetary");
    willis.body("sun", "sun").body("ring", "ring").body("carrier", "arm").number("z_sun", 24.0).number("z_ring", 60.0);
    let mesh = scene.joint("mesh", "gear_pair");
    mesh.body("i", "sun").body("j", "planet").number("a", 24.0).number("b", 18.0).body("carrier", "arm");
    assert_eq!(radii(&scene), [0.024, 0.018, 0.06]);
}

#[test]
fn a_rack_moves_with_the_rim_that_it_touches() {
    let contact = |radius: f64| {
        let mut scene = Scene::new("Rack");
        scene.body("rack", Pose::plane(0.0, 0.0, 0.0));
        scene.body("wheel", Pose::plane(0.0, 0.05, 0.0));
        scene.joint("d", "revolute").point("P", GROUND, [0.0, 0.05]).point("Q", "wheel", [0.0, 0.0]);
        let teeth = scene.joint("teeth", "rack_pinion");
        teeth.body("pinion", "wheel").point("rack", "rack", [0.0, 0.0]).axis("u", GROUND, [1.0, 0.0]).length("R", radius);
        let Place { x, y } = Wheels::of(&placed(&scene)).racks[0].1.contact;
        [x, y].map(|part| (part * 1e9).round() / 1e9)
    };
    // Rotating to the left, the top of a wheel moves to the left.
    assert_eq!(contact(0.025), [0.0, 0.075]);
    assert_eq!(contact(-0.025), [0.0, 0.025]);
}

#[test]
fn a_follower_touches_its_cam() {
    let (turned, roller) = (0.7, 6e-3);
    let profile = |psi: f64| 0.03 + 0.008 * libm::cos(psi);
    let mut scene = Scene::new("Valve");
    scene.body("cam", Pose::plane(0.0, 0.0, turned));
    scene.body("follower", Pose::plane(0.0, profile(core::f64::consts::FRAC_PI_2 - turned) + roller, 0.0));
    let touch = scene.joint("touch", "cam_roller");
    touch.point("O", "cam", [0.0, 0.0]).point("C", "follower", [0.0, 0.0]).length("roller", roller).function("R", profile);
    let cams = cams(&placed(&scene));
    let nearest = cams[0].outline.iter().map(|at| (*at - cams[0].at).norm()).fold(f64::INFINITY, f64::min);
    assert!((nearest - roller).abs() < 2e-4, "the roller's centre is {nearest} from the surface");
}

#[test]
fn links_in_line_leave_no_clearance() {
    let clearance = |angle: f64| engine(angle).clearance().expect("everything has a place");
    assert!(clearance(1.0) > 0.1);
    assert!(clearance(0.0) < 1e-9);
}

#[test]
fn a_scene_by_hand_is_drawn_with_its_names() {
    let picture = engine(1.0).draw().expect("a picture");
    let shown: Vec<&str> = picture.labels().iter().map(|label| label.text.as_str()).collect();
    assert!(["crank", "rod", "piston", "o", "a", "b", "bore", "motor"].iter().all(|name| shown.contains(name)), "{shown:?}");
    assert!(picture.names_all() && picture.svg().contains("<title>a: revolute of crank and rod</title>"));
    assert!(picture.page().contains("fill=\"#fff\"") && !picture.svg().contains("fill=\"#fff\""));
    assert_eq!(engine(1.0).svg(), picture.svg());
}

/// Texts of the labels of spokes about one axle, beside two arms on another one.
fn labels_of_a_wheel(spokes: u32) -> Vec<String> {
    let mut scene = Scene::new("Wheel");
    let mut hinge = |body: &str, name: &str, x: f64, angle: f64| {
        scene.body(body, Pose::plane(x, 0.0, angle));
        scene.point(body, [1.0, 0.0]);
        scene.joint(name, "revolute").point("P", GROUND, [x, 0.0]).point("Q", body, [0.0, 0.0]);
    };
    (0..spokes).for_each(|k| hinge(&format!("s{k}"), "axle", 0.0, f64::from(k) / f64::from(spokes) * core::f64::consts::TAU));
    [0.5, 2.5].iter().zip(0..).for_each(|(angle, k)| hinge(&format!("arm[{k}]"), &format!("joint[{k}]"), 4.0, *angle));
    let picture = scene.draw().expect("a picture");
    picture.labels().iter().map(|label| label.text.clone()).collect()
}

#[test]
fn in_a_crowd_labels_cover_one_body_at_most() {
    let is_named = |spokes: u32| labels_of_a_wheel(spokes).iter().any(|label| label.contains("axle"));
    assert!(is_named(12) && !is_named(40));
}

#[test]
fn in_a_crowd_names_of_several_are_not_shown() {
    let (few, many) = (labels_of_a_wheel(8), labels_of_a_wheel(24));
    let several = |label: &&String| label.contains("joint[");
    assert!(few.iter().any(|label| label == "arm[0]") && few.iter().find(several).is_some_and(|label| label.contains('…')), "{few:?}");
    assert!(many.iter().any(|label| label == "arm[0]") && many.iter().find(several).is_none(), "{many:?}");
}

#[test]
fn what_cannot_be_drawn_says_why() {
    let mut strange = engine(1.0);
    strange.point("pistn", [0.0, 0.0]);
    assert_eq!(strange.draw(), Err(Undrawable::UnknownBody("pistn".into())));
    assert!(strange.svg().contains("There is no picture: `pistn` is none of the bodies."));
    assert_eq!(Scene::new("Nothing").draw(), Err(Undrawable::Empty));
    assert_eq!(engine(f64::NAN).draw(), Err(Undrawable::Nowhere));
    let mut many = Scene::new("Many");
    (0..201).for_each(|number| many.body(&format!("b[{number}]"), Pose::plane(0.0, 0.0, 0.0)));
    assert_eq!(many.draw().expect_err("too many").to_string(), "there is no picture: in one of 201 bodies nothing could be told apart");
    assert_eq!(frames(&[engine(1.0), engine(f64::NAN)]), Err(Undrawable::Nowhere));
}

#[test]
fn ground_stands_still_throughout_a_motion() {
    let scenes: Vec<Scene> = (0..16).map(|step| engine(f64::from(step) * 0.4)).collect();
    let view = |svg: &str| svg.lines().next().map(ToOwned::to_owned);
    let ground = |svg: &str| svg.lines().find(|line| line.contains("class=\"p\" d=\"M")).map(ToOwned::to_owned);
    let frames = frames(&scenes).expect("a picture");
    assert!(ground(frames[0].svg()).is_some());
    for frame in &frames {
        assert_eq!((view(frame.svg()), ground(frame.svg())), (view(frames[0].svg()), ground(frames[0].svg())));
    }
    // In single frames the support moves out of the way of the crank.
    let alone: Vec<Habits> = scenes.iter().map(habits).collect();
    assert!(alone.iter().all(|habits| habits.at(Place::default()).count() <= 1));
}

fn habits(scene: &Scene) -> Habits {
    let placed = placed(scene);
    let setting = Setting::of(&placed);
    setting.draw(crate::view::View::of(&setting.extent()), &Habits::default()).habits
}

#[test]
fn a_guide_lies_on_one_side_throughout_a_motion() {
    // The rod pulls the block up and down in turn, with mean zero.
    let scenes: Vec<Scene> = (0..16).map(|step| engine(f64::from(step) * core::f64::consts::TAU / 16.0)).collect();
    let rail = |svg: &str| {
        let line = svg.lines().find(|line| line.starts_with("<g><path class=\"l\" d=\"M"))?;
        line.split_whitespace().nth(2)?.split('L').next().map(ToOwned::to_owned)
    };
    let rails: Vec<Option<String>> = frames(&scenes).expect("a picture").iter().map(|frame| rail(frame.svg())).collect();
    assert!(rails[0].is_some() && rails.iter().all(|other| *other == rails[0]), "{rails:?}");
}

#[test]
fn an_animation_holds_its_frames() {
    let scenes: Vec<Scene> = (0..3).map(|step| engine(f64::from(step))).collect();
    let moving = animation(&scenes, 1.5).expect("a picture");
    assert!(moving.contains("values=\"visible;hidden\" keyTimes=\"0;0.3333\" dur=\"1.5s\""));
    assert!(moving.contains("values=\"hidden;visible;hidden\" keyTimes=\"0;0.3333;0.6667\""));
    assert!(moving.contains("values=\"hidden;visible\" keyTimes=\"0;0.6667\""));
    assert!(!animation(&scenes[..1], f64::NAN).expect("a picture").contains("animate"));
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

/// Pseudo-random numbers (splitmix64).
pub(crate) struct Chance(pub(crate) u64);

impl Chance {
    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^ (mixed >> 31)
    }

    pub(crate) fn one<T: Copy>(&mut self, of: &[T]) -> T {
        of[self.next() as usize % of.len()]
    }

    pub(crate) fn number(&mut self, is_wild: bool) -> f64 {
        let usual = (self.next() % 2001) as f64 * 1e-3 - 1.0;
        let wild = [0.0, -0.0, 1e-300, 5e-324, 1e-12, 1e9, 1e30, -1e99, 1e100, 1e160, f64::MAX, f64::INFINITY, f64::NAN];
        if is_wild && self.next().is_multiple_of(4) { self.one(&wild) } else { usual }
    }
}

const KINDS: [&str; 25] = [
    "revolute",
    "weld",
    "translational",
    "point_on_line",
    "revolute_translational",
    "distance",
    "absolute_distance",
    "absolute_x",
    "absolute_y",
    "gear_pair",
    "involute_mesh",
    "planetary",
    "belt",
    "rack_pinion",
    "cam_knife",
    "cam_roller",
    "cam_flat",
    "drive_distance",
    "drive_angle",
    "drive_relative_angle",
    "drive_x",
    "drive_y",
    "drive_along",
    "",
    "kind <of> one's \"own\"",
];

const BODIES: [&str; 4] = ["a", "b[1]", "part[2].c", GROUND];

/// A scene of random contents.
fn anything(chance: &mut Chance, is_wild: bool) -> Scene {
    let mut scene = Scene::new("Anything");
    for name in &BODIES[..3] {
        let [x, y, angle] = [(); 3].map(|()| chance.number(is_wild));
        scene.body(name, Pose::plane(x, y, angle));
    }
    for _ in 0..chance.next() % 6 {
        let (body, at) = (chance.one(&BODIES), [(); 2].map(|()| chance.number(is_wild)));
        scene.point(body, at);
        scene.output("out", body, at);
    }
    for number in 0..1 + chance.next() % 6 {
        let (name, kind) = (format!("j[{number}]"), chance.one(&KINDS));
        let rate = chance.number(is_wild);
        let joint = if kind.starts_with("drive") { scene.drive(&name, kind, rate) } else { scene.joint(&name, kind) };
        for name in ["A", "B", "P", "Q", "O", "C", "F", "rack"] {
            if !chance.next().is_multiple_of(5) {
                joint.point(name, chance.one(&BODIES), [(); 2].map(|()| chance.number(is_wild)));
            }
        }
        for name in ["u", "n"] {
            joint.axis(name, chance.one(&BODIES), [(); 2].map(|()| chance.number(is_wild)));
        }
        for name in ["i", "j", "b", "carrier", "sun", "ring", "pinion"] {
            joint.body(name, chance.one(&BODIES));
        }
        for name in ["a", "b", "R", "z_sun", "z_ring", "roller"] {
            let value = chance.number(is_wild);
            if chance.next().is_multiple_of(2) {
                joint.length(name, value)
            } else {
                joint.number(name, value)
            };
        }
        for name in ["R", "h"] {
            joint.function(name, |_| chance.number(is_wild));
        }
        let along = [(); 2].map(|()| chance.number(is_wild));
        joint.joint("slide", "translational", |slide| {
            slide.axis("u", "a", along).point("Q", GROUND, along);
        });
    }
    scene
}

/// `all` if the environment variable `REULEAUX_SAMPLES` is set, as in `.ci/run`; otherwise `few`, so that the usual test run is short.
pub(crate) fn samples(few: usize, all: usize) -> usize {
    if std::env::var_os("REULEAUX_SAMPLES").is_some() { all } else { few }
}

#[test]
fn no_scene_leads_to_a_panic() {
    let mut chance = Chance(1);
    let mut drawn = 0;
    let rounds = samples(100, 600);
    for round in 0..rounds {
        let is_wild = round % 2 == 0;
        let scenes = [(); 2].map(|()| anything(&mut chance, is_wild));
        for scene in &scenes {
            drawn += usize::from(scene.draw().is_ok());
            assert!(scene.svg().ends_with("</svg>\n"));
        }
        assert_eq!(frames(&scenes).is_ok(), animation(&scenes, 1.0).is_ok());
    }
    assert!(drawn > rounds, "only {drawn} scenes were drawn");
}

#[test]
fn a_film_has_the_marks_of_its_frames() -> Result<(), Undrawable> {
    let scenes = [0.3, 0.5, 2.0].map(engine);
    let film = Film::of(&scenes, &[])?;
    let count = |svg: &str| ["<path ", "<circle ", "<text "].map(|tag| svg.matches(tag).count()).iter().sum::<usize>();
    for (number, frame) in frames(&scenes)?.iter().enumerate() {
        let marks = film.marks(number);
        assert_eq!(marks.len() + count(film.foot()), count(frame.svg()));
        for mark in marks {
            let geometry: String = mark.geometry.iter().map(|(name, value)| format!(" {name}=\"{value}\"")).collect();
            assert!(frame.svg().contains(&geometry), "{mark:?}");
        }
    }
    Ok(())
}

#[test]
fn a_film_has_room_for_places() -> Result<(), Undrawable> {
    let scenes = [0.3, 0.5].map(engine);
    let near = Film::of(&scenes, &[])?;
    let far = Film::of(&scenes, &[[1.0, -2.0].into()])?;
    let [x, y] = far.at([1.0, -2.0]);
    let [left, top, width, height] = far.frame();
    assert!(left < x && x < left + width && top < y && y < top + height);
    assert_eq!(near.at([1.0, -2.0]), [x, y], "the scale stays");
    assert!(near.frame()[3] < height);
    Ok(())
}
