//! The mechanism at a few phases, drawn with equal scales.

use std::f64::consts::PI;

use plotters::element::{Circle, PathElement, Polygon, Text};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, FontStyle, IntoFont, RGBAColor, ShapeStyle, TextStyle, WHITE};

use super::outline::{hatching, rounded_hull};
use super::{Area, Fallible, Ink, Place, fine, place, polar, stroke};

/// Half the width of a link, in units of the picture.
const LINK: f64 = 6.0;
/// The radius of a pin.
const PIN: f64 = 3.2;
/// Margin around the mechanism, for pivots and names.
const MARGIN: f64 = 34.0;
/// The distance of hatching lines.
const HATCHING: f64 = 6.0;

/// A mechanism in shapes, in m. Later shapes cover earlier ones.
#[derive(Clone, Debug, Default)]
pub struct Scene {
    marks: Vec<Mark>,
    is_faint: bool,
}

#[derive(Clone, Debug)]
struct Mark {
    shape: Shape,
    ink: Ink,
    is_faint: bool,
}

#[derive(Clone, Debug)]
enum Shape {
    Link(Vec<Place>),
    Surface(Vec<Place>),
    Line(Vec<Place>),
    Dashes(Vec<Place>),
    Disc(Place, f64),
    Pin(Place),
    Pivot(Place, f64),
    Wall(Place, Place),
    Name(Place, String, [f64; 2]),
}

impl Scene {
    /// An empty scene.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Draws a further phase faintly, as thin lines.
    pub fn faint(&mut self, draw: impl FnOnce(&mut Self)) {
        self.is_faint = true;
        draw(self);
        self.is_faint = false;
    }

    /// A rigid link through these points, with round ends.
    pub fn link(&mut self, ink: Ink, points: &[Place]) -> &mut Self {
        self.add(ink, Shape::Link(points.to_vec()))
    }

    /// A closed outline.
    pub fn surface(&mut self, ink: Ink, points: impl IntoIterator<Item = Place>) -> &mut Self {
        self.add(ink, Shape::Surface(points.into_iter().collect()))
    }

    /// A line through these points: the path of a point, a massless rod.
    pub fn line(&mut self, ink: Ink, points: impl IntoIterator<Item = Place>) -> &mut Self {
        self.add(ink, Shape::Line(points.into_iter().collect()))
    }

    /// A dashed straight line: an axis, a construction.
    pub fn dashes(&mut self, ink: Ink, from: Place, to: Place) -> &mut Self {
        self.add(ink, Shape::Dashes(vec![from, to]))
    }

    /// A filled circle of this radius (m).
    pub fn disc(&mut self, ink: Ink, centre: Place, radius: f64) -> &mut Self {
        self.add(ink, Shape::Disc(centre, radius))
    }

    /// A pin between two links.
    pub fn pin(&mut self, at: Place) -> &mut Self {
        self.add(Ink::Ground, Shape::Pin(at))
    }

    /// A pin on a hatched support that stands below it.
    pub fn pivot(&mut self, at: Place) -> &mut Self {
        self.pivot_towards(at, -PI / 2.0)
    }

    /// A pin on a hatched support that stands in the direction `down` (rad) of it.
    pub fn pivot_towards(&mut self, at: Place, down: f64) -> &mut Self {
        self.add(Ink::Ground, Shape::Pivot(at, down))
    }

    /// A wall, hatched on the right-hand side of the way from `from` to `to`.
    pub fn wall(&mut self, from: Place, to: Place) -> &mut Self {
        self.add(Ink::Ground, Shape::Wall(from, to))
    }

    /// The name of a point, beside it by `aside` units of the picture (to the right, up).
    pub fn name(&mut self, at: Place, name: &str, aside: [f64; 2]) -> &mut Self {
        self.add(Ink::Ground, Shape::Name(at, name.to_owned(), aside))
    }

