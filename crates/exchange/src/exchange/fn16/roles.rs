//! Which field of a mask is what: by the number of its parameter, else by the words before it or by what was printed.
//!
//! Results and limits of measuring cycles have numbers of their own. A parameter of the user's own is told by the limits of the callout that
//! is printed beside it: the minimum and the maximum are always these, with more than one callout, and what is left is the measured value.
//! If more than one is left, the mask is refused. A mask that says which part it is prints one value or several of each part: there the
//! words before the fields tell (see `labelled`).

use std::collections::BTreeSet;

use fitcheck_core::length::{Length, Unit};
use fitcheck_core::probing::cycle::number;
use fitcheck_core::tolerance::{Callout, Limits, Sources, ToleranceClass};
use fitcheck_nc::control::mask::{FieldContent, Printed, Slot};
use fitcheck_nc::control::variables::Parameter;

use super::fields::{Fields, MARKERS, Reading, ReadingKind, STATUS, is_callout, is_status, length, value};
use super::labelled;
use super::part::PartFields;
use crate::exchange::claim::Claim;
use crate::exchange::error::ImportErrorKind;
use crate::exchange::given::shorten;
use crate::exchange::vocabulary::Names;

/// A result of a measuring cycle, and the parameters that hold its limits: those of the cycle itself, and those of programs that call it.
struct CycleReading {
    measured: u16,
    kind: ReadingKind,
    /// Minimum and maximum.
    limits: &'static [(u16, u16)],
    /// The nominal size of the cycle.
    nominal: Option<u16>,
}

/// The results that have limits; `docs/SOURCES.md` says where the numbers are from.
const RESULTS: [CycleReading; 5] = [
    CycleReading {
        measured: 153,
        kind: ReadingKind::Size,
        limits: &[(33, 23), (276, 275), (278, 277)],
        nominal: Some(262),
    },
    CycleReading { measured: 154, kind: ReadingKind::Size, limits: &[(285, 284), (83, 73)], nominal: Some(282) },
    CycleReading { measured: 155, kind: ReadingKind::Size, limits: &[(287, 286), (33, 23)], nominal: Some(283) },
    CycleReading { measured: 156, kind: ReadingKind::Size, limits: &[(289, 288), (33, 23)], nominal: Some(311) },
    CycleReading { measured: 160, kind: ReadingKind::Coordinate, limits: &[(289, 288), (33, 23)], nominal: None },
];

/// The deviation along the normal, which cycle 444 leaves; rectangles have that of their first side there.
const NORMAL: u16 = 164;

/// Texts that hold its tolerance: that of the cycle, and that of programs that call it.
const BANDS: [u16; 2] = [400, 1];

/// The centre in two axes.
const CENTRE: [u16; 2] = [151, 152];

/// What the fields of a mask are.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Roles {
    pub(super) readings: Vec<Reading>,
    pub(super) name: Option<usize>,
    /// The callout, or its class alone.
    pub(super) callout: Option<usize>,
    pub(super) nominal: Option<usize>,
    pub(super) status: Option<usize>,
    /// The tolerance of a point.
    pub(super) band: Option<usize>,
    pub(super) centre: Option<[usize; 2]>,
    /// What tells the part from others: its number, its serial number, a counter.
    pub(super) part: PartFields,
    /// Hole or shaft, where a text says it.
    pub(super) side: Option<usize>,
    /// The markers of a cycle, by their numbers.
    markers: Vec<(u16, usize)>,
}

impl Roles {
    /// The roles of a mask's fields, by what was printed with it.
    pub(super) fn of(
        mask: &str,
        slots: &[Slot],
        sample: &[Printed],
        sources: &Sources,
    ) -> Result<Self, ImportErrorKind> {
        let fields = Fields { slots, sample };
        let part = PartFields::of(slots);
        let centre = CENTRE.map(|number| fields.number(number));
        let mut roles = Self {
            readings: fields.known(),
            name: None,
            callout: fields.text(is_callout),
            nominal: fields.number(1),
            status: fields.text(is_status).or_else(|| fields.at(Parameter::qs(3))),
            band: None,
            markers: fields.markers(),
            centre: centre[0].zip(centre[1]).map(<[usize; 2]>::from),
            side: fields.text(is_side),
            part,
        };
        if roles.nominal.is_some() {
            roles.callout = roles.callout.or_else(|| fields.text(is_class));
        }
        if roles.readings.iter().any(|reading| reading.kind == ReadingKind::Point) {
            roles.band = BANDS.into_iter().find_map(|number| fields.at(Parameter::qs(number)));
            roles.centre = None;
        }
        if roles.readings.is_empty() && roles.part.is_any() {
            roles.readings = labelled::readings(&fields, roles.nominal);
        }
        if roles.readings.is_empty() {
            roles.readings.push(fields.by_callout(mask, &roles, sources)?);
        }
        let own: Vec<usize> = roles.readings.iter().flat_map(Reading::others).flatten().collect();
        // The status of one value is not that of the part.
        if 1 < roles.readings.len() {
            roles.status = fields.texts_that(is_status).find(|at| !own.contains(at)).or(roles.status);
        }
        let taken = [roles.callout, roles.status, roles.band, roles.side];
        let is_free = |at: &usize| !taken.contains(&Some(*at)) && !own.contains(at) && !roles.part.has(*at);
        roles.name = fields.texts().find(is_free);
        if roles.name.is_none() && roles.part.is_any() {
            roles.readings.iter_mut().filter(|reading| reading.name.is_empty()).for_each(|reading| {
                reading.name = labelled::name(slots, reading.measured);
            });
        }
        // What a print calls the part names its only value, where nothing else does.
        if roles.name.is_none() && roles.readings.iter().all(|reading| reading.name.is_empty()) {
            roles.name = roles.part.take_named(slots).or(roles.side);
        }
        Ok(roles)
    }

