//! A simulated part with several features: each says what it says alone, the first on the way is met, and what cannot
//! be told is an error with the features' names.

use std::fmt::Write as _;
use std::sync::Arc;

use fitcheck::nc::machine::{self, Contacts, InMemory, Settings, Step};
use fitcheck::nc::program::Program;
use fitcheck::probing::simulated::{Machine, Part, Simulation};
use fitcheck::probing::{Contact, NoContact, Prober, Touch};
use fitcheck::words::Dialogue;
use proptest::prelude::*;

/// A shape as the table of a file with nothing else, and its keys.
const SHAPES: [(&str, &str); 12] = [
    ("bore", "centre = [3, -2]\ndiameter = 40.01"),
    ("bore", "centre = [0, 0]\ndiameter = 30\nlobes = { count = 3, amplitude = 0.02 }\nsurface_scatter = 0.001"),
    ("bore", "centre = [-5, 10]\ndiameter = 60\nplane = \"ZX\""),
    ("stud", "centre = [3, -2]\ndiameter = 20.01"),
    ("stud", "centre = [0, 0]\ndiameter = 20\novality = { count = 2, amplitude = 0.02, angle = 20 }"),
    ("slot", "centre = [1, 1]\nwidth = 30\nangle = 25"),
    ("ridge", "centre = [1, 1]\nwidth = 8\nangle = 90"),
    ("pocket", "centre = [1, 1]\nlengths = [50, 40]\nangle = 12"),
    ("boss", "centre = [1, 1]\nlengths = [25, 15]\nangle = 33"),
    ("face", "point = [10, 0, 0]\nnormal = [1, 0.2, 0.1]\nsurface_scatter = 0.001"),
    ("face", "point = [10, 0, 0]\nnormal = [1, 0, 0]\nwave = { amplitude = 0.05, length = 7, direction = [0, 1, 0] }"),
    ("point", "point = [10, 0, -5]\nnormal = [1, 0, 0.3]\nradius = 60\ndeviation = 0.02"),
];

/// Those whose walls stand upright.
const UPRIGHT: std::ops::Range<usize> = 3..9;

fn part(text: &str) -> Machine {
    Part::read(text).unwrap_or_else(|error| panic!("{error}")).machine().unwrap()
}

fn touch(from: [f64; 3], direction: [f64; 3]) -> Touch {
    Touch { from, direction, longest: 500.0 }
}

fn bits(contact: &Result<Contact, NoContact>) -> Option<[u64; 3]> {
    contact.as_ref().ok().map(|contact| contact.place().map(f64::to_bits))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    /// The same contacts, bit for bit, as a file with that shape and nothing else.
    #[test]
    fn a_feature_alone_says_what_its_shape_says_alone(
        shape in 0..SHAPES.len(), x in -60.0..60.0_f64, y in -60.0..60.0_f64, angle in 0.0..std::f64::consts::TAU,
        ball in prop_oneof![Just(0.0), 0.1..4.0_f64], seed in 1..1_000_u64,
    ) {
        let (kind, keys) = SHAPES[shape];
        let probe = format!("[probe]\nball_radius = {ball}\ntrigger_scatter = 0.0005\n");
        let mut single = Simulation::read(&format!("seed = {seed}\n[{kind}]\n{keys}\n{probe}")).unwrap().machine().unwrap();
        let mut alone = part(&format!("seed = {seed}\n{probe}[[feature]]\nkind = \"{kind}\"\n{keys}\n"));
        // Two contacts, so that the scatter goes on in the same way.
        for turn in [0.0, 2.0] {
            let (sin, cos) = f64::sin_cos(angle + turn);
            let touch = touch([x, y, -5.0], [cos, sin, 0.0]);
            let (expected, found) = (single.touch(&touch), alone.touch(&touch));
            prop_assert_eq!(bits(&found), bits(&expected), "{} {:?} {:?}", kind, found, expected);
        }
    }

    /// Two features far apart do not change each other's contacts.
    #[test]
    fn features_far_apart_do_not_influence_each_other(
        one in UPRIGHT, other in UPRIGHT, angle in 0.0..std::f64::consts::TAU, ball in 0.0..3.0_f64,
    ) {
        let keys = |shape: usize, apart: f64| {
            let (kind, keys) = SHAPES[shape];
            let length = if ["slot", "ridge"].contains(&kind) { "length = 60\n" } else { "" };
            let (head, tail) = keys.split_once("centre = [").unwrap();
            let (x, rest) = tail.split_once(',').unwrap();
            let x: f64 = x.parse().unwrap();
            format!("[[feature]]\nkind = \"{kind}\"\n{head}centre = [{},{rest}\n{length}", x + apart)
        };
        let probe = format!("[probe]\nball_radius = {ball}\n");
        let (alone, beside) = (keys(one, 0.0), keys(other, 1_000.0));
        let (mut alone, mut both) = (part(&format!("{probe}{alone}")), part(&format!("{probe}{alone}{beside}")));
        for distance in [0.0, 45.0] {
            let (sin, cos) = angle.sin_cos();
            // Outwards from the middle, inwards from outside.
            let sign = if distance <= 0.0 { 1.0 } else { -1.0 };
            let touch = Touch { longest: 100.0, ..touch([distance * cos, distance * sin, -5.0], [sign * cos, sign * sin, 0.0]) };
            prop_assert_eq!(alone.touch(&touch), both.touch(&touch));
        }
    }
}

