//! Middle: the picture with its balloons over the limit band of the size that the page is about; the list of sizes, where nothing else
//! has it.

use eframe::egui::{Ui, vec2};

use super::{asked_text, has_picture, sizes_list};
use crate::gui::check::band_of_ui;
use crate::gui::columns::of_height;
use crate::gui::parts::picture;
use crate::gui::theme::space;
use crate::gui::view::{View, heading, quiet};

/// The picture is never lower.
const PICTURE: f32 = 240.0;

/// The height of the band with its heading.
const BAND: f32 = 200.0;

/// The least height of a list beside the band.
const LIST: f32 = 200.0;

/// The picture over the band: the sizes are listed below what is asked.
pub(super) fn picture_ui(ui: &mut Ui, view: &mut View<'_>) {
    let all = ui.available_height();
    let has_band = PICTURE + BAND + space(3.0) <= all;
    let height = if has_band { all - BAND - space(3.0) } else { all };
    of_height(ui, height, |ui| picture::walk_picture_ui(ui, view));
    if has_band {
        ui.add_space((ui.available_height() - BAND).max(0.0));
        band_ui(ui, view);
    }
}

/// The same where the sizes are listed here: below the picture, or below the band of a part without one.
pub(super) fn list_ui(ui: &mut Ui, view: &mut View<'_>) {
    let all = ui.available_height();
    if has_picture(view) {
        of_height(ui, (all * 0.5).max(PICTURE), |ui| picture::walk_picture_ui(ui, view));
    } else if view.session.parts().walking.is_begun() && BAND + LIST <= all {
        of_height(ui, BAND, |ui| band_ui(ui, view));
    }
    sizes_list::sizes_ui(ui, view);
}

/// Where the value lies within its limits; before it is there, the limits alone.
fn band_ui(ui: &mut Ui, view: &View<'_>) {
    let walking = &view.session.parts().walking;
    let Some(size) = walking.faced_size() else { return };
    ui.horizontal_wrapped(|ui| {
        heading(ui, view.text("limit-band"));
        quiet(ui, format!("{}, {}", size.name(), asked_text(view.words, &size)));
    });
    let record = walking.faced_value().map(|(_, value)| value.record.as_ref());
    let limits = record.map_or(size.limits, |record| &record.limits);
    ui.allocate_ui(vec2(ui.available_width(), ui.available_height()), |ui| band_of_ui(ui, view, limits, record));
}
