//! How commands and news change the statistics page.

use std::ops::Range;

use fitcheck_core::message::Message;
use fitcheck_exchange::series::Memory;
use fitcheck_statistics::{Cusum, Ewma};
use jiff::civil::DateTime;

use super::{Below, StatisticsCommand, StatisticsField, StatisticsPage, StatisticsView, StudyCommand};
use crate::command::Command;
use crate::effect::Effect;
use crate::page::Page;
use crate::saved::Saved;
use crate::shared::{News, Shared};
use crate::state::PageState;
use crate::texts::{KeptField as _, Texts};

impl PageState for StatisticsPage {
    type Command = StatisticsCommand;
    type Field = StatisticsField;

    fn restored(saved: &Saved, _shared: &Shared) -> Self {
        Self { texts: Texts::restored(&saved.inputs.texts), ..Self::default() }
    }

    fn save(&self, saved: &mut Saved) {
        // What a gauge was asked for belongs to its file, which is not kept.
        let of_study: Vec<&str> =
            StatisticsField::ALL.iter().filter(|field| field.is_of_study()).map(|field| field.declared().0).collect();
        saved.inputs.texts.extend(self.texts.saved().filter(|(key, _)| !of_study.contains(&key.as_str())));
    }

    fn apply(&mut self, command: StatisticsCommand, shared: &mut Shared, _now: DateTime) -> Vec<Effect> {
        match command {
            StatisticsCommand::Type(field, text) => {
                self.texts.set(field, text);
                match field {
                    StatisticsField::Question | StatisticsField::Last => self.ask(shared, true),
                    StatisticsField::Size | StatisticsField::Pause => self.regroup(),
                    StatisticsField::Reason => {}
                    StatisticsField::StudyLower
                    | StatisticsField::StudyUpper
                    | StatisticsField::StudyReference
                    | StatisticsField::StudyResolution => self.study.read_anew(&self.texts),
                }
            }
            StatisticsCommand::View(view) => self.view = view,
            StatisticsCommand::Study(command) => {
                if matches!(command, StudyCommand::Read { result: Ok(_), .. }) {
                    self.view = StatisticsView::Study;
                }
                self.study.apply(command, &self.texts, shared);
            }
            StatisticsCommand::TakePart(part) => self.take_part(part.as_deref(), shared),
            StatisticsCommand::ReadAgain => self.ask(shared, false),
            StatisticsCommand::Found { run, result } => self.take_found(run, result),
            StatisticsCommand::Evaluated { run, answers } => self.take_answers(run, answers),
            StatisticsCommand::MoveFeature(step) => self.move_feature(step),
            StatisticsCommand::ChooseFeature(at) => self.choose_feature(at),
            StatisticsCommand::UsePoints(points_of) => {
                self.points_of = points_of;
                self.regroup();
            }
            StatisticsCommand::UseMeansOf(mean_of) => {
                self.mean_of = mean_of;
                self.regroup();
            }
            StatisticsCommand::ShowBelow(below) => {
                self.look.memory = match below {
                    Below::Spread => None,
                    Below::Ewma => Some(Memory::Ewma(Ewma::default())),
                    Below::Cusum => Some(Memory::Cusum(Cusum::default())),
                };
                self.recompute();
            }
            StatisticsCommand::SwitchRule(rule) => {
                self.look.rules = self.look.rules.with(rule, !self.look.rules.has(rule));
                self.recompute();
            }
            StatisticsCommand::ShowRules(shows) => self.shows_rules = shows,
            StatisticsCommand::Show(aside) => self.aside = aside,
            StatisticsCommand::Move(step) => self.step(step),
            StatisticsCommand::ChoosePoint(point) => self.go_to(point),
            StatisticsCommand::OpenRecord(point) => self.open_record(point, shared),
            StatisticsCommand::Zoom(zooming) => self.zoom(zooming),
            StatisticsCommand::See(window) => self.see(window),
            StatisticsCommand::Freeze => self.freeze(),
            StatisticsCommand::Stage => self.switch_stage(),
            StatisticsCommand::LeaveOut => return self.leave_out(),
            StatisticsCommand::TakeReason => self.take_reason(),
            StatisticsCommand::CancelReason => self.asks_why = false,
            StatisticsCommand::Copy => {
                let words = shared.report_words();
                let copied = match self.view {
                    StatisticsView::Features => self.copied(&words),
                    StatisticsView::Study => self.study.copied(&words),
                };
                return copied.map(Effect::Copy).into_iter().collect();
            }
        }
        Vec::new()
    }

    fn follow(&mut self, news: &News, shared: &mut Shared) {
        let is_open = shared.page == Page::Statistics;
        match news {
            News::Opened(Page::Statistics) => self.opened(shared),
            News::Journal if is_open => self.opened(shared),
            News::Measured(newest) => self.find_alarms(newest, shared),
            _ => {}
        }
    }

    fn take_errands(&mut self) -> Vec<Effect> {
        let mut errands = std::mem::take(&mut self.errands);
        errands.extend(self.study.take_errands());
        errands
    }

    fn text(&self, field: StatisticsField) -> &str {
        self.texts.text(field)
    }

    fn error(&self, field: StatisticsField) -> Option<&Message> {
        self.errors.get(&field).or_else(|| self.study.error(field))
    }

    fn culprit(&self, field: StatisticsField) -> Option<&Range<usize>> {
        self.culprit.as_ref().filter(|_| field == StatisticsField::Question)
    }

    fn closes(&self) -> Option<Command> {
        if self.asks_why {
            Some(StatisticsCommand::CancelReason.into())
        } else {
            self.shows_rules.then(|| StatisticsCommand::ShowRules(false).into())
        }
    }

    fn is_free_text(&self, field: StatisticsField) -> bool {
        matches!(field, StatisticsField::Question | StatisticsField::Reason | StatisticsField::StudyReference)
    }
}
