//! Middle: the table of contributions as the GUM has it. Where it is narrow, type and law stand below the name.

use eframe::egui::accesskit::Role;
use eframe::egui::{Align, FontId, Grid, Label, Layout, RichText, Sense, Ui, WidgetInfo, vec2};

use crate::budget::{Answer, Assessment, Evaluation, Law, Row};
use crate::gui::theme::{self, palette, sizes, space};
use crate::gui::view::{View, heading, quiet};
use crate::message::Message;

/// The least width of a name where the table has all columns, and where it is narrow.
const WIDE_NAME: f32 = 30.0;
const LEAST_NAME: f32 = 18.0;

/// Between columns.
const GAP: f32 = 2.5;

/// A row in words.
struct Told {
    name: String,
    letter: &'static str,
    law: String,
    u: String,
    /// Sensitivity, c·u, share, degrees of freedom.
    figures: [String; 4],
    said: String,
}

/// The table, or of a calibrated piece the mean of its readings.
pub(super) fn table_ui(ui: &mut Ui, view: &View<'_>, found: &Assessment) {
    match &found.answer {
        Answer::Combined(evaluation) => contributions_ui(ui, view, evaluation),
        Answer::Repeated(repeated) => {
            let mean = format!("{:.6}", repeated.mean_mm);
            let from = view.session.budget().readings().map(|readings| readings.from.clone());
            let own = || Message::new("budget-page-readings-own").count("count", repeated.readings);
            heading(ui, view.text("budget-page-readings"));
            ui.label(view.words.say(&from.unwrap_or_else(own)));
            ui.label(view.words.say(&Message::new("budget-page-mean").mm("mm", mean)));
            ui.separator();
        }
    }
}

fn contributions_ui(ui: &mut Ui, view: &View<'_>, evaluation: &Evaluation) {
    heading(ui, view.text("budget-page-table"));
    let rows: Vec<Told> = evaluation.rows.iter().map(|row| told(view, row)).collect();
    let heads = [
        view.text("budget-page-column-type"),
        view.text("budget-page-column-law"),
        "u".to_owned(),
        view.text("budget-page-column-sensitivity"),
        "c·u, µm".to_owned(),
        view.text("budget-page-column-share"),
        "ν".to_owned(),
    ];
    let cells = |row: &Told| -> Vec<String> {
        let first = [row.letter.to_owned(), row.law.clone(), row.u.clone()];
        first.into_iter().chain(row.figures.iter().cloned()).collect()
    };
    let font = theme::font(sizes().small);
    let width = |text: &str| width(ui, text, &font);
    let widest = |number: usize, head: &String| {
        let cells = rows.iter().filter_map(|row| cells(row).get(number).map(|text| width(text)));
        cells.fold(width(head), f32::max).ceil()
    };
    let widths: Vec<f32> = heads.iter().enumerate().map(|(number, head)| widest(number, head)).collect();
    let room = |from: usize| {
        let columns = widths.get(from..).unwrap_or_default();
        columns.iter().fold(ui.available_width(), |room, width| room - width - space(GAP))
    };
    let is_wide = space(WIDE_NAME) <= room(0);
    let from = if is_wide { 0 } else { 2 };
    let name_width = room(from).max(space(LEAST_NAME));
    let columns: Vec<(&String, f32)> = heads.iter().zip(widths.iter().copied()).skip(from).collect();
    Grid::new("budget-table")
        .num_columns(columns.len() + 1)
        .min_row_height(0.0)
        .spacing(vec2(space(GAP), space(1.0)))
        .show(ui, |ui| {
            name_ui(ui, name_width, &[RichText::new(view.text("budget-page-column-name"))]);
            for (number, (head, width)) in columns.iter().enumerate() {
                cell_ui(ui, head, *width, is_wide && number < 2, true);
            }
            ui.end_row();
            for row in &rows {
                let below = format!("{}, {}", row.letter, row.law);
                let name = RichText::new(&row.name).color(palette(ui.ctx()).text.0);
                let lines = if is_wide { vec![name] } else { vec![name, RichText::new(below)] };
                let mut rect = name_ui(ui, name_width, &lines);
                for (number, (text, (_, width))) in cells(row).iter().skip(from).zip(&columns).enumerate() {
                    rect = rect.union(cell_ui(ui, text, *width, is_wide && number < 2, false));
                }
                let response = ui.interact(rect, ui.scope_id().with(("row", &row.said)), Sense::hover());
                response.widget_info(|| WidgetInfo::labeled(Role::Row, true, &row.said));
                ui.end_row();
            }
        });
    for row in &evaluation.rows {
        if let Some(geometry) = row.geometry {
            let factor = format!("{:.3}", geometry.factor);
            let message = match geometry.step_deg {
                Some(step) => Message::new("budget-page-contacts-stepped").mm("step", step),
                None => Message::new("budget-page-contacts-used"),
            };
            let said = view.words.say(&message.count("count", geometry.touches).mm("factor", factor));
            quiet(ui, format!("{}: {said}", row.name));
        }
    }
    ui.separator();
}

