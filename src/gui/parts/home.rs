//! Where the focus goes when whatever had it is gone: Escape was pressed, or a dialog or a notice was closed.

use eframe::egui::{Id, Key, Popup, Ui};

use super::{plan_id, sizes_id};
use crate::gui::field;
use crate::gui::view::View;
use crate::session::WalkField;
use crate::session::parts::{PartsView, PlanField};

/// What lies over the page.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
struct Over {
    /// A dialog or a question, which takes the focus.
    has_dialog: bool,
    notices: usize,
}

/// Gives the focus back, before anything of the page is drawn: a field that had it keeps its cursor.
pub(super) fn home_ui(ui: &Ui, view: &View<'_>) {
    let session = view.session;
    let has_dialog = session.dialog().is_some()
        || session.open_columns().is_some()
        || session.is_leaving()
        || session.asks_about().is_some();
    let now = Over { has_dialog, notices: session.notices().len() };
    let key = Id::unique("parts-home");
    let before: Over = ui.data_mut(|data| std::mem::replace(data.get_temp_mut_or_default(key), now));
    let focused = ui.memory(eframe::egui::Memory::focused);
    let last_key = key.with("last");
    let last: Option<Id> = ui.data_mut(|data| {
        let last = data.get_temp_mut_or_default::<Option<Id>>(last_key);
        let before = *last;
        *last = focused.or(before);
        before
    });
    if has_dialog || Popup::is_any_open(ui.ctx()) || session.parts().sheet.is_editing {
        return;
    }
    // Below a dialog that was there in the frame before nothing can have the focus: it is given twice.
    let is_uncovered = before.has_dialog || focused.is_none() && now.notices < before.notices;
    let is_second =
        ui.data_mut(|data| std::mem::replace(data.get_temp_mut_or_default(key.with("again")), is_uncovered));
    if is_uncovered {
        ui.ctx().request_repaint();
    }
    let is_escaped = focused.is_none() && ui.input(|input| input.key_pressed(Key::Escape));
    if !is_uncovered && !is_second && !is_escaped {
        return;
    }
    let stops = stops(view);
    let target = last.filter(|last| stops.contains(last)).or_else(|| stops.first().copied());
    if let Some(target) = target {
        ui.memory_mut(|memory| memory.request_focus(target));
    }
}

/// What on the page can have the focus for long, the most important one first.
fn stops(view: &View<'_>) -> Vec<Id> {
    let parts = view.session.parts();
    let field = |field: WalkField| field::id(field);
    match parts.view {
        PartsView::Plan if parts.document.is_empty() => Vec::new(),
        PartsView::Plan => {
            let heads = crate::part::HeadField::ALL.map(|head| field::id(PlanField::Head(head)));
            std::iter::once(plan_id()).chain(heads).collect()
        }
        PartsView::Walk if parts.answered_alarm().is_some() => vec![field(WalkField::Cause), field(WalkField::Action)],
        PartsView::Walk if parts.walking.is_skipping => vec![field(WalkField::Reason)],
        PartsView::Walk if parts.walking.at.is_some() => vec![field(WalkField::Value), sizes_id()],
        PartsView::Walk if parts.walking.is_begun() => vec![sizes_id()],
        PartsView::Walk => parts.document.plan().map(|_| field(WalkField::Serial)).into_iter().collect(),
    }
}
