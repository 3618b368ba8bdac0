//! The rail of pages: at the left in groups, or below the page where the window is narrow or upright. What has no room goes into a menu.

use eframe::egui::accesskit::Role;
use eframe::egui::containers::menu::MenuButton;
use eframe::egui::{
    Align2, Button, Color32, Frame, Margin, Panel, Rect, Response, Sense, Stroke, StrokeKind, Ui, WidgetInfo, pos2,
    vec2,
};

use super::key_names::told;
use super::page::Group;
use super::pages::page_of;
use super::shapes::{lines_of, times};
use super::theme::{self, Icon, Weight, control, palette, sizes, space};
use super::view::View;
use crate::session::{Action, Page, WindowAction};

/// From this size on the items have their names below them.
const NAMED: [f32; 2] = [1_100.0, 700.0];

/// Below this width the rail stands below the page.
const NARROW: f32 = 640.0;

/// Between two groups.
const GAP: f32 = 9.0;

/// How the rail stands in a window.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum RailShape {
    /// At the left, with names.
    Named,
    /// At the left, icons alone.
    Slim,
    Below,
}

impl RailShape {
    pub fn of(ui: &Ui) -> Self {
        let window = ui.ctx().content_rect().size();
        if window.x < NARROW || window.x * 1.3 < window.y {
            Self::Below
        } else if NAMED[0] <= window.x && NAMED[1] <= window.y {
            Self::Named
        } else {
            Self::Slim
        }
    }

    const fn width(self) -> f32 {
        if matches!(self, Self::Named) { 76.0 } else { 52.0 }
    }
}

/// How much of the window's width the rail takes.
pub(super) fn rail_width(ui: &Ui) -> f32 {
    let shape = RailShape::of(ui);
    if shape == RailShape::Below { 0.0 } else { shape.width() }
}

pub(super) fn rail_ui(ui: &mut Ui, view: &mut View<'_>) {
    let shape = RailShape::of(ui);
    let frame = Frame::new().fill(palette(ui.ctx()).canvas.0);
    if shape == RailShape::Below {
        let panel = Panel::bottom("rail").resizable(false).frame(frame.inner_margin(Margin::symmetric(4, 4)));
        panel.show(ui, |ui| below_ui(ui, view));
    } else {
        let panel = Panel::left("rail").resizable(false).exact_size(shape.width());
        panel.frame(frame.inner_margin(Margin { top: 8, bottom: 4, ..Margin::ZERO })).show(ui, |ui| {
            left_ui(ui, view, shape);
        });
    }
}

/// The pages of a group, in the order in which they are listed.
fn pages(group: Group) -> impl Iterator<Item = Page> {
    Page::ALL.into_iter().filter(move |page| page_of(*page).group == group)
}

fn left_ui(ui: &mut Ui, view: &mut View<'_>, shape: RailShape) {
    ui.spacing_mut().item_spacing = vec2(0.0, 0.0);
    let side = space(9.0);
    let (logo, _) = ui.allocate_exact_size(vec2(shape.width(), side + 6.0), Sense::hover());
    logo_ui(ui, Rect::from_center_size(pos2(logo.center().x, logo.top() + side / 2.0), vec2(side, side)));
    let height = control(ui).max(if shape == RailShape::Named { 46.0 } else { 40.0 });
    let foot: Vec<Page> = pages(Group::Foot).collect();
    let room = ui.available_height() - times(height, foot.len());
    let groups = Group::RAIL.map(|group| pages(group).collect::<Vec<Page>>());
    let all = groups.iter().map(Vec::len).sum::<usize>();
    let needed = times(height, all) + times(GAP, groups.len() - 1);
    let mut left = room - if needed <= room { 0.0 } else { height };
    let mut more = Vec::new();
    for (place, group) in groups.into_iter().enumerate() {
        let gap = if place == 0 { 0.0 } else { GAP };
        let takes = gap + times(height, group.len());
        // A group is never torn apart, and what follows one that has no room has none either.
        if left < takes || !more.is_empty() {
            more.extend(group);
            continue;
        }
        left -= takes;
        if 0.0 < gap {
            let (rule, _) = ui.allocate_exact_size(vec2(shape.width(), gap), Sense::hover());
            let across = rule.shrink2(vec2(rule.width() * 0.32, 0.0)).x_range();
            ui.painter().hline(across, rule.center().y, Stroke::new(1.0, palette(ui.ctx()).edge.0.gamma_multiply(0.5)));
        }
        for page in group {
            item_ui(ui, view, page, vec2(shape.width(), height), shape);
        }
    }
    if !more.is_empty() {
        more_ui(ui, view, &more, vec2(shape.width(), height));
    }
    ui.add_space((ui.available_height() - times(height, foot.len())).max(0.0));
    for page in foot {
        item_ui(ui, view, page, vec2(shape.width(), height), shape);
    }
}

