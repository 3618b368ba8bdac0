//! What can be done on the statistics page, and what comes back from outside.

use std::ops::Range;
use std::sync::Arc;

use fitcheck_core::message::Message;
use fitcheck_exchange::series::Evaluated;
use fitcheck_statistics::Rule;

use super::{Aside, Below, MeanOf, PointsOf, SeriesFound, StatisticsField, StatisticsView, StudyCommand, Zooming};
use crate::step::Step;

/// What can be done on the statistics page, and what comes back from outside.
#[derive(Debug, Clone)]
pub enum StatisticsCommand {
    /// Shows the features or a study.
    View(StatisticsView),
    /// Does something with a study of a gauge.
    Study(StudyCommand),
    /// Replaces the text of a field.
    Type(StatisticsField, String),
    /// Asks about one part, or about all of them.
    TakePart(Option<String>),
    /// Reads the values again, for what is new.
    ReadAgain,
    /// The values were read, or cannot be.
    Found {
        /// The number of the question.
        run: u64,
        result: Result<Arc<SeriesFound>, Message>,
    },
    /// Everything is computed.
    Evaluated {
        /// The number of the question.
        run: u64,
        /// The answers, in the order of the features.
        answers: Arc<Vec<Evaluated>>,
    },
    /// Goes to another feature.
    MoveFeature(Step),
    /// Goes to the feature at a place of the list.
    ChooseFeature(usize),
    /// Chooses what makes a point.
    UsePoints(PointsOf),
    /// Chooses which values make a mean.
    UseMeansOf(MeanOf),
    /// Chooses what stands below the chart.
    ShowBelow(Below),
    /// Looks at a rule, or no longer.
    SwitchRule(Rule),
    /// Shows or hides the rules.
    ShowRules(bool),
    /// Chooses what stands beside the chart where there is little room.
    Show(Aside),
    /// Goes to another point of the chart.
    Move(Step),
    /// Goes to a point.
    ChoosePoint(usize),
    /// Opens the record of a point on its page; without one, of the point at which the keys are.
    OpenRecord(Option<usize>),
    /// Shows fewer or more points.
    Zoom(Zooming),
    /// Shows these points.
    See(Range<usize>),
    /// Takes control limits from the points up to that at which the keys are, or from all points again.
    Freeze,
    /// A stage begins at the point at which the keys are, or no longer.
    Stage,
    /// Leaves the point out, for which a reason is asked; or takes it in again.
    LeaveOut,
    /// The reason is given.
    TakeReason,
    /// Leaves nothing out.
    CancelReason,
    /// Puts the figures and signals on the clipboard.
    Copy,
}
