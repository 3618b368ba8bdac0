//! The server of a shop: addresses and passwords by themselves, everything else against PostgreSQL where `FITCHECK_TEST_PG` names one.
//! `tests/shop/server` starts one for as long as a command runs; without it these tests say "skipped: no server".

#![cfg(test)]

mod addresses;
mod asking;
mod chains;
mod clusters;
mod command_line;
mod harness;
mod network;
mod passwords;
mod relay;
mod rights;
mod schemas;
mod sending;
mod structure;
mod tls;
mod view;
