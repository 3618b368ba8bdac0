//! Part plans from files of other tools: the characteristics that they declare become the features of a plan.
//!
//! Lengths that no cycle measures become features as well; what is no length is left out and said. What a file leaves open, such as hole or shaft, stays open and is a fault of
//! the plan until somebody fills it in.

use std::io::Cursor;

use fitcheck_core::length::{Length, Unit};
use fitcheck_core::message::{FilePlace, Located, Say as _};
use fitcheck_core::part::{
    Column, DEFAULT_CLEARANCE_HEIGHT, Document, DraftCell, DraftFeature, PlanError, PlanFault, PlanRemark,
};
use fitcheck_core::tolerance::Sources;

use super::characteristic::{Characteristic, CharacteristicKind, Characteristics};
use super::error::{ImportErrorKind, ImportWarningKind};
use super::imported::WhyUnjudged;
use super::plan_tables::{by_hand, signed};
use super::source::{ImportInputs, Source};
use super::{FORMATS, Mapping, of_mapping, plan_tables, samples, sheet_rows, words};

/// Reads a part plan of any known form: Fitcheck's own TOML or CSV, a workbook with the same columns, or the characteristics that a file of
/// AQDEF, QIF or CALYPSO declares. `given` hands over the file beside it where a format is two files.
///
/// ```
/// use fitcheck_exchange::exchange::{ImportInputs, read_plan};
/// use fitcheck_core::tolerance::Sources;
///
/// let sources = Sources::default();
/// let given = ImportInputs::new(&sources, jiff::civil::DateTime::default());
/// let document = read_plan("plan.csv", b"name;callout\nA1;25 H7\n", given)?;
/// assert_eq!(document.draft.rows.len(), 1);
/// # Ok::<(), fitcheck_core::part::PlanError>(())
/// ```
///
/// # Errors
/// [`PlanError`] where nothing of it can be read.
pub fn read_plan(file_name: &str, bytes: &[u8], given: ImportInputs<'_>) -> Result<Document, PlanError> {
    let refused = |kind: ImportErrorKind| Located {
        what: PlanFault::File { reason: kind.message() },
        place: FilePlace::default(),
    };
    if Document::is_own(bytes) {
        return Document::read(bytes);
    }
    if let Some(mapping) = given.mapping
        && !is_of_mapping(mapping, file_name, bytes)
    {
        let document = plan_tables::document(file_name, bytes, given).map_err(refused)?;
        return document.ok_or_else(|| refused(ImportErrorKind::NoRows));
    }
    if is_workbook(bytes) {
        let own = Document::of_rows(sheet_rows(bytes).map_err(refused)?);
        return or_of_table(own, file_name, bytes, given);
    }
    let mut body = Cursor::new(bytes);
    let mut source = Source::new(file_name, &mut body, given).map_err(refused)?;
    let format = FORMATS.iter().find(|format| (format.recognises)(&source.beginning()));
    let foreign = super::foreign::known(&source.beginning());
    if let Some(foreign) = foreign.filter(|_| format.is_none_or(|format| !format.has_marks)) {
        return Err(refused(foreign));
    }
    match format.and_then(|format| format.plan) {
        Some(declares) => {
            let mut found = Characteristics::default();
            declares(&mut source, &mut found).map_err(refused)?;
            Ok(document(found, given.sources))
        }
        None => or_of_table(Document::read(bytes), file_name, bytes, given),
    }
}

/// A plan with columns of its own, or else that of a table: one without callouts by that name, or with measured values.
fn or_of_table(
    own: Result<Document, PlanError>,
    file_name: &str,
    bytes: &[u8],
    given: ImportInputs<'_>,
) -> Result<Document, PlanError> {
    let is_own = own.as_ref().is_ok_and(|document| {
        let is_other = |problem: &PlanError| match &problem.what {
            PlanFault::NoColumn { column } => *column == "callout",
            PlanFault::UnknownColumn { column, .. } => words::role(column).is_some() || samples::is_one(column),
            _ => false,
        };
        !document.problems.iter().any(is_other)
    });
    if is_own {
        return own;
    }
    match plan_tables::document(file_name, bytes, given) {
        Ok(Some(document)) if !document.draft.rows.is_empty() => Ok(document),
        // The faults of a plan say more than those of a table that is none either.
        Ok(_) | Err(_) => own,
    }
}

/// Whether a mapping says the unit of a file that is no table.
fn is_of_mapping(mapping: &Mapping, file_name: &str, bytes: &[u8]) -> bool {
    of_mapping(mapping).iter().any(|format| format.plan.is_some() && format.recognises(bytes, file_name))
}

/// The endings of files that plans are read from.
pub const PLAN_ENDINGS: [&str; 8] = ["toml", "csv", "xlsx", "dfq", "dfd", "qif", "txt", "tsv"];

/// The mark of a zip archive, which a workbook is.
fn is_workbook(bytes: &[u8]) -> bool {
    bytes.starts_with(b"PK\x03\x04")
}

