//! The answer as text, CSV and JSON.

use serde_json::{Map, Value as Json, json};

use crate::cli::Io;
use crate::cli::people::{Aligned, Side};
use crate::cli::rows::csv_line;
use crate::series::{Answer, Figure, FigureKind, Group, Layout, Series, StudyKind};
use crate::statistics::{ChartPoint, MemoryPoint};

/// `3 operators`
fn plural(count: usize, name: &str) -> String {
    format!("{count} {name}{}", if count == 1 { "" } else { "s" })
}

/// `125 values, 25 groups of 5, 2 left out: 2 simulated`
fn what_was_read(series: &Series<'_>) -> String {
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

/// `10 parts, 3 operators, 3 repeats`
fn understood(layout: &Layout) -> String {
    let Layout { kind, parts, operators, readings: [least, most] } = *layout;
    let each = if least == most { plural(most, "reading") } else { format!("{least} to {most} readings") };
    let operators = || plural(operators, "operator");
    match kind {
        StudyKind::Type1 => format!("1 master, {}", plural(most, "reading")),
        StudyKind::Crossed => format!("{}, {}, {}", plural(parts, "part"), operators(), plural(most, "repeat")),
        StudyKind::Nested => format!("{}, {} each, {}", operators(), plural(parts, "part"), plural(most, "repeat")),
        StudyKind::Linearity => format!("{}, {each} each", plural(parts, "master")),
        StudyKind::Stability => format!("{}, {each} each", plural(parts, "point")),
    }
}

/// A stage: its points, and the limits of its last one.
struct StageLimits<'a> {
    first: usize,
    last: usize,
    point: &'a ChartPoint,
}

/// The stages of a chart that has several.
fn stages(answer: &Answer) -> impl Iterator<Item = StageLimits<'_>> {
    let chart = answer.chart.as_ref().ok().filter(|chart| 1 < chart.stages.len());
    chart.into_iter().flat_map(|chart| {
        chart.stages.iter().filter_map(|stage| {
            let point = stage.points.end.checked_sub(1).and_then(|last| chart.points.get(last))?;
            Some(StageLimits { first: stage.points.start + 1, last: stage.points.end, point })
        })
    })
}

/// So many points of a rule are listed for people.
const MOST_POINTS: usize = 20;

const TABLE: Aligned<4> =
    Aligned { columns: [("", Side::Left), ("", Side::Right), ("", Side::Left), ("", Side::Left)], widest: 80 };

/// The points of a rule or a chart, for people.
fn listed(points: &[usize]) -> String {
    let mut shown: Vec<String> = points.iter().take(MOST_POINTS).map(usize::to_string).collect();
    if MOST_POINTS < points.len() {
        shown.push(format!("… ({} points)", points.len()));
    }
    shown.join(", ")
}

pub(super) fn text(series: &Series<'_>, answer: &Answer, io: &mut Io<'_>) {
    head(series, answer, io);
    writeln!(io.people());
    let group = |Group { name, count, figure }: &Group| {
        let [label, value, ends, method] = cells(figure);
        [format!("{label} {name} ({count})"), value, ends, method]
    };
    let rows: Vec<[String; 4]> = answer.figures.iter().map(cells).chain(answer.groups.iter().map(group)).collect();
    let widths = TABLE.widths(&rows);
    for row in &rows {
        writeln!(io.people(), "{}", TABLE.line(row, &widths));
    }
    writeln!(io.people());
    for (rule, points) in &answer.fired {
        writeln!(io.people(), "{rule} ({}): at {}", rule.word(), listed(points));
    }
    if let Some(memory) = &answer.memory {
        let out: Vec<usize> = memory.out().collect();
        let found = if out.is_empty() { "no point beyond".to_owned() } else { format!("beyond at {}", listed(&out)) };
        writeln!(io.people(), "{}: {found}", memory.memory.method());
    }
    for sentence in answer.sentences() {
        writeln!(io.people(), "{sentence}");
    }
}

/// What was read and how it was understood.
fn head(series: &Series<'_>, answer: &Answer, io: &mut Io<'_>) {
    if let Some(name) = &series.name {
        writeln!(io.people(), "feature   {name}");
    }
    writeln!(io.people(), "read      {}", what_was_read(series));
    if let Some(layout) = &answer.layout {
        writeln!(io.people(), "study     {}: {}", layout.kind.word(), understood(layout));
    }
    for (point, reason) in &answer.wanted.left_out {
        writeln!(io.people(), "left out  point {point}: {reason}");
    }
    for StageLimits { first, last, point } in stages(answer) {
        let [lower, centre, upper] = [point.location.lower, point.location.centre, point.location.upper];
        writeln!(io.people(), "stage     {first} to {last}: {centre:.5} mm, limits {lower:.5} to {upper:.5} mm");
    }
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
}

