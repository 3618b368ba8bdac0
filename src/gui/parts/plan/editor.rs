//! The cell that is typed into.

use eframe::egui::text::{CCursor, CCursorRange};
use eframe::egui::text_edit::TextEditState;
use eframe::egui::{Key, Rect, TextEdit, Ui, WidgetInfo, accesskit::Role};

use super::{column_id, grid};
use crate::gui::dialogs::just_opened;
use crate::gui::theme::{self, sizes};
use crate::gui::view::View;
use crate::gui::{field, keypad};
use crate::message::Message;
use crate::session::parts::{PlanCommand, PlanField};
use crate::session::{PartsCommand, Step};

/// The text field in the place of a cell. Enter takes what is typed and goes down, Tab goes on, Escape leaves the cell as it was.
pub(super) fn editor_ui(ui: &mut Ui, view: &mut View<'_>, rect: Rect) {
    let field = PlanField::Cell;
    let id = field::id(field);
    let mut text = view.session.text(field).to_owned();
    if just_opened(ui, id.with("editor")) {
        let mut state = TextEditState::load(ui.ctx(), id).unwrap_or_default();
        state.cursor.set_char_range(Some(CCursorRange::one(CCursor::new(text.chars().count()))));
        state.store(ui.ctx(), id);
        ui.memory_mut(|memory| memory.request_focus(id));
    }
    let edit = TextEdit::singleline(&mut text).id(id).lock_focus(true).font(theme::font(sizes().body));
    let edit = edit.desired_width(rect.width()).min_size(rect.size()).align(eframe::egui::Align2::LEFT_CENTER);
    let response = ui.put(rect, edit);
    let (row, column) = view.session.parts().sheet().at();
    let name = Message::new("parts-page-editing").text("column", view.text(&column_id(column))).count("row", row + 1);
    let name = view.words.say(&name);
    response.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, &name));
    if response.changed() {
        view.send(crate::session::Field::from(field).typed(text));
    }
    keypad::see(ui, field.into());
    if response.has_focus() {
        keypad::aim(ui, field.into());
    }
    let (pressed, shift) = ui.input(|input| {
        let pressed = [Key::Enter, Key::Escape, Key::Tab].into_iter().find(|key| input.key_pressed(*key));
        (pressed, input.modifiers.shift)
    });
    let command = match pressed {
        Some(Key::Tab) if response.has_focus() => PlanCommand::Tab(!shift),
        Some(Key::Enter) if response.lost_focus() => PlanCommand::Take(Some(if shift { Step::Up } else { Step::Down })),
        Some(Key::Escape) if response.lost_focus() => PlanCommand::Leave,
        _ if response.lost_focus() => return view.send(PartsCommand::Plan(PlanCommand::Take(None))),
        _ => return,
    };
    view.send(PartsCommand::Plan(command));
    ui.memory_mut(|memory| memory.request_focus(grid::id()));
}
