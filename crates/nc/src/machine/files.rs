//! The files of a run: what is read from the store is counted, and the same bytes are not parsed twice.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::budget::{Budget, UsedUp};
use super::fault::FaultKind;
use super::path::NcPath;
use super::remark::Remark;
use super::store::{Origin, OtherNames, Store, StoreError};
use crate::control::mask::FileUse;
use crate::control::table::{ControlTable, TableFile};
use crate::program::Program;

/// How many tables are remembered.
const MOST_TABLES: usize = 4;
/// What reading a file costs at least, bytes: it takes its time even if the file is empty or missing.
const LEAST: usize = 4 << 10;
/// How much memory a remembered table may take, bytes.
const LARGEST_TABLE: usize = 8 << 20;
/// What a cell of a table takes in memory, bytes: a text and its place.
const CELL: usize = 56;

/// The store with what was read from it.
pub(super) struct Files {
    store: Box<dyn Store>,
    budget: Budget,
    /// The programs of this run.
    programs: BTreeMap<NcPath, Arc<Program>>,
    /// The programs of earlier runs.
    known: BTreeMap<NcPath, Arc<Program>>,
    /// What their reader had to say.
    odd: BTreeMap<NcPath, Vec<Remark>>,
    tables: Vec<(NcPath, Vec<u8>, Arc<TableFile>)>,
    /// Where each file comes from that was read.
    origins: BTreeMap<NcPath, Origin>,
    /// What is worth knowing about those that were read since somebody asked.
    told: Vec<Remark>,
    kept_bytes: usize,
    traffic: usize,
    /// The folders that were written into, and those above them.
    folders: BTreeSet<String>,
}

impl Files {
    pub(super) fn new(store: Box<dyn Store>, budget: Budget, main: (NcPath, Arc<Program>)) -> Self {
        Self {
            store,
            budget,
            programs: BTreeMap::from([main]),
            known: BTreeMap::new(),
            odd: BTreeMap::new(),
            tables: Vec::new(),
            origins: BTreeMap::new(),
            told: Vec::new(),
            kept_bytes: 0,
            traffic: 0,
            folders: BTreeSet::new(),
        }
    }

    /// Starts counting again. Programs and tables are remembered until their bytes change.
    pub(super) fn restart(&mut self, main: (NcPath, Arc<Program>)) {
        self.known.append(&mut self.programs);
        self.programs.extend([main]);
        self.kept_bytes = 0;
        self.traffic = 0;
        self.folders.clear();
        self.origins.clear();
        self.told.clear();
    }

    /// Where each file comes from that was read.
    pub(super) const fn origins(&self) -> &BTreeMap<NcPath, Origin> {
        &self.origins
    }

    /// What is worth knowing about the files that were read since this was asked: built-in ones that took the place of
    /// others, and those that a control would have in one spelling only.
    pub(super) fn take_told(&mut self) -> Vec<Remark> {
        std::mem::take(&mut self.told)
    }

    pub(super) fn read(&mut self, path: &NcPath) -> Result<Vec<u8>, FaultKind> {
        self.spend(LEAST)?;
        let bytes = self.store.read(path)?;
        self.spend(bytes.len().saturating_sub(LEAST))?;
        if !self.origins.contains_key(path) {
            let origin = self.store.origin(path);
            if origin == Origin::BuiltInInstead {
                self.told.push(Remark::BuiltIn { path: path.clone() });
            }
            let others = self.store.other_names(path).into_iter();
            self.told.extend(others.map(|OtherNames { read, others }| Remark::OtherNames { read, others }));
            self.origins.insert(path.clone(), origin);
        }
        Ok(bytes)
    }

    /// Writes a file and returns how many bytes it has then; `None` if nothing is written. The caller must count the
    /// bytes with [`Self::spend`].
    pub(super) fn write(&mut self, path: &NcPath, bytes: &[u8], how: FileUse) -> Result<Option<usize>, FaultKind> {
        self.enter(path)?;
        match self.store.write(path, bytes, how) {
            Ok(size) => Ok(Some(size)),
            Err(StoreError::ReadOnly) => Ok(None),
            Err(error) => Err(error.into()),
        }
    }

    /// Whether anything is written.
    pub(super) fn writes(&self) -> bool {
        self.store.writes()
    }