fn cells(figure: &Figure) -> [String; 4] {
    let shown = |value: f64| match figure.kind {
        FigureKind::Length => format!("{value:.5}"),
        FigureKind::Ppm if 100.0 <= value => format!("{value:.0}"),
        FigureKind::Index | FigureKind::Ppm => format!("{value:.3}"),
        FigureKind::Percent => format!("{value:.2}"),
        FigureKind::Square => format!("{value:.4e}"),
        FigureKind::Probability => format!("{value:.4}"),
    };
    let unit = match figure.kind {
        FigureKind::Length => " mm",
        FigureKind::Square => " mm²",
        FigureKind::Percent => " %",
        FigureKind::Index | FigureKind::Ppm | FigureKind::Probability => "",
    };
    let (value, ends) = match &figure.value {
        Ok((value, ends)) => {
            let ends = ends.map(|[lower, upper]| format!("{} to {}", shown(lower), shown(upper)));
            (format!("{}{unit}", shown(*value)), ends.unwrap_or_default())
        }
        Err(reason) => ("–".to_owned(), reason.to_string()),
    };
    [figure.label.to_owned(), value, ends, figure.method.to_string()]
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
    if let Some(layout) = &answer.layout {
        line(note("study", layout.kind.word().to_owned(), understood(layout)));
    }
    for (point, reason) in &answer.wanted.left_out {
        line(note("left_out", point.to_string(), reason.to_string()));
    }
    for stage in stages(answer) {
        let [value, lower, upper] =
            [stage.point.location.centre, stage.point.location.lower, stage.point.location.upper];
        let points = format!("points {} to {}", stage.first, stage.last);
        line(["stage".to_owned(), value.to_string(), lower.to_string(), upper.to_string(), String::new(), points]);
    }
    for figure in &answer.figures {
        line(figure_line(figure, String::new()));
    }
    for Group { name, count, figure } in &answer.groups {
        line(figure_line(figure, format!("{name}: {}", plural(*count, "value"))));
    }
    for (rule, points) in &answer.fired {
        for point in points {
            line(note(rule.word(), point.to_string(), rule.to_string()));
        }
    }
    if let Some(memory) = &answer.memory {
        for point in memory.out() {
            line(note("memory", point.to_string(), memory.memory.method()));
        }
    }
    for sentence in answer.sentences() {
        line(note("advice", String::new(), sentence));
    }
}

fn figure_line(figure: &Figure, group: String) -> [String; 6] {
    let [value, lower, upper, note] = match &figure.value {
        Ok((value, None)) => [value.to_string(), String::new(), String::new(), group],
        Ok((value, Some([lower, upper]))) => [value.to_string(), lower.to_string(), upper.to_string(), group],
        Err(reason) if group.is_empty() => [String::new(), String::new(), String::new(), reason.to_string()],
        Err(reason) => [String::new(), String::new(), String::new(), format!("{group}: {reason}")],
    };
    [figure.name.to_owned(), value, lower, upper, figure.method.to_string(), note]
}

fn figure_json(figure: &Figure) -> Json {
    let method = figure.method.to_string();
    match &figure.value {
        Ok((value, None)) => json!({ "value": value, "method": method }),
        Ok((value, Some([lower, upper]))) => {
            json!({ "value": value, "lower": lower, "upper": upper, "method": method })
        }
        Err(reason) => json!({ "value": null, "reason": reason.to_string(), "method": method }),
    }
}

/// What only some answers have.
fn extras(answer: &Answer) -> Vec<(&'static str, Json)> {
    let mut extras = Vec::new();
    if let Some(layout) = &answer.layout {
        let Layout { kind, parts, operators, readings: [least, most] } = layout;
        let layout = json!({
            "study": kind.word(), "parts": parts, "operators": operators, "readings": [least, most], "layout": understood(layout)
        });
        extras.push(("study", layout));
    }
    let left_out = |(point, reason): &(usize, std::sync::Arc<str>)| json!({ "point": point, "reason": &**reason });
    if !answer.wanted.left_out.is_empty() {
        extras.push(("left_out_points", answer.wanted.left_out.iter().map(left_out).collect()));
    }
    let stages: Vec<Json> = stages(answer)
        .map(|StageLimits { first, last, point }| {
            let of = &point.location;
            json!({ "first": first, "last": last, "centre_mm": of.centre, "lower_mm": of.lower, "upper_mm": of.upper })
        })
        .collect();
    if !stages.is_empty() {
        extras.push(("stages", stages.into()));
    }
    if !answer.groups.is_empty() {
        let group = |Group { name, count, figure }: &Group| json!({ "group": name, "count": count, figure.name: figure_json(figure) });
        extras.push(("groups", answer.groups.iter().map(group).collect()));
    }
    if let Some(memory) = &answer.memory {
        let point = |(number, point): &(usize, MemoryPoint)| match point {
            MemoryPoint::Average(of) => {
                json!({ "point": number, "average_mm": of.value, "lower_mm": of.lower, "upper_mm": of.upper, "out": of.is_out() })
            }
            MemoryPoint::Sums(of) => {
                json!({ "point": number, "above_mm": of.above, "below_mm": of.below, "interval_mm": of.interval, "out": of.is_out() })
            }
        };
        extras.push(("memory", memory.points.iter().map(point).collect()));
    }
    if let Some(doubt) = &answer.doubt {
        extras.push(("doubt", json!(doubt.to_string())));
    }
    extras
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
    for figure in &answer.figures {
        put(figure.name, figure_json(figure));
    }
    for (name, value) in extras(answer) {
        put(name, value);
    }
    let rules = answer
        .fired
        .iter()
        .map(|(rule, points)| json!({ "rule": rule.word(), "what": rule.to_string(), "points": points }));
    put("rules", rules.collect());
    put("advice", answer.sentences().collect());
    Json::Object(all)
}
