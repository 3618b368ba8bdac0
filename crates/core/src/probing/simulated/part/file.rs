//! A part as a TOML file with `[[feature]]` tables.

use serde::{Deserialize, Serialize};

use super::super::error::{FeatureFault, SimulationError};
use super::super::figure::Table;
use super::super::reading::{LARGEST, bounded, column_at, exactly_or_none, has_features, line_at, line_of, plain};
use super::super::tables::{Pair, Rectangle, Round, first_seed, reference, steel};
use super::super::{Face, FreePoint, Lobes, Probe, Shape, Simulation, Surface, Walls, Wave, WorkpieceError};
use super::{Extent, Part, PartFeature};
use crate::probing::cycle::Plane;

/// The most features of a part: as many as a plan of `fitcheck nc` can have.
const MOST_FEATURES: usize = 1_000;

/// The most characters of a feature's name.
const LONGEST_NAME: usize = 40;

/// The file as it is written.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(default = "first_seed")]
    seed: u64,
    #[serde(default = "reference")]
    temperature: f64,
    #[serde(default = "steel")]
    expansion: f64,
    #[serde(default)]
    probe: ProbeTable,
    feature: Vec<FeatureTable>,
}

/// The probe with its stylus.
#[derive(Debug, Clone, Copy, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct ProbeTable {
    #[serde(default)]
    trigger_scatter: f64,
    #[serde(default)]
    ball_radius: f64,
    stylus_radius: Option<f64>,
    #[serde(default)]
    calibration_error: f64,
    #[serde(default, deserialize_with = "exactly_or_none")]
    offset: Option<[f64; 2]>,
    #[serde(default)]
    lobing: Lobes,
}

impl ProbeTable {
    const fn of(part: &Part) -> Self {
        let Probe { trigger_scatter, ball_radius, calibration_error, offset, lobing } = part.probe;
        Self { trigger_scatter, ball_radius, stylus_radius: part.stylus_radius, calibration_error, offset, lobing }
    }

    const fn probe(&self) -> Probe {
        let Self { trigger_scatter, ball_radius, calibration_error, offset, lobing, .. } = *self;
        Probe { trigger_scatter, ball_radius, calibration_error, offset, lobing }
    }
}

/// A feature: its kind, and the keys of all kinds.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct FeatureTable {
    name: Option<String>,
    kind: String,
    #[serde(default, deserialize_with = "exactly_or_none")]
    centre: Option<[f64; 2]>,
    diameter: Option<f64>,
    width: Option<f64>,
    #[serde(default, deserialize_with = "exactly_or_none")]
    lengths: Option<[f64; 2]>,
    angle: Option<f64>,
    plane: Option<Plane>,
    #[serde(default, deserialize_with = "exactly_or_none")]
    point: Option<[f64; 3]>,
    #[serde(default, deserialize_with = "exactly_or_none")]
    normal: Option<[f64; 3]>,
    deviation: Option<f64>,
    radius: Option<f64>,
    top: Option<f64>,
    bottom: Option<f64>,
    length: Option<f64>,
    reach: Option<f64>,
    surface_scatter: Option<f64>,
    ovality: Option<Lobes>,
    lobes: Option<Lobes>,
    wave: Option<Wave>,
}

/// The keys that a kind has besides `name`, `kind` and `surface_scatter`.
const fn keys(shape: Shape) -> &'static [&'static str] {
    match shape {
        Shape::Hole | Shape::Stud => &["centre", "diameter", "plane", "ovality", "lobes", "top", "bottom"],
        Shape::Face => &["point", "normal", "wave", "reach"],
        Shape::Point => &["point", "normal", "deviation", "radius", "reach"],
        Shape::Slot | Shape::Ridge => &["centre", "width", "angle", "top", "bottom", "length"],
        Shape::Pocket | Shape::Boss => &["centre", "lengths", "angle", "top", "bottom"],
    }
}

