//! Capability by the normal law and by percentiles; Anderson and Darling.

use fitcheck_statistics::{
    Capability, CapabilityPlan, Degrees, Estimate, Family, Fitted, Law, Method, Reason, Tolerance, anderson_darling,
    capability, percentiles,
};

use crate::charts::groups;
use crate::simulated::Simulated;
use crate::{data, near, number, numbers, printed, study, within};

fn both(lower: f64, upper: f64) -> Tolerance {
    Tolerance::new(Some(lower), Some(upper)).unwrap()
}

fn of(groups: &[Vec<f64>], plan: &CapabilityPlan) -> Capability {
    capability(groups.iter().map(Vec::as_slice), plan).unwrap()
}

fn singles(values: &[f64]) -> Vec<Vec<f64>> {
    values.iter().map(|value| vec![*value]).collect()
}

#[test]
fn the_case_of_the_shewhart_package_is_met() {
    let case = &data("shewhart_cases.json")["cases"][2];
    let (inputs, expected) = (&case["inputs"], &case["expected"]);
    let limits = both(number(&inputs["kwargs"]["lsl"]), number(&inputs["kwargs"]["usl"]));
    let plan = CapabilityPlan::of(limits, Method::MovingRange);
    let found = of(&singles(&numbers(&inputs["data"])), &plan);
    let within_groups = found.within.unwrap();
    let overall = found.overall;
    let cp = within_groups.potential.unwrap();
    let pp = overall.potential.unwrap();
    for (name, found) in [
        ("mean", found.mean.value),
        ("sigma_within", within_groups.sigma.value),
        ("sigma_overall", overall.sigma.value),
        ("cp", cp.value),
        ("cpk", within_groups.actual.value),
        ("pp", pp.value),
        ("ppk", overall.actual.value),
        ("cp_lci", cp.lower),
        ("cp_uci", cp.upper),
        ("cpk_lci", within_groups.actual.lower),
        ("cpk_uci", within_groups.actual.upper),
        ("pp_lci", pp.lower),
        ("pp_uci", pp.upper),
        ("ppk_lci", overall.actual.lower),
        ("ppk_uci", overall.actual.upper),
        ("ppm_within", within_groups.ppm.value),
        ("ppm_overall", overall.ppm.value),
    ] {
        within(found, number(&expected[name]), 1e-9);
    }
    assert_eq!(found.outside, [0, 0]);
}

#[test]
fn the_piston_rings_have_their_published_capability() {
    let rings = data("pistonrings.json");
    let (published, exact) = (&rings["published"], &rings["computed_exact_constants"]);
    let limits = both(number(&rings["lsl"]), number(&rings["usl"]));
    let plan = CapabilityPlan { degrees: Degrees::OfValues, ..CapabilityPlan::of(limits, Method::Ranges) };
    let found = of(&groups(&rings["subgroups"])[..25], &plan);
    let inside = found.within.as_ref().unwrap();
    let cp = inside.potential.unwrap();
    for (name, found) in [
        ("cp", cp.value),
        ("cpl", inside.lower.unwrap().index.value),
        ("cpu", inside.upper.unwrap().index.value),
        ("cpk", inside.actual.value),
        ("cpm", inside.about_target.unwrap().value),
        ("pp", found.overall.potential.unwrap().value),
        ("ppk", found.overall.actual.value),
        ("sigma_overall", found.overall.sigma.value),
    ] {
        near(found, number(&exact[name]), 1e-12);
        if let Some(published) = published[name].as_f64() {
            within(found, published, 0.001_1);
        }
    }
    for (name, found) in [("cp_ci95", cp), ("cpk_ci95", inside.actual)] {
        let ends = numbers(&published[name]);
        printed(found.lower, ends[0], 3);
        printed(found.upper, ends[1], 3);
    }
    // What 25 ranges of 5 are worth: 90.8 degrees of freedom (AIAG MSA, table of d2*: 72.7 of 20), and wider intervals.
    let effective = of(&groups(&rings["subgroups"])[..25], &CapabilityPlan::of(limits, Method::Ranges));
    let inside = effective.within.unwrap();
    printed(inside.sigma.degrees, 90.8, 1);
    assert!(inside.potential.unwrap().lower < cp.lower && cp.upper < inside.potential.unwrap().upper);
}

