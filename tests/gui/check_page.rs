//! Typing a callout and a value, and reading the answer.

use eframe::egui::accesskit::{Live, Role};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};

use eframe::egui::{Key, Modifiers};
use fitcheck::gui::App;
use fitcheck::session::{CheckCommand, CheckField, Command, Field, FitField, MeasureBy, Page};
use fitcheck::words::Language;

use crate::harness::{Window, check, scan, type_into, unfold, verdict, window};

#[test]
fn a_value_inside_the_limits_is_good() {
    let mut window = window();
    check(&mut window, "25 H7", "25.012");
    assert_eq!(verdict(&window), "GOOD. 25.012 mm. 12 µm above minimum. 9 µm below maximum");
}

#[test]
fn a_hole_too_small_is_rework_with_the_amount_to_remove() {
    let mut window = window();
    check(&mut window, "25 H7", "24.998");
    let said = verdict(&window);
    assert!(
        said.starts_with("REWORK. 24.998 mm. Remove 2 µm to the nearest limit, 1 µm per side. 12.5 µm to the middle"),
        "{said}"
    );
}

#[test]
fn a_hole_too_large_is_scrap() {
    let mut window = window();
    check(&mut window, "25 H7", "25.030");
    assert_eq!(
        verdict(&window),
        "SCRAP. 25.030 mm. Set the part aside. No material can be put back. 9 µm above maximum"
    );
}

#[test]
fn limits_belong_to_the_zone_and_a_nanometre_more_does_not() {
    let mut window = window();
    for (measured, word) in [("25.000", "GOOD"), ("25,021", "GOOD"), ("24.999999", "REWORK"), ("25.021001", "SCRAP")] {
        check(&mut window, "25 H7", measured);
        assert!(verdict(&window).starts_with(word), "{measured}: {}", verdict(&window));
    }
}

#[test]
fn the_sides_swap_for_a_shaft() {
    let mut window = window();
    check(&mut window, "25 h7", "25.001");
    assert!(verdict(&window).starts_with("REWORK"), "{}", verdict(&window));
    check(&mut window, "25 h7", "24.978");
    assert!(verdict(&window).starts_with("SCRAP"), "{}", verdict(&window));
    window.get_by_label("Shaft");
}

#[test]
fn the_verdict_is_a_live_region_and_the_pictures_describe_themselves() {
    let mut window = window();
    check(&mut window, "25 H7", "25.012");
    let status = window.get_by_role(Role::Status);
    assert_eq!(status.accesskit_node().data().live(), Some(Live::Assertive));
    let band = window.get_by_role_and_label(Role::Image, "Limit band");
    let said = band.accesskit_node().data().description().unwrap_or_default().to_owned();
    assert_eq!(
        said,
        "Deviation from nominal size in micrometres: zone from 0 to +21, rework below it, scrap above it. \
         Measured +12, +12 above the minimum, +9 below the maximum."
    );
}

#[test]
fn limits_follow_while_typing_and_a_refusal_stands_beside_the_field() {
    let mut window = window();
    type_into(&mut window, "Callout", "25 H7");
    window.get_by_label("25.021");
    window.get_by_label("25.000");
    window.get_by_label("+21 µm");
    type_into(&mut window, "Callout", "24 T7");
    window.get_by_label_contains("it is defined over 24 up to 3150 mm");
    assert!(window.query_by_label("25.021").is_none(), "no limits beside a refused callout");
    type_into(&mut window, "Callout", "3151 H7");
    window.get_by_label_contains("beyond ISO 286, which ends at 3150 mm");
    type_into(&mut window, "Callout", "7.5.2 H7");
    window.get_by_label_contains("7.5.2 is not a number");
}

#[test]
fn a_changed_callout_clears_the_verdict_at_once() {
    let mut window = window();
    check(&mut window, "25 H7", "25.012");
    type_into(&mut window, "Callout", "25 H6");
    assert_eq!(verdict(&window), "No result. 25.000 … 25.013 mm");
}

#[test]
fn a_value_that_is_no_length_is_refused_beside_its_field() {
    let mut window = window();
    check(&mut window, "25 H7", "25.0.1");
    window.get_by_label("25.0.1 is not a number");
    assert_eq!(verdict(&window), "No result. 25.000 … 25.021 mm");
    check(&mut window, "25 H7", "");
    window.get_by_label("Type the measured value");
}

