//! What cycles 14xx share: nominal values as texts with their tolerances, the way to the clearance height, the status and the correction of
//! the active preset.
//!
//! All of it is remembered but the names of 1400 and 1401 (`docs/SOURCES.md`, "Cycles 14xx"). Decided here, where nothing is known of the
//! control: deviations count from the middle of the zone, which the control probes for and compares with; a class of a hole for a stud is
//! refused, and the other way round; a tolerance for a value that is not measured is refused, too; a result that was not measured is
//! not given; the contacts of an arc lie from its start to its end, those of a full turn at equal angles.

use super::circle_probing::{Round, Way};
use super::{judged, round};
use crate::length::Length;
use crate::probing::contact::Contact;
use crate::probing::cycle::shared::ERROR_REACTION;
use crate::probing::cycle::{
    Angle, Axis, Check, CircleFound, Course, CycleError, DatumAxis, DatumTarget, Inputs, Key, Meaning, Measured,
    NewDatum, Parameter, Plane, ResultName, ResultParameter, Stop,
};
use crate::tolerance::{Feature, Nominal};
use crate::verdict::Status;
use crate::words::Dialogue::{De, En, It, Nl};

// De, Nl, It: not seen.

/// The nominal value of the first point in the first axis.
pub(super) const POINT_1: Parameter = Parameter::nominal_coordinate(1100, "1ST POINT REF AXIS")
    .named(&[(Nl, "1E PUNT HOOFDAS"), (De, "1.PUNKT HAUPTACHSE"), (It, "1. PUNTO ASSE PRINC.")])
    .asked(&[
        (En, "1st nominal position of ref. axis?"),
        (Nl, "1e nominale positie hoofdas?"),
        (De, "1. Sollposition Hauptachse?"),
        (It, "1. posizione nom. asse princ.?"),
    ])
    .means(Meaning::Point(Axis::First));
/// In the second.
pub(super) const POINT_2: Parameter = Parameter::nominal_coordinate(1101, "1ST POINT MINOR AXIS")
    .named(&[(Nl, "1E PUNT NEVENAS"), (De, "1.PUNKT NEBENACHSE"), (It, "1. PUNTO ASSE SECOND.")])
    .asked(&[
        (En, "1st nominal position of minor axis?"),
        (Nl, "1e nominale positie nevenas?"),
        (De, "1. Sollposition Nebenachse?"),
        (It, "1. posizione nom. asse second.?"),
    ])
    .means(Meaning::Point(Axis::Second));
/// In the third.
pub(super) const POINT_3: Parameter = Parameter::nominal_coordinate(1102, "1ST POINT TOOL AXIS")
    .named(&[(Nl, "1E PUNT GS-AS"), (De, "1.PUNKT WZ-ACHSE"), (It, "1. PUNTO ASSE UTENS.")])
    .asked(&[
        (En, "1st nominal position of tool axis?"),
        (Nl, "1e nominale positie gereedschapsas?"),
        (De, "1. Sollposition Werkzeugachse?"),
        (It, "1. posizione nom. asse utensile?"),
    ])
    .means(Meaning::Point(Axis::Third));
/// The nominal diameter.
pub(super) const DIAMETER: Parameter = Parameter::nominal_size(1116, "DIAMETER 1")
    .named(&[(Nl, "DIAMETER 1"), (De, "DURCHMESSER 1"), (It, "DIAMETRO 1")])
    .asked(&[(En, "Diameter 1?"), (Nl, "Diameter 1?"), (De, "Durchmesser 1?"), (It, "Diametro 1?")])
    .means(Meaning::Diameter);
/// Hole or stud.
pub(super) const GEOMETRY: Parameter = Parameter::choice(Key::Q(1115), "GEOMETRY TYPE", &[0, 1])
    .named(&[(Nl, "GEOMETRIETYPE"), (De, "GEOMETRIETYP"), (It, "TIPO DI GEOMETRIA")])
    .asked(&[
        (En, "Geometry type (0=hole/1=stud)?"),
        (Nl, "Geometrietype (0=boring/1=tap)?"),
        (De, "Geometrietyp (0=Bohrung/1=Zapfen)?"),
        (It, "Tipo di geometria (0=foro/1=isola)?"),
    ])
    .or(0)
    .means(Meaning::InsideOutside);
/// The number of contacts.
pub(super) const COUNT: Parameter = Parameter::choice(Key::Q(423), "NO. OF PROBE POINTS", &[3, 4, 5, 6, 7, 8, 9])
    .named(&[(Nl, "AANTAL TASTPUNTEN"), (De, "ANZAHL ANTASTPUNKTE"), (It, "N. PUNTI DI TASTATURA")])
    .asked(&[
        (En, "Number of probe points?"),
        (Nl, "Aantal tastpunten?"),
        (De, "Anzahl Antastpunkte?"),
        (It, "Numero di punti di tastatura?"),
    ])
    .or(4)
    .means(Meaning::ContactCount);
