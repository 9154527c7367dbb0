//! Dimensions: products of powers of length, angle, time and mass.

use std::fmt;

/// Exponents are kept in sixths, so that square and cube roots stay exact.
const WHOLE: i16 = 6;

/// A product of powers of length (m), angle (rad), time (s) and mass (kg).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub struct Dim {
    /// Exponents of metre, radian, second and kilogram, in sixths.
    sixths: [i16; 4],
}

/// Named dimensions, with their exponents of m, rad, s, kg.
const NAMED: &[(&str, [i16; 4])] = &[
    ("Number", [0, 0, 0, 0]),
    ("Length", [1, 0, 0, 0]),
    ("Angle", [0, 1, 0, 0]),
    ("Time", [0, 0, 1, 0]),
    ("Mass", [0, 0, 0, 1]),
    ("Area", [2, 0, 0, 0]),
    ("Velocity", [1, 0, -1, 0]),
    ("Acceleration", [1, 0, -2, 0]),
    ("AngularVelocity", [0, 1, -1, 0]),
    ("AngularAcceleration", [0, 1, -2, 0]),
    ("Frequency", [0, 0, -1, 0]),
    ("Force", [1, 0, -2, 1]),
    ("Torque", [2, 0, -2, 1]),
    ("Inertia", [2, 0, 0, 1]),
    ("Stiffness", [0, 0, -2, 1]),
    ("Damping", [0, 0, -1, 1]),
    ("Pressure", [-1, 0, -2, 1]),
    ("Power", [2, 0, -3, 1]),
];

const UNITS: [&str; 4] = ["m", "rad", "s", "kg"];

const TORSIONAL_STIFFNESS: Dim = Dim::new(2, -1, -2, 1);
const TORSIONAL_DAMPING: Dim = Dim::new(2, -1, -1, 1);

/// Units that engineers do not write by metre, second and kilogram.
const DERIVED: [(Dim, &str); 10] = [
    (Dim::new(2, 0, 0, 1), "kg m²"),
    (Dim::new(1, 0, -2, 1), "N"),
    (Dim::new(2, 0, -2, 1), "N m"),
    (Dim::new(0, 0, -2, 1), "N/m"),
    (Dim::new(0, 0, -1, 1), "N s/m"),
    (Dim::new(2, 0, -3, 1), "W"),
    (Dim::new(-1, 0, -2, 1), "Pa"),
    (Dim::new(2, 0, -1, 1), "N m s"),
    (TORSIONAL_STIFFNESS, "N m/rad"),
    (TORSIONAL_DAMPING, "N m s/rad"),
];

impl Dim {
    /// A pure number.
    pub(crate) const NUMBER: Dim = Dim::new(0, 0, 0, 0);
    /// Metres.
    pub(crate) const LENGTH: Dim = Dim::new(1, 0, 0, 0);
    /// Radians.
    pub(crate) const ANGLE: Dim = Dim::new(0, 1, 0, 0);
    /// Kilograms.
    pub(crate) const MASS: Dim = Dim::new(0, 0, 0, 1);
    /// kg m²
    pub(crate) const INERTIA: Dim = Dim::new(2, 0, 0, 1);
    /// m/s²
    pub(crate) const ACCELERATION: Dim = Dim::new(1, 0, -2, 0);
    /// Newtons.
    pub(crate) const FORCE: Dim = Dim::new(1, 0, -2, 1);
    /// N/m
    pub(crate) const STIFFNESS: Dim = Dim::new(0, 0, -2, 1);
    /// Newton metres, joules.
    pub(crate) const TORQUE: Dim = Dim::new(2, 0, -2, 1);
    /// Seconds.
    pub(crate) const TIME: Dim = Dim::new(0, 0, 1, 0);

    /// From whole exponents of metre, radian, second and kilogram.
    pub(crate) const fn new(length: i16, angle: i16, time: i16, mass: i16) -> Dim {
        Dim { sixths: [length * WHOLE, angle * WHOLE, time * WHOLE, mass * WHOLE] }
    }

    /// True for positive powers of time alone.
    pub(crate) fn is_of_time(self) -> bool {
        let [length, angle, time, mass] = self.sixths;
        time > 0 && [length, angle, mass] == [0; 3]
    }

