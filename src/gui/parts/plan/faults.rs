//! Everything that is wrong with the plan: how much, where, and a way there.

use eframe::egui::accesskit::Live;
use eframe::egui::{Button, RichText, ScrollArea, Ui, vec2};

use super::{column_id, grid, head_id};
use crate::gui::shapes;
use crate::gui::spoken::live;
use crate::gui::theme::{self, control, palette, sizes, space};
use crate::gui::view::{View, problem, quiet};
use crate::message::message;
use crate::part::{Finding, Spot};
use crate::session::parts::PlanCommand;
use crate::session::{PartsAction, PartsCommand};

/// Whether there is anything to list.
pub(in crate::gui::parts) fn has_any(view: &View<'_>) -> bool {
    let document = &view.session.parts().document;
    0 < document.faults()
}

/// What is wrong with the cell at which the keys are, else what it may hold where only a few words are possible, in a line that is always there.
pub(in crate::gui::parts) fn here_ui(ui: &mut Ui, view: &mut View<'_>) {
    let parts = view.session.parts();
    let (row, column) = parts.sheet.at();
    let finding = parts.document.finding(row, Some(column)).or_else(|| parts.document.finding(row, None));
    ui.horizontal_wrapped(|ui| {
        ui.set_min_height(space(5.0));
        if let Some(finding) = finding {
            problem(ui, view.words.told(&finding.what));
            if finding.what.meant().is_some() && view.session.can(PartsAction::TakeMeantCell) {
                view.field_button(ui, PartsAction::TakeMeantCell);
            }
            return;
        }
        let words = parts.words_here();
        if !words.is_empty() {
            quiet(ui, view.words.say(&message!("parts-page-words").text("words", words.join(", "))));
        }
    });
}

/// How much is wrong, and the buttons that lead there.
pub(in crate::gui::parts) fn count_ui(ui: &mut Ui, view: &mut View<'_>) {
    let document = &view.session.parts().document;
    let count = document.faults();
    ui.horizontal_wrapped(|ui| {
        ui.set_min_height(control(ui));
        let text = match count {
            0 if view.session.parts().document.is_blank() => view.text("parts-page-blank"),
            0 => view.text("parts-page-no-fault"),
            count => view.words.say(&message!("parts-page-faults").count("count", count)),
        };
        let colour = if count == 0 { palette(ui.ctx()).text.0 } else { palette(ui.ctx()).error.0 };
        let said = ui.label(RichText::new(&text).font(theme::bold(sizes().body)).color(colour));
        live(ui, &said, &text, Live::Polite);
        if !document.findings().is_empty() {
            view.field_button(ui, PartsAction::PreviousFinding);
            view.field_button(ui, PartsAction::NextFinding);
        }
        if !document.problems.is_empty() {
            view.field_button(ui, PartsAction::LeaveOutOfPlan);
        }
        if 0 < document.comments {
            let comments = message!("parts-page-comments").count("count", document.comments);
            quiet(ui, view.words.say(&comments));
        }
    });
}

/// The list; only the rows in sight are drawn.
pub(in crate::gui::parts) fn list_ui(ui: &mut Ui, view: &mut View<'_>) {
    let document = &view.session.parts().document;
    let problems = &document.problems;
    let findings = document.findings();
    // What the file had and the plan has no place for comes last, below a line of its own.
    let all = findings.len() + problems.len() + usize::from(!problems.is_empty());
    let height = control(ui);
    ScrollArea::vertical().id_salt("plan-faults").auto_shrink(false).show_rows(ui, height, all, |ui, rows| {
        for place in rows {
            match (findings.get(place), place.checked_sub(findings.len() + 1)) {
                (Some(finding), _) => finding_ui(ui, view, place, finding),
                (None, Some(place)) => {
                    let Some(problem) = problems.get(place) else { continue };
                    let text = view.words.told(problem);
                    if line_ui(ui, &text, &text) {
                        view.send(PartsCommand::Plan(PlanCommand::GoToProblem(place)));
                        grid::focus_next(ui);
                    }
                }
                (None, None) => {
                    ui.horizontal(|ui| {
                        ui.set_min_height(height);
                        problem(ui, view.text("parts-page-lost"));
                    });
                }
            }
        }
    });
}

/// A line of the list; whether it was clicked.
fn line_ui(ui: &mut Ui, text: &str, whole: &str) -> bool {
    let button = Button::new(RichText::new(text).size(sizes().small)).truncate().frame(false);
    let line = ui.add(button.min_size(vec2(ui.available_width(), control(ui))));
    shapes::ringed(ui, line, palette(ui.ctx()).focus.0).on_hover_text(whole).clicked()
}

/// What is wrong, and a way there.
fn finding_ui(ui: &mut Ui, view: &mut View<'_>, place: usize, finding: &Finding) {
    let what = view.words.told(&finding.what);
    let text = format!("{}   {what}", spot(view, finding.spot));
    if line_ui(ui, &text, &what) {
        view.send(PartsCommand::Plan(PlanCommand::GoToFinding(place)));
        if matches!(finding.spot, Spot::Feature(..)) {
            grid::focus_next(ui);
        }
    }
}

/// Where it is: `3, Callout`.
fn spot(view: &View<'_>, spot: Spot) -> String {
    match spot {
        Spot::Plan => view.text("parts-page-fault-plan"),
        Spot::Head(field) => view.text(&head_id(field)),
        Spot::Feature(row, column) => {
            let row = message!("parts-page-fault-row").count("row", row + 1);
            match column {
                Some(column) => {
                    let of = message!("parts-page-fault-of").message("row", row);
                    view.words.say(&of.text("column", view.text(&column_id(column))))
                }
                None => view.words.say(&row),
            }
        }
    }
}
