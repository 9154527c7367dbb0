//! One typical mistake in a valid model.

use super::elements::meshing;
use super::model::{Item, Model, Sort, one};
use fastrand::Rng;

/// Kind of mistake.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    UnknownName,
    DroppedJoint,
    DroppedDrive,
    DoubledJoint,
    DoubledDrive,
    WrongDimension,
    ZeroRadius,
    JointOnGround,
    LonelyBody,
    DuplicatedName,
    DriveOfALockedBody,
    ThirdCrank,
    ShortDyad,
    ParallelGuides,
}

pub(super) const KINDS: &[Kind] = &[
    Kind::UnknownName,
    Kind::DroppedJoint,
    Kind::DroppedDrive,
    Kind::DoubledJoint,
    Kind::DoubledDrive,
    Kind::WrongDimension,
    Kind::ZeroRadius,
    Kind::JointOnGround,
    Kind::LonelyBody,
    Kind::DuplicatedName,
    Kind::DriveOfALockedBody,
    Kind::ThirdCrank,
    Kind::ShortDyad,
    Kind::ParallelGuides,
];

impl Kind {
    /// Makes the mistake; returns words, one of which the refusal must contain.
    pub(super) fn put_into(self, model: &mut Model, rng: &mut Rng) -> Vec<String> {
        match self {
            Kind::UnknownName => unknown_name(model, rng),
            Kind::DroppedJoint => dropped(model, rng, Sort::Joint),
            Kind::DroppedDrive => dropped(model, rng, Sort::Drive),
            Kind::DoubledJoint => doubled(model, rng, Sort::Joint),
            Kind::DoubledDrive => doubled(model, rng, Sort::Drive),
            Kind::WrongDimension => wrong_dimension(model, rng),
            Kind::ZeroRadius => zero_radius(model, rng),
            Kind::JointOnGround => added(model, &["joint stray = revolute(ground.G0, ground.G1);"], &["stray"]),
            Kind::LonelyBody => added(model, &["body lonely { point P = (20mm, 0mm); }"], &["lonely"]),
            Kind::DuplicatedName => duplicated(model, rng),
            Kind::DriveOfALockedBody => {
                let bolts = "joint bolts = weld(ground.G0, frame.position);";
                added(model, &["body frame { }", bolts, "drive shake = drive_angle(frame, 2deg * sin(1rad_s * t));"], &["bolts", "shake"])
            }
            Kind::ThirdCrank => third_crank(model),
            Kind::ShortDyad => short_dyad(model),
            Kind::ParallelGuides => parallel_guides(model),
        }
    }
}

fn words(words: &[&str]) -> Vec<String> {
    words.iter().map(|word| (*word).to_owned()).collect()
}

/// Adds items that are wrong together.
fn added(model: &mut Model, items: &[&str], guilty: &[&str]) -> Vec<String> {
    for item in items {
        model.item(Sort::Other, "", item, &[]);
    }
    words(guilty)
}

/// An item of a kind that no other item mentions.
fn any(model: &Model, rng: &mut Rng, sort: Sort) -> usize {
    let all: Vec<usize> = (0..model.items.len()).filter(|item| model.items[*item].sort == sort && !model.items[*item].is_used).collect();
    *one(rng, &all)
}

/// A joint to an undeclared body.
fn unknown_name(model: &mut Model, rng: &mut Rng) -> Vec<String> {
    let index = any(model, rng, Sort::Joint);
    let moving: Vec<usize> = model.items[index].bodies.iter().copied().filter(|body| *body > 0).collect();
    let path = &model.bodies[*one(rng, &moving)].path;
    // The last word of the path, without its index.
    let (whole, index_of_it) = path.split_at(path.find('[').unwrap_or(path.len()));
    let item = &mut model.items[index];
    item.text = item.text.replacen(path, &format!("{whole}_{index_of_it}"), 1);
    vec![format!("`{}_`", whole.rsplit('.').next().unwrap_or(whole))]
}