#[test]
fn half_the_nominal_size_is_doubted() {
    let mut window = window();
    check(&mut window, "25 H7", "12.506");
    assert!(verdict(&window).contains("is it a radius"), "{}", verdict(&window));
}

#[test]
fn a_mistyped_value_leaves_no_verdict_on_screen() {
    let mut window = window();
    check(&mut window, "25 H7", "25.012");
    type_into(&mut window, "Measured value", "25.03O");
    assert_eq!(verdict(&window), "No result. 25.000 … 25.021 mm");
    window.key_press(Key::Enter);
    window.run();
    assert_eq!(verdict(&window), "No result. 25.000 … 25.021 mm");
}

#[test]
fn a_value_that_may_be_another_quantity_is_asked_about() {
    let mut window = window();
    check(&mut window, "25 H7", "250.12");
    assert!(verdict(&window).starts_with("Is this right?. 250.120 mm"), "{}", verdict(&window));
    assert!(verdict(&window).contains(". The measured value is about the nominal size"), "{}", verdict(&window));
    window.get_by_role_and_label(Role::Button, "Use 25.012 mm").click();
    window.run();
    assert!(verdict(&window).starts_with("GOOD. 25.012 mm"), "{}", verdict(&window));
    check(&mut window, "25 H7", "250.12");
    window.get_by_role_and_label(Role::Button, "Judge 250.120 mm as it is").click();
    window.run();
    assert!(verdict(&window).starts_with("SCRAP. 250.120 mm"), "{}", verdict(&window));
    // By keys alone: Enter asks, Enter once more gives the highlighted answer.
    check(&mut window, "25 H7", "2.5012");
    assert!(verdict(&window).starts_with("Is this right?"), "{}", verdict(&window));
    window.key_press(Key::Enter);
    window.run();
    assert!(verdict(&window).starts_with("GOOD. 25.012 mm"), "{}", verdict(&window));
    check(&mut window, "25 H7", "26");
    assert!(verdict(&window).starts_with("Is this right?"), "{}", verdict(&window));
    window.key_press(Key::Enter);
    window.run();
    assert!(verdict(&window).starts_with("SCRAP. 26.000 mm"), "{}", verdict(&window));
}

#[test]
fn a_doubt_is_a_whole_sentence_in_every_language_on_both_pages() {
    for (language, asked, said) in [
        (
            Language::En,
            "Is this right?",
            "The measured value is twice the nominal size: was a diameter taken for a radius?",
        ),
        (
            Language::Nl,
            "Klopt dit?",
            "De gemeten waarde is twee keer de nominale maat: is een diameter voor een radius aangezien?",
        ),
    ] {
        let mut window = Window { language, ..Window::default() }.open();
        let send = |window: &mut Harness<'_, App>, command: Command| {
            let ctx = window.ctx.clone();
            window.state_mut().send(&ctx, command);
            window.run();
        };
        send(&mut window, Field::from(CheckField::Callout).typed("25 H7".to_owned()));
        send(&mut window, Field::from(CheckField::Measured).typed("50.012".to_owned()));
        send(&mut window, CheckCommand::Measure.into());
        assert!(verdict(&window).starts_with(asked), "{}", verdict(&window));
        window.get_by_label(said);
        send(&mut window, CheckCommand::Measure.into());
        assert!(!verdict(&window).starts_with(asked), "{}", verdict(&window));
        window.get_by_label(said);
        send(&mut window, Command::OpenPage(Page::Fit));
        send(&mut window, Field::from(FitField::Callout).typed("25 H7/g6".to_owned()));
        send(&mut window, Field::from(FitField::HoleMeasured).typed("50.012".to_owned()));
        window.get_by_label(said);
    }
}

#[test]
fn the_status_window_keeps_the_controls_digits_with_the_exact_values_beside_it() {
    let mut window = window();
    check(&mut window, "25 H7", "25.021001");
    window.get_by_label_contains("MEASURED DIAMETER:  25.0210");
    window.get_by_label("The window rounds to four decimals. Exact values: Measured 25.021001 mm");
    check(&mut window, "25 H7", "25.012");
    assert!(window.query_by_label_contains("The window rounds").is_none());
}

