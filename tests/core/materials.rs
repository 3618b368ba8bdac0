//! Temperatures, how much parts grow, and the files of materials.

use fitcheck::length::Length;
use fitcheck::tolerance::fit::materials::{Certainty, Materials, MaterialsError};
use fitcheck::tolerance::fit::thermal::{Expansion, Temperature, Warm, clearance_change_apart, growth};
use fitcheck::words::Language;

fn mm(text: &str) -> Length {
    text.parse().unwrap()
}

#[test]
fn temperatures_are_worked_by_hand() {
    let warm = |expansion: &str, temperature: &str| Warm {
        expansion: expansion.parse().unwrap(),
        temperature: temperature.parse().unwrap(),
    };
    // 100 mm of aluminium at 25 °C: 23.1e-6 · 5 · 100 mm = 11.55 µm.
    assert_eq!(growth(mm("100"), warm("23.1", "25")), mm("0.01155"));
    // 25 mm, 6 K more: steel 1.725 µm, aluminium 3.465 µm.
    assert_eq!(growth(mm("25"), warm("11.5", "26")), mm("0.001725"));
    assert_eq!(growth(mm("25"), warm("23.1", "26 °C")), mm("0.003465"));
    // A steel ring of 50 mm at 220 °C over a cold pin at −30 °C: 115 µm and 28.75 µm.
    assert_eq!(clearance_change_apart(mm("50"), warm("11.5", "220"), warm("11.5", "-30")), mm("0.14375"));
    assert_eq!(clearance_change_apart(mm("50"), warm("11.5", "20"), warm("23.1", "20")), Length::ZERO);
    // 0.5 nm either way is rounded away from zero: 1 mm · 0.5e-6 · 1 K.
    assert_eq!(growth(mm("1"), warm("0.5", "21")), mm("0.000001"));
    assert_eq!(growth(mm("1"), warm("0.5", "19")), mm("-0.000001"));
    assert_eq!(growth(mm("1"), warm("0.499", "21")), Length::ZERO);
    assert_eq!(growth(mm("1"), warm("-0.5", "21")), mm("-0.000001"));
    let extreme = Warm { expansion: Expansion::MAX, temperature: Temperature::MAX };
    let cold = Warm { expansion: Expansion::MAX, temperature: Temperature::MIN };
    assert_eq!(clearance_change_apart(Length::MAX, extreme, cold), mm("636575000"));
}

#[test]
fn temperatures_and_expansions_read_as_they_print() {
    #[track_caller]
    fn temperature(text: &str, expected: &str) {
        let told = text.parse::<Temperature>().map(|found| found.to_string());
        assert_eq!(told.unwrap_or_else(|error| format!("! {error}")), expected, "for {text:?}");
    }
    temperature("20", "20");
    temperature("-0", "0");
    assert_eq!("21.5".parse::<Temperature>().map(Temperature::thousandths), Ok(21_500));
    temperature(" -40 °C ", "-40");
    temperature("\u{2212}0,5C", "-0.5");
    temperature("+85.125", "85.125");
    temperature("-273.15", "-273.15");
    temperature("1000.000", "1000");
    temperature("-273.151", "! a temperature of -273.151 °C is out of range: from -273.15 to 1000 °C");
    temperature("1000.001", "! a temperature of 1000.001 °C is out of range: from -273.15 to 1000 °C");
    temperature(
        "99999999999999999999",
        "! a temperature of 99999999999999999999 °C is out of range: from -273.15 to 1000 °C",
    );
    temperature("20.0001", "! 20.0001 has more than three decimals");
    temperature("", "!  is not a number");
    temperature("1.234,5", "! 1.234,5 is not a number");
    temperature("--1", "! --1 is not a number");
    temperature("20 F", "! 20 F is not a number");
    assert_eq!("11.5".parse::<Expansion>().unwrap().thousandths(), 11_500);
    assert_eq!("-0.101".parse::<Expansion>().unwrap().to_string(), "-0.101");
}

