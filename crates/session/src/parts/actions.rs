//! What can be done on the parts page.

use fitcheck_core::message::{Message, message};
use fitcheck_core::part::MOST_FEATURES;
use fitcheck_core::words::Words;
use fitcheck_exchange::report::{RENDERINGS, Rendering, of_any_paper};

use super::{PartsCommand, PartsField, PartsView, PlanCommand, PlanField, WalkCommand, WalkField};
use crate::Session;
use crate::action::row::{ActionRow, Actions, Sends, actions, keys, on, within};
use crate::action::{ActionScope, Held, Key, Part, Shortcut};
use crate::command::Command;
use crate::field::Field;
use crate::page::Page;
use crate::purpose::{ImportInto, Purpose};
use crate::step::Step;

/// The table of the plan.
pub const PLAN: Part = Part::sheet(Page::Parts, "plan-grid");

/// The sizes of the part.
pub const SIZES: Part = Part::list(Page::Parts, "walk-sizes");

actions! {
    /// What can be done on the parts page.
    PartsAction

    /// Opens a view of the parts page.
    ShowParts(PartsView): PartsView::ALL;
    /// Begins a new part plan.
    NewPlan;
    /// Reads a plan.
    OpenPlan;
    /// Writes the plan: as TOML, as CSV.
    SavePlan(usize): 0..2;
    /// Takes the last change of the plan back.
    UndoPlan;
    /// Makes it again.
    RedoPlan;
    /// Goes to another cell of the plan.
    MoveInPlan(Step): Step::CELLS;
    /// Selects cells from where the keys are to another cell.
    ExtendInPlan(Step): Step::CELLS;
    /// Types into the cell of the plan.
    EditPlanCell;
    /// Takes what is typed, and goes to the cell below.
    TakePlanCell;
    /// Empties the selected cells of the plan.
    EmptyPlanCells;
    /// Puts the selected cells of the plan on the clipboard.
    CopyPlanCells;
    /// Asks for what is on the clipboard, for the cells of the plan.
    PastePlanCells;
    /// Puts a feature above the cell.
    InsertPlanRow;
    /// Deletes the selected features.
    DeletePlanRows;
    /// Moves the selected features up or down.
    MovePlanRows(Step): [Step::Up, Step::Down];
    /// Sorts the features by the column of the cell.
    SortPlan;
    /// Numbers the features from 1.
    RenumberPlan;
    /// Shows every column of the plan, or those that are used.
    ShowAllColumns;
    /// Goes to what is wrong before the cell.
    PreviousFinding;
    /// Goes to what is wrong after it.
    NextFinding;
    /// Leaves out what could not be read of the plan's file.
    LeaveOutOfPlan;
    /// Puts into a cell of the plan what it should probably hold.
    TakeMeantCell;
    /// Chooses the part's picture.
    ChoosePicture;
    /// Begins a part with the serial number in its field.
    BeginPart;
    /// Counts the serial number up.
    CountUp;
    /// Takes the typed value of the size that is asked for.
    TakeValue;
    /// Takes what the typed value may have been.
    TakeMeantValue;
    /// Drops the typed value that cannot be: the size is measured again.
    MeasureAnew;
    /// Measures the feature by its cycle on a perfect part.
    SimulateValue;
    /// Asks once more for the size that is shown.
    SizeAgain;
    /// Of the values of a size that contradict each other the last one counts.
    CountNewest;
    /// Asks why the size is left out.
    SkipSize;
    /// Leaves it out for the reason in its field.
    SkipFor;
    LeaveSkip;
    /// Asks for cause and action of the oldest open alarm.
    AskAlarm;
    /// Records cause and action of the alarm.
    AnswerAlarm;
    /// Answers the alarm later.
    LeaveAlarm;
    /// Ends the part; the serial number of the next one is counted up.
    NextPart;
    /// Ends the part in the same way; the next one is measured by the plan that is open now.
    BeginByOpenPlan;
    /// Goes on with the part, though another plan is open.
    KeepMeasuring;
    /// Goes to another size.
    MoveSize(Step): Step::BLOCKS;
    /// Reads measurements into the part.
    ImportValues;
    /// Reads measurements into the part once their columns were seen.
    ImportValuesColumns;
    /// Watches a folder that files are dropped into.
    WatchFolder;
    /// Ends that.
    StopWatch;
    /// Writes the part that is being measured in a format of the report's list, by its number there.
    ReportPart(usize): of_any_paper();
}

