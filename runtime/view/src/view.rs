//! The interface of the crate: states in, files out.

use std::fs;
use std::path::Path;

use reuleaux_picture::{Scene, Vector};

use crate::point::Point;
use crate::recording::{Abscissa, Plot, Recording, Series, Trace};
use crate::unviewable::Unviewable;
use crate::{animation, page, still};

/// A motion to be shown: states, traced points and plotted quantities.
///
/// `S` is a state. Mechanisms of `reuleaux` that are declared with `#[picture]` make a view by `mechanism.view(states)`.
#[derive(Clone, Debug)]
pub struct View<S> {
    states: Vec<S>,
    pub(crate) recording: Recording,
}

impl<S> View<S> {
    /// States in the order of their times (s), with a scene for each.
    #[must_use]
    pub fn new(title: &str, states: impl IntoIterator<Item = S>, time: impl Fn(&S) -> f64, scene: impl Fn(&S) -> Scene) -> View<S> {
        let states: Vec<S> = states.into_iter().collect();
        let abscissa = Abscissa { name: "t".into(), unit: "s".into(), values: states.iter().map(time).collect(), is_time: true };
        let scenes = states.iter().map(scene).collect();
        let recording = Recording { title: title.to_owned(), scenes, abscissa, lasting: None, traces: Vec::new(), plots: Vec::new() };
        View { states, recording }
    }

    /// Changes the title.
    #[must_use]
    pub fn title(mut self, title: &str) -> View<S> {
        title.clone_into(&mut self.recording.title);
        self
    }

    /// Draws the path of a point in ground (m), with two coordinates in the plane and three in space.
    #[must_use]
    pub fn trace<P: Point>(mut self, name: &str, of: impl Fn(&S) -> P) -> View<S> {
        let places: Vec<Vector> = self.states.iter().map(|state| of(state).coordinates()).collect();
        self.recording.traces.push(Trace { name: name.to_owned(), places });
        self
    }

    /// Gives a body a shape in all states: the corners of a polygon in its frame (m), drawn in its colour below links and hinges.
    ///
    /// A cam that is defined by an equation, a bucket, the slots of a Geneva wheel; `reuleaux::picture::GROUND` is a body as well.
    #[must_use]
    pub fn outline<P: Point>(mut self, body: &str, corners: impl IntoIterator<Item = P>) -> View<S> {
        let corners: Vec<Vector> = corners.into_iter().map(|corner| corner.coordinates()).collect();
        self.recording.scenes.iter_mut().for_each(|scene| scene.outline(body, corners.iter().copied()));
        self
    }

    /// Draws a mechanism in space from a direction of your own: a vector from the mechanism towards the eye, in ground. `[0.0, -1.0, 0.0]` is the front
    /// view, `[0.0, 0.0, 1.0]` the view from above, `[1.0, -1.0, 1.0]` is isometric. Its length does not matter.
    ///
    /// z points upwards; in the view from above y does, and x to the right. Without this call a direction is chosen from which joints overlap as
    /// little as possible. A mechanism in the plane is not affected. With a vector that is zero or not finite there is no drawing: the functions that
    /// make one return the reason.
    #[must_use]
    pub fn seen_from(mut self, direction: [f64; 3]) -> View<S> {
        self.recording.scenes.iter_mut().for_each(|scene| scene.seen_from(direction));
        self
    }

    /// Plots a quantity in a diagram of its own. The curve has gaps where the quantity is not finite.
    #[must_use]
    pub fn plot<V: Into<f64>>(mut self, name: &str, unit: &str, of: impl Fn(&S) -> V) -> View<S> {
        let series = vec![self.series(name, of)];
        self.recording.plots.push(Plot { unit: unit.to_owned(), series });
        self
    }

    /// Plots a quantity of the same unit in the last diagram; if there is none, in a new diagram without a unit.
    #[must_use]
    pub fn and<V: Into<f64>>(self, name: &str, of: impl Fn(&S) -> V) -> View<S> {
        let series = self.series(name, of);
        self.with(series)
    }

    /// Plots an independent result for the curve before, in the same diagram: as circles that are not connected, at so few states that they
    /// stay apart. Values that are not finite have no circle.
    #[must_use]
    pub fn against<V: Into<f64>>(self, name: &str, of: impl Fn(&S) -> V) -> View<S> {
        let series = Series { is_dotted: true, ..self.series(name, of) };
        self.with(series)
    }

    /// Adds a quantity to the last diagram.
    fn with(mut self, series: Series) -> View<S> {
        match self.recording.plots.last_mut() {
            Some(plot) => plot.series.push(series),
            None => self.recording.plots.push(Plot { unit: String::new(), series: vec![series] }),
        }
        self
    }

    /// Orders states by a quantity other than time, which must increase from state to state: it is the abscissa of diagrams and advances
    /// uniformly while the motion plays.
    #[must_use]
    pub fn over<V: Into<f64>>(mut self, name: &str, unit: &str, of: impl Fn(&S) -> V) -> View<S> {
        let values = self.values(of);
        self.recording.abscissa = Abscissa { name: name.to_owned(), unit: unit.to_owned(), values, is_time: false };
        self
    }

    /// Sets the initial playing time of all states (s). Without it the motion plays in real time, or slowed down or sped up by a round
    /// factor so that it takes between 2 s and 30 s.
    #[must_use]
    pub fn lasting(mut self, seconds: f64) -> View<S> {
        self.recording.lasting = (seconds.is_finite() && seconds > 0.0).then_some(seconds);
        self
    }

