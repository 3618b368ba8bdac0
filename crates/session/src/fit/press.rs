//! The joint of a press fit, from the fields of the page.

use fitcheck_core::length::Length;
use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_core::tolerance::Feature;
use fitcheck_core::tolerance::fit::Fit;
use fitcheck_core::tolerance::fit::materials::Materials;
use fitcheck_core::tolerance::fit::press::{Joint, Press, PressPart, Ratio};

use super::{FitField, FitPage};
use crate::state::PageState as _;

/// The coefficient of friction of the page, in thousandths, as `fit --friction` has it where nobody says otherwise.
pub const FRICTION: u16 = 120;

impl FitPage {
    /// Reads the joint; there is none until its length and the hub are given.
    pub(super) fn read_press(&mut self) {
        let lengths = self.length(FitField::PressLength).zip(self.length(FitField::HubOuter));
        let (Some((length, hub_outer)), Some(fit)) = (lengths, self.fit.as_ref()) else { return };
        let bore = self.length(FitField::ShaftBore);
        let is_empty = self.text(FitField::ShaftBore).trim().is_empty();
        let Some(shaft_bore) = bore.or_else(|| is_empty.then_some(Length::ZERO)) else { return };
        let press = self.press_of(fit, [length, hub_outer, shaft_bore]);
        self.press = press.transpose();
    }

    fn press_of(&self, fit: &Fit, [length, hub_outer, shaft_bore]: [Length; 3]) -> Result<Option<Press>, Message> {
        let Some(friction) = Ratio::from_thousandths(FRICTION) else { return Ok(None) };
        let (Some(hub), Some(shaft)) = (self.press_part(Feature::Hole)?, self.press_part(Feature::Shaft)?) else {
            return Ok(None);
        };
        let joint = Joint { length, hub_outer, shaft_bore, roughness: Length::ZERO, friction, hub, shaft };
        Press::of(fit, &joint).map(Some).map_err(|error| error.message())
    }

    /// What a part is made of, by its expansion: the page knows no more of a material. `None` while that is being typed.
    fn press_part(&self, part: Feature) -> Result<Option<PressPart>, Message> {
        let Some(expansion) = self.expansion(part) else { return Ok(None) };
        let material = Materials::shipped().of_expansion(expansion).ok_or_else(|| message!("fit-press-material"))?;
        material.press_part().map(Some).map_err(|error| error.message())
    }
}
