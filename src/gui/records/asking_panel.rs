//! Above: the question, the words of it that have a button, and how many records answer it.

use eframe::egui::{Button, Id, Key, Label, RichText, Ui, vec2};

use super::list;
use crate::gui::check::grouped;
use crate::gui::field::{FieldStyle, error_ui, field_ui};
use crate::gui::room::is_tiny;
use crate::gui::theme::{self, Icon, Weight, control, palette, sizes, space};
use crate::gui::view::{View, one_of_ui, problem, quiet};
use crate::journal::ask::KEYS;
use crate::message::{Message, message};
use crate::report::of_any_paper;
use crate::session::records::{Filter, LeftOut, NOT_GOOD, Shorthand};
use crate::session::{Command, Field, RecordsAction, RecordsCommand, RecordsField, WindowAction};
use crate::text::long;
use crate::verdict::Status;

/// The question, and what comes of it. In a very low window its buttons are in a menu, so that rows stay in sight.
pub(super) fn asking_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.spacing_mut().item_spacing.y = space(1.0);
    let is_tiny = is_tiny(ui);
    ui.horizontal_wrapped(|ui| {
        let name = ui.label(view.text("records-page-question"));
        let most = if is_tiny { space(50.0) } else { space(80.0) };
        question_ui(ui, view, name.id, (ui.available_width() - space(4.0)).min(most));
        if is_tiny {
            ui.menu_button(view.text("records-page-more-actions"), |ui| more_ui(ui, view));
        } else {
            chips_ui(ui, view);
            view.toggle(ui, RecordsAction::AskForFilter);
        }
        count_ui(ui, view);
    });
    error_ui(ui, view, RecordsField::Question);
    if is_tiny {
        return;
    }
    if view.session.records().is_filtering {
        filter_ui(ui, view);
    }
}

/// The words of the question that have names; a press on one takes it out.
fn chips_ui(ui: &mut Ui, view: &mut View<'_>) {
    let high = control(ui);
    // By touch as high as everything that is pressed.
    let height = if space(10.0) < high { high } else { space(7.5) };
    for filter in &view.session.records().filters {
        let (name, value) = named(view, filter);
        let said =
            view.words.say(&message!("records-page-remove-filter").text("filter", format!("{name} {value}").trim()));
        let value = RichText::new(value).font(theme::bold(sizes().body));
        let button = Button::new((name, value, Icon::X.text(Weight::Bold, space(3.0))));
        let button = button.fill(palette(ui.ctx()).tint.0).corner_radius(height / 2.0).min_size(vec2(0.0, height));
        if ui.add(button).accessible_name(said).on_hover_text(&filter.word).clicked() {
            view.send(RecordsCommand::RemoveFilter(filter.word.clone()));
        }
    }
}

/// The name of a filter and what it asks for, in the language of the window.
fn named(view: &View<'_>, filter: &Filter) -> (String, String) {
    let text = view.text(key_id(filter.key));
    let is_not_good = filter.word == NOT_GOOD && view.session.records().has(Shorthand::NotGood);
    if is_not_good {
        return (view.text("records-page-not-good"), String::new());
    }
    let status = |word: &str| {
        let status = Status::ALL.into_iter().find(|status| status.key().eq_ignore_ascii_case(word.trim()));
        status.map_or_else(|| word.to_owned(), |status| view.words.told(&status))
    };
    match filter.key {
        "verdict" => (text, filter.value.split(',').map(status).collect::<Vec<_>>().join(", ")),
        _ => (text, filter.value.clone()),
    }
}

/// The name of what the language of questions asks about.
fn key_id(key: &str) -> &'static str {
    match key {
        "part" => "head-part",
        "serial" => "records-page-serial",
        "feature" => "records-page-feature",
        "callout" => "callout",
        "class" => "tolerance-class",
        "who" => "records-page-who",
        "station" => "records-page-station",
        "from" => "records-page-from",
        "to" => "records-page-to",
        "today" => "records-page-today",
        "week" => "records-page-this-week",
        "measured" => "records-page-measured-only",
        "simulated" => "records-page-simulated-only",
        "standing" => "records-page-standing",
        "checks" => "records-page-checks-only",
        "reports" => "records-page-reports-only",
        "alarms" => "records-page-alarms-only",
        _ => "head-status",
    }
}

