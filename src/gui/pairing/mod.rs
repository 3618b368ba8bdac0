//! The pairing page: which measured holes go with which measured shafts.
//!
//! | file | what |
//! |---|---|
//! | `asked_panel` | left: the wanted clearance, holes and shafts, groups |
//! | `picture` | middle: both columns of parts with their pairs as lines |
//! | `pairs_list` | middle: the pairs in sight of all |
//! | `answer_panel` | right: how many pairs, their clearances, what is left over, grinding |
//! | `groups_panel` | right: the groups |

mod answer_panel;
mod asked_panel;
mod groups_panel;
mod pairs_list;
mod picture;

use std::path::Path;

use eframe::egui::{Id, Ui};

use crate::gui::page::{Group, PageView, open};
use crate::session::{Command, PairingCommand, PairingField, Purpose};

#[cfg(test)]
pub(super) use pairs_list::columns;

use super::columns::{Page, THREE, columns_ui, of_height};
use super::field;
use super::over_page::just_opened;
use super::theme::{Icon, control, space};
use super::view::View;

pub(super) const PAGE: PageView =
    PageView { dropped, ..PageView::of(Group::Design, Icon::LinkSimpleHorizontal, pairing_ui) };

/// The page: left what is asked, middle what is seen, right the answer.
fn pairing_ui(ui: &mut Ui, view: &mut View<'_>) {
    if just_opened(ui, Id::unique("pairing-page")) {
        ui.memory_mut(|memory| memory.request_focus(field::id(PairingField::Wanted)));
    }
    let page = Page {
        name: "pairing",
        left: space(76.0),
        right: space(82.0),
        three: THREE,
        head: None,
        asked: asked_panel::asked_ui,
        seen: seen_ui,
        seen_height: space(140.0),
        verdict: |ui, view| answer_panel::count_ui(ui, view),
        least: space(64.0),
        answer: answer_panel::answer_ui,
    };
    columns_ui(ui, view, &page);
}

/// Picture and list; without an answer what is to be done.
fn seen_ui(ui: &mut Ui, view: &mut View<'_>) {
    let Some(paired) = view.session.pairing().paired.as_deref() else { return asked_panel::missing_ui(ui, view) };
    // The list keeps its heads and three rows.
    let height = (ui.available_height() * 0.52).min(ui.available_height() - control(ui) * 4.0 - space(4.0));
    if space(24.0) <= height {
        of_height(ui, height, |ui| picture::picture_ui(ui, view, paired));
        ui.separator();
    }
    pairs_list::list_ui(ui, view, paired);
}

/// Measurements of the side that is free; of several, one for each.
fn dropped(view: &View<'_>, path: &Path, number: usize) -> Command {
    if let Some(feature) = view.session.pairing().side_of_dropped(number) {
        return open(Purpose::OpenParts(feature), path);
    }
    let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
    PairingCommand::NoSideFree { name }.into()
}
