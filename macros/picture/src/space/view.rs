//! Choice of the direction of view, unless one is asked for, and the projection.
//!
//! The projection is orthographic, with z upwards. Among some directions the best keeps distinct points apart, shows no joint axis end
//! on, shortens no link to nothing, and shows no plate edge on.

use super::placed::Placed;
use super::vector::{Vec3, vec3};
use crate::plane::{Place, Rectangle, place};
use core::f64::consts::PI;

/// Largest number of points and links that are compared pairwise.
const MOST: usize = 48;

/// Number of frames of a motion that are examined.
const FRAMES: usize = 6;

/// Points nearer to each other than this fraction of the size are hard to tell apart.
const APART: f64 = 0.07;

/// A direction whose horizontal part is smaller than this is upright.
const UPRIGHT: f64 = 1e-9;

/// A direction of view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Camera {
    pub(crate) right: Vec3,
    pub(crate) up: Vec3,
    /// Unit vector towards the eye.
    pub(crate) toward: Vec3,
}

impl Camera {
    /// Camera from azimuth (from x towards y) and elevation (rad).
    pub(crate) fn new(azimuth: f64, height: f64) -> Camera {
        let ((sine, cosine), (rise, level)) = (libm::sincos(azimuth), libm::sincos(height));
        let toward = vec3(level * cosine, level * sine, rise);
        let right = vec3(-sine, cosine, 0.0);
        Camera { right, up: toward.cross(right), toward }
    }

    /// Camera from a vector of any length towards the eye. Seen from above or below, x points to the right, as in the front view.
    pub(crate) fn from_direction(eye: Vec3) -> Option<Camera> {
        let toward = eye.direction()?;
        let level = libm::hypot(toward.x, toward.y);
        let right = if level > UPRIGHT { vec3(-toward.y / level, toward.x / level, 0.0) } else { vec3(1.0, 0.0, 0.0) };
        Some(Camera { right, up: toward.cross(right), toward })
    }

    /// Projection: components to the right and upwards.
    pub(crate) fn project(&self, at: Vec3) -> Place {
        place(at.dot(self.right), at.dot(self.up))
    }

    /// The candidate of least cost.
    pub(crate) fn best(scenes: &[Placed]) -> Camera {
        let step = scenes.len().div_ceil(FRAMES).max(1);
        let looks: Vec<Look> = scenes.iter().step_by(step).map(Look::of).collect();
        let mut best: Option<(f64, Camera)> = None;
        for (preference, camera) in candidates() {
            let cost = preference + looks.iter().map(|look| look.cost(&camera)).sum::<f64>() / looks.len().max(1) as f64;
            // The margin keeps rounding errors from deciding between equal candidates.
            if best.is_none_or(|(least, _)| cost < least - 1e-6) {
                best = Some((cost, camera));
            }
        }
        best.map_or_else(|| Camera::new(-PI / 3.0, PI / 6.0), |(_, camera)| camera)
    }
}

/// Directions of view, the usual one first, each with its cost.
fn candidates() -> impl Iterator<Item = (f64, Camera)> {
    let degrees = PI / 180.0;
    let azimuths = (0..4).flat_map(|quadrant| [-60, -52, -68, -44, -38, -30, -24].map(move |azimuth| (quadrant, azimuth)));
    azimuths.flat_map(move |(quadrant, azimuth)| {
        [26, 32, 20, 38].into_iter().enumerate().map(move |(rank, height)| {
            // The front is preferred to a side, and a side to the back.
            let strange = [0.0, 0.08, 0.22, 0.16][quadrant as usize] + 0.002 * f64::from((azimuth + 60_i32).abs()) + 0.02 * rank as f64;
            (strange, Camera::new(f64::from(azimuth + 90 * quadrant) * degrees, f64::from(height) * degrees))
        })
    })
}

/// Least projected distance of two points that are distinct in space, relative to the size of the scene.
pub(crate) fn clearance(scene: &Placed, camera: &Camera) -> f64 {
    let look = Look::of(scene);
    let seen: Vec<Place> = look.places.iter().map(|at| camera.project(*at)).collect();
    let pairs = seen.iter().enumerate().flat_map(|(index, one)| seen[..index].iter().map(move |two| (*one - *two).norm()));
    pairs.fold(f64::INFINITY, f64::min) / look.size
}

/// Parts of a scene that must be distinguishable.
struct Look {
    size: f64,
    places: Vec<Vec3>,
    bars: Vec<(Vec3, Vec3)>,
    axes: Vec<Vec3>,
    normals: Vec<Vec3>,
}

