//! What a text shows of the values that are put into it, and what it chooses its words by.

use std::collections::{BTreeMap, BTreeSet};

use fluent_syntax::ast::{Entry, Expression, InlineExpression, Pattern, PatternElement, Variant, VariantKey};
use fluent_syntax::parser;
use fluent_syntax::unicode::unescape_unicode_to_string;

use super::is_wild;

/// As many ways through the variants of a text are looked at; no built-in text has more than a tenth of it.
const MOST_WAYS: usize = 2_000;

/// Keys that are forms of a number and no words that a value has.
const NUMBERS: [&str; 6] = ["zero", "one", "two", "few", "many", "other"];

/// The keys by which variants are chosen, by the names of the values; nothing where none of them is the value.
type Ways<'a> = BTreeMap<String, BTreeSet<&'a str>>;

/// What a text shows, or one of the ways through its variants.
#[derive(Debug, Default)]
struct Shown<'a> {
    /// Values and other texts as they stand between the braces: `$count`, `simulated`.
    placeables: BTreeSet<String>,
    choices: Ways<'a>,
    /// Whether there is anything to be seen.
    is_visible: bool,
    /// A character that a literal puts in and no text may have.
    wild: Option<char>,
}

/// What is wrong with a text beside the built-in one.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Difference {
    /// It shows nothing, or one of its variants does.
    Empty,
    /// A literal puts in a control character.
    Wild(char),
    /// It has something that the built-in text has not; what that has.
    Surplus(String, String),
    /// It lacks something of the built-in text, or a variant does.
    Lost(String),
    /// It has too many variants.
    TooMany,
}

/// The value of an entry that was read without errors; `None` where it is no message, or has attributes.
pub(super) fn value<'a>(entry: &Entry<&'a str>) -> Option<(&'a str, Pattern<&'a str>)> {
    match entry {
        Entry::Message(message) if message.attributes.is_empty() => Some((message.id.name, message.value.clone()?)),
        _ => None,
    }
}

/// Compares a text with the built-in one, both as Fluent reads them.
///
/// # Errors
/// The first [`Difference`]: by no value may a text show less than the built-in one.
pub(super) fn compare(own: &Pattern<&str>, built_in: &str) -> Result<(), Difference> {
    // A built-in text is read without errors, which a test sees to; an empty one has nothing to lose.
    let built_in = parser::parse_runtime(built_in).unwrap_or_else(|(broken, _)| broken);
    let nothing = Pattern { elements: Vec::new() };
    let built_in = built_in.body.iter().find_map(value).map_or(nothing, |(_, pattern)| pattern);
    let (all, of_built_in) = (shown(own, None), shown(&built_in, None));
    if let Some(wild) = all.wild {
        return Err(Difference::Wild(wild));
    }
    let of_values: BTreeSet<&String> = of_built_in.placeables.iter().chain(of_built_in.choices.keys()).collect();
    if let Some(surplus) = all.placeables.iter().chain(all.choices.keys()).find(|of| !of_values.contains(of)) {
        let allowed: Vec<String> = of_values.iter().map(|of| braced(of)).collect();
        return Err(Difference::Surplus(braced(surplus), allowed.join(", ")));
    }
    for (by, keys) in &of_built_in.choices {
        let is_number = |key: &&str| NUMBERS.contains(key) || key.parse::<f64>().is_ok();
        let has = |key: &&str| all.choices.get(by).is_some_and(|keys| keys.contains(key));
        let are_words = !keys.iter().all(is_number);
        if let Some(lost) = keys.iter().find(|key| are_words && !has(key)) {
            return Err(Difference::Lost(format!("{{ {by} -> [{lost}] … }}")));
        }
    }
    for way in ways([&all.choices, &of_built_in.choices]).ok_or(Difference::TooMany)? {
        let (here, there) = (shown(own, Some(&way)), shown(&built_in, Some(&way)));
        if let Some(lost) = there.placeables.difference(&here.placeables).next() {
            return Err(Difference::Lost(braced(lost)));
        }
        if there.is_visible && !here.is_visible {
            return Err(Difference::Empty);
        }
    }
    if all.is_visible { Ok(()) } else { Err(Difference::Empty) }
}

fn braced(placeable: &str) -> String {
    format!("{{ {placeable} }}")
}

