//! The report as one HTML page: no script, no external content, prints well on A4 and in black and white.
//!
//! The templates are in `assets/report`, their look `report.css` and `guard.css`; every value is escaped by them. This file puts figures
//! into words and decides nothing. The page is also well-formed XML, so other tools can read it.
//!
//! A check takes some kilobytes with its pictures, and a browser shows only so much. So a page lists at most
//! [`MOST_CHECKS`]: of a longer report those that are not good or in doubt. The counts are always those of all checks.
//! The page is written check by check, and only one of them is in memory.

pub(super) mod part;

use std::io::{self, Write};

use askama::Template;

use fitcheck_core::length::{Length, Unit};
use fitcheck_core::message::message;
use fitcheck_core::probing::{Circle, Contact};
use fitcheck_core::verdict::{Removal, Status};
use fitcheck_core::words::Words;

use super::changes::Changes;
use super::head::{self, DATE};
use super::origins::{self, Entry};
use super::part::PartSheet;
use super::said::{cause, decimals_of, nearest, title, undecided};
use super::seen::ReportSurvey;
use super::statistics::{self, FeatureStatistics};
use super::template::{Company, Section as Shown};
use super::told::printable;
use super::{Holds, Rendering, Report, picture, text};
use crate::journal::Record;

pub const RENDERING: Rendering = Rendering {
    name: "html",
    title: "HTML",
    is_for_people: true,
    holds: Holds::ReportAndStatistics,
    endings: &["html", "htm"],
    render,
};

/// The most checks that a page lists: some 15 MB, which a browser opens in seconds.
pub const MOST_CHECKS: usize = 2_000;

/// A longer list of contacts goes to the end of the report, so that a check fits on a page and is never split.
const CONTACTS_IN_CHECK: usize = 16;

/// The parts of the page.
trait Part: Template {
    fn words(&self) -> &Words;

    fn t(&self, id: &str) -> String {
        self.words().get(id)
    }

    /// Writes it on a line of its own.
    fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let text = self.render().map_err(io::Error::other)?;
        out.write_all(printable(text.trim_matches('\n')).as_bytes())?;
        out.write_all(b"\n")
    }
}

/// Who stands at the top of the page.
struct CompanyView {
    name: String,
    address: Vec<String>,
    /// The address of the logo, or why there is none.
    logo: Option<String>,
    no_logo: Option<String>,
}

/// Up to what the report is about.
#[derive(Template)]
#[template(path = "head.html", config = "../../assets/report/askama.toml")]
struct Head<'a> {
    words: &'a Words,
    title: String,
    company: Option<CompanyView>,
    entries: Vec<Entry>,
    /// Whether a check has guard bands, which have their own look.
    has_guards: bool,
    /// Whether it is about whole parts, and whether these have pictures.
    has_parts: bool,
    has_pictures: bool,
    program: &'a str,
}

/// A whole part.
#[derive(Template)]
#[template(path = "part.html", config = "../../assets/report/askama.toml")]
struct PartSection<'a> {
    words: &'a Words,
    part: part::PartView,
}

/// The statistics of a feature.
#[derive(Template)]
#[template(path = "statistics.html", config = "../../assets/report/askama.toml")]
struct StatisticsSection<'a> {
    words: &'a Words,
    feature: FeatureStatistics,
}

/// Notes and counts, up to the head of the list of checks.
#[derive(Template)]
#[template(path = "notes.html", config = "../../assets/report/askama.toml")]
struct Notes<'a> {
    words: &'a Words,
    /// What changed since an earlier report, below the sentence that says so.
    changes: Option<(String, Vec<String>)>,
    told: Vec<String>,
    summary: Option<Summary>,
}

/// A check in the list.
#[derive(Template)]
#[template(path = "overview.html", config = "../../assets/report/askama.toml")]
struct Line<'a> {
    words: &'a Words,
    check: &'a Check,
}

/// A check with everything about it.
#[derive(Template)]
#[template(path = "check.html", config = "../../assets/report/askama.toml")]
struct Section<'a> {
    words: &'a Words,
    check: &'a Check,
}

/// A long list of contacts.
#[derive(Template)]
#[template(path = "annex.html", config = "../../assets/report/askama.toml")]
struct Annex<'a> {
    words: &'a Words,
    check: &'a Check,
}

/// The signature, and the end.
#[derive(Template)]
#[template(path = "foot.html", config = "../../assets/report/askama.toml")]
struct Foot<'a> {
    words: &'a Words,
    /// What whoever signs says of the rule, and the statement of conformity, where the template has them.
    said: Vec<String>,
    inspector: &'a str,
}

/// Each part has the words of the page.
macro_rules! parts {
    ($($part:ident),+) => {$(
        impl Part for $part<'_> {
            fn words(&self) -> &Words {
                self.words
            }
        }
    )+};
}

