//! Warnings about a file or a row that was still used.

use fitcheck_core::length::Length;
use fitcheck_core::message::{Message, Say};
use fitcheck_core::probing::Caveat;
use fitcheck_core::tolerance::{Callout, Feature};
use fitcheck_nc::control::log::LogWarningKind;
use fitcheck_nc::control::table::TableWarningKind;

use super::aqdef::AqdefWarning;
use super::calypso::CalypsoWarning;
use super::printed::PrintedWarning;

/// A warning about a file or row that was still used.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ImportWarning {
    /// The line of the record or unjudged measurement that it belongs to; `None` where it is about the file.
    pub row: Option<usize>,
    /// What it says.
    pub kind: ImportWarningKind,
}

impl Say for ImportWarning {
    fn message(&self) -> Message {
        self.kind.message()
    }
}

/// What a warning says, without its place.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "exchange-warning")]
pub enum ImportWarningKind {
    /// A warning about a log.
    #[say(transparent)]
    Log(LogWarningKind),
    /// A warning about a table of a control.
    #[say(transparent)]
    Table(TableWarningKind),
    /// A warning about a file of AQDEF.
    #[say(transparent)]
    Aqdef(AqdefWarning),
    /// The callout contradicts itself.
    #[say(transparent)]
    Callout(Caveat),
    /// A warning about a table of CALYPSO.
    #[say(transparent)]
    Calypso(CalypsoWarning),
    /// A warning about a printed report.
    #[say(transparent)]
    Printed(PrintedWarning),
    /// Values that a file of Fitcheck says to be at 20 °C already.
    Corrected,
    /// A file of Fitcheck whose verdicts may be by another rule.
    OtherRule,
    /// Skipped columns.
    IgnoredColumns {
        /// Their names or numbers.
        columns: String,
    },
    /// A column that may say what was measured, with words that are not known: its values are taken as sizes.
    QuantityUnknown {
        /// Its number and name.
        column: String,
        /// Its first words.
        words: String,
    },
    /// A column of no known name that looks as if it had the callouts of rows without limits.
    CalloutsUnnamed {
        /// Its number and name.
        column: String,
    },
    /// Lower deviations that stand without their minus, which is supplied.
    MinusSupplied {
        /// Its number and name.
        column: String,
    },
    /// Columns that are read as limits by what stands in them.
    LimitsRead {
        /// Their numbers and names.
        columns: String,
    },
    /// What lines above the measurements say of all of them.
    HeadRead {
        /// Their words.
        said: String,
    },
    /// Columns with a measured value each.
    SamplesRead {
        /// Their numbers and names.
        columns: String,
    },
    /// A skipped line above the measurements.
    NotUsed {
        /// The line's text.
        text: String,
    },
    /// A comment above the header that holds a measurement.
    Comment,
    /// A place that cannot be read as a length.
    Place { given: String },
    /// A row that runs over several lines, within quotation marks.
    SeveralLines {
        /// How many.
        lines: usize,
    },
    /// The time cannot be read, so the time of import is used.
    Time { given: String },
    /// There is a column for the time, and the row has none.
    NoTime,
    /// A time with an offset from UTC, which no record has.
    Offset { given: String },
    /// The file's tolerance class has other limits than the file: those of the file count.
    LimitsDiffer {
        callout: Callout,
        /// Its limits.
        minimum: Length,
        /// The larger one.
        maximum: Length,
    },
    /// The file has other limits than the plan: those of the plan count.
    PlanDiffers {
        /// The file's smallest permitted value.
        minimum: Length,
        /// The largest one.
        maximum: Length,
    },
    /// The file has another smallest permitted value than the plan, and no largest one.
    PlanDiffersBelow {
        /// The file's value.
        minimum: Length,
    },
    /// The same of the largest one alone.
    PlanDiffersAbove {
        /// The file's value.
        maximum: Length,
    },
    /// A value that is not of the plan, and above the upper limit of its file.
    AboveOwnLimit {
        /// That limit.
        maximum: Length,
    },
    /// The same below the lower limit.
    BelowOwnLimit {
        /// That limit.
        minimum: Length,
    },
    /// The file has another nominal size than the plan, and no limits.
    PlanDiffersNominal {
        /// The file's value.
        nominal: Length,
    },
    /// The file names another part than the plan: that of the plan counts.
    PartDiffers {
        /// What the file says.
        given: String,
        /// The part of the plan.
        part: String,
    },
    /// The feature was found by its number, and the value has a name that no feature has.
    FoundByNumberOf {
        /// Its name in the plan.
        name: String,
        /// What the value is called.
        given: String,
    },
    /// The feature was found by where it lies, and the value has a name or number that no feature has.
    FoundByPlaceOf {
        /// Its name in the plan.
        name: String,
        /// What the value is called.
        given: String,
    },
    /// The feature was found by the number of its balloon.
    FoundByNumber {
        /// Its name in the plan.
        name: String,
    },
    /// The feature was found by where it lies.
    FoundByPlace {
        /// Its name in the plan.
        name: String,
    },
    /// A tolerance class that is none, or that has no limits here: the file's own limits count.
    ClassUnknown { given: String },
    /// The file has another status than the limits give: that of the limits counts.
    StatusDiffers {
        /// The file's word.
        given: String,
        /// The status by the limits.
        status: String,
    },
    /// The file says something of the status that is not known: nobody compared it with that of the limits.
    StatusUnknown {
        /// The file's word.
        given: String,
        /// The status by the limits.
        status: String,
    },
    /// The file has another limit beside the value: that of the callout or the plan counts.
    LimitDiffers {
        /// The file's column and number.
        given: String,
        /// The smallest permitted value.
        minimum: Length,
        /// The largest one.
        maximum: Length,
    },
    /// The file has another deviation beside the value: that of the value counts.
    DeviationDiffers {
        /// The file's column and number.
        given: String,
        measured: Length,
        /// The nominal size.
        nominal: Length,
    },
    /// The file says that the value is of a shaft, and its limits are those of a hole, or the other way round.
    FeatureDiffers {
        /// The file's word.
        given: String,
        /// What the limits are of.
        feature: Feature,
    },
    /// The file says that the part had another temperature than the one that counts.
    TemperatureDiffers {
        /// The file's column and number.
        given: String,
        /// From how many degrees Celsius the value is brought to 20 °C.
        counted: String,
    },
    /// The same of a line, for all values.
    SpeaksOfTemperature {
        /// The line's text.
        text: String,
        /// From how many degrees Celsius the values are brought to 20 °C.
        counted: String,
    },
    /// A remark that says clearly another unit than that of the values.
    SpeaksOfUnit {
        /// What it says.
        text: String,
    },
    /// A line above or between the measurements that speaks of a simulation.
    SpeaksOfSimulation {
        /// The line's text.
        text: String,
    },
    /// Every value is exactly the nominal size: it may be a list of sizes that nobody measured.
    AllNominal {
        /// How many values.
        count: usize,
    },
    /// A name that speaks of something else than the size of one part: a roundness, a mean, a master.
    NameOfNoSize {
        /// The name.
        given: String,
    },
    /// Columns with other sizes near the measured ones, which are not judged.
    OtherValues {
        /// Their names or numbers.
        columns: String,
    },
    /// The file does not accept a whole part.
    PartRejected {
        /// The file's word.
        given: String,
    },
    /// An uncertainty that the file states, which no rule uses.
    UncertaintyNotUsed {
        /// The expanded uncertainty.
        expanded: Length,
    },
    /// Lengths in another unit than mm, as a line of the file states.
    UnitRead {
        unit: String,
        /// The line's text.
        text: String,
    },
    /// Lengths without a unit are taken for millimetres.
    UnitAssumed,
    /// A length with figures beyond the nanometre, which is rounded.
    Rounded { given: String },
    /// Measured values that were rounded to the nanometre.
    RoundedValues {
        /// How many.
        count: usize,
    },
    /// A standard uncertainty that the file states, which no rule uses.
    StandardUncertaintyNotUsed {
        /// As the file has it, in the unit of the value.
        standard: String,
        /// The mean error beside it.
        mean_error: String,
    },
    /// Sheets of a workbook that are not read.
    SheetsLeft {
        sheet: String,
        /// The others.
        left: String,
        /// Whether one of them looks as if something measured were in it, and nobody has chosen a sheet.
        #[say(skip)]
        may_hold_rows: bool,
    },
    /// A sheet that the user does not see.
    SheetHidden {
        /// Its name.
        sheet: String,
    },
    /// Rows that the user does not see, by hand or by a filter, and that are read like the others.
    RowsHidden {
        /// How many.
        count: usize,
        rows: String,
    },
    /// Columns that the user does not see.
    ColumnsHidden {
        /// Their letters.
        columns: String,
    },
    /// A version of QIF that nobody has tried here.
    QifVersion {
        /// What the file says.
        version: String,
    },
    /// A list that says another number of things than it has.
    QifCount {
        list: String,
        /// How many it says.
        said: usize,
        /// How many there are.
        found: usize,
    },
    /// Two things with one number: the first one counts.
    QifTwice { id: String },
    /// The measured value ends the file, and may have had more decimals.
    CutOff {
        /// What is left of it.
        given: String,
    },
    /// The file ends without a line end, and nothing says whether its last cell is whole.
    OpenEnd {
        /// The cell.
        given: String,
    },
}