#[test]
fn shipped_materials_are_those_of_the_facts() {
    let shipped = Materials::shipped();
    let list: Vec<String> =
        shipped.iter().map(|m| format!("{} {} {}", m.name, m.expansion, m.certainty.word())).collect();
    assert_eq!(
        list,
        [
            "steel 11.5 published",
            "aluminium 23.1 published",
            "stainless steel 16 verify",
            "cast iron 10.5 verify",
            "brass 18.5 verify",
            "bronze 18 verify",
            "copper 16.5 verify",
            "titanium 8.6 verify",
            "magnesium 26 verify",
            "POM 110 verify",
            "carbide 5.5 verify",
            "invar 1.2 verify",
        ]
    );
    assert!(shipped.iter().all(|material| material.source.is_some()));
    assert_eq!(shipped.find("Staal").unwrap().name, "steel");
    assert_eq!(shipped.find(" CAST IRON ").unwrap().name_in(Language::Nl), "gietijzer");
}

#[test]
fn own_materials_replace_and_add() {
    let text = "version = 1\n[[material]]\nname = \"Steel\"\nexpansion = \"12,2\"\n[[material]]\nname = \"PE\"\nexpansion = 200\n";
    let both = Materials::shipped().with_own(Materials::read(text).unwrap());
    let steel = both.find("steel").unwrap();
    assert_eq!((steel.expansion.to_string(), steel.certainty), ("12.2".to_owned(), Certainty::Own));
    assert_eq!(both.iter().count(), 13);
    assert_eq!(both.find("pe").unwrap().expansion.to_string(), "200");
}

#[test]
fn blanks_around_a_name_do_not_belong_to_it() {
    let text = "version = 1\n[[material]]\nname = \" PE \"\nnames = { nl = \" Kunststof\" }\nexpansion = 200\n";
    let own = Materials::read(text).unwrap();
    assert_eq!(own.find("PE").unwrap().name, "PE");
    assert_eq!(own.find(" kunststof ").unwrap().name_in(Language::Nl), "Kunststof");
}

#[test]
fn files_of_materials_that_cannot_be_used_are_refused_with_their_line() {
    #[track_caller]
    fn check(text: &str, expected: &str) {
        assert_eq!(Materials::read(text).unwrap_err().to_string(), expected);
    }
    let steel = "version = 1\n\n[[material]]\nname = \"steel\"\nexpansion = 11.5\n";
    check("version = 2", "materials file version 2 is not supported: expected version 1");
    check(
        &format!("{steel}[[material]]\nname = \"STEEL\"\nexpansion = 1\n"),
        "line 7: material STEEL is defined twice",
    );
    // A name in another language would hide the other material.
    check(
        &format!("{steel}[[material]]\nname = \"stainless\"\nnames = {{ nl = \"Steel\" }}\nexpansion = 16\n"),
        "line 7: material Steel is defined twice",
    );
    check(&" ".repeat((1 << 20) + 1), "a materials file has at most 1048576 bytes");
    check(
        "version = 1\n[[material]]\nname = \" \"\nexpansion = 1",
        "line 3: a material's name has 1 to 60 characters and no control characters",
    );
    let many: Vec<String> =
        (0..1001).map(|number| format!("[[material]]\nname = \"m{number}\"\nexpansion = 1\n")).collect();
    check(&format!("version = 1\n{}", many.concat()), "1001 materials are too many: at most 1000");
    assert!(Materials::read(&format!("version = 1\n{}", many[..1000].concat())).is_ok());
    check(
        &steel.replace("11.5", "1150"),
        "line 5, column 13: an expansion of 1150 is out of range: from -20 to 500, in millionths per kelvin, such as 11.5 for steel",
    );
    check(
        &steel.replace("expansion", "alpha"),
        "line 5, column 1: unknown field `alpha`, expected one of `name`, `names`, `expansion`, `range`, `source`, `certainty`, `modulus`, `poisson`, `yield`, `contraction`",
    );
    let unknown = Materials::read(steel).unwrap().find("wood").unwrap_err();
    assert_eq!(
        unknown.to_string(),
        "unknown material wood: choose one of steel, or give the expansion itself, such as 11.5"
    );
    let is_toml_in_line = |text: &str, line| {
        let error = Materials::read(text).unwrap_err();
        matches!(error.what, MaterialsError::Toml { .. }) && error.place.line == Some(line)
    };
    assert!(is_toml_in_line("version = 1\nmaterial = 3", 2));
    assert!(is_toml_in_line(&steel.replace("11.5", "nan"), 5));
}
