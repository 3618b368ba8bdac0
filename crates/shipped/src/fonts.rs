//! The fonts, cut to the signs that Fitcheck needs (`assets/fonts/README.md`). The window and the pages of reports show the same ones.

/// Text.
pub static SANS: &[u8] = include_bytes!("../../../assets/fonts/sans-regular.ttf");
/// Headings and values.
pub static SEMIBOLD: &[u8] = include_bytes!("../../../assets/fonts/sans-semibold.ttf");
/// Programs and windows of the control.
pub static MONO: &[u8] = include_bytes!("../../../assets/fonts/mono-regular.ttf");
/// Signs that the others lack.
pub static SYMBOLS: &[u8] = include_bytes!("../../../assets/fonts/symbols.ttf");
/// Icons, thin.
pub static ICONS: &[u8] = include_bytes!("../../../assets/fonts/icons-regular.ttf");
/// The same, bold: verdicts.
pub static ICONS_BOLD: &[u8] = include_bytes!("../../../assets/fonts/icons-bold.ttf");
/// The same, filled.
pub static ICONS_FILL: &[u8] = include_bytes!("../../../assets/fonts/icons-fill.ttf");
