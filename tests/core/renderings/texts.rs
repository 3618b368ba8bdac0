//! Sentences about a check, in both languages.

use fitcheck::message::Message;
use fitcheck::report::text::{axis, feature, position, source};
use fitcheck::verdict::Status;

use super::*;

#[track_caller]
fn check(message: &Message, english: &str, dutch: &str) {
    assert_eq!(Words::new(Language::En).say(message), english);
    assert_eq!(Words::new(Language::Nl).say(message), dutch);
}

#[test]
fn english_words_are_those_of_the_machine_readable_files() {
    let words = Words::new(Language::En);
    for each in Status::ALL {
        assert_eq!(words.told(&each), each.word());
    }
    for each in [Feature::Hole, Feature::Shaft] {
        assert_eq!(words.say(&feature(Some(each))), each.word());
    }
}

#[test]
fn the_source_says_what_a_users_table_overrides() {
    let words = Words::new(Language::En);
    let table = |shipped, instead_of| Source::Table {
        name: "a.tab".into(),
        shipped,
        over: um(18_500),
        to: um(30_000),
        instead_of,
    };
    for each in [table(true, None), table(false, None), Source::File("TCHPR421.TXT".into())] {
        assert_eq!(words.say(&source(&each, &words)), each.to_string());
    }
    let standard = Deviations::new(um(21), um(-5)).ok();
    assert_eq!(
        words.say(&source(&table(false, standard), &words)),
        "table a.tab, over 18.5 up to 30 mm; ISO 286 says +21 and \u{2212}5 µm here"
    );
    let words = Words::new(Language::Nl);
    assert_eq!(words.say(&source(&table(true, None), &words)), "ingebouwde tabel a.tab, boven 18,5 tot en met 30 mm");
}

#[test]
fn each_axis_says_its_own() {
    let words = Words::new(Language::En);
    let one = |deviation, tolerance| AxisPosition { deviation: um(deviation), tolerance };
    check(
        &axis("X", &one(10, Some(um(10))), &words),
        "X +0.010 mm, permitted ± 0.010 mm: IN",
        "X +0.010 mm, toegestaan ± 0.010 mm: BINNEN",
    );
    check(
        &axis("Y", &one(-11, Some(um(10))), &words),
        "Y \u{2212}0.011 mm, permitted ± 0.010 mm: OUT",
        "Y \u{2212}0.011 mm, toegestaan ± 0.010 mm: BUITEN",
    );
    check(&axis("Y", &one(0, None), &words), "Y 0.000 mm: not monitored", "Y 0.000 mm: niet bewaakt");
}

#[test]
fn the_position_is_in_out_unmonitored_or_unknown() {
    let one = |deviation, tolerance| AxisPosition { deviation: um(deviation), tolerance };
    let both = |x, y| Some(PositionVerdict { axes: [x, y] });
    check(&position(None), "not measured", "niet gemeten");
    check(&position(both(one(5, None), one(0, None))), "not monitored", "niet bewaakt");
    check(&position(both(one(5, None), one(5, Some(um(5))))), "IN", "BINNEN");
    check(&position(both(one(5, Some(um(4))), one(0, None))), "OUT", "BUITEN");
}
