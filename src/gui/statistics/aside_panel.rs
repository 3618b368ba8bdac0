//! What stands beside the chart: histogram, spread, probability plot, signals.

use eframe::egui::{Sense, Ui};

use super::paint::drawn_ui;
use super::signals_panel;
use crate::gui::segments::segments_ui;
use crate::gui::spoken;
use crate::gui::theme::space;
use crate::gui::view::{View, heading};
use crate::series::Drawn;
use crate::session::StatisticsAction;
use crate::session::statistics::{Aside, Below};

pub(super) fn aside_ui(ui: &mut Ui, view: &mut View<'_>, aside: Aside) {
    let what = match aside {
        Aside::Signals => return signals_panel::card_ui(ui, view),
        Aside::Histogram => Drawn::Histogram,
        Aside::Spread if view.session.statistics().below() == Below::Spread => Drawn::Spread,
        Aside::Spread => Drawn::Memory,
        Aside::Probability => Drawn::Probability,
    };
    let below = StatisticsAction::ShowBelow(view.session.statistics().below());
    let shown = if aside == Aside::Spread { below } else { StatisticsAction::Show(aside) };
    let name = shown.text(view.session, view.words);
    if aside == Aside::Spread {
        segments_ui(ui, view, &Below::ALL.map(StatisticsAction::ShowBelow), space(64.0).min(ui.available_width()));
    } else {
        heading(ui, &name);
    }
    let (rect, response) = ui.allocate_exact_size(ui.available_size(), Sense::hover());
    drawn_ui(ui, view, what, rect);
    let said = view.session.statistics().aside_said(aside, view.words);
    spoken::picture(ui, &response, name, said);
}
