//! A row of what `fitcheck import` prints: a record, a measurement that makes none, or an error.

use std::path::Path;
use std::sync::Arc;

use crate::cli::admitted::Admits;
use crate::cli::judging::{Judge, Sizes};
use crate::cli::{CliRemark, CliWarning};
use crate::exchange::{ImportError, Item, Labels, Unjudged, WhyUnjudged};
use crate::files;
use crate::journal::Record;
use crate::length::Length;
use crate::message::Located;
use crate::part::{Plan, Size};
use crate::tolerance::{Deviations, Source};
use crate::verdict::{PositionVerdict, Status};

/// What a row is.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(in crate::cli) enum RowKind {
    /// It cannot be read.
    #[default]
    Refused,
    /// Something was measured, with a figure or without.
    Measured,
    /// A size of a plan that nothing measured.
    Missing,
}

/// What is known of one row of a file.
#[derive(Debug, Clone, Default, PartialEq)]
pub(in crate::cli) struct ImportRow {
    pub(in crate::cli) file: Arc<str>,
    /// Its line; `None` where the file could not be read.
    pub(in crate::cli) line: Option<usize>,
    /// Where an error is in its line.
    pub(in crate::cli) column: Option<usize>,
    pub(in crate::cli) id: String,
    pub(in crate::cli) callout: Option<String>,
    pub(in crate::cli) nominal: Option<Length>,
    pub(in crate::cli) minimum: Option<Length>,
    pub(in crate::cli) maximum: Option<Length>,
    pub(in crate::cli) measured: Option<Length>,
    pub(in crate::cli) deviation: Option<Length>,
    /// The diameter's status.
    pub(in crate::cli) status: Option<Status>,
    /// To the nearest limit.
    pub(in crate::cli) remove: Option<Length>,
    pub(in crate::cli) position: Option<PositionVerdict>,
    pub(in crate::cli) source: Option<Arc<str>>,
    pub(in crate::cli) warnings: Vec<String>,
    /// Whether one of them asks somebody to look before the verdict counts.
    pub(in crate::cli) wants_a_look: bool,
    pub(in crate::cli) error: Option<String>,
    pub(in crate::cli) kind: RowKind,
    /// What its file says of it besides its name.
    pub(in crate::cli) labels: Labels,
    /// Whether nobody measured its value; `None` where it has none.
    pub(in crate::cli) is_simulated: Option<bool>,
    /// The check, where it is wanted or has more to say than a control.
    pub(in crate::cli) judged: Option<Arc<Record>>,
    /// Whether hole or shaft decides between rework and scrap.
    pub(in crate::cli) is_open: bool,
}

/// So many sources are remembered; others are put into words each time.
const MOST_SOURCES: usize = 100;

/// Makes the rows of a file from what is read from it.
pub(in crate::cli) struct Rows<'a> {
    judge: &'a Judge,
    /// Whether the check of a row is wanted even where it has no more to say than a control.
    wants_checks: bool,
    /// The sizes of the plan.
    sizes: Sizes<'a>,
    /// The path as the user gave it.
    path: Arc<str>,
    /// The name without its folder.
    name: Arc<str>,
    /// Where limits came from so far, in words.
    sources: Vec<(Source, Arc<str>)>,
    /// The line of the row that comes next, the warnings about it, and whether one of them asks somebody to look.
    warnings: (usize, Vec<String>, bool),
}

impl<'a> Rows<'a> {
    pub(in crate::cli) fn of(path: &Path, judge: &'a Judge, wants_checks: bool) -> Self {
        let name = files::name_of(path).to_string_lossy().as_ref().into();
        let path = path.display().to_string().into();
        let sizes = Sizes::default();
        Self { judge, wants_checks, sizes, path, name, sources: Vec::new(), warnings: (0, Vec::new(), false) }
    }

    /// The same of values that a plan has judged.
    pub(in crate::cli) fn by(self, plan: Option<&'a Plan>) -> Self {
        Self { sizes: Sizes::of(plan), ..self }
    }

