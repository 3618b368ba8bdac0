//! The contacts seen from above: nominal circle, contacts with magnified deviations, fitted circle and centre.

use std::f64::consts::TAU;

use eframe::egui::{Align, Align2, Stroke, Ui, vec2};
use egui_plot::{Line, LineStyle, MarkerShape, PlotPoint, PlotPoints, Points};

use crate::gui::shapes::{magnification, screen};
use crate::gui::spoken;
use crate::gui::theme::{self, palette, sizes};
use crate::gui::view::{Digits, View, heading, quiet, still_plot};
use crate::journal::Record;
use crate::length::{Length, Unit};
use crate::message::{Say as _, message};
use crate::words::Words;

/// How far the largest deviation reaches, as a share of the nominal radius.
const REACH: f64 = 0.3;

/// Beyond this many contacts their numbers would hide the picture.
const MOST_NUMBERS: usize = 16;

/// From a contact to its label, in points.
const BESIDE: f32 = 14.0;

/// The share of the room that the circle keeps, whatever labels need.
const LEAST: f64 = 0.3;

/// Points on a drawn circle.
const STEPS: u16 = 144;

/// Heading, plot and remarks.
pub(super) fn contacts_ui(ui: &mut Ui, view: &View<'_>) {
    let record = view.session.check().shown.as_ref().map(|shown| shown.record.as_ref());
    let picture = record.and_then(Picture::of);
    ui.horizontal(|ui| {
        heading(ui, view.text("contacts"));
        if let Some(picture) = &picture {
            let factor = message!("contacts-factor").text("factor", view.words.number(&format!("{}", picture.factor)));
            quiet(ui, view.words.say(&factor));
        }
    });
    let Some(record) = record else {
        quiet(ui, view.text("contacts-empty"));
        return;
    };
    // The remarks are below the plot, so their height is taken first.
    let remarks = remarks(view.words, record);
    let text_height = ui.text_style_height(&eframe::egui::TextStyle::Body) + 6.0;
    let lines = if picture.is_some() { 1.0 } else { 0.0 } + 1.0;
    let height = (ui.available_height() - text_height * lines * 1.3).max(80.0);
    if let Some(picture) = &picture {
        picture.plot_ui(ui, view.words, record, height);
        ui.label(circle_text(view.words, record));
    }
    quiet(ui, remarks);
}

/// Whether contacts are known, so that there is something to draw.
pub(super) fn has_picture(view: &View<'_>) -> bool {
    view.session.check().shown.as_ref().is_some_and(|shown| !shown.record.measurement.contacts.is_empty())
}

/// What the measurement cannot tell.
pub(super) fn remarks_ui(ui: &mut Ui, view: &View<'_>) {
    if let Some(shown) = view.session.check().shown.as_ref() {
        quiet(ui, remarks(view.words, &shown.record));
    }
}

fn circle_text(words: &Words, record: &Record) -> String {
    let mut text = format!("Ø {}", Digits::of(record).mm(words, record.measurement.diameter, 4));
    if let Some(position) = record.verdict.position {
        let [x, y] = position.axes.map(|axis| words.number(&signed_mm(axis.deviation)));
        text = format!("{text}   {}", words.say(&message!("centre-is").text("x", x).text("y", y)));
    }
    text
}

/// A deviation in millimetres with four decimals. What they show as zero has no sign.
fn signed_mm(deviation: Length) -> String {
    let text = deviation.rounded(Unit::Millimetre, 4);
    let is_zero = !text.contains(|c: char| ('1'..='9').contains(&c));
    if Length::ZERO < deviation && !is_zero { format!("+{text}") } else { text }
}

fn remarks(words: &Words, record: &Record) -> String {
    let said: Vec<String> = record.caveats().iter().map(|caveat| words.say(&caveat.message())).collect();
    said.join("; ")
}

/// The picture in units of the nominal radius, deviations magnified by `factor`.
#[derive(Debug, Clone, PartialEq)]
struct Picture {
    factor: f64,
    /// Contacts in probing order.
    contacts: Vec<[f64; 2]>,
    /// The fitted circle as the magnification distorts it.
    fitted: Vec<[f64; 2]>,
    /// The fitted centre.
    centre: [f64; 2],
}

impl Picture {
    fn of(record: &Record) -> Option<Self> {
        let circle = record.measurement.circle?;
        let radius = record.limits.nominal.to_mm_f64() / 2.0;
        if radius <= 0.0 || record.measurement.contacts.is_empty() {
            return None;
        }
        // The position's deviation gives the nominal centre; without a position, it is the fitted centre.
        let off =
            record.verdict.position.map_or([0.0; 2], |position| position.axes.map(|axis| axis.deviation.to_mm_f64()));
        let nominal = [circle.x - off[0], circle.y - off[1]];
        let polar: Vec<(f64, f64)> = record
            .measurement
            .contacts
            .iter()
            .map(|contact| {
                let x = contact.x - nominal[0];
                let y = contact.y - nominal[1];
                (libm::atan2(y, x), libm::hypot(x, y) - radius)
            })
            .collect();
        let largest = polar.iter().map(|(_, deviation)| deviation.abs()).fold(0.0, f64::max);
        let factor = magnification(REACH * radius, largest.max(libm::hypot(off[0], off[1])));
        let at = |(angle, deviation): (f64, f64)| {
            let length = 1.0 + deviation * factor / radius;
            [length * libm::cos(angle), length * libm::sin(angle)]
        };
        let fitted = (0..=STEPS).map(|step| {
            let angle = TAU * f64::from(step) / f64::from(STEPS);
            // Where a ray from the nominal centre meets the fitted circle.
            let along = off[0] * libm::cos(angle) + off[1] * libm::sin(angle);
            let across = off[1] * libm::cos(angle) - off[0] * libm::sin(angle);
            let half = (circle.diameter * circle.diameter / 4.0 - across * across).max(0.0).sqrt();
            at((angle, along + half - radius))
        });
        Some(Self {
            factor,
            fitted: fitted.collect(),
            contacts: polar.into_iter().map(at).collect(),
            centre: off.map(|off| off * factor / radius),
        })
    }