impl FeatureTable {
    /// The keys that were given, apart from those that every kind has.
    fn given(&self) -> impl Iterator<Item = &'static str> {
        let keys = [
            ("centre", self.centre.is_some()),
            ("diameter", self.diameter.is_some()),
            ("width", self.width.is_some()),
            ("lengths", self.lengths.is_some()),
            ("angle", self.angle.is_some()),
            ("plane", self.plane.is_some()),
            ("point", self.point.is_some()),
            ("normal", self.normal.is_some()),
            ("deviation", self.deviation.is_some()),
            ("radius", self.radius.is_some()),
            ("top", self.top.is_some()),
            ("bottom", self.bottom.is_some()),
            ("length", self.length.is_some()),
            ("reach", self.reach.is_some()),
            ("ovality", self.ovality.is_some()),
            ("lobes", self.lobes.is_some()),
            ("wave", self.wave.is_some()),
        ];
        keys.into_iter().filter(|(_, is_given)| *is_given).map(|(key, _)| key)
    }

    /// The surface, or the key that is at fault.
    fn surface(&self) -> Result<Surface, (&'static str, FeatureFault)> {
        let Some(shape) = Shape::ALL.into_iter().find(|shape| shape.table() == self.kind) else {
            let given = bounded(&self.kind);
            let known = Shape::ALL.map(Shape::table).join(", ");
            return Err(("kind", FeatureFault::Kind { given, known }));
        };
        let kind = shape.table();
        if let Some(key) = self.given().find(|key| !keys(shape).contains(key)) {
            return Err((key, FeatureFault::OtherKey { kind, key }));
        }
        let missing = |key| ("", FeatureFault::NoKey { kind, key });
        // What is not given is perfect: along the axes, without scatter, wave and deviation.
        let surface_scatter = self.surface_scatter.unwrap_or(0.0);
        let angle = self.angle.unwrap_or(0.0);
        let centre = || self.centre.ok_or_else(|| missing("centre"));
        let point = || self.point.ok_or_else(|| missing("point"));
        let normal = || self.normal.ok_or_else(|| missing("normal"));
        Ok(match shape {
            Shape::Hole | Shape::Stud => Round {
                centre: centre()?,
                diameter: self.diameter.ok_or_else(|| missing("diameter"))?,
                plane: self.plane.unwrap_or(Plane::Xy),
                ovality: self.ovality.unwrap_or(Lobes::NONE),
                lobes: self.lobes.unwrap_or(Lobes::NONE),
                surface_scatter,
            }
            .surface(shape.feature()),
            Shape::Face => Surface::Face(Face { point: point()?, normal: normal()?, wave: self.wave, surface_scatter }),
            Shape::Point => Surface::Point(FreePoint {
                point: point()?,
                normal: normal()?,
                deviation: self.deviation.unwrap_or(0.0),
                radius: self.radius,
                surface_scatter,
            }),
            Shape::Slot | Shape::Ridge => {
                let width = self.width.ok_or_else(|| missing("width"))?;
                Pair { centre: centre()?, width, angle, surface_scatter }.surface(shape.feature())
            }
            Shape::Pocket | Shape::Boss => {
                let lengths = self.lengths.ok_or_else(|| missing("lengths"))?;
                Rectangle { centre: centre()?, lengths, angle, surface_scatter }.surface(shape.feature())
            }
        })
    }

    fn extent(&self, surface: &Surface) -> Extent {
        let usual = Extent::usual(surface);
        Extent {
            top: self.top.unwrap_or(usual.top),
            bottom: self.bottom.unwrap_or(usual.bottom),
            length: self.length.unwrap_or(usual.length),
            reach: self.reach.unwrap_or(usual.reach),
        }
    }

    /// A feature as it is written: what is not given is what is assumed.
    fn of(feature: &PartFeature) -> Self {
        let PartFeature { name, surface, extent } = feature;
        let usual = Extent::usual(surface);
        let kind = surface.shape().table().to_owned();
        // Which of the four a kind has is known: the others are as usual.
        let other = |given: f64, usual: f64| {
            let is_usual = given <= usual && usual <= given;
            (!is_usual).then_some(given)
        };
        let form = |lobes: Lobes| (lobes != Lobes::NONE).then_some(lobes);
        let scatter = surface.scatter();
        let table = Self {
            name: (!name.is_empty()).then(|| name.clone()),
            kind,
            top: other(extent.top, usual.top),
            bottom: other(extent.bottom, usual.bottom),
            length: other(extent.length, usual.length),
            reach: other(extent.reach, usual.reach),
            surface_scatter: (0.0 < scatter).then_some(scatter),
            ..Self::default()
        };
        match *surface {
            Surface::Round(workpiece, plane) => Self {
                centre: Some(workpiece.centre),
                diameter: Some(workpiece.diameter),
                plane: (plane != Plane::Xy).then_some(plane),
                ovality: form(workpiece.ovality),
                lobes: form(workpiece.lobes),
                ..table
            },
            Surface::Face(Face { point, normal, wave, .. }) => {
                Self { point: Some(point), normal: Some(normal), wave, ..table }
            }
            Surface::Point(FreePoint { point, normal, deviation, radius, .. }) => {
                let deviation = (0.0 < deviation.abs()).then_some(deviation);
                Self { point: Some(point), normal: Some(normal), deviation, radius, ..table }
            }
            Surface::Walls(Walls { centre, lengths: (first, second), angle, .. }) => Self {
                centre: Some(centre),
                width: second.is_none().then_some(first),
                lengths: second.map(|second| [first, second]),
                angle: (0.0 < angle.abs()).then_some(angle),
                ..table
            },
        }
    }
}

