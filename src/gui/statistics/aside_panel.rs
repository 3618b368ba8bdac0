//! What stands beside the chart: histogram, spread, probability plot, signals.

use eframe::egui::{Sense, Ui};

use super::paint::drawn_ui;
use super::signals_panel;
use crate::gui::spoken;
use crate::gui::view::{View, heading};
use crate::series::Drawn;
use crate::session::StatisticsAction;
use crate::session::statistics::Aside;

pub(super) fn aside_ui(ui: &mut Ui, view: &mut View<'_>, aside: Aside) {
    let what = match aside {
        Aside::Signals => return signals_panel::card_ui(ui, view),
        Aside::Histogram => Drawn::Histogram,
        Aside::Spread => Drawn::Spread,
        Aside::Probability => Drawn::Probability,
    };
    let name = StatisticsAction::Show(aside).text(view.session, view.words);
    heading(ui, &name);
    let (rect, response) = ui.allocate_exact_size(ui.available_size(), Sense::hover());
    drawn_ui(ui, view, what, rect);
    let said = view.session.statistics().aside_said(aside, view.words);
    spoken::picture(ui, &response, name, said);
}
