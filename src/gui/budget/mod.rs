//! The budget page: how sure a measured value is.
//!
//! | file | what |
//! |---|---|
//! | `rows_panel` | left: its contributions, each with its fields |
//! | `text_panel` | left, in its place: the budget as TOML, with what is wrong with it |
//! | `asked_panel` | left, below: size, contacts, day and readings that it is evaluated for |
//! | `table`, `bars` | middle: the table of contributions, and their shares as bars |
//! | `answer_panel` | right: U, validity, what would help most, use for checks |

mod answer_panel;
mod asked_panel;
mod bars;
mod rows_panel;
mod table;
mod text_panel;

use std::path::Path;

use eframe::egui::{Id, Ui};

use super::columns::{Page, THREE, column_ui, columns_ui};
use super::over_page::just_opened;
use super::theme::{Icon, space};
use super::view::{View, quiet};
use crate::gui::page::{Group, PageView, ending, open};
use crate::session::{BudgetAction, BudgetView, Command, Purpose};

pub(super) const PAGE: PageView = PageView {
    action: |_| BudgetAction::OpenBudget.into(),
    opened,
    dropped,
    ..PageView::of(Group::Uncertainty, Icon::PlusMinus, budget_ui)
};

/// The budget.
fn opened(view: &View<'_>) -> Vec<String> {
    vec![view.session.budget().document.name()]
}

/// The page: left what is asked, middle what is seen, right the answer.
fn budget_ui(ui: &mut Ui, view: &mut View<'_>) {
    let is_text = view.session.budget().shows == BudgetView::Text;
    if just_opened(ui, Id::unique("budget-page")) && is_text {
        ui.memory_mut(|memory| memory.request_focus(text_panel::id(view)));
    }
    let page = Page {
        name: "budget",
        left: space(104.0),
        right: space(76.0),
        three: THREE,
        head: Some(text_panel::head_ui),
        asked: |ui, view| {
            rows_panel::switch_ui(ui, view);
            match view.session.budget().shows {
                BudgetView::Table => rows_panel::rows_ui(ui, view),
                BudgetView::Text => text_panel::text_ui(ui, view),
            }
            asked_panel::asked_ui(ui, view);
        },
        seen: seen_ui,
        seen_height: space(150.0),
        verdict: |ui, view| answer_panel::card_ui(ui, view),
        least: space(64.0),
        answer: answer_panel::answer_ui,
    };
    columns_ui(ui, view, &page);
}

fn seen_ui(ui: &mut Ui, view: &mut View<'_>) {
    column_ui(ui, "budget-seen", |ui| {
        let Some(found) = view.session.budget().found() else {
            quiet(ui, view.text("budget-page-nothing-seen"));
            return;
        };
        table::table_ui(ui, view, found);
        bars::bars_ui(ui, view, found);
    });
}

/// A budget by its ending, else readings where the budget asks for them.
fn dropped(view: &View<'_>, path: &Path, _number: usize) -> Command {
    let purpose = match ending(path).as_str() {
        "toml" => Purpose::OpenBudget,
        _ if view.session.budget().asks.readings => Purpose::OpenReadings,
        _ => Purpose::Import,
    };
    open(purpose, path)
}
