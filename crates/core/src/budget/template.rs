//! What a new budget begins with, and what of it still stands in another one.

use std::sync::LazyLock;

use jiff::civil::Date;

use super::{Basis, Budget, Contribution};

const TEXT: &str = include_str!("../../../../assets/budget.toml");

static TEMPLATE: LazyLock<Option<Budget>> =
    LazyLock::new(|| Budget::read(&text(Date::constant(2026, 1, 1), Date::constant(2026, 12, 31))).ok());

/// What nobody has said of the station and its probe.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Placeholder {
    /// The name of the station and the probe.
    Name,
    /// Who made the budget.
    By,
    /// All contributions.
    Figures,
}

/// The text of a new budget that is made on a day, with the last day on which it counts.
pub fn text(date: Date, until: Date) -> String {
    TEXT.replace("{date}", &date.to_string()).replace("{until}", &until.to_string())
}

impl Budget {
    /// What of the template still stands in it.
    pub fn placeholders(&self) -> Vec<Placeholder> {
        let Some(template) = &*TEMPLATE else { return Vec::new() };
        let has_its_figures = match (&self.basis, &template.basis) {
            (Basis::Contributions(own), Basis::Contributions(all)) => {
                // Another name is no other figure.
                let is_same = |own: &Contribution, of: &Contribution| {
                    *of == Contribution { name: of.name.clone(), ..own.clone() }
                };
                own.iter().all(|own| all.iter().any(|of| is_same(own, of)))
            }
            _ => false,
        };
        let all = [
            (self.name == template.name, Placeholder::Name),
            (self.by == template.by, Placeholder::By),
            (has_its_figures, Placeholder::Figures),
        ];
        all.into_iter().filter_map(|(stands, what)| stands.then_some(what)).collect()
    }
}
