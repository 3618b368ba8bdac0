//! Zones out of all proportion to their size, and temperatures that are on another scale: nothing is judged by them before somebody says
//! that they are meant.

#![cfg(test)]

use std::fs;

use assert_cmd::Command;
use fitcheck::length::Length;
use fitcheck::tolerance::fit::materials::Materials;
use fitcheck::tolerance::fit::thermal::{Expansion, Range, Temperature, ThermalDoubt, ThermalError};
use fitcheck::tolerance::proportion::{doubt, widest};
use fitcheck::tolerance::{Bounds, Deviations, Feature, Sources};
use proptest::prelude::*;
use tempfile::TempDir;

/// The exit code, standard output and standard error of a call.
fn fitcheck(arguments: &[&str]) -> (Option<i32>, String, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_fitcheck")).args(arguments).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code(), text(output.stdout), text(output.stderr))
}

fn length(text: &str) -> Length {
    text.parse().unwrap()
}

/// What is said of a callout that is doubted, and which callout is offered.
#[track_caller]
fn asked(callout: &str, offer: &str) {
    let (code, out, said) = fitcheck(&["limits", callout]);
    assert_eq!((code, out.as_str()), (Some(1), ""), "{callout}: {said}");
    assert!(said.contains("if the deviations are in micrometres"), "{callout}: {said}");
    let said = said.split(" (character").next().unwrap().trim_end();
    assert!(said.ends_with(&format!("write {offer}")), "{callout}: {said}");
}

/// The callouts of the issue, and what a drawing says: the deviations as thousandths of a millimetre.
#[test]
fn deviations_that_were_typed_in_micrometres_are_asked_about() {
    asked("25 +21/0", "25 +0.021 0");
    asked("100 +35/0", "100 +0.035 0");
    asked("25 ±24", "25 ±0.024");
    asked("25 -7/-20", "25 -0.007 -0.02");
    // Down to zero and beyond.
    asked("25 ±25", "25 ±0.025");
    asked("25 -20/-41", "25 -0.02 -0.041");
    asked("25 0 -52", "25 0 -0.052");
}

/// Nothing can be offered for limits of size, nor for deviations that are none as micrometres either.
#[test]
fn limits_that_are_too_far_apart_are_refused_without_a_guess() {
    for callout in ["40/25", "25 +5000 0", "25 +0.021 -20"] {
        let (code, out, said) = fitcheck(&["limits", callout]);
        assert_eq!((code, out.as_str()), (Some(1), ""), "{callout}: {said}");
        assert!(said.contains("out of all proportion") && said.contains("check nominal size"), "{callout}: {said}");
    }
}

/// ISO 286-1, table 1: IT 18 is 1.4 mm up to 3 mm, 2.2 up to 10, 3.3 up to 30, 5.4 up to 120, 33 up to 3150.
#[test]
fn zones_that_drawings_have_are_not_doubted() {
    for callout in [
        "0.5 ±0.2",
        "0.5c",
        "8 +1/0",
        "12 ±0.02",
        "25.021/25.000",
        "25 ±1.65",
        "25 +3.3/0",
        "100 -0.1/-0.5",
        "3000 ±16.5",
        "5000 ±16.5",
        "1.2 h18",
        "3 js18",
        "3150 H18",
        "400v",
    ] {
        let (code, _, said) = fitcheck(&["limits", callout]);
        assert_eq!(code, Some(0), "{callout}: {said}");
    }
}