/// Every way through the variants of two texts; `None` where there are too many.
fn ways<'a>(of: [&Ways<'a>; 2]) -> Option<Vec<BTreeMap<String, &'a str>>> {
    let mut all = Ways::new();
    for (by, keys) in of.into_iter().flatten() {
        all.entry(by.clone()).or_default().extend(keys);
    }
    let mut ways = vec![BTreeMap::new()];
    for (by, mut keys) in all {
        // A value that is none of them.
        keys.insert("");
        if MOST_WAYS < ways.len().saturating_mul(keys.len()) {
            return None;
        }
        let with = |way: &BTreeMap<String, &'a str>, key| {
            let mut way = way.clone();
            way.insert(by.clone(), key);
            way
        };
        ways = ways.iter().flat_map(|way| keys.iter().map(|key| with(way, *key)).collect::<Vec<_>>()).collect();
    }
    Some(ways)
}

/// What a text shows by these values; without values, everything that it could show.
fn shown<'a>(pattern: &Pattern<&'a str>, way: Option<&BTreeMap<String, &'a str>>) -> Shown<'a> {
    let mut shown = Shown::default();
    shown.add(pattern, way);
    shown
}

impl<'a> Shown<'a> {
    fn add(&mut self, pattern: &Pattern<&'a str>, way: Option<&BTreeMap<String, &'a str>>) {
        for element in &pattern.elements {
            match element {
                PatternElement::TextElement { value } => self.is_visible |= value.chars().any(is_visible),
                PatternElement::Placeable { expression } => self.expression(expression, way),
            }
        }
    }

    fn expression(&mut self, expression: &Expression<&'a str>, way: Option<&BTreeMap<String, &'a str>>) {
        let (selector, variants) = match expression {
            Expression::Inline(inline) => return self.inline(inline, way),
            Expression::Select { selector, variants } => (name(selector), variants),
        };
        let by = selector.unwrap_or_else(|| "\"…\" -> …".to_owned());
        let chosen = way.map(|way| way.get(&by).copied().unwrap_or(""));
        self.choices.entry(by).or_default().extend(variants.iter().map(key));
        match chosen {
            Some(chosen) => {
                let find = |wanted: &str| variants.iter().find(|variant| key(variant) == wanted);
                // One is also a number of the form "one".
                let one = || find("one").filter(|_| chosen == "1");
                let default = || variants.iter().find(|variant| variant.default);
                if let Some(variant) = find(chosen).or_else(one).or_else(default) {
                    self.add(&variant.value, way);
                }
            }
            None => variants.iter().for_each(|variant| self.add(&variant.value, None)),
        }
    }

    fn inline(&mut self, inline: &InlineExpression<&'a str>, way: Option<&BTreeMap<String, &'a str>>) {
        match inline {
            InlineExpression::StringLiteral { value } => {
                let text = unescape_unicode_to_string(value);
                self.is_visible |= text.chars().any(is_visible);
                self.wild = self.wild.or_else(|| text.chars().find(|c| is_wild(*c)));
            }
            InlineExpression::NumberLiteral { .. } => self.is_visible = true,
            InlineExpression::Placeable { expression } => self.expression(expression, way),
            _ => {
                self.placeables.extend(name(inline));
                self.is_visible = true;
            }
        }
    }
}

/// What stands between the braces; `None` for a literal.
fn name(inline: &InlineExpression<&str>) -> Option<String> {
    Some(match inline {
        InlineExpression::VariableReference { id } => format!("${}", id.name),
        InlineExpression::MessageReference { id, attribute: None } => id.name.to_owned(),
        InlineExpression::MessageReference { id, attribute: Some(attribute) } => {
            format!("{}.{}", id.name, attribute.name)
        }
        InlineExpression::TermReference { id, .. } => format!("-{}", id.name),
        InlineExpression::FunctionReference { id, .. } => format!("{}()", id.name),
        InlineExpression::StringLiteral { .. }
        | InlineExpression::NumberLiteral { .. }
        | InlineExpression::Placeable { .. } => return None,
    })
}

fn key<'a>(variant: &Variant<&'a str>) -> &'a str {
    match &variant.key {
        VariantKey::Identifier { name } => name,
        VariantKey::NumberLiteral { value } => value,
    }
}

/// Whether a character can be seen: no blank and none without a width.
fn is_visible(c: char) -> bool {
    !c.is_whitespace()
        && !matches!(c, '\u{ad}' | '\u{200b}'..='\u{200d}' | '\u{2060}' | '\u{feff}' | '\u{2800}' | '\u{3164}')
}
