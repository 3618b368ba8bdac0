//! Decision rules, uncertainty and temperature on the check page.

use fitcheck::budget::Validity;
use fitcheck::exchange::import;
use fitcheck::journal::Record;
use fitcheck::journal::query::RecordId;
use fitcheck::session::{
    BudgetAction, BudgetCommand, BudgetForce, CheckCommand, CheckField, Saved, Session, UncertaintyFrom,
};
use fitcheck::verdict::Status;
use fitcheck::verdict::rules::{Prover, RuleName};
use fitcheck::words::Language;
use jiff::civil::{DateTime, date};

fn now() -> DateTime {
    date(2026, 11, 21).at(10, 42, 7, 0)
}

fn run(session: &mut Session, commands: impl IntoIterator<Item = CheckCommand>) {
    for command in commands {
        session.apply(command.into(), now());
    }
}

fn typed(field: CheckField, text: &str) -> CheckCommand {
    CheckCommand::Type(field, text.to_owned())
}

fn measured(session: &mut Session, callout: &str, measured: &str) {
    run(session, [typed(CheckField::Callout, callout), typed(CheckField::Measured, measured), CheckCommand::Measure]);
}

fn shown(session: &Session) -> &Record {
    &session.check().shown.as_ref().unwrap_or_else(|| panic!("{:?}", session.check().asked)).record
}

fn is_proven(record: &Record) -> Option<bool> {
    record.decision()?.proven
}

fn imported(session: &mut Session, bytes: &[u8]) {
    let imported = import("parts.csv", bytes, session.sources(), now());
    run(session, [CheckCommand::Imported { name: "parts.csv".to_owned(), result: Ok(Box::new(imported)) }]);
}

/// metrology.md, section 5: u = 1.2 µm; for each size the status by the limits, and whether the guard bands of 1.645 u and
/// of U leave it undecided.
const NINE: [(&str, Status, bool); 9] = [
    ("24.9970", Status::Rework, false),
    ("24.9990", Status::Rework, true),
    ("25.0005", Status::Good, true),
    ("25.0025", Status::Good, false),
    ("25.0123", Status::Good, false),
    ("25.0185", Status::Good, false),
    ("25.0195", Status::Good, true),
    ("25.0215", Status::Scrap, true),
    ("25.0235", Status::Scrap, false),
];

/// The same for the shaft 25 g6.
const OF_SHAFT: [(&str, Status, bool); 8] = [
    ("24.9770", Status::Scrap, false),
    ("24.9790", Status::Scrap, true),
    ("24.9805", Status::Good, true),
    ("24.9825", Status::Good, false),
    ("24.9905", Status::Good, false),
    ("24.9915", Status::Good, true),
    ("24.9945", Status::Rework, true),
    ("24.9955", Status::Rework, false),
];

#[test]
fn the_published_sizes_have_their_states_by_each_rule() {
    let mut session = Session::new(Language::En);
    run(&mut session, [typed(CheckField::Uncertainty, "1.2")]);
    for (callout, sizes) in [("25 H7", NINE.as_slice()), ("25 g6", OF_SHAFT.as_slice())] {
        for &(size, by_limits, is_undecided) in sizes {
            run(&mut session, [CheckCommand::UseRule(RuleName::Simple)]);
            measured(&mut session, callout, size);
            assert_eq!((shown(&session).verdict.status(), is_proven(shown(&session))), (by_limits, None), "{size}");
            for rule in [RuleName::Iso14253Of2017, RuleName::Iso14253Of1998] {
                run(&mut session, [CheckCommand::UseRule(rule)]);
                measured(&mut session, callout, size);
                let expected = if is_undecided { Status::ReMeasure } else { by_limits };
                let is = (shown(&session).verdict.status(), is_proven(shown(&session)));
                assert_eq!(is, (expected, Some(!is_undecided)), "{callout} {size} {rule:?}");
            }
        }
    }
}

