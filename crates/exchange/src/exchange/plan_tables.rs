//! Part plans from tables: each row that says what a size should be is a feature. What is missing in a row is missing in its feature, and
//! is a fault of the plan until somebody fills it in.

use std::collections::HashMap;
use std::sync::Arc;

use csv::StringRecord;
use fitcheck_core::length::Length;
use fitcheck_core::message::{FilePlace, Located, Say as _};
use fitcheck_core::part::{Column, Document, DraftCell, DraftFeature, PlanFault, PlanRemark};
use fitcheck_core::tolerance::{Callout, Deviations, Feature};

use super::cell::{Cells as _, joined};
use super::columns::Columns;
use super::delimited::{Item, Rows, lines, without_separator_line};
use super::error::ImportErrorKind;
use super::given::shorten;
use super::imported::{StatedLimits, WhyUnjudged};
use super::index::LONGEST_ROW;
use super::mapping::{FirstRows, Mapping};
use super::quantity::{self, Quantity};
use super::rules::Rules;
use super::source::{ImportInputs, decode};
use super::{cells, sheet_rows};

/// The plan of a table; `None` where it does not say what anything should be.
///
/// # Errors
/// Why its columns are not known.
pub(super) fn document(file: &str, bytes: &[u8], given: ImportInputs<'_>) -> Result<Option<Document>, ImportErrorKind> {
    let open = Mapping::default();
    let mapping = given.mapping.unwrap_or(&open);
    let Some(first) = FirstRows::of_columns(file, bytes) else { return Ok(None) };
    let (columns, separator) = first.planned(mapping)?;
    if columns.tolerance.is_none() && columns.limits.is_none() && columns.nominal.is_none() {
        return Ok(None);
    }
    let mut table = Table {
        columns: &columns,
        given,
        file: file.into(),
        document: Document::default(),
        part: String::new(),
        others: HashMap::new(),
    };
    let rows = all_rows(bytes, &columns, separator, &mut |line, reason| {
        let what = PlanFault::File { reason: reason.message() };
        table.document.problems.push(Located { what, place: FilePlace::line(line) });
    })?;
    let begins = columns.stated.first().max(columns.header.map_or(0, |header| header + 1));
    for (line, row) in
        rows.iter().filter(|(line, row)| begins <= *line && !cells::is_blank(row) && !cells::is_comment(row))
    {
        table.row(*line, row);
    }
    Ok(Some(table.whole()))
}

/// The rows of a text or of a workbook, with their lines; what cannot be split into rows goes to `refuse`.
fn all_rows(
    bytes: &[u8],
    columns: &Columns,
    separator: u8,
    refuse: &mut dyn FnMut(usize, ImportErrorKind),
) -> Result<Vec<(usize, StringRecord)>, ImportErrorKind> {
    if bytes.starts_with(b"PK") {
        let rows = sheet_rows(bytes)?;
        return Ok(rows.into_iter().map(|(line, cells)| (line, cells.into_iter().collect())).collect());
    }
    let decoded = decode(bytes);
    let (text, first_line, _) = without_separator_line(&decoded);
    let mut refused = |line: usize, reason: ImportErrorKind| {
        refuse(line, reason);
        None
    };
    let row = |item: Item<'_>| match item {
        Item::Lines { line, text, cells } if columns.hides_rows(&cells, separator) => {
            for (within, ..) in lines(text, 0, line).skip(1) {
                refused(within, ImportErrorKind::WithinQuotes);
            }
            refused(line, ImportErrorKind::OpenQuote)
        }
        Item::Row { line, cells } | Item::Lines { line, cells, .. } => Some((line, cells)),
        Item::OpenQuote { line, .. } => refused(line, ImportErrorKind::OpenQuote),
        Item::TooLong { line } => refused(line, ImportErrorKind::RowTooLong { most: LONGEST_ROW >> 10 }),
    };
    Ok(Rows::new(text, first_line, separator).filter_map(row).collect())
}

/// A table whose rows become features.
struct Table<'a> {
    columns: &'a Columns,
    given: ImportInputs<'a>,
    file: Arc<str>,
    document: Document,
    /// The part of the first row that names one.
    part: String,
    /// Which of its features are no sizes, and what their rows say of them.
    others: HashMap<usize, String>,
}

