//! Decision rules against worked examples: `tests/data/rules/vectors.json`, from JCGM 106, NCSLI RP-19, Deaver and computations with
//! more digits (docs/SOURCES.md, "Decision rules"), through the command line.

use assert_cmd::Command;
use fitcheck::length::Length;
use fitcheck::message::Say as _;
use fitcheck::tolerance::{Bounds, Deviations, Feature};
use fitcheck::verdict::rules::{Prover, RuleError, RuleInputs, RuleName, Uncertainty, UncertaintyError};
use fitcheck::verdict::{Rule, Status};
use proptest::prelude::*;
use serde_json::Value;

fn vectors() -> Vec<Value> {
    let path = format!("{}/tests/data/rules/vectors.json", env!("CARGO_MANIFEST_DIR"));
    let file: Value = serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap();
    file["vectors"].as_array().unwrap().clone()
}

fn of_kind(kind: &str) -> Vec<Value> {
    let found: Vec<Value> = vectors().into_iter().filter(|vector| vector["type"] == kind).collect();
    assert!(!found.is_empty(), "{kind}");
    found
}

/// The answer as JSON, and the exit code.
fn asked(arguments: &[String]) -> (Value, Option<i32>) {
    let output =
        Command::new(env!("CARGO_BIN_EXE_fitcheck")).args(arguments).args(["--format", "json"]).output().unwrap();
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    (serde_json::from_slice(&output.stdout).unwrap_or_else(|_| panic!("{arguments:?}: {said}")), output.status.code())
}

fn decide(options: &[(&str, String)]) -> Value {
    let options = options.iter().flat_map(|(name, value)| [format!("--{name}"), value.clone()]);
    asked(&std::iter::once("decide".to_owned()).chain(options).collect::<Vec<_>>()).0
}

fn check(callout: &str, measured: f64, options: &[&str]) -> (Value, Option<i32>) {
    let front = ["check", callout, "--measured", &format!("{measured}")].map(str::to_owned);
    asked(&front.into_iter().chain(options.iter().map(|&option| option.to_owned())).collect::<Vec<_>>())
}

/// A number times a power of ten as a decimal, so that no digits are lost in whole nanometres.
fn scaled(value: &Value, factor: f64) -> String {
    format!("{:.6}", value.as_f64().unwrap() * factor)
}

#[track_caller]
fn near(found: &Value, wanted: f64, allowed: f64) {
    let found = found.as_f64().unwrap_or_else(|| panic!("{found}"));
    assert!((found - wanted).abs() <= allowed, "{found} instead of {wanted}");
}

#[test]
fn conformity_is_that_of_jcgm_106() {
    for vector in of_kind("pc_one_sided_upper") {
        let options = [
            ("upper", scaled(&vector["usl"], 1.0)),
            ("measured", scaled(&vector["y"], 1.0)),
            ("u", scaled(&vector["u"], 1e3)),
        ];
        let found = decide(&options);
        near(&found["conformity"], vector["pc"].as_f64().unwrap(), 1e-12);
        assert_eq!(found["min_mm"], Value::Null);
    }
    for vector in of_kind("pc_two_sided") {
        let options = [
            ("lower", scaled(&vector["lsl"], 1.0)),
            ("upper", scaled(&vector["usl"], 1.0)),
            ("measured", scaled(&vector["y"], 1.0)),
            ("u", scaled(&vector["u"], 1e3)),
        ];
        near(&decide(&options)["conformity"], vector["pc"].as_f64().unwrap(), 1e-12);
    }
}

