//! What comes from a port.

use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_gauges::News;
use jiff::civil::DateTime;

use super::{GaugeLine, Gauges, MOST_LINES, OpenGauge, PortState};
use crate::Session;
use crate::effect::Effect;
use crate::notice::Notice;
use crate::page::Page;
use crate::settings_page::Section;
use crate::shared::Shared;

impl Session {
    /// Something came from a port. What comes from one that was closed changes nothing.
    pub(crate) fn heard(&mut self, run: u64, news: News, now: DateTime) -> Vec<Effect> {
        let gauges = &mut self.settings_page.gauges;
        let is_it = |gauge: &OpenGauge| gauge.run == run && gauge.state != PortState::Closed;
        let Some(at) = gauges.list.iter().position(is_it) else { return Vec::new() };
        let Some(gauge) = gauges.list.get_mut(at) else { return Vec::new() };
        let shared = &mut self.shared;
        match news {
            News::Opened => gauge.open(shared),
            News::Back => {
                gauge.open(shared);
                shared.note(message!("gauges-back").text("name", gauge.name()), Vec::new());
            }
            News::Lost(trouble) => {
                let why = trouble.message();
                gauge.tell(message!("gauges-lost").text("name", gauge.name()).message("why", why.clone()), shared);
                gauge.state = PortState::Lost(why);
            }
            News::Refused(refusal) => {
                let why = refusal.message();
                gauge.list(String::new(), Err(why.clone()));
                let said = message!("gauges-refused").text("name", gauge.name()).message("why", why);
                self.tell_unless_tested(at, said);
            }
            News::Line(line) => return self.heard_line(at, &line, now),
        }
        Vec::new()
    }

    /// Whether lines are only listed: somebody looks at what gauges send.
    pub(super) fn is_testing(&self) -> bool {
        let page = &self.settings_page;
        self.shared.page == Page::Settings && page.found.is_none() && page.section == Section::Gauges
    }

    /// Tells what gave no value, unless it is listed before the eyes of whoever sets the gauge.
    pub(super) fn tell_unless_tested(&mut self, at: usize, said: Message) {
        if !self.is_testing()
            && let Some(gauge) = self.settings_page.gauges.list.get(at)
        {
            gauge.tell(said, &mut self.shared);
        }
    }

    fn heard_line(&mut self, at: usize, line: &str, now: DateTime) -> Vec<Effect> {
        let asked = self.size_asked();
        let is_testing = self.is_testing();
        let Some(gauge) = self.settings_page.gauges.list.get_mut(at) else { return Vec::new() };
        let read = gauge.read(line, asked).map_err(|error| error.message());
        gauge.list(line.to_owned(), read.clone());
        match read {
            _ if is_testing => Vec::new(),
            Ok(gauged) => self.value_came(at, gauged, now),
            Err(why) => {
                self.pass_over(at, line, why);
                Vec::new()
            }
        }
    }

    /// Tells that a line gives no check: one notice for all of a gauge until one is taken or the notice is closed.
    pub(super) fn pass_over(&mut self, at: usize, given: &str, why: Message) {
        let Some(gauge) = self.settings_page.gauges.list.get_mut(at) else { return };
        let is_told = |notice: &Notice| notice.gauge == Some(gauge.id);
        gauge.unused = if self.shared.notices.open().iter().any(is_told) { gauge.unused + 1 } else { 1 };
        let said = message!("gauges-not-taken").count("count", gauge.unused).text("name", gauge.name());
        gauge.tell(said.text("given", given).message("why", why), &mut self.shared);
    }
}

impl OpenGauge {
    /// It is there: what was told of it is over.
    fn open(&mut self, shared: &mut Shared) {
        self.state = PortState::Open;
        shared.notices.retain(|notice| notice.gauge != Some(self.id));
    }

    fn list(&mut self, text: String, read: Result<fitcheck_exchange::exchange::gauge::Gauged, Message>) {
        self.lines.push_front(GaugeLine { text, read });
        self.lines.truncate(MOST_LINES);
    }

    /// Tells what is wrong with it, in the place of what was told before.
    fn tell(&self, said: Message, shared: &mut Shared) {
        shared.notices.retain(|notice| notice.gauge != Some(self.id));
        shared.notices.push(Notice { gauge: Some(self.id), page: Some(Page::Settings), ..Notice::of(said, true) });
    }
}

impl Gauges {
    /// When the last value of a gauge came; this one comes now.
    pub(super) fn comes(&mut self, at: usize, now: DateTime) -> Option<DateTime> {
        self.list.get_mut(at)?.last.replace(now)
    }
}
