//! Questions that Enter answers. A scanner or gauge that ends its line with two signs sends two of them: the second one is nobody's answer.

use jiff::civil::DateTime;

/// How long after a question an Enter is no answer to it, milliseconds.
const SOON: i64 = 500;

/// When something was asked last.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Asking(Option<DateTime>);

impl Asking {
    /// Something is asked now.
    pub fn ask(&mut self, now: DateTime) {
        self.0 = Some(now);
    }

    /// Whether an Enter comes in passing: sooner after a question than somebody can have read it. A clock that stands still says nothing
    /// of that.
    pub fn is_in_passing(&mut self, now: DateTime) -> bool {
        let is_later = self.0.is_some_and(|asked| asked < now);
        is_later && !self.is_answered(now)
    }

    /// Whether somebody answers now. An Enter that comes too soon begins the wait anew: a key that is held answers nothing.
    pub fn is_answered(&mut self, now: DateTime) -> bool {
        let since = self.0.map_or(SOON, |asked| i64::try_from(now.duration_since(asked).as_millis()).unwrap_or(SOON));
        // A clock that was set back does not keep anybody waiting.
        let is_soon = (0..SOON).contains(&since);
        if is_soon {
            self.ask(now);
        }
        !is_soon
    }
}

#[cfg(test)]
mod tests {
    use jiff::ToSpan as _;

    use super::*;

    #[test]
    fn an_enter_answers_after_half_a_second_without_one() {
        let asked = jiff::civil::date(2026, 11, 24).at(10, 42, 7, 0);
        let after = |milliseconds: i64| asked.checked_add(milliseconds.milliseconds()).unwrap();
        let mut asking = Asking::default();
        asking.ask(asked);
        assert!(!asking.is_answered(asked));
        assert!(!asking.is_answered(after(499)));
        assert!(!asking.is_answered(after(998)), "it was held");
        assert!(asking.is_answered(after(1498)));
        assert!(asking.is_answered(after(-3_600_000)), "the clock was set back");
        asking.ask(asked);
        assert!(
            asking.is_in_passing(after(1)) && asking.is_in_passing(after(400)) && !asking.is_in_passing(after(901))
        );
    }
}
