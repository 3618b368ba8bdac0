//! Above: the question, the words of it that have a button, and how many records answer it.

use eframe::egui::{Id, Key, Label, RichText, Ui};

use super::list;
use crate::gui::check::grouped;
use crate::gui::field::{FieldStyle, error_ui, field_ui};
use crate::gui::room::is_tiny;
use crate::gui::theme::{palette, sizes, space};
use crate::gui::view::{View, problem, quiet};
use crate::message::{Message, message};
use crate::report::RENDERINGS;
use crate::session::records::{LeftOut, Shorthand};
use crate::session::{Field, RecordsField};
use crate::session::{RecordsAction, WindowAction};
use crate::text::long;

/// The question, and what comes of it. In a very low window its buttons are in a menu, so that rows stay in sight.
pub(super) fn asking_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.spacing_mut().item_spacing.y = space(1.0);
    let is_tiny = is_tiny(ui);
    ui.horizontal_wrapped(|ui| {
        let name = ui.label(view.text("records-page-question"));
        let most = if is_tiny { space(50.0) } else { space(110.0) };
        question_ui(ui, view, name.id, (ui.available_width() - space(4.0)).min(most));
        if is_tiny {
            ui.menu_button(view.text("records-page-more-actions"), |ui| more_ui(ui, view));
        } else {
            for action in Shorthand::ALL.map(RecordsAction::AskRecords) {
                view.toggle(ui, action);
            }
        }
        count_ui(ui, view);
    });
    error_ui(ui, view, RecordsField::Question);
    if is_tiny {
        return;
    }
    let help = RichText::new(view.text("records-page-help")).size(sizes().small).color(palette(ui.ctx()).quiet.0);
    ui.add(Label::new(help).wrap());
    chosen_ui(ui, view);
}

/// The field; Escape empties it and goes to the list.
fn question_ui(ui: &mut Ui, view: &mut View<'_>, name: Id, width: f32) {
    let look = FieldStyle::text(width);
    let asked = field_ui(ui, view, RecordsField::Question, name, look);
    let left = asked.lost_focus() && ui.input(|input| input.key_pressed(Key::Escape));
    // What lies over the page takes Escape first.
    if left && !view.session.can(WindowAction::Close) {
        view.send(Field::from(RecordsField::Question).typed(String::new()));
        ui.memory_mut(|memory| memory.request_focus(list::id()));
    }
    asked.on_hover_text(view.text("records-page-help"));
}

/// Everything that has no room beside the question.
fn more_ui(ui: &mut Ui, view: &mut View<'_>) {
    for action in Shorthand::ALL.map(RecordsAction::AskRecords).into_iter().chain([RecordsAction::WithSimulated]) {
        view.checkbox(ui, action);
    }
    ui.separator();
    for number in 0..RENDERINGS.len() {
        view.menu_item(ui, RecordsAction::ReportRecords(number));
    }
    for action in [
        RecordsAction::CopyRecords,
        RecordsAction::ChooseNoRecords,
        RecordsAction::VerifyRecords,
        RecordsAction::CancelVerify,
    ] {
        view.menu_item(ui, action);
    }
}

/// How many records there are, as far as that is known.
fn count_ui(ui: &mut Ui, view: &View<'_>) {
    let listing = &view.session.records().listing;
    let count = listing.count();
    let number = grouped(long(count));
    let id = match (listing.is_stale, listing.is_whole) {
        (true, _) => "records-page-looking",
        (false, true) => "records-page-count",
        (false, false) => "records-page-more",
    };
    let said = Message::new(id).count("many", count).text("count", number);
    quiet(ui, view.words.say(&said));
    if let Some(why) = listing.unread.as_ref() {
        problem(ui, view.words.say(&message!("records-page-unread").message("why", why.clone())));
    }
}

/// The chosen records, and what a report of them leaves out.
fn chosen_ui(ui: &mut Ui, view: &mut View<'_>) {
    let page = view.session.records();
    let count = page.chosen_count();
    let simulated = page.chosen_simulated();
    if count == 0 {
        return;
    }
    let LeftOut { simulated: without, replaced, cycles, unread } = page.left_out();
    ui.horizontal_wrapped(|ui| {
        quiet(ui, view.words.say(&message!("records-page-chosen").count("count", count)));
        let can_report = view.session.can(RecordsAction::ReportRecords(0));
        ui.add_enabled_ui(can_report, |ui| {
            ui.menu_button(view.text("records-page-report"), |ui| {
                for number in 0..RENDERINGS.len() {
                    view.menu_item(ui, RecordsAction::ReportRecords(number));
                }
            });
        });
        for action in [RecordsAction::CopyRecords, RecordsAction::ChooseNoRecords] {
            view.field_button(ui, action);
        }
        if 0 < simulated {
            view.checkbox(ui, RecordsAction::WithSimulated);
        }
        for (id, count) in [
            ("records-page-out-simulated", without),
            ("records-page-out-replaced", replaced),
            ("records-page-out-cycles", cycles),
            ("records-page-out-unread", unread),
        ] {
            if 0 < count {
                quiet(ui, view.words.say(&Message::new(id).count("count", count)));
            }
        }
    });
}
