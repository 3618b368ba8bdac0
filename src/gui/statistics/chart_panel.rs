//! The chart of the chosen feature.

use eframe::egui::accesskit::Role;
use eframe::egui::{Sense, Ui, WidgetInfo};

use crate::gui::field::{FieldStyle, error_ui, field_ui, named_field_ui};
use crate::gui::key_names::part_id;
use crate::gui::segments::segments_ui;
use crate::gui::shapes::focus_ring;
use crate::gui::theme::space;
use crate::gui::view::{View, heading, quiet};
use crate::session::focused::CHART;
use crate::session::statistics::{PointsOf, feature_name};
use crate::session::{StatisticsAction, StatisticsField};

/// Name, what makes a point, the chart, and what is done with a point.
pub(super) fn chart_ui(ui: &mut Ui, view: &mut View<'_>) {
    head_ui(ui, view);
    ui.allocate_ui(ui.available_size(), |ui| {
        let rect = ui.available_rect_before_wrap();
        let response = ui.interact(rect, part_id(CHART), Sense::click_and_drag());
        let said = view.session.statistics().chart_text(view.words);
        response.widget_info(|| WidgetInfo::labeled(Role::Image, true, &said));
        if response.has_focus() {
            focus_ring(ui, rect);
        }
        ui.allocate_rect(rect, Sense::hover());
    });
}

fn head_ui(ui: &mut Ui, view: &mut View<'_>) {
    let page = view.session.statistics();
    let Some((feature, _)) = page.open() else { return };
    ui.horizontal_wrapped(|ui| {
        heading(ui, feature_name(feature));
        let choices = [PointsOf::Single, PointsOf::Means].map(StatisticsAction::UsePoints);
        segments_ui(ui, view, &choices, space(64.0).min(ui.available_width()));
        if page.points_of == PointsOf::Means {
            let name = quiet(ui, view.text("statistics-page-size"));
            field_ui(ui, view, StatisticsField::Size, name.id, FieldStyle::number(space(12.0)));
        }
        if page.cursor.is_some() {
            for action in [StatisticsAction::OpenPoint, StatisticsAction::LeaveOut, StatisticsAction::Freeze] {
                view.button(ui, action);
            }
        }
    });
    error_ui(ui, view, StatisticsField::Size);
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
