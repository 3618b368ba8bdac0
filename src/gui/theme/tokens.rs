//! What `assets/theme.toml` holds: the colours of every look, and the sizes.

use eframe::egui::Color32;
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
        /// The colours of one look.
        #[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
        #[serde(deny_unknown_fields)]
        pub struct Palette { $($(#[$doc])* pub $name: Hex),* }
    };
}

palette! {
    /// Behind the cards.
    canvas
    /// Cards and fields.
    surface
    /// Charts and wells.
    sunken
    /// Tonal buttons, and what is under the pointer.
    hover
    /// What is chosen.
    tint
    /// Thin lines between things.
    line
    text
    /// Secondary text.
    quiet
    /// The edge of a field.
    edge
    /// Around what has the focus.
    focus
    /// Errors beside fields.
    error
    /// Lines and points of pictures and charts.
    data
    /// The main action, and the page where one is.
    accent
    on_accent
    good
    on_good
    rework
    on_rework
    scrap
    on_scrap
    re_measure
    on_re_measure
    out_of_limits
    on_out_of_limits
    /// No result.
    none
    on_none
    /// GOOD, simulated.
    pale_good
    /// REWORK, simulated.
    pale_rework
    /// SCRAP, simulated.
    pale_scrap
    /// RE-MEASURE, simulated.
    pale_re_measure
    /// OUT OF LIMITS, simulated.
    pale_out_of_limits
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
    /// Hatching of a side where neither is known.
    hatch_out
    /// The hole's zone in the picture of a fit.
    hole
    /// The shaft's.
    shaft
    /// Words of the language in an NC program.
    keyword
    /// What has just happened, in the corner.
    toast
    on_toast
}

impl Palette {
    /// The fill of a verdict and the colour on it; `None` is no result.
    pub const fn of_status(&self, status: Option<Status>) -> (Color32, Color32) {
        match status {
            Some(Status::Good) => (self.good.0, self.on_good.0),
            Some(Status::Rework) => (self.rework.0, self.on_rework.0),
            Some(Status::Scrap) => (self.scrap.0, self.on_scrap.0),
            Some(Status::ReMeasure) => (self.re_measure.0, self.on_re_measure.0),
            Some(Status::OutOfLimits) => (self.out_of_limits.0, self.on_out_of_limits.0),
            None => (self.none.0, self.on_none.0),
        }
    }

    /// The same within an edge.
    pub const fn of_pale(&self, status: Option<Status>) -> (Color32, Color32) {
        let fill = match status {
            Some(Status::Good) => self.pale_good,
            Some(Status::Rework) => self.pale_rework,
            Some(Status::Scrap) => self.pale_scrap,
            Some(Status::ReMeasure) => self.pale_re_measure,
            Some(Status::OutOfLimits) => self.pale_out_of_limits,
            None => return self.of_status(None),
        };
        (fill.0, self.on_pale.0)
    }
}

/// Sizes in points.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sizes {
    /// The rail and key caps.
    pub tiny: f32,
    /// Table heads, labels, remarks.
    pub small: f32,
    pub body: f32,
    pub limits: f32,
    /// The name of a page.
    pub title: f32,
    /// The head of a card.
    pub heading: f32,
    /// A figure that stands out.
    pub figure: f32,
    /// A callout that is typed.
    pub callout: f32,
    /// Values that are typed or measured.
    pub value: f32,
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
    /// The height of a row of a list, with a mouse.
    pub row: f32,
    /// The same where rows stand close.
    pub close_row: f32,
    /// The side of a key on the keypad.
    pub key: f32,
}

/// The theme file.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Tokens {
    pub light: Palette,
    pub dark: Palette,
    /// High contrast, black on white and white on black.
    pub contrast: Palette,
    pub inverted: Palette,
    pub sizes: Sizes,
}