#[test]
fn many_imported_rows_are_counted_and_the_worst_is_shown_first() {
    let mut window = window();
    type_into(&mut window, "Measured value", "9.9");
    let rows = b"id,callout,measured\nA1,25 H7,25.012\nA2,25 H7,25.030\nA3,25 H7,24.998\nA4,,25\n";
    let imported = fitcheck::exchange::import(
        "parts.csv",
        rows,
        window.state().session().sources(),
        jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0),
    );
    let ctx = window.ctx.clone();
    let command = CheckCommand::Imported { name: "parts.csv".to_owned(), result: Ok(Box::new(imported)) };
    window.state_mut().send(&ctx, command.into());
    window.run();
    for label in ["parts.csv: 4 rows", "GOOD 1", "REWORK 1", "SCRAP 1", "1 not judged"] {
        window.get_by_label(label);
    }
    window.get_by_label("Shown: 1 of 3, worst first; line 3, part A2");
    assert!(verdict(&window).starts_with("SCRAP. 25.030 mm"), "{}", verdict(&window));
    window.get_by_role_and_label(Role::Button, "Better").click();
    window.run();
    assert!(verdict(&window).starts_with("REWORK. 24.998 mm"), "{}", verdict(&window));
    window.key_press_modifiers(Modifiers::ALT, Key::End);
    window.run();
    window.get_by_label("Shown: 3 of 3, worst first; line 2, part A1");
    assert_eq!(window.state().session().text(CheckField::Measured), "");
}

#[test]
fn hole_or_shaft_is_said_after_the_verdict_by_label() {
    let mut window = window();
    let rows = b"id,callout,measured\nA,12 \xc2\xb10.02,12.05\nB,12 \xc2\xb10.02,11.95\nC,12 \xc2\xb10.02,12.01\n";
    let when = jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0);
    let imported = fitcheck::exchange::import("parts.csv", rows, window.state().session().sources(), when);
    let ctx = window.ctx.clone();
    let command = CheckCommand::Imported { name: "parts.csv".to_owned(), result: Ok(Box::new(imported)) };
    window.state_mut().send(&ctx, command.into());
    window.run();
    assert!(verdict(&window).starts_with("OUT OF LIMITS. 12.050 mm"), "{}", verdict(&window));
    window.get_by_label("2 values wait for hole or shaft:");
    // For the value on screen alone.
    window.get_by_role_and_label(Role::RadioButton, "Shaft").click();
    window.run();
    assert!(verdict(&window).starts_with("REWORK. 12.050 mm"), "{}", verdict(&window));
    window.get_by_label("One value waits for hole or shaft:");
    // For all that still wait.
    window.get_by_role_and_label(Role::Button, "All are holes").click();
    window.run();
    for label in ["GOOD 1", "REWORK 2"] {
        window.get_by_label(label);
    }
    assert!(window.query_by_label("All are holes").is_none());
}

#[test]
fn nominal_size_and_class_make_the_callout() {
    let mut window = window();
    type_into(&mut window, "Nominal size", "40");
    window.get_by_role_and_label(Role::ComboBox, "Class").click();
    window.run();
    window.get_by_role_and_label(Role::Button, "JS9").click();
    window.run();
    assert_eq!(window.state().session().text(CheckField::Callout), "40 JS9");
    window.get_by_label("40.031");
}

#[test]
fn simulating_measures_with_contacts_and_fills_the_history() {
    let mut window = window();
    type_into(&mut window, "Callout", "25 H7");
    window.get_by_role_and_label(Role::RadioButton, "Simulate").click();
    window.run();
    window.get_by_role_and_label(Role::Button, "Measure").click();
    window.run();
    assert!(verdict(&window).starts_with("SIMULATED. GOOD"), "{}", verdict(&window));
    window.get_by_label("Status window, SIMULATED");
    let picture = window.get_by_role_and_label(Role::Image, "Contacts");
    let said = picture.accesskit_node().data().description().unwrap_or_default().to_owned();
    assert!(said.starts_with("4 contacts seen from above"), "{said}");
    window.get_by_label_contains("no form beyond ovality");
    window.get_by_label("1 check");
    let first = window.state().session().history().iter().next().unwrap().measurement.contacts.clone();
    window.get_by_role_and_label(Role::Button, "Measure").click();
    window.run();
    window.get_by_label("2 checks");
    assert_ne!(first, window.state().session().history().iter().nth(1).unwrap().measurement.contacts);
}

