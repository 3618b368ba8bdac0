//! The answer for people.

use super::found::figure;
use crate::budget::{Answer, Assessment, Conditions, ContributionRow, Evaluation, Geometry, Help, Repeated, Validity};
use crate::cli::Io;

/// The longest name that sets the width of its column.
const WIDEST: usize = 40;

pub(super) fn print(found: &Assessment, conditions: &Conditions, io: &mut Io<'_>) {
    let budget = &found.budget;
    let valid = match found.validity {
        Validity::Valid => "",
        Validity::Expired => ", EXPIRED",
        Validity::NotYet => ", NOT YET VALID",
    };
    writeln!(io.people(), "{}", budget.name);
    writeln!(io.people(), "created {} by {}, valid until {}{valid}", budget.date, budget.by, budget.valid_until);
    if let Some(size) = conditions.size {
        writeln!(io.people(), "for {size} mm");
    }
    writeln!(io.people());
    match &found.answer {
        Answer::Combined(evaluation) => table(evaluation, io),
        Answer::Repeated(repeated) => readings(repeated, io),
    }
    writeln!(io.people());
    writeln!(io.people(), "u     {:.3} µm", found.u());
    if let Answer::Combined(evaluation) = &found.answer {
        writeln!(io.people(), "veff  {}", degrees(evaluation.degrees_of_freedom));
        writeln!(io.people(), "k     {} for 95.45 %", figure(found.k(), 3));
    } else {
        writeln!(io.people(), "k     {} by {}", figure(found.k(), 3), found.method());
    }
    writeln!(io.people(), "U     {:.3} µm", found.expanded());
    if let Answer::Combined(evaluation) = &found.answer {
        helps(evaluation, io);
    }
}

fn degrees(degrees: Option<f64>) -> String {
    degrees.map_or_else(|| "infinite".to_owned(), |degrees| figure(degrees, 1))
}

fn table(evaluation: &Evaluation, io: &mut Io<'_>) {
    let names = evaluation.rows.iter().map(|row| row.name.chars().count());
    let width = names.fold(0, usize::max).clamp("contribution".len(), WIDEST);
    let units =
        evaluation.rows.iter().map(|row| row.unit.chars().count()).fold(0, usize::max).max("µm".chars().count());
    writeln!(
        io.people(),
        "{:<width$}  type  law          {:>10} {:<units$}  {:>10}  {:>9}  {:>7}  degrees of freedom",
        "contribution",
        "u",
        "",
        "c",
        "c·u µm",
        "share",
    );
    for row in &evaluation.rows {
        let ContributionRow { name, u, unit, sensitivity, contribution, share, .. } = row;
        let letter = row.evaluated.letter();
        let law = row.law.name();
        let freedom = degrees(row.degrees_of_freedom);
        writeln!(
            io.people(),
            "{name:<width$}  {letter:<4}  {law:<11}  {u:>10.3} {unit:<units$}  {sensitivity:>10.4}  {contribution:>9.3}  {share:>5.1} %  {freedom}",
        );
    }
    for (row, geometry) in evaluation.rows.iter().filter_map(|row| Some((row, row.geometry?))) {
        let Geometry { touches, step_deg, factor } = geometry;
        let step = step_deg.map_or_else(String::new, |step| format!(" at {}°", figure(step, 3)));
        writeln!(io.people(), "{}: {touches} contacts{step}, factor {factor:.3}", row.name);
    }
}

fn readings(repeated: &Repeated, io: &mut Io<'_>) {
    writeln!(io.people(), "{} readings, mean {:.6} mm", repeated.readings, repeated.mean_mm);
    for (name, um) in repeated.terms() {
        writeln!(io.people(), "{name:<5} {um:>8.3} µm");
    }
    writeln!(io.people(), "U by ISO 15530-3:2011, bias corrected         {:.3} µm", repeated.expanded_2011);
    writeln!(io.people(), "U by ISO/TS 15530-3:2004, bias not corrected  {:.3} µm", repeated.expanded_2004);
}

fn helps(evaluation: &Evaluation, io: &mut Io<'_>) {
    let Some(row) = evaluation.rows.get(evaluation.largest) else { return };
    writeln!(io.people());
    writeln!(io.people(), "largest contribution: {}, {:.1} % of the variance", row.name, row.share);
    for help in &evaluation.help {
        match *help {
            Help::Halved { u } => writeln!(io.people(), "  with half of it: u = {u:.3} µm"),
            Help::FullCircle { touches, u } | Help::MoreTouches { touches, u } => {
                writeln!(io.people(), "  {touches} contacts evenly spaced around the full circle: u = {u:.3} µm");
            }
        }
    }
}
