//! The settings page: sections at the left, and the settings of the chosen one, or all that are found, at the right.
//!
//! | file | what |
//! |---|---|
//! | here | where everything stands |
//! | `sections_panel` | left, or above where the window is narrow: the search and the sections |
//! | `rows_panel` | the settings, a row each |
//! | `controls`, `slot` | how a setting is set, by its kind; where, and what several kinds have |
//! | `gauge_controls` | the gauge that is shown, its port, its lines |
//! | `told` | what is in force |
//! | `keys_panel` | every key |

mod controls;
mod gauge_controls;
mod keys_panel;
mod rows_panel;
mod sections_panel;
mod slot;
mod told;

use eframe::egui::{Frame, Id, Panel, Ui};

use super::card::page_card_ui;
use super::columns::{Side, rest_ui};

use super::field;
use super::keypad::keypad_ui;
use super::over_page::just_opened;
use super::page::{Group, PageView};
use super::theme::{Icon, space};
use super::view::View;
pub(super) use told::gauge_state;

use crate::session::SettingsField;

/// From this width on the sections stand beside the settings.
const BESIDE: f32 = 180.0;

/// The width of the sections, in steps of the grid.
const SECTIONS: f32 = 64.0;

pub(super) const PAGE: PageView = PageView { opened: section, ..PageView::of(Group::Foot, Icon::GearSix, settings_ui) };

/// Which section is shown.
fn section(view: &View<'_>) -> Vec<String> {
    vec![view.text(view.session.settings_page().section.name())]
}

fn settings_ui(ui: &mut Ui, view: &mut View<'_>) {
    if just_opened(ui, Id::unique("settings-page")) {
        ui.memory_mut(|memory| memory.request_focus(field::id(SettingsField::Find)));
    }
    let is_beside = space(BESIDE) <= ui.available_width();
    if is_beside {
        let panel = Panel::left("settings-sections").resizable(false).exact_size(space(SECTIONS));
        let panel = panel.show_separator_line(false).frame(Frame::new().inner_margin(Side::Left.gap()));
        panel.show(ui, |ui| {
            page_card_ui(ui, |ui| {
                sections_panel::find_ui(ui, view);
                sections_panel::list_ui(ui, view);
            });
        });
    }
    keypad_ui(ui, view);
    rest_ui(ui, view, |ui, view| {
        if !is_beside {
            sections_panel::find_ui(ui, view);
            sections_panel::chooser_ui(ui, view);
        }
        rows_panel::rows_ui(ui, view);
    });
}
