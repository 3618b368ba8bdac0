//! How the window looks.

/// The colours of the window.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Theme {
    /// As the system is set.
    #[default]
    System,
    Light,
    Dark,
    /// High contrast: black on white.
    Contrast,
    /// High contrast: white on black.
    Inverted,
}

impl Theme {
    /// Every choice.
    pub const ALL: [Self; 5] = [Self::System, Self::Light, Self::Dark, Self::Contrast, Self::Inverted];
}

/// Who the window is for.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Mode {
    /// Everything, for a desk.
    #[default]
    Full,
    /// Measuring, results and help, for fingers and two metres.
    Operator,
}

impl Mode {
    /// Every choice.
    pub const ALL: [Self; 2] = [Self::Full, Self::Operator];
}

/// What stands before the decimals of a number in the window.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum DecimalSign {
    /// As the language writes it.
    #[default]
    OfLanguage,
    Point,
    Comma,
}

impl DecimalSign {
    /// Every choice.
    pub const ALL: [Self; 3] = [Self::OfLanguage, Self::Point, Self::Comma];
}

/// How high the rows of lists are with a mouse; by touch they are as high as a finger needs.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum RowHeight {
    #[default]
    Usual,
    Close,
}

impl RowHeight {
    /// Every choice.
    pub const ALL: [Self; 2] = [Self::Usual, Self::Close];
}

/// How high everything is that is pressed.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Density {
    /// As it is used: high once a finger has touched the window, until a mouse moves over it.
    #[default]
    ByUse,
    Mouse,
    /// For fingers and gloves.
    Touch,
}

impl Density {
    /// Every choice.
    pub const ALL: [Self; 3] = [Self::ByUse, Self::Mouse, Self::Touch];
}
