//! TLS to the server: its chain and its name are always checked.

use std::sync::Arc;

use fitcheck_files as files;
use rustls::pki_types::CertificateDer;
use rustls::pki_types::pem::PemObject as _;
use rustls::{ClientConfig, RootCertStore};
use tokio_postgres_rustls::MakeRustlsConnect;

use super::address::ShopAddress;
use super::error::ShopError;

/// How TLS is made to a server: by the authorities of the file that its address names, or by the system's.
pub(super) fn connector(address: &ShopAddress) -> Result<MakeRustlsConnect, ShopError> {
    let provider = Arc::new(rustls::crypto::ring::default_provider());
    let config = ClientConfig::builder_with_provider(provider)
        .with_safe_default_protocol_versions()
        .map_err(|error| ShopError::Machine { reason: error.to_string() })?
        .with_root_certificates(authorities(address)?)
        .with_no_client_auth();
    Ok(MakeRustlsConnect::new(config))
}

fn authorities(address: &ShopAddress) -> Result<RootCertStore, ShopError> {
    let mut authorities = RootCertStore::empty();
    if !address.is_tls() {
        return Ok(authorities);
    }
    let Some(path) = address.authority() else {
        let (_added, _ignored) = authorities.add_parsable_certificates(rustls_native_certs::load_native_certs().certs);
        return if authorities.is_empty() { Err(ShopError::NoAuthorities) } else { Ok(authorities) };
    };
    let wrong = |reason: String| ShopError::Authorities { path: path.to_owned(), reason };
    let bytes = files::read_file(path).map_err(|error| wrong(error.to_string()))?;
    for certificate in CertificateDer::pem_slice_iter(&bytes) {
        let certificate = certificate.map_err(|error| wrong(error.to_string()))?;
        authorities.add(certificate).map_err(|error| wrong(error.to_string()))?;
    }
    if authorities.is_empty() { Err(wrong("no certificate".to_owned())) } else { Ok(authorities) }
}
