//! Measured sizes alone, of holes or of shafts: nobody asks what limits they have.
//!
//! The formats and the columns are those of [`super::import`]. Of a callout only its side counts, hole or shaft.

use std::collections::HashMap;
use std::io::Cursor;

use fitcheck_core::length::Length;
use fitcheck_core::message::{FilePlace, Located, Say};
use fitcheck_core::tolerance::{Feature, Sources};
use jiff::civil::DateTime;

use super::error::{ImportError, ImportErrorKind, ImportWarning};
use super::imported::{Item, MOST_ROWS, Sink, Unjudged, WhyUnjudged};
use super::size::{Size, SizesOf};
use super::source::{Body, ImportInputs, Source};
use super::{FORMATS, measurements, xlsx};

/// The sizes of a file, and what did not become one.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Sizes {
    /// What can be used, in the file's order.
    pub measured: Vec<Size>,
    /// Rows that cannot be used, or the reason why the whole file cannot be.
    pub errors: Vec<Located<ImportError>>,
    /// Warnings about what was still readable.
    pub warnings: Vec<Located<ImportWarning>>,
}

/// What to check about the sizes of a file as a whole.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "sizes-warning")]
pub enum SizesWarning {
    /// Parts with the same name.
    NamedTwice {
        /// The first such name.
        id: String,
        /// The line of its first part.
        first: usize,
        /// The line of its second one.
        second: usize,
        /// How many rows have the name of an earlier one.
        rows: usize,
    },
    /// Rows that say that nobody measured.
    SimulatedRows {
        /// How many.
        count: usize,
    },
}

