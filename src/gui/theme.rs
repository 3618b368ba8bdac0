//! Colours, sizes and fonts: the only place where the window gets them from.
//!
//! They are in `assets/theme.toml` and `assets/fonts`; nothing else in `gui` names a colour, a size or a font.

use std::sync::{Arc, LazyLock};

use eframe::egui::{
    Color32, Context, CornerRadius, FontData, FontDefinitions, FontFamily, FontId, Margin, Shadow, Stroke, Style,
    TextStyle, Theme, Ui, Vec2, Visuals,
};
use serde::Deserialize;

use crate::verdict::Status;

/// A colour of the theme file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(try_from = "String")]
pub struct Hex(pub Color32);

impl TryFrom<String> for Hex {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        Color32::from_hex(&text).map(Self).map_err(|_parse| format!("{text} is not a colour such as #14181D"))
    }
}

macro_rules! palette {
    ($($(#[$doc:meta])* $name:ident)*) => {
        /// The colours of light or dark.
        #[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
        #[serde(deny_unknown_fields)]
        pub struct Palette { $($(#[$doc])* pub $name: Hex),* }
    };
}

palette! {
    /// Behind everything.
    background
    /// Panels.
    panel
    /// Text fields.
    field
    /// Thin lines between things.
    line
    /// Text.
    text
    /// Secondary text.
    quiet
    /// The focus ring and the main action.
    accent
    /// Text on the main action.
    on_accent
    /// Errors beside fields.
    error
    /// Selected rows and text.
    selection
    /// GOOD.
    good
    /// Text on it.
    on_good
    /// REWORK.
    rework
    /// Text on it.
    on_rework
    /// SCRAP.
    scrap
    /// Text on it.
    on_scrap
    /// RE-MEASURE.
    re_measure
    /// Text on it.
    on_re_measure
    /// No result.
    none
    /// Text on it.
    on_none
    /// GOOD, simulated.
    pale_good
    /// REWORK, simulated.
    pale_rework
    /// SCRAP, simulated.
    pale_scrap
    /// RE-MEASURE, simulated.
    pale_re_measure
    /// Text on a simulated verdict.
    on_pale
    /// The tolerance zone in the limit band.
    zone
    /// Its edges and the text in it.
    zone_edge
    /// Hatching of the rework side.
    hatch_rework
    /// Hatching of the scrap side.
    hatch_scrap
    /// The hole's zone in the picture of a fit.
    hole
    /// The shaft's.
    shaft
    /// Words of the language in an NC program.
    keyword
    /// The status window.
    popup
    /// Its title bar.
    popup_title
    /// Text on that.
    on_popup_title
}

impl Palette {
    /// The fill of a verdict and the colour on it; `None` is no result.
    pub const fn of_status(&self, status: Option<Status>) -> (Color32, Color32) {
        match status {
            Some(Status::Good) => (self.good.0, self.on_good.0),
            Some(Status::Rework) => (self.rework.0, self.on_rework.0),
            Some(Status::Scrap) => (self.scrap.0, self.on_scrap.0),
            Some(Status::ReMeasure) => (self.re_measure.0, self.on_re_measure.0),
            None => (self.none.0, self.on_none.0),
        }
    }

    /// The same for a simulated verdict.
    pub const fn of_simulated(&self, status: Option<Status>) -> (Color32, Color32) {
        let fill = match status {
            Some(Status::Good) => self.pale_good,
            Some(Status::Rework) => self.pale_rework,
            Some(Status::Scrap) => self.pale_scrap,
            Some(Status::ReMeasure) => self.pale_re_measure,
            None => return self.of_status(None),
        };
        (fill.0, self.on_pale.0)
    }
}

/// Sizes in points.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sizes {
    /// Table heads, remarks.
    pub small: f32,
    /// Body text.
    pub body: f32,
    /// Limits of size.
    pub limits: f32,
    /// Values that are typed or measured.
    pub value: f32,
    /// Headings.
    pub heading: f32,
    /// The status window.
    pub mono: f32,
    /// The status word.
    pub status: f32,
    /// The unit of all spaces.
    pub step: f32,
    /// The height of everything that is pressed, with a mouse.
    pub mouse: f32,
    /// The same by touch.
    pub touch: f32,
    /// The side of a key on the keypad.
    pub key: f32,
}

/// The theme file.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Tokens {
    /// Light.
    pub light: Palette,
    /// Dark.
    pub dark: Palette,
    /// Sizes.
    pub sizes: Sizes,
}

/// The embedded theme. A test proves that it can be read, so the message is for people who edit the file.
static TOKENS: LazyLock<Tokens> = LazyLock::new(|| {
    #[expect(clippy::expect_used, reason = "the file is part of the program and read by a test")]
    toml::from_str(include_str!("../../assets/theme.toml")).expect("assets/theme.toml can be read")
});

/// The sizes.
pub fn sizes() -> &'static Sizes {
    &TOKENS.sizes
}

/// The height of everything that is pressed, here and now: buttons, fields, lists, tabs.
pub fn control(ui: &Ui) -> f32 {
    // Rows of text set it to nothing for themselves.
    ui.ctx().global_style().spacing.interact_size.y
}

/// Sets the height of everything that is pressed.
pub fn set_density(ctx: &Context, is_touch: bool) {
    let height = if is_touch { TOKENS.sizes.touch } else { TOKENS.sizes.mouse };
    if 0.5 < (ctx.global_style().spacing.interact_size.y - height).abs() {
        ctx.all_styles_mut(|style| {
            style.spacing.interact_size.y = height;
            style.spacing.icon_width = if is_touch { space(7.0) } else { space(5.0) };
            style.spacing.icon_width_inner = style.spacing.icon_width * 0.6;
        });
    }
}

/// This many steps of space.
pub fn space(steps: f32) -> f32 {
    TOKENS.sizes.step * steps
}

/// The colours of light or dark.
pub fn palette_of(theme: Theme) -> &'static Palette {
    match theme {
        Theme::Light => &TOKENS.light,
        Theme::Dark => &TOKENS.dark,
    }
}

/// The colours of what is on screen now.
pub fn palette(ctx: &Context) -> &'static Palette {
    palette_of(ctx.theme())
}

