//! The rows of the parts page in the table of actions.

use fitcheck_core::part::MOST_FEATURES;

use super::row::{Row, Sends, on, within};
use super::{Held, Key, Part, Place, Shortcut};
use crate::parts::{PartsCommand, PartsField, PartsView, PlanCommand, WalkCommand};
use crate::{Command, ImportInto, Page, Purpose, Session, Step};

fn of_page(text: &'static str, command: PartsCommand) -> Row {
    on(Page::Parts, text, command)
}

pub(super) fn show(view: PartsView) -> Row {
    let text = match view {
        PartsView::Walk => "parts-page-walk",
        PartsView::Plan => "parts-page-plan",
    };
    of_page(text, PartsCommand::Show(view))
}

pub(super) fn begin() -> Row {
    of_page("parts-page-new", PartsCommand::Plan(PlanCommand::New)).key(Shortcut::ctrl('N'))
}

pub(super) fn open() -> Row {
    on(Page::Parts, "parts-page-open", Command::OpenDialog(Purpose::OpenPlan)).key(Shortcut::ctrl('O'))
}

/// 0 saves as TOML, 1 as CSV.
pub(super) fn save(number: usize) -> Row {
    let text = if number == 0 { "parts-page-save" } else { "parts-page-save-csv" };
    let row = on(Page::Parts, text, Command::OpenDialog(Purpose::SavePlan(number)));
    // What could not be read of its file is not lost by the way.
    let row = row.when(|session| {
        let document = session.parts().document();
        !document.is_empty() && document.problems().is_empty()
    });
    if number == 0 { row.key(Shortcut::ctrl('S')) } else { row }
}

pub(super) fn undo() -> Row {
    of_page("parts-page-undo", PartsCommand::Plan(PlanCommand::Undo))
        .key(Shortcut::ctrl('Z'))
        .when(|session| has_table(session) && session.parts().document().can_undo().0)
}

pub(super) fn redo() -> Row {
    of_page("parts-page-redo", PartsCommand::Plan(PlanCommand::Redo))
        .key(Shortcut::ctrl('Y'))
        .when(|session| has_table(session) && session.parts().document().can_undo().1)
}

/// The table of the plan is in sight.
fn has_table(session: &Session) -> bool {
    !session.parts().document().is_empty() && session.parts().view() == PartsView::Plan
}

/// The keys are on a feature, and not below the last one.
fn is_on_feature(session: &Session) -> bool {
    has_table(session) && session.parts().sheet().at().0 < session.parts().document().draft().rows.len()
}

fn has_findings(session: &Session) -> bool {
    has_table(session) && !session.parts().document().findings().is_empty()
}

/// Its keys are heard while the table has the focus, and not in a field of the part.
fn in_table(text: &'static str, command: PlanCommand) -> Row {
    within(Part::Plan, text, PartsCommand::Plan(command)).when(has_table)
}

/// Its keys are heard wherever the table is in sight.
fn of_table(text: &'static str, command: PlanCommand) -> Row {
    of_page(text, PartsCommand::Plan(command)).when(has_table)
}

pub(super) fn cell_step(step: Step) -> Row {
    in_table("parts-page-move", PlanCommand::Move(step, false))
}

pub(super) fn extend(step: Step) -> Row {
    in_table("parts-page-extend", PlanCommand::Move(step, true))
}

pub(super) fn edit() -> Row {
    in_table("parts-page-edit", PlanCommand::Edit(None))
        .keys(Shortcut::plain(Key::Enter), Shortcut::plain(Key::Function(2)))
}

pub(super) fn take() -> Row {
    of_table("parts-page-take", PlanCommand::Take(Some(Step::Down)))
        .when(|session| has_table(session) && session.parts().sheet().is_editing())
}

pub(super) fn empty() -> Row {
    in_table("parts-page-empty", PlanCommand::Empty).key(Shortcut::plain(Key::Delete)).when(is_on_feature)
}

pub(super) fn copy() -> Row {
    in_table("parts-page-copy", PlanCommand::Copy).key(Shortcut::ctrl('C')).when(is_on_feature)
}

pub(super) fn paste() -> Row {
    in_table("parts-page-paste", PlanCommand::AskForPaste).key(Shortcut::ctrl('V'))
}

pub(super) fn insert() -> Row {
    in_table("parts-page-insert", PlanCommand::Insert)
        .key(Shortcut::ctrl('I'))
        .when(|session| has_table(session) && session.parts().document().draft().rows.len() < MOST_FEATURES)
}

pub(super) fn delete() -> Row {
    in_table("parts-page-delete", PlanCommand::Delete).key(Shortcut::ctrl('D')).when(is_on_feature)
}

pub(super) fn move_rows(step: Step) -> Row {
    let (text, key): (_, _) =
        if step == Step::Up { ("parts-page-up", Key::Up) } else { ("parts-page-down", Key::Down) };
    in_table(text, PlanCommand::MoveRows(step)).key(Shortcut { held: Held::Alt, key }).when(is_on_feature)
}

pub(super) fn sort() -> Row {
    of_table("parts-page-sort", PlanCommand::Sort).hint("parts-page-sort-hint")
}

pub(super) fn renumber() -> Row {
    of_table("parts-page-renumber", PlanCommand::Renumber).hint("parts-page-renumber-hint")
}

pub(super) fn show_all() -> Row {
    Row::new(
        Place::Page(Page::Parts),
        "parts-page-all-columns",
        Sends::FromState(|session| {
            PartsCommand::Plan(PlanCommand::ShowAll(!session.parts().sheet().shows_all())).into()
        }),
    )
    .when(has_table)
}

