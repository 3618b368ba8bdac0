//! What a cycle found: one type for all cycles.

use super::course::Move;
use super::datum::{NewDatum, NewRotation};
use super::inputs::Inputs;
use super::key::Key;
use super::remark::Remark;
use super::value::{Angle, Value};
use crate::length::Length;
use crate::message::{Message, Say, display, message};
use crate::probing::Caveat;
use crate::probing::circle::{Circle, CircleWarning, Evaluation, evaluate};
use crate::probing::contact::Contact;
use crate::verdict::{PositionVerdict, Removal, Status};

/// What a cycle found.
#[derive(Debug, Clone, PartialEq)]
pub struct CycleResult {
    /// What it was run with, defaults filled in.
    pub inputs: Inputs,
    /// The path of the ball's centre, move by move.
    pub path: Vec<Move>,
    /// Points of the surface in probing order, corrected for the ball's radius, mm.
    pub contacts: Vec<Contact>,
    /// What cycles that measure a circle found.
    pub circle: Option<CircleFound>,
    /// What was compared with limits, one check per value; values that were not monitored are left out.
    pub checks: Vec<Check>,
    /// The status that the markers show: `Good` also where no limits were given, as on the control. `None` where the
    /// cycle has no limits at all, or has none in this run and reports so (Q183 = −1).
    pub status: Option<Status>,
    /// The result parameters as the control lists them.
    pub results: Vec<ResultParameter>,
    /// The program stop with an error message that Q309 asks for.
    pub stop: Option<Stop>,
    /// Where the control would put its log.
    pub log: LogTarget,
    /// What is worth knowing about the run.
    pub remarks: Vec<Remark>,
    /// The datum that it sets.
    pub datum: Option<NewDatum>,
    /// How it turns the system.
    pub rotation: Option<NewRotation>,
}

impl CycleResult {
    /// The verdict: the status, where anything was compared with limits. The markers of a control say good also where nothing was.
    pub fn verdict(&self) -> Option<Status> {
        self.status.filter(|_| !self.checks.is_empty())
    }

    /// The same where a tool table is at hand and the tool of Q330 is monitored: without the remark that it is not.
    #[must_use]
    pub fn with_tool_table(mut self) -> Self {
        self.remarks.retain(|remark| !matches!(remark, Remark::ToolNotMonitored { .. }));
        self
    }

    /// A measured length by its name.
    pub fn length(&self, name: ResultName) -> Option<Length> {
        let found = self.results.iter().find(|found| found.name == name)?;
        if let Value::Length(length) = found.value { Some(length) } else { None }
    }

    /// A result parameter.
    pub fn value(&self, key: impl Into<Key>) -> Option<&Value> {
        let key = key.into();
        self.results.iter().find(|found| found.key == Some(key)).map(|found| &found.value)
    }

    /// The contacts in the coordinates of the plane that was probed: first axis, second axis, height.
    pub fn plane_contacts(&self) -> Vec<Contact> {
        let plane = self.circle.as_ref().map_or(Plane::Xy, |circle| circle.plane);
        self.contacts.iter().map(|contact| Contact::at(plane.within(contact.place()))).collect()
    }

    /// What its contacts say against the limits of its diameter.
    pub(super) fn form(&self) -> Option<Caveat> {
        let check = self.checks.iter().find(|check| check.what == ResultName::DIAMETER)?;
        let found = self.circle.as_ref()?;
        Caveat::of_form(&self.plane_contacts(), &found.circle, check.measured, [check.minimum, check.maximum])
    }

    /// What its contacts cannot tell of the circle; nothing for cycles without one.
    pub fn warnings(&self) -> Vec<CircleWarning> {
        self.evaluation().map_or_else(Vec::new, |evaluation| evaluation.warnings)
    }

    /// The evaluation of a circle's contacts by every criterion; `None` for cycles without a circle.
    pub fn evaluation(&self) -> Option<Evaluation> {
        self.circle.as_ref()?;
        evaluate(&self.plane_contacts()).ok()
    }
}

/// What a cycle that measures a circle found.
#[derive(Debug, Clone, PartialEq)]
pub struct CircleFound {
    /// The plane that it lies in.
    pub plane: Plane,
    /// The least-squares circle in that plane, unrounded, mm.
    pub circle: Circle,
    /// The centre in first and second axis, rounded to the nearest nanometre.
    pub centre: [Length; 2],
    /// The diameter, rounded to the nearest nanometre.
    pub diameter: Length,
    /// The centre against its nominal position.
    pub position: PositionVerdict,
}