#[test]
fn the_hundred_diameters_have_their_published_capability() {
    let study = study("capability_100");
    let (published, computed) = (&study["published"], &study["computed"]);
    let values = numbers(&study["data"]);
    let five: Vec<Vec<f64>> = values.chunks(5).map(<[f64]>::to_vec).collect();
    let limits = both(number(&study["lsl"]), number(&study["usl"]));
    let plan = CapabilityPlan {
        target: Some(number(&study["target"])),
        level: 0.9,
        ..CapabilityPlan::of(limits, Method::Ranges)
    };
    let found = of(&five, &plan);
    let inside = found.within.unwrap();
    let overall = found.overall;
    let [pp, cpm] = [overall.potential.unwrap(), overall.about_target.unwrap()];
    for (name, figure, share) in [
        ("s", overall.sigma.value, 1e-9),
        ("s_within_Rbar_exact_d2", inside.sigma.value, 1e-9),
        ("Pp", pp.value, 1e-9),
        ("Ppk", overall.actual.value, 1e-9),
        ("Cpm_target_n_minus_1", cpm.value, 1e-9),
    ] {
        near(figure, number(&computed[name]), share);
    }
    for (name, figure) in [("Pp_ci90", pp), ("Ppk_ci90_bissell", overall.actual), ("Cpm_ci90", cpm)] {
        let ends = numbers(&computed[name]);
        near(figure.lower, ends[0], 1e-9);
        near(figure.upper, ends[1], 1e-9);
    }
    let [below, above] = [overall.lower.unwrap(), overall.upper.unwrap()];
    near(below.ppm.value, number(&published["ppm_below"]), 1e-3);
    near(above.ppm.value, number(&published["ppm_above"]), 1e-5);
    printed(inside.potential.unwrap().value, number(&published["Cp"]), 2);
    printed(inside.actual.value, number(&published["Cpk"]), 2);
    // The source takes d2 as 2.326: σ differs in the fifth digit.
    near(inside.upper.unwrap().ppm.value, number(&published["ppm_within_above"]), 5e-4);
    let sbar = of(&five, &CapabilityPlan { method: Method::Deviations, ..plan });
    near(sbar.within.unwrap().sigma.value, number(&computed["s_within_sbar_c4"]), 1e-9);
    let wide = of(&five, &CapabilityPlan { level: 0.95, ..plan }).overall;
    let ends = numbers(&computed["Pp_ci95"]);
    near(wide.potential.unwrap().lower, ends[0], 1e-9);
    near(wide.potential.unwrap().upper, ends[1], 1e-9);
    let normal = Fitted::of(&values, Family::Normal).unwrap();
    let test = anderson_darling(&values, &normal).unwrap();
    near(test.statistic, number(&computed["AD"]), 1e-9);
    near(test.adjusted, number(&computed["AD_star"]), 1e-9);
    near(test.p.unwrap(), number(&computed["AD_p"]), 1e-8);
}

/// A missing limit once gave a Cpk of 7.39 elsewhere: here the other side alone counts, and there is no Cp.
#[test]
fn one_limit_has_its_side_and_no_potential() {
    let rings = groups(&data("pistonrings.json")["subgroups"]);
    let upper = Tolerance::new(None, Some(74.05)).unwrap();
    let found = of(&rings[..25], &CapabilityPlan::of(upper, Method::Ranges));
    let inside = found.within.unwrap();
    near(inside.actual.value, 1.663_168_642_677_315_8, 1e-12);
    assert!(inside.potential.is_none() && inside.lower.is_none() && inside.about_target.is_none());
    near(inside.ppm.upper, inside.upper.unwrap().ppm.upper, 1e-15);
    assert!(found.overall.potential.is_none());
}

#[test]
fn few_values_have_wide_intervals_and_none_have_a_reason() {
    let plan = CapabilityPlan::of(both(9.0, 11.0), Method::MovingRange);
    let two = of(&singles(&[10.0, 10.1]), &plan);
    let cp = two.within.unwrap().potential.unwrap();
    assert!(cp.lower < 0.1 * cp.value && 1.5 * cp.value < cp.upper, "{cp:?}");
    assert!(two.overall.ppm.upper > 1e5);
    let try_of = |values: &[f64]| {
        let all = singles(values);
        capability(all.iter().map(Vec::as_slice), &plan)
    };
    assert_eq!(try_of(&[]), Err(Reason::Empty));
    assert_eq!(try_of(&[10.0]), Err(Reason::TooFew { found: 1, needed: 2 }));
    assert_eq!(try_of(&[10.0; 9]), Err(Reason::AllEqual));
    assert_eq!(try_of(&[10.0, f64::NAN]), Err(Reason::NotANumber { place: 2 }));
    // No subgroup tells σ within; the figures of all values are there.
    let ones = singles(&[10.0, 10.1, 10.2]);
    let found = of(&ones, &CapabilityPlan { method: Method::Pooled, ..plan });
    assert_eq!(found.within, Err(Reason::NoSubgroups));
    assert!(found.overall.potential.is_some());
    assert!(capability([[1.0, 2.0].as_slice()], &CapabilityPlan { level: 1.0, ..plan }).is_err());
}

