//! A workpiece and a probe that exist only here: a round, oval or lobed contour, scatter from a seed.
//!
//! The same seed gives the same contacts, on every machine and in every version.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng as _;
use rand_distr::{Distribution as _, StandardNormal};
use serde::{Deserialize, Serialize};

use super::contact::{Contact, NoContact, Prober, Touch};
use crate::length::Length;
use crate::tolerance::Feature;
use crate::words::{Message, Say};

/// The largest coordinate and diameter, mm.
const FARTHEST: f64 = 100_000.0;

/// The most lobes: steps in which a contour is followed are so small that none is missed.
const MOST_LOBES: f64 = 100.0;

/// A circular feature with its form, millimetres and degrees.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Workpiece {
    /// Hole or shaft.
    pub feature: Feature,
    /// Where the centre really is.
    pub centre: [f64; 2],
    /// Mean diameter, above zero.
    pub diameter: f64,
    /// Ovality: two lobes.
    #[serde(default)]
    pub ovality: Lobes,
    /// Any other lobes.
    #[serde(default)]
    pub lobes: Lobes,
    /// Scatter of the surface along the probing direction, one sigma.
    #[serde(default)]
    pub surface_scatter: f64,
}

/// A regular wave of the radius.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Lobes {
    /// How many round the circle; two for ovality.
    pub count: u32,
    /// Amplitude in the radius, zero or more.
    pub amplitude: f64,
    /// Direction of the first crest, degrees.
    #[serde(default)]
    pub angle: f64,
}

/// The probe.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Probe {
    /// Scatter of the trigger point along the probing direction, one sigma, millimetres.
    pub trigger_scatter: f64,
}

impl Probe {
    /// A perfect one.
    pub const STILL: Self = Self { trigger_scatter: 0.0 };

    /// Half a micrometre of scatter, as touch probes in machines have.
    pub const USUAL: Self = Self { trigger_scatter: 0.0005 };
}

/// Why a workpiece cannot be.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{what} = {given}: at least {least}, at most {most}")]
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

impl Say for WorkpieceError {
    fn message(&self) -> Message {
        Message::new("workpiece-cannot-be")
            .text("what", self.what)
            .text("given", self.given)
            .text("least", self.least)
            .text("most", self.most)
    }
}

/// The simulated machine: answers touches with contacts.
#[derive(Debug, Clone)]
pub struct Machine {
    workpiece: Workpiece,
    probe: Probe,
    random: ChaCha8Rng,
    touches: usize,
}

impl Workpiece {
    /// A perfectly round one.
    pub const fn round(feature: Feature, centre: [f64; 2], diameter: f64) -> Self {
        let none = Lobes { count: 0, amplitude: 0.0, angle: 0.0 };
        Self { feature, centre, diameter, ovality: none, lobes: none, surface_scatter: 0.0 }
    }

    /// One as a shop makes it: a micrometre oval, three tenths of a micrometre rough.
    pub const fn usual(feature: Feature, diameter: f64) -> Self {
        Self {
            ovality: Lobes { count: 2, amplitude: 0.001, angle: 0.0 },
            surface_scatter: 0.0003,
            ..Self::round(feature, [0.0, 0.0], diameter)
        }
    }

    /// The radius in a direction seen from the centre, radians.
    fn radius(&self, angle: f64) -> f64 {
        self.diameter / 2.0 + self.ovality.height(angle) + self.lobes.height(angle)
    }

    fn check(&self, probe: Probe) -> Result<(), WorkpieceError> {
        let [x, y] = self.centre;
        in_range("diameter", self.diameter, 0.001, FARTHEST)?;
        in_range("centre x", x, -FARTHEST, FARTHEST)?;
        in_range("centre y", y, -FARTHEST, FARTHEST)?;
        // Contour and scatter must stay in the range where a contour is a curve about its centre.
        let highest = self.diameter / 20.0;
        in_range("surface scatter", self.surface_scatter, 0.0, highest)?;
        in_range("probe scatter", probe.trigger_scatter, 0.0, highest)?;
        in_range("ovality", self.ovality.amplitude, 0.0, highest)?;
        in_range("lobe height", self.lobes.amplitude, 0.0, highest)?;
        in_range("ovality angle", self.ovality.angle, -360.0, 360.0)?;
        in_range("lobe angle", self.lobes.angle, -360.0, 360.0)?;
        // A wave that does not wave, or hardly, would only move or widen the circle.
        let fewest = |wave: &Lobes| if 0.0 < wave.amplitude { 2.0 } else { 0.0 };
        in_range("ovality count", f64::from(self.ovality.count), fewest(&self.ovality), 2.0)?;
        in_range("lobes", f64::from(self.lobes.count), fewest(&self.lobes), MOST_LOBES)
    }

