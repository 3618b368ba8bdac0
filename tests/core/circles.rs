//! Circle evaluation against the certified NIST sets, textbook sets, and exact circles anywhere.

use fitcheck::probing::Contact;
use fitcheck::probing::circle::{Circle, Evaluation, arc_deg, evaluate, least_squares};
use proptest::prelude::*;
use serde_json::Value;

const SETS: [&str; 2] =
    [include_str!("../data/circles/nist_circles.json"), include_str!("../data/circles/textbook_circles.json")];

fn contact([x, y]: [f64; 2]) -> Contact {
    Contact { x, y, z: 0.0 }
}

/// Every reference set: its name, its contacts and its answers.
pub fn sets() -> Vec<(String, Vec<Contact>, Value)> {
    let files = SETS.map(|file| serde_json::from_str::<Value>(file).unwrap());
    let sets = files.iter().flat_map(|file| file["sets"].as_array().unwrap());
    let sets: Vec<_> = sets
        .map(|set| {
            let point = |point: &Value| contact([point[0].as_f64().unwrap(), point[1].as_f64().unwrap()]);
            let contacts: Vec<_> = set["points"].as_array().unwrap().iter().map(point).collect();
            assert_eq!(Value::from(contacts.len()), set["n"]);
            (set["id"].as_str().unwrap().to_owned(), contacts, set.clone())
        })
        .collect();
    assert_eq!(sets.len(), 19);
    sets
}

#[track_caller]
fn near(found: f64, expected: &Value, tolerance: f64, what: &str) {
    let expected = expected.as_f64().unwrap();
    let error = (found - expected).abs();
    assert!(error <= tolerance * expected.abs().max(1.0), "{what}: {found} instead of {expected}, off by {error:e}");
}

#[test]
fn every_reference_set_is_met_by_every_criterion() {
    for (id, contacts, set) in sets() {
        let found = evaluate(&contacts).unwrap();
        let answer = &set["least_squares"];
        near(found.least_squares.x, &answer["x"], 1e-9, &id);
        near(found.least_squares.y, &answer["y"], 1e-9, &id);
        near(found.least_squares.diameter, &answer["diameter"], 1e-9, &id);
        near(found.residual_rms(), &set["residual_rms"], 1e-9, &id);
        near(found.form(), &set["residual_max_minus_min"], 1e-9, &id);
        assert!((found.largest_gap_deg - set["largest_gap_deg"].as_f64().unwrap()).abs() < 1e-3, "{id}");

        let answer = &set["minimum_circumscribed"];
        near(found.minimum_circumscribed.x, &answer["x"], 1e-8, &id);
        near(found.minimum_circumscribed.y, &answer["y"], 1e-8, &id);
        near(found.minimum_circumscribed.diameter, &answer["diameter"], 1e-8, &id);

        let answer = &set["maximum_inscribed"];
        assert_eq!(found.maximum_inscribed.is_none(), answer.is_null(), "{id}: {:?}", found.maximum_inscribed);
        if let Some(circle) = found.maximum_inscribed {
            near(circle.x, &answer["x"], 1e-8, &id);
            near(circle.y, &answer["y"], 1e-8, &id);
            near(circle.diameter, &answer["diameter"], 1e-8, &id);
        }

        let answer = &set["minimum_zone"];
        let zone = found.minimum_zone.unwrap();
        near(zone.x, &answer["x"], 1e-8, &id);
        near(zone.y, &answer["y"], 1e-8, &id);
        near(zone.width, &answer["width"], 1e-8, &id);
        near(zone.outer_diameter, &answer["outer_diameter"], 1e-8, &id);
        near(zone.inner_diameter, &answer["inner_diameter"], 1e-8, &id);
    }
}

#[test]
fn a_circumscribed_circle_that_moves_without_growing_by_a_bit_is_found() {
    // Two contacts on a diameter, and a third beyond the circle on it by far less than the square root of a float's last
    // bit: the circle about all three has the same radius to the last bit, and its centre is off by as much.
    for (radius, beyond) in [(12.5, 1e-7), (500.0, 5e-6), (5e4, 5e-4)] {
        let contacts = [[radius, 0.0], [-radius, 0.0], [0.0, radius + beyond], [0.0, -radius / 2.0]].map(contact);
        let found = evaluate(&contacts).unwrap().minimum_circumscribed;
        let error = (found.diameter - 2.0 * radius).abs() / radius;
        assert!(error < 1e-14, "a circle of {} for one of {}", found.diameter, 2.0 * radius);
    }
}

