//! Colours, the same in every picture: each colour stands for a role of links. Shades of Okabe and Ito, which readers with any colour
//! vision can distinguish.

use plotters::style::{Color, RGBAColor, RGBColor, WHITE};

/// Role of a link, a trace or a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ink {
    /// Driven links: the crank, the motor's gear.
    Input,
    /// Transmitting links.
    Coupler,
    /// Output links.
    Output,
    /// A second output, or a second transmitting link.
    Second,
    /// The path of a point.
    Trace,
    /// Fixed parts.
    Ground,
    /// A hole in a fixed part.
    Hole,
}

impl Ink {
    /// Colour of lines.
    pub(super) fn line(self) -> RGBAColor {
        self.rgb().to_rgba()
    }

    /// Colour of surfaces, slightly translucent.
    pub(super) fn surface(self) -> RGBAColor {
        if self == Self::Hole {
            return WHITE.to_rgba();
        }
        let light = |part: u8| 255 - (255 - part) / 4;
        let RGBColor(red, green, blue) = self.rgb();
        RGBColor(light(red), light(green), light(blue)).mix(0.85)
    }

    /// Colour of lines of a faint phase.
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
