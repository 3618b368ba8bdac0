//! The chart of the chosen feature.

use eframe::egui::accesskit::Role;
use eframe::egui::{Pos2, Rangef, Rect, Response, Sense, Stroke, Ui, WidgetInfo};

use super::paint::{drawn_ui, place};
use crate::gui::field::{FieldStyle, error_ui, field_ui, named_field_ui};
use crate::gui::key_names::part_id;
use crate::gui::segments::segments_ui;
use crate::gui::shapes::{focus_ring, screen};
use crate::gui::theme::{Icon, palette, space};
use crate::gui::view::{View, focus_soon, heading, one_of_ui, quiet, take_focus};
use crate::series::Drawn;
use crate::session::focused::CHART;
use crate::session::statistics::{MeanOf, PointsOf, Zooming};
use crate::session::{StatisticsAction, StatisticsCommand, StatisticsField};
use crate::statistics::picture::{Picture, Spot};

/// A point within this distance is meant, and a pointer that is drawn this far chooses points.
const NEAR: f32 = 24.0;
const BRUSH: f32 = 10.0;

/// Name, what makes a point, the chart, and what is done with a point.
pub(super) fn chart_ui(ui: &mut Ui, view: &mut View<'_>) {
    head_ui(ui, view);
    let rect = ui.available_rect_before_wrap();
    let response = ui.interact(rect, part_id(CHART), Sense::click_and_drag());
    let said = view.session.statistics().chart_text(view.words);
    let name = view.session.statistics().open().map_or_else(String::new, |(feature, _)| feature.key.title(true));
    response.widget_info(|| WidgetInfo::labeled(Role::Image, true, &name));
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_description(said));
    if let Some(picture) = drawn_ui(ui, view, Drawn::Run, rect) {
        cursor_ui(ui, view, rect, &picture);
        pointed_ui(ui, view, &response, &picture);
    }
    if response.has_focus() {
        focus_ring(ui, rect);
    }
    ui.allocate_rect(rect, Sense::hover());
}

/// The point at which the keys are.
fn cursor_ui(ui: &Ui, view: &View<'_>, rect: Rect, picture: &Picture) {
    let Some(cursor) = view.session.statistics().cursor else { return };
    let Some(spot) = picture.spots.iter().min_by_key(|spot| spot.number.abs_diff(cursor)) else { return };
    let at = place(rect.min, spot.at);
    let stroke = Stroke::new(2.0, palette(ui.ctx()).focus.0);
    ui.painter().circle_stroke(at, space(2.0), stroke);
    ui.painter().vline(at.x, Rangef::new(rect.top(), at.y - space(2.0)), Stroke::new(1.0, stroke.color));
}

/// A point is chosen by a click and opened by a second one; points that the pointer is drawn over fill the chart.
fn pointed_ui(ui: &Ui, view: &mut View<'_>, response: &Response, picture: &Picture) {
    let from = response.rect.min;
    let across = |x: f32| {
        let nearest = |spot: &&Spot| (screen(spot.at[0]) + from.x - x).abs();
        picture.spots.iter().min_by(|one, other| nearest(one).total_cmp(&nearest(other))).map(|spot| spot.number)
    };
    let near = |at: Pos2| {
        let distance = |spot: &Spot| place(from, spot.at).distance(at);
        let nearest = picture.spots.iter().min_by(|one, other| distance(one).total_cmp(&distance(other)));
        nearest.filter(|spot| distance(spot) <= NEAR).map(|spot| spot.number)
    };
    let start = response.id.with("brush");
    if response.drag_started()
        && let Some(at) = ui.input(|input| input.pointer.press_origin())
    {
        ui.data_mut(|data| data.insert_temp(start, at));
    }
    let begun = ui.data(|data| data.get_temp::<Pos2>(start));
    let now = response.interact_pointer_pos().or_else(|| ui.input(|input| input.pointer.latest_pos()));
    if let (Some(begun), Some(now)) = (begun, now) {
        let ends = Rangef::new(begun.x.min(now.x), begun.x.max(now.x));
        let is_wide = BRUSH <= ends.span();
        if response.drag_stopped() {
            ui.data_mut(|data| data.remove::<Pos2>(start));
            if let (true, Some(first), Some(last)) = (is_wide, across(ends.min), across(ends.max)) {
                view.send(StatisticsCommand::See(first..last + 1));
            }
        } else if response.dragged() && is_wide {
            let rect = Rect::from_x_y_ranges(ends, response.rect.y_range());
            ui.painter().rect_filled(rect, 0.0, palette(ui.ctx()).focus.0.gamma_multiply(0.15));
        }
    }
    if let Some(point) = response.interact_pointer_pos().and_then(near) {
        if response.double_clicked() {
            view.send(StatisticsCommand::OpenRecord(Some(point)));
        } else if response.clicked() {
            view.send(StatisticsCommand::ChoosePoint(point));
            focus_soon(ui, response.id);
        }
    }
    take_focus(ui, response.id);
    if let Some(point) = response.hover_pos().and_then(near) {
        let said = view.session.statistics().point_text(point, view.words);
        response.clone().on_hover_text_at_pointer(said);
    }
}

