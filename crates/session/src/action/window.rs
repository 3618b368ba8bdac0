//! What can be done on every page.

use fitcheck_core::length::Unit;
use fitcheck_core::message::{Message, message};
use fitcheck_core::tolerance::Base;
use fitcheck_core::tolerance::iso286::{Edition, JsHalves, Options};
use fitcheck_core::words::Words;
use fitcheck_exchange::report::{RENDERINGS, Rendering, of_any_paper};

use super::possible::{
    can_export, has_bad, has_history, has_status, is_of_1988, rounds_js, shows_columns, tells_of_file, told_columns,
};
use crate::Session;
use crate::action::row::{ActionRow, Actions, Sends, actions, everywhere};
use crate::action::{ActionScope, Held, Key, Shortcut};
use crate::check::CheckCommand;
use crate::columns::ColumnsCommand;
use crate::command::Command;
use crate::field::Field;
use crate::files::{FilesCommand, Launch};
use crate::help::{HelpCommand, Sample};
use crate::history::ListCommand;
use crate::page::Page;
use crate::palette::PaletteCommand;
use crate::purpose::{ImportInto, Purpose};
use crate::records::{RecordsCommand, RecordsField};
use crate::settings::{Density, Theme};

actions! {
    /// What can be done on every page.
    WindowAction

    Open(Page): Page::ALL;
    /// Opens the palette.
    Palette;
    /// Opens the manual at its page about the open page, or goes back to where one was.
    Help;
    /// Shows the paragraph of the manual about the field that has the focus beside it.
    Explain;
    /// Opens something to try the program with.
    OpenSample(Sample): Sample::ALL;
    /// Shows the first steps on the check page.
    FirstSteps;
    /// Hides them for good.
    EndFirstSteps;
    /// Reads measurements.
    Import;
    /// Reads measurements once their columns were seen.
    ImportColumns;
    /// Imports the file whose columns are shown.
    TakeColumns;
    /// Shows the columns of the file that the notice tells of.
    CorrectColumns;
    /// Forgets what was remembered of them.
    ForgetColumns;
    /// Reads the file again that the notice tells of and that says no unit.
    LengthsInMm;
    LengthsInInches;
    /// Judges a file on the check page that is of no part of the plan.
    JudgeUnplanned;
    /// Writes the checks in a format of the report's list, by its number there.
    Export(usize): of_any_paper();
    /// Writes the status window's text.
    ExportStatus;
    /// Chooses light, dark, or the system's setting.
    UseTheme(Theme): Theme::ALL;
    /// Chooses how high everything is that is pressed.
    UseDensity(Density): Density::ALL;
    /// Looks limits up in a source of the list.
    UseSource(Base): Base::ALL;
    /// Rounds the halves of js, or not.
    RoundJs;
    /// Uses the edition of 1988, or the one of 2010.
    Edition1988;
    /// Reads a folder of the user's own tables.
    LoadTables;
    /// Stops using the user's own tables.
    NoOwnTables;
    /// Reads a mask.
    LoadMask;
    /// Undoes the last change of the history.
    Undo;
    /// Empties the history.
    ClearHistory;
    /// Chooses every listed check that is not good for export.
    ChooseBad;
    ChooseNone;
    /// Shows or hides the keypad.
    Keypad;
    /// Closes what lies over the page: a dialog, a window, the oldest notice.
    Close;
    /// Closes the notice that is shown.
    CloseNotice;
    /// Shows or hides what was told before.
    Messages;
    /// Empties the list of what was told before.
    ForgetMessages;
    /// Opens the file that was written in its own program.
    OpenWritten;
    /// Shows the file that was written in its folder.
    ShowWritten;
    /// Empties the list of recent files.
    ForgetRecent;
    /// Stops reading or writing the file that is at work.
    StopWorking;
    /// Writes again what could not be recorded.
    RecordAgain;
    /// The name in the field measures from now on.
    TakeName;
}

