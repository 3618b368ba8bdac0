//! A connection to the server of a shop, asked from the thread that made it: nothing waits for ever.

use std::cell::Cell;
use std::future::Future;
use std::pin::pin;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use tokio::runtime::{Builder, Runtime};
use tokio_postgres::Client;

use super::access::Access;
use super::address::ShopAddress;
use super::error::ShopError;
use super::tls;

/// How often a call that waits looks whether it was stopped.
const LOOKS: Duration = Duration::from_millis(50);

/// How long is waited for a server.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Patience {
    /// For a connection.
    pub connecting: Duration,
    pub answer: Duration,
    /// After the first failure, before the next attempt; it doubles with each.
    pub first_pause: Duration,
    /// At most between two attempts.
    pub longest_pause: Duration,
}

impl Default for Patience {
    fn default() -> Self {
        Self {
            connecting: Duration::from_secs(10),
            answer: Duration::from_secs(30),
            first_pause: Duration::from_secs(1),
            longest_pause: Duration::from_mins(1),
        }
    }
}

/// Stops what another thread does with a server, within a blink.
#[derive(Debug, Clone, Default)]
pub struct Stop(Arc<AtomicBool>);

impl Stop {
    pub fn stop(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    pub fn is_stopped(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

/// A connection. After an error it is not used again: what it was doing is not known.
pub(super) struct Server {
    runtime: Option<Runtime>,
    pub(super) client: Client,
    patience: Patience,
    stop: Stop,
    is_broken: Cell<bool>,
    database: String,
}

impl Server {
    pub(super) fn connect(access: &Access, patience: Patience, stop: &Stop) -> Result<Self, ShopError> {
        let address = &access.address;
        let runtime = Builder::new_current_thread().enable_all().build();
        let runtime = runtime.map_err(|error| ShopError::Machine { reason: error.to_string() })?;
        let mut config = address.config().clone();
        if config.get_application_name().is_none() {
            config.application_name("fitcheck");
        }
        if config.get_connect_timeout().is_none() {
            config.connect_timeout(patience.connecting);
        }
        if config.get_tcp_user_timeout().is_none() {
            config.tcp_user_timeout(patience.answer.saturating_mul(2) / 3);
        }
        if let Some(password) = &access.password {
            config.password(password.secret());
        }
        let tls = tls::connector(address)?;
        let connecting = async {
            let (client, connection) =
                config.connect(tls).await.map_err(|error| ShopError::connecting(&error, address))?;
            // What ends the connection is told to the question that waits for it.
            let _running = tokio::spawn(async move { drop(connection.await) });
            Ok(client)
        };
        let limit = patience.connecting.saturating_add(patience.answer);
        let client =
            runtime.block_on(bounded(connecting, limit, stop)).map_err(|error| unreachable_in_time(error, address));
        let client = match client {
            Ok(client) => client,
            Err(error) => {
                runtime.shutdown_background();
                return Err(error);
            }
        };
        let stop = stop.clone();
        let database = address.database().to_owned();
        let server = Self { runtime: Some(runtime), client, patience, stop, is_broken: Cell::new(false), database };
        server.settle()?;
        Ok(server)
    }

    /// What this connection is like for the server: a question ends there before it is given up here, and a transaction that is left
    /// alone holds nothing up.
    fn settle(&self) -> Result<(), ShopError> {
        let answer = (self.patience.answer.saturating_mul(5) / 6).as_millis();
        let idle = self.patience.answer.saturating_mul(2).as_millis();
        self.run(&format!(
            "SET statement_timeout = {answer}; SET idle_in_transaction_session_timeout = {idle}; \
             SET client_min_messages = warning; SET search_path = pg_catalog; \
             SET default_transaction_isolation = 'read committed'"
        ))
    }

    /// Runs statements without an answer.
    pub(super) fn run(&self, sql: &str) -> Result<(), ShopError> {
        self.ask(self.client.batch_execute(sql))
    }

    /// Waits for an answer, as long as is patient.
    pub(super) fn ask<T>(
        &self,
        question: impl Future<Output = Result<T, tokio_postgres::Error>>,
    ) -> Result<T, ShopError> {
        if self.is_broken.get() {
            return Err(ShopError::Lost { reason: "the connection was given up".to_owned() });
        }
        let database = &self.database;
        let question = async {
            question.await.map_err(|error| match ShopError::asking(&error) {
                ShopError::NotMade { .. } => ShopError::NotMade { database: database.clone() },
                other => other,
            })
        };
        let Some(runtime) = &self.runtime else { return Err(ShopError::Stopped) };
        let answer = runtime.block_on(bounded(question, self.patience.answer, &self.stop));
        if answer.is_err() {
            self.is_broken.set(true);
        }
        answer
    }

    /// Whether somebody stopped it.
    pub(super) fn is_stopped(&self) -> bool {
        self.stop.is_stopped()
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        // A name that is looked up cannot be interrupted; it is not waited for.
        if let Some(runtime) = self.runtime.take() {
            runtime.shutdown_background();
        }
    }
}

/// A silent server is as unreachable as one that is not there.
fn unreachable_in_time(error: ShopError, address: &ShopAddress) -> ShopError {
    match error {
        ShopError::Lost { reason } => ShopError::Unreachable { address: address.to_string(), reason },
        other => other,
    }
}

/// Waits for work until it is done, the time is over or somebody stops it.
async fn bounded<T>(
    work: impl Future<Output = Result<T, ShopError>>,
    limit: Duration,
    stop: &Stop,
) -> Result<T, ShopError> {
    let mut work = pin!(work);
    let begun = Instant::now();
    loop {
        if let Ok(done) = tokio::time::timeout(LOOKS, work.as_mut()).await {
            return done;
        }
        if stop.is_stopped() {
            return Err(ShopError::Stopped);
        }
        if limit <= begun.elapsed() {
            return Err(ShopError::Lost { reason: format!("no answer for {} s", limit.as_secs()) });
        }
    }
}
