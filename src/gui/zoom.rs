//! The scale of the window: as it is set, or as the keys of egui change it (Ctrl with plus, minus and 0).

use eframe::egui::Context;

use crate::session::Zoom;

/// Scales the window, from the next frame on.
pub(super) fn set(ctx: &Context, zoom: Zoom) {
    ctx.set_zoom_factor(factor(zoom.percent()));
}

/// The scale that keys have made of the one that is set; `None` where they have changed nothing.
pub(super) fn by_keys(ctx: &Context, set: Zoom) -> Option<Zoom> {
    let now = ctx.zoom_factor();
    if (now - factor(set.percent())).abs() < factor(1) / 2.0 {
        return None;
    }
    // The nearest allowed one: keys go further than a window can be read.
    let off = |percent: u16| (now - factor(percent)).abs();
    let all = Zoom::LEAST.percent()..=Zoom::MOST.percent();
    all.min_by(|one, other| off(*one).total_cmp(&off(*other))).map(Zoom::from)
}

fn factor(percent: u16) -> f32 {
    f32::from(percent) / 100.0
}
