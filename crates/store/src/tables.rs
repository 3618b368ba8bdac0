//! A folder of the user's own tables of deviations.

use std::path::{Path, PathBuf};

use fitcheck_core::message::Say;
use fitcheck_core::tolerance::DeviationTable;
use fitcheck_core::tolerance::compare::{Contradiction, contradiction};
use fitcheck_files::{self as files, FileError, no_half_set, read, system};
use fitcheck_nc::control::deviations::{DeviationError, DeviationWarning, read_table};

/// What a folder of tables holds.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct OwnTables {
    /// The tables, by file name.
    pub tables: Vec<DeviationTable>,
    /// Warnings about what was still readable, each with its file and line.
    pub warnings: Vec<DeviationWarning>,
}

/// Why the tables of a folder cannot be used.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(error)]
pub enum OwnTablesError {
    /// The folder or a file in it cannot be read.
    #[say(transparent)]
    File(#[from] FileError),
    /// A table is broken.
    #[say(transparent)]
    Table(#[from] DeviationError),
    /// Two tables have different values for the same class and size.
    #[say(transparent)]
    Contradiction(#[from] Contradiction),
    /// There is no table of deviations in the folder.
    #[say(id = "deviations-no-tables")]
    NoTables { folder: PathBuf },
}

/// Reads every `.tab` file of a folder, in the order of their names.
///
/// # Errors
/// [`OwnTablesError`] where the folder has no table of deviations, one of its tables is broken, or two contradict each
/// other: then none is used.
pub fn read_tables(folder: &Path) -> Result<OwnTables, OwnTablesError> {
    no_half_set(folder)?;
    let mut own = OwnTables::default();
    for path in files_of(folder)? {
        let name = files::name_of(&path).to_string_lossy();
        let file = path.display().to_string();
        let (table, warnings) = read_table(&read(&path)?, &name, &file, false)?;
        own.tables.extend(table);
        own.warnings.extend(warnings);
    }
    if own.tables.is_empty() {
        return Err(OwnTablesError::NoTables { folder: folder.to_owned() });
    }
    contradiction(&own.tables).map_or(Ok(own), |found| Err(found.into()))
}

fn files_of(folder: &Path) -> Result<Vec<PathBuf>, FileError> {
    let mut paths = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(|error| system(folder, &error))? {
        let path = entry.map_err(|error| system(folder, &error))?.path();
        let is_table = path.extension().is_some_and(|suffix| suffix.eq_ignore_ascii_case("tab"));
        if is_table && !path.is_dir() {
            paths.push(path);
        }
    }
    paths.sort();
    Ok(paths)
}