parts!(Head, PartSection, StatisticsSection, Notes, Line, Section, Annex, Foot);

struct Summary {
    counts: Vec<Count>,
    total: usize,
}

struct Count {
    word: String,
    count: usize,
}

struct Check {
    number: usize,
    heading: String,
    /// The heading in the summary.
    short: String,
    feature: String,
    id: String,
    time: String,
    word: String,
    /// The word where nobody measured.
    simulated: Option<String>,
    sign: String,
    reason: String,
    /// The reason where the centre's position overrules the size.
    cause: Option<String>,
    /// Why nothing is decided.
    undecided: Option<String>,
    doubt: Option<String>,
    band: String,
    nominal: String,
    sizes: [Size; 3],
    removals: Vec<RemovalLine>,
    position: String,
    axes: Vec<String>,
    centre: Option<String>,
    caveats: Vec<String>,
    origins: Vec<Entry>,
    contacts: Vec<ContactLine>,
    contacts_at_end: bool,
}

struct Size {
    label: String,
    mm: String,
    um: String,
    measured: bool,
}

struct RemovalLine {
    label: String,
    diameter: String,
    side: String,
}

struct ContactLine {
    number: usize,
    axes: [String; 3],
    radial: String,
}

fn render(report: &Report, words: &Words, out: &mut dyn Write) -> io::Result<()> {
    let seen = ReportSurvey::of(report, MOST_CHECKS)?;
    let head = Head {
        words,
        title: title(report, words),
        company: company(report, words),
        entries: head::whole(report, &seen, words),
        has_guards: 0 < seen.guarded,
        has_parts: !report.parts.is_empty(),
        has_pictures: part::have_pictures(&report.parts) || has_logo(report),
        program: &report.program,
    };
    head.write(out)?;
    let mut parts = part::PartViews::default();
    for part in &report.parts {
        PartSection { words, part: parts.view(part, words).map_err(io::Error::other)? }.write(out)?;
    }
    for feature in statistics::of(report, words)? {
        StatisticsSection { words, feature }.write(out)?;
    }
    let said =
        |changes: &Changes| (words.say(&changes.heading()), changes.lines.iter().map(|line| words.say(line)).collect());
    let notes = Notes {
        words,
        changes: seen.changes.as_ref().map(said),
        told: seen.note(words).into_iter().chain(report.notes.iter().map(|note| words.say(note))).collect(),
        summary: (1 < seen.total).then(|| summary(&seen, &report.parts, words)),
    };
    if notes.changes.is_some() || !notes.told.is_empty() || notes.summary.is_some() {
        notes.write(out)?;
    }
    let made = |number, record: &Record| check(number, record, words).map_err(io::Error::other);
    if 1 < seen.total {
        seen.each(report, &mut |number, record| Line { words, check: &made(number, record)? }.write(out))?;
        out.write_all(b"</tbody>\n</table>\n</section>\n")?;
    }
    if seen.total == 0 && !report.is_of_series(seen.total) {
        writeln!(out, "<p>{}</p>", words.get("report-no-checks"))?;
    }
    seen.each(report, &mut |number, record| Section { words, check: &made(number, record)? }.write(out))?;
    if CONTACTS_IN_CHECK < seen.contacts {
        seen.each(report, &mut |number, record| {
            if record.measurement.contacts.len() <= CONTACTS_IN_CHECK {
                return Ok(());
            }
            Annex { words, check: &made(number, record)? }.write(out)
        })?;
    }
    Foot { words, said: closing(report, &seen, words), inspector: report.inspector.as_deref().unwrap_or("") }.write(out)
}

fn company(report: &Report, words: &Words) -> Option<CompanyView> {
    let Company { name, address, .. } = report.template.company.clone();
    let (logo, no_logo) = match &report.template.logo {
        Some(Ok(image)) => (Some(image.address()), None),
        Some(Err(why)) => (None, Some(words.say(why))),
        None => (None, None),
    };
    let is_there = !name.is_empty() || !address.is_empty() || logo.is_some() || no_logo.is_some();
    is_there.then_some(CompanyView { name, address, logo, no_logo })
}

fn has_logo(report: &Report) -> bool {
    matches!(report.template.logo, Some(Ok(_)))
}

/// What stands above the signature: in the words of whoever signs, and the statement of conformity, where the template has them.
pub(super) fn closing(report: &Report, seen: &ReportSurvey, words: &Words) -> Vec<String> {
    let rule = Some(report.template.rule_text.clone()).filter(|text| !text.is_empty());
    let statement = report.template.has(Shown::Statement).then(|| words.say(&seen.statement(report)));
    rule.into_iter().chain(statement).collect()
}

