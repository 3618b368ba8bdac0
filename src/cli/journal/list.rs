//! `fitcheck journal list`: the newest checks, or those that a question asks for.

use super::row::{self, Line};
use super::written::shown;
use super::{
    CliError, CliRemark, Format, IntoCliError as _, Io, JournalArgs, Outcome, QUESTIONS, QuestionArgs, server,
};
use crate::cli::journal_place::JournalPlace;
use crate::cli::people::Side::Left;
use crate::cli::people::{Aligned, mm};
use crate::cli::rows;
use crate::journal::ask::{AskedKinds, Question};
use crate::journal::entry::{Check, Content, Entry};
use crate::journal::{Alarm, AlarmAnswer};
use crate::message::Say as _;
use crate::store::local::{ListedEntry, Reader};

fn help() -> String {
    format!(
        "\
{QUESTIONS}

A report that was written is a line of its own; JSON has its file and what it shows as report. So is
an alarm of a control chart, and the answer to it; JSON has its rule, cause and action as alarm. csv
leaves both out, unless reports or alarms asks for them alone.

Columns of --format csv, and names in JSON:
  {}

Examples:
  fitcheck journal list
  fitcheck journal list reports flange
  fitcheck journal list part:Flange verdict:scrap,rework week
  fitcheck journal list \"station:Mill 3\" today --format csv",
        rows::names::<Line>().join(",")
    )
}

/// List checks, newest first
#[derive(Debug, clap::Args)]
#[command(after_help = help())]
pub(super) struct Args {
    #[command(flatten)]
    question: QuestionArgs,
    /// Show at most N entries
    #[arg(long, value_name = "N", default_value_t = 50)]
    limit: usize,
    /// Show the oldest first
    #[arg(long)]
    oldest: bool,
    /// Format of the list
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    #[command(flatten)]
    journal: JournalArgs,
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let given = self.question.read(io)?;
        // A table of checks for other programs has no columns for files.
        let question = if self.format == Format::Csv { without_reports(given.clone()) } else { given.clone() };
        // One more than is listed tells that there are more.
        let most = self.limit.saturating_add(1);
        let mut rows = match self.journal.place()? {
            JournalPlace::File(file) => {
                let reader = Reader::open(&file).said()?;
                let all = if self.oldest { usize::MAX } else { most };
                let mut numbers = reader.numbers(&question, None, all).said()?;
                if self.oldest {
                    numbers.reverse();
                }
                numbers.truncate(most);
                reader.rows(&numbers).said()?
            }
            JournalPlace::Server(_) if self.oldest => return Err(CliError::JournalIsServer),
            JournalPlace::Server(address) => server::list(&address, &question, most, io)?,
        };
        let are_more = self.limit < rows.len();
        rows.truncate(self.limit);
        match self.format {
            Format::Text => {
                let cells: Vec<_> = rows.iter().map(cells).collect();
                TABLE.lines(&cells).for_each(|line| writeln!(io.people(), "{line}"));
            }
            Format::Csv => rows::csv(rows.iter().map(Line::of), io),
            Format::Json => io.json(&rows.iter().map(Line::of).collect::<Vec<_>>()),
        }
        // A blank in the wrong place asks for another name.
        if rows.is_empty() && given != Question::default() {
            io.remark(&CliRemark::NothingFound { question: given.text(&super::here()) });
        }
        if are_more {
            io.remark(&CliRemark::MoreEntries { limit: self.limit });
        }
        Ok(unread(&rows, io))
    }
}

/// The question for checks and withdrawals alone, unless it asks for reports or alarms by name.
pub(super) fn without_reports(question: Question) -> Question {
    match question.kinds {
        AskedKinds::All => Question { kinds: AskedKinds::Checks, ..question },
        AskedKinds::Checks | AskedKinds::Reports | AskedKinds::Alarms => question,
    }
}

/// Tells of entries that could not be read.
pub(super) fn unread(rows: &[ListedEntry], io: &mut Io<'_>) -> Outcome {
    let mut outcome = Outcome::Done;
    for row in rows {
        if let Err(error) = &row.entry {
            io.fail(format_args!("entry {}: {error}", row.kept.head.number));
            outcome = Outcome::BadData;
        }
    }
    outcome
}

/// The cells of a row for people.
fn cells(row: &ListedEntry) -> [String; 9] {
    let Some(Entry { about, content }) = row::entry(row) else {
        let mut cells: [String; 9] = Default::default();
        let [number, .., what] = &mut cells;
        *number = row.kept.head.number.to_string();
        "cannot be read".clone_into(what);
        return cells;
    };
    let time = about.time.local().map_or_else(String::new, |time| time.strftime("%Y-%m-%d %H:%M").to_string());
    let status = row::check(row).and_then(Check::status).map_or_else(String::new, |status| status.word().to_owned());
    let callout = match (row::record(row), content) {
        (Some(record), _) => crate::journal::query::callout(record),
        (None, Content::Check(check)) => match &check.what {
            crate::journal::entry::Checked::Cycle(cycle) => format!("cycle {}", cycle.cycle),
            crate::journal::entry::Checked::Size(_) => String::new(),
        },
        (None, Content::Begin(_) | Content::Withdrawal(_) | Content::Report(_) | Content::Alarm(_)) => String::new(),
    };
    let measured = row::measured(row).map_or_else(String::new, mm);
    [
        row.kept.head.number.to_string(),
        time,
        about.who.clone(),
        [&about.part, &about.serial].map(String::as_str).join(" ").trim().to_owned(),
        about.feature.clone(),
        callout,
        measured,
        status,
        marks(row, content),
    ]
}

/// What else is to be said of a row.
fn marks(row: &ListedEntry, content: &Content) -> String {
    let mut marks = Vec::new();
    if row::check(row).is_some_and(crate::journal::entry::Check::is_simulated) {
        marks.push("simulated".to_owned());
    }
    match content {
        Content::Withdrawal(correction) => marks.push(format!("withdraws entry {}", correction.target.number)),
        Content::Check(check) => {
            marks.extend(check.corrects.as_ref().map(|one| format!("corrects entry {}", one.target.number)));
        }
        Content::Report(report) => marks.push(format!("report {}: {}", report.name, shown(report))),
        Content::Alarm(alarm) => marks.push(alarm_mark(alarm)),
        Content::Begin(_) => {}
    }
    marks.extend(row.corrected_by.map(|number| format!("see entry {number}")));
    marks.join(", ")
}

/// Which rule fired, or what somebody says of that.
fn alarm_mark(alarm: &Alarm) -> String {
    match &alarm.answer {
        None => format!("alarm: {}", alarm.message()),
        Some(AlarmAnswer { target, cause, action }) => {
            format!("answers the alarm of entry {}: {cause}; {action}", target.number)
        }
    }
}

const TABLE: Aligned<9> = Aligned {
    columns: [
        ("number", Left),
        ("time", Left),
        ("who", Left),
        ("part", Left),
        ("feature", Left),
        ("callout", Left),
        ("measured", Left),
        ("verdict", Left),
        ("", Left),
    ],
    widest: 30,
};
