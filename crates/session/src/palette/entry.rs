//! One entry of the palette, and every one that there is.

use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::path::PathBuf;
use std::sync::Arc;

use fitcheck_core::message::message;
use fitcheck_core::tolerance::Callout;
use fitcheck_core::words::{Language, Words};

use crate::Session;
use crate::action::{Action, ActionScope, Shortcut, WindowAction};
use crate::budget::BudgetAction;
use crate::check::{CheckCommand, CheckField};
use crate::command::Command;
use crate::field::Field;
use crate::field_table::FieldPlace;
use crate::files::FilesCommand;
use crate::help::{
    CONTENTS, HelpCommand, HelpField, HelpPlace, HelpTopic, ManualPage, TERMS, is_in_a_line, manual, topics,
};
use crate::page::Page;
use crate::parts::PartsAction;
use crate::purpose::Purpose;
use crate::records::RecordRow;
use crate::settings_page::{SettingsAction, setting_of};
use crate::tables::TablesAction;

/// From so many letters on the manual is searched, too.
const FEWEST_LETTERS: usize = 3;

/// Under which head an entry stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum PaletteGroup {
    /// What can be done.
    Do,
    /// Pages, fields, recent files and samples.
    Open,
    /// How the window looks, where limits come from, and the manual.
    Settings,
    /// What was recorded; it comes after everything else, when it comes.
    Records,
}

impl PaletteGroup {
    /// The id of its head.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Do => "palette-do",
            Self::Open => "palette-open",
            Self::Settings => "palette-settings",
            Self::Records => "palette-records",
        }
    }
}

/// What an entry stands for.
#[derive(Debug, Clone)]
pub(super) enum Does {
    Action(Action),
    Commands(Vec<Command>),
}

/// Something that can be chosen.
#[derive(Debug, Clone)]
pub struct PaletteEntry {
    pub group: PaletteGroup,
    pub text: String,
    /// What else is to be known: the page of an action, the folder of a file, the limits of a callout.
    pub note: String,
    /// Its keys on its page.
    pub keys: Option<Shortcut>,
    /// Whether it can be done now.
    pub is_possible: bool,
    /// Everything that it is found by, in small letters: its name in every language.
    pub(super) names: Vec<String>,
    pub(super) does: Does,
    pub(super) subject: Subject,
}

/// What an entry is about: what else can be done follows from it.
#[derive(Debug, Clone)]
pub(super) enum Subject {
    Nothing,
    Action(Action),
    Field(Field),
    Callout(Callout),
    /// What stands below a heading of the manual.
    Heading,
    File(PathBuf, Purpose),
    Record(Arc<RecordRow>),
}

impl PaletteEntry {
    /// An entry that does some commands.
    pub(super) const fn new(group: PaletteGroup, text: String, does: Vec<Command>) -> Self {
        Self {
            group,
            text,
            note: String::new(),
            keys: None,
            is_possible: true,
            names: Vec::new(),
            does: Does::Commands(does),
            subject: Subject::Nothing,
        }
    }

    /// The action that it does, where it is one.
    pub const fn action(&self) -> Option<Action> {
        if let Subject::Action(action) = &self.subject { Some(*action) } else { None }
    }

    /// Whether it takes away what somebody has made.
    pub(super) const fn removes(&self) -> bool {
        matches!(
            self.action(),
            Some(
                Action::Window(WindowAction::ClearHistory | WindowAction::ForgetRecent | WindowAction::NoOwnTables)
                    | Action::Settings(SettingsAction::NoOwnTexts)
                    | Action::Tables(TablesAction::RemoveColumn | TablesAction::EmptyCell)
                    | Action::Parts(PartsAction::EmptyPlanCells | PartsAction::DeletePlanRows)
                    | Action::Budget(BudgetAction::RemoveContribution)
            )
        )
    }

    /// The page that it belongs to; `None` where it is a file or belongs to every page.
    pub fn page(&self) -> Option<Page> {
        match &self.subject {
            Subject::Action(Action::Window(WindowAction::Open(page))) => Some(*page),
            Subject::Action(action) => action.place().page(),
            Subject::Field(field) => Some(field.page()),
            Subject::Callout(_) => Some(Page::Check),
            Subject::Record(_) => Some(Page::Records),
            Subject::Nothing | Subject::Heading => Some(Page::Help),
            Subject::File(..) => None,
        }
    }

    /// Whether something else can be done with it.
    pub const fn has_more(&self) -> bool {
        !matches!(self.subject, Subject::Nothing | Subject::Heading)
    }

