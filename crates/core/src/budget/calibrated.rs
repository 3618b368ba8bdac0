//! Repeated measurements of a calibrated piece (ISO 15530-3).
//!
//! | term | what |
//! |---|---|
//! | `u_cal` | of the calibration, from its certificate |
//! | `u_p` | of the procedure: the standard deviation of the readings |
//! | `u_b` | of the bias: the expansion of the piece, or as given |
//! | `u_w` | of the parts: their expansion, form and roughness |
//! | b | the bias: mean of the readings minus the calibrated size |
//!
//! The edition of 2011 corrects the bias: `U = k √(u_cal² + u_p² + u_b² + u_w²)`. The technical specification of 2004 adds it where
//! it is not corrected: `U = k √(u_cal² + u_p² + u_w²) + |b|`. k is 2.

use super::{brief, count};
use crate::length::Length;
use crate::message::Say;
use crate::tolerance::Feature;

/// The fewest readings that the standard asks for.
pub const FEWEST_READINGS: usize = 20;

/// A calibrated piece and what is known beside its readings. Uncertainties in micrometres.
#[derive(Debug, Clone, PartialEq)]
pub struct Calibrated {
    /// The calibrated size.
    pub size: Length,
    /// Of the calibration.
    pub u_cal: f64,
    /// Of the bias.
    pub u_b: f64,
    /// Of the parts.
    pub u_w: f64,
    /// Hole or shaft, for files of readings.
    pub feature: Feature,
    /// Whether measured values are corrected by the bias before they are judged.
    pub is_corrected: bool,
    /// The readings in the budget's file.
    pub readings: Vec<Length>,
}

/// What the readings say.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Repeated {
    /// How many there are.
    pub readings: usize,
    /// Their mean, mm.
    pub mean_mm: f64,
    /// The bias, µm.
    pub bias: f64,
    /// Of the calibration, µm.
    pub u_cal: f64,
    /// Of the procedure, µm.
    pub u_p: f64,
    /// Of the bias, µm.
    pub u_b: f64,
    /// Of the parts, µm.
    pub u_w: f64,
    /// The expanded uncertainty by the edition of 2011, for corrected values, µm.
    pub expanded_2011: f64,
    /// The expanded uncertainty by the technical specification of 2004, for values that are not corrected, µm.
    pub expanded_2004: f64,
    /// Whether values are corrected.
    pub is_corrected: bool,
}

/// Why readings say nothing.
#[derive(Debug, Clone, PartialEq, Say)]
#[say(prefix = "budget-calibrated", error)]
pub enum CalibratedError {
    /// No standard deviation can be had.
    TooFew {
        /// How many there are.
        readings: usize,
    },
    /// Readings that cannot be of this piece.
    FarAway {
        /// The calibrated size.
        size: Length,
        /// The mean of the readings, mm.
        #[say(with = brief)]
        mean: f64,
    },
    /// Everything is zero.
    Nothing,
}

impl Calibrated {
    /// Evaluates readings: those given, or those of the file.
    ///
    /// # Errors
    /// [`CalibratedError`] for fewer than two, or a mean that is further than a millimetre from the calibrated size.
    pub fn evaluate(&self, readings: Option<&[Length]>) -> Result<Repeated, CalibratedError> {
        let readings = readings.unwrap_or(&self.readings);
        if readings.len() < 2 {
            return Err(CalibratedError::TooFew { readings: readings.len() });
        }
        // From the calibrated size, so that the digits of the deviations are kept; µm.
        let off: Vec<f64> =
            readings.iter().map(|reading| reading.saturating_sub(self.size).to_mm_f64() * 1_000.0).collect();
        let number = count(off.len());
        let bias = off.iter().sum::<f64>() / number;
        let mean_mm = self.size.to_mm_f64() + bias / 1_000.0;
        if 1_000.0 < bias.abs() {
            return Err(CalibratedError::FarAway { size: self.size, mean: mean_mm });
        }
        let u_p = (off.iter().map(|off| (off - bias).powi(2)).sum::<f64>() / (number - 1.0)).sqrt();
        let Self { u_cal, u_b, u_w, is_corrected, .. } = *self;
        let without = libm::hypot(libm::hypot(u_cal, u_p), u_w);
        let repeated = Repeated {
            readings: off.len(),
            mean_mm,
            bias,
            u_cal,
            u_p,
            u_b,
            u_w,
            expanded_2011: Repeated::K * libm::hypot(without, u_b),
            expanded_2004: Repeated::K * without + bias.abs(),
            is_corrected,
        };
        if repeated.expanded() <= 0.0 { Err(CalibratedError::Nothing) } else { Ok(repeated) }
    }
}

impl Repeated {
    /// The coverage factor of the standard.
    pub const K: f64 = 2.0;

    /// The expanded uncertainty that counts: that of 2011 for values that are corrected, otherwise that of 2004.
    pub const fn expanded(&self) -> f64 {
        if self.is_corrected { self.expanded_2011 } else { self.expanded_2004 }
    }

    /// Half of that.
    pub const fn u(&self) -> f64 {
        self.expanded() / Self::K
    }

    /// Its terms by their names in the standard, µm; the bias with its sign.
    pub const fn terms(&self) -> [(&'static str, f64); 5] {
        let Self { u_cal, u_p, u_b, u_w, bias, .. } = *self;
        [("u_cal", u_cal), ("u_p", u_p), ("u_b", u_b), ("u_w", u_w), ("bias", bias)]
    }

    /// Whether there are as many readings as the standard asks for.
    pub const fn is_enough(&self) -> bool {
        FEWEST_READINGS <= self.readings
    }
}