/// The form for another filter.
fn filter_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.horizontal_wrapped(|ui| {
        for action in Shorthand::ALL.map(RecordsAction::AskRecords) {
            view.toggle(ui, action);
        }
    });
    ui.horizontal_wrapped(|ui| {
        let name = quiet(ui, view.text("records-page-filter-by"));
        let keys = KEYS.map(|key| (key, view.text(key_id(key))));
        let (key, list) = one_of_ui(ui, "records-filter-by", space(44.0), &view.session.records().filter_key(), keys);
        list.labelled_by(name.id);
        if let Some(key) = key {
            view.send(RecordsCommand::FilterBy(key));
            // Verdicts are chosen by buttons.
            if key != "verdict" {
                view.send(Command::GoTo(RecordsField::Filter.into()));
            }
        }
        if view.session.records().filter_key() == "verdict" {
            return verdicts_ui(ui, view);
        }
        let name = quiet(ui, view.text("records-page-filter-value"));
        field_ui(ui, view, RecordsField::Filter, name.id, FieldStyle::text(space(44.0)));
        view.field_button(ui, RecordsAction::AddFilter);
    });
    let help = RichText::new(view.text("records-page-help")).size(sizes().small).color(palette(ui.ctx()).quiet.0);
    ui.add(Label::new(help).wrap());
}

/// Verdicts are chosen by their words.
fn verdicts_ui(ui: &mut Ui, view: &mut View<'_>) {
    for status in Status::ALL {
        let word = view.words.told(&status);
        if ui.add(Button::new(&word).min_size(vec2(0.0, control(ui)))).clicked() {
            view.send(Field::from(RecordsField::Filter).typed(word));
            view.send(RecordsCommand::AddFilter);
        }
    }
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
    for number in of_any_paper() {
        view.menu_item(ui, RecordsAction::ReportRecords(number));
    }
    for action in [
        RecordsAction::CopyRecords,
        RecordsAction::ChooseAllRecords,
        RecordsAction::ChooseNoRecords,
        RecordsAction::VerifyRecords,
        RecordsAction::CancelVerify,
    ] {
        view.menu_item(ui, action);
    }
}

/// What is exported of the page: reports of what is chosen, or else of what is listed.
pub(in crate::gui) fn export_ui(ui: &mut Ui, view: &mut View<'_>) {
    for number in of_any_paper() {
        view.menu_item(ui, RecordsAction::ReportRecords(number));
    }
    view.checkbox(ui, RecordsAction::WithSimulated);
    ui.separator();
    let page = view.session.records();
    let said = match page.chosen_count() {
        0 => message!("records-page-reports-listed").text("count", grouped(long(page.listing.count()))),
        chosen => message!("records-page-reports-chosen").text("count", grouped(long(chosen))),
    };
    quiet(ui, view.words.say(&said));
    for action in [RecordsAction::ChooseAllRecords, RecordsAction::ChooseNoRecords, RecordsAction::CopyRecords] {
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

/// The chosen records, and what a report of them leaves out: below the list, where it moves no row.
pub(super) fn chosen_ui(ui: &mut Ui, view: &mut View<'_>) {
    let page = view.session.records();
    let count = page.chosen_count();
    let simulated = page.chosen_simulated();
    if count == 0 {
        return;
    }
    let LeftOut { simulated: without, replaced, cycles, reports, unread } = page.left_out();
    ui.horizontal_wrapped(|ui| {
        quiet(ui, view.words.say(&message!("records-page-chosen").count("count", count)));
        let can_report = view.session.can(RecordsAction::ReportRecords(0));
        ui.add_enabled_ui(can_report, |ui| {
            ui.menu_button(view.text("records-page-report"), |ui| {
                for number in of_any_paper() {
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
            ("records-page-out-reports", reports),
            ("records-page-out-unread", unread),
        ] {
            if 0 < count {
                quiet(ui, view.words.say(&Message::new(id).count("count", count)));
            }
        }
    });
}
