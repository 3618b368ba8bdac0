//! How commands and news change the check page.

use std::ops::Range;
use std::sync::Arc;

use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_core::probing::Origin;
use fitcheck_core::tolerance::{Callout, Feature, Sources};
use fitcheck_exchange::exchange::Labels;
use fitcheck_exchange::journal::entry::{FileRole, UsedFile};
use fitcheck_exchange::journal::query::RecordId;
use fitcheck_exchange::journal::{Record, status_window};
use jiff::civil::DateTime;

use super::inputs::SIMULATION;
use super::{
    CheckAction, CheckCommand, CheckField, CheckInputs, CheckPage, DoubtedText, MeasureBy, Question, RuleChoice,
    RuleFields, ShownCheck, UncertaintyFrom, class_text, measuring, nominal_text, worth,
};
use crate::action::Action;
use crate::effect::Effect;
use crate::gauges::measured_with;
use crate::page::Page;
use crate::recording::used;
use crate::rows::Rows;
use crate::saved::Saved;
use crate::shared::{News, Shared};
use crate::state::{PageQuestion, PageState};

impl PageState for CheckPage {
    type Command = CheckCommand;
    type Field = CheckField;

    fn restored(saved: &Saved, shared: &Shared) -> Self {
        Self::new(&saved.inputs, &shared.sources)
    }

    fn save(&self, saved: &mut Saved) {
        saved.inputs.texts.extend(self.texts());
        saved.inputs.by = self.by;
        saved.inputs.judging = self.own_judging();
    }

    fn apply(&mut self, command: CheckCommand, shared: &mut Shared, now: DateTime) -> Vec<Effect> {
        match command {
            CheckCommand::Type(CheckField::HistoryFilter, text) => {
                self.texts.set(CheckField::HistoryFilter, text);
                self.filter(shared);
            }
            CheckCommand::Type(CheckField::RowsFilter, text) => {
                self.texts.set(CheckField::RowsFilter, text);
                return self.filter_rows(shared);
            }
            CheckCommand::Type(field, text) if shared.is_for_operators() => self.type_as_operator(field, text, shared),
            CheckCommand::Type(field, text) => self.type_text(field, text, &shared.sources),
            CheckCommand::ChooseClass(class) => {
                let nominal = nominal_text(self.text(CheckField::Callout));
                self.take_callout(&format!("{nominal} {class}"), &shared.sources);
            }
            CheckCommand::ChooseFeature(feature) => {
                if self.judge_as(feature, shared) {
                    return Vec::new();
                }
                // A value that was typed or judged already stays: it can be judged by these limits.
                self.mean(feature);
                self.clear(&shared.sources);
            }
            CheckCommand::JudgeAllAs(feature) => self.judge_all_as(feature, shared),
            CheckCommand::MeasureBy(by) if by == self.by => {}
            CheckCommand::MeasureBy(by) => {
                self.by = by;
                self.edited(&shared.sources);
            }
            CheckCommand::UseRule(rule) => self.judge_by(RuleChoice { rule, ..self.judging }, &shared.sources),
            CheckCommand::LetProve(prover) => self.judge_by(RuleChoice { prover, ..self.judging }, &shared.sources),
            CheckCommand::TellUncertainty(from) => {
                self.before_budget = None;
                self.judge_by(RuleChoice { from, ..self.judging }, &shared.sources);
            }
            CheckCommand::ChooseExpansion(field, expansion) => {
                self.type_text(field, shared.as_typed(&expansion.to_string()), &shared.sources);
            }
            CheckCommand::Measure => self.measure(shared, now),
            CheckCommand::TakeMeant => {
                if let Some(meant) = self.question.and_then(|question| question.doubt.meant()) {
                    self.texts.set(CheckField::Measured, shared.as_typed(&meant.to_string()));
                    self.edited(&shared.sources);
                    self.measure(shared, now);
                }
            }
            CheckCommand::TakeText => self.take_text(shared, now),
            CheckCommand::KeepText => self.keep_text(shared, now),
            CheckCommand::Clear => self.clear_value(&shared.sources),
            CheckCommand::CopyStatus => {
                return self.status_text().map(Effect::Copy).into_iter().collect();
            }
            CheckCommand::Show(id) => {
                if !self.lot.as_mut().is_some_and(|lot| lot.go_to(id)) {
                    self.lot = None;
                }
                self.show(id, shared);
            }
            CheckCommand::ShowInLot(step) => {
                if let Some(lot) = &mut self.lot {
                    lot.step(step);
                    self.show_of_lot(shared);
                }
            }
            CheckCommand::Choose(id, is_chosen) => shared.history.choose(id, is_chosen),
            CheckCommand::List(command) => {
                let words = shared.words();
                let copied = shared.history.apply(command, || words);
                return copied.map(Effect::Copy).into_iter().collect();
            }
            CheckCommand::ClearHistory => self.clear_history(shared),
            CheckCommand::Undo => self.undo(shared),
            CheckCommand::Imported { name, result } => self.imported(&name, result, shared, now),
            CheckCommand::Rows(command) => return self.apply_rows(command, shared, now),
        }
        Vec::new()
    }

