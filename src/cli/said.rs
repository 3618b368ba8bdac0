//! What a subcommand says on standard error besides errors: remarks and warnings.

use std::path::PathBuf;

use super::admitted::{LOOK_FIRST, TOLD};
use crate::journal::Decision;
use crate::length::Length;
use crate::message::{Arg, IntoArg, Message, Say, message, printed};
use crate::tolerance::ToleranceClass;
use crate::tolerance::fit::thermal::{Expansion, Temperature};
use crate::verdict::Rule;
use crate::verdict::rules::percent;

/// What is worth knowing about an answer.
#[derive(Debug, Say)]
#[say(prefix = "cli-remark")]
pub(super) enum CliRemark {
    /// A file is written.
    Wrote { path: String },
    /// A file of several files is written.
    WroteFiles { path: String, count: usize },
    /// A folder is looked at, and so many files were taken before.
    Watching { folder: String, known: usize },
    /// A plan without a fault.
    PlanHas { count: usize },
    /// A plan was begun without a callout.
    PlanExample,
    /// A plan that was written has faults.
    PlanToFill { count: usize },
    /// A file that is not read by columns.
    NoColumns,
    /// A plan is written as CSV, which has no place for these of its keys.
    PlanHeadLeft { keys: String },
    /// Outside the limits, and hole or shaft decides between rework and scrap.
    ReworkOrScrap {
        asked: Arg,
        /// How far beyond the limit, as a person reads it.
        #[say(with = printed)]
        um: String,
        /// Which limit: `above` or `below`.
        side: &'static str,
    },
    /// Of so many values hole or shaft decides between rework and scrap.
    Open { count: usize },
    /// Nobody measured.
    Simulated,
    /// A measured value that was brought to 20 °C.
    Corrected {
        measured: Length,
        #[say(with = printed)]
        temperature: Temperature,
        material: String,
        #[say(with = printed)]
        expansion: Expansion,
        #[say(with = printed)]
        change: String,
        at_reference: Length,
    },
    /// All measured values, brought to 20 °C.
    CorrectedAll {
        #[say(with = printed)]
        temperature: Temperature,
        material: String,
        #[say(with = printed)]
        expansion: Expansion,
    },
    /// The scales that it was measured with.
    Scales {
        #[say(with = printed)]
        temperature: Temperature,
        #[say(with = printed)]
        expansion: Expansion,
    },
    /// How far a linear correction is from the exact one.
    LinearCorrection {
        #[say(with = printed)]
        off: String,
    },
    /// The decision rule.
    Rule {
        #[say(with = Say::message)]
        rule: Rule,
    },
    /// The decision rule, with an uncertainty of each value by a budget.
    RuleByBudget {
        #[say(with = by_budget)]
        rule: Rule,
    },
    /// Where the uncertainty comes from.
    Budget { name: String, date: String, until: String },
    /// The contacts that its scatter is of.
    BudgetContacts {
        touches: usize,
        step: String,
        #[say(with = printed)]
        factor: String,
    },
    /// The values that it accepts.
    Accepted { least: Length, most: Length },
    /// It accepts no value: the rule leaves nothing of the tolerance.
    NothingAccepted,
    /// It proves the status.
    Proven,
    /// It does not.
    NotProven,
    /// The probability that the part conforms.
    Conformity {
        #[say(with = printed)]
        percent: String,
    },
    /// A program that was run without a workpiece.
    PerfectWorkpiece,
    /// A part can still be machined.
    Remove { limit: Length, middle: Length },
    /// Callouts without an answer.
    Refused { refused: usize, asked: usize },
    /// A search that found nothing.
    NoPair { nearest: String },
    /// A trace that does not list every block.
    TraceEnds { blocks: usize },
    /// An input in another encoding than its output.
    BatchUtf16 { name: String },
    /// Columns whose values are binary fractions.
    BatchFloats { name: String, columns: String },
    /// A run has changed the tool table in memory only.
    ToolsNotWritten,
    /// A list that ends before the last check.
    MoreEntries { limit: usize },
    /// A journal is copied.
    BackedUp {
        path: PathBuf,
        #[say(with = printed)]
        number: u64,
        hash: String,
    },
    /// What the server of a shop lacked was sent.
    #[cfg(feature = "shop")]
    Sent {
        entries: usize,
        #[say(with = printed)]
        number: u64,
        server: String,
    },
    /// Entries on a server that this version cannot read.
    #[cfg(feature = "shop")]
    Unread { entries: usize },
    /// A question that nothing answers, as it was read.
    NothingFound { question: String },
    /// Nothing is known elsewhere of a journal.
    NoHeadKnown,
    /// A default was used for the clearance height.
    ClearanceHeight { height: Length },
}

told! {
    /// What was recorded.
    #[derive(Debug, Say)]
    #[say(prefix = "cli-recorded")]
    pub(super) enum Recorded {
        /// One check.
        Entry {
            #[say(with = printed)]
            number: u64,
            file: String,
            hash: String,
        } => TOLD,
        /// Several; the hash is that of the last one.
        Entries {
            #[say(with = printed)]
            first: u64,
            #[say(with = printed)]
            last: u64,
            file: String,
            hash: String,
        } => TOLD,
        /// Nothing was judged.
        Nothing => TOLD,
        /// It is safe here, and the server does not have it yet.
        NotSent { error: Message } => TOLD,
        /// Rows of a file that are not checks, or that cannot be kept.
        Without { rows: usize, places: String } => LOOK_FIRST,
    }
}