#[test]
fn the_border_is_it18_itself() {
    for (nominal, widest_mm) in [
        ("0.3", "1.4"),
        ("1", "1.4"),
        ("3", "1.4"),
        ("3.000001", "1.8"),
        ("25", "3.3"),
        ("30", "3.3"),
        ("30.000001", "3.9"),
        ("3150", "33"),
        ("3150.000001", "33"),
        ("9000", "33"),
    ] {
        assert_eq!(widest(length(nominal)), length(widest_mm), "{nominal}");
    }
    let of = |upper_nm: i64| {
        let deviations = Deviations::new(Length::from_nanometres(upper_nm).unwrap(), Length::ZERO).unwrap();
        doubt(&Bounds::new(Feature::Hole, length("25"), deviations).unwrap())
    };
    assert_eq!(of(3_300_000), None);
    assert!(of(3_300_001).is_some());
    // A minimum of a nanometre is above zero.
    let down_to = |minimum_nm: i64| {
        let lower = Length::from_nanometres(minimum_nm - 1_000_000).unwrap();
        doubt(&Bounds::new(Feature::Shaft, length("1"), Deviations::new(Length::ZERO, lower).unwrap()).unwrap())
    };
    assert_eq!(down_to(1), None);
    assert!(down_to(0).is_some());
}

proptest! {
    /// Inside IT 18 and above zero nothing is doubted; everything else is.
    #[test]
    fn what_is_doubted_is_wider_than_it18_or_reaches_to_zero(
        nominal in 1_i64..6_000_000_000,
        lower in -40_000_000_i64..40_000_000,
        width in prop_oneof![0_i64..4_000_000, 0_i64..80_000_000],
    ) {
        let nm = |nm| Length::from_nanometres(nm).unwrap();
        let deviations = Deviations::new(nm(lower + width), nm(lower)).unwrap();
        let bounds = Bounds::new(Feature::Hole, nm(nominal), deviations).unwrap();
        let fits = nm(width) <= widest(nm(nominal)) && 0 < nominal + lower;
        prop_assert_eq!(doubt(&bounds).is_none(), fits);
    }

    /// Whatever is offered is not doubted itself, and a thousandth of what was given.
    #[test]
    fn what_is_offered_is_a_thousandth(nominal in 1_i64..4_000, upper in 0_i64..2_000, lower in -2_000_i64..=0) {
        let mm = |mm: i64| Length::from_nanometres(mm * 1_000_000).unwrap();
        let deviations = Deviations::new(mm(upper), mm(lower)).unwrap();
        let bounds = Bounds::new(Feature::Hole, mm(nominal), deviations).unwrap();
        if let Some(offer) = doubt(&bounds).and_then(|doubt| doubt.meant().copied()) {
            let limits = Sources::default().limits(&offer, Some(Feature::Hole)).unwrap();
            prop_assert_eq!(limits.deviations.upper().nanometres() * 1_000, upper * 1_000_000);
            prop_assert_eq!(limits.deviations.lower().nanometres() * 1_000, lower * 1_000_000);
        }
    }
}

#[test]
fn a_wide_zone_is_judged_only_where_it_is_meant_and_is_told() {
    let asked = ["check", "25 +21/0", "--measured", "30", "--feature", "hole"];
    let (code, out, said) = fitcheck(&asked);
    assert_eq!((code, out.as_str()), (Some(1), ""), "{said}");
    assert!(said.contains("write 25 +0.021 0") && said.contains("--wide-zone"), "{said}");
    let (code, out, said) = fitcheck(&[&asked[..], &["--wide-zone"]].concat());
    assert_eq!(code, Some(0), "{said}");
    assert!(out.contains("GOOD") && said.contains("a zone of 21 mm is out of all proportion to 25 mm"), "{out}{said}");
    let (code, out, said) = fitcheck(&["limits", "25 +21/0", "--wide-zone"]);
    assert_eq!(code, Some(0), "{said}");
    assert!(out.contains("46.000") && said.contains("out of all proportion"), "{out}{said}");
}

/// A folder with files.
struct Shop(TempDir);

impl Shop {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn with(&self, name: &str, text: &str) -> String {
        let path = self.0.path().join(name);
        fitcheck::files::write(&path, text.as_bytes()).unwrap();
        path.display().to_string()
    }
}

/// A call that judges nothing and says what to write.
#[track_caller]
fn refuses(arguments: &[&str], offer: &str) {
    let (code, out, said) = fitcheck(arguments);
    assert_eq!(code, Some(1), "{arguments:?}: {out}{said}");
    assert!(!out.contains("GOOD"), "{arguments:?}: {out}");
    assert!(format!("{out}{said}").contains(offer), "{arguments:?}: {out}{said}");
}

