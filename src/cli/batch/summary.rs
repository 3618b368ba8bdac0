//! What a batch had, on standard error: the first remarks with their lines, then how many rows had which verdict.

use crate::batch::Summary;
use crate::cli::admitted::Admits as _;
use crate::cli::io::Listener;
use crate::cli::{CliRemark, CliWarning, Io, Outcome, said};
use crate::exchange::batch::{Counts, FIRST, RowNoteKind, Tally};
use crate::exchange::{ImportErrorKind, ImportWarningKind};
use crate::verdict::Status;

/// How many classes are listed.
const CLASSES: usize = 20;

/// Tells the first remarks of all inputs together.
pub(super) struct BatchRemarks<'a> {
    listener: Listener<'a>,
    /// How many of each kind were told, in the order of [`RowNoteKind::ALL`].
    counts: [usize; RowNoteKind::ALL.len()],
}

impl<'a> BatchRemarks<'a> {
    pub(super) const fn new(listener: Listener<'a>) -> Self {
        Self { listener, counts: [0; RowNoteKind::ALL.len()] }
    }

    pub(super) fn remark(&mut self, what: &CliRemark) {
        self.listener.note(said::remark(what));
    }

    /// A warning about a line above the rows.
    pub(super) fn warning(&mut self, name: &str, line: usize, what: &ImportWarningKind) {
        if what.wants_a_look() {
            self.listener.look_first();
        }
        self.listener.tell(format_args!("{name}:{line}: {}", said::warning(what)));
    }

    /// The first remarks about rows of an input whose first row is in this line.
    pub(super) fn notes(&mut self, name: &str, first_line: usize, tally: &Tally) {
        for (kind, told) in RowNoteKind::ALL.into_iter().zip(&mut self.counts) {
            for note in tally.notes(kind).first.iter().take(FIRST - *told) {
                *told += 1;
                let column = note.column.map_or(String::new(), |column| format!(":{column}"));
                let warning = if kind == RowNoteKind::Refused { "" } else { "warning: " };
                self.listener.tell(format_args!("{name}:{}{column}: {warning}{}", first_line + note.line, note.what));
            }
        }
    }
}

/// `5000 rows: 4000 GOOD, 600 REWORK, 399 SCRAP, 1 not judged`, and what else there was to say.
pub(super) fn tell(summary: &Summary, io: &mut Io<'_>) {
    let Summary { tally, by_class, others, figures } = summary;
    for warning in figures.values().take(FIRST) {
        io.warn(warning);
    }
    if FIRST < figures.len() {
        io.warn(&CliWarning::MoreFigures { count: figures.len() - FIRST });
    }
    let mut classes: Vec<(&str, Counts, u64)> = by_class
        .iter()
        .map(|(class, counts)| (class.as_str(), *counts))
        .chain([("other callouts", *others)])
        .map(|(name, counts)| (name, counts, counts.iter().sum()))
        .filter(|(_, _, rows)| 0 < *rows)
        .collect();
    classes.sort_by_key(|(_, _, rows)| std::cmp::Reverse(*rows));
    if 1 < classes.len() {
        let left = classes.len().saturating_sub(CLASSES);
        for (name, counts, rows) in classes.into_iter().take(CLASSES) {
            io.note(format_args!("  {name}: {}", counted(rows, counts, 0)));
        }
        if 0 < left {
            io.note(format_args!("  and {left} more {}", if left == 1 { "class" } else { "classes" }));
        }
    }
    if tally.rows == 0 {
        return io.fail(ImportErrorKind::NoRows);
    }
    io.note(counted(tally.rows, summary.counts(), tally.notes(RowNoteKind::Refused).count));
    if let Some(count) = all_nominal(summary).and_then(|count| usize::try_from(count).ok()) {
        io.tell(said::warning(&ImportWarningKind::AllNominal { count }));
    }
    for (count, one, many) in [
        (
            tally.notes(RowNoteKind::Doubt).count,
            "value may be another quantity or belong to another part",
            "values may be another quantity or belong to another part",
        ),
        (
            tally.notes(RowNoteKind::StatusDiffers).count,
            "row has a different status in its file",
            "rows have a different status in their file",
        ),
        (
            tally.notes(RowNoteKind::StatusUnknown).count,
            "row has an unknown status in its file",
            "rows have an unknown status in their file",
        ),
        (
            tally.notes(RowNoteKind::ClaimDiffers).count,
            "limit, deviation or type of feature in the file contradicts its row",
            "limits, deviations or types of features in the file contradict their rows",
        ),
        (tally.simulated, "row says that nobody measured", "rows say that nobody measured"),
        (tally.notes(RowNoteKind::SeveralLines).count, "row runs over several lines", "rows run over several lines"),
        (
            tally.not_utf8,
            "line is not UTF-8: read as Windows-1252, written as UTF-8",
            "lines are not UTF-8: read as Windows-1252, written as UTF-8",
        ),
        (tally.comments, "comment is not a row", "comments are not rows"),
    ] {
        if 0 < count {
            io.tell(format_args!("{count} {}", if count == 1 { one } else { many }));
        }
    }
}

fn counted(rows: u64, counts: Counts, refused: u64) -> String {
    let words = Status::ALL.into_iter().map(Status::word).zip(counts).chain([("not judged", refused)]);
    let parts: Vec<String> =
        words.filter(|(_, count)| 0 < *count).map(|(word, count)| format!("{count} {word}")).collect();
    format!("{rows} {}: {}", if rows == 1 { "row" } else { "rows" }, parts.join(", "))
}

/// How many values there are, where each of them is exactly its nominal size.
fn all_nominal(summary: &Summary) -> Option<u64> {
    let judged: u64 = summary.counts().iter().sum();
    (1 < judged && summary.tally.nominal == judged).then_some(judged)
}

/// As `import`: bad data where any row has no verdict, else the worst one, and what has to be looked at first.
pub(super) fn outcome(summary: &Summary) -> Outcome {
    let tally = &summary.tally;
    if tally.rows == 0 || 0 < tally.notes(RowNoteKind::Refused).count {
        return Outcome::BadData;
    }
    let worst =
        Status::ALL.into_iter().zip(summary.counts()).filter(|(_, count)| 0 < *count).map(|(status, _)| status).max();
    let judged = worst.map_or(Outcome::Done, Outcome::Judged);
    let against =
        tally.notes(RowNoteKind::Doubt).count + tally.simulated + tally.against + all_nominal(summary).unwrap_or(0);
    if 0 < against { judged.worse(Outcome::LookFirst) } else { judged }
}
