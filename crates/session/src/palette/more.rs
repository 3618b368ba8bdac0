//! What else can be done with an entry: Tab shows it.

use std::sync::Arc;

use fitcheck_core::message::message;
use fitcheck_core::tolerance::{Callout, Feature};
use fitcheck_core::words::Words;

use super::entry::{PaletteEntry, PaletteGroup, Subject};
use super::records::show;
use crate::Session;
use crate::action::Action;
use crate::budget::{BudgetCommand, BudgetField};
use crate::command::Command;
use crate::files::FilesCommand;
use crate::fit::{FitCommand, FitField};
use crate::help::{HelpCommand, HelpPlace, HelpTopic};
use crate::page::Page;
use crate::purpose::{CycleFile, Purpose};
use crate::records::{RecordsCommand, RecordsField};
use crate::settings_page::{SettingsCommand, setting_of};
use crate::tables::{TablesCommand, TablesField};

/// What can be done with an entry, first what Enter does.
pub(super) fn more(entry: &PaletteEntry, session: &Session, words: &Words) -> Vec<PaletteEntry> {
    let rest = match &entry.subject {
        Subject::Nothing | Subject::Heading => return Vec::new(),
        Subject::Action(action) => of_action(*action, words),
        Subject::Field(field) => vec![read_about(session.help_of(*field), words)],
        Subject::Callout(callout) => of_callout(callout, words),
        Subject::File(path, purpose) => {
            let others = [Purpose::Import, Purpose::OpenCycleFile(CycleFile::Contacts)].into_iter();
            let others = others.chain([Feature::Hole, Feature::Shaft].map(Purpose::OpenParts));
            // Only a file of measurements can be used in several ways.
            let others = others.filter(|other| *purpose == Purpose::Import && other != purpose);
            let open = |other: Purpose| FilesCommand::Open(other, path.clone()).into();
            others.map(|other| entry_of(words.get(other.title()), vec![open(other)])).collect()
        }
        Subject::Record(row) => {
            // The form needs what the record says: the page is given what was read.
            let read = RecordsCommand::Read { numbers: vec![row.head.number], result: Ok(vec![Arc::clone(row)]) };
            let then = |name: &'static str, then: RecordsCommand| {
                entry_of(words.get(name), [show(row), vec![read.clone().into(), then.into()]].concat())
            };
            vec![
                then("records-page-measure-again", RecordsCommand::MeasureAgain),
                then("records-page-correct", RecordsCommand::Correct(true)),
            ]
        }
    };
    std::iter::once(entry.clone()).chain(rest).collect()
}

const fn entry_of(text: String, does: Vec<Command>) -> PaletteEntry {
    PaletteEntry::new(PaletteGroup::Do, text, does)
}

fn read_about(place: HelpPlace, words: &Words) -> PaletteEntry {
    let title = place.topic.title(words);
    let text = words.say(&message!("help-page-entry").text("title", title));
    entry_of(text, vec![HelpCommand::Open(place).into()])
}

/// Where it is set, and what the manual says of its page.
fn of_action(action: Action, words: &Words) -> Vec<PaletteEntry> {
    let setting = setting_of(action).map(|setting| {
        let show = SettingsCommand::Show(setting.section).into();
        entry_of(words.get("palette-show-setting"), vec![Command::OpenPage(Page::Settings), show])
    });
    let page = action.place().page().unwrap_or(Page::Help);
    let about = read_about(HelpPlace::of(HelpTopic::Manual(page.manual())), words);
    setting.into_iter().chain([about]).collect()
}

/// What other pages do with a callout: the fit with the basic other part, its row in the tables, a budget, its records.
fn of_callout(callout: &Callout, words: &Words) -> Vec<PaletteEntry> {
    let text = callout.to_string();
    let nominal = callout.nominal();
    let in_tables = words.say(&message!("palette-in-tables").text("what", &text));
    let records = words.say(&message!("palette-records-of").text("what", &text));
    let mut found = Vec::new();
    if let Some(class) = callout.class() {
        let fit = match callout.feature() {
            Some(Feature::Shaft) => format!("{nominal} H7/{class}"),
            _ => format!("{nominal} {class}/h6"),
        };
        let title = words.say(&message!("palette-fit").text("fit", &fit));
        let does = vec![Command::OpenPage(Page::Fit), FitCommand::Type(FitField::Callout, fit).into()];
        found.push(entry_of(title, does));
        let filter = format!("{class} {nominal}");
        let does = vec![Command::OpenPage(Page::Tables), TablesCommand::Type(TablesField::Filter, filter).into()];
        found.push(entry_of(in_tables, does));
    }
    let size = BudgetCommand::Type(BudgetField::Size, nominal.to_string()).into();
    let title = words.say(&message!("palette-uncertainty").number("size", nominal));
    found.push(entry_of(title, vec![Command::OpenPage(Page::Budget), size]));
    let question = RecordsCommand::Type(RecordsField::Question, format!("callout:\"{text}\"")).into();
    found.push(entry_of(records, vec![question, Command::OpenPage(Page::Records)]));
    found
}
