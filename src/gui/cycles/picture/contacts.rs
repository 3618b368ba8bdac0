//! The contacts of a measurement: about their circle with deviations magnified, or one deviation between its limits.

use std::f64::consts::TAU;

use eframe::egui::{Align, Align2, Painter, Pos2, Rect, Sense, Stroke, StrokeKind, Ui, Vec2, vec2};

use super::bar;
use super::canvas::Canvas;
use super::criteria::plain;
use crate::gui::shapes::screen;
use crate::gui::spoken;
use crate::gui::theme::{self, Palette, palette, sizes, space};
use crate::gui::view::View;
use crate::message::message;
use crate::probing::Contact;
use crate::probing::circle::{Circle, Evaluation};
use crate::probing::cycle::{CircleFound, CycleResult, ResultName, Value};
use crate::words::Words;

/// How far the largest deviation reaches, as a share of the radius.
const REACH: f64 = 0.3;

/// Deviations below 0.1 µm are not worth a larger picture.
const NOT_WORTH_MM: f64 = 1e-4;

/// From a contact to its label.
const OUT: f32 = 15.0;

/// The same where the label is only a number.
const OUT_ALONE: f32 = 10.0;

/// Between deviations in one line.
const BETWEEN: &str = "     ";

/// Beyond this many contacts their numbers would hide the picture.
const MOST_NUMBERS: usize = 16;

/// Points on a drawn circle.
const STEPS: u16 = 144;

/// The contacts around their circle; for a cycle without a circle its first value between its limits.
///
/// The evaluation, where there is one, is that of the result's contacts in their plane.
pub(in crate::gui) fn contacts_picture(
    ui: &mut Ui,
    view: &View<'_>,
    result: &CycleResult,
    evaluation: Option<&Evaluation>,
) {
    let contacts = result.plane_contacts();
    let picture = result.circle.as_ref().and_then(|found| Picture::of(found, nominal(result), &contacts, evaluation));
    let Some(picture) = picture else { return bar::ui(ui, view, result) };
    // Labels and legend above and below the circle take height of their own.
    let most = (ui.available_width() * 1.1).max(space(40.0));
    let size = vec2(ui.available_width(), ui.available_height().clamp(space(40.0), most));
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    let factor = factor_text(view.words, picture.factor);
    if ui.is_rect_visible(rect) {
        let canvas = Canvas::new(ui.painter(), palette(ui.ctx()), rect);
        Drawing::new(&canvas, rect, &picture, view.words).draw();
    }
    let said = describe(view.words, &picture, &factor);
    spoken::picture_named(&response, said);
}

/// How much the picture magnifies deviations, in words; `None` where it has no circle.
pub(in crate::gui) fn contacts_factor(
    view: &View<'_>,
    result: &CycleResult,
    evaluation: Option<&Evaluation>,
) -> Option<String> {
    let found = result.circle.as_ref()?;
    let picture = Picture::of(found, nominal(result), &result.plane_contacts(), evaluation)?;
    Some(factor_text(view.words, picture.factor))
}

/// The nominal diameter in millimetres: the measured one minus its deviation, where the cycle gives it.
fn nominal(result: &CycleResult) -> Option<f64> {
    let diameter = result.circle.as_ref()?.diameter;
    let deviation = result.results.iter().find(|found| found.name == ResultName::DIAMETER_DEVIATION)?;
    let Value::Length(deviation) = deviation.value else { return None };
    Some(diameter.saturating_sub(deviation).to_mm_f64())
}

fn factor_text(words: &Words, factor: f64) -> String {
    words.say(&message!("contacts-factor").text("factor", words.number(&format!("{factor}"))))
}

fn describe(words: &Words, picture: &Picture, factor: &str) -> String {
    let residuals: Vec<_> =
        picture.residuals.iter().zip(1..=MOST_NUMBERS).map(|(um, number)| numbered(words, number, *um)).collect();
    let message = message!("cycle-picture-contacts")
        .count("count", picture.contacts.len())
        .text("diameter", words.number(&plain(picture.diameter, 4)))
        .text("factor", factor)
        .text("residuals", residuals.join("; "));
    let said = words.say(&message);
    match picture.nominal {
        Some(nominal) => {
            let nominal = message!("cycle-picture-nominal").text("diameter", words.number(&plain(nominal, 4)));
            format!("{said} {}", words.say(&nominal))
        }
        None => said,
    }
}

