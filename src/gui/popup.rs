//! The status window, as the control's pop-up prints it.

use eframe::egui::{Frame, Label, Margin, RichText, ScrollArea, Stroke, Ui};

use super::theme::{self, palette, sizes, space};
use super::view::{View, problem, quiet};
use crate::message::Message;

/// The pop-up with its text, why there is none, or what stands there as long as there is nothing.
pub(super) fn popup_ui(ui: &mut Ui, view: &View<'_>, shown: Option<&Result<String, Message>>, empty: &str) {
    let palette = palette(ui.ctx());
    let frame = Frame::new().fill(palette.popup.0).stroke(Stroke::new(2.0, palette.popup_title.0)).corner_radius(2.0);
    frame.show(ui, |ui| {
        ui.set_min_width(ui.available_width());
        Frame::new().fill(palette.popup_title.0).inner_margin(Margin::symmetric(8, 3)).show(ui, |ui| {
            ui.set_min_width(ui.available_width());
            let title = RichText::new(view.text("popup-title")).size(sizes().small).color(palette.on_popup_title.0);
            ui.label(title);
        });
        Frame::new().inner_margin(Margin::same(8)).show(ui, |ui| {
            ui.set_min_height(space(24.0));
            match shown {
                Some(Ok(text)) => {
                    ScrollArea::both().max_height(space(60.0)).auto_shrink([false, true]).show(ui, |ui| {
                        let text = RichText::new(text.trim_end()).font(theme::mono(sizes().mono)).color(palette.text.0);
                        ui.add(Label::new(text).extend().selectable(true));
                    });
                }
                Some(Err(error)) => _ = problem(ui, view.words.say(error)),
                None => _ = quiet(ui, view.text(empty)),
            }
        });
    });
}
