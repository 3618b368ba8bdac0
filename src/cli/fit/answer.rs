//! The answer for one fit: computed by the core, put together here.

use super::FitInputs;
use super::heat::{Heat, Heated};
use super::press::NamedJoint;
use crate::cli::{CliError, IntoCliError as _};
use crate::length::Length;
use crate::tolerance::fit::equivalent::{Difference, equivalent};
use crate::tolerance::fit::press::Press;
use crate::tolerance::fit::{Fit, FitError};
use crate::tolerance::{Callout, Feature, PartTolerance, Tolerance, ToleranceClass};
use crate::verdict::Status;
use crate::verdict::fit::{Actual, Possible};

/// Everything about one fit.
pub(super) struct Answer<'a> {
    pub callout: Callout,
    pub hole: PartTolerance,
    pub shaft: PartTolerance,
    pub fit: Fit,
    pub equivalent: Option<Equivalent>,
    pub measured: Measured,
    pub heated: Option<(&'a Heat, Heated)>,
    pub press: Option<(&'a NamedJoint, Press)>,
}

/// The fit in the other basis.
pub(super) struct Equivalent {
    pub callout: Callout,
    /// Its fit and how far it is from the one that was asked for, or why it is not defined.
    pub fit: Result<(Fit, Difference), FitError>,
}

/// The measured parts.
#[derive(Clone, Copy)]
pub(super) enum Measured {
    None,
    One(Possible),
    Both(Actual),
}

impl Measured {
    /// The worse of the measured parts.
    pub(super) fn status(&self) -> Option<Status> {
        match self {
            Self::None => None,
            Self::One(part) => Some(part.verdict.status()),
            Self::Both(actual) => Some(actual.status()),
        }
    }

    fn clearance(&self) -> Option<Length> {
        match self {
            Self::Both(actual) => Some(actual.clearance),
            Self::None | Self::One(_) => None,
        }
    }
}

impl<'a> Answer<'a> {
    /// The classes, where both parts have one.
    pub(super) fn classes(&self) -> Option<(ToleranceClass, ToleranceClass)> {
        self.hole.class().zip(self.shaft.class())
    }

    /// The answer, or why there is none.
    pub(super) fn of(callout: Callout, given: &'a FitInputs<'_>) -> Result<Self, CliError> {
        let fit = Fit::of_callout(&callout, given.sources).said()?;
        let Tolerance::Fit { hole, shaft } = callout.tolerance() else {
            return Err(FitError::OneSided { callout }).said();
        };
        let equivalent = hole.class().zip(shaft.class()).and_then(|(hole, shaft)| equivalent(hole, shaft)).and_then(
            |(hole, shaft)| {
                let callout = Callout::fit(callout.nominal(), hole, shaft).ok()?;
                let fit = Fit::of_callout(&callout, given.sources).map(|other| {
                    let difference = Difference::between(&fit, &other);
                    (other, difference)
                });
                Some(Equivalent { callout, fit })
            },
        );
        let measured = match (given.hole, given.shaft) {
            (Some(hole), Some(shaft)) => Measured::Both(Actual::of(&fit, hole, shaft)),
            (Some(hole), None) => Measured::One(Possible::of(&fit, Feature::Hole, hole)),
            (None, Some(shaft)) => Measured::One(Possible::of(&fit, Feature::Shaft, shaft)),
            (None, None) => Measured::None,
        };
        let heated = match &given.heat {
            Some(heat) => {
                let heated = heat.of(&fit, measured.clearance()).ok_or(FitError::TooLarge).said()?;
                Some((heat, heated))
            }
            None => None,
        };
        let press = match &given.press {
            Some(named) => Some((named, Press::of(&fit, &named.joint).said()?)),
            None => None,
        };
        Ok(Self { callout, hole, shaft, fit, equivalent, measured, heated, press })
    }
}
