//! Addresses of servers: what is read, what is refused, and that no password is ever shown.

use fitcheck::store::is_server;
use fitcheck::store::shop::{AddressError, ShopAddress};

fn read(text: &str) -> ShopAddress {
    ShopAddress::read(text).unwrap_or_else(|error| panic!("{text}: {error}")).0
}

#[test]
fn an_address_is_told_from_a_file() {
    for text in ["postgres://a@b/c", "postgresql://a@b/c", " Postgres://a@b/c"] {
        assert!(is_server(text), "{text}");
    }
    for text in ["", "postgres", "journal.sqlite", "/tmp/postgres:", "C:\\journal.sqlite", "é"] {
        assert!(!is_server(text), "{text}");
    }
}

#[test]
fn an_address_prints_without_its_password() {
    let cases = [
        ("postgres://station3@shop.example/checks", "postgres://station3@shop.example/checks"),
        ("postgresql://station3:hidden@shop.example:5433/checks", "postgres://station3@shop.example:5433/checks"),
        ("postgres://station3@shop.example/checks?password=hidden", "postgres://station3@shop.example/checks"),
        (
            "postgres://station3@shop.example/checks?sslmode=verify-full&pass%77ord=hidden&sslrootcert=%2Fetc%2Fca.pem",
            "postgres://station3@shop.example/checks?sslmode=verify-full&sslrootcert=%2Fetc%2Fca.pem",
        ),
        ("postgres://station3:hid%40den@shop.example", "postgres://station3@shop.example"),
        ("postgres://station3:hidden@%2Ftmp%2Fpg/checks", "postgres://station3@%2Ftmp%2Fpg/checks"),
    ];
    for (given, shown) in cases {
        let (address, _password) = ShopAddress::read(given).unwrap();
        assert_eq!(address.to_string(), shown);
        assert_eq!(read(shown).to_string(), shown);
        let debug = format!("{address:?} {address:#?}");
        assert!(!debug.contains("hid"), "{debug}");
    }
}

#[test]
fn the_parts_of_an_address_are_those_of_the_client() {
    let address = read("postgres://st%C3%A4tion:x@shop.example:5433/checks?sslrootcert=%2Fetc%2Fca.pem");
    assert_eq!((address.user(), address.database(), address.port()), ("stätion", "checks", 5433));
    assert_eq!(address.host(), "shop.example");
    assert_eq!(address.authority(), Some(std::path::Path::new("/etc/ca.pem")));
    let address = read("postgres://station3@[::1]");
    assert_eq!((address.database(), address.port(), address.host().as_str()), ("station3", 5432, "::1"));
    assert_eq!(read("postgres://a@h/d?sslrootcert=system").authority(), None);
}

#[test]
fn another_machine_is_reached_by_tls_alone() {
    let plain = [
        "postgres://a@localhost/d",
        "postgres://a@LOCALHOST:5433/d?sslmode=prefer",
        "postgres://a@127.0.0.1/d",
        "postgres://a@127.8.9.10/d?sslmode=disable",
        "postgres://a@[::1]/d",
        "postgres://a@%2Frun%2Fpostgresql/d",
        "postgres://a@/d?host=/tmp",
        "postgres://a@/d?hostaddr=127.0.0.1",
        "postgres://a@localhost/d?hostaddr=127.0.0.1",
        "postgres://a@localhost,127.0.0.1/d",
    ];
    for text in plain {
        assert!(!read(text).is_tls(), "{text}");
    }
    let tls = [
        "postgres://a@shop.example/d",
        "postgres://a@shop.example/d?sslmode=prefer",
        "postgres://a@shop.example/d?sslmode=verify-ca",
        "postgres://a@localhost/d?sslmode=require",
        "postgres://a@localhost/d?sslmode=verify-full",
        "postgres://a@192.0.2.7/d",
        "postgres://a@128.0.0.1/d",
        "postgres://a@localhost.example/d",
        "postgres://a@localhost,shop.example/d",
        "postgres://a@shop.example/d?hostaddr=127.0.0.1",
        "postgres://a@localhost/d?hostaddr=192.0.2.7",
        "postgres://a@/d?hostaddr=192.0.2.7",
        "postgres://a@/d?host=shop.example",
    ];
    for text in tls {
        assert!(read(text).is_tls(), "{text}");
    }
}

#[test]
fn what_is_no_address_is_refused_without_repeating_it() {
    let plain = |host: &str| AddressError::Plain { host: host.to_owned() };
    let cases = [
        ("http://a:hidden@b/c", AddressError::Scheme),
        ("", AddressError::Scheme),
        ("postgres://a:hidden@/c", AddressError::NoHost),
        ("postgres://b/c", AddressError::NoUser),
        ("postgres://:hidden@b/c", AddressError::NoUser),
        ("postgres://a:hid@den@b/c", AddressError::At),
        ("postgres://a:hid/den@b/c", AddressError::At),
        ("postgres://a:hid?den@b/c", AddressError::At),
        ("postgres://b/c?password=hid@den", AddressError::At),
        ("postgres://a:hidden@b/c?sslmode=off", AddressError::Mode { given: "off".to_owned() }),
        ("postgres://a:hidden@shop.example/c?sslmode=disable", plain("shop.example")),
        ("postgres://a:hidden@localhost/c?sslmode=disable&hostaddr=192.0.2.7", plain("192.0.2.7")),
    ];
    for (text, error) in cases {
        assert_eq!(ShopAddress::read(text).map(|(address, _)| address), Err(error), "{text}");
    }
    for text in [
        "postgres://a:hidden@b:port/c",
        "postgres://hidden:hidden/c",
        "postgres://a:hidden@b/c?sslkey=hidden",
        "postgres://a:hidden@b/c?connect_timeout=hidden",
        "postgres://a:hidden@[b/c",
        "postgres://a:hidden@b:99999/c",
        "postgres://a:hidden@b/%FF",
        "postgres://a:hidden@b:1,c:2:3/c",
    ] {
        let error = ShopAddress::read(text).unwrap_err();
        assert!(matches!(error, AddressError::Unreadable { .. } | AddressError::NoUser), "{text}: {error:?}");
        assert!(!format!("{error} {error:?}").contains("hidden"), "{error:?}");
    }
}

#[test]
fn no_text_makes_reading_an_address_fail_in_another_way() {
    let signs = [
        "postgres://",
        "a",
        ":",
        "@",
        "/",
        "?",
        "=",
        "&",
        "%",
        "%4",
        "%40",
        "[",
        "]",
        ",",
        "é",
        "\0",
        "sslmode",
        "password",
    ];
    let mut state = 7_u64;
    for _ in 0..20_000 {
        let mut text = "postgres://".to_owned();
        for _ in 0..(state >> 33) % 12 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            text.push_str(signs[usize::try_from(state >> 33).unwrap() % signs.len()]);
        }
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        if let Ok((address, _)) = ShopAddress::read(&text) {
            let shown = address.to_string();
            let again = ShopAddress::read(&shown).unwrap_or_else(|error| panic!("{text} {shown}: {error}"));
            assert_eq!((again.0, again.1), (address, None), "{text}");
        }
    }
}
