//! Studies of gauges against published ones.

use fitcheck_statistics::gauge::{
    Design, Layout, MasterPlan, StudyPlan, crossed, linearity, master_study, nested, stability,
};
use fitcheck_statistics::{ChartKind, ChartPlan, Ratio, Reason, Row, Rule, Rules, Sample};

use crate::simulated::Simulated;
use crate::{data, near, number, numbers, printed, study, within};

fn cells(of: &serde_json::Value) -> Vec<Vec<Vec<f64>>> {
    serde_json::from_value(of.clone()).unwrap()
}

#[track_caller]
fn row(found: (Row, Option<Ratio>), name: &str, computed: &serde_json::Value) {
    near(found.0.squares, number(&computed["SS"][name]), 1e-8);
    near(found.0.degrees, number(&computed["df"][name]), 1e-15);
    near(found.0.mean_square(), number(&computed["MS"][name]), 1e-8);
    if let Some(ratio) = found.1 {
        near(ratio.f, number(&computed["F"][name]), 1e-8);
        near(ratio.p, number(&computed["p"][name]), 1e-8);
    }
}

#[test]
fn crossed_studies_are_those_published() {
    for id in ["gauge_rr_thermal_impedance", "gauge_rr_interaction_operator_zero"] {
        let study = study(id);
        let computed = &study["computed"];
        let cells = cells(&study["data"]);
        let found = crossed(&cells, &StudyPlan::default()).unwrap();
        let size = |name: &str| usize::try_from(study[name].as_u64().unwrap()).unwrap();
        let (parts, operators, readings) = (size("parts"), size("operators"), size("replicates"));
        assert_eq!(found.layout, Layout { design: Design::Crossed, parts, operators, readings });
        assert!(!found.is_pooled && !found.may_be_swapped());
        row((found.part.0, Some(found.part.1)), "part", computed);
        row(found.operator.map(|(row, ratio)| (row, Some(ratio))).unwrap(), "op", computed);
        row(found.interaction.map(|(row, ratio)| (row, Some(ratio))).unwrap(), "po", computed);
        row((found.repeatability, None), "e", computed);
        let of = found.components;
        let kept = &computed["varcomp_with_interaction"];
        for (name, component) in
            [("e", of.repeatability), ("po", of.interaction), ("op", of.operator), ("part", of.part)]
        {
            within(component.variance, number(&kept[name]), 1e-8 * number(&kept[name]));
        }
        assert!(found.gauge.lower < found.gauge.value && found.gauge.value < found.gauge.upper);
        // No interaction is small enough to be kept: it is pooled.
        let found = crossed(&cells, &StudyPlan { keeps: 0.0, ..StudyPlan::default() }).unwrap();
        let pooled = &computed["varcomp_pooled"];
        assert!(found.is_pooled);
        near(found.repeatability.degrees, number(&pooled["df_e"]), 1e-15);
        near(found.part.1.f, number(&pooled["F_part"]), 1e-8);
        near(found.part.1.p, number(&pooled["p_part"]), 1e-8);
        let (_, operator) = found.operator.unwrap();
        near(operator.f, number(&pooled["F_op"]), 1e-8);
        near(operator.p, number(&pooled["p_op"]), 1e-8);
        for (name, component) in
            [("e", found.components.repeatability), ("op", found.components.operator), ("part", found.components.part)]
        {
            near(component.variance, number(&pooled[name]), 1e-8);
        }
    }
    let thermal = crossed(&cells(&study("gauge_rr_thermal_impedance")["data"]), &StudyPlan::default()).unwrap();
    printed(thermal.components.gauge(), 1.8, 2);
    let zero = study("gauge_rr_interaction_operator_zero");
    let published = &zero["published"];
    let found = crossed(&cells(&zero["data"]), &StudyPlan::default()).unwrap();
    assert!(found.components.operator.is_negative);
    near(found.components.total(), number(&published["var_total"]), 1e-9);
    printed(found.percent_contribution(), number(&published["percent_contribution_grr"]), 1);
    printed(found.percent_of_study(), number(&published["percent_study_grr"]), 2);
    printed(found.percent_of_tolerance(10.0).value, number(&published["percent_tolerance_grr"]), 2);
    // Elsewhere 1 was printed for it.
    within(found.categories(), 4.0, 0.0);
    // At the smallest tolerance the gauge takes just that share.
    near(found.percent_of_tolerance(found.smallest_tolerance(0.3).value).value, 30.0, 1e-12);
}

