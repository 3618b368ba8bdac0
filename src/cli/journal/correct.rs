//! `fitcheck journal correct`: an entry in place of another one, which stays.

use std::sync::Arc;

use super::show::row;
use super::{CliError, IntoCliError as _, Io, JournalArgs, Outcome};
use crate::cli::ErrorSubject;
use crate::cli::record::keep;
use crate::cli::said::CliWarning;
use crate::journal::Record;
use crate::journal::entry::{About, Check, Checked, Content, Correction, Entry};
use crate::store::here;
use crate::store::local::{ListedEntry, Reader};

const HELP: &str = "\
Nothing is changed: a new entry names the old one and gives the reason, and both stay. A value that
was typed may be typed again; it is judged by the same limits and the same rule.
If a correction is withdrawn, the check that it corrected does not count again (exit code 14).

Examples:
  fitcheck journal correct 12 --reason \"serial number of the next part\" --serial 17-0043
  fitcheck journal correct 12 --reason \"25.012 was meant\" --measured 25.012
  fitcheck journal correct 12 --reason \"measured before it was cleaned\" --withdraw";

/// Correct or withdraw a check; the old entry stays
#[derive(Debug, clap::Args)]
#[command(after_help = HELP)]
pub(super) struct Args {
    /// Number of the entry
    #[arg(value_name = "NUMBER")]
    number: u64,
    /// Reason for the correction
    #[arg(long, value_name = "TEXT")]
    reason: String,
    /// Who corrects, not who measured (--who); default: the user of the computer
    #[arg(long, value_name = "NAME")]
    by: Option<String>,
    #[command(flatten)]
    changes: Changes,
    /// Withdraw the check, with nothing in its place
    #[arg(long, conflicts_with = "changes")]
    withdraw: bool,
    /// The station that corrects; default: the name of the computer
    #[arg(long, value_name = "NAME")]
    station: Option<String>,
    #[command(flatten)]
    journal: JournalArgs,
}

/// What is other in the new entry.
#[derive(Debug, clap::Args)]
#[group(id = "changes", multiple = true)]
struct Changes {
    /// The measured value in mm, if it was typed
    #[arg(long, value_name = "MM")]
    measured: Option<String>,
    /// Who measured
    #[arg(long, value_name = "NAME")]
    who: Option<String>,
    /// The part
    #[arg(long, value_name = "NAME")]
    part: Option<String>,
    /// Its serial number
    #[arg(long, value_name = "NO")]
    serial: Option<String>,
    /// The feature of the part
    #[arg(long, value_name = "NAME")]
    feature_name: Option<String>,
    /// The remark
    #[arg(long, value_name = "TEXT")]
    remark: Option<String>,
}

impl Changes {
    fn are_none(&self) -> bool {
        let Self { measured, who, part, serial, feature_name, remark } = self;
        [measured, who, part, serial, feature_name, remark].iter().all(|change| change.is_none())
    }
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        if self.changes.are_none() && !self.withdraw {
            return Err(CliError::NothingCorrected);
        }
        let file = self.journal.file()?;
        let reader = Reader::open(&file).said()?;
        let row = row(&reader, self.number, reader.head().said()?.number, &file)?;
        drop(reader);
        let (about, check) = standing(&row)?;
        let about = self.about(about);
        let by = self.by.clone().unwrap_or_else(here::user);
        let correction = Correction { target: row.kept.head, reason: self.reason.clone(), by };
        let content = if self.withdraw {
            Content::Withdrawal(correction)
        } else {
            let mut check = check.clone();
            if let Some(text) = &self.changes.measured {
                check.what = Checked::Size(Arc::new(self.again(&check, text)?));
            }
            check.corrects = Some(correction);
            Content::Check(Box::new(check))
        };
        let entry = Entry { about: about.clone(), content };
        keep(&file, &about, &[entry], io)?;
        if let (true, Some(corrected)) = (self.withdraw, &check.corrects) {
            io.warn(&CliWarning::NeitherStands { target: corrected.target.number, number: self.number });
        }
        Ok(Outcome::Done)
    }

    /// Who, where and when: the station that corrects, now, and what was known with its changes.
    fn about(&self, old: &About) -> About {
        let Changes { who, part, serial, feature_name, remark, measured: _ } = &self.changes;
        let or = |new: &Option<String>, old: &String| new.as_ref().unwrap_or(old).clone();
        About {
            station: self.station.clone().unwrap_or_else(here::computer),
            time: here::moment(),
            who: or(who, &old.who),
            part: or(part, &old.part),
            serial: or(serial, &old.serial),
            feature: or(feature_name, &old.feature),
            remark: or(remark, &old.remark),
        }
    }

    /// The record with another typed value, judged by the same limits and the same rule.
    fn again(&self, check: &Check, text: &str) -> Result<Record, CliError> {
        let diameter = crate::cli::diameter(text, ErrorSubject::MeasuredValue)?;
        let again = match &check.what {
            Checked::Size(record) => record.typed_again(diameter),
            Checked::Cycle(_) => None,
        };
        again.ok_or(CliError::NotTyped { number: self.number })
    }
}

/// A check that may be corrected: one that nothing has corrected yet.
fn standing(row: &ListedEntry) -> Result<(&About, &Check), CliError> {
    let number = row.kept.head.number;
    if let Some(by) = row.corrected_by {
        return Err(CliError::AlreadyCorrectedBy { number, by });
    }
    match &row.entry {
        Ok(Entry { about, content: Content::Check(check) }) => Ok((about, check)),
        Ok(_) => Err(CliError::NoCheck { number }),
        Err(error) => Err(error.clone()).about(&ErrorSubject::Entry { number }),
    }
}
