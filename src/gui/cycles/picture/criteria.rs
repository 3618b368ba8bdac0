//! Every criterion of a circle side by side, the effect of scatter on it, and what the contacts cannot tell.

use eframe::egui::accesskit::Role;
use eframe::egui::{Align2, FontId, Grid, Response, RichText, Ui, WidgetInfo};

use crate::gui::theme::{self, palette, sizes, space};
use crate::gui::view::{View, quiet};
use crate::message::{Message, message};
use crate::probing::circle::{Circle, CircleWarning, Evaluation, TwoPoint};
use crate::words::Words;

/// Up to this many two-point sizes are listed one by one; of more, the smallest and the largest.
const MOST_PAIRS: usize = 4;

/// Below this width the table is set in small type.
const NARROW: f32 = 140.0;

/// The heads of the columns.
const HEADS: [&str; 4] = [
    "cycle-picture-head-centre-1",
    "cycle-picture-head-centre-2",
    "cycle-picture-head-diameter",
    "cycle-picture-head-form",
];

/// The table, the uncertainties and the warnings, below one another.
pub(in crate::gui) fn criteria_table(ui: &mut Ui, view: &View<'_>, evaluation: &Evaluation) {
    let words = view.words;
    // Where the column is narrow the table is set smaller, so that its last column is not cut.
    let is_narrow = ui.available_width() < space(NARROW);
    let (size, gap) = if is_narrow { (sizes().small, 2.0) } else { (sizes().body, 3.0) };
    let rows = rows(words, evaluation);
    let widths = Widths::of(ui, words, &rows, (size, space(gap)));
    let grid = Grid::new("cycle-criteria").num_columns(5).min_row_height(space(5.0)).spacing([space(gap), 0.0]);
    grid.show(ui, |ui| {
        of_width(ui, widths.name, |ui| quiet(ui, view.text("cycle-picture-head-criterion")));
        for (head, width) in HEADS.into_iter().zip(widths.columns) {
            of_width(ui, width, |ui| quiet(ui, view.text(head)));
        }
        ui.end_row();
        for row in rows {
            row.ui(ui, words, (size, widths.name));
        }
    });
    quiet(ui, uncertainty(words, evaluation));
    for warning in evaluation.warnings.iter().filter(|warning| !stands_in_the_table(warning)) {
        ui.label(format!("• {}", words.told(warning)));
    }
}

/// A cell whose text goes on in another line where the width ends.
fn of_width(ui: &mut Ui, width: f32, content: impl FnOnce(&mut Ui) -> Response) {
    ui.vertical(|ui| {
        ui.set_max_width(width);
        content(ui)
    });
}

/// How wide names and heads may be.
struct Widths {
    name: f32,
    columns: [f32; 4],
}

impl Widths {
    /// As wide as they are; where the room is too narrow for that, heads become as narrow as their values, and names get
    /// what is left.
    fn of(ui: &Ui, words: &Words, rows: &[CriterionRow], (size, gap): (f32, f32)) -> Self {
        let width = |text: &str, font: FontId| {
            ui.painter().layout_no_wrap(text.to_owned(), font, palette(ui.ctx()).text.0).size().x.ceil()
        };
        let name = rows.iter().map(|row| width(&row.name, theme::bold(size))).fold(0.0, f32::max);
        let of_values = |column: usize| {
            let cells = rows.iter().filter_map(|row| row.cells.as_ref().ok()?.get(column));
            cells.map(|cell| width(cell, theme::font(size))).fold(0.0, f32::max)
        };
        let values = [0, 1, 2, 3].map(of_values);
        let small = || theme::font(sizes().small);
        let room = ui.available_width() - gap * 4.0;
        let of_heads = HEADS.map(|head| width(&words.get(head), small()));
        let columns = wider(of_heads, values);
        if name + columns.iter().sum::<f32>() <= room {
            return Self { name, columns };
        }
        let of_words =
            HEADS.map(|head| words.get(head).split(' ').map(|word| width(word, small())).fold(0.0, f32::max));
        let columns = wider(of_words, values);
        Self { name: (room - columns.iter().sum::<f32>()).clamp(space(20.0), name.max(space(20.0))), columns }
    }
}