#[test]
fn files_with_deviations_in_micrometres_are_refused_with_the_remedy() {
    let shop = Shop::new();
    let rows = shop.with("rows.csv", "name;callout;measured\nA;25 +21/0;30\nB;25 -7/-20;10\n");
    refuses(&["import", &rows], "write 25 +0.021 0");
    refuses(&["report", &rows, "-o", "-", "--format", "csv"], "write 25 +0.021 0");
    refuses(&["batch", &rows], "write 25 +0.021 0");
    let plan = shop.with("plan.csv", "name;callout;feature\nA;25 +21/0;hole\n");
    refuses(&["plan", "check", &plan], "write 25 +0.021 0");
    let plan = shop
        .with("plan.toml", "fitcheck_plan = 1\n[[feature]]\nname = \"A\"\ncallout = \"25 ±24\"\nfeature = \"hole\"\n");
    refuses(&["plan", "check", &plan], "write 25 ±0.024");
    refuses(&["report", "--check", "25 +21/0=30", "-o", "-", "--format", "csv"], "write 25 +0.021 0");
    // With the option it is taken as it stands.
    let (code, out, said) = fitcheck(&["plan", "check", &plan, "--wide-zone"]);
    assert_eq!(code, Some(0), "{out}{said}");
    let (_, _, said) = fitcheck(&["import", &rows, "--wide-zone"]);
    assert!(!said.contains("proportion"), "{said}");
}

/// A control's own log says its limits as sizes: 46 and 25 mm.
#[test]
fn limits_of_other_tools_that_are_out_of_all_proportion_are_refused_with_the_remedy() {
    let shop = Shop::new();
    let log = include_str!("../data/samples/logs/en/TCHPR421.TXT");
    assert!(log.contains("25.0210"));
    let wide = log.replace("25.0210", "46.0000").replace("25.0134", "30.0000").replace(" 0.0134", " 5.0000");
    refuses(&["import", &shop.with("TCHPR421.TXT", &wide)], "write 25 +0.021 0");
    let aqdef = "K0100 1\nK1001/1 P\nK2001/1 7\nK2002/1 D\nK2009/1 202\nK2101/1 25\nK2112/1 0\nK2113/1 21\nK2142/1 mm\nK2103/1 H\nK2104/1 7\nK0001/1 30\n";
    refuses(&["import", &shop.with("d.dfq", aqdef)], "write 25 +0.021 0");
    let qif = include_str!("../data/qif/minimal_bore_25H7.qif");
    let wide = qif.replace("25.021", "46");
    assert_ne!(wide, qif);
    refuses(&["import", &shop.with("d.qif", &wide)], "write 25 +0.021 0");
}

/// The cells of a table are micrometres; 21000 of them are 21 mm.
#[test]
fn an_own_table_out_of_all_proportion_is_refused() {
    let shop = Shop::new();
    let folder = shop.0.path().join("own");
    fs::create_dir(&folder).unwrap();
    let table = |upper: &str, lower: &str| {
        let text = format!("BEGIN own.tab\nNR BEREICH PF\n0  30      {upper}\n1          {lower}\n[END]\n");
        fitcheck::files::write(&folder.join("own.tab"), text.as_bytes()).unwrap();
    };
    let own = folder.display().to_string();
    table("+21000", "0");
    refuses(&["limits", "25 PF", "--tables", &own], "write 25 +0.021 0");
    let rows = shop.with("rows.csv", "callout;measured\n25 PF;30\n25 PF;31\n");
    refuses(&["batch", &rows, "--tables", &own], "write 25 +0.021 0");
    refuses(&["import", &rows, "--tables", &own], "write 25 +0.021 0");
    // Within one step the zone reaches to zero for the smaller size alone, whichever is asked first.
    table("0", "-1400");
    for rows in ["1.5 PF;1.2\n1.3 PF;1.2\n", "1.3 PF;1.2\n1.5 PF;1.2\n"] {
        let rows = shop.with("rows.csv", &format!("callout;measured\n{rows}"));
        for of in ["batch", "import"] {
            let (code, out, said) = fitcheck(&[of, &rows, "--tables", &own]);
            assert_eq!(code, Some(1), "{out}{said}");
            assert!(format!("{out}{said}").contains("minimum limit -0.1 mm is not above 0"), "{out}{said}");
        }
    }
}