#[test]
fn a_refused_simulation_says_why_in_the_verdict_s_place_and_beside_the_field() {
    let mut window = window();
    type_into(&mut window, "Callout", "25 H7");
    let ctx = window.ctx.clone();
    let offset = CheckCommand::Type(CheckField::OffsetX, "100".into());
    for command in [offset, CheckCommand::MeasureBy(MeasureBy::Simulating)] {
        window.state_mut().send(&ctx, command.into());
    }
    assert!(window.query_by_role_and_label(Role::TextInput, "Offset X").is_none(), "the workpiece is folded");
    window.get_by_role_and_label(Role::TextInput, "Callout").focus();
    window.run();
    window.key_press(Key::Enter);
    window.run();
    let error = window.state().session().error(CheckField::OffsetX).map(ToString::to_string).unwrap();
    assert_eq!(verdict(&window), format!("No result. Nothing was measured. {error}"));
    window.get_by_role_and_label(Role::TextInput, "Offset X");
    assert_eq!(window.get_all_by_label(&error).count(), 2, "in the card and below the field");
    type_into(&mut window, "Offset X", "0");
    assert_eq!(verdict(&window), "No result. 25.000 … 25.021 mm");
}

#[test]
fn the_status_window_shows_what_the_mask_prints() {
    let mut window = window();
    check(&mut window, "25 H7", "25.012");
    window.get_by_label_contains("MINIMUM SIZE:  25.0000");
    window.get_by_role_and_label(Role::ComboBox, "Mask").click();
    window.run();
    window.get_by_label("Nederlands").click();
    window.run();
    window.get_by_label_contains("GEMETEN DIAMETER:  25.0120");
}

#[test]
fn clear_empties_the_result_and_keeps_the_history() {
    let mut window = window();
    check(&mut window, "25 H7", "25.012");
    window.get_by_role_and_label(Role::Button, "Clear").click();
    window.run();
    assert_eq!(verdict(&window), "No result. 25.000 … 25.021 mm");
    window.get_by_label("1 check");
}

#[test]
fn the_language_can_be_switched_while_running() {
    let mut window = window();
    check(&mut window, "25 H7", "25.012");
    window.get_by_role_and_label(Role::Button, "Menu").click();
    window.run();
    window.get_by_label("Language").click();
    window.run();
    window.get_by_label("Nederlands").click();
    window.run();
    assert_eq!(verdict(&window), "GOED. 25,012 mm. 12 µm boven minimum. 9 µm onder maximum");
    window.get_by_role_and_label(Role::TextInput, "Gemeten waarde");
    window.get_by_label_contains("STATUS VAN DE PASSING: GOED");
}

#[test]
fn a_parameter_out_of_range_says_its_range_beside_the_field() {
    let mut window = window();
    unfold(&mut window, "Probe position");
    type_into(&mut window, "First contact", "361");
    window.get_by_label_contains("Q325 STARTING ANGLE = 361°");
    type_into(&mut window, "First contact", "45,5");
    assert!(window.query_by_label_contains("Q325").is_none());
    type_into(&mut window, "Set-up clearance", "-1");
    window.get_by_label_contains("Q320 SET-UP CLEARANCE = −1 mm");
    type_into(&mut window, "Centre X", "abc");
    window.get_by_label_contains("abc is not a number");
}

#[test]
fn the_controls_tables_can_be_asked_instead_of_the_standard() {
    let mut window = window();
    type_into(&mut window, "Callout", "400.5 H7");
    window.get_by_label("from ISO 286, over 400 up to 500 mm");
    window.get_by_role_and_label(Role::Button, "Menu").click();
    window.run();
    window.get_by_label("Limits from").click();
    window.run();
    window.get_by_label_contains("The control's tables").click();
    window.run();
    window.get_by_label_contains("beyond table 82553_hole.tab");
    type_into(&mut window, "Callout", "25 H7");
    window.get_by_label("from built-in table 82553_hole.tab, over 18 up to 30 mm");
}

#[test]
fn pages_open_by_name_and_by_key() {
    let mut window = window();
    for (page, key) in [("Tables", Key::Num6), ("Cycles", Key::Num7), ("Fits", Key::Num4), ("Check", Key::Num1)] {
        window.key_press_modifiers(Modifiers::COMMAND, key);
        window.run();
        assert_eq!(window.query_by_role_and_label(Role::TextInput, "Measured value").is_some(), page == "Check");
        window.get_by_role_and_label(Role::Button, page).click();
        window.run();
        assert_eq!(window.query_by_role_and_label(Role::TextInput, "Measured value").is_some(), page == "Check");
    }
}

