//! Right, below: the status window, as the control's pop-up prints it.

use eframe::egui::{Color32, ComboBox, Ui};

use crate::gui::popup::{self, popup_ui};
use crate::gui::theme::{control, font, sizes, space};
use crate::gui::view::{Digits, View, caret_ui, quiet};
use crate::journal::Record;
use crate::length::Length;
use crate::message::message;
use crate::session::{CheckAction, Command, MaskChoice, Purpose};
use crate::words::{Dialogue, Words};

/// The pop-up and what can be done with it.
pub(super) fn status_ui(ui: &mut Ui, view: &mut View<'_>) {
    window_ui(ui, view);
    tools_ui(ui, view);
}

/// The height that both need.
pub(super) fn usual_height(ui: &Ui) -> f32 {
    popup::usual_height(ui) + space(1.0) + control(ui)
}

/// The pop-up alone.
pub(super) fn window_ui(ui: &mut Ui, view: &View<'_>) {
    let shown = view.session.check().shown.as_ref();
    let title = match shown.map(|shown| &shown.record) {
        Some(record) if record.measurement.origin.is_simulated() => "popup-title-simulated",
        Some(record) if record.verdict.is_beyond_limits() => "popup-title-accepted",
        _ => "popup-title",
    };
    popup_ui(ui, view, shown.map(|shown| &shown.window), "popup-empty", title);
    if let Some(values) = shown.and_then(|shown| exact(view.words, &shown.record)) {
        ui.label(view.words.say(&message!("popup-exact").text("values", values)));
    }
}

/// What can be done with it.
pub(super) fn tools_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().interact_size.y = control(ui);
        view.button(ui, CheckAction::CopyStatus);
        mask_chooser_ui(ui, view);
    });
}

/// What the window shows with fewer digits than it has; `None` where it shows all of them. The control prints lengths
/// with four decimals; a value that a cycle measured has more that mean nothing, unless they decide.
fn exact(words: &Words, record: &Record) -> Option<String> {
    let limits = &record.limits;
    let measured = (Digits::of(record) == Digits::Exact).then_some(record.measurement.diameter);
    let values =
        [("minimum", Some(limits.minimum())), ("maximum", Some(limits.maximum())), ("head-measured", measured)];
    let said = |(id, length): (&str, Option<Length>)| {
        let length = length.filter(|length| is_finer(*length))?;
        Some(format!("{} {} mm", words.get(id), words.mm(length, 4)))
    };
    let said: Vec<_> = values.into_iter().filter_map(said).collect();
    (!said.is_empty()).then(|| said.join(", "))
}

/// Whether a length has more than four decimals in millimetres.
const fn is_finer(length: Length) -> bool {
    length.nanometres() % 100 != 0
}

pub(in crate::gui) fn mask_chooser_ui(ui: &mut Ui, view: &mut View<'_>) {
    let name = quiet(ui, view.text("mask-choice"));
    let shown = match view.session.mask() {
        MaskChoice::OfLanguage => view.text("mask-choice-of-language"),
        MaskChoice::Shipped(language) => language.name().to_owned(),
        MaskChoice::Own { name, .. } => name.clone(),
    };
    // As wide as its text, and no wider than the panel.
    let width = ui.painter().layout_no_wrap(shown.clone(), font(sizes().body), Color32::PLACEHOLDER).size().x;
    let width = (width + space(12.0)).min(ui.max_rect().width());
    let response = ComboBox::from_id_salt("mask")
        .icon(caret_ui)
        .width(width)
        .truncate()
        .selected_text(shown)
        .show_ui(ui, |ui| {
            let words = view.words;
            let commands = &mut view.commands;
            let mut choice = |ui: &mut Ui, text: String, command: Command| {
                if ui.selectable_label(false, text).clicked() {
                    commands.push(command);
                }
            };
            let of_language = words.get("mask-choice-of-language");
            choice(ui, of_language, Command::SetMask(None));
            for language in Dialogue::ALL {
                choice(ui, language.name().to_owned(), Command::SetMask(Some(language)));
            }
            let own = words.get("mask-choice-own");
            choice(ui, own, Command::OpenDialog(Purpose::LoadMask));
        })
        .response;
    response.labelled_by(name.id);
}
