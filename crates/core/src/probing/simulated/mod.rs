//! A workpiece and a probe that exist only in Fitcheck: form, scatter from a seed, temperature, a ball with a radius.
//!
//! | file | what |
//! |---|---|
//! | `file` | all of it as one TOML file |
//! | `tables` | the tables of surfaces in such a file |
//! | `reading` | what such files are read with: bounds, places, the reader's message |
//! | `error` | why a file is not a machine or a part |
//! | `expansion` | how a workpiece grows with its temperature |
//! | `figure` | the figures, as errors name them and as a file has them |
//! | `shape` | what can be probed, by its shape |
//! | `surface` | round features, plane faces, points of free surfaces |
//! | `walls` | slots, ridges, pockets and bosses |
//! | `workpiece` | a round, oval or lobed contour |
//! | `probe` | ball, scatter, pre-travel, calibration |
//! | `nearest` | where a ball meets a wavy contour |
//! | `part/` | several features on one workpiece, what is met first, what a move would touch |
//!
//! The same seed gives the same contacts, on every machine and in every version.

mod error;
mod expansion;
mod figure;
mod file;
mod nearest;
mod part;
mod probe;
mod reading;
mod shape;
mod surface;
mod tables;
mod walls;
mod workpiece;

use std::sync::Arc;

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng as _;
use rand_distr::{Distribution as _, StandardNormal};

pub use error::{FeatureFault, SimulationError};
pub use figure::Figure;
pub use file::Simulation;
pub use part::{Collision, Extent, Mover, Part, PartFeature};
pub use probe::Probe;
pub use reading::{LARGEST, bounded, column_at, line_at, plain};
pub use shape::Shape;
pub use surface::{Face, FreePoint, Outline, Surface, Wave};
pub use walls::Walls;
pub use workpiece::{Lobes, Workpiece};

use part::{Obstacle, Space};

use super::contact::{Contact, NoContact, Prober, Touch};
use super::cycle::Plane;
use super::touch_probe::TouchProbe;
use super::vector::along;
use crate::length::Length;
use crate::message::Say;

/// The largest coordinate and diameter, mm.
const FARTHEST: f64 = 100_000.0;

/// Why a workpiece is impossible.
#[derive(Debug, Clone, PartialEq, Say)]
#[say(id = "workpiece-cannot-be", error)]
pub struct WorkpieceError {
    /// Which figure.
    pub what: Figure,
    /// What was given.
    pub given: f64,
    /// The smallest that is allowed.
    pub least: f64,
    /// The largest that is allowed.
    pub most: f64,
}

/// NaN is outside every range.
fn in_range(what: Figure, given: f64, least: f64, most: f64) -> Result<(), WorkpieceError> {
    if least <= given && given <= most { Ok(()) } else { Err(WorkpieceError { what, given, least, most }) }
}

/// The simulated machine: answers probings with contacts.
#[derive(Debug, Clone)]
pub struct Machine {
    space: Arc<Space>,
    probe: Probe,
    stylus_radius: f64,
    /// The offset of the ball in the control, minus its real offset.
    misplaced: [f64; 3],
    random: ChaCha8Rng,
    touches: usize,
}

impl Machine {
    /// A machine with a round workpiece on it, in X/Y.
    ///
    /// # Errors
    /// [`WorkpieceError`] names the impossible figure.
    pub fn new(workpiece: Workpiece, probe: Probe, seed: u64) -> Result<Self, WorkpieceError> {
        Self::with(Surface::Round(workpiece, Plane::Xy), probe, seed)
    }

    /// A machine with any surface on it.
    ///
    /// # Errors
    /// [`WorkpieceError`] names the impossible figure.
    pub fn with(surface: Surface, probe: Probe, seed: u64) -> Result<Self, WorkpieceError> {
        Self::of(vec![PartFeature::endless(surface)], probe, None, seed)
    }

    /// A machine with several features on it; a stylus without a radius has that of the ball.
    fn of(
        features: Vec<PartFeature>,
        probe: Probe,
        stylus_radius: Option<f64>,
        seed: u64,
    ) -> Result<Self, WorkpieceError> {
        features.iter().try_for_each(|feature| feature.check(probe.trigger_scatter))?;
        probe.check()?;
        Ok(Self {
            space: Arc::new(Space::of(features)),
            probe,
            stylus_radius: stylus_radius.unwrap_or(probe.ball_radius),
            misplaced: [0.0; 3],
            random: ChaCha8Rng::seed_from_u64(seed),
            touches: 0,
        })
    }