    fn add(&mut self, ink: Ink, shape: Shape) -> &mut Self {
        self.marks.push(Mark { shape, ink, is_faint: self.is_faint });
        self
    }

    /// Lower left and upper right corner of all shapes.
    fn bounds(&self) -> [Place; 2] {
        let around = |centre: &Place, radius: f64| [centre - place(radius, radius), centre + place(radius, radius)];
        let corners = self.marks.iter().flat_map(|mark| match &mark.shape {
            Shape::Link(points) | Shape::Surface(points) | Shape::Line(points) | Shape::Dashes(points) => points.clone(),
            Shape::Disc(centre, radius) => around(centre, *radius).to_vec(),
            Shape::Pin(at) | Shape::Pivot(at, _) | Shape::Name(at, ..) => vec![*at],
            Shape::Wall(from, to) => vec![*from, *to],
        });
        let endless = place(f64::INFINITY, f64::INFINITY);
        corners.fold([endless, -endless], |[low, high], corner| [low.inf(&corner), high.sup(&corner)])
    }

    /// The scale (picture units per m) at which the scene fits, and its height.
    pub(super) fn fit(&self, width: f64, height: f64) -> (f64, f64) {
        let [low, high] = self.bounds();
        let (size, room) = (high - low, place(width - 2.0 * MARGIN, height - 2.0 * MARGIN));
        let scale = (room.x / size.x).min(room.y / size.y);
        (scale, size.y * scale + 2.0 * MARGIN)
    }

    pub(super) fn draw(&self, area: &Area, width: f64, height: f64) -> Fallible {
        let [low, high] = self.bounds();
        let pen = Pen { area, scale: self.fit(width, height).0, centre: (low + high) / 2.0, middle: place(width, height) / 2.0 };
        self.marks.iter().try_for_each(|mark| pen.draw(mark))?;
        pen.scale_bar(height)
    }
}

/// A pen over an area, which converts m to drawing units.
struct Pen<'a, 'b> {
    area: &'a Area<'b>,
    scale: f64,
    centre: Place,
    middle: Place,
}

impl Pen<'_, '_> {
    /// The place in drawing units, y downwards.
    fn at(&self, at: Place) -> (i32, i32) {
        let offset = (at - self.centre) * self.scale;
        (fine(self.middle.x + offset.x), fine(self.middle.y - offset.y))
    }

    fn all(&self, points: &[Place]) -> Vec<(i32, i32)> {
        let mut all: Vec<_> = points.iter().map(|&point| self.at(point)).collect();
        all.dedup();
        all
    }

    /// A length in m that is `units` long in the picture.
    fn metres(&self, units: f64) -> f64 {
        units / self.scale
    }

    fn draw(&self, Mark { shape, ink, is_faint }: &Mark) -> Fallible {
        let line = if *is_faint { ink.faint() } else { ink.line() };
        match shape {
            Shape::Link(points) if *is_faint && points.len() == 2 => self.line(points, line, 1.3),
            Shape::Link(points) if *is_faint => self.surface(&rounded_hull(points, 0.0), None, line, 1.3),
            Shape::Link(points) => self.surface(&rounded_hull(points, self.metres(LINK)), Some(ink.surface()), line, 1.3),
            Shape::Surface(points) if *is_faint => self.surface(points, None, line, 1.0),
            Shape::Surface(points) => self.surface(points, Some(ink.surface()), line, 1.3),
            Shape::Line(points) => self.line(points, line, 1.5),
            Shape::Dashes(points) => self.dashes(points, line),
            Shape::Disc(centre, radius) => self.circle(*centre, *radius, (!is_faint).then(|| ink.surface()), line),
            Shape::Pin(at) if *is_faint => self.circle(*at, self.metres(1.8), Some(line), line),
            Shape::Pin(at) => self.circle(*at, self.metres(PIN), Some(WHITE.to_rgba()), line),
            Shape::Pivot(at, down) => self.pivot(*at, *down),
            Shape::Wall(from, to) => self.wall(*from, *to),
            Shape::Name(at, name, aside) => self.name(*at + Place::from(*aside) / self.scale, name),
        }
    }

