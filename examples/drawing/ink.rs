//! Colours, the same in every picture: a colour says what a link does. Shades of Okabe and Ito, who chose them so that
//! readers with any colour vision can tell them apart.

use plotters::style::{Color, RGBAColor, RGBColor, WHITE};

/// The part that a link, a trace or a curve plays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ink {
    /// What is driven: the crank, the motor's gear.
    Input,
    /// What transmits.
    Coupler,
    /// What the mechanism is for.
    Output,
    /// A second output, or a second link between.
    Second,
    /// The path of a point.
    Trace,
    /// What does not move.
    Ground,
    /// A hole in what does not move.
    Hole,
}

impl Ink {
    /// Of lines.
    pub(super) fn line(self) -> RGBAColor {
        self.rgb().to_rgba()
    }

    /// Of surfaces; what lies below shows a little.
    pub(super) fn surface(self) -> RGBAColor {
        if self == Self::Hole {
            return WHITE.to_rgba();
        }
        let light = |part: u8| 255 - (255 - part) / 4;
        let RGBColor(red, green, blue) = self.rgb();
        RGBColor(light(red), light(green), light(blue)).mix(0.85)
    }

    /// Of lines of a phase that is only hinted at.
    pub(super) fn faint(self) -> RGBAColor {
        self.rgb().mix(0.4)
    }

    fn rgb(self) -> RGBColor {
        match self {
            Self::Input => RGBColor(213, 94, 0),
            Self::Coupler => RGBColor(0, 114, 178),
            Self::Output => RGBColor(0, 140, 102),
            Self::Second => RGBColor(190, 130, 0),
            Self::Trace => RGBColor(170, 51, 119),
            Self::Ground | Self::Hole => RGBColor(70, 70, 70),
        }
    }
}