#[test]
fn a_rule_that_needs_an_uncertainty_judges_nothing_without_one() {
    let mut session = Session::new(Language::En);
    run(&mut session, [CheckCommand::UseRule(RuleName::Iso14253Of2017)]);
    assert!(session.error(CheckField::Uncertainty).is_none(), "nothing was typed yet");
    assert!(session.check().asked.worth.awaits().is_some());
    measured(&mut session, "25 H7", "25.012");
    assert!(session.check().shown.is_none());
    let error = session.error(CheckField::Uncertainty).unwrap().to_string();
    assert_eq!(
        error,
        "the rule ISO 14253-1:2017, 95 % needs the uncertainty of the measured value: type it at the rule on Check, or use a budget"
    );
    run(&mut session, [typed(CheckField::Uncertainty, "1,2"), CheckCommand::Measure]);
    assert_eq!(shown(&session).verdict.status(), Status::Good);
    for (field, text, said) in [
        (CheckField::Uncertainty, "-1", "an uncertainty must be above 0 µm"),
        (
            CheckField::Coverage,
            "0.5",
            "coverage factor 0.5: expected a number from 1 to 10, with at most three decimals",
        ),
    ] {
        run(&mut session, [typed(field, text), typed(CheckField::Measured, "25.012"), CheckCommand::Measure]);
        assert!(session.check().shown.is_none(), "{text}");
        assert_eq!(session.error(field).unwrap().to_string(), said);
        run(&mut session, [typed(CheckField::Uncertainty, "1.2"), typed(CheckField::Coverage, "2")]);
    }
    run(&mut session, [CheckCommand::UseRule(RuleName::Fixed)]);
    assert!(session.error(CheckField::GuardWidth).is_some());
    run(&mut session, [CheckCommand::UseRule(RuleName::IlacG8), typed(CheckField::GuardFactor, "0")]);
    assert!(session.error(CheckField::GuardFactor).is_some());
}

#[test]
fn an_expanded_uncertainty_is_divided_by_its_factor() {
    let mut session = Session::new(Language::En);
    run(
        &mut session,
        [
            CheckCommand::UseRule(RuleName::Iso14253Of1998),
            CheckCommand::TellUncertainty(UncertaintyFrom::Expanded),
            typed(CheckField::Uncertainty, "2.4"),
        ],
    );
    // 25.0024 is U away from the limit: proven, and a nanometre less is not.
    for (size, status) in [("25.002400", Status::Good), ("25.002399", Status::ReMeasure)] {
        measured(&mut session, "25 H7", size);
        assert_eq!(shown(&session).verdict.status(), status, "{size}");
    }
    assert_eq!(shown(&session).verdict.rule.uncertainty().unwrap().um(), "1.2");
    assert_eq!(session.text(CheckField::Uncertainty), "2.4", "what was typed stays");
}

#[test]
fn who_has_to_prove_changes_the_answer() {
    let mut session = Session::new(Language::En);
    run(&mut session, [CheckCommand::UseRule(RuleName::Iso14253Of2017), typed(CheckField::Uncertainty, "1.2")]);
    measured(&mut session, "25 H7", "25.0215");
    assert_eq!(shown(&session).verdict.status(), Status::ReMeasure);
    run(&mut session, [CheckCommand::LetProve(Prover::Customer)]);
    assert!(session.check().shown.is_none(), "no verdict of another rule stays");
    measured(&mut session, "25 H7", "25.0215");
    assert_eq!((shown(&session).verdict.status(), is_proven(shown(&session))), (Status::Good, Some(false)));
}

