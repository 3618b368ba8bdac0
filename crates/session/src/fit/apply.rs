//! How commands and news change the fit page.

use std::ops::Range;

use fitcheck_core::message::Message;
use fitcheck_core::tolerance::{Feature, ToleranceClass};
use jiff::civil::DateTime;

use super::{FitCommand, FitField, FitPage};
use crate::Step;
use crate::check::nominal_text;
use crate::effect::Effect;
use crate::page::Page;
use crate::saved::Saved;
use crate::shared::{News, Shared};
use crate::state::PageState;
use crate::texts::Texts;

impl PageState for FitPage {
    type Command = FitCommand;
    type Field = FitField;

    fn restored(saved: &Saved, shared: &Shared) -> Self {
        let mut page = Self { texts: Texts::restored(&saved.inputs.texts), ..Self::default() };
        page.read(&shared.sources);
        page
    }

    fn save(&self, saved: &mut Saved) {
        saved.inputs.texts.extend(self.texts.saved());
    }

    fn apply(&mut self, command: FitCommand, shared: &mut Shared, _now: DateTime) -> Vec<Effect> {
        match command {
            FitCommand::Type(field, text) => self.texts.set(field, text),
            FitCommand::TakePair(hole, shaft) => self.put_classes(&format!("{hole}/{shaft}")),
            FitCommand::ChooseClass(class) => self.choose_class(class),
            FitCommand::Move(direction) => {
                if let Some(class) = self.neighbour(direction) {
                    self.choose_class(class);
                }
            }
            FitCommand::ShowClasses(side) => self.side = Some(side),
            FitCommand::ChooseExpansion(part, expansion) => {
                self.texts.set(FitField::expansion(part), shared.as_typed(&expansion.to_string()));
            }
            FitCommand::SearchAmong(scope) => self.scope = scope,
            FitCommand::Check(part) => self.check_part(part, shared),
        }
        self.read(&shared.sources);
        Vec::new()
    }

    fn follow(&mut self, news: &News, shared: &mut Shared) {
        if *news == News::Sources {
            self.read(&shared.sources);
        }
    }

    fn text(&self, field: FitField) -> &str {
        self.texts.text(field)
    }

    fn error(&self, field: FitField) -> Option<&Message> {
        self.errors.get(&field)
    }

    fn culprit(&self, field: FitField) -> Option<&Range<usize>> {
        self.culprit.as_ref().filter(|_| field == FitField::Callout)
    }
}

impl FitPage {
    /// The callout with other classes; the nominal size stays.
    fn with_nominal(&self, classes: &str) -> String {
        format!("{} {classes}", nominal_text(self.text(FitField::Callout))).trim().to_owned()
    }

    fn put_classes(&mut self, classes: &str) {
        let callout = self.with_nominal(classes);
        self.texts.set(FitField::Callout, callout);
    }

    fn choose_class(&mut self, class: ToleranceClass) {
        self.put_class(class);
        let classes = [self.hole, self.shaft];
        let classes: Vec<&str> = classes.iter().flatten().map(ToleranceClass::as_str).collect();
        self.put_classes(&classes.join("/"));
    }

    /// The class beside the chosen one in the map that is shown; where none is chosen, the one to begin with.
    fn neighbour(&self, step: Step) -> Option<ToleranceClass> {
        let map = self.map(self.side())?;
        match self.class(self.side()).filter(|class| map.has(*class)) {
            Some(class) => map.next(class, step),
            None => map.first(),
        }
    }

    /// Takes one side of the fit to the check page.
    fn check_part(&self, part: Feature, shared: &mut Shared) {
        let Some(class) = self.class(part) else { return };
        shared.spread(News::Check(self.with_nominal(class.as_str())));
        shared.open(Page::Check);
    }
}
