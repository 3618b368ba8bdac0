//! The fonts, and the style of what egui draws by itself: spaces, edges, widgets, light and dark.

use std::sync::Arc;

use eframe::egui::{
    Context, CornerRadius, FontData, FontDefinitions, FontFamily, Margin, Shadow, Stroke, Style, TextStyle, Theme,
    Vec2, Visuals,
};

use super::{bold, font, mono, palette_of, semibold, sizes, space};

/// Fonts and style, light and dark.
pub fn install(ctx: &Context) {
    ctx.set_fonts(fonts());
    for theme in [Theme::Light, Theme::Dark] {
        ctx.set_style_of(theme, style(theme));
    }
}

fn fonts() -> FontDefinitions {
    let mut fonts = FontDefinitions::empty();
    for (name, bytes) in [
        ("sans", &include_bytes!("../../../assets/fonts/sans-regular.ttf")[..]),
        ("semibold", &include_bytes!("../../../assets/fonts/sans-semibold.ttf")[..]),
        ("mono", &include_bytes!("../../../assets/fonts/mono-regular.ttf")[..]),
        ("symbols", &include_bytes!("../../../assets/fonts/symbols.ttf")[..]),
    ] {
        fonts.font_data.insert(name.to_owned(), Arc::new(FontData::from_static(bytes)));
    }
    for (family, first) in
        [(FontFamily::Proportional, "sans"), (semibold(), "semibold"), (FontFamily::Monospace, "mono")]
    {
        let mut order = vec![first.to_owned(), "sans".to_owned(), "symbols".to_owned()];
        order.dedup();
        fonts.families.insert(family, order);
    }
    fonts
}

fn style(theme: Theme) -> Style {
    let sizes = sizes();
    let mut style = Style { visuals: visuals(theme), ..Style::default() };
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
    style.spacing.window_margin = Margin::same(12);
    style.spacing.icon_width = space(5.0);
    style.spacing.icon_width_inner = space(3.0);
    // Nothing moves except what shows progress.
    style.animation_time = 0.0;
    style
}

fn visuals(theme: Theme) -> Visuals {
    let palette = palette_of(theme);
    let mut visuals = match theme {
        Theme::Light => Visuals::light(),
        Theme::Dark => Visuals::dark(),
    };
    let radius = CornerRadius::same(4);
    visuals.panel_fill = palette.panel.0;
    visuals.window_fill = palette.panel.0;
    visuals.window_stroke = Stroke::new(1.0, palette.line.0);
    visuals.window_corner_radius = CornerRadius::same(6);
    visuals.window_shadow = Shadow::NONE;
    visuals.popup_shadow = Shadow::NONE;
    visuals.extreme_bg_color = palette.field.0;
    visuals.text_edit_bg_color = Some(palette.field.0);
    visuals.faint_bg_color = palette.background.0;
    visuals.code_bg_color = palette.background.0;
    visuals.weak_text_color = Some(palette.quiet.0);
    visuals.error_fg_color = palette.error.0;
    visuals.warn_fg_color = palette.text.0;
    visuals.hyperlink_color = palette.accent.0;
    visuals.selection.bg_fill = palette.selection.0;
    visuals.selection.stroke = Stroke::new(2.0, palette.accent.0);
    // A blinking caret would ask for two frames a second; an idle window draws none.
    visuals.text_cursor.blink = false;
    let edge = Stroke::new(1.0, palette.line.0);
    let ring = Stroke::new(2.0, palette.accent.0);
    for (widget, stroke) in [
        (&mut visuals.widgets.noninteractive, edge),
        (&mut visuals.widgets.inactive, edge),
        (&mut visuals.widgets.hovered, Stroke::new(1.0, palette.accent.0)),
        (&mut visuals.widgets.active, ring),
        (&mut visuals.widgets.open, ring),
    ] {
        widget.bg_fill = palette.field.0;
        widget.weak_bg_fill = palette.field.0;
        widget.bg_stroke = stroke;
        widget.fg_stroke = Stroke::new(1.0, palette.text.0);
        widget.corner_radius = radius;
        widget.expansion = 0.0;
    }
    visuals
}
