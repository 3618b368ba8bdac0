//! How gauges are set.

use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_exchange::exchange::gauge::{self, Taught};

use super::{GaugeCommand, GaugeLine, Gauges, OpenGauge, PortState};
use crate::effect::Effect;
use crate::saved::SavedGauge;
use crate::settings_page::SettingsField;
use crate::shared::Shared;
use crate::texts::whole;

impl Gauges {
    pub(crate) fn apply(&mut self, command: GaugeCommand, shared: &mut Shared) {
        match command {
            GaugeCommand::Add => self.add(shared),
            GaugeCommand::Remove => self.remove(shared),
            GaugeCommand::Show(at) => self.shown = at.min(self.list.len().saturating_sub(1)),
            GaugeCommand::Connect(true) => self.connect_shown(),
            GaugeCommand::Connect(false) => self.disconnect(),
            GaugeCommand::UsePort(port) => {
                self.type_text(SettingsField::GaugePort, port);
            }
            GaugeCommand::UseBits(bits) => self.set(|gauge| gauge.saved.port.bits = bits),
            GaugeCommand::UseParity(parity) => self.set(|gauge| gauge.saved.port.parity = parity),
            GaugeCommand::UseStop(stop) => self.set(|gauge| gauge.saved.port.stop = stop),
            GaugeCommand::UseUnit(unit) => self.read_by(|gauge| gauge.saved.unit = unit),
            GaugeCommand::Teach => self.teach(),
            GaugeCommand::Forget => self.read_by(|gauge| gauge.saved.taught = None),
            GaugeCommand::FindPorts => self.errands.push(Effect::FindPorts),
            GaugeCommand::Ports(Ok(ports)) => self.ports = ports,
            GaugeCommand::Ports(Err(why)) => shared.tell(why),
        }
    }

    fn add(&mut self, shared: &Shared) {
        let number = self.list.len() + 1;
        let name = shared.words().say(&message!("gauges-new-name").count("number", number));
        self.push(SavedGauge { name, ..SavedGauge::default() });
        self.shown = self.list.len().saturating_sub(1);
        self.errands.push(Effect::FindPorts);
    }

    fn remove(&mut self, shared: &mut Shared) {
        self.disconnect();
        if self.shown < self.list.len() {
            let gone = self.list.remove(self.shown);
            shared.notices.retain(|notice| notice.gauge != Some(gone.id));
        }
        self.shown = self.shown.min(self.list.len().saturating_sub(1));
    }

    /// Opens the port of the gauge that is shown, unless it cannot be one.
    fn connect_shown(&mut self) {
        let Some(gauge) = self.shown_mut() else { return };
        if gauge.port().port.trim().is_empty() {
            gauge.port_error = Some(message!("gauges-no-port-chosen"));
            return;
        }
        if gauge.speed_error.is_none() {
            gauge.saved.on = true;
            self.connect(self.shown);
        }
    }

    /// Opens a port that is to be open.
    pub(super) fn connect(&mut self, at: usize) {
        let Some(gauge) = self.list.get_mut(at).filter(|gauge| gauge.is_connected()) else { return };
        if gauge.state != PortState::Closed {
            self.errands.push(Effect::CloseGauge(gauge.run));
        }
        self.runs += 1;
        gauge.run = self.runs;
        gauge.state = PortState::Opening;
        self.errands.push(Effect::OpenGauge { run: gauge.run, settings: gauge.saved.port.clone() });
    }

    fn disconnect(&mut self) {
        let Some(gauge) = self.list.get_mut(self.shown) else { return };
        gauge.saved.on = false;
        if std::mem::take(&mut gauge.state) != PortState::Closed {
            self.errands.push(Effect::CloseGauge(gauge.run));
        }
    }

    /// Changes how the port is set: it is opened anew.
    fn set(&mut self, change: impl FnOnce(&mut OpenGauge)) {
        if let Some(gauge) = self.shown_mut() {
            change(gauge);
            self.connect(self.shown);
        }
    }

