//! QIF 3.0: values, limits and labels of results; what is wrong with a file, and where.

use fitcheck::exchange::{FORMATS, Imported, Item, Labels, WhyUnjudged, import, import_each, sizes};
use fitcheck::journal::Record;
use fitcheck::length::Length;
use fitcheck::tolerance::{Feature, Sources};
use fitcheck::verdict::Status;
use jiff::civil::{DateTime, date};

const LIMITS: &str = include_str!("../data/qif/minimal_bore_25H7.qif");
const CLASS: &str = include_str!("../data/qif/minimal_bore_25H7_limitsandfits.qif");

const NOW: DateTime = date(2030, 1, 1).at(0, 0, 0, 0);

fn read(text: &str) -> Imported {
    import("a.qif", text.as_bytes(), &Sources::default(), NOW)
}

/// The sample with a part of it replaced.
#[track_caller]
fn with(from: &str, to: &str) -> String {
    assert!(LIMITS.contains(from), "{from}");
    LIMITS.replace(from, to)
}

fn mm(text: &str) -> Length {
    text.parse().unwrap()
}

#[track_caller]
fn only(imported: &Imported) -> &Record {
    assert_eq!(imported.errors, []);
    assert_eq!(imported.unjudged, []);
    let [record] = imported.records.as_slice() else { panic!("{} records", imported.records.len()) };
    record
}

fn warnings(imported: &Imported) -> Vec<String> {
    imported.warnings.iter().map(ToString::to_string).collect()
}

fn errors(imported: &Imported) -> Vec<String> {
    imported.errors.iter().map(ToString::to_string).collect()
}

/// The only error of a text.
#[track_caller]
fn refused(text: &str, error: &str) {
    let imported = read(text);
    assert_eq!(errors(&imported), [error]);
    assert_eq!(imported.records, []);
}

/// The records and their labels.
fn labelled(text: &str) -> Vec<(Record, Labels)> {
    let mut read = Vec::new();
    import_each("a.qif", text.as_bytes(), &Sources::default(), NOW, &mut |item| {
        if let Item::Record { record, labels, .. } = item {
            read.push((*record, labels));
        }
    });
    read
}

#[test]
fn both_samples_are_one_good_bore() {
    for (text, callout) in [(LIMITS, None), (CLASS, Some("25 H7"))] {
        let imported = read(text);
        let record = only(&imported);
        assert_eq!(record.id, "BORE1 25 H7");
        assert_eq!(record.callout.map(|callout| callout.to_string()).as_deref(), callout);
        let limits = &record.limits;
        assert_eq!((limits.feature, limits.nominal), (Some(Feature::Hole), mm("25")));
        assert_eq!((limits.minimum(), limits.maximum()), (mm("25"), mm("25.021")));
        assert_eq!(record.measurement.diameter, mm("25.0123"));
        assert_eq!(record.verdict.size.status, Status::Good);
        assert_eq!(record.time, date(2025, 1, 15).at(10, 21, 33, 0));
        assert_eq!(imported.lines, [61]);
        assert_eq!(
            warnings(&imported),
            [
                "line 61: the file states a combined standard uncertainty of 0.0012 and a mean error of 0: no rule uses them, so give --u instead"
            ]
        );
    }
}

#[test]
fn a_value_has_its_part_serial_number_and_place() {
    let text = with(
        "<MeasurementResults id=\"10\">",
        "<MeasurementResults id=\"10\"><InspectionTraceability><InspectionOperator><Name>Ann  B.</Name></InspectionOperator></InspectionTraceability>",
    );
    let text = text.replace(
        "<Name>BORE1 25 H7</Name>",
        "<CharacteristicDesignator><Designator>7.1</Designator></CharacteristicDesignator>",
    );
    let [(record, labels)] = &labelled(&text)[..] else { panic!() };
    assert_eq!(record.id, "7.1");
    assert_eq!((labels.number.as_str(), labels.part.as_str()), ("7.1", "PN-4711"));
    assert_eq!((labels.serial.as_str(), labels.who.as_str()), ("SN-0001", "Ann B."));
    assert_eq!(labels.place, [Some(mm("50")), Some(mm("50")), Some(mm("-5"))]);
    // Where nothing says where it should be, it is where it was found.
    let text = with("<Location>50 50 -5</Location>", "");
    let place = labelled(&text)[0].1.place;
    assert_eq!(place, [Some(mm("50.0012")), Some(mm("49.9987")), Some(mm("-5"))]);
}

