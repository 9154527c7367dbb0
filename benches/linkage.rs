//! A linkage as data: points, rigid links between them, a crank. The reference, the sketch solver and the peers read it; the
//! declarations in `workloads/` say the same in the language of `mechanism!`.

use crate::hand::{Crank, dyad, fixed};

/// A linkage whose crank turns or swings. Lengths in m, time in s.
#[derive(Clone, Debug)]
pub struct Linkage {
    /// Its name in tables.
    pub name: &'static str,
    /// Where its points are at t = 0, exactly or nearly: first those of the ground.
    pub points: Vec<[f64; 2]>,
    /// How many of them belong to the ground.
    pub fixed: usize,
    /// The driven link.
    pub crank: Crank,
    /// Its pivot and its pin, as indices of points.
    pub crank_ends: [usize; 2],
    /// The links that follow.
    pub links: Vec<Link>,
    /// A point that stays on y = 0, with a body that does not turn.
    pub slider: Option<usize>,
    /// Sets of points that follow together from those before them.
    pub order: Vec<Vec<usize>>,
    /// The point whose motion is compared.
    pub tracked: usize,
    /// The length that position errors are a share of.
    pub size: f64,
}

/// A rigid link: a bar, or a triangle on it.
#[derive(Clone, Copy, Debug)]
pub struct Link {
    /// Both ends, as indices of points.
    pub ends: [usize; 2],
    /// How far apart they are.
    pub length: f64,
    /// A third point.
    pub apex: Option<Apex>,
}

/// The third point of a triangular link.
#[derive(Clone, Copy, Debug)]
pub struct Apex {
    /// Index of the point.
    pub point: usize,
    /// How far it is from either end.
    pub distances: [f64; 2],
    /// 1 to the left of the way from the first to the second end, −1 to the right.
    pub side: f64,
}

/// Two points and how far apart they are.
pub type Bar = (usize, usize, f64);

impl Link {
    /// A link with two pins.
    #[must_use]
    pub fn bar(a: usize, b: usize, length: f64) -> Self {
        Self { ends: [a, b], length, apex: None }
    }

    /// A link with three pins, the third to the left of the way between the others if `side` is 1.
    #[must_use]
    pub fn triangle(ends: [usize; 2], length: f64, point: usize, distances: [f64; 2], side: f64) -> Self {
        Self { ends, length, apex: Some(Apex { point, distances, side }) }
    }

    /// Its points in a frame at the first end, with x towards the second.
    #[must_use]
    pub fn local(&self) -> Vec<(usize, [f64; 2])> {
        let mut points = vec![(self.ends[0], [0.0; 2]), (self.ends[1], [self.length, 0.0])];
        points.extend(self.apex.map(|apex| (apex.point, apex.local(self.length))));
        points
    }

    fn bars(&self) -> Vec<Bar> {
        let [a, b] = self.ends;
        let mut bars = vec![(a, b, self.length)];
        if let Some(Apex { point, distances: [from_a, from_b], .. }) = self.apex {
            bars.extend([(a, point, from_a), (b, point, from_b)]);
        }
        bars
    }
}

impl Apex {
    /// The point in the frame of a link of this length.
    #[must_use]
    pub fn local(&self, length: f64) -> [f64; 2] {
        let [a, b] = self.distances;
        let x = (length * length + a * a - b * b) / (2.0 * length);
        [x, self.side * (a * a - x * x).sqrt()]
    }
}

impl Linkage {
    /// All constant distances.
    #[must_use]
    pub fn bars(&self) -> Vec<Bar> {
        self.links.iter().flat_map(Link::bars).collect()
    }

    /// Adds the point that lies at `ra` from a and `rb` from b at t = 0, to the left of the way from a to b if `side` is 1, and
    /// gives its index. It follows from those two.
    pub fn hang(&mut self, (a, ra): (usize, f64), (b, rb): (usize, f64), side: f64) -> usize {
        let place = |point: usize| fixed(self.points[point][0], self.points[point][1]);
        let place = dyad(&place(a), ra, &place(b), rb, side).p;
        self.points.push(place.into());
        self.order.push(vec![self.points.len() - 1]);
        self.points.len() - 1
    }
}
