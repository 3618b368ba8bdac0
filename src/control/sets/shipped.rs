//! The programs of NC-Solution 8255 as they are shipped: our own words after the seed's description
//! (`000_2e707c2d138629e0.txt`), label by label, parameter by parameter.
//!
//! Two parameters and a label's worth are ours: Q61, the clearance height that the seed leaves open; QS4 and QS5, the
//! parts of QS2; and behind LBL 16 an error where the cycle has set no marker, instead of running on into GOOD.

use crate::words::Language;

macro_rules! programs {
    ($($name:literal)*) => {
        [$(($name, include_bytes!(concat!("../../../assets/nc/", $name)).as_slice())),*]
    };
}

const PROGRAMS: [(&str, &[u8]); 8] = programs!(
    "8255_nl.h" "82551_nl.h" "8255_en.h" "82551_en.h" "8255_de.h" "82551_de.h" "8255_it.h" "82551_it.h"
);

/// The shipped programs: name and bytes.
pub const fn shipped_programs() -> &'static [(&'static str, &'static [u8])] {
    &PROGRAMS
}

/// The bytes of a shipped program by its file name, in any case.
pub fn shipped_program(name: &str) -> Option<&'static [u8]> {
    PROGRAMS.iter().find(|(known, _)| known.eq_ignore_ascii_case(name)).map(|(_, bytes)| *bytes)
}

/// Main program and called program of a language, and its mask.
pub(super) const fn originals(language: Language) -> [&'static [u8]; 3] {
    let [main_nl, check_nl, main_en, check_en, main_de, check_de, main_it, check_it] = PROGRAMS;
    match language {
        Language::Nl => [main_nl.1, check_nl.1, include_bytes!("../../../assets/masks/82552_nl.a")],
        Language::En => [main_en.1, check_en.1, include_bytes!("../../../assets/masks/82552_en.a")],
        Language::De => [main_de.1, check_de.1, include_bytes!("../../../assets/masks/82552_de.a")],
        Language::It => [main_it.1, check_it.1, include_bytes!("../../../assets/masks/82552_it.a")],
    }
}
