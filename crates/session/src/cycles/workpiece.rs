//! The simulated workpiece and probe as text fields, read anew at every change.

use std::collections::BTreeMap;

use fitcheck_core::length::{Length, LengthError};
use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_core::probing::cycle::{Plane, number};
use fitcheck_core::probing::simulated::{
    Face, FreePoint, Lobes, Probe, Shape, Simulation, Surface, Walls, Wave, Workpiece,
};
use fitcheck_core::tolerance::Feature;

use super::workpiece_field::WorkpieceField;
use crate::texts::whole;

/// The simulated workpiece, its probe and its seed as they are typed.
#[derive(Debug, Clone)]
pub struct WorkpieceForm {
    pub shape: Shape,
    /// The plane of a round surface.
    pub plane: Plane,
    texts: BTreeMap<WorkpieceField, String>,
    errors: BTreeMap<WorkpieceField, Message>,
    /// The simulation, where every field can be used.
    pub simulation: Option<Simulation>,
}

impl Default for WorkpieceForm {
    /// A hole as a workshop makes it, and an ordinary probe with a ball.
    fn default() -> Self {
        let bore = Surface::Round(Workpiece::usual(Feature::Hole, 25.0), Plane::Xy);
        Self::of(&Simulation { probe: Probe { ball_radius: 3.0, ..Probe::USUAL }, ..Simulation::perfect(bore) })
    }
}

impl WorkpieceForm {
    /// The fields of a simulation.
    pub fn of(simulation: &Simulation) -> Self {
        let shape = simulation.surface.shape();
        let plane = simulation.surface.plane();
        let texts = BTreeMap::new();
        let errors = BTreeMap::new();
        let mut form = Self { shape, plane, texts, errors, simulation: Some(*simulation) };
        form.fill_surface(&simulation.surface);
        form.fill_probe(&simulation.probe);
        form.fill(WorkpieceField::Seed, simulation.seed.to_string());
        let climate = [simulation.temperature, simulation.expansion];
        form.put([WorkpieceField::Temperature, WorkpieceField::Expansion], climate);
        form.read();
        form
    }

    fn fill(&mut self, field: WorkpieceField, text: String) {
        self.texts.insert(field, text);
    }

    fn put<const N: usize>(&mut self, fields: [WorkpieceField; N], figures: [f64; N]) {
        self.texts.extend(fields.into_iter().zip(figures.map(|figure| figure.to_string())));
    }

    fn fill_lobes(&mut self, [count, height, angle]: [WorkpieceField; 3], lobes: &Lobes) {
        self.fill(count, lobes.count.to_string());
        self.put([height, angle], [lobes.amplitude, lobes.angle]);
    }

    fn fill_surface(&mut self, surface: &Surface) {
        use WorkpieceField as F;
        // The figures of other kinds of surface keep sensible initial values.
        self.put([F::PointX, F::PointY, F::PointZ], [0.0; 3]);
        self.put([F::NormalX, F::NormalY, F::NormalZ], [0.0, 0.0, 1.0]);
        self.put([F::WaveX, F::WaveY, F::WaveZ], [1.0, 0.0, 0.0]);
        self.put([F::CentreX, F::CentreY, F::Diameter], [0.0, 0.0, 25.0]);
        self.put([F::Ovality, F::OvalityAngle, F::Deviation], [0.0; 3]);
        self.put([F::Width, F::FirstLength, F::SecondLength], [25.0, 60.0, 40.0]);
        self.put([F::Angle, F::WaveLength], [0.0, 10.0]);
        self.fill_lobes([F::LobeCount, F::LobeHeight, F::LobeAngle], &Lobes { count: 3, ..Lobes::default() });
        match surface {
            Surface::Round(round, _) => {
                let [x, y] = round.centre;
                self.put([F::CentreX, F::CentreY, F::Diameter], [x, y, round.diameter]);
                let Lobes { amplitude, angle, .. } = round.ovality;
                self.put([F::Ovality, F::OvalityAngle, F::SurfaceScatter], [amplitude, angle, round.surface_scatter]);
                if 0 < round.lobes.count {
                    self.fill_lobes([F::LobeCount, F::LobeHeight, F::LobeAngle], &round.lobes);
                }
            }
            Surface::Face(face) => {
                self.put([F::PointX, F::PointY, F::PointZ], face.point);
                self.put([F::NormalX, F::NormalY, F::NormalZ], face.normal);
                self.put([F::SurfaceScatter], [face.surface_scatter]);
                if let Some(wave) = &face.wave {
                    self.put([F::WaveHeight, F::WaveLength], [wave.amplitude, wave.length]);
                    self.put([F::WaveX, F::WaveY, F::WaveZ], wave.direction);
                }
            }
            Surface::Point(point) => {
                self.put([F::PointX, F::PointY, F::PointZ], point.point);
                self.put([F::NormalX, F::NormalY, F::NormalZ], point.normal);
                self.put([F::Deviation, F::SurfaceScatter], [point.deviation, point.surface_scatter]);
                if let Some(radius) = point.radius {
                    self.put([F::Radius], [radius]);
                }
            }
            Surface::Walls(walls) => {
                let ([x, y], (first, second)) = (walls.centre, walls.lengths);
                self.put([F::CentreX, F::CentreY, F::Angle], [x, y, walls.angle]);
                self.put([F::SurfaceScatter], [walls.surface_scatter]);
                match second {
                    None => self.put([F::Width], [first]),
                    Some(second) => self.put([F::FirstLength, F::SecondLength], [first, second]),
                }
            }
        }
    }

