//! Press fits against published worked examples, their rules, and `fitcheck fit --press`.

#![cfg(test)]

use assert_cmd::cargo::cargo_bin_cmd;
use fitcheck::length::Length;
use fitcheck::tolerance::Sources;
use fitcheck::tolerance::fit::Fit;
use fitcheck::tolerance::fit::materials::Materials;
use fitcheck::tolerance::fit::press::{Cylinders, Elastic, Joint, Press, PressError, PressPart, PressRemark, Ratio};
use fitcheck::tolerance::fit::thermal::Range;
use proptest::prelude::*;

fn mm(text: &str) -> Length {
    text.parse().unwrap()
}

fn part(modulus_mpa: u32, poisson: &str, yield_mpa: Option<u32>) -> PressPart {
    let elastic = Elastic { modulus_mpa, poisson: poisson.parse().unwrap(), yield_mpa };
    PressPart { elastic, expansion: "11".parse().unwrap(), contraction: "8.5".parse().ok(), range: Range::USUAL }
}

fn steel() -> PressPart {
    part(210_000, "0.3", Some(10_000))
}

fn joint([length, hub_outer, shaft_bore]: [&str; 3], friction: &str, [hub, shaft]: [PressPart; 2]) -> Joint {
    let friction: Ratio = friction.parse().unwrap();
    let [length, hub_outer, shaft_bore] = [length, hub_outer, shaft_bore].map(mm);
    Joint { length, hub_outer, shaft_bore, roughness: Length::ZERO, friction, hub, shaft }
}

/// A published figure, with what its rounding allows.
#[track_caller]
fn close(found: f64, published: f64, within: f64) {
    assert!((found - published).abs() <= within, "{found} and {published}");
}

fn press(nominal: &str, interference: &str, joint: &Joint) -> Press {
    Press::of_interference(mm(nominal), [mm(interference); 2], joint).unwrap()
}

/// aionlinecalculator.com/press-fit-calculator.html, "Worked example" and its table: 50 in 80 mm, 40 mm long, E 210 `GPa`, μ 0.12.
#[test]
fn the_example_of_50_in_80_mm_with_its_table() {
    let joint = joint(["40", "80", "0"], "0.12", [steel(), steel()]);
    for (interference, pressure, torque) in [("0.02", 25.6, 482.0), ("0.04", 51.2, 965.0), ("0.06", 76.8, 1447.0)] {
        let found = press("50", interference, &joint);
        close(found.pressure[1].unwrap(), pressure, 0.1);
        close(found.torque.unwrap(), torque, 1.0);
    }
    let found = press("50", "0.04", &joint);
    close(found.axial_force.unwrap(), 38_600.0, 50.0);
    close(found.hub.tangential, 117.0, 0.5);
}

/// machinecalcs.com/press-fit-interference-calculator, "Worked example": the same sizes, E 200 `GPa`, μ 0.15.
#[test]
fn the_example_of_50_in_80_mm_of_softer_steel() {
    let soft = part(200_000, "0.3", None);
    let found = press("50", "0.04", &joint(["40", "80", "0"], "0.15", [soft, soft]));
    close(found.pressure[1].unwrap(), 48.8, 0.06);
    close(found.pressing_force.unwrap(), 45_950.0, 60.0);
    close(found.torque.unwrap(), 1149.0, 1.0);
    close(found.hub.tangential, 111.3, 0.2);
}

/// novasolver.jp/en/tools/shrink-fit-stress.html, the values of its defaults: 100 in 150 mm, 50 mm long, 0.1 mm, E 210 `GPa`, μ 0.15.
#[test]
fn the_example_of_100_in_150_mm() {
    let found = press("100", "0.1", &joint(["50", "150", "0"], "0.15", [steel(), steel()]));
    // Ours are rounded up.
    close(found.pressure[1].unwrap(), 58.3, 0.11);
    close(found.hub.tangential, 151.7, 0.11);
    close(found.shaft.tangential, -58.3, 0.11);
    close(found.torque.unwrap(), 6_870.0, 5.0);
}

