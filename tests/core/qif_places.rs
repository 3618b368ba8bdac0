//! Which features of a QIF file have a position for a measuring cycle.

use fitcheck::exchange::{ImportInputs, read_plan};
use fitcheck::tolerance::Sources;

const FILE: &str = include_str!("../data/qif/minimal_bore_25H7_limitsandfits.qif");

/// Whether the bore of a file has a position, and what is said of it.
#[track_caller]
fn plan_of(text: &str) -> (Vec<String>, Vec<String>) {
    let sources = Sources::default();
    let given = ImportInputs::new(&sources, jiff::civil::DateTime::default());
    let document = read_plan("a.qif", text.as_bytes(), given).unwrap();
    let row = &document.draft.rows[0];
    let place = [fitcheck::part::Column::X, fitcheck::part::Column::Y, fitcheck::part::Column::Z];
    let place = place.into_iter().map(|column| row.text(column).unwrap_or_default().to_owned()).collect();
    (place, document.remarks.iter().map(ToString::to_string).collect())
}

#[test]
fn a_bore_along_another_axis_has_no_position_for_a_cycle() {
    let none = vec![String::new(); 3];
    assert_eq!(plan_of(FILE), (["50", "50", "-5"].map(str::to_owned).to_vec(), vec![]));
    let (place, said) = plan_of(&FILE.replace("<Normal>0 0 1</Normal>", "<Normal>1 0 0</Normal>"));
    assert_eq!(place, none);
    assert_eq!(
        said,
        ["line 45: BORE1 25 H7: no position was taken over: it lies along 1 0 0, but cycles 421 and 422 probe along Z"]
    );
    // From below, and with the noise of doubles, it is the same axis.
    for normal in ["0 0 -1", "6.1e-17 -0.0 1.000"] {
        let (place, said) = plan_of(&FILE.replace("<Normal>0 0 1<", &format!("<Normal>{normal}<")));
        assert_eq!((place, said.len()), (["50", "50", "-5"].map(str::to_owned).to_vec(), 0), "{normal}");
    }
    for (from, to, why) in [
        ("<Normal>0 0 1</Normal></CircleFeatureNominal>", "</CircleFeatureNominal>", "does not say along which axis"),
        ("<Normal>0 0 1<", "<Normal>0 0.7071 0.7071<", "it lies along 0 0.7071 0.7071"),
        (
            "<Location>50 50 -5</Location><Normal>0 0 1</Normal></CircleFeatureNominal>",
            "<Axis><AxisPoint>50 50 -5</AxisPoint><Direction>0 1 0</Direction></Axis></CircleFeatureNominal>",
            "it lies along 0 1 0",
        ),
        ("</FeatureName>", "</FeatureName><CoordinateSystemId>33</CoordinateSystemId>", "coordinate system 33"),
    ] {
        let text = FILE.replace(from, to);
        assert_ne!(text, FILE);
        let (place, said) = plan_of(&text);
        assert_eq!(place, none, "{to}");
        assert!(said.len() == 1 && said[0].contains(why), "{said:?}");
    }
    let sphere = FILE
        .replace("CircleFeatureNominal", "SphereFeatureNominal")
        .replace("<Normal>0 0 1</Normal></Sphere", "</Sphere");
    let (place, said) = plan_of(&sphere);
    assert_eq!(place, none);
    assert!(said[0].contains("sphere: cycles 421 and 422"), "{said:?}");
}

#[test]
fn a_system_that_changes_nothing_keeps_the_position() {
    let with = |transform: &str| {
        let system = format!(
            "<CoordinateSystems><CoordinateSystemDefinitions n=\"1\"><CoordinateSystem id=\"33\"><Name>A</Name>{transform}</CoordinateSystem></CoordinateSystemDefinitions></CoordinateSystems>\n  <Features>"
        );
        let text = FILE.replace("</FeatureName>", "</FeatureName><CoordinateSystemId>33</CoordinateSystemId>");
        plan_of(&text.replace("<Features>", &system)).1
    };
    let same = "<NominalTransform><Rotation><XDirection>1 0 0</XDirection><YDirection>0 1 0</YDirection><ZDirection>0 0 1</ZDirection></Rotation><Origin>0 0 0</Origin></NominalTransform>";
    assert!(with(same).is_empty());
    assert!(with("<NominalTransform></NominalTransform>").is_empty());
    for other in [
        "",
        &same.replace("0 0 0", "0 0 5"),
        &same.replace("1 0 0", "0 1 0").replace("<YDirection>0 1 0", "<YDirection>-1 0 0"),
    ] {
        assert_eq!(with(other).len(), 1, "{other}");
    }
}