#[test]
fn a_check_shown_again_stands_beside_its_own_rule_and_lends_it_to_nothing() {
    let mut session = Session::new(Language::En);
    run(&mut session, [CheckCommand::UseRule(RuleName::Iso14253Of2017), typed(CheckField::Uncertainty, "1.2")]);
    run(&mut session, [typed(CheckField::PartTemperature, "24")]);
    measured(&mut session, "25 H7", "25.012");
    run(&mut session, [CheckCommand::UseRule(RuleName::Simple), typed(CheckField::Uncertainty, "")]);
    run(&mut session, [typed(CheckField::PartTemperature, "")]);
    measured(&mut session, "25 H7", "25.013");
    run(&mut session, [CheckCommand::Show(RecordId(0))]);
    let page = session.check();
    assert_eq!(page.asked.worth.judging.rule, RuleName::Iso14253Of2017);
    assert_eq!((session.text(CheckField::Uncertainty), session.text(CheckField::PartTemperature)), ("1.2", "24"));
    assert_eq!(session.text(CheckField::Measured), "25.012", "as it was typed");
    assert_eq!(session.saved().inputs.judging.rule, RuleName::Simple, "the user's own is kept");
    run(&mut session, [typed(CheckField::Measured, "25.014")]);
    let page = session.check();
    assert_eq!(page.asked.worth.judging.rule, RuleName::Simple);
    assert_eq!((session.text(CheckField::Uncertainty), session.text(CheckField::PartTemperature)), ("", ""));
    // An edit of the rule itself takes what stands there.
    run(&mut session, [CheckCommand::Show(RecordId(0)), typed(CheckField::Uncertainty, "1.3")]);
    assert_eq!(session.check().asked.worth.judging.rule, RuleName::Iso14253Of2017);
}

#[test]
fn a_warm_part_is_brought_to_twenty_degrees_and_says_so() {
    let mut session = Session::new(Language::En);
    run(&mut session, [typed(CheckField::PartTemperature, "28"), typed(CheckField::PartExpansion, "23.1")]);
    run(&mut session, [typed(CheckField::ScaleTemperature, "24")]);
    // The example of metrology.md, section 8: 80 mm of aluminium at 28 °C on scales at 24 °C with 10 · 10⁻⁶/K.
    measured(&mut session, "80 H7", "80");
    let record = shown(&session);
    assert_eq!(record.measurement.diameter.to_string(), "79.988416");
    assert_eq!(
        (record.verdict.status(), record.correction.unwrap().measured.to_string()),
        (Status::Rework, "80".into())
    );
    run(&mut session, [typed(CheckField::PartTemperature, "")]);
    assert!(session.error(CheckField::PartTemperature).is_some(), "scales without a part");
    run(&mut session, [typed(CheckField::Measured, "80"), CheckCommand::Measure]);
    assert!(session.check().shown.is_none(), "nothing is judged that cannot be brought to 20 °C");
}

#[test]
fn a_file_is_judged_by_the_rule_and_its_values_are_taken_as_they_are() {
    let mut session = Session::new(Language::En);
    run(&mut session, [CheckCommand::UseRule(RuleName::Iso14253Of1998), typed(CheckField::Uncertainty, "1.2")]);
    run(&mut session, [typed(CheckField::PartTemperature, "28")]);
    imported(&mut session, b"id,callout,measured\nA1,25 H7,25.0005\nA2,25 H7,25.0123\n");
    let statuses: Vec<_> = session.history().iter().map(|record| record.verdict.status()).collect();
    assert_eq!(statuses, [Status::ReMeasure, Status::Good]);
    assert!(session.history().iter().all(|record| record.correction.is_none()));
    let said: Vec<_> = session.notices()[0].details.iter().map(ToString::to_string).collect();
    assert!(said[0].contains("Judged by the rule on the check page: ISO 14253-1:1998"), "{said:?}");
    assert!(said[1].starts_with("Not corrected to 20 °C"), "{said:?}");
}

#[test]
fn a_file_is_not_judged_by_half_a_rule() {
    let mut session = Session::new(Language::En);
    run(&mut session, [CheckCommand::UseRule(RuleName::Iso14253Of1998)]);
    imported(&mut session, b"id,callout,measured\nA1,25 H7,25.0005\n");
    assert!(session.history().is_empty());
    let notice = &session.notices()[0];
    assert!(notice.is_problem);
    assert_eq!(notice.message.to_string(), "parts.csv was read, but nothing in it was judged");
    assert!(notice.details[0].to_string().contains("needs the uncertainty"), "{:?}", notice.details);
}