fn width(ui: &Ui, text: &str, font: &FontId) -> f32 {
    ui.painter().layout_no_wrap(text.to_owned(), font.clone(), palette(ui.ctx()).text.0).size().x
}

/// The lines of a name, broken where they are too long.
fn name_ui(ui: &mut Ui, width: f32, lines: &[RichText]) -> eframe::egui::Rect {
    let shown = ui.vertical(|ui| {
        ui.set_width(width);
        ui.spacing_mut().item_spacing.y = 0.0;
        for line in lines {
            let _shown = ui.add(Label::new(RichText::clone(line).size(sizes().small)).wrap());
        }
    });
    shown.response.rect
}

/// A cell; figures stand at the right.
fn cell_ui(ui: &mut Ui, text: &str, width: f32, is_word: bool, is_head: bool) -> eframe::egui::Rect {
    let layout = if is_word { Layout::left_to_right(Align::Min) } else { Layout::right_to_left(Align::Min) };
    let colour = if is_head { palette(ui.ctx()).quiet.0 } else { palette(ui.ctx()).text.0 };
    let text = RichText::new(text).size(sizes().small).color(colour);
    let height = sizes().small;
    ui.allocate_ui_with_layout(vec2(width, height), layout, |ui| {
        ui.set_min_width(width);
        ui.add(Label::new(text).extend());
    })
    .response
    .rect
}

pub(super) fn degrees(view: &View<'_>, degrees: Option<f64>) -> String {
    degrees.map_or_else(|| "∞".to_owned(), |degrees| view.words.number(&format!("{degrees:.1}")))
}

const fn law_id(law: Law) -> &'static str {
    match law {
        Law::Normal => "budget-page-law-normal",
        Law::Rectangular => "budget-page-law-rectangular",
        Law::UShaped => "budget-page-law-u-shaped",
        Law::Triangular => "budget-page-law-triangular",
    }
}

fn told(view: &View<'_>, row: &Row) -> Told {
    let figure = |number: f64, decimals: usize| view.words.number(&format!("{number:.decimals$}"));
    let law = view.text(law_id(row.law));
    let [u, sensitivity, um, share] =
        [figure(row.u, 3), figure(row.sensitivity, 4), figure(row.contribution, 3), figure(row.share, 1)];
    let freedom = degrees(view, row.degrees_of_freedom);
    let infinite = || view.text("budget-page-infinite");
    let said = Message::new("budget-page-row")
        .text("name", &row.name)
        .text("type", row.evaluated.letter())
        .text("law", &law)
        .text("u", &u)
        .text("unit", row.unit)
        .text("sensitivity", &sensitivity)
        .text("um", &um)
        .text("percent", &share)
        .text("degrees", row.degrees_of_freedom.map_or_else(infinite, |_| freedom.clone()));
    Told {
        name: row.name.clone(),
        letter: row.evaluated.letter(),
        law,
        u: format!("{u} {}", row.unit),
        figures: [sensitivity, um, format!("{share} %"), freedom],
        said: view.words.say(&said),
    }
}
