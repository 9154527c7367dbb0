//! States as serde reads and writes them.

use core::fmt::{self, Display, Formatter};
use core::marker::PhantomData;

use nalgebra::SVector;
use serde::de::{self, Deserialize, Deserializer, Visitor};
use serde::ser::{Serialize, Serializer};

use super::{Extrapolation, State, Values};
use crate::number::{DetSign, Float};

/// The fields of a state. A state that is written by hand needs the first four only.
#[derive(serde::Serialize, serde::Deserialize)]
#[serde(rename = "State", bound(serialize = "T: Float + serde::Serialize", deserialize = "T: Float + serde::Deserialize<'de>"))]
struct Fields<T, const N: usize> {
    t: T,
    q: SVector<T, N>,
    qd: SVector<T, N>,
    qdd: SVector<T, N>,
    #[serde(default = "Branch::positive")]
    branch: Branch<N>,
    #[serde(default = "one")]
    condition: T,
    #[serde(default)]
    iterations: usize,
    #[serde(default)]
    solved: Seal,
}

fn one<T: Float>() -> T {
    T::of(1.0)
}

impl<T: Float + Serialize, const N: usize> Serialize for State<T, N> {
    /// Fields `t`, `q`, `qd`, `qdd`, `branch`, `condition`, `iterations` and `solved`, a number that shows whether the values are those
    /// that were solved for; it is empty where steps need not know.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Values { t, q, qd, qdd, branch, condition, iterations } = self.values;
        let solved = Seal(Some(self.parameter_hash ^ checksum(&self.values)).filter(|_| self.parameter_hash != 0));
        Fields { t, q, qd, qdd, branch: Branch(branch), condition, iterations, solved }.serialize(serializer)
    }
}

impl<'de, T: Float + Deserialize<'de>, const N: usize> Deserialize<'de> for State<T, N> {
    /// A state counts as solved if it did when it was written and its values are the same to the last bit.
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Fields { t, q, qd, qdd, branch: Branch(branch), condition, iterations, solved } = Fields::deserialize(deserializer)?;
        let values = Values { t, q, qd, qdd, branch, condition, iterations };
        // Of other values the result is the hash of no parameters.
        let parameter_hash = solved.0.map_or(0, |seal| seal ^ checksum(&values));
        Ok(Self { values, parameter_hash, extrapolation: Extrapolation::none() })
    }
}

/// A hash of time, coordinates, rates, accelerations and branch (Fowler, Noll and Vo, by words).
fn checksum<T: Float, const N: usize>(values: &Values<T, N>) -> u64 {
    let numbers = values.q.iter().chain(&values.qd).chain(&values.qdd).chain([&values.t]).map(|number| number.bits());
    let signs = values.branch.iter().map(|sign| u64::from(*sign == DetSign::Positive));
    numbers.chain(signs).fold(0xcbf2_9ce4_8422_2325_u64, |hash, word| {
        let mixed = (hash ^ word).wrapping_mul(0x0000_0100_0000_01b3);
        mixed ^ (mixed >> 29)
    })
}

/// The signs of a branch as text: `++-+`.
struct Branch<const N: usize>([DetSign; N]);

impl<const N: usize> Branch<N> {
    fn positive() -> Self {
        Self([DetSign::Positive; N])
    }
}

impl<const N: usize> Display for Branch<N> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|sign| f.write_str(if *sign == DetSign::Positive { "+" } else { "-" }))
    }
}

impl<const N: usize> Text for Branch<N> {
    const EXPECTED: &'static str = "a `+` or `-` for each coordinate";

    fn read(text: &str) -> Option<Self> {
        let mut branch = Self::positive();
        for (sign, letter) in branch.0.iter_mut().zip(text.bytes()) {
            *sign = match letter {
                b'+' => DetSign::Positive,
                b'-' => DetSign::Negative,
                _ => return None,
            };
        }
        (text.len() == N).then_some(branch)
    }
}

/// The hash of the parameters combined with the checksum of the values, in hexadecimal; none if the state was not solved for.
#[derive(Default)]
struct Seal(Option<u64>);

impl Display for Seal {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.0.map_or(Ok(()), |seal| write!(f, "{seal:016x}"))
    }
}

impl Text for Seal {
    const EXPECTED: &'static str = "16 hexadecimal digits, or an empty text";

    fn read(text: &str) -> Option<Self> {
        if text.is_empty() { Some(Self(None)) } else { u64::from_str_radix(text, 16).ok().map(|seal| Self(Some(seal))) }
    }
}

/// A value that is written as text.
trait Text: Display + Sized {
    const EXPECTED: &'static str;

    fn read(text: &str) -> Option<Self>;
}

/// Reads a text.
struct TextVisitor<V>(PhantomData<V>);

impl<V: Text> Visitor<'_> for TextVisitor<V> {
    type Value = V;

    fn expecting(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(V::EXPECTED)
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<V, E> {
        V::read(text).ok_or_else(|| E::invalid_value(de::Unexpected::Str(text), &self))
    }
}

impl<const N: usize> Serialize for Branch<N> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de, const N: usize> Deserialize<'de> for Branch<N> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_str(TextVisitor(PhantomData))
    }
}

impl Serialize for Seal {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for Seal {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_str(TextVisitor(PhantomData))
    }
}