fn numbered(words: &Words, number: usize, residual_mm: f64) -> String {
    let um = residual_mm * 1000.0;
    let text = plain(um, 1);
    let plus = if 0.0 < um && text.bytes().any(|byte| (b'1'..=b'9').contains(&byte)) { "+" } else { "" };
    format!("{number}  {plus}{} µm", words.number(&text))
}

/// The picture in units of the radius, deviations magnified by `factor`.
#[derive(Debug, Clone, PartialEq)]
struct Picture {
    factor: f64,
    diameter: f64,
    nominal: Option<f64>,
    contacts: Vec<[f64; 2]>,
    /// Where the fitted circle is in the direction of each contact.
    feet: Vec<[f64; 2]>,
    /// Radial deviations from the fitted circle, mm.
    residuals: Vec<f64>,
    fitted: Vec<[f64; 2]>,
    centre: [f64; 2],
}

impl Picture {
    fn of(
        found: &CircleFound,
        nominal: Option<f64>,
        contacts: &[Contact],
        evaluation: Option<&Evaluation>,
    ) -> Option<Self> {
        let circle = found.circle;
        let nominal = nominal.filter(|diameter| 0.0 < *diameter);
        let radius = nominal.unwrap_or(circle.diameter) / 2.0;
        let off = found.position.axes.map(|axis| axis.deviation.to_mm_f64());
        let [off_x, off_y] = off;
        let is_sound = 0.0 < radius && [circle.x, circle.y, radius].iter().all(|value| value.is_finite());
        if !is_sound || contacts.is_empty() {
            return None;
        }
        let polar: Vec<(f64, f64)> = contacts
            .iter()
            .map(|contact| {
                let x = contact.x - circle.x + off_x;
                let y = contact.y - circle.y + off_y;
                (libm::atan2(y, x), libm::hypot(x, y) - radius)
            })
            .collect();
        let largest = polar.iter().map(|(_, deviation)| deviation.abs()).fold(NOT_WORTH_MM, f64::max);
        let factor = crate::gui::shapes::magnification(REACH * radius, largest.max(libm::hypot(off_x, off_y)));
        let at = |(angle, deviation): (f64, f64)| {
            let length = (1.0 + deviation * factor / radius).max(0.0);
            [length * libm::cos(angle), length * libm::sin(angle)]
        };
        let on_fitted = |angle: f64| at((angle, ray(&circle, off, angle) - radius));
        let given = evaluation.map(|evaluation| evaluation.residuals.clone());
        let residual =
            |contact: &Contact| libm::hypot(contact.x - circle.x, contact.y - circle.y) - circle.diameter / 2.0;
        Some(Self {
            factor,
            diameter: circle.diameter,
            nominal,
            feet: polar.iter().map(|(angle, _)| on_fitted(*angle)).collect(),
            fitted: (0..=STEPS).map(|step| on_fitted(TAU * f64::from(step) / f64::from(STEPS))).collect(),
            contacts: polar.into_iter().map(at).collect(),
            residuals: given
                .filter(|residuals| residuals.len() == contacts.len())
                .unwrap_or_else(|| contacts.iter().map(residual).collect()),
            centre: off.map(|off| off * factor / radius),
        })
    }
}

impl Picture {
    /// How far out the drawing goes.
    fn reach(&self) -> f64 {
        let lengths = self.contacts.iter().chain(&self.fitted).map(|[x, y]| libm::hypot(*x, *y));
        lengths.fold(1.0, f64::max)
    }
}

