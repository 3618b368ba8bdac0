//! Press fits: arguments, the answer for people and in figures.

use super::heat::HeatArgs;
use super::line::line;
use crate::cli::admitted::Admits;
use crate::cli::material::materials;
use crate::cli::{CliError, ErrorSubject, Figure, IntoCliError as _, Io};
use crate::length::{Length, Unit};
use crate::tolerance::fit::press::{Joint, Press, PressError, PressRemark, Ratio, figure};

/// The material of both parts where none is given.
const STEEL: &str = "steel";

/// A press fit.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Press fit")]
pub(super) struct PressArgs {
    /// Show pressure, holding force and torque, stresses and joining temperatures of a press fit
    #[arg(long, group = "heat", requires = "length", requires = "hub_outer")]
    press: bool,

    /// Length of the joint in mm
    #[arg(long, value_name = "MM", requires = "press")]
    length: Option<String>,

    /// Outer diameter of the hub in mm
    #[arg(long, value_name = "MM", requires = "press")]
    hub_outer: Option<String>,

    /// Bore of the shaft in mm; 0 is a solid shaft
    #[arg(long, value_name = "MM", default_value = "0", requires = "press")]
    shaft_inner: String,

    /// Coefficient of friction
    #[arg(long, value_name = "MU", default_value = "0.12", requires = "press")]
    friction: String,

    /// Roughness Rz of the hub's bore in µm; default: no loss by smoothing
    #[arg(long, value_name = "UM", requires = "press")]
    hub_rz: Option<String>,

    /// Roughness Rz of the shaft in µm
    #[arg(long, value_name = "UM", requires = "press")]
    shaft_rz: Option<String>,

    /// Yield strength of the hub in MPa; default: that of its material, if it has one
    #[arg(long, value_name = "MPA", requires = "press", value_parser = clap::value_parser!(u32).range(1..=10_000))]
    hub_yield: Option<u32>,

    /// Yield strength of the shaft in MPa
    #[arg(long, value_name = "MPA", requires = "press", value_parser = clap::value_parser!(u32).range(1..=10_000))]
    shaft_yield: Option<u32>,
}

/// A joint with the names of its materials.
#[derive(Debug, Clone)]
pub(super) struct NamedJoint {
    pub joint: Joint,
    pub hub: String,
    pub shaft: String,
}

impl PressArgs {
    pub(super) const fn is_asked(&self) -> bool {
        self.press
    }

    /// The joint; `None` where no press fit is asked for.
    pub(super) fn load(&self, heat: &HeatArgs) -> Result<Option<NamedJoint>, CliError> {
        let (Some(length), Some(hub_outer)) = (&self.length, &self.hub_outer) else { return Ok(None) };
        let (names, own) = heat.materials();
        let materials = materials(own)?;
        let part = |name: Option<&str>, which: ErrorSubject<'_>, yield_mpa: Option<u32>| -> Result<_, CliError> {
            let material = materials.find(name.unwrap_or(STEEL)).about(&which)?;
            let mut part = material.press_part().about(&which)?;
            part.elastic.yield_mpa = yield_mpa.or(part.elastic.yield_mpa);
            Ok((part, material.name.clone()))
        };
        let [hub, shaft] = names;
        let (hub, hub_name) = part(hub, ErrorSubject::HoleMaterial, self.hub_yield)?;
        let (shaft, shaft_name) = part(shaft, ErrorSubject::ShaftMaterial, self.shaft_yield)?;
        let read = |text: &str, name: &'static str, unit: Unit| {
            Length::parse_in(text, unit).about(&ErrorSubject::Option { name })
        };
        let rz = |text: &Option<String>, name| {
            text.as_ref().map_or(Ok(Length::ZERO), |text| read(text, name, Unit::Micrometre))
        };
        let [hub_rz, shaft_rz] = [rz(&self.hub_rz, "hub-rz")?, rz(&self.shaft_rz, "shaft-rz")?];
        for (given, name) in [(hub_rz, "hub-rz"), (shaft_rz, "shaft-rz")] {
            if given < Length::ZERO {
                let error = PressError::Roughness { given };
                return Err(error).about(&ErrorSubject::Option { name });
            }
        }
        let joint = Joint {
            length: read(length, "length", Unit::Millimetre)?,
            hub_outer: read(hub_outer, "hub-outer", Unit::Millimetre)?,
            shaft_bore: read(&self.shaft_inner, "shaft-inner", Unit::Millimetre)?,
            roughness: hub_rz.checked_add(shaft_rz).unwrap_or(Length::MAX),
            friction: self.friction.parse::<Ratio>().about(&ErrorSubject::Option { name: "friction" })?,
            hub,
            shaft,
        };
        Ok(Some(NamedJoint { joint, hub: hub_name, shaft: shaft_name }))
    }
}

