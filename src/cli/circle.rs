//! `fitcheck circle`: circle evaluation by every criterion.

use std::path::PathBuf;

use serde::Serialize;

use super::{CliError, Format, Io, Outcome, Refused as _, read_contacts};
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

/// The answer for programs; its names must not change.
#[derive(Debug, Serialize)]
struct Answer<'a> {
    least_squares: LeastSquares,
    minimum_circumscribed: Circle,
    maximum_inscribed: Option<Circle>,
    minimum_zone: Option<Ring>,
    two_point: Vec<Pair>,
    contacts: usize,
    arc_deg: f64,
    residuals: &'a [f64],
    warnings: Vec<String>,
}

#[derive(Debug, Serialize)]
struct LeastSquares {
    x: f64,
    y: f64,
    diameter: f64,
    /// Largest minus smallest radial deviation.
    form: f64,
}

#[derive(Debug, Serialize)]
struct Ring {
    x: f64,
    y: f64,
    width: f64,
    outer_diameter: f64,
    inner_diameter: f64,
}

#[derive(Debug, Serialize)]
struct Pair {
    contacts: [usize; 2],
    size: f64,
    direction_deg: f64,
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
        let Circle { x, y, diameter } = evaluation.least_squares;
        let ring = |zone| {
            let Zone { x, y, width, outer_diameter, inner_diameter, .. } = zone;
            Ring { x, y, width, outer_diameter, inner_diameter }
        };
        let pair = |&TwoPoint { contacts, size, direction_deg, .. }: &TwoPoint| Pair { contacts, size, direction_deg };
        let answer = Answer {
            least_squares: LeastSquares { x, y, diameter, form: evaluation.form() },
            minimum_circumscribed: evaluation.minimum_circumscribed,
            maximum_inscribed: evaluation.maximum_inscribed,
            minimum_zone: evaluation.minimum_zone.map(ring),
            two_point: evaluation.two_point.iter().map(pair).collect(),
            contacts: contacts.len(),
            arc_deg: evaluation.arc_deg,
            residuals: &evaluation.residuals,
            warnings: evaluation.warnings.iter().map(ToString::to_string).collect(),
        };
        match self.format {
            Format::Json => io.json(&answer)?,
            Format::Csv => print_csv(&answer, io)?,
            Format::Text => print_text(&answer, &evaluation, io)?,
        }
        Ok(Outcome::Done)
    }
}

fn print_csv(answer: &Answer<'_>, io: &mut Io<'_>) -> Result<(), CliError> {
    writeln!(io.data(), "criterion,x_mm,y_mm,diameter_mm,form_mm")?;
    let LeastSquares { x, y, diameter, form } = answer.least_squares;
    writeln!(io.data(), "least_squares,{x},{y},{diameter},{form}")?;
    let Circle { x, y, diameter } = answer.minimum_circumscribed;
    writeln!(io.data(), "minimum_circumscribed,{x},{y},{diameter},")?;
    if let Some(Circle { x, y, diameter }) = answer.maximum_inscribed {
        writeln!(io.data(), "maximum_inscribed,{x},{y},{diameter},")?;
    }
    if let Some(Ring { x, y, width, .. }) = answer.minimum_zone {
        writeln!(io.data(), "minimum_zone,{x},{y},,{width}")?;
    }
    for Pair { size, .. } in &answer.two_point {
        writeln!(io.data(), "two_point,,,{size},")?;
    }
    Ok(())
}

fn print_text(answer: &Answer<'_>, evaluation: &Evaluation, io: &mut Io<'_>) -> Result<(), CliError> {
    let mut row = |name: &str, circle: Option<Circle>, form: Option<f64>| {
        let form = form.map(|form| format!("   form {form:.4}")).unwrap_or_default();
        match circle {
            Some(Circle { x, y, diameter }) => {
                writeln!(io.people(), "{name:<24}Ø {diameter:>12.6}   centre {x:>13.6} {y:>13.6}{form}")
            }
            None => writeln!(io.people(), "{name:<24}does not exist for these contacts"),
        }
    };
    row("least squares", Some(evaluation.least_squares), Some(answer.least_squares.form))?;
    row("minimum circumscribed", Some(answer.minimum_circumscribed), None)?;
    row("maximum inscribed", answer.maximum_inscribed, None)?;
    match &answer.minimum_zone {
        Some(Ring { x, y, width, .. }) => {
            let name = "minimum zone";
            writeln!(io.people(), "{name:<24}roundness {width:.6}   centre {x:.6} {y:.6}")?;
        }
        None => writeln!(io.people(), "minimum zone            does not exist for these contacts")?,
    }
    for Pair { contacts: [one, other], size, direction_deg } in &answer.two_point {
        writeln!(io.people(), "two-point {one} - {other}   {size:.6}   at {direction_deg:.1}°")?;
    }
    writeln!(io.people(), "{} contacts over {:.1}°, millimetres", answer.contacts, answer.arc_deg)?;
    Ok(())
}
