//! A workpiece and a probe that exist only here: form, scatter from a seed, temperature, a ball that is not a point.
//!
//! | file | what |
//! |---|---|
//! | `file` | all of it as one TOML file |
//! | `shape` | what there is to probe, by its shape |
//! | `surface` | round features, plane faces, points of free surfaces |
//! | `walls` | slots, ridges, pockets and bosses |
//! | `workpiece` | a round, oval or lobed contour |
//! | `probe` | ball, scatter, pre-travel, calibration |
//! | `nearest` | where a ball meets a wavy contour |
//!
//! The same seed gives the same contacts, on every machine and in every version.

mod file;
mod nearest;
mod probe;
mod shape;
mod surface;
mod walls;
mod workpiece;

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng as _;
use rand_distr::{Distribution as _, StandardNormal};

pub use file::{Simulation, SimulationError};
pub use probe::Probe;
pub use shape::Shape;
pub use surface::{Face, FreePoint, Outline, Surface, Wave};
pub use walls::Walls;
pub use workpiece::{Lobes, Workpiece};

use super::contact::{Contact, NoContact, Prober, Touch};
use super::cycle::{Plane, along};
use super::touch_probe::TouchProbe;
use crate::length::Length;
use crate::message::Say;

/// The largest coordinate and diameter, mm.
const FARTHEST: f64 = 100_000.0;

/// Why a workpiece cannot be.
#[derive(Debug, Clone, PartialEq, Say)]
#[say(id = "workpiece-cannot-be", error)]
pub struct WorkpieceError {
    /// Which figure.
    pub what: &'static str,
    /// What was given.
    pub given: f64,
    /// The smallest that is allowed.
    pub least: f64,
    /// The largest that is allowed.
    pub most: f64,
}

/// NaN is in no range.
fn in_range(what: &'static str, given: f64, least: f64, most: f64) -> Result<(), WorkpieceError> {
    if least <= given && given <= most { Ok(()) } else { Err(WorkpieceError { what, given, least, most }) }
}

/// The simulated machine: answers probings with contacts.
#[derive(Debug, Clone)]
pub struct Machine {
    surface: Surface,
    probe: Probe,
    /// What the control takes the ball's offset for, less what it is.
    misplaced: [f64; 3],
    random: ChaCha8Rng,
    touches: usize,
}

impl Machine {
    /// A machine with a round workpiece on it, in X/Y.
    ///
    /// # Errors
    /// [`WorkpieceError`] names the figure that cannot be.
    pub fn new(workpiece: Workpiece, probe: Probe, seed: u64) -> Result<Self, WorkpieceError> {
        Self::with(Surface::Round(workpiece, Plane::Xy), probe, seed)
    }

    /// A machine with any surface on it.
    ///
    /// # Errors
    /// [`WorkpieceError`] names the figure that cannot be.
    pub fn with(surface: Surface, probe: Probe, seed: u64) -> Result<Self, WorkpieceError> {
        surface.check(probe.trigger_scatter)?;
        probe.check()?;
        Ok(Self { surface, probe, misplaced: [0.0; 3], random: ChaCha8Rng::seed_from_u64(seed), touches: 0 })
    }

    /// Takes the calibration of a row of the touch-probe table: where the file says how far the ball really lies off the
    /// spindle's axis, the difference misplaces every contact.
    #[must_use]
    pub fn calibrated(mut self, row: &TouchProbe) -> Self {
        if let Some([x, y]) = self.probe.offset {
            let [taken_x, taken_y] = row.offset.map(Length::to_mm_f64);
            self.misplaced = [taken_x - x, taken_y - y, 0.0];
        }
        self
    }

    fn scatter(&mut self, sigma: f64) -> f64 {
        // Drawn also for none, so that one figure does not change the others' numbers.
        let normal: f64 = StandardNormal.sample(&mut self.random);
        sigma * normal
    }
}

impl Prober for Machine {
    fn touch(&mut self, touch: &Touch) -> Result<Contact, NoContact> {
        self.touches += 1;
        let number = self.touches;
        // Where the ball really is when the control takes it to be at the start.
        let from = along(touch.from, self.misplaced, -1.0);
        let ball_radius = self.probe.ball_radius;
        if !self.surface.is_free(from, ball_radius) {
            return Err(NoContact::InMaterial { number });
        }
        let met = self.surface.distance(from, touch.direction, ball_radius);
        let distance = met.ok_or(NoContact::Missed { number })?;
        if touch.longest < distance {
            let longest = Length::from_mm_f64(touch.longest).unwrap_or_default();
            return Err(NoContact::OutOfReach { number, longest });
        }
        let scatter = self.scatter(self.surface.scatter()) + self.scatter(self.probe.trigger_scatter);
        let told = distance + scatter + self.probe.pre_travel(touch.direction);
        Ok(Contact::at(along(touch.from, touch.direction, told)))
    }

