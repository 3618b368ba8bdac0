//! What stays in force from block to block, as far as the text alone tells it.
//!
//! Blocks may be reached by jumps and calls. So behind a label, a call and a block that may be skipped, a mode counts as
//! known only where every way to the block leaves it the same; a block that would depend on an unknown mode is refused.

/// Whether coordinates count from the datum or from where the tool is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Measure {
    /// G90
    Absolute,
    /// G91
    Incremental,
}

/// The modes at a block; `None` where they are not known.
#[derive(Debug, Clone, Copy)]
pub(super) struct Modes {
    /// G90 or G91. That a program begins with either is on no page that we found.
    pub measure: Option<Measure>,
    /// The G function of the path.
    pub path: Option<u32>,
    /// Whether the program has G91 anywhere.
    has_incremental: bool,
}

impl Modes {
    /// Those at the beginning of a program.
    pub(super) fn new(text: &str) -> Self {
        Self { measure: None, path: None, has_incremental: mentions(text, "91") }
    }

    /// Behind a label, and behind a call of one.
    pub(super) const fn join(&mut self) {
        self.path = None;
        if self.has_incremental {
            self.measure = None;
        }
    }

    /// Behind a call of another program: it may leave any mode behind.
    pub(super) const fn forget(&mut self) {
        self.path = None;
        self.measure = None;
    }

    /// Behind a block that may have been skipped: what it has changed is not known.
    pub(super) fn skipped(&mut self, before: Self) {
        if before.measure != self.measure {
            self.measure = None;
        }
        if before.path != self.path {
            self.path = None;
        }
    }

    /// Behind a block that was not understood.
    pub(super) fn not_understood(&mut self, code: &str) {
        self.path = None;
        if mentions(code, "90") || mentions(code, "91") {
            self.measure = None;
        }
    }
}

/// Whether a G function occurs in a text, comments included.
fn mentions(text: &str, function: &str) -> bool {
    text.split(['G', 'g']).skip(1).any(|behind| {
        let digits = behind.trim_start().trim_start_matches('0');
        digits.strip_prefix(function).is_some_and(|rest| !rest.starts_with(|c: char| c.is_ascii_digit()))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn functions_are_found_in_a_text() {
        for text in ["G91", "N1 g 91 X5", "G090 G091*", "G00G91X"] {
            assert!(mentions(text, "91"), "{text}");
        }
        for text in ["G910", "G9", "91", "G90 X91", "G 9 1"] {
            assert!(!mentions(text, "91"), "{text}");
        }
    }
}
