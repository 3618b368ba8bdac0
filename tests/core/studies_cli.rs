//! `fitcheck stats`: published studies, comparisons and charts through the program, and layouts that look wrong.

use std::fmt::Write as _;
use std::path::Path;

use serde_json::Value;

use crate::stats_cli::{answer, near, stats, with};

/// Data of the crate's tests.
fn data(name: &str) -> Value {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("crates/statistics/tests/data").join(name);
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

pub(crate) fn published(id: &str) -> Value {
    let all = data("published_studies.json");
    all.as_array().unwrap().iter().find(|study| study["id"] == id).unwrap().clone()
}

pub(crate) fn numbers(of: &Value) -> Vec<f64> {
    of.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
}

/// Values above each other; sizes are above 0, so that some are moved.
pub(crate) fn column(values: &[f64], moved: f64) -> String {
    values.iter().fold("measured [mm]\n".to_owned(), |mut text, value| {
        writeln!(text, "{:.6}", value + moved).unwrap();
        text
    })
}

/// Readings by part and operator.
pub(crate) fn table(of: &Value) -> String {
    let cells: Vec<Vec<Vec<f64>>> = serde_json::from_value(of.clone()).unwrap();
    let mut text = "part;operator;measured [mm]\n".to_owned();
    for (part, row) in (1..).zip(&cells) {
        for (operator, cell) in ["Anna", "Ben", "Cleo"].iter().zip(row) {
            for reading in cell {
                writeln!(text, "{part};{operator};{reading}").unwrap();
            }
        }
    }
    text
}

/// A figure as printed with so many decimals.
#[track_caller]
fn printed(found: &Value, expected: &Value, decimals: usize) {
    let [found, expected] = [found, expected].map(|number| number.as_f64().unwrap());
    assert_eq!(format!("{found:.decimals$}"), format!("{expected:.decimals$}"));
}

#[track_caller]
fn sentence(found: &Value, begin: &str) {
    let all = found["advice"].as_array().unwrap();
    assert!(all.iter().any(|said| said.as_str().unwrap().starts_with(begin)), "{begin}: {all:?}");
}

#[test]
fn crossed_studies_have_their_published_figures() {
    for (id, parts) in [("gauge_rr_thermal_impedance", 10), ("gauge_rr_interaction_operator_zero", 4)] {
        let study = published(id);
        let (code, found) = answer(&table(&study["data"]), &["--study", "crossed", "--lower", "5", "--upper", "15"]);
        assert_eq!(code, Some(0));
        assert_eq!((found["study"]["parts"].as_u64(), found["study"]["operators"].as_u64()), (Some(parts), Some(3)));
        let computed = &study["computed"];
        for (name, short) in [("part", "part"), ("operator", "op"), ("interaction", "po")] {
            near(&found[format!("ms_{name}")]["value"], computed["MS"][short].as_f64().unwrap(), 1e-8);
            near(&found[format!("p_{name}")]["value"], computed["p"][short].as_f64().unwrap(), 1e-7);
            near(
                &found[format!("var_{name}")]["value"],
                computed["varcomp_with_interaction"][short].as_f64().unwrap(),
                1e-8,
            );
        }
        near(&found["ms_repeatability"]["value"], computed["MS"]["e"].as_f64().unwrap(), 1e-8);
        sentence(&found, "operators differ more on some parts than on others");
    }
    let study = published("gauge_rr_interaction_operator_zero");
    let (_, found) = answer(&table(&study["data"]), &["--study", "crossed", "--lower", "5", "--upper", "15"]);
    let figures = &study["published"];
    near(&found["var_total"]["value"], 0.305, 1e-9);
    printed(&found["percent_contribution"]["value"], &figures["percent_contribution_grr"], 2);
    printed(&found["percent_of_study"]["value"], &figures["percent_study_grr"], 2);
    printed(&found["percent_of_tolerance"]["value"], &figures["percent_tolerance_grr"], 2);
    near(&found["categories"]["value"], 4.0, 1e-15);
    sentence(&found, "good enough: the gauge takes 9.8 % of the tolerance");
    sentence(&found, "the variance of operators came out negative");
    let folder = with(&table(&published("gauge_rr_thermal_impedance")["data"]));
    let (_, out, _) = stats(folder.path(), &["values.csv", "--study", "crossed"]);
    assert!(out.starts_with("read      90 values\nstudy     crossed: 10 parts, 3 operators, 3 repeats\n"), "{out}");
    assert!(out.contains("good enough only where it must do: the gauge takes 19.0 % of all variation"), "{out}");
}

/// Montgomery: batches within suppliers, ten above.
#[test]
fn a_nested_study_is_that_of_montgomery() {
    let readings = [
        [[1, -1, 0], [-2, -3, -4], [-2, 0, 1], [1, 4, 0]],
        [[1, -2, -3], [0, 4, 2], [-1, 0, -2], [0, 3, 2]],
        [[2, 4, 0], [-2, 0, 2], [1, -1, 2], [3, 2, 1]],
    ];
    let rows = |names_are_own: bool| {
        let mut text = "part;operator;measured [mm]\n".to_owned();
        for (supplier, batches) in ["A", "B", "C"].iter().zip(readings) {
            for (batch, cell) in (1..).zip(batches) {
                let own = if names_are_own { *supplier } else { "" };
                for reading in cell {
                    writeln!(text, "{own}{batch};{supplier};{}", reading + 10).unwrap();
                }
            }
        }
        text
    };
    let (code, found) = answer(&rows(true), &["--study", "nested"]);
    assert_eq!((code, &found["study"]["layout"]), (Some(0), &"3 operators, 4 parts each, 3 repeats".into()));
    printed(&found["var_part"]["value"], &1.71.into(), 2);
    printed(&found["var_repeatability"]["value"], &2.64.into(), 2);
    near(&found["var_operator"]["value"], 0.0, 1.0);
    // Batches of the same names may be the same batches.
    let folder = with(&rows(false));
    let (code, _, said) = stats(folder.path(), &["values.csv", "--study", "nested"]);
    assert!(
        code == Some(1)
            && said.contains("parts of the same names: is the study crossed? (if it is right: --confirm-layout)"),
        "{said}"
    );
    let (code, confirmed) = answer(&rows(false), &["--study", "nested", "--confirm-layout"]);
    assert_eq!((code, &confirmed["var_part"]), (Some(0), &found["var_part"]));
    let (code, _, said) = stats(with(&rows(true)).path(), &["values.csv", "--study", "crossed"]);
    assert!(
        code == Some(1) && said.contains("each part was read by one operator only: this is a nested study"),
        "{said}"
    );
}

/// Ten above, as sizes are above 0.
#[test]
fn a_type_1_study_has_its_published_figures_and_answers_the_question() {
    let study = published("type1_gauge_50");
    let text = column(&numbers(&study["data"]), 10.0);
    let call = ["--study", "type1", "--reference", "6", "--lower", "1", "--upper", "16"];
    let (code, found) = answer(&text, &call);
    assert_eq!((code, &found["study"]["layout"]), (Some(0), &"1 master, 50 readings".into()));
    let figures = &study["published"];
    near(&found["mean_mm"]["value"], 6.054, 1e-9);
    near(&found["sd_mm"]["value"], figures["s"].as_f64().unwrap(), 1e-8);
    near(&found["bias_mm"]["value"], 0.054, 1e-9);
    near(&found["bias_t"]["value"], figures["t"].as_f64().unwrap(), 1e-9);
    near(&found["bias_p"]["value"], figures["p"].as_f64().unwrap(), 1e-8);
    printed(&found["cg"]["value"], &figures["Cg"], 2);
    printed(&found["cgk"]["value"], &figures["Cgk"], 2);
    printed(&found["bias_mm"]["lower"], &figures["bias_ci95"][0], 8);
    sentence(&found, "not good enough for this tolerance: Cg and Cgk must reach 1.33");
    // 10 (3.99 s + |bias|)
    near(&found["smallest_tolerance_mm"]["value"], 10.0 * (3.99 * 0.420_014_577 + 0.054), 1e-8);
    sentence(&found, "smallest tolerance that it is good enough for: 17.2986 mm (95 %: up to ");
    sentence(&found, "the bias of +54.0 µm may be chance (p = 0.3677)");
    let (_, wide) = answer(&text, &["--study", "type1", "--reference", "6", "--lower", "0.5", "--upper", "18"]);
    sentence(&wide, "good enough for this tolerance: Cg and Cgk reach 1.33");
    let (_, coarse) = answer(&text, &[&call[..], &["--resolution", "1"]].concat());
    near(&coarse["smallest_tolerance_mm"]["value"], 20.0, 1e-12);
    let (code, open) = answer(&text, &["--study", "type1", "--reference", "6", "--upper", "16"]);
    assert_eq!((code, &open["cg"]["reason"]), (Some(0), &"there is only one limit, and both are needed".into()));
    assert_eq!(open["smallest_tolerance_mm"], found["smallest_tolerance_mm"]);
    let (code, _, said) = stats(with(&text).path(), &["values.csv", "--study", "type1"]);
    assert!(code == Some(1) && said.contains("values without a calibrated size: 50"), "{said}");
}

#[test]
fn a_linearity_study_is_that_of_the_msa_manual() {
    let study = published("linearity_aiag_12x5");
    let (sizes, readings) = (numbers(&study["reference"]), numbers(&study["measured"]));
    let mut text = "part;nominal;measured [mm]\n".to_owned();
    for (size, reading) in sizes.iter().zip(&readings) {
        writeln!(text, "M{size};{size};{reading}").unwrap();
    }
    let references = ["M2=2", "M4=4", "M6=6", "M8=8", "M10=10"].map(|given| ["--reference", given]).concat();
    for call in [&[][..], &references] {
        let (_, found) = answer(&text, &[&["--study", "linearity"], call].concat());
        assert_eq!(found["study"]["layout"], "5 masters, 12 readings each");
        let figures = &study["published"];
        for (name, expected) in [
            ("slope", "slope"),
            ("intercept_mm", "intercept"),
            ("residual_mm", "S"),
            ("explained", "R2"),
            ("bias_mm", "average_bias"),
        ] {
            near(&found[name]["value"], figures[expected].as_f64().unwrap(), 1e-8);
        }
        near(&found["slope_p"]["value"], figures["slope_p"].as_f64().unwrap(), 1e-6);
        for (master, bias) in found["groups"].as_array().unwrap().iter().zip(numbers(&figures["bias"])) {
            near(&master["bias_mm"]["value"], bias, 1e-8);
        }
        sentence(&found, "the bias changes with the size (p = 0.0000)");
    }
}

#[test]
fn capability_has_its_published_figures() {
    let study = published("capability_100");
    let text = column(&numbers(&study["data"]), 0.0);
    let limits = ["--group", "5", "--lower", "0", "--upper", "12", "--target", "6", "--level", "0.9"];
    let (code, found) = answer(&text, &limits);
    assert_eq!(code, Some(0));
    let computed = &study["computed"];
    for (name, expected) in [
        ("sd_mm", "s"),
        ("sigma_mm", "s_within_Rbar_exact_d2"),
        ("pp", "Pp"),
        ("ppk", "Ppk"),
        ("cpm", "Cpm_target_n_minus_1"),
        ("anderson_darling_p", "AD_p"),
    ] {
        near(&found[name]["value"], computed[expected].as_f64().unwrap(), 1e-6);
    }
    for (name, ends) in [("pp", "Pp_ci90"), ("ppk", "Ppk_ci90_bissell"), ("cpm", "Cpm_ci90")] {
        let ends = numbers(&computed[ends]);
        near(&found[name]["lower"], ends[0], 1e-8);
        near(&found[name]["upper"], ends[1], 1e-8);
    }
}

#[test]
fn rules_fire_where_they_were_published_to() {
    let study = published("run_rules_45");
    let (_, found) = answer(&column(&numbers(&study["data"]), 10.0), &[]);
    for (rule, name) in [
        ("nelson-1", "beyond_3s"),
        ("nelson-2", "same_side_9"),
        ("nelson-3", "monotone_6_points"),
        ("nelson-4", "alternating_14_points"),
        ("nelson-5", "two_of_three_beyond_2s"),
        ("nelson-6", "four_of_five_beyond_1s"),
        ("nelson-7", "fifteen_within_1s"),
        ("nelson-8", "eight_beyond_1s"),
    ] {
        let fired = found["rules"].as_array().unwrap().iter().find(|fired| fired["rule"] == rule).unwrap();
        let points: Vec<u64> = serde_json::from_value(fired["points"].clone()).unwrap();
        let expected: Vec<u64> = serde_json::from_value(study["computed"][name].clone()).unwrap();
        // A range beyond its limit fires the first rule, too.
        let is_missing = |point: &&u64| !points.contains(point);
        assert_eq!(expected.iter().find(is_missing), None, "{rule}: {points:?}");
        assert!(rule == "nelson-1" || points == expected, "{rule}: {points:?}");
    }
}

#[test]
fn a_chart_of_viscosities_has_its_published_limits() {
    let study = published("individuals_viscosity_qcc");
    let (_, found) = answer(&column(&numbers(&study["data"]), 0.0), &[]);
    printed(&found["mean_mm"]["value"], &study["published"]["mean"], 3);
    printed(&found["lower_control_mm"]["value"], &32.5656.into(), 4);
    printed(&found["upper_control_mm"]["value"], &35.6104.into(), 4);
}

#[test]
fn an_ewma_chart_is_that_of_the_handbook() {
    let study = published("ewma_nist_6324");
    let text = column(&numbers(&study["data"]), 0.0);
    let (code, found) = answer(&text, &["--chart", "ewma", "--parameters", "0.3,3", "--known", "50,2.0539"]);
    assert_eq!(code, Some(0));
    let averages = numbers(&study["published"]["ewma"]);
    let points = found["memory"].as_array().unwrap();
    // The published list begins with the mean.
    assert_eq!(points.len() + 1, averages.len());
    for (point, average) in points.iter().zip(&averages[1..]) {
        printed(&point["average_mm"], &(*average).into(), 2);
        assert_eq!(point["out"], false);
    }
    near(&found["ewma_upper_mm"]["value"], 52.5884, 2e-6);
    near(&found["ewma_lower_mm"]["value"], 47.4115, 2e-6);
    assert_eq!(found["ewma_mm"]["method"], "EWMA, lambda 0.3, L 3");
    let (_, own) = answer(&text, &["--chart", "ewma"]);
    assert_eq!(own["ewma_mm"]["method"], "EWMA, lambda 0.2, L 2.962");
}

/// Montgomery: the mean moves by 1 s at point 21; the sum alarms at 29 and began at 23.
#[test]
fn a_cusum_says_where_the_shift_began() {
    let values = [
        9.45, 7.99, 9.29, 11.66, 12.16, 10.18, 8.04, 11.46, 9.20, 10.34, 9.03, 11.47, 10.51, 9.40, 10.08, 9.37, 10.62,
        10.31, 8.52, 10.84, 10.90, 9.33, 12.29, 11.50, 10.60, 11.08, 10.38, 11.62, 11.31, 10.52,
    ];
    let text = column(&values, 0.0);
    let (_, found) = answer(&text, &["--chart", "cusum", "--known", "10,1"]);
    let out: Vec<&Value> = found["memory"].as_array().unwrap().iter().filter(|point| point["out"] == true).collect();
    assert_eq!(out[0]["point"], 29);
    printed(&out[0]["above_mm"], &5.28.into(), 2);
    assert_eq!(found["cusum_above_mm"]["method"], "CUSUM, k 0.5, h 5");
    sentence(
        &found,
        "the sum is beyond the decision interval, first at point 29: the mean has moved, since about point 23",
    );
    // In subgroups the limits are those of means.
    let (_, means) = answer(&text, &["--chart", "ewma", "--known", "10,1", "--group", "2"]);
    near(
        &means["ewma_upper_mm"]["value"],
        10.0 + 2.962 * (0.5_f64 * (0.2 / 1.8) * (1.0 - 0.8_f64.powi(30))).sqrt(),
        1e-9,
    );
    let (_, uneven) = answer(&text, &["--chart", "ewma", "--group", "4"]);
    assert_eq!(uneven["ewma_mm"]["reason"], "subgroups have 2 to 4 values: this chart needs subgroups of equal size");
}

/// NIST `StRD`, `SiRstv`.
#[test]
fn groups_are_compared_with_certified_figures() {
    let study = data("nist_strd.json")["anova"].clone();
    let mut text = "operator;measured [mm]\n".to_owned();
    for (name, group) in ["A", "B", "C", "D", "E"].iter().zip(study["groups"].as_array().unwrap()) {
        for value in numbers(group) {
            writeln!(text, "{name};{value}").unwrap();
        }
    }
    let (code, found) = answer(&text, &["--compare", "who"]);
    assert_eq!(code, Some(0));
    near(&found["f"]["value"], study["f"].as_f64().unwrap(), 1e-9);
    assert_eq!(found["groups"].as_array().unwrap().len(), 5);
    assert_eq!((&found["groups"][1]["group"], &found["groups"][1]["count"]), (&"B".into(), &5.into()));
    sentence(&found, "the groups do not differ more than by chance (p = 0.3494)");
    let (code, _, said) = stats(with(&text).path(), &["values.csv", "--compare", "gauge"]);
    assert!(code == Some(1) && said.contains("values that do not say to which group they belong: 25"), "{said}");
    let (code, one) = answer("operator;measured [mm]\nA;10\nA;10.1\n", &["--compare", "who"]);
    assert_eq!((code, &one["f"]["reason"]), (Some(1), &"too few values or groups: 1, at least 2 needed".into()));
}

#[test]
fn a_layout_that_looks_swapped_is_refused_until_it_is_confirmed() {
    let study = published("gauge_rr_thermal_impedance");
    let swapped = table(&study["data"]).replacen("part;operator", "operator;part", 1);
    let folder = with(&swapped);
    let (code, out, said) = stats(folder.path(), &["values.csv", "--study", "crossed"]);
    assert_eq!(code, Some(1));
    assert!(out.contains("crossed: 3 parts, 10 operators, 3 repeats"), "{out}");
    assert!(
        said.contains("are the columns of parts and operators swapped? (if it is right: --confirm-layout)"),
        "{said}"
    );
    assert!(!out.contains("gauge, s"), "{out}");
    let (code, found) = answer(&swapped, &["--study", "crossed", "--confirm-layout"]);
    assert_eq!(code, Some(0));
    sentence(&found, "operators: 10, parts: 3: are the columns");
    // As many parts as operators: the figures give it away.
    let square = "part;operator;measured [mm]\n".to_owned()
        + &["1;A;10", "1;A;10.1", "1;B;20", "1;B;20.2", "2;A;10.1", "2;A;10", "2;B;20.1", "2;B;20"].join("\n");
    let (code, _, said) = stats(with(&square).path(), &["values.csv", "--study", "crossed"]);
    assert!(code == Some(1) && said.contains("operators differ more than parts do"), "{said}");
    let each = "part;operator;measured [mm]\n1;A;10\n1;B;10.1\n2;C;20\n2;D;20.2\n";
    let (code, _, said) = stats(with(each).path(), &["values.csv", "--study", "nested"]);
    assert!(code == Some(1) && said.contains("every value has an operator of its own"), "{said}");
}

#[test]
fn what_is_missing_from_a_study_is_named() {
    let refused = |text: &str, arguments: &[&str]| {
        let (code, _, said) = stats(with(text).path(), &[&["values.csv", "--study"], arguments].concat());
        assert_eq!(code, Some(1));
        said
    };
    let rows = ["1;A;10", "1;A;10.1", "1;B;10", "1;B;10.1", "2;A;10", "2;A;10.1", "2;B;10"];
    let text = format!("part;operator;measured [mm]\n{}\n", rows.join("\n"));
    assert!(refused(&text, &["crossed"]).contains("readings of part 2 by operator B: 1, expected 2"));
    assert!(refused(&text, &["crossed", "--leave-out", "9=gone"]).contains("no point 9: the chart has 7"));
    let own = text.replace("2;B;10\n", "3;A;10\n3;A;10.2\n");
    assert!(refused(&own, &["nested"]).contains("parts of operator B: 1, expected 3"));
    let nobody = text.replace("2;B;10\n", "2;;10\n");
    assert!(refused(&nobody, &["crossed"]).contains("values that name no operator, beside others that do: 1"));
    let bare = "operator;measured [mm]\nA;10\nA;11\n";
    assert!(refused(bare, &["crossed"]).contains("values that name no part: 2"));
    let several = "part;measured [mm]\n1;10\n2;10.1\n";
    assert!(refused(several, &["type1", "--reference", "10"]).contains("the values are of 2 parts"));
    assert!(refused(several, &["linearity"]).contains("values without a calibrated size: 2"));
    let (code, equal) = answer("part;measured [mm]\n1;10\n1;10\n2;10\n2;10\n", &["--study", "crossed"]);
    assert_eq!(
        (code, &equal["gauge_mm"]["reason"]),
        (Some(1), &"all values are equal: there is no spread to compute with".into())
    );
    let (code, empty) = answer("part;measured [mm]\n", &["--study", "type1", "--reference", "10"]);
    assert_eq!((code, &empty["sd_mm"]["reason"]), (Some(1), &"there are no values".into()));
}

#[test]
fn a_drifting_master_is_not_stable() {
    let of = |drift: f64| {
        let steps = [0.3, -0.4, 0.1, 0.5, -0.2, -0.5, 0.2, 0.4, -0.3, -0.1];
        let values: Vec<f64> =
            (0..30_u8).map(|at| 10.0 + steps[usize::from(at % 10)] / 1_000.0 + drift * f64::from(at)).collect();
        answer(&column(&values, 0.0), &["--study", "stability", "--reference", "9.999", "--rules", "nelson-1"]).1
    };
    let still = of(0.0);
    assert_eq!(still["study"]["layout"], "30 points, 1 reading each");
    near(&still["bias_mm"]["value"], 0.001, 1e-6);
    sentence(&still, "stable: no rule fires");
    sentence(&of(0.0002), "not stable: ");
}

#[test]
fn a_point_that_is_left_out_stays_with_its_reason_and_counts_nowhere() {
    let values = ["25.01", "25.012", "25.9", "25.011", "25.013", "25.009"];
    let text = format!("measured [mm]\n{}\n", values.join("\n"));
    let without = text.replace("25.9\n", "");
    let limits = ["--lower", "25", "--upper", "25.021"];
    let (_, found) = answer(&text, &[&limits[..], &["--leave-out", "3=chip in the bore"]].concat());
    let (_, alone) = answer(&without, &limits);
    for name in ["mean_mm", "sd_mm", "sigma_mm", "cpk", "ppk", "upper_control_mm"] {
        assert_eq!(found[name], alone[name], "{name}");
    }
    assert_eq!(found["left_out_points"], serde_json::json!([{ "point": 3, "reason": "chip in the bore" }]));
    assert_eq!(found["outside"]["above"], 0);
    let folder = with(&text);
    let (_, out, _) = stats(folder.path(), &["values.csv", "--leave-out", "3=chip in the bore"]);
    assert!(out.contains("left out  point 3: chip in the bore\n"), "{out}");
    let all: Vec<String> = (1..=6).map(|point| format!("{point}=gone")).collect();
    let all: Vec<&str> = all.iter().flat_map(|given| ["--leave-out", given]).collect();
    let (code, none) = answer(&text, &all);
    assert_eq!((code, &none["mean_mm"]["reason"]), (Some(1), &"there are no values".into()));
}

/// Figures are those of the process as it is now.
#[test]
fn a_stage_has_limits_of_its_own() {
    let first = ["25.01", "25.012", "25.011", "25.013", "25.009"];
    let second = ["25.02", "25.022", "25.019", "25.021", "25.024", "25.02"];
    let text = format!("measured [mm]\n{}\n", [&first[..], &second].concat().join("\n"));
    let alone = |values: &[&str]| answer(&format!("measured [mm]\n{}\n", values.join("\n")), &[]).1;
    let (_, found) = answer(&text, &["--stage", "6"]);
    for name in ["mean_mm", "sd_mm", "centre_mm", "lower_control_mm", "upper_control_mm"] {
        assert_eq!(found[name], alone(&second)[name], "{name}");
    }
    let stages = found["stages"].as_array().unwrap();
    assert_eq!((&stages[0]["last"], &stages[1]["first"]), (&5.into(), &6.into()));
    assert_eq!(stages[0]["upper_mm"], alone(&first)["upper_control_mm"]["value"]);
    let (code, _, said) = stats(with(&text).path(), &["values.csv", "--stage", "12"]);
    assert!(code == Some(1) && said.contains("no point 12: the chart has 11"), "{said}");
}

#[test]
fn features_that_need_a_look_come_first() {
    let mut text = "name;callout;measured\n".to_owned();
    for at in 0..10 {
        let off = [0.0, 1.0, -1.0, 0.5, -0.5][at % 5];
        writeln!(text, "good;25 H7;{:.4}", 25.0105 + 0.0005 * off).unwrap();
        writeln!(text, "tight;40 H7;{:.4}", 40.0125 + 0.006 * off).unwrap();
        writeln!(text, "out;30 H7;{:.4}", if at == 4 { 30.03 } else { 30.0105 + 0.001 * off }).unwrap();
    }
    let (code, found) = answer(&text, &["--all"]);
    assert_eq!(code, Some(0));
    let names: Vec<&str> =
        found["features"].as_array().unwrap().iter().map(|one| one["feature"].as_str().unwrap()).collect();
    assert_eq!(names, ["out", "tight", "good"]);
    assert_eq!(found["look_first"], serde_json::json!(["out", "tight"]));
    assert_eq!(found["features"][0]["outside"], 1);
    let (_, tight) = answer(&text, &["--feature", "tight"]);
    assert_eq!(found["features"][1]["ppk"], tight["ppk"]["value"]);
    let (_, out, _) = stats(with(&text).path(), &["values.csv", "--all"]);
    assert!(out.ends_with("\nlook first at: out, tight\n"), "{out}");
    let differ = text + "good;25 H8;25.01\n";
    let (_, found) = answer(&differ, &["--all"]);
    let good = &found["features"][2];
    assert!(good["ppk"].is_null() && good["reason"].as_str().unwrap().starts_with("limits differ"), "{good}");
}

#[test]
fn a_study_gives_an_uncertainty_budget_its_scatter() {
    let study = published("type1_gauge_50");
    let folder = with(&column(&numbers(&study["data"]), 10.0));
    let call = ["values.csv", "--study", "type1", "--reference", "6", "--budget-out", "gauge.toml"];
    let (code, _, said) = stats(folder.path(), &call);
    assert_eq!(code, Some(0), "{said}");
    let mut command = assert_cmd::Command::new(env!("CARGO_BIN_EXE_fitcheck"));
    let output =
        command.current_dir(folder.path()).args(["budget", "gauge.toml", "--format", "json"]).output().unwrap();
    let budget: Value = serde_json::from_slice(&output.stdout).unwrap();
    near(&budget["u_um"], 420.014_577, 1e-6);
    near(&budget["degrees_of_freedom"], 49.0, 1e-9);
}

/// Readings that scatter by some tenths of a micrometre: a gauge for 0.2 mm, and not for 0.5 µm.
#[test]
fn a_gauge_that_is_not_good_enough_says_so_with_every_check() {
    let folder = tempfile::tempdir().unwrap();
    let run = |arguments: &[&str]| {
        let mut command = assert_cmd::Command::new(env!("CARGO_BIN_EXE_fitcheck"));
        let output = command.current_dir(folder.path()).args(arguments).output().unwrap();
        String::from_utf8(output.stderr).unwrap()
    };
    let mut study = "part;operator;measured [mm]\n".to_owned();
    for (part, operator, tenths) in (0..6_i32)
        .flat_map(|part| ["Anna", "Ben"].into_iter().flat_map(move |who| [0, 3].map(|more| (part, who, more))))
    {
        let tenths = 250_000 + part * 20 + if operator == "Anna" { tenths } else { 1 - tenths };
        writeln!(study, "{};{operator};{}.{:04}", part + 1, tenths / 10_000, tenths % 10_000).unwrap();
    }
    fitcheck::files::write(&folder.path().join("study.csv"), study.as_bytes()).unwrap();
    for (lower, upper, budget, is_told) in [("24.9", "25.1", "good.toml", false), ("25", "25.0005", "bad.toml", true)] {
        let asked = ["--study", "crossed", "--lower", lower, "--upper", upper, "--budget-out", budget];
        let told = run(&[&["stats", "study.csv"], asked.as_slice()].concat());
        assert!(folder.path().join(budget).exists(), "{told}");
        let told = run(&["check", "25 H7", "--measured", "25.010", "--rule", "iso14253-2017", "--budget", budget]);
        assert_eq!(told.contains("a study says of this gauge: not good enough"), is_told, "{told}");
    }
}
