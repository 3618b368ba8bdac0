//! The contributions of a budget as its text has them, line by line: each key with its value where it stands, so that a
//! change of one leaves every other line as it is, comments included.

use std::ops::Range;

/// The head of a contribution.
const HEAD: &str = "[[contribution]]";

/// A contribution as it is written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WrittenContribution {
    /// Its lines from its head to its last key, from 0.
    pub lines: Range<usize>,
    /// Its keys in their order, each with its line and its value; texts are without quotation marks.
    keys: Vec<(String, usize, String)>,
}

impl WrittenContribution {
    /// The value of a key; empty where there is none.
    pub fn value(&self, key: &str) -> &str {
        self.keys.iter().find(|(known, ..)| known == key).map_or("", |(.., value)| value)
    }

    /// Whether a key is there.
    pub fn has(&self, key: &str) -> bool {
        self.line(key).is_some()
    }

    /// The line of a key, from 0.
    pub fn line(&self, key: &str) -> Option<usize> {
        self.keys.iter().find(|(known, ..)| known == key).map(|(_, line, _)| *line)
    }
}

/// What stands above every table: the name of the budget, its days and who made it.
pub fn head(text: &str) -> WrittenContribution {
    let mut head = WrittenContribution { lines: 0..0, keys: Vec::new() };
    for (number, line) in text.lines().enumerate() {
        let said = line.trim();
        if said.starts_with('[') {
            break;
        }
        if let Some((key, value)) = said.split_once('=').filter(|_| !said.starts_with('#')) {
            head.keys.push((key.trim().to_owned(), number, unquoted(before_comment(value).trim())));
            head.lines.end = number + 1;
        }
    }
    head
}

/// The contributions of a text; `None` where it writes them in another way than one key a line.
pub fn read(text: &str) -> Option<Vec<WrittenContribution>> {
    let mut all: Vec<WrittenContribution> = Vec::new();
    let mut is_within = false;
    for (number, line) in text.lines().enumerate() {
        let said = line.trim();
        if said.is_empty() || said.starts_with('#') {
            continue;
        }
        if said.starts_with('[') {
            let head: String = before_comment(said).chars().filter(|sign| !sign.is_whitespace()).collect();
            is_within = head == HEAD;
            if is_within {
                all.push(WrittenContribution { lines: number..number + 1, keys: Vec::new() });
            }
            continue;
        }
        let (key, value) = said.split_once('=')?;
        let key = key.trim();
        // A whole list of contributions in a line, or a text over several lines.
        if key == "contribution" || value.contains("\"\"\"") || value.contains("'''") {
            return None;
        }
        if let Some(last) = all.last_mut().filter(|_| is_within) {
            last.keys.push((key.to_owned(), number, unquoted(before_comment(value).trim())));
            last.lines.end = number + 1;
        }
    }
    Some(all)
}

/// What stands in a line before its comment.
fn before_comment(line: &str) -> &str {
    let mut quote = None;
    let mut is_escaped = false;
    for (at, sign) in line.char_indices() {
        match (quote, sign) {
            _ if is_escaped => is_escaped = false,
            (Some('"'), '\\') => is_escaped = true,
            (Some(open), sign) if open == sign => quote = None,
            (None, '"' | '\'') => quote = Some(sign),
            (None, '#') => return line.split_at(at).0,
            _ => {}
        }
    }
    line
}

/// A text without its quotation marks and escapes; anything else, and what is no value yet, as it stands.
fn unquoted(value: &str) -> String {
    match toml::from_str::<toml::Table>(&format!("it = {value}")).ok().and_then(|mut table| table.remove("it")) {
        Some(toml::Value::String(text)) => text,
        _ => value.to_owned(),
    }
}

/// A text as a value.
pub fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}

/// A text with the lines of another one in the place of some of its own.
fn with_lines(text: &str, place: Range<usize>, new: &[String]) -> String {
    let lines: Vec<&str> = text.lines().collect();
    let before = lines.iter().take(place.start).copied();
    let after = lines.iter().skip(place.end).copied();
    let all: Vec<&str> = before.chain(new.iter().map(String::as_str)).chain(after).collect();
    let end = if text.ends_with('\n') || text.is_empty() { "\n" } else { "" };
    format!("{}{end}", all.join("\n"))
}

/// The text with another value of a key; what is behind it in its line stays. A key that is not there yet comes last.
pub fn with_value(text: &str, row: &WrittenContribution, key: &str, value: &str) -> String {
    let Some(number) = row.line(key) else {
        return with_lines(text, row.lines.end..row.lines.end, &[format!("{key} = {value}")]);
    };
    let line = text.lines().nth(number).map_or("", |line| line);
    let (name, old) = line.split_once('=').unwrap_or((line, ""));
    let given = before_comment(old);
    let comment = old.split_at(given.len()).1;
    let gap = given.split_at(given.trim_end().len()).1;
    with_lines(text, number..number + 1, &[format!("{name}= {value}{gap}{comment}")])
}

/// The text with another name of a key; its value and its comment stay.
pub fn with_key(text: &str, row: &WrittenContribution, key: &str, new: &str) -> String {
    let Some(number) = row.line(key) else { return text.to_owned() };
    let line = text.lines().nth(number).map_or("", |line| line);
    let rest = line.split_once('=').map_or("", |(_, rest)| rest);
    with_lines(text, number..number + 1, &[format!("{new} ={rest}")])
}