/// A face lies anywhere: 2 ±1 is a coordinate like any other, and ±20 is none.
#[test]
fn coordinates_may_have_wide_zones_up_to_those_of_half_a_metre() {
    let shop = Shop::new();
    let plan = |callout: &str| {
        format!("name;kind;axis;callout;x\nF;face;-X;{callout};{}\n", callout.split(' ').next().unwrap())
    };
    let (code, out, said) = fitcheck(&["plan", "check", &shop.with("near.csv", &plan("2 ±1"))]);
    assert_eq!(code, Some(0), "{out}{said}");
    refuses(&["plan", "check", &shop.with("far.csv", &plan("50 ±20"))], "write +0.02 -0.02");
}

fn temperature(text: &str) -> Temperature {
    text.parse().unwrap()
}

/// 68 °F = (68 − 32) · 5 / 9 = 20 °C; 293.15 K = 20 °C; 293 K = 19.85 °C.
#[test]
fn degrees_fahrenheit_and_kelvin_are_asked_about() {
    let said = |given: &str| {
        ThermalDoubt::of_measured(temperature(given)).map(|doubt| doubt.meant().map(|meant| meant.to_string()))
    };
    for (given, meant) in [("68", "20"), ("77", "25"), ("293", "19.85"), ("293.15", "20"), ("296.15", "23")] {
        assert_eq!(said(given), Some(Some(meant.to_owned())), "{given}");
    }
    for given in ["-20", "0", "18.5", "20", "37", "50"] {
        assert_eq!(said(given), None, "{given}");
    }
    for given in ["-20.001", "-196", "680", "150"] {
        assert_eq!(said(given), Some(None), "{given}");
    }
    assert!(said("50.001").is_some());
    let call = ["check", "25 H7", "--measured", "25.012", "--material", "steel", "--temperature"];
    for (given, offer) in
        [("68", "Fahrenheit, write 20"), ("293", "kelvin, write 19.85"), ("-196", "--far-temperature")]
    {
        refuses(&[&call[..], &[given]].concat(), offer);
    }
    refuses(&[&call[..], &["22", "--scale-material", "10", "--scale-temperature", "68"]].concat(), "write 20");
    let (_, out, said) = fitcheck(&[&call[..], &["68", "--far-temperature"]].concat());
    assert!(out.contains("REWORK") || out.contains("GOOD"), "{out}{said}");
    assert!(said.contains("if it is in degrees Fahrenheit"), "{said}");
}

#[test]
fn a_coefficient_says_its_range_and_holds_nowhere_else() {
    for material in Materials::shipped().iter() {
        let Range { least, most } = material.range;
        assert!(least <= Temperature::REFERENCE && Temperature::REFERENCE <= most, "{}", material.name);
    }
    let fit = |hole: &str, degrees: &str| {
        fitcheck(&[
            "fit",
            "50 H7/p6",
            "--hole-material",
            hole,
            "--shaft-material",
            "steel",
            "--hole-temperature",
            degrees,
        ])
    };
    let (code, out, said) = fit("steel", "220");
    assert_eq!(code, Some(0), "{said}");
    assert!(out.contains("from -100 to 250 °C"), "{out}");
    for (material, degrees, range) in [
        ("steel", "680", "-100 to 250"),
        ("steel", "-196", "-100 to 250"),
        ("POM", "80", "0 to 60"),
        ("11.5", "201", "-50 to 200"),
    ] {
        let (code, out, said) = fit(material, degrees);
        assert_eq!((code, out.as_str()), (Some(1), ""), "{material} {degrees}: {said}");
        assert!(said.contains(range) && said.contains("--far-temperature"), "{said}");
    }
    let steel: Expansion = "11.5".parse().unwrap();
    let range = Range { least: temperature("-50"), most: temperature("80") };
    let is_doubted = |given: &str| ThermalDoubt::of_expansion(temperature(given), steel, range).is_some();
    assert_eq!(["-50.001", "-50", "80", "80.001"].map(is_doubted), [true, false, false, true]);
}