    /// As which power of a length a residual of this dimension is judged.
    pub(crate) fn power_of_length(self) -> u8 {
        match self {
            Dim::ANGLE | Dim::NUMBER => 0,
            Dim::LENGTH => 1,
            _ => 2,
        }
    }

    /// The dimension of this name.
    pub(crate) fn named(name: &str) -> Option<Dim> {
        NAMED.iter().find(|(known, _)| *known == name).map(|(_, [l, a, t, m])| Dim::new(*l, *a, *t, *m))
    }

    /// All names, for suggestions.
    pub(crate) fn names<'a>() -> impl Iterator<Item = &'a str> {
        NAMED.iter().map(|(name, _)| *name)
    }

    /// The dimension of a product.
    pub(crate) fn times(self, other: Dim) -> Dim {
        self.zip(other, i16::saturating_add)
    }

    /// The dimension of a quotient.
    pub(crate) fn per(self, other: Dim) -> Dim {
        self.zip(other, i16::saturating_sub)
    }

    /// The dimension of a power with exponent `sixths / 6`; `None` if an exponent of the result is not a whole number of sixths.
    pub(crate) fn power(self, sixths: i16) -> Option<Dim> {
        let mut result = self;
        for exponent in &mut result.sixths {
            let product = i32::from(*exponent) * i32::from(sixths);
            if product % i32::from(WHOLE) != 0 {
                return None;
            }
            *exponent = i16::try_from(product / i32::from(WHOLE)).ok()?;
        }
        Some(result)
    }

    /// The dimension of a whole power.
    pub(crate) fn raised(self, exponent: i16) -> Option<Dim> {
        self.power(WHOLE * exponent)
    }

    /// The same dimension without radians.
    pub(crate) fn without_angle(self) -> Dim {
        let [length, _, time, mass] = self.sixths;
        Dim { sixths: [length, 0, time, mass] }
    }

    /// True if the dimension is 1 apart from radians.
    pub(crate) fn is_plain(self) -> bool {
        self.without_angle() == Dim::NUMBER
    }

    /// True if lengths or masses occur; radians do not count beside them.
    pub(crate) fn is_extended(self) -> bool {
        self.sixths[0] != 0 || self.sixths[3] != 0
    }

    /// True if radians occur to the first power: an angle, or its rate.
    pub(crate) fn is_of_turning(self) -> bool {
        self.sixths[1] == WHOLE
    }

    /// True if both dimensions are the same apart from radians.
    pub(crate) fn agrees(self, other: Dim) -> bool {
        self.without_angle() == other.without_angle()
    }

    fn zip(self, other: Dim, combine: fn(i16, i16) -> i16) -> Dim {
        let mut result = self;
        for (mine, theirs) in result.sixths.iter_mut().zip(other.sixths) {
            *mine = combine(*mine, theirs);
        }
        result
    }

    /// The SI unit: `m`, `rad/s`, `m²`, `N/m`; empty for a pure number.
    pub fn unit(self) -> String {
        if let Some((_, unit)) = DERIVED.iter().find(|(dim, _)| *dim == self) {
            return (*unit).to_owned();
        }
        let factor = |unit: &str, sixths: i16| {
            let exponent = sixths.abs();
            match (exponent % WHOLE, exponent / WHOLE) {
                (0, 1) => unit.to_owned(),
                (0, 2) => format!("{unit}²"),
                (0, 3) => format!("{unit}³"),
                (0, whole) => format!("{unit}^{whole}"),
                (2 | 4, _) => format!("{unit}^({}/3)", exponent / 2),
                (3, _) => format!("{unit}^({}/2)", exponent / 3),
                _ => format!("{unit}^({exponent}/6)"),
            }
        };
        let part = |positive: bool| {
            let factors = self.sixths.iter().zip(UNITS).filter(|(sixths, _)| **sixths != 0 && (**sixths > 0) == positive);
            factors.map(|(sixths, unit)| factor(unit, *sixths)).collect::<Vec<_>>()
        };
        let (above, below) = (part(true), part(false));
        match (above.is_empty(), below.len()) {
            (_, 0) => above.join("·"),
            (true, 1) => format!("1/{}", below[0]),
            (false, 1) => format!("{}/{}", above.join("·"), below[0]),
            (true, _) => format!("1/({})", below.join("·")),
            (false, _) => format!("{}/({})", above.join("·"), below.join("·")),
        }
    }
}