/// The family of headings and the status word.
pub fn semibold() -> FontFamily {
    FontFamily::Name("semibold".into())
}

/// The sans-serif font at a size.
pub const fn font(size: f32) -> FontId {
    FontId::new(size, FontFamily::Proportional)
}

/// The bold sans-serif font at a size.
pub fn bold(size: f32) -> FontId {
    FontId::new(size, semibold())
}

/// The monospaced font at a size.
pub const fn mono(size: f32) -> FontId {
    FontId::new(size, FontFamily::Monospace)
}

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
        ("sans", &include_bytes!("../../assets/fonts/sans-regular.ttf")[..]),
        ("semibold", &include_bytes!("../../assets/fonts/sans-semibold.ttf")[..]),
        ("mono", &include_bytes!("../../assets/fonts/mono-regular.ttf")[..]),
        ("symbols", &include_bytes!("../../assets/fonts/symbols.ttf")[..]),
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Contrast according to WCAG 2.1, success criterion 1.4.3: relative luminance of sRGB.
    fn contrast(one: Hex, other: Hex) -> f64 {
        let luminance = |Hex(colour): Hex| {
            let channel = |value: u8| {
                let value = f64::from(value) / 255.0;
                if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
            };
            0.2126 * channel(colour.r()) + 0.7152 * channel(colour.g()) + 0.0722 * channel(colour.b())
        };
        let (one, other) = (luminance(one), luminance(other));
        (one.max(other) + 0.05) / (one.min(other) + 0.05)
    }

    #[test]
    fn every_text_has_contrast_enough() {
        for palette in [&TOKENS.light, &TOKENS.dark] {
            for (name, text, ground, least) in [
                ("text on panel", palette.text, palette.panel, 7.0),
                ("text on field", palette.text, palette.field, 7.0),
                ("text on background", palette.text, palette.background, 7.0),
                ("text on selection", palette.text, palette.selection, 7.0),
                ("quiet on panel", palette.quiet, palette.panel, 7.0),
                ("quiet on background", palette.quiet, palette.background, 7.0),
                ("error on panel", palette.error, palette.panel, 7.0),
                ("keyword on panel", palette.keyword, palette.panel, 4.5),
                ("keyword on field", palette.keyword, palette.field, 4.5),
                ("keyword on selection", palette.keyword, palette.selection, 4.5),
                ("accent on selection", palette.accent, palette.selection, 4.5),
                ("quiet on selection", palette.quiet, palette.selection, 4.5),
                ("accent on panel", palette.accent, palette.panel, 4.5),
                ("on accent", palette.on_accent, palette.accent, 4.5),
                ("on good", palette.on_good, palette.good, 7.0),
                ("on rework", palette.on_rework, palette.rework, 7.0),
                ("on scrap", palette.on_scrap, palette.scrap, 4.5),
                ("on re-measure", palette.on_re_measure, palette.re_measure, 4.5),
                ("on pale good", palette.on_pale, palette.pale_good, 7.0),
                ("on pale rework", palette.on_pale, palette.pale_rework, 7.0),
                ("on pale scrap", palette.on_pale, palette.pale_scrap, 7.0),
                ("on pale re-measure", palette.on_pale, palette.pale_re_measure, 7.0),
                ("on none", palette.on_none, palette.none, 4.5),
                ("zone edge", palette.zone_edge, palette.zone, 7.0),
                ("text on hole zone", palette.text, palette.hole, 7.0),
                ("text on shaft zone", palette.text, palette.shaft, 7.0),
                ("text on popup", palette.text, palette.popup, 7.0),
                ("popup title", palette.on_popup_title, palette.popup_title, 7.0),
            ] {
                assert!(least <= contrast(text, ground), "{name}: {:.2}", contrast(text, ground));
            }
        }
    }

    #[test]
    fn verdicts_are_told_apart_in_greyscale() {
        for palette in [&TOKENS.light, &TOKENS.dark] {
            for (one, other) in
                [(palette.good, palette.rework), (palette.rework, palette.scrap), (palette.good, palette.scrap)]
            {
                assert!(1.4 <= contrast(one, other), "{one:?} {other:?}: {:.2}", contrast(one, other));
            }
        }
    }

    #[test]
    fn a_simulated_verdict_is_told_apart_from_a_measured_one_in_greyscale() {
        for palette in [&TOKENS.light, &TOKENS.dark] {
            for (measured, simulated) in [
                (palette.good, palette.pale_good),
                (palette.rework, palette.pale_rework),
                (palette.scrap, palette.pale_scrap),
                (palette.re_measure, palette.pale_re_measure),
            ] {
                let is = contrast(measured, simulated);
                assert!(1.15 <= is, "{measured:?} {simulated:?}: {is:.2}");
            }
        }
    }
}
