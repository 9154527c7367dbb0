//! A file from which a study goes on.

use std::fs::{self, File};
use std::io::{self, Error, ErrorKind, Write};
use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::{Study, Tally};

/// A study and the tally of its first sets, as JSON.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Checkpoint {
    /// The study.
    pub study: Study,
    /// The tally of its sets 0, 1, 2, … as far as they were solved.
    pub tally: Tally,
}

impl Checkpoint {
    /// Reads a checkpoint of this study. Nothing is known where there is no file.
    ///
    /// # Errors
    /// If the file cannot be read, is not a checkpoint, or is one of another study.
    pub fn load(path: &Path, study: &Study) -> io::Result<Tally> {
        let text = match fs::read(path) {
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(Tally::default()),
            text => text?,
        };
        let found: Self = serde_json::from_slice(&text).map_err(|error| refused(path, &format!("is no checkpoint: {error}")))?;
        if found.study != *study {
            return Err(refused(path, &format!("belongs to another study: {:?} instead of {study:?}", found.study)));
        }
        Ok(found.tally)
    }

    /// Writes the checkpoint to a file beside `path` and then renames it, so that there is a whole checkpoint at any time.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub fn save(&self, path: &Path) -> io::Result<()> {
        let beside = path.with_extension("next");
        let mut file = File::create(&beside)?;
        serde_json::to_writer(&mut file, self)?;
        file.write_all(b"\n")?;
        // What is renamed must be on the disk.
        file.sync_all()?;
        fs::rename(&beside, path)
    }
}

fn refused(path: &Path, why: &str) -> Error {
    Error::new(ErrorKind::InvalidData, format!("{} {why}", path.display()))
}