/// Where the features of a file are, for errors.
struct Places<'a> {
    text: &'a str,
    /// The place of each table, and its name.
    features: Vec<(usize, String)>,
}

impl<'a> Places<'a> {
    fn of(text: &'a str) -> Self {
        let root = toml::de::DeTable::parse_recoverable(text).0;
        let tables = root.get_ref().get("feature").and_then(|value| value.get_ref().as_array());
        let features =
            (1..).zip(tables.into_iter().flat_map(|tables| tables.iter())).map(|(number, value): (usize, _)| {
                let name = value.get_ref().as_table().and_then(|table| table.get("name"));
                let name = name.and_then(|name| name.get_ref().as_str()).filter(|name| !name.is_empty());
                (
                    value.span().start,
                    name.map_or_else(|| usual_name(number), |name| name.chars().take(LONGEST_NAME).collect()),
                )
            });
        Self { text, features: features.collect() }
    }

    /// The error of a feature at a key, or at its table if the key is not there.
    fn fault(&self, number: usize, key: &str, fault: FeatureFault) -> SimulationError {
        let root = toml::de::DeTable::parse_recoverable(self.text).0;
        let tables = root.get_ref().get("feature").and_then(|value| value.get_ref().as_array());
        let table = tables.and_then(|tables| tables.get(number));
        let own =
            table.and_then(|table| table.get_ref().as_table()?.get_key_value(key)).map(|(key, _)| key.span().start);
        let (start, name) = self.features.get(number).map_or_else(|| (0, usual_name(number + 1)), Clone::clone);
        self.at(own.unwrap_or(start), name, fault)
    }

    fn at(&self, offset: usize, feature: String, fault: FeatureFault) -> SimulationError {
        let line = line_at(self.text, offset);
        let column = column_at(self.text, offset);
        SimulationError::Feature { line, column, feature, fault }
    }

    /// An error of the TOML reader: within a feature it names the feature.
    fn toml(&self, error: &toml::de::Error) -> SimulationError {
        let offset = error.span().map_or(0, |span| span.start);
        let said = bounded(&plain(error, self.text));
        // The table that began last before the place, unless another one began since.
        let header = self.text.get(..offset).and_then(|before| before.rfind("\n[")).map_or(0, |at| at + 1);
        let own = self.features.iter().rfind(|(start, _)| *start <= offset && header <= *start + 1);
        match own {
            Some((_, name)) => self.at(offset, name.clone(), FeatureFault::Toml { said }),
            None => SimulationError::Toml { line: line_at(self.text, offset), said },
        }
    }
}

/// The name of a feature without one, by its number from 1.
fn usual_name(number: usize) -> String {
    format!("F{number}")
}

