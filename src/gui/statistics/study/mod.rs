//! A study of a gauge: its readings are opened, how they were understood is confirmed, and then it is evaluated.
//!
//! | file | what |
//! |---|---|
//! | `asked_panel` | left: the file, the kind of study, limits and references |
//! | `figures_panel` | middle: figures with intervals and methods, the chart of a stability study |
//! | `answer_panel` | right: the layout to confirm, then whether the gauge is good enough |

mod answer_panel;
mod asked_panel;
mod figures_panel;

use eframe::egui::Ui;

use crate::gui::columns::{Page, THREE, columns_ui};
use crate::gui::theme::space;
use crate::gui::top_bar::{has_sides, sides_ui};
use crate::gui::view::View;

/// The view: left what is asked, middle what is seen, right the answer.
pub(super) fn study_ui(ui: &mut Ui, view: &mut View<'_>) {
    let page = Page {
        name: "study",
        left: space(80.0),
        right: space(96.0),
        three: THREE,
        head: (!has_sides(ui)).then_some(sides_ui),
        asked: asked_panel::asked_ui,
        seen: figures_panel::seen_ui,
        seen_height: space(150.0),
        verdict: answer_panel::answer_card_ui,
        least: space(72.0),
        answer: answer_panel::advice_ui,
    };
    columns_ui(ui, view, &page);
}
