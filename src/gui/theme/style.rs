//! The fonts, and the style of what egui draws by itself: spaces, edges, widgets, light and dark.

use std::sync::Arc;

use eframe::egui::{
    Color32, Context, CornerRadius, FontData, FontDefinitions, FontFamily, Margin, Shadow, Stroke, Style, TextStyle,
    Theme, Ui, Vec2, Visuals,
};

use super::{Palette, Weight, bold, font, line_width, look, mono, semibold, sizes, space};
use crate::shipped::fonts;

/// Fonts and style, light and dark.
pub fn install(ctx: &Context) {
    ctx.set_fonts(all_fonts());
    for theme in [Theme::Light, Theme::Dark] {
        ctx.set_style_of(theme, style(theme, false));
    }
    // As desktops have it; the library's 0.3 s are short for a hand in a glove.
    ctx.options_mut(|options| options.input_options.max_double_click_delay = 0.5);
}

fn all_fonts() -> FontDefinitions {
    let mut all = FontDefinitions::empty();
    for (name, bytes) in [
        ("sans", fonts::SANS),
        ("semibold", fonts::SEMIBOLD),
        ("mono", fonts::MONO),
        ("symbols", fonts::SYMBOLS),
        (Weight::Regular.font(), fonts::ICONS),
        (Weight::Bold.font(), fonts::ICONS_BOLD),
        (Weight::Fill.font(), fonts::ICONS_FILL),
    ] {
        all.font_data.insert(name.to_owned(), Arc::new(FontData::from_static(bytes)));
    }
    for (family, first) in
        [(FontFamily::Proportional, "sans"), (semibold(), "semibold"), (FontFamily::Monospace, "mono")]
    {
        let mut order = vec![first.to_owned(), "sans".to_owned(), "symbols".to_owned()];
        order.dedup();
        all.families.insert(family, order);
    }
    for icons in Weight::ALL.map(Weight::font) {
        all.families.insert(FontFamily::Name(icons.into()), vec![icons.to_owned()]);
    }
    all
}

/// How egui draws its own widgets.
pub(super) fn style(theme: Theme, is_contrast: bool) -> Style {
    let sizes = sizes();
    let visuals = visuals(theme, look(theme, is_contrast), line_width(is_contrast));
    let mut style = Style { visuals, ..Style::default() };
    style.text_styles = [
        (TextStyle::Small, font(sizes.small)),
        (TextStyle::Body, font(sizes.body)),
        (TextStyle::Button, font(sizes.body)),
        (TextStyle::Heading, bold(sizes.heading)),
        (TextStyle::Monospace, mono(sizes.mono)),
    ]
    .into();
    style.spacing.item_spacing = Vec2::splat(space(2.0));
    style.spacing.button_padding = Vec2::new(space(3.0), space(1.5));
    style.spacing.interact_size.y = sizes.mouse;
    style.spacing.window_margin = Margin::same(16);
    style.spacing.menu_margin = Margin::same(6);
    style.spacing.icon_width = space(5.0);
    style.spacing.icon_width_inner = space(3.0);
    // Nothing moves except what shows progress.
    style.animation_time = 0.0;
    style
}

fn visuals(theme: Theme, palette: &Palette, line: f32) -> Visuals {
    let mut visuals = match theme {
        Theme::Light => Visuals::light(),
        Theme::Dark => Visuals::dark(),
    };
    let shadow = Shadow { offset: [0, 6], blur: 24, spread: 0, color: Color32::from_black_alpha(48) };
    visuals.panel_fill = palette.surface.0;
    visuals.window_fill = palette.surface.0;
    visuals.window_stroke = Stroke::new(line, palette.line.0);
    visuals.window_corner_radius = CornerRadius::same(12);
    visuals.menu_corner_radius = CornerRadius::same(8);
    visuals.window_shadow = shadow;
    visuals.popup_shadow = shadow;
    visuals.extreme_bg_color = palette.surface.0;
    visuals.text_edit_bg_color = Some(palette.surface.0);
    visuals.faint_bg_color = palette.sunken.0;
    visuals.code_bg_color = palette.sunken.0;
    visuals.weak_text_color = Some(palette.quiet.0);
    visuals.error_fg_color = palette.error.0;
    visuals.warn_fg_color = palette.text.0;
    visuals.hyperlink_color = palette.focus.0;
    visuals.selection.bg_fill = palette.tint.0;
    visuals.selection.stroke = Stroke::new(2.0, palette.focus.0);
    // A blinking caret would ask for two frames a second; an idle window draws none.
    visuals.text_cursor.blink = false;
    let edge = Stroke::new(line, palette.edge.0);
    let ring = Stroke::new(2.0, palette.focus.0);
    // What is under the pointer is filled and has no ring: it does not look as if it had the focus.
    for (widget, fill, stroke) in [
        (&mut visuals.widgets.noninteractive, palette.surface, Stroke::new(line, palette.line.0)),
        (&mut visuals.widgets.inactive, palette.surface, edge),
        (&mut visuals.widgets.hovered, palette.hover, edge),
        (&mut visuals.widgets.active, palette.surface, ring),
        (&mut visuals.widgets.open, palette.hover, ring),
    ] {
        widget.bg_fill = fill.0;
        widget.weak_bg_fill = fill.0;
        widget.bg_stroke = stroke;
        widget.fg_stroke = Stroke::new(1.0, palette.text.0);
        widget.corner_radius = CornerRadius::same(8);
        widget.expansion = 0.0;
    }
    visuals
}

/// Draws something as another look has it; what follows looks as before. A scope of its own would never wrap into another line.
pub fn looking<T>(ui: &mut Ui, look: fn(&mut Ui), content: impl FnOnce(&mut Ui) -> T) -> T {
    let before = ui.visuals().widgets.clone();
    look(ui);
    let shown = content(ui);
    ui.visuals_mut().widgets = before;
    shown
}

/// Draws buttons without an edge: filled, as what is pressed and does not stand first.
pub fn tonal(ui: &mut Ui) {
    let palette = super::palette(ui.ctx());
    let widgets = &mut ui.visuals_mut().widgets;
    for (widget, fill) in [
        (&mut widgets.noninteractive, palette.hover),
        (&mut widgets.inactive, palette.hover),
        (&mut widgets.hovered, palette.tint),
        (&mut widgets.open, palette.tint),
    ] {
        widget.bg_fill = fill.0;
        widget.weak_bg_fill = fill.0;
        widget.bg_stroke = Stroke::NONE;
    }
    widgets.active.weak_bg_fill = palette.hover.0;
}

/// The same without a ground, which comes with the pointer.
pub fn plain(ui: &mut Ui) {
    tonal(ui);
    let widgets = &mut ui.visuals_mut().widgets;
    for widget in [&mut widgets.noninteractive, &mut widgets.inactive, &mut widgets.active] {
        widget.weak_bg_fill = Color32::TRANSPARENT;
    }
}

/// Draws fields with their edge, also where a menu takes it from everything.
pub fn edged(ui: &mut Ui) {
    ui.visuals_mut().widgets = ui.ctx().global_style().visuals.widgets.clone();
}
