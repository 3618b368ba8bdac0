//! `fitcheck journal verify`: whether every entry is the one that was written.

use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use super::inspected::{InspectedAnswer, bar};
use super::written::{Written, WrittenAnswer};
use super::{CliError, CliRemark, Format, IntoCliError as _, Io, JournalArgs, Outcome, server};
use crate::cli::args::one_of;
use crate::cli::journal_place::JournalPlace;
use crate::journal::chain::{ChainId, Head, HexError};
use crate::journal::inspection::Break;
use crate::store::StoreRemark;
use crate::store::local::{self, Anchors, Reader, Verified};

const HELP: &str = "\
The chain shows an entry that was changed, removed, inserted or moved. To find out whether the
newest entries were cut off, an older copy was put back or everything was rewritten, verify needs an
entry that is known elsewhere: the last one that this computer has seen, which Fitcheck keeps beside
its settings, and those that --head gives.

With FILE, verify also says whether this file is a report that was written: when, by whom and where,
of which checks, and which of them were corrected or withdrawn since. A file is recognised by its
bytes, whatever it is called. Data in it (a file of JSON, or what a PDF has attached) is compared
with the journal, check by check; of a file that is not known, with the newest report of its name.

Examples:
  fitcheck journal verify
  fitcheck journal verify --head 1204:9f86d081…
  fitcheck journal verify flange.html

The exit code is 1 if anything is not as it was written, and if a file is not known.";

/// Verify every entry of a journal
#[derive(Debug, clap::Args)]
#[command(after_help = HELP)]
pub(super) struct Args {
    /// Reports to look for in the journal, in whatever format
    #[arg(value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Entry that is known elsewhere, such as from a report or a backup, by its number and hash; on a server, its chain comes first
    #[arg(long = "head", value_name = "[CHAIN:]NUMBER:HASH", value_parser = head)]
    heads: Vec<Known>,
    /// Format of the answer
    #[arg(long, value_name = "FORMAT", default_value = "text", value_parser = one_of([Format::Text, Format::Json], |format| format.word()))]
    format: Format,
    #[command(flatten)]
    journal: JournalArgs,
}

/// An entry that is known elsewhere, and perhaps its chain.
type Known = (Option<ChainId>, Head);

fn head(text: &str) -> Result<Known, String> {
    let hex = |error: HexError| error.to_string();
    let (chain, text) = match text.split_once(':') {
        Some((chain, rest)) if rest.contains(':') => (Some(chain.parse().map_err(hex)?), rest),
        _ => (None, text),
    };
    let (number, hash) = text.split_once(':').ok_or("expected a number, a colon and a hash, such as 12:9f86…")?;
    let number: u64 = number.parse().map_err(|_not_one| format!("{number} is not the number of an entry"))?;
    if number == 0 {
        return Err("entries count from 1".to_owned());
    }
    Ok((chain, Head { number, hash: hash.parse().map_err(hex)? }))
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let file = match self.journal.place()? {
            JournalPlace::File(file) => file,
            JournalPlace::Server(_) if !self.files.is_empty() => return Err(CliError::JournalIsServer),
            JournalPlace::Server(address) => {
                let known = self.heads.iter().map(|(chain, head)| Some(((*chain)?, *head)));
                let known: Vec<_> = known.collect::<Option<_>>().ok_or(CliError::HeadWithoutChain)?;
                let is_whole = server::verify(&address, &known, self.format == Format::Json, io)?;
                return Ok(if is_whole { Outcome::Done } else { Outcome::BadData });
            }
        };
        let chain = Reader::open(&file).said()?.chain();
        if let Some(other) = self.heads.iter().find_map(|(given, _)| given.filter(|given| *given != chain)) {
            return Err(CliError::HeadOfOther { chain: chain.to_string(), other: other.to_string() });
        }
        let (mut known, replaced) = known_elsewhere(&file, chain, io);
        known.extend(self.heads.iter().map(|(_, head)| head));
        let bar = bar();
        let found = local::verify(&file, &known, &mut |done, all| {
            bar.set_length(all);
            bar.set_position(done);
            ControlFlow::Continue(())
        });
        bar.finish_and_clear();
        let found = found.said()?;
        let files = self.written(&file, io)?;
        let are_known = files.len() == self.files.len() && files.iter().all(Written::is_whole);
        if self.format == Format::Json {
            io.json(&Answer::of(&found, chain, replaced.as_ref(), &files));
        } else {
            print(&found, &known, replaced.as_ref(), io);
            for file in &files {
                file.print(chain, found.is_whole() && replaced.is_none(), io);
            }
        }
        let is_whole = found.is_whole() && replaced.is_none() && are_known;
        Ok(if is_whole { Outcome::Done } else { Outcome::BadData })
    }

    /// What is found of the files; one that cannot be read is told, and the others are looked for all the same.
    fn written(&self, journal: &Path, io: &mut Io<'_>) -> Result<Vec<Written>, CliError> {
        let reader = Reader::open(journal).said()?;
        let mut found = Vec::new();
        for path in &self.files {
            match Written::of(path, &reader) {
                Ok(written) => found.push(written),
                Err(error @ CliError::File(_)) => io.fail(error),
                Err(error) => return Err(error),
            }
        }
        Ok(found)
    }
}

