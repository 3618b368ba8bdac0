//! Whether a value that was recorded is one of a size as the plan asks for it today: the file of the plan may have changed since.

use std::collections::BTreeMap;

use fitcheck_core::length::Length;
use fitcheck_core::message::{Message, message};
use fitcheck_core::part::{Plan, Size};
use fitcheck_exchange::journal::Record;
use fitcheck_exchange::journal::chain::Hash;

/// Which plan a part is measured by, as far as it is known after a restart.
#[derive(Debug, Clone, Default)]
pub(super) struct Planned {
    /// A hash of the sizes in their order.
    pub sizes: String,
    /// The newest record of the journal when the part was measured by them for the first time.
    pub since: u64,
}

impl Planned {
    /// A plan that counts from a record on.
    pub fn of(plan: &Plan, since: u64) -> Self {
        use std::fmt::Write as _;
        let mut text = String::new();
        for size in plan.sizes() {
            let limits = size.limits;
            let axes = size.feature.axes;
            // A text takes whatever is written to it.
            _ = writeln!(text, "{}|{}|{}|{axes:?}", size.name(), limits.minimum(), limits.maximum());
        }
        Self { sizes: Hash::of_file(text.as_bytes()).to_string(), since }
    }
}

/// The sizes of a plan by their names.
pub(super) struct Sizes<'a>(BTreeMap<String, SizePlace<'a>>);

/// A size, its place, and whether it is called by its place alone: then a row above it gives its name to another one.
struct SizePlace<'a> {
    at: usize,
    size: Size<'a>,
    has_name: bool,
}

/// Why a value is not one of a size of today.
pub(super) enum Away {
    /// The plan has no such size.
    Gone,
    /// It has other limits, or another rule.
    Changed(Message),
}

impl<'a> Sizes<'a> {
    pub fn of(plan: &'a Plan) -> Self {
        let sizes = plan.features().iter().enumerate().flat_map(|(row, feature)| {
            let has_name = feature.name != format!("F{}", row + 1);
            feature.sizes().map(move |size| (size, has_name))
        });
        Self((0..).zip(sizes).map(|(at, (size, has_name))| (size.name(), SizePlace { at, size, has_name })).collect())
    }

    /// The place of the size that a value is of; `is_before` is whether it was recorded before the plan was changed.
    pub fn place(&self, name: &str, record: &Record, is_before: bool) -> Result<usize, Away> {
        let SizePlace { at, size, has_name } = self.0.get(name).ok_or(Away::Gone)?;
        let limits = |record: &Record| (record.limits.feature, record.limits.minimum(), record.limits.maximum());
        let is_same = record.callout == size.callout
            && record.limits.nominal == size.limits.nominal
            && limits(record) == (size.limits.feature, size.limits.minimum(), size.limits.maximum())
            && size.feature.rule.is_none_or(|rule| rule == record.verdict.rule);
        if is_same && (*has_name || !is_before) { Ok(*at) } else { Err(Away::Changed(changed(name, record))) }
    }

    /// The place of a size, where its name is still the name of the same one.
    pub fn named(&self, name: &str, is_before: bool) -> Option<usize> {
        self.0.get(name).filter(|planned| planned.has_name || !is_before).map(|planned| planned.at)
    }
}

/// The value and what it was judged by.
fn changed(name: &str, record: &Record) -> Message {
    let measured: Length = record.measurement.diameter;
    let limits = || format!("{} – {}", record.limits.minimum(), record.limits.maximum());
    let asked = record.callout.map_or_else(limits, |callout| callout.to_string());
    message!("walk-page-changed-size").text("name", name).text("asked", asked).text("measured", measured)
}
