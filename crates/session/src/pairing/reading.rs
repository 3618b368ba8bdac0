//! What the fields of the pairing page mean.

use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_core::pairing::{MOST_GROUPS, PairClearances, PairingError};
use fitcheck_core::tolerance::fit::Fit;
use fitcheck_core::tolerance::{Callout, Sources};

use super::paired::middle_um;
use super::{PairingField, PairingPage};
use crate::state::PageState as _;
use crate::texts::whole;

/// What the wanted clearances are, and the fit that they are of.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct WantedOf {
    pub wanted: PairClearances,
    pub fit: Option<(Callout, Fit)>,
}

impl PairingPage {
    /// Reads the fields anew.
    pub(super) fn read(&mut self, sources: &Sources) {
        self.errors.clear();
        self.wanted = match wanted(self.text(PairingField::Wanted), sources).transpose() {
            Ok(wanted) => wanted,
            Err(problem) => self.refuse(PairingField::Wanted, problem),
        };
        self.group_count = match group_count(self.text(PairingField::Groups)).transpose() {
            Ok(count) => count,
            Err(problem) => self.refuse(PairingField::Groups, problem),
        };
    }

    fn refuse<T>(&mut self, field: PairingField, problem: Message) -> Option<T> {
        self.errors.insert(field, problem);
        None
    }

    /// What the field of the wanted clearances was understood as.
    pub fn understood(&self) -> Option<Message> {
        let WantedOf { wanted, fit } = self.wanted.as_ref()?;
        let id = if fit.is_some() { "pairing-page-wanted-fit" } else { "pairing-page-wanted-range" };
        let message = match fit {
            Some((callout, _)) => Message::new(id).text("fit", callout),
            None => Message::new(id),
        };
        let um = |um: String| fitcheck_core::message::Arg::Number(um);
        Some(
            message
                .with("minimum", &um(wanted.minimum().signed_um()))
                .with("maximum", &um(wanted.maximum().signed_um()))
                .with("middle", &um(middle_um(*wanted))),
        )
    }
}

/// The wanted clearances of a text; `None` without one. Two points are in no callout.
fn wanted(text: &str, sources: &Sources) -> Option<Result<WantedOf, Message>> {
    let text = text.trim();
    if text.is_empty() {
        return None;
    }
    if text.contains("..") {
        let wanted = text.parse::<PairClearances>().map_err(|error| error.message());
        return Some(wanted.map(|wanted| WantedOf { wanted, fit: None }));
    }
    Some(of_fit(text, sources).map_err(|reason| message!("pairing-page-wanted-refused").message("reason", reason)))
}

fn of_fit(text: &str, sources: &Sources) -> Result<WantedOf, Message> {
    let callout: Callout = text.parse().map_err(|error: fitcheck_core::tolerance::CalloutError| error.message())?;
    let fit = Fit::of_callout(&callout, sources).map_err(|error| error.message())?;
    let wanted =
        PairClearances::new(fit.minimum_clearance(), fit.maximum_clearance()).map_err(|error| error.message())?;
    Ok(WantedOf { wanted, fit: Some((callout, fit)) })
}

/// The number of groups; `None` where none are asked for.
fn group_count(text: &str) -> Option<Result<usize, Message>> {
    if text.trim().is_empty() {
        return None;
    }
    let in_range = |count: &usize| (1..=MOST_GROUPS).contains(count);
    let refused = |count| PairingError::GroupCount { count }.message();
    Some(whole(text).and_then(|count| Some(count).filter(in_range).ok_or_else(|| refused(count))))
}