    fn ball_radius(&self) -> f64 {
        (self.probe.ball_radius + self.probe.calibration_error).max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tolerance::Feature;
    use crate::words::{Language, Words};

    #[track_caller]
    fn check(text: &str, expected: &str) {
        let said = match toml::from_str::<Workpiece>(text) {
            Ok(workpiece) => match Machine::new(workpiece, Probe::USUAL, 0) {
                Ok(_) => "fine".to_owned(),
                Err(error) => {
                    assert_eq!(Words::new(Language::En).told(&error), error.to_string());
                    assert_ne!(Words::new(Language::Nl).told(&error), error.message().id);
                    error.to_string()
                }
            },
            Err(error) => error.message().to_owned(),
        };
        assert_eq!(said, expected);
    }

    #[test]
    fn a_workpiece_file_is_read_and_checked() {
        let bore = |form: &str| format!("feature = 'hole'\ncentre = [0.0, 0.0]\ndiameter = 25.0\n{form}");
        check(&bore(""), "fine");
        check(&bore("[ovality]\ncount = 2\namplitude = 0.01\nangle = 45"), "fine");
        check(&bore("").replace("25.0", "-1.0"), "diameter = -1: at least 0.001, at most 100000");
        check(&bore("").replace("25.0", "nan"), "diameter = NaN: at least 0.001, at most 100000");
        check(&bore("").replace("[0.0", "[-inf"), "centre x = -inf: at least -100000, at most 100000");
        check(&bore("surface_scatter = 2.0"), "surface scatter = 2: at least 0, at most 1.25");
        check(&bore("[ovality]\ncount = 2\namplitude = 5.0"), "ovality = 5: at least 0, at most 1.25");
        check(&bore("[ovality]\ncount = 3\namplitude = 0.1"), "ovality count = 3: at least 2, at most 2");
        check(&bore("[lobes]\ncount = 0\namplitude = 0.1"), "lobes = 0: at least 2, at most 100");
        check(&bore("[lobes]\ncount = 101\namplitude = 0.1"), "lobes = 101: at least 2, at most 100");
        check(
            &bore("[lobes]\ncount = 3\namplitude = 0.1\nangle = 361.0"),
            "lobe angle = 361: at least -360, at most 360",
        );
        check("feature = 'hole'\ncentre = [0.0, 0.0]", "missing field `diameter`");
        check(
            &bore("colour = 'red'"),
            "unknown field `colour`, expected one of `feature`, `centre`, `diameter`, `ovality`, `lobes`, `surface_scatter`",
        );
    }

    #[test]
    fn a_touch_that_begins_in_the_material_or_passes_by_meets_nothing() {
        let touch =
            |x: f64, y: f64, along: f64| Touch { from: [x, y, 0.0], direction: [along, 0.0, 0.0], longest: 50.0 };
        let still = Probe::STILL;
        let of = |feature| Machine::new(Workpiece::round(feature, [0.0, 0.0], 20.0), still, 0).unwrap();
        let (missed, in_material) = (Err(NoContact::Missed { number: 1 }), Err(NoContact::InMaterial { number: 1 }));
        assert_eq!(of(Feature::Hole).touch(&touch(11.0, 0.0, 1.0)), in_material);
        assert_eq!(of(Feature::Shaft).touch(&touch(9.0, 0.0, -1.0)), in_material);
        assert_eq!(of(Feature::Shaft).touch(&touch(15.0, 10.5, -1.0)), missed);
        assert_eq!(of(Feature::Shaft).touch(&touch(15.0, 0.0, 1.0)), missed);
        let mut oval = Workpiece::round(Feature::Shaft, [0.0, 0.0], 20.0);
        oval.ovality = Lobes { count: 2, amplitude: 0.1, angle: 0.0 };
        let mut machine = Machine::new(oval, still, 0).unwrap();
        assert_eq!(machine.touch(&touch(15.0, 10.5, -1.0)), missed);
        assert_eq!(machine.touch(&touch(15.0, 0.0, 1.0)), Err(NoContact::Missed { number: 2 }));
        assert!((machine.touch(&touch(15.0, 0.0, -1.0)).unwrap().x - 10.1).abs() < 1e-12);
    }
}
