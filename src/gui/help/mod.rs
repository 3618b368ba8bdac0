//! The help page: the manual and a sheet of all keys.
//!
//! | file | what |
//! |---|---|
//! | `topics_panel` | left: the search field, and the topics that it finds |
//! | `article` | right: what is read, and how its blocks are drawn |
//! | `text` | a paragraph: its looks, and links within the manual |
//! | `grid` | a table of the manual |
//! | `sheet` | the keys of all actions |

mod article;
mod grid;
mod sheet;
mod text;
mod topics_panel;

pub(super) use article::blocks_ui;
use eframe::egui::Ui;

use super::columns::{Side, panel_ui, rest_ui};
use super::keypad::keypad_ui;
use super::page::{Group, PageView};
use super::theme::{Icon, space};
use super::view::View;

/// From this width on the topics stand beside the text.
const BESIDE: f32 = 190.0;

pub(super) const PAGE: PageView = PageView::of(Group::Foot, Icon::Question, help_ui);

/// Topics and text beside each other where there is room, else one in the place of the other.
fn help_ui(ui: &mut Ui, view: &mut View<'_>) {
    keypad_ui(ui, view);
    let is_beside = space(BESIDE) <= ui.available_width();
    if is_beside {
        let sizes = (space(76.0), space(52.0)..=space(110.0));
        panel_ui(ui, view, Side::Left, "help-topics", sizes, |ui, view| topics_panel::topics_ui(ui, view, true));
    }
    let lists_topics = !is_beside && view.session.help().lists_topics;
    rest_ui(ui, view, |ui, view| {
        if lists_topics {
            topics_panel::topics_ui(ui, view, false);
        } else {
            article::article_ui(ui, view, is_beside);
        }
    });
}
