//! At the first touch: whom this window is for. Enter gives the first answer, which a touch panel usually wants.

use eframe::egui::{Button, Id, Modal, RichText, Ui, vec2};

use crate::gui::over_page::just_opened;
use crate::gui::segments::segments_ui;
use crate::gui::spoken::dialog_headed;
use crate::gui::theme::{self, palette, sizes, space};
use crate::gui::view::{View, heading};
use crate::session::{Action, Command, Mode, SettingsAction};
use crate::words::Language;

/// The height of an answer.
const ANSWER: f32 = 64.0;

pub(in crate::gui) fn question_ui(ui: &Ui, view: &mut View<'_>) {
    if !view.session.asks_for_mode() {
        return;
    }
    let id = Id::unique("mode-question");
    Modal::new(id).show(ui, |ui| {
        ui.set_width(space(140.0).min(ui.ctx().content_rect().width() - space(12.0)));
        languages_ui(ui, view);
        let head = heading(ui, view.text("operator-question"));
        dialog_headed(ui, id, &head);
        let palette = palette(ui.ctx());
        for (mode, name, about) in [
            (Mode::Operator, "operator-mode-operator", "operator-mode-operator-about"),
            (Mode::Full, "operator-mode-full", "operator-mode-full-about"),
        ] {
            let is_first = mode == Mode::Operator;
            let colour = if is_first { palette.on_accent.0 } else { palette.text.0 };
            let fill = if is_first { palette.accent.0 } else { palette.hover.0 };
            let name = view.text(name);
            let text = RichText::new(&name).font(theme::bold(sizes().limits)).color(colour);
            let button = Button::new(text).fill(fill).min_size(vec2(ui.available_width(), ANSWER));
            let response = ui.add(button).accessible_name(&name);
            if is_first && just_opened(ui, id.with("shown")) {
                response.request_focus();
            }
            if response.clicked() {
                view.send(Command::SetMode(mode));
            }
            ui.label(view.text(about));
            ui.add_space(space(1.0));
        }
        ui.label(view.text("operator-question-later"));
    });
}

/// The languages, each by its own name.
fn languages_ui(ui: &mut Ui, view: &mut View<'_>) {
    let languages: Vec<Action> = Language::all().map(SettingsAction::UseLanguage).map(Action::from).collect();
    for row in languages.chunks(4) {
        let width = ui.available_width();
        segments_ui(ui, view, row, width);
    }
}
