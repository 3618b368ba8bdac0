//! The statistics page: the series of features, their charts and figures.
//!
//! | file | what |
//! |---|---|
//! | here | the two views: features, and a study of a gauge |
//! | `features` | where everything of the features stands |
//! | `asking_panel` | above: which records, how many values, what was read |
//! | `features_list` | left: the features with Ppk |
//! | `figures_panel` | above the chart: the figures with their intervals |
//! | `chart_panel` | the chart: walked by keys, brushed, clicked through to the record |
//! | `aside_panel` | histogram, spread and probability plot |
//! | `signals_panel` | the patterns that rules find, the rules, advice |
//! | `study` | a study of a gauge |
//! | `paint` | from a picture to the screen |

mod aside_panel;
mod asking_panel;
mod chart_panel;
mod features;
mod features_list;
mod figures_panel;
mod paint;
mod signals_panel;
mod study;

use std::path::Path;

use eframe::egui::Ui;

use super::page::{Group, PageView, open};
use super::theme::Icon;
use super::view::View;
use crate::session::statistics::StatisticsView;
use crate::session::{Action, Command, Purpose, StatisticsAction};

pub(super) const PAGE: PageView = PageView {
    sides: &SIDES,
    action,
    opened,
    dropped,
    ..PageView::of(Group::Results, Icon::ChartScatter, statistics_ui)
};

const SIDES: [Action; 2] = [
    Action::Statistics(StatisticsAction::ShowStatistics(StatisticsView::Features)),
    Action::Statistics(StatisticsAction::ShowStatistics(StatisticsView::Study)),
];

/// The report of the features, or the readings of a gauge.
fn action(view: &View<'_>) -> Action {
    match view.session.statistics().view {
        StatisticsView::Features => StatisticsAction::ReportStatistics.into(),
        StatisticsView::Study => StatisticsAction::OpenStudy.into(),
    }
}

/// The chosen feature, or the file of a study.
fn opened(view: &View<'_>) -> Vec<String> {
    let page = view.session.statistics();
    match page.view {
        StatisticsView::Features => page.open().map(|(feature, _)| feature.key.title(true)).into_iter().collect(),
        StatisticsView::Study => page.study.file().map(|file| file.name.clone()).into_iter().collect(),
    }
}

/// Readings of a gauge while a study is shown, else measurements.
fn dropped(view: &View<'_>, path: &Path, _number: usize) -> Command {
    let purpose = match view.session.statistics().view {
        StatisticsView::Features => Purpose::Import,
        StatisticsView::Study => Purpose::OpenStudy,
    };
    open(purpose, path)
}

/// The page.
fn statistics_ui(ui: &mut Ui, view: &mut View<'_>) {
    match view.session.statistics().view {
        StatisticsView::Features => features::features_ui(ui, view),
        StatisticsView::Study => study::study_ui(ui, view),
    }
}