    /// Changes how lines are read: those in the list are read anew.
    fn read_by(&mut self, change: impl FnOnce(&mut OpenGauge)) {
        let Some(gauge) = self.shown_mut() else { return };
        change(gauge);
        let lines = std::mem::take(&mut gauge.lines);
        let anew = |line: GaugeLine| GaugeLine {
            read: if line.text.is_empty() {
                line.read
            } else {
                gauge.read(&line.text, None).map_err(|error| error.message())
            },
            text: line.text,
        };
        let anew = lines.into_iter().map(anew).collect();
        gauge.lines = anew;
    }

    fn teach(&mut self) {
        let Some(gauge) = self.shown_mut() else { return };
        match taught(gauge) {
            Ok(taught) => {
                gauge.gave.clear();
                gauge.gave_error = None;
                self.read_by(|gauge| gauge.saved.taught = Some(taught));
            }
            Err(why) => gauge.gave_error = Some(why),
        }
    }

    /// A text for a field of the gauge that is shown. A port whose name or speed is being typed is closed.
    pub(crate) fn type_text(&mut self, field: SettingsField, text: String) {
        if matches!(field, SettingsField::GaugePort | SettingsField::GaugeSpeed) {
            self.disconnect();
        }
        let Some(gauge) = self.shown_mut() else { return };
        match field {
            SettingsField::Find
            | SettingsField::NewPin
            | SettingsField::Pin
            | SettingsField::Company
            | SettingsField::CompanyAddress
            | SettingsField::CompanyLogo => {}
            SettingsField::GaugeName => gauge.saved.name = text,
            SettingsField::GaugePort => {
                gauge.saved.port.port = text;
                gauge.port_error = None;
            }
            SettingsField::GaugeSpeed => {
                let read = speed(&text);
                gauge.speed = text;
                gauge.speed_error = read.map(|speed| gauge.saved.port.speed = speed).err();
            }
            SettingsField::GaugeGave => {
                gauge.gave = text;
                gauge.gave_error = None;
            }
        }
    }

    pub(crate) fn text(&self, field: SettingsField) -> &str {
        let Some(gauge) = self.shown() else { return "" };
        match field {
            SettingsField::Find
            | SettingsField::NewPin
            | SettingsField::Pin
            | SettingsField::Company
            | SettingsField::CompanyAddress
            | SettingsField::CompanyLogo => "",
            SettingsField::GaugeName => &gauge.saved.name,
            SettingsField::GaugePort => &gauge.saved.port.port,
            SettingsField::GaugeSpeed => &gauge.speed,
            SettingsField::GaugeGave => &gauge.gave,
        }
    }

    pub(crate) fn error(&self, field: SettingsField) -> Option<&Message> {
        let gauge = self.shown()?;
        match field {
            SettingsField::Find
            | SettingsField::NewPin
            | SettingsField::Pin
            | SettingsField::GaugeName
            | SettingsField::Company
            | SettingsField::CompanyAddress
            | SettingsField::CompanyLogo => None,
            SettingsField::GaugePort => gauge.port_error.as_ref(),
            SettingsField::GaugeSpeed => gauge.speed_error.as_ref(),
            SettingsField::GaugeGave => gauge.gave_error.as_ref(),
        }
    }
}

/// The speeds that drivers take.
const SPEEDS: std::ops::RangeInclusive<u32> = 50..=4_000_000;

fn speed(text: &str) -> Result<u32, Message> {
    let speed = whole::<u32>(text)?;
    let range = || message!("gauges-speed-range").text("given", speed).text("least", SPEEDS.start());
    if SPEEDS.contains(&speed) { Ok(speed) } else { Err(range().text("most", SPEEDS.end())) }
}

/// The form of the newest line, which gave what is typed.
fn taught(gauge: &OpenGauge) -> Result<Taught, Message> {
    let newest = gauge.lines.iter().find(|line| !line.text.is_empty());
    let line = newest.ok_or_else(|| message!("gauges-no-line"))?;
    let gave = gauge::read(&gauge.gave, None).map_err(|error| error.message())?;
    Taught::by(&line.text, gave.value).map_err(|error| error.message())
}