impl ImportWarningKind {
    /// Whether something of the file that may have been measured is not read.
    pub const fn is_loss(&self) -> bool {
        match self {
            Self::NotUsed { .. }
            | Self::SpeaksOfUnit { .. }
            | Self::SpeaksOfSimulation { .. }
            | Self::SpeaksOfTemperature { .. }
            | Self::Comment
            | Self::SheetsLeft { .. }
            | Self::QifCount { .. }
            | Self::QifTwice { .. } => true,
            Self::Aqdef(warning) => warning.is_loss(),
            Self::Calypso(warning) => matches!(warning, CalypsoWarning::Zeros),
            _ => false,
        }
    }

    /// Whether it says that the file names no unit.
    pub(super) const fn lacks_unit(&self) -> bool {
        matches!(self, Self::UnitAssumed)
    }

    /// Whether it compares what the file says beside a value with its answer.
    pub(super) const fn is_of_claim(&self) -> bool {
        matches!(
            self,
            Self::StatusDiffers { .. }
                | Self::StatusUnknown { .. }
                | Self::LimitDiffers { .. }
                | Self::DeviationDiffers { .. }
                | Self::FeatureDiffers { .. }
                | Self::Callout(_)
                | Self::TemperatureDiffers { .. }
                | Self::NameOfNoSize { .. }
        )
    }