/// A boss on a plate with a bore in it, a pocket with an island beside it, and the plate's top.
const PLATE: &str = "\
[[feature]]\nname = \"boss\"\nkind = \"boss\"\ncentre = [0, 0]\nlengths = [60, 60]\ntop = 10\n\
[[feature]]\nname = \"bore\"\nkind = \"bore\"\ncentre = [0, 0]\ndiameter = 30\ntop = 10\nbottom = -20\n\
[[feature]]\nname = \"pocket\"\nkind = \"pocket\"\ncentre = [200, 0]\nlengths = [100, 80]\nbottom = -12\n\
[[feature]]\nname = \"island\"\nkind = \"stud\"\ncentre = [200, 0]\ndiameter = 20\n\
[[feature]]\nname = \"top\"\nkind = \"face\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n\
[probe]\nball_radius = 3\n";

#[track_caller]
fn meets(text: &str, from: [f64; 3], direction: [f64; 3], expected: Result<[f64; 3], &str>) {
    let found = part(text).touch(&touch(from, direction));
    match (found, expected) {
        (Ok(contact), Ok(place)) => {
            let apart = contact.place().into_iter().zip(place).map(|(found, expected)| (found - expected).abs());
            assert!(apart.fold(0.0, f64::max) < 1e-9, "{contact:?} {place:?}");
        }
        (Err(error), Err(expected)) => assert_eq!(error.to_string(), expected),
        (found, expected) => panic!("{found:?} {expected:?}"),
    }
}