#[test]
fn contacts_between_two_parallel_lines_have_no_minimum_zone() {
    // In turn on one line and on the other: the strip between the lines is the narrowest ring, of infinite radius.
    let zigzag = |last: f64| [[0.0, 0.0], [1.0, 0.1], [2.0, 0.0], [3.0, 0.1], [4.0, last]].map(contact);
    assert_eq!(evaluate(&zigzag(0.0)).unwrap().minimum_zone, None);
    // With the last one below its line, the narrowest strip has 0.10075 mm, from the line through it and the first to the
    // contact at 3 mm; a ring of 4 m bends after it.
    let zone = evaluate(&zigzag(-0.001)).unwrap().minimum_zone.unwrap();
    assert!(zone.width < 0.1007 && 1000.0 < zone.outer_diameter, "{zone:?}");
}

#[test]
fn a_set_scaled_by_a_power_of_two_has_the_same_answers_to_the_last_bit() {
    for (id, contacts, _) in sets() {
        let (centres, sizes) = answers(&contacts);
        for power in [-400, -30, 1, 17] {
            let scale = 2.0_f64.powi(power);
            let scaled: Vec<_> = contacts.iter().map(|at| contact([at.x * scale, at.y * scale])).collect();
            let (scaled_centres, scaled_sizes) = answers(&scaled);
            let expected: Vec<_> = centres.iter().map(|[x, y]| [x * scale, y * scale]).collect();
            assert_eq!(scaled_centres, expected, "{id} by 2^{power}");
            // Angles and factors stay what they are.
            let is_same =
                |(scaled, size): (&f64, &f64)| [*size, size * scale].map(f64::to_bits).contains(&scaled.to_bits());
            assert!(scaled_sizes.iter().zip(&sizes).all(is_same), "{id} by 2^{power}: {scaled_sizes:?} {sizes:?}");
        }
    }
}

/// Centres and sizes by every criterion: least squares, circumscribed, inscribed, zone; then form and uncertainties.
fn answers(contacts: &[Contact]) -> (Vec<[f64; 2]>, Vec<f64>) {
    let found = evaluate(contacts).unwrap();
    let circles = [Some(found.least_squares), Some(found.minimum_circumscribed), found.maximum_inscribed];
    let zone = found.minimum_zone.unwrap();
    let centres = circles.into_iter().flatten().map(|circle| [circle.x, circle.y]).chain([[zone.x, zone.y]]);
    let sizes = circles.into_iter().flatten().map(|circle| circle.diameter);
    let more =
        [zone.width, zone.outer_diameter, zone.inner_diameter, found.form(), found.residual_rms(), found.arc_deg];
    let two_point = found.two_point.iter().map(|size| size.size);
    let uncertainty = [found.uncertainty.diameter, found.uncertainty.centre_along, found.uncertainty.centre_across];
    (centres.collect(), sizes.chain(more).chain(two_point).chain(uncertainty).collect())
}

#[test]
fn every_reference_set_a_thousand_metres_away_has_the_same_answers_by_every_criterion() {
    // 2^20 mm, with contacts on a grid of 2^-32 mm: both places hold them without rounding, so nothing may be lost.
    let (far, grid) = (1_048_576.0, 4_294_967_296.0_f64);
    let mut worst = 0.0_f64;
    for (id, contacts, _) in sets() {
        let on_grid = |mm: f64| (mm * grid).round() / grid;
        let near: Vec<_> = contacts.iter().map(|at| contact([on_grid(at.x), on_grid(at.y)])).collect();
        let (centres, sizes) = answers(&near);
        for [x, y] in [[far, far], [-far, far], [-far, -far]] {
            let moved: Vec<_> = near.iter().map(|at| contact([at.x + x, at.y + y])).collect();
            let back: Vec<_> = moved.iter().map(|at| contact([at.x - x, at.y - y])).collect();
            assert_eq!(back, near, "{id} is rounded");
            let (moved_centres, moved_sizes) = answers(&moved);
            assert_eq!((moved_centres.len(), moved_sizes.len()), (centres.len(), sizes.len()), "{id}");
            for (moved, near) in moved_centres.iter().zip(&centres) {
                // A centre there is rounded to 2^-33.
                let error = (moved[0] - x - near[0]).abs().max((moved[1] - y - near[1]).abs());
                worst = worst.max(error);
                assert!(error <= 3e-10, "{id}: centre off by {error:e}");
            }
            for (moved, near) in moved_sizes.iter().zip(&sizes) {
                let error = (moved - near).abs() / near.abs().max(1.0);
                worst = worst.max(error);
                assert!(error <= 1e-12, "{id}: {near} became {moved}");
            }
        }
    }
    assert!(worst <= 3e-10, "{worst:e}");
}

