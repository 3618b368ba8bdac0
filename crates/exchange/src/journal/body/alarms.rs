//! An alarm as the fields of a body, and from them.

use fitcheck_statistics::{Place, Rule};

use super::texts::{long, name, printed, whole};
use super::{BodyError, wire};
use crate::journal::chain::Head;
use crate::journal::{Alarm, AlarmAnswer};

/// The first entry of a chain is its beginning: no value has a smaller number.
const FIRST_VALUE: u64 = 2;

pub(super) fn written(alarm: &Alarm) -> Result<wire::Alarm, BodyError> {
    sound(alarm)?;
    let Alarm { rule, place, first, last, since, answer } = alarm;
    let target = answer.as_ref().map(|answer| answer.target);
    let answers = target.map(|Head { number, hash }| {
        Ok(wire::Last { number: whole("alarm.answers.number", number)?, hash: hash.to_string() })
    });
    let [cause, action] = answer.as_ref().map_or(["", ""], |answer| [answer.cause.as_str(), answer.action.as_str()]);
    Ok(wire::Alarm {
        rule: rule.word().to_owned(),
        place: place.word().to_owned(),
        first: whole("alarm.first", *first)?,
        last: whole("alarm.last", *last)?,
        since: name("alarm.since", since)?,
        answers: answers.transpose()?,
        cause: long("alarm.cause", cause)?,
        action: long("alarm.action", action)?,
    })
}

pub(super) fn read(alarm: &wire::Alarm) -> Result<Alarm, BodyError> {
    let rule = Rule::ALL.into_iter().find(|rule| rule.word() == alarm.rule);
    let place = Place::ALL.into_iter().find(|place| place.word() == alarm.place);
    let answer = match &alarm.answers {
        Some(wire::Last { number, hash }) => {
            let number = whole("alarm.answers.number", *number)?;
            Some(AlarmAnswer {
                target: Head { number, hash: printed("alarm.answers.hash", hash)? },
                cause: long("alarm.cause", &alarm.cause)?,
                action: long("alarm.action", &alarm.action)?,
            })
        }
        None if alarm.cause.is_empty() && alarm.action.is_empty() => None,
        None => return Err(BodyError::Contradiction { field: "alarm.answers" }),
    };
    let read = Alarm {
        rule: rule.ok_or_else(|| BodyError::value("alarm.rule", &alarm.rule))?,
        place: place.ok_or_else(|| BodyError::value("alarm.place", &alarm.place))?,
        first: whole("alarm.first", alarm.first)?,
        last: whole("alarm.last", alarm.last)?,
        since: name("alarm.since", &alarm.since)?,
        answer,
    };
    sound(&read)?;
    Ok(read)
}

/// What holds of every alarm: its values are those of entries that came before its answer, and an answer says cause and action.
fn sound(alarm: &Alarm) -> Result<(), BodyError> {
    let Alarm { first, last, answer, .. } = alarm;
    if *first < FIRST_VALUE {
        return Err(BodyError::value("alarm.first", first));
    }
    // What stands in the place of an older value keeps its place in the series, and has the larger number.
    let Some(AlarmAnswer { target, cause, action }) = answer else { return Ok(()) };
    if target.number <= *last {
        return Err(BodyError::Contradiction { field: "alarm.answers.number" });
    }
    for (field, text) in [("alarm.cause", cause), ("alarm.action", action)] {
        if text.trim().is_empty() {
            return Err(BodyError::Empty { field });
        }
    }
    Ok(())
}
