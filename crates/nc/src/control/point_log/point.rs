//! One measurement of cycle 444, and whether its figures agree.

use fitcheck_core::length::{Length, Unit};
use fitcheck_core::probing::vector;
use fitcheck_core::tolerance::Feature;
use fitcheck_core::verdict::{self, Status};
use jiff::civil::DateTime;

use super::error::PointFault;

/// How far figures of one measurement may differ: the last digit of the control's logs, 0.1 µm.
pub const LAST_FIGURE: Length = Length::constant(100);

/// One measurement: a point on a surface. Coordinates are in the order X, Y, Z.
#[derive(Debug, Clone, PartialEq)]
pub struct PointLog {
    /// When it was measured.
    pub date_time: Option<DateTime>,
    /// Path of the NC program on the control.
    pub program: Option<String>,
    /// Whether a simulation has written it: nobody measured.
    pub is_simulated: bool,
    /// Millimetres or inches: what the page shows. The figures themselves are exact lengths.
    pub unit: Unit,
    /// The nominal point (Q263, Q264, Q294).
    pub nominal: [Length; 3],
    /// The surface's normal as it was programmed (Q581 to Q583): of any length except zero.
    pub normal: [f64; 3],
    /// The measured point (Q151 to Q153).
    pub measured: [Length; 3],
    /// Measured minus nominal point (Q161 to Q163).
    pub deviations: [Length; 3],
    /// The deviation along the normal (Q164): oversize above zero, undersize below.
    pub deviation: Length,
    /// The text of the tolerance (QS400) as it was programmed.
    pub tolerance: String,
    /// What the tolerance permits; `None` if it is one of the documented forms without a tolerance.
    pub band: Option<Band>,
    /// The status (Q183); `None` for -1, not judged.
    pub status: Option<Status>,
}

/// Permitted deviations along the normal; both limits belong to the band.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Band {
    /// The largest.
    pub upper: Length,
    /// The smallest.
    pub lower: Length,
}

impl Band {
    /// Good on or between the limits; above them material is left, rework; below them material is missing, scrap.
    pub fn status(&self, deviation: Length) -> Status {
        verdict::classify(Some(Feature::Shaft), self.lower, self.upper, deviation)
    }
}

impl PointLog {
    /// The normal with a length of one.
    ///
    /// # Errors
    /// [`PointFault::Normal`] if it has no direction or is not finite.
    pub fn unit_normal(&self) -> Result<[f64; 3], PointFault> {
        let given = || self.normal.map(|part| part.to_string()).join(", ");
        vector::direction(self.normal).ok_or_else(|| PointFault::Normal { given: given() })
    }

    /// Checks that the figures agree: each deviation with its points, the deviation along the normal with those of the
    /// axes, both to the last digit of 0.1 µm; the status with the band, exactly.
    ///
    /// # Errors
    /// [`PointFault`]: the first contradiction.
    pub fn check(&self) -> Result<(), PointFault> {
        if self.unit == Unit::Micrometre {
            return Err(PointFault::Unit);
        }
        for (axis, ((deviation, measured), nominal)) in
            ["X", "Y", "Z"].into_iter().zip(self.deviations.iter().zip(self.measured).zip(self.nominal))
        {
            let difference = measured.saturating_sub(nominal);
            if LAST_FIGURE < deviation.saturating_sub(difference).abs() {
                return Err(PointFault::Deviation { axis, given: *deviation, difference });
            }
        }
        let along = vector::dot(self.unit_normal()?, self.deviations.map(Length::to_mm_f64));
        let along = Length::from_mm_f64(along).unwrap_or(Length::MAX);
        if LAST_FIGURE < self.deviation.saturating_sub(along).abs() {
            return Err(PointFault::Along { given: self.deviation, along });
        }
        if let Some(Band { upper, lower }) = self.band
            && upper < lower
        {
            return Err(PointFault::Band { upper, lower });
        }
        let status = self.band.map(|band| band.status(self.deviation));
        if self.status != status {
            return Err(PointFault::Status { given: self.status, status });
        }
        Ok(())
    }
}
