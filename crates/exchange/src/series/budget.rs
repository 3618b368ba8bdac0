//! What a study gives an uncertainty budget, as a file that `fitcheck budget` and the page Uncertainty read.

use std::fmt::Write as _;

use fitcheck_core::message::Say as _;
use fitcheck_statistics::Advice;
use jiff::civil::Date;

use super::figures::{Answer, Contribution};

impl Answer {
    /// A budget with the contributions of a study, named after the files that were read; `None` where it gives none. A gauge that is not good enough
    /// says so with every check that uses the budget.
    pub fn budget(&self, files: &str, today: Date) -> Option<String> {
        if self.contributions.is_empty() {
            return None;
        }
        let name = toml::Value::String(files.to_owned()).to_string();
        // Until somebody says until when it is valid, it is for one day.
        let mut budget = format!("name = {name}\ndate = {today}\nby = \"fitcheck stats\"\nvalid_until = {today}\n");
        let fails = |advice: &&Advice| matches!(advice, Advice::Gauge(finding) if finding.fails());
        if let Some(why) = self.advice.iter().find(fails) {
            let why = toml::Value::String(why.message().to_string());
            let _infallible = writeln!(budget, "failed_study = {why}");
        }
        for Contribution { name, standard, degrees } in &self.contributions {
            let study = self.layout.map_or("", |layout| layout.kind.word());
            let _infallible = write!(
                budget,
                "\n[[contribution]]\nname = \"{name}, {study} study\"\ntype = \"A\"\nlaw = \"normal\"\nstandard_um = {}\ndegrees_of_freedom = {degrees}\n",
                standard * 1_000.0
            );
        }
        Some(budget)
    }
}
