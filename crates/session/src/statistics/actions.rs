//! What can be done on the statistics page.

use fitcheck_core::message::{Say as _, message};
use fitcheck_core::words::Words;
use fitcheck_exchange::series::StudyKind;
use fitcheck_statistics::Rule;

use super::study::kind_id;
use super::{
    Aside, Below, MeanOf, PointsOf, StatisticsCommand, StatisticsField, StatisticsView, StudyCommand, Zooming,
};
use crate::Session;
use crate::action::row::{ActionRow, Actions, Sends, actions, keys, on, within};
use crate::action::{ActionScope, Key, Part, Shortcut};
use crate::command::Command;
use crate::field::Field;
use crate::page::Page;
use crate::purpose::{ImportInto, Purpose};
use crate::reports::{ReportOf, ReportsCommand};
use crate::step::Step;

/// The list of features.
pub const FEATURES: Part = Part::list(Page::Statistics, "statistics-features");

/// The chart of the chosen feature.
pub const CHART: Part = Part::cells(Page::Statistics, "statistics-chart");

/// The steps along the points.
const STEPS: [Step; 6] = [Step::Left, Step::Right, Step::PageUp, Step::PageDown, Step::First, Step::Last];

actions! {
    /// What can be done on the statistics page.
    StatisticsAction

    /// Shows the features or a study of a gauge.
    ShowStatistics(StatisticsView): StatisticsView::ALL;
    /// Reads readings of a gauge.
    OpenStudy;
    /// Reads them after a look at their columns.
    StudyColumns;
    /// Chooses the kind of study.
    KindOfStudy(StudyKind): StudyKind::ALL;
    /// Confirms the layout and evaluates the study.
    EvaluateStudy;
    /// Evaluates a layout that looks wrong.
    EvaluateAllTheSame;
    /// Writes what the study gives an uncertainty budget.
    SaveStudyBudget;
    /// Goes to the question.
    FindSeries;
    /// Reads the values again.
    ReadAgain;
    /// Goes to another feature.
    MoveFeature(Step): Step::BLOCKS;
    /// Chooses what makes a point.
    UsePoints(PointsOf): [PointsOf::Single, PointsOf::Means];
    /// Chooses which values make a mean.
    UseMeansOf(MeanOf): MeanOf::ALL;
    /// Chooses what stands below the chart.
    ShowBelow(Below): Below::ALL;
    /// Shows or hides the rules.
    ShowRules;
    /// Looks at a rule, or no longer.
    SwitchRule(Rule): Rule::ALL;
    /// Chooses what stands beside the chart where there is little room.
    Show(Aside): Aside::ALL;
    /// Goes to another point of the chart.
    MovePoint(Step): STEPS;
    /// Opens the record of the point.
    OpenPoint;
    /// Shows fewer or more points.
    Zoom(Zooming): [Zooming::In, Zooming::Out, Zooming::Whole];
    /// Takes control limits from the points up to this one, or from all again.
    Freeze;
    /// A stage with limits of its own begins at this point, or no longer.
    Stage;
    /// Leaves the point out, or takes it in again.
    LeaveOut;
    /// Leaves it out for the reason in the field.
    TakeReason;
    /// Closes the form.
    CancelReason;
    /// Puts figures and signals on the clipboard.
    CopyStatistics;
    /// Writes the charts into a file.
    SaveChart;
    /// Reports what the page shows.
    ReportStatistics;
    /// Shows the alarms that nobody has answered, where they are answered.
    ShowAlarms;
}