    fn fill_probe(&mut self, probe: &Probe) {
        use WorkpieceField as F;
        let parts = [probe.ball_radius, probe.trigger_scatter, probe.calibration_error];
        self.put([F::BallRadius, F::TriggerScatter, F::CalibrationError], parts);
        if let Some(offset) = probe.offset {
            self.put([F::OffsetX, F::OffsetY], offset);
        }
        self.fill_lobes([F::LobingCount, F::LobingHeight, F::LobingAngle], &probe.lobing);
    }

    pub fn text(&self, field: WorkpieceField) -> &str {
        self.texts.get(&field).map_or("", String::as_str)
    }

    /// What is wrong with a field.
    pub fn error(&self, field: WorkpieceField) -> Option<&Message> {
        self.errors.get(&field)
    }

    /// The first thing that is wrong, with the name of its field.
    pub fn problem(&self) -> Option<Message> {
        let (field, error) = self.errors.first_key_value()?;
        let name = Message::new(field.name_id());
        Some(message!("cycles-workpiece-field").message("name", name).message("problem", error.clone()))
    }

    pub(crate) fn set(&mut self, field: WorkpieceField, text: String) {
        self.texts.insert(field, text);
        self.read();
    }

    pub(crate) fn set_shape(&mut self, shape: Shape) {
        self.shape = shape;
        self.read();
    }

    pub(crate) fn set_plane(&mut self, plane: Plane) {
        self.plane = plane;
        self.read();
    }

    /// The workpiece that a cycle expects, with the form and the roughness that a workshop gives it; probe, seed and
    /// temperature stay. A point of a free surface and a face can replace each other: the chosen one stays.
    pub(super) fn suited(&self, nominal: Surface) -> Simulation {
        let rough: f64 = 0.0003;
        let surface = match nominal {
            Surface::Round(round, plane) => {
                // A tiny circle would not be round with a micrometre of ovality.
                let height = 0.001_f64.min(round.diameter / 100.0);
                let ovality = Lobes { count: 2, amplitude: height, angle: 0.0 };
                let surface_scatter = rough.min(round.diameter / 100.0);
                Surface::Round(Workpiece { ovality, surface_scatter, ..round }, plane)
            }
            Surface::Face(Face { point, normal, .. }) | Surface::Point(FreePoint { point, normal, .. }) => {
                match self.shape {
                    Shape::Point => {
                        Surface::Point(FreePoint { surface_scatter: rough, ..FreePoint::flat(point, normal) })
                    }
                    _ => Surface::Face(Face { surface_scatter: rough, ..Face::plane(point, normal) }),
                }
            }
            Surface::Walls(walls) => Surface::Walls(Walls { surface_scatter: rough, ..walls }),
        };
        let machine = self.simulation.unwrap_or_else(|| Simulation {
            probe: Probe { ball_radius: 3.0, ..Probe::USUAL },
            ..Simulation::perfect(surface)
        });
        Simulation { surface, ..machine }
    }

    fn read(&mut self) {
        self.errors.clear();
        let simulation = self.read_workpiece();
        self.simulation = simulation.filter(|_| self.errors.is_empty());
        if let Some(Err(error)) = self.simulation.map(|simulation| simulation.machine()) {
            self.errors.insert(WorkpieceField::named(&error, self.shape), error.message());
            self.simulation = None;
        }
    }

    fn read_workpiece(&mut self) -> Option<Simulation> {
        use WorkpieceField as F;
        let surface = match self.shape {
            Shape::Hole | Shape::Stud => self.read_round(),
            Shape::Face => self.read_face(),
            Shape::Point => self.read_point(),
            Shape::Slot | Shape::Ridge | Shape::Pocket | Shape::Boss => self.read_walls(),
        };
        let probe = self.read_probe();
        let seed = self.whole(F::Seed);
        let temperature = self.figure(F::Temperature);
        let expansion = self.figure(F::Expansion);
        Some(Simulation {
            surface: surface?,
            probe: probe?,
            seed: seed?,
            temperature: temperature?,
            expansion: expansion?,
        })
    }

    fn read_walls(&mut self) -> Option<Surface> {
        use WorkpieceField as F;
        let [x, y, angle] = self.figures([F::CentreX, F::CentreY, F::Angle])?;
        let lengths = match self.shape {
            Shape::Slot | Shape::Ridge => (self.figure(F::Width)?, None),
            _ => (self.figure(F::FirstLength)?, Some(self.figure(F::SecondLength)?)),
        };
        let surface_scatter = self.figure(F::SurfaceScatter)?;
        let walls = Walls::new(self.shape.feature(), [x, y], lengths);
        Some(Surface::Walls(Walls { angle, surface_scatter, ..walls }))
    }

