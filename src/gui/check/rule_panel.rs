//! Left: what a measured value is worth. The decision rule, the uncertainty, what the process makes; the temperature.

use eframe::egui::Ui;

use super::field_pairs::pairs_ui;
use crate::gui::field::{FieldStyle, error_ui, field_ui, half_width};
use crate::gui::material::material_ui;
use crate::gui::section::Section;
use crate::gui::theme::{Icon, space};
use crate::gui::view::{View, one_of_ui, quiet};
use crate::length::Length;
use crate::message::{Message, message};
use crate::session::{CheckCommand, CheckField, Page, RuleFields, UncertaintyFrom, WindowAction, rule_name_id};
use crate::verdict::rules::{Prover, RuleName, percent};

/// The fields that the header of the rule folds away.
const OF_RULE: [CheckField; 6] = [
    CheckField::Uncertainty,
    CheckField::Coverage,
    CheckField::GuardFactor,
    CheckField::GuardWidth,
    CheckField::ProcessMean,
    CheckField::ProcessSpread,
];

/// The same of the temperature.
const OF_TEMPERATURE: [CheckField; 4] =
    [CheckField::PartTemperature, CheckField::PartExpansion, CheckField::ScaleTemperature, CheckField::ScaleExpansion];

/// The rule and the temperature, folded: their rows say what is in force.
pub(super) fn worth_ui(ui: &mut Ui, view: &mut View<'_>) {
    let is_wrong =
        |view: &View<'_>, fields: &[CheckField]| fields.iter().any(|field| view.session.error(*field).is_some());
    let rule = Section {
        icon: Icon::Scales,
        name: "check-rule-section",
        value: view.text(rule_name_id(worth(view).judging.rule)),
        is_wrong: is_wrong(view, &OF_RULE),
    };
    rule.show(ui, view, rule_ui);
    let temperature = view.session.text(CheckField::PartTemperature).trim().to_owned();
    let value = if temperature.is_empty() {
        view.text("check-temperature-none")
    } else {
        view.words.say(&message!("check-temperature-is").text("temperature", temperature))
    };
    let is_wrong = is_wrong(view, &OF_TEMPERATURE);
    let icon = Icon::ThermometerSimple;
    Section { icon, name: "check-temperature-section", value, is_wrong }.show(ui, view, temperature_ui);
}

const fn worth<'a>(view: &View<'a>) -> &'a RuleFields {
    &view.session.check().asked.worth
}

fn rule_ui(ui: &mut Ui, view: &mut View<'_>) {
    let judging = worth(view).judging;
    let name = quiet(ui, view.text("check-rule"));
    let width = ui.available_width();
    let rules = RuleName::ALL.map(|rule| (rule, view.text(rule_name_id(rule))));
    let (rule, list) = one_of_ui(ui, "rule-list", width - space(2.0), &judging.rule, rules);
    list.labelled_by(name.id);
    if let Some(rule) = rule {
        view.send(CheckCommand::UseRule(rule));
    }
    if judging.rule.takes_prover() {
        ui.horizontal_wrapped(|ui| {
            for (prover, text) in [(Prover::Supplier, "prover-supplier"), (Prover::Customer, "prover-customer")] {
                if ui.radio(judging.prover == prover, view.text(text)).clicked() {
                    view.send(CheckCommand::LetProve(prover));
                }
            }
        });
    }
    uncertainty_ui(ui, view);
    if judging.rule.takes_factor() {
        one_ui(ui, view, (CheckField::GuardFactor, "guard-factor", "× U"));
    }
    if judging.rule.takes_width() {
        one_ui(ui, view, (CheckField::GuardWidth, "guard-width", "µm"));
    }
    zones_ui(ui, view);
    process_ui(ui, view);
}