/// A plane of the machine.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
pub enum Plane {
    /// X/Y, G17.
    #[default]
    #[serde(rename = "XY")]
    Xy,
    /// Z/X, G18.
    #[serde(rename = "ZX")]
    Zx,
    /// Y/Z, G19.
    #[serde(rename = "YZ")]
    Yz,
}

impl Plane {
    /// The names of its axes.
    pub const fn axes(self) -> [&'static str; 2] {
        match self {
            Self::Xy => ["X", "Y"],
            Self::Zx => ["Z", "X"],
            Self::Yz => ["Y", "Z"],
        }
    }

    /// A place in X, Y, Z as first axis, second axis and height above the plane.
    pub const fn within(self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        match self {
            Self::Xy => [x, y, z],
            Self::Zx => [z, x, y],
            Self::Yz => [y, z, x],
        }
    }

    /// A place in first axis, second axis and height as X, Y, Z.
    pub const fn place(self, [first, second, height]: [f64; 3]) -> [f64; 3] {
        match self {
            Self::Xy => [first, second, height],
            Self::Zx => [second, height, first],
            Self::Yz => [height, first, second],
        }
    }
}

/// A result parameter.
#[derive(Debug, Clone, PartialEq)]
pub struct ResultParameter {
    /// What the control calls it; `None` where no manual names a parameter for it.
    pub key: Option<Key>,
    /// What it is.
    pub name: ResultName,
    /// Its value.
    pub value: Value,
}

impl ResultParameter {
    pub(in crate::probing) fn length(key: impl Into<Key>, name: ResultName, value: Length) -> Self {
        Self { key: Some(key.into()), name, value: Value::Length(value) }
    }

    pub(in crate::probing) fn angle(key: impl Into<Key>, name: ResultName, value: Angle) -> Self {
        Self { key: Some(key.into()), name, value: Value::Angle(value) }
    }

    /// A length without a parameter of the control.
    pub(in crate::probing) const fn without_key(name: ResultName, value: Length) -> Self {
        Self { key: None, name, value: Value::Length(value) }
    }

    /// What the control calls it, `Q160`; a dash where it has no name for it.
    pub fn called(&self) -> String {
        self.key.map_or_else(|| "–".to_owned(), |key| key.to_string())
    }

    /// Q180 to Q182, of which exactly one is 1.
    pub(in crate::probing) fn markers(status: Status) -> [Self; 3] {
        let marker =
            |key, name, marked| Self { key: Some(Key::Q(key)), name, value: Value::Whole(i64::from(status == marked)) };
        [
            marker(180, ResultName::GOOD, Status::Good),
            marker(181, ResultName::REWORK, Status::Rework),
            marker(182, ResultName::SCRAP, Status::Scrap),
        ]
    }
}

/// What a result parameter is: a name in English, and its text in the locale files. A cycle may define its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct ResultName(&'static str);

impl ResultName {
    /// Measured centre, first axis.
    pub const CENTRE_1: Self = Self::new("found-centre-1");
    /// Measured centre, second axis.
    pub const CENTRE_2: Self = Self::new("found-centre-2");
    /// Measured centre, third axis.
    pub const CENTRE_3: Self = Self::new("found-centre-3");
    /// Measured length of a rectangle's side along the first axis.
    pub const SIDE_1: Self = Self::new("found-side-1");
    /// Measured length of a rectangle's side along the second axis.
    pub const SIDE_2: Self = Self::new("found-side-2");
    /// Measured width.
    pub const WIDTH: Self = Self::new("found-width");
    /// The position of the middle between two walls in the measured axis.
    pub const CENTRE_LINE: Self = Self::new("found-centre-line");
    /// Deviation of a rectangle's side along the first axis.
    pub const SIDE_DEVIATION_1: Self = Self::new("found-side-deviation-1");
    /// Deviation of a rectangle's side along the second axis.
    pub const SIDE_DEVIATION_2: Self = Self::new("found-side-deviation-2");
    /// Deviation of a width.
    pub const WIDTH_DEVIATION: Self = Self::new("found-width-deviation");
    /// Measured diameter.
    pub const DIAMETER: Self = Self::new("found-diameter");
    /// Deviation of the centre, first axis.
    pub const CENTRE_DEVIATION_1: Self = Self::new("found-centre-deviation-1");
    /// Deviation of the centre, second axis.
    pub const CENTRE_DEVIATION_2: Self = Self::new("found-centre-deviation-2");
    /// Deviation of the centre, third axis.
    pub const CENTRE_DEVIATION_3: Self = Self::new("found-centre-deviation-3");
    /// Deviation of the diameter.
    pub const DIAMETER_DEVIATION: Self = Self::new("found-diameter-deviation");
    /// A coordinate in the measured axis.
    pub const COORDINATE: Self = Self::new("found-coordinate");
    /// Deviation of a coordinate in the measured axis.
    pub const COORDINATE_DEVIATION: Self = Self::new("found-coordinate-deviation");
    /// Measured angle.
    pub const ANGLE: Self = Self::new("found-angle");
    /// Measured position, first axis.
    pub const POSITION_1: Self = Self::new("found-position-1");
    /// Measured position, second axis.
    pub const POSITION_2: Self = Self::new("found-position-2");
    /// Measured position, third axis.
    pub const POSITION_3: Self = Self::new("found-position-3");
    /// Deviation, first axis.
    pub const DEVIATION_1: Self = Self::new("found-deviation-1");
    /// Deviation, second axis.
    pub const DEVIATION_2: Self = Self::new("found-deviation-2");
    /// Deviation, third axis.
    pub const DEVIATION_3: Self = Self::new("found-deviation-3");
    /// Deviation along the normal.
    pub const DEVIATION_ALONG: Self = Self::new("found-deviation-along");
    /// Marker of a good part.
    pub const GOOD: Self = Self::new("found-good");
    /// Marker of rework.
    pub const REWORK: Self = Self::new("found-rework");
    /// Marker of scrap.
    pub const SCRAP: Self = Self::new("found-scrap");
    /// Status as one number.
    pub const STATUS: Self = Self::new("found-status");

