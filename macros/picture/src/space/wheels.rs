//! Wheels in space: spur and bevel gears as pitch surfaces, worms, racks.

use super::drawing::Drawing;
use super::pen::Pen;
use super::placed::{Given, Made, Of, Placed};
use super::vector::Vec3;
use crate::canvas::{DrawnItem, Ink, Layer, Near, Stroke, Subject};
use crate::plane::{Place, hull};
use core::f64::consts::TAU;

/// Half the width of a spur gear.
const HALF: f64 = 4.0;

/// From this ratio on, crossed wheels are drawn as a worm and its wheel.
const WORM: f64 = 4.0;

/// Shape of a wheel.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Look {
    Spur,
    /// A cone with this apex.
    Bevel(Vec3),
    Worm,
}

#[derive(Clone, Debug)]
pub(crate) struct Wheel {
    body: Option<usize>,
    pub(crate) at: Vec3,
    axis: Vec3,
    pub(crate) radius: f64,
    look: Look,
    /// Position of the hinge.
    hinge: Vec3,
}

#[derive(Clone, Copy, Debug)]
struct Rack {
    body: Option<usize>,
    contact: Vec3,
    along: Vec3,
    /// Direction of the teeth, towards the pinion.
    teeth: Vec3,
    held: Vec3,
}

/// A joint between wheels, with the contact point.
#[derive(Clone, Debug)]
struct Mesh {
    joint: usize,
    contact: Vec3,
}

/// All wheels of a scene.
#[derive(Clone, Debug, Default)]
pub(crate) struct Wheels {
    pub(crate) wheels: Vec<Wheel>,
    racks: Vec<Rack>,
    meshes: Vec<Mesh>,
}

/// A wheel of unknown size.
#[derive(Clone, Copy, Debug)]
struct Seat {
    body: Option<usize>,
    at: Vec3,
    axis: Vec3,
}

impl Wheels {
    /// Finds the wheels of all gears and racks; lengths are in units of the scene.
    pub(crate) fn of(scene: &Placed) -> Wheels {
        let mut wheels = Wheels::default();
        for (number, joint) in scene.joints.iter().enumerate() {
            let given = &joint.given;
            let found = match joint.kind.as_str() {
                "gear_pair" => wheels.pair(scene, given),
                "rack_pinion" => wheels.rack(scene, given),
                _ => None,
            };
            wheels.meshes.extend(found.map(|contact| Mesh { joint: number, contact }));
        }
        wheels
    }

    fn pair(&mut self, scene: &Placed, given: &Given) -> Option<Vec3> {
        let [one, two] = given.joints() else { return None };
        let common = common(one, two)?;
        let (one, two) = (seat(scene, one, common)?, seat(scene, two, common)?);
        let (a, b) = (given.number("a")?, given.number("b")?);
        let (p, q) = (a.abs(), b.abs());
        if p == 0.0 || q == 0.0 || !(p / q).is_finite() || !(q / p).is_finite() {
            return None;
        }
        let cross = one.axis.cross(two.axis);
        let between = two.at - one.at;
        if cross.norm() < 0.02 {
            let across = between.across(one.axis);
            let (distance, way) = (across.norm(), across.direction()?);
            if distance < 1e-6 * between.norm() {
                return None;
            }
            let is_outer = a * b * one.axis.dot(two.axis) > 0.0;
            let whole = if is_outer { p + q } else { (p - q).abs() };
            let (r, s) = (distance * p / whole, distance * q / whole);
            if !r.is_finite() || !s.is_finite() {
                return None;
            }
            let centre = two.at + two.axis * (one.at - two.at).dot(two.axis);
            self.add(one, one.at, r, Look::Spur);
            self.add(two, centre, s, Look::Spur);
            let way = if is_outer || p > q { way } else { -way };
            return Some(one.at + way * r);
        }
        // Feet of the common perpendicular of the axes.
        let square = cross.dot(cross);
        let foot_of_one = one.at + one.axis * (between.cross(two.axis).dot(cross) / square);
        let foot_of_two = two.at + two.axis * (between.cross(one.axis).dot(cross) / square);
        let gap = (foot_of_two - foot_of_one).norm();
        let size = between.norm().max((one.at - foot_of_one).norm()).max((two.at - foot_of_two).norm());
        if gap < 1e-3 * size {
            return self.bevel([one, two], foot_of_one, [p, q]);
        }
        let parts = if p / q >= WORM {
            [0.84, 0.16]
        } else if q / p >= WORM {
            [0.16, 0.84]
        } else {
            [p / (p + q), q / (p + q)]
        };
        let look = |part: f64| if part < 0.17 { Look::Worm } else { Look::Spur };
        self.add(one, foot_of_one, gap * parts[0], look(parts[0]));
        self.add(two, foot_of_two, gap * parts[1], look(parts[1]));
        Some(foot_of_one + (foot_of_two - foot_of_one) * parts[0])
    }

