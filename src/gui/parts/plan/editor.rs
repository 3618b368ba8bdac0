//! The cell that is typed into.

use eframe::egui::text::{CCursor, CCursorRange};
use eframe::egui::{Area, Button, Frame, Key, Order, Rect, TextEdit, Ui, WidgetInfo, accesskit::Role, vec2};

use super::{column_id, grid_id};
use crate::gui::over_page::just_opened;
use crate::gui::theme::{self, control, sizes};
use crate::gui::view::View;
use crate::gui::{field, keypad};
use crate::message::message;
use crate::session::parts::{PlanCommand, PlanField};
use crate::session::{PartsCommand, Step};

/// The text field in the place of a cell. Enter takes what is typed and goes down, Tab goes on, Escape leaves the cell as it was.
pub(super) fn editor_ui(ui: &mut Ui, view: &mut View<'_>, rect: Rect) {
    let field = PlanField::Cell;
    let id = field::id(field);
    let mut text = view.session.text(field).to_owned();
    if just_opened(ui, id.with("editor")) {
        field::select(ui.ctx(), id, CCursorRange::one(CCursor::new(text.chars().count())));
        ui.memory_mut(|memory| memory.request_focus(id));
    }
    let edit = TextEdit::singleline(&mut text).id(id).lock_focus(true).font(theme::font(sizes().body));
    let edit = edit.desired_width(rect.width()).min_size(rect.size()).align(eframe::egui::Align2::LEFT_CENTER);
    let response = ui.put(rect, edit);
    let (row, column) = view.session.parts().sheet.at();
    let name = message!("parts-page-editing").text("column", view.text(&column_id(column))).count("row", row + 1);
    let name = view.words.say(&name);
    response.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, &name));
    if response.changed() {
        view.send(crate::session::Field::from(field).typed(text));
    }
    keypad::see(ui, field.into());
    if response.has_focus() {
        keypad::aim(ui, field.into());
    }
    let chosen = choices_ui(ui, view, rect, response.has_focus());
    if let Choice::Taken(word) = chosen {
        view.send(crate::session::Field::from(field).typed(word.to_owned()));
        view.send(PartsCommand::Plan(PlanCommand::Take(Some(Step::Down))));
        ui.memory_mut(|memory| memory.request_focus(grid_id()));
        return;
    }
    let (pressed, shift) = ui.input(|input| {
        let pressed = [Key::Enter, Key::Escape, Key::Tab].into_iter().find(|key| input.key_pressed(*key));
        (pressed, input.modifiers.shift)
    });
    let command = match pressed {
        Some(Key::Tab) if response.has_focus() => PlanCommand::Tab(!shift),
        Some(Key::Enter) if response.lost_focus() => PlanCommand::Take(Some(if shift { Step::Up } else { Step::Down })),
        Some(Key::Escape) if response.lost_focus() => PlanCommand::Leave,
        // The pointer is on the words below: they are part of the cell.
        None if response.lost_focus() && matches!(chosen, Choice::Pressed) => return response.request_focus(),
        _ if response.lost_focus() => return view.send(PartsCommand::Plan(PlanCommand::Take(None))),
        _ => return,
    };
    view.send(PartsCommand::Plan(command));
    ui.memory_mut(|memory| memory.request_focus(grid_id()));
}

/// What was done with the words that the cell may have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Choice {
    None,
    /// The pointer is pressed on them.
    Pressed,
    Taken(&'static str),
}

/// The words that the cell may have, below it: a click takes one, so do the arrows and Enter. Anything may be typed nevertheless.
fn choices_ui(ui: &Ui, view: &View<'_>, rect: Rect, has_focus: bool) -> Choice {
    let words = view.session.parts().choices();
    let key = field::id(PlanField::Cell).with("choice");
    if words.is_empty() {
        ui.data_mut(|data| data.insert_temp(key, None::<usize>));
        return Choice::None;
    }
    let mut at: Option<usize> = ui.data(|data| data.get_temp(key)).flatten();
    let cell = view.session.parts().sheet.at();
    let of = ui.data_mut(|data| data.get_temp_mut_or_insert_with(key.with("of"), || None).replace((cell, words.len())));
    if of != Some((cell, words.len())) {
        at = None;
    }
    if has_focus {
        let [down, up] = [Key::ArrowDown, Key::ArrowUp].map(|key| ui.input(|input| input.key_pressed(key)));
        at = match (down, up) {
            (true, _) => Some(at.map_or(0, |at| (at + 1).min(words.len() - 1))),
            (_, true) => at.and_then(|at| at.checked_sub(1)),
            _ => at,
        };
    }
    ui.data_mut(|data| data.insert_temp(key, at));
    let mut clicked = None;
    let area = Area::new(key.with("words")).order(Order::Foreground).fixed_pos(rect.left_bottom());
    let shown = area.show(ui.ctx(), |ui| {
        Frame::popup(ui.style()).show(ui, |ui| {
            ui.set_min_width(rect.width());
            for (place, word) in words.iter().enumerate() {
                let button = Button::selectable(at == Some(place), *word).min_size(vec2(rect.width(), control(ui)));
                if ui.add(button).clicked() {
                    clicked = Some(*word);
                }
            }
        });
    });
    let entered = ui.input(|input| input.key_pressed(Key::Enter)).then_some(at).flatten();
    let taken = clicked.or_else(|| words.get(entered?).copied());
    let is_on = ui.input(|input| input.pointer.interact_pos().is_some_and(|at| shown.response.rect.contains(at)));
    match taken {
        Some(word) => Choice::Taken(word),
        None if is_on => Choice::Pressed,
        None => Choice::None,
    }
}