#[test]
fn uncertainties_are_those_of_a_computation_with_sixty_digits() {
    // u(D)/s, against 3 x 120, u(centre)/s along and across: (JᵀJ)⁻¹ inverted in decimals, sines by their series.
    for (count, step, exact) in [
        (3, 120.0, "1.154700538379 1.000000000000 0.816496580928 0.816496580928"),
        (3, 90.0, "1.414213562373 1.224744871392 1.224744871392 0.707106781187"),
        (3, 75.0, "2.031853583392 1.759636819988 1.652423559050 0.732050807569"),
        (3, 60.0, "3.464101615138 3.000000000000 2.449489742783 0.816496580928"),
        (3, 45.0, "6.828427124746 5.913591357921 4.181540550352 1.000000000000"),
        (3, 30.0, "16.690238602414 14.454170624914 9.141620172686 1.414213562373"),
        (3, 20.0, "39.000854196781 33.775730503706 20.308374984158 2.067441918218"),
        (3, 15.0, "70.263484341022 60.849962397736 35.943494383216 2.732050807569"),
        (3, 10.0, "159.604064374417 138.221174295492 80.616440239272 4.072065659928"),
        (4, 90.0, "1.000000000000 0.866025403784 0.707106781187 0.707106781187"),
        (4, 60.0, "1.414213562373 1.224744871392 1.154700538379 0.632455532034"),
        (4, 45.0, "2.613125929753 2.263033438454 1.847759065023 0.707106781187"),
        (4, 30.0, "6.540994549060 5.664667445501 3.863703305156 0.939070801588"),
        (4, 20.0, "15.613774651055 13.521925496779 8.418759239072 1.335939616941"),
        (5, 72.0, "0.894427191000 0.774596669241 0.632455532034 0.632455532034"),
        (6, 60.0, "0.816496580928 0.707106781187 0.577350269190 0.577350269190"),
        (8, 45.0, "0.707106781187 0.612372435696 0.500000000000 0.500000000000"),
        (8, 22.5, "1.671628314059 1.447672585661 1.182019716495 0.500000000000"),
        (12, 30.0, "0.577350269190 0.500000000000 0.408248290464 0.408248290464"),
    ] {
        let contacts = on_circle([30.0, -70.0], 12.5, &evenly(17.0, step, count));
        let found = evaluate(&contacts).unwrap().uncertainty;
        let all = [found.diameter, found.against_three_by_120(), found.centre_along, found.centre_across];
        for (found, exact) in all.into_iter().zip(exact.split(' ')) {
            let exact: f64 = exact.parse().unwrap();
            assert!((found / exact - 1.0_f64).abs() < 1e-11, "{count} x {step}: {found} instead of {exact}");
        }
    }
}

fn on_circle(centre: [f64; 2], radius: f64, angles_deg: &[f64]) -> Vec<Contact> {
    let [x, y] = centre;
    let place = |angle: &f64| {
        let (sin, cos) = angle.to_radians().sin_cos();
        contact([x + radius * cos, y + radius * sin])
    };
    angles_deg.iter().map(place).collect()
}

fn evenly(first: f64, step: f64, count: u32) -> Vec<f64> {
    (0..count).map(|k| first + f64::from(k) * step).collect()
}

/// The largest of the errors of centre and diameter.
fn error(found: &fitcheck::probing::Circle, centre: [f64; 2], diameter: f64) -> f64 {
    let [x, y] = centre;
    (found.x - x).abs().max((found.y - y).abs()).max((found.diameter - diameter).abs())
}

