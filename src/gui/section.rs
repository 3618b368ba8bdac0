//! A part of a card that is folded away: its row says what is in force.

use eframe::egui::accesskit::Role;
use eframe::egui::collapsing_header::CollapsingState;
use eframe::egui::{
    Align2, CollapsingHeader, Color32, Context, Id, Memory, Popup, Rect, Sense, Stroke, StrokeKind, Ui, WidgetInfo,
    vec2,
};

use super::shapes::focus_ring;
use super::theme::{self, Icon, Weight, control, palette, sizes, space};
use super::view::View;
use crate::message::message;
use crate::session::Page;

/// The row of a part that is folded away.
pub(super) struct Section<'a> {
    pub icon: Icon,
    /// The text that names it.
    pub name: &'a str,
    /// What is in force; nothing where that says nothing.
    pub value: String,
    /// Whether something in it is wrong: that is never folded away.
    pub is_wrong: bool,
}

fn id(name: &str) -> Id {
    Id::unique(("section", name))
}

/// Opens the part of a name: something in it gets the focus. Whether it was closed.
pub(super) fn unfold(ctx: &Context, name: &str) -> bool {
    let mut state = CollapsingState::load_with_default_open(ctx, id(name), false);
    let was_closed = !state.is_open();
    state.set_open(true);
    state.store(ctx);
    was_closed
}

/// The part that one is in: something of it has the focus or was pressed last.
#[derive(Debug, Clone)]
struct Entered {
    name: String,
    page: Page,
    frame: u64,
}

fn entered_id() -> Id {
    Id::unique("section-entered")
}

/// Remembers a part that one is in.
fn enter(ui: &Ui, name: &str, rect: Rect, page: Page) {
    let pressed = ui.input(|input| input.pointer.interact_pos().filter(|_| input.pointer.any_pressed()));
    let is_pressed = pressed.is_some_and(|at| rect.contains(at)) && ui.rect_contains_pointer(rect);
    // Where it stood in the last frame: to ask for its response would take the focus from it when something else is pressed.
    let focused = ui.memory(Memory::focused);
    let focused = focused.and_then(|id| ui.ctx().viewport(|window| window.prev_pass.widgets.get(id).copied()));
    let has_focus = focused.is_some_and(|it| it.layer_id == ui.layer_id() && rect.contains(it.rect.center()));
    if is_pressed || has_focus {
        let entered = Entered { name: name.to_owned(), page, frame: ui.ctx().cumulative_frame_nr() };
        ui.data_mut(|data| data.insert_temp(entered_id(), entered));
    }
}

/// The name of the part that one is in on a page. A press or the focus elsewhere leaves it; a list that it has opened does not.
pub(super) fn entered(ui: &Ui, page: Page) -> Option<String> {
    let entered: Entered = ui.data(|data| data.get_temp(entered_id()))?;
    let is_now = ui.ctx().cumulative_frame_nr() <= entered.frame + 1;
    let is_elsewhere = ui.input(|input| input.pointer.any_pressed()) || ui.memory(|memory| memory.focused().is_some());
    if entered.page != page || !is_now && is_elsewhere && !Popup::is_any_open(ui.ctx()) {
        ui.data_mut(|data| data.remove::<Entered>(entered_id()));
        return None;
    }
    Some(entered.name)
}

/// The library's head of what folds, with the ring of the focus, which it has none of.
pub(super) fn folded_ui(ui: &mut Ui, head: CollapsingHeader, content: impl FnOnce(&mut Ui)) {
    let head = head.show_unindented(ui, content).header_response;
    if head.has_focus() {
        focus_ring(ui, head.rect.expand2(vec2(space(0.5), 0.0)));
    }
}

impl Section<'_> {
    /// The row, and below it the part where it is open.
    pub fn show(&self, ui: &mut Ui, view: &mut View<'_>, content: impl FnOnce(&mut Ui, &mut View<'_>)) {
        let mut state = CollapsingState::load_with_default_open(ui.ctx(), id(self.name), false);
        if self.is_wrong {
            state.set_open(true);
        }
        let name = view.text(self.name);
        let said = match self.value.as_str() {
            "" => name.clone(),
            value => view.words.say(&message!("section-said").text("name", &name).text("value", value)),
        };
        let top = ui.cursor().top();
        if self.row_ui(ui, (&name, &said), state.is_open()) {
            state.toggle(ui);
        }
        state.show_body_unindented(ui, |ui| {
            ui.add_space(space(1.0));
            content(ui, view);
            ui.add_space(space(2.0));
        });
        state.store(ui.ctx());
        let left = ui.max_rect().x_range();
        let rect = Rect::from_x_y_ranges(left, top..=ui.min_rect().bottom());
        enter(ui, self.name, rect, view.session.page());
    }

    /// The row alone, of a name and what a screen reader says. Returns whether it was pressed.
    pub(super) fn row_ui(&self, ui: &mut Ui, (name, said): (&str, &str), is_open: bool) -> bool {
        let palette = palette(ui.ctx());
        let text = |text: &str, size: f32, colour: Color32| {
            ui.painter().layout_no_wrap(text.to_owned(), theme::font(size), colour)
        };
        // A long name has more lines, so that it does not cover the caret.
        let room = ui.available_width() - space(6.5 + 4.0);
        let name = ui.painter().layout(name.to_owned(), theme::font(sizes().body), palette.text.0, room);
        let name_height = name.size().y;
        let mut value = text(&self.value, sizes().small, palette.quiet.0);
        let beside = space(6.5) + name.size().x + space(6.0) + value.size().x;
        // What is in force is said whole: below the name where there is no room beside it.
        let is_below = ui.available_width() < beside && !self.value.is_empty();
        if is_below {
            value = ui.painter().layout(self.value.clone(), theme::font(sizes().small), palette.quiet.0, room);
        }
        let more = if is_below { value.size().y } else { 0.0 };
        let size = vec2(ui.available_width(), control(ui).max(space(8.5)).max(name_height + space(2.0)) + more);
        let (rect, response) = ui.allocate_exact_size(size, Sense::click());
        let painter = ui.painter();
        let fill = if response.hovered() { palette.hover.0 } else { Color32::TRANSPARENT };
        painter.rect_filled(rect.expand2(vec2(space(1.0), 0.0)), 8.0, fill);
        if response.has_focus() {
            let ring = Stroke::new(2.0, palette.focus.0);
            painter.rect_stroke(rect.expand2(vec2(space(1.0), 0.0)), 8.0, ring, StrokeKind::Inside);
        }
        let left = rect.left_center();
        self.icon.paint(painter, left + vec2(space(2.5), 0.0), Weight::Regular, space(4.75), palette.text.0);
        let caret = if is_open { Icon::CaretDown } else { Icon::CaretRight };
        caret.paint(painter, rect.right_center() - vec2(space(1.5), 0.0), Weight::Bold, space(3.0), palette.text.0);
        let at = left + vec2(space(6.5), -more / 2.0);
        painter.galley(Align2::LEFT_CENTER.anchor_size(at, name.size()).min, name, palette.text.0);
        let (anchor, at) = if is_below {
            (Align2::LEFT_TOP, left + vec2(space(6.5), name_height / 2.0 - more / 2.0))
        } else {
            (Align2::RIGHT_CENTER, rect.right_center() - vec2(space(4.0), 0.0))
        };
        painter.galley(anchor.anchor_size(at, value.size()).min, value, palette.quiet.0);
        response.widget_info(|| WidgetInfo::selected(Role::Button, true, is_open, said));
        if response.clicked() {
            // Tab goes on from here.
            response.request_focus();
        }
        response.on_hover_text(said).clicked()
    }
}
