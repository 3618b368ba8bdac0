//! A database of its own for each test, journals in memory, and a superuser who may do anything.

use std::cell::RefCell;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use fitcheck::journal::Record;
use fitcheck::journal::body;
use fitcheck::journal::chain::{ChainId, Head, entry_hash};
use fitcheck::journal::entry::{About, Begin, Check, Checked, Content, Correction, Entry, Kept, Moment};
use fitcheck::message::Message;
use fitcheck::probing::{Measurement, Origin};
use fitcheck::store::shop::{
    Access, Doing, Patience, Places, SchemaInit, Sender, Sending, Sent, ShopAddress, ShopError, Source, Status, init,
    send_once,
};
use fitcheck::tolerance::{Callout, Sources};
use jiff::civil::date;
use tokio::runtime::Runtime;
use tokio_postgres::{Client, Config, NoTls};

/// The server of the tests, or why there is none.
pub fn server(variable: &str) -> Option<String> {
    let address = std::env::var(variable).ok().filter(|address| !address.is_empty());
    if address.is_none() {
        println!("skipped: no server ({variable})");
    }
    address
}

/// Short waits.
pub const SHORT: Patience = Patience {
    connecting: Duration::from_secs(5),
    answer: Duration::from_secs(20),
    first_pause: Duration::from_millis(20),
    longest_pause: Duration::from_millis(200),
};

/// A database.
pub struct Shop {
    /// The server's address as a superuser, to this database.
    pub address: String,
    pub name: String,
    runtime: Runtime,
    client: RefCell<Option<Client>>,
}

static NUMBER: AtomicU64 = AtomicU64::new(0);

impl Shop {
    /// An empty database on the server that a variable names; `None` where there is no server.
    pub fn empty(variable: &str) -> Option<Self> {
        let server = server(variable)?;
        Some(Self::on(&server, ""))
    }

    /// The same with the schema.
    pub fn new() -> Option<Self> {
        let shop = Self::empty("FITCHECK_TEST_PG")?;
        assert_eq!(init(&shop.admin(), SHORT), Ok(SchemaInit::New { version: 1 }));
        Some(shop)
    }

    /// A database with options on a server.
    pub fn on(server: &str, options: &str) -> Self {
        let number = NUMBER.fetch_add(1, Ordering::Relaxed);
        let name = format!("fitcheck_{}_{number}", std::process::id());
        let shop = Self {
            address: format!("{}/{name}", server.rsplit_once('/').unwrap().0),
            name,
            runtime: runtime(),
            client: RefCell::new(None),
        };
        let client = shop.runtime.block_on(connected(server));
        let made = format!("CREATE DATABASE {} {options}", shop.name);
        shop.runtime.block_on(client.batch_execute(&made)).unwrap();
        shop
    }

    /// Its superuser.
    pub fn admin(&self) -> Access {
        access(&self.address)
    }

    /// Statements of its superuser.
    pub fn run(&self, sql: &str) {
        self.attempt(sql).unwrap_or_else(|error| panic!("{sql}: {error:?}"));
    }

    /// The same that may fail: with the error's code.
    pub fn attempt(&self, sql: &str) -> Result<(), String> {
        self.with(|client| self.runtime.block_on(client.batch_execute(sql)).map_err(|error| code(&error)))
    }

    /// A value as text.
    pub fn text(&self, sql: &str) -> String {
        let rows = self.with(|client| self.runtime.block_on(client.simple_query(sql)).unwrap());
        let value = rows.iter().find_map(|row| match row {
            tokio_postgres::SimpleQueryMessage::Row(row) => Some(row.get(0).unwrap_or("NULL").to_owned()),
            _ => None,
        });
        value.unwrap_or_else(|| panic!("no row of {sql}"))
    }

    pub fn number(&self, sql: &str) -> u64 {
        self.text(sql).parse().unwrap()
    }

    fn with<T>(&self, work: impl FnOnce(&Client) -> T) -> T {
        let mut client = self.client.borrow_mut();
        if client.as_ref().is_none_or(Client::is_closed) {
            *client = Some(self.runtime.block_on(connected(&self.address)));
        }
        work(client.as_ref().unwrap())
    }

