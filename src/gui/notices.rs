//! What is told in the corner, what asks for a look first: a problem, or what was skipped or assumed, until it is closed; anything else for some
//! seconds, in one line. What asked for a look can be read again in the list of earlier messages.

use std::time::Duration;

use eframe::egui::{Align2, Button, CollapsingHeader, Frame, Id, Label, Margin, RichText, ScrollArea, Ui, vec2};

use super::over_page::{corner_window, fixed_window};
use super::section::{folded_ui, unfold};
use super::spoken::told;
use super::theme::{self, Icon, control, palette, sizes, space};
use super::view::{View, problem, quiet};
use crate::message::message;
use crate::session::{Action, Command, Notice, SettingsAction, WindowAction};
use crate::text::Within as _;

pub(super) fn notices_ui(ui: &Ui, view: &mut View<'_>, below: f32) {
    if view.session.shows_messages() {
        return earlier_ui(ui, view);
    }
    let Some(notice) = view.session.notice().cloned() else { return };
    let title = view.text(if notice.is_problem { "notice-problem" } else { "notice" });
    let window = corner_window("notice", title, below);
    let shown = if notice.asks() {
        window.title_bar(notice.is_problem).show(ui, |ui| notice_ui(ui, view, &notice))
    } else {
        let palette = palette(ui.ctx());
        let frame =
            Frame::window(&ui.ctx().global_style()).fill(palette.toast.0).inner_margin(Margin::symmetric(12, 4));
        window.title_bar(false).frame(frame.corner_radius(8.0)).show(ui, |ui| toast_ui(ui, view, &notice))
    };
    let is_looked_at = shown.is_some_and(|shown| shown.response.contains_pointer());
    ui.data_mut(|data| data.insert_temp(looked_at_id(), is_looked_at));
}

fn looked_at_id() -> Id {
    Id::unique("notice-looked-at")
}

/// Closes a notice that asks for nothing once it has been there for some seconds, unless somebody is at its buttons or something lies over it.
pub(super) fn leave_in_time(ui: &Ui, view: &mut View<'_>, stays: f64) {
    let session = view.session;
    let is_covered = session.is_leaving()
        || session.asks_about().is_some()
        || session.dialog().is_some()
        || session.open_columns().is_some()
        || session.working().is_some()
        || session.shows_messages()
        || session.palette.is_some();
    let notice = session.notice().filter(|notice| !notice.asks() && !is_covered);
    let is_looked_at = ui.data(|data| data.get_temp(looked_at_id())) == Some(true);
    if notice.is_none() || is_looked_at {
        return;
    }
    let now = ui.input(|input| input.time);
    let id = Id::unique("notice-since");
    let this = (session.notices_told(), session.notices().len());
    let kept: Option<(f64, (u64, usize))> = ui.data(|data| data.get_temp(id));
    let since = match kept {
        Some((since, which)) if which == this => since,
        _ => {
            ui.data_mut(|data| data.insert_temp(id, (now, this)));
            now
        }
    };
    let left = since + stays - now;
    if left <= 0.0 {
        view.send(Command::CloseNotice);
    } else {
        ui.ctx().request_repaint_after(Duration::from_secs_f64(left));
    }
}

/// The width of a notice at most; in the operator's window the keypad is never below it.
fn widest(ui: &Ui, view: &View<'_>) -> f32 {
    let window = ui.ctx().content_rect().width();
    let room = if view.session.is_for_operators() { window * 0.56 } else { window - space(16.0) };
    space(150.0).min(room)
}

/// What was done, in one line.
fn toast_ui(ui: &mut Ui, view: &mut View<'_>, notice: &Notice) {
    let palette = palette(ui.ctx());
    let width = widest(ui, view);
    ui.horizontal(|ui| {
        // What closes it stands at its end, however long the text is.
        let close = control(ui) + ui.spacing().item_spacing.x;
        ui.scope(|ui| {
            ui.set_max_width(width - close);
            ui.horizontal_wrapped(|ui| {
                ui.set_min_height(control(ui));
                let text = ui.label(RichText::new(view.words.say(&notice.message)).color(palette.on_toast.0));
                told(ui, &text);
                offers_ui(ui, view, notice);
            });
        });
        ui.visuals_mut().override_text_color = Some(palette.on_toast.0);
        view.icon_button(ui, WindowAction::CloseNotice, Icon::X);
    });
}

