//! Start values of the unknowns, by the declared start of the bodies.

use super::{Forest, Started};
use crate::expr::{Arena, Binary, Expr, Leaf, Mark, Node, Substitution, Triple, combination, dot};
use crate::geometry::rotation;
use crate::model::{Facing, JointQuantity, Place, Relationship, Triad};
use crate::quantity::{Ambient, Role};

/// Unit vectors are opposed at the start if their product is below this.
const OPPOSED: f64 = -1e-9;

/// Unit vectors are parallel at the start, in the same direction or not, if the size of their product is above this.
const PARALLEL: f64 = 1.0 - 1e-9;

/// A vector is parallel to an axis if the square of its part across the axis is at most this fraction of its own square.
const ALONG: f64 = 1e-12;

impl Forest<'_> {
    /// Declared orientation of a body at the start, as a quaternion.
    pub(super) fn start_quaternion(&mut self, body: usize) -> [Expr; 4] {
        let declared = &self.model.bodies[body].coordinates;
        let given: Vec<Option<Expr>> = declared.iter().filter(|one| matches!(one.role, Role::Quaternion(_))).map(|one| one.start).collect();
        [0, 1, 2, 3].map(|k| given.get(k).copied().flatten().unwrap_or_else(|| self.arena.integer(i64::from(k == 0))))
    }

    /// A vector fixed in a body, in ground, at the declared start.
    pub(super) fn at_start(&mut self, place: Place) -> Triple {
        let Some(body) = place.body else { return place.local };
        let quaternion = self.start_quaternion(body);
        let columns = rotation(self.arena, quaternion).0;
        combination(self.arena, place.local, columns)
    }

    /// The same, as joints turn the body between ground and there, if its orientation is not declared.
    fn hinged_at_start(&mut self, place: Place) -> Triple {
        match place.body.and_then(|body| self.started.get(&body)) {
            Some(started) => combination(self.arena, place.local, started.columns),
            None => self.at_start(place),
        }
    }

    /// The same, but as joints turn it only if the body turns to its declared place or to that of a drive, or if it keeps the declared orientation of
    /// another body; otherwise angles at the start are those between declared orientations.
    fn placed_at_start(&mut self, place: Place) -> Triple {
        let is_placed = place.body.is_some_and(|body| self.placed.contains(&body) || self.driven.contains(&body));
        let keeps_declared = self.keeps(place.body).flatten().is_some();
        if is_placed || keeps_declared { self.hinged_at_start(place) } else { self.at_start(place) }
    }

    /// Position of a point at the declared start.
    pub(super) fn point_at_start(&mut self, place: Place) -> Triple {
        let turned = self.at_start(place);
        let Some(body) = place.body else { return turned };
        let origin = self.origin_at_start(body);
        [0, 1, 2].map(|k| self.arena.add(origin[k], turned[k]))
    }

    /// Position of a body at the start: as declared, or else by the point that it shares with the body that it was reached from.
    fn origin_at_start(&mut self, body: usize) -> Triple {
        if let Some(origin) = self.origins.get(&body) {
            return *origin;
        }
        let declared = [0, 1, 2].map(|k| self.coordinates[Ambient::Space.first_coordinate(body) + k].start);
        let reached = self.reached[body].filter(|_| declared.iter().any(Option::is_none));
        let shared = reached.and_then(|(_, from)| self.shared_point(from, Some(body)));
        let by_joint = shared.map(|(at, own)| {
            let [to, back] = [at, own].map(|place| self.hinged_at_start(place));
            let from = at.body.map(|from| self.origin_at_start(from));
            [0, 1, 2].map(|k| {
                let place = from.map_or(to[k], |from| self.arena.add(from[k], to[k]));
                self.arena.sub(place, back[k])
            })
        });
        let zero = self.arena.integer(0);
        let origin = [0, 1, 2].map(|k| declared[k].unwrap_or_else(|| by_joint.map_or(zero, |by_joint| by_joint[k])));
        if by_joint.is_some() {
            self.origins.insert(body, origin);
        }
        origin
    }

    /// The point that two bodies share, in each of them.
    fn shared_point(&self, from: Option<usize>, to: Option<usize>) -> Option<(Place, Place)> {
        self.model.space.relations.iter().find_map(|(_, _, relation)| match relation {
            Relationship::Coincident(one, two) if (one.body, two.body) == (from, to) => Some((*one, *two)),
            Relationship::Coincident(one, two) if (two.body, one.body) == (from, to) => Some((*two, *one)),
            _ => None,
        })
    }

    /// A point of each of two bodies on the axis about which the second turns and along which it slides.
    fn points_on_hinge(&self, inner: Triad, outer: Triad) -> Option<(Place, Place)> {
        let is_hinge = |axis: &Triad| [inner, outer].iter().any(|one| (one.body, one.axes[2]) == (axis.body, axis.axes[2]));
        self.model.space.relations.iter().find_map(|(_, _, relation)| match relation {
            Relationship::OnLine(axis, one, two) if is_hinge(axis) && (one.body, two.body) == (inner.body, outer.body) => {
                Some((*one, *two))
            }
            Relationship::OnLine(axis, one, two) if is_hinge(axis) && (two.body, one.body) == (inner.body, outer.body) => {
                Some((*two, *one))
            }
            _ => None,
        })
    }

    /// Declared start of an angle or a displacement of a joint.
    pub(super) fn declared_start(&self, quantity: JointQuantity) -> Option<Expr> {
        self.model.starts.iter().find(|start| start.quantity == quantity).map(|start| start.value)
    }

    /// True if a start of the angle between two triads is declared.
    pub(super) fn starts_between(&self, one: Triad, two: Triad) -> bool {
        [JointQuantity::Angle(one, two), JointQuantity::Angle(two, one)].into_iter().any(|angle| self.declared_start(angle).is_some())
    }

    /// Declared start of the angle of the second triad against the first.
    pub(super) fn declared_angle(&mut self, one: Triad, two: Triad) -> Option<Expr> {
        let opposite = self.declared_start(JointQuantity::Angle(two, one));
        self.declared_start(JointQuantity::Angle(one, two)).or_else(|| opposite.map(|start| self.arena.neg(start)))
    }

    /// Angle of the second triad against the first at t = 0, if a drive or a freedom prescribes it alone.
    pub(super) fn driven_angle(&mut self, one: Triad, two: Triad) -> Option<Expr> {
        let model = self.model;
        let prescribed = model.joints.iter().filter(|joint| joint.is_drive).flat_map(|joint| &joint.residuals);
        prescribed.filter(|residual| !residual.is_velocity).find_map(|residual| {
            let Node::Binary(Binary::Sub, angle, law) = *self.arena.node(residual.expr) else { return None };
            let Node::Marked { mark: Mark::OfJoint(number), .. } = *self.arena.node(angle) else { return None };
            let mut at_start = Substitution::new();
            at_start.replace(Leaf::Time, self.arena.integer(0));
            let law = at_start.of(self.arena, law);
            let is_fixed = self.arena.is_fixed(law);
            match model.space.quantities[number as usize].0 {
                _ if !is_fixed => None,
                quantity if quantity == JointQuantity::Angle(one, two) => Some(law),
                quantity if quantity == JointQuantity::Angle(two, one) => Some(self.arena.neg(law)),
                _ => None,
            }
        })
    }

    /// Starts a body that a line in ground guides, or that carries a line through a point of ground, at a displacement, unless its place is
    /// declared.
    pub(super) fn start_along(&mut self, triad: Triad, displacement: Expr, from: Place, to: Place) {
        let (body, own, other, is_forward) = match (from.body, to.body) {
            (None, Some(body)) => (body, to, from, true),
            (Some(body), None) => (body, from, to, false),
            _ => return,
        };
        let first = Ambient::Space.first_coordinate(body);
        if self.coordinates[first..first + 3].iter().any(|coordinate| coordinate.start.is_some()) {
            return;
        }
        let z = self.hinged_at_start(Place { body: triad.body, local: triad.axes[2] });
        let turned = self.hinged_at_start(own);
        for k in 0..3 {
            let way = self.arena.mul(displacement, z[k]);
            let end = if is_forward { self.arena.add(other.local[k], way) } else { self.arena.sub(other.local[k], way) };
            self.coordinates[first + k].start = Some(self.arena.sub(end, turned[k]));
        }
    }

    /// The angle or displacement of a joint less its declared start, for each such start, in the unknowns and within a turn.
    pub(super) fn off_starts(&mut self) -> Vec<Expr> {
        let model = self.model;
        let each = model.starts.iter().map(|start| {
            let found = match start.quantity {
                JointQuantity::Angle(one, two) => {
                    let ([x, y, _], [other, _, _]) = (self.in_ground(one), self.in_ground(two));
                    let (s, c) = (dot(self.arena, y, other), dot(self.arena, x, other));
                    self.arena.binary(Binary::Atan2, s, c)
                }
                JointQuantity::Displacement(triad, from, to) => {
                    let z = self.vector(Place { body: triad.body, local: triad.axes[2] });
                    let (p, q) = (self.point(from), self.point(to));
                    let d = [0, 1, 2].map(|k| self.arena.sub(q[k], p[k]));
                    dot(self.arena, z, d)
                }
            };
            self.arena.sub(found, start.value)
        });
        each.collect()
    }

    /// Angle of the second triad against the first at the declared start; `None` if it is zero. If the z axes are not parallel there, it is the
    /// angle that leaves the new body closest to its declared orientation, and zero if none is declared.
    ///
    /// ```text
    /// sin = y₁ · x₂ − x₁ · y₂      cos = x₁ · x₂ + y₁ · y₂
    /// ```
    pub(super) fn start_angle(&mut self, one: Triad, two: Triad, is_declared: bool) -> Option<Expr> {
        let [[x, y, z], [xo, yo, zo]] =
            [one, two].map(|triad| triad.axes.map(|axis| self.placed_at_start(Place { body: triad.body, local: axis })));
        let [s, c] = [y, x].map(|axis| dot(self.arena, axis, xo));
        let product = dot(self.arena, z, zo);
        if self.at_defaults(product).is_none_or(|product| product.abs() > PARALLEL) {
            return self.angle_of(s, c);
        }
        let [a, b] = [x, y].map(|axis| dot(self.arena, axis, yo));
        let (s, c) = (self.arena.sub(s, a), self.arena.add(c, b));
        self.angle_of(s, c).filter(|_| is_declared)
    }

    /// Angle of the triad of a new body against the one that it is reached from, at the start: by the declared place of its origin, if its
    /// orientation is not declared and that of the other body is known, since the place of the hinge is not known without it.
    ///
    /// ```text
    /// u = r − P    from a point that both bodies share, or on the axis along which they slide, to the origin of the new body, in ground
    /// v = −s       the same, in the new body
    /// ```
    pub(super) fn start_angle_by_place(&mut self, inner: Triad, outer: Triad) -> Option<Expr> {
        let body = outer.body?;
        let declared = &self.model.bodies[body].coordinates;
        if self.has_orientation(body) || !declared.iter().any(|one| one.start.is_some()) || !self.is_orientation_known(inner.body) {
            return None;
        }
        let is_placed = declared.iter().all(|one| one.start.is_some() || !one.role.is_position());
        let on_hinge = || self.points_on_hinge(inner, outer).filter(|_| is_placed);
        let (at, own) = self.shared_point(inner.body, outer.body).or_else(on_hinge)?;
        let to_place = self.hinged_at_start(at);
        let (foot, origin) = (at.body.map(|from| self.origin_at_start(from)), self.origin_at_start(body));
        let u = [0, 1, 2].map(|k| {
            let place = foot.map_or(to_place[k], |foot| self.arena.add(foot[k], to_place[k]));
            self.arena.sub(origin[k], place)
        });
        let v = own.local.map(|part| self.arena.neg(part));
        let axes = inner.axes.map(|axis| self.hinged_at_start(Place { body: inner.body, local: axis }));
        let (u, v) = (self.across([axes[0], axes[1]], u)?, self.across([outer.axes[0], outer.axes[1]], v)?);
        let products = |arena: &mut Arena, [i, j]: [usize; 2]| [arena.mul(u[i], v[0]), arena.mul(u[j], v[1])];
        let ([a, b], [c, d]) = (products(self.arena, [1, 0]), products(self.arena, [0, 1]));
        let (s, c) = (self.arena.sub(a, b), self.arena.add(c, d));
        Some(self.arena.binary(Binary::Atan2, s, c))
    }

    /// Notes how a new body is turned at the start, if its orientation is not declared: by this angle against the triad that it is reached
    /// from, or not at all.
    pub(super) fn note_start(&mut self, inner: Triad, outer: Triad, angle: Option<Expr>) {
        let Some(body) = outer.body.filter(|body| !self.has_orientation(*body)) else { return };
        let mut axes = inner.axes.map(|axis| self.hinged_at_start(Place { body: inner.body, local: axis }));
        match angle {
            Some(angle) => axes = self.about(angle, axes),
            None => {
                for bodies in [&mut self.placed, &mut self.driven] {
                    if inner.body.is_some_and(|from| bodies.contains(&from)) {
                        bodies.insert(body);
                    }
                }
            }
        }
        let columns = self.columns(outer, axes);
        self.started.insert(body, Started { columns, inner, outer, is_hinged: angle.is_some() });
    }

    /// The triad of a new body, half turned about its x axis if its z axis points against that of the other triad at the declared start.
    pub(super) fn facing(&mut self, inner: Triad, outer: Triad) -> Triad {
        let is_opposed = self.product_at_start(inner, outer, 2).is_some_and(|z| z < OPPOSED);
        if is_opposed { self.opposed(outer, 0) } else { outer }
    }

    /// The triad from which a body is reached, half turned about its x axis if its z axis points against that of the new body at the declared
    /// start.
    pub(super) fn facing_back(&mut self, inner: Triad, outer: Triad) -> Triad {
        let is_opposed = self.product_at_start(inner, outer, 2).is_some_and(|z| z < OPPOSED);
        if is_opposed { self.opposed(inner, 0) } else { inner }
    }

    /// The triad of a new body, half turned about one of its axes if this brings it nearer to the other triad at the declared start.
    pub(super) fn facing_in_all(&mut self, inner: Triad, outer: Triad) -> Triad {
        let [Some(x), Some(y), Some(z)] = [0, 1, 2].map(|k| self.product_at_start(inner, outer, k)) else { return outer };
        // Half a turn about an axis reverses the products of the other two.
        let least = |least: (usize, f64), one: (usize, f64)| if one.1 < least.1 { one } else { least };
        let (about, others) = [(0, y + z), (1, z + x), (2, x + y)].into_iter().fold((0, OPPOSED), least);
        if others < OPPOSED { self.opposed(outer, about) } else { outer }
    }

    fn opposed(&mut self, triad: Triad, about: usize) -> Triad {
        self.has_opposed = true;
        triad.half_turned(self.arena, about)
    }

    /// Product of one axis of two triads at the start, at the defaults; `None` if declared orientations do not say it.
    fn product_at_start(&mut self, inner: Triad, outer: Triad, axis: usize) -> Option<f64> {
        let [one, two] = [inner, outer].map(|triad| Place { body: triad.body, local: triad.axes[axis] });
        let is_told = self.model.space.facing == Facing::Nearest && outer.body.is_some_and(|body| self.has_orientation(body));
        if !is_told || !self.is_declared(one) {
            return None;
        }
        let [one, two] = [one, two].map(|place| self.hinged_at_start(place));
        let value = dot(self.arena, one, two);
        self.at_defaults(value)
    }

    /// True if the direction of an axis at the start follows from declared orientations. A hinge does not turn its own axis.
    fn is_declared(&mut self, axis: Place) -> bool {
        let Some(body) = axis.body.filter(|body| !self.has_orientation(*body)) else { return true };
        let Some(Started { inner, outer, is_hinged, .. }) = self.started.get(&body).copied() else { return false };
        let opposite = axis.local.map(|part| self.arena.neg(part));
        let mut kept = if is_hinged { 2..3 } else { 0..3 };
        match kept.find(|k| [axis.local, opposite].contains(&outer.axes[*k])) {
            Some(k) => self.is_declared(Place { body: inner.body, local: inner.axes[k] }),
            None => !is_hinged && self.keeps(inner.body).is_some(),
        }
    }

    /// Ground, or the body with a declared orientation, against which no joint turns a body at the start; `None` if joints turn it against each of
    /// them.
    fn keeps(&self, body: Option<usize>) -> Option<Option<usize>> {
        let Some(number) = body.filter(|body| !self.has_orientation(*body)) else { return Some(body) };
        let started = self.started.get(&number).filter(|started| !started.is_hinged)?;
        self.keeps(started.inner.body)
    }

    /// True if the start angle of a joint follows from the orientations of its two bodies. It does not if the new body has no declared orientation
    /// and the other is driven, nor if the new body has one and that of the other is not known: such a body is noted.
    pub(super) fn says_angle(&mut self, inner: Triad, body: usize) -> bool {
        if !self.has_orientation(body) {
            return !inner.body.is_some_and(|from| self.driven.contains(&from));
        }
        let is_known = self.is_orientation_known(inner.body);
        if !is_known {
            self.turned.insert(body);
        }
        is_known
    }

    /// True if the orientation of a body at the start is declared, that of ground, or follows from such a one by the place or the angle of its joint.
    fn is_orientation_known(&self, body: Option<usize>) -> bool {
        let Some(body) = body else { return true };
        let is_free = self.coordinates.iter().any(|one| one.body == body && matches!(one.role, Role::Quaternion(_)));
        let is_turned = [&self.placed, &self.driven].iter().any(|bodies| bodies.contains(&body));
        let follows = |started: &Started| is_turned && self.is_orientation_known(started.inner.body);
        self.keeps(Some(body)).is_some() || is_free || self.started.get(&body).is_some_and(follows)
    }

    /// True if the orientation of a body at the start is declared.
    pub(super) fn has_orientation(&self, body: usize) -> bool {
        self.model.bodies[body].coordinates.iter().any(|one| matches!(one.role, Role::Quaternion(_)) && one.start.is_some())
    }

    /// Components of a vector along two axes; `None` if it is perpendicular to both at the defaults.
    fn across(&mut self, axes: [Triple; 2], vector: Triple) -> Option<[Expr; 2]> {
        let parts = axes.map(|axis| dot(self.arena, axis, vector));
        let squares = parts.map(|part| self.arena.square(part));
        let (across, whole) = (self.arena.add(squares[0], squares[1]), dot(self.arena, vector, vector));
        let (across, whole) = (self.at_defaults(across)?, self.at_defaults(whole)?);
        (across > ALONG * whole).then_some(parts)
    }

    /// Value of an expression of parameters at their defaults.
    pub(super) fn at_defaults(&mut self, expr: Expr) -> Option<f64> {
        let mut defaults = Substitution::new();
        for (number, parameter) in (0..).zip(&self.model.parameters) {
            defaults.replace(Leaf::Parameter(number), parameter.default);
        }
        let value = defaults.of(self.arena, expr);
        self.arena.value(value)
    }

    fn angle_of(&mut self, s: Expr, c: Expr) -> Option<Expr> {
        let angle = self.arena.binary(Binary::Atan2, s, c);
        let is_zero = self.arena.as_constant(s).is_some_and(|value| value.is_zero())
            && self.arena.as_constant(c).is_some_and(|value| value.signum() >= 0);
        (!is_zero).then_some(angle)
    }

    /// Angles about two perpendicular axes at the declared start.
    pub(super) fn start_cross(&mut self, inner: Triad, outer: Triad) -> [Option<Expr>; 2] {
        let [x, y, z] = [0, 1, 2].map(|k| self.placed_at_start(Place { body: inner.body, local: inner.axes[k] }));
        let [xo, _, zo] = [0, 1, 2].map(|k| self.placed_at_start(Place { body: outer.body, local: outer.axes[k] }));
        // The second axis is −y turned by the first angle: its components are sin α and −cos α.
        let (s, c) = (dot(self.arena, x, zo), dot(self.arena, y, zo));
        let c = self.arena.neg(c);
        let first = self.angle_of(s, c);
        let alpha = first.unwrap_or_else(|| self.arena.integer(0));
        let [xa, _, _] = self.about(alpha, [x, y, z]);
        let (s, c) = (dot(self.arena, z, xo), dot(self.arena, xa, xo));
        [first, self.angle_of(s, c)]
    }
}
