//! Tests of the core and the command line, in one binary.

#![cfg(test)]

mod bad_input;
mod callouts;
mod check_cli;
mod circle_cli;
mod circles;
mod corpus;
mod cycle_cli;
mod cycle_declaration;
mod cycle_logs;
mod cycles;
mod exact_cycles;
mod fit_cli;
mod fit_search;
mod fits;
mod house;
mod import;
mod iso286;
mod limits_cli;
mod locales;
mod log_444;
mod log_writing;
mod logs;
mod machine;
mod masks;
mod nc_cli;
mod nc_sets;
mod point_cycles;
mod probe_blocks;
mod programs;
mod promises;
mod report;
mod report_cli;
mod run_cli;
mod session;
mod session_actions;
mod session_cycles;
mod session_fit;
mod session_program;
mod session_tables;
mod table_cli;
mod table_compare;
mod tables;
mod twin;
mod wall_cycles;
