//! What a code reader types into the field of the value and is none: it goes where it belongs by its shape, and that is said.

use fitcheck_core::message::message;
use fitcheck_core::tolerance::Callout;

use super::{CheckField, CheckPage, MeasureBy};
use crate::effect::Effect;
use crate::shared::Shared;

impl CheckPage {
    /// A text in the field of the value that is a callout with a class that has limits, or begins with a letter and has a figure, as serial numbers do.
    /// Returns whether it was one.
    pub(super) fn take_code(&mut self, shared: &mut Shared) -> bool {
        let text = self.texts.text(CheckField::Measured).trim().to_owned();
        if self.by != MeasureBy::Typing {
            return false;
        }
        // A letter in the place of a figure makes a class that no table has.
        let is_known =
            |callout: Callout| callout.class().is_some() && shared.sources.limits(&callout, callout.feature()).is_ok();
        let taken = if text.parse().is_ok_and(is_known) {
            self.texts.set(CheckField::Measured, "");
            self.take_callout(&text, &shared.sources);
            message!("scanned-callout")
        } else if is_code(&text) {
            self.texts.set(CheckField::Measured, "");
            self.texts.set(CheckField::Serial, text.as_str());
            self.edited(&shared.sources);
            message!("scanned-serial")
        } else {
            return false;
        };
        shared.note(taken.text("given", text), Vec::new());
        self.errands.push(Effect::Focus(CheckField::Measured.into()));
        true
    }
}

/// Whether a text can only be a code: a letter first, a figure somewhere, and nothing between words.
fn is_code(text: &str) -> bool {
    let begins = text.starts_with(char::is_alphabetic);
    begins && text.contains(|c: char| c.is_ascii_digit()) && !text.contains(char::is_whitespace)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_code_begins_with_a_letter_and_a_mistyped_value_does_not() {
        for (text, expected) in
            [("A-0102", true), ("S0232", true), ("25.O12", false), ("25,012 mm", false), ("abc", false), ("-3", false)]
        {
            assert_eq!(is_code(text), expected, "{text}");
        }
    }
}