#[test]
fn an_expansion_in_another_unit_is_refused_with_its_millionths() {
    for (given, meant) in [
        ("11.5e-6", "11.5"),
        ("1.15E-5", "11.5"),
        ("0.0000115", "11.5"),
        ("0.0115", "11.5"),
        ("0,0231", "23.1"),
        ("-1e-6", "-1"),
    ] {
        match given.parse::<Expansion>() {
            Err(ThermalError::ExpansionUnit { meant: found, .. }) => assert_eq!(found.to_string(), meant, "{given}"),
            other => panic!("{given}: {other:?}"),
        }
    }
    for sound in ["0", "0.1", "1.2", "-0.5", "110"] {
        assert!(sound.parse::<Expansion>().is_ok(), "{sound}");
    }
    refuses(&["check", "25 H7", "--measured", "25.01", "--temperature", "22", "--material", "11.5e-6"], "write 11.5");
}

/// The journal's own CSV with the temperature of another scale: a part of 20 °C that somebody called 68 °C.
#[test]
fn a_csv_that_was_corrected_from_degrees_fahrenheit_is_refused() {
    let shop = Shop::new();
    let call = [
        "report",
        "--check",
        "25 H7=25.02",
        "-o",
        "-",
        "--format",
        "csv",
        "--temperature",
        "68",
        "--material",
        "steel",
        "--far-temperature",
    ];
    let (_, out, said) = fitcheck(&call);
    assert!(out.contains("temperature_c"), "{out}{said}");
    refuses(&["import", &shop.with("again.csv", &out)], "Fahrenheit, write 20");
}

/// The window, by commands.
mod window {
    use fitcheck::session::{Action, CheckAction, CheckCommand, CheckField, Command, Field, FitField, Session};
    use fitcheck::tolerance::Feature;
    use fitcheck::verdict::Status;
    use fitcheck::words::{Language, Words};
    use jiff::civil::{DateTime, date};

    fn now() -> DateTime {
        date(2026, 11, 25).at(10, 42, 7, 0)
    }

    fn run(session: &mut Session, commands: impl IntoIterator<Item = Command>) {
        for command in commands {
            session.apply(command, now());
        }
    }

    fn typed(field: impl Into<Field>, text: &str) -> Command {
        field.into().typed(text.to_owned())
    }

    /// A callout and a value, and Enter.
    fn asked(callout: &str, measured: &str) -> Session {
        let mut session = Session::new(Language::En);
        run(
            &mut session,
            [
                typed(CheckField::Callout, callout),
                CheckCommand::ChooseFeature(Some(Feature::Hole)).into(),
                typed(CheckField::Measured, measured),
                CheckCommand::Measure.into(),
            ],
        );
        session
    }

    fn status(session: &Session) -> Option<Status> {
        session.check().shown.as_ref().map(|shown| shown.record.verdict.status())
    }

    fn act(session: &mut Session, action: Action) {
        let command = action.command(session).unwrap();
        run(session, [command]);
    }

    #[test]
    fn a_zone_in_micrometres_is_asked_about_and_enter_takes_the_remedy() {
        let mut session = asked("25 +21/0", "25.012");
        assert_eq!(status(&session), None);
        let doubted = session.check().doubted().unwrap().clone();
        assert_eq!((doubted.field, doubted.meant.as_deref()), (CheckField::Callout, Some("25 +0.021 0")));
        let words = Words::new(Language::En);
        assert_eq!(CheckAction::TakeText.text(&session, &words), "Use 25 +0.021 0");
        assert_eq!(CheckAction::KeepText.text(&session, &words), "Judge by 25 +21 0 as it is");
        // Enter once more.
        run(&mut session, [CheckCommand::Measure.into()]);
        assert_eq!(status(&session), Some(Status::Good));
        assert_eq!(session.text(CheckField::Callout), "25 +0.021 0");
        assert_eq!(session.check().shown.as_ref().unwrap().record.limits.maximum().to_string(), "25.021");
    }

