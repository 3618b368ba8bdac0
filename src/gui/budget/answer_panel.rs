//! Right: the answer. U and whether the budget is valid as a card, then how it came about, what would help most, and its
//! use for checks.

use eframe::egui::{RichText, Sense, Ui, vec2};

use super::table::degrees;
use crate::budget::{Answer, Assessment, BudgetWarning, Validity};
use crate::gui::card::{plain_ui, word_ui};
use crate::gui::section::unfold;
use crate::gui::shapes;
use crate::gui::theme::{self, control, palette, sizes, space};
use crate::gui::view::{View, heading, problem, quiet};
use crate::length::without_zeros;
use crate::message::message;
use crate::session::{BudgetAction, BudgetField, BudgetForce, Page, UseOf, WindowAction, advice};
use crate::verdict::Status;

/// U and the validity. It is not a verdict on a part, so it does not have the colour of one.
pub(super) fn card_ui(ui: &mut Ui, view: &View<'_>) {
    let found = view.session.budget().found();
    let word = view.text(if found.is_some() { "budget-page-answer" } else { "budget-page-no-answer" });
    plain_ui(ui, "budget-answer", false, |ui| {
        ui.spacing_mut().item_spacing.y = space(0.5);
        quiet(ui, &word);
        let Some(found) = found else { return vec![word] };
        let um = format!("{:.3}", found.expanded());
        let large = view.words.say(&message!("budget-page-expanded").number("um", um));
        word_ui(ui, &large, (0.14, 0.08));
        let covered = covered(view, found);
        ui.label(&covered);
        let at = at_size(view);
        if let Some(at) = &at {
            quiet(ui, at);
        }
        [word, large, covered].into_iter().chain(at).chain(validity_ui(ui, view, found)).collect()
    });
}

/// For which size U is, where it depends on it.
fn at_size(view: &View<'_>) -> Option<String> {
    let size = view.session.text(BudgetField::Size).trim();
    let asks = view.session.budget().asks.size && !size.is_empty();
    asks.then(|| view.words.say(&message!("budget-page-at-size").number("size", size)))
}

fn covered(view: &View<'_>, found: &Assessment) -> String {
    let k = format!("{:.3}", found.k());
    let k = without_zeros(&k).to_owned();
    view.words.say(&match found.answer {
        Answer::Combined(_) => message!("budget-page-covered").number("k", k),
        Answer::Repeated(_) => message!("budget-page-covered-by").number("k", k).text("method", found.method()),
    })
}

/// Whether the budget is valid: a word, a shape and the day. Returns what a screen reader says.
fn validity_ui(ui: &mut Ui, view: &View<'_>, found: &Assessment) -> Vec<String> {
    let palette = palette(ui.ctx());
    let until = || found.budget.valid_until.to_string();
    let (shape, colour, word, rest) = match found.validity {
        Validity::Valid => {
            let word = message!("budget-page-valid").text("until", until());
            (Some(Status::Good), palette.text.0, view.words.say(&word), None)
        }
        Validity::Expired => {
            let day = view.session.budget().day_shown();
            let rest = message!("budget-page-expired-on").text("until", until()).text("day", day);
            (Some(Status::Scrap), palette.error.0, view.text("budget-page-expired"), Some(rest))
        }
        Validity::NotYet => {
            let rest = message!("budget-page-not-yet-on").text("date", found.budget.date);
            (None, palette.error.0, view.text("budget-page-not-yet"), Some(rest))
        }
    };
    let font = if rest.is_some() { theme::bold(sizes().figure) } else { theme::font(sizes().body) };
    let galley = ui.painter().layout_no_wrap(word.clone(), font, colour);
    let mark = space(4.0);
    let size = vec2(mark + space(1.5) + galley.size().x, galley.size().y.max(mark));
    let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
    let place = eframe::egui::Align2::LEFT_CENTER.align_size_within_rect(vec2(mark, mark), rect);
    shapes::status(ui.painter(), place, shape, colour);
    let at = eframe::egui::Align2::RIGHT_CENTER.align_size_within_rect(galley.size(), rect);
    ui.painter().galley(at.min, galley, colour);
    let rest = rest.map(|rest| view.words.say(&rest));
    if let Some(rest) = &rest {
        ui.label(rest);
    }
    std::iter::once(word).chain(rest).collect()
}

