//! Formats of arrays that are longer than those that serde reads and writes by itself, for generated code.

use core::fmt::{self, Formatter};
use core::marker::PhantomData;

use serde::de::{self, Deserialize, DeserializeSeed, Deserializer, SeqAccess, Visitor};
use serde::ser::{Serialize, SerializeTuple, Serializer};

/// The format of a value that has one.
#[derive(Clone, Copy, Debug)]
pub struct Each;

/// The format of an array whose elements have the format `F`.
#[derive(Clone, Copy, Debug)]
pub struct Rows<F>(PhantomData<F>);

/// A format in which values of type `A` are written.
pub trait WriteAs<A> {
    /// Writes a value.
    ///
    /// # Errors
    /// That of the serializer.
    fn write<S: Serializer>(value: &A, serializer: S) -> Result<S::Ok, S::Error>;
}

/// A format in which values of type `A` are read.
pub trait ReadAs<'de, A> {
    /// Reads a value.
    ///
    /// # Errors
    /// That of the deserializer.
    fn read<D: Deserializer<'de>>(deserializer: D) -> Result<A, D::Error>;
}

impl<A: Serialize> WriteAs<A> for Each {
    fn write<S: Serializer>(value: &A, serializer: S) -> Result<S::Ok, S::Error> {
        value.serialize(serializer)
    }
}

impl<'de, A: Deserialize<'de>> ReadAs<'de, A> for Each {
    fn read<D: Deserializer<'de>>(deserializer: D) -> Result<A, D::Error> {
        A::deserialize(deserializer)
    }
}

/// The two functions that `#[serde(with = "…")]` calls.
impl<F> Rows<F> {
    /// Writes an array.
    ///
    /// # Errors
    /// That of the serializer.
    pub fn serialize<A, S: Serializer>(value: &A, serializer: S) -> Result<S::Ok, S::Error>
    where
        Self: WriteAs<A>,
    {
        Self::write(value, serializer)
    }

    /// Reads an array.
    ///
    /// # Errors
    /// That of the deserializer.
    pub fn deserialize<'de, A, D: Deserializer<'de>>(deserializer: D) -> Result<A, D::Error>
    where
        Self: ReadAs<'de, A>,
    {
        Self::read(deserializer)
    }
}

/// An element with its format.
struct Element<'a, F, A>(&'a A, PhantomData<F>);

impl<F: WriteAs<A>, A> Serialize for Element<'_, F, A> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        F::write(self.0, serializer)
    }
}

impl<F: WriteAs<A>, A, const N: usize> WriteAs<[A; N]> for Rows<F> {
    fn write<S: Serializer>(value: &[A; N], serializer: S) -> Result<S::Ok, S::Error> {
        let mut tuple = serializer.serialize_tuple(N)?;
        value.iter().try_for_each(|element| tuple.serialize_element(&Element::<F, A>(element, PhantomData)))?;
        tuple.end()
    }
}

/// Reads an array, or one of its elements.
struct RowsReader<F, A, const N: usize>(PhantomData<(F, A)>);

impl<'de, F: ReadAs<'de, A>, A, const N: usize> DeserializeSeed<'de> for RowsReader<F, A, N> {
    type Value = A;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<A, D::Error> {
        F::read(deserializer)
    }
}

impl<'de, F: ReadAs<'de, A>, A: Copy, const N: usize> Visitor<'de> for RowsReader<F, A, N> {
    type Value = [A; N];

    fn expecting(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "an array of length {N}")
    }

    fn visit_seq<S: SeqAccess<'de>>(self, mut elements: S) -> Result<[A; N], S::Error> {
        let mut next = |length: usize| {
            let element = elements.next_element_seed(RowsReader::<F, A, N>(PhantomData))?;
            element.ok_or_else(|| de::Error::invalid_length(length, &self))
        };
        let mut array = [next(0)?; N];
        for (length, element) in array.iter_mut().enumerate().skip(1) {
            *element = next(length)?;
        }
        Ok(array)
    }
}

impl<'de, F: ReadAs<'de, A>, A: Copy, const N: usize> ReadAs<'de, [A; N]> for Rows<F> {
    fn read<D: Deserializer<'de>>(deserializer: D) -> Result<[A; N], D::Error> {
        deserializer.deserialize_tuple(N, RowsReader::<F, A, N>(PhantomData))
    }
}
