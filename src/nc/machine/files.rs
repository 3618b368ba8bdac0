//! The files of a run: what is read from the store is counted, and the same bytes are not parsed twice.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::budget::{Budget, UsedUp};
use super::fault::FaultKind;
use super::path::NcPath;
use super::store::{Store, StoreError};
use crate::control::mask::FileUse;
use crate::control::table::{ControlTable, TableFile};
use crate::nc::program::Program;

/// How many tables are remembered.
const MOST_TABLES: usize = 4;
/// How large a remembered table may be, bytes.
const LARGEST_TABLE: usize = 1 << 20;

/// The store with what was read from it.
pub(super) struct Files {
    store: Box<dyn Store>,
    budget: Budget,
    /// The programs of this run.
    programs: BTreeMap<NcPath, Arc<Program>>,
    /// The programs of earlier runs.
    known: BTreeMap<NcPath, Arc<Program>>,
    tables: Vec<(NcPath, Vec<u8>, Arc<TableFile>)>,
    kept_bytes: usize,
    traffic: usize,
}

impl Files {
    pub(super) fn new(store: Box<dyn Store>, budget: Budget, main: (NcPath, Arc<Program>)) -> Self {
        Self {
            store,
            budget,
            programs: BTreeMap::from([main]),
            known: BTreeMap::new(),
            tables: Vec::new(),
            kept_bytes: 0,
            traffic: 0,
        }
    }

    /// Starts counting again. Programs and tables are remembered until their bytes change.
    pub(super) fn restart(&mut self, main: (NcPath, Arc<Program>)) {
        self.known.append(&mut self.programs);
        self.programs.extend([main]);
        (self.kept_bytes, self.traffic) = (0, 0);
    }

    pub(super) fn read(&mut self, path: &NcPath) -> Result<Vec<u8>, FaultKind> {
        let bytes = self.store.read(path)?;
        self.spend(bytes.len())?;
        Ok(bytes)
    }

    /// Writes a file and returns how many bytes it has then; `None` if nothing is written. The caller must count the
    /// bytes with [`Self::spend`].
    pub(super) fn write(&mut self, path: &NcPath, bytes: &[u8], how: FileUse) -> Result<Option<usize>, StoreError> {
        match self.store.write(path, bytes, how) {
            Ok(size) => Ok(Some(size)),
            Err(StoreError::ReadOnly) => Ok(None),
            Err(error) => Err(error),
        }
    }

    /// Counts bytes that were read or written: without it, a loop with a large file could run for days.
    pub(super) fn spend(&mut self, bytes: usize) -> Result<(), UsedUp> {
        self.traffic = self.traffic.saturating_add(bytes);
        let most = self.budget.traffic;
        if most < self.traffic { Err(UsedUp::Traffic(most)) } else { Ok(()) }
    }

    /// Counts a file that is kept, in addition to this many changed tables.
    pub(super) fn keep(&mut self, bytes: usize, tables: usize) -> Result<(), UsedUp> {
        Budget::one_more(self.programs.len() + tables, self.budget.files, UsedUp::Files)?;
        let bytes = self.kept_bytes + bytes;
        if self.budget.file_bytes < bytes {
            return Err(UsedUp::FileBytes(self.budget.file_bytes));
        }
        self.kept_bytes = bytes;
        Ok(())
    }

    /// A program that this run has loaded.
    pub(super) fn loaded(&self, path: &NcPath) -> Option<&Arc<Program>> {
        self.programs.get(path)
    }

    /// A program, read once per run.
    pub(super) fn program(&mut self, path: &NcPath, tables: usize) -> Result<Arc<Program>, FaultKind> {
        if let Some(program) = self.programs.get(path) {
            return Ok(Arc::clone(program));
        }
        let bytes = self.read(path).or_else(|fault| self.with_suffix(path, fault))?;
        self.keep(bytes.len(), tables)?;
        // A program returns exactly the bytes that it was read from.
        let program = match self.known.get(path).filter(|program| program.write() == bytes) {
            Some(program) => Arc::clone(program),
            None => match Program::read(&bytes) {
                Ok((program, _warnings)) => Arc::new(program),
                Err(error) => return Err(FaultKind::NoProgram { path: path.clone(), error }),
            },
        };
        self.programs.insert(path.clone(), Arc::clone(&program));
        Ok(program)
    }

    /// `CALL PGM sub` without `.h`.
    fn with_suffix(&mut self, path: &NcPath, fault: FaultKind) -> Result<Vec<u8>, FaultKind> {
        if path.file_name().contains('.') || !matches!(fault, FaultKind::Store(StoreError::Missing { .. })) {
            return Err(fault);
        }
        self.read(&NcPath::new(&format!("{path}.h"))?).map_err(|_missing_too| fault)
    }

    /// A table, and how many bytes it has.
    pub(super) fn table(&mut self, path: &NcPath) -> Result<(Arc<TableFile>, usize), FaultKind> {
        let bytes = self.read(path)?;
        let size = bytes.len();
        let known = self.tables.iter().find(|(known, read, _)| known == path && *read == bytes);
        if let Some((.., file)) = known {
            return Ok((Arc::clone(file), size));
        }
        let file = ControlTable::read(&bytes, path.file_name()).map_err(|error| FaultKind::Table(Box::new(error)))?;
        let file = Arc::new(file);
        self.tables.retain(|(known, ..)| known != path);
        if size <= LARGEST_TABLE {
            self.tables.truncate(MOST_TABLES - 1);
            self.tables.insert(0, (path.clone(), bytes, Arc::clone(&file)));
        }
        Ok((file, size))
    }
}
