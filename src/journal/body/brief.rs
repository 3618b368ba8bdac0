//! What an entry is found by, read from its body without judging it again: a million of them in seconds.

use std::borrow::Cow;

use serde::Deserialize;

use super::{BodyError, wire};
use crate::journal::found::{Found, Kind, folded, words_of};
use crate::length::Length;
use crate::tolerance::Callout;
use crate::verdict::Status;

#[derive(Deserialize)]
struct Brief<'a> {
    kind: wire::Kind,
    #[serde(borrow)]
    about: About<'a>,
    #[serde(borrow)]
    check: Option<Check<'a>>,
    withdrawal: Option<Corrects>,
}

#[derive(Deserialize)]
struct About<'a> {
    #[serde(borrow)]
    station: Cow<'a, str>,
    time: Time,
    #[serde(borrow)]
    who: Cow<'a, str>,
    #[serde(borrow)]
    part: Cow<'a, str>,
    #[serde(borrow)]
    serial: Cow<'a, str>,
    #[serde(borrow)]
    feature: Cow<'a, str>,
    #[serde(borrow)]
    remark: Cow<'a, str>,
}

#[derive(Deserialize)]
struct Time {
    utc_ms: i64,
}

#[derive(Deserialize)]
struct Check<'a> {
    status: Option<Status>,
    simulated: bool,
    #[serde(borrow)]
    size: Option<Size<'a>>,
    corrects: Option<Corrects>,
}

#[derive(Deserialize)]
struct Size<'a> {
    #[serde(borrow)]
    callout: Option<Cow<'a, str>>,
    limits: Limits,
}

#[derive(Deserialize)]
struct Limits {
    nominal_nm: i64,
}

#[derive(Deserialize)]
struct Corrects {
    number: u64,
}

/// What an entry is found by; `None` for the first entry of a chain, which is no check.
///
/// # Errors
/// [`BodyError::Json`] where the bytes are no entry. What is found may still be one that [`read`](super::read) refuses.
pub fn found(bytes: &[u8]) -> Result<Option<Found>, BodyError> {
    let brief: Brief<'_> =
        serde_json::from_slice(bytes).map_err(|error| BodyError::Json { reason: error.to_string() })?;
    let kind = match brief.kind {
        wire::Kind::Begin => return Ok(None),
        wire::Kind::Check => Kind::Check,
        wire::Kind::Withdrawal => Kind::Withdrawal,
    };
    let (about, check) = (&brief.about, brief.check.as_ref());
    let texts = [&about.part, &about.serial, &about.feature, &about.who, &about.remark];
    let words: Vec<String> = texts.iter().flat_map(|text| words_of(text)).collect();
    let (callout, class) = check.and_then(|check| check.size.as_ref()).map(asked).unwrap_or_default();
    let corrects = check.and_then(|check| check.corrects.as_ref()).or(brief.withdrawal.as_ref());
    Ok(Some(Found {
        kind,
        at_ms: about.time.utc_ms,
        status: check.and_then(|check| check.status),
        is_simulated: check.is_some_and(|check| check.simulated),
        part: folded(&about.part),
        serial: folded(&about.serial),
        feature: folded(&about.feature),
        callout,
        class,
        who: folded(&about.who),
        station: folded(&about.station),
        corrects: corrects.map(|correction| correction.number),
        words: words.join(" "),
    }))
}

/// The callout as it is listed, and its class.
fn asked(size: &Size<'_>) -> (String, String) {
    let Some(callout) = &size.callout else {
        let nominal = Length::from_nanometres(size.limits.nominal_nm);
        return (nominal.map(|nominal| format!("Ø {nominal}")).unwrap_or_default(), String::new());
    };
    let class = callout.parse::<Callout>().ok().and_then(|callout| callout.class());
    (callout.to_string(), class.map(|class| class.to_string()).unwrap_or_default())
}
