//! A file and the table of what is right of it.

use std::fmt::Write as _;
use std::path::Path;

use fitcheck::control::mask::Mask;
use fitcheck::exchange::ImportInputs;
use fitcheck::length::Length;
use fitcheck::tolerance::Sources;

use crate::session_walk::now;

const FOLDER: &str = "tests/data/field";

/// A file, and what is right of it.
pub(crate) struct Case {
    pub(crate) name: String,
    pub(crate) bytes: Vec<u8>,
    /// The exit code of `import`.
    pub(crate) code: i32,
    /// The mask that printed it.
    pub(crate) mask: Option<(String, String)>,
    /// How many of its values are of the part that is being measured, where that is not all of them.
    pub(crate) walked: Option<usize>,
    /// How many of its rows a watched folder takes, where the last one may not be complete.
    pub(crate) watched: Option<usize>,
    pub(crate) rows: Vec<Row>,
}

/// A value: `name | measured | limits | verdict | callout of its feature | verdict by that`. The table stands below `----` and `|`. A verdict that begins with `!` is the reason
/// why there is none; a callout in brackets is what a plan says that was not made of the file.
pub(crate) struct Row {
    pub(crate) name: String,
    pub(crate) measured: Option<Length>,
    pub(crate) limits: Option<(Length, Length)>,
    pub(crate) verdict: String,
    pub(crate) callout: String,
    pub(crate) by_plan: String,
}

/// A value as a way says it: its name, the figure, the limits and the verdict, or the reason why there is none.
#[derive(Debug, PartialEq)]
pub(crate) struct Said {
    pub(crate) name: String,
    pub(crate) measured: Option<Length>,
    pub(crate) limits: Option<(Length, Length)>,
    pub(crate) verdict: String,
}

pub(crate) fn length(text: &str) -> Option<Length> {
    let text = text.trim();
    (!text.is_empty() && text != "-").then(|| text.parse().unwrap_or_else(|_| panic!("{text}")))
}

impl Row {
    pub(crate) fn of(line: &str) -> Self {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let [name, measured, limits, verdict, callout, by_plan] = cells[..] else { panic!("{line}") };
        let limits = limits.split_once('…').map(|(from, to)| (length(from).unwrap(), length(to).unwrap()));
        let name = if name == "-" { String::new() } else { name.to_owned() };
        let [verdict, callout, by_plan] = [verdict, callout, by_plan].map(str::to_owned);
        Self { name, measured: length(measured), limits, verdict, callout, by_plan }
    }

    pub(crate) fn is_judged(&self) -> bool {
        !self.verdict.starts_with('!')
    }

    /// Whether a way says what is right; names and figures of rows that cannot be read are theirs.
    pub(crate) fn is_said_by(&self, said: &Said) -> bool {
        if let Some(words) = self.verdict.strip_prefix('!') {
            return said.verdict.starts_with('!') && said.verdict.contains(words.trim());
        }
        let own = (&self.name, self.measured, self.limits, &self.verdict);
        own == (&said.name, said.measured, said.limits, &said.verdict)
    }

    /// The callout, what it is of, and whether a plan that is made of the file has it.
    pub(crate) fn planned(&self) -> Option<(String, &str, bool)> {
        let bare = self.callout.trim_start_matches('(').trim_end_matches(')');
        let is_made = bare.len() == self.callout.len();
        let words = [" hole", " shaft", " length", " form"];
        let word = words.into_iter().find(|word| bare.ends_with(word)).unwrap_or("");
        (bare != "-").then(|| (bare.trim_end_matches(word).to_owned(), word.trim(), is_made))
    }
}

/// The files of a format.
pub(crate) fn cases(format: &str) -> Vec<Case> {
    let text = std::fs::read_to_string(Path::new(FOLDER).join(format!("{format}.txt"))).unwrap();
    let mut found: Vec<Case> = Vec::new();
    let mut masks: Vec<(String, String)> = Vec::new();
    let mut bases: Vec<(String, String)> = Vec::new();
    for section in text.split("==== ").skip(1) {
        let (head, rest) = section.split_once('\n').unwrap();
        let mut words = head.split(' ').filter(|word| !word.is_empty());
        let name = words.next().unwrap().to_owned();
        let flags: Vec<&str> = words.collect();
        if flags == ["mask"] {
            masks.push((name, rest.to_owned()));
            continue;
        }
        if flags == ["base"] {
            bases.push((name, rest.to_owned()));
            continue;
        }
        let (body, table) = rest.split_once("----\n|\n").unwrap_or_else(|| panic!("{name}"));
        let mask = masks.iter().find(|(mask, _)| flags.contains(&format!("by={mask}").as_str())).cloned();
        let number = |key: &str| flags.iter().find_map(|flag| flag.strip_prefix(key)?.parse::<i32>().ok());
        let body = match flags.iter().find_map(|flag| flag.strip_prefix("from=")) {
            None => body.to_owned(),
            Some(base) => {
                let known = bases.iter().find(|(known, _)| known == base).map(|(_, text)| text.clone());
                replaced(known.unwrap_or_else(|| std::fs::read_to_string(base).unwrap()), body)
            }
        };
        found.push(Case {
            bytes: bytes(&body, &flags),
            watched: number("watch=").map(|count| usize::try_from(count).unwrap()),
            code: number("exit=").unwrap_or(0),
            walked: number("walk=").map(|count| usize::try_from(count).unwrap()),
            rows: table.lines().filter(|line| !line.trim().is_empty()).map(Row::of).collect(),
            name,
            mask,
        });
    }
    found
}

