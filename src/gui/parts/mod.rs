//! The parts page: a plan of the features of a part, and the walk through them.
//!
//! | file | what |
//! |---|---|
//! | `head` | above both views: the switch between them, new, open, save |
//! | `plan_view`, `plan` | the plan as a table |
//! | `picture` | the part's picture with its balloons |
//! | `home` | where the focus goes when whatever had it is gone |
//! | `walk` | the part that is measured, feature by feature |

mod head;
mod home;
mod picture;
mod plan;
mod plan_view;
mod walk;

use std::path::Path;

use eframe::egui::Ui;

use super::columns::{Side, bar_ui};
use super::theme::Icon;
use super::view::View;
use crate::gui::page::{Group, PageView, ending, open};
use crate::session::Command;
use crate::session::Purpose;
use crate::session::parts::PartsView;
pub(super) use plan::grid::focus as focus_table;
pub(super) use plan::grid_id as plan_id;
#[cfg(test)]
pub(super) use walk::SIZES;
pub(super) use walk::sizes_id;

pub(super) const PAGE: PageView = PageView { group: Group::Measure, icon: Icon::Cube, ui: parts_ui, opened, dropped };

/// The plan, and the serial number of the part that is measured.
fn opened(view: &View<'_>) -> Vec<String> {
    let parts = view.session.parts();
    let plan = Some(parts.document.name()).filter(|_| !parts.document.is_empty());
    let serial = Some(parts.walking.serial().to_owned()).filter(|serial| !serial.is_empty());
    plan.into_iter().chain(serial).collect()
}

/// The page.
fn parts_ui(ui: &mut Ui, view: &mut View<'_>) {
    home::home_ui(ui, view);
    let is_walk = view.session.parts().view == PartsView::Walk;
    // Where there is no room, the head scrolls with the walk: the verdict stays in sight.
    if !(is_walk && walk::has_head(ui, view)) {
        bar_ui(ui, view, Side::Top, "parts-head", head::head_ui);
    }
    if is_walk {
        walk::walk_ui(ui, view);
    } else {
        plan_view::plan_ui(ui, view);
    }
}

/// A plan, its picture, or measurements, by its ending.
fn dropped(_view: &View<'_>, path: &Path, _number: usize) -> Command {
    let purpose = match ending(path).as_str() {
        "toml" => Purpose::OpenPlan,
        ending if Purpose::OpenPicture.endings().contains(&ending) => Purpose::OpenPicture,
        _ => Purpose::Import,
    };
    open(purpose, path)
}