/// Reads sizes alone from a file with columns.
type Reads = fn(&mut Source<'_>, &mut Sink<'_>, SizesOf<'_>) -> Result<(), ImportErrorKind>;

/// Reads the measured sizes of a file of any known format; `feature` is what the file should hold.
///
/// ```
/// use fitcheck_core::tolerance::Feature;
///
/// let read = fitcheck_exchange::exchange::sizes("holes.csv", b"id;measured\nH1;25,012\nH2;\n", Feature::Hole);
/// assert_eq!(read.measured[0].measured.to_string(), "25.012");
/// assert_eq!(read.errors[0].to_string(), "line 3, column 2: measured: a length is missing");
/// ```
pub fn sizes(file_name: &str, bytes: &[u8], feature: Feature) -> Sizes {
    sizes_from(file_name, &mut Cursor::new(bytes), feature, &mut || {})
}

/// The same from a file that is read piece by piece; `row` is called after each of its rows.
pub fn sizes_from(file_name: &str, body: &mut dyn Body, feature: Feature, row: &mut dyn FnMut()) -> Sizes {
    let mut read = Sizes::default();
    if let Err(reason) = read_sizes(&mut read, (file_name, body), feature, row) {
        read.refuse(1, reason);
    }
    read
}

fn read_sizes(
    read: &mut Sizes,
    (file_name, body): (&str, &mut dyn Body),
    feature: Feature,
    row: &mut dyn FnMut(),
) -> Result<(), ImportErrorKind> {
    let sources = Sources::default();
    // No record comes of it, so nobody sees the time.
    let mut source = Source::new(file_name, body, ImportInputs::new(&sources, DateTime::MIN))?;
    if source.is_blank() {
        return Err(ImportErrorKind::Empty);
    }
    let format = FORMATS.iter().find(|format| (format.recognises)(&source.beginning()));
    let format = format.ok_or(ImportErrorKind::NotRecognised)?;
    let reads_sizes: Reads = match format.name {
        name if name == measurements::FORMAT.name => measurements::read_sizes,
        name if name == xlsx::FORMAT.name => xlsx::read_sizes,
        _ => {
            let mut take = |item| {
                row();
                read.take(item, feature);
            };
            return (format.read)(&mut source, &mut Sink::up_to(MOST_ROWS, &mut take));
        }
    };
    let Sizes { measured, errors, warnings } = read;
    let mut beside = |item| match item {
        Item::Error(error) => errors.push(*error),
        Item::Warning(warning) => warnings.push(warning),
        // A row of sizes becomes nothing else.
        Item::Record { .. } | Item::Unjudged(_) | Item::Contacts(_) => {}
    };
    let mut take = |size| {
        row();
        measured.push(size);
    };
    let sizes = SizesOf { feature, take: &mut take };
    reads_sizes(&mut source, &mut Sink::up_to(MOST_ROWS, &mut beside), sizes)
}

impl Sizes {
    /// What to check about the file as a whole.
    pub fn doubts(&self) -> Vec<SizesWarning> {
        let count = self.measured.iter().filter(|size| size.is_simulated).count();
        let simulated = (0 < count).then_some(SizesWarning::SimulatedRows { count });
        self.named_twice().into_iter().chain(simulated).collect()
    }

    /// The first name that two rows have, and how many rows have the name of an earlier one.
    fn named_twice(&self) -> Option<SizesWarning> {
        let mut lines: HashMap<&str, usize> = HashMap::new();
        let mut rows = 0;
        let mut found = None;
        for part in self.measured.iter().filter(|part| !part.id.is_empty()) {
            let first = *lines.entry(&part.id).or_insert(part.line);
            if first != part.line {
                rows += 1;
                found = found.or(Some((&part.id, first, part.line)));
            }
        }
        let (id, first, second) = found?;
        Some(SizesWarning::NamedTwice { id: id.clone(), first, second, rows })
    }

    fn refuse(&mut self, line: usize, kind: ImportErrorKind) {
        self.errors.push(Located { what: ImportError { kind, given: String::new() }, place: FilePlace::line(line) });
    }

    /// What a log says of a size.
    fn take(&mut self, item: Item, feature: Feature) {
        match item {
            Item::Record { line, record, labels } if labels.quantity.as_ref().is_some_and(|of| !of.is_size()) => {
                let why = WhyUnjudged::NotASize { what: record.id.clone() };
                self.refuse(line, ImportErrorKind::NotASize(why.message()));
            }
            Item::Record { line, record, .. } if record.limits.feature.is_none_or(|of| of == feature) => {
                self.add(Size {
                    line,
                    id: record.id.clone(),
                    measured: record.measurement.diameter,
                    is_simulated: record.measurement.origin.is_simulated(),
                });
            }
            Item::Record { line, .. } => self.refuse(line, ImportErrorKind::OtherLog { feature }),
            Item::Unjudged(unjudged) => self.take_unjudged(*unjudged),
            Item::Error(error) => self.errors.push(*error),
            Item::Warning(warning) => self.warnings.push(warning),
            // Refused above, as a measurement that makes no record.
            Item::Contacts(_) => {}
        }
    }

    fn take_unjudged(&mut self, unjudged: Unjudged) {
        let Unjudged { line, id, measured, why, origin, .. } = unjudged;
        let is_size = matches!(
            why,
            WhyUnjudged::NoCallout
                | WhyUnjudged::NoLimits { .. }
                | WhyUnjudged::OneLimit
                | WhyUnjudged::NoTolerance
                | WhyUnjudged::SwappedLimits { .. }
        );
        match measured {
            Some(measured) if is_size => {
                self.add(Size { line, id, measured, is_simulated: origin.is_simulated() });
            }
            None if matches!(why, WhyUnjudged::Contacts { .. }) => self.refuse(line, ImportErrorKind::ContactsNotSizes),
            _ => self.refuse(line, ImportErrorKind::NotASize(why.message())),
        }
    }

    fn add(&mut self, size: Size) {
        if Length::ZERO < size.measured {
            self.measured.push(size);
        } else {
            self.refuse(size.line, ImportErrorKind::NotPositive { given: size.measured.to_string() });
        }
    }
}
