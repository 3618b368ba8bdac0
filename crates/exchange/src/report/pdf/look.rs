//! How the pages look: colours, sizes, spaces. Lengths are in points, 72 of which are an inch.
//!
//! The colours are those of the window's light theme (`assets/theme.toml`). Nothing is told by a colour alone: a verdict has its word, its sign
//! and its outline, a side of the band its hatching, so that a page in black and white says the same.

use fitcheck_core::verdict::Status;

use super::fonts::Weight;

/// Red, green, blue.
pub(super) type Ink = [u8; 3];

pub(super) const TEXT: Ink = [0x0e, 0x16, 0x20];
pub(super) const QUIET: Ink = [0x43, 0x4e, 0x5b];
pub(super) const LINE: Ink = [0xd0, 0xd7, 0xdf];
pub(super) const PAPER: Ink = [0xff, 0xff, 0xff];
pub(super) const ZONE: Ink = [0xc9, 0xee, 0xd6];
pub(super) const ZONE_EDGE: Ink = [0x00, 0x35, 0x1a];
pub(super) const HATCH_REWORK: Ink = [0x9a, 0x65, 0x00];
pub(super) const HATCH_SCRAP: Ink = [0xa3, 0x14, 0x0c];
/// The same of a side of which nobody has said whether it is rework or scrap.
pub(super) const HATCH_OUT: Ink = [0x6b, 0x2f, 0x9c];

/// A fill, its simulated pale form, and the text on the fill.
pub(super) struct Tone {
    pub ground: Ink,
    pub pale: Ink,
    pub on: Ink,
}

/// The colours of a verdict; of none, where there is none.
pub(super) const fn tone(status: Option<Status>) -> Tone {
    let (ground, pale, on) = match status {
        Some(Status::Good) => ([0xc9, 0xee, 0xd6], [0xf1, 0xfa, 0xf4], [0x00, 0x35, 0x1a]),
        Some(Status::Rework) => ([0xf6, 0xae, 0x1e], [0xfc, 0xeb, 0xcb], [0x22, 0x15, 0x00]),
        Some(Status::ReMeasure) => ([0x6c, 0xa7, 0xeb], [0xd6, 0xe4, 0xf5], [0x00, 0x14, 0x2e]),
        Some(Status::OutOfLimits) => ([0x8a, 0x4f, 0xb8], [0xe6, 0xda, 0xf0], [0xff, 0xff, 0xff]),
        Some(Status::Scrap) => ([0xa3, 0x14, 0x0c], [0xeb, 0xcf, 0xcc], [0xff, 0xff, 0xff]),
        None => ([0xe6, 0xeb, 0xf1], [0xe6, 0xeb, 0xf1], [0x0e, 0x16, 0x20]),
    };
    Tone { ground, pale, on }
}

/// A way to set text.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Style {
    pub weight: Weight,
    pub size: f32,
    pub ink: Ink,
}

impl Style {
    const fn new(weight: Weight, size: f32, ink: Ink) -> Self {
        Self { weight, size, ink }
    }

    /// The same in another colour.
    pub const fn in_ink(self, ink: Ink) -> Self {
        Self { ink, ..self }
    }

    /// From one line to the next.
    pub fn line(self) -> f32 {
        self.size * 1.3
    }
}

pub(super) const TITLE: Style = Style::new(Weight::Semibold, 19.0, TEXT);
pub(super) const SUBTITLE: Style = Style::new(Weight::Regular, 11.5, TEXT);
pub(super) const HEADING: Style = Style::new(Weight::Semibold, 11.5, TEXT);
pub(super) const WORD: Style = Style::new(Weight::Semibold, 26.0, TEXT);
pub(super) const CARD: Style = Style::new(Weight::Semibold, 10.0, TEXT);
pub(super) const BODY: Style = Style::new(Weight::Regular, 9.0, TEXT);
pub(super) const STRONG: Style = Style::new(Weight::Semibold, 9.0, TEXT);
pub(super) const LABEL: Style = Style::new(Weight::Regular, 8.0, QUIET);
pub(super) const NOTE: Style = Style::new(Weight::Regular, 8.0, QUIET);
pub(super) const CELL: Style = Style::new(Weight::Regular, 8.8, TEXT);
pub(super) const VALUE: Style = Style::new(Weight::Semibold, 8.8, TEXT);
pub(super) const CHIP: Style = Style::new(Weight::Semibold, 7.6, TEXT);
pub(super) const FOOT: Style = Style::new(Weight::Regular, 7.6, QUIET);

/// The page's margins.
pub(super) const SIDE: f32 = 36.0;
pub(super) const TOP: f32 = 36.0;
pub(super) const BOTTOM: f32 = 48.0;
/// Where the content of pages after the first one begins, below their running line.
pub(super) const TOP_AFTER: f32 = 56.0;
/// Between blocks.
pub(super) const GAP: f32 = 12.0;
/// Round corners.
pub(super) const RADIUS: f32 = 5.0;
