//! The answer for programs; its names must not change.

use serde_json::{Map, Value as Json, json};

use super::ReadingMessages;
use super::found::{figure, head, rounded};
use crate::budget::{Answer, Assessment, Conditions, ContributionRow, Help};
use crate::cli::{Figure, Io, rows};

/// Everything as one object.
pub(super) fn json(found: &Assessment, conditions: &Conditions, beside: &ReadingMessages) -> Map<String, Json> {
    let mut answer = head(found);
    if let Some(Json::Array(warnings)) = answer.get_mut("warnings") {
        warnings.extend(beside.warnings.iter().map(|warning| json!(warning)));
    }
    let mut put = |name: &str, value: Json| {
        answer.insert(name.to_owned(), value);
    };
    put("size_mm", json!(conditions.size.map(|size| Figure::mm(size, 0))));
    match &found.answer {
        Answer::Combined(evaluation) => {
            put("contributions", evaluation.rows.iter().map(contribution).collect());
            put("largest", json!(evaluation.rows.get(evaluation.largest).map(|row| &row.name)));
            put("help", evaluation.help.iter().map(help).collect());
        }
        Answer::Repeated(repeated) => {
            put("readings", json!(repeated.readings));
            put("refused", json!(beside.refused));
            put("mean_mm", rounded(repeated.mean_mm, 9));
            for (name, um) in repeated.terms() {
                put(&format!("{name}_um"), rounded(um, 6));
            }
            put("expanded_2011_um", rounded(repeated.expanded_2011, 6));
            put("expanded_2004_um", rounded(repeated.expanded_2004, 6));
            put("bias_corrected", json!(repeated.is_corrected));
        }
    }
    answer
}

fn contribution(row: &ContributionRow) -> Json {
    json!({
        "name": row.name,
        "type": row.evaluated.letter(),
        "law": row.law.name(),
        "u": rounded(row.u, 6),
        "unit": row.unit,
        "sensitivity": rounded(row.sensitivity, 6),
        "contribution_um": rounded(row.contribution, 6),
        "share_percent": rounded(row.share, 3),
        "degrees_of_freedom": row.degrees_of_freedom.map(|degrees| rounded(degrees, 2)),
        "touches": row.geometry.map(|geometry| geometry.touches),
        "step_deg": row.geometry.and_then(|geometry| geometry.step_deg),
        "geometry_factor": row.geometry.map(|geometry| rounded(geometry.factor, 6)),
    })
}

/// What helps by its name for programs, the touches that it takes, and what it comes to.
const fn helped(help: &Help) -> (&'static str, Option<usize>, f64) {
    match *help {
        Help::Halved { u } => ("halved", None, u),
        Help::FullCircle { touches, u } => ("full-circle", Some(touches), u),
        Help::MoreTouches { touches, u } => ("more-touches", Some(touches), u),
    }
}

fn help(one: &Help) -> Json {
    let (what, touches, u) = helped(one);
    json!({ "what": what, "touches": touches, "u_um": rounded(u, 6) })
}

row! {
    /// A line of CSV: micrometres with a name, and what else there is to say of them.
    #[derive(Default)]
    struct Line<'a> of(row: &'static str, name: &'a str, um: f64) {
        row: &'static str = row,
        name: &'a str = name,
        r#type: &'static str = "",
        law: &'static str = "",
        u: Option<String> = None,
        unit: &'static str = "",
        sensitivity: Option<String> = None,
        contribution_um: Option<String> = Some(figure(um, 6)),
        share_percent: Option<String> = None,
        degrees_of_freedom: Option<String> = None,
        k: Option<String> = None,
        expanded_um: Option<String> = None,
    }
}

/// A row per contribution, then what they come to.
pub(super) fn csv(found: &Assessment, io: &mut Io<'_>) {
    rows::csv(lines(found), io);
}

fn lines(found: &Assessment) -> Vec<Line<'_>> {
    let combined = Line {
        degrees_of_freedom: degrees(found.degrees_of_freedom()),
        k: Some(figure(found.k(), 3)),
        expanded_um: Some(figure(found.expanded(), 6)),
        ..Line::of("combined", &found.budget.name, found.u())
    };
    match &found.answer {
        Answer::Combined(evaluation) => {
            let name = evaluation.rows.get(evaluation.largest).map_or("", |row| &row.name);
            let contributions = evaluation.rows.iter().map(Line::of_contribution);
            let help = evaluation.help.iter().map(|help| {
                let (what, _, u) = helped(help);
                Line::of(what, name, u)
            });
            contributions.chain([combined]).chain(help).collect()
        }
        Answer::Repeated(repeated) => {
            let terms = repeated.terms().into_iter().map(|(name, um)| Line::of("term", name, um));
            let editions = [("2011", repeated.expanded_2011), ("2004", repeated.expanded_2004)];
            let editions = editions.into_iter().map(|(name, um)| Line {
                row: "edition",
                name,
                expanded_um: Some(figure(um, 6)),
                ..Line::default()
            });
            terms.chain(editions).chain([combined]).collect()
        }
    }
}

impl<'a> Line<'a> {
    fn of_contribution(row: &'a ContributionRow) -> Self {
        Self {
            r#type: row.evaluated.letter(),
            law: row.law.name(),
            u: Some(figure(row.u, 6)),
            unit: row.unit,
            sensitivity: Some(figure(row.sensitivity, 6)),
            share_percent: Some(figure(row.share, 3)),
            degrees_of_freedom: degrees(row.degrees_of_freedom),
            ..Self::of("contribution", &row.name, row.contribution)
        }
    }
}

fn degrees(degrees: Option<f64>) -> Option<String> {
    degrees.map(|degrees| figure(degrees, 2))
}