    #[test]
    fn a_wide_zone_is_judged_by_the_button_that_says_so_and_never_by_enter() {
        let mut session = asked("25 +21/0", "30");
        act(&mut session, CheckAction::KeepText.into());
        assert_eq!(status(&session), Some(Status::Good));
        assert_eq!(session.check().shown.as_ref().unwrap().record.limits.maximum().to_string(), "46");
        // The next value of the same callout is judged; another callout asks again.
        run(&mut session, [typed(CheckField::Measured, "47"), CheckCommand::Measure.into()]);
        assert_eq!(status(&session), Some(Status::Scrap));
        run(
            &mut session,
            [typed(CheckField::Callout, "25 +22/0"), typed(CheckField::Measured, "30"), CheckCommand::Measure.into()],
        );
        assert_eq!(status(&session), None);
        assert!(session.check().doubted().is_some());
        // Typing takes the question away, and nothing was judged.
        run(&mut session, [typed(CheckField::Measured, "31")]);
        assert_eq!((session.check().doubted(), session.history().len()), (None, 2));
        // Nothing can be offered for limits of size: Enter goes on asking.
        let mut session = asked("40/25", "30");
        run(&mut session, [CheckCommand::Measure.into(), CheckCommand::Measure.into()]);
        assert!(status(&session).is_none() && session.check().doubted().is_some());
        assert!(!session.can(CheckAction::TakeText) && session.can(CheckAction::KeepText));
        // What leaves nothing is no callout, and cannot be taken as it is.
        let mut session = asked("25 ±25", "25.012");
        assert!(session.can(CheckAction::TakeText) && !session.can(CheckAction::KeepText));
        act(&mut session, CheckAction::TakeText.into());
        assert_eq!((status(&session), session.text(CheckField::Callout)), (Some(Status::Good), "25 ±0.025"));
    }

    #[test]
    fn a_temperature_in_degrees_fahrenheit_is_asked_about() {
        let mut session = Session::new(Language::En);
        let steel = "11.5".parse().unwrap();
        run(
            &mut session,
            [
                typed(CheckField::Callout, "25 H7"),
                typed(CheckField::PartTemperature, "68"),
                CheckCommand::ChooseExpansion(CheckField::PartExpansion, steel).into(),
                typed(CheckField::Measured, "25.005"),
                CheckCommand::Measure.into(),
            ],
        );
        assert_eq!(status(&session), None);
        assert_eq!(session.check().doubted().unwrap().meant.as_deref(), Some("20"));
        let mut kept = asked("25 H7", "25.005");
        run(&mut session, [CheckCommand::Measure.into()]);
        assert_eq!((status(&session), session.text(CheckField::PartTemperature)), (Some(Status::Good), "20"));
        // 25.005 · 11.5e-6 · 48 K = 13.8 µm: as it stands it is rework.
        run(
            &mut kept,
            [
                typed(CheckField::PartTemperature, "68"),
                CheckCommand::ChooseExpansion(CheckField::PartExpansion, steel).into(),
                typed(CheckField::Measured, "25.005"),
                CheckCommand::Measure.into(),
            ],
        );
        act(&mut kept, CheckAction::KeepText.into());
        assert_eq!(status(&kept), Some(Status::Rework));
    }

    #[test]
    fn the_fit_page_refuses_a_temperature_beyond_the_range_of_the_material() {
        let mut session = Session::new(Language::En);
        let of = |session: &mut Session, degrees: &str| {
            run(session, [typed(FitField::Callout, "50 H7/p6"), typed(FitField::Temperature, degrees)]);
            session.error(FitField::Temperature).is_some()
        };
        assert_eq!(
            ["80", "250", "251", "680", "-196"].map(|degrees| of(&mut session, degrees)),
            [false, false, true, true, true]
        );
    }
}
