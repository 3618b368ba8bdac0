//! The options of the chart: its kind, rules, limits and stages, and points that are left out.

use std::sync::Arc;

use crate::cli::args::one_of;
use crate::series::{Memory, Wanted};
use crate::statistics::{ChartKind, Cusum, Ewma, Rule, Rules};

/// A chart by its name.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    Points(ChartKind),
    Memory(Memory),
}

/// The chart and its limits.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Chart")]
pub(super) struct ChartArgs {
    /// Chart; default: by the size of the subgroups. ewma and cusum stand beside that one
    #[arg(long, value_name = "CHART", value_parser = one_of(charts(), |chart| chart.0))]
    chart: Option<(&'static str, Kind)>,

    /// EWMA: weight lambda and width L in s; CUSUM: allowance k and decision interval h in s; default: 0.2,2.962 or 0.5,5
    #[arg(long, value_name = "A,B", value_parser = pair, requires = "chart")]
    parameters: Option<[f64; 2]>,

    /// Rules that are looked at; repeat it for several rules
    #[arg(long = "rules", value_name = "RULES", value_parser = one_of(rules(), |rules| rules.0), default_value = "nelson")]
    rules: Vec<(&'static str, Rules)>,

    /// Control limits from the first N points of each stage alone
    #[arg(long, value_name = "N", conflicts_with = "known")]
    baseline: Option<usize>,

    /// Control limits from mean and standard deviation of single values of an earlier study, in mm
    #[arg(long, value_name = "MEAN,S", value_parser = pair, allow_hyphen_values = true)]
    known: Option<[f64; 2]>,

    /// A stage with limits of its own begins at point N; repeat it for several stages
    #[arg(long = "stage", value_name = "N", value_parser = point)]
    stages: Vec<usize>,

    /// Leaves point N out of all figures; it stays in the answer with the reason. Repeat it for several points
    #[arg(long, value_name = "N=REASON", value_parser = left_out)]
    leave_out: Vec<(usize, Arc<str>)>,
}

fn charts() -> [(&'static str, Kind); 5] {
    [
        ("individuals", Kind::Points(ChartKind::Individuals)),
        ("means-ranges", Kind::Points(ChartKind::MeansRanges)),
        ("means-deviations", Kind::Points(ChartKind::MeansDeviations)),
        ("ewma", Kind::Memory(Memory::Ewma(Ewma::default()))),
        ("cusum", Kind::Memory(Memory::Cusum(Cusum::default()))),
    ]
}

/// Sets of rules and single ones by their names.
fn rules() -> impl Iterator<Item = (&'static str, Rules)> {
    let sets = [("nelson", Rules::NELSON), ("western-electric", Rules::WESTERN_ELECTRIC), ("none", Rules::NONE)];
    sets.into_iter().chain(Rule::ALL.map(|rule| (rule.word(), Rules::NONE.with(rule, true))))
}

fn pair(text: &str) -> Result<[f64; 2], String> {
    let number = |text: &str| text.trim().parse().ok().filter(|number: &f64| number.is_finite());
    let found = text.split_once(',').and_then(|(one, other)| Some([number(one)?, number(other)?]));
    found.ok_or_else(|| "expected two numbers with a comma between, such as 0.2,3".to_owned())
}

fn point(text: &str) -> Result<usize, String> {
    let found = text.trim().parse().ok().filter(|number| 0 < *number);
    found.ok_or_else(|| "expected the number of a point, from 1".to_owned())
}

fn left_out(text: &str) -> Result<(usize, Arc<str>), String> {
    let (number, reason) = text.split_once('=').ok_or("expected a point and a reason, such as 12=chip in the bore")?;
    let reason = reason.trim();
    if reason.is_empty() {
        return Err("expected a reason behind the point, such as 12=chip in the bore".to_owned());
    }
    Ok((point(number)?, Arc::from(reason)))
}

impl ChartArgs {
    /// What they ask of a series.
    pub(super) fn wanted(&self) -> Wanted {
        let kind = self.chart.map(|(_, kind)| kind);
        let memory = match (kind, self.parameters) {
            (Some(Kind::Memory(memory)), None) => Some(memory),
            (Some(Kind::Memory(Memory::Ewma(_))), Some([weight, width])) => Some(Memory::Ewma(Ewma { weight, width })),
            (Some(Kind::Memory(Memory::Cusum(_))), Some([allowance, interval])) => {
                Some(Memory::Cusum(Cusum { allowance, interval }))
            }
            (Some(Kind::Points(_)) | None, _) => None,
        };
        Wanted {
            chart: kind.and_then(|kind| match kind {
                Kind::Points(kind) => Some(kind),
                Kind::Memory(_) => None,
            }),
            memory,
            rules: self.rules.iter().fold(Rules::NONE, |all, (_, rules)| all.or(*rules)),
            baseline: self.baseline,
            known: self.known,
            stages: self.stages.clone(),
            left_out: self.leave_out.clone(),
            ..Wanted::default()
        }
    }

    /// Whether something is asked of single points.
    pub(super) const fn names_points(&self) -> bool {
        !self.stages.is_empty() || !self.leave_out.is_empty()
    }

    /// Whether parameters are given for a chart that has none.
    pub(super) fn has_idle_parameters(&self) -> bool {
        self.parameters.is_some() && self.wanted().memory.is_none()
    }
}