    /// Forgets the superuser's connection, as before its database is dropped.
    pub fn leave(&self) {
        *self.client.borrow_mut() = None;
        self.runtime.block_on(async { tokio::time::sleep(Duration::from_millis(20)).await });
    }

    /// A login of a role, and the address with its password.
    pub fn login(&self, name: &str, role: &str) -> String {
        let login = format!("{}_{name}", self.name);
        let of = if role.is_empty() { String::new() } else { format!("IN ROLE {role}") };
        self.run(&format!("CREATE ROLE {login} LOGIN PASSWORD 'top secret {name}' {of}"));
        let (_, host) = self.address.rsplit_once('@').unwrap();
        format!("postgres://{login}:top%20secret%20{name}@{host}")
    }

    /// A station's access.
    pub fn station(&self, name: &str) -> Access {
        access(&self.login(name, "fitcheck_station"))
    }

    /// How many entries of a journal the server has, and how many numbers are among them.
    pub fn counts(&self, book: &Book) -> (u64, u64) {
        let of = format!("FROM fitcheck.entry WHERE chain = '\\x{}'", book.chain);
        (self.number(&format!("SELECT count(*) {of}")), self.number(&format!("SELECT count(DISTINCT number) {of}")))
    }
}

impl Drop for Shop {
    fn drop(&mut self) {
        // Its logins own nothing; a server that is thrown away takes them with it.
        self.leave();
    }
}

pub fn runtime() -> Runtime {
    tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap()
}

async fn connected(address: &str) -> Client {
    let mut config: Config = address.parse().unwrap();
    config.connect_timeout(Duration::from_secs(10));
    let begun = Instant::now();
    loop {
        match config.connect(NoTls).await {
            Ok((client, connection)) => {
                drop(tokio::spawn(connection));
                return client;
            }
            // A server that starts again lets nobody in at first.
            Err(error) if begun.elapsed() < Duration::from_secs(30) => {
                drop(error);
                tokio::time::sleep(Duration::from_millis(100)).await;
            }
            Err(error) => panic!("{error:?}"),
        }
    }
}

fn code(error: &tokio_postgres::Error) -> String {
    error.code().map_or_else(|| error.to_string(), |code| code.code().to_owned())
}

pub fn access(address: &str) -> Access {
    let (address, password) = ShopAddress::read(address).unwrap();
    Access::find(address, password, &Places::none())
}

/// Statements by an address: the code of the error, if there is one.
pub fn by(address: &str, sql: &str) -> Result<(), String> {
    let runtime = runtime();
    let client = runtime.block_on(connected(address));
    runtime.block_on(client.batch_execute(sql)).map_err(|error| code(&error))
}

/// A journal in memory.
#[derive(Clone)]
pub struct Book {
    pub chain: ChainId,
    pub station: String,
    entries: Arc<Mutex<Vec<Kept>>>,
}

impl Book {
    /// A chain with its first entry.
    pub fn new(station: &str) -> Self {
        let mut name = [0; 16];
        getrandom::fill(&mut name).unwrap();
        let chain = ChainId(name);
        let book = Self { chain, station: station.to_owned(), entries: Arc::default() };
        book.add(&Entry {
            about: book.about(""),
            content: Content::Begin(Begin { chain, program: "fitcheck 0.1.0".to_owned(), after: None }),
        });
        book
    }

    /// A copy that goes its own way.
    pub fn copied(&self) -> Self {
        let entries = self.entries.lock().unwrap().clone();
        Self { entries: Arc::new(Mutex::new(entries)), ..self.clone() }
    }

    pub fn about(&self, serial: &str) -> About {
        About {
            station: self.station.clone(),
            time: Moment {
                utc_ms: jiff::Timestamp::now().as_millisecond(),
                offset_min: 60,
                zone: "Europe/Amsterdam".to_owned(),
            },
            who: "Anna".to_owned(),
            part: "Flange".to_owned(),
            serial: serial.to_owned(),
            feature: "B1".to_owned(),
            remark: "after the second cut".to_owned(),
        }
    }

    pub fn add(&self, entry: &Entry) -> Head {
        self.add_body(&body::write(entry).unwrap())
    }