#[test]
fn the_feature_tells_hole_from_shaft() {
    let shaft = with("INTERNAL", "EXTERNAL");
    assert_eq!(only(&read(&shaft)).limits.feature, Some(Feature::Shaft));
    let either = with("INTERNAL", "NOT_APPLICABLE");
    let judged = |text: &str| {
        let imported = read(text);
        let record = only(&imported);
        (record.limits.feature, record.verdict.status())
    };
    assert_eq!(judged(&either), (None, Status::Good));
    assert_eq!(judged(&either.replace("25.0123", "25.0223")), (None, Status::OutOfLimits));
    // The item may name its feature, and then the measured one is not needed.
    let named = with(
        "<CharacteristicNominalId>8",
        "<FeatureItemIds n=\"1\"><Id>5</Id></FeatureItemIds><CharacteristicNominalId>8",
    );
    let named = named.replace("<FeatureMeasurementIds n=\"1\"><Id>6</Id></FeatureMeasurementIds>", "");
    assert_eq!(only(&read(&named)).limits.feature, Some(Feature::Hole));
    // And so may the nominal.
    let nominal = with("<TargetValue>25", "<FeatureNominalIds n=\"1\"><Id>4</Id></FeatureNominalIds><TargetValue>25");
    let nominal = nominal.replace("<FeatureMeasurementIds n=\"1\"><Id>6</Id></FeatureMeasurementIds>", "");
    assert_eq!(only(&read(&nominal)).limits.feature, Some(Feature::Hole));
}

#[test]
fn a_class_and_its_zone_must_agree() {
    let shaft = CLASS.replace("zoneVariance=\"HOLE\"><FormVariance>H", "zoneVariance=\"SHAFT\"><FormVariance>g");
    assert_eq!(only(&read(&shaft)).callout.unwrap().to_string(), "25 g7");
    let odd = CLASS.replace("zoneVariance=\"HOLE\"", "zoneVariance=\"SHAFT\"");
    refused(
        &odd,
        "line 61, column 13: class H7 and SHAFT contradict each other: uppercase letters are holes, lowercase letters are shafts",
    );
}

#[test]
fn tolerances_are_limits_or_deviations_or_shared() {
    let deviations = with(
        "<MaxValue>25.021</MaxValue><MinValue>25.000</MinValue><DefinedAsLimit>true",
        "<MaxValue>0.021</MaxValue><MinValue>-0.004</MinValue><DefinedAsLimit>false",
    );
    let limits = &only(&read(&deviations)).limits.clone();
    assert_eq!((limits.minimum(), limits.maximum()), (mm("24.996"), mm("25.021")));
    // The feature has the nominal size where the characteristic has none.
    let deviations = deviations.replace("<TargetValue>25</TargetValue>", "");
    assert_eq!(only(&read(&deviations)).limits.nominal, mm("25"));
    let nothing = deviations.replace("<Diameter>25</Diameter>", "");
    refused(&nothing, "line 61, column 13: the limits are deviations, but there is no nominal size");
    let shared = with(
        "<CharacteristicDefinitions n=\"1\">",
        "<ToleranceDefinitions n=\"1\"><LinearTolerance id=\"15\"><MaxValue>25.021</MaxValue><MinValue>25</MinValue></LinearTolerance></ToleranceDefinitions><CharacteristicDefinitions n=\"1\">",
    );
    let shared = shared.replace(
        "<MaxValue>25.021</MaxValue><MinValue>25.000</MinValue><DefinedAsLimit>",
        "<DefinitionId>15</DefinitionId><DefinedAsLimit>",
    );
    assert_eq!(only(&read(&shared)).limits.maximum(), mm("25.021"));
    refused(
        &shared.replace("<DefinitionId>15", "<DefinitionId>16"),
        "line 61, column 13: LinearTolerance 16 is not in the file",
    );
    let one = with("<MinValue>25.000</MinValue>", "");
    assert_eq!(read(&one).unjudged[0].why, WhyUnjudged::OneLimit);
    let none = CLASS.replace(
        "<LimitsAndFitsSpecification zoneVariance=\"HOLE\"><FormVariance>H</FormVariance><Grade>7</Grade></LimitsAndFitsSpecification>",
        "<NonTolerance>MEASURED</NonTolerance>",
    );
    assert_eq!(read(&none).unjudged[0].why, WhyUnjudged::NoTolerance);
}