    /// Uses the calibration of a row of the touch-probe table: where the file says how far the ball really lies off the
    /// spindle's axis, the difference displaces every contact.
    #[must_use]
    pub fn calibrated(mut self, row: &TouchProbe) -> Self {
        if let Some([x, y]) = self.probe.offset {
            let [taken_x, taken_y] = row.offset.map(Length::to_mm_f64);
            self.misplaced = [taken_x - x, taken_y - y, 0.0];
        }
        self
    }

    /// What a move of the ball's centre would touch first, on a straight line or on the shorter arc about a centre,
    /// millimetres; `None` where the way is free, and for a workpiece of a file without `[[feature]]`.
    pub fn collision(&self, from: [f64; 3], to: [f64; 3], about: Option<[f64; 3]>) -> Option<Collision> {
        self.collision_of(&[Mover::Ball, Mover::Stylus], from, to, about)
    }

    /// The same for the ball alone, or the stylus alone.
    pub fn collision_of(
        &self,
        movers: &[Mover],
        from: [f64; 3],
        to: [f64; 3],
        about: Option<[f64; 3]>,
    ) -> Option<Collision> {
        let real = |place| along(place, self.misplaced, -1.0);
        let radius = |mover: &Mover| match mover {
            Mover::Ball => (*mover, self.probe.ball_radius),
            Mover::Stylus => (*mover, self.stylus_radius),
        };
        let movers: Vec<(Mover, f64)> = movers.iter().map(radius).collect();
        let found = self.space.collision([from, to].map(real), about.map(real), &movers)?;
        Some(Collision { place: along(found.place, self.misplaced, 1.0), ..found })
    }

    /// Whether moves are looked at, with a stylus above the ball: not for a workpiece of a file without `[[feature]]`.
    pub fn has_stylus(&self) -> bool {
        self.space.only().is_none()
    }

    /// The features that moves, or the stylus, are not looked at with: no closed form says how near they are.
    pub fn unchecked(&self) -> Vec<&str> {
        self.space.unchecked()
    }

    fn scatter(&mut self, sigma: f64) -> f64 {
        // Drawn even if there is no scatter, so that one figure does not change the random numbers of the others.
        let normal: f64 = StandardNormal.sample(&mut self.random);
        sigma * normal
    }

    /// What stands in the way of a probing, as its error.
    fn refused(&self, number: usize, obstacle: Obstacle) -> NoContact {
        let name = |feature: usize| self.space.name(feature).to_owned();
        match obstacle {
            Obstacle::Nothing => NoContact::Missed { number },
            Obstacle::InMaterial(_) if self.space.only().is_some() => NoContact::InMaterial { number },
            Obstacle::InMaterial(feature) => NoContact::InFeature { number, feature: name(feature) },
            Obstacle::Behind(feature) => NoContact::Behind { number, feature: name(feature) },
            Obstacle::Ambiguous(one, other) => NoContact::Ambiguous { number, feature: name(one), other: name(other) },
        }
    }
}

impl Prober for Machine {
    fn touch(&mut self, touch: &Touch) -> Result<Contact, NoContact> {
        self.touches += 1;
        let number = self.touches;
        // Where the ball really is when the control assumes it at the start.
        let from = along(touch.from, self.misplaced, -1.0);
        let met = self.space.meet(from, touch.direction, self.probe.ball_radius);
        let met = met.map_err(|obstacle| self.refused(number, obstacle))?;
        if touch.longest < met.distance {
            let longest = Length::from_mm_f64(touch.longest).unwrap_or(Length::MAX);
            return Err(NoContact::OutOfReach { number, longest });
        }
        let of_surface = self.space.scatter(met.feature);
        let scatter = self.scatter(of_surface) + self.scatter(self.probe.trigger_scatter);
        let told = met.distance + scatter + self.probe.pre_travel(touch.direction);
        Ok(Contact::at(along(touch.from, touch.direction, told)))
    }

    fn ball_radius(&self) -> f64 {
        (self.probe.ball_radius + self.probe.calibration_error).max(0.0)
    }
}
