//! The status window, as the control's pop-up prints it.

use std::fmt::Debug;
use std::hash::Hash;

use eframe::egui::{Color32, FontId, Frame, Label, Margin, RichText, ScrollArea, Ui};

use super::spoken::icon_ui;
use super::theme::{self, Icon, Weight, palette, sizes, space};
use super::view::{View, problem, quiet};
use crate::message::Message;

/// How much smaller than usual a text is set at most so that its lines are whole.
const LEAST_SCALE: f32 = 0.75;

/// How many lines a mask usually prints.
const LINES: f32 = 5.0;

/// The height of the pop-up with that many lines, its title and its margins.
pub(super) fn usual_height(ui: &Ui) -> f32 {
    lines_height(ui) + space(14.0)
}

fn lines_height(ui: &Ui) -> f32 {
    let line = ui.fonts_mut(|fonts| fonts.row_height(&theme::mono(sizes().mono)));
    (line * LINES).ceil().max(space(24.0))
}

/// The pop-up with its text, with the reason why there is none, or with `empty` while there is nothing.
pub(super) fn popup_ui(
    ui: &mut Ui,
    view: &View<'_>,
    shown: Option<&Result<String, Message>>,
    empty: &str,
    title: &str,
) {
    let title = if shown.is_some() { title } else { "popup-title" };
    frame_ui(ui, view.text(title), |ui| {
        // As high as the window of a mask: what stands below it does not move when one comes.
        ui.set_min_height(lines_height(ui));
        match shown {
            Some(Ok(text)) => text_ui(ui, text, "popup"),
            Some(Err(error)) => _ = problem(ui, view.words.say(error)),
            None => _ = quiet(ui, view.text(empty)),
        }
    });
}

/// A window of the control with its title.
pub(super) fn frame_ui(ui: &mut Ui, title: String, content: impl FnOnce(&mut Ui)) {
    let palette = palette(ui.ctx());
    Frame::new().fill(palette.sunken.0).corner_radius(8.0).inner_margin(Margin::symmetric(12, 8)).show(ui, |ui| {
        ui.set_min_width(ui.available_width());
        ui.horizontal(|ui| {
            ui.spacing_mut().interact_size.y = 0.0;
            icon_ui(ui, Icon::AppWindow, Weight::Regular, space(4.5), palette.quiet.0);
            ui.label(RichText::new(title).font(theme::bold(sizes().small)));
        });
        content(ui);
    });
}

/// The text that such a window prints.
pub(super) fn text_ui(ui: &mut Ui, text: &str, salt: impl Hash + Debug) {
    let area = ScrollArea::both().id_salt(salt).max_height(space(60.0)).auto_shrink([false, true]);
    area.show(ui, |ui| {
        // A number whose last digit is out of sight reads as another one: the line is set smaller before it scrolls.
        let usual = theme::mono(sizes().mono);
        let size = ui.painter().layout_no_wrap(text.to_owned(), usual.clone(), Color32::PLACEHOLDER).size();
        let scale = (ui.available_width() / size.x.max(1.0)).clamp(LEAST_SCALE, 1.0);
        let font = FontId { size: (usual.size * scale * 2.0).floor() / 2.0, ..usual };
        let text = RichText::new(text.trim_end()).font(font).color(palette(ui.ctx()).text.0);
        ui.add(Label::new(text).extend().selectable(true));
    });
}
