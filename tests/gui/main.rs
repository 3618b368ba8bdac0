//! The window, driven by label and key, never by pixel. Pictures are few and small.

#![cfg(test)]

mod actions;
mod asked;
mod budget_page;
mod budget_table;
mod check_page;
mod columns_page;
mod cycle_page;
mod dialogs;
mod fake_journal;
mod fast_keys;
mod fit_page;
mod focus;
mod gauges;
mod harness;
mod help_page;
mod history;
mod icons;
mod keeping;
mod keyboard;
mod lot;
mod operator;
mod pairing_page;
mod palette;
mod parts;
mod pictures;
mod plan_page;
mod program_page;
mod readme;
mod records_page;
mod reports_page;
mod rows;
mod rules;
mod settings_page;
mod shift;
mod sizes;
mod small_windows;
mod statistics_page;
mod studies;
mod table_page;
mod tools;
mod walk_page;
mod working;
