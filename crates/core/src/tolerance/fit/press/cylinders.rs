//! Two thick cylinders, one in the other, by Lamé: plane stress, elastic.

use super::{Joint, PartStress, PressError, up};
use crate::length::Length;

/// Hub and shaft of a joint.
#[derive(Debug, Clone, Copy)]
pub struct Cylinders {
    diameter: f64,
    /// The squares of the hub's diameter ratio d/D and of the shaft's ratio dᵢ/d.
    hub_square: f64,
    shaft_square: f64,
    is_solid: bool,
    /// How much both give way together, per MPa.
    compliance: f64,
    yields: [Option<u32>; 2],
}

impl Cylinders {
    /// The cylinders of a joint of this diameter.
    ///
    /// # Errors
    /// [`PressError`] for a hub that is no larger, a bore that is no smaller than the joint, and for a length, a roughness or a
    /// friction that is none.
    pub fn of(nominal: Length, joint: &Joint) -> Result<Self, PressError> {
        let Joint { length, hub_outer, shaft_bore, roughness, friction, hub, shaft } = *joint;
        if length <= Length::ZERO {
            return Err(PressError::Length { length });
        }
        if hub_outer <= nominal {
            return Err(PressError::HubOuter { given: hub_outer, nominal });
        }
        if shaft_bore < Length::ZERO || nominal <= shaft_bore {
            return Err(PressError::ShaftBore { given: shaft_bore, nominal });
        }
        if roughness < Length::ZERO {
            return Err(PressError::Roughness { given: roughness });
        }
        if friction.value() <= 0.0 {
            return Err(PressError::Friction);
        }
        let square = |inner: Length, outer: Length| (inner.to_mm_f64() / outer.to_mm_f64()).powi(2);
        let hub_square = square(nominal, hub_outer);
        let shaft_square = square(shaft_bore, nominal);
        let shape = |square: f64| (1.0 + square) / (1.0 - square);
        let compliance = (shape(hub_square) + hub.elastic.poisson.value()) / hub.elastic.modulus()
            + (shape(shaft_square) - shaft.elastic.poisson.value()) / shaft.elastic.modulus();
        let yields = [hub.elastic.yield_mpa, shaft.elastic.yield_mpa];
        let is_solid = shaft_bore == Length::ZERO;
        Ok(Self { diameter: nominal.to_mm_f64(), hub_square, shaft_square, is_solid, compliance, yields })
    }

    /// The pressure of an interference of the diameters, MPa: `p = δ / (d (K_A/E_A + K_I/E_I))`.
    pub fn pressure(&self, interference: Length) -> f64 {
        interference.to_mm_f64() / self.diameter / self.compliance
    }

    /// The stresses of hub and shaft at a pressure, MPa: tangential and von Mises, where each is largest, rounded up.
    pub fn stresses(&self, pressure: f64) -> [PartStress; 2] {
        let [hub_yield, shaft_yield] = self.yields;
        let wall = 1.0 - self.hub_square;
        let hub = PartStress {
            tangential: up(pressure * (1.0 + self.hub_square) / wall, 10.0),
            equivalent: up(pressure * self.hub_square.mul_add(self.hub_square, 3.0).sqrt() / wall, 10.0),
            yield_strength: hub_yield,
        };
        // A solid shaft has the same pressure everywhere; a hollow one has the largest stress at its bore, however small that is.
        let factor = if self.is_solid { 1.0 } else { 2.0 / (1.0 - self.shaft_square) };
        let equivalent = up(pressure * factor, 10.0);
        [hub, PartStress { tangential: -equivalent, equivalent, yield_strength: shaft_yield }]
    }
}
