//! Cells of a sheet: numbers, dates, texts and formulas with their looks, and how a sheet is printed.

use std::io;

use fitcheck_core::length::Length;
use fitcheck_core::message::is_formula;
use fitcheck_core::verdict::Status;
use fitcheck_core::words::Words;
use jiff::civil::DateTime;
use rust_xlsxwriter::{
    Color, ConditionalFormatText, ConditionalFormatTextRule, ExcelDateTime, Format, FormatAlign, FormatBorder, Formula,
    Worksheet,
};

use super::failed;
use crate::report::told::{mark, on_one_line};

/// The most UTF-16 units of a cell.
const LONGEST: usize = 32_767;

/// A4.
const PAPER: u8 = 9;

/// How dates are written: the same in every language, so that nobody mistakes the day for the month.
const TIME: &str = "yyyy\\-mm\\-dd hh:mm:ss";

/// The height of a line of text, and the most that a row has, in points.
const LINE: u32 = 15;
const HIGHEST: u32 = 405;

/// The margins of a page in inches: left, right, top, bottom, and those of header and footer.
const MARGINS: [f64; 6] = [0.4, 0.4, 0.5, 0.6, 0.3, 0.3];

/// The most UTF-16 units of a footer.
const LONGEST_FOOTER: usize = 200;

/// Where a cell stands: row and column, from 0.
pub(super) type At = (u32, u16);

/// How cells look.
pub(super) struct Looks {
    plain: Format,
    /// The same where an edit of the cell would make a formula of it.
    quoted: Format,
    title: Format,
    head: Format,
    label: Format,
    strong: Format,
    mm: Format,
    um: Format,
    amount: Format,
    whole: Format,
    time: Format,
    /// The same at the left, beside a label.
    whole_beside: Format,
    time_beside: Format,
    /// The colours of the verdicts, by their marks.
    verdicts: Vec<(&'static str, Format)>,
    /// What stands above the cells of a sheet where nobody measured.
    pub(super) simulated: String,
}

/// The looks of a text.
#[derive(Clone, Copy)]
pub(super) enum Look {
    Plain,
    Title,
    Head,
    Label,
    Strong,
}

impl Looks {
    pub(super) fn new(words: &Words) -> Self {
        let top = || Format::new().set_align(FormatAlign::Top);
        // A number stands at the right of its cell, so a text behind it begins a little later.
        let wrapped = || top().set_align(FormatAlign::Left).set_text_wrap().set_indent(1);
        let coloured = |status: Option<Status>, back: u32, front: u32| {
            let format = Format::new().set_background_color(Color::RGB(back)).set_font_color(Color::RGB(front));
            (mark(status), format)
        };
        Self {
            plain: wrapped(),
            quoted: wrapped().set_quote_prefix(),
            title: Format::new().set_bold().set_font_size(16),
            head: wrapped()
                .set_bold()
                .set_border_bottom(FormatBorder::Medium)
                .set_background_color(Color::RGB(0x00E6_E6E6)),
            label: top().set_bold(),
            strong: wrapped().set_bold(),
            // At least three decimals, and those that a finer size has.
            mm: top().set_num_format("0.000###"),
            um: top().set_num_format("+0.###;\u{2212}0.###;0"),
            // With its unit: a column whose name has one is taken for one of sizes while nothing is in it.
            amount: top().set_num_format("0.### \"µm\""),
            whole: top().set_num_format("0"),
            time: top().set_num_format(TIME),
            whole_beside: top().set_num_format("0").set_align(FormatAlign::Left),
            time_beside: top().set_num_format(TIME).set_align(FormatAlign::Left),
            verdicts: vec![
                coloured(Some(Status::Good), 0x0022_AA77, 0),
                coloured(Some(Status::Rework), 0x00FF_C20A, 0),
                coloured(Some(Status::ReMeasure), 0x0000_559E, 0x00FF_FFFF),
                coloured(Some(Status::OutOfLimits), 0x007A_3FA8, 0x00FF_FFFF),
                coloured(Some(Status::Scrap), 0x00A6_1C00, 0x00FF_FFFF),
                coloured(None, 0x0059_5959, 0x00FF_FFFF),
            ],
            simulated: words.get("simulated"),
        }
    }

    const fn of(&self, look: Look) -> &Format {
        match look {
            Look::Plain => &self.plain,
            Look::Title => &self.title,
            Look::Head => &self.head,
            Look::Label => &self.label,
            Look::Strong => &self.strong,
        }
    }
}

/// A sheet that is being filled, row by row.
pub(super) struct Paper<'w> {
    sheet: &'w mut Worksheet,
    /// How wide its columns are, in characters.
    widths: Vec<f64>,
    /// The row that is being filled, and how many lines it has.
    row: (u32, u32),
}

