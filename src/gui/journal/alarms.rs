//! Rules of control charts that fire at the newest values, and the alarms that nobody has answered: read and computed on a thread of their
//! own, a few hundred values for each value that came.

use std::path::Path;

use super::{Journals, ReadError, Reads};
use crate::journal::Alarm;
use crate::journal::ask::{AskedKinds, Question};
use crate::message::{Message, Say as _, message};
use crate::series::{FiredAlarm, Gathering, Look};
use crate::session::parts::{AlarmSearch, AlarmsFound, NewestValue};
use crate::statistics::Reason;

/// So many open alarms are shown, the newest of them.
const MOST_OPEN: usize = 200;

/// So many alarms of a feature are known, the newest of them: an older pattern does not reach to the newest value.
const MOST_KNOWN: usize = 1_000;

/// So many entries are read for a value that counts: others are withdrawn, corrected or in doubt.
const READ_FOR_ONE: usize = 2;

/// Looks for what fires, and for what is open.
pub(super) fn find(search: &AlarmSearch, journals: &dyn Journals, file: Option<&Path>) -> Result<AlarmsFound, Message> {
    let file = file.ok_or_else(|| message!("records-page-none"))?;
    let reader = journals.reader(file)?;
    look(search, reader.as_ref()).map_err(|error| match error {
        ReadError::Failed(why) => why,
        ReadError::Interrupted => message!("records-page-interrupted"),
    })
}

fn look(search: &AlarmSearch, reader: &dyn Reads) -> Result<AlarmsFound, ReadError> {
    let mut found = AlarmsFound::default();
    for value in &search.newest {
        match fired(search, value, reader)? {
            Ok(fired) => found
                .fired
                .extend(fired.into_iter().map(|(serial, alarm)| (NewestValue { serial, ..value.clone() }, alarm))),
            Err(why) => found.unchecked.push((value.clone(), why.message())),
        }
    }
    let open = Question { kinds: AskedKinds::Alarms, standing: true, ..Question::default() };
    let mut numbers = reader.numbers(&open, None, MOST_OPEN)?;
    numbers.sort_unstable();
    found.open = reader.rows(&numbers)?;
    Ok(found)
}

/// What fires at a value.
fn fired(
    search: &AlarmSearch,
    value: &NewestValue,
    reader: &dyn Reads,
) -> Result<Result<Vec<FiredAlarm>, Reason>, ReadError> {
    let NewestValue { number, part, feature, .. } = value;
    let of = |kinds| {
        let (part, feature) = (Some(part.clone()), Some(feature.clone()));
        Question { part, feature, kinds, ..Question::default() }
    };
    let most = search.most.saturating_mul(READ_FOR_ONE);
    let numbers = reader.numbers(&of(AskedKinds::Checks), None, most)?;
    let mut gathering = Gathering::default();
    for row in reader.rows(&numbers)? {
        if let Ok(entry) = &row.entry {
            gathering.take(row.head.number, entry, row.corrected_by.is_some());
        }
    }
    let series = gathering.finish(search.most);
    let has_it =
        |series: &&crate::series::FeatureSeries| series.values.iter().any(|value| value.origin.number == Some(*number));
    let Some(series) = series.iter().find(has_it) else { return Ok(Ok(Vec::new())) };
    let known = reader.rows(&reader.numbers(&of(AskedKinds::Alarms), None, MOST_KNOWN)?)?;
    let known: Vec<Alarm> = known.iter().filter_map(|row| row.entry.as_ref().ok()?.alarm()).cloned().collect();
    let baseline = search.baselines.get(&series.key).copied();
    Ok(series.alarms(&Look { baseline, ..search.look.clone() }, *number, &known))
}
