//! Left, from below: the button that Enter is for, the keypad, the field of the value; what is asked has the rest.

use eframe::egui::{Button, Frame, Margin, Panel, Response, RichText, Ui};

use crate::gui::card::page_card_ui;
use crate::gui::field::{FieldStyle, error_ui, named_field_ui};
use crate::gui::keypad::keys_of_height_ui;
use crate::gui::theme::{self, Icon, Weight, palette, sizes, space};
use crate::gui::view::View;
use crate::session::{Field, SettingsField};

/// The height of the button that Enter is for: 15 mm on a panel of ten inches, more where there is room.
const MAIN: [f32; 2] = [56.0, 88.0];

/// Two taps within this time are one, seconds.
const TWO_TAPS: f64 = 0.25;

/// The height of the field of the value.
const VALUE: f32 = 58.0;

/// What is asked needs this height at least.
const ASKED: f32 = 132.0;

/// The height of a row of keys, at least and at most, with its gap.
const KEY: [f32; 2] = [54.0, 96.0];

/// What stands on the button that Enter is for.
pub(super) struct Main {
    pub text: String,
    pub icon: Icon,
    pub is_possible: bool,
}

/// What is asked in its card, and below it where it is answered. Returns whether the main button was pressed.
pub(super) fn asked_ui(
    ui: &mut Ui,
    view: &mut View<'_>,
    (field, name): (Option<Field>, &'static str),
    main: &Main,
    asked: impl FnOnce(&mut Ui, &mut View<'_>),
) -> bool {
    let gap = f32::from(super::gap(ui));
    let main_height = (ui.available_height() * 0.115).clamp(MAIN[0], MAIN[1]);
    let is_pressed = from_below(ui, "operator-main", main_height, |ui| main_ui(ui, main));
    if view.session.has_keypad() {
        let left = ui.available_height() - ASKED - VALUE - gap * 3.0;
        let height = (left / 4.0).clamp(KEY[0], KEY[1]) * 4.0;
        keys_of_height_ui(ui, view, height.min(ui.available_height()), false);
    }
    if let Some(field) = field {
        let id = ("operator-value", name);
        from_below(ui, id, VALUE, |ui| {
            let width = ui.available_width();
            let is_hidden = field == SettingsField::Pin.into();
            let unit = if view.session.is_free_text(field) { "" } else { "mm" };
            let hint = RichText::new(view.text(name)).size(sizes().limits);
            let font = theme::bold(sizes().value * 1.2);
            let look = FieldStyle { height: VALUE, font, is_hidden, hint, ..FieldStyle::value(ui, width).unit(unit) };
            named_field_ui(ui, view, field, &view.text(name), look);
        });
    }
    page_card_ui(ui, |ui| {
        ui.spacing_mut().item_spacing.y = space(1.0);
        asked(ui, view);
        if let Some(field) = field {
            error_ui(ui, view, field);
        }
    });
    is_pressed
}

/// Something of a height at the lower edge of what is left.
fn from_below<T>(
    ui: &mut Ui,
    id: impl std::hash::Hash + std::fmt::Debug,
    height: f32,
    content: impl FnOnce(&mut Ui) -> T,
) -> T {
    let gap = super::gap(ui);
    let margin = Margin { top: gap, ..Margin::ZERO };
    let panel =
        Panel::bottom(eframe::egui::Id::unique(("operator-below", id))).resizable(false).show_separator_line(false);
    panel.exact_size(height + f32::from(gap)).frame(Frame::new().inner_margin(margin)).show(ui, content).inner
}

/// Where there is no field, the button has the focus, but never from an Enter that may still be of what came before.
fn take_focus_soon(ui: &Ui, button: &Response) {
    /// As long as somebody needs to see that something else is asked, seconds.
    const SOON: f64 = 0.5;
    let since = button.id.with("since");
    let now = ui.input(|input| input.time);
    if ui.memory(|memory| memory.focused().is_some()) {
        return ui.data_mut(|data| data.remove::<f64>(since));
    }
    let begun = ui.data_mut(|data| *data.get_temp_mut_or_insert_with(since, || now));
    if begun + SOON <= now {
        button.request_focus();
    } else {
        ui.ctx().request_repaint_after(std::time::Duration::from_secs_f64(begun + SOON - now));
    }
}

fn main_ui(ui: &mut Ui, main: &Main) -> bool {
    let palette = palette(ui.ctx());
    let size = ui.available_size();
    let text = RichText::new(&main.text).font(theme::bold(sizes().figure)).color(palette.on_accent.0);
    let icon = main.icon.text(Weight::Bold, sizes().figure).color(palette.on_accent.0);
    let button = Button::new((text, icon)).fill(palette.accent.0).min_size(size);
    let shown = ui.centered_and_justified(|ui| ui.add_enabled(main.is_possible, button));
    let response = shown.inner.accessible_name(&main.text);
    take_focus_soon(ui, &response);
    if response.has_focus() {
        let stroke = eframe::egui::Stroke::new(3.0, palette.focus.0);
        ui.painter().rect_stroke(response.rect, 8.0, stroke, eframe::egui::StrokeKind::Inside);
    }
    // The second tap of two is none: the word on the button has just changed.
    let id = eframe::egui::Id::unique("operator-main-word");
    let now = ui.input(|input| input.time);
    let (text, since): (String, f64) = ui.data(|data| data.get_temp(id)).unwrap_or((main.text.clone(), f64::MIN));
    let since = if text == main.text { since } else { now };
    ui.data_mut(|data| data.insert_temp(id, (main.text.clone(), since)));
    response.clicked() && since + TWO_TAPS < now
}
