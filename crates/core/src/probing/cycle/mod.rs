//! What a measuring cycle declares: parameters with name, question, unit, range, default and meaning; the surface that
//! it expects; what it does; its status window and its log.
//!
//! Range errors, forms, drawings, NC blocks, logs and status windows are made from the declaration. A cycle does not
//! know where its contacts come from.
//!
//! | file | what |
//! |---|---|
//! | `key` | what programs call a parameter or a result |
//! | `name` | a parameter's name as errors say it |
//! | `note` | what to know of a cycle before it is used on a control |
//! | `parameter`, `range` | one parameter: key, name, question, default; which values it may have |
//! | `texts` | words of the control by dialogue language |
//! | `meaning` | what a parameter means: its drawing and its sentence |
//! | `shared` | parameters that several cycles have |
//! | `value` | values of parameters and results: lengths, angles, numbers, texts |
//! | `inputs` | all values of a run, the probe, the position of the machine |
//! | `course` | the path of the probe, move by move |
//! | `astray` | contacts that lie apart from where the cycle probes |
//! | `result`, `remark` | what a cycle found, and what is worth knowing of it |
//! | `datum` | the datum that a cycle sets |
//! | `correction` | what it says about the tool that made the surface |
//! | `shown` | its status window and its measuring log |
//! | `error` | why a cycle did not run |

mod astray;
mod correction;
mod course;
mod datum;
mod error;
mod inputs;
mod key;
mod meaning;
mod name;
mod note;
mod parameter;
mod range;
mod remark;
mod result;
pub(in crate::probing) mod shared;
mod shown;
mod texts;
mod value;

pub use correction::{Corrected, Correction, Corrects};
pub(in crate::probing) use course::nearest;
pub use course::{Course, Move, Phase};
pub use datum::{DatumAxis, DatumTarget, NewDatum, NewRotation, RotaryAxis, TurnedBy};
pub use error::CycleError;
pub use inputs::Inputs;
pub use key::Key;
pub use meaning::{Axis, Meaning, ParameterGroup};
pub use name::ParameterName;
pub use note::Note;
pub use parameter::{Parameter, Unset, UnsetWhere, number};
pub use range::Range;
pub use remark::Remark;
pub use result::{Check, CircleFound, CycleResult, LogTarget, Plane, ResultName, ResultParameter, Stop};
pub use shown::{FigureKind, Log, LogFigure, TextLog, Window};
pub use texts::Texts;
use texts::in_language;
pub(in crate::probing) use value::QUARTER_TURN;
pub use value::{Angle, Value};

use super::contact::{Contact, Prober};
use super::simulated::{Face, Shape, Surface, Workpiece};
use crate::length::Length;
use crate::tolerance::{Bounds, Deviations, Feature, proportion};
use crate::verdict::Status;
use crate::words::Dialogue;

/// A measuring cycle of a control.
#[derive(Debug)]
pub struct Cycle {
    /// Its number, 421.
    pub number: u16,
    /// What programs call it: `421`, `G785`.
    pub code: &'static str,
    /// The control that has it.
    pub control: Control,
    /// Its name in NC programs, by dialogue language.
    pub names: Texts,
    /// What to know before it is used on a control.
    pub notes: &'static [Note],
    /// Its parameters in the order of NC programs.
    pub parameters: &'static [Parameter],
    /// The perfect surface, in which the cycle would find no fault.
    pub surface: fn(&Inputs) -> Surface,
    /// Runs it on checked inputs.
    pub run: fn(&Inputs, &mut Course<'_>) -> Result<Measured, CycleError>,
    /// What is checked, as the status window puts it: the nominal size, or the measured axis.
    pub subject: fn(&Inputs) -> Option<String>,
    /// How its result corrects the tool of Q330.
    pub corrects: Corrects,
    /// Its status window.
    pub window: Window,
    /// Its measuring log.
    pub log: Log,
}

/// The controls that have measuring cycles.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Control {
    /// A milling control: a `TCH PROBE` block, one parameter per line.
    Milling,
    /// A lathe control: address letters on one line.
    Lathe,
}

