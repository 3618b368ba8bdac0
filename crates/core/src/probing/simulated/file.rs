//! The simulated machine as one TOML file: a surface, its temperature, the probe and a seed.
//!
//! ```toml
//! seed = 7                   # of all scatter; 1 without it
//! temperature = 23.7         # of the workpiece, °C; 20 without it
//! expansion = 11.5           # millionths per kelvin; steel without it
//!
//! [bore]                     # or one of the others below: exactly one
//! centre = [50.0, 20.0]
//! diameter = 25.012
//! plane = "XY"               # "ZX" or "YZ" for G785
//! ovality = { count = 2, amplitude = 0.001, angle = 30.0 }
//! lobes = { count = 3, amplitude = 0.0005 }
//! surface_scatter = 0.0003
//!
//! [probe]
//! ball_radius = 3.0
//! trigger_scatter = 0.0005
//! calibration_error = 0.0002
//! offset = [0.0, 0.0]
//! lobing = { count = 3, amplitude = 0.0004 }
//! ```
//!
//! | table | what | keys |
//! |---|---|---|
//! | `[bore]`, `[stud]` | a hole, a shaft | above |
//! | `[face]` | a plane face | point, normal, wave, `surface_scatter` |
//! | `[point]` | a point of a free surface | point, normal, deviation, radius, `surface_scatter` |
//! | `[slot]`, `[ridge]` | two parallel walls | centre, width, angle, `surface_scatter` |
//! | `[pocket]`, `[boss]` | a rectangle | centre, lengths = \[first, second\], angle, `surface_scatter` |
//!
//! The angle of walls is that of the first length, from the first axis; 0 if it is not given. Lengths are in
//! millimetres, angles in degrees. An unknown key is an error.
//!
//! A part with any number of features has tables `[[feature]]` instead, read by [`Part::read`](super::Part::read):
//!
//! ```toml
//! [[feature]]
//! name = "A1"                # F1, F2 … without it
//! kind = "bore"              # the name of the table above
//! centre = [40.0, 30.0]      # and the other keys of that table
//! diameter = 25.012
//! top = 0.0                  # of walls in X/Y, Z0 without it; walls in other planes have no end
//! bottom = -20.0             # the floor, or the end of a body; without end if it is not given
//!
//! [probe]
//! ball_radius = 3.0
//! stylus_radius = 2.0        # that of the ball without it
//! ```
//!
//! A slot or ridge can have a `length` across its width, a face or point a `reach` about its point; without them they
//! have no end.

use serde::{Deserialize, Serialize};

use super::error::SimulationError;
use super::expansion::{REFERENCE, STEEL, growth};
use super::reading::{LARGEST, bounded, has_features, line_at, line_of, plain};
use super::tables::{Pair, Rectangle, Round, first_seed, reference, steel};
use super::{Face, Figure, FreePoint, Machine, Probe, Surface, Walls, WorkpieceError, in_range};
use crate::tolerance::Feature;

/// A simulated machine before it is switched on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Simulation {
    /// The surface at 20 °C.
    pub surface: Surface,
    /// The probe.
    pub probe: Probe,
    /// The seed of all scatter.
    pub seed: u64,
    /// Temperature of the workpiece, °C.
    pub temperature: f64,
    /// Thermal expansion of the workpiece, millionths per kelvin.
    pub expansion: f64,
}

/// The file as it is written.
#[derive(Debug, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(default = "first_seed")]
    seed: u64,
    #[serde(default = "reference")]
    temperature: f64,
    #[serde(default = "steel")]
    expansion: f64,
    bore: Option<Round>,
    stud: Option<Round>,
    face: Option<Face>,
    point: Option<FreePoint>,
    slot: Option<Pair>,
    ridge: Option<Pair>,
    pocket: Option<Rectangle>,
    boss: Option<Rectangle>,
    #[serde(default)]
    probe: Probe,
}

impl Simulation {
    /// A perfect machine with a surface at 20 °C.
    pub const fn perfect(surface: Surface) -> Self {
        Self { surface, probe: Probe::STILL, seed: 1, temperature: REFERENCE, expansion: STEEL }
    }

