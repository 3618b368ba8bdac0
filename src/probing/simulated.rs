//! A workpiece and a probe that exist only here: a round, oval or lobed contour, scatter from a seed.
//!
//! The same seed gives the same contacts, on every machine and in every version.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng as _;
use rand_distr::{Distribution as _, StandardNormal};
use serde::{Deserialize, Serialize};

use super::contact::{Contact, NoContact, Prober, Touch};
use crate::tolerance::Feature;
use crate::words::{Message, Say};

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
    /// Half a micrometre of scatter, as touch probes in machines have.
    pub const USUAL: Self = Self { trigger_scatter: 0.0005 };
}

/// Why a workpiece cannot be.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{what} = {given}: {allowed}")]
pub struct WorkpieceError {
    /// Which figure.
    pub what: &'static str,
    /// What was given.
    pub given: f64,
    /// What is allowed.
    pub allowed: &'static str,
}

impl Say for WorkpieceError {
    fn message(&self) -> Message {
        Message::new("workpiece-cannot-be")
            .text("what", self.what)
            .text("given", self.given)
            .text("allowed", self.allowed)
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
        let refuse = |what, given, allowed| Err(WorkpieceError { what, given, allowed });
        // Contour and probe must stay in the range where a contour is a curve about its centre.
        let most = self.diameter / 20.0;
        let above_zero = |value: f64| value.is_finite() && 0.0 < value;
        let zero_to_most = |value: f64| value.is_finite() && 0.0 <= value && value <= most;
        if !above_zero(self.diameter) {
            return refuse("diameter", self.diameter, "a number above 0 is allowed");
        }
        for (what, given) in [
            ("ovality", self.ovality.amplitude),
            ("lobe height", self.lobes.amplitude),
            ("surface scatter", self.surface_scatter),
            ("probe scatter", probe.trigger_scatter),
        ] {
            if !zero_to_most(given) {
                return refuse(what, given, "0 to a twentieth of the diameter is allowed");
            }
        }
        for (what, given) in [("centre", self.centre.iter().sum()), ("angle", self.ovality.angle + self.lobes.angle)] {
            if !f64::is_finite(given) {
                return refuse(what, given, "a finite number is allowed");
            }
        }
        if 1000 < self.lobes.count {
            return refuse("lobes", f64::from(self.lobes.count), "0 to 1000 is allowed");
        }
        Ok(())
    }
}

impl Lobes {
    fn height(&self, angle: f64) -> f64 {
        // Exactly zero for none, so that a round workpiece stays exact.
        if self.amplitude == 0.0 {
            return 0.0;
        }
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
        // Out of a hole the far side is met, onto a shaft the near one.
        let side = match self.workpiece.feature {
            Feature::Hole => 1.0,
            Feature::Shaft => -1.0,
        };
        let meet = |radius: f64| {
            let square = radius * radius - across * across;
            (0.0 <= square).then(|| along + side * square.sqrt())
        };
        let mut distance = meet(self.workpiece.diameter / 2.0)?;
        // The radius depends on where it is met: the form is small, so this settles in a few steps.
        for _ in 0..60 {
            let (at_x, at_y) = (x + distance * along_x - centre_x, y + distance * along_y - centre_y);
            let next = meet(self.workpiece.radius(at_y.atan2(at_x)))?;
            let settled = (next - distance).abs() <= 1e-15 * self.workpiece.diameter;
            distance = next;
            if settled {
                break;
            }
        }
        (0.0 <= distance).then_some(distance)
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
        if sigma == 0.0 { 0.0 } else { sigma * normal }
    }
}

impl Prober for Machine {
    fn touch(&mut self, touch: &Touch) -> Result<Contact, NoContact> {
        self.touches += 1;
        if !self.is_free(touch) {
            return Err(NoContact::InMaterial { number: self.touches });
        }
        let distance = self.distance(touch).ok_or(NoContact::Missed { number: self.touches })?;
        let scatter = self.scatter(self.workpiece.surface_scatter) + self.scatter(self.probe.trigger_scatter);
        let distance = distance + scatter;
        let [x, y, z] = touch.from;
        let [along_x, along_y, along_z] = touch.direction;
        Ok(Contact { x: x + distance * along_x, y: y + distance * along_y, z: z + distance * along_z })
    }
}