#[test]
fn global_risks_are_those_of_the_worked_examples() {
    // Lengths are whole nanometres: a thousand times larger they keep nine digits of the examples.
    let large = 1e3;
    for vector in of_kind("global_risk_normal") {
        let (limit, accept) = (vector["limit"].as_f64().unwrap(), vector["accept"].as_f64().unwrap());
        let mut options = vec![
            ("lower", format!("-{}", scaled(&vector["limit"], large))),
            ("upper", scaled(&vector["limit"], large)),
            ("process-mean", "0".to_owned()),
            ("process-sd", format!("{:.3}", vector["sigma_process"].as_f64().unwrap() * large * 1e3)),
            ("u", scaled(&vector["u"], large * 1e3)),
        ];
        if accept < limit {
            options.extend([("rule", "fixed".to_owned()), ("guard", format!("{:.3}", (limit - accept) * large * 1e3))]);
        }
        let found = decide(&options);
        if let Some(percent) = vector["RC_percent"].as_f64() {
            near(&found["consumer_risk"], percent / 100.0, 1e-9);
            near(&found["consumer_risk"], vector["published_percent"].as_f64().unwrap() / 100.0, 1.1e-8);
        } else {
            near(&found["consumer_risk"], vector["RC"].as_f64().unwrap(), 1e-9);
            near(&found["producer_risk"], vector["RP"].as_f64().unwrap(), 1e-9);
        }
    }
    for vector in of_kind("global_risk") {
        // Micrometres, taken as millimetres.
        let options = [
            ("upper", scaled(&vector["usl"], 1.0)),
            ("u", scaled(&vector["u"], 1e3)),
            ("gamma", "4,250".to_owned()),
            ("consumer-risk", "0.001".to_owned()),
        ];
        let found = decide(&options);
        near(&found["nonconforming"], vector["p_nonconforming"].as_f64().unwrap(), 1e-9);
        near(&found["consumer_risk"], vector["RC_simple"].as_f64().unwrap(), 1e-9);
        near(&found["producer_risk"], vector["RP_simple"].as_f64().unwrap(), 1e-9);
        near(&found["risk_zone_max_mm"], vector["A_for_RC_0p001"].as_f64().unwrap(), 1e-7);
        near(&found["risk_zone_producer_risk"], vector["RP_at_A"].as_f64().unwrap(), 1e-7);
    }
}

#[test]
fn the_guard_band_of_iso_14253_counts_both_limits_exactly() {
    let large = 1e6;
    for vector in of_kind("guard_table") {
        for row in vector["rows"].as_array().unwrap() {
            let options = [
                ("lower", "0".to_owned()),
                ("upper", scaled(&row["T_over_u"], large)),
                ("u", format!("{}", large * 1e3)),
                ("rule", "iso14253-2017".to_owned()),
            ];
            let found = decide(&options);
            near(&found["zone_min_mm"], row["g_over_u"].as_f64().unwrap() * large, 1e-3);
        }
        let least = vector["no_value_can_be_proven_below_T_over_u"].as_f64().unwrap();
        for (ratio, is_nothing) in [(least - 1e-9, true), (least + 1e-9, false)] {
            let options = [
                ("lower", "0".to_owned()),
                ("upper", format!("{:.6}", ratio * large)),
                ("u", format!("{}", large * 1e3)),
                ("rule", "iso14253-2017".to_owned()),
            ];
            assert_eq!(decide(&options)["accepts_nothing"], Value::Bool(is_nothing), "{ratio}");
        }
        let one_sided =
            [("lower", "0".to_owned()), ("u", format!("{}", large * 1e3)), ("rule", "iso14253-2017".to_owned())];
        near(&decide(&one_sided)["zone_min_mm"], vector["one_sided_limit"].as_f64().unwrap() * large, 1e-3);
    }
}

#[test]
fn bore_and_shaft_have_the_states_of_the_table_through_check() {
    for vector in of_kind("zones") {
        let callout = if vector["feature"] == "bore" { "25 H7" } else { "25 g6" };
        for row in vector["rows"].as_array().unwrap() {
            let measured = row["y"].as_f64().unwrap();
            let word = |name: &str| {
                if row[name] == "UNCERTAIN" { "RE-MEASURE".to_owned() } else { row[name].as_str().unwrap().to_owned() }
            };
            for (rule, name) in
                [("simple", "simple"), ("iso14253-2017", "guard_1p645_u"), ("iso14253-1998", "guard_2_u")]
            {
                let (found, code) = check(callout, measured, &["--rule", rule, "--u", "1.2"]);
                assert_eq!(found["status"].as_str().unwrap(), word(name), "{callout} {measured} {rule}");
                near(&found["conformity"], row["pc"].as_f64().unwrap(), 5.1e-6);
                let codes = [("GOOD", 0), ("REWORK", 10), ("SCRAP", 11), ("RE-MEASURE", 12)];
                assert_eq!(code, codes.iter().find(|(status, _)| *status == word(name)).map(|(_, code)| *code));
                if rule != "simple" {
                    assert_eq!(found["proven"], Value::Bool(word(name) != "RE-MEASURE"));
                }
            }
        }
    }
}