#[test]
fn the_rule_survives_a_restart() {
    let mut session = Session::new(Language::En);
    run(&mut session, [CheckCommand::UseRule(RuleName::IlacG8), CheckCommand::LetProve(Prover::Customer)]);
    run(&mut session, [typed(CheckField::Uncertainty, "1.2"), typed(CheckField::GuardFactor, "0.83")]);
    let bytes = session.saved().write().unwrap();
    let text = String::from_utf8(bytes.clone()).unwrap();
    assert!(text.contains("rule = \"ilac-g8\"") && text.contains("prover = \"customer\""), "{text}");
    let (again, _) = Session::restore(Saved::read(&bytes).unwrap());
    assert_eq!(again.check().asked.worth.rule(), session.check().asked.worth.rule());
    let other = text.replace("ilac-g8", "ilac-g9");
    let refused = Saved::read(other.as_bytes()).unwrap_err().to_string();
    assert!(refused.contains("ilac-g9 is no decision rule: expected simple, iso14253-2017"), "{refused}");
}

#[test]
fn what_the_process_makes_tells_the_risks() {
    let mut session = Session::new(Language::En);
    run(&mut session, [typed(CheckField::Callout, "25 H7"), typed(CheckField::Uncertainty, "1.2")]);
    assert_eq!(session.check().asked.worth.risks, None);
    run(&mut session, [typed(CheckField::ProcessSpread, "5.25")]);
    let simple = session.check().asked.worth.risks.unwrap();
    // Two standard deviations to either limit: 4.550 % of a normal law lie beyond.
    assert!((simple.nonconforming - 0.045_500).abs() < 1e-6, "{simple:?}");
    run(&mut session, [CheckCommand::UseRule(RuleName::Iso14253Of1998)]);
    let guarded = session.check().asked.worth.risks.unwrap();
    assert!(guarded.consumer < simple.consumer / 10.0 && simple.producer < guarded.producer, "{guarded:?}");
    run(&mut session, [typed(CheckField::ProcessSpread, "0")]);
    assert_eq!(session.error(CheckField::ProcessSpread).unwrap().to_string(), "0: expected a number above 0");
}

#[test]
fn without_a_budget_in_use_nothing_is_judged_by_one() {
    let mut session = Session::new(Language::En);
    run(&mut session, [CheckCommand::UseRule(RuleName::Iso14253Of2017)]);
    run(&mut session, [CheckCommand::TellUncertainty(UncertaintyFrom::Budget)]);
    measured(&mut session, "25 H7", "25.012");
    assert!(session.check().shown.is_none());
    let said = session.error(CheckField::Uncertainty).unwrap().to_string();
    assert_eq!(said, "no budget is in use: open one on the uncertainty page and use it for checks");
}

/// The budget of metrology.md, section 7, with its days: u = 0.957 µm.
fn budget(from: &str, until: &str) -> String {
    format!(
        "name = \"Station 3\"\ndate = {from}\nby = \"J. Jansen\"\nvalid_until = {until}\n\
         [[contribution]]\nname = \"Scatter of a touch\"\nkind = \"scatter\"\ntype = \"B\"\nlaw = \"normal\"\n\
         standard_um = 0.5\ntouches = 4\nstep_deg = 90\n\
         [[contribution]]\nname = \"Setting ring\"\ntype = \"B\"\nlaw = \"normal\"\nexpanded_um = 1.0\nk = 2\n\
         [[contribution]]\nname = \"Temperature\"\nkind = \"part-temperature\"\ntype = \"B\"\nlaw = \"normal\"\n\
         standard_k = 1\nalpha_per_k = 11.5e-6\n\
         [[contribution]]\nname = \"Machine\"\ntype = \"B\"\nlaw = \"rectangular\"\nhalf_width_um = 1.0\n"
    )
}

fn with_budget(from: &str, until: &str) -> Session {
    let mut session = Session::new(Language::En);
    session.apply(BudgetCommand::Edit(budget(from, until)).into(), now());
    session.apply(BudgetCommand::Use.into(), now());
    run(&mut session, [CheckCommand::UseRule(RuleName::Iso14253Of1998)]);
    run(&mut session, [CheckCommand::TellUncertainty(UncertaintyFrom::Budget)]);
    session
}

