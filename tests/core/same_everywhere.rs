//! Twenty thousand calls answer with the same bytes on every system: standard output, standard error and exit code of each.
//!
//! `tests/data/same_everywhere.txt` has a hash for every hundred of them. `SAME=write cargo test --test core same_everywhere` records the
//! hashes again, where answers were meant to change; with `SAME=FOLDER` the answers themselves are written there, to be compared with those
//! of another system. A fifth of the hundreds is run by default, all of them with `SAME=all` and on every system before a release.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use clap::Parser as _;
use fitcheck::cli::{Cli, Io};
use fitcheck::journal::chain::Hash;
use fitcheck::tolerance::iso286;
use jiff::ToSpan as _;

/// How many calls have one hash.
const HUNDRED: usize = 100;

/// One call. `«here»` stands for the folder of its files.
struct Call {
    words: Vec<String>,
    /// Standard input, and the file `rows.csv`.
    input: String,
}

/// Numbers that look random and are the same everywhere: `SplitMix64`, by Steele, Lea and Flood, 2014.
struct Chance(u64);

impl Chance {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^ (mixed >> 31)
    }

    fn below(&mut self, count: usize) -> usize {
        usize::try_from(self.next() % u64::try_from(count).unwrap()).unwrap()
    }

    /// Whole numbers from one to another, both of them possible.
    fn between(&mut self, least: i64, most: i64) -> i64 {
        least + i64::try_from(self.below(usize::try_from(most - least).unwrap() + 1)).unwrap()
    }

    fn one<'a, T: ?Sized>(&mut self, of: &[&'a T]) -> &'a T {
        of[self.below(of.len())]
    }

    /// A share of a circle about zero, exact to 1/1000 of a turn's tangent: a point of the unit circle without sines.
    fn direction(&mut self) -> (f64, f64) {
        let tangent = f64::from(i32::try_from(self.between(-8_000, 8_000)).unwrap()) / 1_000.0;
        let below = 1.0 + tangent * tangent;
        ((1.0 - tangent * tangent) / below, 2.0 * tangent / below)
    }
}

/// Ten-thousandths of a millimetre as millimetres.
fn mm(ten_thousandths: i64) -> String {
    let sign = if ten_thousandths < 0 { "-" } else { "" };
    let all = ten_thousandths.unsigned_abs();
    format!("{sign}{}.{:04}", all / 10_000, all % 10_000)
}

const FORMATS: [&str; 3] = ["text", "csv", "json"];

fn class(chance: &mut Chance) -> String {
    let is_hole = chance.below(2) == 0;
    let feature = if is_hole { fitcheck::tolerance::Feature::Hole } else { fitcheck::tolerance::Feature::Shaft };
    let preferred: Vec<_> = iso286::preferred_classes(feature).collect();
    if chance.below(2) == 0 {
        return preferred[chance.below(preferred.len())].to_string();
    }
    let letters = [
        "A", "B", "C", "CD", "D", "E", "EF", "F", "FG", "G", "H", "JS", "J", "K", "M", "N", "P", "R", "S", "T", "U",
        "V", "X", "Y", "Z", "ZA", "ZB", "ZC",
    ];
    let letter = chance.one(&letters);
    let letter = if is_hole { letter.to_owned() } else { letter.to_lowercase() };
    format!(
        "{letter}{}",
        chance.one(&["01", "0", "1", "2", "3", "4", "5", "6", "7", "8", "9", "10", "11", "12", "14", "16", "18"])
    )
}

fn size(chance: &mut Chance) -> i64 {
    let most = chance.one(&[&30_000, &300_000, &1_200_000, &5_000_000, &31_500_000]);
    let size = chance.between(1, *most);
    // As a drawing has it, and as nobody writes it.
    if chance.below(3) == 0 { size } else { (size / 5_000 + 1) * 5_000 }
}

fn limits(chance: &mut Chance) -> Call {
    let callout = format!("{} {}", mm(size(chance)), class(chance));
    let mut words = vec!["limits".to_owned(), callout, "--format".to_owned(), chance.one(&FORMATS).to_owned()];
    words.extend(
        chance
            .one::<[&str]>(&[&[], &[], &["--edition", "1988"], &["--js-rounded"], &["--source", "control"]])
            .iter()
            .map(|&word| word.to_owned()),
    );
    Call { words, input: String::new() }
}

