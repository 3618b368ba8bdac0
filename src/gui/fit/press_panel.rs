//! Right: what a press fit holds, its stresses, and how it is joined.

use eframe::egui::Ui;

use crate::gui::view::{View, heading, named_figures_ui, problem, quiet};
use crate::message::message;
use crate::session::FRICTION;
use crate::tolerance::fit::press::{PartStress, Press, Ratio, figure};

/// The press fit of the page, when its joint is given.
pub(super) fn press_ui(ui: &mut Ui, view: &View<'_>) {
    let Some(press) = view.session.fit().press() else { return };
    ui.separator();
    heading(ui, view.text("fit-press"));
    match press {
        Ok(press) => figures_ui(ui, view, press),
        Err(error) => _ = problem(ui, view.words.say(error)),
    }
}

/// What asks for a look comes before the figures, everything else behind them.
fn figures_ui(ui: &mut Ui, view: &View<'_>, press: &Press) {
    for remark in press.remarks.iter().filter(|remark| remark.stands_against()) {
        problem(ui, view.words.told(remark));
    }
    let number = |value: f64| view.words.number(&figure(value));
    let stress = |part: PartStress| match part.yield_strength {
        Some(limit) => format!("{} / {limit} MPa", number(part.equivalent)),
        None => format!("{} / ? MPa", number(part.equivalent)),
    };
    let pressure = match press.pressure {
        [Some(least), Some(most)] => Some(format!("{} … {} MPa", number(least), number(most))),
        _ => None,
    };
    let rows = [
        ("fit-press-pressure", pressure),
        ("fit-press-force", press.axial_force.map(|force| format!("{} N", number(force)))),
        ("fit-press-torque", press.torque.map(|torque| format!("{} N·m", number(torque)))),
        ("fit-press-pressing", press.pressing_force.map(|force| format!("{} N", number(force)))),
        ("fit-press-hub", Some(stress(press.hub))),
        ("fit-press-shaft", Some(stress(press.shaft))),
        ("fit-press-heat", press.heat_hub.map(|hot| format!("{} °C", number(hot)))),
        ("fit-press-cool", press.cool_shaft.map(|cold| format!("{} °C", number(cold)))),
    ];
    // What there is not is said, not left out.
    let rows = rows.map(|(name, value)| (view.text(name), value.unwrap_or_else(|| "–".to_owned())));
    named_figures_ui(ui, "press-figures", rows);
    if let Some(friction) = Ratio::from_thousandths(FRICTION) {
        quiet(ui, view.words.say(&message!("fit-press-friction").with("friction", &friction)));
    }
    for remark in press.remarks.iter().filter(|remark| !remark.stands_against()) {
        quiet(ui, view.words.told(remark));
    }
}
