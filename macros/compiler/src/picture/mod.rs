//! Picture of the assembled mechanism for its documentation page.
//!
//! In: a [`Model`] with its sketch, the [`System`] and the [`Assembly`]. Out: a [`Picture`]: inline SVG, and a sentence on it.
//! Not done here: drawing, which the crate `reuleaux-picture` does. Without the feature `picture` nothing is drawn.

#[cfg(feature = "picture")]
mod pose;
#[cfg(feature = "picture")]
mod scene;

use crate::assembly::Assembly;
use crate::model::Model;
use crate::system::System;

/// A picture of the mechanism, or the reason why there is none.
#[derive(Clone, Debug, Default)]
pub struct Picture {
    #[cfg(feature = "picture")]
    drawn: Option<reuleaux_picture::Picture>,
    words: String,
}

impl Picture {
    /// Caption of the picture, or the reason why there is none.
    #[must_use]
    pub fn words(&self) -> &str {
        &self.words
    }

    /// Inline SVG without a blank line, if there is a picture.
    #[must_use]
    pub fn svg(&self) -> Option<&str> {
        #[cfg(feature = "picture")]
        return self.drawn.as_ref().map(reuleaux_picture::Picture::svg);
        #[cfg(not(feature = "picture"))]
        return None;
    }
}

#[cfg(feature = "picture")]
impl Picture {
    /// The picture with its labels, if there is one.
    #[must_use]
    pub fn drawn(&self) -> Option<&reuleaux_picture::Picture> {
        self.drawn.as_ref()
    }

    fn none(why: String) -> Picture {
        Picture { drawn: None, words: why }
    }
}

/// Without the feature `picture`: no picture and no caption.
#[cfg(not(feature = "picture"))]
pub(crate) fn draw(_: &Model, _: &System, _: &Assembly) -> Picture {
    Picture::default()
}

/// Draws the mechanism in its assembled configuration.
#[cfg(feature = "picture")]
pub(crate) fn draw(model: &Model, system: &System, assembly: &Assembly) -> Picture {
    use reuleaux_picture::Undrawable;
    let bodies = model.bodies.len();
    if bodies > crate::model::sketch::MOST_DRAWN {
        return Picture::none(Undrawable::Bodies(bodies).sentence());
    }
    if !assembly.is_closed {
        return Picture::none("There is no picture: no assembly was found at the declared defaults.".into());
    }
    let drawn = pose::pose(model, system, assembly).and_then(|(time, scene)| Ok((time, scene.draw()?)));
    match drawn {
        Ok((time, picture)) => Picture { words: words(time, picture.names_all()), drawn: Some(picture) },
        Err(Undrawable::Nowhere) => Picture::none("There is no picture: not every place is a number at the declared defaults.".into()),
        Err(undrawable) => Picture::none(undrawable.sentence()),
    }
}

#[cfg(feature = "picture")]
fn words(time: f64, names_all: bool) -> String {
    let mut words = if time == 0.0 {
        "Assembled at the declared defaults, at t = 0.".to_owned()
    } else {
        format!("At the declared defaults, at t = {} s: at t = 0 parts lie on each other.", rounded(time))
    };
    if !names_all {
        words += " The other names show where the pointer rests.";
    }
    words
}

/// Rounds to three significant digits.
#[cfg(feature = "picture")]
fn rounded(value: f64) -> f64 {
    format!("{value:.2e}").parse().unwrap_or(value)
}