    fn follow(&mut self, news: &News, shared: &mut Shared) {
        match news {
            News::Sources => {
                self.callout_changed(true, &shared.sources);
                let errands = self.judge_again();
                self.errands.extend(errands);
            }
            News::StatusWindow => {
                self.filter(shared);
                if let Some(shown) = self.shown.take() {
                    self.draw(shown.record, shown.id, shared);
                }
            }
            News::Check(callout) => self.take_callout(callout, &shared.sources),
            News::Correcting if shared.page == Page::Check => self.clear(&shared.sources),
            News::TakenBack { by, .. } => self.taken_back(by.as_ref().map(|by| by.0), shared),
            News::MeasureAgain { record, part, serial } => self.ask_again(record, part, serial, shared),
            // No verdict stays beside a budget that it was not made with.
            News::Budget if self.own_judging().from == UncertaintyFrom::Budget => self.edited(&shared.sources),
            News::BudgetTaken => {
                let from = self.own_judging().from;
                if from != UncertaintyFrom::Budget {
                    self.before_budget = Some(from);
                }
                self.tell_own(UncertaintyFrom::Budget, &shared.sources);
            }
            News::BudgetLeft => {
                let own = self.own_judging().from;
                let from = self.before_budget.take().filter(|_| own == UncertaintyFrom::Budget).unwrap_or(own);
                if from == UncertaintyFrom::Budget || from != own {
                    self.tell_own(from, &shared.sources);
                }
            }
            News::Opened(_)
            | News::OwnTables
            | News::OwnMask
            | News::Workpiece
            | News::WorkpieceTaken
            | News::ContactsTaken
            | News::PartTaken
            | News::Tools
            | News::Columns
            | News::Temperature
            | News::Journal
            | News::ShowRecord(_)
            | News::Correcting
            | News::UndoCorrection(_)
            | News::Kept(..)
            | News::Measured(_)
            | News::Undone { .. }
            | News::Budget => {}
        }
    }

    fn take_errands(&mut self) -> Vec<Effect> {
        std::mem::take(&mut self.errands)
    }

    fn text(&self, field: CheckField) -> &str {
        self.texts.text(field)
    }

    fn error(&self, field: CheckField) -> Option<&Message> {
        self.asked.error(field)
    }

    fn culprit(&self, field: CheckField) -> Option<&Range<usize>> {
        self.asked.culprit.as_ref().filter(|_| field == CheckField::Callout)
    }

    fn asks(&self) -> Option<PageQuestion> {
        let meant = self.question.as_ref()?.doubt.meant().map(|_| CheckAction::TakeMeant.into());
        let answers = meant.into_iter().chain([CheckAction::JudgeAnyway.into()]).collect();
        Some(PageQuestion { about: CheckAction::Measure.into(), answers })
    }

