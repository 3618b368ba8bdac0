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

use super::figure::Table;
use super::part::{FeatureFault, has_features};
use super::{
    Face, Figure, FreePoint, Lobes, Machine, Probe, Shape, Surface, Walls, Workpiece, WorkpieceError, in_range,
};
use crate::message::Say;
use crate::probing::cycle::Plane;
use crate::tolerance::Feature;

/// Steel, millionths per kelvin.
pub(super) const STEEL: f64 = 11.5;

/// The temperature that sizes refer to (ISO 1), °C.
pub(super) const REFERENCE: f64 = 20.0;

/// The largest file in bytes: a real one has some hundred, and the TOML reader takes fifty times as many.
pub const LARGEST: usize = 1 << 20;

/// The most characters of the TOML reader's message.
const LONGEST: usize = 300;

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

/// Why a file is not a machine.
#[derive(Debug, Clone, PartialEq, Say)]
#[say(prefix = "workpiece-file", error)]
pub enum SimulationError {
    /// It is not TOML, or has other keys.
    Toml {
        /// The line.
        line: usize,
        /// The TOML reader's message, in English.
        said: String,
    },
    /// Larger than any such file.
    #[say(args(most = LARGEST >> 10))]
    TooLarge,
    /// No surface, or more than one.
    #[say(args(tables = tables()))]
    NotOne {
        /// How many there are.
        found: usize,
    },
    /// A file with `[[feature]]` tables, where one surface is wanted.
    Several,
    /// More features than a part can have.
    TooMany {
        /// What is allowed.
        most: usize,
    },
    /// Something is wrong with a feature.
    Feature {
        /// The line.
        line: usize,
        /// The character in it.
        column: usize,
        /// The feature's name.
        feature: String,
        /// What is wrong.
        fault: FeatureFault,
    },
    /// An impossible figure.
    CannotBe {
        /// The line.
        line: usize,
        /// Which figure, and what is allowed.
        error: WorkpieceError,
    },
}

/// The tables of which a file has exactly one: `[bore], [stud], …`.
fn tables() -> String {
    Shape::ALL.map(|shape| format!("[{}]", shape.table())).join(", ")
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

pub(super) const fn first_seed() -> u64 {
    1
}

pub(super) const fn reference() -> f64 {
    REFERENCE
}

pub(super) const fn steel() -> f64 {
    STEEL
}

#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Round {
    #[serde(deserialize_with = "exactly")]
    pub(super) centre: [f64; 2],
    pub(super) diameter: f64,
    #[serde(default)]
    pub(super) plane: Plane,
    #[serde(default)]
    pub(super) ovality: Lobes,
    #[serde(default)]
    pub(super) lobes: Lobes,
    #[serde(default)]
    pub(super) surface_scatter: f64,
}

impl Round {
    const fn of(workpiece: &Workpiece, plane: Plane) -> Self {
        let Workpiece { centre, diameter, ovality, lobes, surface_scatter, .. } = *workpiece;
        Self { centre, diameter, plane, ovality, lobes, surface_scatter }
    }

    pub(super) const fn surface(&self, feature: Feature) -> Surface {
        let Self { centre, diameter, plane, ovality, lobes, surface_scatter } = *self;
        Surface::Round(Workpiece { feature, centre, diameter, ovality, lobes, surface_scatter }, plane)
    }
}

/// Two walls.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Pair {
    #[serde(deserialize_with = "exactly")]
    pub(super) centre: [f64; 2],
    pub(super) width: f64,
    #[serde(default)]
    pub(super) angle: f64,
    #[serde(default)]
    pub(super) surface_scatter: f64,
}

/// Four walls.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Rectangle {
    #[serde(deserialize_with = "exactly")]
    pub(super) centre: [f64; 2],
    #[serde(deserialize_with = "exactly")]
    pub(super) lengths: [f64; 2],
    #[serde(default)]
    pub(super) angle: f64,
    #[serde(default)]
    pub(super) surface_scatter: f64,
}

impl Pair {
    pub(super) const fn surface(&self, feature: Feature) -> Surface {
        let Self { centre, width, angle, surface_scatter } = *self;
        Surface::Walls(Walls { feature, centre, lengths: (width, None), angle, surface_scatter })
    }
}

