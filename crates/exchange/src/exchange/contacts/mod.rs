//! Contacts of one circle: CSV with x, y and optionally z, in millimetres.
//!
//! A row that cannot be used makes the whole file doubtful, so it is an error: a circle through the rest would be a
//! guess. Figures are read as `f64` with all their digits; they are geometry, not sizes.

mod error;

use csv::StringRecord;
pub use error::ContactsError;
use fitcheck_core::message::{FilePlace, Located};
use fitcheck_core::probing::Contact;
use fitcheck_core::tolerance::fit::thermal::Temperature;

use super::delimited::{Item, Rows, SEPARATORS};
use super::error::ImportWarningKind;
use super::evidence::{self, marks_simulation};
use super::given::shorten;
use super::role::Role;
use super::sample::Sample;
use super::source::decode;
use super::warmth::{self, Scale};
use super::{stated, words};

/// The most contacts of a file: a scan of some minutes.
pub const MOST_CONTACTS: usize = 500_000;

/// What a file of contacts holds.
#[derive(Debug, Clone, PartialEq)]
#[expect(clippy::struct_field_names, reason = "the contacts of a file are contacts")]
pub struct Contacts {
    /// The contacts in the file's order.
    pub contacts: Vec<Contact>,
    /// Whether the file has a column z; without one all heights are 0.
    pub has_heights: bool,
    /// Names of the skipped columns.
    pub ignored: Vec<String>,
    /// What the file says of how warm the part was, and which temperature that is.
    pub warm: Option<(String, Temperature)>,
}

impl Contacts {
    /// That the file says another temperature of its contacts than the one that counts, from 1 K on.
    pub fn told_of_temperature(&self, counted: Temperature) -> Option<ImportWarningKind> {
        let (text, warm) = self.warm.as_ref()?;
        let told = ImportWarningKind::SpeaksOfTemperature { text: shorten(text), counted: counted.to_string() };
        warmth::differ(*warm, counted).then_some(told)
    }

    /// Takes what a text says of how warm the part was, where that is further from 20 °C than what was said before.
    fn take_temperature(&mut self, text: &str, said: Option<Temperature>) {
        let off = |warm: Temperature| (warm.thousandths() - Temperature::REFERENCE.thousandths()).abs();
        let before = self.warm.as_ref().map(|(_, warm)| off(*warm));
        if let Some(said) = said.filter(|said| before.is_none_or(|before| before < off(*said))) {
            self.warm = Some((text.to_owned(), said));
        }
    }
}

/// Where x, y and z are in a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Places {
    x: usize,
    y: usize,
    z: Option<usize>,
    cells: usize,
    /// A column that says whether they are simulated.
    simulated: Option<usize>,
}