fn mm(text: &str) -> Length {
    text.parse().unwrap()
}

fn bounds(feature: Feature, minimum: &str, maximum: &str) -> Bounds {
    Bounds::new(feature, Length::ZERO, Deviations::new(mm(maximum), mm(minimum)).unwrap()).unwrap()
}

fn rule(name: RuleName, prover: Prover) -> Rule {
    let width = name.takes_width().then(|| mm("0.002"));
    Rule::new(name, RuleInputs { uncertainty: Some(Uncertainty::standard("1").unwrap()), factor: None, width, prover })
        .unwrap()
}

/// For each rule: where accepted values begin within or beyond the lower limit, and where rejected ones begin, µm from it, for a zone
/// of 21 µm and u = 1 µm. 1.645 u is 1.644854 µm, the next whole nanometre 1.645 µm.
const BORDERS: [(RuleName, Prover, f64, f64); 12] = [
    (RuleName::Simple, Prover::Supplier, 0.0, 0.0),
    (RuleName::Iso14253Of2017, Prover::Supplier, 1.645, -1.645),
    (RuleName::Iso14253Of2017, Prover::Customer, -1.645, -1.645),
    (RuleName::Iso14253Of1998, Prover::Supplier, 2.0, -2.0),
    (RuleName::Iso14253Of1998, Prover::Customer, -2.0, -2.0),
    (RuleName::IlacG8, Prover::Supplier, 2.0, -2.0),
    (RuleName::IlacG8, Prover::Customer, -2.0, -2.0),
    (RuleName::AsmeSimple, Prover::Supplier, 0.0, 0.0),
    (RuleName::AsmeStringent, Prover::Supplier, 2.0, 0.0),
    (RuleName::AsmeRelaxed, Prover::Supplier, -2.0, -2.0),
    (RuleName::Fixed, Prover::Supplier, 2.0, -2.0),
    (RuleName::Fixed, Prover::Customer, -2.0, -2.0),
];

#[test]
fn every_rule_has_a_row_of_borders() {
    for name in RuleName::ALL {
        let provers = BORDERS.iter().filter(|row| row.0 == name).count();
        assert_eq!(provers, if name.takes_prover() { 2 } else { 1 }, "{name:?}");
    }
}

#[test]
fn borders_belong_to_the_zones_and_a_nanometre_more_does_not() {
    let um = |um: f64| Length::from_mm_f64(um / 1000.0).unwrap();
    let nm = |nm: i64| Length::from_nanometres(nm).unwrap();
    for feature in [Feature::Hole, Feature::Shaft] {
        let bounds = bounds(feature, "25", "25.021");
        let (small, large) =
            if feature == Feature::Hole { (Status::Rework, Status::Scrap) } else { (Status::Scrap, Status::Rework) };
        for (name, prover, accepted, rejected) in BORDERS {
            let rule = rule(name, prover);
            let status = |measured: Length| rule.status(&bounds, measured);
            let plus = |one: Length, other: Length| one.checked_add(other).unwrap();
            let minus = |one: Length, other: Length| one.checked_sub(other).unwrap();
            let (first, last) = (plus(mm("25"), um(accepted)), minus(mm("25.021"), um(accepted)));
            let (least, most) = (plus(mm("25"), um(rejected)), minus(mm("25.021"), um(rejected)));
            for inside in [first, plus(first, nm(1)), minus(last, nm(1)), last] {
                assert_eq!(status(inside), Status::Good, "{name:?} {prover:?} {feature:?} {inside}");
            }
            let between =
                |outside: Status| if (accepted - rejected).abs() < 1e-9 { outside } else { Status::ReMeasure };
            assert_eq!(status(minus(first, nm(1))), between(small), "{name:?} {prover:?} {feature:?} below");
            assert_eq!(status(plus(last, nm(1))), between(large), "{name:?} {prover:?} {feature:?} above");
            assert_eq!(status(minus(least, nm(1))), small, "{name:?} {prover:?} {feature:?}");
            assert_eq!(status(plus(most, nm(1))), large, "{name:?} {prover:?} {feature:?}");
            if (accepted - rejected).abs() > 1e-9 {
                assert_eq!(
                    (status(least), status(most)),
                    (Status::ReMeasure, Status::ReMeasure),
                    "{name:?} {feature:?}"
                );
            }
        }
    }
}

