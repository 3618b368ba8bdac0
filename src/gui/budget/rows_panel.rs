//! Left: the contributions of the budget as a table. Each is a row that says its figure; the one that is open has its
//! fields below it. What is changed there changes the text.

use eframe::egui::{Align, ComboBox, Layout, Ui, vec2};

use super::table::law_id;
use crate::budget::{Basis, Budget, Evaluated, KindName, Law};
use crate::gui::field::{FieldStyle, error_ui, field_ui, half_width, pairs_ui};
use crate::gui::section::Section;
use crate::gui::segments::segments_ui;
use crate::gui::theme::{Icon, space};
use crate::gui::view::{View, caret_ui, heading, list_height, problem, quiet};
use crate::message::message;
use crate::session::{
    BudgetAction, BudgetCommand, BudgetField, BudgetPage, BudgetView, Field, GivenAs, KindChoice, WrittenContribution,
};

/// Table or text.
pub(super) fn switch_ui(ui: &mut Ui, view: &mut View<'_>) {
    let width = ui.available_width().min(space(60.0));
    segments_ui(ui, view, &BudgetView::ALL.map(BudgetAction::ShowBudget), width);
}

/// The rows, and what is wrong with the text where they are not what it says.
pub(super) fn rows_ui(ui: &mut Ui, view: &mut View<'_>) {
    let budget = view.session.budget();
    let name = budget.document.name();
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().interact_size.y = 0.0;
        heading(ui, view.text("budget-rows"));
        if budget.document.is_unsaved() {
            quiet(ui, view.words.say(&message!("budget-page-not-saved").text("name", &name)));
        } else if !budget.document.text.is_empty() {
            quiet(ui, &name);
        }
    });
    if budget.document.text.is_empty() {
        quiet(ui, view.text("budget-page-none"));
        return;
    }
    ui.add_enabled_ui(!budget.is_stale(), |ui| head_ui(ui, view));
    if matches!(budget.read, Some(Ok(Budget { basis: Basis::Calibrated(_), .. }))) {
        quiet(ui, view.text("budget-table-calibrated"));
        return;
    }
    let is_stale = budget.is_stale();
    if is_stale {
        let is_faulty = matches!(budget.read, Some(Err(_)));
        problem(ui, view.text(if is_faulty { "budget-table-stale" } else { "budget-table-other" }));
    }
    if let Some(Err(error)) = &budget.read {
        problem(ui, view.words.told(error));
    }
    ui.add_enabled_ui(!is_stale, |ui| {
        for (number, row) in budget.rows.iter().enumerate() {
            row_ui(ui, view, number, row);
        }
    });
    ui.add_space(space(1.0));
    view.field_button(ui, BudgetAction::AddContribution);
}

/// Of what the budget is and who made it: checks use no budget that nobody has put a name to.
fn head_ui(ui: &mut Ui, view: &mut View<'_>) {
    for (field, name) in [(BudgetField::HeadName, "budget-head-name"), (BudgetField::HeadBy, "budget-head-by")] {
        let name = quiet(ui, view.text(name));
        field_ui(ui, view, field, name.id, FieldStyle::text(ui.available_width()));
        error_ui(ui, view, field);
    }
    ui.add_space(space(1.0));
}

fn row_ui(ui: &mut Ui, view: &mut View<'_>, number: usize, row: &WrittenContribution) {
    let is_open = view.session.budget().chosen == Some(number);
    let name = row.value("name").to_owned();
    let value = told(view, row);
    let said = view.words.say(&message!("section-said").text("name", &name).text("value", &value));
    ui.push_id(("contribution", number), |ui| {
        let section = Section { icon: Icon::PlusMinus, name: "", value, is_wrong: false };
        if section.row_ui(ui, (&name, &said), is_open) {
            view.send(BudgetCommand::Choose((!is_open).then_some(number)));
        }
        if is_open {
            fields_ui(ui, view, row);
            ui.add_space(space(2.0));
        }
    });
}

/// The figure of a row, its divisor and its law.
fn told(view: &View<'_>, row: &WrittenContribution) -> String {
    let Some(law) = BudgetPage::law(row) else { return view.text("budget-row-unread") };
    let kind = BudgetPage::kind(row);
    let divisor = match (kind, law) {
        (Some(KindName::Resolution), _) => "2√3",
        (_, Law::Rectangular) => "√3",
        (_, Law::UShaped) => "√2",
        (_, Law::Triangular) => "√6",
        (_, Law::Normal) if BudgetPage::given_as(row) == Some(GivenAs::Expanded) => row.value("k"),
        (_, Law::Normal) => "1",
    };
    let said = message!("budget-row-said")
        .text("value", view.words.number(row.value(BudgetPage::value_key(row))))
        .text("unit", unit(row))
        .text("divisor", view.words.number(divisor))
        .text("law", view.text(law_id(law)));
    view.words.say(&said)
}