/// The angle over which they lie.
pub(super) const ARC: Parameter = Parameter::angle(Key::Q(1119), "ANGULAR LENGTH", 360, 1)
    .named(&[(Nl, "HOEKLENGTE"), (De, "WINKELLAENGE"), (It, "LUNGHEZZA ANGOLARE")])
    .asked(&[(En, "Angular length?"), (Nl, "Hoeklengte?"), (De, "Winkellänge?"), (It, "Lunghezza angolare?")])
    .or(FULL_TURN.ten_thousandths())
    .means(Meaning::Arc);
/// Where the probe goes to the clearance height.
pub(super) const CLEARANCE_MODE: Parameter = Parameter::choice(Key::Q(1125), "CLEAR. HEIGHT MODE", &[-1, 0, 1, 2])
    .named(&[(Nl, "MODUS VEILIGE HOOGTE"), (De, "MODUS SICHERE HOEHE"), (It, "MODO ALT. SICUREZZA")])
    .asked(&[
        (En, "Traverse to clearance height?"),
        (Nl, "Naar veilige hoogte gaan?"),
        (De, "Auf sichere Höhe fahren?"),
        (It, "Spostamento a altezza di sicurezza?"),
    ])
    .or(1)
    .means(Meaning::ClearanceMode);
/// Whether the program stops.
pub(super) const REACTION: Parameter = ERROR_REACTION.means(Meaning::StopOnScrap);
/// Whether the active preset is corrected. The control writes the word without its F.
pub(super) const PRESET: Parameter = Parameter::choice(Key::Q(1120), "TRANSER POSITION", &[0, 1])
    .named(&[(Nl, "OVER TE NEMEN POSITIE"), (De, "UEBERNAHMEPOSITION"), (It, "POSIZIONE CONFERMA")])
    .asked(&[
        (En, "Transfer position?"),
        (Nl, "Over te nemen positie?"),
        (De, "Übernahmeposition?"),
        (It, "Posizione da confermare?"),
    ])
    .or(0)
    .means(Meaning::PresetCorrection);

const FULL_TURN: Angle = Angle::from_degrees(360);

/// What a cycle has found, result by result.
#[derive(Default)]
pub(super) struct Findings {
    checks: Vec<Check>,
    results: Vec<ResultParameter>,
    deviations: Vec<ResultParameter>,
    axes: Vec<DatumAxis>,
}

impl Findings {
    /// A measured value against its nominal one: the numbers and names of the result and of its deviation, and the check if it has limits.
    pub(super) fn add(
        &mut self,
        (nominal, measured): (Nominal, Length),
        [at, off_at]: [u16; 2],
        [name, off_name]: [ResultName; 2],
        check: Option<Check>,
    ) {
        self.results.push(ResultParameter::length(at, name, measured));
        let off = measured.saturating_sub(nominal.target());
        self.deviations.push(ResultParameter::length(off_at, off_name, off));
        self.checks.extend(check);
    }

    /// A value that is given as it was found, against nothing.
    pub(super) fn only(&mut self, at: u16, name: ResultName, measured: Length) {
        self.also(ResultParameter::length(at, name, measured));
    }

    /// A result that is none of a length.
    pub(super) fn also(&mut self, result: ResultParameter) {
        self.results.push(result);
    }

    /// A coordinate of a centre: a wrong position is scrap.
    pub(super) fn centre(
        &mut self,
        axis: Axis,
        (nominal, measured): (Nominal, Length),
        at: [u16; 2],
        names: [ResultName; 2],
    ) {
        self.add((nominal, measured), at, names, judged::place(names[0], measured, nominal.limits()));
        self.correct(axis, nominal, measured);
    }

    /// What corrects the active preset where Q1120 asks for that: the place reads its nominal value afterwards.
    pub(super) fn correct(&mut self, axis: Axis, nominal: Nominal, measured: Length) {
        self.axes.push(DatumAxis { axis, measured, wanted: nominal.target() });
    }

    /// What corrects it instead.
    pub(super) fn correct_by(&mut self, axes: Vec<DatumAxis>) {
        self.axes = axes;
    }

    /// What the cycle says: the status, the stop that Q309 asks for, the correction of the preset.
    pub(super) fn measured(self, inputs: &Inputs, contacts: Vec<Contact>) -> Measured {
        let Self { checks, results, deviations, axes } = self;
        let status = checks.iter().map(|check| check.status).max();
        let setting = inputs.whole(REACTION.key);
        let stops = match setting {
            1 => true,
            2 => status == Some(Status::Scrap),
            _ => false,
        };
        let new = NewDatum { target: DatumTarget::Active, axes };
        Measured {
            contacts,
            status,
            results: results.into_iter().chain(deviations).chain([judged::status(status)]).collect(),
            stop: if stops { Stop::of(setting, &checks) } else { None },
            checks,
            datum: (inputs.whole(PRESET.key) != 0).then_some(new),
            ..Measured::default()
        }
    }
}

/// A hole or a stud, with the parameters of its nominal values.
pub(super) struct NominalCircle {
    pub(super) feature: Feature,
    pub(super) centre: [Parameter; 2],
    pub(super) height: Parameter,
    pub(super) diameter: Parameter,
}