#[test]
fn the_first_surface_on_the_way_is_met_whichever_it_is() {
    // The bore from inside, the boss from outside, at the same height.
    meets(PLATE, [0.0, 0.0, 5.0], [1.0, 0.0, 0.0], Ok([12.0, 0.0, 5.0]));
    meets(PLATE, [50.0, 0.0, 5.0], [-1.0, 0.0, 0.0], Ok([33.0, 0.0, 5.0]));
    // From above: the top of the boss, the floor of the bore, the plate, the island in the pocket, the pocket's floor.
    meets(PLATE, [25.0, 0.0, 50.0], [0.0, 0.0, -1.0], Ok([25.0, 0.0, 13.0]));
    meets(PLATE, [1.0, 1.0, 50.0], [0.0, 0.0, -1.0], Ok([1.0, 1.0, -17.0]));
    meets(PLATE, [80.0, 0.0, 50.0], [0.0, 0.0, -1.0], Ok([80.0, 0.0, 3.0]));
    meets(PLATE, [200.0, 0.0, 50.0], [0.0, 0.0, -1.0], Ok([200.0, 0.0, 3.0]));
    meets(PLATE, [230.0, 20.0, 50.0], [0.0, 0.0, -1.0], Ok([230.0, 20.0, -9.0]));
    // In the pocket: its wall to one side, the island to the other.
    meets(PLATE, [230.0, 0.0, -5.0], [1.0, 0.0, 0.0], Ok([247.0, 0.0, -5.0]));
    meets(PLATE, [230.0, 0.0, -5.0], [-1.0, 0.0, 0.0], Ok([213.0, 0.0, -5.0]));
    // A shaft that nobody meant stands in the way.
    let other = "[[feature]]\nkind = \"stud\"\ncentre = [0, 0]\ndiameter = 10\n\
                 [[feature]]\nkind = \"stud\"\ncentre = [30, 0]\ndiameter = 10\n";
    meets(other, [80.0, 0.0, -1.0], [-1.0, 0.0, 0.0], Ok([35.0, 0.0, -1.0]));
    // Above the tops there is nothing.
    meets(other, [80.0, 0.0, 1.0], [-1.0, 0.0, 0.0], Err("contact 1: the probe met nothing on the probing path"));
    // A ball whose centre is 1.8 above the top meets its edge √(3² − 1.8²) = 2.4 away.
    let edge = format!("{other}[probe]\nball_radius = 3\n");
    meets(&edge, [80.0, 0.0, 1.8], [-1.0, 0.0, 0.0], Ok([37.4, 0.0, 1.8]));
    // A smaller bore that begins at the floor of a larger one.
    let stepped = "[[feature]]\nkind = \"bore\"\ncentre = [0, 0]\ndiameter = 40\nbottom = -5\n\
                   [[feature]]\nkind = \"bore\"\ncentre = [0, 0]\ndiameter = 20\ntop = -5\nbottom = -30\n\
                   [probe]\nball_radius = 3\n";
    meets(stepped, [0.0, 0.0, 20.0], [0.0, 0.0, -1.0], Ok([0.0, 0.0, -27.0]));
    meets(stepped, [14.0, 0.0, 20.0], [0.0, 0.0, -1.0], Ok([14.0, 0.0, -2.0]));
    meets(stepped, [0.0, 0.0, -1.5], [0.0, 1.0, 0.0], Ok([0.0, 17.0, -1.5]));
    meets(stepped, [0.0, 0.0, -9.0], [0.0, 1.0, 0.0], Ok([0.0, 7.0, -9.0]));
}

#[test]
fn a_face_at_a_floor_or_on_a_body_is_what_is_met_there() {
    let faces = format!(
        "[[feature]]\nname = \"floor\"\nkind = \"face\"\npoint = [230, 0, -12]\nnormal = [0, 0, 1]\nreach = 5\n\
         [[feature]]\nname = \"lid\"\nkind = \"face\"\npoint = [25, 0, 10]\nnormal = [0, 0, 1]\nreach = 4\n{PLATE}"
    );
    meets(&faces, [230.0, 0.0, 50.0], [0.0, 0.0, -1.0], Ok([230.0, 0.0, -9.0]));
    meets(&faces, [25.0, 0.0, 50.0], [0.0, 0.0, -1.0], Ok([25.0, 0.0, 13.0]));
    // The rim of a disc, a ball's side away from it.
    let disc =
        "[[feature]]\nkind = \"face\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\nreach = 5\n[probe]\nball_radius = 3\n";
    meets(disc, [6.8, 0.0, 50.0], [0.0, 0.0, -1.0], Ok([6.8, 0.0, 2.4]));
    meets(disc, [9.0, 0.0, 50.0], [0.0, 0.0, -1.0], Err("contact 1: the probe met nothing on the probing path"));
}

