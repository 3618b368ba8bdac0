//! The server itself dies, is filled, or comes back from an older copy.

use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use fitcheck::store::shop::{Doing, Patience, ShopError, init};

use crate::chains::verified;
use crate::harness::{Book, SHORT, Shop, server};

/// A server that may be stopped, killed and filled: by one test at a time.
pub struct Cluster {
    pub address: String,
    data: PathBuf,
    bin: PathBuf,
    user: String,
    _alone: MutexGuard<'static, ()>,
}

static ALONE: Mutex<()> = Mutex::new(());

impl Cluster {
    pub fn alone() -> Option<Self> {
        let address = server("FITCHECK_TEST_PG_OTHER")?;
        let variable = |name| std::env::var(name).unwrap_or_default();
        Some(Self {
            address,
            data: variable("FITCHECK_TEST_PG_DATA").into(),
            bin: variable("FITCHECK_TEST_PG_BIN").into(),
            user: variable("FITCHECK_TEST_PG_USER"),
            _alone: ALONE.lock().unwrap_or_else(PoisonError::into_inner),
        })
    }

    /// One of PostgreSQL's programs, as the user whom it belongs to.
    fn program(&self, name: &str) -> Command {
        let path = self.bin.join(name);
        if self.user.is_empty() {
            return Command::new(path);
        }
        let mut command = Command::new("runuser");
        command.args(["-u", &self.user, "--"]).arg(path);
        command
    }

    fn pg_ctl(&self, arguments: &[&str]) -> bool {
        let mut command = self.program("pg_ctl");
        command
            .arg("-D")
            .arg(&self.data)
            .args(arguments)
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::null());
        command.status().unwrap().success()
    }

    /// Starts it again; as long as processes of the one that was killed are there, it does not.
    fn start(&self) -> u32 {
        let log = format!("{}.log", self.data.display());
        for attempt in 1..=100 {
            if self.pg_ctl(&["-l", &log, "-w", "-t", "60", "start"]) {
                return attempt;
            }
            std::thread::sleep(Duration::from_millis(100));
        }
        panic!("the server does not start again: {log}");
    }

    /// Kills its first process.
    fn kill(&self) {
        let file = std::fs::read_to_string(self.data.join("postmaster.pid")).unwrap();
        let process = file.lines().next().unwrap().to_owned();
        assert!(Command::new("kill").args(["-9", &process]).status().unwrap().success());
        let begun = Instant::now();
        while std::path::Path::new("/proc").join(&process).exists() && begun.elapsed() < Duration::from_secs(10) {
            std::thread::sleep(Duration::from_millis(5));
        }
    }
}

#[test]
fn a_server_that_is_stopped_or_killed_in_the_midst_of_a_batch_loses_and_doubles_nothing() {
    let Some(cluster) = Cluster::alone() else { return };
    let shop = Shop::on(&cluster.address, "");
    init(&shop.admin(), SHORT).unwrap();
    let patience = Patience { longest_pause: Duration::from_millis(50), ..SHORT };
    let stations: Vec<_> = (0..2)
        .map(|number| {
            let book = Book::new(&format!("Mill {number}"));
            let (sender, told) = book.sender(&shop.login(&format!("mill{number}"), "fitcheck_station"), patience);
            (book, sender, told)
        })
        .collect();
    let (mut attempts, mut in_the_midst) = (0, 0);
    for round in 0..8_u64 {
        for (book, sender, told) in &stations {
            told.all(book);
            book.checks(6_000);
            sender.wake();
        }
        std::thread::sleep(Duration::from_millis(20 + 15 * round));
        shop.leave();
        if round % 2 == 0 {
            assert!(cluster.pg_ctl(&["-m", "immediate", "-w", "stop"]));
        } else {
            cluster.kill();
        }
        let sent: Vec<u64> = stations.iter().map(|(_, _, told)| acknowledged(told)).collect();
        attempts += cluster.start();
        for ((book, _, _), sent) in stations.iter().zip(sent) {
            let (there, _) = shop.counts(book);
            assert!(sent <= there, "{sent} were acknowledged and {there} are there");
            in_the_midst += u64::from(sent < book.length());
        }
    }
    for (book, _, told) in &stations {
        told.all(book);
        assert_eq!(shop.counts(book), (book.length(), book.length()));
    }
    let books: Vec<&Book> = stations.iter().map(|(book, ..)| book).collect();
    assert!(verified(&shop.admin(), &books).is_whole());
    assert!(4 <= in_the_midst, "only {in_the_midst} of 16 journals were being sent");
    let entries: u64 = books.iter().map(|book| book.length()).sum();
    println!(
        "4 immediate stops and 4 kills of the server, {in_the_midst} of 16 times in the midst of sending: {entries} entries, each once, \
         0 acknowledged lost, 0 broken links; {attempts} attempts to start it"
    );
}

/// The last entry that a sender was told the server has.
fn acknowledged(told: &crate::harness::StatusLog) -> u64 {
    told.0.lock().unwrap().iter().filter_map(|status| status.server).map(|head| head.number).max().unwrap_or_default()
}

/// A small disk in memory.
struct Disk(PathBuf);