#[test]
fn the_budget_in_use_gives_the_uncertainty_of_each_value() {
    let mut session = with_budget("2026-01-15", "2027-01-14");
    measured(&mut session, "25 H7", "25.012");
    let record = shown(&session);
    // √(0.5² + 0.5² + (25.012 · 0.0115)² + 1/3), rounded up to the picometre.
    assert_eq!(record.verdict.rule.uncertainty().unwrap().um(), "0.957115");
    let kept = record.budget.as_ref().unwrap();
    assert_eq!((kept.name.as_str(), kept.validity), ("Station 3", Validity::Valid));
    // Contacts on a short arc spread the scatter of a touch: 3 at 60° have 3.464 times of it (metrology.md, section 7: 1.91 µm).
    let arc = b"x,y\n12.506,0\n6.253,10.830513688652\n-6.253,10.830513688652\n";
    let read = import("arc.csv", arc, session.sources(), now());
    run(&mut session, [CheckCommand::Imported { name: "arc.csv".to_owned(), result: Ok(Box::new(read)) }]);
    let u: f64 = shown(&session).verdict.rule.uncertainty().unwrap().um().parse().unwrap();
    assert!((u - 1.9147).abs() < 0.0001, "{u}");
    // Nothing is left of a verdict by a budget that is in use no more.
    session.apply(BudgetCommand::Leave.into(), now());
    assert!(session.check().shown.is_none());
}

#[test]
fn use_for_checks_takes_the_place_of_a_typed_uncertainty_until_the_budget_is_left() {
    let mut session = Session::new(Language::En);
    run(&mut session, [CheckCommand::UseRule(RuleName::Iso14253Of1998), typed(CheckField::Uncertainty, "1")]);
    session.apply(BudgetCommand::Edit(budget("2026-01-15", "2027-01-14")).into(), now());
    session.apply(BudgetCommand::Use.into(), now());
    assert_eq!(session.budget_force(), BudgetForce::InForce);
    let told = session.notices().last().unwrap();
    let told = told.details.iter().map(ToString::to_string).collect::<Vec<_>>().join(". ");
    assert!(told.contains("checks used the typed uncertainty (u = 1 µm, U = 2 µm (k = 2))"), "{told}");
    measured(&mut session, "25 H7", "25.012");
    assert_eq!(shown(&session).verdict.rule.uncertainty().unwrap().um(), "0.957115");
    assert_eq!(shown(&session).budget.as_ref().unwrap().name, "Station 3");
    session.apply(BudgetCommand::Leave.into(), now());
    measured(&mut session, "25 H7", "25.012");
    assert_eq!(shown(&session).verdict.rule.uncertainty().unwrap().um(), "1");
}

#[test]
fn a_budget_is_said_to_be_in_use_only_where_checks_use_it() {
    let mut session = Session::new(Language::En);
    session.apply(BudgetCommand::Edit(budget("2026-01-15", "2027-01-14")).into(), now());
    session.apply(BudgetCommand::Use.into(), now());
    assert_eq!(session.budget_force(), BudgetForce::RuleWithout, "the limits decide");
    run(&mut session, [CheckCommand::UseRule(RuleName::Iso14253Of1998)]);
    assert_eq!(session.budget_force(), BudgetForce::InForce);
    run(&mut session, [CheckCommand::TellUncertainty(UncertaintyFrom::Expanded)]);
    assert_eq!(session.budget_force(), BudgetForce::TypedCounts);
    session.apply(fitcheck::session::Command::OpenPage(fitcheck::session::Page::Budget), now());
    assert!(session.can(BudgetAction::UseBudget), "it can be used again");
}

