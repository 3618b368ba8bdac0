//! Files of contacts: ten layouts of contacts on a circle whose size and place were chosen, so that both are known. They carry no limits: a
//! file alone is not judged, and a callout judges it by the same value everywhere.

use std::fmt::Write as _;

use fitcheck::exchange::import;
use fitcheck::session::{CheckCommand, CheckField, Command, Field, Session};
use fitcheck::tolerance::Sources;
use fitcheck::words::Language;

use super::ways::{answers_of, program};
use crate::session_walk::now;

/// A file: how its rows are written, and what is right of it with 25 H7.
struct File {
    name: &'static str,
    /// The diameter, thousandths of a millimetre.
    diameter: i32,
    count: u16,
    head: &'static str,
    row: fn([f64; 3]) -> String,
    tail: &'static str,
    encode: fn(&str) -> Vec<u8>,
    right: &'static str,
}

fn utf_8(text: &str) -> Vec<u8> {
    text.as_bytes().to_vec()
}

fn utf_16(text: &str) -> Vec<u8> {
    [0xfeff].into_iter().chain(text.encode_utf16()).flat_map(u16::to_le_bytes).collect()
}

fn dos(text: &str) -> Vec<u8> {
    text.replace('\n', "\r\n").into_bytes()
}

/// A number with a decimal comma.
fn comma(number: f64) -> String {
    number.to_string().replace('.', ",")
}

const PLAIN: File = File {
    name: "plain.csv",
    diameter: 25_010,
    count: 4,
    head: "x,y\n",
    row: |[x, y, _]| format!("{x},{y}\n"),
    tail: "",
    encode: utf_8,
    right: "GOOD",
};

const FILES: [File; 10] = [
    PLAIN,
    File { name: "small.csv", diameter: 24_998, right: "REWORK", ..PLAIN },
    File { name: "large.csv", diameter: 25_022, right: "SCRAP", ..PLAIN },
    File {
        name: "comma.txt",
        count: 8,
        head: "Y;X;Z\n",
        row: |[x, y, z]| format!("{};{};{}\n", comma(y), comma(x), comma(z)),
        encode: dos,
        ..PLAIN
    },
    File {
        name: "units.csv",
        count: 5,
        head: "# bore 7\nX [mm];Y (mm);Z mm;remark\n",
        row: |[x, y, z]| format!("{x};{y};{z};ok\n"),
        ..PLAIN
    },
    File { name: "tabs.txt", count: 16, head: "", row: |[x, y, _]| format!("{x}\t{y}\n"), tail: "\n\n", ..PLAIN },
    File { name: "wide.csv", count: 12, encode: utf_16, right: "GOOD", ..PLAIN },
    File { name: "powers.csv", count: 6, row: |[x, y, _]| format!("{x:e},{y:+E}\n"), ..PLAIN },
    File {
        name: "nominal.csv",
        head: "x_nominal;y_nominal;x;y;temperature\n",
        row: |[x, y, _]| format!("0;0;{x};{y};20\n"),
        ..PLAIN
    },
    File {
        name: "quoted.csv",
        count: 360,
        head: "\"y\",\"x\"\n",
        row: |[x, y, _]| format!("\"{y}\",\"{x}\"\n"),
        ..PLAIN
    },
];

impl File {
    /// Contacts in equal steps about a centre that is not the zero.
    fn bytes(&self) -> Vec<u8> {
        let mut text = self.head.to_owned();
        for number in 0..self.count {
            let angle = (360.0 * f64::from(number) / f64::from(self.count) + 10.0).to_radians();
            let radius = f64::from(self.diameter) / 2_000.0;
            let place = [3.25 + radius * angle.cos(), -7.5 + radius * angle.sin(), -5.0];
            write!(text, "{}", (self.row)(place)).unwrap();
        }
        text.push_str(self.tail);
        (self.encode)(&text)
    }
}

#[test]
fn contacts_are_the_same_in_every_way() {
    let place = tempfile::tempdir().unwrap();
    let put = |name: &str, bytes: &[u8]| fitcheck::files::write(&place.path().join(name), bytes).unwrap();
    std::fs::create_dir(place.path().join("in")).unwrap();
    put("plan.toml", b"fitcheck_plan = 1\n[[feature]]\nname = \"H\"\nkind = \"hole\"\ncallout = \"25 H7\"\n");
    for file in &FILES {
        put(file.name, &file.bytes());
        put(&format!("in/{}", file.name), &file.bytes());
    }
    let (_, watched, _) =
        program(place.path(), &["watch", "in", "--until-idle", "2", "--format", "csv", "--journal", "w.sqlite"]);
    for file in &FILES {
        let name = file.name;
        // A file without limits says how many contacts it has, whoever reads it.
        let alone = format!("!not judged: {} contacts without a callout", file.count);
        let said = |out: &str| answers_of(name, out).into_iter().map(|said| said.verdict).collect::<Vec<_>>();
        let (code, out, _) = program(place.path(), &["import", name, "--format", "csv"]);
        assert_eq!((code, said(&out)), (1, vec![alone.clone()]), "import {name}");
        let (code, out, _) = program(place.path(), &["import", name, "--format", "csv", "--plan", "plan.toml"]);
        assert_eq!((code, said(&out)), (1, vec![alone.clone()]), "import --plan {name}");
        assert_eq!(said(&watched), [alone], "watch {name}");
        // Contacts make no feature of a plan.
        let (code, _, err) = program(place.path(), &["plan", "convert", name, "-o", "made.toml", "--force"]);
        assert!(code != 0 && err.contains(&format!("{name}: line 1")), "plan convert {name}: {code} {err}");
        // A callout judges them.
        let (code, out, err) = program(place.path(), &["check", "25 H7", "--contacts", name, "--format", "json"]);
        let json: serde_json::Value = serde_json::from_str(&out).unwrap_or_else(|_| panic!("check {name}: {err}"));
        let right = f64::from(file.diameter) / 1_000.0;
        assert_eq!(json["measured_mm"].as_f64(), Some(right), "check {name}: {out}");
        let expected = match file.right {
            "GOOD" => 0,
            "REWORK" => 10,
            _ => 11,
        };
        assert_eq!(code, expected, "check {name}");
        by_window(file);
    }
}

/// The check page judges a file by the callout on it.
fn by_window(file: &File) {
    let read = import(file.name, &file.bytes(), &Sources::default(), now());
    let mut session = Session::new(Language::default());
    session.apply(Field::from(CheckField::Callout).typed("25 H7".to_owned()), now());
    let result = Ok(Box::new(read));
    session.apply(Command::Check(CheckCommand::Imported { name: file.name.to_owned(), result }), now());
    let listed = session.history().listed();
    let found: Vec<(i64, &str)> = listed
        .page(0..listed.count())
        .into_iter()
        .map(|(_, record)| (record.measurement.diameter.nanometres(), record.verdict.status().word()))
        .collect();
    assert_eq!(found, [(i64::from(file.diameter) * 1_000, file.right)], "{} on the check page", file.name);
}