impl Disk {
    fn new(folder: PathBuf, size: &str) -> Option<Self> {
        std::fs::create_dir_all(&folder).unwrap();
        let mut mount = Command::new("mount");
        mount.args(["-t", "tmpfs", "-o", &format!("size={size}"), "tmpfs"]).arg(&folder).stderr(Stdio::null());
        mount.status().is_ok_and(|status| status.success()).then_some(Self(folder))
    }

    fn grow(&self, size: &str) {
        let mut mount = Command::new("mount");
        assert!(mount.args(["-o", &format!("remount,size={size}")]).arg(&self.0).status().unwrap().success());
    }
}

impl Drop for Disk {
    fn drop(&mut self) {
        drop(Command::new("umount").arg("-l").arg(&self.0).status());
    }
}

#[test]
fn a_server_whose_disk_is_full_gets_the_rest_when_it_has_space_again() {
    let Some(cluster) = Cluster::alone() else { return };
    let folder = cluster.data.with_extension("disk");
    let Some(disk) = Disk::new(folder.clone(), "24m") else {
        println!("skipped: no small disk can be made here");
        return;
    };
    if !cluster.user.is_empty() {
        assert!(Command::new("chown").arg(&cluster.user).arg(&folder).status().unwrap().success());
    }
    let first = Shop::on(&cluster.address, "");
    let space = format!("{}_space", first.name);
    first.run(&format!("CREATE TABLESPACE {space} LOCATION '{}'", folder.display()));
    let shop = Shop::on(&cluster.address, &format!("TABLESPACE {space}"));
    init(&shop.admin(), SHORT).unwrap();
    let book = Book::new("Mill 3");
    let (sender, told) = book.sender(&shop.login("a", "fitcheck_station"), SHORT);
    told.all(&book);
    book.checks(30_000);
    sender.wake();
    let status = told.until("a full disk", |status| status.problem == Some(ShopError::Full));
    assert_eq!(status.doing, Doing::Waiting);
    let (there, _) = shop.counts(&book);
    assert!(acknowledged(&told) <= there && there < book.length(), "{there}");
    disk.grow("400m");
    told.all(&book);
    assert_eq!(shop.counts(&book), (book.length(), book.length()));
    assert!(verified(&shop.admin(), &[&book]).is_whole());
    println!("a full disk after {there} of {} entries: then all, each once", book.length());
    sender.stop();
    shop.leave();
    first.run(&format!("DROP DATABASE {} WITH (FORCE)", shop.name));
    first.run(&format!("DROP TABLESPACE {space}"));
}

#[test]
fn a_server_that_comes_back_from_an_older_copy_gets_what_it_lacks() {
    let Some(cluster) = Cluster::alone() else { return };
    let first = Shop::on(&cluster.address, "");
    let shop = Shop::on(&cluster.address, "");
    init(&shop.admin(), SHORT).unwrap();
    let books = [Book::new("Mill 3"), Book::new("Mill 4")];
    let access = [shop.station("a"), shop.station("b")];
    let add = |count: usize| {
        for (book, access) in books.iter().zip(&access) {
            book.checks(count);
            book.send(access).unwrap();
        }
    };
    add(300);
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("journal.dump");
    let ran = |mut command: Command| {
        let output = command.output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    };
    let mut dump = Command::new(cluster.bin.join("pg_dump"));
    dump.args(["-Fc", "-f"]).arg(&file).args(["-d", &shop.address]);
    ran(dump);
    add(700);
    shop.leave();
    first.run(&format!("DROP DATABASE {} WITH (FORCE)", shop.name));
    first.run(&format!("CREATE DATABASE {}", shop.name));
    let mut restore = Command::new(cluster.bin.join("pg_restore"));
    restore.args(["--exit-on-error", "-d", &shop.address]).arg(&file);
    ran(restore);
    for book in &books {
        assert_eq!(shop.counts(book), (301, 301));
    }
    assert!(!verified(&shop.admin(), &books.iter().collect::<Vec<_>>()).is_whole(), "the older copy is told");
    // As the handbook says: the schema is looked after, and the stations send the rest.
    init(&shop.admin(), SHORT).unwrap();
    add(1);
    for book in &books {
        assert_eq!(shop.counts(book), (1_002, 1_002));
    }
    assert!(verified(&shop.admin(), &books.iter().collect::<Vec<_>>()).is_whole());
    println!("an older copy of 602 entries: the stations sent the 1402 others");
}

#[test]
fn a_server_that_stops_politely_is_waited_for() {
    let Some(cluster) = Cluster::alone() else { return };
    let shop = Shop::on(&cluster.address, "");
    init(&shop.admin(), SHORT).unwrap();
    let book = Book::new("Mill 3");
    let (sender, told) = book.sender(&shop.login("a", "fitcheck_station"), SHORT);
    told.all(&book);
    shop.leave();
    assert!(cluster.pg_ctl(&["-m", "fast", "-w", "stop"]));
    book.checks(10);
    sender.wake();
    let status = told.until("that nobody answers", |status| status.doing == Doing::Waiting);
    assert_eq!(status.unsent, Some(10));
    cluster.start();
    told.all(&book);
    assert_eq!(shop.counts(&book), (11, 11));
}