fn rule(chance: &mut Chance) -> Vec<String> {
    let u = format!("{}.{}", chance.below(4), chance.below(10));
    let rules: [&[&str]; 5] = [
        &[],
        &[],
        &["--rule", "iso14253-2017", "--u"],
        &["--rule", "iso14253-1998", "--expanded"],
        &["--rule", "ilac-g8", "--expanded"],
    ];
    let chosen = chance.one(&rules);
    chosen.iter().map(|&word| word.to_owned()).chain((!chosen.is_empty()).then_some(u)).collect()
}

fn check(chance: &mut Chance) -> Call {
    let size = size(chance);
    let measured = (size + chance.between(-600, 600)).max(1);
    let mut words =
        vec!["check".to_owned(), format!("{} {}", mm(size), class(chance)), "--measured".to_owned(), mm(measured)];
    words.extend(["--format".to_owned(), chance.one(&FORMATS).to_owned()]);
    words.extend(rule(chance));
    Call { words, input: String::new() }
}

fn simulated(chance: &mut Chance) -> Call {
    let callout =
        format!("{} {}", mm(size(chance).max(20_000)), chance.one(&["H7", "h6", "G7", "k6", "P7", "s6", "js5", "F8"]));
    let mut words = vec![
        "check".to_owned(),
        callout,
        "--simulate".to_owned(),
        "--seed".to_owned(),
        chance.below(1_000_000).to_string(),
    ];
    words.extend(["--format".to_owned(), chance.one(&["json", "csv"]).to_owned()]);
    words.extend(rule(chance));
    Call { words, input: String::new() }
}

fn decision(chance: &mut Chance) -> Call {
    let lower = size(chance);
    let upper = lower + chance.between(20, 900);
    let mut words: Vec<String> = ["decide", "--lower", &mm(lower), "--upper", &mm(upper)].map(str::to_owned).into();
    words.extend(["--u".to_owned(), format!("{}.{}", chance.below(6), 1 + chance.below(9))]);
    match chance.below(4) {
        0 => words.extend([
            "--measured".to_owned(),
            mm(chance.between(lower - 50, upper + 50)),
            "--rule".to_owned(),
            "ilac-g8".to_owned(),
        ]),
        1 => words.extend([
            "--consumer-risk".to_owned(),
            format!("0.0{:02}", 1 + chance.below(99)),
            "--process-mean".to_owned(),
            mm(i64::midpoint(lower, upper)),
            "--process-sd".to_owned(),
            format!("{}.5", 1 + chance.below(9)),
        ]),
        2 => words.extend([
            "--process-mean".to_owned(),
            mm(chance.between(lower, upper)),
            "--process-sd".to_owned(),
            format!("{}.5", 1 + chance.below(9)),
        ]),
        _ => words.extend(["--gamma".to_owned(), format!("{},0.{}", 1 + chance.below(6), 1 + chance.below(9))]),
    }
    words.extend(["--format".to_owned(), "json".to_owned()]);
    Call { words, input: String::new() }
}

fn circle(chance: &mut Chance) -> Call {
    // Ten-thousandths of a millimetre.
    let number = |chance: &mut Chance, least, most| f64::from(i32::try_from(chance.between(least, most)).unwrap());
    let radius = number(chance, 10_000, 2_000_000);
    let (x, y) = (number(chance, -900_000, 900_000), number(chance, -900_000, 900_000));
    let mut input = "x,y\n".to_owned();
    for _ in 0..3 + chance.below(10) {
        let (cosine, sine) = chance.direction();
        let radius = radius + number(chance, -60, 60);
        writeln!(input, "{:.4},{:.4}", (x + radius * cosine) / 10_000.0, (y + radius * sine) / 10_000.0).unwrap();
    }
    Call { words: ["circle", "-", "--format", chance.one(&FORMATS)].map(str::to_owned).into(), input }
}

