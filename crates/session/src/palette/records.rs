//! Records among what the palette finds: asked of the journal, off the frame, and added when the answer comes.

use std::sync::Arc;

use fitcheck_core::message::{Message, message};
use fitcheck_core::words::Words;
use fitcheck_exchange::journal::ask::Question;

use super::entry::{PaletteEntry, PaletteGroup, Subject};
use crate::Session;
use crate::command::Command;
use crate::page::Page;
use crate::records::{RecordRow, RecordsCommand, RowTexts};

/// How many records are asked for.
pub(super) const MOST: usize = 5;

/// The fewest characters that records are asked about.
const FEWEST: usize = 2;

/// The question that a query asks of the journal: records of a callout, or those with these words.
pub(super) fn question(query: &str, session: &Session) -> Option<Question> {
    let query = query.trim();
    if !session.recording().is_on() || query.chars().count() < FEWEST {
        return None;
    }
    let question = match query.parse::<fitcheck_core::tolerance::Callout>() {
        Ok(callout) => format!("callout:\"{callout}\""),
        Err(_no_callout) => query.to_owned(),
    };
    // What is no question finds no record, and may still find everything else. What was corrected or withdrawn is found on its page.
    let question = format!("{question} standing");
    crate::records::question(&question, &session.shared).ok()
}

/// Shows a record on its page.
pub(super) fn show(row: &RecordRow) -> Vec<Command> {
    vec![Command::OpenPage(Page::Records), RecordsCommand::Open(row.head.number).into()]
}

/// The entry of a record.
fn entry(row: &Arc<RecordRow>, words: &Words) -> PaletteEntry {
    let number = row.head.number;
    let RowTexts { time, callout, measured, status, .. } = RowTexts::of(row, words);
    let about = row.entry.as_ref().map(|entry| [entry.about.part.clone(), entry.about.serial.clone()]);
    let [part, serial] = about.unwrap_or_default();
    let parts = [callout, part, serial, measured, status, time];
    let note: Vec<String> = parts.into_iter().filter(|part| !part.is_empty()).collect();
    let text = words.say(&message!("records-page-record").text("number", number));
    PaletteEntry {
        note: note.join(", "),
        subject: Subject::Record(Arc::clone(row)),
        ..PaletteEntry::new(PaletteGroup::Records, text, show(row))
    }
}

/// Why no records can be read.
pub(super) fn problem(why: &Message, words: &Words) -> PaletteEntry {
    let text = words.say(&message!("records-page-unread").message("why", why.clone()));
    PaletteEntry { is_possible: false, ..PaletteEntry::new(PaletteGroup::Records, text, Vec::new()) }
}

/// The entries of what was found.
pub(super) fn entries(rows: &[Arc<RecordRow>], words: &Words) -> Vec<PaletteEntry> {
    rows.iter().map(|row| entry(row, words)).collect()
}