impl Actions for WindowAction {
    #[expect(clippy::too_many_lines, reason = "one row for everything that can be done")]
    fn row(&self) -> ActionRow {
        match *self {
            Self::Open(page) => {
                let row = everywhere(page.name(), Command::OpenPage(page));
                match page.digit() {
                    Some(digit) => row.key(Shortcut::ctrl(digit)),
                    None => row,
                }
            }
            Self::Palette => everywhere("palette", PaletteCommand::Show(true).into()).key(Shortcut::ctrl('K')),
            Self::Help => everywhere("help-page-help", HelpCommand::ForPage.into())
                .hint("help-page-help-hint")
                .key(Shortcut::plain(Key::Function(1))),
            Self::Explain => {
                switch("help-page-explain", |session| HelpCommand::Explain(!session.help().explains).into())
                    .hint("help-page-explain-hint")
                    .key(Shortcut { held: Held::Shift, key: Key::Function(1) })
                    .when(|session| session.help().at.is_some())
            }
            Self::OpenSample(sample) => {
                let text = match sample {
                    Sample::Value => "help-page-sample-value",
                    Sample::Part => "help-page-sample-part",
                    Sample::File => "help-page-sample-file",
                    Sample::Program => "help-page-sample-program",
                };
                everywhere(text, FilesCommand::Open(sample.purpose(), sample.path()).into())
                    .hint("help-page-sample-hint")
            }
            Self::FirstSteps => everywhere("first-steps", Command::Welcome(true)),
            Self::EndFirstSteps => everywhere("first-steps-done", Command::Welcome(false)).when(Session::welcomes),
            Self::Import => everywhere("import", open(Purpose::Import)).key(Shortcut::ctrl('O')),
            Self::ImportColumns => everywhere("columns-page-import", open(Purpose::AskColumns(ImportInto::History)))
                .hint("columns-page-hint"),
            Self::TakeColumns => {
                ActionRow::new(ActionScope::Dialog, "columns-page-take", Sends::Always(ColumnsCommand::Take.into()))
                    .key(Shortcut { held: Held::Ctrl, key: Key::Enter })
                    .when(|session| shows_columns(session).is_some_and(|open| open.refusal.is_none()))
            }
            Self::CorrectColumns => everywhere("columns-page-correct", ColumnsCommand::Correct.into())
                .when(|session| told_columns(session).is_some_and(|columns| !columns.lacks_unit)),
            Self::LengthsInMm => everywhere("columns-page-in-mm", ColumnsCommand::In(Unit::Millimetre).into())
                .when(|session| told_columns(session).is_some_and(|columns| columns.lacks_unit)),
            Self::LengthsInInches => everywhere("columns-page-in-inches", ColumnsCommand::In(Unit::Inch).into())
                .when(|session| told_columns(session).is_some_and(|columns| columns.lacks_unit)),
            Self::JudgeUnplanned => everywhere("judge-unplanned", FilesCommand::JudgeUnplanned.into())
                .when(|session| session.unplanned_file().is_some()),
            Self::ForgetColumns => everywhere("columns-page-forget", ColumnsCommand::Forget.into())
                .when(|session| told_columns(session).is_some_and(|columns| columns.shape.is_some())),
            Self::Export(number) => {
                let row = everywhere("export", open(Purpose::Export(number))).when(can_export);
                if number == 0 { row.key(Shortcut::ctrl('S')) } else { row }
            }
            Self::ExportStatus => everywhere("export-status-check", open(Purpose::ExportStatus)).when(has_status),
            Self::UseTheme(theme) => {
                let text = match theme {
                    Theme::System => "theme-system",
                    Theme::Light => "theme-light",
                    Theme::Dark => "theme-dark",
                    Theme::Contrast => "theme-contrast",
                    Theme::Inverted => "theme-inverted",
                };
                everywhere(text, Command::SetTheme(theme))
            }
            Self::UseDensity(density) => {
                let text = match density {
                    Density::ByUse => "density-by-use",
                    Density::Mouse => "density-mouse",
                    Density::Touch => "density-touch",
                };
                everywhere(text, Command::SetDensity(density))
            }
            Self::UseSource(base) => everywhere(base.text(), Command::UseSource(base)),
            Self::RoundJs => switch("standard-js-rounded", |session| {
                let options = session.sources().options();
                let js = if rounds_js(options) { JsHalves::Exact } else { JsHalves::Rounded };
                Command::SetStandard(Options { js, ..options })
            }),
            Self::Edition1988 => switch("standard-1988", |session| {
                let options = session.sources().options();
                let edition = if is_of_1988(options) { Edition::Of2010 } else { Edition::Of1988 };
                Command::SetStandard(Options { edition, ..options })
            }),
            Self::LoadTables => everywhere("load-tables", open(Purpose::LoadTables)),
            Self::NoOwnTables => {
                let row = everywhere("no-own-tables", Command::NoOwnTables);
                row.when(|session| !session.sources().own().is_empty() || session.sources().absent().is_some())
            }
            Self::LoadMask => everywhere("load-mask", open(Purpose::LoadMask)),
            Self::Undo => everywhere("undo", CheckCommand::Undo.into())
                .key(Shortcut::ctrl('Z'))
                .when(|session| session.history().undoes().is_some()),
            Self::ClearHistory => everywhere("clear-history", CheckCommand::ClearHistory.into()).when(has_history),
            Self::ChooseBad => everywhere("choose-bad", ListCommand::ChooseBad.into()).when(has_bad),
            Self::ChooseNone => everywhere("choose-none", ListCommand::ChooseNone.into())
                .when(|session| 0 < session.history().chosen_count()),
            Self::Keypad => switch("keypad", |session| Command::ShowKeypad(!session.has_keypad())),
            Self::Close => {
                let row = switch("close", |session| session.uppermost().unwrap_or(Command::Close));
                row.key(Shortcut::plain(Key::Escape)).when(|session| session.uppermost().is_some())
            }
            Self::CloseNotice => {
                everywhere("close", Command::CloseNotice).when(|session| !session.notices().is_empty())
            }
            Self::Messages => switch("messages", |session| Command::ShowMessages(!session.shows_messages()))
                .when(|session| session.shows_messages() || 0 < session.earlier_notices().len()),
            Self::ForgetMessages => everywhere("messages-forget", Command::ForgetMessages)
                .when(|session| 0 < session.earlier_notices().len()),
            Self::OpenWritten => {
                everywhere("open-written", FilesCommand::Launch(Launch::Open).into()).when(tells_of_file)
            }
            Self::ShowWritten => {
                everywhere("show-in-folder", FilesCommand::Launch(Launch::ShowInFolder).into()).when(tells_of_file)
            }
            Self::ForgetRecent => everywhere("forget-recent", FilesCommand::ForgetRecent.into())
                .when(|session| !session.recent_files().is_empty()),
            Self::StopWorking => {
                everywhere("working-stop", FilesCommand::StopWorking.into()).when(|session| session.working().is_some())
            }
            Self::RecordAgain => everywhere("records-page-try-again", RecordsCommand::TryAgain.into())
                .when(|session| 0 < session.recording().failed() || session.recording().has_failed_to_open()),
            Self::TakeName => everywhere("records-page-take-name", RecordsCommand::TakeName.into())
                .when(|session| !session.text(RecordsField::Who).trim().is_empty()),
        }
    }