fn summary(seen: &ReportSurvey, parts: &[PartSheet], words: &Words) -> Summary {
    let counts = Status::ALL.into_iter().filter_map(|status| {
        let count = seen.counts.get(status.at()).map_or(0, |count| *count);
        // Nothing is re-measured without a guard band or out of limits where hole or shaft is said, so a zero would only raise questions.
        (!status.is_rare() || 0 < count).then(|| Count { word: words.told(&status), count })
    });
    // What a part lacks belongs to its sizes, too.
    let standings: Vec<_> = parts.iter().map(PartSheet::standing).collect();
    let lacks = [
        ("report-missing", standings.iter().map(|standing| standing.missing).sum::<usize>()),
        ("report-skipped", standings.iter().map(|standing| standing.skipped).sum()),
    ];
    let total = seen.total + lacks.iter().map(|(_, count)| count).sum::<usize>();
    let lacks = lacks.into_iter().filter(|(_, count)| 0 < *count);
    let counts = counts.chain(lacks.map(|(id, count)| Count { word: words.get(id), count })).collect();
    Summary { counts, total }
}

fn check(number: usize, record: &Record, words: &Words) -> askama::Result<Check> {
    let Record { limits, measurement, verdict, .. } = record;
    let status = verdict.status();
    let sizes = [limits.maximum(), limits.minimum(), measurement.diameter];
    let decimals = sizes.into_iter().map(decimals_of).fold(3, usize::max);
    let nominal = words.mm(limits.nominal, 0);
    let size = |id: &str, size: Length, measured| Size {
        label: words.get(id),
        mm: words.mm(size, decimals),
        um: words.signed_um(size.saturating_sub(limits.nominal)),
        measured,
    };
    let (heading, short) = match &record.callout {
        Some(callout) => (words.number(&callout.to_string()), words.number(&callout.to_string())),
        None => {
            (words.say(&message!("report-heading-without-callout").text("nominal", &nominal)), format!("{nominal} mm"))
        }
    };
    Ok(Check {
        number,
        heading,
        short,
        feature: words.say(&text::feature(limits.feature)),
        id: record.id.clone(),
        time: record.time.strftime(DATE).to_string(),
        word: words.told(verdict),
        simulated: measurement.origin.is_simulated().then(|| words.get("simulated")),
        sign: picture::verdict(status, words.told(verdict))?,
        reason: words.say(&text::size(&verdict.size, words)),
        cause: cause(verdict, words),
        undecided: undecided(verdict, words),
        doubt: record.doubt.map(|doubt| words.told(&doubt)),
        band: picture::band(record, decimals, words)?,
        nominal,
        sizes: [
            size("report-maximum", limits.maximum(), false),
            size("report-minimum", limits.minimum(), false),
            size("report-measured", measurement.diameter, true),
        ],
        removals: verdict.size.removal.map_or_else(Default::default, |removal| removals(removal, record, words)),
        position: words.say(&text::position(verdict.position)),
        axes: verdict.position.map_or_else(Vec::new, |position| {
            ["X", "Y"].iter().zip(&position.axes).map(|(n, a)| words.say(&text::axis(n, a, words))).collect()
        }),
        centre: measurement
            .centre
            .map(|[x, y]| words.say(&message!("report-centre").text("x", words.mm(x, 3)).text("y", words.mm(y, 3)))),
        caveats: record.caveats().iter().map(|caveat| words.told(caveat)).collect(),
        origins: origins::of(record, words),
        contacts: contacts(&measurement.contacts, measurement.circle, words),
        contacts_at_end: CONTACTS_IN_CHECK < measurement.contacts.len(),
    })
}

/// What to remove, on diameter and per side. Half a nanometre per side is rounded up, so that it is enough.
fn removals(removal: Removal, record: &Record, words: &Words) -> Vec<RemovalLine> {
    let line = |id: &str, amount: Length| RemovalLine {
        label: words.get(id),
        diameter: words.um(amount),
        side: words.um(Length::ZERO.midpoint(amount)),
    };
    vec![
        line(nearest(&record.verdict.size, removal), removal.to_limit),
        line("report-remove-to-middle", removal.to_middle),
    ]
}

fn contacts(contacts: &[Contact], circle: Option<Circle>, words: &Words) -> Vec<ContactLine> {
    let mm = |value: f64| match Length::from_mm_f64(value) {
        Ok(length) => words.number(&length.rounded(Unit::Millimetre, 4)),
        Err(error) => words.number(&error.to_string()),
    };
    let radial = |contact: &Contact, circle: Circle| {
        let distance = libm::hypot(contact.x - circle.x, contact.y - circle.y);
        picture::radial_um(distance, circle.diameter / 2.0, words)
    };
    let line = |(before, contact): (usize, &Contact)| ContactLine {
        number: before + 1,
        axes: [contact.x, contact.y, contact.z].map(mm),
        radial: circle.map_or_else(String::new, |circle| radial(contact, circle)),
    };
    contacts.iter().enumerate().map(line).collect()
}
