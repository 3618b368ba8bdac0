//! Every class at this size, to choose from: letters across, grades down. A place without a class is empty.
//!
//! One widget for the keyboard (arrows go to the next defined class), one node a class for screen readers and the
//! pointer.

use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align2, Button, Id, Painter, Pos2, Rect, Response, Sense, Stroke, StrokeKind, Ui, UiBuilder, WidgetInfo, pos2, vec2,
};

use super::letter_columns::Columns;
use super::staircase::staircase_ui;
use crate::gui::class_chooser::feature_classes_id;
use crate::gui::key_names::part_id;
use crate::gui::theme::{self, Palette, control, palette, sizes, space};
use crate::gui::view::{View, heading, quiet};
use crate::message::message;
use crate::session::focused::CLASSES;
use crate::session::{ClassMap, FitAction, FitCommand, MapCell};
use crate::tolerance::iso286::{self, Grade, Letter};
use crate::tolerance::{Feature, ToleranceClass};

/// Heading, staircase, grid, and classes of own tables, down to the end of a column of `height` if that is high enough.
pub(super) fn class_map_ui(ui: &mut Ui, view: &mut View<'_>, height: f32) {
    let session = view.session;
    let side = session.fit().side();
    ui.horizontal(|ui| {
        match session.fit().nominal {
            Some(nominal) => heading(ui, view.words.say(&message!("fit-classes").number("nominal", nominal))),
            None => heading(ui, view.text("fit-classes-none")),
        };
        for feature in [Feature::Hole, Feature::Shaft] {
            let show = FitAction::ShowClasses(feature);
            let button = Button::selectable(side == feature, show.text(session, view.words));
            view.button_as(ui, show, button.min_size(vec2(0.0, control(ui))));
        }
    });
    let Some(map) = session.fit().map(side) else {
        quiet(ui, view.text("fit-classes-empty"));
        return;
    };
    if map.is_empty() {
        quiet(ui, view.text("fit-classes-nowhere"));
        return;
    }
    // Counted from the top of the column, so that nothing changes its size while it scrolls.
    let left = |ui: &Ui| height - (ui.cursor().top() - ui.min_rect().top());
    let chosen = session.fit().class(side);
    let grade = chosen.and_then(iso286::parts).map(|(_, grade)| grade);
    let grade = grade.or_else(|| map.first().and_then(iso286::parts).map(|(_, grade)| grade));
    if let Some(grade) = grade {
        staircase_ui(ui, view, map, grade, ((left(ui) - space(2.0)) * 0.28).max(space(22.0)), Columns::of);
    }
    let rows = f32::from(u8::try_from(map.grades().count()).unwrap_or(u8::MAX)) + 1.0;
    let row = ((left(ui) - space(1.0)) / rows).clamp(space(3.0), space(5.5));
    grid_ui(ui, view, map, chosen, row);
    for class in &map.others {
        if ui.add(Button::selectable(chosen == Some(*class), class.as_str())).clicked() {
            view.send(FitCommand::ChooseClass(*class));
        }
    }
}

pub(super) fn letter_text(letter: Letter, side: Feature) -> String {
    match side {
        Feature::Hole => letter.text().to_uppercase(),
        Feature::Shaft => letter.text().to_owned(),
    }
}

/// The id of a side's map: it takes the focus as a whole.
pub(in crate::gui) fn map_id() -> Id {
    part_id(CLASSES)
}

