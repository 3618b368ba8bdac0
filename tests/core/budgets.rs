//! Uncertainty budgets against the GUM (H.1, table G.2), the worked figures of docs/SOURCES.md, "Uncertainty budgets", and
//! `tests/data/rules/vectors.json`.

use fitcheck::budget::{
    Basis, Budget, Calibrated, Conditions, Contribution, ContributionKind, Evaluated, Evaluation, Geometry, Help, Law,
    Validity, factor, student,
};
use fitcheck::length::Length;
use fitcheck::probing::Contact;
use proptest::prelude::*;

const HEAD: &str = "name = \"S3\"\ndate = 2026-01-15\nby = \"J. Jansen\"\nvalid_until = 2027-01-14\n";

/// Touch 0.5 µm, ring U 1 µm, ±1 K standard on steel, geometry ±1 µm.
const WORKED: &str = "
[[contribution]]
name = \"touch\"
kind = \"scatter\"
type = \"A\"
law = \"normal\"
standard_um = 0.5
touches = 4
step_deg = 90
[[contribution]]
name = \"ring\"
type = \"B\"
law = \"normal\"
expanded_um = 1
k = 2
[[contribution]]
name = \"temperature\"
kind = \"part-temperature\"
type = \"B\"
law = \"normal\"
standard_k = 1
alpha_per_k = 11.5e-6
[[contribution]]
name = \"geometry\"
type = \"B\"
law = \"rectangular\"
half_width_um = 1
";

fn read(tables: &str) -> Budget {
    Budget::read(&format!("{HEAD}{tables}")).unwrap_or_else(|error| panic!("{error}"))
}

fn contributions(tables: &str) -> Vec<Contribution> {
    match read(tables).basis {
        Basis::Contributions(contributions) => contributions,
        Basis::Calibrated(_) => panic!("a calibrated piece"),
    }
}

fn at(size: &str, geometry: Option<Geometry>) -> Conditions {
    Conditions { size: Some(size.parse().unwrap()), geometry, ..Conditions::default() }
}

#[track_caller]
fn near(found: f64, wanted: f64, allowed: f64) {
    assert!((found - wanted).abs() <= allowed, "{found} instead of {wanted}");
}

/// u(D)/s by touches and step, as computed with more digits elsewhere; half a unit of the last digit.
#[test]
fn the_scatter_of_a_touch_grows_on_a_short_arc() {
    let rows = [
        (3, 120.0, "1.155"),
        (3, 90.0, "1.414"),
        (3, 75.0, "2.032"),
        (3, 60.0, "3.464"),
        (3, 45.0, "6.828"),
        (3, 30.0, "16.69"),
        (3, 20.0, "39.0"),
        (3, 15.0, "70.3"),
        (3, 10.0, "159.6"),
        (4, 90.0, "1.000"),
        (4, 60.0, "1.414"),
        (4, 45.0, "2.613"),
        (4, 30.0, "6.541"),
        (4, 20.0, "15.61"),
        (5, 72.0, "0.894"),
        (6, 60.0, "0.816"),
        (8, 45.0, "0.707"),
        (8, 22.5, "1.672"),
        (12, 30.0, "0.577"),
    ];
    for (touches, step, wanted) in rows {
        let decimals = wanted.split_once('.').unwrap().1.len();
        let found = Geometry::steps(touches, step).unwrap().factor;
        assert_eq!(format!("{found:.decimals$}"), wanted, "{touches} x {step}");
    }
    near(Geometry::even_factor(3), 1.1547, 5e-5);
}

#[test]
fn real_contacts_have_the_factor_of_their_directions() {
    let contacts = [0.0_f64, 60.0, 120.0].map(|angle| {
        let angle = angle.to_radians();
        Contact { x: 40.0 + 12.5 * angle.cos(), y: 30.0 + 12.5 * angle.sin(), z: 0.0 }
    });
    let geometry = Geometry::of_contacts(&contacts).unwrap();
    near(geometry.factor, 3.4641, 5e-5);
    assert_eq!((geometry.touches, geometry.step_deg), (3, None));
}

