//! The band: its axis, its marker and its sides.

use fitcheck::report::band::{Band, Marker, Side};

use super::*;

fn band_limits(feature: Feature, nominal: &str, upper_nm: i64, lower_nm: i64) -> Limits {
    let nm = |nm| Length::from_nanometres(nm).unwrap();
    let deviations = Deviations::new(nm(upper_nm), nm(lower_nm)).unwrap();
    Limits::new(feature, nominal.parse().unwrap(), deviations, Source::File("x".into())).unwrap()
}

#[track_caller]
fn check(limits: &Limits, measured: &str, axis: [f64; 2], marker: Marker) {
    let band = Band::new(limits, Some(measured.parse().unwrap()));
    assert_eq!(([band.axis_min_um, band.axis_max_um], band.marker), (axis, Some(marker)), "for {measured}");
}

#[test]
fn a_value_near_the_zone_stretches_the_axis_and_a_far_one_becomes_an_arrow() {
    let hole = band_limits(Feature::Hole, "25", 20_000, 0);
    check(&hole, "25.012", [-10.0, 30.0], Marker::InSight(12.0));
    check(&hole, "25.020", [-10.0, 30.0], Marker::InSight(20.0));
    check(&hole, "25.030", [-10.0, 33.0], Marker::InSight(30.0));
    check(&hole, "25.040", [-10.0, 43.0], Marker::InSight(40.0));
    check(&hole, "25.040001", [-10.0, 30.0], Marker::BeyondRight(40.001));
    check(&hole, "24.980", [-23.0, 30.0], Marker::InSight(-20.0));
    check(&hole, "24.979999", [-10.0, 30.0], Marker::BeyondLeft(-20.001));
    check(&hole, "635", [-10.0, 30.0], Marker::BeyondRight(610_000.0));
}

#[test]
fn the_nominal_size_is_shown_when_it_is_near() {
    let near = Band::new(&band_limits(Feature::Shaft, "25", -7_000, -20_000), None);
    assert!(near.shows(0.0) && near.ticks.contains(&0.0), "{near:?}");
    assert_eq!(near.marker, None);
    let far = Band::new(&band_limits(Feature::Shaft, "25", -65_000, -117_000), None);
    assert!(!far.shows(0.0), "{far:?}");
}

#[test]
fn rework_and_scrap_swap_for_a_shaft() {
    let sides = |feature| {
        let band = Band::new(&band_limits(feature, "25", 5_000, -5_000), None);
        (band.left, band.right)
    };
    assert_eq!(sides(Feature::Hole), (Side::Rework, Side::Scrap));
    assert_eq!(sides(Feature::Shaft), (Side::Scrap, Side::Rework));
}

#[test]
fn a_zone_of_no_width_has_an_axis() {
    let none = band_limits(Feature::Hole, "25", 3_000, 3_000);
    check(&none, "25.003", [-2.0, 8.0], Marker::InSight(3.0));
    check(&none, "25.013", [-2.0, 14.5], Marker::InSight(13.0));
    check(&none, "25.013001", [-2.0, 8.0], Marker::BeyondRight(13.001));
}

proptest::proptest! {
    #[test]
    fn every_band_is_in_order(lower in -5_000_000_i64..5_000_000, width in 0_i64..5_000_000,
                              measured in -10_000_000_i64..10_000_000) {
        let limits = band_limits(Feature::Hole, "25", lower + width, lower);
        let measured = Length::from_nanometres(25_000_000 + measured).unwrap();
        let band = Band::new(&limits, Some(measured));
        assert!(band.axis_min_um < band.lower_um && band.upper_um < band.axis_max_um);
        assert!(band.lower_um <= band.upper_um);
        if 0 < width {
            assert!(0.3 < (band.upper_um - band.lower_um) / (band.axis_max_um - band.axis_min_um), "{band:?}");
        }
        assert!((3..=13).contains(&band.ticks.len()), "{band:?}");
        assert!(band.ticks.iter().all(|tick| band.shows(*tick)) && band.ticks.is_sorted());
        match band.marker {
            Some(Marker::InSight(um)) => assert!(band.shows(um)),
            Some(Marker::BeyondLeft(um)) => assert!(um < band.axis_min_um),
            Some(Marker::BeyondRight(um)) => assert!(band.axis_max_um < um),
            None => panic!("there is a value"),
        }
    }
}
