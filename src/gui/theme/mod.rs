//! Colours, sizes and fonts: the only place where the window gets them from.
//!
//! They are in `assets/theme.toml` and `assets/fonts`; nothing else in `gui` names a colour, a size or a font.
//!
//! | file | what |
//! |---|---|
//! | here | what panels ask for: a colour, a size, a font, a space |
//! | `tokens` | what the theme file holds |
//! | `icon` | the icons |
//! | `style` | the fonts, and how egui draws its own widgets |

mod icon;
mod style;
#[cfg(test)]
mod tests;
mod tokens;

use std::sync::LazyLock;

use eframe::egui::{Color32, ColorImage, Context, FontFamily, FontId, Id, Stroke, Style, Theme, Ui};

pub use icon::{Icon, Weight};
use style::style;
pub use style::{edged, install, looking, plain, tonal};
pub use tokens::{Hex, Palette, Sizes, Tokens};

/// The embedded theme. A test proves that it can be read, so the message is for people who edit the file.
static TOKENS: LazyLock<Tokens> = LazyLock::new(|| {
    #[expect(clippy::expect_used, reason = "the file is part of the program and read by a test")]
    toml::from_str(include_str!("../../../assets/theme.toml")).expect("assets/theme.toml can be read")
});

pub fn sizes() -> &'static Sizes {
    &TOKENS.sizes
}

/// The height of everything that is pressed, here and now: buttons, fields, lists, tabs.
pub fn control(ui: &Ui) -> f32 {
    // Rows of text set it to nothing for themselves.
    ui.ctx().global_style().spacing.interact_size.y
}

/// The height of a row of a list: a little less than what is pressed, but never less than a finger needs.
pub fn row(ui: &Ui) -> f32 {
    let height = control(ui);
    if TOKENS.sizes.mouse < height {
        return height;
    }
    let is_close = ui.data(|data| data.get_temp(close_rows())) == Some(true);
    if is_close { TOKENS.sizes.close_row } else { TOKENS.sizes.row }
}

fn close_rows() -> Id {
    Id::unique("close-rows")
}

/// Sets whether the rows of lists stand close to each other.
pub fn set_rows(ctx: &Context, is_close: bool) {
    ctx.data_mut(|data| data.insert_temp(close_rows(), is_close));
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

/// A picture of its own colours, from red, green, blue and opacity of every dot; nothing where there are too few of them.
pub fn picture(size: [usize; 2], dots: &[u8]) -> ColorImage {
    if size[0].checked_mul(size[1]).and_then(|count| count.checked_mul(4)) == Some(dots.len()) {
        ColorImage::from_rgba_unmultiplied(size, dots)
    } else {
        ColorImage::default()
    }
}

/// This many steps of space.
pub fn space(steps: f32) -> f32 {
    TOKENS.sizes.step * steps
}

/// A colour of a page that will be printed, whatever the look.
#[expect(clippy::disallowed_methods, reason = "the colours of paper are those of the file, and not of a theme")]
pub const fn ink([red, green, blue]: [u8; 3]) -> Color32 {
    Color32::from_rgb(red, green, blue)
}

/// The white of paper, whatever the look.
pub fn paper() -> Color32 {
    TOKENS.light.surface.0
}

/// Switches high contrast on or off: it takes the place of light and dark.
pub fn set_contrast(ctx: &Context, is_on: bool) {
    let before = ctx.data_mut(|data| std::mem::replace(data.get_temp_mut_or_default::<bool>(contrast()), is_on));
    if before != is_on {
        for theme in [Theme::Light, Theme::Dark] {
            let spacing = ctx.style_of(theme).spacing.clone();
            ctx.set_style_of(theme, Style { spacing, ..style(theme, is_on) });
        }
    }
}

/// Whether high contrast is on.
fn is_contrast(ctx: &Context) -> bool {
    ctx.data(|data| data.get_temp(contrast())) == Some(true)
}

fn contrast() -> Id {
    Id::unique("high-contrast")
}

/// The colours of what is on screen now.
pub fn palette(ctx: &Context) -> &'static Palette {
    look(ctx.theme(), is_contrast(ctx))
}

/// The edge of a card and what parts things: thicker in high contrast.
pub fn line(ctx: &Context) -> Stroke {
    Stroke::new(line_width(is_contrast(ctx)), palette(ctx).line.0)
}

const fn line_width(is_contrast: bool) -> f32 {
    if is_contrast { 2.0 } else { 1.0 }
}

fn look(theme: Theme, is_contrast: bool) -> &'static Palette {
    match (theme, is_contrast) {
        (Theme::Light, false) => &TOKENS.light,
        (Theme::Dark, false) => &TOKENS.dark,
        (Theme::Light, true) => &TOKENS.contrast,
        (Theme::Dark, true) => &TOKENS.inverted,
    }
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