proptest! {
    #[test]
    fn exact_circles_anywhere_answer_exactly(
        centre in [-1000.0..1000.0_f64, -1000.0..1000.0],
        diameter in 0.5..500.0_f64,
        first in -360.0..360.0_f64,
        step in prop_oneof![30.0..120.0_f64, -120.0..-30.0],
        count in 3_u32..12,
    ) {
        let contacts = on_circle(centre, diameter / 2.0, &evenly(first, step, count));
        prop_assume!(arc_deg(&contacts, &fitcheck::probing::Circle { x: centre[0], y: centre[1], diameter }) >= 60.0);
        let found = least_squares(&contacts).unwrap();
        prop_assert!(error(&found, centre, diameter) < 1e-9, "{found:?}");
    }

    #[test]
    fn far_from_the_origin_nothing_is_lost_beyond_the_contacts_own_rounding(
        centre in [-1e6..1e6_f64, -1e6..1e6],
        diameter in 1.0..100.0_f64,
        first in -360.0..360.0_f64,
        count in 3_u32..9,
    ) {
        let step = 360.0 / f64::from(count);
        let found = least_squares(&on_circle(centre, diameter / 2.0, &evenly(first, step, count))).unwrap();
        // A coordinate near a million has steps of 1.2e-10; contacts and the centre are rounded to them.
        prop_assert!(error(&found, centre, diameter) < 4.0 * 1.2e-10, "{found:?}");
    }

    #[test]
    fn the_order_of_contacts_changes_no_bit(
        radii in prop::collection::vec(9.9..10.1_f64, 3..40),
        seed in any::<u64>(),
    ) {
        let step = 360.0 / f64::from(u32::try_from(radii.len()).unwrap());
        let contacts: Vec<_> = (0_u32..)
            .zip(&radii)
            .map(|(k, _)| (f64::from(k) * step).to_radians().sin_cos())
            .zip(&radii)
            .map(|((sin, cos), radius)| contact([50.0 + radius * cos, radius * sin]))
            .collect();
        let mut shuffled = contacts.clone();
        let mut state = seed | 1;
        for index in (1..shuffled.len()).rev() {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            shuffled.swap(index, usize::try_from(state >> 33).unwrap() % (index + 1));
        }
        let (one, other) = (evaluate(&contacts).unwrap(), evaluate(&shuffled).unwrap());
        prop_assert_eq!(one.least_squares, other.least_squares);
        prop_assert_eq!(one.minimum_circumscribed, other.minimum_circumscribed);
        prop_assert_eq!(one.maximum_inscribed, other.maximum_inscribed);
        prop_assert_eq!(one.minimum_zone, other.minimum_zone);
        prop_assert_eq!(one.two_point.len(), other.two_point.len());
    }

    #[test]
    fn turning_all_contacts_turns_nothing_but_the_centre(turn in -360.0..360.0_f64, bump in 0.0..0.05_f64) {
        let radii = [10.0, 10.0 + bump, 10.0, 10.0, 10.0 - bump / 3.0, 10.0, 10.0];
        let contacts = |turn: f64| -> Vec<_> {
            let places = evenly(turn, 360.0 / 7.0, 7);
            places.iter().zip(radii).flat_map(|(&angle, radius)| on_circle([0.0, 0.0], radius, &[angle])).collect()
        };
        let (straight, turned) = (evaluate(&contacts(0.0)).unwrap(), evaluate(&contacts(turn)).unwrap());
        let sizes = |found: &Evaluation| [
            found.least_squares.diameter,
            found.minimum_circumscribed.diameter,
            found.maximum_inscribed.unwrap().diameter,
            found.minimum_zone.unwrap().width,
            found.form(),
            found.uncertainty.diameter,
        ];
        for (one, other) in sizes(&straight).into_iter().zip(sizes(&turned)) {
            prop_assert!((one - other).abs() < 1e-11, "{one} and {other}");
        }
    }

    #[test]
    fn no_circle_beside_the_least_squares_circle_of_any_scatter_is_better(
        points in prop::collection::vec([-1.0..1.0_f64, -1.0..1.0_f64], 4..9),
    ) {
        let contacts: Vec<_> = points.into_iter().map(contact).collect();
        // Some scatter is nearer to a straight line than to any circle.
        let Ok(found) = evaluate(&contacts) else { return Ok(()) };
        let squares = |x: f64, y: f64| {
            // How much farther a contact lies from the centre than the origin does: of a large circle about a small scatter,
            // the distances themselves would be rounded by more than a step changes them.
            let excess = |contact: &Contact| {
                let square = contact.x * contact.x + contact.y * contact.y;
                let across = contact.x * x + contact.y * y;
                (square - 2.0 * across) / ((contact.x - x).hypot(contact.y - y) + x.hypot(y))
            };
            let distances: Vec<f64> = contacts.iter().map(excess).collect();
            let mean = distances.iter().sum::<f64>() / f64::from(u32::try_from(distances.len()).unwrap());
            distances.iter().map(|distance| (distance - mean).powi(2)).sum::<f64>()
        };
        let circle = found.least_squares;
        let least = squares(circle.x, circle.y);
        for angle in evenly(0.0, 30.0, 12) {
            for step in [1e-3, 1e-2] {
                let (x, y) = (circle.x + step * angle.to_radians().cos(), circle.y + step * angle.to_radians().sin());
                prop_assert!(least <= squares(x, y) * (1.0 + 1e-12), "better {step} mm beside {circle:?}");
            }
        }
    }

    #[test]
    fn the_criteria_stand_in_their_order_and_no_crude_search_beats_them(
        radii in prop::collection::vec(9.0..11.0_f64, 4..16),
        first in 0.0..360.0_f64,
    ) {
        let step = 360.0 / f64::from(u32::try_from(radii.len()).unwrap());
        let angles = evenly(first, step, u32::try_from(radii.len()).unwrap());
        let contacts: Vec<_> =
            angles.iter().zip(&radii).flat_map(|(&angle, &radius)| on_circle([0.0, 0.0], radius, &[angle])).collect();
        let found = evaluate(&contacts).unwrap();
        let zone = found.minimum_zone.unwrap();
        let width = brute_width(&contacts);
        prop_assert!((zone.width - width).abs() < 1e-9, "{} instead of {width}", zone.width);
        prop_assert!(zone.width <= found.form() + 1e-12);
        for contact in &contacts {
            let around = found.minimum_circumscribed;
            let distance = (contact.x - around.x).hypot(contact.y - around.y);
            prop_assert!(distance <= around.diameter / 2.0 + 1e-12);
            if let Some(inside) = found.maximum_inscribed {
                let distance = (contact.x - inside.x).hypot(contact.y - inside.y);
                prop_assert!(inside.diameter / 2.0 <= distance + 1e-12);
            }
        }
    }
}

