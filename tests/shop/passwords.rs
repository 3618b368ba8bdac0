//! Where a password is looked for, in which order, and that it goes nowhere else.

use std::path::PathBuf;

use fitcheck::files;
use fitcheck::store::shop::{Access, Password, PasswordRemark, Places, ShopAddress, pgpass};
use tempfile::TempDir;

const LOGIN: [&str; 4] = ["shop.example", "5432", "checks", "station3"];

#[test]
fn a_password_file_is_read_as_postgresql_reads_it() {
    let cases = [
        ("shop.example:5432:checks:station3:secret", Some("secret")),
        ("shop.example:5432:checks:station3:secret\r\n", Some("secret")),
        ("*:*:*:*:secret", Some("secret")),
        ("# *:*:*:*:remark\nother:*:*:*:a\n*:*:*:station3:b\n*:*:*:*:c", Some("b")),
        (r"*:*:*:station3:a\:b\\c", Some(r"a:b\c")),
        (r"*:*:*:station3:a b:rest", Some("a b")),
        (r"*:*:*:\station3:secret", Some("secret")),
        (r"\*:*:*:*:secret", None),
        ("shop.example:5433:checks:station3:secret", None),
        ("shop.example:5432:checks:station:secret", None),
        ("SHOP.EXAMPLE:5432:checks:station3:secret", None),
        ("shop.example:5432:checks:station3", None),
        ("shop.example:5432:checks:station3:", None),
        ("", None),
        (":::::", None),
        ("\\", None),
    ];
    for (text, password) in cases {
        assert_eq!(pgpass::find(text, LOGIN).as_deref(), password, "{text:?}");
    }
    assert_eq!(pgpass::find("localhost:*:*:*:s", ["/run/postgresql", "5432", "c", "a"]).as_deref(), Some("s"));
    assert_eq!(pgpass::find("/srv/pg:*:*:*:s", ["/srv/pg", "5432", "c", "a"]).as_deref(), Some("s"));
    assert_eq!(pgpass::find("localhost:*:*:*:s", ["/srv/pg", "5432", "c", "a"]), None);
}

fn secret(text: &str) -> Password {
    Password::new(text.to_owned())
}

fn file(folder: &TempDir, mode: u32) -> PathBuf {
    let path = folder.path().join("pgpass");
    files::write(&path, b"*:*:*:station3:from the file\n").unwrap();
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt as _;
        std::fs::set_permissions(&path, std::fs::Permissions::from_mode(mode)).unwrap();
    }
    path
}

#[test]
fn the_first_place_that_has_a_password_gives_it() {
    let folder = tempfile::tempdir().unwrap();
    let path = file(&folder, 0o600);
    let of_keyring = Places {
        keyring: |service, user| {
            assert_eq!((service, user), ("fitcheck", "postgres://station3@shop.example/checks"));
            Ok(Some(Password::new("from the keyring".to_owned())))
        },
        ..Places::none()
    };
    let of_file = Places { file: Some(path), ..of_keyring.clone() };
    let of_environment = Places { environment: Some(secret("from the environment")), ..of_file.clone() };
    let cases = [
        (Some(secret("given")), of_environment.clone(), secret("given")),
        (None, of_environment, secret("from the environment")),
        (None, of_file, secret("from the file")),
        (None, of_keyring, secret("from the keyring")),
    ];
    for (given, places, expected) in cases {
        let (address, none) = ShopAddress::read("postgres://station3@shop.example/checks").unwrap();
        assert_eq!(none, None);
        let access = Access::find(address.clone(), given, &places);
        assert_eq!(access, Access::find(address, Some(expected), &Places::none()));
        let debug = format!("{access:?} {access:#?} {places:?}");
        assert!(!debug.contains("from") && !debug.contains("given"), "{debug}");
    }
    let (_, password) = ShopAddress::read("postgres://a:s%3Acr%2Fet@h/d").unwrap();
    assert_eq!(password, Some(secret("s:cr/et")));
    let (_, password) = ShopAddress::read("postgres://a@h/d?password=s%26t").unwrap();
    assert_eq!(password, Some(secret("s&t")));
}

#[test]
#[cfg(unix)]
fn a_password_file_that_others_may_read_is_passed_over_with_a_remark() {
    let folder = tempfile::tempdir().unwrap();
    for mode in [0o644, 0o640, 0o604, 0o666] {
        let path = file(&folder, mode);
        let (address, _) = ShopAddress::read("postgres://station3@shop.example/checks").unwrap();
        let places = Places { file: Some(path.clone()), ..Places::none() };
        let access = Access::find(address, None, &places);
        assert!(!access.has_password());
        assert_eq!(access.remarks, [PasswordRemark::Open { path }]);
    }
}

#[test]
fn a_keyring_that_does_not_answer_is_told_where_nothing_else_has_a_password() {
    let places = Places { keyring: |_service, _user| Err("no session".to_owned()), ..Places::none() };
    let address = || ShopAddress::read("postgres://station3@shop.example/checks").unwrap().0;
    let access = Access::find(address(), None, &places);
    assert_eq!(access.remarks, [PasswordRemark::NoKeyring { reason: "no session".to_owned() }]);
    let access = Access::find(address(), None, &Places { environment: Some(secret("a")), ..places });
    assert_eq!(access.remarks, []);
    let missing = Places { file: Some(PathBuf::from("/nowhere/pgpass")), ..Places::none() };
    assert_eq!(Access::find(address(), None, &missing).remarks, []);
}
