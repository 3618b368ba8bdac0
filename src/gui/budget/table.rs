//! Middle: the table of contributions as the GUM has it. Where it is narrow, type and law stand below the name.

use eframe::egui::accesskit::Role;
use eframe::egui::{Align, FontId, Grid, Label, Layout, Rect, RichText, Sense, Ui, WidgetInfo, vec2};

use crate::budget::{Answer, Assessment, ContributionRow, Evaluation, Law};
use crate::gui::spoken;
use crate::gui::theme::{self, palette, sizes, space};
use crate::gui::view::{View, heading, quiet};
use crate::message::message;

/// The least width of a name where the table has all columns, and where it is narrow.
const WIDE_NAME: f32 = 30.0;
const LEAST_NAME: f32 = 18.0;

/// How many columns of words come before the figures; where there is no room they stand below the name.
const WORDS: usize = 2;

/// Between columns.
const GAP: f32 = 2.5;

/// A row in words.
struct ContributionTexts {
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
            let from = view.session.budget().readings.as_ref().map(|readings| readings.from.clone());
            let own = || message!("budget-page-readings-own").count("count", repeated.readings);
            heading(ui, view.text("budget-page-readings"));
            ui.label(view.words.say(&from.unwrap_or_else(own)));
            ui.label(view.words.say(&message!("budget-page-mean").number("mm", mean)));
            ui.separator();
        }
    }
}

fn contributions_ui(ui: &mut Ui, view: &View<'_>, evaluation: &Evaluation) {
    let name = view.text("budget-page-table");
    heading(ui, &name);
    let rows: Vec<ContributionTexts> = evaluation.rows.iter().map(|row| told(view, row)).collect();
    let heads = [
        view.text("budget-page-column-type"),
        view.text("budget-page-column-law"),
        "u".to_owned(),
        view.text("budget-page-column-sensitivity"),
        "c·u, µm".to_owned(),
        view.text("budget-page-column-share"),
        "ν".to_owned(),
    ];
    let font = theme::font(sizes().small);
    let width = |text: &str| width(ui, text, &font);
    let widest = |number: usize, head: &String| {
        let cells = rows.iter().filter_map(|row| row.cells().get(number).map(|text| width(text)));
        cells.fold(width(head), f32::max).ceil()
    };
    let widths: Vec<f32> = heads.iter().enumerate().map(|(number, head)| widest(number, head)).collect();
    let room =
        |from: usize| widths.iter().skip(from).fold(ui.available_width(), |room, width| room - width - space(GAP));
    // A short name leaves no gap before its figures.
    let head = view.text("budget-page-column-name");
    let names = rows.iter().map(|row| width(&row.name)).fold(width(&head), f32::max).ceil();
    let (all, with_words_below) = (room(0), room(WORDS));
    spoken::around_ui(ui, Role::Table, &name, |ui| {
        if space(WIDE_NAME) <= all {
            grid_ui(ui, view, &rows, &Columns { heads: &heads, widths: &widths, from: 0, name: names.min(all) });
        } else if space(LEAST_NAME) <= with_words_below {
            let columns = Columns { heads: &heads, widths: &widths, from: WORDS, name: with_words_below };
            grid_ui(ui, view, &rows, &columns);
        } else {
            list_ui(ui, &rows);
        }
    });
    for row in &evaluation.rows {
        if let Some(geometry) = row.geometry {
            let factor = format!("{:.3}", geometry.factor);
            let message = match geometry.step_deg {
                Some(step) => message!("budget-page-contacts-stepped").number("step", step),
                None => message!("budget-page-contacts-used"),
            };
            let said = view.words.say(&message.count("count", geometry.touches).number("factor", factor));
            quiet(ui, format!("{}: {said}", row.name));
        }
    }
    ui.separator();
}

/// The columns of the table after the name, from one of them on.
struct Columns<'a> {
    heads: &'a [String],
    widths: &'a [f32],
    from: usize,
    /// The width of the name.
    name: f32,
}