/// Montgomery, *Design and Analysis of Experiments*, table 14.3: batches within suppliers (remembered; the sums of squares that go
/// with it are those printed there).
#[test]
fn a_nested_study_is_that_of_montgomery() {
    let suppliers = [
        [[1, -1, 0], [-2, -3, -4], [-2, 0, 1], [1, 4, 0]],
        [[1, -2, -3], [0, 4, 2], [-1, 0, -2], [0, 3, 2]],
        [[2, 4, 0], [-2, 0, 2], [1, -1, 2], [3, 2, 1]],
    ];
    let of = suppliers.map(|supplier| supplier.map(|batch| batch.map(f64::from).to_vec()).to_vec()).to_vec();
    let found = nested(&of, &StudyPlan::default()).unwrap();
    assert_eq!(found.layout, Layout { design: Design::Nested, parts: 4, operators: 3, readings: 3 });
    let (operator, ratio) = found.operator.unwrap();
    printed(operator.squares, 15.06, 2);
    printed(found.part.0.squares, 69.92, 2);
    printed(found.repeatability.squares, 63.33, 2);
    printed(ratio.f, 0.97, 2);
    printed(found.part.1.f, 2.94, 2);
    printed(found.components.part.variance, 1.71, 2);
    printed(found.components.repeatability.variance, 2.64, 2);
    assert!(found.components.operator.is_negative && found.interaction.is_none());
}

#[test]
fn type_one_studies_are_those_published() {
    let gauge = data("type1_gauge.json");
    let computed = &gauge["computed"];
    let plan = MasterPlan::of(number(&gauge["reference"]), number(&gauge["tolerance"]));
    let readings = numbers(&gauge["readings"]);
    let found = master_study(&readings, &plan).unwrap();
    let four = master_study(&readings, &MasterPlan { spread: 4.0, ..plan }).unwrap();
    for (name, figure) in [
        ("mean", found.moments.mean),
        ("s", found.deviation.value),
        ("bias", found.bias.value),
        ("t", found.t),
        ("p", found.p),
        ("cg_6s", found.cg.value),
        ("cgk_6s", found.cgk.value),
        ("cg_4s", four.cg.value),
        ("cgk_4s", four.cgk.value),
    ] {
        near(figure, number(&computed[name]), 1e-9);
    }
    assert!(!found.is_good && !four.is_good);
    // What metrology asks for: 39.9 s for Cg, 10 (3.99 s + |bias|) for Cgk.
    near(found.smallest.value, 10.0 * (3.99 * found.deviation.value + found.bias.value), 1e-12);
    let good = MasterPlan { tolerance: found.smallest.value, ..plan };
    let good = master_study(&readings, &good).unwrap();
    near(good.cgk.value, 1.33, 1e-12);
    let coarse = master_study(&readings, &MasterPlan { resolution: Some(0.02), ..plan }).unwrap();
    near(coarse.smallest.value, 0.4, 1e-12);

    let study = study("type1_gauge_50");
    let published = &study["published"];
    let plan = MasterPlan::of(number(&study["reference"]), number(&study["tolerance"]));
    let found = master_study(&numbers(&study["data"]), &plan).unwrap();
    near(found.moments.mean, number(&published["mean"]), 1e-9);
    near(found.deviation.value, number(&published["s"]), 1e-8);
    near(found.bias.value, number(&published["bias"]), 1e-9);
    near(found.t, number(&published["t"]), 1e-9);
    near(found.p, number(&published["p"]), 1e-8);
    printed(found.cg.value, number(&published["Cg"]), 2);
    printed(found.cgk.value, number(&published["Cgk"]), 2);
    printed(20.0 / found.cg.value, number(&published["percent_repeatability"]), 1);
    printed(20.0 / found.cgk.value, number(&published["percent_repeatability_and_bias"]), 2);
    let ends = numbers(&published["bias_ci95"]);
    printed(found.bias.lower, ends[0], 9);
    printed(found.bias.upper, ends[1], 9);
}

#[test]
fn the_linearity_study_is_that_of_the_msa_manual() {
    let study = study("linearity_aiag_12x5");
    let published = &study["published"];
    let readings: Vec<[f64; 2]> = numbers(&study["reference"])
        .into_iter()
        .zip(numbers(&study["measured"]))
        .map(|(reference, measured)| [reference, measured])
        .collect();
    let found = linearity(&readings, 0.95).unwrap();
    for (name, figure) in [
        ("intercept", found.line.intercept.value),
        ("intercept_se", found.line.intercept.error),
        ("intercept_t", found.line.intercept.t),
        ("intercept_p", found.line.intercept.p),
        ("slope", found.line.slope.value),
        ("slope_se", found.line.slope.error),
        ("slope_t", found.line.slope.t),
        ("slope_p", found.line.slope.p),
        ("S", found.line.deviation),
        ("R2", found.line.explained),
        ("average_bias", found.bias.as_ref().unwrap().value),
    ] {
        near(figure, number(&published[name]), 1e-8);
    }
    // As printed by JMP, with the standard deviation within masters.
    let bias = found.bias.unwrap();
    printed(bias.lower, -0.1152, 4);
    printed(bias.upper, 0.0085, 4);
    let biases = numbers(&published["bias"]);
    let ps = numbers(&published["bias_p"]);
    assert_eq!(found.masters.len(), 5);
    for ((master, bias), p) in found.masters.iter().zip(biases).zip(ps) {
        assert_eq!(master.count, 12);
        printed(master.mean, bias, 9);
        near(master.p.unwrap(), p, 1e-8);
    }
    assert!(found.line.slope.p < 0.05);
}