/// Reads contacts. The separator is a comma, semicolon, tab or bar; a decimal comma may be used where the comma is not
/// the separator. A header with x, y and z in any order is optional.
///
/// ```
/// let contacts = fitcheck_exchange::exchange::contacts::read(b"x;y\n12,5;0\n0;12,5\n-12,5;0\n")?;
/// assert_eq!(contacts.contacts[0].x, 12.5);
/// # Ok::<(), fitcheck_core::message::Located<fitcheck_exchange::exchange::contacts::ContactsError>>(())
/// ```
///
/// # Errors
/// [`ContactsError`] with the line and, as the column, the number of the cell.
pub fn read(bytes: &[u8]) -> Result<Contacts, Located<ContactsError>> {
    let text = decode(bytes);
    let separator = separator(&text);
    let mut read = Contacts { contacts: Vec::new(), has_heights: false, ignored: Vec::new(), warm: None };
    let mut places: Option<Places> = None;
    let mut decimal_sign = None;
    let mut unit = None;
    let mut warm = None::<(usize, (String, Scale))>;
    for item in Rows::new(&text, 1, separator) {
        let (line, cells) = match item {
            Item::Row { line, cells } => (line, cells),
            Item::Lines { line, .. } | Item::OpenQuote { line, .. } => {
                return Err(Located::in_line(line, ContactsError::OpenQuote));
            }
            Item::TooLong { line } => return Err(Located::in_line(line, ContactsError::RowTooLong)),
        };
        if read.contacts.len() == MOST_CONTACTS {
            return Err(Located::in_line(line, ContactsError::TooMany));
        }
        let row: Vec<&str> = cells.iter().map(str::trim).collect();
        if row.iter().all(|cell| cell.is_empty()) {
            continue;
        }
        if let Some((first, more)) = row.split_first().and_then(|(first, more)| Some((first.strip_prefix('#')?, more)))
        {
            if marks_simulation(&cells) {
                return Err(Located::in_line(line, ContactsError::Simulated));
            }
            // One number is a remark such as a count; two are a place.
            if 2 <= more.iter().copied().chain([first.trim()]).filter(|cell| number(cell).is_some()).count() {
                return Err(at_cell(line, 0, ContactsError::Comment));
            }
            in_mm(&row, line)?;
            let text = row.join(" ");
            read.take_temperature(&text, warmth::mentioned(&text));
            continue;
        }
        if !is_header(&row) {
            same_sign(&row, line, &mut decimal_sign)?;
        }
        match places {
            Some(_) if read.contacts.is_empty() && stated::are_units(row.iter().copied()) => in_mm(&row, line)?,
            Some(places) => {
                if let Some(cell) = unit.and_then(|at| row.get(at)) {
                    in_mm(&[*cell], line)?;
                }
                if let Some((at, (name, scale))) = &warm
                    && let Some(cell) = row.get(*at)
                {
                    read.take_temperature(&format!("{name} {cell}"), warmth::read(cell, *scale));
                }
                read.contacts.push(contact(&row, places, line)?);
            }
            None if is_header(&row) => {
                places = Some(header(&row, line, &mut read.ignored)?);
                unit = row.iter().position(|name| stated::names_units(name));
                let of_column =
                    |(at, name): (usize, &&str)| Some((at, ((*name).to_owned(), warmth::of_column(name)?.scale)));
                warm = row.iter().enumerate().find_map(of_column);
                read.ignored.retain(|name| warm.as_ref().is_none_or(|(_, (warm, _))| warm != name));
            }
            None => {
                let found = Places {
                    x: 0,
                    y: 1,
                    z: (2 < row.len()).then_some(2),
                    cells: row.len().clamp(2, 3),
                    simulated: None,
                };
                places = Some(found);
                read.contacts.push(contact(&row, found, line)?);
            }
        }
    }
    read.has_heights = places.is_some_and(|places| places.z.is_some());
    if read.contacts.is_empty() {
        return Err(Located { what: ContactsError::FileEmpty, place: FilePlace::default() });
    }
    Ok(read)
}

/// Whether a text is a list of contacts: a header x, y or rows of two or three numbers, and no callout.
pub(super) fn are_contacts(text: &str) -> bool {
    SEPARATORS.iter().any(|&separator| {
        let sample = Sample::of(text, 1, Some(separator));
        let Some((_, first)) = sample.rows.first() else { return false };
        let names: Vec<String> = first.iter().map(words::bare).collect();
        let has = |name: &str| names.iter().any(|given| given == name);
        if has("x") && has("y") {
            // Beside a measured value and a callout, or a name that a plan knows, they are the place of a feature.
            let names = |role: Role| first.iter().any(|name| words::role(name).is_some_and(|(named, _)| named == role));
            return !(names(Role::Measured) && [Role::Tolerance, Role::Id, Role::Number].into_iter().any(names));
        }
        let is_contact = |cells: &StringRecord| {
            matches!(cells.len(), 2..=3)
                && cells.iter().all(|cell| cell.trim().replace(',', ".").parse::<f64>().is_ok())
        };
        // Most rows are enough: the reader of contacts reports one with letters.
        let contacts = sample.rows.iter().filter(|(_, cells)| is_contact(cells)).count();
        sample.header.is_none() && sample.rows.len() < contacts * 2
    })
}

/// Refuses cells that state another unit than millimetres.
fn in_mm(row: &[&str], line: usize) -> Result<(), Located<ContactsError>> {
    let refused = |given: String| Located::in_line(line, ContactsError::OtherUnit { given: shorten(&given) });
    stated::not_mm(row.iter().copied()).map_or(Ok(()), |given| Err(refused(given)))
}

/// Refuses point and comma as decimal signs in one file: one of them is a slip, and nobody can tell which.
fn same_sign(row: &[&str], line: usize, sign: &mut Option<char>) -> Result<(), Located<ContactsError>> {
    for (at, cell) in row.iter().enumerate().filter(|(_, cell)| number(cell).is_some()) {
        let Some(own) = cell.chars().find(|c| ['.', ','].contains(c)) else { continue };
        if *sign.get_or_insert(own) != own {
            return Err(at_cell(line, at, ContactsError::MixedSigns { given: (*cell).to_owned() }));
        }
    }
    Ok(())
}