    /// What the markers of a cycle say of the status.
    pub(super) fn markers(&self, printed: &Printed) -> Vec<Claim> {
        let number = |wanted: u16| {
            let (_, at) = self.markers.iter().find(|(number, _)| *number == wanted)?;
            number(value(printed, *at)?)
        };
        let is = |wanted: u16, value: f64| number(wanted).is_some_and(|found| (found - value).abs() < 0.5);
        let mut claims: Vec<Claim> = Vec::new();
        for (marker, status) in MARKERS {
            if is(marker, 1.0) {
                claims.push(Claim::of(&format!("Q{marker} = 1"), status));
            }
        }
        // All of them are there, and none of them is set.
        if MARKERS.iter().all(|(marker, _)| is(*marker, 0.0)) {
            claims.push(Claim::unknown("Q180 = Q181 = Q182 = 0"));
        }
        for (value, (_, status)) in [0.0, 1.0, 2.0].into_iter().zip(MARKERS) {
            if is(STATUS, value) {
                claims.push(Claim::of(&format!("Q{STATUS} = {value}"), status));
            }
        }
        claims
    }

    /// The status of a cycle that has none: what it says.
    pub(super) fn undefined(&self, printed: &Printed) -> Option<String> {
        let (_, at) = self.markers.iter().find(|(number, _)| *number == STATUS)?;
        let given = value(printed, *at)?;
        let status = number(given);
        let is_known = status.is_some_and(|status| [0.0, 1.0, 2.0].iter().any(|known| (status - known).abs() < 0.5));
        (!is_known).then(|| format!("Q{STATUS} = {}", shorten(given)))
    }

    /// What is not used, by name.
    pub(super) fn ignored(&self, slots: &[Slot]) -> Vec<String> {
        let readings =
            self.readings.iter().flat_map(|reading| reading.others().into_iter().chain([Some(reading.measured)]));
        let others = [self.name, self.callout, self.nominal, self.status, self.band, self.side];
        let markers = self.markers.iter().map(|(_, at)| *at);
        let others = others.into_iter().chain(self.centre.into_iter().flatten().map(Some));
        let used: Vec<usize> = readings.chain(others).flatten().chain(markers).collect();
        let ignored = (0..).zip(slots).filter(|(at, _)| !used.contains(at) && !self.part.has(*at));
        let ignored = ignored.filter(|(_, slot)| matches!(slot.of, FieldContent::Parameter(_)));
        let firsts = ignored.filter(|(at, slot)| slots.iter().position(|other| other.of == slot.of) == Some(*at));
        firsts.map(|(_, slot)| slot.of.to_string()).collect()
    }
}

