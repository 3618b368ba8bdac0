//! What the rows of a file ask again and again: a callout is read once, and limits are looked up once for each class and size step.

use std::cell::{OnceCell, RefCell};
use std::collections::HashMap;

use fitcheck_core::length::Length;
use fitcheck_core::tolerance::{
    Callout, CalloutError, Deviations, Limits, LimitsError, Source, Sources, Tolerance, ToleranceClass,
};

/// The most texts and the most classes in a step that are remembered; others are read each time.
const MOST: usize = 4_096;

/// What one file has asked so far. What could not be read or has no limits is asked anew each time: its rows are refused anyway.
#[derive(Debug, Clone, Default)]
pub(super) struct Lookup {
    callouts: RefCell<HashMap<Box<str>, Callout>>,
    /// The ends of the size steps: within one of them no class has another answer.
    ends: OnceCell<Vec<Length>>,
    found: RefCell<HashMap<(ToleranceClass, usize), (Deviations, Source)>>,
}

impl Lookup {
    pub(super) fn callout(&self, text: &str) -> Result<Callout, CalloutError> {
        if let Some(callout) = self.callouts.borrow().get(text) {
            return Ok(*callout);
        }
        let callout = text.parse()?;
        let mut callouts = self.callouts.borrow_mut();
        if callouts.len() < MOST {
            callouts.insert(text.into(), callout);
        }
        Ok(callout)
    }

    /// The limits of a callout, as the sources say; a file always asks the same ones.
    pub(super) fn limits(&self, callout: &Callout, sources: &Sources) -> Result<Limits, LimitsError> {
        let Tolerance::Class(class) = callout.tolerance() else { return sources.limits(callout, None) };
        let nominal = callout.nominal();
        let ends = self.ends.get_or_init(|| sources.step_ends());
        let step = ends.partition_point(|end| *end < nominal);
        if let Some((deviations, source)) = self.found.borrow().get(&(class, step)) {
            let limits = Limits::new(class.feature(), nominal, *deviations, source.clone());
            let limits = limits.ok_or(LimitsError::TooLarge { nominal })?;
            // Within a step a zone is as wide everywhere; whether it reaches to zero depends on the size.
            if Length::ZERO < limits.minimum() {
                return Ok(limits);
            }
        }
        let limits = sources.limits(callout, None)?;
        let mut found = self.found.borrow_mut();
        if step < ends.len() && found.len() < MOST {
            found.insert((class, step), (limits.deviations, limits.source.clone()));
        }
        Ok(limits)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use fitcheck_core::tolerance::Feature;

    proptest! {
        /// Whatever was asked before, the answer is that of the sources, with where it comes from.
        #[test]
        fn what_is_remembered_is_what_the_sources_say(
            asked in proptest::collection::vec((0_usize..400, 1_i64..3_200_000_000), 1..60),
            is_control in any::<bool>(),
        ) {
            let sources = if is_control { Sources::of_tables(fitcheck_nc::control::deviations::shipped_tables()) } else { Sources::default() };
            let classes: Vec<ToleranceClass> =
                [Feature::Hole, Feature::Shaft].into_iter().flat_map(|feature| sources.classes(feature)).collect();
            let lookup = Lookup::default();
            for (class, nm) in asked {
                let class = classes[class % classes.len()];
                let Ok(callout) = Callout::new(Length::from_nanometres(nm).unwrap(), class) else { continue };
                prop_assert_eq!(lookup.limits(&callout, &sources), sources.limits(&callout, None));
                let text = callout.to_string();
                prop_assert_eq!(lookup.callout(&text), text.parse());
                prop_assert_eq!(lookup.callout(&text), text.parse());
            }
        }
    }
}
