//! Files of measurements: read at once where it is certain which column is which, or remembered; asked about otherwise.

use std::io::Cursor;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::file_contents::{FileContents, With, bytes_of, name, whole};
use super::rows;
use super::working::Watched;
use crate::control::mask::Mask;
use crate::exchange::{self, Detected, FirstRows, ImportInputs, Imported, Item, MOST_ROWS, Mapping};
use crate::files;
use crate::journal::chain::Hash;
use crate::message::{Message, message};
use crate::session::help::Sample;
use crate::session::parts::WalkCommand;
use crate::session::statistics::{StudyCommand, StudyFile};
use crate::session::{
    CheckCommand, ColumnsCommand, ColumnsRequest, Command, ImportInto, RowsCommand, StatisticsCommand, UnitLess,
    UsedColumns, refusal,
};

/// A file with its beginning, where it is read by its columns.
struct Looked {
    path: PathBuf,
    name: String,
    into: ImportInto,
    bytes: Vec<u8>,
    sha256: Option<Hash>,
    first: Option<FirstRows>,
}

/// What is known of the columns of a file.
struct Known {
    detected: Detected,
    /// The mapping that it is read with; `None` where it is read as ever.
    mapping: Option<Mapping>,
    /// The shape and the day of a mapping that was remembered.
    remembered: Option<(String, String)>,
}

/// Reads measurements: with these columns, else with those that are remembered, else with those that are certain.
pub(super) fn read(into: ImportInto, path: PathBuf, mapping: Option<&Mapping>, with: With<'_>) -> FileContents {
    if let Some(command) = large(into, &path, mapping.is_some(), with) {
        return FileContents { before: None, command, sha256: None };
    }
    let mut looked = match Looked::new(into, path, FirstRows::of) {
        Ok(looked) => looked,
        Err((name, problem)) => return taken(into, name, Err(problem)),
    };
    if !masks_of(&looked.name, &looked.bytes, mapping, with).is_empty() {
        return looked.import(None, None, with);
    }
    let takes_unit = takes_unit(&looked.name, &looked.bytes, with);
    if takes_unit && mapping.is_some_and(Mapping::says_unit_alone) {
        return looked.import(mapping, None, with);
    }
    if mapping.is_some() {
        looked.first = FirstRows::of_columns(&looked.name, &looked.bytes);
    }
    let Some(first) = &looked.first else { return looked.import(mapping, None, with) };
    let known = match mapping {
        Some(mapping) => first.detect(mapping).ok().map(|detected| Known {
            detected,
            mapping: Some(mapping.clone()),
            // It was remembered when it was chosen.
            remembered: with.columns.find(first).map(|(shape, kept, _)| (shape.to_owned(), kept.day().to_owned())),
        }),
        None => known(into, first, with),
    };
    match (known, mapping) {
        (Some(known), _) => {
            let mapping = known.mapping.clone();
            looked.import(mapping.as_ref(), Some(known), with)
        }
        (None, Some(_)) => looked.import(mapping, None, with),
        (None, None) if !first.has_numbers() => looked.import(None, None, with),
        (None, None) => looked.ask(false, with),
    }
}

/// Reads the beginning of a file whose columns the user wants to see.
pub(super) fn ask(into: ImportInto, path: PathBuf, with: With<'_>) -> FileContents {
    if let Some(command) = large(into, &path, true, with) {
        return FileContents { before: None, command, sha256: None };
    }
    match Looked::new(into, path, FirstRows::of_columns) {
        Ok(looked) if looked.first.is_some() => looked.ask(true, with),
        Ok(looked) => {
            let problem = message!("columns-page-none").text("name", &looked.name);
            taken(into, looked.name, Err(problem))
        }
        Err((name, problem)) => taken(into, name, Err(problem)),
    }
}

/// The columns of a file that need no question.
fn known(into: ImportInto, first: &FirstRows, with: With<'_>) -> Option<Known> {
    if let Some((shape, kept, mapping)) = with.columns.find(first) {
        let detected = first.detect(&mapping).ok()?;
        let remembered = Some((shape.to_owned(), kept.day().to_owned()));
        return Some(Known { detected, mapping: Some(mapping), remembered });
    }
    let detected = first.detect(&Mapping::default()).ok()?;
    let is_certain = detected.knows_all() && refusal(into, |role| detected.has(role)).is_none();
    is_certain.then_some(Known { detected, mapping: None, remembered: None })
}

/// What is said of a file that is too large for the history; its rows are judged without a mapping.
fn large(into: ImportInto, path: &Path, is_mapped: bool, with: With<'_>) -> Option<Command> {
    if into != ImportInto::History || Sample::bytes_at(path).is_some() {
        return None;
    }
    let name = name(path);
    let large = match rows::large(path) {
        Ok(large) => large?,
        Err(problem) => return Some(RowsCommand::Opened { name, result: Err(problem) }.into()),
    };
    let is_remembered = || {
        let head = files::read_head(path, 1 << 20).ok().and_then(|head| FirstRows::of(&name, &head));
        head.is_some_and(|first| with.columns.find(&first).is_some())
    };
    let result = if is_mapped || is_remembered() {
        Err(message!("columns-page-large").text("name", &name))
    } else {
        Ok((path.to_owned(), large))
    };
    Some(RowsCommand::Opened { name, result }.into())
}

/// What could not be read, said by whoever waits for it.
fn taken(into: ImportInto, name: String, result: Result<std::convert::Infallible, Message>) -> FileContents {
    let Err(problem) = result;
    let command = match into {
        ImportInto::History => CheckCommand::Imported { name, result: Err(problem) }.into(),
        ImportInto::Part(run) => WalkCommand::Imported { run, name, result: Err(problem) }.into(),
        ImportInto::Study => StatisticsCommand::Study(StudyCommand::Read { name, result: Err(problem) }).into(),
    };
    FileContents { before: None, command, sha256: None }
}

