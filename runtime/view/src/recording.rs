//! The contents of a view, extracted from the states.

use reuleaux_picture::{Film, Scene, Vector};

use crate::template::Template;
use crate::unviewable::Unviewable;

/// Scenes and plotted quantities, with one entry for each state.
#[derive(Clone, Debug)]
pub(crate) struct Recording {
    pub(crate) title: String,
    pub(crate) scenes: Vec<Scene>,
    pub(crate) abscissa: Abscissa,
    pub(crate) lasting: Option<f64>,
    pub(crate) traces: Vec<Trace>,
    pub(crate) plots: Vec<Plot>,
}

/// The quantity that orders the states.
#[derive(Clone, Debug)]
pub(crate) struct Abscissa {
    pub(crate) name: String,
    pub(crate) unit: String,
    pub(crate) values: Vec<f64>,
    pub(crate) is_time: bool,
}

/// Path of a point in ground (m).
#[derive(Clone, Debug)]
pub(crate) struct Trace {
    pub(crate) name: String,
    pub(crate) places: Vec<Vector>,
}

/// Quantities of one unit, in one diagram.
#[derive(Clone, Debug)]
pub(crate) struct Plot {
    pub(crate) unit: String,
    pub(crate) series: Vec<Series>,
}

/// A quantity.
#[derive(Clone, Debug)]
pub(crate) struct Series {
    pub(crate) name: String,
    pub(crate) values: Vec<f64>,
    /// True for an independent result, which is drawn as separate points.
    pub(crate) is_dotted: bool,
}

/// Playing speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pace {
    /// Playing time at speed 1, in s.
    pub(crate) lasting: f64,
    /// Initial speed.
    pub(crate) speed: f64,
}

/// A drawn recording.
pub(crate) struct Drawn {
    pub(crate) film: Film,
    pub(crate) template: Template,
    /// For each trace its points, in picture units.
    pub(crate) traces: Vec<Vec<[f64; 2]>>,
}

/// Playing time (s) of states that are not ordered by time.
const USUAL: f64 = 5.0;

/// Least playing time at the initial speed, in s.
const SHORTEST: f64 = 2.0;

/// Largest playing time at the initial speed, in s.
const LONGEST: f64 = 30.0;

impl Recording {
    /// Draws all states.
    pub(crate) fn drawn(&self) -> Result<Drawn, Unviewable> {
        self.check()?;
        self.drawing()
    }

    /// Draws the states in any order.
    pub(crate) fn drawing(&self) -> Result<Drawn, Unviewable> {
        let places: Vec<Vector> = self.traces.iter().flat_map(|trace| trace.places.iter().copied()).collect();
        let film = Film::of(&self.scenes, &places)?;
        let template = Template::of(&film);
        let traces: Vec<Vec<[f64; 2]>> =
            self.traces.iter().map(|trace| trace.places.iter().map(|place| film.at(*place)).collect()).collect();
        for (trace, seen) in self.traces.iter().zip(&traces) {
            if let Some(state) = seen.iter().position(|place: &[f64; 2]| !place.iter().all(|part| part.is_finite())) {
                return Err(Unviewable::Trace { name: trace.name.clone(), state });
            }
        }
        Ok(Drawn { film, template, traces })
    }

    /// Checks that the abscissa is finite and strictly increasing.
    pub(crate) fn check(&self) -> Result<(), Unviewable> {
        let values = &self.abscissa.values;
        let before = [f64::NEG_INFINITY].into_iter().chain(values.iter().copied());
        match before.zip(values).position(|(before, now)| !(now.is_finite() && *now > before)) {
            Some(state) => Err(Unviewable::Abscissa { name: self.abscissa.name.clone(), state }),
            None => Ok(()),
        }
    }

    pub(crate) fn pace(&self) -> Pace {
        let span = self.abscissa.values.last().zip(self.abscissa.values.first()).map_or(0.0, |(last, first)| last - first);
        let usual = if self.abscissa.is_time && span > 0.0 { span } else { USUAL };
        match self.lasting {
            Some(lasting) if self.abscissa.is_time => Pace { lasting: usual, speed: usual / lasting },
            Some(lasting) => Pace { lasting, speed: 1.0 },
            None => Pace { lasting: usual, speed: speed(usual) },
        }
    }

    /// A copy with at most `most` states, evenly chosen, including the first and the last.
    pub(crate) fn thinned(&self, most: usize) -> Recording {
        let count = self.scenes.len();
        if count <= most || most < 2 {
            return self.clone();
        }
        let chosen: Vec<usize> = (0..most).map(|number| (number * (count - 1) + (most - 1) / 2) / (most - 1)).collect();
        self.chosen(&chosen)
    }

    /// A copy with these states, without plots.
    pub(crate) fn chosen(&self, chosen: &[usize]) -> Recording {
        Recording {
            title: self.title.clone(),
            scenes: pick(chosen, &self.scenes),
            abscissa: Abscissa { values: pick(chosen, &self.abscissa.values), ..self.abscissa.clone() },
            lasting: self.lasting,
            traces: self.traces.clone(),
            plots: Vec::new(),
        }
    }
}

fn pick<V: Clone>(chosen: &[usize], values: &[V]) -> Vec<V> {
    chosen.iter().filter_map(|index| values.get(*index).cloned()).collect()
}

/// Speed 1 if the playing time is acceptable; otherwise the nearest of 1, 2 and 5 times powers of ten that makes it so.
fn speed(lasting: f64) -> f64 {
    let series = |power: i32| [1.0, 2.0, 5.0].map(|step| step * 10_f64.powi(power));
    let mut upwards = (0..12).flat_map(series);
    let mut downwards = (-12..0).rev().flat_map(|power| series(power).into_iter().rev());
    if lasting > LONGEST {
        upwards.find(|speed| lasting / speed <= LONGEST).unwrap_or(1.0)
    } else if lasting < SHORTEST {
        downwards.find(|speed| lasting / speed >= SHORTEST).unwrap_or(1.0)
    } else {
        1.0
    }
}