fn grid_ui(ui: &mut Ui, view: &View<'_>, rows: &[ContributionTexts], columns: &Columns<'_>) {
    let Columns { heads, widths, from, name } = *columns;
    let is_word = |number: usize| number < WORDS;
    let quiet = palette(ui.ctx()).quiet.0;
    let grid = Grid::new("budget-table").num_columns(heads.len() + 1 - from).min_row_height(0.0).min_col_width(0.0);
    grid.spacing(vec2(space(GAP), space(1.0))).show(ui, |ui| {
        name_ui(ui, name, vec![RichText::new(view.text("budget-page-column-name")).color(quiet)]);
        for (number, (head, width)) in heads.iter().zip(widths).enumerate().skip(from) {
            cell_ui(ui, RichText::new(head).color(quiet), *width, is_word(number));
        }
        ui.end_row();
        for row in rows {
            let below = RichText::new(format!("{}, {}", row.letter, row.law)).color(quiet);
            let lines = std::iter::once(RichText::new(&row.name)).chain((0 < from).then_some(below));
            let mut rect = name_ui(ui, name, lines.collect());
            for (number, (text, width)) in row.cells().iter().zip(widths).enumerate().skip(from) {
                rect = rect.union(cell_ui(ui, RichText::new(text), *width, is_word(number)));
            }
            row.say(ui, rect);
            ui.end_row();
        }
    });
}

/// Where there is no room for columns, a row is a sentence.
fn list_ui(ui: &mut Ui, rows: &[ContributionTexts]) {
    for row in rows {
        let shown = quiet(ui, &row.said);
        row.say(ui, shown.rect);
    }
}

impl ContributionTexts {
    /// The cells after the name.
    fn cells(&self) -> Vec<String> {
        let first = [self.letter.to_owned(), self.law.clone(), self.u.clone()];
        first.into_iter().chain(self.figures.iter().cloned()).collect()
    }

    /// What a screen reader says of the row.
    fn say(&self, ui: &Ui, rect: Rect) {
        let response = ui.interact(rect, ui.scope_id().with(("row", &self.said)), Sense::hover());
        response.widget_info(|| WidgetInfo::labeled(Role::Row, true, &self.said));
    }
}

fn width(ui: &Ui, text: &str, font: &FontId) -> f32 {
    ui.painter().layout_no_wrap(text.to_owned(), font.clone(), palette(ui.ctx()).text.0).size().x
}

/// The lines of a name, broken where they are too long.
fn name_ui(ui: &mut Ui, width: f32, lines: Vec<RichText>) -> Rect {
    let shown = ui.vertical(|ui| {
        ui.set_width(width);
        ui.spacing_mut().item_spacing.y = 0.0;
        for line in lines {
            ui.add(Label::new(line.size(sizes().small)).wrap());
        }
    });
    shown.response.rect
}

/// A cell; figures stand at the right.
fn cell_ui(ui: &mut Ui, text: RichText, width: f32, is_word: bool) -> Rect {
    let layout = if is_word { Layout::left_to_right(Align::Min) } else { Layout::right_to_left(Align::Min) };
    let font = theme::font(sizes().small);
    let height = ui.painter().layout_no_wrap("0".to_owned(), font, palette(ui.ctx()).text.0).size().y;
    let shown = ui.allocate_ui_with_layout(vec2(width, height), layout, |ui| {
        ui.set_min_width(width);
        ui.add(Label::new(text.size(sizes().small)).extend());
    });
    shown.response.rect
}

pub(super) fn degrees(view: &View<'_>, degrees: Option<f64>) -> String {
    degrees.map_or_else(|| "∞".to_owned(), |degrees| view.words.number(&format!("{degrees:.1}")))
}

pub(super) const fn law_id(law: Law) -> &'static str {
    match law {
        Law::Normal => "budget-page-law-normal",
        Law::Rectangular => "budget-page-law-rectangular",
        Law::UShaped => "budget-page-law-u-shaped",
        Law::Triangular => "budget-page-law-triangular",
    }
}

fn told(view: &View<'_>, row: &ContributionRow) -> ContributionTexts {
    let figure = |number: f64, decimals: usize| view.words.number(&format!("{number:.decimals$}"));
    let law = view.text(law_id(row.law));
    let [u, sensitivity, um, share] =
        [figure(row.u, 3), figure(row.sensitivity, 4), figure(row.contribution, 3), figure(row.share, 1)];
    let freedom = degrees(view, row.degrees_of_freedom);
    let infinite = || view.text("budget-page-infinite");
    let said = message!("budget-page-row")
        .text("name", &row.name)
        .text("type", row.evaluated.letter())
        .text("law", &law)
        .text("u", &u)
        .text("unit", row.unit)
        .text("sensitivity", &sensitivity)
        .text("um", &um)
        .text("percent", &share)
        .text("degrees", row.degrees_of_freedom.map_or_else(infinite, |_| freedom.clone()));
    ContributionTexts {
        name: row.name.clone(),
        letter: row.evaluated.letter(),
        law,
        u: format!("{u} {}", row.unit),
        figures: [sensitivity, um, format!("{share} %"), freedom],
        said: view.words.say(&said),
    }
}
