//! Left: before a part its plan and serial number, then the size that is asked for and the field of its value.

use eframe::egui::{Align, Button, Color32, Frame, Key, Label, Layout, Margin, RichText, Sense, Ui, vec2};

use super::asked_text;
use super::sizes_list::numbered;
use super::skip_panel::skip_ui;
use crate::gui::field::{FieldStyle, error_ui, field_ui, keypad_button_ui, value_field_ui};
use crate::gui::limits::limits_ui;
use crate::gui::over_page::just_opened;
use crate::gui::room::{is_low, is_tiny};
use crate::gui::theme::{self, Icon, Weight, control, palette, sizes, space};
use crate::gui::view::{Digits, View, heading, problem, quiet, steady};
use crate::message::message;
use crate::part::{Plan, Size};
use crate::session::help::Sample;
use crate::session::{FilesCommand, PartsAction, Purpose, WalkField, WindowAction};

/// The panel's content.
pub(super) fn asked_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.spacing_mut().item_spacing.y = space(1.0);
    let session = view.session;
    let walking = &session.parts().walking;
    let Some(plan) = walking.plan.as_ref() else { return begin_ui(ui, view) };
    if session.parts().asks_which_plan() {
        other_plan_ui(ui, view);
    }
    part_ui(ui, view, plan);
    ui.separator();
    // Nothing else is asked until that is answered: the buttons come back in their places.
    if let (Some(size), true) = (walking.asked(), walking.is_skipping) {
        name_ui(ui, view, &size, walking.at);
        return skip_ui(ui, view);
    }
    if let (Some(asked), Some(faced)) = (walking.asked(), walking.faced_size()) {
        size_ui(ui, view, &faced);
        value_ui(ui, view, &faced, &asked);
        steady(ui, "walk-actions", |ui| {
            ui.horizontal_wrapped(|ui| {
                for action in [PartsAction::SizeAgain, PartsAction::SimulateValue] {
                    view.field_button(ui, action);
                }
            });
        });
    } else {
        heading(ui, view.text("walk-page-done"));
        next_ui(ui, view);
        view.field_button(ui, PartsAction::SizeAgain);
    }
    if walking.is_warned && !session.parts().asks_which_plan() {
        let missing = walking.standing().missing;
        problem(ui, view.words.say(&message!("walk-page-next-warned").count("count", missing)));
    }
}

/// Once nothing is open, the next part is the main thing to do. The button gets the focus, but never from an Enter that is still held.
fn next_ui(ui: &mut Ui, view: &mut View<'_>) {
    let size = vec2(ui.available_width(), control(ui));
    let button =
        steady(ui, "walk-next", |ui| ui.horizontal(|ui| view.main_button(ui, PartsAction::NextPart, size)).inner);
    let wants = button.id.with("wants");
    if just_opened(ui, button.id.with("shown")) {
        ui.data_mut(|data| data.insert_temp(wants, true));
    }
    let is_held = ui.input(|input| input.key_down(Key::Enter));
    if !is_held && ui.data_mut(|data| std::mem::take(data.get_temp_mut_or_default::<bool>(wants))) {
        button.request_focus();
    }
}

/// Before a part: which plan, and which serial number.
fn begin_ui(ui: &mut Ui, view: &mut View<'_>) {
    let session = view.session;
    let document = &session.parts().document;
    let Some(plan) = document.plan() else {
        if document.is_empty() || document.is_blank() {
            quiet(ui, view.text("walk-page-no-plan"));
            view.field_button(ui, WindowAction::OpenSample(Sample::Part));
            view.field_button(ui, PartsAction::NewPlan);
        } else {
            let count = document.faults();
            problem(ui, view.words.say(&message!("walk-page-plan-wrong").count("count", count)));
        }
        return recent_ui(ui, view);
    };
    let part = &plan.head.part;
    heading(ui, if part.is_empty() { document.name() } else { part.clone() });
    if document.path().is_none() || document.is_unsaved() {
        quiet(ui, view.text("walk-page-not-saved"));
        view.field_button(ui, PartsAction::SavePlan(0));
    }
    let name = heading(ui, view.text("walk-page-serial"));
    let width = ui.available_width();
    field_ui(ui, view, WalkField::Serial, name.id, FieldStyle::large(width));
    error_ui(ui, view, WalkField::Serial);
    quiet(ui, view.text("walk-page-serial-hint"));
    ui.horizontal_wrapped(|ui| {
        let size = vec2(view.width_of(ui, &[PartsAction::BeginPart]), control(ui));
        view.main_button(ui, PartsAction::BeginPart, size);
        view.field_button(ui, PartsAction::CountUp);
        view.toggle(ui, WindowAction::Keypad);
    });
    recent_ui(ui, view);
}