#[test]
fn the_worked_budget_has_its_figures() {
    let contributions = contributions(WORKED);
    let full = Evaluation::of(&contributions, &at("25", None)).unwrap();
    near(full.u, 0.957, 0.0005);
    near(full.rows[2].contribution, 0.2875, 1e-9);
    near(full.rows[3].contribution, 0.577, 0.0005);
    assert_eq!((full.k, full.degrees_of_freedom, full.largest), (2.0, None, 3));
    near(full.expanded(), 2.0 * full.u, 1e-12);
    let short = Evaluation::of(&contributions, &at("25", Some(Geometry::steps(3, 60.0).unwrap()))).unwrap();
    near(short.u, 1.91, 0.005);
    assert_eq!(short.largest, 0);
    // The others together: √(0.25 + 0.0827 + 0.3333) = 0.8161.
    let [
        Help::Halved { u: halved },
        Help::FullCircle { touches: 3, u: full },
        Help::MoreTouches { touches: 6, u: more },
    ] = short.help[..]
    else {
        panic!("{:?}", short.help)
    };
    near(halved, 0.8161_f64.hypot(0.8660), 0.0005);
    near(full, 0.8161_f64.hypot(0.5774), 0.0005);
    near(more, 0.8161_f64.hypot(0.4082), 0.0005);
}

/// The laws by their divisors √3, √2, √6, and a display whose step is 1 µm: 1 / √12.
#[test]
fn a_half_width_is_divided_by_the_root_of_its_law() {
    let rows = [("rectangular", 3.0), ("u-shaped", 2.0), ("triangular", 6.0)];
    for (law, square) in rows {
        let table = format!("[[contribution]]\nname = \"a\"\ntype = \"B\"\nlaw = \"{law}\"\nhalf_width_um = 2\n");
        near(contributions(&table)[0].u, 2.0 / f64::sqrt(square), 1e-12);
    }
    let table = "[[contribution]]\nname = \"a\"\ntype = \"B\"\nkind = \"resolution\"\nresolution_um = 1\n";
    near(contributions(table)[0].u, 0.288_675, 1e-6);
}

/// JCGM 100, H.1: the end gauge; u = 32 nm, 16 degrees of freedom, U99 = 93 nm.
#[test]
fn the_end_gauge_of_the_gum_has_its_figures() {
    let plain = |name: &str, nm: f64, degrees: f64| {
        format!(
            "[[contribution]]\nname = \"{name}\"\ntype = \"A\"\nlaw = \"normal\"\nstandard_um = {}\n\
             degrees_of_freedom = {degrees:.1}\n",
            nm / 1_000.0
        )
    };
    // δα within ±1e-6 per kelvin, at −0.1 K.
    let expansion = "[[contribution]]\nname = \"difference of expansion\"\nkind = \"part-expansion\"\ntype = \"B\"\n\
         law = \"rectangular\"\nhalf_width_per_k = 1e-6\ndelta_k = -0.1\ndegrees_of_freedom = 50\n";
    let temperature = "[[contribution]]\nname = \"difference of temperature\"\nkind = \"part-temperature\"\ntype = \"B\"\n\
         law = \"rectangular\"\nhalf_width_k = 0.05\nalpha_per_k = 11.5e-6\ndegrees_of_freedom = 2\n";
    let tables = [
        plain("standard", 25.0, 18.0),
        plain("observations", 5.8, 24.0),
        plain("random effects", 3.9, 5.0),
        plain("systematic effects", 6.7, 8.0),
        expansion.to_owned(),
        temperature.to_owned(),
    ];
    let found = Evaluation::of(&contributions(&tables.concat()), &at("50.000838", None)).unwrap();
    near(found.rows[4].u, 0.577, 0.0005);
    near(found.rows[4].contribution, 0.0029, 5e-5);
    near(found.rows[5].contribution, 0.0166, 5e-5);
    assert_eq!(format!("{:.0}", found.u * 1_000.0), "32");
    let degrees = found.degrees_of_freedom.unwrap();
    near(degrees.floor(), 16.0, 0.0);
    // The recalculation in vectors.json gets 15.78, with more digits of its inputs.
    near(degrees, 15.78, 1.0);
    near(student(Some(16.0), 0.99), 2.92, 0.005);
    near(0.0318 * student(Some(16.0), 0.99), 0.093, 0.0005);
    near(student(Some(15.78), 0.95), 2.122, 0.0005);
    near(32.0 * student(Some(15.78), 0.95), 68.0, 0.5);
}

