//! Studies of gauges: is this gauge good enough for this tolerance, and what is the smallest one that it is good enough for?

use fitcheck_statistics::gauge::{
    ACCEPTED_SHARE, Finding, GOOD_SHARE, Linearity, MasterPlan, Study, StudyPlan, crossed, linearity, master_study,
    nested, stability,
};
use fitcheck_statistics::{Advice, ENOUGH_VALUES, Estimate, Moments, Ratio, Reason, Row, Tolerance, probability};

use fitcheck_core::length::Length;

use super::Series;
use super::charted::{Charted, plan};
use super::figure::{Figure, FigureKind};
use super::figures::{Answer, Contribution, Group};
use super::layout::{Cells, Layout, StudyError, StudyKind};
use super::value::Value;
use super::wanted::Wanted;

/// A calibrated size in millimetres, of one part or of all.
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    pub part: Option<String>,
    pub size: f64,
}

/// What is asked of a study.
#[derive(Debug, Clone)]
pub struct StudyWanted {
    pub kind: StudyKind,
    /// In a linearity study, nominal sizes are references where none is given.
    pub references: Vec<Reference>,
    /// The step of the display in millimetres.
    pub resolution: Option<f64>,
    /// Whether a layout that looks wrong is meant.
    pub is_confirmed: bool,
}

impl StudyWanted {
    /// A nominal size is that of a column of masters: in other studies a calibrated size must be given.
    fn reference(&self, value: &Value) -> Option<f64> {
        let part = value.origin.whole_part();
        let named = self.references.iter().find(|one| one.part.as_ref().is_some_and(|name| *name == part));
        let given = named.or_else(|| self.references.iter().find(|one| one.part.is_none())).map(|one| one.size);
        let nominal = value.nominal.filter(|_| self.kind == StudyKind::Linearity);
        given.or_else(|| nominal.map(Length::to_mm_f64))
    }

    /// The references of values, each of which has one.
    fn all_references(&self, values: &[&Value]) -> Result<Vec<f64>, StudyError> {
        let found: Vec<f64> = values.iter().filter_map(|value| self.reference(value)).collect();
        let count = values.len() - found.len();
        if count == 0 { Ok(found) } else { Err(StudyError::NoReference { count }) }
    }

    /// The one size of a master.
    fn one_reference(&self, values: &[&Value]) -> Result<Option<f64>, StudyError> {
        let mut all = self.all_references(values)?;
        all.dedup();
        if 1 < all.len() { Err(StudyError::References) } else { Ok(all.first().copied()) }
    }
}

const ANOVA: &str = "analysis of variance";

impl Answer {
    /// What a study says of a gauge. Points that are left out are values, in the order of the series; in a stability study those of its
    /// chart.
    ///
    /// # Errors
    /// Values that make no study.
    pub fn of_study(series: &Series<'_>, wanted: &Wanted, study: &StudyWanted) -> Result<Self, StudyError> {
        let mut answer = Self::begun(wanted);
        let values = match study.kind {
            StudyKind::Stability => series.counted.clone(),
            _ => series.counted_without(wanted),
        };
        let width = Tolerance::new(wanted.limits[0], wanted.limits[1])
            .and_then(|limits| limits.both())
            .map(|[lower, upper]| upper - lower);
        match study.kind {
            StudyKind::Type1 => answer.type1(&values, study, &width)?,
            StudyKind::Crossed | StudyKind::Nested => answer.repeated(&values, study, &width)?,
            StudyKind::Linearity => answer.linear(&values, study)?,
            StudyKind::Stability => answer.stable(series, &values, study)?,
        }
        Ok(answer)
    }

    fn say(&mut self, finding: Finding) {
        self.advice.push(Advice::Gauge(finding));
    }

    /// Whether a layout looks right, or what looks wrong is meant.
    fn looks_right(&mut self, doubts: impl IntoIterator<Item = Finding>, study: &StudyWanted) -> bool {
        for doubt in doubts {
            if !study.is_confirmed {
                self.doubt = Some(doubt);
                return false;
            }
            self.say(doubt);
        }
        true
    }

    /// A study of one master has one part.
    fn is_one_master(&mut self, values: &[&Value], study: &StudyWanted) -> bool {
        let mut parts: Vec<String> = values.iter().map(|value| value.origin.whole_part()).collect();
        parts.sort_unstable();
        parts.dedup();
        let parts = parts.len();
        self.looks_right((1 < parts).then_some(Finding::SeveralMasters { parts }), study)
    }