/// The plans that were read last.
fn recent_ui(ui: &mut Ui, view: &mut View<'_>) {
    let session = view.session;
    let plans: Vec<_> = session.recent_of(Purpose::OpenPlan).collect();
    if plans.is_empty() {
        return;
    }
    ui.add_space(space(2.0));
    heading(ui, view.text("walk-page-recent"));
    for (number, path) in plans {
        let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
        let button = Button::new(name).min_size(vec2(0.0, control(ui)));
        if ui.add(button).on_hover_text(path.display().to_string()).clicked() {
            view.send(FilesCommand::OpenRecent(number));
        }
    }
}

/// Another plan was opened while this part is not finished: nobody types a value of the one into the other.
fn other_plan_ui(ui: &mut Ui, view: &mut View<'_>) {
    let palette = palette(ui.ctx());
    let [own, open] = view.session.parts().both_plans();
    let frame = Frame::new().fill(palette.tint.0).corner_radius(12.0).inner_margin(Margin::same(12));
    frame.show(ui, |ui| {
        ui.set_min_width(ui.available_width());
        heading(ui, view.words.say(&message!("walk-page-part-of").text("own", own)));
        ui.label(view.words.say(&message!("walk-page-open-is").text("open", open)));
        ui.horizontal_wrapped(|ui| {
            view.field_button(ui, PartsAction::BeginByOpenPlan);
            view.field_button(ui, PartsAction::KeepMeasuring);
        });
        let walking = &view.session.parts().walking;
        if walking.is_warned {
            let missing = walking.standing().missing;
            problem(ui, view.words.say(&message!("walk-page-begin-warned").count("count", missing)));
        }
    });
}

fn part_ui(ui: &mut Ui, view: &View<'_>, plan: &Plan) {
    let walking = &view.session.parts().walking;
    let part = &plan.head.part;
    let message = match (part.is_empty(), walking.serial().is_empty()) {
        (true, true) => message!("walk-page-no-serial"),
        (false, true) => message!("walk-page-part-no-serial").text("part", part),
        (true, false) => message!("walk-page-part-serial").text("serial", walking.serial()),
        (false, false) => message!("walk-page-part").text("part", part).text("serial", walking.serial()),
    };
    heading(ui, view.words.say(&message));
    let parts = view.session.parts();
    if parts.is_other_open() {
        // Until it is answered which plan comes next, that stands above.
        if !parts.asks_which_plan() {
            let [own, _] = parts.both_plans();
            quiet(ui, view.words.say(&message!("walk-page-by-plan").text("name", own)));
        }
    } else if parts.has_other_plan() {
        quiet(ui, view.text("walk-page-other-plan"));
    }
}

/// The size that the page is about, readable from afar.
fn size_ui(ui: &mut Ui, view: &View<'_>, size: &Size<'_>) {
    let feature = size.feature;
    name_ui(ui, view, size, view.session.parts().walking.faced());
    limits_ui(ui, view, size.limits);
    match feature.place {
        Some(place) => {
            let [x, y, z] = place.map(|mm| view.words.mm(mm, 0));
            let message = message!("walk-page-place").text("x", x).text("y", y).text("z", z);
            ui.label(RichText::new(view.words.say(&message)).font(theme::bold(sizes().limits)));
        }
        None => _ = quiet(ui, view.text("walk-page-no-place")),
    }
    if !feature.remark.is_empty() {
        ui.label(&feature.remark);
    }
}

/// Which size is asked for and by which callout, readable from afar; beside each other where both have room.
fn name_ui(ui: &mut Ui, view: &View<'_>, size: &Size<'_>, at: Option<usize>) {
    let walking = &view.session.parts().walking;
    let name = numbered(size);
    let asked = asked_text(view.words, size);
    let font = || theme::bold(sizes().figure);
    let width = |text: &str| ui.painter().layout_no_wrap(text.to_owned(), font(), Color32::PLACEHOLDER).size().x;
    let room = ui.available_width();
    let left = room - width(&asked);
    if width(&name) + space(3.0) <= left {
        ui.horizontal(|ui| {
            let from = ui.cursor().left();
            ui.label(RichText::new(name).font(font()));
            ui.add_space((from + left - ui.cursor().left()).max(0.0));
            ui.label(RichText::new(asked).font(font()));
        });
    } else {
        ui.label(RichText::new(name).font(font()));
        ui.label(RichText::new(asked).font(font()));
    }
    if let Some(at) = at {
        quiet(ui, view.words.say(&message!("walk-page-of").count("at", at + 1).count("count", walking.count())));
    }
}

