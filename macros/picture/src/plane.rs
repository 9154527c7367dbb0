//! Points and vectors in the plane, segments, rectangles and convex areas.

use core::ops::{Add, Mul, Neg, Sub};

/// A point or a vector: in m before the projection into the picture, in picture units afterwards.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Place {
    pub(crate) x: f64,
    pub(crate) y: f64,
}

pub(crate) fn place(x: f64, y: f64) -> Place {
    Place { x, y }
}

/// Point at distance `radius` from the origin in the direction `angle` (rad).
pub(crate) fn polar(radius: f64, angle: f64) -> Place {
    place(radius * libm::cos(angle), radius * libm::sin(angle))
}

impl Place {
    pub(crate) fn norm(self) -> f64 {
        libm::hypot(self.x, self.y)
    }

    pub(crate) fn dot(self, other: Place) -> f64 {
        self.x * other.x + self.y * other.y
    }

    pub(crate) fn cross(self, other: Place) -> f64 {
        self.x * other.y - self.y * other.x
    }

    /// Rotated by a right angle from x towards y.
    pub(crate) fn perp(self) -> Place {
        place(-self.y, self.x)
    }

    /// Unit vector; along x if the vector vanishes.
    pub(crate) fn unit(self) -> Place {
        let norm = self.norm();
        if norm > 0.0 { self * (1.0 / norm) } else { place(1.0, 0.0) }
    }

    /// Rotated by `angle` (rad) from x towards y.
    pub(crate) fn turned(self, angle: f64) -> Place {
        let (sine, cosine) = libm::sincos(angle);
        place(cosine * self.x - sine * self.y, sine * self.x + cosine * self.y)
    }

    pub(crate) fn angle(self) -> f64 {
        libm::atan2(self.y, self.x)
    }

    pub(crate) fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite()
    }

    /// Distance from the segment between `a` and `b`.
    pub(crate) fn to_segment(self, a: Place, b: Place) -> f64 {
        let way = b - a;
        let square = way.dot(way);
        let along = if square > 0.0 { ((self - a).dot(way) / square).clamp(0.0, 1.0) } else { 0.0 };
        (self - a - way * along).norm()
    }
}

impl Add for Place {
    type Output = Place;
    fn add(self, other: Place) -> Place {
        place(self.x + other.x, self.y + other.y)
    }
}

impl Sub for Place {
    type Output = Place;
    fn sub(self, other: Place) -> Place {
        place(self.x - other.x, self.y - other.y)
    }
}

impl Mul<f64> for Place {
    type Output = Place;
    fn mul(self, factor: f64) -> Place {
        place(self.x * factor, self.y * factor)
    }
}

impl Neg for Place {
    type Output = Place;
    fn neg(self) -> Place {
        self * -1.0
    }
}

/// A rectangle with sides along the axes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rectangle {
    pub(crate) low: Place,
    pub(crate) high: Place,
}

impl Rectangle {
    /// The empty rectangle.
    pub(crate) fn empty() -> Rectangle {
        Rectangle { low: place(f64::INFINITY, f64::INFINITY), high: place(f64::NEG_INFINITY, f64::NEG_INFINITY) }
    }

    /// Bounding box of points.
    pub(crate) fn around(places: impl IntoIterator<Item = Place>) -> Rectangle {
        places.into_iter().fold(Rectangle::empty(), Rectangle::with)
    }

    /// Rectangle with this centre and size.
    pub(crate) fn centred(middle: Place, size: Place) -> Rectangle {
        Rectangle { low: middle - size * 0.5, high: middle + size * 0.5 }
    }

    pub(crate) fn with(self, other: Place) -> Rectangle {
        let low = place(self.low.x.min(other.x), self.low.y.min(other.y));
        Rectangle { low, high: place(self.high.x.max(other.x), self.high.y.max(other.y)) }
    }

    /// Enlarged by `margin` on every side.
    pub(crate) fn grown(self, margin: f64) -> Rectangle {
        Rectangle { low: self.low - place(margin, margin), high: self.high + place(margin, margin) }
    }

    pub(crate) fn size(self) -> Place {
        self.high - self.low
    }

    pub(crate) fn middle(self) -> Place {
        (self.low + self.high) * 0.5
    }

    pub(crate) fn overlaps(self, other: Rectangle) -> bool {
        self.low.x < other.high.x && other.low.x < self.high.x && self.low.y < other.high.y && other.low.y < self.high.y
    }

    /// True if part of a segment lies inside (Liang and Barsky's clipping).
    pub(crate) fn is_crossed(self, a: Place, b: Place) -> bool {
        // Most segments lie on one side.
        let (low, high) = (self.low, self.high);
        if (a.x < low.x && b.x < low.x) || (a.x > high.x && b.x > high.x) || (a.y < low.y && b.y < low.y) || (a.y > high.y && b.y > high.y)
        {
            return false;
        }
        let way = b - a;
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        let sides = [(-way.x, a.x - low.x), (way.x, high.x - a.x), (-way.y, a.y - low.y), (way.y, high.y - a.y)];
        for (slope, room) in sides {
            if slope == 0.0 {
                if room < 0.0 {
                    return false;
                }
            } else if slope < 0.0 {
                from = from.max(room / slope);
            } else {
                to = to.min(room / slope);
            }
        }
        from <= to
    }
}

/// Corners of the convex hull in order (Andrew's monotone chain); two points if all are collinear.
pub(crate) fn hull(places: &[Place]) -> Vec<Place> {
    let mut sorted = places.to_vec();
    sorted.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    sorted.dedup();
    if sorted.len() < 3 {
        return sorted;
    }
    let half = |places: &mut dyn Iterator<Item = &Place>| {
        let mut chain: Vec<Place> = Vec::new();
        for next in places {
            while let [.., one, two] = chain[..]
                && (two - one).cross(*next - two) <= 0.0
            {
                chain.pop();
            }
            chain.push(*next);
        }
        chain.pop();
        chain
    };
    let mut lower = half(&mut sorted.iter());
    lower.extend(half(&mut sorted.iter().rev()));
    lower
}

/// True if a point lies in the convex area with these corners in order.
pub(crate) fn is_inside(corners: &[Place], at: Place) -> bool {
    let sides = corners.iter().zip(corners.iter().cycle().skip(1));
    let turns: Vec<f64> = sides.map(|(a, b)| (*b - *a).cross(at - *a)).collect();
    turns.iter().all(|turn| *turn > 0.0) || turns.iter().all(|turn| *turn < 0.0)
}

/// The two points that are farthest apart, in the given order.
pub(crate) fn farthest(places: &[Place]) -> Option<(Place, Place)> {
    let pairs = places.iter().enumerate().flat_map(|(index, one)| places[index + 1..].iter().map(move |two| (*one, *two)));
    pairs.max_by(|a, b| (a.1 - a.0).norm().total_cmp(&(b.1 - b.0).norm()))
}
