//! Errors of a file or a row: what is wrong, and what was given.

use fitcheck_core::length::{Length, LengthError};
use fitcheck_core::message::{Located, Message, Say};
use fitcheck_core::tolerance::fit::thermal::ThermalDoubt;
use fitcheck_core::tolerance::{Callout, CalloutError, Feature, LimitsError};
use fitcheck_nc::control::log::LogFault;
use fitcheck_nc::control::point_log::PointFault;
use fitcheck_nc::control::table::TableFault;

use super::aqdef::AqdefFault;
use super::calypso::CalypsoFault;
use super::contacts::ContactsError;
use super::gauge::GaugeError;
use super::printed::PrintedFault;
use super::role::Role;

pub use super::warning::{ImportWarning, ImportWarningKind};

/// A row that could not be used. Its place has its line, or 1 for the whole file; the column is the number of the cell
/// in its row or, in a log or in XML, the character in its line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ImportError {
    /// What is wrong.
    pub kind: ImportErrorKind,
    /// What was given there; long texts are shortened.
    pub given: String,
}

impl Say for ImportError {
    fn message(&self) -> Message {
        self.kind.message()
    }
}

/// What is wrong with a row or a file.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "exchange", error)]
pub enum ImportErrorKind {
    /// A file of Fitcheck says that the centre was out of position.
    PositionOut,
    /// A file of Fitcheck says that nothing was decided.
    Undecided {
        /// The reason that it gives.
        given: String,
    },
    /// The columns of a correction to 20 °C and the measured value contradict each other.
    Correction,
    /// The temperature from which a value was brought to 20 °C is doubted.
    #[say(transparent)]
    Temperature(ThermalDoubt),
    /// There is nothing in the file.
    Empty,
    /// The system cannot read on.
    Read {
        /// What it says.
        reason: String,
    },
    /// Larger than a file of its format may be, which is read whole.
    TooLarge {
        /// The most, MiB.
        most: u64,
    },
    /// A workbook without the sheet that is asked for.
    NoSheet {
        /// The sheet.
        given: String,
        /// Those that it has.
        sheets: String,
    },
    /// No format recognises the file.
    NotRecognised,
    /// A model of a part.
    ModelNotRead {
        format: &'static str,
    },
    DrawingNotRead {
        format: &'static str,
    },
    /// A document for readers.
    DocumentNotRead {
        format: &'static str,
    },
    ImageNotRead {
        format: &'static str,
    },
    /// A packed file.
    ArchiveNotRead {
        format: &'static str,
    },
    /// Another format than the one that was expected.
    OtherFormat {
        format: Message,
    },
    /// A Parquet file, and a program built without the feature `parquet`.
    ParquetUnknown,
    /// A Parquet file in a stream that has no end yet.
    ParquetStream,
    /// A Parquet file that cannot be read.
    Parquet {
        /// What is wrong with it.
        reason: String,
    },
    /// A column of a Parquet file that has columns or lists in it.
    ParquetNested {
        column: String,
    },
    /// A comment that holds a measurement: a row that somebody has put aside, or one whose name begins with `#`.
    #[say(id = "exchange-warning-comment")]
    Comment,
    /// A mask whose print cannot be read back.
    MaskBackwards {
        /// The mask's file.
        mask: String,
        /// Why not.
        reason: Message,
    },
    /// No mask prints such a file.
    MaskNone {
        /// The files of the masks.
        masks: String,
    },
    /// Several masks print such a file.
    MaskSeveral {
        /// Their files.
        masks: String,
    },
    /// A mask that prints no measured value.
    MaskNoMeasured {
        /// The mask's file.
        mask: String,
    },
    /// A mask of which several numbers could be the measured value.
    MaskMeasured {
        /// The mask's file.
        mask: String,
        fields: String,
    },
    /// A record of a mask that can be read in several ways.
    PrintAmbiguous,
    /// A record of a mask that ends too early.
    PrintBroken {
        /// The line of the mask whose text was expected.
        line: usize,
    },
    /// A line that no record of the mask prints, with figures in it.
    PrintOther,
    /// A print that is not in millimetres.
    PrintUnit {
        line: usize,
        unit: String,
    },
    /// A table of a control that cannot be read.
    #[say(transparent)]
    Table(TableFault),
    /// A table of a control without a column that says which part a row is of.
    TableNoPart,
    /// A table of a control without measured values.
    TableNoValues,
    /// A name of which several columns of a table could be the measured value, or none.
    TableNoValue {
        name: String,
    },
    /// A cell that begins where the one before it ends: either may be split wrongly.
    TableTouches {
        column: String,
    },
    /// A value in a table in inch whose column is no length: it may be in mm.
    TableUnit {
        column: String,
    },
    /// Only a header, comments or blank lines.
    NoRows,
    /// A log that cannot be used.
    #[say(transparent)]
    Log(LogFault),
    /// A file of AQDEF, or a line of one.
    #[say(transparent)]
    Aqdef(Box<AqdefFault>),
    /// A table of CALYPSO, or a row of one.
    #[say(transparent)]
    Calypso(CalypsoFault),
    /// A printed report, or a row of one.
    #[say(transparent)]
    Printed(PrintedFault),
    /// A line of a gauge that is no value.
    #[say(transparent)]
    Gauge(GaugeError),
    /// Lines of gauges in a file, of which one names no unit.
    GaugeUnit {
        /// The first such line.
        line: usize,
        /// What it says.
        given: String,
    },
    /// A measurement of cycle 444 that cannot be used.
    #[say(transparent)]
    Point(PointFault),
    /// Contacts that cannot be used.
    #[say(transparent)]
    Contacts(Box<Located<ContactsError>>),
    /// XML that is not well-formed.
    Xml {
        /// What is wrong with it.
        reason: String,
    },
    /// A document type: a file could make much of little with it, and none that is read here has one.
    XmlDoctype,
    /// An entity beyond the five that XML has by itself.
    XmlEntity {
        name: String,
    },
    /// Elements within one another, too deep.
    XmlDepth {
        most: usize,
    },
    /// A tag or a text that is too long.
    XmlLong {
        /// The most, KiB.
        most: usize,
    },
    /// A text with an element in the middle of it.
    XmlMixed {
        /// The element that has both.
        name: String,
    },
    /// The file ends within an element.
    XmlCutOff,
    /// An encoding that is not known.
    XmlEncoding {
        given: String,
    },
    /// Bytes that are none in the encoding of the file.
    XmlBytes,
    /// Something wrong at a place, where a reader has one error alone.
    #[say(transparent)]
    Located(Box<Located<Self>>),
    /// A unit of length of a QIF file that is not known, or contradicts itself.
    QifUnit {
        /// What was given.
        unit: String,
    },
    /// A QIF file that names no unit of length.
    QifNoUnit,
    /// Something that a QIF file refers to, and does not have.
    QifReference {
        /// What it should be.
        what: String,
        id: String,
    },
    /// More things of a kind than are kept.
    QifTooMany {
        what: String,
        most: usize,
    },
    /// A measurement without a value.
    QifNoValue {
        /// The status that the file gives it.
        status: String,
    },
    /// A limit or nominal size of a QIF file that cannot be read.
    QifLimit(#[say(name = "reason")] LengthError),
    /// A measurement of another kind than its characteristic.
    QifOtherKind {
        /// The kind of the measurement.
        measured: String,
        /// The kind of the characteristic.
        defined: String,
    },
    /// A measurement with several values.
    QifSeveralValues,
    /// A tolerance that does not say whether its numbers are limits or deviations.
    QifDefinedAsLimit,
    /// Deviations without a nominal size.
    QifNoNominal,
    /// A tolerance class of a hole for a shaft, or the other way round.
    QifZone {
        class: String,
        /// `HOLE` or `SHAFT`.
        zone: String,
    },
    /// A QIF file without measured values, such as a plan.
    QifNoResults,
    /// A workbook that cannot be read.
    Workbook {
        /// What is wrong with it.
        reason: String,
    },
    /// A ZIP file that is not a workbook.
    NotAWorkbook,
    OldWorkbook {
        /// The kind, by its ending.
        format: &'static str,
    },
    WorkbookPassword,
    /// A ZIP file without its end, where its list of members is.
    ZipCutOff,
    /// A ZIP file with too many members.
    ZipMembers {
        most: usize,
    },
    /// A member that unpacks to more than is read, or is packed too densely to be meant well.
    ZipBomb {
        /// Its name.
        member: String,
        /// The most, MiB.
        most: u64,
    },
    /// A workbook with two members of one name.
    ZipTwice,
    /// More texts than are kept.
    ZipTexts {
        most: usize,
    },
    /// A cell further to the right than columns are read.
    SheetWide {
        cell: String,
        /// The most columns.
        most: usize,
    },
    /// More cells than are taken as texts.
    TooManyCells {
        most: usize,
    },
    /// Something wrong with a sheet or a cell.
    Cell {
        /// The sheet and the cell.
        cell: String,
        reason: Box<Self>,
    },
    /// A formula that was never calculated.
    FormulaWithoutValue {
        formula: String,
    },
    /// A value of a cell that is not one text, or a number of a text that is none.
    CellSplit,
    /// A formula that has no value.
    CellError {
        /// What the cell shows.
        error: String,
    },
    /// A QIF file without characteristics.
    QifNoCharacteristics,
    /// No column holds the measured values.
    NoMeasuredColumn,
    /// Several columns could have the same role.
    #[say(args(word = role.word()))]
    SeveralColumns {
        role: Role,
        /// The columns, by number or name.
        columns: String,
    },
    /// A column that was given and that the file does not have.
    NoColumn {
        /// What it should hold.
        role: Role,
        /// Its number or name, as given.
        given: String,
        /// The columns that the file has.
        columns: String,
    },
    /// A column that was given for two things.
    ColumnTwice {
        column: String,
        /// The first thing.
        first: Role,
        /// The second one.
        second: Role,
    },
    /// The header names an unsupported unit.
    Unit {
        /// What was given.
        unit: String,
    },
    /// A title, comment or column that states a unit which is not read.
    UnitStated {
        line: usize,
        /// What was given.
        unit: String,
        /// The text of the line.
        text: String,
    },
    /// A title or comment that names a unit, and does not say that values are in it.
    UnitMentioned {
        line: usize,
        unit: String,
        /// The text of the line.
        text: String,
    },
    /// Two statements of units that contradict each other.
    UnitsDiffer {
        /// The first unit.
        unit: &'static str,
        /// What says so.
        at: String,
        other: &'static str,
        /// What says so.
        other_at: String,
    },
    /// A line behind the first row that states another unit than rows were read by.
    UnitLate {
        line: usize,
        /// What it states.
        unit: String,
        text: String,
        /// The unit of the rows.
        read: &'static str,
    },
    /// The same, where the line is known.
    UnitStray {
        /// What it states.
        unit: String,
        text: String,
        /// The unit of the rows.
        read: &'static str,
    },
    /// The file states another unit than the user says.
    UnitGiven {
        /// What the user says.
        given: &'static str,
        /// What the file states.
        unit: String,
        text: String,
    },
    /// One column of lengths is in inch, and another one says nothing.
    UnitHalf {
        /// The one in inch.
        column: String,
        open: String,
    },
    /// A row whose unit is missing, where a column states it.
    UnitMissing,
    /// A callout with a size or deviations of its own, in mm by its nature, in a row of inches.
    CalloutUnit {
        given: String,
    },
    /// A required cell is missing.
    RowShort {
        /// How many cells there are.
        found: usize,
        /// How many there should be.
        expected: usize,
    },
    /// More cells than columns, caused for example by a decimal comma among separating commas.
    RowLong {
        /// How many cells there are.
        found: usize,
        /// How many there should be.
        expected: usize,
    },
    /// A quotation mark that is not closed on its line.
    OpenQuote,
    /// A line within quotation marks that open on a line above, beside lines that look like rows.
    WithinQuotes,
    /// A line within the quotation marks of the header that looks like a row.
    HeaderHidesRows {
        /// The line where the header begins.
        line: usize,
    },
    RowTooLong {
        /// The most, KiB.
        most: usize,
    },
    /// The callout cannot be read.
    Callout(#[say(name = "reason")] CalloutError),
    /// The nominal size in a column of its own cannot be read.
    Nominal(#[say(name = "reason")] LengthError),
    /// The callout and the column of nominal sizes contradict each other.
    NominalDiffers {
        callout: Callout,
        /// The other nominal size.
        nominal: Length,
    },
    /// A limit in a column of its own cannot be read.
    Limit(#[say(name = "reason")] LengthError),
    /// A tolerance of one number without a sign: both deviations, or the width of the zone.
    ToleranceUnsigned {
        given: String,
    },
    /// A lower deviation with a minus, where the others have none.
    MinusAgain {
        given: String,
    },
    /// Limits beside a callout that are other ones than those of the callout.
    LimitsContradict {
        callout: Callout,
        /// The limits of the callout.
        minimum: Length,
        maximum: Length,
        /// The others, as the file has them.
        given: String,
        /// How the columns are left out.
        columns: &'static str,
    },
    /// Columns of limits or of deviations.
    LimitsOrDeviations {
        columns: String,
        /// The number of the upper one; `-` where there is none.
        upper: String,
        lower: String,
    },
    /// Columns of limits, or of the largest and the smallest of several readings.
    LimitsOrReadings {
        columns: String,
        /// The number of the upper one; `-` where there is none.
        upper: String,
        lower: String,
    },
    /// Lower deviations without a sign, which may be above the nominal size or below it.
    MinusOrPlus {
        columns: String,
        /// The number of the column.
        lower: String,
    },
    /// Several measured values in each row, where a row has one answer.
    SamplesSideBySide {
        columns: String,
        /// The number of the first column.
        first: usize,
    },
    /// The callout has no limits.
    #[say(transparent)]
    Limits(LimitsError),
    /// The measured value cannot be read.
    Measured(#[say(name = "reason")] LengthError),
    /// A decimal sign other than that of the rest of the column.
    DecimalSign {
        given: String,
        sign: char,
    },
    /// A cell of the column that says whether nobody measured.
    Simulated {
        given: String,
    },
    /// A row names other columns than those of the file.
    OtherHeader,
    /// A row below one that names other columns.
    BelowOtherHeader {
        /// The line that names them.
        line: usize,
    },
    /// The mark of a simulation stands between rows that are judged in any order.
    SimulatedBelow,
    /// The text of an origin says neither that a value was measured nor that it was simulated.
    Origin {
        given: String,
    },
    /// A diameter of zero or less.
    NotPositive {
        given: String,
    },
    /// Two cells that may be one number with a decimal comma.
    DecimalComma {
        /// The two cells together.
        joined: String,
    },
    /// A callout of a shaft among holes, or of a hole among shafts.
    OtherFeature {
        /// The callout.
        given: String,
        /// What the file should hold.
        feature: Feature,
    },
    /// A value that its own file rejects, where parts are to be used.
    Rejected {
        /// What the file says.
        given: String,
    },
    /// A row whose name is that of a figure of several parts, or of what a gauge was set by.
    NoPart {
        /// The name.
        given: String,
    },
    /// The measurement of a hole or of a shaft in a log among the others.
    OtherLog {
        /// What the file should hold.
        feature: Feature,
    },
    /// A measurement that is not a size.
    NotASize(#[say(name = "what")] Message),
    /// Contacts where sizes are needed.
    ContactsNotSizes,
    /// More rows than are kept in memory, [`MOST_ROWS`](super::imported::MOST_ROWS).
    TooManyRows {
        /// How many.
        most: usize,
    },
}

impl ImportErrorKind {
    /// Whether it says that the file names no unit.
    pub(super) const fn lacks_unit(&self) -> bool {
        matches!(self, Self::GaugeUnit { .. })
    }

    /// That the system cannot read on.
    pub(super) fn read(error: &std::io::Error) -> Self {
        Self::Read { reason: error.to_string() }
    }
}