    /// Whether it is a heading within a page of the manual: there are many, so they are found and not listed.
    pub(super) const fn is_heading(&self) -> bool {
        matches!(self.subject, Subject::Heading)
    }
}

/// Everything that can be found now.
pub(super) fn all(session: &Session) -> Vec<PaletteEntry> {
    let own = session.shared.words();
    let others: Vec<Words> =
        Language::all().filter(|language| *language != session.language()).map(Words::new).collect();
    let mut seen = BTreeSet::new();
    let mut entries = Vec::new();
    for action in Action::all().filter(|action| is_listed(*action)) {
        let entry = of_action(action, session, &own, &others);
        // The steps of a table have one name.
        if seen.insert((entry.text.clone(), entry.note.clone())) {
            entries.push(entry);
        }
    }
    entries.extend(session.recent_files().iter().enumerate().map(|(number, file)| {
        let path = file.path.as_path();
        let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
        let folder = path.parent().map_or(OsStr::new(""), |folder| folder.as_os_str());
        PaletteEntry {
            names: vec![path.display().to_string().to_lowercase()],
            note: folder.to_string_lossy().into_owned(),
            subject: Subject::File(path.to_owned(), file.purpose),
            ..PaletteEntry::new(PaletteGroup::Open, name, vec![FilesCommand::OpenRecent(number).into()])
        }
    }));
    entries.extend(session.fields().into_iter().filter_map(|field| of_field(field, session, &own, &others)));
    entries.extend(topics().map(|topic| of_topic(topic, &own, &others)));
    // The page of terms explains a word before others use it.
    let (terms, pages): (Vec<_>, Vec<_>) = manual().iter().partition(|page| page.file == TERMS);
    let pages = terms.into_iter().chain(pages).filter(|page| page.file != CONTENTS);
    entries.extend(pages.flat_map(|page| of_headings(page, &own, &others)));
    entries
}

/// The entry of a field that stands on its page: the page opens, the part in which it is folded away, too, and it has the focus.
fn of_field(field: Field, session: &Session, own: &Words, others: &[Words]) -> Option<PaletteEntry> {
    if !session.stands(field) {
        return None;
    }
    let beside = |words: &Words| match session.place_of(field) {
        FieldPlace::Fold(fold) => format!("{}, {}", words.get(field.page().name()), words.get(fold)),
        _ => words.get(field.page().name()),
    };
    let name = |words: &Words| session.field_name(field, words);
    let names = std::iter::once(own).chain(others);
    Some(PaletteEntry {
        names: names.map(|words| format!("{} {}", name(words), beside(words)).to_lowercase()).collect(),
        note: beside(own),
        subject: Subject::Field(field),
        ..PaletteEntry::new(PaletteGroup::Open, name(own), vec![Command::OpenPage(field.page()), Command::GoTo(field)])
    })
}

/// The entry of something that can be read on the help page.
fn of_topic(topic: HelpTopic, own: &Words, others: &[Words]) -> PaletteEntry {
    let name = |words: &Words| words.say(&message!("help-page-entry").text("title", topic.title(words)));
    PaletteEntry {
        names: std::iter::once(own).chain(others).map(|words| name(words).to_lowercase()).collect(),
        ..PaletteEntry::new(PaletteGroup::Settings, name(own), vec![HelpCommand::Open(HelpPlace::of(topic)).into()])
    }
}

/// What a word is looked for in the manual with; nothing where the manual has none of it.
pub(super) fn of_manual_search(query: &str, words: &Words) -> Option<PaletteEntry> {
    let query = query.trim();
    if query.chars().count() < FEWEST_LETTERS || !is_in_a_line(query) {
        return None;
    }
    let does = vec![
        Command::OpenPage(Page::Help),
        HelpCommand::Type(HelpField::Search, query.to_owned()).into(),
        HelpCommand::Search.into(),
    ];
    let text = words.say(&message!("palette-search-manual").text("query", query));
    Some(PaletteEntry { subject: Subject::Heading, ..PaletteEntry::new(PaletteGroup::Settings, text, does) })
}

/// The entries of what stands below the headings of a page of the manual, which are the terms on the page of terms.
fn of_headings(page: &'static ManualPage, own: &Words, others: &[Words]) -> impl Iterator<Item = PaletteEntry> {
    page.headings().map(move |(heading, anchor)| {
        let name = |words: &Words| words.say(&message!("help-page-entry").text("title", heading));
        let names = std::iter::once(own).chain(others).map(|words| name(words).to_lowercase());
        let place = HelpPlace::at(page.file, anchor);
        PaletteEntry {
            names: names.chain([heading.to_lowercase()]).collect(),
            note: page.title.clone(),
            subject: Subject::Heading,
            ..PaletteEntry::new(PaletteGroup::Settings, name(own), vec![HelpCommand::Open(place).into()])
        }
    })
}