/// u(alpha) · D · (T − 20): 0.5e-6 per kelvin, 100 mm and 4 K are 0.2 µm, whatever it is that expands and however it is given.
#[test]
fn the_uncertainty_of_an_expansion_counts_by_size_and_temperature() {
    let laws = [
        ("normal", "standard_per_k = 0.5e-6"),
        ("normal", "expanded_per_k = 1e-6\nk = 2"),
        ("rectangular", "half_width_per_k = 0.866025e-6"),
        ("triangular", "half_width_per_k = 1.224745e-6"),
        ("u-shaped", "half_width_per_k = 0.707107e-6"),
    ];
    for kind in ["part-expansion", "scale-expansion"] {
        for (law, keys) in laws {
            for delta in ["4", "-4.0"] {
                let table = format!(
                    "[[contribution]]\nname = \"alpha\"\nkind = \"{kind}\"\ntype = \"B\"\nlaw = \"{law}\"\n{keys}\n\
                     delta_k = {delta}\n"
                );
                let found = Evaluation::of(&contributions(&table), &at("100", None)).unwrap();
                near(found.u, 0.2, 1e-6);
                assert_eq!((found.rows[0].unit, found.rows[0].geometry), ("µm/(m K)", None));
                near(found.rows[0].u, 0.5, 1e-6);
                near(found.rows[0].sensitivity.abs(), 0.4, 1e-12);
                let error = Evaluation::of(&contributions(&table), &Conditions::default()).unwrap_err();
                assert_eq!(error.to_string(), "alpha depends on the size, but no size is given");
            }
        }
    }
}

/// JCGM 100, table G.2, the column of 95.45 %.
#[test]
fn coverage_factors_are_those_of_the_gum() {
    let table = [
        (1, 13.97),
        (2, 4.53),
        (3, 3.31),
        (4, 2.87),
        (5, 2.65),
        (6, 2.52),
        (7, 2.43),
        (8, 2.37),
        (9, 2.32),
        (10, 2.28),
        (15, 2.18),
        (20, 2.13),
        (25, 2.11),
        (30, 2.09),
        (40, 2.06),
        (50, 2.05),
    ];
    for (degrees, wanted) in table {
        near(factor(Some(f64::from(degrees))), wanted, 0.0055);
    }
    near(factor(Some(100.0)), 2.025, 0.0005);
    near(factor(Some(99_999.0)), 2.0, 1e-9);
    near(factor(Some(1e300)), 2.0, 1e-9);
    near(factor(None), 2.0, 1e-9);
}

fn vector(id: &str) -> serde_json::Value {
    let path = format!("{}/tests/data/rules/vectors.json", env!("CARGO_MANIFEST_DIR"));
    let file: serde_json::Value = serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap();
    file["vectors"].as_array().unwrap().iter().find(|vector| vector["id"] == id).unwrap().clone()
}

fn piece(tables: &str) -> Calibrated {
    match read(tables).basis {
        Basis::Calibrated(piece) => piece,
        Basis::Contributions(_) => panic!("contributions"),
    }
}

