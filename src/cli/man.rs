//! `fitcheck man`: the manual pages of the command line.

use std::path::PathBuf;

use clap::CommandFactory as _;

use super::io::not_dash;
use super::{Cli, CliError, CliRemark, Io, Outcome};
use crate::files;

const EXAMPLES: &str = "\
Examples:
  fitcheck man check | man -l -
  fitcheck man journal list | man -l -
  fitcheck man -o ~/.local/share/man/man1       a page for each subcommand";

/// Write manual pages: of one subcommand, or of all into a folder
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// The subcommand; default: fitcheck itself
    #[arg(conflicts_with = "output")]
    subcommand: Vec<String>,
    /// The folder to write every page into
    #[arg(short, long, value_name = "FOLDER")]
    output: Option<PathBuf>,
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let mut whole = Cli::command();
        whole.build();
        if let Some(folder) = &self.output {
            not_dash(folder)?;
            let mut commands = vec![&whole];
            while let Some(command) = commands.pop() {
                let (name, page) = page(command)?;
                files::write(&folder.join(format!("{name}.1")), &page)?;
                commands.extend(command.get_subcommands().filter(|subcommand| subcommand.get_name() != "help"));
            }
            io.note(CliRemark::Wrote { path: folder.display().to_string() });
            return Ok(Outcome::Done);
        }
        let mut command = &whole;
        for name in &self.subcommand {
            let names = || command.get_subcommands().map(clap::Command::get_name).collect::<Vec<_>>().join(", ");
            let unknown = || CliError::NoSubcommand { given: name.clone(), names: names() };
            command = command.find_subcommand(name).ok_or_else(unknown)?;
        }
        io.data().write_all(&page(command)?.1);
        Ok(Outcome::Done)
    }
}

/// A page and its name: `fitcheck-journal-list`.
fn page(command: &clap::Command) -> Result<(String, Vec<u8>), CliError> {
    let name = command.get_display_name().unwrap_or_else(|| command.get_name()).to_owned();
    let mut page = Vec::new();
    clap_mangen::Man::new(command.clone().name(name.clone())).render(&mut page)?;
    Ok((name, page))
}