    fn repeated(&self) -> Option<Action> {
        self.would_repeat().then_some(CheckAction::Measure.into())
    }

    fn is_free_text(&self, field: CheckField) -> bool {
        matches!(field, CheckField::Part | CheckField::Serial | CheckField::Remark | CheckField::HistoryFilter)
    }
}

impl CheckPage {
    /// Lists what the filter says in the language of the window.
    fn filter(&self, shared: &mut Shared) {
        shared.history.filter(self.text(CheckField::HistoryFilter), &shared.words());
    }

    /// Empties the history; what is recorded stays in the journal, and undo brings the checks back.
    fn clear_history(&mut self, shared: &mut Shared) {
        let stay = shared.recording.has_any(&shared.history.ids()).then(|| message!("records-page-stay"));
        let count = shared.history.clear();
        if 0 < count {
            self.clear(&shared.sources);
            let message = message!("history-cleared").count("count", count);
            shared.note(message, stay.into_iter().collect());
            shared.note_change();
        }
    }

    /// Undoes the last change of the history, and closes the notice that tells of it. Where the list is not in sight, a
    /// notice says what was undone.
    fn undo(&mut self, shared: &mut Shared) {
        if self.undo_judging(shared) {
            return;
        }
        if let Some(new) = shared.history.undoes_correction() {
            let undone = shared.history.take_back();
            if let Some(undone) = undone.filter(|_| shared.page != Page::Check) {
                shared.note(message!("undone").message("what", undone), Vec::new());
            }
            return shared.spread(News::UndoCorrection(new));
        }
        let change = shared.history.last_change();
        let taken = shared.history.taken_by_undo();
        let standing: Vec<RecordId> = taken.iter().filter_map(|id| shared.history.standing(*id)).collect();
        let Some(undone) = shared.history.take_back() else { return };
        if shared.is_for_operators() && shared.page == Page::Check {
            // What was undone is typed anew.
            let focus = self.go_on(&shared.sources);
            self.errands.extend(focus);
        }
        self.clear(&shared.sources);
        shared.notices.retain(|notice| notice.change.is_none() || notice.change != change);
        // Where records are withdrawn, the journal's answer says what was undone.
        if !shared.withdraw(taken, &standing) && shared.page != Page::Check {
            shared.note(message!("undone").message("what", undone), Vec::new());
        }
    }

    /// What stands now takes the place of the check that was shown, or that was corrected here.
    fn taken_back(&mut self, by: Option<u64>, shared: &mut Shared) {
        let shown = self.shown.as_ref().and_then(|shown| shown.id);
        if shared.page != Page::Check && shown.is_none_or(|id| shared.history.replaced_by(id).is_none()) {
            return;
        }
        self.clear(&shared.sources);
        if let Some(new) = by.and_then(|number| shared.recording.check_of(number)) {
            self.show(new, shared);
        }
    }

    /// Judges the next part in another way. What stands in the fields of the rule is what is meant, even where a shown
    /// record lent it.
    fn judge_by(&mut self, judging: RuleChoice, sources: &Sources) {
        self.judging = judging;
        self.keep_rule();
        self.edited(sources);
    }

    /// The uncertainty of the next part is told in another way. The rest is as the user has it, whatever a shown record lent.
    fn tell_own(&mut self, from: UncertaintyFrom, sources: &Sources) {
        self.take_back_own();
        self.judging.from = from;
        self.edited(sources);
    }

    /// The rule on screen is the user's own from now on.
    fn keep_rule(&mut self) {
        self.own_judging = None;
        self.own.retain(|field, _| !worth::is_of_rule(*field));
    }