#[test]
fn a_calibrated_piece_has_both_editions_to_their_digits() {
    let vector = vector("iso15530_3_synthetic");
    let number = |name: &str| vector[name].as_f64().unwrap();
    let tables = format!(
        "[calibrated]\nx_cal_mm = {}\nexpanded_um = 0.6\nk = 2\nu_b_um = 0.1\nu_w_um = {}\nreadings_mm = {}\n",
        vector["x_cal"],
        number("u_w") * 1_000.0,
        vector["readings"]
    );
    let found = piece(&tables).evaluate(None).unwrap();
    near(found.mean_mm, number("mean"), 1e-12);
    near(found.bias, number("bias") * 1e3, 1e-9);
    near(found.u_cal, number("u_cal") * 1e3, 1e-9);
    near(found.u_p, number("u_p") * 1e3, 1e-9);
    near(found.expanded_2011, number("U_2011") * 1e3, 1e-9);
    near(found.expanded_2004, number("U_TS2004_bias_added") * 1e3, 1e-9);
    assert!(found.is_enough());
    // A bias that nobody corrects counts.
    near(found.expanded(), found.expanded_2004, 0.0);
    near(
        piece(&format!("{tables}bias_corrected = true\n")).evaluate(None).unwrap().u(),
        found.expanded_2011 / 2.0,
        1e-12,
    );
    let few: Vec<Length> = ["30.0021", "30.0024"].map(|reading| reading.parse().unwrap()).into();
    assert!(!piece(&tables).evaluate(Some(&few)).unwrap().is_enough());
    let error = piece(&tables).evaluate(Some(&few[..1])).unwrap_err();
    assert_eq!(error.to_string(), "one reading: at least 2 are needed");
    let far = [few[0], "32".parse().unwrap(), "36.0".parse().unwrap()];
    let error = piece(&tables).evaluate(Some(&far)).unwrap_err().to_string();
    assert!(error.contains("more than 1 mm from the calibrated size, 30.0012 mm"), "{error}");
}

/// |T - 20| u(alpha) D: 4 K, 1e-6 per kelvin, 30 mm are 0.12 µm; together with 0.05 given they are 0.13.
#[test]
fn expansion_counts_in_bias_and_parts() {
    let found = piece(
        "[calibrated]\nx_cal_mm = 30\nstandard_um = 0.3\ntemperature_c = 24\nu_alpha_per_k = 1e-6\nu_w_um = 0.05\n\
         u_alpha_parts_per_k = 1e-6\n",
    );
    near(found.u_b, 0.12, 1e-12);
    near(found.u_w, 0.13, 1e-12);
}

#[test]
fn the_first_and_the_last_day_count() {
    let budget = read(WORKED);
    let on = |day: &str| budget.validity(day.parse().unwrap());
    assert_eq!(on("2026-01-14"), Validity::NotYet);
    assert_eq!([on("2026-01-15"), on("2027-01-14")], [Validity::Valid; 2]);
    assert_eq!(on("2027-01-15"), Validity::Expired);
    assert_eq!(Budget::read(&format!("{HEAD}{WORKED}").replace("2026-01-15", "\"2026-01-15\"")).unwrap(), budget);
}

#[test]
fn a_budget_says_what_it_needs() {
    let budget = contributions(WORKED);
    let error = Evaluation::of(&budget, &Conditions::default()).unwrap_err();
    assert_eq!(error.to_string(), "temperature depends on the size, but no size is given");
    let without = WORKED.replace("touches = 4\nstep_deg = 90\n", "");
    let error = Evaluation::of(&contributions(&without), &at("25", None)).unwrap_err().to_string();
    assert_eq!(
        error,
        "touch depends on the contacts, but the budget has no touches and step_deg, and no contacts are given"
    );
    let zero = "[[contribution]]\nname = \"a\"\ntype = \"B\"\nlaw = \"rectangular\"\nhalf_width_um = 0\n";
    let error = Evaluation::of(&contributions(zero), &Conditions::default()).unwrap_err();
    assert_eq!(error.to_string(), "every contribution is zero");
}

