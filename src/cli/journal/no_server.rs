//! A program that was built without the server of a shop.

use std::path::Path;

use super::{CliError, Io};
use crate::journal::ask::Question;
use crate::journal::chain::{ChainId, Head};
use crate::message::Message;
use crate::store::local::ListedEntry;

pub(in crate::cli) fn answers(_address: &str, _io: &mut Io<'_>) -> Result<String, CliError> {
    Err(CliError::NoShop)
}

pub(in crate::cli) fn init(_address: &str, _io: &mut Io<'_>) -> Result<(), CliError> {
    Err(CliError::NoShop)
}

pub(in crate::cli) fn send(_address: &str, _file: &Path, _station: &str, _io: &mut Io<'_>) -> Result<(), CliError> {
    Err(CliError::NoShop)
}

pub(in crate::cli) fn verify(
    _address: &str,
    _known: &[(ChainId, Head)],
    _is_json: bool,
    _io: &mut Io<'_>,
) -> Result<bool, CliError> {
    Err(CliError::NoShop)
}

/// There are none.
pub(in crate::cli) enum Pages {}

pub(in crate::cli) fn pages(_address: &str, _question: Question, _io: &mut Io<'_>) -> Result<Pages, CliError> {
    Err(CliError::NoShop)
}

impl Pages {
    pub(in crate::cli) fn each(
        &self,
        _most: usize,
        _take: &mut dyn FnMut(ChainId, ListedEntry) -> std::io::Result<()>,
    ) -> Result<std::io::Result<()>, Message> {
        match *self {}
    }
}

pub(in crate::cli) fn list(
    _address: &str,
    _question: &Question,
    _most: usize,
    _io: &mut Io<'_>,
) -> Result<Vec<ListedEntry>, CliError> {
    Err(CliError::NoShop)
}