/// The width of the narrowest ring by trying every crossing of two perpendicular bisectors.
fn brute_width(contacts: &[Contact]) -> f64 {
    let mut bisectors = Vec::new();
    for (index, a) in contacts.iter().enumerate() {
        for b in &contacts[index + 1..] {
            let normal = [b.x - a.x, b.y - a.y];
            bisectors.push((normal, normal[0] * (a.x + b.x) / 2.0 + normal[1] * (a.y + b.y) / 2.0));
        }
    }
    let mut width = f64::INFINITY;
    for (index, (first, first_offset)) in bisectors.iter().enumerate() {
        for (second, second_offset) in &bisectors[index + 1..] {
            let determinant = first[0] * second[1] - first[1] * second[0];
            let x = (first_offset * second[1] - second_offset * first[1]) / determinant;
            let y = (second_offset * first[0] - first_offset * second[0]) / determinant;
            let distances = contacts.iter().map(|contact| (contact.x - x).hypot(contact.y - y));
            let (least, most) = distances
                .fold((f64::INFINITY, 0.0_f64), |(least, most), distance| (least.min(distance), most.max(distance)));
            if least.is_finite() && most - least < width {
                width = most - least;
            }
        }
    }
    width
}

#[test]
fn opposed_contacts_give_two_point_sizes() {
    // An oval of amplitude 0.01 probed on its axes: X minus Y is four times the amplitude.
    let contacts = [[10.01, 0.0], [0.0, 9.99], [-10.01, 0.0], [0.0, -9.99]].map(contact);
    let found = evaluate(&contacts).unwrap();
    let sizes: Vec<_> = found.two_point.iter().map(|size| (size.contacts, size.size)).collect();
    assert_eq!(sizes.len(), 2);
    assert_eq!(sizes[0].0, [1, 3]);
    assert_eq!(sizes[1].0, [2, 4]);
    assert!((sizes[0].1 - sizes[1].1 - 0.04).abs() < 1e-12);
    assert!((found.least_squares.diameter - 20.0).abs() < 1e-12);
    let three = on_circle([0.0, 0.0], 10.0, &evenly(0.0, 120.0, 3));
    assert!(evaluate(&three).unwrap().two_point.is_empty());
}

#[test]
fn a_chord_beside_the_centre_is_named() {
    // D = 25, contacts opposed about a point 0.1 mm off the true centre: the chord is 0.8 µm short.
    let half = (12.5_f64 * 12.5 - 0.1 * 0.1).sqrt();
    let contacts = [[half, 0.1], [0.0, 12.5], [-half, 0.1], [0.0, -12.5]].map(contact);
    let found = evaluate(&contacts).unwrap();
    assert!((found.two_point[0].short_by - 0.0008).abs() < 1e-5, "{:?}", found.two_point);
    let said: Vec<_> = found.warnings.iter().map(ToString::to_string).collect();
    assert_eq!(
        said,
        [
            "4 contacts: four lobes are not detected and change the diameter",
            "contacts 1 and 3 are opposite each other but off the centre: this size is 0.80 µm too small",
        ]
    );
}

