//! What the verdicts rest on, below a table: limits, rules, budgets, and what the measurements cannot tell. Each sentence stands once, with the
//! rows that it is about, unless it is about all of them.

use std::collections::HashMap;

use fitcheck_core::message::message;
use fitcheck_core::words::Words;

use super::flow::{Flow, base};
use super::fonts::Weight;
use super::look::{GAP, NOTE, SIDE, Style, TEXT};
use super::tags::{Kind, TagId};
use crate::journal::Record;
use crate::report::template::Section;
use crate::report::{origins, text};

/// The label of what the measurements cannot tell.
const CAVEATS: &str = "report-cannot-tell";
/// The most sentences with a label: those of a lot with a file for each value would fill pages.
const MOST: usize = 40;
/// Up to here a sentence is a short one.
const SHORT: usize = 60;
/// The most runs of rows that a sentence names.
const MOST_SPANS: usize = 12;

/// The most lines of a sentence, or of several short ones.
const MOST_LINES: usize = 16;

/// Rows one behind the other: the numbers of the first and the last one, and what they are called.
struct Span {
    last: usize,
    first_label: String,
    last_label: String,
}

#[derive(Default)]
struct Sentence {
    spans: Vec<Span>,
    rows: usize,
}

#[derive(Default)]
struct Group {
    /// By what they say; their order is in `order`.
    sentences: HashMap<String, Sentence>,
    order: Vec<String>,
    left_out: usize,
}

/// The sentences, by their labels.
pub(super) struct Grounds<'a> {
    words: &'a Words,
    groups: [(&'static str, Group); 5],
    rows: usize,
}

impl<'a> Grounds<'a> {
    pub fn new(words: &'a Words) -> Self {
        let labels = ["report-limits-from", "report-measured-from", "report-verdict-from", "report-budget", CAVEATS];
        Self { words, groups: labels.map(|label| (label, Group::default())), rows: 0 }
    }

    /// Adds what a row rests on.
    pub fn see(&mut self, label: &str, record: &Record) {
        let words = self.words;
        let [limits, measured, rule, budget, caveats] = &mut self.groups;
        let row = (self.rows, label);
        limits.1.see(row, words.say(&text::source(&record.limits.source, words)));
        measured.1.see(row, origins::measured(record, words));
        rule.1.see(row, origins::rule(record.verdict.rule, words));
        if let Some(found) = &record.budget {
            budget.1.see(row, origins::budget(found, words));
        }
        for caveat in record.caveats() {
            caveats.1.see(row, words.told(&caveat));
        }
        self.rows += 1;
    }

    /// Writes the sentences of a section.
    pub fn write(&self, flow: &mut Flow<'_>, section: TagId, shown: Section) {
        for (label, group) in &self.groups {
            let is_caveat = *label == CAVEATS;
            if !group.order.is_empty() && is_caveat == (shown == Section::Caveats) {
                self.group(flow, section, label, group);
            }
        }
        flow.y += GAP / 2.0;
    }

    fn group(&self, flow: &mut Flow<'_>, section: TagId, label: &str, group: &Group) {
        let mut sentences: Vec<String> = group.order.iter().map(|said| self.said(said, group)).collect();
        if 0 < group.left_out {
            sentences.push(self.words.say(&message!("report-pdf-more").count("count", group.left_out)));
        }
        // Short ones stand one behind the other.
        if 1 < sentences.len() && sentences.iter().all(|said| said.chars().count() <= SHORT) {
            sentences = vec![sentences.join("; ")];
        }
        labelled(flow, section, &self.words.get(label), &sentences);
    }

    /// A sentence, with the rows that it is about.
    fn said(&self, said: &str, group: &Group) -> String {
        let Some(sentence) = group.sentences.get(said).filter(|sentence| sentence.rows < self.rows) else {
            return said.to_owned();
        };
        let name = |span: &Span| {
            if span.first_label == span.last_label {
                span.first_label.clone()
            } else {
                format!("{}–{}", span.first_label, span.last_label)
            }
        };
        let mut names: Vec<String> = sentence.spans.iter().take(MOST_SPANS).map(name).collect();
        if MOST_SPANS < sentence.spans.len() {
            names.push("…".to_owned());
        }
        format!("{said} ({} {})", self.words.get("report-contact"), names.join(", "))
    }
}

impl Group {
    fn see(&mut self, (row, label): (usize, &str), said: String) {
        if !self.sentences.contains_key(&said) {
            if MOST <= self.order.len() {
                self.left_out += 1;
                return;
            }
            self.order.push(said.clone());
        }
        let sentence = self.sentences.entry(said).or_default();
        sentence.rows += 1;
        let is_full = MOST_SPANS < sentence.spans.len();
        match sentence.spans.last_mut() {
            Some(span) if span.last + 1 == row => {
                span.last = row;
                label.clone_into(&mut span.last_label);
            }
            // What is named no more is only counted.
            Some(span) if is_full => span.last = row,
            _ => {
                let [first_label, last_label] = [label.to_owned(), label.to_owned()];
                sentence.spans.push(Span { last: row, first_label, last_label });
            }
        }
    }
}

/// A label on the left, and sentences beside it.
pub(super) fn labelled(flow: &mut Flow<'_>, section: TagId, label: &str, sentences: &[String]) {
    let element = flow.tags.add(section, Kind::Paragraph);
    let indent = 112.0;
    let style = Style { weight: Weight::Semibold, ..NOTE.in_ink(TEXT) };
    let heads = flow.wrap(label, style, indent - 8.0, 3);
    flow.room(style.line() * 2.0);
    let page = flow.page();
    let top = flow.y;
    let mut y = flow.y;
    for head in heads {
        flow.say(Some(element), [SIDE, base(y, style.line(), style)], style, format!("{head} "));
        y += style.line();
    }
    for said in sentences {
        let element = flow.tags.add(section, Kind::Paragraph);
        let width = flow.width() - indent;
        let lines = flow.wrap(said, NOTE.in_ink(TEXT), width, MOST_LINES);
        flow.lines(element, SIDE + indent, NOTE.in_ink(TEXT), lines);
    }
    if flow.page() == page {
        flow.y = flow.y.max(y).max(top);
    }
    flow.y += 3.0;
}
