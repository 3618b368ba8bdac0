//! A row for every action. Menus, buttons, tooltips and keys are made from it.

use fitcheck_core::tolerance::Feature;
use fitcheck_core::tolerance::iso286::{Edition, JsHalves, Options};
use fitcheck_exchange::journal::query::Column;

use super::possible::{
    asks_to_replace, can_export, cell, differs, free_dialog, has_bad, has_cell, has_cursor, has_history, has_listed,
    has_rows, has_status, has_table, is_after_first, is_after_worst, is_before_best, is_before_last, is_of_1988,
    rounds_js, selected, shows_columns, tells_of_file, told_columns,
};
use super::row::{Row, Sends, everywhere, in_dialog, of_workpiece, on, switch, within};
use super::{Action, Held, Key, Part, Place, Shortcut};
use super::{budget, pairing, parts, program, records};
use crate::check::{CheckCommand, CheckField};
use crate::columns::ColumnsCommand;
use crate::cycles::CyclesCommand;
use crate::files::{FilesCommand, Launch};
use crate::fit::FitCommand;
use crate::tables::{self, TablesCommand, TablesField};
use crate::tools::ToolsCommand;
use crate::workpiece::WorkpieceCommand;
use crate::{
    Command, CycleFile, Density, ImportInto, ListCommand, MeasureBy, Page, Purpose, Rows, RowsCommand, Session, Step,
    Theme,
};

const fn open(purpose: Purpose) -> Command {
    Command::OpenDialog(purpose)
}