    pub(super) fn type_text(&mut self, field: CheckField, text: String, sources: &Sources) {
        self.own.remove(&field);
        if worth::is_of_rule(field) {
            self.keep_rule();
        }
        if worth::is_of_temperature(field) {
            // The temperatures on screen are the user's own from now on, and not only the one that is typed.
            self.own.retain(|of, _| !worth::is_of_temperature(*of));
        }
        self.texts.set(field, text);
        match field {
            CheckField::Callout => return self.callout_changed(true, sources),
            CheckField::Nominal => {
                let nominal = self.text(CheckField::Nominal);
                let class = class_text(self.text(CheckField::Callout));
                let callout = format!("{} {class}", nominal.trim());
                self.texts.set(CheckField::Callout, callout.trim());
                return self.callout_changed(false, sources);
            }
            CheckField::Measured => {
                self.by = MeasureBy::Typing;
                self.measured_is_used = false;
                self.gauge = None;
            }
            // The name is that of the next part, and the value that of the one before.
            CheckField::Part | CheckField::Serial | CheckField::Remark => self.empty_used(),
            _ => {}
        }
        self.edited(sources);
    }

    /// Reads the fields anew. The limits are those of the record that lends them.
    fn read(&mut self, sources: &Sources) {
        self.asked = CheckInputs::read(&self.texts, self.feature(), self.judging, sources, &self.meant);
        if let Some(record) = &self.lent {
            self.asked.show_limits(record.limits.clone(), record.callout);
        }
    }

    pub(super) fn take_callout(&mut self, callout: &str, sources: &Sources) {
        self.texts.set(CheckField::Callout, callout.trim());
        self.callout_changed(true, sources);
    }

    /// No verdict stays beside limits that it was not made with.
    fn callout_changed(&mut self, nominal_follows: bool, sources: &Sources) {
        if nominal_follows {
            let nominal = nominal_text(self.text(CheckField::Callout)).to_owned();
            self.texts.set(CheckField::Nominal, nominal);
        }
        self.empty_used();
        // Every new callout that does not say hole or shaft is asked about.
        let callout = self.text(CheckField::Callout).parse().ok();
        let is_same = |of: Option<Callout>| of.is_none() || of == callout;
        self.feature = self.feature.filter(|(of, _)| is_same(*of)).map(|(_, feature)| (callout, feature));
        self.clear(sources);
    }

    /// A value that was judged belongs to nothing else.
    fn empty_used(&mut self) {
        if std::mem::take(&mut self.measured_is_used) {
            self.texts.set(CheckField::Measured, "");
            self.gauge = None;
        }
    }

    /// The callout in the field, which does not say it, is that of a hole or a shaft, or of neither.
    fn mean(&mut self, feature: Option<Feature>) {
        self.feature = feature.map(|feature| (self.text(CheckField::Callout).parse().ok(), feature));
    }

    /// No verdict stays beside a value, a position or a name that it was not made with, and what it lent goes with it:
    /// the next value is judged by the source that is chosen now. Only limits without a callout stay, for the fields
    /// have no others.
    pub(super) fn edited(&mut self, sources: &Sources) {
        self.shown = None;
        self.question = None;
        self.lot = None;
        self.refusal = None;
        self.asks = false;
        self.is_repeated = false;
        self.rows.iter_mut().for_each(Rows::hide);
        self.lent = self.lent.take().filter(|record| record.callout.is_none());
        self.take_back_own();
        self.read(sources);
    }

    /// The user's own texts and rule come back into the fields.
    fn take_back_own(&mut self) {
        for (field, text) in std::mem::take(&mut self.own) {
            self.texts.set(field, text);
        }
        self.judging = self.own_judging.take().unwrap_or(self.judging);
    }

    /// Without a record, the limits are again those of the fields.
    pub(super) fn clear(&mut self, sources: &Sources) {
        self.lent = None;
        self.edited(sources);
    }