/// What is done with the point at which the keys are.
const POINT_ACTIONS: [StatisticsAction; 4] =
    [StatisticsAction::OpenPoint, StatisticsAction::LeaveOut, StatisticsAction::Freeze, StatisticsAction::Stage];

/// Which values make a mean.
fn mean_ui(ui: &mut Ui, view: &mut View<'_>) {
    let page = view.session.statistics();
    let name = quiet(ui, view.text("statistics-page-mean-of"));
    let entries = MeanOf::ALL.map(|of| (of, StatisticsAction::UseMeansOf(of).text(view.session, view.words)));
    let (mean_of, list) = one_of_ui(ui, "statistics-mean-of", space(48.0), &page.mean_of, entries);
    list.labelled_by(name.id);
    if let Some(mean_of) = mean_of {
        view.send(StatisticsCommand::UseMeansOf(mean_of));
    }
    let (field, id) = match page.mean_of {
        MeanOf::Count => (StatisticsField::Size, "statistics-page-size"),
        MeanOf::Pause => (StatisticsField::Pause, "statistics-page-pause"),
        MeanOf::Part | MeanOf::Station | MeanOf::Person => return,
    };
    let name = quiet(ui, view.text(id));
    field_ui(ui, view, field, name.id, FieldStyle::number(space(12.0)));
}

fn head_ui(ui: &mut Ui, view: &mut View<'_>) {
    let page = view.session.statistics();
    let Some((feature, _)) = page.open() else { return };
    ui.horizontal_wrapped(|ui| {
        heading(ui, view.words.number(&feature.key.title(false)));
        let choices = [PointsOf::Single, PointsOf::Means].map(StatisticsAction::UsePoints);
        segments_ui(ui, view, &choices, space(64.0).min(ui.available_width()));
        if page.points_of == PointsOf::Means {
            mean_ui(ui, view);
        }
        for (zooming, icon) in [(Zooming::In, Icon::Plus), (Zooming::Out, Icon::Minus)] {
            view.icon_button(ui, StatisticsAction::Zoom(zooming), icon);
        }
        view.icon_button(ui, StatisticsAction::SaveChart, Icon::FloppyDisk);
        if page.window().len() < page.count() {
            view.button(ui, StatisticsAction::Zoom(Zooming::Whole));
        }
        if page.cursor.is_some() {
            for action in POINT_ACTIONS {
                view.button(ui, action);
            }
        }
    });
    for field in [StatisticsField::Size, StatisticsField::Pause] {
        error_ui(ui, view, field);
    }
    if page.asks_why {
        ui.horizontal_wrapped(|ui| {
            let name = view.text("statistics-page-reason");
            ui.label(&name);
            let width = space(60.0).min(ui.available_width());
            named_field_ui(ui, view, StatisticsField::Reason, &name, FieldStyle::text(width));
            view.field_button(ui, StatisticsAction::TakeReason);
            view.field_button(ui, StatisticsAction::CancelReason);
        });
    }
    if let Some(said) = page.cursor_text(view.words) {
        quiet(ui, said);
    }
}
