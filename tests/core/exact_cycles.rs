//! On an exact workpiece every cycle gives the exact answer; neither the first angle nor the direction changes it.

use fitcheck::length::Length;
use fitcheck::probing::TouchProbe;
use fitcheck::probing::cycle::{Angle, Cycle, CycleResult, Inputs, Key, Plane, Value};
use fitcheck::probing::cycles::cycle_named;
use fitcheck::probing::simulated::{Face, FreePoint, Machine, Probe, Surface, Workpiece};
use fitcheck::tolerance::Feature;
use proptest::prelude::*;

/// What is required of every cycle, mm.
const EXACT: f64 = 1e-9;

fn length(mm: f64) -> Value {
    Value::Length(Length::from_mm_f64(mm).unwrap())
}

fn angle(ten_thousandths: i64) -> Value {
    let sign = if ten_thousandths < 0 { "-" } else { "" };
    let size = ten_thousandths.abs();
    let angle: Angle = format!("{sign}{}.{:04}", size / 10_000, size % 10_000).parse().unwrap();
    Value::Angle(angle)
}

fn machine(surface: Surface, ball_radius: f64) -> Machine {
    Machine::with(surface, Probe { ball_radius, ..Probe::STILL }, 1).unwrap()
}

/// A round feature and how a cycle probes it; angles in ten-thousandths of a degree.
#[derive(Debug, Clone, Copy)]
struct Round {
    code: &'static str,
    feature: Feature,
    plane: Plane,
    /// Where the centre is.
    centre: [f64; 2],
    /// Where it should be, from there.
    off: [f64; 2],
    diameter: f64,
    first: i64,
    step: i64,
    contacts: i64,
    ball_radius: f64,
}

impl Round {
    fn inputs(&self) -> Inputs {
        let nominal = [self.centre[0] + self.off[0], self.centre[1] + self.off[1]].map(length);
        let [nominal_1, nominal_2] = nominal;
        if self.code == "G785" {
            let (start, path) = match self.feature {
                Feature::Hole => (self.diameter - 12.0, 9.0),
                Feature::Shaft => (self.diameter + 12.0, -9.0),
            };
            let plane = match self.plane {
                Plane::Xy => 0,
                Plane::Zx => 1,
                Plane::Yz => 2,
            };
            return Inputs::new()
                .with(Key::Word("R"), Value::Whole(plane))
                .with(Key::Word("BR"), Value::Whole(i64::from(self.feature == Feature::Shaft)))
                .with(Key::Word("D"), length(start))
                .with(Key::Word("K"), length(path))
                .with(Key::Word("C"), angle(self.first))
                .with(Key::Word("RC"), angle(self.step))
                .with(Key::Word("I"), nominal_1)
                .with(Key::Word("J"), nominal_2);
        }
        Inputs::new()
            .with(273, nominal_1)
            .with(274, nominal_2)
            .with(262, length(self.diameter))
            .with(325, angle(self.first))
            .with(247, angle(self.step))
            .with(423, Value::Whole(self.contacts))
            .with_probe(TouchProbe::default())
    }

    fn run(&self) -> CycleResult {
        let part = Workpiece::round(self.feature, self.centre, self.diameter);
        let cycle: &Cycle = cycle_named(self.code).unwrap();
        cycle.measure(&self.inputs(), &mut machine(Surface::Round(part, self.plane), self.ball_radius)).unwrap()
    }

    /// The largest error of centre and diameter, mm.
    fn error(&self) -> f64 {
        let circle = self.run().circle.unwrap().circle;
        let [x, y] = self.centre;
        (circle.x - x).abs().max((circle.y - y).abs()).max((circle.diameter - self.diameter).abs())
    }

    /// What the control lists, without the places of the contacts.
    fn listed(&self) -> Vec<(Key, Value)> {
        self.run().results.into_iter().filter_map(|found| Some((found.key?, found.value))).collect()
    }
}

