//! TLS: the right certificate is accepted, every other one is refused, and nothing goes to another machine in plain text.

use std::path::{Path, PathBuf};

use fitcheck::files;
use fitcheck::store::shop::{CertificateFault, SchemaInit, ShopAddress, ShopError, ShopReader, Stop, init};

use crate::clusters::Cluster;
use crate::harness::{SHORT, Shop, access, server};

/// A server with a certificate for `shop.example` and 127.0.0.1.
fn certified() -> Option<(Cluster, PathBuf)> {
    let cluster = Cluster::alone()?;
    let certs = server("FITCHECK_TEST_PG_CERTS")?;
    Some((cluster, certs.into()))
}

/// An address by a name that is not this machine's, but leads here.
fn named(address: &str, host: &str, authority: &Path) -> String {
    format!("{}?hostaddr=127.0.0.1&sslrootcert={}", address.replace("127.0.0.1", host), authority.display())
}

#[test]
fn the_right_certificate_is_accepted() {
    let Some((cluster, certs)) = certified() else { return };
    let shop = Shop::on(&cluster.address, "");
    let address = named(&shop.address, "shop.example", &certs.join("authority.pem"));
    assert!(ShopAddress::read(&address).unwrap().0.is_tls());
    assert_eq!(init(&access(&address), SHORT), Ok(SchemaInit::New { version: 1 }));
    let _reader = ShopReader::open(&access(&address), SHORT, &Stop::default()).unwrap();
    let encrypted = "SELECT string_agg(DISTINCT ssl::text || version, ' ') FROM pg_stat_ssl JOIN pg_stat_activity USING (pid) \
                     WHERE application_name = 'fitcheck' AND datname = current_database()";
    assert_eq!(shop.text(encrypted), "trueTLSv1.3");
    // By its number too, and on this machine where it is asked for.
    for mode in ["require", "verify-ca", "verify-full"] {
        let address = format!("{}?sslmode={mode}&sslrootcert={}", shop.address, certs.join("authority.pem").display());
        assert_eq!(init(&access(&address), SHORT), Ok(SchemaInit::Already { version: 1 }), "{mode}");
    }
}

#[test]
fn every_other_certificate_is_refused_with_a_sentence() {
    let Some((cluster, certs)) = certified() else { return };
    let (right, wrong) = (certs.join("authority.pem"), certs.join("stranger.pem"));
    let by_system = cluster.address.replace("127.0.0.1", "shop.example") + "?hostaddr=127.0.0.1";
    let cases = [
        named(&cluster.address, "shop.example", &wrong),
        named(&cluster.address, "other.example", &right),
        format!(
            "{}?sslmode=verify-full&sslrootcert={}",
            cluster.address.replace("127.0.0.1", "localhost"),
            right.display()
        ),
        by_system,
    ];
    for address in cases {
        let error = init(&access(&address), SHORT).unwrap_err();
        assert!(matches!(error, ShopError::Certificate { .. } | ShopError::NoAuthorities), "{address}: {error:?}");
        assert!(!error.is_passing());
        let said = error.to_string();
        assert!(said.contains("certificate") || said.contains("authority"), "{said}");
    }
    let error = init(&access(&named(&cluster.address, "shop.example", &wrong)), SHORT).unwrap_err();
    assert_eq!(error, ShopError::Certificate { fault: CertificateFault::UnknownIssuer });
    assert_eq!(
        error.to_string(),
        "the certificate of the server is not accepted: it was not issued by an authority that this computer trusts; for a shop's own \
         authority, name its file with sslrootcert=FILE in the address"
    );
    let error = init(&access(&named(&cluster.address, "other.example", &right)), SHORT).unwrap_err();
    assert_eq!(error, ShopError::Certificate { fault: CertificateFault::OtherName });
}

#[test]
fn a_server_without_tls_gets_nothing_under_another_machines_name() {
    let Some(plain) = server("FITCHECK_TEST_PG") else { return };
    let authority = tempfile::tempdir().unwrap();
    let file = authority.path().join("authority.pem");
    let Some(certs) = server("FITCHECK_TEST_PG_CERTS") else { return };
    files::write(&file, &std::fs::read(Path::new(&certs).join("authority.pem")).unwrap()).unwrap();
    let error = init(&access(&named(&plain, "shop.example", &file)), SHORT).unwrap_err();
    assert_eq!((error.clone(), error.is_passing()), (ShopError::NoTls, false));
    let required = format!("{plain}?sslmode=require&sslrootcert={}", file.display());
    assert_eq!(init(&access(&required), SHORT), Err(ShopError::NoTls));
}

#[test]
fn a_file_of_authorities_that_cannot_be_used_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    files::write(&path("empty.pem"), b"").unwrap();
    files::write(&path("text.pem"), b"not a certificate").unwrap();
    files::write(&path("broken.pem"), b"-----BEGIN CERTIFICATE-----\n!!!\n-----END CERTIFICATE-----\n").unwrap();
    files::write(&path("other.pem"), b"-----BEGIN CERTIFICATE-----\nAAAA\n-----END CERTIFICATE-----\n").unwrap();
    for name in ["empty.pem", "text.pem", "broken.pem", "other.pem", "missing.pem"] {
        let address = named("postgres://a:hidden@127.0.0.1:1/d", "shop.example", &path(name));
        let error = init(&access(&address), SHORT).unwrap_err();
        assert!(
            matches!(&error, ShopError::Authorities { path: named, .. } if *named == path(name)),
            "{name}: {error:?}"
        );
        assert!(!error.to_string().contains("hidden"));
    }
}
