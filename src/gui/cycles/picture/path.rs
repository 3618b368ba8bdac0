//! The path of the ball's centre, from above and from the side: what is done, what is to come, where the ball is.

use eframe::egui::{Align2, Rect, Sense, Ui, vec2};

use super::canvas::Canvas;
use super::criteria::plain;
use super::scale::{Scale, legend};
use super::way::{Eye, System, Way, phase_id, place};
use super::{part, system};
use crate::gui::spoken;
use crate::gui::theme::{palette, space};
use crate::gui::view::View;
use crate::message::message;
use crate::probing::cycle::{Move, Phase};
use crate::probing::simulated::{PartFeature, Surface};
use crate::words::Words;

/// What is drawn with a path.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::gui) struct Surroundings<'a> {
    /// The surface that the cycle expects.
    pub nominal: Option<Surface>,
    /// The features of a part: they take the place of that surface.
    pub features: &'a [PartFeature],
    /// The ball to scale, mm; 0 where contacts are points of the surface.
    pub ball_radius: f64,
    /// The zero and the axes that the program counts in, where a block has set them.
    pub system: Option<System>,
}

impl Surroundings<'_> {
    /// The surface that a cycle expects, and the ball.
    pub fn of(nominal: Option<Surface>, ball_radius: f64) -> Self {
        Self { nominal, ball_radius, ..Self::default() }
    }
}

/// The path of the probe after `step` moves (0 to their number).
pub(in crate::gui) fn path_picture(ui: &mut Ui, view: &View<'_>, path: &[Move], step: usize, around: Surroundings<'_>) {
    let moves: Vec<Move> = path.iter().copied().filter(is_finite).collect();
    // Moves that cannot be drawn are left out; the step counts only those that can.
    let step = path.iter().take(step).filter(|one| is_finite(one)).count();
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), height(ui)), Sense::hover());
    if ui.is_rect_visible(rect) {
        let canvas = Canvas::new(ui.painter(), palette(ui.ctx()), rect);
        let Surroundings { nominal, features, ball_radius, system } = around;
        let way = Way { moves: &moves, step, nominal, features, ball_radius: ball_radius.abs().min(1e6), system };
        draw(&canvas, &way, view.words);
    }
    let said = [describe(view.words, &moves, step), describe_part(view.words, around.features)].concat();
    spoken::picture_named(&response, said);
}

/// The height that there is room for; in a list that scrolls, three quarters of the width.
pub(super) fn height(ui: &Ui) -> f32 {
    let most = (ui.available_width() * 0.75).max(space(40.0));
    ui.available_height().clamp(space(40.0), most)
}

fn is_finite(one: &Move) -> bool {
    one.from.iter().chain(&one.to).chain(one.about.iter().flatten()).all(|value| value.abs() < 1e9)
}

/// The features of a part by name, the first ones of many.
fn describe_part(words: &Words, features: &[PartFeature]) -> String {
    const MOST: usize = 20;
    if features.is_empty() {
        return String::new();
    }
    let mut names: Vec<&str> = features.iter().take(MOST).map(|feature| feature.name.as_str()).collect();
    if MOST < features.len() {
        names.push("…");
    }
    let message = message!("cycle-picture-part").count("count", features.len()).text("names", names.join(", "));
    format!(" {}", words.say(&message))
}

fn describe(words: &Words, moves: &[Move], step: usize) -> String {
    let Some(at) = place(moves, step) else { return words.get("cycle-picture-no-path") };
    let [x, y, z] = at.map(|value| words.number(&plain(value, 3)));
    let contacts = moves.iter().filter(|one| one.phase == Phase::Contact).count();
    let message = message!("cycle-picture-path").text("step", step).text("moves", moves.len());
    let said = words.say(&message.count("contacts", contacts).text("x", x).text("y", y).text("z", z));
    let Some(now) = step.checked_sub(1).and_then(|last| moves.get(last)) else { return said };
    let phase = words.get(phase_id(now.phase));
    match now.touch {
        Some(touch) => {
            let now = message!("cycle-picture-path-touch").text("phase", phase).text("touch", touch);
            format!("{said} {}", words.say(&now))
        }
        None => format!("{said} {phase}"),
    }
}

fn draw(canvas: &Canvas<'_>, way: &Way<'_>, words: &Words) {
    let below = legend(canvas, canvas.rect, words);
    let body = Rect::from_min_max(canvas.rect.min, canvas.rect.max - vec2(0.0, below));
    if way.moves.is_empty() && way.features.is_empty() {
        canvas.note(body.center(), Align2::CENTER_CENTER, &words.get("cycle-picture-no-path"));
        return;
    }
    let gap = space(2.0);
    let (above, side) = if body.height() * 1.15 < body.width() {
        let (left, right) = body.split_left_right_at_fraction(0.58);
        (left.with_max_x(left.right() - gap), right.with_min_x(right.left() + gap))
    } else {
        let (top, bottom) = body.split_top_bottom_at_fraction(0.6);
        (top.with_max_y(top.bottom() - gap), bottom.with_min_y(bottom.top() + gap))
    };
    let beside = if way.features.is_empty() { Eye::beside(way.nominal) } else { Eye::Side };
    for (eye, rect) in [(Eye::Above, above), (beside, side)] {
        let scale = Scale::of(way, eye, rect);
        scale.view(canvas, way, words, part::draw);
        system::draw(canvas, &scale, way);
    }
}