#[test]
fn units_are_those_of_the_file() {
    let unit =
        "<SIUnitName>meter</SIUnitName><UnitName>mm</UnitName><UnitConversion><Factor>0.001</Factor></UnitConversion>";
    let inch = with(
        unit,
        "<SIUnitName>meter</SIUnitName><UnitName>inch</UnitName><UnitConversion><Factor>0.0254</Factor></UnitConversion>",
    );
    let record = only(&read(&inch)).clone();
    assert_eq!((record.measurement.diameter, record.limits.nominal), (mm("635.31242"), mm("635")));
    let metres = with(unit, "<SIUnitName>meter</SIUnitName><UnitName>m</UnitName>");
    assert_eq!(only(&read(&metres)).measurement.diameter, mm("25012.3"));
    // Characteristics may have another unit than features.
    let pmi = with("</LinearUnit>", "</LinearUnit><PMILinearUnit><UnitName>inch</UnitName></PMILinearUnit>");
    let record = labelled(&pmi).remove(0);
    assert_eq!((record.0.limits.nominal, record.1.place[0]), (mm("635"), Some(mm("50"))));
    // And a value may name its own.
    let own = with("meanError=\"0\"", "meanError=\"0\" linearUnit=\"inch\"");
    assert_eq!(only(&read(&own)).measurement.diameter, mm("635.31242"));
    let unknown = with("meanError=\"0\"", "meanError=\"0\" linearUnit=\"ell\"");
    let hint =
        "the name is unknown, or does not match the factor; use mm, inch or another unit with its factor to metres";
    refused(&unknown, &format!("line 61, column 13: unit of length ell: {hint}"));
    refused(&with(unit, "<UnitName>ell</UnitName>"), &format!("line 12, column 3: unit of length ell: {hint}"));
    refused(
        &with("0.001</Factor>", "0.0254</Factor>"),
        &format!("line 12, column 3: unit of length mm 0.0254 meter: {hint}"),
    );
    refused(
        &with("<Factor>0.001</Factor>", "<Factor>0.001</Factor><Offset>1</Offset>"),
        &format!("line 12, column 3: unit of length mm 0.001 1 meter: {hint}"),
    );
    refused(
        &with(&format!("<LinearUnit>{unit}</LinearUnit>"), ""),
        "line 12, column 3: the file has no unit of length: it needs FileUnits with PrimaryUnits and LinearUnit",
    );
}

#[test]
fn figures_beyond_the_nanometre_are_rounded_and_told() {
    let fine = with("25.0123</Value>", "25.012300000000003</Value>");
    let imported = read(&fine);
    assert_eq!(only(&imported).measurement.diameter, mm("25.0123"));
    assert!(
        warnings(&imported).contains(
            &"line 61: 25.012300000000003 has digits beyond the nanometre: it is rounded to the nearest nanometre"
                .to_owned()
        )
    );
}