impl Part {
    /// Whether a text, or the beginning of one, is a file of several features: one with `[[feature]]` tables.
    pub fn is_file(text: &str) -> bool {
        has_features(text)
    }

    /// Reads a file: one with `[[feature]]` tables, or one with a single table as [`Simulation::read`] does.
    ///
    /// ```
    /// use fitcheck_core::probing::simulated::Part;
    ///
    /// let part = Part::read(
    ///     "[[feature]]\nkind = \"bore\"\ncentre = [50, 20]\ndiameter = 25.012\n\
    ///      [[feature]]\nname = \"rib\"\nkind = \"ridge\"\ncentre = [90, 20]\nwidth = 8\nlength = 30\n",
    /// )?;
    /// assert_eq!(part.features[0].name, "F1");
    /// assert_eq!(part.features[1].extent.length, 30.0);
    /// # Ok::<(), fitcheck_core::probing::simulated::SimulationError>(())
    /// ```
    ///
    /// # Errors
    /// [`SimulationError`] with the place; within a feature, with its name.
    pub fn read(text: &str) -> Result<Self, SimulationError> {
        if LARGEST < text.len() || !has_features(text) {
            return Simulation::read(text).map(Self::from);
        }
        let places = Places::of(text);
        let file: File = toml::from_str(text).map_err(|error| places.toml(&error))?;
        if MOST_FEATURES < file.feature.len() {
            return Err(SimulationError::TooMany { most: MOST_FEATURES });
        }
        let mut features = Vec::with_capacity(file.feature.len());
        let mut names = std::collections::BTreeSet::new();
        for (number, table) in file.feature.into_iter().enumerate() {
            let feature = read_feature(number, table).map_err(|(key, fault)| places.fault(number, key, fault))?;
            if !names.insert(feature.name.clone()) {
                return Err(places.fault(number, "name", FeatureFault::SameName));
            }
            let checked = feature.check(file.probe.trigger_scatter);
            checked.map_err(|error| match error.what.place() {
                (Table::Shape, key) => places.fault(number, key, FeatureFault::Figure(error)),
                _ => of_file(text, error),
            })?;
            features.push(feature);
        }
        let probe = file.probe.probe();
        let stylus_radius = file.probe.stylus_radius;
        let seed = file.seed;
        let temperature = file.temperature;
        let expansion = file.expansion;
        let part = Self { features, probe, stylus_radius, seed, temperature, expansion };
        part.check().map_err(|error| of_file(text, error))?;
        Ok(part)
    }

    /// The part as a file; [`Self::read`] turns it back into the same part.
    ///
    /// # Errors
    /// The TOML writer's message, for figures that no file can hold.
    pub fn write(&self) -> Result<String, toml::ser::Error> {
        if let ([PartFeature { name, surface, extent }], None) = (self.features.as_slice(), self.stylus_radius)
            && name.is_empty()
            && extent.is_endless()
        {
            let surface = *surface;
            let probe = self.probe;
            let seed = self.seed;
            let temperature = self.temperature;
            let expansion = self.expansion;
            return Simulation { surface, probe, seed, temperature, expansion }.write();
        }
        toml::to_string(&File {
            seed: self.seed,
            temperature: self.temperature,
            expansion: self.expansion,
            probe: ProbeTable::of(self),
            feature: self.features.iter().map(FeatureTable::of).collect(),
        })
    }
}

fn read_feature(number: usize, table: FeatureTable) -> Result<PartFeature, (&'static str, FeatureFault)> {
    let surface = table.surface()?;
    let extent = table.extent(&surface);
    let name = table.name.unwrap_or_else(|| usual_name(number + 1));
    if name.is_empty() || LONGEST_NAME < name.chars().count() || name.chars().any(char::is_control) {
        return Err(("name", FeatureFault::Name { most: LONGEST_NAME }));
    }
    Ok(PartFeature { name, surface, extent })
}

/// The error of a figure that all features share.
fn of_file(text: &str, error: WorkpieceError) -> SimulationError {
    SimulationError::CannotBe { line: line_of(text, "", error.what), error }
}