impl Actions for PartsAction {
    #[expect(clippy::too_many_lines, reason = "one row for everything that can be done")]
    fn row(&self) -> ActionRow {
        match *self {
            Self::ShowParts(view) => {
                let text = match view {
                    PartsView::Walk => "parts-page-walk",
                    PartsView::Plan => "parts-page-plan",
                };
                of_page(text, PartsCommand::Show(view))
            }
            Self::NewPlan => of_page("parts-page-new", PartsCommand::Plan(PlanCommand::New)).key(Shortcut::ctrl('N')),
            Self::OpenPlan => {
                on(Page::Parts, "parts-page-open", Command::OpenDialog(Purpose::OpenPlan)).key(Shortcut::ctrl('O'))
            }
            Self::SavePlan(number) => {
                let text = if number == 0 { "parts-page-save" } else { "parts-page-save-csv" };
                let row = on(Page::Parts, text, Command::OpenDialog(Purpose::SavePlan(number)));
                // What could not be read of its file is not lost by the way.
                let row = row.when(|session| {
                    let document = &session.parts().document;
                    !document.is_empty() && document.problems.is_empty()
                });
                if number == 0 { row.key(Shortcut::ctrl('S')) } else { row }
            }
            Self::UndoPlan => of_page("parts-page-undo", PartsCommand::Plan(PlanCommand::Undo))
                .key(Shortcut::ctrl('Z'))
                .when(|session| has_table(session) && session.parts().document.can_undo().0),
            Self::RedoPlan => of_page("parts-page-redo", PartsCommand::Plan(PlanCommand::Redo))
                .key(Shortcut::ctrl('Y'))
                .when(|session| has_table(session) && session.parts().document.can_undo().1),
            Self::MoveInPlan(step) => in_table("parts-page-move", PlanCommand::Move(step, false)).key(keys(step)),
            Self::ExtendInPlan(step) => {
                in_table("parts-page-extend", PlanCommand::Move(step, true)).key(with_shift(keys(step)))
            }
            Self::EditPlanCell => in_table("parts-page-edit", PlanCommand::Edit(None))
                .keys(Shortcut::plain(Key::Enter), Shortcut::plain(Key::Function(2))),
            Self::TakePlanCell => of_table("parts-page-take", PlanCommand::Take(Some(Step::Down)))
                .when(|session| has_table(session) && session.parts().sheet.is_editing),
            Self::EmptyPlanCells => {
                in_table("parts-page-empty", PlanCommand::Empty).key(Shortcut::plain(Key::Delete)).when(is_on_feature)
            }
            Self::CopyPlanCells => {
                in_table("parts-page-copy", PlanCommand::Copy).key(Shortcut::ctrl('C')).when(is_on_feature)
            }
            Self::PastePlanCells => in_table("parts-page-paste", PlanCommand::AskForPaste).key(Shortcut::ctrl('V')),
            Self::InsertPlanRow => in_table("parts-page-insert", PlanCommand::Insert)
                .key(Shortcut::ctrl('I'))
                .when(|session| has_table(session) && session.parts().document.draft().rows.len() < MOST_FEATURES),
            Self::DeletePlanRows => {
                in_table("parts-page-delete", PlanCommand::Delete).key(Shortcut::ctrl('D')).when(is_on_feature)
            }
            Self::MovePlanRows(step) => {
                let (text, key): (_, _) =
                    if step == Step::Up { ("parts-page-up", Key::Up) } else { ("parts-page-down", Key::Down) };
                in_table(text, PlanCommand::MoveRows(step)).key(Shortcut { held: Held::Alt, key }).when(is_on_feature)
            }
            Self::SortPlan => of_table("parts-page-sort", PlanCommand::Sort).hint("parts-page-sort-hint"),
            Self::RenumberPlan => {
                of_table("parts-page-renumber", PlanCommand::Renumber).hint("parts-page-renumber-hint")
            }
            Self::ShowAllColumns => ActionRow::new(
                ActionScope::Page(Page::Parts),
                "parts-page-all-columns",
                Sends::FromState(|session| {
                    PartsCommand::Plan(PlanCommand::ShowAll(!session.parts().sheet.shows_all)).into()
                }),
            )
            .when(has_table),
            Self::PreviousFinding => of_table("parts-page-previous", PlanCommand::NextFinding(false))
                .key(Shortcut::shift(Key::Function(4)))
                .when(has_findings),
            Self::NextFinding => of_table("parts-page-next", PlanCommand::NextFinding(true))
                .key(Shortcut::plain(Key::Function(4)))
                .when(has_findings),
            Self::LeaveOutOfPlan => of_table("parts-page-leave-out", PlanCommand::LeaveOut)
                .hint("parts-page-leave-out-hint")
                .key(Shortcut::ctrl('L'))
                .when(|session| has_table(session) && !session.parts().document.problems.is_empty()),
            Self::TakeMeantCell => of_table("parts-page-take-meant", PlanCommand::TakeMeant)
                .when(|session| has_table(session) && session.parts().meant_here().is_some()),
            Self::ChoosePicture => {
                on(Page::Parts, "parts-page-choose-picture", Command::OpenDialog(Purpose::OpenPicture)).when(has_table)
            }
            Self::BeginPart => of_walk("walk-page-begin", WalkCommand::Begin).when(|session| {
                is_walk(session) && !session.parts().walking.is_begun() && session.parts().document.plan().is_some()
            }),
            Self::CountUp => of_walk("walk-page-count-up", WalkCommand::CountUp)
                .when(|session| is_walk(session) && !session.parts().walking.is_begun()),
            Self::TakeValue => of_walk("walk-page-take", WalkCommand::Take).when(is_asked),
            Self::TakeMeantValue => of_walk("walk-page-take-meant", WalkCommand::TakeMeant).when(|session| {
                is_walk(session)
                    && session.parts().walking.question.as_ref().is_some_and(|asked| asked.doubt.meant().is_some())
            }),
            Self::MeasureAnew => of_walk("walk-page-measure-anew", WalkCommand::MeasureAnew)
                .when(|session| is_walk(session) && session.parts().walking.asks_about_implausible()),
            Self::SimulateValue => {
                let row = of_walk("walk-page-simulate", WalkCommand::Simulate).hint("walk-page-simulate-hint");
                row.key(Shortcut::plain(Key::Function(5))).when(is_asked)
            }
            Self::SizeAgain => of_walk("walk-page-again", WalkCommand::Again)
                .key(Shortcut::plain(Key::Function(6)))
                .when(|session| is_walk(session) && session.parts().walking.shown().is_some()),
            Self::CountNewest => of_walk("walk-page-count-newest", WalkCommand::CountNewest)
                .when(|session| is_walk(session) && session.parts().walking.contradicted().is_some()),
            Self::SkipSize => of_walk("walk-page-skip", WalkCommand::AskSkip(true))
                .key(Shortcut::plain(Key::Function(7)))
                .when(is_asked),
            Self::SkipFor => {
                let reason = |session: &Session| WalkCommand::Skip(session.text(WalkField::Reason).to_owned()).into();
                ActionRow::new(ActionScope::Page(Page::Parts), "walk-page-skip-for", Sends::FromState(reason))
                    .when(is_skipping)
            }
            Self::LeaveSkip => of_walk("walk-page-skip-not", WalkCommand::AskSkip(false)).when(is_skipping),
            Self::AskAlarm => {
                let ask = |session: &Session| {
                    let oldest = session.parts().alarms.open().first();
                    WalkCommand::AskAlarm(oldest.map_or(0, |alarm| alarm.head.number)).into()
                };
                ActionRow::new(ActionScope::Page(Page::Parts), "walk-page-alarm-ask", Sends::FromState(ask))
                    .when(|session| is_walk(session) && !session.parts().alarms.open().is_empty())
            }
            Self::AnswerAlarm => on(Page::Parts, "walk-page-alarm-answer", WalkCommand::AnswerAlarm).when(is_answering),
            Self::LeaveAlarm => on(Page::Parts, "walk-page-alarm-later", WalkCommand::LeaveAlarm).when(is_answering),
            Self::NextPart => of_walk("walk-page-next", WalkCommand::Next).key(Shortcut::plain(Key::Function(8))),
            Self::BeginByOpenPlan => of_walk("walk-page-begin-by", WalkCommand::Next).when(asks_which_plan),
            Self::KeepMeasuring => of_walk("walk-page-keep-on", WalkCommand::KeepOn).when(asks_which_plan),
            Self::MoveSize(step) => {
                within(SIZES, "walk-page-move", WalkCommand::Move(step)).when(is_measured).key(keys(step))
            }
            Self::ImportValues => {
                let open = |session: &Session| Command::OpenDialog(Purpose::ImportValues(session.parts().walking.run));
                ActionRow::new(ActionScope::Page(Page::Parts), "walk-page-import", Sends::FromState(open))
                    .when(is_measured)
            }
            Self::ImportValuesColumns => {
                let open = |session: &Session| {
                    Command::OpenDialog(Purpose::AskColumns(ImportInto::Part(session.parts().walking.run)))
                };
                let row = ActionRow::new(ActionScope::Page(Page::Parts), "columns-page-import", Sends::FromState(open));
                row.hint("columns-page-hint").when(is_measured)
            }
            Self::WatchFolder => {
                let row =
                    of_walk("walk-page-watch", Command::OpenDialog(Purpose::WatchFolder)).hint("walk-page-watch-hint");
                row.when(|session| {
                    let parts = session.parts();
                    is_walk(session) && (parts.document.plan().is_some() || parts.walking.is_begun())
                })
            }
            Self::StopWatch => of_walk("walk-page-watch-stop", WalkCommand::StopWatch)
                .when(|session| is_walk(session) && session.parts().watched.folder.is_some()),
            Self::ReportPart(number) => of_walk("walk-page-report", Command::OpenDialog(Purpose::ReportPart(number))),
        }
    }

