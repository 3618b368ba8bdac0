//! What can be opened to try the program: built-in files that are read as files from a disk are, by paths at which no disk has anything.

use std::path::{Path, PathBuf};

use fitcheck_exchange::journal::chain::Hash;
use fitcheck_shipped as shipped;

use crate::purpose::Purpose;

/// The folder that the samples seem to lie in.
const FOLDER: &str = "fitcheck:samples";

/// Something to try the program with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Sample {
    /// One measured value, marked as simulated and not recorded.
    Value,
    /// A plan with a picture.
    Part,
    /// A file of measurements. Its values are marked as simulated, and are not recorded.
    File,
    /// An NC program that measures.
    Program,
}

impl Sample {
    /// Every sample.
    pub const ALL: [Self; 4] = [Self::Value, Self::Part, Self::File, Self::Program];

    /// What it is read for, and its name.
    const fn row(self) -> (Purpose, &'static str) {
        match self {
            Self::Value => (Purpose::Import, "sample_value.csv"),
            Self::Part => (Purpose::OpenPlan, "sample_plate.toml"),
            Self::File => (Purpose::Import, "sample_measurements.csv"),
            Self::Program => (Purpose::OpenProgram, "sample_plate.h"),
        }
    }

    /// What it is read for.
    pub const fn purpose(self) -> Purpose {
        self.row().0
    }

    /// The path that it is read from.
    pub fn path(self) -> PathBuf {
        Path::new(FOLDER).join(self.row().1)
    }

    /// Whether a file of measurements is a sample: by its bytes, so that a file of the same name is not taken for one.
    pub(crate) fn is_measured_in(name: &str, sha256: Hash) -> bool {
        [Self::Value, Self::File].into_iter().any(|sample| {
            let is_its = |bytes| Hash::of_file(bytes) == sha256;
            sample.row().1 == name && Self::bytes_at(&sample.path()).is_some_and(is_its)
        })
    }

    /// The bytes at a path of a sample, or of what lies beside one; `None` for any other path.
    pub fn bytes_at(path: &Path) -> Option<&'static [u8]> {
        let name = path.strip_prefix(FOLDER).ok()?.to_str()?;
        shipped::file(shipped::SAMPLES, name)
    }
}