#[test]
fn what_cannot_be_told_is_an_error_with_the_names() {
    meets(
        PLATE,
        [22.0, 0.0, 5.0],
        [1.0, 0.0, 0.0],
        Err("contact 1: the probing path begins inside the material of boss"),
    );
    meets(
        PLATE,
        [13.0, 0.0, 5.0],
        [1.0, 0.0, 0.0],
        Err("contact 1: the probing path begins inside the material of bore"),
    );
    meets(
        PLATE,
        [120.0, 0.0, -5.0],
        [1.0, 0.0, 0.0],
        Err("contact 1: the probing path begins inside the material of top"),
    );
    let behind =
        "[[feature]]\nname = \"hole\"\nkind = \"bore\"\ncentre = [0, 0]\ndiameter = 30\n[probe]\nball_radius = 3\n";
    meets(
        behind,
        [50.0, 0.0, -5.0],
        [-1.0, 0.0, 0.0],
        Err(
            "contact 1: the ball reaches the wall of hole from behind, and the thickness of the material there is unknown",
        ),
    );
    // Two shafts side by side, met at once.
    let both = "[[feature]]\nkind = \"stud\"\ncentre = [0, 10]\ndiameter = 10\n\
                [[feature]]\nkind = \"stud\"\ncentre = [0, -10]\ndiameter = 10\n[probe]\nball_radius = 8\n";
    meets(
        both,
        [50.0, 0.0, -5.0],
        [-1.0, 0.0, 0.0],
        Err("contact 1: the ball meets F1 and F2 at the same place, so it is not known which one is measured"),
    );
    // A keyway: the bore is measured beside it, and where it is, its wall is not there.
    let keyway = "[[feature]]\nname = \"bore\"\nkind = \"bore\"\ncentre = [0, 0]\ndiameter = 30\n\
                  [[feature]]\nname = \"key\"\nkind = \"slot\"\ncentre = [0, 0]\nwidth = 10\nlength = 40\nangle = 90\n\
                  [probe]\nball_radius = 1\n";
    meets(keyway, [0.0, 0.0, -5.0], [0.0, 1.0, 0.0], Ok([0.0, 14.0, -5.0]));
    meets(keyway, [17.0, 0.0, -5.0], [0.0, 1.0, 0.0], Ok([17.0, 4.0, -5.0]));
}

#[test]
fn the_scatter_is_that_of_the_surface_that_is_met() {
    let text = "[[feature]]\nkind = \"stud\"\ncentre = [0, 0]\ndiameter = 10\nsurface_scatter = 0.1\n\
                [[feature]]\nkind = \"stud\"\ncentre = [50, 0]\ndiameter = 10\n";
    let mut machine = part(text);
    let rough = machine.touch(&touch([-20.0, 0.0, -1.0], [1.0, 0.0, 0.0])).unwrap();
    let smooth = machine.touch(&touch([20.0, 0.0, -1.0], [1.0, 0.0, 0.0])).unwrap();
    assert!(1e-6 < (rough.x + 5.0).abs(), "{rough:?}");
    assert!((smooth.x - 45.0).abs() < 1e-9, "{smooth:?}");
}

#[test]
fn a_part_is_written_and_read_back_the_same() {
    let mut text =
        String::from("seed = 9\ntemperature = 23.5\n[probe]\nball_radius = 2\nstylus_radius = 1\noffset = [0.01, 0]\n");
    for (number, (kind, keys)) in SHAPES.into_iter().enumerate() {
        let ends = match kind {
            "slot" => "length = 80\nbottom = -7\n",
            "face" => "reach = 12\n",
            "boss" => "top = 4\n",
            _ => "",
        };
        write!(text, "[[feature]]\nname = \"no {number}\"\nkind = \"{kind}\"\n{keys}\n{ends}").unwrap();
    }
    let part = Part::read(&text).unwrap();
    assert_eq!(part.features.len(), SHAPES.len());
    assert_eq!(Part::read(&part.write().unwrap()), Ok(part));
    // A file as before is a part with one feature, and written as before.
    let single = "seed = 1\ntemperature = 20.0\nexpansion = 11.5\n\n[bore]\ncentre = [0.0, 0.0]\ndiameter = 25.0\n";
    let part = Part::read(single).unwrap();
    assert_eq!((part.features[0].name.as_str(), part.write()), ("", Simulation::read(single).unwrap().write()));
    // A warm part grows as a whole.
    let warm =
        "temperature = 120\nexpansion = 10\n[[feature]]\nkind = \"stud\"\ncentre = [100, 0]\ndiameter = 10\ntop = 50\n";
    meets(warm, [80.0, 0.0, 50.04], [1.0, 0.0, 0.0], Ok([95.095, 0.0, 50.04]));
}