    /// The row of what was read; none for a warning, which goes to the row that follows, and for contacts, which have
    /// had theirs.
    pub(in crate::cli) fn row(&mut self, item: Item) -> Option<ImportRow> {
        let (line, mut row) = match item {
            Item::Record { line, record, labels } => (line, self.record(record, labels)),
            Item::Unjudged(unjudged) => {
                let mut row = ImportRow::of_unjudged(&unjudged);
                if row.status.is_some() && !self.judge.is_plain() {
                    row.warns(&CliWarning::LimitsAlone);
                }
                (unjudged.line, row)
            }
            Item::Error(error) => (error.place.line.unwrap_or(1), ImportRow::of_error(&error)),
            Item::Warning(warning) => {
                let line = warning.what.row?;
                if self.warnings.0 != line {
                    self.warnings = (line, Vec::new(), false);
                }
                self.warnings.1.push(warning.what.kind.to_string());
                self.warnings.2 |= warning.what.kind.wants_a_look();
                return None;
            }
            Item::Contacts(_) => return None,
        };
        row.file = Arc::clone(&self.path);
        row.line = Some(line);
        // A coordinate's limits come from its log.
        if row.minimum.is_some() && row.source.is_none() {
            row.source = Some(self.said(&Source::File(Arc::clone(&self.name))));
        }
        if self.warnings.0 == line {
            row.warnings.append(&mut self.warnings.1);
            row.wants_a_look |= self.warnings.2;
        }
        Some(row)
    }
}

impl Rows<'_> {
    /// Where limits come from, in words. Rows of one file have few sources.
    fn said(&mut self, source: &Source) -> Arc<str> {
        if let Some((_, said)) = self.sources.iter().find(|(known, _)| known == source) {
            return Arc::clone(said);
        }
        let said: Arc<str> = source.to_string().into();
        if self.sources.len() < MOST_SOURCES {
            self.sources.push((source.clone(), Arc::clone(&said)));
        }
        said
    }

    /// The row of a record, as the judge of this import says.
    fn record(&mut self, record: Box<Record>, labels: Labels) -> ImportRow {
        let source = Some(self.said(&record.limits.source));
        if self.judge.keeps() && self.sizes.is_empty() {
            let row = ImportRow { source, labels, ..ImportRow::of(&record) };
            let is_wanted = self.wants_checks || record.correction.is_some();
            return ImportRow { judged: is_wanted.then(|| Arc::from(record)), ..row };
        }
        let id = record.id.clone();
        let measured = Some(record.measurement.diameter);
        let is_simulated = Some(record.measurement.origin.is_simulated());
        match self.judge.judged_of(&self.sizes, *record, &labels) {
            Ok((record, said)) => {
                let mut row = ImportRow { source, labels, ..ImportRow::of(&record) };
                row.warnings.extend(said.iter().map(ToString::to_string));
                ImportRow { judged: Some(Arc::new(record)), ..row }
            }
            Err(error) => {
                let error = Some(error.to_string());
                ImportRow { id, labels, measured, kind: RowKind::Measured, is_simulated, error, ..ImportRow::default() }
            }
        }
    }
}

impl ImportRow {
    fn of(record: &Record) -> Self {
        let limits = &record.limits;
        let size = record.verdict.size;
        let mut row = Self::default();
        record.doubt.iter().for_each(|doubt| row.warns(doubt));
        if record.measurement.origin.is_simulated() {
            row.warnings.push(CliRemark::Simulated.to_string());
            row.wants_a_look = true;
        }
        record.budget.iter().flat_map(|budget| &budget.warnings).for_each(|warning| row.warns(warning));
        if let Source::Table { instead_of: Some(standard), .. } = &limits.source {
            row.warnings.push(differs(*standard));
        }
        Self {
            is_open: record.is_open(),
            id: record.id.clone(),
            callout: record.callout.map(|callout| callout.to_string()),
            nominal: Some(limits.nominal),
            minimum: Some(limits.minimum()),
            maximum: Some(limits.maximum()),
            measured: Some(record.measurement.diameter),
            kind: RowKind::Measured,
            deviation: Some(size.deviation),
            status: Some(size.status),
            remove: size.removal.map(|removal| removal.to_limit),
            position: record.verdict.position,
            is_simulated: Some(record.measurement.origin.is_simulated()),
            ..row
        }
    }

    /// What is said of it.
    fn warns(&mut self, what: &impl Admits) {
        self.warnings.push(what.message().to_string());
        self.wants_a_look |= what.wants_a_look();
    }

