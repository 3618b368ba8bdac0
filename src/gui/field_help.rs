//! Help for the field that has the focus: a sign at its corner, and its paragraph of the manual beside it. Nothing moves when they come.
//! F1 opens what the manual says of the field, or of the part of the page that one is in.

use eframe::egui::accesskit::Role;
use eframe::egui::{
    Id, Memory, Popup, PopupCloseBehavior, Rect, Response, ScrollArea, Sense, Stroke, Ui, WidgetInfo, vec2,
};

use super::cycles::picture::{parameter_picture, parameter_range};
use super::help::blocks_ui;
use super::theme::{Icon, Weight, control, palette, space};
use super::view::{View, heading, quiet};
use super::{field_id, keypad, section};
use crate::message::message;
use crate::session::help::{HelpTopic, ManualPage};
use crate::session::{Field, HelpCommand, Session, WindowAction};
use crate::words::Language;

/// The diameter of the sign, and how wide and high the place is that a finger presses.
const SIGN: f32 = 4.0;
const TOUCH: f32 = 11.0;

/// The width of the paragraph, and its height at most.
const WIDTH: f32 = 92.0;
const HEIGHT: f32 = 110.0;

/// Tells the state which field has the focus, so that F1 opens its paragraph. What lies over the page does not count.
pub(super) fn follow_ui(ui: &Ui, view: &mut View<'_>) {
    // In its first frame the palette has no layer of its own yet.
    if view.session.palette.is_some() || ui.memory(|memory| memory.top_modal_layer().is_some()) {
        return;
    }
    let focused = ui.memory(Memory::focused);
    let field = keypad::aimed(ui).filter(|field| focused == Some(field_id::id(*field)));
    let at = field.map(|field| (field, view.session.treated_in(field)));
    if at != view.session.help().at {
        view.send(HelpCommand::At(at));
    }
    let within = section::entered(ui, view.session.page()).and_then(|name| Session::fold_treated_in(&name));
    if within != view.session.help().within {
        view.send(HelpCommand::Within(within));
    }
}

/// How far the place that is pressed for help reaches into its field.
pub(super) fn reach(ui: &Ui) -> f32 {
    if space(TOUCH) <= control(ui) { TOUCH / 2.0 } else { SIGN / 2.0 + 0.5 }
}

/// The sign at the corner of a field that has the focus, and the paragraph where it is shown.
pub(super) fn field_help_ui(ui: &Ui, view: &mut View<'_>, field: Field, response: &Response) {
    // The frame in which something else is pressed has to see whether that was the sign.
    if !response.has_focus() && !response.lost_focus() || !ui.is_rect_visible(response.rect) {
        return;
    }
    let explains = view.session.help().explains && view.session.help().at.as_ref().is_some_and(|(at, _)| *at == field);
    let corner = response.rect.right_top() - vec2(space(SIGN) / 2.0, 0.0);
    let sign = Rect::from_center_size(corner, vec2(space(SIGN), space(SIGN)));
    let place = if space(TOUCH) <= control(ui) {
        Rect::from_center_size(corner - vec2(0.0, space(TOUCH) / 3.0), vec2(space(TOUCH), space(TOUCH)))
    } else {
        sign.expand(space(0.5))
    };
    // Not for Tab: by keys, Shift+F1 does the same.
    let pressed = ui.interact(place, field_id::id(field).with("help"), Sense::CLICK);
    let palette = palette(ui.ctx());
    let colour = if explains || pressed.hovered() { palette.accent.0 } else { palette.focus.0 };
    ui.painter().circle(corner, space(SIGN) / 2.0, palette.surface.0, Stroke::NONE);
    Icon::Question.paint(ui.painter(), corner, Weight::Regular, space(SIGN), colour);
    let name = view.session.field_name(field, view.words);
    let said = view.words.say(&message!("help-page-about-field").text("name", name.trim()));
    pressed.widget_info(|| WidgetInfo::selected(Role::Button, true, explains, &said));
    let is_pressed = pressed.clicked();
    pressed.on_hover_text(said);
    if is_pressed {
        view.send(HelpCommand::Explain(!explains));
        response.request_focus();
        field_id::select_all(ui.ctx(), response.id, view.session.text(field));
    }
    if explains {
        paragraph_ui(ui, view, (field, name.trim()), response);
    }
}

/// The paragraph: drawing, what the field is for, its unit and its range.
fn paragraph_ui(ui: &Ui, view: &mut View<'_>, (field, name): (Field, &str), response: &Response) {
    let screen = ui.ctx().content_rect();
    let width = space(WIDTH).min(screen.width() - space(8.0));
    let popup = Popup::from_response(response).id(Id::unique("field-help")).open(true);
    let popup = popup.close_behavior(PopupCloseBehavior::IgnoreClicks).width(width);
    let shown = popup.show(|ui| {
        ui.set_width(width);
        ScrollArea::vertical().max_height(space(HEIGHT).min(screen.height() * 0.5)).show(ui, |ui| {
            heading(ui, name);
            if let Some((cycle, key)) = view.session.drawing_of(field) {
                parameter_picture(ui, view, cycle, key, false);
                if let (Field::Cycles(_), Some(parameter)) = (field, cycle.parameter(key)) {
                    ui.label(parameter_range(view, parameter));
                }
            }
            let place = view.session.help_of(field);
            if let HelpTopic::Manual(file) = place.topic
                && let Some(page) = ManualPage::of(file)
            {
                blocks_ui(ui, view, page.below(place.anchor.as_deref().unwrap_or_default()));
            }
            if view.session.language() != Language::En {
                quiet(ui, view.text("help-page-english"));
            }
        });
        if ui.button(view.text("help-page-in-manual")).clicked() {
            view.act(WindowAction::Help);
        }
    });
    // A press on the paragraph is no press elsewhere.
    let is_on_it = shown.is_some_and(|shown| {
        ui.input(|input| input.pointer.interact_pos()).is_some_and(|at| shown.response.rect.contains(at))
    });
    if is_on_it && response.lost_focus() {
        response.request_focus();
    }
}