    /// Deletes a file that the run may write.
    pub(super) fn remove(&mut self, path: &NcPath) -> Result<(), FaultKind> {
        self.spend(LEAST)?;
        self.origins.remove(path);
        Ok(self.store.remove(path)?)
    }

    /// Counts the folders on the way to a file: a program could make some thousand a second.
    fn enter(&mut self, path: &NcPath) -> Result<(), UsedUp> {
        let mut folder = String::new();
        let mut parts: Vec<&str> = path.parts().collect();
        parts.pop();
        for part in parts {
            folder.push_str(part);
            folder.push('\\');
            if !self.folders.contains(&folder) {
                Budget::one_more(self.folders.len(), self.budget.folders, UsedUp::Folders)?;
                self.folders.insert(folder.clone());
            }
        }
        Ok(())
    }

    /// Counts bytes that were read or written: without it, a loop with a large file could run for days.
    pub(super) fn spend(&mut self, bytes: usize) -> Result<(), UsedUp> {
        self.traffic = self.traffic.saturating_add(bytes);
        let most = self.budget.traffic;
        if most < self.traffic { Err(UsedUp::Traffic(most)) } else { Ok(()) }
    }

    /// Counts a changed table that is written through to the disk.
    pub(super) fn count_table_write(&self, writes: &mut usize) -> Result<(), UsedUp> {
        Budget::one_more(*writes, self.budget.table_writes, UsedUp::TableWrites)?;
        *writes += 1;
        Ok(())
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

    /// A program, read once per run, and what its reader has to say the first time.
    pub(super) fn program(&mut self, path: &NcPath, tables: usize) -> Result<(Arc<Program>, Vec<Remark>), FaultKind> {
        if let Some(program) = self.programs.get(path) {
            return Ok((Arc::clone(program), Vec::new()));
        }
        let bytes = self.read(path).or_else(|fault| self.with_suffix(path, fault))?;
        // A program returns exactly the bytes that it was read from.
        let (program, remarks) = match self.known.get(path).filter(|program| program.write() == bytes) {
            Some(program) => (Arc::clone(program), self.odd.get(path).map_or_else(Vec::new, Clone::clone)),
            None => match Program::read(&bytes) {
                Ok((program, warnings)) => (Arc::new(program), Remark::read(path, &warnings)),
                Err(error) => return Err(FaultKind::NoProgram { path: path.clone(), error }),
            },
        };
        self.keep(program.memory(), tables)?;
        self.odd.insert(path.clone(), remarks.clone());
        self.programs.insert(path.clone(), Arc::clone(&program));
        Ok((program, remarks))
    }

    /// `CALL PGM sub` without `.h`, `%sub` without `.i`.
    fn with_suffix(&mut self, path: &NcPath, fault: FaultKind) -> Result<Vec<u8>, FaultKind> {
        if path.file_name().contains('.') || !matches!(fault, FaultKind::Store(StoreError::Missing { .. })) {
            return Err(fault);
        }
        for ending in ["h", "i"] {
            match self.read(&NcPath::new(&format!("{path}.{ending}"))?) {
                Err(FaultKind::Store(StoreError::Missing { .. })) => {}
                found => return found,
            }
        }
        Err(fault)
    }

    /// A table, and how much memory it takes.
    pub(super) fn table(&mut self, path: &NcPath) -> Result<(Arc<TableFile>, usize), FaultKind> {
        let bytes = self.read(path)?;
        let memory = |file: &TableFile| file.table.rows.len() * file.table.columns.len() * CELL;
        let known = self.tables.iter().find(|(known, read, _)| known == path && *read == bytes);
        if let Some((.., file)) = known {
            return Ok((Arc::clone(file), bytes.len() + memory(file)));
        }
        let file = ControlTable::read(&bytes, path.file_name()).map_err(|error| FaultKind::Table(Box::new(error)))?;
        let file = Arc::new(file);
        let size = bytes.len() + memory(&file);
        self.tables.retain(|(known, ..)| known != path);
        if size <= LARGEST_TABLE {
            self.tables.truncate(MOST_TABLES - 1);
            self.tables.insert(0, (path.clone(), bytes, Arc::clone(&file)));
        }
        Ok((file, size))
    }
}
