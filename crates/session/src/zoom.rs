//! The scale of the window.

use serde::{Deserialize, Serialize};

/// The scale of the window in per cent, 75 to 300.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(from = "u16", into = "u16")]
pub struct Zoom(u16);

impl Zoom {
    /// As the system draws it.
    pub const NORMAL: Self = Self(100);
    /// Below this nobody reads the texts.
    pub const LEAST: Self = Self(75);
    /// Above this a page has no room on a usual screen.
    pub const MOST: Self = Self(300);
    /// How far a step goes.
    const STEP: u16 = 10;

    pub const fn percent(self) -> u16 {
        self.0
    }

    /// One step larger: to the next whole step.
    #[must_use]
    pub fn larger(self) -> Self {
        Self::from((self.0 / Self::STEP + 1) * Self::STEP)
    }

    /// One step smaller: to the whole step before it.
    #[must_use]
    pub fn smaller(self) -> Self {
        Self::from(self.0.saturating_sub(1) / Self::STEP * Self::STEP)
    }
}

impl Default for Zoom {
    fn default() -> Self {
        Self::NORMAL
    }
}

impl From<u16> for Zoom {
    /// What lies outside takes the nearest allowed scale: a window that nobody can read cannot be set right.
    fn from(percent: u16) -> Self {
        Self(percent.clamp(Self::LEAST.0, Self::MOST.0))
    }
}

impl From<Zoom> for u16 {
    fn from(zoom: Zoom) -> Self {
        zoom.0
    }
}