/// A file, and what is said of it.
#[test]
fn wrong_files_are_refused_with_line_and_what_is_allowed() {
    let with = |keys: &str| format!("{HEAD}[[contribution]]\nname = \"a\"\ntype = \"B\"\n{keys}\n");
    let cases = [
        (HEAD.to_owned(), "a budget needs either [[contribution]] tables or one [calibrated] table"),
        (with("law = \"normal\""), "line 6, column 8: a: standard_um, or expanded_um with k is missing"),
        (with("law = \"normal\"\nexpanded_um = 1"), "line 6, column 8: a: k is missing"),
        (with("standard_um = 1"), "line 6, column 8: a: law is missing"),
        (
            with("law = \"rectangular\"\nhalf_width_um = -1"),
            "line 9, column 17: a: half_width_um is -1: expected 0 to 1000000",
        ),
        (
            with("law = \"rectangular\"\nhalf_width_um = nan"),
            "line 9, column 17: a: half_width_um is NaN: expected 0 to 1000000",
        ),
        (
            with("law = \"rectangular\"\nstandard_um = 1"),
            "line 9, column 15: a: standard_um is not used here: the allowed keys are half_width_um, sensitivity, degrees_of_freedom",
        ),
        (
            with("law = \"normal\"\nstandard_um = 1\nk = 2"),
            "line 10, column 5: a: k is not used here: the allowed keys are standard_um, sensitivity, degrees_of_freedom",
        ),
        (with("law = \"normal\"\nexpanded_um = 1\nk = 0.5"), "line 10, column 5: a: k is 0.5: expected 1 to 10"),
        (
            with("law = \"normal\"\nstandard_um = 1\ndegrees_of_freedom = 0"),
            "line 10, column 22: a: degrees_of_freedom is 0: expected 1 to inf",
        ),
        (
            with("kind = \"part-temperature\"\nlaw = \"normal\"\nstandard_k = 1\nalpha_per_k = 11.5"),
            "line 11, column 15: a: alpha_per_k is 11.5: expected 0 to 0.001",
        ),
        (
            with("kind = \"resolution\"\nlaw = \"triangular\"\nresolution_um = 1"),
            "line 6, column 8: a: a resolution is rectangular: expected law = \"rectangular\" or no law",
        ),
        (
            with("kind = \"scatter\"\nlaw = \"normal\"\nstandard_um = 1\ntouches = 2\nstep_deg = 90"),
            "line 11, column 11: a: 2 touches: expected 3 to 1000",
        ),
        (
            with("kind = \"scatter\"\nlaw = \"normal\"\nstandard_um = 1\ntouches = 4\nstep_deg = 120"),
            "line 11, column 11: a: 4 touches at 120 degrees: expected a step of 0.01 to 90 degrees",
        ),
        (
            with("kind = \"scatter\"\nlaw = \"normal\"\nstandard_um = 1\ntouches = 4"),
            "line 6, column 8: a: step_deg is missing",
        ),
        (
            with("law = \"gaussian\""),
            "line 8, column 7: unknown variant `gaussian`, expected one of `normal`, `rectangular`, `u-shaped`, `triangular`",
        ),
        (
            HEAD.replace("2027-01-14", "2025-12-31"),
            "line 4, column 15: valid_until 2025-12-31 is before date 2026-01-15",
        ),
        (
            HEAD.replace("2026-01-15", "\"15.01.2026\""),
            "line 2, column 8: date: 15.01.2026 is not a day: expected YYYY-MM-DD",
        ),
        (
            HEAD.replace("2026-01-15", "2026-01-15T10:00:00"),
            "line 2, column 8: date: 2026-01-15T10:00:00 is not a day: expected YYYY-MM-DD",
        ),
        (
            with("law = \"rectangular\"\nhalf_width_um = 1").replace("J. Jansen", " "),
            "line 3, column 6: by is empty: expected a text",
        ),
    ];
    for (file, wanted) in cases {
        let error = Budget::read(&file).expect_err(wanted).to_string();
        assert_eq!(error, wanted, "{file}");
    }
    let error = Budget::read(&with("law = \"normal\"\nstandard = 1")).unwrap_err().to_string();
    assert!(error.starts_with("line 9, column 1: unknown field `standard`, expected one of"), "{error}");
}