/// How it came about, what would help most, and its use.
pub(super) fn answer_ui(ui: &mut Ui, view: &mut View<'_>) {
    match view.session.budget().answer.as_ref() {
        Some(Ok(found)) => {
            figures_ui(ui, view, found);
            help_ui(ui, view, found);
            ui.separator();
        }
        Some(Err(error)) => {
            problem(ui, view.words.say(error));
            ui.separator();
        }
        None => {}
    }
    use_ui(ui, view);
}

fn figures_ui(ui: &mut Ui, view: &View<'_>, found: &Assessment) {
    let u = message!("budget-page-standard").number("um", format!("{:.3}", found.u()));
    ui.label(RichText::new(view.words.say(&u)).font(theme::bold(sizes().figure)));
    if let Answer::Combined(evaluation) = &found.answer {
        let infinite = || view.text("budget-page-infinite");
        let shown =
            evaluation.degrees_of_freedom.map_or_else(infinite, |_| degrees(view, evaluation.degrees_of_freedom));
        ui.label(view.words.say(&message!("budget-page-degrees").text("degrees", shown)));
    }
    let budget = &found.budget;
    ui.label(RichText::new(&budget.name).font(theme::bold(sizes().body)));
    let made = message!("budget-page-made").text("date", budget.date).text("by", &budget.by);
    quiet(ui, view.words.say(&made));
    let method = match found.answer {
        Answer::Combined(_) => view.text("budget-page-method-gum"),
        Answer::Repeated(_) => found.method().to_owned(),
    };
    quiet(ui, view.words.say(&message!("budget-page-method").text("method", method)));
    // What of the template is left is said below, one by one.
    for warning in found.warnings().into_iter().filter(|warning| *warning != BudgetWarning::OfTemplate) {
        problem(ui, view.words.told(&warning));
    }
    // Figures that may well be true of the station are no problem.
    if let Some(warning) = found.budget.template_figures() {
        quiet(ui, view.words.told(&warning));
    }
}

fn help_ui(ui: &mut Ui, view: &View<'_>, found: &Assessment) {
    let Answer::Combined(evaluation) = &found.answer else { return };
    let Some(row) = evaluation.rows.get(evaluation.largest) else { return };
    ui.separator();
    heading(ui, view.text("budget-page-largest"));
    let largest =
        message!("budget-page-largest-is").text("name", &row.name).number("percent", format!("{:.1}", row.share));
    ui.label(view.words.say(&largest));
    heading(ui, view.text("budget-page-help"));
    for help in advice(evaluation) {
        ui.label(view.words.say(&help));
    }
}

/// Which budget checks use.
fn use_ui(ui: &mut Ui, view: &mut View<'_>) {
    heading(ui, view.text("budget-page-checks"));
    let used = view.session.used_budget();
    let force = view.session.budget_force();
    let said = match (view.session.budget().use_of(used), used) {
        (_, Some(used)) if force == BudgetForce::TypedCounts => {
            message!("budget-page-uses-typed").text("name", &used.budget.name)
        }
        (_, Some(used)) if force == BudgetForce::RuleWithout => {
            message!("budget-page-uses-no-rule").text("name", &used.budget.name)
        }
        (UseOf::Another, Some(used)) => {
            message!("budget-page-uses-another").text("name", &used.budget.name).text("file", &used.file)
        }
        (_, Some(used)) => message!("budget-page-uses-this").text("name", &used.budget.name),
        (_, None) => message!("budget-page-uses-none"),
    };
    ui.label(view.words.say(&said));
    if used.is_some()
        && force != BudgetForce::InForce
        && view.field_button(ui, WindowAction::Open(Page::Check)).clicked()
    {
        unfold(ui.ctx(), "check-rule-section");
    }
    let placeholders = view.session.budget().placeholders();
    if !placeholders.is_empty() {
        let what = placeholders.iter().map(|what| view.words.say(what)).collect::<Vec<_>>().join(", ");
        problem(ui, view.words.say(&message!("budget-page-placeholders").text("what", what)));
    }
    let width = view.width_of(ui, &[BudgetAction::UseBudget]);
    view.main_button(ui, BudgetAction::UseBudget, vec2(width, control(ui)));
    view.field_button(ui, BudgetAction::LeaveBudget);
}