/// A text with `this => that` of each line.
pub(crate) fn replaced(mut text: String, lines: &str) -> String {
    for line in lines.lines().filter(|line| !line.is_empty()) {
        let (from, to) = line.split_once(" =>").unwrap_or_else(|| panic!("{line}"));
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to.trim_start_matches(' '));
    }
    text
}

/// The bytes of a file whose text is this; `{DC4}` and `{SI}` are the characters that AQDEF has between values.
pub(crate) fn bytes(body: &str, flags: &[&str]) -> Vec<u8> {
    let mut text = body.replace("{DC4}", "\u{14}").replace("{SI}", "\u{0f}");
    if flags.contains(&"tabs") {
        text = text.replace(';', "\t");
    }
    if flags.contains(&"open") {
        text.pop();
    }
    if flags.contains(&"crlf") {
        text = text.replace('\n', "\r\n");
    }
    if flags.contains(&"workbook") {
        let rows: Vec<Vec<&str>> = text.lines().map(|line| line.split(';').collect()).collect();
        let rows: Vec<&[&str]> = rows.iter().map(Vec::as_slice).collect();
        return crate::xlsx::workbook(&rows);
    }
    if flags.contains(&"utf16") {
        return std::iter::once(0xfeff).chain(text.encode_utf16()).flat_map(u16::to_le_bytes).collect();
    }
    if flags.contains(&"cp1252") {
        return text.chars().map(|c| u8::try_from(u32::from(c)).unwrap()).collect();
    }
    if flags.contains(&"bom") {
        text.insert(0, '\u{feff}');
    }
    text.into_bytes()
}

impl Case {
    /// What differs between what is right and what a way says, line by line.
    #[track_caller]
    pub(crate) fn check(&self, way: &str, expected: &[&Row], said: &[Said], faults: &mut Vec<String>) {
        let is_right =
            expected.len() == said.len() && expected.iter().zip(said).all(|(row, said)| row.is_said_by(said));
        if !is_right {
            let right =
                |row: &&Row| format!("  right: {} {:?} {:?} {}", row.name, row.measured, row.limits, row.verdict);
            let is =
                |said: &Said| format!("  said:  {} {:?} {:?} {}", said.name, said.measured, said.limits, said.verdict);
            let lines: Vec<String> = expected.iter().map(right).chain(said.iter().map(is)).collect();
            faults.push(format!("{} by {way}:\n{}", self.name, lines.join("\n")));
        }
    }

    /// What the values are by the plan: a verdict, or none.
    pub(crate) fn rows_by_plan(&self) -> Vec<Row> {
        let row = |row: &Row| {
            let is_judged = row.by_plan != "-";
            let verdict = if is_judged { row.by_plan.clone() } else { "!".to_owned() };
            Row {
                name: row.name.clone(),
                measured: row.measured,
                limits: None,
                verdict,
                callout: String::new(),
                by_plan: String::new(),
            }
        };
        self.rows.iter().map(row).collect()
    }

    /// Each feature of the plan once.
    pub(crate) fn features(&self) -> Vec<(String, String, &str, bool)> {
        let mut features: Vec<(String, String, &str, bool)> = Vec::new();
        for row in &self.rows {
            if let Some((callout, word, is_made)) = row.planned() {
                let feature = (row.name.clone(), callout, word, is_made);
                if !features.contains(&feature) {
                    features.push(feature);
                }
            }
        }
        features
    }

    pub(crate) fn plan(&self) -> String {
        let mut text = "fitcheck_plan = 1\n".to_owned();
        for (name, callout, word, _) in self.features() {
            let kind = match word {
                "" => String::new(),
                "length" | "form" => format!("kind = \"{word}\"\n"),
                side => format!("feature = \"{side}\"\n"),
            };
            write!(text, "\n[[feature]]\nname = \"{name}\"\ncallout = \"{callout}\"\n{kind}").unwrap();
        }
        text
    }

    pub(crate) fn inputs<'a>(masks: &'a [(String, Mask)], sources: &'a Sources, has_plan: bool) -> ImportInputs<'a> {
        ImportInputs { masks, has_plan, ..ImportInputs::new(sources, now()) }
    }

    pub(crate) fn masks(&self) -> Vec<(String, Mask)> {
        let read = |(name, text): &(String, String)| (name.clone(), Mask::read(text.as_bytes()).unwrap().0);
        self.mask.iter().map(read).collect()
    }
}