fn grid_ui(ui: &mut Ui, view: &mut View<'_>, map: &ClassMap, chosen: Option<ToleranceClass>, row: f32) {
    let side = view.session.fit().side();
    let grades: Vec<Grade> = map.grades().collect();
    let count = f32::from(u8::try_from(grades.len()).unwrap_or(u8::MAX)) + 1.0;
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), row * count), Sense::hover());
    let id = map_id();
    let whole = ui.interact(rect, id, Sense::click());
    let name = view.text(feature_classes_id(side));
    whole.widget_info(|| WidgetInfo::labeled(Role::RadioGroup, true, &name));
    if let Some(class) = chosen {
        ui.ctx().accesskit_node_builder(id, |node| node.set_value(class.as_str()));
    }
    // The classes stand in their group.
    let ui = &mut ui.new_child(UiBuilder::new().max_rect(rect).accessibility_parent(id));
    let columns = Columns::of(rect);
    let table = Table { painter: ui.painter().clone(), palette: palette(ui.ctx()), columns, row, chosen, side };
    table.letters(rect.top());
    let mut top = rect.top();
    for grade in grades {
        top += row;
        table.grade(rect.left(), top, grade);
        for (letter, x) in columns.letters() {
            let Some(cell) = map.cell(letter, grade) else { continue };
            let place = Rect::from_min_size(pos2(x, top), vec2(columns.step, row));
            let response = ui.interact(place, id.with((letter, grade)), Sense::CLICK);
            table.cell(place, cell, &response);
            if response.clicked() {
                view.send(FitCommand::ChooseClass(cell.class));
                whole.request_focus();
            }
            cell_hint(view, cell, response);
        }
    }
    if whole.has_focus() {
        let ring = Stroke::new(2.0, palette(ui.ctx()).focus.0);
        ui.painter().rect_stroke(rect, 4.0, ring, StrokeKind::Inside);
    }
}

fn cell_hint(view: &View<'_>, cell: &MapCell, response: Response) {
    response.on_hover_ui(|ui| {
        let upper = cell.deviations.upper();
        let lower = cell.deviations.lower();
        let upper = view.words.signed_um(upper);
        let lower = view.words.signed_um(lower);
        ui.label(format!("{}  {lower} … {upper} µm", cell.class));
    });
}

struct Table<'a> {
    painter: Painter,
    palette: &'a Palette,
    columns: Columns,
    row: f32,
    chosen: Option<ToleranceClass>,
    side: Feature,
}

impl Table<'_> {
    fn text(&self, at: Pos2, anchor: Align2, text: &str, is_chosen: bool) {
        let (font, colour) = if is_chosen {
            (theme::bold(sizes().small), self.palette.text.0)
        } else {
            (theme::font(sizes().small), self.palette.quiet.0)
        };
        self.painter.text(at, anchor, text, font, colour);
    }

    fn letters(&self, top: f32) {
        let now = self.chosen.and_then(iso286::parts).map(|(letter, _)| letter);
        for (letter, x) in self.columns.letters() {
            let at = pos2(x + self.columns.step / 2.0, top + self.row / 2.0);
            self.text(at, Align2::CENTER_CENTER, &letter_text(letter, self.side), now == Some(letter));
        }
    }

    fn grade(&self, left: f32, top: f32, grade: Grade) {
        let now = self.chosen.and_then(iso286::parts).map(|(_, grade)| grade);
        let at = pos2(left + space(7.5), top + self.row / 2.0);
        self.text(at, Align2::RIGHT_CENTER, &grade.to_string(), now == Some(grade));
    }

    fn cell(&self, place: Rect, cell: &MapCell, response: &Response) {
        let is_chosen = self.chosen == Some(cell.class);
        let inner = place.shrink(1.0);
        let fill = if is_chosen {
            self.palette.data.0
        } else {
            match self.side {
                Feature::Hole => self.palette.hole.0,
                Feature::Shaft => self.palette.shaft.0,
            }
        };
        self.painter.rect_filled(inner, 1.0, fill);
        if response.hovered() {
            self.painter.rect_stroke(inner, 1.0, Stroke::new(1.5, self.palette.data.0), StrokeKind::Inside);
        }
        if is_chosen {
            // An additional mark: the chosen class is not shown by colour alone.
            self.painter.circle_filled(place.center(), space(0.8), self.palette.on_accent.0);
        }
        response.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, is_chosen, cell.class.as_str()));
    }
}