/// Workpieces with every kind of error of form and of probing: about 25 mm, at 50, 50.
const WORKPIECES: [&str; 6] = [
    "[bore]\ncentre = [50.13, 49.93]\ndiameter = 25.0123\nsurface_scatter = 0.002\n",
    "[bore]\ncentre = [50, 50]\ndiameter = 25.01\nlobes = { count = 3, amplitude = 0.004, angle = 11 }\n[probe]\nball_radius = 2\ntrigger_scatter = 0.001\n",
    "[bore]\ncentre = [50.01, 50.02]\ndiameter = 25.02\novality = { amplitude = 0.003, angle = 30, count = 2 }\n[probe]\nball_radius = 1.5\nlobing = { count = 3, amplitude = 0.002, angle = 7 }\n",
    "[pocket]\ncentre = [50.05, 50.02]\nlengths = [60.011, 25.008]\nangle = 0.3\nsurface_scatter = 0.001\n",
    "[slot]\ncentre = [50.02, 40]\nwidth = 25.006\nangle = 0.7\nsurface_scatter = 0.0015\n",
    "[face]\npoint = [50.004, 50, 0]\nnormal = [-1, 0.02, 0.01]\nsurface_scatter = 0.001\nwave = { amplitude = 0.003, length = 8, direction = [0, 1, 0] }\n",
];

fn workpiece(number: usize) -> [String; 2] {
    ["--workpiece".to_owned(), format!("«here»/workpiece{number}.toml")]
}

fn cycle(chance: &mut Chance) -> Call {
    let (number, code, limits) = match chance.below(WORKPIECES.len()) {
        3 => (3, "423", "Q273=50 Q274=50 Q282=60 Q283=25 Q284=60.02 Q285=60 Q286=25.021 Q287=25"),
        4 => (4, "425", "Q328=50 Q329=50 Q272=1 Q311=25 Q288=25.021 Q289=25"),
        5 => (5, "427", "Q263=45 Q264=50 Q272=1 Q267=1 Q288=50.01 Q289=49.99"),
        bore => (bore, "421", "Q273=50 Q274=50 Q262=25 Q275=25.021 Q276=25"),
    };
    let mut words: Vec<String> =
        ["cycle", code, "--set"].into_iter().chain(limits.split(' ')).map(str::to_owned).collect();
    words.push(format!("Q261={}", mm(chance.between(-100_000, -20_000))));
    if code == "421" {
        words.extend([
            format!("Q325={}", mm(chance.between(0, 900_000))),
            format!("Q247={}", mm(chance.between(300_000, 900_000))),
        ]);
    }
    words.extend(workpiece(number));
    words.extend([
        "--seed".to_owned(),
        chance.below(1_000_000).to_string(),
        "--time".to_owned(),
        "2026-01-02T03:04".to_owned(),
    ]);
    words.extend(["--format", chance.one(&["json", "text"])].map(str::to_owned));
    words.extend((chance.below(4) == 0).then(|| "--path".to_owned()));
    Call { words, input: String::new() }
}

fn program(chance: &mut Chance) -> Call {
    let class = chance.one(&["H7", "G7", "K7", "N7", "P7", "F8"]);
    let mut words: Vec<String> = ["run", "8255_nl.h", "--set", "Q1=25", "Q11=50", "Q21=50"].map(str::to_owned).into();
    words.push(format!("QS1={class}"));
    words.extend(workpiece(chance.below(3)));
    words.extend(["--seed".to_owned(), chance.below(1_000_000).to_string(), "--format".to_owned(), "json".to_owned()]);
    Call { words, input: String::new() }
}

fn fit(chance: &mut Chance) -> Call {
    let size = size(chance);
    let hole = chance.one(&["H7", "H8", "G7", "K7", "N7", "P7", "F8", "E9"]);
    let shaft = chance.one(&["h6", "g6", "k6", "n6", "p6", "s6", "f7", "e8", "u6"]);
    let mut words = vec!["fit".to_owned(), format!("{} {hole}/{shaft}", mm(size))];
    match chance.below(3) {
        0 => words.extend(
            [
                "--hole-material",
                "brass",
                "--shaft-material",
                "steel",
                "--temperature",
                chance.one(&["80", "-40", "23.5", "120"]),
            ]
            .map(str::to_owned),
        ),
        1 => words.extend(["--press", "--length", "30", "--hub-outer", &mm(size * 2)].map(str::to_owned)),
        _ => words
            .extend(["--hole", &mm(size + 50), "--shaft", &mm(size + chance.between(-200, 200))].map(str::to_owned)),
    }
    words.extend(["--format".to_owned(), chance.one(&FORMATS).to_owned()]);
    Call { words, input: String::new() }
}