    /// Reads a file.
    ///
    /// ```
    /// use fitcheck_core::probing::simulated::Simulation;
    ///
    /// let simulation = Simulation::read("[bore]\ncentre = [50, 20]\ndiameter = 25.012\n")?;
    /// assert_eq!(simulation.temperature, 20.0);
    /// # Ok::<(), fitcheck_core::probing::simulated::SimulationError>(())
    /// ```
    ///
    /// # Errors
    /// [`SimulationError`] with the line.
    pub fn read(text: &str) -> Result<Self, SimulationError> {
        if LARGEST < text.len() {
            return Err(SimulationError::TooLarge);
        }
        if has_features(text) {
            return Err(SimulationError::Several);
        }
        let file: File = toml::from_str(text).map_err(|error| SimulationError::Toml {
            line: line_at(text, error.span().map_or(0, |span| span.start)),
            said: bounded(&plain(&error, text)),
        })?;
        let surfaces = [
            file.bore.map(|bore| bore.surface(Feature::Hole)),
            file.stud.map(|stud| stud.surface(Feature::Shaft)),
            file.face.map(Surface::Face),
            file.point.map(Surface::Point),
            file.slot.map(|slot| slot.surface(Feature::Hole)),
            file.ridge.map(|ridge| ridge.surface(Feature::Shaft)),
            file.pocket.map(|pocket| pocket.surface(Feature::Hole)),
            file.boss.map(|boss| boss.surface(Feature::Shaft)),
        ];
        let found: Vec<_> = surfaces.into_iter().flatten().collect();
        let &[surface] = found.as_slice() else { return Err(SimulationError::NotOne { found: found.len() }) };
        let kind = surface.shape().table();
        let seed = file.seed;
        let temperature = file.temperature;
        let expansion = file.expansion;
        let simulation = Self { surface, probe: file.probe, seed, temperature, expansion };
        simulation
            .check()
            .map_err(|error| SimulationError::CannotBe { line: line_of(text, kind, error.what), error })?;
        Ok(simulation)
    }

    /// The machine as a file; [`Self::read`] turns it back into the same machine.
    ///
    /// # Errors
    /// The TOML writer's message, for figures that no file can hold.
    pub fn write(&self) -> Result<String, toml::ser::Error> {
        let seed = self.seed;
        let temperature = self.temperature;
        let expansion = self.expansion;
        let probe = self.probe;
        let mut file = File { seed, temperature, expansion, probe, ..File::default() };
        match self.surface {
            Surface::Round(workpiece, plane) => {
                (file.bore, file.stud) = hole_or_shaft(workpiece.feature, Round::of(&workpiece, plane));
            }
            Surface::Face(face) => file.face = Some(face),
            Surface::Point(point) => file.point = Some(point),
            Surface::Walls(Walls { feature, centre, lengths: (width, None), angle, surface_scatter }) => {
                (file.slot, file.ridge) = hole_or_shaft(feature, Pair { centre, width, angle, surface_scatter });
            }
            Surface::Walls(Walls { feature, centre, lengths: (first, Some(second)), angle, surface_scatter }) => {
                let rectangle = Rectangle { centre, lengths: [first, second], angle, surface_scatter };
                (file.pocket, file.boss) = hole_or_shaft(feature, rectangle);
            }
        }
        toml::to_string(&file)
    }

    fn check(&self) -> Result<(), WorkpieceError> {
        in_range(Figure::Temperature, self.temperature, -100.0, 200.0)?;
        in_range(Figure::Expansion, self.expansion, 0.0, 200.0)?;
        self.probe.check()?;
        self.surface.check(self.probe.trigger_scatter)
    }

    /// Switches the machine on: the workpiece grows about its zero with its temperature, the scales do not.
    ///
    /// # Errors
    /// [`WorkpieceError`] names the impossible figure.
    pub fn machine(&self) -> Result<Machine, WorkpieceError> {
        self.check()?;
        Machine::with(self.surface.grown(growth(self.temperature, self.expansion)), self.probe, self.seed)
    }
}

/// A table of a file, either as a hole's or as a shaft's.
const fn hole_or_shaft<T: Copy>(feature: Feature, table: T) -> (Option<T>, Option<T>) {
    match feature {
        Feature::Hole => (Some(table), None),
        Feature::Shaft => (None, Some(table)),
    }
}
