//! One picture of the gallery.

use std::error::Error;
use std::path::{Path, PathBuf};

use plotters::backend::SVGBackend;
use plotters::drawing::IntoDrawingArea;
use plotters::element::Text;
use plotters::style::{FontStyle, IntoFont, TextStyle, WHITE};

use super::diagram::BELOW;
use super::{Abscissa, Diagram, FINE, Fallible, Scene, fine};

/// Width of a picture.
const WIDTH: f64 = 720.0;
/// Margin around the picture.
const BORDER: f64 = 14.0;
/// Height of the title.
const TITLE: f64 = 26.0;
/// Largest height of a scene.
const SCENE: f64 = 380.0;
/// Height of a diagram, without the numbers below the last one.
const DIAGRAM: f64 = 150.0;

/// A mechanism and its diagrams on one page.
#[derive(Clone, Debug)]
pub struct Plate {
    title: &'static str,
    scene: Scene,
    over: Abscissa,
    diagrams: Vec<Diagram>,
}

impl Plate {
    /// A picture of this scene, with diagrams over `over`.
    #[must_use]
    pub fn new(title: &'static str, scene: Scene, over: Abscissa) -> Self {
        Self { title, scene, over, diagrams: Vec::new() }
    }

    /// Adds a diagram below the others.
    #[must_use]
    pub fn diagram(mut self, diagram: Diagram) -> Self {
        self.diagrams.push(diagram);
        self
    }

    /// Writes `examples/gallery/<name>.svg` and returns its path.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn save(&self, name: &str) -> Result<PathBuf, Box<dyn Error>> {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("gallery").join(name).with_extension("svg");
        std::fs::write(&path, self.svg()?)?;
        Ok(path)
    }

    fn svg(&self) -> Result<String, Box<dyn Error>> {
        let inner = WIDTH - 2.0 * BORDER;
        let scene = self.scene.fit(inner, SCENE).1;
        let height = 2.0 * BORDER + TITLE + scene + 10.0 + DIAGRAM * self.diagrams.len() as f64 + BELOW;
        let (wide, high) = (fine(WIDTH), fine(height));
        let mut svg = String::new();
        self.draw(SVGBackend::with_string(&mut svg, (wide.unsigned_abs(), high.unsigned_abs())), scene)?;
        let size = |wide: i32, high: i32| format!("width=\"{wide}\" height=\"{high}\"");
        Ok(svg.replacen(&size(wide, high), &size(wide / FINE, high / FINE), 1))
    }

    fn draw(&self, page: SVGBackend, scene: f64) -> Fallible {
        let page = page.into_drawing_area();
        page.fill(&WHITE)?;
        let page = page.margin(fine(BORDER), fine(BORDER), fine(BORDER), fine(BORDER));
        let style = TextStyle::from(("sans-serif", fine(18.0)).into_font().style(FontStyle::Bold));
        page.draw(&Text::new(self.title, (0, 0), style))?;
        let (upper, mut rest) = page.split_vertically(fine(TITLE + scene + 10.0));
        self.scene.draw(&upper.margin(fine(TITLE), 0, 0, 0), WIDTH - 2.0 * BORDER, scene)?;
        for (index, diagram) in self.diagrams.iter().enumerate() {
            let is_last = index + 1 == self.diagrams.len();
            let (own, below) = rest.split_vertically(fine(DIAGRAM + if is_last { BELOW } else { 0.0 }));
            diagram.draw(&own, &self.over, is_last)?;
            rest = below;
        }
        page.present()?;
        Ok(())
    }
}