    fn line(&self, points: &[Place], colour: RGBAColor, width: f64) -> Fallible {
        Ok(self.area.draw(&PathElement::new(self.all(points), colour.stroke_width(stroke(width))))?)
    }

    fn surface(&self, points: &[Place], fill: Option<RGBAColor>, colour: RGBAColor, width: f64) -> Fallible {
        let mut corners = self.all(points);
        if let Some(fill) = fill {
            self.area.draw(&Polygon::new(corners.clone(), fill))?;
        }
        corners.extend(corners.iter().copied().take(2).collect::<Vec<_>>());
        Ok(self.area.draw(&PathElement::new(corners, colour.stroke_width(stroke(width))))?)
    }

    fn dashes(&self, points: &[Place], colour: RGBAColor) -> Fallible {
        let [from, to] = [points[0], points[1]];
        let count = ((to - from).norm() * self.scale / 9.0).ceil();
        (0..count as usize).try_for_each(|k| {
            let along = |part: f64| from + (to - from) * (part / count).min(1.0);
            self.line(&[along(k as f64), along(k as f64 + 0.6)], colour, 0.8)
        })
    }

    fn circle(&self, centre: Place, radius: f64, fill: Option<RGBAColor>, colour: RGBAColor) -> Fallible {
        let radius = fine(radius * self.scale);
        if let Some(fill) = fill {
            self.area.draw(&Circle::new(self.at(centre), radius, fill.filled()))?;
        }
        Ok(self.area.draw(&Circle::new(self.at(centre), radius, ShapeStyle::from(colour).stroke_width(stroke(1.3))))?)
    }

    fn pivot(&self, at: Place, down: f64) -> Fallible {
        let foot = at + polar(self.metres(13.0), down);
        let (side, wide) = (polar(self.metres(8.0), down + PI / 2.0), polar(self.metres(13.0), down + PI / 2.0));
        self.surface(&[at, foot - side, foot + side], Some(WHITE.to_rgba()), Ink::Ground.line(), 1.2)?;
        self.wall(foot - wide, foot + wide)?;
        self.circle(at, self.metres(PIN), Some(WHITE.to_rgba()), Ink::Ground.line())
    }

    fn wall(&self, from: Place, to: Place) -> Fallible {
        self.line(&[from, to], Ink::Ground.line(), 1.4)?;
        hatching(from, to, self.metres(HATCHING)).iter().try_for_each(|hatch| self.line(hatch, Ink::Ground.line(), 0.8))
    }

    fn name(&self, at: Place, name: &str) -> Fallible {
        let style =
            TextStyle::from(("sans-serif", fine(15.0)).into_font().style(FontStyle::Italic)).pos(Pos::new(HPos::Center, VPos::Center));
        Ok(self.area.draw(&Text::new(name.to_owned(), self.at(at), style))?)
    }

    /// A bar of a round length in the lower left corner.
    fn scale_bar(&self, height: f64) -> Fallible {
        let length = super::diagram::round_number(self.metres(90.0));
        let name = if length < 0.9 { format!("{:.0} mm", length * 1e3) } else { format!("{length:.0} m") };
        let (left, base) = (fine(4.0), fine(height - 6.0));
        let right = left + fine(length * self.scale);
        let bar = vec![(left, base - fine(4.0)), (left, base), (right, base), (right, base - fine(4.0))];
        self.area.draw(&PathElement::new(bar, Ink::Ground.line().stroke_width(stroke(1.0))))?;
        let style = TextStyle::from(("sans-serif", fine(13.0)).into_font()).pos(Pos::new(HPos::Center, VPos::Bottom));
        Ok(self.area.draw(&Text::new(name, ((left + right) / 2, base - fine(3.0)), style))?)
    }
}