#[test]
fn where_the_uncertainty_is_too_large_nothing_is_accepted_and_it_is_said() {
    let narrow = bounds(Feature::Hole, "25", "25.003");
    for name in [
        RuleName::Iso14253Of2017,
        RuleName::Iso14253Of1998,
        RuleName::IlacG8,
        RuleName::AsmeStringent,
        RuleName::AsmeSimple,
    ] {
        let rule = rule(name, Prover::Supplier);
        assert_eq!(rule.zones(&narrow).accepted, None, "{name:?}");
        assert_eq!(rule.status(&narrow, mm("25.0015")), Status::ReMeasure, "{name:?}");
    }
    // 4:1 holds from a tolerance of eight times U on, and not a nanometre less.
    let simple = rule(RuleName::AsmeSimple, Prover::Supplier);
    assert_eq!(simple.status(&bounds(Feature::Hole, "25", "25.016"), mm("25.016")), Status::Good);
    assert_eq!(simple.status(&bounds(Feature::Hole, "25", "25.015999"), mm("25.01")), Status::ReMeasure);
    assert_eq!(simple.status(&bounds(Feature::Hole, "25", "25.015999"), mm("26")), Status::ReMeasure);
    let output = Command::new(env!("CARGO_BIN_EXE_fitcheck"))
        .args(["check", "25 H7", "--measured", "25.01", "--rule", "iso14253-1998", "--u", "6"])
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(12));
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.contains("no value is accepted: the rule leaves no part of this tolerance"), "{said}");
}

#[test]
fn what_is_removed_brings_the_size_to_where_the_rule_accepts_it() {
    let removed = |options: &[&str]| {
        let (found, _) = check("25 H7", 24.997, options);
        (found["remove_um"].as_f64().unwrap(), found["remove_to_middle_um"].as_f64().unwrap())
    };
    assert_eq!(removed(&[]), (3.0, 13.5));
    assert_eq!(removed(&["--rule", "iso14253-1998", "--u", "1"]), (5.0, 13.5));
    assert_eq!(removed(&["--rule", "iso14253-1998", "--u", "1", "--prover", "customer"]), (3.0, 13.5));
}

#[test]
fn what_is_accepted_beyond_a_limit_has_another_word() {
    let limits = fitcheck::tolerance::Sources::default().limits(&"25 H7".parse().unwrap(), None).unwrap();
    let u = Uncertainty::standard("1").ok();
    for prover in [Prover::Supplier, Prover::Customer] {
        let given = RuleInputs { uncertainty: u, prover, ..RuleInputs::default() };
        let rule = Rule::new(RuleName::Iso14253Of1998, given).unwrap();
        for (size, is_beyond) in
            [("25", false), ("25.021", false), ("25.021001", true), ("25.023", true), ("24.998", true)]
        {
            let verdict = fitcheck::verdict::judge_by(rule, &limits, mm(size), None);
            let is_accepted = is_beyond && prover == Prover::Customer;
            assert_eq!(verdict.is_beyond_limits(), is_accepted, "{size} {prover:?}");
            let word = if is_accepted { "ACCEPTED" } else { verdict.status().word() };
            assert_eq!(verdict.message().to_string(), word, "{size} {prover:?}");
        }
    }
    let options = ["--rule", "iso14253-1998", "--u", "1", "--prover", "customer"];
    let (found, _) = check("25 H7", 25.022, &options);
    assert_eq!((&found["status"], &found["proven"]), (&"GOOD".into(), &false.into()));
    assert!(found["warnings"].to_string().contains("the size is outside the limits; the rule accepts it"), "{found}");
    assert!(!check("25 H7", 25.020, &options).0["warnings"].to_string().contains("outside the limits"));
    let mut command = Command::new(env!("CARGO_BIN_EXE_fitcheck"));
    let output = command.args(["check", "25 H7", "--measured", "25.022"]).args(options).output().unwrap();
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(said.contains("warning: outside the limits: accepted by the rule"), "{said}");
}

