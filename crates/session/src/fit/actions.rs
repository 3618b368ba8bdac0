//! What can be done on the fit page.

use fitcheck_core::tolerance::Feature;

use super::FitCommand;
use crate::Session;
use crate::action::Part;
use crate::action::row::{ActionRow, Actions, actions, keys, on, within};
use crate::page::Page;
use crate::step::Step;

/// The map of classes.
pub const CLASSES: Part = Part::cells(Page::Fit, "fit-map");

actions! {
    /// What can be done on the fit page.
    FitAction

    /// Goes to another class of the map.
    MoveClass(Step): Step::CLASSES;
    /// Shows the map of hole classes or of shaft classes.
    ShowClasses(Feature): [Feature::Hole, Feature::Shaft];
    /// Takes one side of the fit to the check page.
    CheckPart(Feature): [Feature::Hole, Feature::Shaft];
}

impl Actions for FitAction {
    fn row(&self) -> ActionRow {
        match *self {
            Self::MoveClass(step) => within(CLASSES, "fit-move", FitCommand::Move(step)).key(keys(step)),
            Self::ShowClasses(feature) => {
                let text = match feature {
                    Feature::Hole => "classes-hole",
                    Feature::Shaft => "classes-shaft",
                };
                on(Page::Fit, text, FitCommand::ShowClasses(feature))
            }
            Self::CheckPart(part) => {
                let (text, possible): (_, fn(&Session) -> bool) = match part {
                    Feature::Hole => ("fit-check-hole", |session| session.fit().class(Feature::Hole).is_some()),
                    Feature::Shaft => ("fit-check-shaft", |session| session.fit().class(Feature::Shaft).is_some()),
                };
                on(Page::Fit, text, FitCommand::Check(part)).when(possible)
            }
        }
    }

    fn is_on(&self, session: &Session) -> Option<bool> {
        match *self {
            Self::ShowClasses(feature) => Some(session.fit().side() == feature),
            _ => None,
        }
    }
}