/// The text without a key, and the comment that goes with it.
pub fn without_key(text: &str, row: &WrittenContribution, key: &str) -> (String, Vec<String>) {
    let Some(number) = row.line(key) else { return (text.to_owned(), Vec::new()) };
    let lost = comments(text, number..number + 1);
    (with_lines(text, number..number + 1, &[]), lost)
}

/// The text without a contribution and the comment above it, and the comments that go with it.
pub fn without_row(text: &str, row: &WrittenContribution) -> (String, Vec<String>) {
    let lines: Vec<&str> = text.lines().collect();
    let above = lines.iter().take(row.lines.start).rev().take_while(|line| line.trim_start().starts_with('#')).count();
    let start = row.lines.start - above;
    // The blank line above goes with it.
    let is_blank = start.checked_sub(1).and_then(|before| lines.get(before)).is_some_and(|line| line.trim().is_empty());
    let lost = comments(text, start..row.lines.end);
    (with_lines(text, start - usize::from(is_blank)..row.lines.end, &[]), lost)
}

/// The comments of some lines.
fn comments(text: &str, place: Range<usize>) -> Vec<String> {
    let lines = text.lines().skip(place.start).take(place.len());
    let comment = |line: &str| line.split_at(before_comment(line).len()).1.trim().to_owned();
    lines.map(comment).filter(|comment| !comment.is_empty()).collect()
}

/// The text with a new contribution behind the last one, and its number.
pub fn with_row(text: &str, rows: &[WrittenContribution], name: &str) -> (String, usize) {
    let at = rows.last().map_or(text.lines().count(), |row| row.lines.end);
    let name = format!("name = {}", quoted(name));
    let new = ["", HEAD, &name, "type = \"B\"", "law = \"rectangular\"", "half_width_um = 1.0"];
    (with_lines(text, at..at, &new.map(str::to_owned)), rows.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "name = \"S # 1\"  # station\n\n# From its certificate.\n[[contribution]] # ring\nname = \"Ring \\\"A\\\"\"\nlaw = \"normal\" # by k\nexpanded_um = 1.0   # U\nk = 2\n\n[[contribution]]\nname = 'Display'\n";

    fn rows() -> Vec<WrittenContribution> {
        read(TEXT).unwrap()
    }

    #[test]
    fn a_text_is_read_with_the_escapes_of_toml_and_a_number_as_it_stands() {
        let text = "[[contribution]]\nname = \"Ma\\u00df\\t1\"\nhalf_width_um = 1_0.5\nk = 2e\n";
        let row = read(text).unwrap().remove(0);
        assert_eq!([row.value("name"), row.value("half_width_um"), row.value("k")], ["Maß\t1", "1_0.5", "2e"]);
    }

    #[test]
    fn contributions_are_found_with_their_keys_and_lines() {
        let rows = rows();
        assert_eq!(rows.iter().map(|row| row.lines.clone()).collect::<Vec<_>>(), [3..8, 9..11]);
        assert_eq!(
            rows[0].keys.iter().map(|(key, ..)| key.as_str()).collect::<Vec<_>>(),
            ["name", "law", "expanded_um", "k"]
        );
        assert_eq!(
            [rows[0].value("name"), rows[0].value("law"), rows[1].value("name")],
            ["Ring \"A\"", "normal", "Display"]
        );
    }

    #[test]
    fn a_new_value_keeps_its_comment_and_every_other_line() {
        assert_eq!(
            with_value(TEXT, &rows()[0], "expanded_um", "0.8"),
            TEXT.replace("expanded_um = 1.0   # U", "expanded_um = 0.8   # U")
        );
        assert_eq!(
            with_value(TEXT, &rows()[0], "sensitivity", "2"),
            TEXT.replace("k = 2\n", "k = 2\nsensitivity = 2\n")
        );
        assert_eq!(
            with_key(TEXT, &rows()[0], "expanded_um", "standard_um"),
            TEXT.replace("expanded_um = 1.0", "standard_um = 1.0")
        );
    }

    #[test]
    fn what_is_removed_says_which_comments_go_with_it() {
        let (text, lost) = without_row(TEXT, &rows()[0]);
        assert_eq!(text, "name = \"S # 1\"  # station\n\n[[contribution]]\nname = 'Display'\n");
        assert_eq!(lost, ["# From its certificate.", "# ring", "# by k", "# U"]);
        let (text, lost) = without_key(TEXT, &rows()[0], "k");
        assert_eq!((text, lost), (TEXT.replace("k = 2\n", ""), Vec::new()));
    }

    #[test]
    fn a_new_contribution_comes_behind_the_last_one() {
        let (text, number) = with_row(TEXT, &rows(), "New");
        assert_eq!(number, 2);
        assert!(text.ends_with("name = 'Display'\n\n[[contribution]]\nname = \"New\"\ntype = \"B\"\nlaw = \"rectangular\"\nhalf_width_um = 1.0\n"));
        assert_eq!(read(&text).unwrap().len(), 3);
    }

    #[test]
    fn other_ways_to_write_it_are_left_to_the_text() {
        for text in ["contribution = [{ name = \"a\" }]\n", "name = \"\"\"a\n\"\"\"\n", "name\n"] {
            assert_eq!(read(text), None, "{text}");
        }
    }
}