impl Actions for StatisticsAction {
    fn row(&self) -> ActionRow {
        match *self {
            Self::ShowStatistics(_)
            | Self::OpenStudy
            | Self::StudyColumns
            | Self::KindOfStudy(_)
            | Self::EvaluateStudy
            | Self::EvaluateAllTheSame
            | Self::SaveStudyBudget => self.on_study(),
            Self::FindSeries => {
                on(Page::Statistics, "statistics-page-question", Command::GoTo(StatisticsField::Question.into()))
                    .key(Shortcut::ctrl('F'))
                    .when(|session| shows_features(session) && session.recording().is_on())
            }
            Self::ReadAgain => on(Page::Statistics, "statistics-page-read-again", StatisticsCommand::ReadAgain)
                .key(Shortcut::plain(Key::Function(5)))
                .when(|session| shows_features(session) && session.recording().is_on()),
            Self::MoveFeature(step) => {
                within(FEATURES, "statistics-page-move-feature", StatisticsCommand::MoveFeature(step)).key(keys(step))
            }
            Self::UsePoints(of) => {
                let text = match of {
                    PointsOf::Single => "statistics-page-single",
                    PointsOf::Means => "statistics-page-means",
                };
                on(Page::Statistics, text, StatisticsCommand::UsePoints(of))
            }
            Self::UseMeansOf(of) => on(Page::Statistics, mean_id(of), StatisticsCommand::UseMeansOf(of))
                .when(|session| session.statistics().points_of == PointsOf::Means),
            Self::ShowBelow(below) => {
                let text = match below {
                    Below::Spread => "statistics-page-spread",
                    Below::Ewma => "statistics-page-ewma",
                    Below::Cusum => "statistics-page-cusum",
                };
                on(Page::Statistics, text, StatisticsCommand::ShowBelow(below))
            }
            Self::ShowRules => ActionRow::new(
                ActionScope::Page(Page::Statistics),
                "statistics-page-rules",
                Sends::FromState(|session| StatisticsCommand::ShowRules(!session.statistics().shows_rules).into()),
            ),
            Self::SwitchRule(rule) => {
                on(Page::Statistics, "statistics-page-rules", StatisticsCommand::SwitchRule(rule))
            }
            Self::Show(aside) => {
                let text = match aside {
                    Aside::Signals => "statistics-page-signals",
                    Aside::Histogram => "statistics-page-histogram",
                    Aside::Spread => "statistics-page-spread",
                    Aside::Probability => "statistics-page-probability",
                };
                on(Page::Statistics, text, StatisticsCommand::Show(aside))
            }
            Self::ShowAlarms => on(Page::Statistics, "statistics-page-alarms", Command::OpenPage(Page::Parts))
                .when(|session| !session.parts().alarms.open().is_empty()),
            _ => self.on_chart(),
        }
    }

    fn name(&self, session: &Session, words: &Words) -> Option<String> {
        match self {
            Self::UsePoints(PointsOf::Means) if session.statistics().mean_of != MeanOf::Count => {
                Some(words.get("statistics-page-means-of-groups"))
            }
            Self::UsePoints(PointsOf::Means) => {
                let size = session.text(StatisticsField::Size).trim();
                Some(words.say(&message!("statistics-page-means").text("size", size)))
            }
            Self::SwitchRule(rule) => Some(words.say(&rule.message())),
            Self::ShowAlarms => {
                let count = session.parts().alarms.open().len();
                Some(words.say(&message!("statistics-page-alarms").count("count", count)))
            }
            Self::Freeze if session.statistics().is_frozen() => Some(words.get("statistics-page-unfreeze")),
            Self::Stage if session.statistics().stage() == Some(true) => Some(words.get("statistics-page-no-stage")),
            Self::LeaveOut if is_left_out(session) => Some(words.get("statistics-page-take-in")),
            _ => None,
        }
    }

    fn is_on(&self, session: &Session) -> Option<bool> {
        let page = session.statistics();
        Some(match *self {
            Self::ShowStatistics(view) => page.view == view,
            Self::KindOfStudy(kind) => page.study.kind == kind,
            Self::UsePoints(of) => page.points_of == of,
            Self::UseMeansOf(of) => page.mean_of == of,
            Self::ShowBelow(below) => page.below() == below,
            Self::ShowRules => page.shows_rules,
            Self::SwitchRule(rule) => page.rules().has(rule),
            Self::Show(aside) => page.aside == aside,
            _ => return None,
        })
    }

    fn on_enter(field: Field, _page: Page) -> Option<Self> {
        match field {
            Field::Statistics(StatisticsField::Reason) => Some(Self::TakeReason),
            Field::Statistics(field) if field.is_of_study() => Some(Self::EvaluateStudy),
            Field::Statistics(_) => Some(Self::ReadAgain),
            _ => None,
        }
    }
}

impl StatisticsAction {
    /// What is done with a study of a gauge.
    fn on_study(self) -> ActionRow {
        let on_page = |text, command: StudyCommand| on(Page::Statistics, text, StatisticsCommand::Study(command));
        let open = |text, purpose| on(Page::Statistics, text, Command::OpenDialog(purpose));
        match self {
            Self::ShowStatistics(StatisticsView::Features) => {
                on(Page::Statistics, "statistics-page-features", StatisticsCommand::View(StatisticsView::Features))
            }
            Self::OpenStudy => open("statistics-study-open", Purpose::OpenStudy)
                .hint("statistics-study-open-hint")
                .key(Shortcut::ctrl('O'))
                .when(shows_study),
            Self::StudyColumns => open("columns-page-import", Purpose::AskColumns(ImportInto::Study))
                .hint("columns-page-hint")
                .when(shows_study),
            Self::KindOfStudy(kind) => on_page(kind_id(kind), StudyCommand::SetKind(kind)),
            Self::EvaluateStudy => on_page("statistics-study-evaluate", StudyCommand::Evaluate { all_the_same: false })
                .when(|session| shows_study(session) && session.statistics().study.is_whole() && !is_doubted(session)),
            Self::EvaluateAllTheSame => {
                on_page("statistics-study-all-the-same", StudyCommand::Evaluate { all_the_same: true }).when(
                    |session| shows_study(session) && session.statistics().study.is_whole() && is_doubted(session),
                )
            }
            Self::SaveStudyBudget => open("statistics-study-save-budget", Purpose::SaveStudyBudget)
                .hint("statistics-study-save-budget-hint")
                .when(|session| shows_study(session) && session.statistics().study.has_budget()),
            _ => on(Page::Statistics, "statistics-study", StatisticsCommand::View(StatisticsView::Study)),
        }
    }