    fn read_round(&mut self) -> Option<Surface> {
        use WorkpieceField as F;
        let [x, y, diameter] = self.figures([F::CentreX, F::CentreY, F::Diameter])?;
        let [amplitude, angle, surface_scatter] = self.figures([F::Ovality, F::OvalityAngle, F::SurfaceScatter])?;
        let lobes = self.lobes([F::LobeCount, F::LobeHeight, F::LobeAngle])?;
        let ovality = Lobes { count: 2, amplitude, angle };
        let round =
            Workpiece { feature: self.shape.feature(), centre: [x, y], diameter, ovality, lobes, surface_scatter };
        Some(Surface::Round(round, self.plane))
    }

    fn read_face(&mut self) -> Option<Surface> {
        use WorkpieceField as F;
        let point = self.figures([F::PointX, F::PointY, F::PointZ])?;
        let normal = self.figures([F::NormalX, F::NormalY, F::NormalZ])?;
        let surface_scatter = self.figure(F::SurfaceScatter)?;
        let wave = if self.text(F::WaveHeight).trim().is_empty() {
            None
        } else {
            let direction = self.figures([F::WaveX, F::WaveY, F::WaveZ])?;
            Some(Wave { amplitude: self.figure(F::WaveHeight)?, length: self.figure(F::WaveLength)?, direction })
        };
        Some(Surface::Face(Face { point, normal, wave, surface_scatter }))
    }

    fn read_point(&mut self) -> Option<Surface> {
        use WorkpieceField as F;
        let point = self.figures([F::PointX, F::PointY, F::PointZ])?;
        let normal = self.figures([F::NormalX, F::NormalY, F::NormalZ])?;
        let deviation = self.figure(F::Deviation)?;
        let surface_scatter = self.figure(F::SurfaceScatter)?;
        let is_flat = self.text(F::Radius).trim().is_empty();
        let radius = if is_flat { None } else { Some(self.figure(F::Radius)?) };
        Some(Surface::Point(FreePoint { point, normal, deviation, radius, surface_scatter }))
    }

    fn read_probe(&mut self) -> Option<Probe> {
        use WorkpieceField as F;
        let [ball_radius, trigger_scatter, calibration_error] =
            self.figures([F::BallRadius, F::TriggerScatter, F::CalibrationError])?;
        let is_known = [F::OffsetX, F::OffsetY].iter().all(|field| self.text(*field).trim().is_empty());
        let offset = if is_known { None } else { Some(self.both([F::OffsetX, F::OffsetY])?) };
        let lobing = self.lobes([F::LobingCount, F::LobingHeight, F::LobingAngle])?;
        Some(Probe { trigger_scatter, ball_radius, calibration_error, offset, lobing })
    }

    /// Two figures that may only be left out together: with one alone, the other would be a guess.
    fn both(&mut self, fields: [WorkpieceField; 2]) -> Option<[f64; 2]> {
        for field in fields {
            if self.text(field).trim().is_empty() {
                self.errors.insert(field, LengthError::Empty.message());
                return None;
            }
        }
        let [one, two] = fields.map(|field| self.figure(field));
        Some([one?, two?])
    }

    fn lobes(&mut self, [count, height, angle]: [WorkpieceField; 3]) -> Option<Lobes> {
        let count = self.whole(count);
        let amplitude = self.figure(height);
        let angle = self.figure(angle);
        let lobes = Lobes { count: count?, amplitude: amplitude?, angle: angle? };
        // Without an amplitude, a count below 2 means no lobes.
        Some(if lobes.amplitude <= 0.0 && lobes.count < 2 { Lobes { count: 0, ..lobes } } else { lobes })
    }

    fn figures(&mut self, fields: [WorkpieceField; 3]) -> Option<[f64; 3]> {
        let [one, two, three] = fields.map(|field| self.figure(field));
        Some([one?, two?, three?])
    }

    fn figure(&mut self, field: WorkpieceField) -> Option<f64> {
        let text = self.text(field).trim().to_owned();
        if text.is_empty() && field.is_optional() {
            return Some(0.0);
        }
        // A length may name its unit.
        let length = || match field.unit() {
            "mm" => text.parse().map(Length::to_mm_f64),
            _ if text.is_empty() => Err(LengthError::Empty),
            _ => Err(LengthError::NotANumber { text: text.clone() }),
        };
        match number(&text).map_or_else(length, Ok) {
            Ok(figure) => Some(figure),
            Err(error) => {
                self.errors.insert(field, error.message());
                None
            }
        }
    }

    fn whole<T: std::str::FromStr>(&mut self, field: WorkpieceField) -> Option<T> {
        whole(self.text(field)).map_err(|error| self.errors.insert(field, error)).ok()
    }
}
