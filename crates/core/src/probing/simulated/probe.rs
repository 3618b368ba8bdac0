//! The simulated probe: its ball, its scatter, and the errors that calibration left.

use serde::{Deserialize, Serialize};

use super::{Figure, Lobes, WorkpieceError, in_range};

/// The largest ball and offset, mm.
const LARGEST: f64 = 100.0;

/// The probe.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Probe {
    /// Scatter of the trigger point along the probing direction, one sigma, millimetres.
    #[serde(default)]
    pub trigger_scatter: f64,
    /// Radius of the ball, millimetres; zero is a point.
    #[serde(default)]
    pub ball_radius: f64,
    /// How much larger the control takes that radius to be, millimetres.
    #[serde(default)]
    pub calibration_error: f64,
    /// How far the ball really lies off the spindle's axis, millimetres; if not given, calibration found it exactly.
    #[serde(default, deserialize_with = "super::reading::exactly_or_none")]
    pub offset: Option<[f64; 2]>,
    /// Pre-travel by direction in the plane X/Y: the contact is reported this much later, millimetres.
    #[serde(default)]
    pub lobing: Lobes,
}

impl Probe {
    /// A perfect point.
    pub const STILL: Self =
        Self { trigger_scatter: 0.0, ball_radius: 0.0, calibration_error: 0.0, offset: None, lobing: Lobes::NONE };

    /// Half a micrometre of scatter, as is usual for touch probes in machines.
    pub const USUAL: Self = Self { trigger_scatter: 0.0005, ..Self::STILL };

    pub(super) fn check(&self) -> Result<(), WorkpieceError> {
        in_range(Figure::ProbeScatter, self.trigger_scatter, 0.0, 1.0)?;
        in_range(Figure::BallRadius, self.ball_radius, 0.0, LARGEST)?;
        // The control's radius is never below zero.
        in_range(Figure::CalibrationError, self.calibration_error, -self.ball_radius, 1.0)?;
        for offset in self.offset.into_iter().flatten() {
            in_range(Figure::Offset, offset, -LARGEST, LARGEST)?;
        }
        in_range(Figure::Lobing, self.lobing.amplitude, 0.0, 1.0)?;
        in_range(Figure::LobingAngle, self.lobing.angle, -360.0, 360.0)?;
        in_range(Figure::LobingCount, f64::from(self.lobing.count), 0.0, 100.0)
    }

    /// How much later a contact is reported in this direction: only the share in X/Y counts.
    pub(super) fn pre_travel(&self, [x, y, _]: [f64; 3]) -> f64 {
        if self.lobing.amplitude <= 0.0 { 0.0 } else { self.lobing.height(libm::atan2(y, x)) * libm::hypot(x, y) }
    }
}
