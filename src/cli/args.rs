//! Arguments that several subcommands share.

use std::path::PathBuf;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::error::ErrorKind;
use clap::parser::ValueSource;
use clap::{ArgMatches, Command, FromArgMatches, ValueEnum};

use super::{CliError, IntoCliError as _, Io};
use crate::control::shipped_tables;
use crate::store::tables::read_tables;
use crate::tolerance::table_edit::MakeError;
use crate::tolerance::{Base, Feature, Sources, ToleranceClass, iso286};
use crate::words::Dialogue;

/// One of several named values: clap lists the names, the program gets the value.
pub(super) fn one_of<T: Clone + Send + Sync + 'static>(
    all: impl IntoIterator<Item = T>,
    name: fn(&T) -> &'static str,
) -> impl TypedValueParser<Value = T> {
    let all: Vec<T> = all.into_iter().collect();
    let names = PossibleValuesParser::new(all.iter().map(name).collect::<Vec<_>>());
    // Unlisted names have already been refused.
    names.try_map(move |given| all.iter().find(|one| name(one) == given).cloned().ok_or(std::fmt::Error))
}

/// A language of the control's dialogue, by its code.
pub(super) fn dialogue() -> impl TypedValueParser<Value = Dialogue> {
    one_of(Dialogue::ALL, |dialogue| dialogue.code())
}

/// A source of limits, by its name; its help stands in the help of the option.
fn bases() -> impl TypedValueParser<Value = Base> {
    let names = Base::ALL.map(|base| PossibleValue::new(base.name()).help(base.help()));
    PossibleValuesParser::new(names)
        .try_map(|given| Base::ALL.into_iter().find(|base| base.name() == given).ok_or(std::fmt::Error))
}

/// How a result is printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    /// For people.
    Text,
    /// For spreadsheets and scripts: the same in every language.
    Csv,
    /// For programs: the same in every language.
    Json,
}

impl Format {
    /// Its name as an option has it.
    pub(super) const fn word(self) -> &'static str {
        match self {
            Self::Text => "text",
            Self::Csv => "csv",
            Self::Json => "json",
        }
    }
}

/// Text or JSON, each with what it is for.
pub(super) fn text_or_json() -> impl TypedValueParser<Value = Format> {
    let both = [Format::Text, Format::Json].iter().filter_map(Format::to_possible_value);
    PossibleValuesParser::new(both).try_map(|name| Format::from_str(&name, false))
}

/// Where limits are looked up; options of ISO 286 are refused where the control's tables answer.
#[derive(Debug, Clone)]
pub(super) struct TableArgs(GivenTables);

/// Where the tables come from.
#[derive(Debug, Clone, clap::Args)]
#[group(id = "TableArgs")]
struct GivenTables {
    /// Folder with your own control tables (*.tab); they take precedence for the classes and sizes that they hold
    #[arg(long, value_name = "FOLDER", global = false)]
    tables: Option<PathBuf>,
    /// Source of the limits that your own tables do not have
    #[arg(long, value_parser = bases(), default_value = Base::default().name())]
    source: Base,
    #[command(flatten)]
    standard: StandardArgs,
    /// Accept a tolerance zone that is wider than IT 18 of its size or reaches to zero
    #[arg(long)]
    wide_zone: bool,
}

const EDITIONS: [(&str, iso286::Edition); 2] = [("1988", iso286::Edition::Of1988), ("2010", iso286::Edition::Of2010)];

/// Where editions of ISO 286 differ.
#[derive(Debug, Clone, clap::Args)]
pub(super) struct StandardArgs {
    /// Edition of ISO 286 for cd, ef and fg: up to 10 mm (1988) or up to 50 mm (2010)
    #[arg(long, value_name = "YEAR", default_value = "2010", value_parser = one_of(EDITIONS, |edition| edition.0))]
    edition: (&'static str, iso286::Edition),
    /// Round half micrometres of JS7 to JS11 and js7 to js11 down, as in 1988
    #[arg(long)]
    js_rounded: bool,
}

impl StandardArgs {
    /// The names of the options, as fields and as they are given.
    const OPTIONS: [(&'static str, &'static str); 2] = [("edition", "edition"), ("js_rounded", "js-rounded")];

    /// The options of the standard.
    pub(super) const fn options(&self) -> iso286::Options {
        iso286::Options {
            edition: self.edition.1,
            js: if self.js_rounded { iso286::JsHalves::Rounded } else { iso286::JsHalves::Exact },
        }
    }
}

impl clap::Args for TableArgs {
    fn augment_args(command: Command) -> Command {
        GivenTables::augment_args(command)
    }

    fn augment_args_for_update(command: Command) -> Command {
        GivenTables::augment_args_for_update(command)
    }
}

impl FromArgMatches for TableArgs {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let given = GivenTables::from_arg_matches(matches)?;
        let is_given = |id| matches.value_source(id) == Some(ValueSource::CommandLine);
        let option = StandardArgs::OPTIONS.into_iter().find(|(id, _)| is_given(id));
        match option.filter(|_| !given.source.is_standard()) {
            Some((_, option)) => {
                let why = CliError::OptionOfStandard { option };
                Err(clap::Error::raw(ErrorKind::ArgumentConflict, why.to_string()))
            }
            None => Ok(Self(given)),
        }
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

impl TableArgs {
    /// Whether anything but the default is asked for.
    pub(super) fn is_given(&self) -> bool {
        let standard = self.0.standard.options() != iso286::Options::default();
        self.0.tables.is_some() || self.0.source != Base::default() || standard
    }

    /// Where limits are looked up; warnings about the user's own tables go to standard error.
    pub(super) fn load(&self, io: &mut Io<'_>) -> Result<Sources, CliError> {
        let GivenTables { tables, source, standard, wide_zone } = &self.0;
        let sources = Sources::default().with_base(*source, shipped_tables).with_options(standard.options());
        let sources = sources.with_wide_zones(*wide_zone);
        let Some(folder) = tables else { return Ok(sources) };
        let own = read_tables(folder).said()?;
        for warning in &own.warnings {
            io.warn(warning);
        }
        Ok(sources.with_own(own.tables))
    }
}

/// Classes by name, or one of the two lists.
pub(super) fn classes(text: &str) -> Result<Vec<ToleranceClass>, CliError> {
    let both = [Feature::Hole, Feature::Shaft];
    let found: Vec<_> = match text.trim() {
        "preferred" => both.into_iter().flat_map(iso286::preferred_classes).collect(),
        "control" => {
            let tables = shipped_tables();
            tables.iter().flat_map(|table| table.columns().iter().map(|column| column.class)).collect()
        }
        text => {
            let words = text.split([' ', ',', ';']).filter(|word| !word.is_empty());
            words.map(str::parse).collect::<Result<_, _>>().said()?
        }
    };
    if found.is_empty() { Err(MakeError::NoClass).said() } else { Ok(found) }
}
