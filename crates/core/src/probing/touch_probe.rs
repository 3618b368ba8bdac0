//! What the touch-probe table says about a probe: clearances, longest path, feeds, calibration.
//!
//! `control::probe_table` reads `tchprobe.tp`.

use crate::length::Length;

/// One row of the touch-probe table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct TouchProbe {
    /// Its number (NO).
    pub number: u32,
    /// Centre offset in reference and minor axis, found by calibration (`CAL_OF1`, `CAL_OF2`).
    pub offset: [Length; 2],
    /// Probing feed, mm/min (F).
    pub feed: u32,
    /// Rapid traverse in probing cycles, mm/min (FMAX).
    pub rapid: u32,
    /// The longest probing path (DIST): no contact within it is an error.
    pub longest_path: Length,
    /// Set-up clearance (`SET_UP`); Q320 is added to it.
    pub set_up: Length,
}

impl Default for TouchProbe {
    /// The probe of the built-in table.
    fn default() -> Self {
        Self {
            number: 1,
            offset: [Length::ZERO; 2],
            feed: 100,
            rapid: 2000,
            longest_path: Length::constant(50_000_000),
            set_up: Length::constant(2_000_000),
        }
    }
}