#[test]
fn three_contacts_on_a_short_arc_say_how_much_worse_they_are() {
    let found = evaluate(&on_circle([5.0, 5.0], 12.5, &evenly(0.0, 60.0, 3))).unwrap();
    let said: Vec<_> = found.warnings.iter().map(ToString::to_string).collect();
    assert_eq!(
        said,
        [
            "3 contacts: form cannot be measured, the residual is always zero",
            "the contacts cover only 120.0° of arc: scatter in the diameter is 3.0 times that of 3 contacts at 120°",
            "the minimum circumscribed circle of a short arc is not the size of the feature",
            "no maximum inscribed circle: the contacts do not surround one",
        ]
    );
    assert!(found.form() < 1e-13);
}

#[test]
fn a_thousand_contacts_on_an_exact_or_oval_circle_are_answered_soon() {
    // On an exact circle all bisectors meet in one point; an oval's hull has every contact as a corner.
    let angles = evenly(0.0, 0.36, 1000);
    let exact = evaluate(&on_circle([50.0, 0.0], 12.5, &angles)).unwrap();
    assert!(exact.minimum_zone.unwrap().width < 1e-13);
    assert!((exact.maximum_inscribed.unwrap().diameter - 25.0).abs() < 1e-12);
    let radius = |angle: f64| 12.5 + 0.01 * (2.0 * angle.to_radians()).cos();
    let oval: Vec<_> = angles.iter().flat_map(|&angle| on_circle([50.0, 0.0], radius(angle), &[angle])).collect();
    let oval = evaluate(&oval).unwrap();
    assert!((oval.minimum_zone.unwrap().width - 0.02).abs() < 1e-12);
    assert!((oval.maximum_inscribed.unwrap().diameter - 24.98).abs() < 1e-8);
}

/// Two contacts close together, one opposite: the circle on the diameter between the two farthest holds the third. Found by the
/// fuzz target `circle`; the first circle of the search had a radius of hardly more than the last bits of the coordinates.
#[test]
fn the_circumscribed_circle_of_a_narrow_triangle_stands_on_its_longest_side() {
    let places = [
        [-4_656.447_244_088_679, 31_662.497_666_259_15],
        [-4_656.893_974_661_232, -31_665.535_305_250_738],
        [-4_657.340_136_874_278, 31_668.569_079_561_672],
    ];
    for order in [[0, 1, 2], [1, 2, 0], [2, 1, 0]] {
        let contacts = order.map(|at: usize| Contact { x: places[at][0], y: places[at][1], z: 0.0 });
        let circle = evaluate(&contacts).unwrap().minimum_circumscribed;
        let [[x1, y1], [x2, y2]] = [places[1], places[2]];
        let (x, y, diameter) = (f64::midpoint(x1, x2), f64::midpoint(y1, y2), (x1 - x2).hypot(y1 - y2));
        assert!((circle.x - x).abs() < 1e-9 && (circle.y - y).abs() < 1e-9, "{circle:?}");
        assert!((circle.diameter - diameter).abs() < 1e-9, "{circle:?}");
    }
}

/// Three contacts close together and one far off: the circle stands on two of the three and the far one. Found by the fuzz target
/// `circle`: the rounding of that circle's centre was taken for a contact outside, and the circle that was given instead was too
/// large by 1.4 m of 40 km.
#[test]
fn a_circumscribed_circle_on_two_contacts_close_together_and_one_far_off_is_no_larger_than_needed() {
    // Only where they lie, a hundred kilometres away, the rounding was as large as that.
    let away = |at: f64, by: f64| by + 1000.0 * at;
    let contacts = [[1.0, -1.0], [-1.0, 1.0], [-28_271.0, -28_271.0], [-1.0, -1.0]];
    let contacts = contacts.map(|[x, y]| contact([away(x, 1e8), away(y, -1e8)]));
    let circle = evaluate(&contacts).unwrap().minimum_circumscribed;
    // On the line x = y, as far from the first contact as from the third: 2 t² + 2 = 2 (t + 28 271)².
    let middle = (1.0 - 28_271.0_f64.powi(2)) / (2.0 * 28_271.0);
    assert!((circle.x - away(middle, 1e8)).abs() < 1e-6 && (circle.y - away(middle, -1e8)).abs() < 1e-6, "{circle:?}");
    assert!((circle.diameter - 2000.0 * (2.0 * middle * middle + 2.0).sqrt()).abs() < 1e-6, "{circle:?}");
}