#[test]
fn limits_that_are_none_are_refused() {
    assert_eq!(Tolerance::new(None, None), Err(Reason::NoLimits));
    assert_eq!(Tolerance::new(Some(1.0), Some(1.0)), Err(Reason::SwappedLimits));
    assert_eq!(Tolerance::new(Some(2.0), Some(1.0)), Err(Reason::SwappedLimits));
    assert_eq!(Tolerance::new(Some(f64::NAN), None), Err(Reason::SwappedLimits));
    assert_eq!(Tolerance::new(Some(1.0), None).unwrap().middle(), Err(Reason::OneLimit));
    // A value on a limit is within.
    assert_eq!(both(1.0, 2.0).outside(&[0.9, 1.0, 2.0, 2.1, 3.0]), [1, 2]);
}

/// The law is found again from many of its quantiles, and its quantiles and tails belong together.
#[test]
fn each_law_is_found_again() {
    for (family, first, second) in [
        (Family::Normal, 25.01, 0.003),
        (Family::LogNormal, -5.0, 0.4),
        (Family::Weibull, 0.02, 1.7),
        (Family::Weibull, 25.0, 4_000.0),
        (Family::FoldedNormal, 0.004, 0.002),
    ] {
        let law = Law { family, first, second };
        let number = 4_000;
        let values: Vec<f64> = (0..number).map(|at| law.quantile((f64::from(at) + 0.5) / f64::from(number))).collect();
        let found = Fitted::of(&values, family).unwrap().law;
        near(found.first, first, 3e-3);
        near(found.second, second, 3e-3);
        for share in [0.001_35, 0.2, 0.5, 0.998_65] {
            let tails = law.tails(law.quantile(share));
            near(tails.below, share, 1e-9);
            near(tails.below + tails.above, 1.0, 1e-12);
        }
    }
    // About 0 the folded law is the half of a normal one.
    let half = Law { family: Family::Normal, first: 0.0, second: 2.0 };
    let values: Vec<f64> = (0..500).map(|at| half.quantile(0.5 + (f64::from(at) + 0.5) / 1_000.0)).collect();
    let found = Fitted::of(&values, Family::FoldedNormal).unwrap().law;
    assert!(found.first < 0.4 * found.second, "{found:?}");
    near(found.quantile(0.998_65), half.quantile(0.999_325), 0.02);
}

/// The percentile method of normal values is that of the mean and the standard deviation: the span is 5.999954 s.
#[test]
fn percentiles_of_normal_values_are_those_of_the_normal_law() {
    let values = numbers(&study("capability_100")["data"]);
    let limits = both(0.0, 12.0);
    let found = percentiles(&values, Family::Normal, &limits, 0.9).unwrap();
    let plan = CapabilityPlan { level: 0.9, ..CapabilityPlan::of(limits, Method::Overall) };
    let overall = of(&singles(&values), &plan).overall;
    near(found.potential.unwrap().value * 5.999_954, overall.potential.unwrap().value * 6.0, 1e-7);
    near(found.actual.value, overall.actual.value, 1e-5);
    near(found.actual.lower, overall.actual.lower, 1e-2);
    near(found.above.unwrap().value, overall.upper.unwrap().ppm.value, 1e-9);
    near(found.above.unwrap().upper, overall.upper.unwrap().ppm.upper, 2e-2);
    // The lognormal law of e^x is the normal one of x: the same share is outside.
    let powers: Vec<f64> = values.iter().map(|value| (value / 10.0).exp()).collect();
    let upper = Tolerance::new(None, Some(1.2_f64.exp())).unwrap();
    let lognormal = percentiles(&powers, Family::LogNormal, &upper, 0.9).unwrap();
    near(lognormal.above.unwrap().value, found.above.unwrap().value, 1e-9);
    near(lognormal.test.unwrap().statistic, found.test.unwrap().statistic, 1e-9);
    assert!(lognormal.potential.is_none() && lognormal.below.is_none());
}

