//! A simulated part: any number of features on one workpiece, one probe, one seed.
//!
//! | file | what |
//! |---|---|
//! | `file` | the part as a TOML file with `[[feature]]` tables |
//! | `extent` | where a feature ends: top, bottom, length, reach |
//! | `solid` | how far a ball is from the material of a feature |
//! | `space` | what lies in what: holes in bodies, bodies in pockets |
//! | `meeting` | what a probing meets first |
//! | `collision` | what a move would touch |
//!
//! What is material, in the order in which a part is made:
//!
//! - A shaft, ridge or boss is a body from its top to its bottom. Where bodies meet, they are one.
//! - A face without a reach is the end of a half-space full of material; with one it is a disc without a back. The same
//!   holds for a point, which is a disc or the cap of a ball.
//! - A hole, slot or pocket is space cut out of the bodies and faces that it lies in, open at its top. The material
//!   round it is not known, so its wall is a shell: a ball is met by it from inside, and one that comes to it from
//!   behind is an error. A slot is open at its two ends.
//! - What lies wholly within a hole, slot or pocket, seen along its axis, stands in it and is not cut: an island, or a
//!   face with a reach at the floor. Everything else is cut: a boss by its bore, a ridge by a slot across it, a boss by
//!   a pocket that takes its corner away, a face by all holes in it. What lies higher than the top of the space covers
//!   it and is cut only below that top.
//! - Where spaces run into one another, the wall of one is missing within the other. A ball that would touch it there
//!   meets nothing that can be told: an error. A space that begins at the floor of another takes away that floor.
//!
//! The first surface on the ball's way is the one that is met, whatever the cycle meant. Where two are met at once,
//! within a nanometre, that is an error with both names; only the top of a body and the floor of a pocket give way to
//! a face or a point that lies in them.

mod collision;
mod extent;
mod file;
mod meeting;
mod solid;
mod space;

pub use collision::{Collision, Mover};
pub use extent::Extent;
pub(super) use meeting::Obstacle;
pub(super) use space::Space;

use super::expansion::{REFERENCE, STEEL, growth};
use super::{Figure, Machine, Probe, Simulation, Surface, WorkpieceError, in_range};

/// The largest ball and stylus, mm.
const THICKEST: f64 = 100.0;

/// A simulated part and its probe before they are switched on.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// The features at 20 °C.
    pub features: Vec<PartFeature>,
    /// The probe.
    pub probe: Probe,
    /// Radius of the stylus above the ball, millimetres; if not given, that of the ball.
    pub stylus_radius: Option<f64>,
    /// The seed of all scatter.
    pub seed: u64,
    /// Temperature of the part, °C.
    pub temperature: f64,
    /// Thermal expansion of the part, millionths per kelvin.
    pub expansion: f64,
}

/// A feature of a simulated part.
#[derive(Debug, Clone, PartialEq)]
pub struct PartFeature {
    /// Its name; empty for the only feature of a file without `[[feature]]`.
    pub name: String,
    /// Its surface at 20 °C.
    pub surface: Surface,
    /// Where it ends.
    pub extent: Extent,
}

impl Part {
    /// Whether it has the temperature that sizes refer to, so that it has not expanded.
    pub fn is_at_reference(&self) -> bool {
        (self.temperature - REFERENCE).abs() < f64::EPSILON
    }
}

impl PartFeature {
    /// A surface without ends and without a name.
    pub const fn endless(surface: Surface) -> Self {
        Self { name: String::new(), surface, extent: Extent::ENDLESS }
    }

    pub(super) fn check(&self, trigger_scatter: f64) -> Result<(), WorkpieceError> {
        self.surface.check(trigger_scatter)?;
        self.extent.check()
    }

    /// The same feature grown by a factor about the workpiece's zero.
    fn grown(&self, factor: f64) -> Self {
        Self { name: self.name.clone(), surface: self.surface.grown(factor), extent: self.extent.grown(factor) }
    }
}

impl From<Simulation> for Part {
    fn from(simulation: Simulation) -> Self {
        let Simulation { surface, probe, seed, temperature, expansion } = simulation;
        let features = vec![PartFeature::endless(surface)];
        Self { features, probe, stylus_radius: None, seed, temperature, expansion }
    }
}

impl Part {
    /// A perfect part at 20 °C, with a point as the probe.
    pub const fn perfect(features: Vec<PartFeature>) -> Self {
        let probe = Probe::STILL;
        Self { features, probe, stylus_radius: None, seed: 1, temperature: REFERENCE, expansion: STEEL }
    }

    /// What all features share.
    fn check(&self) -> Result<(), WorkpieceError> {
        in_range(Figure::Temperature, self.temperature, -100.0, 200.0)?;
        in_range(Figure::Expansion, self.expansion, 0.0, 200.0)?;
        if let Some(radius) = self.stylus_radius {
            in_range(Figure::StylusRadius, radius, 0.0, THICKEST)?;
        }
        self.probe.check()
    }

    /// Switches the machine on: the part grows about its zero with its temperature, the scales do not.
    ///
    /// # Errors
    /// [`WorkpieceError`] names the impossible figure.
    pub fn machine(&self) -> Result<Machine, WorkpieceError> {
        self.check()?;
        for feature in &self.features {
            feature.check(self.probe.trigger_scatter)?;
        }
        let factor = growth(self.temperature, self.expansion);
        let features = self.features.iter().map(|feature| feature.grown(factor)).collect();
        Machine::of(features, self.probe, self.stylus_radius, self.seed)
    }
}