/// Two valleys: along one the circle grows towards a straight line, along the other three places of four contacts are met.
#[test]
fn contacts_close_together_have_the_circle_that_meets_them_all_and_not_a_huge_one() {
    let (sin, cos) = 1.571_f64.sin_cos();
    let far = 1.000_006_835_937_5;
    let contacts = [[1.0, 0.0], [far * cos, far * sin], [1.000_013_061_523_437_5, 0.0], [1.0, 0.0]].map(contact);
    let found = evaluate(&contacts).unwrap();
    assert!(found.residual_rms() < 1e-14, "{}", found.residual_rms());
    // The centre lies midway between the two places on the X axis, and as far from them as from the second contact.
    let Circle { x, y, diameter } = found.least_squares;
    assert!((x - 1.000_006_530_761_718_8).abs() < 1e-9 && (y - 1.000_210_226_02).abs() < 1e-9, "{x} {y}");
    assert!((diameter - 2.000_420_452).abs() < 1e-8, "{diameter}");
}

#[test]
fn among_several_valleys_of_rough_contacts_the_deepest_is_found() {
    // The circle on the diameter between the first two fits to 0.39364 mm; a search from one start ends at 0.39631 mm.
    let places = [[1.0, 0.0], [-18688.0, 14342.0], [178.0, 1280.0], [1280.0, 0.0]];
    let repeated = std::iter::repeat_n([0.0, 0.0], 5);
    let contacts: Vec<_> =
        places.into_iter().chain(repeated).map(|place| contact(place.map(|at| at * 0.001))).collect();
    let found = evaluate(&contacts).unwrap().residuals;
    let rms = (found.iter().map(|residual| residual * residual).sum::<f64>() / 9.0).sqrt();
    assert!(rms <= 0.393_642_465, "{rms}");
}

#[test]
fn repeated_contacts_are_listed_but_not_by_the_thousand() {
    let angles = evenly(0.0, 90.0, 4).repeat(100);
    let said: Vec<_> =
        evaluate(&on_circle([0.0, 0.0], 10.0, &angles)).unwrap().warnings.iter().map(ToString::to_string).collect();
    assert_eq!(said[0], "contacts 1 and 5 coincide: this place counts twice");
    assert_eq!(said[5], "the same applies to 391 more");
    assert_eq!(said.len(), 6);
}

#[test]
fn as_many_repeated_contacts_as_are_listed_leave_no_more() {
    // Three at one place make two pairs, each of three others at the next place one.
    let said = |repeats: &[f64]| -> Vec<String> {
        let angles = [&evenly(0.0, 90.0, 4), repeats].concat();
        let found = evaluate(&on_circle([0.0, 0.0], 10.0, &angles)).unwrap();
        found
            .warnings
            .iter()
            .map(ToString::to_string)
            .filter(|said| said.contains("coincide") || said.contains("more"))
            .collect()
    };
    let five = said(&[0.0, 90.0, 180.0, 270.0, 270.0]);
    assert!(five.len() == 5 && five.iter().all(|said| said.contains("coincide")), "{five:?}");
    let six = said(&[0.0, 0.0, 90.0, 180.0, 270.0, 270.0]);
    assert_eq!(six.last().map(String::as_str), Some("the same applies to 1 more"), "{six:?}");
}

#[test]
fn the_direction_of_a_chord_is_above_minus_90_and_up_to_90_degrees() {
    for turn in [0.0, 30.0, 90.0, 100.0, 180.0, 200.0, 270.0, 300.0] {
        let found = evaluate(&on_circle([1.0, 2.0], 10.0, &[turn, turn + 90.0, turn + 180.0, turn + 270.0])).unwrap();
        let directions: Vec<f64> = found.two_point.iter().map(|size| size.direction_deg).collect();
        assert_eq!(directions.len(), 2);
        for (direction, along) in directions.into_iter().zip([turn, turn + 90.0]) {
            assert!(-90.0 < direction && direction <= 90.0, "{direction}");
            // The same line, whichever way it is walked.
            let off = (direction - along).rem_euclid(180.0);
            assert!(off.min(180.0 - off) < 1e-9, "{direction} for {along}");
        }
    }
}

#[test]
fn a_contact_lies_apart_only_among_six_beyond_a_micrometre_and_twice_as_far_as_the_next() {
    let apart = |count: u32, first: f64, second: f64| {
        let mut contacts = on_circle([0.0, 0.0], 10.0, &evenly(0.0, 360.0 / f64::from(count), count));
        contacts[0].x += first;
        let middle = contacts.len() / 2;
        contacts[middle].x -= second;
        let said: Vec<_> = evaluate(&contacts).unwrap().warnings.iter().map(ToString::to_string).collect();
        said.iter().any(|said| said.starts_with("contact 1 lies"))
    };
    assert!(apart(12, 0.1, 0.0), "alone");
    assert!(!apart(5, 0.1, 0.0), "among five any form is possible");
    assert!(!apart(12, 0.0009, 0.0), "below a micrometre");
    assert!(!apart(12, 0.1, 0.09), "the next one is nearly as far");
}

