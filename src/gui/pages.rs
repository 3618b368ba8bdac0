//! The pages as the window shows them, a line each.

use eframe::egui::Ui;

use super::page::PageView;
use super::view::View;
use super::{
    budget, check, cycles, fit, help, pairing, parts, program, records, reports, settings, statistics, tables,
};
use crate::session::Page;

pub(super) const fn page_of(page: Page) -> PageView {
    match page {
        Page::Check => check::PAGE,
        Page::Fit => fit::PAGE,
        Page::Cycles => cycles::PAGE,
        Page::Tables => tables::PAGE,
        Page::Program => program::PAGE,
        Page::Pairing => pairing::PAGE,
        Page::Budget => budget::PAGE,
        Page::Records => records::PAGE,
        Page::Statistics => statistics::PAGE,
        Page::Reports => reports::PAGE,
        Page::Parts => parts::PAGE,
        Page::Help => help::PAGE,
        Page::Settings => settings::PAGE,
    }
}

/// Files dropped on the window are read, each as the open page uses it.
pub(super) fn dropped_ui(ui: &Ui, view: &mut View<'_>) {
    let dropped = ui.input(|input| input.raw.dropped_files.clone());
    for (number, file) in dropped.iter().enumerate() {
        let command = (page_of(view.session.page()).dropped)(view, file.path(), number);
        view.send(command);
    }
}
