//! One of a few choices, side by side in one frame.

use eframe::egui::accesskit::Role;
use eframe::egui::{Align2, Color32, Sense, Stroke, StrokeKind, Ui, WidgetInfo, vec2};

use super::theme::{self, control, palette, sizes};
use super::view::View;
use crate::session::Action;

/// Around the chosen one.
const EDGE: f32 = 2.0;

/// The choices in a width; the one that is on stands out.
pub(super) fn segments_ui(ui: &mut Ui, view: &mut View<'_>, choices: &[impl Into<Action> + Copy], width: f32) {
    let palette = palette(ui.ctx());
    let count = super::shapes::times(1.0, choices.len().max(1));
    let (frame, _) = ui.allocate_exact_size(vec2(width, control(ui)), Sense::hover());
    ui.painter().rect_filled(frame, 8.0, palette.hover.0);
    for (place, choice) in choices.iter().enumerate() {
        let action: Action = (*choice).into();
        let is_on = action.is_on(view.session) == Some(true);
        let name = action.text(view.session, view.words);
        let left = frame.left() + super::shapes::times(frame.width() / count, place);
        let rect = eframe::egui::Rect::from_min_size(
            eframe::egui::pos2(left, frame.top()),
            vec2(frame.width() / count, frame.height()),
        );
        let is_possible = ui.is_enabled() && view.session.can(action);
        let sense = if is_possible { Sense::click() } else { Sense::hover() };
        let response = ui.interact(rect, ui.scope_id().with(("segment", &name)), sense);
        let inner = rect.shrink(EDGE);
        if is_on {
            let edge = theme::line(ui.ctx());
            ui.painter().rect(inner, 6.0, palette.surface.0, edge, StrokeKind::Inside);
        } else if response.hovered() {
            ui.painter().rect_filled(inner, 6.0, palette.tint.0);
        }
        if response.has_focus() {
            ui.painter().rect_stroke(inner, 6.0, Stroke::new(2.0, palette.focus.0), StrokeKind::Inside);
        }
        let font = |size: f32| if is_on { theme::bold(size) } else { theme::font(size) };
        let wanted = ui.painter().layout_no_wrap(name.clone(), font(sizes().body), Color32::PLACEHOLDER).size().x;
        let size = sizes().body * ((inner.width() - 4.0) / wanted.max(1.0)).min(1.0);
        let colour = if is_possible { palette.text.0 } else { palette.quiet.0 };
        ui.painter().text(inner.center(), Align2::CENTER_CENTER, &name, font(size), colour);
        response.widget_info(|| WidgetInfo::selected(Role::RadioButton, is_possible, is_on, &name));
        if response.clicked() {
            view.act(action);
        }
    }
}