fn document(declared: Characteristics, sources: &Sources) -> Document {
    let mut document = Document::default();
    let Characteristics { found, refused, told, head, .. } = declared;
    let problem = |(line, kind): (usize, ImportErrorKind)| Located {
        what: PlanFault::File { reason: kind.message() },
        place: FilePlace::line(line),
    };
    document.problems.extend(refused.into_iter().map(problem));
    let said = |(line, kind): (usize, ImportWarningKind)| Located {
        what: PlanRemark::File { said: kind.message() },
        place: FilePlace::line(line),
    };
    document.remarks.extend(told.into_iter().map(said));
    let part =
        found.iter().map(|(_, characteristic)| characteristic.labels.part.as_str()).find(|part| !part.is_empty());
    head.write_into(&mut document.draft, part.unwrap_or(""));
    let mut has_told_axes = false;
    for (line, characteristic) in found {
        let mut remark = |what| document.remarks.push(Located { what, place: FilePlace::line(line) });
        let left = match &characteristic.what {
            CharacteristicKind::Size => {
                let row = row(&characteristic, line, sources, &mut remark);
                document.draft.rows.push(row);
                let labels = &characteristic.labels;
                if labels.is_axis_assumed && labels.place != [None; 3] && !std::mem::replace(&mut has_told_axes, true) {
                    document.remarks.push(Located { what: PlanRemark::AxesAssumed, place: FilePlace::line(line) });
                }
                continue;
            }
            CharacteristicKind::Quantity(quantity) => WhyUnjudged::Quantity { quantity: *quantity },
            CharacteristicKind::Length(why) => match by_hand(&characteristic.said()) {
                Some((kind, callout)) => {
                    let mut row = row(&characteristic, line, sources, &mut remark);
                    let cell = |text: String| DraftCell::at(text, FilePlace::line(line));
                    row.put(Column::Kind, cell(kind.to_owned()));
                    row.put(Column::Callout, cell(callout));
                    document.draft.rows.push(row);
                    continue;
                }
                None => why.clone(),
            },
            CharacteristicKind::Other(what) => WhyUnjudged::NotASize { what: what.clone() },
        };
        remark(PlanRemark::Left { name: characteristic.id(), why: left.message() });
    }
    document
}

/// The feature of a characteristic. A class counts where its limits are those of the file; otherwise the file's limits do.
fn row(
    characteristic: &Characteristic,
    line: usize,
    sources: &Sources,
    remark: &mut dyn FnMut(PlanRemark),
) -> DraftFeature {
    let mut row = DraftFeature::at(FilePlace::line(line));
    let mut set = |column, text: String| row.put(column, DraftCell::at(text, FilePlace::line(line)));
    set(Column::Number, characteristic.labels.number.clone());
    set(Column::Name, characteristic.id());
    let deviations = characteristic.nominal.zip(characteristic.minimum.zip(characteristic.maximum));
    let of_class = characteristic.callout().map(|callout| (callout, sources.limits(&callout, characteristic.feature)));
    let own = deviations.map(|(nominal, (minimum, maximum))| {
        let upper = maximum.saturating_sub(nominal);
        let lower = minimum.saturating_sub(nominal);
        format!("{nominal} {}/{}", signed(upper), signed(lower))
    });
    let callout = match (of_class, own) {
        (Some((callout, Ok(limits))), Some(own)) => {
            let given = (characteristic.minimum, characteristic.maximum);
            if given == (Some(limits.minimum()), Some(limits.maximum())) {
                callout.to_string()
            } else {
                let name = characteristic.id();
                let class = callout.to_string();
                remark(PlanRemark::ClassLeft { name, class });
                own
            }
        }
        // The other limit is none, or nobody wrote it down: that of the class would be a guess.
        (Some((callout, _)), None) if characteristic.minimum.is_some() || characteristic.maximum.is_some() => {
            remark(PlanRemark::ClassLeft { name: characteristic.id(), class: callout.to_string() });
            callout.nominal().to_string()
        }
        (Some((callout, _)), None) => callout.to_string(),
        (_, Some(own)) => own,
        (None, None) => characteristic.nominal.map_or_else(String::new, |nominal| nominal.to_string()),
    };
    let has_letters = callout.chars().any(char::is_alphabetic);
    set(Column::Callout, callout);
    if let Some(feature) = characteristic.feature().filter(|_| !has_letters) {
        set(Column::Feature, feature.word().to_owned());
    }
    for (column, length) in [Column::X, Column::Y, Column::Z].into_iter().zip(characteristic.labels.place) {
        if let Some(length) = length {
            set(column, length.to_string());
        }
    }
    // The probe moves above what it measures: a clearance height that nobody gave is no fault of the file.
    if let Some(z) = characteristic.labels.place.last().copied().flatten()
        && DEFAULT_CLEARANCE_HEIGHT <= z
        && let Some(height) = z.checked_add(DEFAULT_CLEARANCE_HEIGHT)
    {
        set(Column::ClearanceHeight, height.to_string());
        remark(PlanRemark::ClearanceRaised { name: characteristic.id(), height });
    }
    if let Some(why) = &characteristic.labels.no_place {
        remark(PlanRemark::PlaceLeft { name: characteristic.id(), why: why.message() });
    }
    // The standard uncertainty is half the expanded one, k = 2: of an odd number of nanometres it would be rounded.
    match characteristic.expanded.map(|expanded| (expanded, Length::from_nanometres(expanded.nanometres() / 2))) {
        Some((expanded, Ok(half))) if half.nanometres() * 2 == expanded.nanometres() => {
            set(Column::Uncertainty, half.exact(Unit::Micrometre, 0));
        }
        Some((expanded, _)) => remark(PlanRemark::UncertaintyLeft { name: characteristic.id(), expanded }),
        None => {}
    }
    row
}