/// The last entries of the chain that this computer has seen; and whether another journal was in this file.
fn known_elsewhere(file: &Path, chain: ChainId, io: &mut Io<'_>) -> (Vec<Head>, Option<StoreRemark>) {
    let Some(path) = Anchors::of_user() else { return (Vec::new(), None) };
    match Anchors::read(&path) {
        Ok(anchors) => {
            let other = anchors.at(file).filter(|anchor| anchor.chain != chain);
            let replaced = other.map(|other| StoreRemark::Replaced { path: file.to_owned(), known: other.head.number });
            (anchors.of_chain(chain), replaced)
        }
        Err(reason) => {
            io.warn(&StoreRemark::NoAnchor { path, reason });
            // A journal that was cut off would pass as whole.
            io.look_first();
            (Vec::new(), None)
        }
    }
}

fn print(found: &Verified, known: &[Head], replaced: Option<&StoreRemark>, io: &mut Io<'_>) {
    let inspected = &found.inspected;
    for problem in &inspected.breaks {
        writeln!(io.people(), "{problem}");
    }
    let named = u64::try_from(inspected.breaks.len()).unwrap_or(u64::MAX);
    if named < inspected.count {
        writeln!(io.people(), "… {} more", inspected.count.saturating_sub(named));
    }
    for finding in &found.findings {
        writeln!(io.people(), "{finding}");
    }
    if let Some(replaced) = replaced {
        writeln!(io.people(), "{replaced}");
    }
    let entries = inspected.entries;
    let Head { number, hash } = inspected.head;
    if found.is_whole() && replaced.is_none() {
        writeln!(io.people(), "{entries} entries are as they were written; the last one is {number}:{hash}");
    } else if let Some(first) = inspected.breaks.first().map(Break::number) {
        writeln!(io.people(), "{entries} entries; the first that is not as it was written is {first}");
    }
    if known.is_empty() {
        io.remark(&CliRemark::NoHeadKnown);
    }
}

object! {
    struct Answer of(found: &Verified, chain: ChainId, replaced: Option<&StoreRemark>, written: &[Written]) {
        whole: bool = found.is_whole() && replaced.is_none(),
        chain: String = chain.to_string(),
        entries: u64 = found.inspected.entries,
        #[serde(flatten)]
        inspected: InspectedAnswer = InspectedAnswer::of(&found.inspected),
        findings: Vec<String> =
            found.findings.iter().map(ToString::to_string).chain(replaced.map(ToString::to_string)).collect(),
        #[serde(skip_serializing_if = "Vec::is_empty")]
        files: Vec<WrittenAnswer> = written.iter().map(WrittenAnswer::of).collect(),
    }
}