/// Removes an item, so that the bodies it held become loose, with everything they carry.
fn dropped(model: &mut Model, rng: &mut Rng, sort: Sort) -> Vec<String> {
    let index = any(model, rng, sort);
    let Item { bodies, .. } = model.items.remove(index);
    model.carried(&bodies.into_iter().filter(|body| *body > 0).collect::<Vec<_>>())
}

/// Duplicates an item under another name; a drive with another law.
fn doubled(model: &mut Model, rng: &mut Rng, sort: Sort) -> Vec<String> {
    let index = any(model, rng, sort);
    let Item { name, text, bodies, .. } = model.items[index].clone();
    let text = text.replacen(&name, "again", 1).replace("rpm", "deg_s");
    model.item(sort, "again", &text, &bodies);
    vec!["again".to_owned(), name]
}

/// An angle for a length, or a speed for an angle.
fn wrong_dimension(model: &mut Model, rng: &mut Rng) -> Vec<String> {
    if rng.bool() {
        return added(model, &["param wrong: Length = 12.5deg;"], &["12.5deg"]);
    }
    let index = model.items.iter().position(|item| item.sort == Sort::Drive && item.text.contains("rpm * t")).expect("there is a crank");
    let item = &mut model.items[index];
    item.text = item.text.replace("rpm * t", "rpm");
    vec![item.name.clone()]
}

/// A gear or a pulley of radius zero.
fn zero_radius(model: &mut Model, rng: &mut Rng) -> Vec<String> {
    meshing(model, rng);
    let item = model.items.last_mut().expect("the mesh was added");
    let (head, tail) = item.text.rsplit_once(", ").expect("the sizes are the last arguments");
    let zero = if tail.contains("mm") { "b: 0mm" } else { "0" };
    item.text = format!("{head}, {zero});");
    vec![item.name.clone()]
}

/// One name for two items.
fn duplicated(model: &mut Model, rng: &mut Rng) -> Vec<String> {
    let index = any(model, rng, Sort::Body);
    let name = model.items[index].name.clone();
    let sort = *one(rng, &["param {}: Length = 1mm;", "let {} = 5;", "joint {} = absolute_x((0mm, 0mm), 0mm);", "body {} { }"]);
    added(model, &[&sort.replace("{}", &name)], &[&format!("`{name}` is taken")])
}

/// A parallelogram on three cranks, one of which is redundant.
fn third_crank(model: &mut Model) -> Vec<String> {
    let cranks = ["fore", "mid", "aft"].map(|name| {
        let at = match name {
            "fore" => 0,
            "mid" => 150,
            _ => 300,
        };
        [
            format!("body {name} {{ point A = (80mm, 0mm); start angle = 60deg; }}"),
            format!("joint {name}_axle = revolute(({at}mm, 900mm), {name}.position);"),
            format!("joint {name}_pin = revolute({name}.A, side_rod.{name});"),
        ]
    });
    let rod = "body side_rod { point fore = (0mm, 0mm); point mid = (150mm, 0mm); point aft = (300mm, 0mm); }";
    let items: Vec<&str> = cranks.iter().flatten().map(String::as_str).chain([rod]).collect();
    added(model, &items, &[]);
    added(model, &["drive steam = drive_angle(fore, 60deg + 30rpm * t);"], &["fore_", "mid_", "aft_", "steam"])
}

/// Two bars that do not reach each other.
fn short_dyad(model: &mut Model) -> Vec<String> {
    let items = [
        "body near { point end = (100mm, 0mm); }",
        "body far { point end = (150mm, 0mm); }",
        "joint near_pin = revolute((0mm, 900mm), near.position);",
        "joint far_pin = revolute((300mm, 900mm), far.position);",
        "joint knee = revolute(near.end, far.end);",
    ];
    added(model, &items, &["near_pin", "far_pin", "knee"])
}

/// A carriage on two parallel rails: both determine its angle.
fn parallel_guides(model: &mut Model) -> Vec<String> {
    let items = [
        "body carriage { point P = (100mm, 75mm); }",
        "joint rail = translational((4, 3), (0mm, 900mm), carriage.position);",
        "joint second_rail = point_on_line((0mm, 900mm), (4, 3), carriage.P);",
    ];
    added(model, &items, &["rail", "second_rail"])
}