#[test]
fn another_verdict_of_the_file_is_told() {
    let told = |status: &str, value: &str| {
        let text = with("<CharacteristicStatusEnum>PASS", &format!("<CharacteristicStatusEnum>{status}"));
        let imported = read(&text.replace("25.0123</Value>", &format!("{value}</Value>")));
        only(&imported);
        warnings(&imported).into_iter().find(|warning| warning.contains("the file says"))
    };
    assert_eq!(told("PASS", "25.0123"), None);
    assert_eq!(told("BASIC_OR_TED", "25.0123"), None);
    assert_eq!(told("REWORK", "24.999"), None);
    // Software that knows no rework.
    assert_eq!(told("FAIL", "24.999"), None);
    assert_eq!(told("FAIL", "25.022"), None);
    for (status, value, ours) in
        [("FAIL", "25.0123", "GOOD"), ("PASS", "25.022", "SCRAP"), ("REWORK", "25.022", "SCRAP")]
    {
        let expected = format!("line 61: the file says {status}, but the limits say {ours}");
        assert_eq!(told(status, value), Some(expected));
    }
}

/// Statuses of the schema (`CharacteristicStatusEnumType`, `InspectionStatusEnumType`) that say that there is no valid value.
#[test]
fn a_value_that_the_software_could_not_determine_is_not_judged() {
    for status in
        ["SYSERROR", "INDETERMINATE", "NOT_ANALYZED", "UNDEFINED", "UNKNOWN", "NOT_CALCULATED", "NOT_MEASURED"]
    {
        let imported = read(&with("<CharacteristicStatusEnum>PASS", &format!("<CharacteristicStatusEnum>{status}")));
        let [unjudged] = imported.unjudged.as_slice() else { panic!("{imported:?}") };
        assert_eq!(unjudged.why, WhyUnjudged::NotValid { said: status.to_owned() });
        assert!(imported.records.is_empty());
    }
}

#[test]
fn other_lengths_are_judged_by_their_limits_and_are_no_sizes() {
    for kind in ["Position", "CircularRunout", "Depth"] {
        let other = LIMITS.replace("DiameterCharacteristic", &format!("{kind}Characteristic"));
        let imported = read(&other);
        let record = only(&imported);
        assert_eq!((record.limits.feature, record.verdict.status()), (None, Status::Good), "{kind}");
        let read = sizes("a.qif", other.as_bytes(), Feature::Hole);
        assert!(read.measured.is_empty(), "{kind}");
        assert!(read.errors[0].to_string().contains("this is not a size that can be paired"), "{kind}");
    }
}

#[test]
fn angles_are_set_aside_by_name() {
    let angle = LIMITS.replace("DiameterCharacteristic", "AngleCharacteristic");
    let imported = read(&angle);
    let [unjudged] = imported.unjudged.as_slice() else { panic!("{imported:?}") };
    assert_eq!((&unjudged.why, unjudged.measured), (&WhyUnjudged::NotASize { what: "angle".to_owned() }, None));
    assert_eq!(unjudged.id, "BORE1 25 H7");
    assert_eq!(
        sizes("a.qif", angle.as_bytes(), Feature::Hole).errors[0].to_string(),
        "line 61: angle: not a size of a hole or shaft: this is not a size that can be paired"
    );
}

#[test]
fn a_value_without_its_definition_or_number_is_refused() {
    let at = "line 61, column 13: ";
    refused(
        &with("<CharacteristicItemId>9", "<CharacteristicItemId>99"),
        &format!("{at}CharacteristicItem 99 is not in the file"),
    );
    refused(
        &with("<CharacteristicNominalId>8", "<CharacteristicNominalId>88"),
        &format!("{at}CharacteristicNominal 88 is not in the file"),
    );
    refused(
        &with("<CharacteristicDefinitionId>7", "<CharacteristicDefinitionId>77"),
        &format!("{at}CharacteristicDefinition 77 is not in the file"),
    );
    refused(&with("25.0123</Value>", "25,0l23</Value>"), &format!("{at}measured: 25,0l23 is not a number"));
    refused(
        &with("25.0123</Value>", "-25.0123</Value>"),
        &format!("{at}measured: a diameter of -25.0123 is not above 0"),
    );
    refused(&with("<MaxValue>25.021", "<MaxValue>INF"), &format!("{at}limits or nominal size: INF is not a number"));
    let text = with("<Value combinedUncertainty=\"0.0012\" meanError=\"0\">25.0123</Value>", "");
    refused(&text.replace("PASS</Char", "SYSERROR</Char"), &format!("{at}no measured value here; status SYSERROR"));
}