    fn name(&self, session: &Session, words: &Words) -> Option<String> {
        match *self {
            Self::ReportPart(number) => {
                let Rendering { title, is_for_people, .. } = *RENDERINGS.get(number)?;
                let [people, programs] = [message!("walk-page-report-people"), message!("walk-page-report-programs")];
                Some(words.say(&if is_for_people { people } else { programs }.text("format", title)))
            }
            Self::BeginByOpenPlan => {
                let [_, open] = session.parts().both_plans();
                Some(words.say(&Message::new(self.row().text).text("open", open)))
            }
            Self::TakeMeantCell => {
                let meant = session.parts().meant_here().map_or_else(String::new, |meant| words.number(&meant));
                Some(words.say(&Message::new(self.row().text).text("meant", meant)))
            }
            Self::TakeValue => {
                let question = session.parts().walking.question.as_ref()?;
                let measured = words.mm(question.measured, 3);
                let is_implausible = session.parts().walking.asks_about_implausible();
                let id = if is_implausible { "walk-page-it-is-so" } else { "judge-anyway" };
                Some(words.say(&Message::new(id).text("measured", measured)))
            }
            Self::TakeMeantValue => {
                let meant = session.parts().walking.question.as_ref().and_then(|question| question.doubt.meant());
                let meant = meant.map_or_else(String::new, |meant| words.mm(meant, 3));
                Some(words.say(&Message::new(self.row().text).text("meant", meant)))
            }
            _ => None,
        }
    }

