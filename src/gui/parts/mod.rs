//! The parts page: a plan of the features of a part, and the walk through them.
//!
//! | file | what |
//! |---|---|
//! | `plan_view`, `plan` | the plan as a table |
//! | `picture` | the part's picture with its balloons |
//! | `home` | where the focus goes when whatever had it is gone |
//! | `walk` | the part that is measured, feature by feature |

mod home;
mod picture;
mod plan;
mod plan_view;
mod walk;

use std::path::Path;

use eframe::egui::Ui;

use super::theme::Icon;
use super::view::View;
use crate::gui::page::{Group, PageView, ending, open};
use crate::session::parts::PartsView;
use crate::session::{Action, Command, PartsAction, Purpose};
pub(super) use picture::walk_picture_ui;
pub(super) use plan::grid::focus as focus_table;
pub(super) use plan::grid_id as plan_id;
#[cfg(test)]
pub(super) use walk::SIZES;
pub(super) use walk::{
    alarms_ui, asked_text, catch_typing, features_ui, has_picture as has_walk_picture, headline_card, recorded_of,
    sizes_id, skip_ui, value_card, value_question_ui,
};

pub(super) const PAGE: PageView =
    PageView { sides: &SIDES, action, opened, dropped, ..PageView::of(Group::Measure, Icon::Cube, parts_ui) };

const SIDES: [Action; 2] =
    [Action::Parts(PartsAction::ShowParts(PartsView::Walk)), Action::Parts(PartsAction::ShowParts(PartsView::Plan))];

/// Values for the part that is measured; else a plan.
fn action(view: &View<'_>) -> Action {
    let parts = view.session.parts();
    let is_measured = parts.view == PartsView::Walk && parts.walking.is_begun();
    if is_measured { PartsAction::ImportValues } else { PartsAction::OpenPlan }.into()
}

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