    fn bias(&mut self, bias: Estimate, p: f64) {
        self.put(["bias_mm", "bias"], FigureKind::Length, Ok(bias), "mean - reference, Student");
        self.bare(["bias_p", "p of the bias"], FigureKind::Probability, p, "t test");
        let um = format!("{:+.1}", bias.value * 1_000.0);
        let is_chance = 1.0 - self.wanted.level <= p;
        let p = probability(p);
        self.say(if is_chance { Finding::NotBiased { um, p } } else { Finding::Biased { um, p } });
    }

    fn type1(&mut self, values: &[&Value], study: &StudyWanted, width: &Result<f64, Reason>) -> Result<(), StudyError> {
        let count = values.len();
        self.layout = Some(Layout { kind: study.kind, parts: 1, operators: 1, readings: [count; 2] });
        if !self.is_one_master(values, study) {
            return Ok(());
        }
        let reference = study.one_reference(values)?.unwrap_or(0.0);
        let readings: Vec<f64> = values.iter().map(|value| value.measured.to_mm_f64()).collect();
        let level = self.wanted.level;
        // The smallest tolerance is that of any.
        let known = width.clone().unwrap_or(1.0);
        let plan = MasterPlan { resolution: study.resolution, level, ..MasterPlan::of(reference, known) };
        let found = match master_study(&readings, &plan) {
            Ok(found) => found,
            Err(reason) => {
                self.figures.push(Figure::none(["sd_mm", "s"], FigureKind::Length, reason, "type 1"));
                return Ok(());
            }
        };
        self.bare(["reference_mm", "reference"], FigureKind::Length, reference, "given");
        let mean = found.bias.map(|bias| bias + reference);
        self.put(["mean_mm", "mean"], FigureKind::Length, Ok(mean), "mean, Student");
        self.put(["sd_mm", "s"], FigureKind::Length, Ok(found.deviation), "standard deviation, chi-square");
        self.bias(found.bias, found.p);
        self.bare(["bias_t", "t of the bias"], FigureKind::Index, found.t, "t test");
        let share = format!("{} % of the tolerance, {} s", 100.0 * plan.share, plan.spread);
        for (name, estimate) in [(["cg", "Cg"], found.cg), (["cgk", "Cgk"], found.cgk)] {
            self.put(name, FigureKind::Index, width.clone().map(|_| estimate), share.clone());
        }
        let smallest = ["smallest_tolerance_mm", "smallest tolerance"];
        let required = plan.required.to_string();
        self.put(smallest, FigureKind::Length, Ok(found.smallest), format!("Cg and Cgk at least {required}"));
        if width.is_ok() {
            let required = required.clone();
            self.say(if found.is_good { Finding::MasterGood { required } } else { Finding::MasterBad { required } });
        }
        self.say(Finding::Smallest {
            mm: mm(found.smallest.value),
            most: mm(found.smallest.upper),
            level: (100.0 * level).to_string(),
        });
        if count < ENOUGH_VALUES {
            self.advice.push(Advice::FewValues { count, enough: ENOUGH_VALUES });
        }
        let degrees = found.moments.degrees();
        self.contributions = vec![Contribution { name: "repeatability", standard: found.deviation.value, degrees }];
        Ok(())
    }

    fn repeated(
        &mut self,
        values: &[&Value],
        study: &StudyWanted,
        width: &Result<f64, Reason>,
    ) -> Result<(), StudyError> {
        let is_nested = study.kind == StudyKind::Nested;
        let cells = Cells::of(values, is_nested)?;
        self.layout = Some(cells.layout);
        if !self.looks_right(cells.doubts, study) {
            return Ok(());
        }
        let plan = StudyPlan { level: self.wanted.level, ..StudyPlan::default() };
        let found = if is_nested { nested(&cells.readings, &plan) } else { crossed(&cells.readings, &plan) };
        match found {
            Ok(found) => {
                if self.looks_right(found.may_be_swapped().then_some(Finding::OperatorsDifferMore), study) {
                    self.rows(&found);
                    self.shares(&found, width);
                }
            }
            Err(reason) => self.figures.push(Figure::none(["gauge_mm", "gauge, s"], FigureKind::Length, reason, ANOVA)),
        }
        Ok(())
    }