#[test]
fn a_budget_without_a_rule_that_uses_it_is_told_once_and_offers_the_rule() {
    let mut session = Session::new(Language::En);
    run(&mut session, [typed(CheckField::Uncertainty, "1")]);
    session.apply(fitcheck::session::Command::OpenPage(fitcheck::session::Page::Budget), now());
    session.apply(BudgetCommand::Edit(budget("2026-01-15", "2027-01-14")).into(), now());
    session.apply(BudgetCommand::Use.into(), now());
    let [told] = session.notices() else { panic!("{:?}", session.notices()) };
    let said = "“Station 3” changes no verdict yet: the rule on Check is “the limits decide”, which uses no uncertainty. \
                Choose another rule";
    assert_eq!(told.message.to_string(), said);
    assert_eq!((told.page, told.part), (Some(fitcheck::session::Page::Check), Some("check-rule-section")));
    let details: Vec<_> = told.details.iter().map(ToString::to_string).collect();
    assert_eq!(details, ["Save the budget to keep using it after a restart"], "no rule used the typed one either");
    run(&mut session, [CheckCommand::UseRule(RuleName::Iso14253Of1998)]);
    session.apply(BudgetCommand::Use.into(), now());
    assert_eq!(session.notices().last().unwrap().message.to_string(), "Checks use the budget Station 3");
}

#[test]
fn an_expired_budget_still_counts_and_says_so() {
    let mut session = with_budget("2025-01-15", "2026-01-14");
    measured(&mut session, "25 H7", "25.012");
    let kept = shown(&session).budget.clone().unwrap();
    assert_eq!(kept.validity, Validity::Expired);
    assert_eq!(kept.warnings[0].to_string(), "the budget has expired: it was valid until 2026-01-14");
}

#[test]
fn a_check_by_an_earlier_budget_stands_beside_its_own_uncertainty() {
    let mut session = with_budget("2026-01-15", "2027-01-14");
    measured(&mut session, "25 H7", "25.012");
    session.apply(BudgetCommand::Edit(budget("2026-02-15", "2027-02-14")).into(), now());
    session.apply(BudgetCommand::Use.into(), now());
    run(&mut session, [CheckCommand::Show(RecordId(0))]);
    let kept = shown(&session).budget.clone().unwrap();
    assert_eq!(kept.date, date(2026, 1, 15));
    assert_eq!(session.used_budget().unwrap().budget.date, date(2026, 2, 15), "the next check has the new one");
    run(&mut session, [typed(CheckField::Measured, "25.013"), CheckCommand::Measure]);
    assert_eq!(shown(&session).budget.as_ref().unwrap().date, date(2026, 2, 15));
}

/// A value that may be a radius is doubled as it was typed: what it comes to at 20 °C would be corrected once more.
#[test]
fn what_a_warm_value_may_have_been_is_corrected_once() {
    let mut session = Session::new(Language::En);
    run(&mut session, [typed(CheckField::PartTemperature, "26"), typed(CheckField::Callout, "25 H7")]);
    run(&mut session, [typed(CheckField::Measured, "12.5115"), CheckCommand::Measure]);
    let question = session.check().question.as_ref().unwrap();
    assert_eq!(
        (question.measured.to_string(), question.doubt.meant().unwrap().to_string()),
        ("12.5115".into(), "25.023".into())
    );
    run(&mut session, [CheckCommand::TakeMeant]);
    let record = shown(&session);
    assert_eq!(
        (record.measurement.diameter.to_string().as_str(), record.verdict.status()),
        ("25.021273", Status::Scrap)
    );
}

#[test]
fn an_edit_of_one_temperature_takes_the_others_that_stand_there() {
    let mut session = Session::new(Language::En);
    run(&mut session, [typed(CheckField::PartTemperature, "28"), typed(CheckField::PartExpansion, "23.1")]);
    measured(&mut session, "80 H7", "80.02");
    run(&mut session, [typed(CheckField::PartTemperature, ""), typed(CheckField::PartExpansion, "11.5")]);
    run(&mut session, [CheckCommand::Show(RecordId(0)), typed(CheckField::PartExpansion, "23.2")]);
    assert_eq!(session.text(CheckField::PartTemperature), "28");
    run(&mut session, [CheckCommand::Show(RecordId(0)), typed(CheckField::PartTemperature, "29")]);
    assert_eq!(session.text(CheckField::PartExpansion), "23.1");
}

