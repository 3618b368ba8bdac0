//! `fitcheck circle`: circle evaluation by every criterion.

use std::path::PathBuf;

use super::{CliError, Format, IntoCliError as _, Io, Outcome, read_contacts};
use crate::exchange::contacts::Contacts;
use crate::probing::Circle;
use crate::probing::circle::{Evaluation, TwoPoint, Zone, evaluate};
use crate::tolerance::fit::thermal::Temperature;

const EXAMPLES: &str = "Examples:
  fitcheck circle bore.csv
  fitcheck circle bore.csv --format json
  printf 'x,y\\n12.5,0\\n0,12.5\\n-12.5,0\\n' | fitcheck circle -

The file has columns x, y and optionally z in millimetres, with or without a header. The answer is in
millimetres and degrees; maximum_inscribed is null if the contacts do not surround a circle.";

/// Evaluate a circle by every criterion: least squares, circumscribed, inscribed, minimum zone, two-point
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// CSV file of contacts; - reads standard input
    #[arg(value_name = "CONTACTS.csv")]
    file: PathBuf,
    /// Format of the result
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

object! {
    /// The answer for programs.
    struct Answer<'a> of(evaluation: &'a Evaluation, contacts: usize) {
        least_squares: LeastSquares = LeastSquares::of(evaluation),
        minimum_circumscribed: Circle = evaluation.minimum_circumscribed,
        maximum_inscribed: Option<Circle> = evaluation.maximum_inscribed,
        minimum_zone: Option<Ring> = evaluation.minimum_zone.as_ref().map(Ring::of),
        two_point: Vec<Pair> = evaluation.two_point.iter().map(Pair::of).collect(),
        contacts: usize = contacts,
        arc_deg: f64 = evaluation.arc_deg,
        residuals: &'a [f64] = &evaluation.residuals,
        warnings: Vec<String> = evaluation.warnings.iter().map(ToString::to_string).collect(),
    }

    /// The form is the largest minus the smallest radial deviation.
    struct LeastSquares of(evaluation: &Evaluation) {
        x: f64 = evaluation.least_squares.x,
        y: f64 = evaluation.least_squares.y,
        diameter: f64 = evaluation.least_squares.diameter,
        form: f64 = evaluation.form(),
    }

    struct Ring of(zone: &Zone) {
        x: f64 = zone.x,
        y: f64 = zone.y,
        width: f64 = zone.width,
        outer_diameter: f64 = zone.outer_diameter,
        inner_diameter: f64 = zone.inner_diameter,
    }

    struct Pair of(pair: &TwoPoint) {
        contacts: [usize; 2] = pair.contacts,
        size: f64 = pair.size,
        direction_deg: f64 = pair.direction_deg,
    }
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let (name, Contacts { contacts, .. }) = read_contacts(&self.file, Temperature::REFERENCE, io)?;
        let evaluation = evaluate(&contacts).about(&name)?;
        if self.format != Format::Json {
            for warning in &evaluation.warnings {
                io.warn(warning);
            }
        }
        let answer = Answer::of(&evaluation, contacts.len());
        match self.format {
            Format::Json => io.json(&answer),
            Format::Csv => print_csv(&answer, io),
            Format::Text => print_text(&answer, &evaluation, io),
        }
        Ok(Outcome::Done)
    }
}

fn print_csv(answer: &Answer<'_>, io: &mut Io<'_>) {
    writeln!(io.data(), "criterion,x_mm,y_mm,diameter_mm,form_mm");
    let LeastSquares { x, y, diameter, form } = answer.least_squares;
    writeln!(io.data(), "least_squares,{x},{y},{diameter},{form}");
    let Circle { x, y, diameter } = answer.minimum_circumscribed;
    writeln!(io.data(), "minimum_circumscribed,{x},{y},{diameter},");
    if let Some(Circle { x, y, diameter }) = answer.maximum_inscribed {
        writeln!(io.data(), "maximum_inscribed,{x},{y},{diameter},");
    }
    if let Some(Ring { x, y, width, .. }) = answer.minimum_zone {
        writeln!(io.data(), "minimum_zone,{x},{y},,{width}");
    }
    for Pair { size, .. } in &answer.two_point {
        writeln!(io.data(), "two_point,,,{size},");
    }
}

fn print_text(answer: &Answer<'_>, evaluation: &Evaluation, io: &mut Io<'_>) {
    let mut row = |name: &str, circle: Option<Circle>, form: Option<f64>| {
        let form = form.map_or_else(String::new, |form| format!("   form {form:.4}"));
        match circle {
            Some(Circle { x, y, diameter }) => {
                writeln!(io.people(), "{name:<24}Ø {diameter:>12.6}   centre {x:>13.6} {y:>13.6}{form}");
            }
            None => writeln!(io.people(), "{name:<24}does not exist for these contacts"),
        }
    };
    row("least squares", Some(evaluation.least_squares), Some(answer.least_squares.form));
    row("minimum circumscribed", Some(answer.minimum_circumscribed), None);
    row("maximum inscribed", answer.maximum_inscribed, None);
    match &answer.minimum_zone {
        Some(Ring { x, y, width, .. }) => {
            let name = "minimum zone";
            writeln!(io.people(), "{name:<24}roundness {width:.6}   centre {x:.6} {y:.6}");
        }
        None => writeln!(io.people(), "minimum zone            does not exist for these contacts"),
    }
    for Pair { contacts: [one, other], size, direction_deg } in &answer.two_point {
        writeln!(io.people(), "two-point {one} - {other}   {size:.6}   at {direction_deg:.1}°");
    }
    writeln!(io.people(), "{} contacts over {:.1}°, millimetres", answer.contacts, answer.arc_deg);
}