impl fmt::Display for Dim {
    /// `a length (m)`, `a pure number`, `a quantity in m²/s`.
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        let name = NAMED.iter().find(|(name, _)| Dim::named(name) == Some(*self)).map(|(name, _)| *name);
        let words = match name {
            Some("Number") => return write!(formatter, "a pure number"),
            Some("Angle") => "an angle",
            Some("Area") => "an area",
            Some("Acceleration") => "an acceleration",
            Some("AngularVelocity") => "an angular velocity",
            Some("AngularAcceleration") => "an angular acceleration",
            Some("Inertia") => "an inertia",
            Some(other) => return write!(formatter, "a {} ({})", other.to_lowercase(), self.unit()),
            None if *self == TORSIONAL_STIFFNESS => "a torsional stiffness",
            None if *self == TORSIONAL_DAMPING => "a torsional damping",
            None => return write!(formatter, "a quantity in {}", self.unit()),
        };
        write!(formatter, "{words} ({})", self.unit())
    }
}

/// Dimension of an expression, as far as it is known: a bare number takes the dimension that its context requires.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum InferredDim {
    /// Any dimension.
    Any,
    /// A known dimension.
    Known(Dim),
}

impl InferredDim {
    /// The dimension if the context requires none: a bare number is a pure number.
    pub(crate) fn settled(self) -> Dim {
        match self {
            InferredDim::Any => Dim::NUMBER,
            InferredDim::Known(dim) => dim,
        }
    }

    /// Common dimension of two numbers that are added or compared.
    pub(crate) fn common(self, other: InferredDim) -> Option<InferredDim> {
        match (self, other) {
            (InferredDim::Any, measure) | (measure, InferredDim::Any) => Some(measure),
            (InferredDim::Known(one), InferredDim::Known(two)) if one == two => Some(self),
            // Beside lengths or masses radians are dropped: an arc is a length.
            (InferredDim::Known(one), InferredDim::Known(two)) if one.agrees(two) && one.is_extended() => {
                Some(InferredDim::Known(one.without_angle()))
            }
            (InferredDim::Known(one), InferredDim::Known(two)) if one.agrees(two) => Some(if two.is_of_turning() { other } else { self }),
            _ => None,
        }
    }

    /// True if a number of this dimension may be used where `wanted` is required.
    ///
    /// A ratio of lengths may be used as an angle (an arc over its radius), and a speed over a radius as an angular velocity; but not
    /// an angle as a ratio, nor an angular velocity as a frequency.
    pub(crate) fn fits(self, wanted: Dim) -> bool {
        match self {
            InferredDim::Any => true,
            InferredDim::Known(found) if found == wanted => true,
            InferredDim::Known(found) if found.agrees(wanted) && wanted.is_extended() => true,
            InferredDim::Known(found) => found.agrees(wanted) && found == found.without_angle() && wanted.is_of_turning(),
        }
    }

    /// The dimension of a product.
    pub(crate) fn times(self, other: InferredDim) -> InferredDim {
        match (self, other) {
            (InferredDim::Any, measure) | (measure, InferredDim::Any) => measure,
            (InferredDim::Known(one), InferredDim::Known(two)) => InferredDim::Known(one.times(two)),
        }
    }

    /// The dimension of a quotient.
    pub(crate) fn per(self, other: InferredDim) -> InferredDim {
        match (self, other) {
            (measure, InferredDim::Any) => measure,
            (InferredDim::Any, InferredDim::Known(dim)) => InferredDim::Known(Dim::NUMBER.per(dim)),
            (InferredDim::Known(one), InferredDim::Known(two)) => InferredDim::Known(one.per(two)),
        }
    }

    /// The dimension of a power with exponent `sixths / 6`.
    pub(crate) fn power(self, sixths: i16) -> Option<InferredDim> {
        match self {
            InferredDim::Any => Some(InferredDim::Any),
            InferredDim::Known(dim) => dim.power(sixths).map(InferredDim::Known),
        }
    }
}

impl fmt::Display for InferredDim {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        self.settled().fmt(formatter)
    }
}
