//! A whole part: its status first, what is missing, its picture with a balloon a feature, and the list of its sizes.

use fitcheck_core::length::Length;
use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_core::part::{FeatureStanding, Size, Step};
use fitcheck_core::verdict::Status;
use fitcheck_core::words::Words;

use crate::report::image::Image;
use crate::report::origins;
use crate::report::part::PartSheet;
use crate::report::picture::{self, shape, status_class};
use crate::report::said::{balloon_said, beyond_limits, decimals_of, heading, lacks};

/// The most bytes of pictures in one page: a browser opens it in seconds.
const MOST_PICTURES: usize = 32 << 20;

/// The most signs of a balloon's number.
const LABEL: usize = 4;

/// What the page says of a part.
pub(super) struct PartView {
    pub heading: String,
    pub drawing: String,
    pub remark: String,
    /// The part's verdict, where it has one.
    pub sign: Option<String>,
    pub no_verdict: String,
    pub standing: String,
    pub is_simulated: bool,
    pub lacks: Vec<String>,
    pub picture: Option<PictureView>,
    pub sizes: Vec<SizeView>,
}

/// Its picture, or why it is not shown.
pub(super) struct PictureView {
    pub name: String,
    pub address: Option<String>,
    pub said: String,
    pub balloons: Vec<BalloonView>,
    /// That some features have no balloon on it.
    pub beside: Option<String>,
    pub why: Option<String>,
}

/// A balloon, at shares of the picture's sides in per cent.
pub(super) struct BalloonView {
    pub class: &'static str,
    pub shape: &'static str,
    pub x: String,
    pub y: String,
    pub label: String,
    pub said: String,
    pub has_mark: bool,
    pub is_simulated: bool,
}

/// A size in the list.
pub(in crate::report) struct SizeView {
    pub number: String,
    pub name: String,
    pub asked: String,
    pub limits: String,
    pub measured: String,
    pub deviation: String,
    pub word: String,
    pub origin: String,
    pub rule: String,
}

/// The views of parts, one after the other: their pictures share the room of the page.
pub(super) struct PartViews {
    left: usize,
}

impl Default for PartViews {
    fn default() -> Self {
        Self { left: MOST_PICTURES }
    }
}

impl PartViews {
    /// What the page says of the next part.
    pub(super) fn view(&mut self, part: &PartSheet, words: &Words) -> askama::Result<PartView> {
        let standing = part.standing();
        let head = &part.plan.head;
        Ok(PartView {
            heading: heading(part, words),
            drawing: head.drawing.clone(),
            remark: head.remark.clone(),
            sign: part
                .status()
                .map(|status| {
                    let is_accepted = status == Status::Good && beyond_limits(part).next().is_some();
                    picture::verdict(
                        status,
                        if is_accepted { words.get("status-accepted") } else { words.told(&status) },
                    )
                })
                .transpose()?,
            no_verdict: words.get("walk-page-not-complete"),
            standing: words.say(&standing.message()),
            is_simulated: 0 < standing.simulated,
            lacks: lacks(part, words),
            picture: self.picture(part, words),
            sizes: part
                .sizes()
                .map(|(size, step, record)| size_view(&size, step, record.map(AsRef::as_ref), words))
                .collect(),
        })
    }

    fn picture(&mut self, part: &PartSheet, words: &Words) -> Option<PictureView> {
        let name = part.plan.head.picture.clone();
        let said = words.get("parts-page-picture");
        let none = |why: &Message| PictureView {
            name: name.clone(),
            address: None,
            said: String::new(),
            balloons: Vec::new(),
            beside: None,
            why: Some(words.say(why)),
        };
        Some(match part.picture.as_ref()? {
            Ok(image) if self.left < image.size() => none(&message!("report-picture-room").text("name", &name)),
            Ok(image) => {
                self.left -= image.size();
                shown(part, image, said, words)
            }
            Err(why) => none(why),
        })
    }
}

/// The picture with the balloons that are on it.
fn shown(part: &PartSheet, image: &Image, said: String, words: &Words) -> PictureView {
    let standings = part.features();
    let features = (1_usize..).zip(part.plan.features()).zip(&standings);
    let balloons: Vec<BalloonView> = features
        .filter_map(|((place, feature), standing)| {
            let [x, y] = feature.balloon?;
            let label = if feature.number.is_empty() { place.to_string() } else { feature.number.clone() };
            Some(balloon([x, y], &label, (&feature.name, standing), words))
        })
        .collect();
    let beside = standings.len() - balloons.len();
    PictureView {
        name: part.plan.head.picture.clone(),
        address: Some(image.address()),
        said,
        balloons,
        beside: (0 < beside).then(|| words.say(&message!("report-picture-beside").count("count", beside))),
        why: None,
    }
}

fn balloon([x, y]: [f64; 2], label: &str, (name, standing): (&str, &FeatureStanding), words: &Words) -> BalloonView {
    let FeatureStanding { status, is_simulated, is_skipped, .. } = *standing;
    let percent = |share: f64| format!("{:.2}", share.clamp(0.0, 1.0) * 100.0);
    BalloonView {
        class: status.map_or(if is_skipped { "skipped" } else { "open" }, status_class),
        shape: shape(status),
        x: percent(x),
        y: percent(y),
        label: label.chars().take(LABEL).collect(),
        said: balloon_said(label, name, standing, words),
        has_mark: status.is_some() || is_skipped,
        is_simulated,
    }
}

/// A size as a row of the list.
pub(in crate::report) fn size_view(
    size: &Size<'_>,
    step: &Step,
    record: Option<&crate::journal::Record>,
    words: &Words,
) -> SizeView {
    let deviations = &size.limits.deviations;
    let of_point = || format!("{} / {} µm", words.signed_um(deviations.upper()), words.signed_um(deviations.lower()));
    let mm = |length: Length| format!("{} mm", words.mm(length, decimals_of(length).max(3)));
    let word = match record {
        Some(record) => {
            let word = words.told(&record.verdict);
            if record.measurement.origin.is_simulated() {
                words.say(&message!("parts-page-balloon-simulated").text("status", word))
            } else {
                word
            }
        }
        None if step.skipped.is_some() => words.get("parts-page-balloon-skipped"),
        None => words.get("parts-page-balloon-open"),
    };
    SizeView {
        number: size.feature.number.clone(),
        name: size.name(),
        asked: size.callout.map_or_else(of_point, |callout| callout.to_string()),
        limits: limits(size, words),
        measured: record.map_or_else(String::new, |record| mm(record.measurement.diameter)),
        deviation: record
            .map_or_else(String::new, |record| format!("{} µm", words.signed_um(record.verdict.size.deviation))),
        word,
        origin: record.map_or_else(String::new, |record| words.told(&record.measurement.origin)),
        rule: record.map_or_else(String::new, |record| origins::rule(record.verdict.rule, words)),
    }
}

/// Minimum and maximum, with as many decimals as both need.
fn limits(size: &Size<'_>, words: &Words) -> String {
    let ends = [size.limits.minimum(), size.limits.maximum()];
    let decimals = ends.into_iter().map(decimals_of).fold(3, usize::max);
    let [minimum, maximum] = ends.map(|end| words.mm(end, decimals));
    format!("{minimum} … {maximum}")
}

/// Whether any part has a picture that the page can show.
pub(super) fn have_pictures(parts: &[PartSheet]) -> bool {
    parts.iter().any(|part| matches!(part.picture, Some(Ok(_))))
}
