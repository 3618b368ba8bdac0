//! The list of a folder in the file dialog. Tab passes over it: the arrow keys move in it while the path has the focus.

use eframe::egui::accesskit::Role;
use eframe::egui::{Button, Frame, Id, ScrollArea, Sense, Ui, WidgetInfo, vec2};

use super::spoken;
use super::theme::{control, palette, space};
use super::view::{View, problem, quiet, quiet_cut, remembered};
use crate::files::{Entry, MOST_ENTRIES};
use crate::message::{Message, message};
use crate::session::{Dialog, FilesAction, FilesCommand};
use crate::words::Words;

/// What is beside the list in the dialog: texts and margins in steps, and rows of buttons and fields.
const AROUND: (f32, f32) = (46.0, 5.0);
/// The fewest and the most rows.
const ROWS: (f32, f32) = (3.0, 12.0);

/// Whether the window has room for the dialog with a list of the fewest rows.
pub(super) fn has_room(ui: &Ui) -> bool {
    ROWS.0 * control(ui) <= room(ui)
}

/// How much room the window has for the rows.
fn room(ui: &Ui) -> f32 {
    ui.ctx().content_rect().height() - space(AROUND.0) - AROUND.1 * control(ui)
}

/// Where the list begins, what lies in the folder, and what of it is shown.
pub(super) fn folder_list_ui(ui: &mut Ui, view: &mut View<'_>, dialog: &Dialog) {
    let list = &dialog.list;
    ui.horizontal_wrapped(|ui| {
        view.button(ui, FilesAction::FolderUp);
        view.button(ui, FilesAction::HomeFolder);
        let folders = view.session.recent_folders();
        ui.add_enabled_ui(!folders.is_empty(), |ui| {
            ui.menu_button(view.text("dialog-recent-folders"), |ui| {
                for folder in folders {
                    if ui.button(folder.display().to_string()).clicked() {
                        view.send(FilesCommand::Show(folder.to_owned()));
                        ui.close();
                    }
                }
            });
        });
    });
    let folder = list.folder().map(|folder| message!("dialog-list").text("folder", folder.display()));
    let folder = folder.unwrap_or_else(|| message!("dialog-list-none"));
    quiet_cut(ui, view.words.say(&folder));
    rows_ui(ui, view, dialog);
    ui.horizontal_wrapped(|ui| {
        view.checkbox(ui, FilesAction::AllFiles);
        let more = list.has_more();
        let left_out = list.left_out();
        if more {
            quiet_cut(ui, view.words.say(&message!("dialog-list-more").count("most", MOST_ENTRIES)));
        } else if 0 < left_out {
            quiet_cut(ui, view.words.say(&message!("dialog-list-left-out").count("count", left_out)));
        }
    });
}

/// As many rows as the window has room for, however many there are: nothing moves.
fn rows_ui(ui: &mut Ui, view: &mut View<'_>, dialog: &Dialog) {
    let list = &dialog.list;
    let row = control(ui);
    let height = (room(ui) / row).floor().clamp(ROWS.0, ROWS.1) * row;
    Frame::new().fill(palette(ui.ctx()).surface.0).show(ui, |ui| {
        ui.set_min_size(vec2(ui.available_width(), height));
        ui.set_max_height(height);
        ui.spacing_mut().item_spacing.y = 0.0;
        if let Some(text) = list.problem.as_ref() {
            problem(ui, view.words.say(text));
        } else if list.is_empty() {
            let text = if list.is_reading() { "dialog-list-reading" } else { "dialog-list-empty" };
            if list.folder().is_some() {
                quiet(ui, view.text(text));
            }
        } else {
            let area = ScrollArea::vertical().id_salt("folder-list").max_height(height).auto_shrink([false, false]);
            let area = match follow(ui, list.selected, row, height) {
                Some(offset) => area.vertical_scroll_offset(offset),
                None => area,
            };
            let name = view.text("dialog-entries");
            let shown = area.show_rows(ui, row, list.len(), |ui, rows| {
                spoken::around_ui(ui, Role::ListBox, &name, |ui| {
                    for number in rows {
                        if let Some(entry) = list.entry(number) {
                            row_ui(ui, view, entry, number, list.selected == Some(number));
                        }
                    }
                });
            });
            ui.data_mut(|data| data.insert_temp(offset_id(), shown.state.clamped_offset().y));
        }
    });
}

fn offset_id() -> Id {
    Id::unique("folder-list-offset")
}

/// How far the list is scrolled so that an entry that was just selected is in sight; afterwards scrolling is free.
fn follow(ui: &Ui, selected: Option<usize>, row: f32, height: f32) -> Option<f32> {
    let id = Id::unique("folder-list-selected");
    let before = ui.data_mut(|data| std::mem::replace(data.get_temp_mut_or_default::<Option<usize>>(id), selected));
    let number = selected.filter(|_| before != selected)?;
    // The list holds some thousand entries: exact in any number.
    let top = f32::from(u16::try_from(number).unwrap_or(u16::MAX)) * row;
    Some(remembered::<f32>(ui, offset_id()).clamp((top + row - height).max(0.0), top))
}

/// One click shows a folder or takes a file's name; a second one, however late, does with the file what the dialog is for.
fn row_ui(ui: &mut Ui, view: &mut View<'_>, entry: &Entry, number: usize, is_selected: bool) {
    let told = told(view.words, entry);
    // Not focusable: arrows move in the list while the path has the focus.
    let row = Button::selectable(is_selected, &entry.name).right_text(&told).truncate().sense(Sense::CLICK);
    let response = ui.add(row.min_size(vec2(ui.available_width(), control(ui))));
    let said = format!("{}, {told}", entry.name);
    response.widget_info(|| WidgetInfo::labeled(Role::ListBoxOption, true, &said));
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_selected(is_selected));
    // The second click of two on a folder finds another list below it.
    let is_second = response.double_clicked();
    if response.clicked() && is_selected && !entry.is_folder {
        view.send(FilesCommand::Take(number));
    } else if response.clicked() && !is_second {
        view.send(FilesCommand::Select(number));
    }
}

/// What stands beside a name: how large a file is, and when it was changed.
fn told(words: &Words, entry: &Entry) -> String {
    let size = if entry.is_folder { words.get("dialog-is-folder") } else { words.say(&size(entry.bytes)) };
    let changed = entry.changed.map(|changed| changed.strftime("%Y-%m-%d %H:%M").to_string());
    changed.map(|changed| format!("{size}, {changed}")).unwrap_or(size)
}

/// A size in full units, rounded up: no file looks empty that is not.
fn size(bytes: u64) -> Message {
    let (name, unit) = match bytes {
        ..1_000 => ("file-bytes", 1),
        1_000..1_000_000 => ("file-kilobytes", 1_000),
        _ => ("file-megabytes", 1_000_000),
    };
    Message::new(name).text("count", bytes.div_ceil(unit))
}