/// The unit of its figure.
fn unit(row: &WrittenContribution) -> &'static str {
    match BudgetPage::value_key(row) {
        key if key.ends_with("_per_k") => "1/K",
        key if key.ends_with("_k") => "K",
        _ => "µm",
    }
}

fn fields_ui(ui: &mut Ui, view: &mut View<'_>, row: &WrittenContribution) {
    let column = half_width(ui);
    let name = quiet(ui, view.text("budget-row-name"));
    field_ui(ui, view, BudgetField::RowName, name.id, FieldStyle::text(ui.available_width()));
    error_ui(ui, view, BudgetField::RowName);
    let kinds: Vec<_> = KindChoice::all().map(BudgetAction::KindOfContribution).collect();
    let types = [Evaluated::A, Evaluated::B].map(BudgetAction::TypeOfContribution);
    let laws = Law::ALL.map(BudgetAction::LawOfContribution);
    let given = GivenAs::ALL.map(BudgetAction::GiveContribution);
    choices_ui(ui, view, ui.available_width(), &[("budget-row-kind", &kinds)]);
    choices_ui(ui, view, column, &[("budget-row-type", &types), ("budget-row-law", &laws)]);
    choices_ui(ui, view, ui.available_width(), &[("budget-row-given", &given)]);
    let value = match BudgetPage::given_as(row) {
        _ if BudgetPage::kind(row) == Some(KindName::Resolution) => "budget-row-resolution",
        Some(GivenAs::Standard) => "budget-given-standard",
        Some(GivenAs::Expanded) => "budget-given-expanded",
        None => "budget-row-half-width",
    };
    // Who has n readings of a type A types n − 1.
    let is_counted = BudgetPage::evaluated(row) == Some(Evaluated::A);
    let freedom = if is_counted { "budget-row-freedom-a" } else { "budget-row-freedom" };
    let all = [
        (BudgetField::RowValue, value, unit(row)),
        (BudgetField::RowCoverage, "budget-row-k", ""),
        (BudgetField::RowAlpha, "budget-row-alpha", ""),
        (BudgetField::RowDelta, "budget-row-delta", "K"),
        (BudgetField::RowTouches, "budget-row-touches", ""),
        (BudgetField::RowStep, "budget-row-step", "°"),
        (BudgetField::RowSensitivity, "budget-row-sensitivity", ""),
        (BudgetField::RowFreedom, freedom, ""),
    ];
    let has = |field: &BudgetField| BudgetPage::key_of(*field, row).is_some();
    let fields: Vec<(Field, String, &str)> = all
        .into_iter()
        .filter(|(field, ..)| has(field))
        .map(|(field, name, unit)| (field.into(), view.text(name), unit))
        .collect();
    pairs_ui(ui, view, &fields);
    ui.add_space(space(1.0));
    view.field_button(ui, BudgetAction::RemoveContribution);
}

/// Lists of choices side by side, each below its name; one that is not possible is left out.
fn choices_ui(ui: &mut Ui, view: &mut View<'_>, column: f32, lists: &[(&str, &[BudgetAction])]) {
    ui.horizontal_top(|ui| {
        ui.spacing_mut().item_spacing.x = space(2.0);
        for (name, actions) in lists.iter().copied() {
            if !actions.iter().any(|action| view.session.can(*action)) {
                continue;
            }
            ui.allocate_ui_with_layout(vec2(column, 0.0), Layout::top_down(Align::Min), |ui| {
                ui.set_width(column);
                let label = quiet(ui, view.text(name));
                let chosen = actions.iter().find(|action| action.is_on(view.session) == Some(true));
                let shown = chosen.map_or_else(String::new, |action| action.text(view.session, view.words));
                let list = ComboBox::from_id_salt(name).selected_text(shown).width(column).truncate().icon(caret_ui);
                let list = list.height(list_height(ui)).show_ui(ui, |ui| {
                    for action in actions {
                        let is_on = action.is_on(view.session) == Some(true);
                        if ui.selectable_label(is_on, action.text(view.session, view.words)).clicked() {
                            view.act(*action);
                        }
                    }
                });
                list.response.labelled_by(label.id);
            });
        }
    });
}