fn statistics(chance: &mut Chance) -> Call {
    let mut input = "feature;callout;measured;time\n".to_owned();
    let drift = chance.between(0, 3);
    let count = chance.between(8, 130);
    for part in 0..count {
        // The sum of several is nearly normal.
        let scatter: i64 = (0..6).map(|_| chance.between(-12, 12)).sum();
        let value = 250_105 + scatter + part * drift / 4;
        let (hour, minute) = (6 + part / 60, part % 60);
        writeln!(input, "bore;25 H7;{};2026-01-02T{hour:02}:{minute:02}", mm(value)).unwrap();
    }
    let mut words = vec![
        "stats".to_owned(),
        "«here»/rows.csv".to_owned(),
        "--format".to_owned(),
        chance.one(&["json", "csv", "text"]).to_owned(),
    ];
    let more: [&[&str]; 8] = [
        &[],
        &["--chart", "ewma"],
        &["--chart", "cusum"],
        &["--law", "weibull"],
        &["--law", "lognormal"],
        &["--law", "folded-normal"],
        &["--rules", "western-electric", "--level", "0.99"],
        &["--group", "4"],
    ];
    words.extend(chance.one(&more).iter().map(|&word| word.to_owned()));
    Call { words, input }
}

fn report(chance: &mut Chance) -> Call {
    // A PDF takes longer than all others.
    let formats = [
        "html", "csv", "json", "markdown", "dfq", "qif", "xlsx", "html", "csv", "json", "markdown", "dfq", "qif",
        "pdf", "png",
    ];
    let mut words: Vec<String> =
        ["report", "-o", "-", "--time", "2026-01-02T03:04", "--format", chance.one(&formats)].map(str::to_owned).into();
    for number in 0..=chance.below(5) {
        let size = size(chance);
        let measured = (size + chance.between(-300, 300)).max(1);
        words.extend([
            "--check".to_owned(),
            format!("Bore {number}: {} {}={}", mm(size), chance.one(&["H7", "h6", "K7", "s6"]), mm(measured)),
        ]);
    }
    words.extend(["--language".to_owned(), chance.one(&["cs", "de", "en", "es", "fr", "it", "nl", "pl"]).to_owned()]);
    words.extend(rule(chance));
    Call { words, input: String::new() }
}

/// A plan's values on its picture, whose circles become curves.
fn plan(chance: &mut Chance) -> Call {
    let mut input = "id;measured\n".to_owned();
    for (name, size) in [("BORE", 250_000), ("HOLE_1", 80_000), ("HOLE_4", 80_000), ("PIN", 119_900)] {
        writeln!(input, "{name};{}", mm(size + chance.between(-100, 300))).unwrap();
    }
    let words =
        ["report", "--plan", "assets/samples/sample_plate.toml", "«here»/rows.csv", "-o", "-", "--format", "pdf"];
    let mut words: Vec<String> = words.map(str::to_owned).into();
    words.extend(
        ["--time", "2026-01-02T03:04", "--template", chance.one(&["sheet", "certificate", "list"])].map(str::to_owned),
    );
    Call { words, input }
}