    /// How far out the drawing goes.
    fn reach(&self) -> f64 {
        let lengths = self.contacts.iter().chain(&self.fitted).map(|[x, y]| libm::hypot(*x, *y));
        lengths.fold(1.0, f64::max)
    }

    fn plot_ui(&self, ui: &mut Ui, words: &Words, record: &Record, height: f32) {
        let palette = palette(ui.ctx());
        let nominal: Vec<[f64; 2]> = (0..=STEPS)
            .map(|step| libm::sincos(TAU * f64::from(step) / f64::from(STEPS)))
            .map(|(sin, cos)| [cos, sin])
            .collect();
        let labels: Vec<_> = (1..)
            .zip(deviations(record))
            .take_while(|_| self.contacts.len() <= MOST_NUMBERS)
            .map(|(number, um)| format!("{number}  {} µm", words.number(&um)))
            .map(|text| ui.painter().layout_no_wrap(text, theme::font(sizes().small), palette.text.0))
            .collect();
        let widest = labels.iter().map(|label| label.size().x).fold(0.0, f32::max);
        // In a low picture all labels stand left or right of their contacts, and the circle keeps the height.
        let is_low = height < ui.available_width();
        let above = if is_low { sizes().small } else { sizes().small + BESIDE + 8.0 };
        let [x, y] = [(ui.available_width(), widest + BESIDE + 6.0), (height, above)]
            .map(|(room, label)| self.reach() / (1.0 - 2.0 * f64::from(label) / f64::from(room.max(1.0))).max(LEAST));
        let response = still_plot("contacts", height)
            .data_aspect(1.0)
            .show_axes(false)
            .include_x(-x)
            .include_x(x)
            .include_y(-y)
            .include_y(y)
            .show(ui, |plot| {
                let line = |name: &str, points: &[[f64; 2]]| {
                    Line::new(name, PlotPoints::from(points.to_vec())).allow_hover(false)
                };
                plot.line(line("nominal", &nominal).color(palette.quiet.0).width(1.5).style(LineStyle::dashed_loose()));
                plot.line(line("fitted", &self.fitted).color(palette.data.0).width(2.0));
                for axis in [[[-0.06, 0.0], [0.06, 0.0]], [[0.0, -0.06], [0.0, 0.06]]] {
                    plot.line(line("nominal centre", &axis).color(palette.quiet.0).width(1.0));
                }
                plot.points(
                    Points::new("centre", vec![self.centre])
                        .shape(MarkerShape::Cross)
                        .radius(6.0)
                        .color(palette.data.0),
                );
                plot.points(Points::new("contacts", self.contacts.clone()).radius(5.0).color(palette.text.0));
            });
        let painter = ui.painter().with_clip_rect(response.response.rect);
        for ([x, y], galley) in self.contacts.iter().zip(labels) {
            let at = response.transform.position_from_point(&PlotPoint::new(*x, *y));
            // The number is beside the contact, outside the circle.
            let side = |part: f64, before, after| match part / libm::hypot(*x, *y) {
                part if part < -0.38 => before,
                part if 0.38 < part => after,
                _ => Align::Center,
            };
            let (anchor, out) = if is_low {
                let (align, aside) = if *x < -0.1 { (Align::Max, -BESIDE) } else { (Align::Min, BESIDE) };
                (Align2([align, Align::Center]), vec2(aside, 0.0))
            } else {
                let out = vec2(screen(*x), -screen(*y)).normalized() * BESIDE;
                (Align2([side(*x, Align::Max, Align::Min), side(*y, Align::Min, Align::Max)]), out)
            };
            let rect = anchor.anchor_size(at + out, galley.size());
            painter.rect_filled(rect.expand(2.0), 2.0, palette.surface.0);
            painter.rect_stroke(
                rect.expand(2.0),
                2.0,
                Stroke::new(1.0, palette.line.0),
                eframe::egui::StrokeKind::Outside,
            );
            painter.galley(rect.min, galley, palette.text.0);
        }
        let described = message!("contacts-describe")
            .count("count", record.measurement.contacts.len())
            .text("factor", words.number(&format!("{}", self.factor)))
            .text("circle", circle_text(words, record));
        let described = words.say(&described);
        spoken::picture(ui, &response.response, words.get("contacts"), described);
    }
}

/// The radial deviation of every contact from the fitted circle in µm, one decimal, with its sign.
fn deviations(record: &Record) -> Vec<String> {
    let Some(circle) = record.measurement.circle else { return Vec::new() };
    let deviation = |contact: &crate::probing::Contact| {
        let radius = libm::hypot(contact.x - circle.x, contact.y - circle.y);
        let um = (radius - circle.diameter / 2.0) * 1000.0;
        let text = format!("{um:+.1}");
        if text == "+0.0" || text == "-0.0" { "0.0".to_owned() } else { text }
    };
    record.measurement.contacts.iter().map(deviation).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_deviation_has_a_sign_where_a_digit_shows() {
        for (mm, shown) in [
            ("0.00001", "0.0000"),
            ("-0.00001", "0.0000"),
            ("0", "0.0000"),
            ("0.00005", "+0.0001"),
            ("-0.00005", "-0.0001"),
            ("0.0123", "+0.0123"),
        ] {
            assert_eq!(signed_mm(mm.parse().unwrap()), shown, "{mm}");
        }
    }
}
