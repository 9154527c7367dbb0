//! Gears, racks and belts in m: pitch circles whose radii follow from the centre distance and the ratio.

use crate::placed::{PlacedScene, Sign};
use crate::plane::{Place, Rectangle, place, polar};
use crate::teeth::Teeth;

/// A pitch circle, in m.
#[derive(Clone, Debug)]
pub(crate) struct Wheel {
    /// `None` for a wheel that is fixed to ground.
    pub(crate) body: Option<usize>,
    pub(crate) middle: Place,
    pub(crate) radius: f64,
    /// True for an internal gear.
    pub(crate) is_ring: bool,
    /// Teeth, where their number is known.
    pub(crate) teeth: Option<Teeth>,
}

/// A rack, in m.
#[derive(Clone, Debug)]
pub(crate) struct Rack {
    pub(crate) body: Option<usize>,
    /// Contact point with the pinion.
    pub(crate) contact: Place,
    pub(crate) along: Place,
    /// Unit vector from the contact towards the centre of the pinion.
    pub(crate) toward: Place,
    /// Guided point of the rack.
    pub(crate) held: Place,
    pub(crate) reach: f64,
    /// Length of the rack beyond a contact at its end.
    pub(crate) overhang: f64,
}

/// All gears, racks and belts of a scene, in m.
#[derive(Clone, Debug, Default)]
pub(crate) struct Wheels {
    pub(crate) wheels: Vec<Wheel>,
    /// Contact points of gears: number of the joint and position.
    pub(crate) meshes: Vec<(usize, Place)>,
    pub(crate) racks: Vec<(usize, Rack)>,
    /// Straight parts of belts.
    pub(crate) belts: Vec<(usize, [(Place, Place); 2])>,
}

impl Wheels {
    pub(crate) fn of(scene: &PlacedScene) -> Wheels {
        let mut found = Wheels::default();
        for (number, joint) in scene.joints.iter().enumerate() {
            let _ = match joint.kind.as_str() {
                "gear_pair" => found.gears(scene, number, joint),
                "involute_mesh" => found.involutes(scene, number, joint),
                "belt" => found.belt(scene, number, joint),
                "rack_pinion" => found.rack(scene, number, joint),
                _ => None,
            };
        }
        // The radius of a planetary train's sun follows from its mesh with a planet.
        for (number, joint) in scene.joints.iter().enumerate().filter(|(_, joint)| joint.kind == "planetary") {
            let _ = found.planetary(scene, number, joint);
        }
        found
    }

    /// Bounding box of the wheels and racks.
    pub(crate) fn frame(&self) -> Rectangle {
        let corners = |wheel: &Wheel| [wheel.middle - place(wheel.radius, wheel.radius), wheel.middle + place(wheel.radius, wheel.radius)];
        let rails = |(_, rack): &(usize, Rack)| [rack.contact - rack.along * rack.reach, rack.contact + rack.along * rack.reach];
        Rectangle::around(self.wheels.iter().flat_map(corners).chain(self.racks.iter().flat_map(rails)))
    }

    /// A fraction of the smallest radius, at which a wheel is as legible as a link of that length.
    pub(crate) fn smallest(&self) -> f64 {
        self.wheels.iter().map(|wheel| 0.6 * wheel.radius).fold(f64::INFINITY, f64::min)
    }

    /// The largest wheel of a body: its radius, and whether it is an internal gear.
    pub(crate) fn largest(&self, body: Option<usize>) -> Option<(f64, bool)> {
        let own = self.wheels.iter().filter(|wheel| wheel.body == body);
        own.max_by(|a, b| a.radius.total_cmp(&b.radius)).map(|wheel| (wheel.radius, wheel.is_ring))
    }

    /// True if the symbol of the joint is drawn by its wheels.
    pub(crate) fn shows(&self, joint: usize) -> bool {
        let numbers = self.meshes.iter().map(|mesh| mesh.0).chain(self.racks.iter().map(|rack| rack.0));
        numbers.chain(self.belts.iter().map(|belt| belt.0)).any(|number| number == joint)
    }

    /// Adds a wheel unless it is known; its number.
    fn wheel(&mut self, body: Option<usize>, middle: Place, radius: f64, is_ring: bool) -> Option<usize> {
        let is_known = |wheel: &Wheel| {
            wheel.body == body && (wheel.radius - radius).abs() < 1e-6 * radius && (wheel.middle - middle).norm() < 1e-6 * radius
        };
        let known = self.wheels.iter().position(is_known);
        if known.is_some() || !(radius > 0.0 && radius.is_finite()) {
            return known;
        }
        self.wheels.push(Wheel { body, middle, radius, is_ring, teeth: None });
        Some(self.wheels.len() - 1)
    }

    fn gears(&mut self, scene: &PlacedScene, number: usize, joint: &Sign) -> Option<()> {
        let (i, j, carrier) = (joint.body("i")?, joint.body("j")?, joint.body("carrier").unwrap_or(None));
        self.pair(scene, number, joint, [(i, scene.centre(i, carrier)), (j, scene.centre(j, carrier))])
    }

    fn involutes(&mut self, scene: &PlacedScene, number: usize, joint: &Sign) -> Option<()> {
        self.pair(scene, number, joint, [joint.point("A")?, joint.point("B")?])
    }

