//! The records page: everything that was recorded.
//!
//! | file | what |
//! |---|---|
//! | here | where everything stands |
//! | `asking_panel` | above: the question, its short ways, how many records |
//! | `list`, `cells` | the rows in sight of all |
//! | `record_panel` | right, or in the place of the list: the record that is open, with its whole reasoning |
//! | `correction_panel` | the form of a correction; also on the check page |
//! | `foot_panel` | below: where records are kept, how many, what is wrong; the walk along the chain |

mod asking_panel;
mod cells;
mod correction_panel;
mod foot_panel;
mod list;
mod reasons;
mod record_panel;

use eframe::egui::{Id, Ui};

use crate::gui::page::{Group, PageView};
pub(super) use asking_panel::export_ui;
pub(super) use correction_panel::{correction_card_ui, correction_ui};
#[cfg(test)]
pub(super) use list::COLUMNS;

use super::columns::{Side, bar_ui, column_ui, rest_ui};
use super::over_page::just_opened;
use super::split::{Split, split_ui};
use super::theme::Icon;
use super::view::{View, heading, quiet};
use crate::session::{Keeping, RecordsAction};

/// From this width on the open record stands beside the list.
const BESIDE: f32 = 230.0;

pub(super) const PAGE: PageView = PageView {
    action: |_| RecordsAction::ReportRecords(0).into(),
    ..PageView::of(Group::Results, Icon::ListChecks, records_ui)
};

/// The page.
fn records_ui(ui: &mut Ui, view: &mut View<'_>) {
    if just_opened(ui, Id::unique("records-page")) {
        ui.memory_mut(|memory| memory.request_focus(list::id()));
    }
    if !view.session.recording().is_on() {
        return nothing_ui(ui, view);
    }
    bar_ui(ui, view, Side::Bottom, "records-foot", foot_panel::foot_ui);
    let split = Split { name: "records-open", beside: BESIDE, list: listed_ui, detail: record_panel::record_ui };
    split_ui(ui, view, &split, view.session.records().open.is_some());
}

fn listed_ui(ui: &mut Ui, view: &mut View<'_>) {
    asking_panel::asking_ui(ui, view);
    list::list_ui(ui, view);
}

/// Nothing is recorded, and why.
fn nothing_ui(ui: &mut Ui, view: &mut View<'_>) {
    rest_ui(ui, view, |ui, view| {
        column_ui(ui, "records-none", |ui| {
            heading(ui, view.text("page-records"));
            let is_off = view.session.recording().keeping == Keeping::Off;
            ui.label(view.text(if is_off { "records-page-off" } else { "records-page-nowhere" }));
            quiet(ui, view.text("records-page-how-on"));
        });
    });
}
