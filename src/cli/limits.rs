//! `fitcheck limits`: limits of size of one callout or of a stream of them.

use super::answers::{Answerer, Answers, CalloutInput};
use super::people::mm;
use super::{CliError, Figure, Format, Io, Outcome, TableArgs};
use crate::probing::noted;
use crate::tolerance::{Callout, Deviations, Feature, Limits, Sources, Tolerance};

const EXAMPLES: &str = "\
Examples:
  fitcheck limits \"25 H7\"                        one callout, for people
  fitcheck limits \"25 H7\" \"25 g6\" --format csv   several, for a spreadsheet
  fitcheck limits - --format csv < callouts.txt  one callout per line, one answer per line
  fitcheck limits \"25 PF\" --tables my_tables     with your own control tables and a column PF
  fitcheck limits \"25 H7/g6\" 10m \"12 ±0.02\"     a fit (hole, then shaft), ISO 2768-1, deviations

Columns of CSV and names in JSON: callout, nominal_mm, lower_um, upper_um, min_mm, max_mm, source, error.
A refused callout has no values and a reason in error, and the exit code is 1.";

/// Show the limits of size of callouts such as "25 H7"
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// "25 H7", "25 H7/g6", "10m", "12 +0.01 -0.015", "12.01/11.985"; - reads one per line from standard input
    #[arg(value_name = "CALLOUT", required = true)]
    callouts: Vec<String>,

    /// Format of the answer
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,

    #[command(flatten)]
    tables: TableArgs,
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let sources = self.tables.load(io)?;
        let all_answered = Answers::print((self.format, false), &self.callouts, &mut LimitsOf(&sources), io)?;
        Ok(if all_answered { Outcome::Done } else { Outcome::BadData })
    }
}

/// Answers with limits of size.
struct LimitsOf<'a>(&'a Sources);

row! {
    /// A line of CSV or a JSON object.
    #[derive(Default)]
    struct LimitsRow<'a> of(callout: &'a str, limits: &Limits) {
        callout: &'a str = callout,
        nominal_mm: Option<Figure> = Some(Figure::mm(limits.nominal, 0)),
        lower_um: Option<Figure> = Some(Figure::um(limits.deviations.lower())),
        upper_um: Option<Figure> = Some(Figure::um(limits.deviations.upper())),
        min_mm: Option<Figure> = Some(Figure::mm(limits.minimum(), 3)),
        max_mm: Option<Figure> = Some(Figure::mm(limits.maximum(), 3)),
        source: Option<String> = Some(limits.source.with_difference()),
        error: Option<String> = None,
    }
}

/// `0 / +21`
pub(super) fn lower_and_upper(deviations: &Deviations) -> String {
    format!("{} / {}", deviations.lower().signed_um(), deviations.upper().signed_um())
}

impl Answerer for LimitsOf<'_> {
    type AnswerRow<'a> = LimitsRow<'a>;

    fn answer(&mut self, asked: CalloutInput<'_>, answers: &mut Answers, io: &mut Io<'_>) {
        let callout: Callout = match asked.callout.parse() {
            Ok(callout) => callout,
            Err(error) => return answers.refuse::<Self>(asked, &error, io),
        };
        if !matches!(callout.tolerance(), Tolerance::Fit { .. }) {
            return self.answer_part(asked, callout, answers, io);
        }
        // A fit is two sizes: the hole's answer, then the shaft's.
        for feature in [Feature::Hole, Feature::Shaft] {
            let part = callout.of_part(feature);
            self.answer_part(CalloutInput { callout: &part.to_string(), ..asked }, part, answers, io);
        }
    }

    fn refused(callout: &str, error: String) -> LimitsRow<'_> {
        LimitsRow { callout, error: Some(error), ..LimitsRow::default() }
    }
}

impl LimitsOf<'_> {
    fn answer_part(&self, asked: CalloutInput<'_>, callout: Callout, answers: &mut Answers, io: &mut Io<'_>) {
        match self.0.limits(&callout, None) {
            Err(error) => answers.refuse::<Self>(asked, &error, io),
            Ok(limits) => {
                if let Some(doubt) = self.0.zone_doubt(&callout, &limits) {
                    io.warn_about(&callout, &doubt);
                }
                if let Some(differs) = noted::differing(callout.notes(), &limits) {
                    io.warn_about(&callout, &differs);
                }
                if !answers.is_text() {
                    return answers.figures(&LimitsRow::of(asked.callout, &limits), io);
                }
                answers.text(|io, _| write_text(&callout, &limits, io), io);
            }
        }
    }
}

/// `25 H7   hole   25.000 … 25.021   mm   (0 / +21 µm)   from …`: the callout as it was understood.
fn write_text(callout: &Callout, limits: &Limits, io: &mut Io<'_>) {
    let minimum = mm(limits.minimum());
    let maximum = mm(limits.maximum());
    let range = format!("{minimum:>8} … {maximum} mm");
    let deviations = format!("({} µm)", lower_and_upper(&limits.deviations));
    let feature = callout.feature().map_or("–", Feature::word);
    let source = limits.source.with_difference();
    writeln!(io.people(), "{callout:<10}  {feature:<5}  {range:<22}  {deviations:<18}  from {source}");
}
