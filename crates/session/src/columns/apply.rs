//! Doing what can be done with the columns of a file.

use std::sync::Arc;

use fitcheck_core::message::message;
use fitcheck_core::part::Plan;
use fitcheck_exchange::exchange::Mapping;
use jiff::civil::DateTime;

use super::{ColumnsCommand, ColumnsRequest, NoticeColumns, OpenColumns};
use crate::Session;
use crate::effect::Effect;
use crate::purpose::{ImportInto, Purpose};
use crate::shared::News;

impl Session {
    /// Does something about the columns of a file.
    pub(crate) fn apply_columns(&mut self, command: ColumnsCommand, now: DateTime) -> Vec<Effect> {
        match command {
            ColumnsCommand::Ask(asked) => self.ask_for_columns(*asked, now),
            ColumnsCommand::Used(used) => self.shared.columns.used = Some(*used),
            ColumnsCommand::UnitLess(file) => self.shared.columns.unit_less = Some(*file),
            ColumnsCommand::In(unit) => {
                let of_notice = self.shared.notices.shown().and_then(|notice| notice.columns.clone());
                let Some(NoticeColumns { path, into, .. }) = of_notice else { return Vec::new() };
                self.shared.notices.close();
                return vec![Effect::ReadColumns { into, path, mapping: Box::new(Mapping::of_unit(unit)) }];
            }
            ColumnsCommand::Choose(choice) => {
                let plan = self.plan_of_columns();
                let sources = Arc::clone(&self.shared.sources);
                if let Some(open) = self.shared.columns.open.front_mut() {
                    open.choose(choice);
                    open.look(&sources, plan.as_deref(), now);
                }
            }
            ColumnsCommand::Take => return self.take_columns(now),
            ColumnsCommand::Leave => _ = self.shared.columns.open.pop_front(),
            ColumnsCommand::Correct => {
                let of_notice = self.shared.notices.shown().and_then(|notice| notice.columns.clone());
                let read = of_notice.map(|columns| Effect::Read(Purpose::AskColumns(columns.into), columns.path));
                return read.into_iter().collect();
            }
            ColumnsCommand::Forget => {
                let Some(notice) = self.shared.notices.shown_mut() else { return Vec::new() };
                let shape = notice.columns.as_mut().and_then(|columns| columns.shape.take());
                if shape.is_some_and(|shape| Arc::make_mut(&mut self.shared.columns.remembered).forget(&shape)) {
                    notice.details.insert(0, message!("columns-page-forgotten"));
                    self.shared.spread(News::Columns);
                }
            }
        }
        Vec::new()
    }

    /// The plan that the values of the shown file are judged by.
    fn plan_of_columns(&self) -> Option<Arc<Plan>> {
        let into = self.shared.columns.open().map(|open| open.asked.into);
        self.plan_for(into?)
    }

    fn plan_for(&self, into: ImportInto) -> Option<Arc<Plan>> {
        match into {
            ImportInto::History | ImportInto::Study => None,
            ImportInto::Part(run) => {
                let walking = &self.parts.walking;
                walking.plan.as_ref().filter(|_| run == walking.run).map(Arc::clone)
            }
        }
    }

    fn ask_for_columns(&mut self, asked: ColumnsRequest, now: DateTime) {
        let Some(asked) = self.shared.file_answered(Ok(asked)) else { return };
        let plan = self.plan_for(asked.into);
        if matches!(asked.into, ImportInto::Part(_)) && plan.is_none() {
            return self.shared.tell(message!("walk-page-import-late").text("name", &asked.name));
        }
        // Asked about a second time, a file begins anew.
        self.shared.columns.open.retain(|open| open.asked.path != asked.path);
        let open = OpenColumns::new(asked, &self.shared.sources, plan.as_deref(), now);
        self.shared.columns.open.push_back(open);
    }

    /// Reads the shown file with what is chosen, which is remembered for files of its shape.
    fn take_columns(&mut self, now: DateTime) -> Vec<Effect> {
        let columns = &mut self.shared.columns;
        let Some(open) = columns.open.pop_front_if(|open| open.refusal.is_none()) else { return Vec::new() };
        if let Some(kept) = open.kept(now) {
            Arc::make_mut(&mut columns.remembered).keep(kept);
            self.shared.spread(News::Columns);
        }
        let mapping = Box::new(open.mapping());
        let asked = open.asked;
        vec![Effect::ReadColumns { into: asked.into, path: asked.path.clone(), mapping }]
    }
}

impl Session {
    /// The file whose columns are shown.
    pub fn open_columns(&self) -> Option<&OpenColumns> {
        self.shared.columns.open()
    }

    /// What is remembered of the columns of files.
    pub const fn remembered_columns(&self) -> &Arc<fitcheck_exchange::exchange::Remembered> {
        &self.shared.columns.remembered
    }
}