/// What is wrong with the value; else what there is of the size already. The lines are there in any case: the buttons keep their places.
fn note_ui(ui: &mut Ui, view: &View<'_>) {
    let walking = &view.session.parts().walking;
    // The keypad leaves no room to spare.
    let lines = match (view.session.has_keypad(), is_low(ui)) {
        (true, _) => 0.0,
        (false, true) => 1.0,
        (false, false) => 2.0,
    };
    ui.vertical(|ui| {
        ui.spacing_mut().item_spacing.y = 0.0;
        ui.set_min_height(lines * space(5.0));
        error_ui(ui, view, WalkField::Value);
        // While the verdict of another size stands beside it, nothing is said here of the next one.
        let is_of_it = |at: &usize| walking.faced() == Some(*at) && view.session.error(WalkField::Value).is_none();
        let Some(at) = walking.at.filter(is_of_it) else { return };
        let count = walking.values(at).len();
        if 0 < count {
            quiet(ui, view.words.say(&message!("walk-page-measured-before").count("count", count)));
        }
        let reason = walking.with_row(at, |row| row.step.skipped.clone()).flatten();
        if let Some(reason) = reason {
            quiet(ui, view.words.say(&message!("walk-page-skipped").text("reason", reason)));
        }
    });
}

/// The size that the next value is of, while the page is still about the one before. Before that the room of its lines is there already:
/// nothing moves when the verdict comes.
fn next_size_ui(ui: &mut Ui, view: &View<'_>, asked: &Size<'_>) {
    let walking = &view.session.parts().walking;
    let is_shown = walking.faced() != walking.at;
    let size = sizes().limits;
    let palette = palette(ui.ctx());
    let left = size + ui.spacing().item_spacing.x;
    let width = ui.available_width() - left;
    let galley = |text| ui.painter().layout(text, theme::bold(size), palette.text.0, width);
    let line = galley("0".to_owned()).size().y;
    let text = if is_shown {
        next_text(view, asked)
    } else {
        let next = walking.at.and_then(|at| walking.walk.next(at + 1));
        let text = next.and_then(|at| walking.with_row(at, |row| next_text(view, row.size)));
        text.into_iter().collect()
    };
    let height = galley(text.clone()).size().y.max(line);
    let row = vec2(ui.available_width(), height);
    ui.allocate_ui_with_layout(row, Layout::left_to_right(Align::Min), |ui| {
        ui.set_min_size(row);
        if is_shown {
            let (rect, _) = ui.allocate_exact_size(vec2(size, line), Sense::hover());
            Icon::ArrowRight.paint(ui.painter(), rect.center(), Weight::Bold, size, palette.accent.0);
            ui.add(Label::new(RichText::new(text).font(theme::bold(size))).wrap());
        }
    });
}

/// Number, name and callout of the size that comes next.
fn next_text(view: &View<'_>, size: &Size<'_>) -> String {
    let number = &size.feature.number;
    let name = if number.is_empty() { size.name() } else { format!("{number} {}", size.name()) };
    let said = message!("walk-page-next-size").text("name", name);
    view.words.say(&said.text("asked", asked_text(view.words, size)))
}

/// The value that was judged last, as the field shows it until the next one is typed: heading, field and verdict are of one size.
fn judged_text(view: &View<'_>) -> String {
    let walking = &view.session.parts().walking;
    let judged = walking.faced_value().filter(|(at, _)| walking.at != Some(*at));
    judged.map_or_else(String::new, |(_, value)| {
        let record = &value.record;
        Digits::of(record).mm(view.words, record.measured(), 3)
    })
}

fn value_ui(ui: &mut Ui, view: &mut View<'_>, size: &Size<'_>, asked: &Size<'_>) {
    let row = ui.horizontal_wrapped(|ui| {
        let name = heading(ui, view.text("walk-page-value"));
        // What is asked for stands above, which is out of sight where there is no room.
        if is_tiny(ui) {
            ui.label(format!("{}, {}", size.name(), asked_text(view.words, size)));
        }
        name
    });
    let name = row.inner;
    let hint = RichText::new(judged_text(view)).color(palette(ui.ctx()).quiet.0);
    let look = FieldStyle { hint, ..FieldStyle::large(ui.available_width()) };
    let field = value_field_ui(ui, view, WalkField::Value, name.id, look);
    keypad_button_ui(ui, view, WalkField::Value, field);
    next_size_ui(ui, view, asked);
    note_ui(ui, view);
    steady(ui, "walk-value", |ui| {
        ui.horizontal(|ui| {
            let skip = view.width_of(ui, &[PartsAction::SkipSize]) + ui.spacing().item_spacing.x;
            let width = (ui.available_width() - skip).max(view.width_of(ui, &[PartsAction::TakeValue]));
            view.main_button(ui, PartsAction::TakeValue, vec2(width, control(ui)));
            view.field_button(ui, PartsAction::SkipSize);
        });
    });
}
