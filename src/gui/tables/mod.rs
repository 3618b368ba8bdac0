//! The table page: tables of deviations against ISO 286.
//!
//! | file | what |
//! |---|---|
//! | `tool_bar` | above: which table, filter, save as, and whether it agrees with ISO 286 |
//! | `grid` | middle: the cells in sight, and the keys that walk through them |
//! | `paint` | how a cell and a head look |
//! | `cell_panel` | right: the selected cell against ISO 286, and its fields |
//! | `classes_panel` | right, below: classes from ISO 286 as columns or as a new table |

mod cell_panel;
mod classes_panel;
mod grid;
mod paint;
mod tool_bar;

use eframe::egui::{CentralPanel, Frame, Key, KeyboardShortcut, Modifiers, Panel, ScrollArea, Ui};

use super::theme::{palette, space};
use super::view::View;
use crate::session::{Command, Field, Purpose, TablesCommand};

const UNDO: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND, Key::Z);
const REDO: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND, Key::Y);
const REDO_TOO: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND.plus(Modifiers::SHIFT), Key::Z);
const OPEN: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND, Key::O);
const SAVE: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND, Key::S);
const FIND: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND, Key::F);
const NEXT: KeyboardShortcut = KeyboardShortcut::new(Modifiers::NONE, Key::F8);
const PREVIOUS: KeyboardShortcut = KeyboardShortcut::new(Modifiers::SHIFT, Key::F8);

/// The page: above which table, middle its cells, right the selected cell.
pub(super) fn tables_ui(ui: &mut Ui, view: &mut View<'_>) {
    shortcuts(ui, view);
    let size = ui.available_size();
    Panel::top("table-tools").show(ui, |ui| tool_bar::tool_bar_ui(ui, view));
    let side = if size.x < 1200.0 { space(72.0) } else { space(80.0) };
    Panel::right("table-cell").exact_size(side).show(ui, |ui| {
        ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            // The scroll bar floats: it must not lie on the fields.
            ui.set_max_width(ui.available_width() - space(2.5));
            cell_panel::cell_panel_ui(ui, view);
            ui.separator();
            classes_panel::classes_panel_ui(ui, view);
        });
    });
    Panel::bottom("table-strip").exact_size(space(8.0)).show(ui, |ui| tool_bar::strip_ui(ui, view));
    let frame = Frame::new().fill(palette(ui.ctx()).panel.0);
    CentralPanel::default().frame(frame).show(ui, |ui| grid::grid_ui(ui, view));
}

/// The keys of the page. In a text field Ctrl+Z is the field's own.
fn shortcuts(ui: &Ui, view: &mut View<'_>) {
    if view.session.dialog().is_some() {
        return;
    }
    let pressed = |shortcut: &KeyboardShortcut| ui.input_mut(|input| input.consume_shortcut(shortcut));
    // The longer shortcut first: the shorter one would take it.
    for (shortcut, command) in [
        (PREVIOUS, Command::Tables(TablesCommand::PreviousDifference)),
        (NEXT, Command::Tables(TablesCommand::NextDifference)),
        (OPEN, Command::OpenDialog(Purpose::OpenTable)),
        (SAVE, Command::OpenDialog(Purpose::SaveTable(0))),
    ] {
        if pressed(&shortcut) {
            view.send(command);
        }
    }
    if pressed(&FIND) {
        ui.memory_mut(|memory| memory.request_focus(super::field::id(Field::TableFilter)));
    }
    if ui.ctx().text_edit_focused() {
        return;
    }
    for (shortcut, command) in
        [(REDO_TOO, TablesCommand::Redo), (UNDO, TablesCommand::Undo), (REDO, TablesCommand::Redo)]
    {
        if pressed(&shortcut) {
            view.send(Command::Tables(command));
        }
    }
}