/// Of two widths of each column the wider one.
fn wider(mut widths: [f32; 4], others: [f32; 4]) -> [f32; 4] {
    for (width, other) in widths.iter_mut().zip(others) {
        *width = width.max(other);
    }
    widths
}

/// One criterion.
#[derive(Debug, Clone, PartialEq)]
struct CriterionRow {
    name: String,
    /// Centre in both axes, diameter, form; a dash where a criterion has none. Or else why there is no circle.
    cells: Result<[String; 4], String>,
}

impl CriterionRow {
    fn ui(self, ui: &mut Ui, words: &Words, (size, width): (f32, f32)) {
        of_width(ui, width, |ui| ui.label(RichText::new(&self.name).font(theme::bold(size))));
        match self.cells {
            Ok(cells) => {
                for (cell, head) in cells.into_iter().zip(HEADS) {
                    let said = format!("{}, {} {cell}", self.name, words.get(head));
                    let response = ui.label(RichText::new(cell).font(theme::font(size)));
                    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, &said));
                }
            }
            Err(reason) => {
                // The reason is a sentence and spans all columns.
                let colour = palette(ui.ctx()).quiet.0;
                let galley = ui.painter().layout_no_wrap(reason.clone(), theme::font(sizes().small), colour);
                let response = ui.allocate_response([1.0, galley.size().y].into(), eframe::egui::Sense::hover());
                let at = Align2::LEFT_CENTER.anchor_size(response.rect.left_center(), galley.size()).min;
                ui.painter().galley(at, galley, colour);
                let said = format!("{}, {reason}", self.name);
                response.widget_info(|| WidgetInfo::labeled(Role::Label, true, &said));
            }
        }
        ui.end_row();
    }
}

fn rows(words: &Words, evaluation: &Evaluation) -> Vec<CriterionRow> {
    let named = |id: &str, cells| CriterionRow { name: words.get(id), cells };
    let circle = |circle: &Circle, form: Option<f64>| {
        let form = form.map_or_else(|| words.get("cycle-picture-none"), |form| um(words, form));
        [mm(words, circle.x), mm(words, circle.y), mm(words, circle.diameter), form]
    };
    let missing = |known: fn(&CircleWarning) -> bool| {
        let warning = evaluation.warnings.iter().find(|warning| known(warning) || is_too_many(warning));
        warning.map_or_else(|| words.get("cycle-picture-none"), |warning| words.told(warning))
    };
    let inscribed = evaluation.maximum_inscribed.as_ref().map(|inscribed| circle(inscribed, None));
    let zone = evaluation.minimum_zone.map(|zone| {
        let ring = format!("{}–{}", mm(words, zone.inner_diameter), mm(words, zone.outer_diameter));
        [mm(words, zone.x), mm(words, zone.y), ring, um(words, zone.width)]
    });
    let mut rows = vec![
        named("cycle-picture-least-squares", Ok(circle(&evaluation.least_squares, Some(evaluation.form())))),
        named("cycle-picture-circumscribed", Ok(circle(&evaluation.minimum_circumscribed, None))),
        named(
            "cycle-picture-inscribed",
            inscribed.ok_or_else(|| missing(|warning| *warning == CircleWarning::NoInscribed)),
        ),
        named("cycle-picture-zone", zone.ok_or_else(|| missing(|warning| *warning == CircleWarning::NoZone))),
    ];
    rows.extend(two_point(words, &evaluation.two_point));
    rows
}

fn two_point(words: &Words, sizes: &[TwoPoint]) -> Vec<CriterionRow> {
    if sizes.is_empty() {
        let name = words.get("cycle-picture-two-point");
        return vec![CriterionRow { name, cells: Err(words.get("cycle-picture-no-opposed")) }];
    }
    let row = |id: &'static str, size: &TwoPoint| {
        let [first, second] = size.contacts;
        let name = words.say(&Message::new(id).text("first", first).text("second", second));
        let none = || words.get("cycle-picture-none");
        CriterionRow { name, cells: Ok([none(), none(), mm(words, size.size), none()]) }
    };
    if sizes.len() <= MOST_PAIRS {
        return sizes.iter().map(|size| row("cycle-picture-two-point-of", size)).collect();
    }
    let least = sizes.iter().min_by(|one, other| one.size.total_cmp(&other.size));
    let most = sizes.iter().max_by(|one, other| one.size.total_cmp(&other.size));
    let ends = [("cycle-picture-two-point-least", least), ("cycle-picture-two-point-most", most)];
    ends.into_iter().filter_map(|(id, size)| size.map(|size| row(id, size))).collect()
}

