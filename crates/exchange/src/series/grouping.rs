//! What makes a subgroup: so many values, one part, one batch, or values without a long pause between them.

use std::ops::Range;

use fitcheck_statistics::Reason;

use super::{Factor, Value};

/// What makes a subgroup.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Grouping {
    /// Each value is one.
    #[default]
    Single,
    /// So many values in a row.
    Of(usize),
    /// The values in a row that have this in common.
    By(Factor),
    /// The values in a row of which none was measured more than so many minutes after, or before, the last one.
    Pause(u32),
}

impl Grouping {
    /// The subgroups of values, by their places.
    ///
    /// # Errors
    /// Values that do not say what groups are made of.
    pub fn groups(self, values: &[&Value]) -> Result<Vec<Range<usize>>, Reason> {
        let in_rows = |size: usize| (0..values.len()).step_by(size).map(|at| at..values.len().min(at + size)).collect();
        let lacks = |value: &&&Value| match self {
            Self::Single | Self::Of(_) => false,
            Self::By(factor) => factor.of(&value.origin).is_empty(),
            Self::Pause(_) => value.origin.time.is_none(),
        };
        match values.iter().filter(lacks).count() {
            0 => Ok(match self {
                Self::Single => in_rows(1),
                Self::Of(size) => in_rows(size.max(1)),
                Self::By(factor) => places(values, |one, other| factor.of(&one.origin) == factor.of(&other.origin)),
                Self::Pause(minutes) => places(values, |one, other| !is_pause(one, other, minutes)),
            }),
            count => Err(Reason::Ungrouped { count }),
        }
    }

    /// How many of these values make whole subgroups: the newest one is whole where its size says so, or another one follows it.
    pub(super) fn whole(self, groups: &[Range<usize>]) -> usize {
        let last = groups.last().cloned().unwrap_or_default();
        let is_whole = match self {
            Self::Single => true,
            Self::Of(size) => last.len() == size.max(1),
            Self::By(_) | Self::Pause(_) => false,
        };
        if is_whole { last.end } else { last.start }
    }
}

/// The stretches of values of which each one goes with the one before it.
fn places(values: &[&Value], goes_with: impl Fn(&Value, &Value) -> bool) -> Vec<Range<usize>> {
    let mut start = 0;
    let stretches = values.chunk_by(|one, other| goes_with(one, other)).map(|stretch| {
        let place = start..start + stretch.len();
        start = place.end;
        place
    });
    stretches.collect()
}

fn is_pause(one: &Value, other: &Value, minutes: u32) -> bool {
    let passed = one.origin.time.zip(other.origin.time).map(|(one, other)| one.duration_until(other));
    passed.is_some_and(|passed| i64::from(minutes) * 60 < passed.as_secs().abs())
}
