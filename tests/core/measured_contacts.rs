//! Measurements and contacts: what is reported about them, and what happens to contacts.

use fitcheck::length::Length;
use fitcheck::message::Say;
use fitcheck::probing::circle::CircleError;
use fitcheck::probing::{Caveat, Contact, NoContact, Origin, Prober as _, Recorded, Touch, measure_contacts};
use fitcheck::words::{Language, Words};

#[track_caller]
fn check(said: &(impl Say + std::fmt::Display), expected: &str) {
    assert_eq!(said.to_string(), expected);
    assert_eq!(Words::new(Language::En).told(said), expected);
    assert_ne!(Words::new(Language::Nl).told(said), said.message().id);
}

#[test]
fn every_origin_has_its_words() {
    check(&Origin::Simulated { cycle: 421, seed: 7 }, "simulated, cycle 421, seed 7");
    check(&Origin::Contacts { file: "bore.csv".into() }, "contacts from bore.csv");
    check(&Origin::Imported { file: "TCHPR421.TXT".into() }, "imported from TCHPR421.TXT");
    check(&Origin::Typed, "typed");
}

#[test]
fn every_caveat_has_its_words() {
    check(&Caveat::OnlyADiameter, "one diameter only: form and position are unknown");
    check(&Caveat::ThreeContacts, "3 contacts: form cannot be measured");
    check(&Caveat::FourContacts, "4 contacts: no form beyond ovality is detected");
    check(&Caveat::FewContacts { contacts: 12 }, "12 contacts: form between them is not detected");
    check(&Caveat::ShortArc { arc_deg: 120 }, "contacts cover only 120°: scatter is magnified in diameter and centre");
}

fn on_circle(count: u32, step_deg: f64) -> Vec<Contact> {
    let angles = (0..count).map(|k| (f64::from(k) * step_deg).to_radians());
    angles.map(|angle| Contact { x: 50.0 + 12.5 * angle.cos(), y: 12.5 * angle.sin(), z: -5.0 }).collect()
}

#[test]
fn contacts_become_a_diameter_in_whole_nanometres() {
    let measurement = measure_contacts(&on_circle(7, 50.0), Origin::Typed).unwrap();
    assert_eq!(measurement.diameter.nanometres(), 25_000_000);
    assert_eq!(measurement.centre.unwrap().map(Length::nanometres), [50_000_000, 0]);
    assert_eq!(measurement.caveats(), [Caveat::FewContacts { contacts: 7 }]);
    let short = measure_contacts(&on_circle(3, 60.0), Origin::Typed).unwrap();
    assert_eq!(short.caveats(), [Caveat::ThreeContacts, Caveat::ShortArc { arc_deg: 120 }]);
    let half = measure_contacts(&on_circle(3, 90.0), Origin::Typed).unwrap();
    assert_eq!(half.caveats(), [Caveat::ThreeContacts]);
    assert!(matches!(measure_contacts(&on_circle(2, 90.0), Origin::Typed), Err(CircleError::TooFew { contacts: 2 })));
}

#[test]
fn every_missing_contact_has_its_words() {
    check(&NoContact::Missed { number: 2 }, "contact 2: the probe met nothing on the probing path");
    let longest = Length::from_micrometres(2_000);
    check(
        &NoContact::OutOfReach { number: 3, longest },
        "contact 3: the probe met nothing within the probing path of 2 mm",
    );
    check(&NoContact::InMaterial { number: 1 }, "contact 1: the probing path begins inside the material");
    check(
        &NoContact::BeyondTravel { number: 1, distance: Length::from_micrometres(56_600), allowed: longest },
        "contact 1 lies 56.6 mm from where its probing begins, and the ball travels at most 2 mm (DIST or K, plus SET_UP of the \
         touch-probe table and Q320): check that these contacts are of this feature, in this order, and counted from this zero",
    );
    check(&NoContact::UsedUp { number: 4, available: 3 }, "contact 4: the file has only 3 contacts");
}

#[test]
fn a_record_is_handed_out_in_order_and_ends() {
    let contact = |x| Contact { x, y: 0.0, z: 0.0 };
    let mut recorded = Recorded::new(vec![contact(1.0), contact(2.0)]);
    let touch = Touch { from: [0.0; 3], direction: [1.0, 0.0, 0.0], longest: 10.0 };
    assert_eq!(recorded.touch(&touch), Ok(contact(1.0)));
    assert_eq!(recorded.touch(&touch), Ok(contact(2.0)));
    assert_eq!(recorded.touch(&touch), Err(NoContact::UsedUp { number: 3, available: 2 }));
    assert_eq!(recorded.touch(&touch), Err(NoContact::UsedUp { number: 4, available: 2 }));
}
