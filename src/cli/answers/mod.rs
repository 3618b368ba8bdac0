//! Answers callouts one by one, in one of the three formats: memory stays the same however many there are.

mod lines;

pub(super) use lines::LONGEST_LINE;

use std::fmt::Display;
use std::io::{BufRead, Cursor};
use std::path::Path;

use lines::{Line, NextLine};
use serde::Serialize;

use super::rows::{Columns, csv_line, line, names};
use super::{CliError, CliRemark, Format, Io, read_input};
use crate::text::{decode, utf16};

/// How much of a line that is too long is shown.
const SHOWN: usize = 40;

/// A callout, and its line if it comes from standard input.
#[derive(Debug, Clone, Copy)]
pub(super) struct CalloutInput<'a> {
    pub(super) callout: &'a str,
    pub(super) line: Option<usize>,
}

/// What a subcommand says about a callout; a refused callout also gets an answer.
pub(super) trait Answerer {
    /// What CSV and JSON say.
    type AnswerRow<'a>: Columns + Serialize;

    /// Answers a callout.
    fn answer(&mut self, asked: CalloutInput<'_>, answers: &mut Answers, io: &mut Io<'_>);

    /// The figures of a callout without an answer.
    fn refused(callout: &str, error: String) -> Self::AnswerRow<'_>;
}

/// What has been printed so far.
pub(super) struct Answers {
    format: Format,
    /// A single answer in JSON is an object, not an array.
    is_one: bool,
    answered: usize,
    refused: usize,
}

impl Answers {
    /// Answers every callout; `-` stands for the lines of standard input. Returns whether none was refused.
    pub(super) fn print<A: Answerer>(
        (format, is_one): (Format, bool),
        callouts: &[String],
        answerer: &mut A,
        io: &mut Io<'_>,
    ) -> Result<bool, CliError> {
        let mut answers = Self { format, is_one, answered: 0, refused: 0 };
        match format {
            Format::Csv => csv_line(names::<A::AnswerRow<'_>>(), io),
            Format::Json if !is_one => io.data().write_all(b"["),
            Format::Json | Format::Text => {}
        }
        for callout in callouts {
            if callout == "-" {
                answers.lines(answerer, io)?;
            } else {
                answerer.answer(CalloutInput { callout: printable(callout).trim(), line: None }, &mut answers, io);
            }
        }
        Ok(answers.finish(io))
    }

    /// Answers every line of the input. Answers are written out before the next wait for input, so that another program
    /// can ask line by line.
    fn lines<A: Answerer>(&mut self, answerer: &mut A, io: &mut Io<'_>) -> Result<(), CliError> {
        let mut line = Line::default();
        let mut whole = None;
        for number in 1_usize.. {
            // UTF-16 comes from a file, so that nobody waits for its first answers.
            if number == 1 && utf16(io.input_and_data().0.fill_buf()?).is_some() {
                whole = Some(Cursor::new(decode(&read_input(Path::new("-"), io)?.1).into_owned()));
            }
            let (given, out) = io.input_and_data();
            let input: &mut dyn BufRead = match &mut whole {
                Some(whole) => whole,
                None => given,
            };
            let found = line.read(input, || out.flush())?;
            let text = printable(&decode(&line.bytes));
            let asked = |callout| CalloutInput { callout, line: Some(number) };
            match found {
                NextLine::End => break,
                // A line that nobody reads the answer of.
                _ if io.is_closed() => break,
                NextLine::Whole => answerer.answer(asked(text.trim()), self, io),
                NextLine::TooLong => {
                    let beginning: String = text.chars().take(SHOWN).chain(['…']).collect();
                    self.refuse::<A>(asked(&beginning), &CliError::LineTooLong, io);
                }
            }
        }
        Ok(())
    }

    /// Whether answers are for people.
    pub(super) fn is_text(&self) -> bool {
        self.format == Format::Text
    }

    /// Prints an answer for people; `write` gets `true` for the first one.
    pub(super) fn text(&mut self, write: impl FnOnce(&mut Io<'_>, bool), io: &mut Io<'_>) {
        self.answered += 1;
        write(io, self.answered == 1);
    }

    /// Prints why there is no answer.
    pub(super) fn refuse<A: Answerer>(&mut self, asked: CalloutInput<'_>, error: &impl Display, io: &mut Io<'_>) {
        self.refused += 1;
        if !self.is_text() {
            return self.figures(&A::refused(asked.callout, error.to_string()), io);
        }
        self.answered += 1;
        // On a screen, earlier answers must also come before it.
        io.data().flush();
        match asked {
            CalloutInput { callout: "", line: Some(line) } => io.tell(format_args!("line {line}: {error}")),
            CalloutInput { callout: "", line: None } => io.tell(format_args!("\"\": {error}")),
            CalloutInput { callout, .. } => io.tell(format_args!("{callout}: {error}")),
        }
    }

    /// A line of CSV or a JSON object.
    pub(super) fn figures(&mut self, figures: &(impl Columns + Serialize), io: &mut Io<'_>) {
        self.answered += 1;
        match self.format {
            Format::Csv => io.data().write_all(line(figures).end()),
            _ if self.is_one => io.json(figures),
            _ => {
                io.data().write_all(if self.answered == 1 { b"\n  " } else { b",\n  " });
                io.data().write_json(figures);
            }
        }
    }

    fn finish(&self, io: &mut Io<'_>) -> bool {
        if self.format == Format::Json && !self.is_one {
            io.data().write_all(if self.answered == 0 { b"]\n" } else { b"\n]\n" });
        }
        io.data().flush();
        if 0 < self.refused && !self.is_text() {
            io.tell(CliRemark::Refused { refused: self.refused, asked: self.answered });
        }
        self.refused == 0
    }
}

/// A text without control characters: it goes to a terminal, and one line of input stays one line of output.
pub(super) fn printable(text: &str) -> String {
    text.chars().map(|c| if c.is_control() && c != '\t' { char::REPLACEMENT_CHARACTER } else { c }).collect()
}