#[test]
fn a_rule_has_what_it_needs_and_nothing_without_effect() {
    let u = Uncertainty::standard("1").ok();
    let refused = |name: RuleName, given: RuleInputs| Rule::new(name, given).unwrap_err();
    for name in RuleName::ALL {
        assert_eq!(RuleName::of_word(name.word()), Some(name));
        let needs = !matches!(name, RuleName::Simple | RuleName::Fixed);
        if needs {
            assert_eq!(refused(name, RuleInputs::default()), RuleError::NoUncertainty { rule: name.word() });
        }
        if !name.takes_factor() {
            let given = RuleInputs { uncertainty: u, factor: Some(1), ..RuleInputs::default() };
            assert_eq!(refused(name, given), RuleError::NoFactor { rule: name.word() });
        }
        if !name.takes_width() {
            let given = RuleInputs { uncertainty: u, width: Some(mm("1")), ..RuleInputs::default() };
            assert_eq!(refused(name, given), RuleError::NoWidth { rule: name.word() });
        }
    }
    let none = RuleInputs { width: Some(Length::ZERO), ..RuleInputs::default() };
    assert_eq!(refused(RuleName::Fixed, none), RuleError::WidthMissing { rule: "fixed" });
    let customer = RuleInputs { prover: Prover::Customer, ..RuleInputs::default() };
    assert_eq!(refused(RuleName::Simple, customer), RuleError::NoProver { rule: "simple" });
    assert_eq!(Uncertainty::standard("0"), Err(UncertaintyError::NotPositive));
    assert!(matches!(Uncertainty::standard("x"), Err(UncertaintyError::Length(_))));
    assert!(Uncertainty::factor("0.9").is_err() && Uncertainty::factor("10.001").is_err());
    let expanded = Uncertainty::expanded("2.4", 2_000).unwrap();
    assert_eq!((expanded.um(), expanded.expanded_um(), expanded.k()), ("1.2".into(), "2.4".into(), "2".into()));
}

#[test]
fn a_coverage_factor_without_an_uncertainty_is_wrong_usage() {
    let code = |options: &[&str]| {
        let front = ["check", "25 H7", "--measured", "25.01"];
        Command::new(env!("CARGO_BIN_EXE_fitcheck")).args(front).args(options).output().unwrap().status.code()
    };
    assert_eq!(code(&["--k", "3"]), Some(2));
    assert_eq!(code(&["--u", "1", "--expanded", "2"]), Some(2));
    assert_eq!(code(&["--u", "1", "--k", "3"]), Some(0));
}

#[test]
fn csv_and_reports_have_the_rule_where_there_is_one() {
    let run = |arguments: &[&str]| {
        let output = Command::new(env!("CARGO_BIN_EXE_fitcheck")).args(arguments).output().unwrap();
        String::from_utf8(output.stdout).unwrap()
    };
    let plain = run(&["check", "25 H7", "--measured", "25.01", "--format", "csv"]);
    assert!(!plain.contains("zone_min_mm"));
    let guarded = run(&["check", "25 H7", "--measured", "25.01", "--format", "csv", "--rule", "ilac-g8", "--u", "1.2"]);
    assert!(
        guarded
            .lines()
            .next()
            .unwrap()
            .ends_with(",simulated,rule_name,u_um,k,zone_min_mm,zone_max_mm,conformity,proven")
    );
    assert!(guarded.contains(",ilac-g8,1.2,2,25.0024,25.0186,"), "{guarded}");
    let of = |format: &str| {
        run(&[
            "report",
            "--check",
            "25 H7=25.0195",
            "-o",
            "-",
            "--format",
            format,
            "--rule",
            "iso14253-2017",
            "--u",
            "1.2",
        ])
    };
    assert!(of("csv").contains("RE-MEASURE") && of("json").contains("\"zone_max_mm\": 25.019026"), "{}", of("json"));
    assert!(of("html").contains("ISO 14253-1:2017"), "{}", of("html"));
}