impl Rectangle {
    pub(super) const fn surface(&self, feature: Feature) -> Surface {
        let Self { centre, lengths: [first, second], angle, surface_scatter } = *self;
        Surface::Walls(Walls { feature, centre, lengths: (first, Some(second)), angle, surface_scatter })
    }
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
        let (seed, temperature, expansion) = (file.seed, file.temperature, file.expansion);
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
        let (seed, temperature, expansion, probe) = (self.seed, self.temperature, self.expansion, self.probe);
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

/// An array of as many numbers as are wanted: the TOML reader passes over further ones, which a decimal comma makes.
pub(super) fn exactly<'de, D: serde::Deserializer<'de>, const N: usize>(reader: D) -> Result<[f64; N], D::Error> {
    let numbers = Vec::<f64>::deserialize(reader)?;
    let refused =
        |numbers: Vec<f64>| serde::de::Error::custom(format_args!("expected {N} numbers, found {}", numbers.len()));
    numbers.try_into().map_err(refused)
}

/// The same where nothing may be given.
pub(super) fn exactly_or_none<'de, D: serde::Deserializer<'de>, const N: usize>(
    reader: D,
) -> Result<Option<[f64; N]>, D::Error> {
    exactly(reader).map(Some)
}

/// A table of a file, either as a hole's or as a shaft's.
const fn hole_or_shaft<T: Copy>(feature: Feature, table: T) -> (Option<T>, Option<T>) {
    match feature {
        Feature::Hole => (Some(table), None),
        Feature::Shaft => (None, Some(table)),
    }
}

/// The TOML reader's message, cut off where a key is very long.
pub fn bounded(said: &str) -> String {
    match said.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", said.get(..end).unwrap_or_default()),
        None => said.to_owned(),
    }
}

/// The TOML reader's message in a user's words: numbers instead of their types, and which key is there twice.
pub fn plain(error: &toml::de::Error, text: &str) -> String {
    let said = error.message().replace("expected f64", "expected a number");
    let said = said.replace("expected u64", "expected a whole number from 0 to 9223372036854775807");
    let said = said.replace(" as i128", "").replace("expected u32", "expected a whole number from 0");
    let key = error
        .span()
        .and_then(|span| text.get(..span.start)?.trim_end().strip_suffix('=')?.split_whitespace().next_back());
    if let Some(key) = key.filter(|_| error.message().contains(" numbers, found ")) {
        return format!("{key}: {said}");
    }
    match error.span().and_then(|span| text.get(span)) {
        Some(key) if said == "duplicate key" => format!("{said} {key}"),
        _ => said,
    }
}

/// The line of a place in a text, from 1.
pub fn line_at(text: &str, offset: usize) -> usize {
    1 + text.bytes().take(offset).filter(|byte| *byte == b'\n').count()
}

/// The character in its line of a place in a text, from 1.
pub fn column_at(text: &str, offset: usize) -> usize {
    let before = text.get(..offset).unwrap_or_default();
    1 + before.chars().rev().take_while(|character| *character != '\n').count()
}

/// By which factor a workpiece of this temperature and expansion is larger than at 20 °C.
pub(super) fn growth(temperature: f64, expansion: f64) -> f64 {
    1.0 + expansion * 1e-6 * (temperature - REFERENCE)
}

/// The line of the key that gave a figure; the first line of the table if the figure was not given.
pub(super) fn line_of(text: &str, kind: &str, what: Figure) -> usize {
    let (table, key) = what.place();
    let table = match table {
        Table::Top => None,
        Table::Probe => Some("probe"),
        Table::Shape => Some(kind),
    };
    let Ok(root) = toml::de::DeTable::parse(text) else { return 1 };
    let root = root.get_ref();
    let place = match table {
        None => root.get(key).map(|value| value.span().start),
        Some(table) => root.get(table).map(|value| {
            let own = value.get_ref().as_table().and_then(|table| table.get(key)).map(|value| value.span().start);
            own.unwrap_or_else(|| value.span().start)
        }),
    };
    line_at(text, place.unwrap_or_default())
}
