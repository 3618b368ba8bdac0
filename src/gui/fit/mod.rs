//! The fit page: a hole against a shaft.
//!
//! | file | what |
//! |---|---|
//! | `asked_panel` | left: the callout, fits to pick from |
//! | `parts_panel` | left: measured parts, temperature and materials, the joint of a press fit |
//! | `search_panel` | left: from a wanted clearance to classes |
//! | `picture` | middle: the classical picture |
//! | `class_map`, `staircase` | middle: every class at this size, and where the zones of a grade lie |
//! | `press_panel` | right: what a press fit holds |
//! | `answer_panel` | right: kind of fit, figures, limits, equivalent fit, what the parts do |

mod answer_panel;
mod asked_panel;
mod class_map;
mod letter_columns;
mod parts_panel;
mod picture;
mod press_panel;
mod search_panel;
mod staircase;

use eframe::egui::{Id, Ui};

use super::columns::{Page, column_ui, columns_ui};
use super::field;
use super::over_page::just_opened;
use super::theme::{Icon, space};
use super::view::View;
use crate::gui::limits::feature_id;
use crate::gui::page::{Group, PageView};
use crate::message::message;
use crate::session::FitField;
use crate::tolerance::Feature;
use crate::tolerance::fit::FitKind;

pub(super) const PAGE: PageView = PageView::of(Group::Design, Icon::Intersect, fit_ui);

/// A part and its class: `Hole H7`. What has been typed may not name a class yet.
fn part_text(view: &View<'_>, part: Feature) -> String {
    let class = view.session.fit().seen().class(part).map_or_else(String::new, |class| class.to_string());
    format!("{} {class}", view.text(feature_id(Some(part))))
}

/// What says that the fit in sight is an example.
fn example_text(view: &View<'_>) -> Option<String> {
    let callout = view.session.fit().example()?;
    Some(view.words.say(&message!("fit-example").text("callout", callout)))
}

/// The page: left what is asked, middle what is seen, right the answer.
fn fit_ui(ui: &mut Ui, view: &mut View<'_>) {
    if just_opened(ui, Id::unique("fit-page")) {
        ui.memory_mut(|memory| memory.request_focus(field::id(FitField::Callout)));
    }
    let page = Page {
        name: "fit",
        left: space(82.0),
        right: space(82.0),
        three: space(240.0),
        head: None,
        asked: |ui, view| {
            asked_panel::callout_ui(ui, view);
            ui.separator();
            parts_panel::parts_ui(ui, view);
            ui.separator();
            parts_panel::temperature_ui(ui, view);
            ui.separator();
            // A clearance fit has no joint to press; before one is typed everything can be found.
            let fit = view.session.fit().seen().fit.as_ref().filter(|_| view.session.fit().example().is_none());
            if fit.is_none_or(|fit| fit.kind() != FitKind::Clearance) {
                parts_panel::press_ui(ui, view);
                ui.separator();
            }
            search_panel::search_ui(ui, view);
        },
        seen: |ui, view| {
            let height = ui.available_height();
            column_ui(ui, "fit-seen", |ui| {
                picture::picture_ui(ui, view, (height * 0.31).max(space(50.0)));
                ui.separator();
                class_map::class_map_ui(ui, view, height);
            });
        },
        seen_height: space(190.0),
        verdict: |ui, view| answer_panel::kind_ui(ui, view),
        least: space(64.0),
        answer: answer_panel::answer_ui,
    };
    columns_ui(ui, view, &page);
}