/// How each kind of call is made, and how many there are of it.
type Kind = (&'static str, usize, fn(&mut Chance) -> Call);

const KINDS: [Kind; 11] = [
    ("limits", 5_000, limits),
    ("check", 5_000, check),
    ("simulated", 2_000, simulated),
    ("decision", 1_500, decision),
    ("circle", 2_500, circle),
    ("cycle", 2_000, cycle),
    ("program", 400, program),
    ("fit", 1_000, fit),
    ("statistics", 500, statistics),
    ("report", 300, report),
    ("plan", 100, plan),
];

/// The calls of a hundred: each begins with its own numbers.
fn calls((name, _, make): Kind, hundred: usize) -> Vec<Call> {
    let seed =
        name.bytes().fold(u64::try_from(hundred).unwrap(), |seed, byte| seed.wrapping_mul(1_000_003) ^ u64::from(byte));
    let mut chance = Chance(seed);
    (0..HUNDRED).map(|_| make(&mut chance)).collect()
}

/// What is said, with the exit code before it. What differs from call to call has a name: the folder, and the time now.
fn answer(call: &Call, here: &Path) -> Vec<u8> {
    let here = here.display().to_string();
    let words: Vec<String> = call.words.iter().map(|word| word.replace("«here»", &here)).collect();
    if words.iter().any(|word| word.ends_with("rows.csv")) {
        fitcheck::files::write(&Path::new(&here).join("rows.csv"), call.input.as_bytes()).unwrap();
    }
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let begin = fitcheck::files::now();
    let code = match Cli::try_parse_from(std::iter::once("fitcheck").chain(words.iter().map(String::as_str))) {
        Ok(cli) => cli.run(&mut Io::new(&mut call.input.as_bytes(), &mut out, &mut err)),
        Err(error) => panic!("{:?}: {error}", call.words),
    };
    let plain = |bytes: Vec<u8>| {
        let mut text = String::from_utf8(bytes)?.replace(&here, "«here»");
        let mut time = begin.clone();
        // Up to the second that has begun since.
        while time <= fitcheck::files::now().saturating_add(1.seconds()) {
            text = text.replace(&time.strftime("%Y-%m-%dT%H:%M:%S").to_string(), "«now»");
            time = time.saturating_add(1.seconds());
        }
        Ok::<_, std::string::FromUtf8Error>(text.into_bytes())
    };
    let out = plain(out).unwrap_or_else(std::string::FromUtf8Error::into_bytes);
    [format!("= {code}\n").into_bytes(), out, plain(err).unwrap()].concat()
}

fn file() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/same_everywhere.txt")
}

#[test]
fn twenty_thousand_calls_give_the_same_bytes_on_every_system() {
    let asked = std::env::var("SAME").unwrap_or_default();
    let folder = Some(Path::new(&asked)).filter(|_| !matches!(asked.as_str(), "" | "all" | "write"));
    let all: Vec<(Kind, usize)> =
        KINDS.iter().flat_map(|&kind| (0..kind.1 / HUNDRED).map(move |hundred| (kind, hundred))).collect();
    assert!(20_000 <= all.len() * HUNDRED);
    let chosen: Vec<&(Kind, usize)> =
        all.iter().enumerate().filter(|(at, _)| !asked.is_empty() || at % 5 == 0).map(|(_, one)| one).collect();
    let hashed = |&(kind, hundred): &(Kind, usize), here: &Path| {
        let mut all = Vec::new();
        for (number, call) in calls(kind, hundred).iter().enumerate() {
            let answer = answer(call, here);
            if let Some(folder) = folder {
                let words = call.words.join(" ");
                let name = format!("{}-{hundred:02}-{number:02}.txt", kind.0);
                fitcheck::files::write(&folder.join(name), &[words.as_bytes(), b"\n", &answer].concat()).unwrap();
            }
            all.extend(answer);
        }
        let hash = Hash::of_file(&all).to_string();
        format!("{} {hundred} {hash}", kind.0)
    };
    let next = AtomicUsize::new(0);
    let work = || {
        let here = tempfile::tempdir().unwrap();
        for (number, text) in WORKPIECES.iter().enumerate() {
            fitcheck::files::write(&here.path().join(format!("workpiece{number}.toml")), text.as_bytes()).unwrap();
        }
        let mut done = Vec::new();
        while let Some(one) = chosen.get(next.fetch_add(1, Ordering::Relaxed)) {
            done.push(hashed(one, here.path()));
        }
        done
    };
    let threads = std::thread::available_parallelism().map_or(2, usize::from);
    let lines: Vec<String> = std::thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        workers.into_iter().flat_map(|worker| worker.join().unwrap()).collect()
    });
    if asked == "write" {
        let mut lines = lines;
        let order = |line: &String| {
            all.iter().position(|((name, ..), hundred)| line.starts_with(&format!("{name} {hundred} ")))
        };
        lines.sort_by_key(order);
        fitcheck::files::write(&file(), (lines.join("\n") + "\n").as_bytes()).unwrap();
        return;
    }
    let recorded = std::fs::read_to_string(file()).unwrap();
    let recorded: Vec<&str> = recorded.lines().collect();
    let differ: Vec<&String> = lines.iter().filter(|line| !recorded.contains(&line.as_str())).collect();
    assert!(differ.is_empty(), "{} of {} hundreds differ: {differ:?}", differ.len(), lines.len());
}
