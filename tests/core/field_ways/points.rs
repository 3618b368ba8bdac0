//! Logs of points in 3-D: ten pages, each with the deviation that was probed and what is right of it.

use fitcheck::control::point_log::PointLog;
use fitcheck::length::Unit;
use fitcheck::words::Dialogue;

use super::ways::{answers_of, program};
use crate::point_log::{page, point};

/// A page: its point, its language, how its text becomes bytes, and the verdict by its own tolerance and by that of a plan, +0.4 −0.1.
struct Page {
    deviation: &'static str,
    unit: Unit,
    has_tolerance: bool,
    is_simulated: bool,
    language: Dialogue,
    is_crlf: bool,
    right: &'static str,
    by_plan: &'static str,
}

const PAGE: Page = Page {
    deviation: "0",
    unit: Unit::Millimetre,
    has_tolerance: true,
    is_simulated: false,
    language: Dialogue::En,
    is_crlf: false,
    right: "GOOD",
    by_plan: "GOOD",
};

const PAGES: [Page; 10] = [
    PAGE,
    Page { deviation: "0.4", language: Dialogue::De, ..PAGE },
    Page { deviation: "0.400001", right: "REWORK", by_plan: "REWORK", ..PAGE },
    Page { deviation: "-0.1", language: Dialogue::It, ..PAGE },
    Page { deviation: "-0.100001", right: "SCRAP", by_plan: "SCRAP", ..PAGE },
    Page { deviation: "-0.2", is_crlf: true, right: "SCRAP", by_plan: "SCRAP", ..PAGE },
    Page { deviation: "0.127", unit: Unit::Inch, ..PAGE },
    Page { deviation: "0.5", unit: Unit::Inch, language: Dialogue::Nl, right: "REWORK", by_plan: "REWORK", ..PAGE },
    Page { deviation: "0.1", has_tolerance: false, right: "", ..PAGE },
    Page { deviation: "0.3", is_simulated: true, ..PAGE },
];

const PLAN: &str = "fitcheck_plan = 1\n[[feature]]\nname = \"P\"\nkind = \"point\"\naxis = \"-Z\"\ncallout = \"+0.4 -0.1\"\n\
                    x = 35\ny = -45.5\nz = 5\n";

#[test]
fn logs_of_points_are_the_same_in_every_way() {
    let place = tempfile::tempdir().unwrap();
    let folder = place.path().join("in");
    std::fs::create_dir(&folder).unwrap();
    let put = |name: &str, bytes: &[u8]| fitcheck::files::write(&place.path().join(name), bytes).unwrap();
    put("plan.toml", PLAN.as_bytes());
    let names: Vec<String> = (0..PAGES.len()).map(|at| format!("p{at}.html")).collect();
    for (name, case) in names.iter().zip(&PAGES) {
        let log = PointLog { unit: case.unit, is_simulated: case.is_simulated, ..point(case.deviation) };
        let log = if case.has_tolerance { log } else { PointLog { band: None, status: None, ..log } };
        let text = page(&[log], case.language);
        let text = if case.is_crlf { text.replace('\n', "\r\n") } else { text };
        put(name, text.as_bytes());
        fitcheck::files::write(&folder.join(name), text.as_bytes()).unwrap();
    }
    let verdict = |name: &str, out: &str| {
        let said = answers_of(name, out);
        let [one] = said.as_slice() else { panic!("{name}: {out}") };
        (
            one.measured.unwrap().to_string(),
            if one.verdict.starts_with('!') { String::new() } else { one.verdict.clone() },
        )
    };
    let (_, watched, _) =
        program(place.path(), &["watch", "in", "--until-idle", "2", "--format", "csv", "--journal", "w.sqlite"]);
    for (name, case) in names.iter().zip(&PAGES) {
        let of = |verdict: &str| (case.deviation.to_owned(), verdict.to_owned());
        let (_, out, err) = program(place.path(), &["import", name, "--format", "csv"]);
        assert_eq!(verdict(name, &out), of(case.right), "import {name}: {out}{err}");
        let (_, out, err) = program(place.path(), &["import", name, "--format", "csv", "--plan", "plan.toml"]);
        assert_eq!(verdict(name, &out), of(case.by_plan), "import --plan {name}: {out}{err}");
        assert_eq!(verdict(name, &watched), of(case.right), "watch {name}: {watched}");
    }
}
