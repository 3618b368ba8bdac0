//! The part's picture with a balloon a feature: its number, the colour and shape of its verdict, and a ring around the next one.
//!
//! Both views show it: on the plan balloons are moved, on the walk they lead to their feature.

use std::sync::{Arc, Weak};

use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align2, EventFilter, Id, Key, Painter, Pos2, Rect, Response, ScrollArea, Sense, Stroke, TextureHandle,
    TextureOptions, Ui, Vec2, WidgetInfo, pos2, vec2,
};

use crate::gui::shapes::{self, Edge, screen};
use crate::gui::spoken;
use crate::gui::theme::{self, control, palette, sizes, space};
use crate::gui::verdict_card::{colours, status_id};
use crate::gui::view::{View, problem, quiet};
use crate::message::message;
use crate::session::parts::{Balloon, PartPicture, PictureState, PlanCommand, WalkCommand};
use crate::session::{PartsCommand, Step};

/// The most balloons that stand beside the picture at once: more would be no help.
const MOST_BESIDE: usize = 40;

/// The picture of the plan that is edited; its balloons are moved.
pub(super) fn plan_picture_ui(ui: &mut Ui, view: &mut View<'_>) {
    let balloons = view.session.parts().balloons();
    let sight = view.session.parts().sight();
    if let Some(row) = picture_ui(ui, view, (sight, &balloons), true) {
        let (_, column) = view.session.parts().sheet.at();
        view.send(PartsCommand::Plan(PlanCommand::Go(row, column, false)));
    }
}

/// The picture of the part that is measured; a balloon leads to its feature.
pub(in crate::gui) fn walk_picture_ui(ui: &mut Ui, view: &mut View<'_>) {
    let balloons = view.session.parts().walk_balloons();
    let sight = view.session.parts().walk_sight();
    let clicked = picture_ui(ui, view, (sight, &balloons), false);
    let first = clicked.and_then(|row| balloons.get(row)?.first);
    if let Some(first) = first {
        view.send(PartsCommand::Walk(WalkCommand::Go(first)));
    }
}

/// The picture with its balloons, in the room that is left. The row of a balloon that was clicked.
fn picture_ui(
    ui: &mut Ui,
    view: &mut View<'_>,
    (sight, balloons): (Option<PictureState>, &[Balloon]),
    can_move: bool,
) -> Option<usize> {
    let picture = match sight {
        Some(PictureState::Seen(picture)) => picture,
        Some(PictureState::Awaited) => {
            quiet(ui, view.text("parts-page-picture-awaited"));
            return None;
        }
        Some(PictureState::Refused(why)) => {
            problem(ui, view.words.say(&why));
            return None;
        }
        None => {
            quiet(ui, view.text("parts-page-picture-none"));
            return None;
        }
    };
    let beside: Vec<&Balloon> = balloons.iter().filter(|balloon| balloon.at.is_none()).collect();
    let room = ui.available_rect_before_wrap();
    let foot = if can_move && !beside.is_empty() { control(ui) + space(9.0) } else { 0.0 };
    let frame = Rect::from_min_max(room.min, pos2(room.right(), (room.bottom() - foot).max(room.top() + space(10.0))));
    let rect = within(frame, &picture);
    draw(ui, &picture, rect);
    let figure = ui.interact(frame, Id::unique(("part-picture", can_move)), Sense::HOVER);
    let on = balloons.len() - beside.len();
    let said = message!("parts-page-picture-said").count("on", on).count("count", balloons.len());
    spoken::picture(ui, &figure, view.text("parts-page-picture"), view.words.say(&said));
    ui.advance_cursor_after_rect(frame);
    let mut clicked = None;
    for balloon in balloons {
        if let Some(at) = balloon.at.map(|at| on_screen(rect, at))
            && balloon_ui(ui, view, (balloon, at), (rect, can_move))
        {
            clicked = Some(balloon.row);
        }
    }
    if can_move && !beside.is_empty() {
        beside_ui(ui, view, &beside, rect);
    }
    clicked
}