/// The effect of a contact's scatter on diameter and centre.
fn uncertainty(words: &Words, evaluation: &Evaluation) -> String {
    let factors = &evaluation.uncertainty;
    let factor = |value: f64| words.number(&format!("{value:.2}"));
    let message = message!("cycle-picture-uncertainty")
        .text("diameter", factor(factors.diameter))
        .text("along", factor(factors.centre_along))
        .text("across", factor(factors.centre_across))
        .text("against", factor(factors.against_three_by_120()));
    words.say(&message)
}

fn is_too_many(warning: &CircleWarning) -> bool {
    matches!(warning, CircleWarning::TooManyContacts { .. })
}

/// Whether a warning is already shown in place of the circle.
fn stands_in_the_table(warning: &CircleWarning) -> bool {
    is_too_many(warning) || matches!(warning, CircleWarning::NoInscribed | CircleWarning::NoZone)
}

/// Millimetres to 0.1 µm.
fn mm(words: &Words, value: f64) -> String {
    words.number(&plain(value, 4))
}

/// Micrometres to a hundredth.
fn um(words: &Words, value_mm: f64) -> String {
    format!("{} µm", words.number(&plain(value_mm * 1000.0, 2)))
}

/// Decimals without the minus sign of a rounded zero.
pub(super) fn plain(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(bare) if !bare.bytes().any(|byte| (b'1'..=b'9').contains(&byte)) => bare.to_owned(),
        _ => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::probing::Contact;
    use crate::probing::circle::evaluate;
    use crate::words::Language;

    fn on_circle(degrees: &[f64]) -> Evaluation {
        let contacts: Vec<_> = degrees
            .iter()
            .map(|degrees| libm::sincos(degrees.to_radians()))
            .map(|(sin, cos)| Contact { x: 10.0 + 12.5 * cos, y: 12.5 * sin, z: 0.0 })
            .collect();
        evaluate(&contacts).unwrap()
    }

    fn said(evaluation: &Evaluation) -> Vec<String> {
        let words = Words::new(Language::En);
        let text = |row: CriterionRow| {
            format!("{}: {}", row.name, row.cells.map_or_else(|reason| reason, |cells| cells.join(" ")))
        };
        rows(&words, evaluation).into_iter().map(text).collect()
    }

    #[test]
    fn every_criterion_has_its_row() {
        assert_eq!(
            said(&on_circle(&[0.0, 90.0, 180.0, 270.0])),
            [
                "Least squares: 10.0000 0.0000 25.0000 0.00 µm",
                "Minimum circumscribed: 10.0000 0.0000 25.0000 —",
                "Maximum inscribed: 10.0000 0.0000 25.0000 —",
                "Minimum zone, roundness: 10.0000 0.0000 25.0000–25.0000 0.00 µm",
                "Two-point size 1–3: — — 25.0000 —",
                "Two-point size 2–4: — — 25.0000 —",
            ]
        );
    }

    #[test]
    fn what_does_not_exist_says_why() {
        let short = said(&on_circle(&[0.0, 20.0, 40.0]));
        assert!(
            short.contains(
                &"Maximum inscribed: no maximum inscribed circle: the contacts do not surround one".to_owned()
            ),
            "{short:#?}"
        );
        assert!(short.contains(&"Two-point size: no two contacts oppose each other".to_owned()), "{short:#?}");
    }

    #[test]
    fn a_rounded_zero_has_no_sign() {
        assert_eq!(plain(-0.000_04, 4), "0.0000");
        assert_eq!(plain(-0.000_06, 4), "-0.0001");
    }
}
