//! Gauges on serial and USB ports: which there are, what came from them, and where their values go.
//!
//! | file | what |
//! |---|---|
//! | here | the gauges, and the one that is shown |
//! | `actions`, `command`, `setting` | what can be done with them, and doing it |
//! | `hearing` | what comes from a port |
//! | `taking` | a value goes where a typed one would go, or is told |
//!
//! The settings page has them; ports are opened outside.

mod actions;
mod command;
mod hearing;
mod setting;
mod taking;

use std::collections::VecDeque;

use fitcheck_core::length::Length;
use fitcheck_core::message::{Message, message};
use fitcheck_exchange::exchange::gauge::{self, GaugeError, GaugeRemark, Gauged};
use fitcheck_gauges::PortSettings;
use jiff::civil::DateTime;

pub use self::actions::GaugeAction;
pub use self::command::GaugeCommand;
use super::effect::Effect;
use super::saved::SavedGauge;
use super::shared::Shared;

/// How many lines of a gauge are listed, the latest first.
const MOST_LINES: usize = 20;

/// The gauges.
#[derive(Debug, Default)]
pub struct Gauges {
    list: Vec<OpenGauge>,
    /// The place of the one that is shown.
    shown: usize,
    /// The ports of this computer, as far as they were found.
    pub ports: Vec<String>,
    /// How many ports were opened, and gauges made.
    runs: u64,
    made: u64,
    /// When something came that is not good: somebody looks at it.
    not_good: Option<DateTime>,
    /// What has to be done outside.
    errands: Vec<Effect>,
}

/// A gauge, and its port.
#[derive(Debug, Default)]
pub struct OpenGauge {
    pub saved: SavedGauge,
    /// Its number, as long as the window is open.
    id: u64,
    /// The number of its port: every time that it is opened has another one.
    run: u64,
    pub state: PortState,
    lines: VecDeque<GaugeLine>,
    /// When its last value came.
    last: Option<DateTime>,
    /// How many of its lines gave nothing since one did.
    unused: usize,
    speed: String,
    speed_error: Option<Message>,
    port_error: Option<Message>,
    /// What the newest line gave, as it is typed.
    gave: String,
    gave_error: Option<Message>,
}

/// How a port stands.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub enum PortState {
    #[default]
    Closed,
    Opening,
    Open,
    Lost(Message),
}

/// A line as it came.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct GaugeLine {
    pub text: String,
    /// What was read of it.
    pub read: Result<Gauged, Message>,
}

/// The gauge that a value is from, and what was read besides it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FromGauge {
    pub name: String,
    pub remarks: Vec<GaugeRemark>,
}

impl FromGauge {
    /// What is to be said beside the value.
    pub fn told(&self) -> Message {
        message!("gauges-measured-with").text("name", &self.name)
    }
}

/// A remark, and the gauge with which the value was measured.
pub(super) fn measured_with(remark: &str, gauge: Option<&FromGauge>, shared: &Shared) -> String {
    let told = gauge.map(|gauge| shared.recorded_words().say(&gauge.told()));
    let both = (!remark.is_empty()).then(|| remark.to_owned()).into_iter().chain(told);
    both.collect::<Vec<_>>().join("; ")
}

impl Gauges {
    pub(super) fn restored(saved: &[SavedGauge]) -> Self {
        let mut gauges = Self::default();
        for saved in saved {
            gauges.push(saved.clone());
        }
        for at in 0..gauges.list.len() {
            gauges.connect(at);
        }
        gauges
    }

    pub(super) fn saved(&self) -> Vec<SavedGauge> {
        self.list.iter().map(|gauge| gauge.saved.clone()).collect()
    }

    /// All of them.
    pub fn list(&self) -> &[OpenGauge] {
        &self.list
    }

    /// The one that is shown.
    pub fn shown(&self) -> Option<&OpenGauge> {
        self.list.get(self.shown)
    }

    /// Its place.
    pub const fn shown_place(&self) -> usize {
        self.shown
    }

    fn push(&mut self, saved: SavedGauge) {
        self.made += 1;
        let speed = saved.port.speed.to_string();
        self.list.push(OpenGauge { id: self.made, speed, saved, ..OpenGauge::default() });
    }

    fn shown_mut(&mut self) -> Option<&mut OpenGauge> {
        self.list.get_mut(self.shown)
    }

    pub(super) fn take_errands(&mut self) -> Vec<Effect> {
        std::mem::take(&mut self.errands)
    }

    /// Something was judged that is not good.
    pub(super) const fn saw_not_good(&mut self, now: DateTime) {
        self.not_good = Some(now);
    }
}

impl OpenGauge {
    /// What it is called: by its name, or else by its port.
    pub fn name(&self) -> &str {
        let name = self.saved.name.trim();
        if name.is_empty() { self.port().port.trim() } else { name }
    }

    pub const fn port(&self) -> &PortSettings {
        &self.saved.port
    }

    /// The lines that came last, the latest first.
    pub fn lines(&self) -> impl Iterator<Item = &GaugeLine> {
        self.lines.iter()
    }

    /// Whether its port is open or tried.
    pub const fn is_connected(&self) -> bool {
        self.saved.on
    }

    /// Reads a line of it.
    ///
    /// # Errors
    /// Why it is no value.
    fn read(&self, line: &str, asked: Option<Length>) -> Result<Gauged, GaugeError> {
        match &self.saved.taught {
            Some(taught) => taught.read(line, asked),
            None => gauge::read_line(line, self.saved.unit, asked),
        }
    }
}