/// metricmech.com/calculators/press-fit.html, "Worked Press-Fit Example": 25 in 50 mm, 20 mm long, 0.02 mm, E 210 `GPa`, μ 0.1.
#[test]
fn the_example_of_25_in_50_mm() {
    let found = press("25", "0.02", &joint(["20", "50", "0"], "0.1", [steel(), steel()]));
    close(found.pressure[1].unwrap(), 63.0, 0.5);
    close(found.hub.tangential, 105.0, 0.5);
    close(found.pressing_force.unwrap(), 9_900.0, 20.0);
}

/// `github.com/slehmann1/PressFits`, `pressfits/tests/test_plane_stress_press_fit_model.py`: von Mises stresses of inner and outer part, two
/// materials, hollow shafts; radii in metres there, and the last row is of a finite-element program.
#[test]
fn the_examples_of_hollow_shafts_of_another_material() {
    let aluminium = part(68_900, "0.33", None);
    for (radii, shaft, hub, stresses) in [
        ([400, 500, 600], steel(), aluminium, [10.53, 11.57]),
        ([400, 500, 600], aluminium, steel(), [12.46, 13.7]),
        ([3_000, 5_000, 7_000], steel(), aluminium, [21.47, 25.32]),
        ([3_000, 5_000, 7_000], aluminium, steel(), [29.65, 34.97]),
        ([20, 30, 50], steel(), aluminium, [257.6, 197.79]),
    ] {
        let [bore, nominal, outer] = radii.map(|radius| (2 * radius).to_string());
        let interference = if radii[1] == 5_000 { "4" } else { "0.2" };
        let joint = joint(["100", &outer, &bore], "0.1", [hub, shaft]);
        let found = press(&nominal, interference, &joint);
        close(found.shaft.equivalent, stresses[0], 0.11);
        close(found.hub.equivalent, stresses[1], 0.11);
        // Not rounded, to the published decimals.
        let cylinders = Cylinders::of(mm(&nominal), &joint).unwrap();
        let pressure = cylinders.pressure(mm(interference));
        let ratio = (f64::from(radii[0]) / f64::from(radii[1])).powi(2);
        close(2.0 * pressure / (1.0 - ratio), stresses[0], 0.006);
    }
}

/// Joining temperature and play by the formulas of the sheet "Berechnungsgleichungen für Pressverbindungen II" (WHZ): a thousandth of
/// the diameter for play, 11 · 10⁻⁶/K for heating and 8.5 · 10⁻⁶/K for cooling steel.
#[test]
fn joining_temperatures_take_the_largest_interference_and_the_play() {
    let joint = joint(["30", "80", "0"], "0.12", [steel(), steel()]);
    let found = Press::of_interference(mm("40"), [mm("0.018"), mm("0.059")], &joint).unwrap();
    assert_eq!(found.play, mm("0.04"));
    // 0.099 mm of 40 mm: 225 K of heat; 291 K of cold are colder than liquid nitrogen.
    assert_eq!((found.heat_hub, found.cool_shaft), (None, None));
    assert!(found.remarks.iter().any(|remark| matches!(remark, PressRemark::TooHot { .. })));
    let found = Press::of_interference(mm("40"), [mm("0.003"), mm("0.02")], &joint).unwrap();
    assert_eq!((found.heat_hub, found.cool_shaft), (Some(157.0), Some(-157.0)));
}

#[test]
fn roughness_loses_four_fifths_of_itself_and_only_of_what_holds() {
    let smooth = joint(["30", "80", "0"], "0.12", [steel(), steel()]);
    let rough = Joint { roughness: mm("0.010"), ..smooth };
    let of = |joint: &Joint| Press::of_interference(mm("40"), [mm("0.018"), mm("0.059")], joint).unwrap();
    assert_eq!((of(&rough).loss, of(&rough).interference), (mm("0.008"), [mm("0.01"), mm("0.059")]));
    let ratio = of(&rough).axial_force.unwrap() / of(&smooth).axial_force.unwrap();
    close(ratio, 10.0 / 18.0, 1e-3);
    assert_eq!(of(&rough).pressing_force, of(&smooth).pressing_force);
    let lost = of(&Joint { roughness: mm("0.030"), ..smooth });
    assert_eq!((lost.axial_force, lost.torque), (None, None));
    assert!(lost.remarks.contains(&PressRemark::AllSmoothed { loss: mm("0.024") }));
}

