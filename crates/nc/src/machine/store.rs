//! Where programs, tables and masks come from, and where outputs go.

use std::collections::BTreeMap;
use std::path::PathBuf;

use fitcheck_core::message::Say;
use fitcheck_core::words::Dialogue;
use fitcheck_shipped as shipped;

use super::path::NcPath;
use crate::control::mask::FileUse;

/// Files as a program sees them. Paths are fully resolved before they get here.
pub trait Store: Send {
    /// The bytes of a file.
    ///
    /// # Errors
    /// [`StoreError`] if they cannot be read.
    fn read(&self, path: &NcPath) -> Result<Vec<u8>, StoreError>;

    /// Where a file comes from that was read. The default implementation says that it was given.
    fn origin(&self, _path: &NcPath) -> Origin {
        Origin::Given(None)
    }

    /// What else is there under the name of a file that was read, where a control would have one file. The default
    /// implementation has no other.
    fn other_names(&self, _path: &NcPath) -> Vec<OtherNames> {
        Vec::new()
    }

    /// Writes what FN 16 prints, or a table that FN 27 has changed, and returns how many bytes the file has then. The
    /// default implementation writes nothing.
    ///
    /// # Errors
    /// [`StoreError::ReadOnly`] if nothing is written, others if writing failed.
    fn write(&mut self, _path: &NcPath, _bytes: &[u8], _how: FileUse) -> Result<usize, StoreError> {
        Err(StoreError::ReadOnly)
    }

    /// Whether it writes at all. The default implementation does not.
    fn writes(&self) -> bool {
        false
    }

    /// Deletes a file that it may write. The default implementation deletes nothing.
    ///
    /// # Errors
    /// [`StoreError::Elsewhere`] for a file that only is read, [`StoreError::ReadOnly`] if nothing is written, others if there is no such
    /// file or deleting failed.
    fn remove(&mut self, _path: &NcPath) -> Result<(), StoreError> {
        Err(StoreError::ReadOnly)
    }
}

/// Where a file comes from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Origin {
    /// The user gave it; its name on this machine, where it has one.
    Given(Option<PathBuf>),
    /// It is built in, and nothing else could be meant.
    BuiltIn,
    /// It is built in and takes the place of one that is not among those that were given.
    BuiltInInstead,
}

/// A file or folder that was read, and others beside it whose names differ only by case.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OtherNames {
    pub read: String,
    pub others: String,
}

/// A file that a run has read, and where it comes from.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "machine-file")]
pub enum FileRead {
    /// A file on this machine.
    From {
        /// Its path on the control.
        path: NcPath,
        /// Its name on this machine.
        file: String,
    },
    /// A file that was given without a name on this machine.
    Given {
        /// Its path on the control.
        path: NcPath,
    },
    BuiltIn {
        /// Its path on the control.
        path: NcPath,
    },
}

impl FileRead {
    /// What to say of a file and its origin.
    pub fn of(path: &NcPath, origin: &Origin) -> Self {
        let path = path.clone();
        match origin {
            Origin::Given(Some(file)) => Self::From { path, file: file.display().to_string() },
            Origin::Given(None) => Self::Given { path },
            Origin::BuiltIn | Origin::BuiltInInstead => Self::BuiltIn { path },
        }
    }
}

/// Why a file cannot be read or written.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "machine-store", error)]
pub enum StoreError {
    /// The file does not exist.
    Missing { path: NcPath },
    /// A link leads out of the given folders.
    Outside { path: NcPath },
    /// A folder, a pipe or a device.
    NoFile { path: NcPath },
    /// It is larger than any file of a control.
    TooLarge {
        path: NcPath,
        /// What is allowed, MiB.
        most: u64,
    },
    /// Several files or folders have the name in different spellings, and none has exactly it.
    Ambiguous { path: NcPath, names: String },
    /// No folder was chosen for outputs.
    ReadOnly,
    /// A file to delete that is not in the folder for outputs.
    Elsewhere { path: NcPath },
    /// The system reported an error.
    System {
        path: NcPath,
        /// What the system reports.
        reason: String,
    },
}

impl Store for Box<dyn Store> {
    fn read(&self, path: &NcPath) -> Result<Vec<u8>, StoreError> {
        self.as_ref().read(path)
    }

    fn origin(&self, path: &NcPath) -> Origin {
        self.as_ref().origin(path)
    }

    fn other_names(&self, path: &NcPath) -> Vec<OtherNames> {
        self.as_ref().other_names(path)
    }