#[test]
fn a_drifting_master_is_not_stable() {
    let of = |drift: f64| {
        let mut simulated = Simulated::of(3);
        let samples: Vec<Sample> =
            (0..40).map(|at| Sample::of(vec![10.0 + simulated.normal() + drift * f64::from(at)])).collect();
        let rules = Rules::NONE.with(Rule::BeyondLimits, true);
        stability(&samples, &ChartPlan { rules, ..ChartPlan::of(ChartKind::Individuals) }, 0.99).unwrap()
    };
    assert!(of(0.0).is_stable());
    let drifting = of(0.1);
    assert!(!drifting.is_stable() && drifting.trend.is_real());
}

#[test]
fn uneven_and_empty_cells_are_named() {
    let mut cells = cells(&study("gauge_rr_interaction_operator_zero")["data"]);
    cells[2][1].pop();
    let plan = StudyPlan::default();
    assert_eq!(crossed(&cells, &plan), Err(Reason::UnevenCell { part: 3, operator: 2, found: 1, needed: 2 }));
    cells[2].pop();
    cells[2].pop();
    assert_eq!(crossed(&cells, &plan), Err(Reason::UnevenCell { part: 3, operator: 2, found: 0, needed: 2 }));
    assert_eq!(crossed(&[], &plan), Err(Reason::Empty));
    assert_eq!(crossed(&[vec![vec![1.0, 2.0]]], &plan), Err(Reason::TooFew { found: 1, needed: 2 }));
    let one = vec![vec![vec![1.0]], vec![vec![2.0]]];
    assert_eq!(crossed(&one, &plan), Err(Reason::TooFew { found: 1, needed: 2 }));
    let equal = vec![vec![vec![1.0, 1.0]], vec![vec![2.0, 2.0]]];
    assert_eq!(crossed(&equal, &plan), Err(Reason::AllEqual));
    assert_eq!(nested(&equal, &plan), Err(Reason::TooFew { found: 1, needed: 2 }));
    let hole = vec![vec![vec![1.0, 2.0]], vec![vec![f64::NAN, 2.0]]];
    assert_eq!(crossed(&hole, &plan), Err(Reason::NotANumber { place: 3 }));
}

/// A probe that nobody holds has one operator: all of the gauge is repeatability.
#[test]
fn a_study_with_one_operator_is_repeatability_alone() {
    let cells = vec![vec![vec![1.0, 1.2]], vec![vec![2.0, 2.2]], vec![vec![3.1, 3.0]]];
    let found = crossed(&cells, &StudyPlan::default()).unwrap();
    assert!(found.operator.is_none() && found.interaction.is_none() && !found.is_pooled);
    near(found.gauge.value.powi(2), (0.02 + 0.02 + 0.005) / 3.0, 1e-12);
    near(found.gauge.lower, found.repeatability_deviation.lower, 1e-12);
    near(found.gauge.upper, found.repeatability_deviation.upper, 1e-12);
}

/// Parts and operators exchanged: the operators seem to differ more than the parts.
#[test]
fn swapped_columns_are_noticed() {
    let cells = cells(&study("gauge_rr_thermal_impedance")["data"]);
    let swapped: Vec<Vec<Vec<f64>>> =
        (0..3).map(|operator| cells.iter().map(|part| part[operator].clone()).collect()).collect();
    assert!(crossed(&swapped, &StudyPlan::default()).unwrap().may_be_swapped());
}

/// 2 000 simulated studies of 10 parts, 3 operators and 3 readings.
#[test]
fn the_interval_of_the_gauge_holds_its_level() {
    let mut simulated = Simulated::of(11);
    let mut held = 0;
    for _ in 0..2_000 {
        let operators = simulated.normals(3);
        let parts: Vec<f64> = simulated.normals(10).iter().map(|part| 4.0 * part).collect();
        let cells: Vec<Vec<Vec<f64>>> = parts
            .iter()
            .map(|part| {
                let cell = |operator: &f64| {
                    let interaction = 0.7 * simulated.normal();
                    simulated.normals(3).iter().map(|error| part + operator + interaction + error).collect()
                };
                operators.iter().map(cell).collect()
            })
            .collect();
        let found = crossed(&cells, &StudyPlan::default()).unwrap().gauge;
        let truth = (1.0_f64 + 0.49 + 1.0).sqrt();
        held += u32::from(found.lower <= truth && truth <= found.upper);
    }
    let level = f64::from(held) / 2_000.0;
    assert!((0.93..0.975).contains(&level), "{level}");
}
