//! What can be done with gauges, by button.

use fitcheck_exchange::exchange::gauge::LineUnit;
use fitcheck_gauges::{DataBits, Parity, PortSettings, StopBits};

use super::{GaugeCommand, OpenGauge};
use crate::Session;
use crate::action::ActionScope;
use crate::action::row::{ActionRow, Sends, on};
use crate::page::Page;
use crate::settings_page::SettingsCommand;

/// What can be done with gauges; all but adding one is about the one that is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum GaugeAction {
    Add,
    Remove,
    /// Opens its port, or closes it.
    Connect,
    FindPorts,
    /// Learns the form of its lines.
    Teach,
    Forget,
    UseBits(DataBits),
    UseParity(Parity),
    UseStop(StopBits),
    /// Says what its numbers without a unit are in.
    UseUnit(LineUnit),
}

impl GaugeAction {
    /// All of them.
    pub(crate) fn all() -> impl Iterator<Item = Self> {
        [Self::Add, Self::Remove, Self::Connect, Self::FindPorts, Self::Teach, Self::Forget]
            .into_iter()
            .chain(DataBits::ALL.map(Self::UseBits))
            .chain(Parity::ALL.map(Self::UseParity))
            .chain(StopBits::ALL.map(Self::UseStop))
            .chain(LineUnit::ALL.map(Self::UseUnit))
    }

    pub(crate) fn row(self) -> ActionRow {
        match self {
            Self::Add => of_gauges("gauges-add", GaugeCommand::Add),
            Self::Remove => of_gauges("gauges-remove", GaugeCommand::Remove).when(has_gauge),
            Self::Connect => {
                let connects = |session: &Session| {
                    let is_on = shown(session).is_some_and(OpenGauge::is_connected);
                    SettingsCommand::Gauge(GaugeCommand::Connect(!is_on)).into()
                };
                let place = ActionScope::Page(Page::Settings);
                ActionRow::new(place, "gauges-connect", Sends::FromState(connects)).when(has_gauge)
            }
            Self::FindPorts => of_gauges("gauges-find-ports", GaugeCommand::FindPorts),
            Self::Teach => of_gauges("gauges-teach", GaugeCommand::Teach).when(has_gauge),
            Self::Forget => of_gauges("gauges-forget", GaugeCommand::Forget)
                .when(|session| shown(session).is_some_and(|gauge| gauge.saved.taught.is_some())),
            Self::UseBits(bits) => {
                let text = match bits {
                    DataBits::Seven => "gauges-bits-seven",
                    DataBits::Eight => "gauges-bits-eight",
                };
                of_gauges(text, GaugeCommand::UseBits(bits)).when(has_gauge)
            }
            Self::UseParity(parity) => {
                let text = match parity {
                    Parity::None => "gauges-parity-none",
                    Parity::Even => "gauges-parity-even",
                    Parity::Odd => "gauges-parity-odd",
                };
                of_gauges(text, GaugeCommand::UseParity(parity)).when(has_gauge)
            }
            Self::UseStop(stop) => {
                let text = match stop {
                    StopBits::One => "gauges-stop-one",
                    StopBits::Two => "gauges-stop-two",
                };
                of_gauges(text, GaugeCommand::UseStop(stop)).when(has_gauge)
            }
            Self::UseUnit(unit) => {
                let text = match unit {
                    LineUnit::Said => "gauges-unit-said",
                    LineUnit::Mm => "gauges-unit-mm",
                    LineUnit::Inch => "gauges-unit-inch",
                };
                of_gauges(text, GaugeCommand::UseUnit(unit)).when(has_gauge)
            }
        }
    }

    /// Whether it is what counts now, where it is a choice.
    pub(crate) fn is_on(self, session: &Session) -> Option<bool> {
        Some(match self {
            Self::Connect => shown(session).is_some_and(OpenGauge::is_connected),
            Self::UseBits(bits) => port(session).bits == bits,
            Self::UseParity(parity) => port(session).parity == parity,
            Self::UseStop(stop) => port(session).stop == stop,
            Self::UseUnit(unit) => shown(session).map_or_else(LineUnit::default, |gauge| gauge.saved.unit) == unit,
            Self::Add | Self::Remove | Self::FindPorts | Self::Teach | Self::Forget => return None,
        })
    }
}

/// The gauge that is shown.
fn shown(session: &Session) -> Option<&OpenGauge> {
    session.settings_page().gauges.shown()
}

/// How its port is set; how a new one's is where there is none.
fn port(session: &Session) -> PortSettings {
    shown(session).map_or_else(PortSettings::default, |gauge| gauge.port().clone())
}

fn has_gauge(session: &Session) -> bool {
    shown(session).is_some()
}

fn of_gauges(text: &'static str, command: GaugeCommand) -> ActionRow {
    on(Page::Settings, text, SettingsCommand::Gauge(command))
}