/// The separator of the first line that has one; a blank is not a separator.
fn separator(text: &str) -> u8 {
    let lines = fitcheck_core::text::lines(text)
        .map(|(_, line)| line.trim())
        .filter(|line| !line.is_empty() && !line.starts_with('#'));
    let mut lines = lines.take(20);
    lines
        .find_map(|line| SEPARATORS.iter().copied().find(|separator| line.bytes().any(|byte| byte == *separator)))
        .unwrap_or(b',')
}

/// Whether a row is a header: one of its cells begins with x or y, and no cell is a number.
fn is_header(row: &[&str]) -> bool {
    let begins = |cell: &&str| cell.starts_with(['x', 'y', 'X', 'Y']);
    row.iter().any(begins) && row.iter().all(|cell| number(cell).is_none())
}

/// `X`, `x [mm]` and `x_mm` are x; `x [inch]` and `x_nominal` are something else.
fn name(cell: &str) -> Option<char> {
    let letters = |c: &char| !"[]()_".contains(*c) && !c.is_whitespace();
    let bare: String = cell.chars().filter(letters).collect::<String>().to_ascii_lowercase();
    match bare.as_str() {
        "x" | "xmm" => Some('x'),
        "y" | "ymm" => Some('y'),
        "z" | "zmm" => Some('z'),
        _ => None,
    }
}

fn header(row: &[&str], line: usize, ignored: &mut Vec<String>) -> Result<Places, Located<ContactsError>> {
    let place = |wanted| {
        let mut places = (0..).zip(row).filter(|(_, cell)| name(cell) == Some(wanted)).map(|(at, _)| at);
        match (places.next(), places.next()) {
            (Some(first), Some(second)) => {
                let twice = ContactsError::Twice { name: wanted, first: first + 1, second: second + 1 };
                Err(Located::in_line(line, twice))
            }
            (place, _) => Ok(place),
        }
    };
    let (Some(x), Some(y)) = (place('x')?, place('y')?) else {
        return Err(Located::in_line(line, ContactsError::NoColumns { given: shorten(&row.join(", ")) }));
    };
    let says =
        |cell: &str| words::is_origin(cell) || words::role(cell).is_some_and(|(role, _)| role == Role::Simulated);
    ignored.extend(row.iter().filter(|cell| name(cell).is_none() && !says(cell)).map(|cell| (*cell).to_owned()));
    let simulated = row.iter().position(|cell| says(cell));
    Ok(Places { x, y, z: place('z')?, cells: row.len(), simulated })
}

fn contact(row: &[&str], places: Places, line: usize) -> Result<Contact, Located<ContactsError>> {
    if row.len() != places.cells {
        let given = shorten(&row.join(", "));
        let cells = ContactsError::Cells { cells: row.len(), wanted: places.cells, given };
        return Err(Located::in_line(line, cells));
    }
    if let Some((at, text)) = places.simulated.and_then(|at| Some((at, *row.get(at)?))) {
        match evidence::yes_or_no(text).or_else(|| evidence::is_simulated(text)) {
            Some(false) => {}
            Some(true) => return Err(at_cell(line, at, ContactsError::Simulated)),
            None => return Err(at_cell(line, at, ContactsError::Origin { given: shorten(text) })),
        }
    }
    let coordinate = |name: char, at: usize| {
        let cell = row.get(at).map_or("", |cell| *cell);
        number(cell).ok_or_else(|| {
            let given = if cell.is_empty() { "empty".to_owned() } else { shorten(cell) };
            at_cell(line, at, ContactsError::NotANumber { name, given })
        })
    };
    Ok(Contact {
        x: coordinate('x', places.x)?,
        y: coordinate('y', places.y)?,
        z: places.z.map_or(Ok(0.0), |at| coordinate('z', at))?,
    })
}

/// An error in a cell of a row, counted from 0.
fn at_cell(line: usize, at: usize, what: ContactsError) -> Located<ContactsError> {
    Located { what, place: FilePlace { column: Some(at + 1), ..FilePlace::line(line) } }
}

/// A finite decimal number with point or comma. Words such as `nan` and `inf` are not numbers.
fn number(cell: &str) -> Option<f64> {
    let plain = cell.replace(',', ".").replace('\u{2212}', "-");
    let figures = plain.bytes().all(|byte| byte.is_ascii_digit() || b"+-.eE".contains(&byte));
    let begins = plain.trim_start_matches(['+', '-']).starts_with(|c: char| c.is_ascii_digit() || c == '.');
    if !figures || !begins || 1 < cell.bytes().filter(|byte| b".,".contains(byte)).count() {
        return None;
    }
    plain.parse().ok().filter(|value: &f64| value.is_finite())
}