    /// One self-contained HTML page with the animated drawing and the plots. The same bytes on every run.
    ///
    /// # Errors
    /// The reason why the states cannot be shown.
    pub fn to_html(&self) -> Result<String, Unviewable> {
        page::html(&self.recording)
    }

    /// Writes [`to_html`](Self::to_html) to a file.
    ///
    /// # Errors
    /// The reason why the states cannot be shown or the file cannot be written.
    pub fn write(&self, path: impl AsRef<Path>) -> Result<(), Unviewable> {
        Ok(fs::write(path, self.to_html()?)?)
    }

    /// The drawing as one animated SVG that repeats, without scripts, so that it also plays in a README.
    ///
    /// More than 61 states are thinned out to 61, and shapes move linearly between them. Readers who prefer reduced motion, and programs
    /// that do not animate SVG, see the first state.
    ///
    /// # Errors
    /// The reason why the states cannot be shown.
    pub fn animated_svg(&self) -> Result<String, Unviewable> {
        animation::animated_svg(&self.recording, usize::MAX)
    }

    /// The same in a file of at most `size` bytes if possible: states are thinned out further until it fits, down to 13.
    ///
    /// # Errors
    /// The reason why the states cannot be shown.
    pub fn animated_svg_within(&self, size: usize) -> Result<String, Unviewable> {
        animation::animated_svg(&self.recording, size)
    }

    /// The drawing of one state, with the traces, above the bodies of other states, which are pale: the plate of a textbook.
    ///
    /// States are counted from 0. A number without a state stands for the last one.
    ///
    /// # Errors
    /// The reason why the states cannot be shown.
    pub fn still(&self, state: usize, others: &[usize]) -> Result<String, Unviewable> {
        let few = self.few(state, others);
        Ok(still::phases(&few, &few.drawing()?, others.len()))
    }

    /// A figure for print, 540 picture units wide, on white and without scripts: [`still`](Self::still), and below it the diagrams of the
    /// page, with axes, numbers and names. The same bytes on every run.
    ///
    /// Axes have numbers at multiples of 1, 2 or 5 times a power of ten, axes in ° from 10° on at multiples of 10, 15, 30, 45, 60, 90, …;
    /// with large and small numbers, the unit has a power of ten.
    ///
    /// # Errors
    /// The reason why the states cannot be shown: `figure` has the same as [`to_html`](Self::to_html).
    #[cfg(feature = "figure")]
    pub fn figure(&self, state: usize, others: &[usize]) -> Result<String, Unviewable> {
        self.recording.check()?;
        let few = self.few(state, others);
        crate::figure::svg(&self.recording, &few, &few.drawing()?)
    }

    /// A state and, after it, others. A number without a state stands for the last one.
    fn few(&self, state: usize, others: &[usize]) -> Recording {
        let last = self.states.len().saturating_sub(1);
        let chosen: Vec<usize> = [state].iter().chain(others).map(|state| *state.min(&last)).collect();
        self.recording.chosen(&chosen)
    }

    /// Gives all states a spring between two points, each with its body and its position in the frame of the body (m).
    #[must_use]
    pub fn spring<P: Point>(self, name: &str, from: (&str, P), to: (&str, P)) -> View<S> {
        self.between(name, "spring", from, to)
    }

    /// Gives all states a damper between two points, each with its body and its position in the frame of the body (m).
    #[must_use]
    pub fn damper<P: Point>(self, name: &str, from: (&str, P), to: (&str, P)) -> View<S> {
        self.between(name, "damper", from, to)
    }

    fn between<P: Point>(mut self, name: &str, kind: &str, from: (&str, P), to: (&str, P)) -> View<S> {
        let [p, q] = [from.1, to.1].map(|at| at.coordinates());
        for scene in &mut self.recording.scenes {
            scene.joint(name, kind).of(&[from.0, to.0]).point("P", from.0, p).point("Q", to.0, q);
        }
        self
    }

    /// Writes the drawing of every state into a folder, which is created if necessary: `0000.svg`, `0001.svg`, …, all of one size.
    ///
    /// # Errors
    /// The reason why the states cannot be shown or a file cannot be written.
    pub fn svg_frames(&self, folder: impl AsRef<Path>) -> Result<(), Unviewable> {
        let names = still::Names::new(folder.as_ref(), self.states.len(), "svg")?;
        let drawn = self.recording.drawn()?;
        for frame in 0..self.states.len() {
            fs::write(names.of(frame), still::svg(&self.recording, &drawn, frame))?;
        }
        Ok(())
    }

    /// Writes the drawing of every state into a folder, which is created if necessary: `0000.png`, `0001.png`, …, all `width` pixels
    /// wide. Labels use a font of this machine.
    ///
    /// # Errors
    /// The reason why the states cannot be shown or a file cannot be written.
    #[cfg(feature = "png")]
    pub fn png_frames(&self, folder: impl AsRef<Path>, width: u32) -> Result<(), Unviewable> {
        let names = still::Names::new(folder.as_ref(), self.states.len(), "png")?;
        let drawn = self.recording.drawn()?;
        let painter = crate::pixels::Painter::new()?;
        for frame in 0..self.states.len() {
            fs::write(names.of(frame), painter.png(&still::svg(&self.recording, &drawn, frame), width)?)?;
        }
        Ok(())
    }

    fn series<V: Into<f64>>(&self, name: &str, of: impl Fn(&S) -> V) -> Series {
        Series { name: name.to_owned(), values: self.values(of), is_dotted: false }
    }

    fn values<V: Into<f64>>(&self, of: impl Fn(&S) -> V) -> Vec<f64> {
        self.states.iter().map(|state| of(state).into()).collect()
    }
}
