//! `TCH PROBE`: the cycles of `probing::cycles`, by number.

use fitcheck_core::length::Length;
use fitcheck_core::probing::cycle::{self, Control, Cycle, CycleError, CycleResult, Inputs, Key, Move, Phase, Range};
use fitcheck_core::probing::cycles::cycles_of;
use fitcheck_core::probing::simulated::Surface;
use fitcheck_core::probing::{Touch, TouchProbe};
use fitcheck_core::tolerance::Nominal;
use fitcheck_core::verdict::Status;

use super::around::{Around, ChangingBlock, DatumInForce, Global, INCH, Moment};
use super::budget::{Budget, Settings, UsedUp};
use super::contacts::{Contacts, Probed, Touched};
use super::fault::{BlockPlace, FaultKind};
use super::placement::{Placement, System};
use super::remark::Remark;
use super::values::{Values, length_of, whole};
use crate::control::cycle_status::variable;
use crate::control::probe_table::ProbeTable;
use crate::control::variables::{Parameter, Value};
use crate::program::{CycleBlock, CycleName, CycleValue, Operand, Tool, Unit};

#[derive(Debug, Clone)]
pub struct CycleRun {
    pub place: BlockPlace,
    pub cycle: &'static Cycle,
    /// What it found.
    pub result: CycleResult,
    /// Whether it gave rework and the same block has measured the same feature again since: that measurement counts.
    pub is_reworked: bool,
    /// The datum that it counted from, where a cycle had set it.
    pub datum: Option<DatumInForce>,
    pub(super) moment: Moment,
}

impl CycleRun {
    /// A cycle that was run now.
    pub(super) fn new(
        place: BlockPlace,
        cycle: &'static Cycle,
        result: CycleResult,
        (moment, datum): (Moment, Option<DatumInForce>),
    ) -> Self {
        Self { place, cycle, result, is_reworked: false, datum, moment }
    }

    /// The surface that it expected, in the coordinates of the workpiece; `None` where the tool axis is not Z, and for what would not stand
    /// along Z in a tilted plane.
    pub fn nominal(&self) -> Option<Surface> {
        let system = self.moment.system_of_plane_xy()?;
        Some(self.cycle.nominal(&self.result.inputs).ok()?.turned(system.axes)?.moved(system.zero))
    }

    /// The zero that it counted from, mm in the coordinates of the workpiece, and the unit vectors of its axes there; `None` where no block
    /// has set them.
    pub fn axes(&self) -> Option<([f64; 3], [[f64; 3]; 3])> {
        self.datum.as_ref()?;
        let System { zero, axes } = self.moment.system();
        Some((zero, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|axis| axes.out(axis))))
    }

    /// Whether both were run with the same values; where the ball came from does not count.
    fn has_values_of(&self, other: &Self) -> bool {
        let value = |run: &Self, key| run.result.inputs.value(key).cloned();
        self.cycle.parameters.iter().all(|parameter| value(self, parameter.key) == value(other, parameter.key))
    }

    /// Whether this is rework of a feature that another run has measured again: the same block with the same values on the same
    /// workpiece, and the spindle has turned between. Scrap stays scrap.
    fn is_superseded_by(&self, later: &Self) -> bool {
        self.result.verdict() == Some(Status::Rework)
            && later.result.verdict().is_some()
            && self.place == later.place
            && self.moment.is_before_rework(&later.moment)
            && self.has_values_of(later)
    }
}

/// The cycles of a run, and the probe that they use.
#[derive(Debug)]
pub(super) struct Cycles {
    probed: Probed,
    probe: TouchProbe,
    /// The tool of the last call, if it is not in the touch-probe table.
    other_tool: Option<String>,
    runs: Vec<CycleRun>,
    most: usize,
    /// A measurement that was not run, where contacts were recorded: some of them may be of it.
    lost: Option<ChangingBlock>,
}

impl Cycles {
    pub(super) fn new(contacts: Contacts, settings: &Settings) -> Self {
        Self {
            probed: Probed::new(contacts),
            probe: settings.probe_table.probe_or_first(None),
            other_tool: None,
            runs: Vec::new(),
            most: settings.budget.cycles,
            lost: None,
        }
    }

    pub(super) fn runs(&self) -> &[CycleRun] {
        &self.runs
    }