impl Look {
    fn of(scene: &Placed) -> Look {
        let all: Vec<Vec3> = scene.places().collect();
        let first = all.first().copied().unwrap_or_default();
        let size = all.iter().map(|at| (*at - first).norm()).fold(0.0, f64::max);
        let mut places: Vec<Vec3> = Vec::new();
        for at in all {
            if places.len() < MOST && places.iter().all(|known| (*known - at).norm() > 1e-3 * size) {
                places.push(at);
            }
        }
        let bars = scene.bodies.iter().filter_map(super::placed::Solid::bar).filter(|(one, two)| (*two - *one).norm() > 1e-3 * size);
        let rods = scene.joints.iter().filter(|joint| joint.kind.ends_with("distance"));
        let rods = rods.filter_map(|joint| Some((joint.given.point("P")?.at, joint.given.point("Q")?.at)));
        let axes = scene.joints.iter().filter(|joint| joint.given.points().next().is_some()).filter_map(|joint| joint.given.axis("a"));
        let normals = scene.bodies.iter().filter_map(|body| {
            let (one, two) = body.bar()?;
            let along = (two - one).direction()?;
            let farthest = body.points.iter().map(|at| (*at - one).across(along)).max_by(|a, b| a.norm().total_cmp(&b.norm()))?;
            (farthest.norm() > 0.1 * (two - one).norm()).then(|| along.cross(farthest).unit())
        });
        let (bars, axes) = (bars.chain(rods).take(MOST).collect(), axes.map(|of| of.at).take(MOST).collect());
        Look { size, places, bars, axes, normals: normals.take(MOST).collect() }
    }

    /// Cost of the parts that cannot be told apart from this direction.
    fn cost(&self, camera: &Camera) -> f64 {
        let near = |distance: f64| (1.0 - distance / (APART * self.size)).max(0.0);
        let seen: Vec<Place> = self.places.iter().map(|at| camera.project(*at)).collect();
        let mut cost = 0.0;
        for (index, one) in seen.iter().enumerate() {
            for (other, two) in seen[..index].iter().enumerate() {
                // Points that are near in space may be near in the projection.
                let apart = (self.places[index] - self.places[other]).norm();
                cost += (near((*one - *two).norm()) - near(apart)).max(0.0);
            }
        }
        for (a, b) in &self.bars {
            let (one, two) = (camera.project(*a), camera.project(*b));
            let hidden = |(at, place): (&Place, &Vec3)| {
                let is_own = (*place - *a).norm() < 1e-3 * self.size || (*place - *b).norm() < 1e-3 * self.size;
                if is_own { 0.0 } else { 0.5 * near(at.to_segment(one, two)) }
            };
            cost += seen.iter().zip(&self.places).map(hidden).sum::<f64>();
            let along = (*b - *a).unit().dot(camera.toward).abs();
            cost += ((along - 0.7) / 0.3).max(0.0) * 0.8 + 0.5 * (1.0 - (1.0 - along * along).max(0.0).sqrt());
        }
        cost /= (self.places.len() as f64 / 4.0).max(1.0);
        let spread = Rectangle::around(seen.iter().copied()).size();
        cost -= 0.6 * spread.x.min(spread.y) / self.size.max(f64::MIN_POSITIVE);
        let end_on = |axis: &Vec3| ((axis.dot(camera.toward).abs() - 0.8) / 0.2).max(0.0);
        let edge_on = |normal: &Vec3| (1.0 - normal.dot(camera.toward).abs() / 0.3).max(0.0);
        let mean = |costs: f64, count: usize| costs / (count as f64 / 3.0).max(1.0);
        cost + mean(self.axes.iter().map(end_on).sum(), self.axes.len()) + mean(self.normals.iter().map(edge_on).sum(), self.normals.len())
    }
}

/// A camera with the centre and the scale of the picture.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sight {
    pub(crate) camera: Camera,
    middle: Vec3,
    /// Picture units per metre.
    pub(crate) scale: f64,
}

impl Sight {
    /// `middle` is the centre of the picture (m, to the right and upwards).
    pub(crate) fn new(camera: Camera, middle: Place, scale: f64) -> Sight {
        Sight { camera, middle: camera.right * middle.x + camera.up * middle.y, scale }
    }

    /// From m to picture units, still in space.
    pub(crate) fn enlarge(&self, at: Vec3) -> Vec3 {
        (at - self.middle) * self.scale
    }

    /// Projection of a point in picture units into the picture, with y downwards.
    pub(crate) fn at(&self, at: Vec3) -> Place {
        let seen = self.camera.project(at);
        place(seen.x, -seen.y)
    }

    /// Coordinate towards the eye.
    pub(crate) fn depth(&self, at: Vec3) -> f64 {
        at.dot(self.camera.toward)
    }
}