#[test]
fn bad_files_are_refused_with_feature_key_line_and_column() {
    let good = "[[feature]]\nname = \"A\"\nkind = \"bore\"\ncentre = [0, 0]\ndiameter = 25\n";
    for (text, expected) in [
        ("[[feature]]\nname = \"B\"\nkind = \"slot\"\ncentre = [0, 0]\n", "line 6, column 1: B: a slot needs width"),
        ("[[feature]]\nkind = \"bore\"\ncentre = [0, 0]\n  width = 3\n", "line 9, column 3: F2: a bore has no width"),
        (
            "[[feature]]\nkind = \"groove\"\n",
            "line 7, column 1: F2: groove is not a kind of feature: the kinds are bore, stud, face, point, slot, ridge, \
             pocket, boss",
        ),
        (
            "[[feature]]\nkind = \"bore\"\ncentre = [0, 0]\ndiameter = -1\n",
            "line 9, column 1: F2: diameter = -1: at least 0.001, at most 100000",
        ),
        (
            "[[feature]]\nkind = \"bore\"\ncentre = [0, 0]\ndiameter = 10\nbottom = 1\n",
            "line 10, column 1: F2: bottom = 1: at least -100000, at most -0.001",
        ),
        (
            "[[feature]]\nkind = \"ridge\"\ncentre = [0, 0]\nwidth = 10\nlength = nan\n",
            "line 10, column 1: F2: length of the walls = NaN: at least 0.001, at most 100000",
        ),
        (
            "[[feature]]\nname = \"A\"\nkind = \"stud\"\ncentre = [0, 0]\ndiameter = 2\n",
            "line 7, column 1: A: another feature has the same name",
        ),
        (
            "[[feature]]\nname = \"\"\nkind = \"stud\"\ncentre = [0, 0]\ndiameter = 2\n",
            "line 7, column 1: F2: a name has 1 to 40 characters on one line",
        ),
        ("[[feature]]\nkind = \"bore\"\ncentre = [0]\n", "line 8, column 10: F2: centre: expected 2 numbers, found 1"),
        ("[[feature]]\ncentre = [0, 0]\n", "line 6, column 1: F2: missing field `kind`"),
        ("[probe]\nball_radius = -1\n", "line 7: ball radius = -1: at least 0, at most 100"),
        ("[probe]\nstylus_radius = 101\n", "line 7: stylus radius = 101: at least 0, at most 100"),
    ] {
        assert_eq!(Part::read(&format!("{good}{text}")).unwrap_err().to_string(), expected, "{text}");
    }
    let mixed = Part::read(&format!("{good}[bore]\ncentre = [0, 0]\ndiameter = 2\n")).unwrap_err().to_string();
    assert!(mixed.starts_with("line 6: unknown field `bore`"), "{mixed}");
    let odd = Part::read(&format!("{good}colour = 1\n")).unwrap_err().to_string();
    assert!(odd.starts_with("line 6, column 1: A: unknown field `colour`"), "{odd}");
    assert_eq!(
        Simulation::read(good).unwrap_err().to_string(),
        "the file has [[feature]] tables: one workpiece with a single surface is expected here"
    );
    let many = Part::read(&good.replace("name = \"A\"\n", "").repeat(1_001)).unwrap_err().to_string();
    assert_eq!(many, "a part has at most 1000 features");
}