impl Looked {
    fn new(
        into: ImportInto,
        path: PathBuf,
        first: fn(&str, &[u8]) -> Option<FirstRows>,
    ) -> Result<Self, (String, Message)> {
        let name = name(&path);
        let mut sha256 = None;
        match bytes_of(&path, &mut sha256) {
            Ok(bytes) => Ok(Self { first: first(&name, &bytes), path, name, into, bytes, sha256 }),
            Err(problem) => Err((name, problem)),
        }
    }

    /// Its columns are asked about.
    fn ask(self, is_wanted: bool, with: With<'_>) -> FileContents {
        let Self { path, name, into, sha256, first, .. } = self;
        let Some(first) = first else { return FileContents { before: None, command: Command::Picked(None), sha256 } };
        // A file of a new shape begins without any column.
        let mapping = with.columns.find(&first).map_or_else(Mapping::default, |(.., mapping)| mapping);
        let asked = ColumnsRequest { name, path, into, first, mapping, is_wanted };
        FileContents { before: None, command: ColumnsCommand::Ask(Box::new(asked)).into(), sha256: None }
    }

    fn import(self, mapping: Option<&Mapping>, known: Option<Known>, with: With<'_>) -> FileContents {
        let Self { path, name, into, bytes, sha256, .. } = self;
        let takes_unit = mapping.is_none() && takes_unit(&name, &bytes, with);
        let unit_less = || {
            let file = UnitLess { name: name.clone(), path: path.clone(), into };
            Command::from(ColumnsCommand::UnitLess(Box::new(file)))
        };
        let used = known.map(|Known { detected, remembered, .. }| {
            let used = UsedColumns { name: name.clone(), path: path.clone(), into, detected, remembered };
            ColumnsCommand::Used(Box::new(used)).into()
        });
        let (command, lacks_unit) = match into {
            ImportInto::History => {
                let result = import(&path, bytes, mapping, with);
                let lacks_unit = result.as_ref().is_ok_and(|read| read.lacks_unit());
                (CheckCommand::Imported { result, name: name.clone() }.into(), lacks_unit)
            }
            ImportInto::Part(run) => {
                let result = items(into, &path, bytes, mapping, with);
                let lacks_unit = result.as_ref().is_ok_and(|items| items.iter().any(Item::lacks_unit));
                (WalkCommand::Imported { run, result, name: name.clone() }.into(), lacks_unit)
            }
            ImportInto::Study => {
                let result = items(into, &path, bytes, mapping, with);
                let lacks_unit = result.as_ref().is_ok_and(|items| items.iter().any(Item::lacks_unit));
                let result = result.map(|items| Arc::new(StudyFile::of(&name, &items)));
                (StatisticsCommand::Study(StudyCommand::Read { name: name.clone(), result }).into(), lacks_unit)
            }
        };
        let before = used.or_else(|| (takes_unit && lacks_unit).then(unit_less));
        FileContents { before, command, sha256 }
    }
}

/// Whether a mapping of the unit alone may say the unit of a file.
fn takes_unit(name: &str, bytes: &[u8], with: With<'_>) -> bool {
    let format = exchange::recognised(name, &mut Cursor::new(bytes), with.masks).ok().flatten();
    format.is_some_and(exchange::Format::takes_unit)
}

/// The user's own mask, where it seems to have printed a file; chosen columns are those of a table.
fn masks_of<'a>(name: &str, bytes: &[u8], mapping: Option<&Mapping>, with: With<'a>) -> &'a [(String, Mask)] {
    let format = exchange::recognised(name, &mut Cursor::new(bytes), with.masks).ok().flatten();
    format.filter(|_| mapping.is_none()).map_or(&[], |format| format.masks_of(with.masks))
}

fn import(path: &Path, bytes: Vec<u8>, mapping: Option<&Mapping>, with: With<'_>) -> Result<Box<Imported>, Message> {
    let job = (with.begins)(path, false);
    job.has(bytes.len());
    let beside = |ending: &str| files::beside(path, ending);
    let masks = masks_of(&name(path), &bytes, mapping, with);
    let temperature = with.temperature;
    let given =
        ImportInputs { beside: &beside, mapping, masks, temperature, ..ImportInputs::new(with.sources, with.now) };
    let mut body = Cursor::new(bytes);
    let imported = exchange::import_given(&name(path), &mut Watched::new(&mut body, &job), given);
    whole(Box::new(imported), &job)
}

/// Everything that a file holds, one after the other: a plan judges the values of a part later.
fn items(
    into: ImportInto,
    path: &Path,
    bytes: Vec<u8>,
    mapping: Option<&Mapping>,
    with: With<'_>,
) -> Result<Vec<Item>, Message> {
    let job = (with.begins)(path, false);
    job.has(bytes.len());
    let beside = |ending: &str| files::beside(path, ending);
    let usual = ImportInputs::new(with.sources, with.now);
    let masks = masks_of(&name(path), &bytes, mapping, with);
    let given = ImportInputs {
        beside: &beside,
        mapping,
        masks,
        most_rows: MOST_ROWS,
        has_plan: matches!(into, ImportInto::Part(_)),
        temperature: with.temperature,
        ..usual
    };
    let mut items = Vec::new();
    let mut body = Cursor::new(bytes);
    exchange::import_from(&name(path), &mut Watched::new(&mut body, &job), given, &mut |item| {
        if item.is_row() {
            job.row();
        }
        items.push(item);
    });
    whole(items, &job)
}