    fn write(&mut self, path: &NcPath, bytes: &[u8], how: FileUse) -> Result<usize, StoreError> {
        self.as_mut().write(path, bytes, how)
    }

    fn writes(&self) -> bool {
        self.as_ref().writes()
    }

    fn remove(&mut self, path: &NcPath) -> Result<(), StoreError> {
        self.as_mut().remove(path)
    }
}

impl StoreError {
    fn missing(path: &NcPath) -> Self {
        Self::Missing { path: path.clone() }
    }
}

/// The embedded programs, tables and masks: found by file name, in any folder. Nothing is written.
#[derive(Debug, Clone, Copy, Default)]
pub struct Shipped;

impl Shipped {
    /// The bytes of an embedded file.
    pub fn file(name: &str) -> Option<&'static [u8]> {
        let mut files = shipped::NC.iter().chain(shipped::MASKS).chain(shipped::TABLES);
        files.find(|(known, _)| known.eq_ignore_ascii_case(name)).map(|(_, bytes)| *bytes)
    }

    /// The programs that can be started directly, one per dialogue language.
    pub fn main_programs() -> impl Iterator<Item = (Dialogue, &'static str)> {
        let named = |dialogue| shipped::NC.iter().find(|(name, _)| *name == format!("8255_{dialogue}.h"));
        Dialogue::ALL.into_iter().filter_map(move |dialogue| Some((dialogue, named(dialogue)?.0)))
    }
}

impl Store for Shipped {
    fn read(&self, path: &NcPath) -> Result<Vec<u8>, StoreError> {
        Self::file(path.file_name()).map(<[u8]>::to_vec).ok_or_else(|| StoreError::missing(path))
    }

    fn origin(&self, _path: &NcPath) -> Origin {
        Origin::BuiltIn
    }
}

/// Only these files of a control. Nothing is written.
impl Store for BTreeMap<NcPath, Vec<u8>> {
    fn read(&self, path: &NcPath) -> Result<Vec<u8>, StoreError> {
        self.get(path).cloned().ok_or_else(|| StoreError::missing(path))
    }
}

/// Files in memory, by path or by file name, then the embedded ones. Outputs stay in memory.
#[derive(Debug, Clone, Default)]
pub struct InMemory(BTreeMap<String, Vec<u8>>);

impl InMemory {
    /// No files except the embedded ones.
    pub fn new() -> Self {
        Self::default()
    }

    /// The same with one more file: `a.h` in any folder, or `TNC:\fit\a.h` in this one.
    #[must_use]
    pub fn with(mut self, name: &str, bytes: impl Into<Vec<u8>>) -> Self {
        self.0.insert(name.to_ascii_lowercase(), bytes.into());
        self
    }

    /// A file by path or by file name.
    pub fn file(&self, path: &NcPath) -> Option<&[u8]> {
        let by = |name: &str| self.0.get(&name.to_ascii_lowercase());
        by(&path.to_string()).or_else(|| by(path.file_name())).map(Vec::as_slice)
    }
}

impl Store for InMemory {
    fn read(&self, path: &NcPath) -> Result<Vec<u8>, StoreError> {
        self.file(path).map_or_else(|| Shipped.read(path), |bytes| Ok(bytes.to_vec()))
    }

    fn origin(&self, path: &NcPath) -> Origin {
        if self.file(path).is_some() { Origin::Given(None) } else { Origin::BuiltIn }
    }

    fn write(&mut self, path: &NcPath, bytes: &[u8], how: FileUse) -> Result<usize, StoreError> {
        let mut whole = match self.file(path) {
            Some(old) if how != FileUse::Replace => old.to_vec(),
            _ => Vec::new(),
        };
        whole.extend_from_slice(bytes);
        let size = whole.len();
        self.0.insert(path.to_string().to_ascii_lowercase(), whole);
        Ok(size)
    }

    fn writes(&self) -> bool {
        true
    }

    fn remove(&mut self, path: &NcPath) -> Result<(), StoreError> {
        let whole = self.0.remove(&path.to_string().to_ascii_lowercase());
        let removed = whole.or_else(|| self.0.remove(&path.file_name().to_ascii_lowercase()));
        match removed {
            Some(_bytes) => Ok(()),
            None if Shipped.read(path).is_ok() => Err(StoreError::Elsewhere { path: path.clone() }),
            None => Err(StoreError::missing(path)),
        }
    }
}
