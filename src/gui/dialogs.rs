//! The file dialog with its typed path and its question, and questions about what would be lost.

use std::path::Path;

use eframe::egui::{Button, Id, Key, Modal, ScrollArea, TextEdit, Ui, vec2};

use super::columns_panel::columns_ui;
use super::field::select_all;
use super::folder_list::{folder_list_ui, has_room};
use super::notices::notices_ui;
use super::over_page::{corner_window, just_opened};
use super::spoken::dialog_headed;
use super::theme::{control, space};
use super::view::{View, heading, problem, quiet};
use super::working::working_ui;
use crate::message::message;
use crate::session::{Command, Dialog, FilesAction};

/// Draws the open dialog, or what stands under it, in a corner above what is `below` the page.
pub(super) fn dialogs_ui(ui: &Ui, view: &mut View<'_>, below: f32) {
    let session = view.session;
    if view.session.is_leaving() {
        leaving_ui(ui, view);
    } else if let Some(name) = session.asks_about() {
        discarding_ui(ui, view, &name);
    } else if let Some(dialog) = session.dialog().filter(|dialog| !(session.is_for_operators() && dialog.is_waiting()))
    {
        Modal::new(Id::unique("file-dialog")).show(ui, |ui| dialog_ui(ui, view, dialog));
    } else if let Some(open) = session.open_columns() {
        Modal::new(Id::unique("columns-panel")).show(ui, |ui| columns_ui(ui, view, open));
    } else if let Some(working) = session.working() {
        let title = view.text("working");
        corner_window("working", title, below).show(ui, |ui| {
            ui.set_max_width(space(150.0));
            working_ui(ui, view, working);
        });
    } else {
        notices_ui(ui, view, below);
    }
}

/// A question over the page that loses something by one of its answers.
struct LossQuestion {
    id: &'static str,
    head: &'static str,
    /// The answer that loses nothing: Enter gives it. Then the other one.
    answers: [&'static str; 2],
    answer: fn(bool) -> Command,
}

impl LossQuestion {
    fn show(&self, ui: &Ui, view: &mut View<'_>, said: impl FnOnce(&mut Ui, &View<'_>)) {
        Modal::new(Id::unique(self.id)).show(ui, |ui| {
            ui.set_width(space(110.0));
            let head = heading(ui, view.text(self.head));
            dialog_headed(ui, Id::unique(self.id), &head);
            said(ui, view);
            ui.horizontal(|ui| {
                ui.spacing_mut().interact_size.y = control(ui);
                for (text, loses) in self.answers.into_iter().zip([false, true]) {
                    let button = ui.button(view.text(text));
                    if !loses && just_opened(ui, Id::unique(self.id)) {
                        button.request_focus();
                    }
                    if button.clicked() {
                        view.send((self.answer)(loses));
                    }
                }
            });
        });
    }
}

/// Nothing is lost without a question to the user.
fn leaving_ui(ui: &Ui, view: &mut View<'_>) {
    let answers = ["leave-stay", "leave-anyway"];
    let asked = LossQuestion { id: "leaving", head: "leave", answers, answer: Command::Leave };
    asked.show(ui, view, |ui, view| {
        let names = view.session.unsaved().join(", ");
        if !names.is_empty() {
            ui.label(view.words.say(&message!("leave-unsaved").text("names", names)));
        }
        let unwritten = view.session.recording().unwritten();
        if 0 < unwritten {
            problem(ui, view.words.say(&message!("records-page-leave").count("count", unwritten)));
        }
    });
}

/// Another document takes the place of one with changes.
fn discarding_ui(ui: &Ui, view: &mut View<'_>, name: &str) {
    let answers = ["discard-no", "discard-yes"];
    let asked = LossQuestion { id: "discarding", head: "discard", answers, answer: Command::Discard };
    asked.show(ui, view, |ui, view| {
        ui.label(view.words.say(&message!("discard-unsaved").text("name", name)));
    });
}