#[test]
fn what_yields_is_said_and_holds_nothing() {
    let weak = part(210_000, "0.3", Some(235));
    let found = press("50", "0.1", &joint(["40", "80", "0"], "0.12", [weak, steel()]));
    assert_eq!((found.is_elastic(), found.pressure, found.torque), (Some(false), [None, None], None));
    assert_eq!((found.axial_force, found.pressing_force), (None, None));
    assert!(matches!(found.remarks.first(), Some(PressRemark::Yields { .. })), "{:?}", found.remarks);
    let unknown = part(70_000, "0.33", None);
    let found = press("50", "0.02", &joint(["40", "80", "0"], "0.12", [unknown, steel()]));
    assert_eq!(found.is_elastic(), None);
    assert!(found.remarks.iter().any(|remark| matches!(remark, PressRemark::YieldUnknown { .. })));
}

#[test]
fn a_fit_that_may_be_loose_holds_nothing_for_sure() {
    let fit = |text: &str| Fit::of_callout(&text.parse().unwrap(), &Sources::default()).unwrap();
    let joint = joint(["40", "80", "0"], "0.12", [steel(), steel()]);
    let found = Press::of(&fit("50 H7/k6"), &joint).unwrap();
    assert_eq!((found.interference[0], found.axial_force), (Length::ZERO, None));
    assert!(found.remarks.iter().any(|remark| matches!(remark, PressRemark::MayBeLoose { .. })));
    assert!(matches!(Press::of(&fit("50 H7/g6"), &joint), Err(PressError::NoInterference { .. })));
    assert!(matches!(Press::of(&fit("50 H7/h6"), &joint), Err(PressError::NoInterference { .. })));
}

#[test]
fn a_joint_that_is_none_is_refused() {
    let good = joint(["40", "80", "0"], "0.12", [steel(), steel()]);
    let of = |joint: Joint| Press::of_interference(mm("50"), [mm("0.01"), mm("0.02")], &joint).unwrap_err();
    assert!(matches!(of(Joint { length: mm("0"), ..good }), PressError::Length { .. }));
    assert!(matches!(of(Joint { hub_outer: mm("50"), ..good }), PressError::HubOuter { .. }));
    assert!(matches!(of(Joint { shaft_bore: mm("50"), ..good }), PressError::ShaftBore { .. }));
    assert!(matches!(of(Joint { shaft_bore: mm("-1"), ..good }), PressError::ShaftBore { .. }));
    assert!(matches!(of(Joint { roughness: mm("-1"), ..good }), PressError::Roughness { .. }));
    assert!(matches!(of(Joint { friction: "0".parse().unwrap(), ..good }), PressError::Friction));
}

#[test]
fn ratios_are_read_exactly_or_refused() {
    for (text, value) in [("0.12", 0.12), ("0,3", 0.3), ("1", 1.0), (" .5 ", 0.5), ("0.120", 0.12)] {
        assert_eq!(text.parse::<Ratio>().unwrap().value().to_bits(), f64::to_bits(value), "{text}");
    }
    for text in ["", "-0.1", "1.001", "0.1234", "12", "x", "NaN", "1e-1"] {
        assert!(text.parse::<Ratio>().is_err(), "{text}");
    }
}

#[test]
fn materials_have_what_a_press_fit_needs_or_say_so() {
    let shipped = Materials::shipped();
    let part = shipped.find("steel").unwrap().press_part().unwrap();
    assert_eq!((part.elastic.modulus_mpa, part.elastic.yield_mpa), (210_000, Some(235)));
    assert!(matches!(shipped.find("POM").unwrap().press_part(), Err(PressError::Material { .. })));
    let file = |more: &str| Materials::read(&format!("version = 1\n[[material]]\nname = \"x\"\nexpansion = 1\n{more}"));
    assert!(file("modulus = 210000\npoisson = 0.3\nyield = 355\ncontraction = 8.5").is_ok());
    for wrong in
        ["modulus = 1", "poisson = 0.3", "yield = 3", "modulus = 0\npoisson = 0.3", "modulus = 1\npoisson = 0.6"]
    {
        assert!(file(wrong).is_err(), "{wrong}");
    }
}