    fn is_on(&self, session: &Session) -> Option<bool> {
        Some(match *self {
            Self::ShowParts(view) => session.parts().view == view,
            Self::ShowAllColumns => session.parts().sheet.shows_all,
            _ => return None,
        })
    }

    fn on_enter(field: Field, _page: Page) -> Option<Self> {
        match field {
            Field::Parts(PartsField::Walk(WalkField::Serial)) => Some(Self::BeginPart),
            Field::Parts(PartsField::Walk(WalkField::Value)) => Some(Self::TakeValue),
            Field::Parts(PartsField::Walk(WalkField::Reason)) => Some(Self::SkipFor),
            Field::Parts(PartsField::Walk(WalkField::Cause | WalkField::Action)) => Some(Self::AnswerAlarm),
            Field::Parts(PartsField::Plan(PlanField::Cell)) => Some(Self::TakePlanCell),
            _ => None,
        }
    }
}

fn of_page(text: &'static str, command: PartsCommand) -> ActionRow {
    on(Page::Parts, text, command)
}

/// The table of the plan is in sight.
fn has_table(session: &Session) -> bool {
    !session.parts().document.is_empty() && session.parts().view == PartsView::Plan
}

/// The keys are on a feature, and not below the last one.
fn is_on_feature(session: &Session) -> bool {
    has_table(session) && session.parts().sheet.at().0 < session.parts().document.draft().rows.len()
}

fn has_findings(session: &Session) -> bool {
    has_table(session) && !session.parts().document.findings().is_empty()
}

/// Its keys are heard while the table has the focus, and not in a field of the part.
fn in_table(text: &'static str, command: PlanCommand) -> ActionRow {
    within(PLAN, text, PartsCommand::Plan(command)).when(has_table)
}

/// Its keys are heard wherever the table is in sight.
fn of_table(text: &'static str, command: PlanCommand) -> ActionRow {
    of_page(text, PartsCommand::Plan(command)).when(has_table)
}

/// On the walk through a part, in its view.
fn of_walk(text: &'static str, command: impl Into<Command>) -> ActionRow {
    on(Page::Parts, text, command).when(is_measured)
}

fn is_walk(session: &Session) -> bool {
    session.parts().view == PartsView::Walk
}

fn is_measured(session: &Session) -> bool {
    is_walk(session) && session.parts().walking.is_begun()
}

fn asks_which_plan(session: &Session) -> bool {
    is_walk(session) && session.parts().asks_which_plan()
}

fn is_asked(session: &Session) -> bool {
    is_walk(session) && session.parts().walking.at.is_some()
}

fn is_answering(session: &Session) -> bool {
    is_walk(session) && session.parts().answered_alarm().is_some()
}

fn is_skipping(session: &Session) -> bool {
    is_walk(session) && session.parts().walking.is_skipping
}

/// The same keys with Shift held down as well.
const fn with_shift(keys: Shortcut) -> Shortcut {
    let held = match keys.held {
        Held::Ctrl => Held::CtrlShift,
        _ => Held::Shift,
    };
    Shortcut { held, key: keys.key }
}