/// Those that are not on the picture yet.
fn beside_ui(ui: &mut Ui, view: &mut View<'_>, beside: &[&Balloon], rect: Rect) {
    quiet(ui, view.text("parts-page-beside"));
    ScrollArea::horizontal().id_salt("balloons-beside").show(ui, |ui| {
        ui.horizontal(|ui| {
            for balloon in beside.iter().take(MOST_BESIDE) {
                let (place, _) = ui.allocate_exact_size(Vec2::splat(control(ui)), Sense::hover());
                balloon_ui(ui, view, (balloon, place.center()), (rect, true));
            }
            if MOST_BESIDE < beside.len() {
                let more = message!("parts-page-beside-more").count("count", beside.len() - MOST_BESIDE);
                quiet(ui, view.words.say(&more));
            }
        });
    });
}

/// As large as there is room for, and not larger than twice its dots.
fn within(frame: Rect, picture: &PartPicture) -> Rect {
    let side = |side: usize| u16::try_from(side).map_or(1.0, |side| f32::from(side.max(1)));
    let size = vec2(side(picture.size[0]), side(picture.size[1]));
    let scale = (frame.width() / size.x).min(frame.height() / size.y).clamp(0.01, 2.0);
    Rect::from_center_size(frame.center(), size * scale)
}

fn on_screen(rect: Rect, [x, y]: [f64; 2]) -> Pos2 {
    rect.min + rect.size() * vec2(screen(x), screen(y))
}

/// Where something is on the picture: shares of its width and height.
fn on_picture(rect: Rect, at: Pos2) -> [f64; 2] {
    let share = (at - rect.min) / rect.size();
    [share.x, share.y].map(|share| f64::from(share.clamp(0.0, 1.0)))
}

/// Draws the picture; its dots go to the graphics card once.
fn draw(ui: &Ui, picture: &Arc<PartPicture>, rect: Rect) {
    let key = Id::unique("part-picture-dots");
    let kept: Option<(Weak<PartPicture>, TextureHandle)> = ui.data(|data| data.get_temp(key));
    // The memory of a picture is no other's while it is remembered here.
    let is_its = |of: &Weak<PartPicture>| std::ptr::eq(of.as_ptr(), Arc::as_ptr(picture));
    let texture = kept.filter(|(of, _)| is_its(of)).map(|(_, texture)| texture);
    let texture = texture.unwrap_or_else(|| {
        let image = theme::picture(picture.size, &picture.dots);
        let texture = ui.ctx().load_texture("part", image, TextureOptions::LINEAR);
        ui.data_mut(|data| data.insert_temp(key, (Arc::downgrade(picture), texture.clone())));
        texture
    });
    // What an SVG picture leaves open is paper, whatever the theme: its lines are black.
    let paper = theme::paper();
    ui.painter().rect_filled(rect, 0.0, paper);
    let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
    ui.painter().image(texture.id(), rect, whole, paper);
}

/// A balloon; whether it was clicked. Dragged, it follows the pointer; with the focus it is moved by arrows, put on the picture by
/// Enter, and taken off it by Delete.
fn balloon_ui(ui: &Ui, view: &mut View<'_>, (balloon, at): (&Balloon, Pos2), (rect, can_move): (Rect, bool)) -> bool {
    let sense = if can_move { Sense::click_and_drag() } else { Sense::click() };
    let place = Rect::from_center_size(at, Vec2::splat(control(ui)));
    let response = ui.interact(place, Id::unique(("balloon", can_move, balloon.row)), sense);
    let pointer = response.interact_pointer_pos();
    let shown = pointer.filter(|_| can_move && response.dragged()).unwrap_or(at);
    // Above everything while it is dragged from beside the picture.
    let painter = if response.dragged() { ui.ctx().debug_painter() } else { ui.painter().clone() };
    paint(&painter, ui, (balloon, shown), response.has_focus());
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, said(view, balloon)));
    if !can_move {
        return response.clicked();
    }
    if let Some(pointer) = pointer.filter(|_| response.dragged() || response.drag_stopped()) {
        // From beside the picture it is put where it is let go, on the picture.
        let is_on = balloon.at.is_some();
        let is_done = response.drag_stopped();
        let moves = is_on && (is_done || response.drag_delta() != Vec2::ZERO);
        if moves || is_done && rect.contains(pointer) {
            let at = on_picture(rect, pointer);
            view.send(PartsCommand::Plan(PlanCommand::PlaceBalloon { row: balloon.row, at, is_done }));
        }
    }
    // What is clicked or let go is moved by the keys next.
    if response.clicked() || response.drag_stopped() {
        response.request_focus();
    }
    keys(ui, view, balloon, &response);
    response.clicked()
}

