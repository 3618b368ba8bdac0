//! `fitcheck fit`: a hole and a shaft, and the way back from a clearance to classes.
//!
//! | file | what |
//! |---|---|
//! | `answer` | the answer for one fit |
//! | `figures` | the same in figures |
//! | `text` | the same for people |
//! | `heat` | materials and temperatures |
//! | `line` | a named line of an answer |
//! | `press` | press fits |
//! | `reverse` | from a wanted clearance or a function to classes |
//!
//! Callouts are answered one by one, so that memory stays the same however many come.

mod answer;
mod figures;
mod heat;
mod line;
mod press;
mod reverse;
mod text;

use answer::Answer;
use figures::Figures;

use super::answers::{Answerer, Answers, CalloutInput};
use super::{CliError, ErrorSubject, Format, IntoCliError as _, Io, Outcome, TableArgs, diameter};
use crate::length::Length;
use crate::tolerance::Sources;
use crate::verdict::{Status, doubt};

const HELP: &str = "\
Examples:
  fitcheck fit \"50 H7/p6\"                                 clearance, kind, basis, other basis
  fitcheck fit \"50 H7/p6\" --hole 50.010 --shaft 50.030    two measured parts, or one alone
  fitcheck fit \"50 H7/p6\" --hole-material brass --shaft-material steel --temperature 80
  fitcheck fit \"50 H7/p6\" --hole-material steel --shaft-material steel --hole-temperature 220
  fitcheck fit \"40 H7/s6\" --press --length 30 --hub-outer 80        what a press fit holds
  fitcheck fit 25 --min-clearance 0.007 --max-clearance 0.041     classes for a clearance
  fitcheck fit 25 --function sliding --format json
  fitcheck fit - --format csv < fits.txt                  one fit per line

A clearance is hole minus shaft; a negative value is an interference. Measured diameters are those
at 20 °C.

JSON of one fit is an object, of several or of - an array:
  callout, nominal_mm, kind (clearance, transition, interference), minimum_clearance_um,
    maximum_clearance_um, mean_clearance_um, basis (hole, shaft, both),
    preferred (hole basis, shaft basis), function, error
  hole, shaft   class, min_mm, max_mm, lower_um, upper_um, source
  equivalent    the fit in the other basis: callout, exact, minimum_clearance_um,
                maximum_clearance_um, error
  actual        two measured parts: hole_mm, shaft_mm, clearance_um, conforms, hole_status,
                shaft_status, hole_remove_um, shaft_remove_um
  possible      one measured part: feature, measured_mm, status, remove_um,
                minimum_clearance_um, maximum_clearance_um
  temperature   hole_c, shaft_c, change_um, minimum_clearance_um, maximum_clearance_um, kind,
                actual_clearance_um, hole_material and shaft_material with name,
                expansion_um_per_m_k, certainty, source
  press         length_mm, hub_outer_mm, shaft_inner_mm, friction, minimum_interference_um,
                maximum_interference_um, smoothing_um, minimum_pressure_mpa, maximum_pressure_mpa,
                axial_force_n, torque_nm, pressing_force_n, elastic (yes, no, unknown),
                hub_stress_mpa, hub_tangential_mpa, hub_yield_mpa, shaft_stress_mpa,
                shaft_tangential_mpa, shaft_yield_mpa, joining_play_um, heat_hub_c, cool_shaft_c,
                hub_material, shaft_material
JSON of a search:
  nominal_mm, minimum_clearance_um, maximum_clearance_um, scope, function, total
  candidates    callout, hole, shaft, kind, minimum_clearance_um, maximum_clearance_um, basis,
                preferred, function
  nearest       if nothing fits: candidate, below_um, above_um
Values that do not exist are null. CSV has the same names, with _ between the levels.

Exit codes: that of the worse measured part: 0 good, 10 rework, 11 scrap, 14 look
first (see fitcheck --help); 1 bad data, 2 wrong usage. A search that finds nothing names the nearest miss and ends with 0.";

