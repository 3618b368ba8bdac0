//! Simulated workpieces: what a file may say about one, and where a probe makes contact with it.

use fitcheck::message::Say as _;
use fitcheck::probing::simulated::{Lobes, Machine, Probe, Surface, Walls, Workpiece};
use fitcheck::probing::{Contact, NoContact, Prober as _, Touch};
use fitcheck::tolerance::Feature;
use fitcheck::words::{Language, Words};

#[track_caller]
fn check(text: &str, expected: &str) {
    let said = match toml::from_str::<Workpiece>(text) {
        Ok(workpiece) => match Machine::new(workpiece, Probe::USUAL, 0) {
            Ok(_) => "fine".to_owned(),
            Err(error) => {
                // People read a true minus sign.
                assert_eq!(Words::new(Language::En).told(&error).replace('\u{2212}', "-"), error.to_string());
                assert_ne!(Words::new(Language::Nl).told(&error), error.message().id);
                error.to_string()
            }
        },
        Err(error) => error.message().to_owned(),
    };
    assert_eq!(said, expected);
}

#[test]
fn a_workpiece_file_is_read_and_checked() {
    let bore = |form: &str| format!("feature = 'hole'\ncentre = [0.0, 0.0]\ndiameter = 25.0\n{form}");
    check(&bore(""), "fine");
    check(&bore("[ovality]\ncount = 2\namplitude = 0.01\nangle = 45"), "fine");
    check(&bore("").replace("25.0", "-1.0"), "diameter = -1: at least 0.001, at most 100000");
    check(&bore("").replace("25.0", "nan"), "diameter = NaN: at least 0.001, at most 100000");
    check(&bore("").replace("[0.0", "[-inf"), "centre x = -inf: at least -100000, at most 100000");
    check(&bore("surface_scatter = 2.0"), "surface scatter = 2: at least 0, at most 1.25");
    check(&bore("[ovality]\ncount = 2\namplitude = 5.0"), "ovality = 5: at least 0, at most 1.25");
    check(&bore("[ovality]\ncount = 3\namplitude = 0.1"), "ovality count = 3: at least 2, at most 2");
    check(&bore("[lobes]\ncount = 0\namplitude = 0.1"), "lobes = 0: at least 2, at most 100");
    check(&bore("[lobes]\ncount = 101\namplitude = 0.1"), "lobes = 101: at least 2, at most 100");
    check(&bore("[lobes]\ncount = 3\namplitude = 0.1\nangle = 361.0"), "lobe angle = 361: at least -360, at most 360");
    check("feature = 'hole'\ncentre = [0.0, 0.0]", "missing field `diameter`");
    check(
        &bore("colour = 'red'"),
        "unknown field `colour`, expected one of `feature`, `centre`, `diameter`, `ovality`, `lobes`, `surface_scatter`",
    );
}

#[test]
fn a_touch_that_begins_in_the_material_or_passes_by_meets_nothing() {
    let touch = |x: f64, y: f64, along: f64| Touch { from: [x, y, 0.0], direction: [along, 0.0, 0.0], longest: 50.0 };
    let still = Probe::STILL;
    let of = |feature| Machine::new(Workpiece::round(feature, [0.0, 0.0], 20.0), still, 0).unwrap();
    let (missed, in_material) = (Err(NoContact::Missed { number: 1 }), Err(NoContact::InMaterial { number: 1 }));
    assert_eq!(of(Feature::Hole).touch(&touch(11.0, 0.0, 1.0)), in_material);
    assert_eq!(of(Feature::Shaft).touch(&touch(9.0, 0.0, -1.0)), in_material);
    assert_eq!(of(Feature::Shaft).touch(&touch(15.0, 10.5, -1.0)), missed);
    assert_eq!(of(Feature::Shaft).touch(&touch(15.0, 0.0, 1.0)), missed);
    let mut oval = Workpiece::round(Feature::Shaft, [0.0, 0.0], 20.0);
    oval.ovality = Lobes { count: 2, amplitude: 0.1, angle: 0.0 };
    let mut machine = Machine::new(oval, still, 0).unwrap();
    assert_eq!(machine.touch(&touch(15.0, 10.5, -1.0)), missed);
    assert_eq!(machine.touch(&touch(15.0, 0.0, 1.0)), Err(NoContact::Missed { number: 2 }));
    assert!((machine.touch(&touch(15.0, 0.0, -1.0)).unwrap().x - 10.1).abs() < 1e-12);
}

