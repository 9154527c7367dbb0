//! A file from which a study goes on.

use std::fs::{self, File};
use std::io::{self, Error, ErrorKind, Write};
use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::{Lengths, Linkage, Study, Tally, lengths};

/// A study and the tally of its first sets, as JSON.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Checkpoint {
    /// The study.
    study: Study,
    /// The lengths of the nominal linkage in m, so that a changed declaration does not go on with the numbers of the old one.
    nominal: Lengths,
    /// The tally of its sets 0, 1, 2, … as far as they were solved.
    tally: Tally,
}

impl Checkpoint {
    /// A checkpoint of this study.
    #[must_use]
    pub fn new(study: Study, tally: Tally) -> Self {
        Self { study, nominal: lengths(&Linkage::default()), tally }
    }

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
        let wanted = Self::new(*study, Tally::default());
        if (found.study, found.nominal) != (wanted.study, wanted.nominal) || !found.tally.has_all_numbers() {
            let [found, wanted] = [&found, &wanted].map(|of| format!("{:?} of {:?} m", of.study, of.nominal));
            return Err(refused(path, &format!("belongs to another study:\n{found} instead of\n{wanted}")));
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