    /// Two cones that roll on each other about a common apex.
    fn bevel(&mut self, seats: [Seat; 2], apex: Vec3, teeth: [f64; 2]) -> Option<Vec3> {
        let ways = seats.map(|seat| seat.at - apex);
        let sides = [ways[0].direction()?, ways[1].direction()?];
        let (cosine, sine) = (sides[0].dot(sides[1]), sides[0].cross(sides[1]).norm());
        let angles = [0, 1].map(|k| libm::atan2(sine, teeth[1 - k] / teeth[k] + cosine));
        let slants = [0, 1].map(|k| ways[k].norm() / libm::cos(angles[k]));
        if angles.iter().any(|angle| !(0.02..1.55).contains(angle)) {
            return None;
        }
        // Meshing bevel wheels have the same cone distance.
        let near = |at: Vec3| (at - apex).norm() < 1e-3 * ways[0].norm();
        let known = self.wheels.iter().filter(|wheel| matches!(wheel.look, Look::Bevel(other) if near(other)));
        let known = known.map(|wheel| libm::hypot(wheel.radius, (wheel.at - apex).norm())).reduce(f64::min);
        let slant = known.unwrap_or(f64::INFINITY).min(slants[0]).min(slants[1]);
        for wheel in self.wheels.iter_mut().filter(|wheel| matches!(wheel.look, Look::Bevel(other) if near(other))) {
            let factor = slant / libm::hypot(wheel.radius, (wheel.at - apex).norm());
            wheel.radius *= factor;
            wheel.at = apex + (wheel.at - apex) * factor;
        }
        for k in [0, 1] {
            let (sine, cosine) = libm::sincos(angles[k]);
            self.add(seats[k], apex + sides[k] * (slant * cosine), slant * sine, Look::Bevel(apex));
        }
        let (own_sine, own_cosine) = libm::sincos(angles[0]);
        Some(apex + (sides[0] * own_cosine + sides[1].across(sides[0]).unit() * own_sine) * slant)
    }

    fn rack(&mut self, scene: &Placed, given: &Given) -> Option<Vec3> {
        let [made] = given.joints() else { return None };
        let (p, q, a) = (given.point("P")?, given.point("Q")?, given.axis("a")?);
        let pinion = seat(scene, made, p.body)?;
        let radius = given.number("radius")?.abs() * scene.scale;
        let between = (q.at - pinion.at).across(a.at).across(pinion.axis);
        let out = between.direction().or_else(|| pinion.axis.cross(a.at).direction())?;
        let contact = pinion.at + out * radius;
        self.add(pinion, pinion.at, radius, Look::Spur);
        self.racks.push(Rack { body: q.body, contact, along: a.at, teeth: -out, held: q.at });
        Some(contact)
    }

    /// Adds a wheel, once for each body and hinge.
    fn add(&mut self, seat: Seat, at: Vec3, radius: f64, look: Look) {
        let Seat { body, axis, at: hinge } = seat;
        let is_known =
            |wheel: &Wheel| wheel.body == body && (wheel.at - at).norm() < 1e-3 * radius && (wheel.radius - radius).abs() < 1e-3 * radius;
        if !self.wheels.iter().any(is_known) {
            self.wheels.push(Wheel { body, at, axis, radius, look, hinge });
        }
    }

    /// True if the joint is drawn by its wheels.
    pub(crate) fn shows(&self, joint: usize) -> bool {
        self.meshes.iter().any(|mesh| mesh.joint == joint)
    }

    /// Extent of the wheels along an axis from a place.
    pub(crate) fn reach(&self, at: Vec3, axis: Vec3) -> f64 {
        let own = self.wheels.iter().filter(|wheel| wheel.axis.dot(axis).abs() > 0.99 && (wheel.at - at).norm() < 2.0);
        own.map(Wheel::half).fold(0.0, f64::max)
    }

    /// Marks bodies with wheels as shown, and gives them shafts to their hinges.
    pub(crate) fn show(&self, drawing: &mut Drawing) {
        for wheel in &self.wheels {
            let Some(body) = wheel.body else { continue };
            drawing.shapes[body].is_shown = true;
            if (wheel.at - wheel.hinge).norm() > 3.0 {
                drawing.shapes[body].bars.push((wheel.hinge, wheel.at));
            }
        }
        for rack in &self.racks {
            let Some(body) = rack.body else { continue };
            let held = (rack.held - rack.contact).dot(rack.along);
            let (low, high) = (held.min(-20.0) - 14.0, held.max(20.0) + 14.0);
            drawing.shapes[body].bars.push((rack.contact + rack.along * low, rack.contact + rack.along * high));
        }
    }