/// How uncertain a measured value is, and who says so.
fn uncertainty_ui(ui: &mut Ui, view: &mut View<'_>) {
    let judging = worth(view).judging;
    quiet(ui, view.text("check-uncertainty"));
    ui.horizontal_wrapped(|ui| {
        for from in UncertaintyFrom::ALL {
            let text = match from {
                UncertaintyFrom::Standard => "uncertainty-standard",
                UncertaintyFrom::Expanded => "uncertainty-expanded",
                UncertaintyFrom::Budget => "uncertainty-budget",
            };
            if ui.radio(judging.from == from, view.text(text)).clicked() {
                view.send(CheckCommand::TellUncertainty(from));
            }
        }
    });
    if judging.from == UncertaintyFrom::Budget {
        // A shown check has the budget that it was made with.
        let of_check = view.session.check().shown.as_ref().and_then(|shown| shown.record.budget.clone());
        match (of_check, view.session.used_budget()) {
            (Some(kept), _) => {
                let date = kept.date.to_string();
                let said = message!("check-budget-of-check").text("name", &kept.name).text("date", date);
                ui.label(view.words.say(&said));
            }
            (None, Some(open)) => {
                let said = message!("check-budget-used").text("name", &open.budget.name).text("file", &open.file);
                ui.label(view.words.say(&said));
            }
            (None, None) => _ = quiet(ui, view.text("check-budget-none")),
        }
        view.field_button(ui, WindowAction::Open(Page::Budget));
        error_ui(ui, view, CheckField::Uncertainty);
        return;
    }
    let name = if judging.from == UncertaintyFrom::Expanded { "uncertainty-u-expanded" } else { "uncertainty-u" };
    pairs_ui(ui, view, &[(CheckField::Uncertainty, name, "µm"), (CheckField::Coverage, "coverage-factor", "")]);
    let is_refused = view.session.error(CheckField::Uncertainty).is_some();
    if let Some(awaited) = worth(view).awaits().filter(|_| !is_refused) {
        quiet(ui, view.words.say(awaited));
    }
}

/// Which values are accepted; nothing where the limits themselves decide.
fn zones_ui(ui: &mut Ui, view: &View<'_>) {
    let asked = &view.session.check().asked;
    let (Some(rule), Some(limits)) = (view.session.rule_ahead(), asked.limits.as_ref()) else { return };
    if rule.is_plain() {
        return;
    }
    ui.label(accepted_text(view, rule.zones(&limits.bounds()).accepted));
}

/// The accepted values in words.
pub(super) fn accepted_text(view: &View<'_>, accepted: Option<[Length; 2]>) -> String {
    match accepted {
        Some([least, most]) => {
            let mm = |length| view.words.mm(length, 3);
            view.words.say(&message!("rule-accepted").text("least", mm(least)).text("most", mm(most)))
        }
        None => view.text("rule-accepts-nothing"),
    }
}

/// What the process makes, and what then goes wrong by the rule.
fn process_ui(ui: &mut Ui, view: &mut View<'_>) {
    quiet(ui, view.text("check-process"));
    pairs_ui(
        ui,
        view,
        &[(CheckField::ProcessMean, "process-mean", "mm"), (CheckField::ProcessSpread, "process-spread", "µm")],
    );
    if worth(view).wants_uncertainty_for_risks() {
        quiet(ui, view.text("risk-without-uncertainty"));
    }
    if let Some(risks) = worth(view).risks {
        for (text, risk) in [
            ("risk-nonconforming", risks.nonconforming),
            ("risk-consumer", risks.consumer),
            ("risk-producer", risks.producer),
        ] {
            let said = Message::new(text).text("percent", view.words.number(&percent(risk)));
            ui.label(view.words.say(&said));
        }
    }
}

/// The temperature of the part and of the scales, and what they are made of.
fn temperature_ui(ui: &mut Ui, view: &mut View<'_>) {
    quiet(ui, view.text("check-temperature-hint"));
    let width = (ui.available_width() - space(2.0)) / 2.0;
    for (temperature, material, expansion, names) in [
        (
            CheckField::PartTemperature,
            "check-part-material",
            CheckField::PartExpansion,
            ["part-temperature", "part-expansion"],
        ),
        (
            CheckField::ScaleTemperature,
            "check-scale-material",
            CheckField::ScaleExpansion,
            ["scale-temperature", "scale-expansion"],
        ),
    ] {
        let [of_temperature, of_expansion] = names;
        pairs_ui(ui, view, &[(temperature, of_temperature, "°C"), (expansion, of_expansion, "10⁻⁶/K")]);
        let name = quiet(ui, view.text(material));
        let now = view.session.text(expansion).parse().ok();
        if let Some(taken) = material_ui(ui, view, material, now, (name.id, width * 2.0)) {
            view.send(CheckCommand::ChooseExpansion(expansion, taken));
        }
    }
}

/// One field with its name above it.
fn one_ui(ui: &mut Ui, view: &mut View<'_>, (of, name, unit): (CheckField, &str, &str)) {
    let name = quiet(ui, view.text(name));
    field_ui(ui, view, of, name.id, FieldStyle::number(half_width(ui)).unit(unit));
    error_ui(ui, view, of);
}
