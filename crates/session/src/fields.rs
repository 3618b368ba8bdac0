//! What a session knows of its text fields, by their table: which there are, where they stand, what they are called, and what helps.

use fitcheck_core::message::message;
use fitcheck_core::probing::cycle::{Axis as PlaneAxis, Cycle, Key, Meaning, Range};
use fitcheck_core::probing::cycles::measuring;
use fitcheck_core::tolerance::Feature;
use fitcheck_core::words::Words;

use super::budget::BudgetField;
use super::check::CheckField;
use super::cycles::{CycleField, fold_of};
use super::field::Field;
use super::field_table::{AT_TIMES, FieldPlace, PAGE, Rows, all};
use super::help::HelpPlace;
use super::program::{Input, ProgramField};
use super::records::RecordsField;
use super::statistics::StatisticsField;
use super::{Session, treated};

/// The drawing of a field: a parameter of a cycle that means the same.
pub type FieldDrawing = (&'static Cycle, Key);

impl Session {
    /// Every text field, with those of the parameters of the chosen cycle.
    pub fn fields(&self) -> Vec<Field> {
        all(self.cycles.cycle)
    }

    /// Where a field stands on its page.
    pub fn place_of(&self, field: Field) -> FieldPlace {
        match field {
            Field::Cycles(CycleField::Parameter(key)) => fold_of(self.cycles.cycle, key).map_or(PAGE, FieldPlace::Fold),
            field => field.row().map_or(AT_TIMES, |row| row.place),
        }
    }

    /// Whether a field stands on its page now, so that it can be gone to.
    pub fn stands(&self, field: Field) -> bool {
        match field {
            Field::Check(CheckField::HistoryFilter) => !self.history().is_empty(),
            Field::Records(RecordsField::Question)
            | Field::Statistics(StatisticsField::Question | StatisticsField::Last) => self.recording().is_on(),
            Field::Budget(BudgetField::Size) => self.budget.read.is_some() && self.budget.asks.size,
            Field::Budget(BudgetField::Day) => self.budget.read.is_some(),
            // One of a few numbers is chosen from a list, and what has no effect is folded away.
            Field::Cycles(CycleField::Parameter(key)) => self
                .cycles
                .cycle
                .parameter(key)
                .is_some_and(|parameter| parameter.has_effect && !matches!(parameter.range, Range::OneOf(_))),
            field => self.place_of(field) != AT_TIMES,
        }
    }

    /// The paragraph of the manual about a field.
    pub fn help_of(&self, field: Field) -> HelpPlace {
        field.help(self.cycles.cycle)
    }

    /// What F1 opens in a field: the heading of the manual that treats it.
    pub fn treated_in(&self, field: Field) -> HelpPlace {
        treated::of_field(field).unwrap_or_else(|| self.help_of(field))
    }

    /// What F1 opens in a part of a page that folds away, by its name.
    pub fn fold_treated_in(name: &str) -> Option<HelpPlace> {
        treated::of_fold(name)
    }

    /// What a field is called, in the words of a language.
    pub fn field_name(&self, field: Field, words: &Words) -> String {
        match field {
            Field::Cycles(CycleField::Parameter(key) | CycleField::Global(key)) => {
                let parameter = self.cycles.cycle.parameter(key);
                let question = parameter.map(|parameter| parameter.question(words.language().dialogue()));
                format!("{key}  {}", question.unwrap_or_default())
            }
            Field::Cycles(CycleField::Position(axis)) => {
                format!("{} {}", words.get("cycles-ball-stands"), axis.letter())
            }
            Field::Program(ProgramField::Tool(parameter)) => {
                words.say(&message!("tools-input").text("parameter", parameter))
            }
            Field::Program(ProgramField::Input(input)) => {
                format!("{} {}", input.parameter(), words.get(Rows::row(input).name))
            }
            field => words.get(field.row().map_or("parts-page-cell-name", |row| row.name)),
        }
    }

    /// The drawing that shows what a field means; of cycle 421 where the field sets a parameter of it.
    pub fn drawing_of(&self, field: Field) -> Option<FieldDrawing> {
        let of_hole = |meaning| {
            let cycle = measuring(Feature::Hole);
            Some((cycle, cycle.meant(meaning)?.key))
        };
        match field {
            Field::Cycles(CycleField::Parameter(key) | CycleField::Global(key)) => Some((self.cycles.cycle, key)),
            Field::Check(CheckField::CentreX) | Field::Program(ProgramField::Input(Input::CentreX)) => {
                of_hole(Meaning::Centre(PlaneAxis::First))
            }
            Field::Check(CheckField::CentreY) | Field::Program(ProgramField::Input(Input::CentreY)) => {
                of_hole(Meaning::Centre(PlaneAxis::Second))
            }
            Field::Check(CheckField::Height) | Field::Program(ProgramField::Input(Input::Height)) => {
                of_hole(Meaning::MeasuringHeight)
            }
            Field::Check(CheckField::FirstAngle) | Field::Program(ProgramField::Input(Input::Angle)) => {
                of_hole(Meaning::FirstAngle)
            }
            Field::Check(CheckField::Clearance) | Field::Program(ProgramField::Input(Input::Clearance)) => {
                of_hole(Meaning::SetUpClearance)
            }
            Field::Check(CheckField::CentreTolerance) => of_hole(Meaning::CentreTolerance(PlaneAxis::First)),
            Field::Check(CheckField::Nominal) | Field::Program(ProgramField::Input(Input::Size)) => {
                of_hole(Meaning::Diameter)
            }
            _ => None,
        }
    }
}