impl Table<'_> {
    fn row(&mut self, line: usize, row: &StringRecord) {
        let columns = self.columns;
        let has_commas = false;
        let rules =
            Rules { columns, has_commas, sources: self.given.sources, lookup: None, has_plan: false, file: &self.file };
        let text = |at: Option<usize>| row.cell(at).trim();
        let name = text(columns.id);
        let number = text(columns.labels.number);
        if self.part.is_empty() {
            text(columns.labels.part).clone_into(&mut self.part);
        }
        let quantity = quantity::of_row(&columns.quantities, row);
        if let Some((_, what, _)) = quantity.as_ref().filter(|(_, _, of)| !of.is_size()) {
            let asked = rules.asked_of_other(row).ok().and_then(|said| by_hand(&said));
            let Some((kind, callout)) = asked else { return self.leave(FilePlace::line(line), name, shorten(what)) };
            let at = self.document.draft.rows.len();
            if self.feature(line, row, (&callout, Some(kind)), None) {
                self.others.insert(at, shorten(what));
            }
            return;
        }
        let (callout, kind) = match rules.planned(row) {
            Ok((Some(callout), _)) => (callout.to_string(), None),
            Ok((None, said)) => match by_hand(&said).filter(|_| said.nominal == Some(Length::ZERO)) {
                Some((kind, callout)) => (callout, Some(kind)),
                None => (of_limits(&said), None),
            },
            // As it is written, so that the plan says what is wrong with it.
            Err(_) => (text(columns.tolerance).to_owned(), None),
        };
        let has_numbers = cells::has_number(row);
        if callout.is_empty() && (!has_numbers || name.is_empty() && number.is_empty()) {
            let why = WhyUnjudged::NoCallout.message();
            let remark = PlanRemark::Left { name: shorten(&joined(row)), why };
            return self.document.remarks.push(Located { what: remark, place: FilePlace::line(line) });
        }
        let says_side = callout.parse::<Callout>().is_ok_and(|callout| callout.feature().is_some());
        let (kind, side) = match columns.feature_of(row).filter(|_| !says_side) {
            _ if kind.is_some() => (kind, None),
            Some(side) => (None, Some(side)),
            // A distance may be neither; a groove or a tongue is written in the plan.
            None if !says_side && matches!(quantity, Some((_, _, Quantity::Width))) => (Some("length"), None),
            None => (None, None),
        };
        self.feature(line, row, (&callout, kind), side);
    }

    /// Says that no feature comes of what is no size.
    fn leave(&mut self, place: FilePlace, name: &str, what: String) {
        let what = PlanRemark::Left { name: name.to_owned(), why: WhyUnjudged::NotASize { what }.message() };
        self.document.remarks.push(Located { what, place });
    }

    /// Adds a feature, unless it is of another part, or the same one measured again.
    fn feature(
        &mut self,
        line: usize,
        row: &StringRecord,
        (callout, kind): (&str, Option<&str>),
        side: Option<Feature>,
    ) -> bool {
        let columns = self.columns;
        let text = |at: Option<usize>| row.cell(at).trim();
        let cells = [
            (Column::Number, text(columns.labels.number)),
            (Column::Name, text(columns.id)),
            (Column::Callout, callout),
            (Column::Kind, kind.unwrap_or("")),
        ];
        let is_known = |feature: &DraftFeature| {
            cells.iter().all(|(column, text)| feature.text(*column).map_or("", |known| known) == *text)
        };
        if self.document.draft.rows.iter().any(is_known) {
            return false;
        }
        let place = FilePlace::line(line);
        let mut feature = DraftFeature::at(place.clone());
        let mut set = |column: Column, text: &str| {
            if !text.is_empty() {
                feature.put(column, DraftCell::at(text.to_owned(), place.clone()));
            }
        };
        for (column, text) in cells {
            set(column, text);
        }
        set(Column::Feature, side.map_or("", Feature::word));
        for (column, at) in [Column::X, Column::Y, Column::Z].into_iter().zip(columns.labels.place) {
            let Some(at) = at else { continue };
            let length = cells::length(text(Some(at.at)), columns.stated.of_place(at, row)).ok();
            set(column, &length.map_or_else(|| text(Some(at.at)).to_owned(), |length| length.to_string()));
        }
        self.document.draft.rows.push(feature);
        true
    }

    /// Leaves out what has the name of a size, or of another quantity: a plan knows its features by their names.
    fn leave_of_other_names(&mut self) {
        let rows = std::mem::take(&mut self.document.draft.rows);
        let name = |row: &DraftFeature| row.text(Column::Name).unwrap_or(row.said(Column::Number)).to_owned();
        let mut counts: HashMap<String, usize> = HashMap::new();
        for row in &rows {
            *counts.entry(name(row)).or_default() += 1;
        }
        for (at, row) in rows.into_iter().enumerate() {
            let name = name(&row);
            match self.others.remove(&at).filter(|_| counts.get(&name).is_some_and(|count| 1 < *count)) {
                Some(what) => self.leave(row.place.clone(), &name, what),
                None => self.document.draft.rows.push(row),
            }
        }
    }

    /// The plan with what the head of the table says.
    fn whole(mut self) -> Document {
        self.leave_of_other_names();
        let Self { columns, mut document, part, .. } = self;
        columns.head.write_into(&mut document.draft, &part);
        document
    }
}

/// The callout of limits in columns: as deviations from the nominal size, or as two sizes; what is missing is left out.
fn of_limits(said: &StatedLimits) -> String {
    match (said.nominal, said.minimum, said.maximum) {
        (Some(nominal), Some(minimum), Some(maximum)) => {
            let upper = maximum.saturating_sub(nominal);
            let lower = minimum.saturating_sub(nominal);
            let callout =
                Deviations::new(upper, lower).ok().and_then(|both| Callout::with_deviations(nominal, both).ok());
            callout
                .map_or_else(|| format!("{nominal} {}/{}", signed(upper), signed(lower)), |callout| callout.to_string())
        }
        (None, Some(minimum), Some(maximum)) => format!("{maximum}/{minimum}"),
        (Some(nominal), ..) => nominal.to_string(),
        (None, ..) => String::new(),
    }
}

/// Kind and callout of what no cycle measures; `None` without the limits that its kind has.
pub(super) fn by_hand(said: &StatedLimits) -> Option<(&'static str, String)> {
    let StatedLimits { nominal, minimum, maximum } = *said;
    let is_zero = |length: Option<Length>| length.is_none_or(|length| length == Length::ZERO);
    let maximum = maximum.filter(|maximum| Length::ZERO < *maximum)?;
    if is_zero(nominal) && is_zero(minimum) {
        return Some(("form", maximum.to_string()));
    }
    let nominal = nominal.filter(|nominal| Length::ZERO < *nominal)?;
    let [upper, lower] = [maximum, minimum?].map(|limit| signed(limit.saturating_sub(nominal)));
    Some(("length", format!("{nominal} {upper}/{lower}")))
}

/// A deviation with its sign, as callouts have it.
pub(super) fn signed(deviation: Length) -> String {
    if Length::ZERO < deviation { format!("+{deviation}") } else { deviation.to_string() }
}