/// How far a ray from the nominal centre goes until it meets the fitted circle.
fn ray(circle: &Circle, [off_x, off_y]: [f64; 2], angle: f64) -> f64 {
    let (sin, cos) = libm::sincos(angle);
    let along = off_x * cos + off_y * sin;
    let across = off_y * cos - off_x * sin;
    along + (circle.diameter * circle.diameter / 4.0 - across * across).max(0.0).sqrt()
}

struct Drawing<'a> {
    canvas: &'a Canvas<'a>,
    picture: &'a Picture,
    words: &'a Words,
    /// What stands beside each contact.
    labels: Vec<String>,
    /// From a contact to what stands beside it.
    out: f32,
    /// Where the circle and the labels are.
    room: Rect,
    /// The radius of the nominal circle.
    unit: f32,
}

impl<'a> Drawing<'a> {
    /// Beside each contact its number and deviation; where that leaves the circle little room, the number alone, and the
    /// deviations in lines below the circle.
    fn new(canvas: &'a Canvas<'a>, body: Rect, picture: &'a Picture, words: &'a Words) -> Self {
        let contacts = 1..=picture.residuals.len();
        let whole = contacts.clone().zip(&picture.residuals).map(|(number, mm)| numbered(words, number, *mm));
        let whole: Vec<_> = whole.collect();
        let size = |text: &str, width: f32| {
            let font = theme::font(sizes().small);
            canvas.painter.layout(text.to_owned(), font, canvas.palette.text.0, width).size()
        };
        // Labels stand left and right of the circle, and above and below it.
        let unit = |room: Rect, widest: f32, out: f32| {
            let around = vec2(widest + out + space(1.0), sizes().small + out + space(0.5)) * 2.0;
            (room.size() - around).min_elem().max(space(8.0)) / 2.0 / screen(picture.reach())
        };
        let widest = whole.iter().map(|text| size(text, f32::INFINITY).x).fold(0.0, f32::max);
        let legend = legend_height(picture);
        // The circle is in the middle; the words in the corner stay beside its labels, or get a room of their own.
        let words_end = legend_width(canvas, words);
        let above =
            if words_end < (body.width() - widest) / 2.0 { body } else { body.with_max_y(body.bottom() - legend) };
        let beside = unit(above, widest, OUT);
        let lines = size(&whole.join(BETWEEN), body.width()).y;
        let below = body.with_max_y(body.bottom() - lines - legend - space(1.0));
        let alone = unit(below, size("8", f32::INFINITY).x, OUT_ALONE);
        if whole.len() <= MOST_NUMBERS && beside < alone {
            canvas.wrapped(below.left_bottom(), &whole.join(BETWEEN), body.width());
            let labels = contacts.map(|number| number.to_string()).collect();
            return Self { canvas, picture, words, labels, out: OUT_ALONE, room: below, unit: alone };
        }
        Self { canvas, picture, words, labels: whole, out: OUT, room: above, unit: beside }
    }

    fn at(&self, [x, y]: [f64; 2]) -> Pos2 {
        self.room.center() + vec2(screen(x), -screen(y)) * self.unit
    }

    fn draw(&self) {
        let palette = self.canvas.palette;
        let nominal: Vec<Pos2> = (0..=STEPS)
            .map(|step| libm::sincos(TAU * f64::from(step) / f64::from(STEPS)))
            .map(|(sin, cos)| self.at([cos, sin]))
            .collect();
        let dashed = Stroke::new(1.5, palette.quiet.0);
        self.canvas.dashed(&nominal, dashed, 6.0, 4.0);
        self.canvas.cross(self.at([0.0; 2]), 6.0, self.canvas.thin());
        self.canvas.polyline(self.picture.fitted.iter().map(|place| self.at(*place)).collect(), self.canvas.strong());
        let centre = self.at(self.picture.centre);
        for across in [vec2(5.0, 5.0), vec2(5.0, -5.0)] {
            self.canvas.line(centre - across, centre + across, self.canvas.strong());
        }
        for (contact, foot) in self.picture.contacts.iter().zip(&self.picture.feet) {
            self.canvas.line(self.at(*foot), self.at(*contact), self.canvas.edge());
            self.canvas.circle(self.at(*contact), 4.5, palette.text.0, Stroke::new(1.0, palette.surface.0));
        }
        if self.picture.contacts.len() <= MOST_NUMBERS {
            self.numbers();
        }
        self.legend();
    }

