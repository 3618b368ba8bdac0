//! Studies of gauges: is this gauge good enough for this tolerance, and what is the smallest one that it is good enough for?

use fitcheck_statistics::gauge::{
    ACCEPTED_SHARE, Finding, GOOD_SHARE, Linearity, MasterPlan, Study, StudyPlan, crossed, linearity, master_study,
    nested, stability,
};
use fitcheck_statistics::{Advice, ENOUGH_VALUES, Estimate, Moments, Ratio, Reason, Row, Tolerance, probability};

use super::Series;
use super::charted::{Charted, plan};
use super::figure::{Figure, FigureKind, FigureMethod};
use super::figures::{Answer, Contribution, Group};
use super::layout::{Cells, StudyError, StudyKind, Understood};
use super::study_wanted::{StudyWanted, masters, one_master, points};
use super::value::Value;
use super::wanted::Wanted;

impl Answer {
    /// What a study says of a gauge. Points that are left out are values, in the order of the series; in a stability study those of its
    /// chart.
    ///
    /// # Errors
    /// Values that make no study.
    pub fn of_study(series: &Series<'_>, wanted: &Wanted, study: &StudyWanted) -> Result<Self, StudyError> {
        let mut answer = Self::begun(wanted);
        let values = study.values(series, wanted);
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

    fn bias(&mut self, bias: Estimate, p: f64) {
        self.put(["bias_mm", "bias"], FigureKind::Length, Ok(bias), FigureMethod::Bias);
        self.bare(["bias_p", "p of the bias"], FigureKind::Probability, p, FigureMethod::TTest);
        let um = format!("{:+.1}", bias.value * 1_000.0);
        let is_chance = 1.0 - self.wanted.level <= p;
        let p = probability(p);
        self.say(if is_chance { Finding::NotBiased { um, p } } else { Finding::Biased { um, p } });
    }

    fn type1(&mut self, values: &[&Value], study: &StudyWanted, width: &Result<f64, Reason>) -> Result<(), StudyError> {
        let count = values.len();
        let understood = one_master(values, study.kind, (1, [count; 2]));
        self.layout = Some(understood.layout);
        if !self.looks_right(understood.doubts, study) {
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
                self.figures.push(Figure::none(["sd_mm", "s"], FigureKind::Length, reason, FigureMethod::Type1));
                return Ok(());
            }
        };
        self.bare(["reference_mm", "reference"], FigureKind::Length, reference, FigureMethod::Given);
        let mean = found.bias.map(|bias| bias + reference);
        self.put(["mean_mm", "mean"], FigureKind::Length, Ok(mean), FigureMethod::Mean);
        self.put(["sd_mm", "s"], FigureKind::Length, Ok(found.deviation), FigureMethod::Deviation);
        self.bias(found.bias, found.p);
        self.bare(["bias_t", "t of the bias"], FigureKind::Index, found.t, FigureMethod::TTest);
        let [percent, spread] = [100.0 * plan.share, plan.spread].map(|number| number.to_string());
        let share = FigureMethod::Share { percent, spread };
        for (name, estimate) in [(["cg", "Cg"], found.cg), (["cgk", "Cgk"], found.cgk)] {
            self.put(name, FigureKind::Index, width.clone().map(|_| estimate), share.clone());
        }
        let smallest = ["smallest_tolerance_mm", "smallest tolerance"];
        let required = plan.required.to_string();
        self.put(
            smallest,
            FigureKind::Length,
            Ok(found.smallest),
            FigureMethod::Required { required: required.clone() },
        );
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
        let Understood { layout, doubts, faults } = cells.understood;
        if let Some(fault) = faults.into_iter().next() {
            return Err(fault);
        }
        self.layout = Some(layout);
        if !self.looks_right(doubts, study) {
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
            Err(reason) => self.figures.push(Figure::none(
                ["gauge_mm", "gauge, s"],
                FigureKind::Length,
                reason,
                FigureMethod::Anova,
            )),
        }
        Ok(())
    }

