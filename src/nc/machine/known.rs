//! Programs and tables that were read before: the same bytes are not taken apart twice.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::path::NcPath;
use crate::control::table::{ControlTable, TableError, TableFile};
use crate::nc::program::{Program, ProgramError};

/// How many tables are remembered.
const MOST_TABLES: usize = 4;
/// How large a remembered table may be, bytes.
const LARGEST_TABLE: usize = 1 << 20;

/// What was read before.
#[derive(Debug, Default)]
pub(super) struct Known {
    pub(super) programs: BTreeMap<NcPath, Arc<Program>>,
    tables: Vec<(NcPath, Vec<u8>, Arc<TableFile>)>,
}

impl Known {
    /// A program of these bytes.
    pub(super) fn program(&self, path: &NcPath, bytes: &[u8]) -> Result<Arc<Program>, ProgramError> {
        // A program gives its bytes back as they were read.
        if let Some(program) = self.programs.get(path).filter(|program| program.write() == bytes) {
            return Ok(Arc::clone(program));
        }
        Program::read(bytes).map(|(program, _warnings)| Arc::new(program))
    }

    /// A table of these bytes.
    pub(super) fn table(&mut self, path: &NcPath, bytes: Vec<u8>) -> Result<Arc<TableFile>, TableError> {
        let known = self.tables.iter().find(|(known, read, _)| known == path && *read == bytes);
        if let Some((.., file)) = known {
            return Ok(Arc::clone(file));
        }
        let file = Arc::new(ControlTable::read(&bytes, path.file_name())?);
        self.tables.retain(|(known, ..)| known != path);
        if bytes.len() <= LARGEST_TABLE {
            self.tables.truncate(MOST_TABLES - 1);
            self.tables.insert(0, (path.clone(), bytes, Arc::clone(&file)));
        }
        Ok(file)
    }
}