/// The remarks of a program on a part.
fn remarks(text: &str, blocks: &str) -> Vec<String> {
    let program = format!("BEGIN PGM a MM\n{blocks}\nEND PGM a MM\n");
    let program = Arc::new(Program::read(program.as_bytes()).unwrap().0);
    let settings = Settings::new(Dialogue::En, jiff::civil::date(2026, 3, 7).at(8, 5, 9, 0));
    let contacts = Contacts::Workpiece(Part::read(text).unwrap());
    let mut machine = machine::Machine::new("a.h", program, InMemory::new(), contacts, settings);
    while machine.run(1_000).unwrap() != Step::Ended {}
    machine.remarks().iter().map(|(place, remark)| format!("{} {remark}", place.block)).collect()
}

#[test]
fn moves_that_would_touch_are_told_once_for_a_block() {
    let up = "L X+80 Y+0 Z+50 R0 FMAX\n";
    // Free at clearance height, and down into the bore.
    assert_eq!(remarks(PLATE, &format!("{up}L X+0 R0 FMAX\nL Z-10\nL Z+50\n")), Vec::<String>::new());
    assert_eq!(
        remarks(PLATE, &format!("{up}L Z+8\nL X+0\n")),
        ["3 the ball would touch boss, with the centre of the ball at X 32.999999 Y 0 Z 8 mm"]
    );
    // Over the edge: √(3² − 2²) beside it.
    assert_eq!(
        remarks(PLATE, &format!("{up}L Z+12\nL X+0\n")),
        ["3 the ball would touch boss, with the centre of the ball at X 32.236067 Y 0 Z 12 mm"]
    );
    // From within the bore through its wall; in a loop, once for the block.
    let twice = "L X+0 Y+0 Z+50 FMAX\nLBL 1\nL Z+5\nL X+20\nL X+0\nL Z+50\nCALL LBL 1 REP 1\n";
    assert_eq!(
        remarks(PLATE, twice),
        [
            "4 the ball would touch bore, with the centre of the ball at X 12.000001 Y 0 Z 5 mm",
            "5 the ball would touch boss, with the centre of the ball at X 20 Y 0 Z 5 mm",
            "6 the ball would touch boss, with the centre of the ball at X 0 Y 0 Z 5 mm"
        ][..2]
    );
    // Into the plate.
    assert_eq!(
        remarks(PLATE, &format!("{up}L Z+2.9\n")),
        ["2 the ball would touch top, with the centre of the ball at X 80 Y 0 Z 2.999999 mm"]
    );
    // The stylus meets what hangs over the ball: a body that ends above it.
    let over = "[[feature]]\nname = \"bridge\"\nkind = \"boss\"\ncentre = [0, 0]\nlengths = [20, 20]\ntop = 30\nbottom = 20\n\
                [probe]\nball_radius = 3\nstylus_radius = 2\n";
    assert_eq!(
        remarks(over, "L X+80 Y+0 Z+0 FMAX\nL X+0\n"),
        ["2 the stylus would touch bridge, with the centre of the ball at X 11.999999 Y 0 Z 0 mm"]
    );
    // A face that looks down has no closed form for an endless stylus.
    let down = "[[feature]]\nname = \"below\"\nkind = \"face\"\npoint = [0, 0, 90]\nnormal = [0, 0, -1]\n";
    assert_eq!(remarks(down, up), Vec::<String>::new());
    assert_eq!(
        remarks(down, &format!("{up}L Z+40\nL Z+95\n")),
        [
            "2 moves are not checked in full against below",
            "3 the ball would touch below, with the centre of the ball at X 80 Y 0 Z 90.000001 mm"
        ]
    );
    // The simulated stylus stands in Z: with another tool axis it is not looked at, and that is said once.
    assert_eq!(
        remarks(over, "TOOL CALL 1 X\nL X+80 Y+0 Z+0 FMAX\nL X+0\nL X+80\n"),
        ["3 the stylus is not checked for collisions: it does not stand along Z"]
    );
    // A file as before says nothing about heights: nothing is looked at.
    assert_eq!(remarks("[stud]\ncentre = [0, 0]\ndiameter = 20\n", "L X+80 Y+0 Z+5\nL X+0\n"), Vec::<String>::new());
}

