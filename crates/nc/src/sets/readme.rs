//! The page that says where each file goes, from a text of each language in `assets/nc`.
//!
//! A line may begin with the controls that it is for, `[tnc640 tnc7] text`; `limits` and `texts` are a TNC7 whose cycles take limits, or
//! tolerances as texts. `{main}` and similar words are filled in;
//! `{features}` and `{nominal}` are alone on their lines and become as many lines as needed.

use fitcheck_core::tolerance::Feature;
use fitcheck_shipped as shipped;

use super::called::Called;
use super::error::SetRemark;
use super::names::{Control, Names};
use super::{Planned, given};

/// What begins a line that is only there where the plan says more of judging than the set knows.
const OF_UNKNOWN: &str = "{?unknown}";

/// What begins a line that is only there where a feature has no class.
const OF_GIVEN: &str = "{?given}";

/// What begins a line of a series alone, and one of a part alone.
const OF_SERIES: &str = "{?series}";
const OF_ONE: &str = "{?one}";

/// The page as a file: Windows-1252, CRLF.
pub(super) fn page(names: &Names<'_>, planned: &[Planned<'_>], remarks: &[SetRemark]) -> Vec<u8> {
    let template = shipped::text(shipped::NC, &format!("readme_{}.txt", names.target.language));
    let mut page = String::new();
    for line in template.lines() {
        let Some(line) = for_control(line, codes(names)) else { continue };
        if !is_for(line, planned) {
            continue;
        }
        let (of, other) = if names.target.parts.is_some() { (OF_SERIES, OF_ONE) } else { (OF_ONE, OF_SERIES) };
        if line.starts_with(other) {
            continue;
        }
        let line = line.strip_prefix(of).unwrap_or(line);
        match line.trim() {
            "{features}" => planned.iter().for_each(|planned| add(&mut page, &feature(*planned, names))),
            "{nominal}" => {
                let moved: Vec<String> = remarks.iter().filter_map(nominal).collect();
                add(&mut page, &if moved.is_empty() { "  -".to_owned() } else { moved.join("\r\n") });
            }
            "{unknown}" => remarks.iter().filter_map(unknown).for_each(|line| add(&mut page, &line)),
            // What follows is of a plan that says more than a set knows.
            trimmed if trimmed.starts_with(OF_UNKNOWN) => {
                if remarks.iter().any(|remark| unknown(remark).is_some()) {
                    add(&mut page, &filled(line, names).replacen(OF_UNKNOWN, "", 1));
                }
            }
            _ if line.starts_with(OF_GIVEN) => {
                if planned.iter().any(given::has_given) {
                    add(&mut page, &filled(line, names).replacen(OF_GIVEN, "", 1));
                }
            }
            _ => add(&mut page, &filled(line, names)),
        }
    }
    encoding_rs::WINDOWS_1252.encode(&page).0.into_owned()
}

fn add(page: &mut String, line: &str) {
    page.push_str(line.trim_end());
    page.push_str("\r\n");
}

/// What the lines for a set begin with.
fn codes(names: &Names<'_>) -> [&'static str; 2] {
    let control = names.target.control;
    let takes = if names.target.by_text { "texts" } else { "limits" };
    [control.code(), if control == Control::Tnc7 { takes } else { control.code() }]
}

/// The line without its controls, or `None` if it is for other controls.
fn for_control<'a>(line: &'a str, codes: [&str; 2]) -> Option<&'a str> {
    let Some((controls, text)) = line.strip_prefix('[').and_then(|line| line.split_once(']')) else {
        return Some(line);
    };
    controls.split(' ').any(|control| codes.contains(&control)).then(|| text.strip_prefix(' ').unwrap_or(text))
}

/// Whether a line that names the program of a kind of feature is for this plan.
fn is_for(line: &str, planned: &[Planned<'_>]) -> bool {
    let has = |called| planned.iter().any(|planned| Called::of(&planned.feature.kind) == Some(called));
    [
        ("{width}", Called::Width),
        ("{face}", Called::Face),
        ("{rectangle}", Called::Rectangle),
        ("{point}", Called::Point),
    ]
    .iter()
    .all(|(mark, called)| !line.contains(mark) || has(*called))
}

fn filled(line: &str, names: &Names<'_>) -> String {
    let control = names.target.control;
    let marks = [
        ("{main}", names.main.clone()),
        ("{check}", names.check(Called::Diameter).clone()),
        ("{mask}", names.mask(Called::Diameter).clone()),
        ("{width}", names.check(Called::Width).clone()),
        ("{width_mask}", names.mask(Called::Width).clone()),
        ("{face}", names.check(Called::Face).clone()),
        ("{face_mask}", names.mask(Called::Face).clone()),
        ("{rectangle}", names.check(Called::Rectangle).clone()),
        ("{rectangle_mask}", names.mask(Called::Rectangle).clone()),
        ("{point}", names.check(Called::Point).clone()),
        ("{point_mask}", names.mask(Called::Point).clone()),
        ("{hole}", names.table(Feature::Hole).to_owned()),
        ("{shaft}", names.table(Feature::Shaft).to_owned()),
        ("{result}", names.result("*")),
        ("{series_mask}", names.series_mask.clone()),
        ("{series_table}", names.series_table.to_owned()),
        ("{protocol}", names.protocol.to_owned()),
        ("{parts}", names.target.parts.map_or_else(String::new, |parts| parts.to_string())),
        ("{control}", control.name().to_owned()),
        ("{clearance}", control.clearance().to_owned()),
        ("{folder}", names.target.folder.to_string()),
        ("{version}", env!("CARGO_PKG_VERSION").to_owned()),
    ];
    marks.into_iter().fold(line.to_owned(), |line, (mark, text)| line.replace(mark, &text))
}

/// Name, callout, limits and place of a feature, and a line with callout and limits of a second side: only figures, the
/// same in every language.
fn feature(planned: Planned<'_>, names: &Names<'_>) -> String {
    let feature = planned.feature;
    let [x, y, z] = planned.place;
    let result = match names.target.parts {
        // The columns of a series have the names of the features.
        Some(_) => String::new(),
        None => format!(" -> {}", names.result(&planned.feature.name)),
    };
    let place = format!("X{x} Y{y} Z{z} ({}){result}", feature.clearance_height);
    let callouts = feature.kind.callouts();
    let asked = |number| callouts.get(number).map_or_else(|| feature.kind.asked(), ToString::to_string);
    let lines = planned.limits.iter().enumerate().map(|(number, limits)| {
        let (name, place) = if number == 0 { (feature.name.as_str(), place.as_str()) } else { ("", "") };
        let limits = format!("{} ... {}", limits.minimum(), limits.maximum());
        format!("  {name:<20} {:<12} {limits:<24} {place}", asked(number)).trim_end().to_owned()
    });
    lines.collect::<Vec<_>>().join("\r\n")
}

fn nominal(remark: &SetRemark) -> Option<String> {
    match remark {
        SetRemark::MovedNominal { name, callout, value, parameter, .. } => {
            Some(format!("  {name:<20} {callout}: {parameter} = {value}"))
        }
        _ => None,
    }
}

/// A feature and what the plan says of judging it, as the keys of a plan: the same in every language.
fn unknown(remark: &SetRemark) -> Option<String> {
    match remark {
        SetRemark::ByHand { name, kind } => Some(format!("  {name:<20} {kind}")),
        SetRemark::NotInSet { name, said } => Some(format!("  {name:<20} {said}")),
        _ => None,
    }
}
