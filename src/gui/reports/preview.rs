//! Middle: a page as it will print, and the way to the others.

use std::sync::{Arc, Weak};
use std::time::Duration;

use eframe::egui::accesskit::Role;
use eframe::egui::{
    Button, Id, Rect, ScrollArea, Sense, Stroke, StrokeKind, TextureHandle, TextureOptions, Ui, WidgetInfo, vec2,
};

use super::canvas::PainterCanvas;
use crate::gui::empty::empty_ui;
use crate::gui::theme::{self, Icon, control, palette, space};
use crate::gui::view::{View, problem, quiet};
use crate::message::message;
use crate::report::pdf::{Pages, PictureDots};
use crate::session::{Magnification, ReportsAction, ReportsCommand, Step};
use crate::text::grouped;

/// Between the page and the edge of its ground.
const MARGIN: f32 = 16.0;

pub(super) fn preview_ui(ui: &mut Ui, view: &mut View<'_>) {
    working_ui(ui, view);
    let page = view.session.reports();
    match page.pages() {
        Some(Ok(pages)) => {
            let pages = Arc::clone(pages);
            let at = page.at();
            bar_ui(ui, view, &pages);
            let [width, height] = pages.size();
            let room = ui.available_size() - vec2(2.0 * MARGIN, 2.0 * MARGIN);
            let whole = (room.x / width).min(room.y / height).max(0.05);
            let scale = match page.magnification {
                Magnification::WholePage => whole,
                Magnification::Percent(percent) => f32::from(percent) / 100.0 * POINTS,
            };
            let ground = ui.available_rect_before_wrap();
            ui.painter().rect_filled(ground, 8.0, palette(ui.ctx()).sunken.0);
            ScrollArea::both().id_salt(("report-page", at)).auto_shrink(false).show(ui, |ui| {
                let size = vec2(width * scale, height * scale);
                let all = (size + vec2(2.0 * MARGIN, 2.0 * MARGIN)).max(ui.available_size());
                let (area, response) = ui.allocate_exact_size(all, Sense::focusable_noninteractive());
                let paper = Rect::from_center_size(area.center(), size);
                let said = format!("{}: {}", view.text("reports-page-preview"), pages.text(at));
                response.widget_info(|| WidgetInfo::labeled(Role::Document, true, &said));
                ui.painter().rect(paper, 0.0, theme::paper(), theme::line(ui.ctx()), StrokeKind::Outside);
                if response.has_focus() {
                    let focus = Stroke::new(2.0, palette(ui.ctx()).focus.0);
                    ui.painter().rect_stroke(paper.expand(3.0), 0.0, focus, StrokeKind::Outside);
                }
                let pictures = textures(ui, &pages);
                pages.draw(at, &mut PainterCanvas::new(ui, paper, scale, &pictures));
            });
        }
        Some(Err(_)) if view.session.report_of().is_none() => empty_ui(ui, view, "reports-page-nothing-hint", &[]),
        Some(Err(why)) => _ = problem(ui, view.words.say(why)),
        None if page.at_work().is_some() => {}
        None => empty_ui(ui, view, "reports-page-nothing-hint", &[]),
    }
}

/// How far the pages are that are being made, and the button that stops them. Short work says nothing of its figures.
fn working_ui(ui: &mut Ui, view: &mut View<'_>) {
    let Some(drawing) = view.session.reports().at_work() else { return };
    let checks = drawing.checks();
    ui.ctx().request_repaint_after(EVERY);
    if checks < LONG {
        if view.session.reports().pages().is_none() {
            quiet(ui, view.text("reports-page-drawing"));
        }
        return;
    }
    let said = message!("reports-page-drawing-checks").text("count", grouped(checks));
    let said = view.words.say(&said);
    ui.horizontal_wrapped(|ui| {
        quiet(ui, said);
        view.button(ui, ReportsAction::StopPages);
    });
}

/// How often it is said how far pages are.
const EVERY: Duration = Duration::from_millis(100);

/// From so many checks on it is said how far the pages are.
const LONG: u64 = 5_000;

/// The pictures of pages, whose dots go to the graphics card once.
fn textures(ui: &Ui, pages: &Arc<Pages>) -> Vec<Option<TextureHandle>> {
    type Kept = (Weak<Pages>, Vec<Option<TextureHandle>>);
    let key = Id::unique("report-pictures");
    let kept: Option<Kept> = ui.data(|data| data.get_temp(key));
    // The memory of pages is no other's while they are remembered here.
    if let Some((_, kept)) = kept.filter(|(of, _)| std::ptr::eq(of.as_ptr(), Arc::as_ptr(pages))) {
        return kept;
    }
    let load = |picture: &PictureDots| {
        let image = theme::picture(picture.size, &picture.bytes);
        ui.ctx().load_texture(&picture.name, image, TextureOptions::LINEAR)
    };
    let loaded: Vec<Option<TextureHandle>> = pages.dots.iter().map(|dots| dots.as_ref().map(load)).collect();
    ui.data_mut(|data| data.insert_temp(key, (Arc::downgrade(pages), loaded.clone())));
    loaded
}

/// Dots of the window a point of the page at its size on paper: 96 and 72 an inch.
const POINTS: f32 = 96.0 / 72.0;

/// Which page, and how large.
fn bar_ui(ui: &mut Ui, view: &mut View<'_>, pages: &Pages) {
    let at = view.session.reports().at();
    let count = pages.count();
    ui.horizontal(|ui| {
        for (step, sign) in [(Step::PageUp, "‹"), (Step::PageDown, "›")] {
            let action = ReportsAction::Move(step);
            let name = action_name(view, action);
            let button = Button::new(sign).min_size(vec2(control(ui), control(ui)));
            view.button_as(ui, action, button).accessible_name(name);
            if step == Step::PageUp {
                let said = message!("reports-page-at").count("at", at + 1).count("count", count);
                ui.label(view.words.say(&said));
            }
        }
        ui.add_space(space(2.0));
        for (is_larger, icon, name) in
            [(false, Icon::Minus, "reports-page-smaller"), (true, Icon::Plus, "reports-page-larger")]
        {
            let name = view.text(name);
            let button = Button::new(icon.text(theme::Weight::Regular, space(4.0)));
            let button =
                ui.add(button.min_size(vec2(control(ui), control(ui)))).accessible_name(&name).on_hover_text(&name);
            if button.clicked() {
                let magnification = view.session.reports().magnification.step(is_larger, 50);
                view.send(ReportsCommand::Magnify(magnification));
            }
        }
        view.button(ui, ReportsAction::WholePage);
    });
}

fn action_name(view: &View<'_>, action: ReportsAction) -> String {
    crate::session::Action::from(action).text(view.session, view.words)
}