/// Round features within the given mm, with a step of the given degrees either way.
fn rounds(reach: f64, steps: std::ops::RangeInclusive<i64>) -> impl Strategy<Value = Round> {
    let code = proptest::sample::select(vec!["421", "422", "G785"]);
    let sense = prop_oneof![Just(1_i64), Just(-1)];
    let plane = proptest::sample::select(vec![Plane::Xy, Plane::Zx, Plane::Yz]);
    let places = ([-reach..reach, -reach..reach], [-0.3..0.3_f64, -0.3..0.3], 15.0..200.0_f64);
    let turns = (-3_600_000..=3_600_000_i64, steps, sense, 3_i64..=4);
    (code, any::<bool>(), plane, places, turns, 0.0..4.0_f64).prop_map(
        |(code, is_hole, plane, (centre, off, diameter), (first, step, sense, contacts), ball_radius)| {
            let (feature, plane) = match code {
                "421" => (Feature::Hole, Plane::Xy),
                "422" => (Feature::Shaft, Plane::Xy),
                _ => (if is_hole { Feature::Hole } else { Feature::Shaft }, plane),
            };
            // Places on the nanometre grid, so that a result is on the grid and not between two points.
            let nanometre = |mm: f64| (mm * 1e6).round() / 1e6;
            Round {
                code,
                feature,
                plane,
                centre: centre.map(nanometre),
                off: off.map(nanometre),
                diameter: nanometre(diameter),
                first,
                step: sense * step,
                contacts,
                ball_radius,
            }
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    #[test]
    fn circles_are_exact_within_a_metre(round in rounds(1000.0, 300_000..=1_200_000)) {
        prop_assert!(round.error() < EXACT, "{:e}", round.error());
    }

    #[test]
    fn circles_are_exact_at_the_end_of_the_range(round in rounds(99_999.0, 600_000..=1_200_000)) {
        prop_assert!(round.error() < EXACT, "{:e}", round.error());
    }

    #[test]
    fn circles_are_exact_on_the_shortest_arcs(round in rounds(50.0, 50_000..=300_000)) {
        prop_assert!(round.error() < EXACT, "{:e}", round.error());
    }

    #[test]
    fn the_first_angle_and_the_sense_of_the_step_change_no_result(
        round in rounds(1000.0, 300_000..=1_200_000),
        other in -3_600_000..=3_600_000_i64,
    ) {
        let listed = round.listed();
        prop_assert_eq!(&Round { first: other, ..round }.listed(), &listed);
        prop_assert_eq!(&Round { step: -round.step, ..round }.listed(), &listed);
        prop_assert_eq!(&Round { first: other, step: -round.step, ..round }.listed(), &listed);
    }

    #[test]
    fn cycle_427_is_exact_and_the_same_from_both_sides(
        point in [-99_990.0..99_990.0_f64, -99_990.0..99_990.0, -99_990.0..99_990.0],
        off in -1.5..1.5_f64,
        axis in 0_usize..3,
        ball_radius in 0.0..5.0_f64,
    ) {
        let nanometre = |mm: f64| (mm * 1e6).round() / 1e6;
        let mut place = point.map(nanometre);
        let nominal = place;
        place[axis] = nanometre(place[axis] + off);
        let measured = |direction: i64| {
            let cycle = cycle_named("427").unwrap();
            let inputs = [263, 264, 261].into_iter().zip(nominal)
                .fold(Inputs::new(), |inputs, (key, part)| inputs.with(key, length(part)))
                .with(272, Value::Whole(i64::try_from(axis).unwrap() + 1))
                .with(267, Value::Whole(direction));
            let mut normal = [0.0; 3];
            normal[axis] = if direction < 0 { 1.0 } else { -1.0 };
            let face = Face { point: place, normal, wave: None, surface_scatter: 0.0 };
            let result = cycle.measure(&inputs, &mut machine(Surface::Face(face), ball_radius)).unwrap();
            (result.contacts[0].place()[axis], result.value(160).cloned())
        };
        let (down, up) = (measured(-1), measured(1));
        prop_assert!((down.0 - place[axis]).abs() < EXACT && (up.0 - place[axis]).abs() < EXACT, "{down:?} {up:?}");
        prop_assert_eq!((&down.1, &up.1), (&Some(length(place[axis])), &Some(length(place[axis]))));
    }

    #[test]
    fn cycle_444_is_exact_for_a_normal_of_any_direction_and_length(
        point in [-99_990.0..99_990.0_f64, -99_990.0..99_990.0, -99_990.0..99_990.0],
        normal in [-10.0..10.0_f64, -10.0..10.0, -10.0..10.0],
        power in -200_i32..=0,
        deviation in -1.5..1.5_f64,
        ball_radius in 0.0..5.0_f64,
    ) {
        prop_assume!(0.01 < normal.iter().map(|part| part * part).sum::<f64>());
        let nanometre = |mm: f64| (mm * 1e6).round() / 1e6;
        let (point, deviation) = (point.map(nanometre), nanometre(deviation));
        let surface = Surface::Point(FreePoint { point, normal, deviation, radius: None, surface_scatter: 0.0 });
        let cycle = cycle_named("444").unwrap();
        let found = |power: i32| {
            let inputs = [(263, 581), (264, 582), (294, 583)].into_iter().zip(point.into_iter().zip(normal)).fold(
                Inputs::new(),
                |inputs, ((place, component), (mm, part))| {
                    inputs.with(place, length(mm)).with(component, Value::Number(part * 10.0_f64.powi(power)))
                },
            );
            let result = cycle.measure(&inputs, &mut machine(surface, ball_radius)).unwrap();
            (result.contacts[0].place(), result.value(164).cloned())
        };
        let size = normal.iter().map(|part| part * part).sum::<f64>().sqrt();
        let (place, along) = found(power);
        for axis in 0..3 {
            let error = place[axis] - (point[axis] + deviation * normal[axis] / size);
            prop_assert!(error.abs() < EXACT, "{error:e}");
        }
        prop_assert_eq!(&along, &Some(length(deviation)));
        prop_assert_eq!(along, found(0).1);
    }
}