impl NominalCircle {
    /// The hole or stud in the middle of its tolerance.
    pub(super) fn round(&self, inputs: &Inputs) -> Round {
        let target = |of: &Parameter| inputs.nominal(of.key).target().to_mm_f64();
        Round {
            feature: self.feature,
            centre: [target(&self.centre[0]), target(&self.centre[1])],
            diameter: target(&self.diameter),
            height: target(&self.height),
        }
    }

    /// Refuses what is not defined, before anything is probed.
    pub(super) fn check(&self, inputs: &Inputs) -> Result<(), CycleError> {
        not_measured(&self.height, inputs)?;
        of_feature(&self.diameter, self.feature, GEOMETRY.key, inputs)
    }

    /// Makes the contacts and finds the circle through them.
    pub(super) fn probe(
        &self,
        ways: [Way; 2],
        inputs: &Inputs,
        course: &mut Course<'_>,
    ) -> Result<(Vec<Contact>, CircleFound), CycleError> {
        let contacts = self.round(inputs).probe(angles(inputs), ways, inputs, course)?;
        let nominal = self.centre.map(|of| inputs.nominal(of.key));
        let targets = nominal.map(|nominal| nominal.target());
        let halves = nominal.map(|nominal| {
            nominal
                .limits()
                .map_or(Length::ZERO, |(minimum, maximum)| Length::ZERO.midpoint(maximum.saturating_sub(minimum)))
        });
        round::found(contacts, self.feature, Plane::Xy, course.ball_radius(), targets, halves)
    }

    /// What was found of it.
    pub(super) fn add(&self, found: &CircleFound, results: &CircleResults, inputs: &Inputs, findings: &mut Findings) {
        let axes = [Axis::First, Axis::Second];
        let CircleResults { centre, diameter: (at, names) } = *results;
        for (((of, measured), axis), (at, names)) in self.centre.iter().zip(found.centre).zip(axes).zip(centre) {
            findings.centre(axis, (inputs.nominal(of.key), measured), at, names);
        }
        let nominal = inputs.nominal(self.diameter.key);
        let [name, _] = names;
        let check = judged::size(name, found.diameter, nominal.limits(), self.feature);
        findings.add((nominal, found.diameter), at, names, check);
    }
}

/// The results of a circle, each with its deviation: numbers and names.
pub(super) struct CircleResults {
    pub(super) centre: [([u16; 2], [ResultName; 2]); 2],
    pub(super) diameter: ([u16; 2], [ResultName; 2]),
}

/// Those of the first circle of a cycle.
pub(super) const FIRST_CIRCLE: CircleResults = CircleResults {
    centre: [
        ([950, 980], [ResultName::CENTRE_1, ResultName::CENTRE_DEVIATION_1]),
        ([951, 981], [ResultName::CENTRE_2, ResultName::CENTRE_DEVIATION_2]),
    ],
    diameter: ([966, 996], [ResultName::DIAMETER, ResultName::DIAMETER_DEVIATION]),
};

/// Refuses a diameter of zero, and a class of the other feature.
pub(super) fn of_feature(
    diameter: &Parameter,
    feature: Feature,
    geometry: Key,
    inputs: &Inputs,
) -> Result<(), CycleError> {
    let (key, name, nominal) = (diameter.key, diameter.called(), inputs.nominal(diameter.key));
    if nominal.target() == Length::ZERO {
        return Err(CycleError::NoDiameter { key, name });
    }
    if nominal.feature().is_some_and(|class| class != feature) {
        return Err(CycleError::OtherFeature { key, name, given: nominal.to_string(), geometry });
    }
    Ok(())
}

/// Refuses a tolerance for a value that the cycle does not measure.
pub(super) fn not_measured(parameter: &Parameter, inputs: &Inputs) -> Result<(), CycleError> {
    let nominal = inputs.nominal(parameter.key);
    if nominal.limits().is_none() {
        return Ok(());
    }
    Err(CycleError::NotMeasured { key: parameter.key, name: parameter.called(), given: nominal.to_string() })
}

/// The ways to the first contact and to the others, as Q1125 says.
pub(super) fn ways(inputs: &Inputs) -> [Way; 2] {
    match inputs.whole(CLEARANCE_MODE.key) {
        -1 => [Way::Straight, Way::Arc],
        2 => [Way::Over, Way::Over],
        _ => [Way::Over, Way::Arc],
    }
}

/// Goes to the clearance height behind the last contact, unless Q1125 says never.
pub(super) fn leave(inputs: &Inputs, course: &mut Course<'_>) {
    if inputs.whole(CLEARANCE_MODE.key) != -1 {
        course.leave(inputs.mm(260));
    }
}

/// The angles of the contacts: Q423 of them from Q325 over Q1119, whose last one would be the first again where that is a full turn.
pub(super) fn angles(inputs: &Inputs) -> impl Iterator<Item = Angle> {
    let count = u8::try_from(inputs.whole(COUNT.key)).unwrap_or(3);
    let arc = inputs.angle(ARC.key);
    let is_full = arc.ten_thousandths().abs() == FULL_TURN.ten_thousandths();
    let step = arc.divided(if is_full { count } else { count.saturating_sub(1) });
    let first = inputs.angle(325);
    (0..count).map(move |number| first.stepped(step, number))
}
