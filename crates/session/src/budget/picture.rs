//! The shares of a budget as bars, and what would help most.

use fitcheck_core::budget::{Answer, Assessment, ContributionKind, Evaluation, Help, Repeated};
use fitcheck_core::message::{Message, message};

/// A bar of the picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Bar {
    pub name: Message,
    /// Its length as a part of the longest possible, 0 to 1.
    pub length: f64,
    /// How much it is.
    pub amount: Message,
}

/// The bars of an answer: the shares of contributions, largest first, or the terms of a calibrated piece in the order of
/// the standard.
pub fn bars(found: &Assessment) -> Vec<Bar> {
    match &found.answer {
        Answer::Combined(evaluation) => shares(evaluation),
        Answer::Repeated(repeated) => terms(repeated),
    }
}

fn shares(evaluation: &Evaluation) -> Vec<Bar> {
    let mut rows: Vec<_> = evaluation.rows.iter().collect();
    rows.sort_by(|one, other| other.share.total_cmp(&one.share));
    let bar = |(name, share): (&str, f64)| Bar {
        name: message!("budget-page-named").text("name", name),
        length: (share / 100.0).clamp(0.0, 1.0),
        amount: message!("budget-page-percent").number("percent", format!("{share:.1}")),
    };
    rows.into_iter().map(|row| bar((&row.name, row.share))).collect()
}

fn terms(repeated: &Repeated) -> Vec<Bar> {
    let terms = repeated.terms().map(|(name, um)| (message!("budget-page-named").text("name", name), um));
    let editions = [
        (message!("budget-page-edition-2011"), repeated.expanded_2011),
        (message!("budget-page-edition-2004"), repeated.expanded_2004),
    ];
    let all: Vec<(Message, f64)> = terms.into_iter().chain(editions).collect();
    let largest = all.iter().map(|(_, um)| um.abs()).fold(f64::MIN_POSITIVE, f64::max);
    let bar = |(name, um): (Message, f64)| Bar {
        name,
        length: (um.abs() / largest).clamp(0.0, 1.0),
        amount: message!("budget-page-um").number("um", format!("{um:.3}")),
    };
    all.into_iter().map(bar).collect()
}

/// What would make the uncertainty smaller, each with the u that it would give.
pub fn advice(evaluation: &Evaluation) -> Vec<Message> {
    let kind = evaluation.rows.get(evaluation.largest).map(|row| row.kind);
    let told = |help: &Help| {
        let um = |u: f64| format!("{u:.3}");
        match *help {
            Help::Halved { u } => Message::new(match kind {
                Some(ContributionKind::PartTemperature(_)) => "budget-page-help-part-temperature",
                Some(ContributionKind::ScaleTemperature(_)) => "budget-page-help-scale-temperature",
                Some(ContributionKind::PartExpansion(_) | ContributionKind::ScaleExpansion(_)) => {
                    "budget-page-help-expansion"
                }
                _ => "budget-page-help-halved",
            })
            .number("u", um(u)),
            Help::FullCircle { touches, u } => {
                message!("budget-page-help-full-circle").count("count", touches).number("u", um(u))
            }
            Help::MoreTouches { touches, u } => {
                message!("budget-page-help-more-touches").count("count", touches).number("u", um(u))
            }
        }
    };
    evaluation.help.iter().map(told).collect()
}