told! {
    /// What to check about an answer.
    #[derive(Debug, Say)]
    #[say(prefix = "cli-warning")]
    pub(super) enum CliWarning<'a> {
        /// Rows were to be recorded together, and were not all read.
        StoppedUnrecorded => TOLD,
        /// A correction was withdrawn: neither it nor what it corrected stands.
        NeitherStands {
            /// The entry that it corrected.
            #[say(with = printed)]
            target: u64,
            /// The correction.
            #[say(with = printed)]
            number: u64,
        } => LOOK_FIRST,
        /// A good value that lies beyond a limit: the rule accepts it.
        BeyondLimits => TOLD,
        /// Features of a plan without a value.
        PlanMissing { names: String } => TOLD,
        /// The same of one part among several.
        PlanMissingOf { who: String, names: String } => TOLD,
        /// Values of one feature that contradict each other.
        Contradiction { name: String, values: String } => LOOK_FIRST,
        /// The same of one part among several.
        ContradictionOf { who: String, name: String, values: String } => LOOK_FIRST,
        /// Which one of them counts, and how to choose.
        WorstCounts => LOOK_FIRST,
        /// A file whose content was taken before under another name: nothing of it is recorded again.
        SameContent { known: String } => LOOK_FIRST,
        /// It is not known whether another program watches the same folder for the same journal.
        NotAlone { reason: String } => TOLD,
        /// What could not be used of a file is written beside it, in a file with this ending.
        SeeNote { note: &'static str } => TOLD,
        /// More parts than are known one by one.
        PlanMoreParts { most: usize } => TOLD,
        /// A size of a plan without a value.
        PlanNoValue => TOLD,
        /// The same of one part among several.
        PlanNoValueOf { who: String } => TOLD,
        /// A skipped column of a file of contacts.
        ColumnNotUsed { column: &'a str } => TOLD,
        /// A coefficient of expansion that no document confirms.
        ExpansionUnconfirmed {
            #[say(with = printed)]
            expansion: Expansion,
        } => TOLD,
        /// A file that is named twice among the inputs.
        FileTwice => LOOK_FIRST,
        /// Figures to check beyond those that are listed.
        MoreFigures { count: usize } => TOLD,
        /// A position for a cycle that does not begin there.
        PositionUnused { code: &'a str } => TOLD,
        /// What PREDEF stands for, of a parameter that is not set to it.
        PredefUnused { name: &'a str } => TOLD,
        /// An option of the log, without a log.
        LogOption { option: &'a str } => TOLD,
        /// Where limits come from, and no limits are looked up.
        TablesNotUsed => TOLD,
        /// A cell for which ISO 286 has no value, or several.
        EmptyCell {
            #[say(with = ToString::to_string)]
            class: ToleranceClass,
            over: Length,
            to: Length,
        } => TOLD,
        /// Options of a report that CSV has no place for.
        NotInCsv { options: &'a str } => TOLD,
        /// What a report says beside its checks, which CSV has no place for.
        NotesNotInCsv { count: usize } => TOLD,
        /// Recorded contacts that the cycle did not ask for.
        ContactsLeft { used: usize, count: usize } => LOOK_FIRST,
        /// A tool table, and a cycle that names no tool.
        NoToolMonitored => TOLD,
        /// A cycle with an unknown log.
        LogUnknown { code: &'a str } => TOLD,
        /// An option that a budget does not ask for.
        BudgetOption { option: &'a str } => TOLD,
        /// A value that is not a diameter, and another rule than the control's own, or a temperature.
        LimitsAlone => LOOK_FIRST,
        /// A folder for logs, and an input that wants no log.
        LogOff => TOLD,
        /// A folder for logs, and a cycle without one.
        LogNone => TOLD,
        /// A folder for logs, and an input that shows the log on the screen.
        LogOnScreen => TOLD,
    }
}

impl CliWarning<'_> {
    /// Features of a plan without a value; `who` is their part, empty where there is one alone.
    pub(super) fn missing(who: String, names: String) -> Self {
        if who.is_empty() { Self::PlanMissing { names } } else { Self::PlanMissingOf { who, names } }
    }
}

/// What a decision rule says of a value, sentence by sentence.
pub(super) fn decided(Decision { zones, proven, conformity }: &Decision) -> impl Iterator<Item = CliRemark> {
    let accepted = match zones.accepted {
        Some([least, most]) => CliRemark::Accepted { least, most },
        None => CliRemark::NothingAccepted,
    };
    let proven = proven.map(|is_proven| if is_proven { CliRemark::Proven } else { CliRemark::NotProven });
    let conformity =
        conformity.as_ref().map(|conformity| CliRemark::Conformity { percent: percent(conformity.within) });
    std::iter::once(accepted).chain(proven).chain(conformity)
}

/// `warning: …`
pub(super) fn warning(what: &impl Say) -> Message {
    message!("cli-warning").with("what", what)
}

/// `note: …`
pub(super) fn remark(what: &impl Say) -> Message {
    message!("cli-remark").with("what", what)
}

/// A sentence after what it is about.
pub(super) fn about(what: &(impl IntoArg + ?Sized), sentence: &impl Say) -> Message {
    message!("cli-about").with("what", what).with("error", sentence)
}

/// A rule whose uncertainty a budget gives for each value.
fn by_budget(rule: &Rule) -> Message {
    rule.message_with(message!("uncertainty-by-budget"))
}
