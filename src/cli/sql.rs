//! `fitcheck sql`: limits and verdicts as plain SQL, for engines that hold the measurements themselves.

use std::path::PathBuf;

use super::args::{classes, one_of};
use super::{CliError, IntoCliError as _, Io, Outcome, TableArgs, put};
use crate::exchange::sql::{self, DIALECTS, Dialect, ERRORS, Model};

/// Write limits and verdicts as plain SQL for a database or a data lake
#[derive(Debug, clap::Args)]
#[command(after_help = help())]
pub(super) struct Args {
    /// Database engine
    #[arg(long, value_parser = one_of(DIALECTS, |dialect| dialect.name))]
    dialect: &'static Dialect,
    /// Classes such as "H7 h6", preferred or control; default: every class
    #[arg(long, value_name = "CLASSES")]
    classes: Option<String>,
    /// The file to write; - or no file is standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    #[command(flatten)]
    tables: TableArgs,
}

fn help() -> String {
    let dialects = DIALECTS.iter().map(|dialect| format!("  {:<10}{}\n", dialect.name, dialect.engine));
    let errors: Vec<&str> = ERRORS.iter().map(|(code, _)| *code).collect();
    format!(
        "\
Dialects:
{}
Examples:
  fitcheck sql --dialect postgres -o fitcheck.sql && psql -v ON_ERROR_STOP=1 -f fitcheck.sql
  fitcheck sql --dialect duckdb --classes \"H7 g6\" | duckdb fit.duckdb
  fitcheck sql --dialect sqlite --tables my_tables -o fitcheck.sql

The SQL holds the limits of every class and size step, and views that judge the rows of a table
in place, with the rule of fitcheck check without a guard band: min_mm, max_mm,
deviation_um, status, remove_um, error. The comment at its top describes how to use it, with examples.
A row that cannot be judged keeps its place, with a code in error:
  {}
The ends of all size ranges of your own tables must be whole millimetres.",
        dialects.collect::<String>(),
        errors.join("\n  ")
    )
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let chosen = self.classes.as_deref().map(classes).transpose()?;
        let sources = self.tables.load(io)?;
        let model = Model::new(&sources, chosen).said()?;
        put(self.output.as_deref(), &mut |out| sql::write(&model, self.dialect, out), io)?;
        Ok(Outcome::Done)
    }
}