    /// Any bytes as an entry.
    pub fn add_body(&self, body: &[u8]) -> Head {
        let mut entries = self.entries.lock().unwrap();
        let before = entries.last().map(|kept| kept.head).unwrap_or_default();
        let hash = entry_hash(self.chain, before, body).unwrap();
        let head = Head { number: before.number + 1, hash };
        entries.push(Kept { head, body: body.into() });
        head
    }

    /// So many checks.
    pub fn checks(&self, count: usize) {
        for number in 0..count {
            let about = self.about(&format!("{}-{number}", self.station));
            self.add(&Entry { about, content: check(bore("25.012"), None) });
        }
    }

    pub fn length(&self) -> u64 {
        self.entries.lock().unwrap().len().try_into().unwrap()
    }

    pub fn kept(&self, number: usize) -> Kept {
        self.entries.lock().unwrap()[number - 1].clone()
    }

    /// Takes the newest entries away.
    pub fn cut(&self, length: usize) {
        self.entries.lock().unwrap().truncate(length);
    }

    pub fn last(&self) -> Head {
        self.head().unwrap()
    }

    pub fn send(&self, access: &Access) -> Result<Sent, ShopError> {
        send_once(self, &self.station, access, SHORT, &mut |_sent| ControlFlow::Continue(()))
    }

    /// A sender in the background, and what it told last.
    pub fn sender(&self, address: &str, patience: Patience) -> (Sender, StatusLog) {
        let (address, given) = ShopAddress::read(address).unwrap();
        Self::sender_as(Sending {
            source: Box::new(self.clone()),
            station: self.station.clone(),
            address,
            given,
            places: Places::none(),
            known: None,
            patience,
        })
    }

    pub fn sender_as(sending: Sending) -> (Sender, StatusLog) {
        let told = StatusLog::default();
        let telling = told.clone();
        let sender = Sender::start(sending, move |status| telling.0.lock().unwrap().push(status.clone())).unwrap();
        (sender, told)
    }
}

impl Source for Book {
    fn chain(&self) -> ChainId {
        self.chain
    }

    fn head(&self) -> Result<Head, Message> {
        Ok(self.entries.lock().unwrap().last().map(|kept| kept.head).unwrap_or_default())
    }

    fn entries(&self, from: u64, most: usize) -> Result<Vec<Kept>, Message> {
        let entries = self.entries.lock().unwrap();
        Ok(entries.iter().filter(|kept| from <= kept.head.number).take(most).cloned().collect())
    }
}

/// Everything that a sender told.
#[derive(Clone, Default)]
pub struct StatusLog(pub Arc<Mutex<Vec<Status>>>);

impl StatusLog {
    /// Waits until it tells something.
    #[track_caller]
    pub fn until(&self, what: &str, wanted: impl Fn(&Status) -> bool) -> Status {
        let begun = Instant::now();
        loop {
            // Not held while somebody looks at it.
            let last = self.0.lock().unwrap().last().cloned();
            if let Some(status) = last.as_ref().filter(|status| wanted(status)) {
                return status.clone();
            }
            assert!(begun.elapsed() < Duration::from_secs(90), "{what} is waited for in vain: {last:?}");
            std::thread::sleep(Duration::from_millis(5));
        }
    }

    /// Waits until everything was sent.
    #[track_caller]
    pub fn all(&self, book: &Book) {
        self.until("the last entry", |status| {
            assert_ne!(status.doing, Doing::Stopped, "{status:?}");
            status.server == Some(book.last()) && status.problem.is_none()
        });
    }
}

/// A typed bore of 25 H7.
pub fn bore(measured: &str) -> Record {
    let callout: Callout = "25 H7".parse().unwrap();
    let limits = Sources::default().limits(&callout, None).unwrap();
    let measurement = Measurement::of_diameter(measured.parse().unwrap(), Origin::Typed);
    Record::judged(date(2026, 11, 23).at(13, 0, 0, 0), "B1".to_owned(), Some(callout), limits, measurement, None)
}

pub fn check(record: Record, corrects: Option<Correction>) -> Content {
    Content::Check(Box::new(Check { what: Checked::Size(Arc::new(record)), files: Vec::new(), corrects }))
}
