//! Above the cells one row of tools: which table, what is shown of it, and what can be done with it. Below them whether it agrees with ISO 286.

use eframe::egui::accesskit::Live;
use eframe::egui::{Label, RichText, Sense, Ui, vec2};

use super::paint;
use crate::exchange::tables::TABLE_FORMATS;
use crate::gui::field::{FieldStyle, field_ui};
use crate::gui::shapes;
use crate::gui::spoken::live;
use crate::gui::theme::{self, control, palette, sizes, space};
use crate::gui::view::{View, list_ui, quiet, quiet_cut};
use crate::message::message;
use crate::session::tables::{Document, Origin, TableChoice};
use crate::session::{TablesAction, TablesCommand, TablesField};
use crate::verdict::Status;

/// What has a button of its own as far as there is room, the most important one first; the rest is in a menu.
const TOOLS: [TablesAction; 6] = [
    TablesAction::OnlyDifferences,
    TablesAction::NextDifference,
    TablesAction::UndoEdit,
    TablesAction::RedoEdit,
    TablesAction::UseTable,
    TablesAction::PreviousDifference,
];

/// One row: which table, what is shown of it, and what can be done with it.
pub(super) fn tool_bar_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.horizontal_wrapped(|ui| {
        ui.set_min_height(control(ui));
        choice_ui(ui, view);
        theme::looking(ui, theme::tonal, |ui| {
            ui.spacing_mut().interact_size.y = control(ui);
            ui.menu_button(view.text("tables-save"), |ui| {
                for number in 0..TABLE_FORMATS.len() {
                    view.menu_item(ui, TablesAction::SaveTable(number));
                }
            });
        });
        filter_ui(ui, view);
        tools_ui(ui, view);
    });
}

fn tools_ui(ui: &mut Ui, view: &mut View<'_>) {
    let gap = ui.spacing().item_spacing.x;
    let widths = TOOLS.map(|action| view.width_of(ui, &[action]) + gap);
    let room = ui.available_size_before_wrap().x;
    let has_all = widths.iter().sum::<f32>() <= room;
    let mut left = if has_all { room } else { room - control(ui) - 2.0 * gap };
    let mut more = Vec::new();
    for (action, width) in TOOLS.into_iter().zip(widths) {
        if width <= left && more.is_empty() {
            left -= width;
            if action == TablesAction::OnlyDifferences {
                view.toggle(ui, action);
            } else {
                view.field_button(ui, action);
            }
        } else {
            more.push(action);
        }
    }
    if !more.is_empty() {
        view.more_ui(ui, |ui, view| {
            for action in more {
                view.menu_item(ui, action);
            }
        });
    }
}

/// The name of a table and what kind it is.
fn told(view: &View<'_>, title: &str, origin: Origin) -> String {
    let kind = match origin {
        Origin::Shipped => "tables-kind-shipped",
        Origin::Own => "tables-kind-own",
        Origin::File => "tables-kind-file",
        Origin::Copy => "tables-kind-copy",
        Origin::Made => "tables-kind-made",
    };
    format!("{title}, {}", view.text(kind))
}

fn choice_ui(ui: &mut Ui, view: &mut View<'_>) {
    let name = ui.label(view.text("tables-choice"));
    // Where no table is open none is chosen.
    let shown = view.session.tables().shown();
    let shown = shown.map_or_else(String::new, |document| told(view, &document.title, document.origin));
    let list = list_ui(ui, "table-choice", shown, space(54.0), |ui| {
        let open = view.session.tables().documents.iter().enumerate();
        let open = open.map(|(number, document)| {
            let mut text = told(view, &document.title, document.origin);
            if document.is_unsaved() {
                text = format!("{text}, {}", view.text("tables-unsaved"));
            }
            (TableChoice::Document(number), text)
        });
        let own = view.session.unopened_tables();
        let own = own.map(|(number, table)| (TableChoice::Own(number), told(view, table.name(), Origin::Own)));
        let entries: Vec<_> = open.chain(own).collect();
        for (choice, text) in entries {
            let chosen = choice == TableChoice::Document(view.session.tables().number());
            if ui.selectable_label(chosen, text).clicked() {
                view.send(TablesCommand::Open(choice));
            }
        }
    });
    list.labelled_by(name.id);
}

fn filter_ui(ui: &mut Ui, view: &mut View<'_>) {
    let name = ui.label(view.text("tables-filter"));
    let look = FieldStyle::text(space(30.0));
    let field = field_ui(ui, view, TablesField::Filter, name.id, look);
    field.on_hover_text(view.text("tables-filter-hint"));
    let filter = &view.session.tables().filter;
    if !filter.unmatched.is_empty() {
        let words = filter.unmatched.join(" ");
        let text = view.words.say(&message!("tables-unmatched").text("words", words));
        let text = RichText::new(text).color(palette(ui.ctx()).error.0).size(sizes().small);
        ui.scope(|ui| {
            ui.set_max_width(space(44.0));
            ui.add(Label::new(text).truncate())
        });
    }
}

/// Whether the table agrees with ISO 286: mark and sentence.
fn summary_ui(ui: &mut Ui, view: &View<'_>, document: &Document) {
    let comparison = &document.comparison;
    let found = document.differing();
    let compared = comparison.compared;
    let palette = palette(ui.ctx());
    let (mark, _) = ui.allocate_exact_size(vec2(space(4.0), space(4.0)), Sense::hover());
    let message = match (found, compared) {
        (0, 0) => message!("tables-compared-nothing"),
        (0, _) => message!("tables-agrees").count("count", compared),
        _ => message!("tables-differs").count("count", found).text("compared", compared),
    };
    if 0 < found {
        paint::unequal(ui.painter(), mark, palette.error.0);
    } else {
        shapes::status(ui.painter(), mark, (0 < compared).then_some(Status::Good), palette.text.0);
    }
    let mut said = view.words.say(&message);
    if !comparison.unknown.is_empty() {
        let own = message!("tables-own-classes").count("count", comparison.unknown.len());
        said = format!("{said}; {}", view.words.say(&own));
    }
    let label = ui.label(RichText::new(&said).font(theme::bold(sizes().body)));
    live(ui, &label, &said, Live::Polite);
}

/// Below the cells: whether the table agrees with ISO 286, how many classes are shown, whether anything is unsaved; and the keys,
/// where they have room.
pub(super) fn strip_ui(ui: &mut Ui, view: &View<'_>) {
    let Some(document) = view.session.tables().shown() else { return };
    ui.horizontal_wrapped(|ui| {
        ui.set_min_height(space(8.0));
        summary_ui(ui, view, document);
        let shown = view.session.tables().filter.columns.len();
        let all = document.table().columns().len();
        quiet(ui, view.words.say(&message!("tables-shown").text("shown", shown).count("count", all)));
        if document.is_unsaved() {
            ui.label(RichText::new(view.text("tables-not-saved")).font(theme::bold(sizes().small)));
        }
        if space(100.0) <= ui.available_size_before_wrap().x {
            quiet_cut(ui, view.text("tables-keys"));
        }
    });
}
