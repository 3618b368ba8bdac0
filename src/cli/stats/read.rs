//! The values of the files: what cannot be read is told.

use std::path::{Path, PathBuf};

use crate::cli::measured::{Measured, unreadable};
use crate::cli::{CliRemark, Io, import, now};
use crate::exchange::{ByPlan, ImportInputs, Item, Mapping, import_from};
use crate::files;
use crate::part::Plan;
use crate::series::{Value, ValueReader};
use crate::tolerance::Sources;

/// What was read.
#[derive(Debug, Default)]
pub(super) struct Read {
    pub(super) values: Vec<Value>,
    /// Whether a row or a file could not be read.
    pub(super) has_failed: bool,
}

/// Reads all files; what cannot be read is told.
pub(super) fn read(
    paths: &[PathBuf],
    sources: &Sources,
    mapping: Option<&Mapping>,
    plan: Option<&Plan>,
    io: &mut Io<'_>,
) -> Read {
    crate::cli::io::warn_of_repeats(paths, io);
    let mut read = Read::default();
    let by_plan = plan.map(ByPlan::new);
    for path in paths {
        let file = match Measured::open(path) {
            Ok(file) => file,
            Err(error) => {
                io.fail(&error);
                read.has_failed = true;
                continue;
            }
        };
        let beside = |ending: &str| files::beside(path, ending);
        let given =
            ImportInputs { beside: &beside, mapping, has_plan: plan.is_some(), ..ImportInputs::new(sources, now()) };
        let name = files::name_of(path).to_string_lossy();
        let mut reader = ValueReader::default();
        let mut take_one = |item: Item| read.take(path, item, &mut reader, io);
        let mut take = |item: Item| match &by_plan {
            Some(by_plan) => by_plan.item(item, &mut take_one),
            None => take_one(item),
        };
        file.read(|body| import_from(&name, body, given, &mut take));
    }
    read
}

impl Read {
    /// Takes what a file holds.
    fn take(&mut self, path: &Path, item: Item, reader: &mut ValueReader, io: &mut Io<'_>) {
        import::warn(path, &item, io);
        if let Some(error) = unreadable(path, &item) {
            io.fail(&error);
        }
        let value = reader.take(&item);
        let is_value = value.is_some();
        self.values.extend(value);
        let place = |line: usize| format!("{}:{line}", path.display());
        match item {
            Item::Record { line, record, .. } => {
                if let Some(doubt) = &record.doubt {
                    io.tell(format_args!("{}: warning: {doubt}", place(line)));
                }
            }
            Item::Unjudged(unjudged) => {
                if !is_value {
                    io.tell(format_args!("{}: {}", place(unjudged.line), unjudged.why));
                    self.has_failed = true;
                }
            }
            Item::Error(error) => {
                io.tell(format_args!("{}: {}", place(error.place.line.unwrap_or(1)), error.what.kind));
                self.has_failed = true;
            }
            Item::Warning(warning) => {
                if let Some(line) = warning.what.row {
                    io.tell(format_args!("{}: warning: {}", place(line), warning.what.kind));
                }
            }
            Item::Contacts(_) => {
                io.note(format_args!("{}: {}", path.display(), CliRemark::NoColumns));
                self.has_failed = true;
            }
        }
    }
}
