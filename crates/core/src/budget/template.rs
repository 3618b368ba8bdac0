//! What a new budget begins with, and what of it still stands in another one.

use std::sync::LazyLock;

use jiff::civil::Date;

use super::{Basis, Budget, BudgetWarning, Contribution};

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
        let all = [
            (self.name == template.name, Placeholder::Name),
            (self.by == template.by, Placeholder::By),
            (self.has_template_figures_only(), Placeholder::Figures),
        ];
        all.into_iter().filter_map(|(stands, what)| stands.then_some(what)).collect()
    }

    fn has_template_figures_only(&self) -> bool {
        match &self.basis {
            Basis::Contributions(own) => self.contributions_of_template().len() == own.len(),
            Basis::Calibrated(_) => false,
        }
    }

    /// Its contributions that have the figures of the template, in their order. Another name is no other figure.
    fn contributions_of_template(&self) -> Vec<&Contribution> {
        let template = TEMPLATE.as_ref().map(|template| &template.basis);
        let (Basis::Contributions(own), Some(Basis::Contributions(all))) = (&self.basis, template) else {
            return Vec::new();
        };
        let is_same =
            |own: &Contribution, of: &Contribution| *of == Contribution { name: of.name.clone(), ..own.clone() };
        own.iter().filter(|own| all.iter().any(|of| is_same(own, of))).collect()
    }

    /// Which of its figures are those of the template, where others are its own: they may be true of the station, too, so
    /// that nothing but the one who uses the budget can tell.
    pub fn template_figures(&self) -> Option<BudgetWarning> {
        let of_template = self.contributions_of_template();
        if of_template.is_empty() || self.has_template_figures_only() {
            return None;
        }
        let names: Vec<&str> = of_template.into_iter().map(|contribution| contribution.name.as_str()).collect();
        Some(BudgetWarning::TemplateFigures { contributions: names.join(", ") })
    }
}