    /// Whether nobody measured: no contacts were recorded.
    pub(super) const fn is_simulated(&self) -> bool {
        self.probed.is_simulated()
    }

    /// What the simulated part has to say about moves: what they would touch.
    pub(super) const fn probed(&mut self) -> &mut Probed {
        &mut self.probed
    }

    /// A remark that recorded contacts are left, unless the cycles took all.
    pub(super) fn contacts_left(&self) -> Option<Remark> {
        self.probed.left().map(|(count, used)| Remark::ContactsLeft { count, used })
    }

    /// A measurement was not run: from here on it is not known which recorded contacts are of which cycle.
    pub(super) fn lose(&mut self, by: impl FnOnce() -> ChangingBlock) {
        if self.probed.is_recorded() {
            self.lost.get_or_insert_with(by);
        }
    }

    /// TOOL CALL: the probe of that number; a name selects the first probe of the table.
    pub(super) fn call_tool(
        &mut self,
        tool: Option<&Tool>,
        table: &ProbeTable,
        values: &Values,
    ) -> Result<(), FaultKind> {
        let (number, name) = match tool {
            // Without a tool, only speed or feed change.
            None => return Ok(()),
            Some(Tool::Number(number)) => {
                let value = values.operand(*number)?;
                let number = whole(value).and_then(|number| u32::try_from(number).ok());
                (number, value.to_string())
            }
            Some(Tool::Name(name)) => (None, values.text_operand(name)?.to_owned()),
        };
        let found = number.and_then(|number| table.probe(Some(number)));
        self.probe = table.probe_or_first(number);
        // With one probe there is no doubt which one is meant.
        let is_doubtful = found.is_none() && 1 < table.probes.len();
        self.other_tool = is_doubtful.then_some(name);
        Ok(())
    }

    /// A remark that another probe measures than the tool that was called; made once per call.
    pub(super) fn other_probe(&mut self) -> Option<Remark> {
        self.other_tool.take().map(|tool| Remark::OtherProbe { tool, probe: self.probe.number })
    }

    /// One contact, from a place in a direction of the system.
    pub(super) fn touch(
        &mut self,
        (from, direction): ([f64; 3], [f64; 3]),
        placement: Placement,
    ) -> Result<Option<Touched>, FaultKind> {
        if let Some(ChangingBlock { line, text }) = self.lost.clone() {
            return Err(FaultKind::ContactsUnknown { line, text });
        }
        let touch = Touch { from, direction, longest: self.probe.longest_path.to_mm_f64() };
        self.probed.touch(&touch, self.probe, placement)
    }

    /// Whether one more cycle may be run.
    pub(super) fn check_count(&self) -> Result<(), UsedUp> {
        Budget::one_more(self.runs.len(), self.most, UsedUp::Cycles)
    }

    /// Runs a cycle: the path of the probe in the cycle's own coordinates, and the outcome.
    pub(super) fn measure(
        &mut self,
        cycle: &'static Cycle,
        asked: &CycleRequest<'_>,
        around: &Around,
        values: &Values,
    ) -> Result<(Vec<Move>, Result<CycleResult, FaultKind>), FaultKind> {
        if let Some(ChangingBlock { line, text }) = self.lost.clone() {
            return Err(FaultKind::ContactsUnknown { line, text });
        }
        let mut inputs = Inputs::new().with_probe(self.probe);
        if let Some(place) = asked.position {
            inputs = inputs.with_position(asked.placement.into_cycle(place));
        }
        let inputs = with_globals(inputs, cycle, around)?;
        let inputs = with_lines(inputs, cycle, asked, values)?;
        if let Some(error) = cycle.half_limits(&inputs) {
            return Err(FaultKind::Cycle { cycle: cycle.code, error: Box::new(error) });
        }
        let (path, result) = self.probed.measure(cycle, &inputs, asked.placement)?;
        Ok((path, result.map_err(|error| FaultKind::Cycle { cycle: cycle.code, error: Box::new(error) })))
    }

    /// Keeps a cycle that was run; returns a remark if it takes the place of an earlier one.
    pub(super) fn keep(&mut self, run: CycleRun) -> Option<Remark> {
        let before = self.runs.iter_mut().rev().find(|earlier| !earlier.is_reworked && earlier.place == run.place);
        let reworked = before.filter(|earlier| earlier.is_superseded_by(&run));
        let remark = reworked.is_some().then_some(Remark::MeasuredAgain);
        if let Some(earlier) = reworked {
            earlier.is_reworked = true;
        }
        self.runs.push(run);
        remark
    }
}