    /// Every contact's number and deviation beside it, outside the circle.
    fn numbers(&self) {
        let mut taken: Vec<Rect> = Vec::new();
        for (contact, text) in self.picture.contacts.iter().zip(&self.labels) {
            let place = self.at(*contact);
            let out = (place - self.at([0.0; 2])).normalized();
            let side = |part: f32, before, after| match part {
                part if part < -0.38 => before,
                part if 0.38 < part => after,
                _ => Align::Center,
            };
            let anchor = Align2([side(out.x, Align::Max, Align::Min), side(out.y, Align::Max, Align::Min)]);
            let rect = free(&taken, label_rect(&self.canvas.painter, place + out * self.out, anchor, text));
            taken.push(label(self.canvas, rect, text));
        }
    }

    /// Which circle is which, in the corners below.
    fn legend(&self) {
        let mut at = self.canvas.rect.left_bottom() - vec2(0.0, sizes().small * 0.5 + 2.0);
        for (id, is_fitted) in LEGEND {
            if !is_fitted && self.picture.nominal.is_none() {
                continue;
            }
            let line = [at, at + vec2(space(6.0), 0.0)];
            if is_fitted {
                self.canvas.polyline(line.to_vec(), self.canvas.strong());
            } else {
                self.canvas.dashed(&line, Stroke::new(1.5, self.canvas.palette.quiet.0), 6.0, 4.0);
            }
            self.canvas.note(at + vec2(space(7.0), 0.0), Align2::LEFT_CENTER, &self.words.get(id));
            at.y -= legend_line();
        }
    }
}

/// Which circle is which: the name's text, and whether it is the fitted one.
const LEGEND: [(&str, bool); 2] = [("cycle-picture-legend-fitted", true), ("cycle-picture-legend-nominal", false)];

/// How far the words of the legend reach.
fn legend_width(canvas: &Canvas<'_>, words: &Words) -> f32 {
    let width = |(id, _): (&str, bool)| {
        let font = theme::font(sizes().small);
        let colour = canvas.palette.quiet.0;
        canvas.painter.layout_no_wrap(words.get(id), font, colour).size().x
    };
    space(9.0) + LEGEND.map(width).into_iter().fold(0.0, f32::max)
}

fn legend_line() -> f32 {
    sizes().small + space(1.0)
}

/// The height of the lines that say which circle is which.
fn legend_height(picture: &Picture) -> f32 {
    legend_line() * if picture.nominal.is_some() { 2.0 } else { 1.0 }
}

fn label_rect(painter: &Painter, at: Pos2, anchor: Align2, text: &str) -> Rect {
    let galley =
        painter.layout_no_wrap(text.to_owned(), theme::font(sizes().small), eframe::egui::Color32::PLACEHOLDER);
    anchor.anchor_size(at, galley.size())
}

/// The place of a label, moved down or up where another label is already.
fn free(taken: &[Rect], wanted: Rect) -> Rect {
    let is_free = |rect: &Rect| taken.iter().all(|other| !other.expand(2.0).intersects(*rect));
    let step = wanted.height() + 4.0;
    let shifts = [0.0, 1.0, -1.0, 2.0, -2.0, 3.0, -3.0];
    let places = shifts.into_iter().map(|shift| wanted.translate(Vec2::new(0.0, shift * step)));
    places.into_iter().find(is_free).unwrap_or(wanted)
}

fn label(canvas: &Canvas<'_>, rect: Rect, text: &str) -> Rect {
    let palette: &Palette = canvas.palette;
    let font = theme::font(sizes().small);
    let rect = canvas.label(rect.min, Align2::LEFT_TOP, text, font, palette.text.0);
    let edge = Stroke::new(1.0, palette.line.0);
    canvas.painter.rect_stroke(rect.expand2(vec2(3.0, 0.0)), 2.0, edge, StrokeKind::Outside);
    rect
}
