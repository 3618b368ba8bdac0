//! Opens the window of the program `fitcheck` beside it, without a console. A program for Windows has either a console or none:
//! `fitcheck.exe` has one, so that shells wait for it and see what it says, and shortcuts start this one instead.
#![cfg_attr(windows, windows_subsystem = "windows")]

use std::process::{Command, ExitCode};

/// `CREATE_NO_WINDOW`: the console of the program that is started stays out of sight.
#[cfg(windows)]
const WITHOUT_CONSOLE: u32 = 0x0800_0000;

fn main() -> ExitCode {
    let started = std::env::current_exe().and_then(|own| {
        let mut program = Command::new(own.with_file_name(format!("fitcheck{}", std::env::consts::EXE_SUFFIX)));
        #[cfg(windows)]
        std::os::windows::process::CommandExt::creation_flags(&mut program, WITHOUT_CONSOLE);
        program.args(std::env::args_os().skip(1)).spawn()
    });
    if started.is_ok() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