    pub(crate) fn draw(&self, drawing: &mut Drawing) {
        for wheel in &self.wheels {
            let mesh = self.meshes.iter().find(|mesh| (mesh.contact - wheel.at).across(wheel.axis).norm() < 1.01 * wheel.radius + 1.0);
            let title = mesh.map_or_else(String::new, |mesh| drawing.title(&drawing.scene.joints[mesh.joint]));
            let mut pen = drawing.pen(&title);
            wheel.draw(&mut pen, drawing.scene);
            let depth = drawing.sight.depth(wheel.at);
            drawing.put(depth, pen);
        }
        for rack in &self.racks {
            let mut pen = drawing.pen("");
            let tooth = |step: i32| {
                let at = rack.contact + rack.along * (6.0 * f64::from(step));
                vec![at, at + rack.teeth * 6.0]
            };
            pen.lines(Layer::Block, Ink::Line, &(-4..=4).map(tooth).collect::<Vec<_>>());
            let depth = drawing.depth_on(rack.contact) + 0.3;
            drawing.put(depth, pen);
        }
        for mesh in &self.meshes {
            let name = drawing.scene.joints[mesh.joint].name.clone();
            let at = drawing.sight.at(mesh.contact);
            drawing.canvas.wish(Subject::Joint, &name, Near::Point(at, 7.0));
        }
    }
}

impl Wheel {
    fn draw(&self, pen: &mut Pen, scene: &Placed) {
        let body = self.body.unwrap_or(usize::MAX);
        match self.look {
            Look::Spur => {
                let (from, to) = (self.at - self.axis * HALF, self.at + self.axis * HALF);
                pen.mantle(Layer::Wheel, Ink::Glass, from, to, self.radius);
                pen.mantle(Layer::Wheel, Ink::Wheel(body), from, to, self.radius);
                let front = if pen.sight.depth(self.axis) >= 0.0 { to } else { from };
                pen.disc(Layer::Wheel, Ink::Wheel(body), front, self.axis, self.radius);
                self.spoke(pen, scene, front, self.radius);
            }
            Look::Bevel(apex) => {
                let small = (self.at + (apex - self.at) * 0.32, self.radius * 0.68);
                let (one, two) = self.axis.frame();
                let ring = |(at, radius): (Vec3, f64)| Pen::on_circle(at, [one, two], radius, 0.0, TAU);
                let ends = [ring((self.at, self.radius)), ring(small)].concat();
                let outline: Vec<Place> = hull(&ends.iter().map(|at| pen.sight.at(*at)).collect::<Vec<_>>());
                for ink in [Ink::Glass, Ink::Wheel(body)] {
                    let item = DrawnItem { layer: Layer::Wheel, ink, shape: Stroke::Closed(outline.clone()), title: pen.title.clone() };
                    pen.items.push(item);
                }
                // The end that faces the eye is visible.
                let front = if pen.sight.depth(self.at - apex) >= 0.0 { (self.at, self.radius) } else { small };
                pen.disc(Layer::Wheel, Ink::Wheel(body), front.0, self.axis, front.1);
                self.spoke(pen, scene, front.0, front.1);
            }
            Look::Worm => {
                let half = self.axis * self.half();
                pen.tube(Layer::Wheel, Ink::Block(body), self.at - half, self.at + half, self.radius);
                let turn = |step: i32| pen.half_turn(self.at + half * (f64::from(step) / 5.0), self.axis, self.radius, self.half() / 5.5);
                let turns: Vec<_> = (-4..=4).map(turn).collect();
                pen.lines(Layer::Wheel, Ink::Line, &turns);
            }
        }
    }

    /// Half the width.
    fn half(&self) -> f64 {
        if self.look == Look::Worm { (self.radius * 3.0).clamp(18.0, 60.0) } else { HALF + 2.0 }
    }

    /// A line that shows the angle of the wheel.
    fn spoke(&self, pen: &mut Pen, scene: &Placed, at: Vec3, radius: f64) {
        let Some(body) = self.body else { return };
        let fixed = scene.bodies[body].columns().map(|column| column.across(self.axis));
        let longest = fixed.into_iter().fold(Vec3::default(), |best, next| if next.norm() > best.norm() + 1e-6 { next } else { best });
        if let Some(way) = longest.direction() {
            pen.line(Layer::Wheel, Ink::Of(body), &[at + way * (0.35 * radius), at + way * (0.95 * radius)]);
        }
    }
}

/// The reference body that both angles share.
fn common(one: &Made, two: &Made) -> Option<Option<usize>> {
    let bodies = |made: &Made| Some([made.given.axis("a")?.body, made.given.axis("b")?.body]);
    let (one, two) = (bodies(one)?, bodies(two)?);
    one.into_iter().find(|body| two.contains(body))
}

/// The wheel of an angle: the body that rotates relative to the common one.
fn seat(scene: &Placed, made: &Made, common: Option<usize>) -> Option<Seat> {
    let (a, b) = (made.given.axis("a")?, made.given.axis("b")?);
    let wheel: Of = if b.body == common { a } else { b };
    // Measured from the second body, the angle changes its sign.
    let axis = if b.body == common { -a.at } else { a.at };
    let bodies = [a.body, b.body];
    let joint = scene
        .joint_on(axis, |p, q| [p, q] == bodies || [q, p] == bodies)
        .or_else(|| scene.joint_on(axis, |p, q| p == wheel.body || q == wheel.body))?;
    Some(Seat { body: wheel.body, at: scene.joints[joint].given.point("P")?.at, axis })
}