    fn name(&self, session: &Session, words: &Words) -> Option<String> {
        Some(match *self {
            Self::Export(number) if session.lists_rows() && !RENDERINGS.get(number)?.is_for_people => {
                words.say(&message!("rows-export-programs").text("format", RENDERINGS.get(number)?.title))
            }
            Self::Export(number) => report_name(number, words)?,
            Self::ExportStatus => words.say(&session.status_named()),
            // The chosen one is what is in force: own tables come first.
            Self::UseSource(base) if !session.sources().own().is_empty() => {
                words.say(&message!("source-choice-after-own").message("base", Message::new(base.text())))
            }
            Self::Undo => words.say(&message!("undo-what").message("what", session.history().undoes()?)),
            Self::ChooseBad => words.say(&message!("choose-bad").count("count", session.bad_count())),
            _ => return None,
        })
    }

    fn is_on(&self, session: &Session) -> Option<bool> {
        Some(match *self {
            Self::Open(page) => session.page() == page,
            Self::UseTheme(theme) => session.theme() == theme,
            Self::UseDensity(density) => session.density() == density,
            Self::UseSource(base) => session.sources().base() == base,
            Self::RoundJs => rounds_js(session.sources().options()),
            Self::Edition1988 => is_of_1988(session.sources().options()),
            Self::Keypad => session.has_keypad(),
            _ => return None,
        })
    }

    fn on_enter(field: Field, _page: Page) -> Option<Self> {
        (field == RecordsField::Who.into()).then_some(Self::TakeName)
    }
}

/// What writing checks in a format of the report's list is called.
pub(crate) fn report_name(number: usize, words: &Words) -> Option<String> {
    let Rendering { title, is_for_people, .. } = *RENDERINGS.get(number)?;
    let [people, programs] = [message!("export-people"), message!("export-programs")];
    Some(words.say(&if is_for_people { people } else { programs }.text("format", title)))
}

const fn open(purpose: Purpose) -> Command {
    Command::OpenDialog(purpose)
}

fn switch(text: &'static str, command: fn(&Session) -> Command) -> ActionRow {
    ActionRow::new(ActionScope::Everywhere, text, Sends::FromState(command))
}