fn fitcheck(args: &[&str]) -> (Option<i32>, String, String) {
    let answer = cargo_bin_cmd!("fitcheck").arg("fit").args(args).assert();
    let output = answer.get_output();
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
    (output.status.code(), text(&output.stdout), text(&output.stderr))
}

const GIVEN: [&str; 6] = ["40 H7/s6", "--press", "--length", "30", "--hub-outer", "80"];

#[test]
fn the_command_line_answers_in_text_and_figures() {
    let (code, out, error) = fitcheck(&[&GIVEN[..], &["--hub-yield", "600", "--shaft-yield", "600"]].concat());
    assert_eq!(code, Some(0), "{out}{error}");
    for words in ["interference 18 … 59 µm", "MPa", "holds at least", "pressing force at most", "joining"] {
        assert!(out.contains(words), "{words}: {out}");
    }
    assert!(error.contains("no roughness Rz was given"), "{error}");
    let (code, out, _) = fitcheck(&[&GIVEN[..], &["--hub-yield", "600", "--format", "json"]].concat());
    let json: serde_json::Value = serde_json::from_str(&out).unwrap();
    let press = &json["press"];
    assert_eq!((code, press["elastic"].as_str()), (Some(0), Some("yes")));
    // 0.018 mm and 0.059 mm of 40 mm, E 210 GPa, (1 - 1/4)/2.
    assert_eq!(press["minimum_pressure_mpa"].as_f64(), Some(35.4));
    assert_eq!(press["maximum_pressure_mpa"].as_f64(), Some(116.2));
    assert_eq!(press["shaft_yield_mpa"].as_f64(), Some(235.0));
}

#[test]
fn a_hub_that_yields_asks_for_a_look() {
    let (code, out, error) = fitcheck(&GIVEN);
    assert_eq!(code, Some(14), "{out}{error}");
    assert!(error.contains("NOT ELASTIC: the stress of the hub"), "{error}");
    assert!(out.contains("not elastic: no pressure, force or torque can be given"), "{out}");
    assert!(!out.contains("holds"), "{out}");
    let (code, _, error) = fitcheck(&[&GIVEN[..], &["--hub-material", "POM", "--shaft-material", "steel"]].concat());
    assert!(code == Some(1) && error.contains("the modulus of elasticity of POM is not known"), "{error}");
    let (code, _, error) = fitcheck(&["40 H7/g6", "--press", "--length", "30", "--hub-outer", "80"]);
    assert!(code == Some(1) && error.contains("a press fit needs an interference"), "{error}");
}

proptest! {
    #[test]
    fn any_joint_is_answered_or_refused_and_more_interference_never_holds_less(
        nominal in 1_i64..3_000_000_000,
        outer in 0_i64..6_000_000_000,
        bore in -1_i64..3_000_000_000,
        least in -1_000_000_i64..1_000_000,
        more in 0_i64..1_000_000,
        rough in 0_i64..50_000,
    ) {
        let nm = |nm| Length::from_nanometres(nm).unwrap();
        let hub_outer = nm(outer);
        let strong = part(210_000, "0.3", None);
        let joint = Joint { hub_outer, shaft_bore: nm(bore), roughness: nm(rough), ..joint(["40", "80", "0"], "0.12", [strong, strong]) };
        let of = |least, most| Press::of_interference(nm(nominal), [nm(least), nm(most)], &joint);
        if let (Ok(one), Ok(other)) = (of(least, least + more), of(least + 1_000, least + more + 1_000)) {
            prop_assert!(one.axial_force <= other.axial_force);
            prop_assert!(one.pressing_force <= other.pressing_force);
            prop_assert!(one.hub.equivalent <= other.hub.equivalent && one.hub.equivalent.is_finite());
            prop_assert!(one.torque.is_none_or(f64::is_finite));
        }
    }
}