impl<'w> Paper<'w> {
    /// A4 across, as wide as the page, with the program and the page at the foot.
    pub(super) fn new(sheet: &'w mut Worksheet, program: &str) -> Self {
        let program: String = on_one_line(program).replace('&', "&&").chars().take(LONGEST_FOOTER).collect();
        sheet.set_paper_size(PAPER).set_landscape().set_print_fit_to_pages(1, 0);
        sheet.set_footer(format!("&L{program}&R&P / &N"));
        let [left, right, top, bottom, header, footer] = MARGINS;
        sheet.set_margins(left, right, top, bottom, header, footer);
        Self { sheet, widths: Vec::new(), row: (0, 1) }
    }

    pub(super) fn name(&self) -> String {
        self.sheet.name()
    }

    /// A text: never a formula, a link or a number. The number of characters that were too many, where there were any.
    pub(super) fn text(&mut self, (row, column): At, text: &str, looks: (&Looks, Look)) -> io::Result<bool> {
        let (all, look) = looks;
        let text = on_one_line(text);
        let kept = cut(&text);
        let format = if matches!(look, Look::Plain) && is_formula(kept) { &all.quoted } else { all.of(look) };
        if !kept.is_empty() {
            self.sheet.write_string_with_format(row, column, kept, format).map_err(failed)?;
        }
        if matches!(look, Look::Plain | Look::Head | Look::Strong) {
            self.make_room((row, column), kept)?;
        }
        Ok(kept.len() < text.len())
    }

    /// Makes a row as high as a text needs that is broken at the end of its column: not every program does so by itself.
    fn make_room(&mut self, (row, column): At, text: &str) -> io::Result<()> {
        let Some(width) = self.widths.get(usize::from(column)) else { return Ok(()) };
        let lines = (0..HIGHEST / LINE).zip(wrapped(text, *width)).count();
        let lines = u32::try_from(lines).unwrap_or(1);
        if self.row.0 != row {
            self.row = (row, 1);
        }
        if self.row.1 < lines {
            self.row.1 = lines;
            self.sheet.set_row_height(row, lines * LINE).map_err(failed)?;
        }
        Ok(())
    }

    pub(super) fn mm(&mut self, (row, column): At, length: Length, looks: &Looks) -> io::Result<()> {
        self.sheet.write_number_with_format(row, column, length.to_mm_f64(), &looks.mm).map_err(failed)?;
        Ok(())
    }

    /// Micrometres without a sign.
    pub(super) fn amount(&mut self, (row, column): At, length: Length, looks: &Looks) -> io::Result<()> {
        self.sheet.write_number_with_format(row, column, length.to_um_f64(), &looks.amount).map_err(failed)?;
        Ok(())
    }

    pub(super) fn whole(&mut self, (row, column): At, count: usize, looks: &Looks) -> io::Result<()> {
        // More than a sheet has rows, so a float holds it.
        let count = f64::from(u32::try_from(count).unwrap_or(u32::MAX));
        self.sheet.write_number_with_format(row, column, count, &looks.whole).map_err(failed)?;
        Ok(())
    }

    /// A date with its time; as a text where a sheet knows no such year.
    pub(super) fn time(&mut self, at: At, time: DateTime, looks: &Looks) -> io::Result<()> {
        match excel_time(time) {
            Some(known) => {
                self.sheet.write_datetime_with_format(at.0, at.1, &known, &looks.time).map_err(failed)?;
            }
            None => {
                self.text(at, &time.to_string(), (looks, Look::Plain))?;
            }
        }
        Ok(())
    }

    /// Gives a number or a date the place of a text beside its label.
    pub(super) fn beside(&mut self, (row, column): At, is_time: bool, looks: &Looks) -> io::Result<()> {
        let format = if is_time { &looks.time_beside } else { &looks.whole_beside };
        self.sheet.set_cell_format(row, column, format).map_err(failed)?;
        Ok(())
    }

    /// A whole number that a formula counts.
    pub(super) fn counted(&mut self, (row, column): At, formula: &str, count: usize, looks: &Looks) -> io::Result<()> {
        let formula = Formula::new(formula).set_result(count.to_string());
        self.sheet.write_formula_with_format(row, column, formula, &looks.whole).map_err(failed)?;
        Ok(())
    }

    /// Micrometres that a formula reckons.
    pub(super) fn reckoned(&mut self, (row, column): At, formula: &str, um: Length, looks: &Looks) -> io::Result<()> {
        let formula = Formula::new(formula).set_result(um.to_um_f64().to_string());
        self.sheet.write_formula_with_format(row, column, formula, &looks.um).map_err(failed)?;
        Ok(())
    }