    /// Whether it stands against the answers of the file, or says that something which may have been measured is left out of them: a run
    /// that only says so must not end as if nothing were the matter.
    pub const fn stands_against(&self) -> bool {
        match self {
            Self::Comment
            | Self::LimitsDiffer { .. }
            | Self::PlanDiffers { .. }
            | Self::PlanDiffersBelow { .. }
            | Self::PlanDiffersAbove { .. }
            | Self::AboveOwnLimit { .. }
            | Self::BelowOwnLimit { .. }
            | Self::StatusDiffers { .. }
            | Self::StatusUnknown { .. }
            | Self::LimitDiffers { .. }
            | Self::DeviationDiffers { .. }
            | Self::FeatureDiffers { .. }
            | Self::Callout(_)
            | Self::TemperatureDiffers { .. }
            | Self::SpeaksOfTemperature { .. }
            | Self::SpeaksOfUnit { .. }
            | Self::SpeaksOfSimulation { .. }
            | Self::AllNominal { .. }
            | Self::PartRejected { .. }
            | Self::NameOfNoSize { .. }
            | Self::OtherValues { .. }
            | Self::QuantityUnknown { .. }
            | Self::SheetHidden { .. }
            | Self::RowsHidden { .. }
            | Self::ColumnsHidden { .. }
            | Self::QifCount { .. }
            | Self::QifTwice { .. }
            | Self::Table(TableWarningKind::NoEnd)
            | Self::CutOff { .. } => true,
            Self::SheetsLeft { may_hold_rows, .. } => *may_hold_rows,
            Self::Aqdef(warning) => warning.stands_against(),
            Self::Calypso(warning) => warning.stands_against(),
            Self::Printed(warning) => warning.stands_against(),
            // A nominal size that is rounded, or the middle of the limits: another one is refused.
            Self::PlanDiffersNominal { .. }
            // Lines that are no measurement, what a file lacks and what explains how a row was read.
            | Self::Log(
                LogWarningKind::NoUnit
                | LogWarningKind::NoTime
                | LogWarningKind::NoDeviations
                | LogWarningKind::Ignored { .. }
                | LogWarningKind::TextBefore,
            )
            | Self::Table(_)
            | Self::Corrected
            | Self::OtherRule
            | Self::IgnoredColumns { .. }
            | Self::NotUsed { .. }
            | Self::CalloutsUnnamed { .. }
            | Self::MinusSupplied { .. }
            | Self::LimitsRead { .. }
            | Self::HeadRead { .. }
            | Self::SamplesRead { .. }
            | Self::Place { .. }
            | Self::SeveralLines { .. }
            | Self::Time { .. }
            | Self::NoTime
            | Self::Offset { .. }
            | Self::PartDiffers { .. }
            | Self::FoundByNumberOf { .. }
            | Self::FoundByPlaceOf { .. }
            | Self::FoundByNumber { .. }
            | Self::FoundByPlace { .. }
            | Self::ClassUnknown { .. }
            | Self::UncertaintyNotUsed { .. }
            | Self::UnitRead { .. }
            | Self::UnitAssumed
            | Self::Rounded { .. }
            | Self::RoundedValues { .. }
            | Self::StandardUncertaintyNotUsed { .. }
            | Self::QifVersion { .. }
            | Self::OpenEnd { .. } => false,
        }
    }
}