#[test]
fn lists_that_have_another_number_of_things_and_numbers_that_stand_twice_are_told() {
    let said = |text: &str| {
        warnings(&read(text)).into_iter().filter(|warning| !warning.contains("uncertainty")).collect::<Vec<_>>()
    };
    assert_eq!(
        said(&with("<CharacteristicMeasurements n=\"1\">", "<CharacteristicMeasurements n=\"2\">")),
        ["line 60, column 11: CharacteristicMeasurements says n=2, but has 1: something may be missing or added"]
    );
    let twice = with(
        "<CharacteristicItems n=\"1\">",
        "<CharacteristicItems n=\"2\"><DiameterCharacteristicItem id=\"9\"><Name>other</Name><CharacteristicNominalId>8</CharacteristicNominalId></DiameterCharacteristicItem>",
    );
    assert_eq!(said(&twice), ["line 45, column 7: id 9 occurs twice: the first element is used"]);
    assert_eq!(
        said(&with("versionQIF=\"3.0.0\"", "versionQIF=\"1.0.0\"")),
        ["line 2, column 1: QIF version 1.0.0: this program is made for versions 2.0, 2.1 and 3.0"]
    );
    let timeless = with("<TimeStamp>2025-01-15T10:21:33</TimeStamp>", "");
    let imported = read(&timeless);
    assert_eq!(only(&imported).time, NOW);
    assert_eq!(said(&timeless), ["line 1: no date and time here: the time of import is used"]);
    let offset = with("10:21:33</TimeStamp>", "10:21:33.5+01:00</TimeStamp>");
    assert_eq!(
        said(&offset),
        ["line 61: 2025-01-15T10:21:33.5+01:00 is stored as local time without its offset from UTC"]
    );
    assert_eq!(only(&read(&offset)).time, date(2025, 1, 15).at(10, 21, 33, 500_000_000));
    let inspection = timeless.replace("<MeasurementResults id=\"10\">", "<MeasurementResults id=\"10\"><InspectionTraceability><InspectionEnd>2025-01-16T00:00:00Z</InspectionEnd></InspectionTraceability>");
    assert_eq!(only(&read(&inspection)).time, date(2025, 1, 16).at(0, 0, 0, 0));
}