/// What a block asks of a cycle.
pub(super) struct CycleRequest<'a> {
    pub block: &'a CycleBlock,
    /// The unit of its program.
    pub unit: Option<Unit>,
    /// Where it measures.
    pub placement: Placement,
    /// Where the ball's centre is, mm from the preset.
    pub position: Option<[f64; 3]>,
}

/// The inputs, with the values of GLOBAL DEF.
fn with_globals(mut inputs: Inputs, cycle: &'static Cycle, around: &Around) -> Result<Inputs, FaultKind> {
    for declared in cycle.parameters {
        let Key::Q(number) = declared.key else { continue };
        if let Some(Global { value, unit }) = around.global(Parameter::q(number)) {
            inputs = inputs.with_global(declared.key, accepted(cycle, declared, &Value::Number(*value), *unit)?);
        }
    }
    Ok(inputs)
}

/// The inputs, with the values from the lines of a block.
fn with_lines(
    mut inputs: Inputs,
    cycle: &'static Cycle,
    asked: &CycleRequest<'_>,
    values: &Values,
) -> Result<Inputs, FaultKind> {
    for line in &asked.block.lines {
        let name = || line.parameter.clone();
        let unknown = || FaultKind::NoCycleParameter { cycle: cycle.code, parameter: name() };
        let declared = cycle.parameter_named(&line.parameter.to_string()).ok_or_else(unknown)?;
        if inputs.is_given(declared.key) {
            return Err(twice(cycle, asked.block, declared, name()));
        }
        inputs = inputs.with(declared.key, input(cycle, declared, &line.value, asked.unit, values)?);
    }
    Ok(inputs)
}

/// That a parameter stands twice. Where the one of the next number is missing, it is the one that is meant: a widely used
/// post-processor writes `Q288` for both limits of 425 (nc-programs, section 6).
fn twice(cycle: &'static Cycle, block: &CycleBlock, declared: &cycle::Parameter, parameter: CycleName) -> FaultKind {
    let next = if let Key::Q(number) = declared.key { cycle.parameter(Key::Q(number + 1)) } else { None };
    let is_missing = |other: &&cycle::Parameter| {
        let other = other.key.to_string();
        !block.lines.iter().any(|line| line.parameter.to_string() == other)
    };
    match next.filter(is_missing) {
        Some(other) => FaultKind::CycleParameterFor { cycle: cycle.code, parameter, other: other.key.to_string() },
        None => FaultKind::CycleParameterTwice { cycle: cycle.code, parameter },
    }
}

/// A value in the kind that the parameter declares; the cycle checks the range.
fn input(
    cycle: &'static Cycle,
    declared: &cycle::Parameter,
    given: &CycleValue,
    unit: Option<Unit>,
    values: &Values,
) -> Result<cycle::Value, FaultKind> {
    let refused = |error: CycleError| FaultKind::Cycle { cycle: cycle.code, error: Box::new(error) };
    let read = |text: &str| declared.read(text).map_err(refused);
    let operand: Operand = match given {
        CycleValue::Word(word) => return declared.read_word(word).map_err(refused),
        CycleValue::Text(text) => {
            let text = values.text_operand(text)?;
            return Ok(match read(text)? {
                cycle::Value::Nominal(nominal) if unit == Some(Unit::Inch) => {
                    in_mm(nominal, declared).map_err(refused)?
                }
                // QS330 = "5" is the tool with the name 5.
                cycle::Value::Number(_) if declared.range == Range::Tool => cycle::Value::Text(text.trim().to_owned()),
                value => value,
            });
        }
        CycleValue::Number { value, .. } => *value,
    };
    accepted(cycle, declared, &values.value(operand)?, unit)
}

/// A nominal value of a program in inches; what its tolerance means there is not known.
fn in_mm(nominal: Nominal, declared: &cycle::Parameter) -> Result<cycle::Value, CycleError> {
    let (key, name, given) = (declared.key, declared.called(), nominal.to_string());
    if nominal.limits().is_some() {
        return Err(CycleError::InchTolerance { key, name, given });
    }
    let in_mm = Length::from_mm_f64(nominal.value().to_mm_f64() * INCH).map_err(CycleError::TooFar)?;
    Ok(cycle::Value::Nominal(Nominal::of(in_mm)))
}