    /// The analysis of variance, and what becomes of it.
    fn rows(&mut self, found: &Study) {
        let components = &found.components;
        let mut row = |names: [[&'static str; 2]; 2], of: Option<(Row, Ratio)>| {
            if let Some((row, ratio)) = of {
                let method = format!("{ANOVA}, {} degrees of freedom", row.degrees);
                self.bare(names[0], FigureKind::Square, row.mean_square(), method);
                self.bare(names[1], FigureKind::Probability, ratio.p, format!("F = {:.3}", ratio.f));
            }
        };
        row([["ms_part", "mean square, parts"], ["p_part", "p of parts"]], Some(found.part));
        row([["ms_operator", "mean square, operators"], ["p_operator", "p of operators"]], found.operator);
        row([["ms_interaction", "mean square, interaction"], ["p_interaction", "p of interaction"]], found.interaction);
        let method = format!("{ANOVA}, {} degrees of freedom", found.repeatability.degrees);
        let repeated = ["ms_repeatability", "mean square, repeatability"];
        self.bare(repeated, FigureKind::Square, found.repeatability.mean_square(), method);
        for (name, component) in [
            (["var_part", "variance, parts"], components.part),
            (["var_operator", "variance, operators"], components.operator),
            (["var_interaction", "variance, interaction"], components.interaction),
            (["var_repeatability", "variance, repeatability"], components.repeatability),
        ] {
            let method = if component.is_negative { "negative, set to 0" } else { ANOVA };
            self.bare(name, FigureKind::Square, component.variance, method);
        }
        self.bare(["var_gauge", "variance, gauge"], FigureKind::Square, components.gauge(), ANOVA);
        self.bare(["var_total", "variance, total"], FigureKind::Square, components.total(), ANOVA);
        if let Some((_, ratio)) = found.interaction {
            let p = probability(ratio.p);
            let finding =
                if found.is_pooled { Finding::InteractionPooled { p } } else { Finding::InteractionKept { p } };
            self.say(finding);
        }
        for (what, component) in
            [("operator", components.operator), ("interaction", components.interaction), ("part", components.part)]
        {
            if component.is_negative {
                self.say(Finding::Negative { what });
            }
        }
    }

    /// What the gauge takes of a tolerance and of all readings.
    fn shares(&mut self, found: &Study, width: &Result<f64, Reason>) {
        let repeatability = found.repeatability_deviation;
        self.put(["repeatability_mm", "repeatability, s"], FigureKind::Length, Ok(repeatability), "chi-square");
        self.put(["gauge_mm", "gauge, s"], FigureKind::Length, Ok(found.gauge), "modified large sample");
        let (contribution, of_study) = (found.percent_contribution(), found.percent_of_study());
        self.bare(["percent_contribution", "share of variance"], FigureKind::Percent, contribution, "variances");
        self.bare(["percent_of_study", "share of all readings"], FigureKind::Percent, of_study, "6 s");
        let of_tolerance = width.clone().map(|width| found.percent_of_tolerance(width));
        self.put(["percent_of_tolerance", "share of the tolerance"], FigureKind::Percent, of_tolerance, "6 s");
        self.bare(["categories", "distinct categories"], FigureKind::Index, found.categories(), "1.41 parts / gauge");
        let [good, accepted] = [GOOD_SHARE, ACCEPTED_SHARE].map(|share| found.smallest_tolerance(share));
        self.put(["smallest_good_mm", "smallest tolerance, 10 %"], FigureKind::Length, Ok(good), "AIAG MSA");
        self.put(["smallest_accepted_mm", "smallest tolerance, 30 %"], FigureKind::Length, Ok(accepted), "AIAG MSA");
        self.say(match width {
            Ok(width) => Finding::of_share("tolerance", found.percent_of_tolerance(*width).value),
            Err(_) => Finding::of_share("variation", of_study),
        });
        self.say(Finding::SmallestShares { good: mm(good.value), accepted: mm(accepted.value) });
        let repeated =
            Contribution { name: "repeatability", standard: repeatability.value, degrees: found.repeatability.degrees };
        // The rest of the gauge, with the few degrees of freedom of its operators.
        let reproduced = found.operator.map(|(row, _)| Contribution {
            name: "reproducibility",
            standard: (found.components.operator.variance + found.components.interaction.variance).sqrt(),
            degrees: row.degrees,
        });
        let reproduced = reproduced.filter(|of| 0.0 < of.standard);
        self.contributions = [Some(repeated), reproduced].into_iter().flatten().collect();
    }

    fn linear(&mut self, values: &[&Value], study: &StudyWanted) -> Result<(), StudyError> {
        let references = study.all_references(values)?;
        let readings: Vec<[f64; 2]> =
            references.into_iter().zip(values).map(|(size, value)| [size, value.measured.to_mm_f64()]).collect();
        let found = match linearity(&readings, self.wanted.level) {
            Ok(found) => found,
            Err(reason) => {
                self.figures.push(Figure::none(["slope", "slope"], FigureKind::Index, reason, "linearity"));
                return Ok(());
            }
        };
        let sizes = || found.masters.iter().map(|master| master.count);
        let readings = [sizes().min().unwrap_or_default(), sizes().max().unwrap_or_default()];
        self.layout = Some(Layout { kind: study.kind, parts: found.masters.len(), operators: 1, readings });
        self.line(found);
        Ok(())
    }

    fn line(&mut self, found: Linearity) {
        let level = self.wanted.level;
        let line = found.line;
        let method = "least squares";
        self.put(["slope", "slope"], FigureKind::Index, Ok(line.slope_estimate(level)), method);
        self.bare(["slope_p", "p of the slope"], FigureKind::Probability, line.slope.p, method);
        let intercept = ["intercept_mm", "bias at 0"];
        self.put(intercept, FigureKind::Length, Ok(line.at(0.0, level)), method);
        self.bare(["intercept_p", "p of the bias at 0"], FigureKind::Probability, line.intercept.p, method);
        self.bare(["residual_mm", "s about the line"], FigureKind::Length, line.deviation, method);
        self.bare(["explained", "R²"], FigureKind::Index, line.explained, method);
        self.put(["bias_mm", "mean bias"], FigureKind::Length, found.bias, "s within masters");
        self.groups = found
            .masters
            .into_iter()
            .map(|master| Group {
                name: master.reference.to_string(),
                count: master.count,
                figure: Figure::of(
                    ["bias_mm", "bias at"],
                    FigureKind::Length,
                    master.bias,
                    "mean - reference, Student",
                ),
            })
            .collect();
        let p = probability(line.slope.p);
        let changes = line.slope.p < 1.0 - level;
        self.say(if changes { Finding::NotLinear { p } } else { Finding::Linear { p } });
    }

    fn stable(&mut self, series: &Series<'_>, values: &[&Value], study: &StudyWanted) -> Result<(), StudyError> {
        let kind = self.wanted.kind(series);
        let samples = self.wanted.samples(series);
        let sizes = || samples.iter().map(|sample| sample.values.len());
        let readings = [sizes().min().unwrap_or_default(), sizes().max().unwrap_or_default()];
        self.layout = Some(Layout { kind: study.kind, parts: samples.len(), operators: 1, readings });
        if !self.is_one_master(values, study) {
            return Ok(());
        }
        let level = self.wanted.level;
        let counted = samples.iter().filter(|sample| sample.left_out.is_none());
        let readings: Vec<f64> = counted.flat_map(|sample| sample.values.iter().copied()).collect();
        let moments = Moments::of(&readings);
        let mean = moments.clone().and_then(|of| of.mean_estimate(level));
        self.put(["mean_mm", "mean"], FigureKind::Length, mean.clone(), "mean, Student");
        let deviation = moments.and_then(|of| of.deviation_estimate(level));
        self.put(["sd_mm", "s"], FigureKind::Length, deviation, "standard deviation, chi-square");
        // A master without its size is watched all the same.
        let is_known = values.iter().any(|value| study.reference(value).is_some());
        if let (true, Ok(mean)) = (is_known, mean)
            && let Some(reference) = study.one_reference(values)?
        {
            let bias = mean.map(|mean| mean - reference);
            self.put(["bias_mm", "bias"], FigureKind::Length, Ok(bias), "mean - reference, Student");
        }
        match stability(&samples, &plan(&self.wanted, kind), level) {
            Ok(found) => {
                let is_stable = found.is_stable();
                let trend = Advice::of_trend(&found.trend, level);
                let charted = Charted::drawn(found.chart, &samples, &self.wanted);
                self.take(charted);
                self.advice.push(trend);
                self.say(if is_stable { Finding::Stable } else { Finding::NotStable });
            }
            Err(reason) => {
                self.figures.push(Figure::none(["centre_mm", "centre line"], FigureKind::Length, reason, kind.word()));
            }
        }
        Ok(())
    }
}

/// Millimetres for people.
fn mm(size: f64) -> String {
    format!("{size:.4}")
}
