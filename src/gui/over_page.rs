//! What lies over a page: its title, its window, and when it is new.

use eframe::egui::{Align2, Id, Memory, Ui, Vec2, Window, vec2};

use super::theme::space;
use super::view::remembered;

/// A window that cannot be moved, at a distance from its anchor.
pub(super) fn fixed_window(id: &str, title: String, anchor: Align2, from: Vec2) -> Window<'static> {
    let window = Window::new(title).id(Id::unique(id)).anchor(anchor, from);
    window.collapsible(false).resizable(false)
}

/// Such a window in the corner of the page, above what is `below` it.
pub(super) fn corner_window(id: &str, title: String, below: f32) -> Window<'static> {
    fixed_window(id, title, Align2::RIGHT_BOTTOM, vec2(-space(5.0), -space(5.0) - below))
}

/// Whether something is drawn that was not drawn in the frame before.
pub(super) fn just_opened(ui: &Ui, id: Id) -> bool {
    let frame = ui.ctx().cumulative_frame_nr();
    let last = ui.data_mut(|data| std::mem::replace(data.get_temp_mut_or_default::<u64>(id), frame));
    last + 1 < frame
}

/// After a dialog the keys go where they went before it, unless what was done has given them to something else. Called before anything
/// is drawn.
pub(super) fn come_home(ui: &Ui) {
    let id = Id::unique("home");
    let (was_covered, home): (bool, Option<Id>) = remembered(ui, id);
    let (is_covered, focused) = ui.memory(|memory| (memory.top_modal_layer().is_some(), Memory::focused(memory)));
    if is_covered {
        ui.data_mut(|data| data.insert_temp(id, (true, home)));
        return;
    }
    // What is not drawn any more takes no keys.
    let back = home.filter(|home| was_covered && focused.is_none() && ui.ctx().read_response(*home).is_some());
    if let Some(back) = back {
        ui.memory_mut(|memory| memory.request_focus(back));
    }
    ui.data_mut(|data| data.insert_temp(id, (false, back.or(focused))));
}
