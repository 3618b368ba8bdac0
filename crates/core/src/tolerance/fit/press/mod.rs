//! Press fits: the pressure in the joint of an interference fit, what the joint holds, its stresses, and how it is joined.
//!
//! | file | what |
//! |---|---|
//! | here | what is asked and what is answered |
//! | `cylinders` | thick cylinders by Lamé: pressure, stresses, where a part yields |
//! | `elastic` | modulus, Poisson's ratio and yield strength of a material |
//! | `remark` | what to know before the answer is used |
//!
//! This is engineering, not a verdict, so it counts in floats: megapascals, newtons, millimetres. What a joint holds comes from the
//! smallest interference less what the roughness loses (0.8 of both Rz, DIN 7190-1) and is rounded down; pressing force, stresses and
//! temperatures come from the largest interference without that loss and are rounded to the unfavourable side. Everything is elastic:
//! a joint whose parts yield is said to, and nothing that depends on it is answered. Both parts are as long as the joint, at 20 °C and
//! at rest.

mod cylinders;
mod elastic;
mod remark;

pub use cylinders::Cylinders;
pub use elastic::{Elastic, Ratio};
pub use remark::{PressError, PressRemark};

use super::Fit;
use super::thermal::{Expansion, Range};
use crate::length::{Length, Unit};
use crate::tolerance::Feature;

/// What roughness loses of an interference: this part of both Rz, in fifths (0.8, DIN 7190-1).
const SMOOTHED_FIFTHS: i64 = 4;

/// The play while joining is this part of the diameter: a thousandth, as DIN 7190 advises.
const PLAY: i64 = 1_000;

/// The temperature of liquid nitrogen in °C; no shaft gets colder in a shop.
const NITROGEN: f64 = -196.0;

/// What one part is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PressPart {
    /// How it gives way.
    pub elastic: Elastic,
    /// How much it expands when it is heated.
    pub expansion: Expansion,
    /// How much it shrinks when it is cooled far below 0 °C, where that is known; most metals shrink less than they expand.
    pub contraction: Option<Expansion>,
    /// At which temperatures it expands so.
    pub range: Range,
}

/// A joint as it is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Joint {
    /// How long hub and shaft touch.
    pub length: Length,
    /// Outer diameter of the hub.
    pub hub_outer: Length,
    /// Bore of the shaft; zero for a solid one.
    pub shaft_bore: Length,
    /// Roughness Rz of hub and shaft together; zero counts no loss.
    pub roughness: Length,
    /// Coefficient of friction, for pressing and holding alike.
    pub friction: Ratio,
    /// The hub.
    pub hub: PressPart,
    /// The shaft.
    pub shaft: PressPart,
}

/// Stresses of one part at the largest interference, in MPa, rounded up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PartStress {
    /// Tangential stress where it is largest: at the bore; negative is compression.
    pub tangential: f64,
    /// Equivalent stress by von Mises in plane stress.
    pub equivalent: f64,
    /// The yield strength that it was compared with.
    pub yield_strength: Option<u32>,
}

impl PartStress {
    /// Whether the part stays elastic; `None` where its yield strength is not known.
    pub fn is_elastic(&self) -> Option<bool> {
        Some(self.equivalent <= f64::from(self.yield_strength?))
    }
}

/// A press fit.
#[derive(Debug, Clone, PartialEq)]
pub struct Press {
    /// Smallest interference less the loss by roughness, not below zero, and largest interference.
    pub interference: [Length; 2],
    /// What the roughness loses of the interference.
    pub loss: Length,
    /// Smallest and largest pressure in the joint, MPa; the largest only while both parts stay elastic, as far as is known.
    pub pressure: [Option<f64>; 2],
    /// Axial force that the joint holds at least, N; only if it stays elastic at the largest interference, as far as is known.
    pub axial_force: Option<f64>,
    /// Torque that the joint holds at least, N·m; as for the axial force, and not both at once.
    pub torque: Option<f64>,
    /// Force to press the parts together at most, N.
    pub pressing_force: Option<f64>,
    /// Stresses of the hub.
    pub hub: PartStress,
    /// Stresses of the shaft.
    pub shaft: PartStress,
    /// Play while joining.
    pub play: Length,
    /// To what the hub is heated for that play, °C; `None` where the coefficient does not hold there.
    pub heat_hub: Option<f64>,
    /// To what the shaft is cooled instead, °C; `None` where no bath is so cold, or the material does not shrink.
    pub cool_shaft: Option<f64>,
    /// What to know before the answer is used, the most important first.
    pub remarks: Vec<PressRemark>,
}

impl Press {
    /// The press fit of a fit and its joint.
    ///
    /// # Errors
    /// [`PressError`] for a fit that never has an interference, and for sizes that are no joint.
    pub fn of(fit: &Fit, joint: &Joint) -> Result<Self, PressError> {
        let [minimum, maximum] = [fit.maximum_clearance().negated(), fit.minimum_clearance().negated()];
        Self::of_interference(fit.nominal(), [minimum, maximum], joint)
    }

