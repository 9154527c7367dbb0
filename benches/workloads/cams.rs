//! Slides that follow laws in pieces, of which a step computes one; one turn a second.

use reuleaux::mechanism;

use super::Make;
use crate::contender::{Contender, Generated};

mechanism! {
    /// Two rises and two falls.
    pub mechanism Program {
        body slide { point tip = (0m, 0.1m); }
        joint guide = translational((0, 1), (0m, 0m), slide.tip);
        drive law = drive_y(slide.tip, segments(1turn * t / 1s, 0mm, [
            rise(20mm, 90deg, modified_sine), dwell(45deg), fall(12mm, 100deg, modified_sine),
            rise(6mm, 40deg, modified_sine), fall(14mm, 60deg, modified_sine), dwell(25deg),
        ], periodic));
        output tip = slide.tip;
    }
}

mechanism! {
    /// A design by its points.
    pub mechanism Points {
        body slide { point tip = (0m, 0.1m); }
        joint guide = translational((0, 1), (0m, 0m), slide.tip);
        drive law = drive_y(slide.tip, spline(1turn * t / 1s, [
            (0deg, 0mm), (30deg, 5mm), (60deg, 14mm), (90deg, 20mm), (120deg, 24mm), (150deg, 26mm), (180deg, 24mm),
            (220deg, 18mm), (260deg, 10mm), (300deg, 4mm), (330deg, 1mm), (360deg, 0mm),
        ], periodic));
        output tip = slide.tip;
    }
}

fn program() -> Box<dyn Contender> {
    Box::new(Generated::new(Program::default(), |program, state: &_| program.tip(&ProgramState(Clone::clone(state)))))
}

fn points() -> Box<dyn Contender> {
    Box::new(Generated::new(Points::default(), |points, state: &_| points.tip(&PointsState(Clone::clone(state)))))
}

/// Their names and the generated ones; there are no others beside them.
#[must_use]
pub fn cams() -> [(&'static str, Make); 2] {
    [("program of four modified sines", program), ("spline through twelve points", points)]
}