/// A number in the kind that the parameter declares.
fn accepted(
    cycle: &'static Cycle,
    declared: &cycle::Parameter,
    value: &Value,
    unit: Option<Unit>,
) -> Result<cycle::Value, FaultKind> {
    let refused = |error: CycleError| FaultKind::Cycle { cycle: cycle.code, error: Box::new(error) };
    let read = |text: &str| declared.read(text).map_err(refused);
    let number = match value {
        Value::Number(number) => *number,
        Value::Length(length) => length.to_mm_f64(),
        Value::Text(text) => return read(text),
    };
    match declared.range {
        // Rounded to the nearest nanometre; the reader of such texts rejects what is not a length.
        Range::Length { .. } => {
            let is_inch = unit == Some(Unit::Inch);
            let in_mm = if is_inch { length_of(&Value::Number(number * INCH)) } else { length_of(value) };
            // A tolerance that rounds to zero would switch the comparison off.
            let in_mm = in_mm.filter(|length| *length != Length::ZERO || number.abs() <= 0.0);
            in_mm.map_or_else(|| read(&number.to_string()), |length| Ok(cycle::Value::Length(length)))
        }
        Range::Nominal { .. } => {
            let is_inch = unit == Some(Unit::Inch);
            let in_mm = if is_inch { length_of(&Value::Number(number * INCH)) } else { length_of(value) };
            in_mm.map_or_else(|| read(&number.to_string()), |length| Ok(cycle::Value::Nominal(Nominal::of(length))))
        }
        Range::Angle { .. } => read(&format!("{number:.4}")),
        Range::OneOf(_) | Range::Count { .. } | Range::Band => read(&number.to_string()),
        Range::Number { .. } | Range::Tool => Ok(cycle::Value::Number(number)),
    }
}

/// A length in the unit of a program.
fn in_unit(value: Value, unit: Option<Unit>) -> Value {
    match value {
        Value::Length(length) if unit == Some(Unit::Inch) => Value::Number(length.to_mm_f64() / INCH),
        value => value,
    }
}

/// Puts the results into their parameters, in the unit of the program; on milling controls also the cycle's number into Q198, and
/// the last contact, counted from the preset, into Q115 to Q117 (nc-programs, section 12). Results of an earlier cycle that this
/// one does not give become undefined, so that nothing stale passes as measured.
pub(super) fn hand_over(
    cycle: &Cycle,
    result: &CycleResult,
    path: &[Move],
    unit: Option<Unit>,
    values: &mut Values,
) -> Result<(), FaultKind> {
    values.forget(RESULTS);
    for (parameter, value) in result.results.iter().filter_map(|found| variable(found.key?, &found.value)) {
        values.put(parameter, in_unit(value, unit))?;
    }
    if cycle.control == Control::Lathe {
        return Ok(());
    }
    values.put(Parameter::q(198), Value::Number(f64::from(cycle.number)))?;
    put_contact(path, unit, values)
}

/// The last contact, in the coordinates of the workpiece, into the parameters that a control has for it.
pub(super) fn put_contact(path: &[Move], unit: Option<Unit>, values: &mut Values) -> Result<(), FaultKind> {
    let last = path.iter().rev().find(|step: &&Move| step.phase == Phase::Contact);
    for (number, place) in (115..).zip(last.into_iter().flat_map(|step| step.to)) {
        if let Ok(length) = Length::from_mm_f64(place) {
            values.put(Parameter::q(number), in_unit(Value::Length(length), unit))?;
        }
    }
    Ok(())
}

/// The parameters of results and of the markers.
const RESULTS: std::ops::RangeInclusive<u16> = 150..=183;

/// The cycle of a number: programs call only those of their own control.
pub(super) fn cycle_of(number: &str, control: Control) -> Result<&'static Cycle, FaultKind> {
    cycles_of(control).find(|cycle| cycle.code == number).ok_or_else(|| {
        let known: Vec<&str> = cycles_of(control).map(|cycle| cycle.code).collect();
        FaultKind::UnknownCycle { cycle: number.to_owned(), known: known.join(", ") }
    })
}