proptest! {
    /// Where conformity is proven, its probability is 95 % or more. Nonconformity is proven outside of the limits alone, and beyond the
    /// nanometre at which conformity still has 5 %.
    #[test]
    fn proofs_of_iso_14253_are_proofs(width in 1_i64..200_000, pm in 1_i64..50_000_000, at in -400_000_i64..400_000) {
        let maximum = Length::from_nanometres(25_000_000 + width).unwrap();
        let bounds = Bounds::new(Feature::Hole, Length::ZERO, Deviations::new(maximum, mm("25")).unwrap()).unwrap();
        let uncertainty = Uncertainty::standard(&format!("{}.{:06}", pm / 1_000_000, pm % 1_000_000)).unwrap();
        let rule = Rule::new(RuleName::Iso14253Of2017, RuleInputs { uncertainty: Some(uncertainty), ..RuleInputs::default() }).unwrap();
        let measured = Length::from_nanometres(25_000_000 + at).unwrap();
        let within = rule.conformity(&bounds, measured).unwrap();
        prop_assert!((within.within + within.below + within.above - 1.0).abs() < 1e-12);
        let status = rule.status(&bounds, measured);
        prop_assert_eq!(status == Status::Good, 0.95 <= within.within);
        let nearer = Length::from_nanometres(25_000_000 + at - at.signum()).unwrap();
        let is_out = !(0..=width).contains(&at) && rule.conformity(&bounds, nearer).unwrap().within <= 0.05;
        prop_assert_eq!(matches!(status, Status::Rework | Status::Scrap), is_out);
    }
}

/// One limit and the same limit with another one far away have the same answers.
#[test]
fn one_limit_alone_has_the_guard_band_of_a_limit() {
    for (limits, far) in [([("upper", "0.002")], ("lower", "-1")), ([("lower", "0.002")], ("upper", "1"))] {
        let options = |both: bool, prover: &str, measured: &str| {
            let mut options: Vec<_> = limits.iter().map(|(name, value)| (*name, (*value).to_owned())).collect();
            options.extend(both.then(|| (far.0, far.1.to_owned())));
            let others = [("rule", "iso14253-2017"), ("u", "0.25"), ("prover", prover), ("measured", measured)];
            options.extend(others.map(|(name, value)| (name, value.to_owned())));
            decide(&options)
        };
        for prover in ["supplier", "customer"] {
            for measured in ["0.0015", "0.0018", "0.002", "0.0022", "0.0025", "0.0044", "-0.002"] {
                let (one, both) = (options(false, prover, measured), options(true, prover, measured));
                for name in ["status", "proven"] {
                    assert_eq!(one[name], both[name], "{limits:?} {prover} {measured} {name}");
                }
            }
        }
    }
    let output = Command::new(env!("CARGO_BIN_EXE_fitcheck"))
        .args(["decide", "--lower", "25", "--rule", "asme-simple", "--u", "100", "--measured", "25.01"])
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(1), "{}", String::from_utf8_lossy(&output.stderr));
}

/// However wide the process: the share of a uniform density about a limit, u √(2/π) / 2 on either side of it, is the risk.
#[test]
fn the_risks_of_a_wide_process_are_those_about_the_limits() {
    use fitcheck::verdict::rules::{Acceptance, Prior, Risks};
    for (u, deviation) in [(1.0, 1e4), (0.01, 1e4), (1.0, 1e3)] {
        let limits = [25_000.0, 25_021.0];
        let risks = Risks::of(Prior::Normal { mean: 25_010.5, deviation }, &Acceptance { limits, accepted: limits, u });
        let density = 1.0 / (deviation * std::f64::consts::TAU.sqrt());
        let expected = 2.0 * density * u / std::f64::consts::TAU.sqrt();
        assert!((risks.consumer / expected - 1.0).abs() < 1e-4, "{u} {deviation}: {risks:?} {expected}");
    }
}

#[test]
fn a_percentage_shows_on_which_side_of_five_and_ninety_five_it_lies() {
    use fitcheck::verdict::rules::percent;
    for (probability, text) in
        [(0.5, "50.00"), (0.050_000_4, "5.00004"), (0.949_999, "94.9999"), (0.9995, "99.95"), (0.000_02, "0.0020")]
    {
        assert_eq!(percent(probability), text);
    }
}
