//! The reports page: templates, the pages as they will print, and what is on them.
//!
//! | file | what |
//! |---|---|
//! | here | where everything stands |
//! | `asked_panel` | left: what is reported, by which template |
//! | `preview` | middle: a page as it will print, and the way to the others |
//! | `canvas` | the drawing of a page with the window's painter |
//! | `contents_panel` | right: saving and printing; language, paper, sections, the head |

mod asked_panel;
mod canvas;
mod contents_panel;
mod preview;

use eframe::egui::Ui;

use super::columns::{Page, THREE, columns_ui};
use super::page::{Group, PageView};
use super::theme::{Icon, space};
use super::view::View;
use crate::session::ReportsAction;

pub(super) const PAGE: PageView = PageView {
    action: |_| ReportsAction::OpenRecords.into(),
    ..PageView::of(Group::Results, Icon::FileText, reports_ui)
};

fn reports_ui(ui: &mut Ui, view: &mut View<'_>) {
    let page = Page {
        name: "reports",
        left: space(60.0),
        right: space(74.0),
        three: THREE,
        head: None,
        asked: asked_panel::asked_ui,
        seen: preview::preview_ui,
        seen_height: space(120.0),
        verdict: contents_panel::write_ui,
        least: space(64.0),
        answer: contents_panel::contents_ui,
    };
    columns_ui(ui, view, &page);
}