fn keys(ui: &Ui, view: &mut View<'_>, balloon: &Balloon, response: &Response) {
    if !response.has_focus() {
        return;
    }
    let filter = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
    let row = balloon.row;
    let steps = [
        (Key::ArrowLeft, Step::Left),
        (Key::ArrowRight, Step::Right),
        (Key::ArrowUp, Step::Up),
        (Key::ArrowDown, Step::Down),
    ];
    let pressed = |key| ui.input(|input| input.key_pressed(key));
    for (_, step) in steps.into_iter().filter(|(key, _)| pressed(*key)) {
        view.send(PartsCommand::Plan(PlanCommand::NudgeBalloon(row, step)));
    }
    if balloon.at.is_none() && pressed(Key::Enter) {
        view.send(PartsCommand::Plan(PlanCommand::PlaceBalloon { row, at: [0.5, 0.5], is_done: true }));
    }
    if balloon.at.is_some() && pressed(Key::Delete) {
        view.send(PartsCommand::Plan(PlanCommand::RemoveBalloon(row)));
    }
}

/// `Balloon 3, A1, good, next`.
fn said(view: &View<'_>, balloon: &Balloon) -> String {
    let status = match (balloon.status, balloon.is_skipped) {
        (None, true) => view.text("parts-page-balloon-skipped"),
        (None, false) => view.text("parts-page-balloon-open"),
        (status, _) if balloon.is_simulated => {
            view.words.say(&message!("parts-page-balloon-simulated").text("status", view.text(status_id(status))))
        }
        (status, _) => view.text(status_id(status)),
    };
    let mut message = message!("parts-page-balloon");
    message = message.text("label", &balloon.label).text("name", &balloon.name).text("status", status);
    if balloon.is_next {
        message = message!("parts-page-balloon-next").message("balloon", message);
    }
    if balloon.at.is_none() {
        message = message!("parts-page-balloon-beside").message("balloon", message);
    }
    view.words.say(&message)
}

/// The number in the outline of its verdict, a dash at its shoulder where it was skipped, a dashed edge where it was simulated, and rings
/// around the next one.
fn paint(painter: &Painter, ui: &Ui, (balloon, at): (&Balloon, Pos2), is_focused: bool) {
    let palette = palette(ui.ctx());
    let radius = control(ui) * 0.36;
    let (fill, text) = match balloon.status {
        None => (palette.surface.0, palette.text.0),
        status => colours(palette, status, Edge::of_simulated(balloon.is_simulated)),
    };
    if balloon.is_next {
        painter.circle_filled(at, radius * 1.3 + space(1.75), palette.data.0);
        painter.circle_filled(at, radius * 1.3 + space(1.0), palette.surface.0);
    }
    shapes::outline(painter, at, radius, balloon.status, (fill, Stroke::new(1.5, palette.text.0)));
    if balloon.is_simulated {
        let square = Rect::from_center_size(at, Vec2::splat(2.0 * radius + space(2.0)));
        shapes::dashed_frame(painter, square, palette.text.0);
    }
    let size = if balloon.label.chars().count() < 3 { sizes().body } else { sizes().small };
    let label: String = balloon.label.chars().take(4).collect();
    painter.text(at, Align2::CENTER_CENTER, label, theme::bold(size), text);
    if balloon.status.is_none() && balloon.is_skipped {
        let mark = Rect::from_center_size(at + vec2(radius, -radius), Vec2::splat(space(4.0)));
        painter.circle(mark.center(), space(2.5), fill, Stroke::new(1.0, palette.text.0));
        shapes::status(painter, mark.shrink(space(0.5)), None, text);
    }
    if is_focused {
        // Outside the rings of the next one.
        painter.circle_stroke(at, radius * 1.3 + space(2.5), Stroke::new(2.0, palette.focus.0));
    }
}
