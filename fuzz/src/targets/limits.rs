//! A callout's limits: they add up, they belong to the zone, a nanometre more does not, and a hole's follow from a
//! shaft's wherever ISO 286 has a rule.

use std::sync::LazyLock;

use fitcheck::control::shipped_tables;
use fitcheck::length::Length;
use fitcheck::tolerance::iso286::{self, Edition, Grade, JsHalves, Letter, Options};
use fitcheck::tolerance::{Callout, Deviations, Feature, Limits, Sources, Tolerance};
use fitcheck::verdict::{Status, classify, doubt, judge_size};

use super::shared::{Figures, told};

/// The built-in tables, and nothing else.
static TABLES: LazyLock<Sources> = LazyLock::new(|| Sources::of_tables(shipped_tables()));

pub fn run(bytes: &[u8]) {
    let mut figures = Figures(bytes);
    let options = Options {
        edition: figures.one_of(&[Edition::Of2010, Edition::Of1988]),
        js: figures.one_of(&[JsHalves::Exact, JsHalves::Rounded]),
    };
    let feature = figures.one_of(&[Feature::Hole, Feature::Shaft]);
    let Ok(callout) = String::from_utf8_lossy(figures.0).parse::<Callout>() else { return };
    let sources = Sources::default().with_options(options);
    let asked = if callout.class().is_some() { None } else { Some(feature) };
    match sources.limits(&callout, asked) {
        Ok(limits) => {
            add_up(&limits, callout.nominal());
            borders(&limits);
        }
        Err(error) => told(bytes, &error),
    }
    if let Tolerance::Class(_) | Tolerance::Fit { .. } = callout.tolerance() {
        for class in [callout.class_for(Feature::Hole), callout.class_for(Feature::Shaft)].into_iter().flatten() {
            if let Some((letter, grade)) = iso286::parts(class) {
                zone(class.feature(), letter, grade, callout.nominal(), options);
                fits(letter, callout.nominal(), options);
            }
            let callout = Callout::new(callout.nominal(), class).expect("a size above zero");
            if let Ok(limits) = TABLES.limits(&callout, None) {
                let standard = iso286::deviations(class, callout.nominal(), Options::default());
                assert_eq!(Ok(limits.deviations), standard.map(|cell| cell.deviations), "{callout}");
            }
        }
    }
}

fn add_up(limits: &Limits, nominal: Length) {
    assert_eq!(limits.nominal, nominal);
    assert_eq!(nominal.checked_add(limits.deviations.upper()), Some(limits.maximum()));
    assert_eq!(nominal.checked_add(limits.deviations.lower()), Some(limits.minimum()));
    assert!(limits.minimum() <= limits.maximum());
}

fn borders(limits: &Limits) {
    let (small, large) = match limits.feature {
        Some(Feature::Hole) => (Status::Rework, Status::Scrap),
        Some(Feature::Shaft) => (Status::Scrap, Status::Rework),
        None => (Status::OutOfLimits, Status::OutOfLimits),
    };
    let (minimum, maximum) = (limits.minimum().nanometres(), limits.maximum().nanometres());
    for (measured, status) in
        [(minimum - 1, small), (minimum, Status::Good), (maximum, Status::Good), (maximum + 1, large)]
    {
        let Ok(measured) = Length::from_nanometres(measured) else { continue };
        let verdict = judge_size(limits, measured);
        assert_eq!(verdict.status, status);
        assert_eq!(classify(limits.feature, limits.minimum(), limits.maximum(), measured), status);
        assert_eq!(
            verdict.removal.map(|removal| removal.to_limit.nanometres()),
            (status == Status::Rework).then_some(1)
        );
        let _doubt = doubt(limits, measured);
    }
}

fn deviations(feature: Feature, letter: Letter, grade: Grade, nominal: Length, options: Options) -> Option<Deviations> {
    iso286::deviations(iso286::class(feature, letter, grade), nominal, options).ok().map(|cell| cell.deviations)
}

/// A zone is as wide as its grade, and the same over its whole step; up to H a hole's is a shaft's turned over.
fn zone(feature: Feature, letter: Letter, grade: Grade, nominal: Length, options: Options) {
    let Ok(cell) = iso286::deviations(iso286::class(feature, letter, grade), nominal, options) else { return };
    assert!(cell.over < nominal && nominal <= cell.to);
    for same in [cell.over.nanometres() + 1, cell.to.nanometres()] {
        let same = Length::from_nanometres(same).expect("a size within the step");
        assert_eq!(deviations(feature, letter, grade, same, options), Some(cell.deviations));
    }
    let width = iso286::standard_tolerance(grade, nominal).expect("a zone has a grade");
    if letter != Letter::Js || options.js == JsHalves::Exact {
        assert_eq!(cell.deviations.width(), width);
    }
    if letter <= Letter::H || letter == Letter::Js {
        let other = deviations(feature.other(), letter, grade, nominal, options).expect("both or none");
        assert_eq!(
            (other.upper().negated(), other.lower().negated()),
            (cell.deviations.lower(), cell.deviations.upper())
        );
    }
}

/// Fits Hn/x(n-1) and Xn/h(n-1) have the same clearances: K, M, N to n = 8, P to ZC to n = 7, above 3 up to 500 mm.
/// The tables have exceptions: M6 above 250 up to 315 mm; K3 and K4, where k2 and k3 begin at zero.
fn fits(letter: Letter, nominal: Length, options: Options) {
    let mm = |mm: i32| Length::from_micrometres(mm * 1000);
    if letter < Letter::K || nominal <= mm(3) || mm(500) < nominal {
        return;
    }
    for number in 3..=if letter <= Letter::N { 8 } else { 7 } {
        let is_exception = letter == Letter::M && number == 6 && mm(250) < nominal && nominal <= mm(315)
            || letter == Letter::K && number < 5;
        let (Some(grade), Some(finer)) = (Grade::numbered(number), Grade::numbered(number - 1)) else { continue };
        let clearances = |hole, shaft| {
            let hole = deviations(Feature::Hole, hole, grade, nominal, options)?;
            let shaft = deviations(Feature::Shaft, shaft, finer, nominal, options)?;
            Some((hole.upper().saturating_sub(shaft.lower()), hole.lower().saturating_sub(shaft.upper())))
        };
        if let (Some(hole_basis), Some(shaft_basis)) = (clearances(Letter::H, letter), clearances(letter, Letter::H)) {
            assert!(hole_basis == shaft_basis || is_exception, "{letter:?}{number} at {nominal}");
        }
    }
}