#[test]
fn any_encoding_prefix_and_line_end_will_do() {
    let expected = only(&read(LIMITS)).clone();
    let check = |bytes: &[u8]| {
        for name in ["a.qif", "a.xml", "a.txt", "a.csv"] {
            let found = FORMATS.iter().find(|format| format.recognises(bytes, name)).map(|format| format.name);
            assert_eq!(found, Some("qif"));
        }
        let imported = import("a.qif", bytes, &Sources::default(), NOW);
        assert_eq!(only(&imported).clone(), expected);
    };
    check(LIMITS.replace('\n', "\r\n").as_bytes());
    check(format!("\u{feff}{LIMITS}").as_bytes());
    check(LIMITS.replace("UTF-8", "ISO-8859-1").as_bytes());
    let utf16 = LIMITS.replace("UTF-8", "UTF-16");
    for bom in ["\u{feff}", ""] {
        check(&format!("{bom}{utf16}").encode_utf16().flat_map(u16::to_le_bytes).collect::<Vec<_>>());
        check(&format!("{bom}{utf16}").encode_utf16().flat_map(u16::to_be_bytes).collect::<Vec<_>>());
    }
    // A sign that is none in XML is none of the decoder's.
    check(
        &LIMITS
            .replace("UTF-8", "UTF-16")
            .replace("<Product", "<Product n=\"\u{f}\"")
            .encode_utf16()
            .flat_map(u16::to_le_bytes)
            .collect::<Vec<_>>(),
    );
    let prefixed = LIMITS.replace("</", "</q:").replace("xmlns=", "xmlns:q=");
    let prefixed = regex_lite(&prefixed);
    check(prefixed.as_bytes());
    let latin = LIMITS.replace("UTF-8", "windows-1252").replace("BORE1 25 H7", "Bohrung \u{d8}");
    let bytes: Vec<u8> = latin.chars().map(|c| u8::try_from(u32::from(c)).unwrap()).collect();
    assert_eq!(only(&import("a.qif", &bytes, &Sources::default(), NOW)).id, "Bohrung \u{d8}");
    // The same bytes are not UTF-8.
    let bytes = String::from_utf8_lossy(&bytes).replace("windows-1252", "UTF-8").into_bytes();
    assert_eq!(only(&import("a.qif", &bytes, &Sources::default(), NOW)).id, "Bohrung \u{fffd}");
    let broken: Vec<u8> =
        latin.replace("windows-1252", "UTF-8").chars().map(|c| u8::try_from(u32::from(c)).unwrap()).collect();
    assert_eq!(
        errors(&import("a.qif", &broken, &Sources::default(), NOW)),
        ["line 45, column 48: these bytes are not text in the file's encoding"]
    );
    refused(
        &LIMITS.replace("UTF-8", "KLINGON-1"),
        "line 1: unknown encoding KLINGON-1: use UTF-8, UTF-16 or ISO 8859-1",
    );
}

/// Elements with the prefix `q`.
fn regex_lite(text: &str) -> String {
    let mut out = String::new();
    let mut before = ' ';
    for c in text.chars() {
        if before == '<' && c.is_ascii_alphabetic() {
            out.push_str("q:");
        }
        out.push(c);
        before = c;
    }
    out
}

#[test]
fn what_could_be_meant_badly_is_refused_with_its_place() {
    let head = "<?xml version=\"1.0\"?>\n";
    let laughs = format!(
        "{head}<!DOCTYPE QIFDocument [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;&a;&a;\">]>\n{}",
        LIMITS.split_once('\n').unwrap().1
    );
    refused(&laughs, "line 2, column 1: a DOCTYPE is not supported: remove it, or export the file without it");
    let entity = "entity b is not known: only &lt; &gt; &amp; &quot; and &apos; are supported";
    refused(&with("BORE1 25 H7", "BORE1 &b;"), &format!("line 45, column 54: {entity}"));
    assert_eq!(only(&read(&with("BORE1 25 H7", "B &lt;&amp;&#216;&#xD8;&gt;"))).id, "B <&\u{d8}\u{d8}>");
    assert_eq!(only(&read(&with("BORE1 25 H7", "<!-- no --><![CDATA[B<1>]]>"))).id, "B<1>");
    let deep = with("<Features>", &format!("<Features>{}", "<a>".repeat(1000)));
    refused(&deep, "line 23, column 607: nesting limit of 200 elements reached");
    let long = with("BORE1 25 H7", &"x".repeat(3 << 20));
    assert_eq!(errors(&read(&long)).len(), 1, "{:?}", errors(&read(&long)));
    // What nobody asks for may be long.
    let points = with("<Features>", &format!("<Features><Points>{}</Points>", "1 2 3 ".repeat(1 << 20)));
    only(&read(&points));
    let tag = with("<Features>", &format!("<Features {}>", "a=\"1\" ".repeat(1 << 20)));
    assert_eq!(errors(&read(&tag)), ["line 23, column 3: a tag or text is longer than 1024 KiB"]);
    refused(
        &with("</Features>", "</Feature>"),
        "line 33, column 3: not well-formed XML: ill-formed document: expected `</Features>`, but `</Feature>…",
    );
    refused(
        &with("<Results>", "<Rules><Results>"),
        "line 78, column 1: not well-formed XML: ill-formed document: expected `</Rules>`, but `</QIFDocument…",
    );
    refused(
        "<QIFDocument versionQIF='3.0.0'/>",
        "line 1: the file has no unit of length: it needs FileUnits with PrimaryUnits and LinearUnit",
    );
}