    fn is_round(&self) -> bool {
        self.ovality.amplitude.max(self.lobes.amplitude) <= 0.0
    }
}

/// NaN is in no range.
fn in_range(what: &'static str, given: f64, least: f64, most: f64) -> Result<(), WorkpieceError> {
    if least <= given && given <= most { Ok(()) } else { Err(WorkpieceError { what, given, least, most }) }
}

impl Lobes {
    fn height(&self, angle: f64) -> f64 {
        self.amplitude * (f64::from(self.count) * (angle - self.angle.to_radians())).cos()
    }
}

impl Machine {
    /// A machine with a workpiece on it.
    ///
    /// # Errors
    /// [`WorkpieceError`] names the figure that cannot be.
    pub fn new(workpiece: Workpiece, probe: Probe, seed: u64) -> Result<Self, WorkpieceError> {
        workpiece.check(probe)?;
        Ok(Self { workpiece, probe, random: ChaCha8Rng::seed_from_u64(seed), touches: 0 })
    }

    /// How far along the touch the contour is met.
    fn distance(&self, touch: &Touch) -> Option<f64> {
        let [x, y, _] = touch.from;
        let [along_x, along_y, _] = touch.direction;
        let [centre_x, centre_y] = self.workpiece.centre;
        let (to_x, to_y) = (centre_x - x, centre_y - y);
        let (along, across) = (to_x * along_x + to_y * along_y, to_x * along_y - to_y * along_x);
        let half_chord = |radius: f64| {
            let square = (radius - across) * (radius + across);
            (0.0 <= square).then(|| square.sqrt())
        };
        let feature = self.workpiece.feature;
        if self.workpiece.is_round() {
            let half = half_chord(self.workpiece.diameter / 2.0)?;
            // Out of a hole the far side is met, onto a shaft the near one.
            let distance = if feature == Feature::Hole { along + half } else { along - half };
            return (0.0 <= distance).then_some(distance);
        }
        // Any other contour lies within a circle a little wider than its highest crest; on the way through that the
        // first crossing is looked for in small steps and then halved to the last bit.
        let (ovality, lobes) = (self.workpiece.ovality.amplitude, self.workpiece.lobes.amplitude);
        let half = half_chord((self.workpiece.diameter / 2.0 + ovality + lobes) * (1.0 + 1e-9))?;
        let (first, last) = ((along - half).max(0.0), along + half);
        let crossed = |distance: f64| {
            let (off_x, off_y) = (distance * along_x - to_x, distance * along_y - to_y);
            let outside = off_x.hypot(off_y) - self.workpiece.radius(off_y.atan2(off_x));
            if feature == Feature::Hole { 0.0 <= outside } else { outside <= 0.0 }
        };
        if last < first {
            return None;
        }
        let steps = 512 + 64 * self.workpiece.lobes.count;
        let place = |step: u32| first + (last - first) * (f64::from(step) / f64::from(steps));
        let beyond = (0..=steps).find(|&step| crossed(place(step)))?;
        let (mut before, mut after) = (place(beyond.saturating_sub(1)), place(beyond));
        for _ in 0..60 {
            let middle = f64::midpoint(before, after);
            if crossed(middle) { after = middle } else { before = middle }
        }
        Some(after)
    }

    /// Whether the probe's start is not in the material.
    fn is_free(&self, touch: &Touch) -> bool {
        let [x, y, _] = touch.from;
        let [centre_x, centre_y] = self.workpiece.centre;
        let (off_x, off_y) = (x - centre_x, y - centre_y);
        let radius = self.workpiece.radius(off_y.atan2(off_x));
        match self.workpiece.feature {
            Feature::Hole => off_x.hypot(off_y) <= radius,
            Feature::Shaft => radius <= off_x.hypot(off_y),
        }
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
        if !self.is_free(touch) {
            return Err(NoContact::InMaterial { number: self.touches });
        }
        let number = self.touches;
        let distance = self.distance(touch).ok_or(NoContact::Missed { number })?;
        if touch.longest < distance {
            let longest = Length::from_mm_f64(touch.longest).unwrap_or_default();
            return Err(NoContact::OutOfReach { number, longest });
        }
        let scatter = self.scatter(self.workpiece.surface_scatter) + self.scatter(self.probe.trigger_scatter);
        let distance = distance + scatter;
        let [x, y, z] = touch.from;
        let [along_x, along_y, along_z] = touch.direction;
        Ok(Contact { x: x + distance * along_x, y: y + distance * along_y, z: z + distance * along_z })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
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
        let still = Probe { trigger_scatter: 0.0 };
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