impl Fields<'_> {
    /// The markers that it prints.
    fn markers(&self) -> Vec<(u16, usize)> {
        let numbers = MARKERS.into_iter().map(|(number, _)| number).chain([STATUS]);
        numbers.filter_map(|number| Some((number, self.number(number)?))).collect()
    }

    /// The results of cycles that it prints.
    fn known(&self) -> Vec<Reading> {
        if let Some(deviation) = self.number(NORMAL).filter(|_| self.number(154).is_none()) {
            return vec![Reading::of(deviation, ReadingKind::Point)];
        }
        let found = RESULTS.iter().filter_map(|result| {
            let measured = self.number(result.measured)?;
            let pair = |(minimum, maximum): &(u16, u16)| [self.number(*minimum), self.number(*maximum)];
            let limits = result.limits.iter().map(pair).find(|pair| pair.iter().any(Option::is_some));
            let [minimum, maximum] = limits.unwrap_or([None; 2]);
            let nominal = result.nominal.and_then(|number| self.number(number));
            let is_hole = labelled::side(self, [Some(measured), minimum, maximum, nominal].into_iter().flatten());
            Some(Reading { minimum, maximum, nominal, is_hole, ..Reading::of(measured, result.kind) })
        });
        found.collect()
    }

    /// The one number that is neither a limit nor the nominal size of the callout that is printed beside it.
    fn by_callout(&self, mask: &str, roles: &Roles, sources: &Sources) -> Result<Reading, ImportErrorKind> {
        let limits: Vec<(usize, Limits)> = (0..)
            .zip(self.sample)
            .filter_map(|(number, printed)| {
                Some((number, limits(&asked(printed, roles.callout, roles.nominal)?, sources)?))
            })
            .collect();
        // Whether a field always is what the callout says, to its last digit. That a measured value lies on a limit is chance, and that it
        // lies on two different ones is not: a field is a limit once it has followed it from one callout to another.
        let always = |at: usize, of: fn(&Limits) -> Length| {
            let mut followed = BTreeSet::new();
            let mut is = |(number, limits): &(usize, Limits)| {
                let Some(value) = self.sample.get(*number).and_then(|printed| value(printed, at)) else { return true };
                followed.insert(of(limits));
                is_printed(of(limits), value)
            };
            limits.iter().all(&mut is) && 1 < followed.len()
        };
        let numbers = self.numbers();
        let named = |list: &[usize]| {
            RESULTS.iter().flat_map(|result| result.limits).find_map(|(minimum, maximum)| {
                let minimum = self.number(*minimum)?;
                let maximum = self.number(*maximum)?;
                (list.contains(&minimum) && list.contains(&maximum)).then_some((minimum, maximum))
            })
        };
        let pair = named(&numbers);
        let minima: Vec<usize> = numbers.iter().copied().filter(|at| always(*at, Limits::minimum)).collect();
        let maxima: Vec<usize> = numbers.iter().copied().filter(|at| always(*at, Limits::maximum)).collect();
        let is_named = |at: &usize| pair.is_some_and(|(minimum, maximum)| [minimum, maximum].contains(at));
        let is_nominal = |at: &usize| Some(*at) == roles.nominal || always(*at, |limits| limits.nominal);
        let is_limit = |at: &usize| minima.contains(at) || maxima.contains(at);
        let left: Vec<usize> =
            numbers.iter().copied().filter(|at| !is_named(at) && !is_limit(at) && !is_nominal(at)).collect();
        // Nothing is left where a value is always on a limit: it cannot be told from it.
        let doubtful = if left.is_empty() && pair.is_none() { &numbers } else { &left };
        match doubtful.as_slice() {
            [measured] => Ok(Reading {
                minimum: pair.map(|pair| pair.0).or_else(|| minima.first().copied()),
                maximum: pair.map(|pair| pair.1).or_else(|| maxima.first().copied()),
                ..Reading::of(*measured, ReadingKind::Size)
            }),
            [] => Err(ImportErrorKind::MaskNoMeasured { mask: mask.to_owned() }),
            several => {
                let names: Vec<String> =
                    several.iter().filter_map(|at| self.slots.get(*at)).map(|slot| slot.of.to_string()).collect();
                Err(ImportErrorKind::MaskMeasured { mask: mask.to_owned(), fields: names.join(", ") })
            }
        }
    }
}

/// The callout of a print: printed as one, or as nominal size and class.
pub(super) fn asked(printed: &Printed, callout: Option<usize>, nominal: Option<usize>) -> Option<Callout> {
    let text = value(printed, callout?)?;
    match text.parse() {
        Ok(callout) => Some(callout),
        Err(_) => Callout::new(length(printed, nominal?)?, text.parse().ok()?).ok(),
    }
}

pub(super) fn limits(callout: &Callout, sources: &Sources) -> Option<Limits> {
    sources.limits(callout, None).ok()
}

/// What the last digit of a printed length is worth, in nanometres; 0 beyond the nanometre.
pub(super) fn last_digit(text: &str) -> i64 {
    /// The last of so many decimals in nanometres: the seventh is less than one.
    const LAST: [i64; 6] = [1_000_000, 100_000, 10_000, 1_000, 100, 10];
    let digits = text.rsplit_once(['.', ',']).map_or(0, |(_, decimals)| decimals.len());
    LAST.get(digits).map_or(0, |last| *last)
}

/// Whether a length is printed like this: the same to the last digit.
pub(super) fn is_printed(length: Length, text: &str) -> bool {
    let value = Length::parse_in(text, Unit::Millimetre);
    value.is_ok_and(|value| 2 * length.saturating_sub(value).abs().nanometres() <= last_digit(text))
}

/// Words of a hole or a shaft that are no names of one.
static SIDES: Names = Names::of("hole|shaft|bohrung|welle|boring|gat|as|foro|albero|alésage|alesage|arbre|agujero|eje");

fn is_side(text: &str) -> bool {
    SIDES.has(&text.to_lowercase())
}

fn is_class(text: &str) -> bool {
    text.parse::<ToleranceClass>().is_ok_and(ToleranceClass::has_grade)
}