#[test]
fn wrong_pieces_are_refused_with_place_and_what_is_missing() {
    let piece = |keys: &str| format!("{HEAD}[calibrated]\nx_cal_mm = 30\n{keys}\n");
    let cases = [
        (
            piece("u_b_um = 0\nu_w_um = 0"),
            "line 6, column 12: [calibrated]: standard_um, or expanded_um with k is missing",
        ),
        (
            piece("standard_um = 0.3\nu_w_um = 0"),
            "line 6, column 12: [calibrated]: u_b_um, or u_alpha_per_k with temperature_c is missing",
        ),
        (
            piece("standard_um = 0.3\nu_alpha_per_k = 1e-6\nu_w_um = 0"),
            "line 6, column 12: [calibrated]: temperature_c is missing",
        ),
    ];
    for (file, wanted) in cases {
        let error = Budget::read(&file).expect_err(wanted).to_string();
        assert_eq!(error, wanted, "{file}");
    }
    let error = Budget::read(&piece("standard_um = 1\nexpanded_um = 2\nk = 2\nu_b_um = 0\nu_w_um = 0")).unwrap_err();
    assert!(error.to_string().starts_with("line 8, column 15: [calibrated]: expanded_um is not used here"), "{error}");
}

#[test]
fn wrong_expansions_are_refused_with_place_and_what_is_allowed() {
    let with = |keys: &str| format!("{HEAD}[[contribution]]\nname = \"a\"\ntype = \"B\"\n{keys}\n");
    let cases = [
        (
            with("kind = \"part-expansion\"\nlaw = \"normal\"\nstandard_per_k = 1.0\ndelta_k = 4"),
            "line 10, column 18: a: standard_per_k is 1: expected 0 to 0.001",
        ),
        (
            with("kind = \"part-expansion\"\nlaw = \"normal\"\nstandard_k = 1e-6\ndelta_k = 4"),
            "line 10, column 14: a: standard_k is not used here: the allowed keys are standard_per_k, expanded_per_k, k, delta_k, \
             sensitivity, degrees_of_freedom",
        ),
        (
            with("kind = \"scale-expansion\"\nlaw = \"normal\"\nstandard_per_k = 1e-6"),
            "line 6, column 8: a: delta_k is missing",
        ),
        (
            with("kind = \"scale-expansion\"\nlaw = \"normal\"\ndelta_k = 3"),
            "line 6, column 8: a: standard_per_k, or expanded_per_k with k is missing",
        ),
    ];
    for (file, wanted) in cases {
        let error = Budget::read(&file).expect_err(wanted).to_string();
        assert_eq!(error, wanted, "{file}");
    }
}

proptest! {
    #[test]
    fn shares_are_a_hundred_per_cent_and_squares_the_total(
        given in prop::collection::vec((0.0..10.0_f64, -3.0..3.0_f64, 1.0..100.0_f64), 1..20),
        endless in any::<bool>(),
    ) {
        let contributions: Vec<Contribution> = given
            .iter()
            .map(|&(u, sensitivity, degrees)| Contribution {
                name: String::new(),
                evaluated: Evaluated::B,
                law: Law::Normal,
                kind: ContributionKind::Plain,
                u,
                sensitivity,
                degrees_of_freedom: (!endless).then_some(degrees),
            })
            .collect();
        let Ok(found) = Evaluation::of(&contributions, &Conditions::default()) else { return Ok(()) };
        let shares: f64 = found.rows.iter().map(|row| row.share).sum();
        prop_assert!((shares - 100.0).abs() < 1e-9, "{shares}");
        let squares: f64 = found.rows.iter().map(|row| row.contribution.powi(2)).sum();
        prop_assert!((squares - found.u.powi(2)).abs() <= 1e-12 * squares);
        prop_assert!(found.rows.iter().all(|row| row.contribution <= found.rows[found.largest].contribution));
        prop_assert_eq!(found.degrees_of_freedom.is_none(), endless);
        if let Some(degrees) = found.degrees_of_freedom {
            // Between the smallest and the sum (GUM, G.4.1).
            let least = given.iter().map(|given| given.2).fold(f64::INFINITY, f64::min);
            prop_assert!(least - 1e-9 <= degrees && degrees <= given.iter().map(|given| given.2).sum::<f64>() + 1e-9);
        }
        prop_assert!(2.0 <= found.k && found.k <= 13.968_001 );
        let Help::Halved { u } = found.help[0] else { panic!() };
        prop_assert!(found.u / 2.0 - 1e-9 <= u && u < found.u);
    }
}