/// Show the fit of a hole and a shaft such as "25 H7/g6", or find classes for a clearance
#[derive(Debug, clap::Args)]
#[command(after_help = HELP)]
pub(super) struct Args {
    /// "25 H7/g6"; - reads one per line from standard input; for a search, only the nominal size, "25"
    #[arg(value_name = "CALLOUT|SIZE", required = true, allow_negative_numbers = true)]
    callouts: Vec<String>,

    /// Measured diameter of the hole in mm
    #[arg(long, value_name = "MM", allow_hyphen_values = true)]
    hole: Option<String>,

    /// Measured diameter of the shaft in mm
    #[arg(long, value_name = "MM", allow_hyphen_values = true)]
    shaft: Option<String>,

    #[command(flatten)]
    heat: heat::HeatArgs,

    #[command(flatten)]
    press: press::PressArgs,

    #[command(flatten)]
    reverse: reverse::ReverseArgs,

    /// Format of the answer
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,

    #[command(flatten)]
    tables: TableArgs,
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let sources = self.tables.load(io)?;
        if self.reverse.is_asked() {
            if self.hole.is_some() || self.shaft.is_some() || self.heat.is_asked() || self.press.is_asked() {
                return Err(CliError::SearchWithParts);
            }
            return self.reverse.run(&self.callouts, &sources, self.format, io);
        }
        let part = |text: &Option<String>, what| text.as_ref().map(|text| diameter(text, what)).transpose();
        let hole = part(&self.hole, ErrorSubject::MeasuredHole)?;
        let shaft = part(&self.shaft, ErrorSubject::MeasuredShaft)?;
        let is_one = matches!(self.callouts.as_slice(), [one] if one != "-");
        if !is_one && (hole.is_some() || shaft.is_some()) {
            return Err(CliError::PartsOfSeveral);
        }
        let heat = self.heat.load(self.press.is_asked())?;
        let press = self.press.load(&self.heat)?;
        for doubt in heat.iter().flat_map(|heat| &heat.doubts) {
            io.warn(doubt);
        }
        let given = FitInputs { sources: &sources, heat, press, hole, shaft };
        let mut fits = Fits { given, worst: None };
        let all_answered = Answers::print((self.format, is_one), &self.callouts, &mut fits, io)?;
        Ok(if all_answered { fits.worst.map_or(Outcome::Done, Outcome::Judged) } else { Outcome::BadData })
    }
}

/// What is asked about every callout.
struct FitInputs<'a> {
    sources: &'a Sources,
    heat: Option<heat::Heat>,
    press: Option<press::NamedJoint>,
    /// The measured diameters.
    hole: Option<Length>,
    shaft: Option<Length>,
}

/// Answers with fits.
struct Fits<'a> {
    given: FitInputs<'a>,
    /// The worst status of the measured parts.
    worst: Option<Status>,
}

impl Answerer for Fits<'_> {
    type AnswerRow<'a> = Figures<'a>;

    fn answer(&mut self, asked: CalloutInput<'_>, answers: &mut Answers, io: &mut Io<'_>) {
        let answer = asked.callout.parse().said().and_then(|callout| Answer::of(callout, &self.given));
        let answer = match answer {
            Ok(answer) => answer,
            Err(error) => return answers.refuse::<Self>(asked, &error, io),
        };
        self.worst = self.worst.max(answer.measured.status());
        let fit = &answer.fit;
        for (name, limits, measured) in
            [(ErrorSubject::Hole, fit.hole(), self.given.hole), (ErrorSubject::Shaft, fit.shaft(), self.given.shaft)]
        {
            if let Some(doubt) = measured.and_then(|measured| doubt(limits, measured)) {
                io.warn_about(&name, &doubt);
            }
        }
        for remark in answer.press.iter().flat_map(|(_, press)| &press.remarks) {
            io.warn_about(&answer.callout, remark);
        }
        if !answers.is_text() {
            return answers.figures(&Figures::of(asked.callout, &answer), io);
        }
        let write = |io: &mut Io<'_>, is_first: bool| {
            if !is_first {
                writeln!(io.people());
            }
            text::write(&answer, io);
        };
        answers.text(write, io);
    }

    fn refused(callout: &str, error: String) -> Figures<'_> {
        Figures::refused(callout, error)
    }
}
