//! How contacts spread the scatter of a touch into the diameter.

use super::{brief, count};
use crate::message::Say;
use crate::probing::Contact;
use crate::probing::circle::{CircleError, Uncertainty, evaluate};

/// The most touches of a circle.
const MOST: u32 = 1_000;

/// Contacts on a circle, as far as they matter for the uncertainty of its diameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Geometry {
    /// How many.
    pub touches: usize,
    /// The angle from one to the next in degrees; `None` for contacts that were really taken.
    pub step_deg: Option<f64>,
    /// u(D) / s: the uncertainty of the diameter in units of that of one touch.
    pub factor: f64,
}

/// Why there is no such geometry.
#[derive(Debug, Clone, PartialEq, Say)]
#[say(prefix = "budget-geometry", error)]
pub enum GeometryError {
    /// Fewer than three touches, or very many.
    #[say(args(most = MOST))]
    Touches {
        /// What was given.
        touches: u32,
    },
    /// A step of zero or less, or touches that go round more than once.
    Step {
        /// How many touches.
        touches: u32,
        /// What was given.
        #[say(with = brief)]
        step: f64,
        /// The largest step for that many.
        #[say(with = brief)]
        most: f64,
    },
    /// Contacts that do not make a circle.
    #[say(transparent)]
    Circle(#[from] CircleError),
}

impl Geometry {
    /// Touches at equal steps of an angle.
    ///
    /// ```
    /// use fitcheck_core::budget::Geometry;
    ///
    /// let short_arc = Geometry::steps(3, 60.0)?;
    /// assert!((short_arc.factor - 3.464).abs() < 0.0005);
    /// # Ok::<(), fitcheck_core::budget::GeometryError>(())
    /// ```
    ///
    /// # Errors
    /// [`GeometryError`] for fewer than three touches, or touches that go round more than once.
    pub fn steps(touches: u32, step_deg: f64) -> Result<Self, GeometryError> {
        if !(3..=MOST).contains(&touches) {
            return Err(GeometryError::Touches { touches });
        }
        let most = 360.0 / f64::from(touches);
        // 360 / 7 as a decimal belongs to the full circle.
        if !(0.01..=most + 1e-3).contains(&step_deg) {
            return Err(GeometryError::Step { touches, step: step_deg, most });
        }
        let angles: Vec<f64> = (0..touches).map(|touch| (f64::from(touch) * step_deg).to_radians()).collect();
        let factor = Uncertainty::of_angles(&angles).diameter;
        Ok(Self { touches: angles.len(), step_deg: Some(step_deg), factor })
    }

    /// Contacts that were really taken.
    ///
    /// # Errors
    /// [`GeometryError`] unless they make a circle.
    pub fn of_contacts(contacts: &[Contact]) -> Result<Self, GeometryError> {
        let factor = evaluate(contacts)?.uncertainty.diameter;
        Ok(Self { touches: contacts.len(), step_deg: None, factor })
    }

    /// How many times larger its factor is than that of as many touches evenly round the full circle, in thousandths.
    ///
    /// ```
    /// use fitcheck_core::budget::Geometry;
    ///
    /// assert_eq!(Geometry::steps(3, 60.0)?.times_even(), 3_000);
    /// # Ok::<(), fitcheck_core::budget::GeometryError>(())
    /// ```
    #[expect(
        clippy::as_conversions,
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a quotient of positive numbers; a larger one is as bad as the largest"
    )]
    pub fn times_even(&self) -> u32 {
        (self.factor / Self::even_factor(self.touches) * 1e3).round() as u32
    }

    /// The factor of this many touches evenly round the full circle: 2 / √n.
    pub fn even_factor(touches: usize) -> f64 {
        2.0 / count(touches).sqrt()
    }
}