    /// What files for programs call a result that has no parameter: `coordinate_deviation`.
    pub fn in_files(self) -> String {
        self.0.trim_start_matches("found-").replace('-', "_")
    }

    /// Whether it is a coordinate of a centre, which has no limits of size.
    pub fn is_centre(self) -> bool {
        [Self::CENTRE_1, Self::CENTRE_2, Self::CENTRE_3].contains(&self)
    }

    /// A name by the id of its text.
    pub const fn new(id: &'static str) -> Self {
        Self(id)
    }
}

display!(ResultName, Check, Stop);

impl Say for ResultName {
    fn message(&self) -> Message {
        Message::new(self.0)
    }
}

/// A measured value that was compared with its limits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Check {
    /// What was compared.
    pub what: ResultName,
    /// The measured value.
    pub measured: Length,
    /// The smallest permitted value.
    pub minimum: Length,
    /// The largest permitted value.
    pub maximum: Length,
    /// Good, rework or scrap by this value alone.
    pub status: Status,
}

impl Check {
    /// Whether the value is outside its limits.
    pub fn is_out(&self) -> bool {
        self.status != Status::Good
    }

    /// How far the value lies above its minimum; below zero where it is too small.
    pub fn above_minimum(&self) -> Length {
        self.measured.saturating_sub(self.minimum)
    }

    /// How far the value lies below its maximum; below zero where it is too large.
    pub fn below_maximum(&self) -> Length {
        self.maximum.saturating_sub(self.measured)
    }

    /// How much to remove, where that makes the part good.
    pub fn removal(&self) -> Option<Removal> {
        let middle = self.minimum.midpoint(self.maximum);
        let beyond = self.above_minimum().min(self.below_maximum()).negated();
        let to_middle = self.measured.saturating_sub(middle).abs();
        (self.status == Status::Rework).then_some(Removal { to_limit: beyond, to_middle })
    }
}

impl Say for Check {
    fn message(&self) -> Message {
        let id = match () {
            () if !self.is_out() => "check-within",
            () if self.maximum < self.measured => "check-above",
            () => "check-below",
        };
        Message::new(id)
            .message("what", self.what.message())
            .number("measured", self.measured)
            .number("minimum", self.minimum)
            .number("maximum", self.maximum)
            .with("status", &self.status)
    }
}

/// A program stop because something is out of tolerance.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Stop {
    /// The value of Q309.
    pub setting: i64,
    /// The first value that is out.
    pub out: Check,
    /// The others that are out.
    pub more: Vec<Check>,
}

impl Stop {
    /// The stop for what is out of tolerance, if anything is.
    pub(in crate::probing) fn of(setting: i64, checks: &[Check]) -> Option<Self> {
        let mut out = checks.iter().copied().filter(Check::is_out);
        out.next().map(|first| Self { setting, out: first, more: out.collect() })
    }
}

impl Say for Stop {
    fn message(&self) -> Message {
        let both = |one: Message, other: Message| message!("check-and").message("one", one).message("other", other);
        let out = self.more.iter().fold(self.out.message(), |out, check| both(out, check.message()));
        message!("cycle-stop").text("setting", self.setting).message("out", out)
    }
}

/// Where the control puts the log of a cycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum LogTarget {
    /// There is none.
    None,
    /// A file next to the program.
    File(&'static str),
    /// On the screen, and the program stops until it is started again.
    Screen,
    /// On the screen while the program goes on.
    Shown,
}