/// The step between sampled places of a surface, mm.
const STEP: f64 = 0.08;

fn steps(from: f64, to: f64) -> impl Iterator<Item = f64> + Clone {
    let count = ((to - from) / STEP).ceil().max(1.0);
    (0..=1_000).map(f64::from).take_while(move |step| *step <= count).map(move |step| from + (to - from) * step / count)
}

/// Places of the walls of a rectangle that are there: across the first axis, and across the second.
fn walls([half_1, half_2]: [f64; 2], has_ends: bool) -> Vec<[f64; 3]> {
    let mut places = Vec::new();
    for z in steps(-6.0, 0.0) {
        places.extend(steps(-half_2, half_2).flat_map(|y| [[half_1, y, z], [-half_1, y, z]]));
        if has_ends {
            places.extend(steps(-half_1, half_1).flat_map(|x| [[x, half_2, z], [x, -half_2, z]]));
        }
    }
    places
}

/// Places within a flat contour at a height.
fn flat(height: f64, reach: f64, is_within: impl Fn(f64, f64) -> bool) -> Vec<[f64; 3]> {
    let all = steps(-reach, reach).flat_map(|x| steps(-reach, reach).map(move |y| [x, y, height]));
    all.filter(|[x, y, _]| is_within(*x, *y)).collect()
}