    /// The same of a diameter with its smallest and largest interference; a negative one is a clearance.
    ///
    /// # Errors
    /// [`PressError`], as for [`Self::of`].
    pub fn of_interference(
        nominal: Length,
        [minimum, maximum]: [Length; 2],
        joint: &Joint,
    ) -> Result<Self, PressError> {
        if maximum <= Length::ZERO {
            return Err(PressError::NoInterference { clearance: maximum.negated() });
        }
        let cylinders = Cylinders::of(nominal, joint)?;
        let loss = Length::from_nanometres(joint.roughness.nanometres().saturating_mul(SMOOTHED_FIFTHS) / 5)
            .unwrap_or(Length::MAX);
        let smallest = minimum.saturating_sub(loss).max(Length::ZERO);
        let pressure = cylinders.pressure(maximum);
        let [hub, shaft] = cylinders.stresses(pressure);
        let is_elastic = [hub, shaft].iter().all(|part| part.is_elastic() != Some(false));
        let area = std::f64::consts::PI * nominal.to_mm_f64() * joint.length.to_mm_f64() * joint.friction.value();
        let least = cylinders.pressure(smallest);
        let held = (is_elastic && Length::ZERO < smallest).then_some(area * least);
        let play = Length::from_nanometres(nominal.nanometres() / PLAY).unwrap_or(Length::ZERO);
        let gap = maximum.checked_add(play).unwrap_or(Length::MAX).to_mm_f64() / nominal.to_mm_f64();
        let hot = 20.0 + gap / per_kelvin(joint.hub.expansion);
        let cold = 20.0 - gap / per_kelvin(joint.shaft.contraction.unwrap_or(joint.shaft.expansion));
        let mut press = Self {
            interference: [smallest, maximum],
            loss,
            pressure: [is_elastic.then(|| down(least, 10.0)), is_elastic.then(|| up(pressure, 10.0))],
            axial_force: held.map(|force| down(force, 1.0)),
            torque: held.map(|force| down(force * nominal.to_mm_f64() / 2_000.0, 10.0)),
            pressing_force: is_elastic.then(|| up(area * pressure, 1.0)),
            hub,
            shaft,
            play,
            heat_hub: Some(up(hot, 1.0)).filter(|hot| hot.is_finite() && *hot <= degrees(joint.hub.range.most)),
            cool_shaft: Some(down(cold, 1.0)).filter(|cold| NITROGEN <= *cold && *cold < 20.0),
            remarks: Vec::new(),
        };
        press.remarks = press.remarks_of(minimum, joint);
        Ok(press)
    }

    fn remarks_of(&self, minimum: Length, joint: &Joint) -> Vec<PressRemark> {
        let mut remarks = Vec::new();
        let parts = [(Feature::Hole, self.hub), (Feature::Shaft, self.shaft)];
        for (part, stress) in parts {
            match (stress.is_elastic(), stress.yield_strength) {
                (Some(false), Some(limit)) => {
                    remarks.push(PressRemark::Yields {
                        part,
                        stress: figure(stress.equivalent),
                        limit: limit.to_string(),
                    });
                }
                (None, _) => remarks.push(PressRemark::YieldUnknown { part }),
                _ => {}
            }
        }
        if minimum <= Length::ZERO {
            remarks.push(PressRemark::MayBeLoose { clearance: minimum.negated() });
        } else if self.interference.first() == Some(&Length::ZERO) {
            remarks.push(PressRemark::AllSmoothed { loss: self.loss });
        }
        if joint.roughness == Length::ZERO {
            remarks.push(PressRemark::NoRoughness);
        }
        if self.heat_hub.is_none() {
            remarks.push(PressRemark::TooHot { most: joint.hub.range.most });
        }
        if self.cool_shaft.is_none() {
            remarks.push(PressRemark::TooCold);
        } else if joint.shaft.contraction.is_none() {
            remarks.push(PressRemark::ContractionUnknown);
        }
        remarks
    }

    /// Whether both parts stay elastic: `None` where a yield strength is not known and the other part does not yield.
    pub fn is_elastic(&self) -> Option<bool> {
        match [self.hub.is_elastic(), self.shaft.is_elastic()] {
            [Some(false), _] | [_, Some(false)] => Some(false),
            [Some(true), Some(true)] => Some(true),
            _ => None,
        }
    }
}

/// A coefficient of expansion per kelvin.
fn per_kelvin(expansion: Expansion) -> f64 {
    f64::from(expansion.thousandths()) * 1e-9
}

fn degrees(temperature: super::thermal::Temperature) -> f64 {
    f64::from(temperature.thousandths()) / 1e3
}

/// The next lower multiple of one over a scale.
fn down(value: f64, scale: f64) -> f64 {
    (value * scale).floor() / scale
}

/// The next higher multiple of one over a scale.
fn up(value: f64, scale: f64) -> f64 {
    (value * scale).ceil() / scale
}

/// A figure of an answer, with a point and only the decimals it has.
pub fn figure(value: f64) -> String {
    // What was rounded may be a negative zero.
    let text = format!("{:.1}", value + 0.0);
    text.strip_suffix(".0").map_or_else(|| text.clone(), ToOwned::to_owned)
}

/// An interference in micrometres.
pub fn micrometres(length: Length) -> String {
    length.exact(Unit::Micrometre, 0)
}
