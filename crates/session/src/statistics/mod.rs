//! The statistics page: the values of a feature as the journal has them, their charts and figures, and what to do about them.
//!
//! | file | what |
//! |---|---|
//! | here | the state |
//! | `field` | the text fields |
//! | `command`, `apply` | what can be done, and doing it |
//! | `asking` | from the fields to what is asked of the journal, and what it answers |
//! | `walking` | walking the points, which of them are in sight, leaving them out |
//! | `texts` | figures, signals and charts in words |
//! | `study` | the other view: a study of a gauge |
//!
//! No figure is computed here: [`fitcheck_exchange::series`] does that, as `fitcheck stats` shows it, off the frame.

mod actions;
mod apply;
mod asking;
mod command;
mod field;
mod study;
mod texts;
mod walking;

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::sync::Arc;

pub use actions::{CHART, FEATURES, StatisticsAction};
pub use command::StatisticsCommand;
pub use field::StatisticsField;
use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_core::words::Words;
use fitcheck_exchange::series::{Evaluated, EvaluatedSeries, FeatureKey, FeatureSeries, Look, Memory, Value};
use fitcheck_statistics::picture::svg;
pub use study::{Study, StudyAsked, StudyCommand, StudyFigure, StudyFile, StudyFound, StudyRead};
pub use texts::{FigureText, SignalText, said_of_value};

use crate::effect::Effect;
use crate::texts::Texts;

/// What the page shows.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum StatisticsView {
    /// The features of the journal.
    #[default]
    Features,
    /// A study of a gauge.
    Study,
}

impl StatisticsView {
    pub const ALL: [Self; 2] = [Self::Features, Self::Study];
}

/// What makes a point of the chart.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum PointsOf {
    /// One value.
    #[default]
    Single,
    /// So many values in a row.
    Means,
}

/// Which values make a mean.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum MeanOf {
    /// So many in a row.
    #[default]
    Count,
    /// Those until a pause of so many minutes.
    Pause,
    /// Those of one part in a row.
    Part,
    /// Those of one station in a row.
    Station,
    /// Those that one person measured in a row.
    Person,
}

impl MeanOf {
    pub const ALL: [Self; 5] = [Self::Count, Self::Pause, Self::Part, Self::Station, Self::Person];
}

/// What stands below the chart, of the same points.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum Below {
    /// Their spread.
    #[default]
    Spread,
    /// Weighted averages.
    Ewma,
    /// Sums of deviations.
    Cusum,
}

impl Below {
    pub const ALL: [Self; 3] = [Self::Spread, Self::Ewma, Self::Cusum];
}

/// What stands beside the chart where there is room for one thing only.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum Aside {
    #[default]
    Signals,
    Histogram,
    Spread,
    Probability,
}

impl Aside {
    pub const ALL: [Self; 4] = [Self::Signals, Self::Histogram, Self::Spread, Self::Probability];
}

/// How many points are shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Zooming {
    /// Fewer.
    In,
    /// More.
    Out,
    /// All of them.
    Whole,
}

/// What a question to the journal found.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct SeriesFound {
    pub features: Vec<Arc<FeatureSeries>>,
    /// How many entries were read.
    pub read: usize,
    /// How many of them cannot be read.
    pub unread: usize,
    /// Whether there are older ones that were not read.
    pub has_more: bool,
}

/// The state of the statistics page.
#[derive(Debug, Default)]
pub struct StatisticsPage {
    pub view: StatisticsView,
    pub study: Study,
    texts: Texts<StatisticsField>,
    errors: BTreeMap<StatisticsField, Message>,
    /// Where in the question an error shows.
    culprit: Option<Range<usize>>,
    /// The part that is open on its page.
    open_part: Option<String>,
    /// The parts that were found so far.
    parts: BTreeSet<String>,
    /// Whether anything was asked since the window was opened.
    has_asked: bool,
    /// The newest question that the journal was asked.
    question: String,
    runs: u64,
    /// The number of the question whose values are being read.
    reading: Option<u64>,
    /// The number of the question that is being computed, with its values.
    computing: Option<(u64, Arc<SeriesFound>)>,
    /// Why nothing could be read.
    pub problem: Option<Message>,
    found: Option<Arc<SeriesFound>>,
    /// What is shown: the features, and what was computed of them.
    shown: EvaluatedSeries,
    /// Goes up with every answer.
    version: u64,
    chosen: Option<FeatureKey>,
    pub points_of: PointsOf,
    pub mean_of: MeanOf,
    look: Look,
    /// The baselines of features, by the numbers of their first and last value.
    baselines: BTreeMap<FeatureKey, [u64; 2]>,
    pub shows_rules: bool,
    pub aside: Aside,
    /// The point at which the keys are.
    pub cursor: Option<usize>,
    /// The points in sight; `None` for all.
    window: Option<Range<usize>>,
    /// Whether a reason is asked for.
    pub asks_why: bool,
    errands: Vec<Effect>,
}