#[test]
fn a_callout_without_letters_is_judged_and_hole_or_shaft_can_be_said_afterwards() {
    let mut window = window();
    type_into(&mut window, "Callout", "12 +0.01 -0.015");
    window.get_by_label("from the callout itself");
    type_into(&mut window, "Measured value", "12.02");
    window.key_press(Key::Enter);
    window.run();
    assert!(verdict(&window).starts_with("OUT OF LIMITS. 12.020 mm"), "{}", verdict(&window));
    assert!(verdict(&window).contains("10 µm above maximum"), "{}", verdict(&window));
    window.get_by_role_and_label(Role::RadioButton, "Shaft").click();
    window.run();
    type_into(&mut window, "Measured value", "12.02");
    window.key_press(Key::Enter);
    window.run();
    assert!(verdict(&window).starts_with("REWORK. 12.020 mm. Remove 10 µm"), "{}", verdict(&window));
    // The same size as a hole is scrap, and the old verdict does not stay.
    window.get_by_role_and_label(Role::RadioButton, "Hole").click();
    window.run();
    assert!(verdict(&window).starts_with("No result"), "{}", verdict(&window));
    type_into(&mut window, "Measured value", "12.02");
    window.key_press(Key::Enter);
    window.run();
    assert!(verdict(&window).starts_with("SCRAP"), "{}", verdict(&window));
    // A class says it itself, and the next callout without letters is of neither again.
    type_into(&mut window, "Callout", "25 H7");
    type_into(&mut window, "Callout", "10m");
    check(&mut window, "10m", "10.25");
    assert!(verdict(&window).starts_with("OUT OF LIMITS"), "{}", verdict(&window));
}

#[test]
fn one_part_of_a_fit_is_checked() {
    let mut window = window();
    type_into(&mut window, "Callout", "25 H7/g6");
    window.get_by_role_and_label(Role::RadioButton, "Shaft").click();
    window.run();
    check(&mut window, "25 H7/g6", "24.99");
    assert!(verdict(&window).starts_with("GOOD. 24.990 mm"), "{}", verdict(&window));
    let record = window.state().session().history().iter().next().unwrap();
    assert_eq!(record.callout.map(|callout| callout.to_string()), Some("25 g6".to_owned()));
}

#[test]
fn enter_in_the_callout_leads_to_the_value() {
    let mut window = window();
    scan(&mut window, "20 h6⏎");
    assert_eq!(window.state().session().text(CheckField::Callout), "20 h6");
    window.get_by_label_contains("Type the measured value");
    scan(&mut window, "19.992⏎");
    assert_eq!(window.state().session().text(CheckField::Callout), "20 h6");
    assert!(verdict(&window).starts_with("GOOD. 19.992 mm"), "{}", verdict(&window));
}

#[test]
fn the_field_of_the_value_stands_still_whatever_the_callout_says() {
    let mut window = window();
    let top = |window: &Harness<'_, App>| {
        format!("{:.0}", window.get_by_role_and_label(Role::TextInput, "Measured value").rect().top())
    };
    let first = top(&window);
    for callout in ["25 H7", "20 h6", "18 ±0.02", "25 Q99", ""] {
        type_into(&mut window, "Callout", callout);
        assert_eq!(top(&window), first, "{callout}");
    }
}

#[test]
fn the_search_field_stays_in_the_middle_of_the_bar() {
    let mut window = Window { size: eframe::egui::vec2(1920.0, 1080.0), ..Window::default() }.open();
    let middle = |window: &Harness<'_, App>| {
        let rail = window.get_all_by_role_and_label(Role::Button, "Check").map(|node| node.rect().right());
        let field = window.get_by_role_and_label(Role::Button, "Search or do anything").rect();
        // A page may have such a button, too; the rail is left of it.
        let bar = f32::midpoint(rail.fold(f32::INFINITY, f32::min), 1920.0);
        (field.center().x - bar).round()
    };
    assert!(middle(&window).abs() < 0.01);
    check(&mut window, "25 H7", "25.012");
    let ctx = window.ctx.clone();
    for rule in fitcheck::verdict::rules::RuleName::ALL {
        window.state_mut().send(&ctx, CheckCommand::UseRule(rule).into());
        for frame in 0..4 {
            window.step();
            assert!(middle(&window).abs() < 0.01, "{rule:?}, frame {frame}");
        }
    }
    for page in Page::ALL {
        window.state_mut().send(&ctx, Command::OpenPage(page));
        window.step();
        assert!(middle(&window).abs() < 0.01, "{page:?}");
    }
}