#[test]
fn a_plan_without_results_says_so() {
    let (before, rest) = LIMITS.split_once("  <Results>").unwrap();
    let plan = format!("{before}{}", rest.split_once("</Results>\n").unwrap().1);
    refused(&plan, "line 1: a QIF file without measured values: a plan can be read as a part plan");
}

#[test]
fn a_file_that_is_cut_off_anywhere_says_so() {
    let whole = read(LIMITS);
    let value =
        LIMITS.find("</DiameterCharacteristicMeasurement>").unwrap() + "</DiameterCharacteristicMeasurement>".len();
    for end in 0..LIMITS.trim_end().len() {
        let imported = read(LIMITS.get(..end).unwrap());
        assert_eq!(imported.errors.len(), 1, "{end}: {:?}", imported.errors);
        assert_eq!(imported.records.len(), usize::from(value <= end), "{end}");
        if value <= end {
            let [record] = imported.records.as_slice() else { panic!() };
            assert_eq!(record.verdict, whole.records[0].verdict);
        }
    }
    assert_eq!(
        errors(&read(LIMITS.get(..value).unwrap())),
        ["line 69, column 49: the file ends within an element: it may be cut off"]
    );
}

#[test]
fn many_values_are_read_one_by_one() {
    let begin = LIMITS.find("            <DiameterCharacteristicMeasurement ").unwrap();
    let end = LIMITS.find("          </CharacteristicMeasurements>").unwrap();
    let rows = LIMITS.get(begin..end).unwrap().repeat(20_000);
    let text = format!("{}{rows}{}", LIMITS.get(..begin).unwrap(), LIMITS.get(end..).unwrap())
        .replace("<CharacteristicMeasurements n=\"1\">", "<CharacteristicMeasurements n=\"20000\">");
    let imported = read(&text);
    assert_eq!((imported.records.len(), imported.rows, imported.errors.len()), (20_000, 20_000, 0));
    assert_eq!(imported.lines[19_999], 61 + 19_999 * 9);
}

#[test]
fn a_radius_is_no_value_of_a_diameter() {
    let radius = LIMITS.replace("DiameterCharacteristicMeasurement", "RadiusCharacteristicMeasurement");
    refused(
        &radius,
        "line 61, column 13: the measurement is of kind radius, but its characteristic is of kind diameter",
    );
}

#[test]
fn two_values_or_one_in_pieces_are_refused() {
    let (_, behind) = LIMITS.split_once("<Value").unwrap();
    let (value, _) = behind.split_once("</Value>").unwrap();
    let value = format!("<Value{value}</Value>");
    refused(&with(&value, &format!("{value}{value}")), "line 61, column 13: the measurement has several values");
    let [error] = errors(&read(&with(&value, "<Value>25.0<x>1</x>123</Value>"))).try_into().unwrap();
    assert!(error.ends_with("Value has an element in the middle of its text"), "{error}");
    assert_eq!(only(&read(&with(&value, "<Value>25.0<!-- -->123</Value>"))).measurement.diameter, mm("25.0123"));
}

#[test]
fn a_tolerance_must_say_whether_it_has_limits_or_deviations() {
    for text in ["", "<DefinedAsLimit></DefinedAsLimit>", "<DefinedAsLimit>yes</DefinedAsLimit>"] {
        refused(
            &with("<DefinedAsLimit>true</DefinedAsLimit>", text),
            "line 61, column 13: DefinedAsLimit is missing or neither true nor false, so the numbers may be limits or deviations",
        );
    }
}
