//! `--all`: every feature in a line, those that need a look first.

use serde_json::{Value as Json, json};

use crate::cli::people::{Aligned, Side};
use crate::cli::rows::csv_line;
use crate::cli::{CliError, Format, Io};
use crate::series::{Grouping, ListedFeature, NoPpk, SeriesError, Value, Wanted, listed};

/// So many features are named as those that need a look.
const FIRST: usize = 5;

const TABLE: Aligned<6> = Aligned {
    columns: [
        ("feature", Side::Left),
        ("values", Side::Right),
        ("outside", Side::Right),
        ("signals", Side::Right),
        ("Ppk", Side::Right),
        ("interval", Side::Left),
    ],
    widest: 60,
};

/// Prints the list; whether no feature has a Ppk.
pub(super) fn list(values: &[Value], grouping: Grouping, wanted: &Wanted, format: Format, io: &mut Io<'_>) -> bool {
    let all = listed(values, grouping, wanted);
    match format {
        Format::Text => text(&all, io),
        Format::Csv => {
            csv_line(["feature", "count", "outside", "signals", "ppk", "lower", "upper", "note"], io);
            for feature in &all {
                let [ppk, lower, upper] =
                    numbers(feature).map(|number| number.map_or_else(String::new, |of| of.to_string()));
                let [count, outside, signals] = counts(feature);
                csv_line([feature.name.clone(), count, outside, signals, ppk, lower, upper, why(feature)], io);
            }
        }
        Format::Json => io.json(&json!({
            "features": all.iter().map(as_json).collect::<Vec<_>>(),
            "look_first": first(&all).collect::<Vec<_>>(),
        })),
    }
    all.iter().all(|feature| feature.ppk.is_err())
}

/// The features that need a look, the most urgent first.
fn first(all: &[ListedFeature]) -> impl Iterator<Item = &str> {
    all.iter().filter(|feature| feature.needs_a_look()).take(FIRST).map(|feature| feature.name.as_str())
}

fn text(all: &[ListedFeature], io: &mut Io<'_>) {
    let rows: Vec<[String; 6]> = all
        .iter()
        .map(|feature| {
            let [ppk, lower, upper] = numbers(feature);
            let interval = match (lower, upper) {
                (Some(lower), Some(upper)) => format!("{lower:.3} to {upper:.3}"),
                _ => why(feature),
            };
            let [count, outside, signals] = counts(feature);
            let ppk = ppk.map_or_else(|| "–".to_owned(), |ppk| format!("{ppk:.3}"));
            [feature.name.clone(), count, outside, signals, ppk, interval]
        })
        .collect();
    for line in TABLE.lines(&rows) {
        writeln!(io.people(), "{line}");
    }
    writeln!(io.people());
    let first: Vec<&str> = first(all).collect();
    let said = if first.is_empty() {
        "no feature needs a look".to_owned()
    } else {
        format!("look first at: {}", first.join(", "))
    };
    writeln!(io.people(), "{said}");
}

fn counts(feature: &ListedFeature) -> [String; 3] {
    [feature.count, feature.outside, feature.signals].map(|count| count.to_string())
}

/// Ppk and the ends of its interval.
fn numbers(feature: &ListedFeature) -> [Option<f64>; 3] {
    match &feature.ppk {
        Ok((ppk, ends)) => [Some(*ppk), ends.map(|[lower, _]| lower), ends.map(|[_, upper]| upper)],
        Err(_) => [None; 3],
    }
}

/// Why there is no Ppk.
fn why(feature: &ListedFeature) -> String {
    match &feature.ppk {
        Ok(_) => String::new(),
        Err(NoPpk::Reason(reason) | NoPpk::Series(SeriesError::Reason(reason))) => reason.to_string(),
        Err(NoPpk::Series(_)) => CliError::StatsLimits.to_string(),
    }
}

fn as_json(feature: &ListedFeature) -> Json {
    let [ppk, lower, upper] = numbers(feature);
    let reason = Some(why(feature)).filter(|why| !why.is_empty());
    json!({
        "feature": feature.name, "count": feature.count, "outside": feature.outside, "signals": feature.signals,
        "ppk": ppk, "lower": lower, "upper": upper, "reason": reason,
    })
}
