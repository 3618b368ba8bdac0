//! Where a run in the window reads, and what it would have written: kept in memory, never on disk.

use crate::control::machine::{Folders, InMemory, NcPath, Store, StoreError};
use crate::control::mask::FileUse;

/// The folder of the program and the embedded files; what is written stays here and can be read again.
#[derive(Debug, Clone, Default)]
pub(super) struct Dry {
    folders: Folders,
    written: Vec<NcPath>,
    files: InMemory,
}

impl Dry {
    /// Reads what these folders hold.
    pub(super) fn reading(folders: Folders) -> Self {
        Self { folders, ..Self::default() }
    }
}

impl Store for Dry {
    fn read(&self, path: &NcPath) -> Result<Vec<u8>, StoreError> {
        if self.written.contains(path) { self.files.read(path) } else { self.folders.read(path) }
    }

    fn write(&mut self, path: &NcPath, bytes: &[u8], how: FileUse) -> Result<(), StoreError> {
        if !self.written.contains(path) {
            self.written.push(path.clone());
        }
        self.files.write(path, bytes, how)
    }
}