/// What can be done about it.
fn offers_ui(ui: &mut Ui, view: &mut View<'_>, notice: &Notice) {
    // Only what undo would take back now: other changes may have followed.
    let is_last = notice.change.is_some() && notice.change == view.session.history().last_change();
    let of_history = is_last.then_some(Action::from(WindowAction::Undo));
    if let Some(undo) = of_history.or_else(|| notice.before.is_some().then(|| SettingsAction::SettingBack.into())) {
        let button = Button::new(view.text("undo")).min_size(vec2(space(24.0), control(ui)));
        view.button_as(ui, undo, button);
    }
    if let Some(page) = notice.page.filter(|page| *page != view.session.page()) {
        let text = view.text(notice.part.unwrap_or("notice-show"));
        let button = Button::new(text).min_size(vec2(space(24.0), control(ui)));
        if view.button_as(ui, WindowAction::Open(page), button).clicked()
            && let Some(part) = notice.part
        {
            unfold(ui.ctx(), part);
        }
    }
    if notice.unplanned.is_some() {
        view.wide_button(ui, WindowAction::JudgeUnplanned);
    }
    if notice.records {
        view.wide_button(ui, WindowAction::RecordAgain);
    }
    let of_columns = notice.columns.iter().flat_map(|columns| {
        let forget = columns.shape.is_some().then_some(WindowAction::ForgetColumns);
        let [first, second] = if columns.lacks_unit {
            [Some(WindowAction::LengthsInMm), Some(WindowAction::LengthsInInches)]
        } else {
            [Some(WindowAction::CorrectColumns), forget]
        };
        first.into_iter().chain(second)
    });
    let of_file = [WindowAction::OpenWritten, WindowAction::ShowWritten].into_iter().filter(|_| notice.file.is_some());
    for action in of_columns.chain(of_file) {
        if let Some(purpose) = notice.opens.filter(|_| action == WindowAction::OpenWritten) {
            let page = purpose.page(view.session.page()).unwrap_or(view.session.page());
            let text = view.words.say(&message!("notice-open-in").text("page", view.text(page.name())));
            view.button_as(ui, action, Button::new(text).min_size(vec2(0.0, control(ui))));
        } else {
            view.field_button(ui, action);
        }
    }
}

fn notice_ui(ui: &mut Ui, view: &mut View<'_>, notice: &Notice) {
    ui.set_max_width(widest(ui, view));
    let text = view.words.say(&notice.message);
    let text = if notice.is_problem { problem(ui, text) } else { ui.label(text) };
    told(ui, &text);
    details_ui(ui, view, notice);
    let more = view.session.notices().len().saturating_sub(1);
    if 0 < more {
        quiet(ui, view.words.say(&message!("notice-more").count("count", more)));
    }
    ui.horizontal_wrapped(|ui| {
        offers_ui(ui, view, notice);
        view.wide_button(ui, WindowAction::CloseNotice);
    });
}

fn details_ui(ui: &mut Ui, view: &View<'_>, notice: &Notice) {
    if notice.details.is_empty() {
        return;
    }
    let area = ScrollArea::vertical().max_height(space(60.0));
    area.show_rows(ui, sizes().body + 4.0, notice.details.len(), |ui, rows| {
        for detail in notice.details.within(rows) {
            quiet(ui, view.words.say(detail));
        }
    });
}

/// What was told before and asked for a look, newest first, below the bar.
fn earlier_ui(ui: &Ui, view: &mut View<'_>) {
    let screen = ui.ctx().content_rect();
    let window = fixed_window("messages", view.text("messages"), Align2::RIGHT_TOP, vec2(-space(5.0), space(15.0)));
    window.show(ui, |ui| {
        ui.set_width(space(130.0).min(screen.width() - space(18.0)));
        ScrollArea::vertical().max_height(screen.height() * 0.5).show(ui, |ui| {
            for (number, notice) in view.session.earlier_notices().enumerate() {
                let said = RichText::new(view.words.say(&notice.message)).font(theme::font(sizes().body));
                if notice.details.is_empty() {
                    ui.add(Label::new(said).wrap());
                } else {
                    let head = CollapsingHeader::new(said).id_salt(number);
                    folded_ui(ui, head, |ui| details_ui(ui, view, notice));
                }
            }
        });
        ui.horizontal_wrapped(|ui| {
            for action in [WindowAction::ForgetMessages, WindowAction::Close].map(Action::from) {
                view.wide_button(ui, action);
            }
        });
    });
}
