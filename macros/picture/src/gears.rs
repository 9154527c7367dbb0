//! Drawings of wheels, racks and belts.

use crate::canvas::{Canvas, Ink, Layer, Near, Stroke, Subject};
use crate::drawing::Drawing;
use crate::habits::Guide;
use crate::plane::{Place, polar};
use crate::teeth::{self, FINEST, Teeth};
use crate::wheels::{Rack, Wheel, Wheels};

/// Width of the rim that an internal gear has outside its pitch circle.
pub(crate) const RIM: f64 = 9.0;

impl Drawing<'_> {
    /// Draws all wheels, racks and belts.
    pub(crate) fn wheels(&mut self, wheels: &Wheels) {
        let mut sorted: Vec<&Wheel> = wheels.wheels.iter().collect();
        sorted.sort_by(|a, b| b.radius.total_cmp(&a.radius));
        for wheel in sorted {
            self.wheel(wheel);
        }
        for (joint, contact) in &wheels.meshes {
            let (at, title, name) = (self.view.at(*contact), self.title(*joint), self.scene.joints[*joint].name.clone());
            self.canvas.circle(Layer::Pin, Ink::Solid, &title, at, 1.8);
            self.canvas.wish(Subject::Joint, &name, Near::Point(at, 5.0));
        }
        for (joint, rack) in &wheels.racks {
            self.rack(*joint, rack);
        }
        for (joint, spans) in &wheels.belts {
            let (title, name) = (self.title(*joint), self.scene.joints[*joint].name.clone());
            let spans = spans.map(|(a, b)| (self.view.at(a), self.view.at(b)));
            for (a, b) in spans {
                self.canvas.line(Layer::Rod, Ink::Line, &title, &[a, b]);
            }
            self.canvas.wish(Subject::Joint, &name, Near::Segments(spans.to_vec()));
        }
    }

    fn wheel(&mut self, wheel: &Wheel) {
        let (at, radius) = (self.view.at(wheel.middle), self.view.length(wheel.radius));
        let number = wheel.body.unwrap_or(usize::MAX);
        let name = self.scene.name(wheel.body).to_owned();
        let turned = wheel.body.map_or(0.0, |body| self.scene.bodies[body].angle);
        if let Some(Teeth { count, angle }) = wheel.teeth.filter(|teeth| 2.0 * radius / teeth.count > FINEST) {
            // Rounded, so that rounding errors do not change the outline from frame to frame.
            let radius = (radius * 1e6).round() / 1e6;
            let outline = teeth::outline(count, radius, wheel.is_ring);
            let rim = wheel.is_ring.then(|| teeth::rim(radius + RIM + 2.4 * radius / count));
            let outlines = rim.into_iter().chain([outline]).collect();
            self.canvas.draw(Layer::Wheel, Ink::Wheel(number), &name, Stroke::Rigid(outlines, at, -(turned + angle)));
        } else if wheel.is_ring {
            self.canvas.circle(Layer::Wheel, Ink::Of(number), &name, at, radius);
            self.canvas.circle(Layer::Wheel, Ink::Of(number), &name, at, radius + RIM);
        } else {
            self.canvas.circle(Layer::Wheel, Ink::Wheel(number), &name, at, radius);
        }
        let Some(body) = wheel.body else { return };
        if !wheel.is_ring {
            // A spoke shows the angle of the wheel.
            let angle = self.scene.bodies[body].angle;
            let rim = at + self.view.along(polar(1.0, angle)) * radius;
            self.canvas.line(Layer::Wheel, Ink::Of(body), &name, &[at, rim]);
        }
        // If the body also has a bar, its name stands beside the bar.
        if !std::mem::replace(&mut self.links[body].is_shown, true) && !self.links[body].has_extent() {
            let near = if wheel.is_ring { Near::Point(at, radius + RIM + 3.0) } else { Near::Rim(at, radius) };
            self.canvas.wish(Subject::Body, &name, near);
        }
    }

    /// Draws a rack: a bar with teeth towards its pinion, and its guide or support.
    fn rack(&mut self, joint: usize, rack: &Rack) {
        let (title, name) = (self.title(joint), self.scene.joints[joint].name.clone());
        let (contact, held) = (self.view.at(rack.contact), self.view.at(rack.held));
        let (along, toward, reach) = (self.view.along(rack.along), self.view.along(rack.toward), self.view.length(rack.reach));
        let number = rack.body.unwrap_or(usize::MAX);
        let (middle, reach) = self.bar(joint, (contact - held).dot(along), reach, self.view.length(rack.overhang));
        let back = contact - toward * 6.5;
        let bar = [back + along * (middle - reach), back + along * (middle + reach)];
        self.canvas.line(Layer::DrawnBody, Ink::Bar(number), self.scene.name(rack.body), &bar);
        let beside = back + along * (held - back).dot(along);
        if rack.body.is_some() && (held - beside).norm() > 4.0 {
            self.canvas.line(Layer::DrawnBody, Ink::Bar(number), self.scene.name(rack.body), &[held, beside]);
        }
        let teeth = (reach / 4.0).floor().max(2.0) as i32;
        let tooth = |number: i32| {
            contact + along * (middle + f64::from(number) * reach / f64::from(teeth)) + toward * if number % 2 == 0 { 3.0 } else { -3.0 }
        };
        let teeth: Vec<Place> = (-teeth..=teeth).map(tooth).collect();
        self.canvas.line(Layer::Rod, Ink::Thin, &title, &teeth);
        self.canvas.wish(Subject::Joint, &name, Near::Point(contact, 7.0));
        if let Some(body) = rack.body {
            self.links[body].is_shown = true;
            let name = self.scene.bodies[body].name.clone();
            self.canvas.wish(Subject::Body, &name, Near::Segments(vec![(bar[0], bar[1])]));
        }
    }

    /// Offset of the centre of a rack from the contact, along the rack, and half its length; in a motion the bar contains every contact.
    fn bar(&mut self, joint: usize, contact: f64, reach: f64, overhang: f64) -> (f64, f64) {
        let own = Guide::new(contact, 0.0);
        self.habits.slide(joint, own);
        match self.known.guide(joint) {
            Some(Guide { low, high, .. }) if low < high => ((low + high) / 2.0 - contact, (high - low) / 2.0 + overhang),
            _ => (0.0, reach),
        }
    }
}

impl Canvas {
    /// A thin arrow head with its tip at `tip`, pointing along `way`.
    pub(crate) fn head(&mut self, title: &str, tip: Place, way: Place) {
        let (back, side) = (tip - way * 8.0, way.perp() * 3.2);
        self.area(Layer::Arrow, Ink::Solid, title, &[tip, back + side, back - side]);
    }
}
