//! Failures as serde writes them: the sentence, and its facts.

use core::fmt::Display;

use serde::ser::{Serialize, Serializer};

use super::Failure;
use crate::names::{BranchEnd, Cause};
use crate::number::Float;
use crate::state::State;

#[derive(serde::Serialize)]
#[serde(rename = "Failure", bound(serialize = "T: Float + serde::Serialize, M: Display"))]
struct Fields<'a, M, T, const N: usize> {
    #[serde(serialize_with = "sentence")]
    message: &'a M,
    mechanism: &'static str,
    cause: &'a Cause<T>,
    time: T,
    end: &'a Option<BranchEnd<T>>,
    last: &'a Option<State<T, N>>,
}

fn sentence<M: Display, S: Serializer>(message: &&M, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(message)
}

impl<T: Float + Serialize, const N: usize> Serialize for Failure<T, N> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Failure { mechanism, cause, time, end, last } = self;
        Fields { message: self, mechanism, cause, time: *time, end, last }.serialize(serializer)
    }
}