/// Whether somebody has to look first is said by the remark itself: a joint that yields or may be loose is not safe.
impl Admits for PressRemark {
    fn wants_a_look(&self) -> bool {
        self.stands_against()
    }
}

row! {
    /// A press fit in figures.
    pub(super) struct PressFigures of(named: &NamedJoint, press: &Press) {
        length_mm: Figure = Figure::mm(named.joint.length, 0),
        hub_outer_mm: Figure = Figure::mm(named.joint.hub_outer, 0),
        shaft_inner_mm: Figure = Figure::mm(named.joint.shaft_bore, 0),
        friction: Figure = Figure(named.joint.friction.to_string()),
        minimum_interference_um: Option<Figure> = press.interference.first().map(|one| Figure::um(*one)),
        maximum_interference_um: Option<Figure> = press.interference.last().map(|one| Figure::um(*one)),
        smoothing_um: Figure = Figure::um(press.loss),
        minimum_pressure_mpa: Option<Figure> = press.pressure.first().copied().flatten().map(float),
        maximum_pressure_mpa: Option<Figure> = press.pressure.last().copied().flatten().map(float),
        axial_force_n: Option<Figure> = press.axial_force.map(float),
        torque_nm: Option<Figure> = press.torque.map(float),
        pressing_force_n: Option<Figure> = press.pressing_force.map(float),
        elastic: &'static str = elastic(press),
        hub_stress_mpa: Figure = float(press.hub.equivalent),
        hub_tangential_mpa: Figure = float(press.hub.tangential),
        hub_yield_mpa: Option<Figure> = press.hub.yield_strength.map(whole),
        shaft_stress_mpa: Figure = float(press.shaft.equivalent),
        shaft_tangential_mpa: Figure = float(press.shaft.tangential),
        shaft_yield_mpa: Option<Figure> = press.shaft.yield_strength.map(whole),
        joining_play_um: Figure = Figure::um(press.play),
        heat_hub_c: Option<Figure> = press.heat_hub.map(float),
        cool_shaft_c: Option<Figure> = press.cool_shaft.map(float),
        hub_material: String = named.hub.clone(),
        shaft_material: String = named.shaft.clone(),
    }
}

fn whole(value: u32) -> Figure {
    Figure(value.to_string())
}

fn float(value: f64) -> Figure {
    Figure(figure(value))
}

/// `yes`, `no`, or `unknown` where a yield strength is missing.
fn elastic(press: &Press) -> &'static str {
    match press.is_elastic() {
        Some(true) => "yes",
        Some(false) => "no",
        None => "unknown",
    }
}

pub(super) fn write(named: &NamedJoint, press: &Press, io: &mut Io<'_>) {
    let NamedJoint { joint, hub, shaft } = named;
    let [smallest, largest] = press.interference;
    let um = |length: Length| length.exact(Unit::Micrometre, 0);
    let loss =
        if press.loss == Length::ZERO { String::new() } else { format!(", {} µm lost by smoothing", um(press.loss)) };
    line("press fit", format_args!("interference {} … {} µm{loss}", um(smallest), um(largest)), io);
    match press.pressure {
        [Some(least), Some(most)] => line("", format_args!("pressure {} … {} MPa", figure(least), figure(most)), io),
        _ => line("", "not elastic: no pressure, force or torque can be given", io),
    }
    if let (Some(force), Some(torque)) = (press.axial_force, press.torque) {
        let friction = joint.friction;
        let held = format!("holds at least {} N axially or {} N·m", figure(force), figure(torque));
        line("", format_args!("{held}, friction {friction}"), io);
    }
    if let Some(force) = press.pressing_force {
        line("", format_args!("pressing force at most {} N", figure(force)), io);
    }
    for (name, material, part) in [("hub", hub, press.hub), ("shaft", shaft, press.shaft)] {
        let limit = part.yield_strength.map_or_else(|| "unknown".to_owned(), |limit| format!("{limit} MPa"));
        let stress = format!("{} MPa, tangential {} MPa", figure(part.equivalent), figure(part.tangential));
        line("", format_args!("{name} {material}: stress {stress}, yield strength {limit}"), io);
    }
    let heat = press.heat_hub.map(|hot| format!("heat the hub to {} °C", figure(hot)));
    let cool = press.cool_shaft.map(|cold| format!("cool the shaft to {} °C", figure(cold)));
    let ways: Vec<String> = heat.into_iter().chain(cool).collect();
    let ways = if ways.is_empty() { "neither heat nor cold alone is enough".to_owned() } else { ways.join(" or ") };
    line("joining", format_args!("{ways}, for a play of {} µm", um(press.play)), io);
}