    /// Sends checks to the journal, with the file that their values are from and what it says of each. The serial number on the page is that
    /// of one part.
    pub(super) fn keep(
        &self,
        first: RecordId,
        (records, labels): (&[Arc<Record>], &[Labels]),
        from: Option<&UsedFile>,
        shared: &mut Shared,
    ) {
        let mut named = self.named();
        if 1 < records.len() {
            named.serial.clear();
        }
        let gauge = self.gauge.as_ref().filter(|_| self.by == MeasureBy::Typing && from.is_none() && labels.is_empty());
        named.remark = measured_with(&named.remark, gauge, shared);
        let budget = shared.budget.as_deref().and_then(|open| used(FileRole::Budget, &open.file, open.sha256));
        let refused = shared.recording.keep_checks(first, records, labels, &named, |record| {
            let budget = budget.clone().filter(|_| record.budget.is_some());
            from.into_iter().cloned().chain(budget).collect()
        });
        if let Some((count, why)) = refused {
            shared.tell(message!("records-page-refused").count("count", count).message("why", why));
        }
    }

    /// Asks for what a record asked for: callout, part, serial number and rule. Its value is to be measured.
    fn ask_again(&mut self, record: &Record, part: &str, serial: &str, shared: &Shared) {
        // Limits that came without a callout are asked for anew.
        let callout = record.callout.map_or_else(String::new, |callout| callout.to_string());
        self.take_callout(&callout, &shared.sources);
        if self.asked.needs_feature() {
            self.mean(record.limits.feature);
        }
        let (judging, texts) = worth::of_record(record);
        self.judging = judging;
        for (field, text) in texts {
            self.texts.set(field, text);
        }
        self.texts.set(CheckField::Part, part);
        self.texts.set(CheckField::Serial, serial);
        self.texts.set(CheckField::Measured, "");
        self.gauge = None;
        self.measured_is_used = false;
        self.edited(&shared.sources);
    }

    /// What is highlighted beside a doubted text: what it probably means. Without that it stays as it is, and is asked about.
    fn take_text(&mut self, shared: &mut Shared, now: DateTime) {
        let Some(DoubtedText { field, meant: Some(meant), .. }) = self.doubted().cloned() else { return };
        // The same hole or shaft in the unit that was meant.
        let feature = self.feature().filter(|_| field == CheckField::Callout);
        self.type_text(field, shared.as_typed(&meant), &shared.sources);
        self.mean(feature);
        self.measure(shared, now);
    }

    fn keep_text(&mut self, shared: &mut Shared, now: DateTime) {
        let Some(doubted) = self.doubted().filter(|doubted| doubted.can_stay).cloned() else { return };
        self.meant.add(&doubted);
        self.edited(&shared.sources);
        self.measure(shared, now);
    }

    fn measure(&mut self, shared: &mut Shared, now: DateTime) {
        if self.doubted().is_some() {
            return self.take_text(shared, now);
        }
        // Nothing was entered since, and nobody has read the verdict: the button was pressed twice at once.
        if self.would_repeat() && self.judged.is_in_passing(now) {
            return self.say_repeated();
        }
        self.judged.ask(now);
        let asked_about = self.question.take();
        // Who only looked at a record judges by the own rule and names the own part; a simulation is that of the fields.
        self.own.retain(|field, _| !SIMULATION.contains(field));
        self.edited(&shared.sources);
        self.asks = self.asked.doubted.is_some();
        if self.asks {
            return;
        }
        let record = match measuring::measure(self, shared.budget.as_deref(), now) {
            Ok(record) => record,
            Err((CheckField::Measured, _)) if self.take_code(shared) => return,
            Err((field, problem)) => {
                // A typed value has its error beside it, in sight.
                self.refusal = Some(problem.clone()).filter(|_| self.by == MeasureBy::Simulating);
                if field == CheckField::Measured && self.text(field).trim().is_empty() {
                    // What is typed next is the value, and not the callout once more.
                    self.errands.push(Effect::Focus(field.into()));
                }
                return self.asked.refuse(field, problem);
            }
        };
        if self.by == MeasureBy::Typing
            && let Some(doubt) = record.doubt
        {
            // As it was typed.
            let question = Question { measured: record.measured(), doubt };
            if asked_about != Some(question) {
                self.question = Some(question);
                return;
            }
        }
        self.measured_is_used = self.by == MeasureBy::Typing;
        let record = Arc::new(record);
        let id = shared.history.add(vec![Arc::clone(&record)]);
        self.keep(id, (&[record], &[]), None, shared);
        if self.by == MeasureBy::Simulating {
            self.inputs.keep(id, &self.texts);
            if let Some(seed) = self.asked.seed {
                self.texts.set(CheckField::Seed, seed.wrapping_add(1).to_string());
            }
        } else {
            self.inputs.keep_typed(id, self.texts.text(CheckField::Measured));
        }
        self.show(id, shared);
    }