/// A perfect probe's contact with walls, however far away they are.
fn touched(
    walls: &Walls,
    [x, y]: [f64; 2],
    [along_x, along_y]: [f64; 2],
    ball_radius: f64,
) -> Result<Contact, NoContact> {
    let probe = Probe { ball_radius, ..Probe::STILL };
    let touch = Touch { from: [x, y, 0.0], direction: [along_x, along_y, 0.0], longest: f64::INFINITY };
    Machine::with(Surface::Walls(*walls), probe, 0).unwrap().touch(&touch)
}

#[track_caller]
fn check_walls(walls: &Walls, from: [f64; 2], direction: [f64; 2], ball_radius: f64, expected: Option<f64>) {
    let found = match touched(walls, from, direction, ball_radius) {
        Ok(contact) => Some((contact.x - from[0]) * direction[0] + (contact.y - from[1]) * direction[1]),
        Err(error) => {
            assert_eq!(error, NoContact::Missed { number: 1 });
            None
        }
    };
    let is_near = found.zip(expected).map_or(found == expected, |(found, expected)| (found - expected).abs() < 1e-12);
    assert!(is_near, "{found:?} for {expected:?}");
}

/// Whether a ball at this place is outside the material.
fn is_free(walls: &Walls, from: [f64; 2], ball_radius: f64) -> bool {
    touched(walls, from, [1.0, 0.0], ball_radius) != Err(NoContact::InMaterial { number: 1 })
}

#[test]
fn a_ball_meets_the_wall_ahead() {
    let slot = Walls::new(Feature::Hole, [50.0, 20.0], (10.0, None));
    check_walls(&slot, [48.0, 90.0], [1.0, 0.0], 2.0, Some(5.0));
    check_walls(&slot, [48.0, 90.0], [-1.0, 0.0], 2.0, Some(1.0));
    check_walls(&slot, [48.0, 90.0], [0.0, 1.0], 2.0, None);
    assert!(is_free(&slot, [47.0, 0.0], 2.0) && !is_free(&slot, [46.9, 0.0], 2.0));
    let ridge = Walls { feature: Feature::Shaft, angle: 90.0, ..slot };
    check_walls(&ridge, [0.0, 30.0], [0.0, -1.0], 2.0, Some(3.0));
    check_walls(&ridge, [0.0, 30.0], [0.0, 1.0], 2.0, None);
    check_walls(&ridge, [0.0, 30.0], [1.0, 0.0], 2.0, None);
    assert!(is_free(&ridge, [0.0, 27.0], 2.0) && !is_free(&ridge, [0.0, 26.9], 2.0));
    let pocket = Walls::new(Feature::Hole, [0.0, 0.0], (60.0, Some(40.0)));
    check_walls(&pocket, [1.0, 2.0], [0.0, -1.0], 3.0, Some(19.0));
    check_walls(&pocket, [1.0, 2.0], [1.0, 0.0], 3.0, Some(26.0));
    assert!(!is_free(&pocket, [0.0, 18.0], 3.0) && !is_free(&pocket, [28.0, 0.0], 3.0));
}

#[test]
fn a_ball_meets_the_edge_of_a_boss_on_its_side_or_passes_it() {
    let boss = Walls::new(Feature::Shaft, [0.0, 0.0], (60.0, Some(40.0)));
    check_walls(&boss, [50.0, 10.0], [-1.0, 0.0], 5.0, Some(15.0));
    // 3 above the edge, the ball is 4 beside it.
    check_walls(&boss, [50.0, 23.0], [-1.0, 0.0], 5.0, Some(16.0));
    check_walls(&boss, [50.0, 25.1], [-1.0, 0.0], 5.0, None);
    assert!(is_free(&boss, [34.0, 23.0], 5.0) && !is_free(&boss, [33.9, 22.9], 5.0));
    // Turned by 45 degrees the edge points along the axis.
    let turned = Walls { angle: 45.0, lengths: (20.0, Some(20.0)), ..boss };
    check_walls(&turned, [30.0, 14.2], [-1.0, 0.0], 0.0, None);
    check_walls(&turned, [30.0, 0.001], [-1.0, 0.0], 0.0, Some(30.0 - 200.0_f64.sqrt() + 0.001));
    let corners = turned.corners(1e3);
    assert!(corners.iter().any(|[x, y]| (x - 200.0_f64.sqrt()).abs() < 1e-12 && y.abs() < 1e-12), "{corners:?}");
}