fn dialog_ui(ui: &mut Ui, view: &mut View<'_>, dialog: &Dialog) {
    let screen = ui.ctx().content_rect().size();
    ui.set_width(space(160.0).min(screen.x - space(10.0)));
    let mut content_ui = |ui: &mut Ui| {
        let head = heading(ui, view.text(dialog.purpose.title()));
        dialog_headed(ui, Id::unique("file-dialog"), &head);
        ui.add_enabled_ui(dialog.exists.is_none(), |ui| {
            path_ui(ui, view, dialog);
            folder_list_ui(ui, view, dialog);
        });
    };
    if has_room(ui) {
        content_ui(ui);
    } else {
        // The list scrolls away, and the buttons stay.
        let height = screen.y - control(ui) - space(20.0);
        ScrollArea::vertical().id_salt("file-dialog").max_height(height).show(ui, content_ui);
    }
    ui.horizontal_wrapped(|ui| {
        ui.set_min_height(control(ui));
        match &dialog.exists {
            Some(path) => replace_ui(ui, view, path),
            None => buttons_ui(ui, view, dialog),
        }
    });
}

/// The typed path, and what is wrong with it.
fn path_ui(ui: &mut Ui, view: &mut View<'_>, dialog: &Dialog) {
    let name = quiet(ui, view.text(if dialog.purpose.is_folder() { "folder-path" } else { "file-path" }));
    let mut path = dialog.path.clone();
    let id = Id::unique("dialog-path");
    let field = ui
        .add(TextEdit::singleline(&mut path).id(id).desired_width(f32::INFINITY).min_size(vec2(0.0, control(ui))))
        .labelled_by(name.id);
    // The dialog asks for the path: the field has the focus at first and after a question, and typing replaces a
    // proposed name.
    let asked = ui.data_mut(|data| {
        std::mem::replace(data.get_temp_mut_or_default::<bool>(id.with("asked")), dialog.exists.is_some())
    });
    if just_opened(ui, id) || (asked && dialog.exists.is_none()) {
        field.request_focus();
        select_all(ui.ctx(), id, &path);
    }
    // There is nothing to delete: the key goes back.
    if field.has_focus() && dialog.path.is_empty() && ui.input(|input| input.key_pressed(Key::Backspace)) {
        view.act(FilesAction::FolderUp);
    } else if field.changed() {
        view.send(Command::TypePath(path.clone()));
    }
    if field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter)) && !dialog.is_waiting() {
        view.send(Command::Confirm);
        field.request_focus();
    }
    // After a click on a file Enter takes it, as after typing its name.
    if dialog.exists.is_none() && ui.memory(|memory| memory.focused().is_none()) {
        field.request_focus();
    }
    // The line is there in any case, so that the list stays in its place.
    ui.vertical(|ui| {
        ui.set_min_height(space(5.0));
        if let Some(text) = &dialog.problem {
            problem(ui, view.words.say(text));
        } else if let Some(working) = view.session.working().filter(|_| dialog.busy) {
            working_ui(ui, view, working);
        } else if dialog.busy {
            quiet(ui, view.text("dialog-busy"));
        } else if dialog.nothing_picked {
            quiet(ui, view.text("dialog-nothing-picked"));
        }
    });
}

fn buttons_ui(ui: &mut Ui, view: &mut View<'_>, dialog: &Dialog) {
    let confirm = if dialog.purpose.is_reading() { "dialog-open" } else { "dialog-save" };
    let button = |id: &str| Button::new(view.words.get(id)).min_size(vec2(space(24.0), control(ui)));
    let confirm = button(confirm);
    let cancel = button("dialog-cancel");
    if ui.add_enabled(!dialog.busy, confirm).clicked() {
        view.send(Command::Confirm);
    }
    view.wide_button(ui, FilesAction::Browse);
    if ui.add(cancel).clicked() {
        view.send(Command::Close);
    }
}

/// Asks whether a file may be replaced. Enter keeps it.
fn replace_ui(ui: &mut Ui, view: &mut View<'_>, path: &Path) {
    let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
    let is_set = view.session.dialog().is_some_and(|dialog| dialog.purpose.is_folder());
    let question = if is_set { message!("dialog-exists-set") } else { message!("dialog-exists") };
    let question = view.words.say(&question.text("name", name));
    problem(ui, question);
    let keep = view.wide_button(ui, FilesAction::KeepFile);
    if just_opened(ui, Id::unique("replace")) {
        keep.request_focus();
    }
    view.wide_button(ui, FilesAction::ReplaceFile);
}