    pub(super) fn widths(&mut self, widths: &[f64]) -> io::Result<()> {
        self.widths = widths.to_vec();
        for (column, width) in (0..).zip(widths) {
            self.sheet.set_column_width(column, *width).map_err(failed)?;
        }
        Ok(())
    }

    /// A table from its head to its last row: the head stays in sight and stands on each page, every column can be filtered, and the
    /// verdicts in one column have their colours.
    pub(super) fn table(&mut self, head: At, last: At, verdicts: u16, looks: &Looks) -> io::Result<()> {
        let first = head.0 + 1;
        self.sheet.set_freeze_panes(first, 0).map_err(failed)?;
        self.sheet.set_repeat_rows(head.0, head.0).map_err(failed)?;
        self.sheet.autofilter(head.0, head.1, last.0, last.1).map_err(failed)?;
        self.sheet.set_print_area(0, 0, last.0, last.1).map_err(failed)?;
        if first <= last.0 {
            self.colours((first, verdicts), last.0, looks)?;
        }
        Ok(())
    }

    /// Gives the cells of a column the colours of their verdicts.
    pub(super) fn colours(&mut self, (first, column): At, last: u32, looks: &Looks) -> io::Result<()> {
        for (mark, format) in &looks.verdicts {
            let rule = ConditionalFormatTextRule::BeginsWith((*mark).to_owned());
            let colour = ConditionalFormatText::new().set_rule(rule).set_format(format);
            self.sheet.add_conditional_format(first, column, last, column, &colour).map_err(failed)?;
        }
        Ok(())
    }

    pub(super) fn print_all(&mut self, last: At) -> io::Result<()> {
        self.sheet.set_print_area(0, 0, last.0, last.1).map_err(failed)?;
        Ok(())
    }
}

/// The lines of a text in a column that is so many characters wide, whole words on each where they fit; their lengths.
fn wrapped(text: &str, width: f64) -> impl Iterator<Item = f64> {
    let mut words = text.split(' ').map(|word| f64::from(u32::try_from(word.chars().count()).unwrap_or(u32::MAX)));
    let mut waiting = words.next();
    std::iter::from_fn(move || {
        let mut line = waiting.take()?;
        if width < line {
            // A word of several lines.
            waiting = Some(line - width);
            return Some(width);
        }
        for word in words.by_ref() {
            if width < line + 1.0 + word {
                waiting = Some(word);
                break;
            }
            line += 1.0 + word;
        }
        Some(line)
    })
}

/// What a cell has room for.
fn cut(text: &str) -> &str {
    if text.len() <= LONGEST {
        return text;
    }
    let mut units = 0;
    let end = text.char_indices().find(|(_, c)| {
        units += c.len_utf16();
        LONGEST < units
    });
    end.and_then(|(at, _)| text.get(..at)).unwrap_or(text)
}

/// A date as sheets have it, from the year 1900 on.
pub(super) fn excel_time(time: DateTime) -> Option<ExcelDateTime> {
    let [month, day, hour, minute, second] =
        [time.month(), time.day(), time.hour(), time.minute(), time.second()].map(|part| u8::try_from(part).ok());
    let date = ExcelDateTime::from_ymd(u16::try_from(time.year()).ok()?, month?, day?).ok()?;
    date.and_hms(u16::from(hour?), minute?, f64::from(second?)).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_is_broken_between_words() {
        for (text, width, lines) in [
            ("", 10.0, 1),
            ("one two", 10.0, 1),
            ("one two three", 10.0, 2),
            ("a-very-long-word-of-many-signs x", 10.0, 4),
            ("one two three four five", 5.0, 5),
        ] {
            assert_eq!(wrapped(text, width).count(), lines, "{text}");
        }
    }

    #[test]
    fn a_text_is_cut_where_a_cell_ends() {
        let long = "\u{1f600}".repeat(20_000);
        assert_eq!(cut(&long).encode_utf16().count(), LONGEST - 1);
        assert_eq!(cut("Bore A"), "Bore A");
    }

    #[test]
    fn a_year_before_1900_is_no_date_of_a_sheet() {
        assert!(excel_time(DateTime::constant(2026, 11, 21, 10, 42, 7, 0)).is_some());
        assert!(excel_time(DateTime::constant(1899, 12, 1, 0, 0, 0, 0)).is_none());
        assert!(excel_time(DateTime::constant(-5, 1, 1, 0, 0, 0, 0)).is_none());
    }
}