    /// Two gears about their centres, in the ratio of `a` and `b`.
    fn pair(&mut self, scene: &PlacedScene, number: usize, joint: &Sign, [(i, one), (j, two)]: [(Option<usize>, Place); 2]) -> Option<()> {
        let ((a, is_length), (b, _)) = (joint.number("a")?, joint.number("b")?);
        let (distance, is_external) = ((two - one).norm(), a * b > 0.0);
        let teeth = if is_external { a.abs() + b.abs() } else { (a.abs() - b.abs()).abs() };
        let size = a.abs().max(b.abs());
        // Coaxial wheels have no pitch point; their numbers may still be radii.
        let unit = if distance > 0.0 && teeth > 1e-9 * size {
            distance / teeth
        } else if is_length {
            1.0
        } else {
            return None;
        };
        let first = self.wheel(i, one, a.abs() * unit, !is_external && a.abs() > b.abs());
        let second = self.wheel(j, two, b.abs() * unit, !is_external && b.abs() > a.abs());
        if let (false, Some(first), Some(second)) = (is_length, first, second) {
            self.mesh(scene, [first, second], [a.abs(), b.abs()]);
        }
        let toward = (two - one).unit();
        let contact = if is_external || a.abs() > b.abs() { one + toward * (a.abs() * unit) } else { one - toward * (a.abs() * unit) };
        self.meshes.push((number, contact));
        Some(())
    }

    fn planetary(&mut self, scene: &PlacedScene, number: usize, joint: &Sign) -> Option<()> {
        let (sun, ring, carrier) = (joint.body("sun")?, joint.body("ring")?, joint.body("carrier")?);
        let (z_sun, z_ring) = (joint.number("z_sun")?, joint.number("z_ring")?);
        let middle = scene.centre(sun, None);
        let known = self.wheels.iter().filter(|wheel| wheel.body == sun).map(|wheel| wheel.radius).next();
        let arm = carrier
            .and_then(|carrier| scene.bodies.get(carrier))
            .map_or(0.0, |carrier| carrier.points.iter().map(|at| (*at - middle).norm()).fold(0.0, f64::max));
        let unit = match known {
            Some(radius) => radius / z_sun.0.abs(),
            None if z_sun.1 => 1.0,
            // The pin of a planet lies halfway between sun and ring.
            None => 2.0 * arm / (z_sun.0.abs() + z_ring.0.abs()),
        };
        if !(unit > 0.0 && unit.is_finite()) {
            return None;
        }
        self.wheel(sun, middle, z_sun.0.abs() * unit, false);
        let ring = self.wheel(ring, middle, z_ring.0.abs() * unit, z_sun.0 * z_ring.0 > 0.0);
        if let Some((ring, planet)) = ring.and_then(|ring| Some((ring, self.inside(ring)?)))
            && let Some(teeth) = self.wheels[planet].teeth
            && !z_ring.1
        {
            self.mesh(scene, [planet, ring], [teeth.count, z_ring.0.abs()]);
        }
        self.meshes.push((number, middle + polar(z_ring.0.abs() * unit, core::f64::consts::FRAC_PI_4)));
        Some(())
    }

    fn rack(&mut self, scene: &PlacedScene, number: usize, joint: &Sign) -> Option<()> {
        let (pinion, (body, held)) = (joint.body("pinion")?, joint.point("rack")?);
        let ((carrier, along), (radius, _)) = (joint.axis("u")?, joint.number("R")?);
        let middle = scene.centre(pinion, carrier);
        if scene.is_hinged(pinion, body) {
            return self.rail(scene, number, joint, middle);
        }
        // Point of the pinion's rim that moves with the rack.
        let contact = middle + along.perp() * radius;
        let overhang = 0.3 * radius.abs();
        let reach = ((held - contact).dot(along).abs() + overhang).max(1.3 * radius.abs());
        self.wheel(pinion, middle, radius.abs(), false);
        self.racks.push((number, Rack { body, contact, along, toward: (middle - contact).unit(), held, reach, overhang }));
        Some(())
    }

    /// A pinion on the body that moves along the line is a wheel that rolls on a rail.
    fn rail(&mut self, scene: &PlacedScene, number: usize, joint: &Sign, middle: Place) -> Option<()> {
        let ((carrier, along), (radius, _)) = (joint.axis("u")?, joint.number("R")?);
        let contact = middle - along.perp() * radius;
        let held = carrier.and_then(|carrier| scene.bodies.get(carrier)).map_or(Place::default(), |carrier| carrier.origin);
        let overhang = 1.3 * radius.abs();
        self.wheel(joint.body("pinion")?, middle, radius.abs(), false);
        let rail = Rack { body: carrier, contact, along, toward: (middle - contact).unit(), held, reach: overhang, overhang };
        self.racks.push((number, rail));
        Some(())
    }

    fn belt(&mut self, scene: &PlacedScene, number: usize, joint: &Sign) -> Option<()> {
        let (i, j, carrier) = (joint.body("i")?, joint.body("j")?, joint.body("carrier").unwrap_or(None));
        let ((a, is_length), (b, _)) = (joint.number("a")?, joint.number("b")?);
        let (one, two) = (scene.centre(i, carrier), scene.centre(j, carrier));
        let distance = (two - one).norm();
        let unit = if is_length { 1.0 } else { 0.3 * distance / a.abs().max(b.abs()) };
        let (r, s) = (a.abs() * unit, b.abs() * unit * if a * b > 0.0 { 1.0 } else { -1.0 });
        if distance <= (r - s).abs() {
            return None;
        }
        self.wheel(i, one, r, false);
        self.wheel(j, two, s.abs(), false);
        // Angle between the normal of a common tangent and the line of centres.
        let (angle, line) = (libm::acos((r - s) / distance), (two - one).angle());
        let tangent = |side: f64| {
            let normal = polar(1.0, line + side * angle);
            (one + normal * r, two + normal * s)
        };
        self.belts.push((number, [tangent(1.0), tangent(-1.0)]));
        Some(())
    }
}