/// Shapes with keys, sampled places of their surface, and how far a place is in their material.
type Sampled = (&'static str, Vec<[f64; 3]>, fn([f64; 3]) -> bool);

fn sampled() -> Vec<Sampled> {
    let round = || {
        let turns = steps(0.0, 8.0 * std::f64::consts::PI).map(|arc| arc / 4.0);
        steps(-6.0, 0.0)
            .flat_map(move |z| turns.clone().map(move |angle| [4.0 * angle.cos(), 4.0 * angle.sin(), z]))
            .collect::<Vec<_>>()
    };
    let in_circle = |x: f64, y: f64| x.hypot(y) <= 4.0;
    let cap = flat(0.0, 3.0, |x, y| x.hypot(y) <= 3.0)
        .into_iter()
        .map(|[x, y, _]| [x, y, (25.0 - x * x - y * y).sqrt() - 5.0]);
    vec![
        (
            "kind = \"stud\"\ncentre = [0, 0]\ndiameter = 8\nbottom = -6",
            [round(), flat(0.0, 4.0, in_circle), flat(-6.0, 4.0, in_circle)].concat(),
            |[x, y, z]| x.hypot(y) < 4.0 && -6.0 < z && z < 0.0,
        ),
        (
            "kind = \"bore\"\ncentre = [0, 0]\ndiameter = 8\nbottom = -6",
            [round(), flat(-6.0, 4.0, in_circle)].concat(),
            |_| false,
        ),
        (
            "kind = \"boss\"\ncentre = [0, 0]\nlengths = [6, 8]\nbottom = -6",
            [walls([3.0, 4.0], true), flat(0.0, 4.0, |x, _| x.abs() <= 3.0), flat(-6.0, 4.0, |x, _| x.abs() <= 3.0)]
                .concat(),
            |[x, y, z]| x.abs() < 3.0 && y.abs() < 4.0 && -6.0 < z && z < 0.0,
        ),
        (
            "kind = \"ridge\"\ncentre = [0, 0]\nwidth = 6\nlength = 8\nbottom = -6",
            [walls([3.0, 4.0], true), flat(0.0, 4.0, |x, _| x.abs() <= 3.0), flat(-6.0, 4.0, |x, _| x.abs() <= 3.0)]
                .concat(),
            |[x, y, z]| x.abs() < 3.0 && y.abs() < 4.0 && -6.0 < z && z < 0.0,
        ),
        (
            "kind = \"pocket\"\ncentre = [0, 0]\nlengths = [6, 8]\nbottom = -6",
            [walls([3.0, 4.0], true), flat(-6.0, 4.0, |x, _| x.abs() <= 3.0)].concat(),
            |_| false,
        ),
        (
            "kind = \"slot\"\ncentre = [0, 0]\nwidth = 6\nlength = 8\nbottom = -6",
            [walls([3.0, 4.0], false), flat(-6.0, 4.0, |x, _| x.abs() <= 3.0)].concat(),
            |_| false,
        ),
        ("kind = \"face\"\npoint = [0, 0, -2]\nnormal = [0, 0, 3]\nreach = 4", flat(-2.0, 4.0, in_circle), |_| false),
        ("kind = \"point\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\nradius = 5\nreach = 3", cap.collect(), |_| false),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// A ball, or a stylus, touches a shape where a place of its sampled surface is nearer than its radius.
    #[test]
    fn what_touches_a_shape_is_what_its_sampled_surface_says(
        x in -9.0..9.0_f64, y in -9.0..9.0_f64, z in -12.0..6.0_f64,
    ) {
        for (keys, places, is_material) in sampled() {
            let touches = |ball: f64, stylus: f64| {
                let machine = part(&format!("[probe]\nball_radius = {ball}\nstylus_radius = {stylus}\n[[feature]]\n{keys}\n"));
                machine.collision([x, y, z], [x, y, z], None).is_some()
            };
            if is_material([x, y, z]) {
                prop_assert!(touches(0.0, 0.0), "{} {:?}", keys, [x, y, z]);
                continue;
            }
            let nearest = |with_stylus: bool| {
                let gap = |[at_x, at_y, at_z]: &[f64; 3]| {
                    let below = if with_stylus { (z - at_z).max(0.0) } else { z - at_z };
                    (x - at_x).hypot(y - at_y).hypot(below)
                };
                places.iter().map(gap).fold(f64::INFINITY, f64::min)
            };
            let (ball, stylus) = (nearest(false), nearest(true));
            // No place of a surface is farther than two steps from a sampled one, also where a cap is steep.
            let (less, more) = (|gap: f64| (gap - 2.0 * STEP).max(0.0), |gap: f64| gap + 1e-5);
            prop_assert!(!touches(less(ball), 0.0) || stylus <= 2.0 * STEP || less(ball) <= 0.0, "{} {:?} {}", keys, [x, y, z], ball);
            prop_assert!(touches(more(ball), 0.0), "{} {:?} {}", keys, [x, y, z], ball);
            // The cap of a ball has no closed form for the stylus.
            if !keys.contains("radius") {
                prop_assert!(!touches(0.0, less(stylus)) || less(stylus) <= 0.0, "{} {:?} {}", keys, [x, y, z], stylus);
                prop_assert!(touches(0.0, more(stylus)), "{} {:?} {}", keys, [x, y, z], stylus);
            }
        }
    }
}

#[test]
fn an_arc_is_looked_at_all_the_way_round() {
    let text = "[[feature]]\nname = \"post\"\nkind = \"stud\"\ncentre = [0, 0]\ndiameter = 4\n\
                [[feature]]\nname = \"pin\"\nkind = \"stud\"\ncentre = [20, 20]\ndiameter = 4\n[probe]\nball_radius = 1\n";
    let machine = part(text);
    let radius = 20.0 * f64::sqrt(2.0);
    let told = |to: [f64; 2], about| {
        let found = machine.collision([radius, 0.0, -1.0], [to[0], to[1], -1.0], about);
        found.map(|found| found.feature)
    };
    let centre = Some([0.0, 0.0, -1.0]);
    // A quarter turn and half a turn meet the pin, the straight way across meets the post.
    assert_eq!(told([0.0, radius], centre).as_deref(), Some("pin"));
    assert_eq!(told([-radius, 0.0], centre).as_deref(), Some("pin"));
    assert_eq!(told([-radius, 0.0], None).as_deref(), Some("post"));
    // The other quarter is free, and so is the straight way beside both.
    assert_eq!(told([0.0, -radius], centre), None);
    assert_eq!(told([0.0, -radius], None), None);
}