    /// What is done with points.
    fn on_chart(self) -> ActionRow {
        let key = |character: char| Shortcut::plain(Key::Character(character));
        match self {
            Self::MovePoint(step) => within(CHART, "statistics-page-move-point", StatisticsCommand::Move(step))
                .key(keys(step))
                .when(|session| 0 < session.statistics().count()),
            Self::OpenPoint => within(CHART, "statistics-page-open", StatisticsCommand::OpenRecord(None))
                .key(Shortcut::plain(Key::Enter))
                .when(has_cursor),
            Self::Zoom(zooming) => {
                let (text, shortcut) = match zooming {
                    Zooming::In => ("statistics-page-zoom-in", key('+')),
                    Zooming::Out => ("statistics-page-zoom-out", key('-')),
                    Zooming::Whole => ("statistics-page-zoom-whole", key('0')),
                };
                within(CHART, text, StatisticsCommand::Zoom(zooming))
                    .key(shortcut)
                    .when(|session| 0 < session.statistics().count())
            }
            Self::Freeze => within(CHART, "statistics-page-freeze", StatisticsCommand::Freeze)
                .hint("statistics-page-freeze-hint")
                .key(key('B'))
                .when(|session| has_cursor(session) || session.statistics().is_frozen()),
            Self::Stage => within(CHART, "statistics-page-stage", StatisticsCommand::Stage)
                .hint("statistics-page-stage-hint")
                .key(key('S'))
                .when(|session| session.statistics().stage().is_some()),
            Self::LeaveOut => within(CHART, "statistics-page-leave-out", StatisticsCommand::LeaveOut)
                .hint("statistics-page-leave-out-hint")
                .key(key('X'))
                .when(has_cursor),
            Self::TakeReason => on(Page::Statistics, "statistics-page-take-reason", StatisticsCommand::TakeReason)
                .when(|session| !session.text(StatisticsField::Reason).trim().is_empty()),
            Self::CancelReason => {
                on(Page::Statistics, "statistics-page-cancel-reason", StatisticsCommand::CancelReason)
            }
            Self::SaveChart => {
                on(Page::Statistics, "statistics-page-save-chart", Command::OpenDialog(Purpose::SaveChart))
                    .hint("statistics-page-save-chart-hint")
                    .key(Shortcut::ctrl('S'))
                    .when(|session| shows_features(session) && session.statistics().has_chart())
            }
            Self::ReportStatistics => on(Page::Statistics, "statistics-page-report", ReportsCommand::OfStatistics)
                .hint("statistics-page-report-hint")
                .key(Shortcut::ctrl('R'))
                .when(|session| shows_features(session) && session.can_report(ReportOf::Statistics)),
            _ => on(Page::Statistics, "statistics-page-copy", StatisticsCommand::Copy)
                .hint("statistics-page-copy-hint")
                .key(Shortcut::ctrl('C'))
                .when(|session| {
                    let page = session.statistics();
                    match page.view {
                        StatisticsView::Features => page.open().is_some(),
                        StatisticsView::Study => page.study.evaluated().is_some(),
                    }
                }),
        }
    }
}

/// The text of what makes a mean.
const fn mean_id(of: MeanOf) -> &'static str {
    match of {
        MeanOf::Count => "statistics-page-mean-count",
        MeanOf::Pause => "statistics-page-mean-pause",
        MeanOf::Part => "statistics-page-mean-part",
        MeanOf::Station => "statistics-page-mean-station",
        MeanOf::Person => "statistics-page-mean-person",
    }
}

fn shows_features(session: &Session) -> bool {
    session.statistics().view == StatisticsView::Features
}

fn shows_study(session: &Session) -> bool {
    session.statistics().view == StatisticsView::Study
}

fn is_doubted(session: &Session) -> bool {
    session.statistics().study.is_doubted()
}

fn has_cursor(session: &Session) -> bool {
    session.statistics().cursor.is_some()
}

fn is_left_out(session: &Session) -> bool {
    let page = session.statistics();
    page.cursor.is_some_and(|cursor| page.reason_of(cursor).is_some())
}