#[expect(clippy::too_many_lines, reason = "one table of everything that can be done")]
pub(super) fn row(action: Action) -> Row {
    match action {
        Action::Open(page) => {
            let (text, key) = match page {
                Page::Check => ("page-check", '1'),
                Page::Fit => ("page-fit", '2'),
                Page::Cycles => ("page-cycles", '3'),
                Page::Tables => ("page-tables", '4'),
                Page::Program => ("page-program", '5'),
                Page::Pairing => ("page-pairing", '6'),
                Page::Budget => ("page-budget", '7'),
                Page::Records => ("page-records", '8'),
                Page::Parts => ("page-parts", '9'),
            };
            everywhere(text, Command::OpenPage(page)).key(Shortcut::ctrl(key))
        }
        Action::Import => everywhere("import", open(Purpose::Import)).key(Shortcut::ctrl('O')),
        Action::ImportColumns => {
            everywhere("columns-page-import", open(Purpose::AskColumns(ImportInto::History))).hint("columns-page-hint")
        }
        Action::TakeColumns => Row::new(Place::Dialog, "columns-page-take", Sends::Always(ColumnsCommand::Take.into()))
            .key(Shortcut { held: Held::Ctrl, key: Key::Enter })
            .when(|session| shows_columns(session).is_some_and(|open| open.refusal().is_none())),
        Action::CorrectColumns => everywhere("columns-page-correct", ColumnsCommand::Correct.into())
            .when(|session| told_columns(session).is_some()),
        Action::ForgetColumns => everywhere("columns-page-forget", ColumnsCommand::Forget.into())
            .when(|session| told_columns(session).is_some_and(|columns| columns.shape.is_some())),
        Action::Export(number) => {
            let row = everywhere("export", open(Purpose::Export(number))).when(can_export);
            if number == 0 { row.key(Shortcut::ctrl('S')) } else { row }
        }
        Action::ExportStatus => everywhere("export-status", open(Purpose::ExportStatus)).when(has_status),
        Action::UseTheme(theme) => {
            let text = match theme {
                Theme::System => "theme-system",
                Theme::Light => "theme-light",
                Theme::Dark => "theme-dark",
            };
            everywhere(text, Command::SetTheme(theme))
        }
        Action::UseDensity(density) => {
            let text = match density {
                Density::ByUse => "density-by-use",
                Density::Mouse => "density-mouse",
                Density::Touch => "density-touch",
            };
            everywhere(text, Command::SetDensity(density))
        }
        Action::UseSource(base) => everywhere(base.text(), Command::UseSource(base)),
        Action::RoundJs => switch("standard-js-rounded", |session| {
            let options = session.sources().options();
            let js = if rounds_js(options) { JsHalves::Exact } else { JsHalves::Rounded };
            Command::SetStandard(Options { js, ..options })
        }),
        Action::Edition1988 => switch("standard-1988", |session| {
            let options = session.sources().options();
            let edition = if is_of_1988(options) { Edition::Of2010 } else { Edition::Of1988 };
            Command::SetStandard(Options { edition, ..options })
        }),
        Action::LoadTables => everywhere("load-tables", open(Purpose::LoadTables)),
        Action::NoOwnTables => {
            let row = everywhere("no-own-tables", Command::NoOwnTables);
            row.when(|session| !session.sources().own().is_empty() || session.sources().absent().is_some())
        }
        Action::LoadMask => everywhere("load-mask", open(Purpose::LoadMask)),
        Action::Undo => everywhere("undo", CheckCommand::Undo.into())
            .key(Shortcut::ctrl('Z'))
            .when(|session| session.history().undoes().is_some()),
        Action::ClearHistory => everywhere("clear-history", CheckCommand::ClearHistory.into()).when(has_history),
        Action::ChooseBad => everywhere("choose-bad", ListCommand::ChooseBad.into()).when(has_bad),
        Action::ChooseNone => everywhere("choose-none", ListCommand::ChooseNone.into())
            .when(|session| 0 < session.history().chosen_count()),
        Action::Keypad => switch("keypad", |session| Command::ShowKeypad(!session.has_keypad())),
        Action::Close => {
            let row = switch("close", |session| session.uppermost().unwrap_or(Command::Close));
            row.key(Shortcut::plain(Key::Escape)).when(|session| session.uppermost().is_some())
        }
        Action::OpenWritten => {
            everywhere("open-written", FilesCommand::Launch(Launch::Open).into()).when(tells_of_file)
        }
        Action::ShowWritten => {
            everywhere("show-in-folder", FilesCommand::Launch(Launch::ShowInFolder).into()).when(tells_of_file)
        }
        Action::ForgetRecent => everywhere("forget-recent", FilesCommand::ForgetRecent.into())
            .when(|session| !session.recent_files().is_empty()),

        Action::Browse => in_dialog("dialog-browse", Command::Browse).hint("dialog-browse-hint"),
        Action::FolderUp => in_dialog("dialog-up", FilesCommand::Up)
            .key(Shortcut { held: Held::Alt, key: Key::Up })
            .when(|session| free_dialog(session).is_some_and(|dialog| dialog.list.parent().is_some())),
        Action::HomeFolder => in_dialog("dialog-home", FilesCommand::Home)
            .key(Shortcut { held: Held::Alt, key: Key::Home })
            .when(|session| free_dialog(session).is_some() && session.home().is_some()),
        Action::AllFiles => Row::new(
            Place::Dialog,
            "dialog-all-files",
            Sends::FromState(|session| {
                FilesCommand::ShowAll(!free_dialog(session).is_some_and(|dialog| dialog.list.shows_all())).into()
            }),
        )
        .when(|session| free_dialog(session).is_some()),
        Action::MoveFile(step) => in_dialog("dialog-move", FilesCommand::Move(step))
            .key(keys(step))
            .when(|session| free_dialog(session).is_some_and(|dialog| !dialog.list.is_empty())),
        Action::ReplaceFile => {
            Row::new(Place::Dialog, "dialog-replace", Sends::Always(FilesCommand::Replace(true).into()))
                .when(asks_to_replace)
        }
        Action::KeepFile => Row::new(Place::Dialog, "dialog-keep", Sends::Always(FilesCommand::Replace(false).into()))
            .when(asks_to_replace),

        Action::Measure => on(Page::Check, "measure", CheckCommand::Measure),
        Action::JudgeAnyway => {
            on(Page::Check, "judge-anyway", CheckCommand::Measure).when(|session| session.check().question().is_some())
        }
        Action::TakeMeant => on(Page::Check, "take-meant", CheckCommand::TakeMeant)
            .when(|session| session.check().question().is_some_and(|question| question.doubt.meant().is_some())),
        Action::TakeText => on(Page::Check, "take-text", CheckCommand::TakeText)
            .when(|session| session.check().doubted().is_some_and(|doubted| doubted.meant.is_some())),
        Action::KeepText => on(Page::Check, "keep-text", CheckCommand::KeepText)
            .when(|session| session.check().doubted().is_some_and(|doubted| doubted.can_stay)),
        Action::ShowInLot(step) => {
            let (text, possible): (_, fn(&Session) -> bool) = match step {
                Step::First => ("lot-worst", is_after_worst),
                Step::Left => ("lot-worse", is_after_worst),
                Step::Right => ("lot-better", is_before_best),
                _ => ("lot-best", is_before_best),
            };
            let row = on(Page::Check, text, CheckCommand::ShowInLot(step)).when(possible);
            row.key(Shortcut { held: Held::Alt, ..keys(step) })
        }
        Action::ClearResult => on(Page::Check, "clear", CheckCommand::Clear),
        Action::MeasureBy(by) => {
            let text = match by {
                MeasureBy::Typing => "by-typing",
                MeasureBy::Simulating => "by-simulating",
            };
            on(Page::Check, text, CheckCommand::MeasureBy(by))
        }
        Action::CopyStatus => on(Page::Check, "copy", CheckCommand::CopyStatus).when(has_status),
        Action::FindInHistory => on(Page::Check, "history-filter", Command::GoTo(CheckField::HistoryFilter.into()))
            .key(Shortcut::ctrl('F'))
            .when(has_history),
        Action::OnlyBad => Row::new(
            Place::Page(Page::Check),
            "history-only-bad",
            Sends::FromState(|session| ListCommand::OnlyBad(!session.history().listed().query().only_bad).into()),
        )
        .hint("history-only-bad-hint"),
        Action::SortHistory(column) => {
            let text = match column {
                Column::Time => "head-time",
                Column::Part => "head-part",
                Column::Callout => "head-callout",
                Column::Measured => "head-measured",
                Column::Deviation => "head-deviation",
                Column::Status => "head-status",
                Column::From => "head-from",
            };
            on(Page::Check, text, ListCommand::SortBy(column)).hint("history-sort-hint")
        }
        Action::MoveCheck(step) => {
            within(Part::History, "history-move", ListCommand::Move(step)).key(keys(step)).when(has_listed)
        }
        Action::ShowCheck => Row::new(
            Place::Part(Part::History),
            "history-show",
            Sends::FromState(|session| CheckCommand::Show(session.history().cursor().unwrap_or_default()).into()),
        )
        .key(Shortcut::plain(Key::Enter))
        .when(has_cursor),
        Action::ChooseCheck => Row::new(
            Place::Part(Part::History),
            "history-choose",
            Sends::FromState(|session| {
                let id = session.history().cursor().unwrap_or_default();
                CheckCommand::Choose(id, !session.history().is_chosen(id)).into()
            }),
        )
        .key(Shortcut::plain(Key::Space))
        .when(has_cursor),
        Action::ChooseAll => {
            within(Part::History, "choose-all", ListCommand::ChooseAll).key(Shortcut::ctrl('A')).when(has_listed)
        }
        Action::CopyChecks => within(Part::History, "copy-checks", ListCommand::Copy)
            .key(Shortcut::ctrl('C'))
            .when(|session| 0 < session.history().chosen_count() || has_cursor(session)),

        Action::ShowRows(shows_rows) => {
            let text = if shows_rows { "rows" } else { "history" };
            on(Page::Check, text, RowsCommand::Show(shows_rows)).when(|session| session.check().rows().is_some())
        }
        Action::CancelRows => on(Page::Check, "rows-cancel", RowsCommand::Cancel)
            .key(Shortcut::plain(Key::Escape))
            .when(|session| session.check().rows().is_some_and(Rows::is_running)),
        Action::JudgeRowsAgain => on(Page::Check, "rows-again", RowsCommand::Again)
            .when(|session| session.check().rows().is_some_and(|rows| !rows.is_running())),
        Action::CloseRows => on(Page::Check, "rows-close", RowsCommand::Close)
            .hint("rows-close-hint")
            .when(|session| session.check().rows().is_some()),
        Action::MoveRow(step) => {
            within(Part::Rows, "rows-move", RowsCommand::Move(step)).key(keys(step)).when(has_rows)
        }
        Action::ShowRow => Row::new(
            Place::Part(Part::Rows),
            "rows-show",
            Sends::FromState(|session| {
                RowsCommand::Check(session.check().rows().and_then(Rows::cursor).unwrap_or_default()).into()
            }),
        )
        .key(Shortcut::plain(Key::Enter))
        .when(|session| session.check().rows().is_some_and(|rows| rows.look().1.is_some())),
        Action::KeepRow => on(Page::Check, "rows-keep", RowsCommand::Keep)
            .when(|session| session.check().rows().and_then(Rows::shown).is_some_and(|row| row.record.is_some())),

        Action::MoveClass(step) => within(Part::Classes, "fit-move", FitCommand::Move(step)).key(keys(step)),
        Action::ShowClasses(feature) => {
            let text = match feature {
                Feature::Hole => "classes-hole",
                Feature::Shaft => "classes-shaft",
            };
            on(Page::Fit, text, FitCommand::ShowClasses(feature))
        }
        Action::CheckPart(part) => {
            let (text, possible): (_, fn(&Session) -> bool) = match part {
                Feature::Hole => ("fit-check-hole", |session| session.fit().class(Feature::Hole).is_some()),
                Feature::Shaft => ("fit-check-shaft", |session| session.fit().class(Feature::Shaft).is_some()),
            };
            on(Page::Fit, text, FitCommand::Check(part)).when(possible)
        }

        Action::RunCycle => on(Page::Cycles, "cycles-run", CyclesCommand::Run).key(Shortcut::plain(Key::Function(5))),
        Action::ClearCycle => on(Page::Cycles, "clear", CyclesCommand::Clear),
        Action::StepPath(step) => {
            let (text, possible): (_, fn(&Session) -> bool) = match step {
                Step::First => ("cycles-first", is_after_first),
                Step::Left => ("cycles-back", is_after_first),
                Step::Right => ("cycles-next", is_before_last),
                _ => ("cycles-last", is_before_last),
            };
            let row = on(Page::Cycles, text, CyclesCommand::Step(step)).when(possible);
            row.key(Shortcut { held: Held::Alt, ..keys(step) })
        }
        Action::EditWorkpiece => of_workpiece("cycles-workpiece", WorkpieceCommand::Show(true)),
        Action::SuitWorkpiece => of_workpiece("cycles-suit", WorkpieceCommand::Suit),
        Action::OpenWorkpiece => {
            of_workpiece("cycles-open-workpiece", open(Purpose::OpenCycleFile(CycleFile::Workpiece)))
        }
        Action::SaveWorkpiece => of_workpiece("cycles-save-workpiece", open(Purpose::SaveWorkpiece))
            .when(|session| session.workpiece().simulation().is_some()),
        Action::OpenContacts => of_workpiece("cycles-open-contacts", open(Purpose::OpenCycleFile(CycleFile::Contacts))),
        Action::OpenTools => of_workpiece("tools-open", open(Purpose::OpenTools)),
        Action::CloseTools => {
            of_workpiece("tools-close", ToolsCommand::Close).when(|session| session.tools().is_some())
        }
        Action::SaveTools => {
            of_workpiece("tools-save", open(Purpose::SaveTools)).when(|session| session.changed_tools().is_some())
        }
        Action::OpenProbes => on(Page::Cycles, "cycles-open-probes", open(Purpose::OpenCycleFile(CycleFile::Probes))),
        Action::ShippedProbes => on(Page::Cycles, "cycles-shipped-probes", CyclesCommand::ShippedProbes)
            .when(|session| session.cycles().probes_name().is_some()),
        Action::PasteBlock => on(Page::Cycles, "cycles-paste-block", CyclesCommand::ShowBlock(true)),
        Action::TakeBlock => {
            on(Page::Cycles, "cycles-fill", CyclesCommand::TakeBlock).when(|session| session.cycles().block().is_some())
        }
        Action::CopyBlock => on(Page::Cycles, "cycles-copy-block", CyclesCommand::CopyBlock)
            .when(|session| session.cycles().is_complete()),
        Action::CopyCycleStatus => on(Page::Cycles, "copy", CyclesCommand::CopyStatus)
            .when(|session| session.cycles().window(session.drawn_with()).is_some_and(|window| window.is_ok())),
        Action::CopyResults => on(Page::Cycles, "copy", CyclesCommand::CopyResults)
            .when(|session| session.cycles().run().is_some_and(|run| run.found().is_some())),
        Action::SaveLog => on(Page::Cycles, "cycles-save-log", open(Purpose::SaveCycleLog))
            .when(|session| session.cycles().log().is_some()),

        Action::OpenTable => on(Page::Tables, "tables-open", open(Purpose::OpenTable)).key(Shortcut::ctrl('O')),
        Action::SaveTable(number) => {
            let row = on(Page::Tables, "tables-save", open(Purpose::SaveTable(number))).when(has_table);
            if number == 0 { row.key(Shortcut::ctrl('S')) } else { row }
        }
        Action::UndoEdit => on(Page::Tables, "undo", TablesCommand::Undo)
            .key(Shortcut::ctrl('Z'))
            .when(|session| session.tables().shown().is_some_and(tables::Document::can_undo)),
        Action::RedoEdit => on(Page::Tables, "tables-redo", TablesCommand::Redo)
            .keys(Shortcut::ctrl('Y'), Shortcut { held: Held::CtrlShift, key: Key::Character('Z') })
            .when(|session| session.tables().shown().is_some_and(tables::Document::can_redo)),
        Action::UseTable => on(Page::Tables, "tables-use", TablesCommand::Use)
            .when(|session| has_table(session) && !session.tables().is_used(session.sources())),
        Action::FindInTable => on(Page::Tables, "tables-filter", Command::GoTo(TablesField::Filter.into()))
            .key(Shortcut::ctrl('F'))
            .when(has_table),
        Action::PreviousDifference => on(Page::Tables, "tables-previous", TablesCommand::PreviousDifference)
            .key(Shortcut::shift(Key::Function(8)))
            .when(differs),
        Action::NextDifference => on(Page::Tables, "tables-next", TablesCommand::NextDifference)
            .key(Shortcut::plain(Key::Function(8)))
            .when(differs),
        Action::MoveCell(step) => within(Part::Cells, "tables-move", TablesCommand::Move(step)).key(keys(step)),
        Action::EditCell => within(Part::Cells, "tables-edit-cell", Command::GoTo(TablesField::CellUpper.into()))
            .keys(Shortcut::plain(Key::Enter), Shortcut::plain(Key::Function(2)))
            .when(has_cell),
        Action::SetCell => on(Page::Tables, "tables-set", TablesCommand::SetCell).when(has_cell),
        Action::TakeStandard => on(Page::Tables, "tables-take-standard", TablesCommand::TakeStandard).when(|session| {
            let standard = selected(session).and_then(|(document, (class, range))| document.standard(class, range));
            standard.is_some() && standard != cell(session)
        }),
        Action::EmptyCell => within(Part::Cells, "tables-empty-cell", TablesCommand::EmptyCell)
            .key(Shortcut::plain(Key::Delete))
            .when(|session| cell(session).is_some()),
        Action::AddColumns => on(Page::Tables, "tables-add-columns", TablesCommand::AddColumns).when(has_table),
        Action::RemoveColumn => on(Page::Tables, "tables-remove-column", TablesCommand::RemoveColumn).when(has_cell),
        Action::MakeTable => on(Page::Tables, "tables-make", TablesCommand::Make),

        Action::OpenPart => program::open_part(),
        Action::OpenProgram => program::open(),
        Action::RunProgram => program::run(),
        Action::PauseProgram => program::pause(),
        Action::StepProgram => program::step(),
        Action::StepOver => program::step_over(),
        Action::RunToSelected => program::run_to_selected(),
        Action::ToggleBreakpoint => program::toggle_breakpoint(),
        Action::ResetProgram => program::reset(),
        Action::Switch(switch) => program::switch(switch),
        Action::MoveBlock(step) => program::go(step).key(keys(step)),
        Action::GiveValue => program::give_value(),

        Action::NewBudget => budget::begin(),
        Action::OpenBudget => budget::open(),
        Action::SaveBudget => budget::save(),
        Action::UseBudget => budget::use_it(),
        Action::LeaveBudget => budget::leave(),
        Action::ContactsOfCheck => budget::contacts_of_check(),
        Action::ContactsRecorded => budget::contacts_recorded(),
        Action::OwnContacts => budget::own_contacts(),
        Action::OpenReadings => budget::open_readings(),
        Action::TakeReadings => budget::take_readings(),
        Action::OwnReadings => budget::own_readings(),

        Action::ShowParts(view) => parts::show(view),
        Action::NewPlan => parts::begin(),
        Action::OpenPlan => parts::open(),
        Action::SavePlan(number) => parts::save(number),
        Action::UndoPlan => parts::undo(),
        Action::RedoPlan => parts::redo(),
        Action::MoveInPlan(step) => parts::cell_step(step).key(keys(step)),
        Action::ExtendInPlan(step) => parts::extend(step).key(with_shift(keys(step))),
        Action::EditPlanCell => parts::edit(),
        Action::TakePlanCell => parts::take(),
        Action::EmptyPlanCells => parts::empty(),
        Action::CopyPlanCells => parts::copy(),
        Action::PastePlanCells => parts::paste(),
        Action::InsertPlanRow => parts::insert(),
        Action::DeletePlanRows => parts::delete(),
        Action::MovePlanRows(step) => parts::move_rows(step),
        Action::SortPlan => parts::sort(),
        Action::RenumberPlan => parts::renumber(),
        Action::ShowAllColumns => parts::show_all(),
        Action::PreviousFinding => parts::previous_finding(),
        Action::NextFinding => parts::next_finding(),
        Action::TakeMeantCell => parts::take_meant_cell(),
        Action::LeaveOutOfPlan => parts::leave_out(),
        Action::ChoosePicture => parts::choose_picture(),
        Action::BeginPart => parts::begin_part(),
        Action::CountUp => parts::count_up(),
        Action::TakeValue => parts::take_value(),
        Action::TakeMeantValue => parts::take_meant(),
        Action::SimulateValue => parts::simulate(),
        Action::SizeAgain => parts::again(),
        Action::CountNewest => parts::count_newest(),
        Action::SkipSize => parts::skip(),
        Action::SkipFor => parts::skip_for(),
        Action::LeaveSkip => parts::leave_skip(),
        Action::NextPart => parts::next_part(),
        Action::MoveSize(step) => parts::step(step).key(keys(step)),
        Action::ImportValues => parts::import(),
        Action::ImportValuesColumns => parts::import_columns(),
        Action::WatchFolder => parts::watch(),
        Action::StopWatch => parts::stop_watch(),

        Action::OpenParts(feature) => pairing::open(feature),
        Action::HistoryParts(feature) => pairing::of_history(feature),
        Action::SavePairs(number) => pairing::save(number),
        Action::MovePair(step) => pairing::step(step).key(keys(step)),
        Action::CopyPairs => pairing::copy(),

        Action::AskRecords(shorthand) => records::ask(shorthand),
        Action::FindRecords => records::find(),
        Action::MoveRecord(step) => records::step(step).key(keys(step)),
        Action::OpenRecord => records::open(),
        Action::ChooseRecord => records::choose(),
        Action::ChooseNoRecords => records::choose_none(),
        Action::WithSimulated => records::with_simulated(),
        Action::CopyRecords => records::copy(),
        Action::ReportRecords(number) => records::report(number),
        Action::ReportPart(number) => parts::report(number),
        Action::StopWorking => {
            everywhere("working-stop", FilesCommand::StopWorking.into()).when(|session| session.working().is_some())
        }
        Action::CloseRecord => records::close(),
        Action::MeasureAgain => records::measure_again(),
        Action::CorrectRecord => records::correct(),
        Action::SendCorrection => records::send_correction(),
        Action::LeaveCorrection => records::leave_correction(),
        Action::WithdrawRecord => records::withdraw(),
        Action::VerifyRecords => records::verify(),
        Action::CancelVerify => records::cancel_verify(),
        Action::RecordAgain => records::try_again(),
        Action::AskForServer => records::ask_for_server(),
        Action::TakeServer => records::take_server(),
        Action::LeaveServer => records::leave_server(),
        Action::SendAgain => records::send_again(),
        Action::TakeName => records::take_name(),
    }
}

/// The same keys with Shift held down as well.
const fn with_shift(keys: Shortcut) -> Shortcut {
    let held = match keys.held {
        Held::Ctrl => Held::CtrlShift,
        _ => Held::Shift,
    };
    Shortcut { held, key: keys.key }
}

const fn keys(step: Step) -> Shortcut {
    let key = match step {
        Step::Left => Key::Left,
        Step::Right => Key::Right,
        Step::Up => Key::Up,
        Step::Down => Key::Down,
        Step::PageUp => Key::PageUp,
        Step::PageDown => Key::PageDown,
        Step::First => Key::Home,
        Step::Last => Key::End,
        Step::Top => return Shortcut { held: Held::Ctrl, key: Key::Home },
        Step::Bottom => return Shortcut { held: Held::Ctrl, key: Key::End },
    };
    Shortcut::plain(key)
}