impl StatisticsPage {
    /// The features, each with what was computed of it.
    pub fn features(&self) -> impl ExactSizeIterator<Item = (&FeatureSeries, &Evaluated)> {
        self.shown.iter()
    }

    /// A number that changes with what is shown.
    pub const fn version(&self) -> u64 {
        self.version
    }

    /// The place of the chosen feature.
    pub fn chosen(&self) -> Option<usize> {
        let chosen = self.chosen.as_ref()?;
        self.features().position(|(feature, _)| feature.key == *chosen)
    }

    /// The chosen feature, with what was computed of it.
    pub fn open(&self) -> Option<(&FeatureSeries, &Evaluated)> {
        self.features().nth(self.chosen()?)
    }

    /// The parts that were found so far, and the one that is open on its page.
    pub fn parts(&self) -> impl Iterator<Item = &str> {
        let open = self.open_part.as_deref().filter(|part| !self.parts.contains(*part));
        self.parts.iter().map(String::as_str).chain(open)
    }

    /// The part that the question asks for, where it asks for nothing else.
    pub fn part(&self) -> Option<&str> {
        let question = self.texts.text(StatisticsField::Question).trim();
        self.parts().find(|part| asks_for(part) == question)
    }

    /// What was found of the question that is shown.
    pub fn found(&self) -> Option<&SeriesFound> {
        self.found.as_deref()
    }

    /// The features that are shown, with what was computed of them.
    pub const fn series(&self) -> &EvaluatedSeries {
        &self.shown
    }

    /// Whether what is shown answers the newest question.
    pub fn is_settled(&self) -> bool {
        self.open().is_some() && !self.is_working() && self.problem.is_none()
    }

    /// Whether values are being read or figures computed.
    pub const fn is_working(&self) -> bool {
        self.reading.is_some() || self.computing.is_some()
    }

    /// Which rules are looked at.
    pub const fn rules(&self) -> fitcheck_statistics::Rules {
        self.look.rules
    }

    /// What stands below the chart.
    pub const fn below(&self) -> Below {
        match self.look.memory {
            None => Below::Spread,
            Some(Memory::Ewma(_)) => Below::Ewma,
            Some(Memory::Cusum(_)) => Below::Cusum,
        }
    }

    /// Whether the chosen feature has a chart.
    pub fn has_chart(&self) -> bool {
        self.open().is_some_and(|(_, of)| of.answer.chart.is_ok())
    }

    /// The charts of the chosen feature on one sheet, as SVG.
    ///
    /// # Errors
    /// Why there are none.
    pub(crate) fn drawing(&self, words: &Words) -> Result<String, Message> {
        let (feature, of) = self.open().ok_or_else(|| message!("statistics-page-none"))?;
        let sheet =
            of.sheet(words).map_err(|why| message!("statistics-page-no-chart").message("why", why.message()))?;
        Ok(svg(&sheet, &feature.key.title(true)))
    }

    /// The values of a point of the chosen feature.
    pub fn values_of(&self, point: usize) -> impl Iterator<Item = &Value> {
        let open = self.open();
        let places = open.and_then(|(_, of)| of.shown.get(of.points.get(point)?.clone())).unwrap_or_default();
        places.iter().filter_map(move |at| open?.0.values.get(*at))
    }

    /// Why somebody left a point out.
    pub fn reason_of(&self, point: usize) -> Option<&str> {
        self.values_of(point).find_map(|value| Some(self.look.apart.get(&value.origin.number?)?.as_ref()))
    }
}

/// The question for a part.
fn asks_for(part: &str) -> String {
    fitcheck_exchange::journal::ask::asking("part", part)
}