#[test]
fn one_contact_far_off_is_named() {
    let mut contacts = on_circle([0.0, 0.0], 10.0, &evenly(0.0, 30.0, 12));
    contacts[4].x *= 0.98;
    contacts[4].y *= 0.98;
    let said: Vec<_> = evaluate(&contacts).unwrap().warnings.iter().map(ToString::to_string).collect();
    assert!(said.iter().any(|said| said.starts_with("contact 5 lies 0.1")), "{said:?}");
}

#[test]
fn a_hundred_thousand_contacts_are_answered_without_the_pairwise_criteria() {
    let angles = evenly(0.0, 360.0 / 100_000.0, 100_000);
    let found = evaluate(&on_circle([100.0, -50.0], 25.0, &angles)).unwrap();
    assert!(error(&found.least_squares, [100.0, -50.0], 50.0) < 1e-9);
    assert!(error(&found.minimum_circumscribed, [100.0, -50.0], 50.0) < 1e-9);
    assert_eq!(found.maximum_inscribed, None);
    assert_eq!(found.minimum_zone, None);
    let said: Vec<_> = found.warnings.iter().map(ToString::to_string).collect();
    assert_eq!(said, ["maximum inscribed circle and minimum zone are not computed for 100000 contacts: at most 3000"]);
}

/// Checks one line of the table of factors.
#[track_caller]
fn check_factors(count: u32, step_deg: f64, [diameter, against, along, across]: [&str; 4]) {
    let points: Vec<_> = (0..count)
        .map(|k| (17.0 + f64::from(k) * step_deg).to_radians())
        .map(|angle| contact([3.0 + angle.cos(), 4.0 + angle.sin()]))
        .collect();
    let found = evaluate(&points).unwrap().uncertainty;
    for (value, printed) in [
        (found.diameter, diameter),
        (found.against_three_by_120(), against),
        (found.centre_along, along),
        (found.centre_across, across),
    ] {
        let decimals = printed.split_once('.').map_or(0, |(_, decimals)| decimals.len());
        assert_eq!(format!("{value:.decimals$}"), printed, "{count} x {step_deg}: {found:?}");
    }
}

#[test]
fn agrees_with_the_table_of_touches_and_steps() {
    check_factors(3, 120.0, ["1.155", "1.00", "0.816", "0.816"]);
    check_factors(3, 90.0, ["1.414", "1.22", "1.225", "0.707"]);
    check_factors(3, 75.0, ["2.032", "1.76", "1.652", "0.732"]);
    check_factors(3, 60.0, ["3.464", "3.00", "2.449", "0.816"]);
    // The table prints 4.181; the exact value, 4.18154, rounds to 4.182.
    check_factors(3, 45.0, ["6.828", "5.91", "4.182", "1.000"]);
    check_factors(3, 30.0, ["16.69", "14.5", "9.142", "1.414"]);
    check_factors(3, 20.0, ["39.0", "33.8", "20.31", "2.067"]);
    // The table prints 60.9; the exact value, 60.84996, rounds to 60.8.
    check_factors(3, 15.0, ["70.3", "60.8", "35.94", "2.732"]);
    check_factors(3, 10.0, ["159.6", "138", "80.62", "4.072"]);
    check_factors(4, 90.0, ["1.000", "0.87", "0.707", "0.707"]);
    check_factors(4, 60.0, ["1.414", "1.22", "1.155", "0.632"]);
    check_factors(4, 45.0, ["2.613", "2.26", "1.848", "0.707"]);
    check_factors(4, 30.0, ["6.541", "5.66", "3.864", "0.939"]);
    check_factors(4, 20.0, ["15.61", "13.5", "8.419", "1.336"]);
    check_factors(5, 72.0, ["0.894", "0.77", "0.632", "0.632"]);
    check_factors(6, 60.0, ["0.816", "0.71", "0.577", "0.577"]);
    check_factors(8, 45.0, ["0.707", "0.61", "0.500", "0.500"]);
    check_factors(8, 22.5, ["1.672", "1.45", "1.182", "0.500"]);
    check_factors(12, 30.0, ["0.577", "0.50", "0.408", "0.408"]);
}
