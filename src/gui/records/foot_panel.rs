//! Below: the chosen records, where records are kept, how many there are, what is wrong; and the walk along the chain.

use eframe::egui::accesskit::Role;
use eframe::egui::{ProgressBar, Ui, WidgetInfo};

use super::asking_panel::chosen_ui;
use crate::gui::check::grouped;
use crate::gui::field::{FieldStyle, error_ui, field_ui};
use crate::gui::room::is_tiny;
use crate::gui::shapes::share;
use crate::gui::theme::space;
use crate::gui::view::{View, problem, quiet, quiet_cut};
use crate::message::{Message, message};
use crate::session::records::{Verified, Walk};
use crate::session::{Keeping, RecordsAction, RecordsField, WindowAction};

/// The foot of the page.
pub(super) fn foot_ui(ui: &mut Ui, view: &mut View<'_>) {
    if !is_tiny(ui) {
        chosen_ui(ui, view);
    }
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.y = space(1.0);
        // Each stands in the place of the other.
        for action in [RecordsAction::VerifyRecords, RecordsAction::CancelVerify] {
            if view.session.can(action) && !is_tiny(ui) {
                view.button(ui, action);
            }
        }
        if view.session.can(RecordsAction::AskForServer) && !is_tiny(ui) {
            view.button(ui, RecordsAction::AskForServer);
        }
        walk_ui(ui, view);
        wrong_ui(ui, view);
    });
    if view.session.recording().asks_for_server() {
        server_ui(ui, view);
    }
    place_ui(ui, view);
}

/// Where records are kept, and how many there are.
fn place_ui(ui: &mut Ui, view: &View<'_>) {
    let recording = view.session.recording();
    // Until the journal is known its file has no name.
    let file = recording.file.as_deref().map_or_else(String::new, |file| file.display().to_string());
    let entries = recording.newest;
    let said = message!("records-page-place").text("file", &file).text("entries", grouped(entries));
    let mut said = view.words.say(&said);
    if let Some(server) = recording.server() {
        let sent = match recording.unsent() {
            None => message!("records-page-server-unknown"),
            Some(0) => message!("records-page-all-sent"),
            Some(unsent) => message!("records-page-unsent").text("count", grouped(unsent)),
        };
        said = format!("{said} · {}", view.words.say(&sent.text("server", server)));
    }
    quiet_cut(ui, &said).on_hover_text(&said);
}

/// The form for the server of the shop.
fn server_ui(ui: &mut Ui, view: &mut View<'_>) {
    let name = quiet(ui, view.text("records-page-server-address"));
    let look = FieldStyle::text(ui.available_width().min(space(140.0)));
    field_ui(ui, view, RecordsField::Server, name.id, look);
    error_ui(ui, view, RecordsField::Server);
    ui.horizontal_wrapped(|ui| {
        view.button(ui, RecordsAction::TakeServer);
        view.button(ui, RecordsAction::LeaveServer);
        quiet(ui, view.text("records-page-server-passwords"));
    });
}

/// What is wrong, when something is.
fn wrong_ui(ui: &mut Ui, view: &mut View<'_>) {
    let recording = view.session.recording();
    if let Keeping::Failed(why) = &recording.keeping {
        problem(ui, view.words.say(&message!("records-page-not-opened").message("why", why.clone())));
    }
    let failed = recording.failed();
    if 0 < failed {
        problem(ui, view.words.say(&message!("records-page-failed").count("count", failed)));
    }
    if view.session.can(WindowAction::RecordAgain) {
        view.button(ui, WindowAction::RecordAgain);
    }
    if let Some(why) = view.session.recording().trouble() {
        problem(ui, view.words.say(&message!("records-page-not-sent").message("why", why.clone())));
        view.button(ui, RecordsAction::SendAgain);
    }
}

/// How far the walk is, or what it has found.
fn walk_ui(ui: &mut Ui, view: &View<'_>) {
    let words = view.words;
    match &view.session.records().walk {
        Walk::None => {}
        Walk::Running { done, of } => {
            let bar = ProgressBar::new(share(*done, *of)).desired_width(space(25.0)).desired_height(space(3.0));
            let shown = ui.add(bar);
            let name = view.text("records-page-verify-progress");
            shown.widget_info(|| WidgetInfo::labeled(Role::ProgressIndicator, true, &name));
            let said = message!("records-page-verifying").text("done", grouped(*done)).text("of", grouped(*of));
            quiet(ui, words.say(&said));
        }
        Walk::Cancelled => _ = quiet(ui, view.text("records-page-verify-cancelled")),
        Walk::Done { result: Ok(Verified { entries, head, problems }), at } => {
            let time = at.strftime(crate::journal::query::TIME).to_string();
            let id = if problems.is_empty() { "records-page-whole" } else { "records-page-broken" };
            let said = Message::new(id)
                .text("time", time)
                .text("entries", grouped(*entries))
                .text("number", head.number)
                .text("hash", head.hash.short());
            let said = words.say(&said);
            if problems.is_empty() {
                quiet(ui, said)
            } else {
                problem(ui, said)
            };
            for found in problems {
                problem(ui, words.say(found));
            }
        }
        Walk::Done { result: Err(why), at } => {
            let time = at.strftime(crate::journal::query::TIME).to_string();
            let said = message!("records-page-not-verified").text("time", time).message("why", why.clone());
            problem(ui, words.say(&said));
        }
    }
}
