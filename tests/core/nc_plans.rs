//! Plans of features as CSV, and the folders and controls that they are written for.

use fitcheck::nc::sets::{Control, ControlFolder, NcSet, Target};
use fitcheck::part::PlanFeature;
use fitcheck::tolerance::Sources;
use fitcheck::words::Dialogue;

use crate::plans::{plan, read};

#[track_caller]
fn check(text: &str, expected: &str) {
    let said = match read(text, &Sources::default()) {
        Ok(plan) => {
            let feature = |f: &PlanFeature| {
                let [x, y, z] = f.place.unwrap();
                format!(
                    "{} {} {} {} {} {} {} {}",
                    f.name,
                    f.kind.asked(),
                    x,
                    y,
                    z,
                    f.angle,
                    f.clearance,
                    f.clearance_height
                )
            };
            plan.features().iter().map(feature).collect::<Vec<_>>().join("; ")
        }
        Err(errors) => errors.join("; "),
    };
    assert_eq!(said, expected, "{text}");
}

#[test]
fn a_feature_a_line_in_any_order_of_columns() {
    check("callout,x,y,z\n25 H7,40,30,-8\n", "F1 25 H7 40 30 -8 0° 2 50");
    check(
        "\u{feff}Z;Y;X;Callout;Name;angle;clearance;clearance_height\r\n-8,5;30;40;25 H7;A_1;22,5;1;80\r\n\r\n;;;;;;;\r\n0;0;0;10g6\r\n",
        "A_1 25 H7 40 30 -8.5 22.5° 1 80; F2 10 g6 0 0 0 0° 2 50",
    );
    check("callout\tx\ty\tz\n\"25 H7\"\t1\t2\t3", "F1 25 H7 1 2 3 0° 2 50");
}

#[test]
fn what_is_wrong_is_told_with_its_line() {
    check("", "the plan has no features");
    check("callout,x,y,z\n", "the plan has no features");
    let known = fitcheck::part::Column::known();
    check("callout,x,y,z,depth\n", &format!("line 1: unknown column depth: the columns are {known}"));
    check("callout,x,y,z,X\n", "line 1: column x occurs twice");
    check(
        "callout,x,y,z\n25 H7,40,5,30,-8\n",
        "line 2: the row has 5 cells and the header 4: with a decimal comma, separate the columns with semicolons",
    );
    check("callout,x,y,z\n\n,1,2,3\n", "line 3: callout is missing");
    check("callout,x,y,z\n25 H7,a,30,0\n", "line 2: x: a is not a number");
    check(
        "callout,x,y,z\n25 H7,100000,30,0\n",
        "line 2: Q273 CENTER IN 1ST AXIS = 100000 mm: at least -99999.9999 mm, at most 99999.9999 mm",
    );
    check("callout,x,y,z,angle\n25 H7,1,30,0,361\n", "line 2: Q325 STARTING ANGLE = 361°: at most 360° either way");
    check("callout,x,y,z\n25 H7,1,30,50\n", "line 2: clearance height 50 mm is not above the measuring height, 50 mm");
    check(
        "name,callout,x,y,z\na,25 H7,1,2,3\nA,25 H7,1,2,3\n",
        "line 3: name A occurs twice, first on line 2: file names on a control ignore case",
    );
    check(
        "callout,x,y,z\n12 +0.02 -0.02,1,2,3\n",
        "line 2: 12 ±0.02 may be a hole or a shaft: add feature = \"hole\" or feature = \"shaft\", or kind = \"length\" where it is neither",
    );
    check("callout,x,y,z\n25 H7/g6,1,2,3\n", "line 2: 25 H7/g6 is a fit: write the hole and the shaft as two features");
    check(
        "callout,x,y,z\n25 H7x,1,2,3\n",
        "line 2: 25 H7x: H7x is not a tolerance class: write letters and a grade, such as H7 or js13 (character 4)",
    );
}

#[test]
fn what_a_control_cannot_measure_is_told_with_its_line() {
    let refused = |text: &str| {
        let made = NcSet::make(&plan(text), &Target::new(Control::Tnc7, Dialogue::En), &Sources::default());
        made.unwrap_err().to_string()
    };
    assert_eq!(refused("callout,x,y\n25 H7,1,2\n"), "line 2: F1 needs x, y and z: the program moves there");
    assert_eq!(
        refused("name,callout,x,y,z\na b,25 H7,1,2,3\n"),
        "line 2: name a b: letters A to Z, digits and _ are allowed, at most 20"
    );
    assert_eq!(
        refused("name,callout,x,y,z,parameters\nA,25 H7,1,2,3,Q423=3\n"),
        "line 2: A has its own cycle or parameters, which the called programs do not support"
    );
}

#[track_caller]
fn check_folder(folder: &str, expected: Option<&str>) {
    let read = folder.parse::<ControlFolder>().ok().map(|folder| folder.to_string());
    assert_eq!(read.as_deref(), expected, "{folder}");
}

#[test]
fn a_folder_is_below_the_drive_of_programs() {
    check_folder(r"TNC:\fit", Some(r"TNC:\fit\"));
    check_folder(r"tnc:\nc_prog\a-1\", Some(r"TNC:\nc_prog\a-1\"));
    check_folder(r"TNC:\", Some(r"TNC:\"));
    check_folder(r"TNC:fit", None);
    check_folder(r"C:\fit", None);
    check_folder(r"TNC:\fit\..\x", None);
    check_folder(r"TNC:\my fit", None);
    check_folder(r"TNC:\a\\b", None);
    check_folder("TNC:\\fit\n", Some(r"TNC:\fit\"));
    check_folder("TNC:\\fit\\;x", None);
    check_folder("é", None);
    check_folder("", None);
    check_folder(&format!(r"TNC:\{}", "x".repeat(80)), None);
}

#[test]
fn usual_folders_and_codes_read_back() {
    for control in Control::ALL {
        let folder = control.usual_folder();
        assert_eq!(folder.to_string().parse::<ControlFolder>().unwrap(), folder);
        assert_eq!(Control::from_code(control.code()), Some(control));
    }
    assert_eq!(Control::from_code("TNC620"), Some(Control::Tnc640));
    assert_eq!(Control::from_code("tnc426"), None);
}