/// Whether an action stands in the palette: those of a dialog do not, for none is open, nor what only closes the palette.
fn is_listed(action: Action) -> bool {
    action.place() != ActionScope::Dialog
        && !matches!(action, Action::Window(WindowAction::Palette | WindowAction::Close | WindowAction::CloseNotice))
}

fn of_action(action: Action, session: &Session, own: &Words, others: &[Words]) -> PaletteEntry {
    let setting = setting_of(action);
    let group = match action {
        Action::Window(WindowAction::Open(_) | WindowAction::OpenSample(_)) => PaletteGroup::Open,
        Action::Window(WindowAction::Help) => PaletteGroup::Settings,
        _ if setting.is_some() => PaletteGroup::Settings,
        _ => PaletteGroup::Do,
    };
    let page = action.place().page();
    let text = action.text(session, own);
    let elsewhere = others.iter().map(|words| action.text(session, words));
    // A choice alone says little: its setting stands beside it, but not twice where it is a switch.
    let of_setting = setting.map(|setting| setting.name).filter(|name| own.get(name) != text);
    let beside = page.map(Page::name).or(of_setting);
    let on_page = |words: &Words| beside.map_or_else(String::new, |id| words.get(id));
    let pages = std::iter::once(own).chain(others).map(on_page);
    let names = std::iter::once(text.clone()).chain(elsewhere).zip(pages);
    let names = names.map(|(name, page)| format!("{name} {page}").to_lowercase());
    // A page is found by its other name as well, and what can be done on it beside that.
    let opened = if let Action::Window(WindowAction::Open(page)) = action { Some(page) } else { None };
    let also = opened.or(page).and_then(Page::also);
    let also =
        also.into_iter().flat_map(|id| std::iter::once(own).chain(others).map(move |words| (words.get(id), words)));
    let also = also.map(|(also, words)| {
        let name = action.text(session, words);
        if opened.is_some() { format!("{also} {name}") } else { format!("{name} {also}") }.to_lowercase()
    });
    let words = action.row().also.into_iter();
    let words = words.flat_map(|id| {
        let name = move |words: &Words| format!("{} {}", action.text(session, words), words.get(id)).to_lowercase();
        std::iter::once(own).chain(others).map(name)
    });
    PaletteEntry {
        group,
        names: names.chain(also).chain(words).collect(),
        note: on_page(own),
        keys: action.shortcut_on(page.unwrap_or(session.page())),
        is_possible: session.can(action),
        does: Does::Action(action),
        subject: Subject::Action(action),
        text,
    }
}

/// The entry of a callout: the check page checks it, with the limits that it has now.
pub(super) fn of_callout(query: &str, session: &Session, words: &Words) -> Option<PaletteEntry> {
    let query = query.trim();
    // A value may follow: it is judged at once.
    let with_value = || {
        let (callout, value) = query.rsplit_once(char::is_whitespace)?;
        let is_number = value.starts_with(|c: char| c.is_ascii_digit())
            && value.chars().all(|c| c.is_ascii_digit() || c == '.' || c == ',');
        Some((callout.parse::<Callout>().ok()?, is_number.then_some(value)?))
    };
    let (callout, value) = match query.parse::<Callout>() {
        Ok(callout) => (callout, None),
        Err(_) => with_value().map(|(callout, value)| (callout, Some(value)))?,
    };
    let limits = session.sources().limits(&callout, callout.feature()).ok()?;
    let range = format!("{} … {}", words.mm(limits.minimum(), 3), words.mm(limits.maximum(), 3));
    let text = callout.to_string();
    let said = match value {
        Some(value) => message!("palette-check-value").text("callout", &text).text("value", value),
        None => message!("palette-check").text("callout", &text),
    };
    let said = words.say(&said);
    let mut does = vec![
        Command::OpenPage(Page::Check),
        CheckCommand::Type(CheckField::Callout, text).into(),
        Command::GoTo(CheckField::Measured.into()),
    ];
    if let Some(value) = value {
        does.push(CheckCommand::Type(CheckField::Measured, value.to_owned()).into());
        does.push(CheckCommand::Measure.into());
    }
    Some(PaletteEntry {
        note: format!("{range} mm"),
        subject: Subject::Callout(callout),
        ..PaletteEntry::new(PaletteGroup::Do, said, does)
    })
}