fn below_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.spacing_mut().item_spacing = vec2(0.0, 0.0);
    let window = ui.ctx().content_rect().size();
    // A window that is low, too, has no line for names.
    let shape = if window.y < 480.0 { RailShape::Slim } else { RailShape::Named };
    let height = if shape == RailShape::Named { 56.0 } else { control(ui) };
    let mut pages: Vec<Page> = Group::RAIL.into_iter().chain([Group::Foot]).flat_map(pages).collect();
    let fit = lines_of(ui.available_width() / 72.0).max(2);
    let more = if fit < pages.len() { pages.split_off(fit - 1) } else { Vec::new() };
    let count = pages.len() + usize::from(!more.is_empty());
    let width = ui.available_width() / times(1.0, count);
    ui.horizontal(|ui| {
        for page in pages {
            item_ui(ui, view, page, vec2(width, height), shape);
        }
        if !more.is_empty() {
            more_ui(ui, view, &more, vec2(width, height));
        }
    });
}

/// The mark of the program: a measured circle and that it is good.
fn logo_ui(ui: &Ui, rect: Rect) {
    let palette = palette(ui.ctx());
    let painter = ui.painter();
    painter.rect_filled(rect, 8.0, palette.accent.0);
    let stroke = Stroke::new(2.0, palette.on_accent.0);
    let centre = rect.center();
    let radius = rect.width() * 0.29;
    painter.circle_stroke(centre, radius, stroke);
    for along in [vec2(1.0, 0.0), vec2(-1.0, 0.0), vec2(0.0, 1.0), vec2(0.0, -1.0)] {
        painter.line_segment([centre + along * radius, centre + along * (radius + 4.0)], stroke);
    }
    Icon::Check.paint(painter, centre, Weight::Bold, radius * 1.2, palette.on_accent.0);
}

fn item_ui(ui: &mut Ui, view: &mut View<'_>, page: Page, size: eframe::egui::Vec2, shape: RailShape) {
    let action = Action::from(WindowAction::Open(page));
    let is_on = view.session.page() == page;
    let name = action.text(view.session, view.words);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    let names = (shape == RailShape::Named).then_some(name.as_str());
    paint_item(ui, rect, &response, (page_of(page).icon, names), is_on);
    response.widget_info(|| WidgetInfo::selected(Role::Button, true, is_on, &name));
    let keys = action.shortcut_shown(view.session.page()).map(|keys| told(ui, keys));
    let hint: Vec<String> = names.is_none().then(|| name.clone()).into_iter().chain(keys).collect();
    let response = if hint.is_empty() { response } else { response.on_hover_text(hint.join("\n")) };
    if response.clicked() {
        view.act(action);
    }
}

pub(super) fn paint_item(ui: &Ui, rect: Rect, response: &Response, (icon, name): (Icon, Option<&str>), is_on: bool) {
    let palette = palette(ui.ctx());
    let ground = rect.shrink2(vec2(6.0_f32.min(rect.width() * 0.1), 1.0));
    let fill = match (is_on, response.hovered()) {
        (true, _) => palette.tint.0,
        (false, true) => palette.hover.0,
        (false, false) => Color32::TRANSPARENT,
    };
    ui.painter().rect_filled(ground, 10.0, fill);
    if response.has_focus() {
        let ring = Stroke::new(2.0, palette.focus.0);
        ui.painter().rect_stroke(ground, 10.0, ring, StrokeKind::Inside);
    }
    let colour = if is_on { palette.accent.0 } else { palette.quiet.0 };
    let weight = if is_on { Weight::Fill } else { Weight::Regular };
    let middle = if name.is_some() { pos2(rect.center().x, rect.top() + rect.height() * 0.35) } else { rect.center() };
    icon.paint(ui.painter(), middle, weight, space(5.5), colour);
    if let Some(name) = name {
        let size = sizes().tiny;
        let font = if is_on { theme::bold(size) } else { theme::font(size) };
        let galley = ui.painter().layout_no_wrap(name.to_owned(), font.clone(), colour);
        // A longer language sets a name smaller rather than cutting it.
        let font = eframe::egui::FontId { size: size.min(size * rect.width() / galley.size().x.max(1.0)), ..font };
        let at = pos2(rect.center().x, rect.bottom() - rect.height() * 0.22);
        ui.painter().text(at, Align2::CENTER_CENTER, name, font, colour);
    }
}

/// The pages that have no room.
fn more_ui(ui: &mut Ui, view: &mut View<'_>, pages: &[Page], size: eframe::egui::Vec2) {
    let name = view.text("rail-more");
    let icon = Icon::DotsThree.text(Weight::Bold, space(5.5)).color(palette(ui.ctx()).quiet.0);
    theme::looking(ui, theme::plain, |ui| {
        let button = Button::new(icon).min_size(size);
        let (response, _) = MenuButton::from_button(button).ui(ui, |ui| {
            for page in pages {
                view.menu_item(ui, WindowAction::Open(*page));
            }
        });
        response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
        response.on_hover_text(name);
    });
}