    /// Shows a record of the history; what made it stands in the fields.
    pub(super) fn show(&mut self, id: RecordId, shared: &mut Shared) {
        let Some(record) = shared.history.get(id) else { return };
        shared.history.go_to(id);
        self.show_record(record, Some(id), shared);
    }

    /// Shows a record, of the history or not; what made it stands in the fields.
    pub(super) fn show_record(&mut self, record: Arc<Record>, id: Option<RecordId>, shared: &Shared) {
        self.rows.iter_mut().for_each(Rows::hide);
        // The limits on screen follow the record, never the other way round.
        let lot = self.lot.take();
        match record.callout {
            Some(callout) if Some(callout) != self.part_callout() => {
                self.take_callout(&callout.to_string(), &shared.sources);
            }
            Some(_) => {}
            // A log carries limits and no callout: the one in the field would belong to others.
            None if self.text(CheckField::Callout).is_empty() => {}
            None => self.take_callout("", &shared.sources),
        }
        if record.callout.is_some_and(|callout| callout.feature().is_none()) {
            self.mean(record.limits.feature);
        }
        self.lot = lot;
        self.question = None;
        self.refusal = None;
        self.asks = false;
        self.is_repeated = false;
        self.show_inputs(id, &record, shared);
        self.lent = Some(Arc::clone(&record));
        self.read(&shared.sources);
        self.draw(record, id, shared);
    }

    /// Puts what a record was made with back into the fields: nothing else stands beside the verdict. The user's own
    /// texts come back with the next edit.
    fn show_inputs(&mut self, id: Option<RecordId>, record: &Record, shared: &Shared) {
        let budget = shared.budget.as_deref();
        self.take_back_own();
        let worth = RuleFields::read(&self.texts, self.judging, &mut |_, _| {});
        let mut inputs = self.inputs.of(id, record);
        if let Some(named) = id.and_then(|id| shared.recording.named_of(id)) {
            inputs.push((CheckField::Serial, named.serial.clone()));
            inputs.push((CheckField::Remark, named.remark.clone()));
        }
        if !worth.agrees(record, budget) {
            let (judging, texts) = worth::of_record(record);
            self.own_judging = Some(std::mem::replace(&mut self.judging, judging));
            inputs.extend(texts);
        }
        if !worth.agrees_on_temperature(record) {
            inputs.extend(worth::temperatures_of(record));
        }
        for (field, text) in inputs {
            if self.text(field).trim() != text {
                self.own.insert(field, self.text(field).to_owned());
                self.texts.set(field, text);
            }
        }
        let is_typed = record.measurement.origin == Origin::Typed;
        // As it was typed, not as it is at 20 °C.
        let diameter = record.measured();
        let measured = self.asked.length(CheckField::Measured).filter(|_| is_typed);
        if measured != Some(diameter) {
            let text = self.inputs.typed(id).map_or_else(|| shared.as_typed(&diameter.to_string()), str::to_owned);
            self.texts.set(CheckField::Measured, if is_typed { text } else { String::new() });
            self.gauge = None;
        }
        self.measured_is_used = is_typed;
    }

    fn draw(&mut self, record: Arc<Record>, id: Option<RecordId>, shared: &Shared) {
        let (language, mask) = shared.drawn_with();
        let window = status_window(&record, language, mask).map_err(|error| error.message());
        self.shown = Some(ShownCheck { record, id, window });
    }
}