    /// The analysis of variance, and what becomes of it.
    fn rows(&mut self, found: &Study) {
        let components = &found.components;
        let mut row = |names: [[&'static str; 2]; 2], of: Option<(Row, Ratio)>| {
            if let Some((row, ratio)) = of {
                let method = FigureMethod::Degrees { degrees: row.degrees.to_string() };
                self.bare(names[0], FigureKind::Square, row.mean_square(), method);
                self.bare(
                    names[1],
                    FigureKind::Probability,
                    ratio.p,
                    FigureMethod::Ratio { f: format!("{:.3}", ratio.f) },
                );
            }
        };
        row([["ms_part", "mean square, parts"], ["p_part", "p of parts"]], Some(found.part));
        row([["ms_operator", "mean square, operators"], ["p_operator", "p of operators"]], found.operator);
        row([["ms_interaction", "mean square, interaction"], ["p_interaction", "p of interaction"]], found.interaction);
        let method = FigureMethod::Degrees { degrees: found.repeatability.degrees.to_string() };
        let repeated = ["ms_repeatability", "mean square, repeatability"];
        self.bare(repeated, FigureKind::Square, found.repeatability.mean_square(), method);
        for (name, component) in [
            (["var_part", "variance, parts"], components.part),
            (["var_operator", "variance, operators"], components.operator),
            (["var_interaction", "variance, interaction"], components.interaction),
            (["var_repeatability", "variance, repeatability"], components.repeatability),
        ] {
            let method = if component.is_negative { FigureMethod::Negative } else { FigureMethod::Anova };
            self.bare(name, FigureKind::Square, component.variance, method);
        }
        self.bare(["var_gauge", "variance, gauge"], FigureKind::Square, components.gauge(), FigureMethod::Anova);
        self.bare(["var_total", "variance, total"], FigureKind::Square, components.total(), FigureMethod::Anova);
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
        self.put(
            ["repeatability_mm", "repeatability, s"],
            FigureKind::Length,
            Ok(repeatability),
            FigureMethod::ChiSquare,
        );
        self.put(["gauge_mm", "gauge, s"], FigureKind::Length, Ok(found.gauge), FigureMethod::LargeSample);
        let (contribution, of_study) = (found.percent_contribution(), found.percent_of_study());
        self.bare(
            ["percent_contribution", "share of variance"],
            FigureKind::Percent,
            contribution,
            FigureMethod::Variances,
        );
        self.bare(["percent_of_study", "share of all readings"], FigureKind::Percent, of_study, "6 s");
        let of_tolerance = width.clone().map(|width| found.percent_of_tolerance(width));
        self.put(["percent_of_tolerance", "share of the tolerance"], FigureKind::Percent, of_tolerance, "6 s");
        self.bare(
            ["categories", "distinct categories"],
            FigureKind::Index,
            found.categories(),
            FigureMethod::Categories,
        );
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
        let layout = masters(&references);
        let readings: Vec<[f64; 2]> =
            references.into_iter().zip(values).map(|(size, value)| [size, value.measured.to_mm_f64()]).collect();
        let found = match linearity(&readings, self.wanted.level) {
            Ok(found) => found,
            Err(reason) => {
                self.figures.push(Figure::none(["slope", "slope"], FigureKind::Index, reason, FigureMethod::Linearity));
                return Ok(());
            }
        };
        self.layout = Some(layout);
        self.line(found);
        Ok(())
    }

    fn line(&mut self, found: Linearity) {
        let level = self.wanted.level;
        let line = found.line;
        let method = || FigureMethod::LeastSquares;
        self.put(["slope", "slope"], FigureKind::Index, Ok(line.slope_estimate(level)), method());
        self.bare(["slope_p", "p of the slope"], FigureKind::Probability, line.slope.p, method());
        let intercept = ["intercept_mm", "bias at 0"];
        self.put(intercept, FigureKind::Length, Ok(line.at(0.0, level)), method());
        self.bare(["intercept_p", "p of the bias at 0"], FigureKind::Probability, line.intercept.p, method());
        self.bare(["residual_mm", "s about the line"], FigureKind::Length, line.deviation, method());
        self.bare(["explained", "R²"], FigureKind::Index, line.explained, method());
        self.put(["bias_mm", "mean bias"], FigureKind::Length, found.bias, FigureMethod::WithinMasters);
        self.groups = found
            .masters
            .into_iter()
            .map(|master| Group {
                name: master.reference.to_string(),
                count: master.count,
                figure: Figure::of(["bias_mm", "bias at"], FigureKind::Length, master.bias, FigureMethod::Bias),
            })
            .collect();
        let p = probability(line.slope.p);
        let changes = line.slope.p < 1.0 - level;
        self.say(if changes { Finding::NotLinear { p } } else { Finding::Linear { p } });
    }

    fn stable(&mut self, series: &Series<'_>, values: &[&Value], study: &StudyWanted) -> Result<(), StudyError> {
        let kind = self.wanted.kind(series);
        let samples = self.wanted.samples(series);
        let understood = one_master(values, study.kind, points(&samples));
        self.layout = Some(understood.layout);
        if !self.looks_right(understood.doubts, study) {
            return Ok(());
        }
        let level = self.wanted.level;
        let counted = samples.iter().filter(|sample| sample.left_out.is_none());
        let readings: Vec<f64> = counted.flat_map(|sample| sample.values.iter().copied()).collect();
        let moments = Moments::of(&readings);
        let mean = moments.clone().and_then(|of| of.mean_estimate(level));
        self.put(["mean_mm", "mean"], FigureKind::Length, mean.clone(), FigureMethod::Mean);
        let deviation = moments.and_then(|of| of.deviation_estimate(level));
        self.put(["sd_mm", "s"], FigureKind::Length, deviation, FigureMethod::Deviation);
        // A master without its size is watched all the same.
        let is_known = values.iter().any(|value| study.reference(value).is_some());
        if let (true, Ok(mean)) = (is_known, mean)
            && let Some(reference) = study.one_reference(values)?
        {
            let bias = mean.map(|mean| mean - reference);
            self.put(["bias_mm", "bias"], FigureKind::Length, Ok(bias), FigureMethod::Bias);
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
