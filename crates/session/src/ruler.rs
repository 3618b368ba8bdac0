//! How large a millimetre is on the screen: whoever knows it has held a bank card to it. Systems often say it wrong.

use serde::{Deserialize, Serialize};

/// The width of a bank card, mm (ISO/IEC 7810, ID-1).
const CARD: f32 = 85.6;

/// The width of a bank card on the screen, in dots of a window at 100 %.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(from = "u16", into = "u16")]
pub struct Ruler(u16);

/// How the length of a bank card on the screen is brought to that of a real one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum RulerStep {
    MuchShorter,
    Shorter,
    Longer,
    MuchLonger,
}

impl RulerStep {
    pub const ALL: [Self; 4] = [Self::MuchShorter, Self::Shorter, Self::Longer, Self::MuchLonger];
}

impl Ruler {
    /// On a screen of 96 dots an inch.
    pub const USUAL: Self = Self(324);
    /// On a wall, and on a very fine screen.
    const LEAST: u16 = 120;
    const MOST: u16 = 1_200;
    /// How far a step goes: a quarter of a millimetre on a usual screen.
    const STEP: u16 = 1;
    /// How far a large step goes.
    const LARGE: u16 = 12;

    /// The card's width.
    pub fn dots(self) -> f32 {
        f32::from(self.0)
    }

    /// The dots of a millimetre.
    pub fn millimetre(self) -> f32 {
        self.dots() / CARD
    }

    #[must_use]
    pub fn moved(self, step: RulerStep) -> Self {
        Self::from(match step {
            RulerStep::MuchShorter => self.0.saturating_sub(Self::LARGE),
            RulerStep::Shorter => self.0.saturating_sub(Self::STEP),
            RulerStep::Longer => self.0.saturating_add(Self::STEP),
            RulerStep::MuchLonger => self.0.saturating_add(Self::LARGE),
        })
    }
}

impl From<u16> for Ruler {
    fn from(dots: u16) -> Self {
        Self(dots.clamp(Self::LEAST, Self::MOST))
    }
}

impl From<Ruler> for u16 {
    fn from(ruler: Ruler) -> Self {
        ruler.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_card_of_324_dots_is_96_dots_an_inch() {
        assert!((Ruler::USUAL.millimetre() * 25.4 - 96.0).abs() < 0.2);
        assert_eq!(Ruler::from(0), Ruler::from(120));
        assert_eq!(Ruler::USUAL.moved(RulerStep::MuchLonger).moved(RulerStep::MuchShorter), Ruler::USUAL);
    }
}