#[test]
fn values_that_a_law_cannot_have_are_refused() {
    let limits = both(0.0, 1.0);
    let of = |values: &[f64], family| percentiles(values, family, &limits, 0.95).err();
    assert_eq!(of(&[0.1, 0.0, 0.2], Family::LogNormal), Some(Reason::NotPositive));
    assert_eq!(of(&[0.1, 0.0, 0.2], Family::Weibull), Some(Reason::NotPositive));
    assert_eq!(of(&[0.1, -0.1, 0.2], Family::FoldedNormal), Some(Reason::Negative));
    assert_eq!(of(&[0.1, 0.2], Family::Normal), Some(Reason::TooFew { found: 2, needed: 3 }));
    for family in Family::ALL {
        assert_eq!(of(&[0.3; 20], family), Some(Reason::AllEqual));
        // Few values are few, not a crash.
        let few = percentiles(&[0.1, 0.3, 0.2, 0.25], family, &limits, 0.95).unwrap();
        assert_eq!(few.test, Err(Reason::TooFew { found: 4, needed: 8 }));
        assert!(few.actual.lower < few.actual.value && few.actual.value < few.actual.upper, "{family:?}");
    }
}

/// How often each of several conditions holds in so many simulated series.
fn held<const N: usize>(series: usize, holds: impl Fn(&mut Simulated) -> [bool; N]) -> [f64; N] {
    let mut simulated = Simulated::of(7);
    let mut held = [0; N];
    for _ in 0..series {
        for (count, holds) in held.iter_mut().zip(holds(&mut simulated)) {
            *count += usize::from(holds);
        }
    }
    held.map(|held| fitcheck_statistics::count(held) / fitcheck_statistics::count(series))
}

/// 10 000 series of 50 values: the standard error of a level is 0.2 %.
#[test]
fn intervals_hold_their_level() {
    let limits = both(-3.0, 4.5);
    let is_in = |found: Estimate, truth: f64| found.lower <= truth && truth <= found.upper;
    for (method, size, series) in [
        (Method::MovingRange, 1, 10_000),
        (Method::Ranges, 5, 10_000),
        (Method::Deviations, 5, 3_000),
        (Method::Pooled, 2, 3_000),
        (Method::Ranges, 2, 3_000),
    ] {
        let plan = CapabilityPlan::of(limits, method);
        let levels = held(series, |simulated| {
            let groups: Vec<Vec<f64>> = simulated.normals(50).chunks(size).map(<[f64]>::to_vec).collect();
            let found = of(&groups, &plan);
            let inside = found.within.unwrap();
            [
                is_in(inside.potential.unwrap(), 1.25),
                is_in(inside.actual, 1.0),
                is_in(found.overall.potential.unwrap(), 1.25),
                is_in(found.overall.actual, 1.0),
                is_in(found.mean, 0.0),
                is_in(found.overall.deviation, 1.0),
            ]
        });
        for (name, level) in ["Cp", "Cpk", "Pp", "Ppk", "mean", "s"].iter().zip(levels) {
            assert!((0.94..0.96).contains(&level), "{method:?} of {size}: {name} {level}");
        }
    }
}

/// Bonferroni: the share outside is held at least as often as it says.
#[test]
fn the_interval_of_the_share_outside_holds_at_least_its_level() {
    let plan = CapabilityPlan::of(both(-2.0, 2.0), Method::MovingRange);
    let truth = 45_500.263_896;
    let [level] = held(3_000, |simulated| {
        let ppm = of(&singles(&simulated.normals(50)), &plan).overall.ppm;
        [ppm.lower <= truth && truth <= ppm.upper]
    });
    assert!((0.95..=1.0).contains(&level), "{level}");
}

/// 2 000 series of 100 values; the delta method is one for many values.
#[test]
fn intervals_of_percentiles_hold_their_level() {
    for law in [
        Law { family: Family::LogNormal, first: 0.0, second: 0.3 },
        Law { family: Family::Weibull, first: 2.0, second: 1.8 },
        Law { family: Family::FoldedNormal, first: 2.0, second: 1.0 },
    ] {
        let limit = law.quantile(0.9995);
        let tolerance = Tolerance::new(None, Some(limit)).unwrap();
        let middle = law.quantile(0.5);
        let truth = (limit - middle) / (law.quantile(0.998_65) - middle);
        let [level] = held(2_000, |simulated| {
            let values: Vec<f64> = simulated.shares(100).into_iter().map(|share| law.quantile(share)).collect();
            let found = percentiles(&values, law.family, &tolerance, 0.95).unwrap().actual;
            [found.lower <= truth && truth <= found.upper]
        });
        assert!((0.92..0.975).contains(&level), "{law:?}: {level}");
    }
}