#[test]
fn the_guard_bands_of_a_budget_are_known_before_anything_is_measured() {
    let mut session = with_budget("2026-01-15", "2027-01-14");
    assert_eq!(session.rule_ahead(), None);
    run(&mut session, [typed(CheckField::Callout, "25 H7")]);
    // For the middle of the zone, 25.0105 mm.
    assert_eq!(session.rule_ahead().unwrap().uncertainty().unwrap().um(), "0.95711");
    run(&mut session, [CheckCommand::TellUncertainty(UncertaintyFrom::Standard)]);
    assert_eq!(session.rule_ahead(), None, "the rule has no uncertainty");
}

/// Whatever is chosen, the page says what `fitcheck check` says.
#[test]
fn the_page_judges_as_the_command_line_does() {
    let provers = [(Prover::Supplier, "supplier"), (Prover::Customer, "customer")];
    let mut count = 0;
    for (number, rule) in RuleName::ALL.into_iter().cycle().take(96).enumerate() {
        let pick = |list: &[&'static str], step: usize| list[number / step % list.len()];
        let (u, k) = (pick(&["0.3", "1.2", "6"], 8), pick(&["2", "2.5"], 3));
        let (callout, size) = [("25 H7", "25.0"), ("25 g6", "24.98")][number / 48];
        let size = format!("{size}{}", pick(&["0050", "1950", "21", "1234", "0003"], 5));
        let (temperature, scale) = (pick(&["", "26", "-4.5"], 7), pick(&["", "22"], 11));
        let (prover, said) = provers[number / 16 % 2];
        let mut session = Session::new(Language::En);
        let mut arguments =
            vec!["check", callout, "--measured", &size, "--format", "json", "--rule", rule.word(), "--u", u];
        arguments.extend(["--k", k]);
        run(
            &mut session,
            [CheckCommand::UseRule(rule), typed(CheckField::Uncertainty, u), typed(CheckField::Coverage, k)],
        );
        if rule.takes_factor() {
            run(&mut session, [typed(CheckField::GuardFactor, "0.83")]);
            arguments.extend(["--factor", "0.83"]);
        }
        if rule.takes_width() {
            run(&mut session, [typed(CheckField::GuardWidth, "1.5")]);
            arguments.extend(["--guard", "1.5"]);
        }
        if rule.takes_prover() {
            run(&mut session, [CheckCommand::LetProve(prover)]);
            arguments.extend(["--prover", said]);
        }
        if !temperature.is_empty() {
            run(
                &mut session,
                [typed(CheckField::PartTemperature, temperature), typed(CheckField::PartExpansion, "23.1")],
            );
            arguments.extend(["--temperature", temperature, "--material", "23.1"]);
            if !scale.is_empty() {
                run(&mut session, [typed(CheckField::ScaleTemperature, scale), typed(CheckField::ScaleExpansion, "8")]);
                arguments.extend(["--scale-temperature", scale, "--scale-material", "8"]);
            }
        }
        measured(&mut session, callout, &size);
        let output = assert_cmd::Command::new(env!("CARGO_BIN_EXE_fitcheck")).args(&arguments).output().unwrap();
        let expected: serde_json::Value = serde_json::from_slice(&output.stdout)
            .unwrap_or_else(|_| panic!("{arguments:?} {}", String::from_utf8_lossy(&output.stderr)));
        let mut is = fitcheck::report::json::object(shown(&session)).unwrap();
        // Both were checked now, whenever that was.
        is.insert("time".to_owned(), expected["time"].clone());
        // Through the same text: a last digit of a float may change when it is read.
        let is: serde_json::Value = serde_json::from_str(&serde_json::to_string(&is).unwrap()).unwrap();
        assert_eq!(is, expected, "{arguments:?}");
        count += 1;
    }
    assert_eq!(count, 96);
}
