//! What TOOL CALL says besides the tool's axis: which tool it is, what it adds to the tool's measures, and words that it does not
//! have.

use super::remark::Remark;

/// What a TOOL CALL names.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Named {
    Tool,
    /// Tool 0: the spindle is empty then (nc-programs, section 1).
    Empty,
    /// Nothing: only speed, feed or axis change.
    Nothing,
}

/// The tool in the spindle, as far as the TOOL CALLs have said.
#[derive(Debug, Default)]
pub(super) struct Called {
    named: Option<Named>,
    /// What the last TOOL CALL adds to the tool's length or radius, as written.
    offsets: Option<String>,
}

impl Called {
    /// A TOOL CALL; `rest` is what stands behind the tool and its axis.
    pub(super) fn call(&mut self, named: Named, rest: &str) {
        let offsets = offsets(rest);
        if named == Named::Nothing {
            self.named.get_or_insert(named);
            self.offsets = offsets.or(self.offsets.take());
        } else {
            self.named = Some(named);
            self.offsets = offsets;
        }
    }

    /// What is odd about measuring with it.
    pub(super) fn odd(&self) -> impl Iterator<Item = Remark> {
        let tool = match self.named {
            Some(Named::Empty) => Some(Remark::EmptySpindle),
            Some(Named::Nothing) => Some(Remark::NoToolNamed),
            Some(Named::Tool) | None => None,
        };
        let offsets = self.offsets.clone().map(|offsets| Remark::ToolOffsets { offsets });
        tool.into_iter().chain(offsets)
    }
}

/// The words that add to the tool's length or radius: `DL+0.1`, `DR2-Q5`; not where they add zero.
fn offsets(rest: &str) -> Option<String> {
    let is_offset = |word: &&str| {
        let upper = word.to_ascii_uppercase();
        let value = upper.strip_prefix("DL").or_else(|| upper.strip_prefix("DR2")).or_else(|| upper.strip_prefix("DR"));
        value.is_some_and(|value| {
            let value = value.trim_start_matches(['=', '+', '-']).replace(',', ".");
            !value.parse::<f64>().is_ok_and(|value| value.abs() <= 0.0)
        })
    };
    listed(rest.split_ascii_whitespace().filter(is_offset))
}

/// The words that no TOOL CALL of a milling control has, such as `M3` and `X+100`: S, F, DL, DR and DR2 are known, and an axis.
pub(super) fn unknown_words(rest: &str) -> Option<String> {
    let is_value = |text: &str| {
        let begins = text.chars().next().is_none_or(|c| c.is_ascii_digit() || "+-=.,Q".contains(c));
        // Words may stand without a blank between: S2500F350.
        begins && text.chars().all(|c| c.is_ascii_digit() || "+-=.,QLRSFD".contains(c))
    };
    let is_known = |word: &str| {
        let upper = word.to_ascii_uppercase();
        let value = ["DR2", "DR", "DL", "S", "F"].into_iter().find_map(|letters| upper.strip_prefix(letters));
        let is_axis = matches!(upper.as_str(), "X" | "Y" | "Z" | "U" | "V" | "W");
        is_axis || is_value(value.unwrap_or(&upper))
    };
    listed(rest.split_ascii_whitespace().filter(|word| !is_known(word)))
}

fn listed<'a>(words: impl Iterator<Item = &'a str>) -> Option<String> {
    let words: Vec<&str> = words.collect();
    (!words.is_empty()).then(|| words.join(" "))
}