pub(super) fn previous_finding() -> Row {
    of_table("parts-page-previous", PlanCommand::NextFinding(false))
        .key(Shortcut::shift(Key::Function(4)))
        .when(has_findings)
}

pub(super) fn next_finding() -> Row {
    of_table("parts-page-next", PlanCommand::NextFinding(true))
        .key(Shortcut::plain(Key::Function(4)))
        .when(has_findings)
}

pub(super) fn take_meant_cell() -> Row {
    of_table("parts-page-take-meant", PlanCommand::TakeMeant)
        .when(|session| has_table(session) && session.parts().meant_here().is_some())
}

pub(super) fn leave_out() -> Row {
    of_table("parts-page-leave-out", PlanCommand::LeaveOut)
        .hint("parts-page-leave-out-hint")
        .key(Shortcut::ctrl('L'))
        .when(|session| has_table(session) && !session.parts().document().problems().is_empty())
}

pub(super) fn choose_picture() -> Row {
    on(Page::Parts, "parts-page-choose-picture", Command::OpenDialog(Purpose::OpenPicture)).when(has_table)
}

/// On the walk through a part, in its view.
fn of_walk(text: &'static str, command: impl Into<Command>) -> Row {
    on(Page::Parts, text, command).when(is_measured)
}

fn is_walk(session: &Session) -> bool {
    session.parts().view() == PartsView::Walk
}

fn is_measured(session: &Session) -> bool {
    is_walk(session) && session.parts().walking().is_begun()
}

fn is_asked(session: &Session) -> bool {
    is_walk(session) && session.parts().walking().at().is_some()
}

pub(super) fn begin_part() -> Row {
    of_walk("walk-page-begin", WalkCommand::Begin).when(|session| {
        is_walk(session) && !session.parts().walking().is_begun() && session.parts().document().plan().is_some()
    })
}

pub(super) fn count_up() -> Row {
    of_walk("walk-page-count-up", WalkCommand::CountUp)
        .when(|session| is_walk(session) && !session.parts().walking().is_begun())
}

pub(super) fn take_value() -> Row {
    of_walk("walk-page-take", WalkCommand::Take).when(is_asked)
}

pub(super) fn take_meant() -> Row {
    of_walk("walk-page-take-meant", WalkCommand::TakeMeant).when(|session| {
        is_walk(session) && session.parts().walking().question().is_some_and(|asked| asked.doubt.meant().is_some())
    })
}

pub(super) fn simulate() -> Row {
    let row = of_walk("walk-page-simulate", WalkCommand::Simulate).hint("walk-page-simulate-hint");
    row.key(Shortcut::plain(Key::Function(5))).when(is_asked)
}

pub(super) fn again() -> Row {
    of_walk("walk-page-again", WalkCommand::Again)
        .key(Shortcut::plain(Key::Function(6)))
        .when(|session| is_walk(session) && session.parts().walking().shown().is_some())
}

pub(super) fn count_newest() -> Row {
    of_walk("walk-page-count-newest", WalkCommand::CountNewest)
        .when(|session| is_walk(session) && session.parts().walking().contradicted().is_some())
}

pub(super) fn skip() -> Row {
    of_walk("walk-page-skip", WalkCommand::AskSkip(true)).key(Shortcut::plain(Key::Function(7))).when(is_asked)
}

pub(super) fn skip_for() -> Row {
    let reason = |session: &Session| WalkCommand::Skip(session.parts().text(PartsField::Reason).to_owned()).into();
    Row::new(Place::Page(Page::Parts), "walk-page-skip-for", Sends::FromState(reason)).when(is_skipping)
}

pub(super) fn leave_skip() -> Row {
    of_walk("walk-page-skip-not", WalkCommand::AskSkip(false)).when(is_skipping)
}

fn is_skipping(session: &Session) -> bool {
    is_walk(session) && session.parts().walking().is_skipping()
}

pub(super) fn next_part() -> Row {
    of_walk("walk-page-next", WalkCommand::Next).key(Shortcut::plain(Key::Function(8)))
}

pub(super) fn step(step: Step) -> Row {
    within(Part::Sizes, "walk-page-move", WalkCommand::Move(step)).when(is_measured)
}

pub(super) fn import() -> Row {
    let open = |session: &Session| Command::OpenDialog(Purpose::ImportValues(session.parts().walking().run()));
    Row::new(Place::Page(Page::Parts), "walk-page-import", Sends::FromState(open)).when(is_measured)
}

pub(super) fn report(number: usize) -> Row {
    of_walk("walk-page-report", Command::OpenDialog(Purpose::ReportPart(number)))
}

pub(super) fn import_columns() -> Row {
    let open =
        |session: &Session| Command::OpenDialog(Purpose::AskColumns(ImportInto::Part(session.parts().walking().run())));
    let row = Row::new(Place::Page(Page::Parts), "columns-page-import", Sends::FromState(open));
    row.hint("columns-page-hint").when(is_measured)
}

pub(super) fn watch() -> Row {
    let row = of_walk("walk-page-watch", Command::OpenDialog(Purpose::WatchFolder)).hint("walk-page-watch-hint");
    row.when(|session| {
        let parts = session.parts();
        is_walk(session) && (parts.document().plan().is_some() || parts.walking().is_begun())
    })
}

pub(super) fn stop_watch() -> Row {
    of_walk("walk-page-watch-stop", WalkCommand::StopWatch)
        .when(|session| is_walk(session) && session.parts().watched().folder().is_some())
}