/// What a cycle makes of its contacts; the rest of a [`CycleResult`] is the same for all.
#[derive(Debug, Default)]
pub struct Measured {
    pub(in crate::probing) contacts: Vec<Contact>,
    pub(in crate::probing) circle: Option<CircleFound>,
    pub(in crate::probing) checks: Vec<Check>,
    pub(in crate::probing) status: Option<Status>,
    pub(in crate::probing) results: Vec<ResultParameter>,
    pub(in crate::probing) stop: Option<Stop>,
    pub(in crate::probing) remarks: Vec<Remark>,
    pub(in crate::probing) datum: Option<NewDatum>,
    pub(in crate::probing) rotation: Option<NewRotation>,
}

/// Cycles are told apart by their names.
impl PartialEq for Cycle {
    fn eq(&self, other: &Self) -> bool {
        self.code == other.code
    }
}

impl Cycle {
    /// The name in a language; English if the language has none, else the first name in the list.
    pub fn name(&self, language: Dialogue) -> &'static str {
        let first = self.names.first().map_or("", |(_, name)| *name);
        in_language(self.names, language).or_else(|| in_language(self.names, Dialogue::En)).unwrap_or(first)
    }

    /// A parameter by its key; a bare number means a Q parameter.
    pub fn parameter(&self, key: impl Into<Key>) -> Option<&'static Parameter> {
        let key = key.into();
        self.parameters.iter().find(|parameter| parameter.key == key)
    }

    /// A parameter by the name that people type: `Q273`, `q273`, `QS400`, `br`. `QS330` is the text form of Q330,
    /// and Q1116 a number for the text QS1116.
    pub fn parameter_named(&self, name: &str) -> Option<&'static Parameter> {
        let takes_number = |parameter: &Parameter| matches!(parameter.range, Range::Nominal { .. });
        let found = self.parameters.iter().find(|parameter| parameter.key.is_named(name));
        found.or_else(|| self.parameters.iter().find(|known| takes_number(known) && known.key.is_number_of(name)))
    }

    /// The parameter of a meaning.
    pub fn meant(&self, meaning: Meaning) -> Option<&'static Parameter> {
        self.parameters.iter().find(|parameter| parameter.meaning == meaning)
    }

    /// The inputs' value for a meaning; `None` if the cycle has no such parameter, or the inputs no value for it.
    pub fn value_of<'a>(&self, inputs: &'a Inputs, meaning: Meaning) -> Option<&'a Value> {
        inputs.value(self.meant(meaning)?.key)
    }

    /// A length by its meaning.
    pub fn length_of(&self, inputs: &Inputs, meaning: Meaning) -> Option<Length> {
        self.value_of(inputs, meaning)?.length()
    }

    /// Whether it sets a datum or a rotation: such a cycle judges nothing.
    pub fn sets_datum(&self) -> bool {
        self.meant(Meaning::TableRow).is_some()
    }

    /// Whether it judges what it measures.
    pub fn judges(&self) -> bool {
        let is_limit = |parameter: &Parameter| parameter.meaning.group() == ParameterGroup::Tolerance;
        self.takes_nominals() || self.parameters.iter().any(is_limit)
    }

    /// Whether a basic rotation in force ends before its contacts.
    pub fn ends_rotation(&self) -> bool {
        self.notes.contains(&Note::EndsRotation)
    }

    /// Whether its limits stand in texts beside the nominal values, and no parameter has them.
    pub fn takes_nominals(&self) -> bool {
        self.parameters.iter().any(|parameter| matches!(parameter.range, Range::Nominal { .. }))
    }

    /// The top that a cycle probes besides its surface, where its inputs ask for that.
    pub fn nominal_top(&self, inputs: &Inputs) -> Option<Face> {
        let Some(Value::Whole(1)) = self.value_of(inputs, Meaning::ToolAxisProbing) else { return None };
        let along = |axis| self.length_of(inputs, Meaning::ToolAxisPoint(axis)).unwrap_or(Length::ZERO).to_mm_f64();
        Some(Face::plane([Axis::First, Axis::Second, Axis::Third].map(along), [0.0, 0.0, 1.0]))
    }

    /// What else a cycle expects besides its surface: a top that its inputs ask for, or a second circle.
    pub fn nominal_beside(&self, inputs: &Inputs) -> Option<Surface> {
        if let Some(top) = self.nominal_top(inputs) {
            return Some(Surface::Face(top));
        }
        let of = |meaning| match self.value_of(inputs, meaning)? {
            Value::Nominal(nominal) => Some(nominal.target().to_mm_f64()),
            _ => None,
        };
        let centre = [of(Meaning::SecondCentre(Axis::First))?, of(Meaning::SecondCentre(Axis::Second))?];
        let is_stud = matches!(self.value_of(inputs, Meaning::Geometries), Some(Value::Whole(1 | 2)));
        let feature = if is_stud { Feature::Shaft } else { Feature::Hole };
        Some(Surface::Round(Workpiece::round(feature, centre, of(Meaning::SecondDiameter)?), Plane::Xy))
    }

    /// What is measured, as its drawings show it. Where an input decides, this is the shape without inputs.
    pub fn shape(&self) -> Shape {
        (self.surface)(&Inputs::new()).shape()
    }

    /// Gives a parameter a value, both as people type them.
    ///
    /// # Errors
    /// [`CycleError::NoSuchParameter`] or [`CycleError::NotAValue`]; the range is checked when the cycle runs.
    pub fn set(&self, inputs: Inputs, name: &str, text: &str) -> Result<Inputs, CycleError> {
        let unknown = || self.no_such(name.trim());
        let parameter = self.parameter_named(name).ok_or_else(unknown)?;
        let value = match parameter.read(text)? {
            // QS330 = "5" is the tool with the name 5, Q330 = 5 the tool with that number.
            Value::Number(_) if parameter.range == Range::Tool && !parameter.key.is_exactly(name) => {
                Value::Text(text.trim().to_owned())
            }
            value => value,
        };
        Ok(inputs.with(parameter.key, value))
    }

    /// Checks the values against the declaration, fills in defaults and runs the cycle.
    ///
    /// # Errors
    /// [`CycleError`] names the parameter, the value and what is allowed, or what went wrong on the way.
    pub fn measure(&self, inputs: &Inputs, prober: &mut dyn Prober) -> Result<CycleResult, CycleError> {
        self.measure_along(inputs, prober).1
    }

    /// The same, and returns the path of the probe even where the cycle did not finish.
    pub fn measure_along(
        &self,
        inputs: &Inputs,
        prober: &mut dyn Prober,
    ) -> (Vec<Move>, Result<CycleResult, CycleError>) {
        let inputs = match self.checked(inputs) {
            Ok(inputs) => inputs,
            Err(error) => return (Vec::new(), Err(error)),
        };
        // The cycle begins so much farther away, and the contact is where it was.
        let set_up = inputs.probe().set_up.saturating_sub(inputs.length(320).max(Length::ZERO).negated());
        let mut course = Course::new(prober, inputs.position, set_up);
        let measured = (self.run)(&inputs, &mut course);
        let (path, astray) = course.into_parts();
        let result = measured.map(|measured| {
            let mut remarks = self.remarks(&inputs);
            remarks.extend(measured.remarks);
            let set = measured.datum.as_ref();
            remarks.extend(set.map(|new| Remark::NewDatum { axes: new.listed(), target: new.target }));
            remarks.extend(measured.rotation.as_ref().map(Remark::of_rotation));
            remarks.extend(self.zone_remarks(&measured.checks));
            remarks.extend(astray);
            let result = CycleResult {
                path: path.clone(),
                contacts: measured.contacts,
                circle: measured.circle,
                checks: measured.checks,
                status: measured.status,
                results: measured.results,
                stop: measured.stop,
                log: self.log_target(&inputs),
                datum: measured.datum,
                rotation: measured.rotation,
                remarks,
                inputs,
            };
            let form = result.form().map(Remark::Form);
            CycleResult { remarks: result.remarks.into_iter().chain(form).collect(), ..result }
        });
        (path, result)
    }

    /// The surface that the cycle expects by its inputs.
    ///
    /// # Errors
    /// The same as for [`Self::measure`], except those that only a contact can cause.
    pub fn nominal(&self, inputs: &Inputs) -> Result<Surface, CycleError> {
        self.checked(inputs).map(|inputs| (self.surface)(&inputs))
    }

    /// Checks the values against the declaration and fills in defaults.
    ///
    /// # Errors
    /// [`CycleError`] names the parameter, the value and what is allowed.
    pub fn checked(&self, inputs: &Inputs) -> Result<Inputs, CycleError> {
        if let Some(key) = inputs.given.keys().find(|key| self.parameter(**key).is_none()) {
            return Err(self.no_such(&key.to_string()));
        }
        let mut checked = inputs.clone();
        checked.filled.clear();
        for parameter in self.parameters {
            let key = parameter.key;
            let name = parameter.called();
            let value = match inputs.given.get(&key) {
                Some(Value::Predef) if parameter.may_be_predef => {
                    Some(inputs.globals.get(&key).cloned().ok_or(CycleError::NoGlobal { key, name })?)
                }
                Some(value) => Some(value.clone()),
                None => parameter.default_with(inputs),
            };
            let Some(value) = value else {
                if parameter.unset == Unset::Refused {
                    return Err(CycleError::Missing { key, name });
                }
                continue;
            };
            if !parameter.allows(&value) {
                return Err(parameter.out_of_range(&value));
            }
            checked.filled.insert(key, value);
        }
        Ok(checked)
    }

    /// The error of a limit that is given without the other limit of the same value, which would count as 0.
    pub fn half_limits(&self, inputs: &Inputs) -> Option<CycleError> {
        let given = self.parameters.iter().filter(|parameter| inputs.is_given(parameter.key));
        let mut halves = given.filter_map(|given| {
            let other = given.meaning.other_limit()?;
            let missing = self.parameters.iter().find(|parameter| parameter.meaning == other)?;
            (!inputs.is_given(missing.key)).then_some(CycleError::OneLimit { given: given.key, missing: missing.key })
        });
        halves.next()
    }

    fn no_such(&self, parameter: &str) -> CycleError {
        let known = self.parameters.iter().map(|known| known.key.to_string()).collect::<Vec<_>>().join(", ");
        CycleError::NoSuchParameter { cycle: self.code, parameter: parameter.to_owned(), known }
    }

    /// Where the log goes: as the parameter for it says, if the cycle has one.
    fn log_target(&self, inputs: &Inputs) -> LogTarget {
        match (self.log.file(), self.value_of(inputs, Meaning::Log)) {
            (None, _) if matches!(self.log, Log::None) => LogTarget::None,
            (None, _) => LogTarget::Shown,
            (Some(file), None | Some(Value::Whole(1))) => LogTarget::File(file),
            (Some(_), Some(Value::Whole(2))) => LogTarget::Screen,
            _ => LogTarget::None,
        }
    }

    /// Remarks about limits that are out of all proportion.
    fn zone_remarks<'a>(&self, checks: &'a [Check]) -> impl Iterator<Item = Remark> + use<'a> {
        let lies_anywhere = matches!(self.shape(), Shape::Face | Shape::Point);
        checks.iter().filter_map(move |check| {
            let middle = check.minimum.midpoint(check.maximum);
            let from = |limit: Length| limit.saturating_sub(middle);
            let deviations = Deviations::new(from(check.maximum), from(check.minimum)).ok()?;
            let doubt = if lies_anywhere || check.what.is_centre() {
                proportion::doubt_of_coordinate(middle, deviations)
            } else {
                // Good for a hole and for a shaft.
                proportion::doubt(&Bounds::new(Feature::Shaft, middle, deviations)?)
            };
            // The parameters of a cycle are limits: no deviations were written.
            doubt.map(|doubt| Remark::Zone(doubt.without_offer()))
        })
    }

    /// Remarks about inputs without effect, and about a tool that is not monitored: a cycle knows no tool table.
    fn remarks(&self, inputs: &Inputs) -> Vec<Remark> {
        let idle = self.parameters.iter().filter(|parameter| !parameter.has_effect && inputs.is_given(parameter.key));
        let mut remarks: Vec<_> = idle.map(|parameter| Remark::WithoutEffect { key: parameter.key }).collect();
        match self.value_of(inputs, Meaning::Tool) {
            Some(Value::Number(number)) if 0.0 < *number => {
                remarks.push(Remark::ToolNotMonitored { tool: number.to_string() });
            }
            Some(Value::Text(name)) => remarks.push(Remark::ToolNotMonitored { tool: name.clone() }),
            _ => {}
        }
        remarks
    }
}

/// The limits of a cycle from two parameters: swapped limits are an error, both zero monitors nothing.
pub(in crate::probing) fn limits(
    inputs: &Inputs,
    minimum: u16,
    maximum: u16,
) -> Result<Option<(Length, Length)>, CycleError> {
    let minimum_key = Key::Q(minimum);
    let maximum_key = Key::Q(maximum);
    let minimum = inputs.length(minimum_key);
    let maximum = inputs.length(maximum_key);
    if maximum < minimum {
        return Err(CycleError::LimitsSwapped { minimum_key, minimum, maximum_key, maximum });
    }
    Ok((minimum != Length::ZERO || maximum != Length::ZERO).then_some((minimum, maximum)))
}