    fn of_unjudged(unjudged: &Unjudged) -> Self {
        let row = Self {
            id: unjudged.id.clone(),
            measured: unjudged.measured,
            kind: RowKind::Measured,
            position: unjudged.position,
            is_simulated: unjudged.measured.map(|_| unjudged.origin.is_simulated()),
            ..Self::default()
        };
        match &unjudged.why {
            WhyUnjudged::Coordinate(coordinate)
            | WhyUnjudged::Point(coordinate)
            | WhyUnjudged::Size { judged: coordinate, .. } => Self {
                nominal: coordinate.nominal,
                minimum: Some(coordinate.minimum),
                maximum: Some(coordinate.maximum),
                deviation: coordinate.nominal.and_then(|nominal| Some(unjudged.measured?.saturating_sub(nominal))),
                status: Some(coordinate.status),
                remove: coordinate.removal.map(|removal| removal.to_limit),
                warnings: vec![unjudged.why.to_string()],
                ..row
            },
            WhyUnjudged::NoLimits { nominal } => Self {
                nominal: Some(*nominal),
                deviation: unjudged.measured.map(|measured| measured.saturating_sub(*nominal)),
                error: Some(unjudged.why.to_string()),
                ..row
            },
            WhyUnjudged::NoCallout
            | WhyUnjudged::NotPositive { .. }
            | WhyUnjudged::OneLimit
            | WhyUnjudged::NotInPlan(_)
            | WhyUnjudged::SwappedLimits { .. }
            | WhyUnjudged::Rounded { .. }
            | WhyUnjudged::Implausible { .. }
            | WhyUnjudged::NoTolerance
            | WhyUnjudged::NotASize { .. }
            | WhyUnjudged::CoordinateWithoutLimits
            | WhyUnjudged::SizeWithoutLimits { .. }
            | WhyUnjudged::PointWithoutTolerance
            | WhyUnjudged::Quantity { .. }
            | WhyUnjudged::Kind { .. }
            | WhyUnjudged::Attribute { .. }
            | WhyUnjudged::NotValid { .. }
            | WhyUnjudged::Declaration { .. }
            | WhyUnjudged::Contacts { .. } => Self { error: Some(unjudged.why.to_string()), ..row },
        }
    }

    /// The row for a size of a plan without a value; `who` is its part, empty where there is one alone.
    pub(in crate::cli) fn missing(plan: &Path, size: &Size<'_>, who: &str) -> Self {
        let error = if who.is_empty() {
            CliWarning::PlanNoValue.to_string()
        } else {
            CliWarning::PlanNoValueOf { who: who.to_owned() }.to_string()
        };
        Self {
            file: plan.display().to_string().into(),
            line: size.feature.line,
            id: size.name(),
            callout: size.callout.map(|callout| callout.to_string()),
            nominal: Some(size.limits.nominal),
            minimum: Some(size.limits.minimum()),
            maximum: Some(size.limits.maximum()),
            error: Some(error),
            kind: RowKind::Missing,
            ..Self::default()
        }
    }

    fn of_error(error: &Located<ImportError>) -> Self {
        Self { column: error.place.column, error: Some(error.what.kind.to_string()), ..Self::default() }
    }

    /// The row for what stands against the values of a file, and of none of its rows alone.
    pub(in crate::cli) fn against(path: &Path, item: &Item) -> Option<Self> {
        let Item::Warning(Located { what: warning, place }) = item else { return None };
        let file = path.display().to_string().into();
        let row = || Self { file, line: place.line, warnings: vec![warning.kind.to_string()], ..Self::default() };
        (warning.row.is_none() && warning.kind.wants_a_look()).then(row)
    }

    /// The row for a file that could not be read at all.
    pub(in crate::cli) fn of_file(path: &Path, error: String) -> Self {
        Self { file: path.display().to_string().into(), error: Some(error), ..Self::default() }
    }

    /// The part's status: also scrap where its centre is out of position.
    pub(in crate::cli) fn part_status(&self) -> Option<Status> {
        if self.position.is_some_and(|position| position.is_out()) { Some(Status::Scrap) } else { self.status }
    }

    /// `IN`, `OUT`, or nothing where the centre was not monitored.
    pub(in crate::cli) fn position_word(&self) -> Option<&'static str> {
        let position = self.position.filter(PositionVerdict::is_monitored)?;
        Some(if position.is_out() { "OUT" } else { "IN" })
    }
}

/// Where a user's own table differs from the standard.
fn differs(standard: Deviations) -> String {
    format!("ISO 286 has {} / {} µm here", standard.lower().signed_um(), standard.upper().signed_um())
}
