//! The answer as text, CSV and JSON.

use serde_json::{Map, Value as Json, json};

use crate::cli::Io;
use crate::cli::people::{Aligned, Side};
use crate::cli::rows::csv_line;
use crate::series::{Answer, Figure, FigureKind, Series};

/// `125 values, 25 groups of 5, 2 left out: 2 simulated`
fn what_was_read(series: &Series<'_>) -> String {
    let plural = |count: usize, name: &str| format!("{count} {name}{}", if count == 1 { "" } else { "s" });
    let mut read = vec![plural(series.count(), "value")];
    let sizes = || series.groups.iter().map(Vec::len);
    if let (Some(least), Some(most)) = (sizes().min(), sizes().max())
        && 1 < most
    {
        let size = if least == most { most.to_string() } else { format!("{least} to {most}") };
        read.push(format!("{} of {size}", plural(series.groups.len(), "group")));
    }
    let left_out: Vec<String> = series.left_out().map(|(why, count)| format!("{count} {}", why.word())).collect();
    if !left_out.is_empty() {
        let count: usize = series.left_out().map(|(_, count)| count).sum();
        read.push(format!("{count} left out: {}", left_out.join(", ")));
    }
    read.join(", ")
}

/// So many points of a rule are listed for people.
const MOST_POINTS: usize = 20;

const TABLE: Aligned<4> =
    Aligned { columns: [("", Side::Left), ("", Side::Right), ("", Side::Left), ("", Side::Left)], widest: 80 };

pub(super) fn text(series: &Series<'_>, answer: &Answer, io: &mut Io<'_>) {
    if let Some(name) = &series.name {
        writeln!(io.people(), "feature   {name}");
    }
    writeln!(io.people(), "read      {}", what_was_read(series));
    let [lower, upper] = answer.wanted.limits.map(|limit| limit.map(|limit| limit.to_string()));
    let limits = match (lower, upper) {
        (Some(lower), Some(upper)) => format!("{lower} to {upper} mm"),
        (Some(lower), None) => format!("at least {lower} mm"),
        (None, Some(upper)) => format!("at most {upper} mm"),
        (None, None) => "none".to_owned(),
    };
    let [below, above] = answer.outside;
    let outside = if below + above == 0 { String::new() } else { format!("; {below} below, {above} above") };
    writeln!(io.people(), "limits    {limits}{outside}");
    writeln!(io.people());
    let rows: Vec<[String; 4]> = answer.figures.iter().map(cells).collect();
    let widths = TABLE.widths(&rows);
    for row in &rows {
        writeln!(io.people(), "{}", TABLE.line(row, &widths));
    }
    writeln!(io.people());
    for (rule, points) in &answer.fired {
        let mut shown: Vec<String> = points.iter().take(MOST_POINTS).map(usize::to_string).collect();
        if MOST_POINTS < points.len() {
            shown.push(format!("… ({} points)", points.len()));
        }
        writeln!(io.people(), "{rule} ({}): at {}", rule.word(), shown.join(", "));
    }
    for sentence in answer.sentences() {
        writeln!(io.people(), "{sentence}");
    }
}

fn cells(figure: &Figure) -> [String; 4] {
    let shown = |value: f64| match figure.kind {
        FigureKind::Length => format!("{value:.5}"),
        FigureKind::Ppm if 100.0 <= value => format!("{value:.0}"),
        FigureKind::Index | FigureKind::Ppm => format!("{value:.3}"),
        FigureKind::Probability => format!("{value:.4}"),
    };
    let unit = if figure.kind == FigureKind::Length { " mm" } else { "" };
    let (value, ends) = match &figure.value {
        Ok((value, ends)) => {
            let ends = ends.map(|[lower, upper]| format!("{} to {}", shown(lower), shown(upper)));
            (format!("{}{unit}", shown(*value)), ends.unwrap_or_default())
        }
        Err(reason) => ("–".to_owned(), reason.to_string()),
    };
    [figure.label.to_owned(), value, ends, figure.method.clone()]
}

pub(super) fn csv(series: &Series<'_>, answer: &Answer, io: &mut Io<'_>) {
    csv_line(["name", "value", "lower", "upper", "method", "note"], io);
    let mut line = |cells: [String; 6]| csv_line(cells, io);
    let note = |name: &str, value: String, note: String| {
        [name.to_owned(), value, String::new(), String::new(), String::new(), note]
    };
    line(note("count", series.count().to_string(), what_was_read(series)));
    for (name, limit) in ["lower_limit_mm", "upper_limit_mm"].into_iter().zip(answer.wanted.limits) {
        line(note(name, limit.map_or_else(String::new, |limit| limit.to_string()), String::new()));
    }
    for Figure { name, value, method, .. } in &answer.figures {
        let [value, lower, upper, note] = match value {
            Ok((value, None)) => [value.to_string(), String::new(), String::new(), String::new()],
            Ok((value, Some([lower, upper]))) => {
                [value.to_string(), lower.to_string(), upper.to_string(), String::new()]
            }
            Err(reason) => [String::new(), String::new(), String::new(), reason.to_string()],
        };
        line([(*name).to_owned(), value, lower, upper, method.clone(), note]);
    }
    for (rule, points) in &answer.fired {
        for point in points {
            line(note(rule.word(), point.to_string(), rule.to_string()));
        }
    }
    for sentence in answer.sentences() {
        line(note("advice", String::new(), sentence));
    }
}

pub(super) fn json(series: &Series<'_>, answer: &Answer) -> Json {
    let mut all = Map::new();
    let mut put = |name: &str, value: Json| {
        all.insert(name.to_owned(), value);
    };
    put("feature", json!(series.name));
    put("count", json!(series.count()));
    put("groups", json!(series.groups.len()));
    let left_out = series.left_out().map(|(why, count)| (why.word().to_owned(), json!(count)));
    put("left_out", Json::Object(left_out.collect()));
    let [lower, upper] = answer.wanted.limits;
    put("lower_limit_mm", json!(lower));
    put("upper_limit_mm", json!(upper));
    let [below, above] = answer.outside;
    put("outside", json!({ "below": below, "above": above }));
    for Figure { name, value, method, .. } in &answer.figures {
        let figure = match value {
            Ok((value, None)) => json!({ "value": value, "method": method }),
            Ok((value, Some([lower, upper]))) => {
                json!({ "value": value, "lower": lower, "upper": upper, "method": method })
            }
            Err(reason) => json!({ "value": null, "reason": reason.to_string(), "method": method }),
        };
        put(name, figure);
    }
    let rules = answer
        .fired
        .iter()
        .map(|(rule, points)| json!({ "rule": rule.word(), "what": rule.to_string(), "points": points }));
    put("rules", rules.collect());
    put("advice", answer.sentences().collect());
    Json::Object(all)
}
