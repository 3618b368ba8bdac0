//! The ports of this computer, and the thread that reads one of them.

use std::io::{self, ErrorKind};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, TryRecvError, channel};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use serial2::{CharSize, SerialPort, Settings};

use crate::lines::Lines;
use crate::news::{News, Trouble};
use crate::settings::{DataBits, Parity, PortSettings, StopBits};

/// After so long a silence what has come of a line is dropped.
const SILENCE: Duration = Duration::from_millis(300);

/// How long a read waits before it looks whether it is to end.
const LOOK: Duration = Duration::from_millis(50);

/// How often a port that is not there is tried.
const RETRY: Duration = Duration::from_secs(1);

/// The ports of this computer, by name.
///
/// # Errors
/// The system cannot list them.
pub fn list() -> io::Result<Vec<String>> {
    let mut names: Vec<String> =
        SerialPort::available_ports()?.into_iter().map(|path| path.to_string_lossy().into_owned()).collect();
    names.sort();
    Ok(names)
}

/// A port that is read on a thread. Dropped, it is closed, and the thread has ended.
#[derive(Debug)]
pub struct Port {
    /// Gone, it ends the thread.
    stop: Option<Sender<()>>,
    thread: Option<JoinHandle<()>>,
}

impl Port {
    /// Opens a port, now or as soon as it is there, and tells what comes from it.
    ///
    /// # Errors
    /// There is no thread for it.
    pub fn open(settings: PortSettings, tell: Box<dyn FnMut(News) + Send>) -> io::Result<Self> {
        let (stop, stopped) = channel();
        let read = move || Reader { settings, tell, stopped, is_known: false }.run();
        let thread = std::thread::Builder::new().name("gauge".to_owned()).spawn(read)?;
        Ok(Self { stop: Some(stop), thread: Some(thread) })
    }
}

impl Drop for Port {
    fn drop(&mut self) {
        self.stop = None;
        let is_itself = |thread: &JoinHandle<()>| thread.thread().id() == std::thread::current().id();
        if let Some(thread) = self.thread.take().filter(|thread| !is_itself(thread))
            && thread.join().is_err()
        {
            log::error!("the thread of a gauge has panicked");
        }
    }
}

struct Reader {
    settings: PortSettings,
    tell: Box<dyn FnMut(News) + Send>,
    stopped: Receiver<()>,
    /// Whether it was open before.
    is_known: bool,
}

impl Reader {
    fn run(mut self) {
        let mut is_told = false;
        loop {
            match open(&self.settings) {
                Ok(port) => {
                    (self.tell)(if self.is_known { News::Back } else { News::Opened });
                    self.is_known = true;
                    let Some(trouble) = self.read(&port) else { return };
                    (self.tell)(News::Lost(trouble));
                    is_told = true;
                }
                Err(error) if !is_told => {
                    (self.tell)(News::Lost(trouble(&self.settings.port, &error)));
                    is_told = true;
                }
                Err(_still) => {}
            }
            if self.stopped.recv_timeout(RETRY) != Err(RecvTimeoutError::Timeout) {
                return;
            }
        }
    }

    /// Reads until the port is gone, and says why; nothing once it is to end.
    fn read(&mut self, port: &SerialPort) -> Option<Trouble> {
        let mut lines = Lines::opened();
        let mut heard = Instant::now();
        let mut bytes = [0; 256];
        while self.stopped.try_recv() == Err(TryRecvError::Empty) {
            match port.read(&mut bytes) {
                Ok(0) => return Some(Trouble::Unplugged { port: self.settings.port.clone() }),
                Ok(count) => {
                    heard = Instant::now();
                    lines.take(bytes.get(..count).unwrap_or(&bytes), &mut self.tell);
                }
                Err(error) if error.kind() == ErrorKind::TimedOut => {}
                Err(error) if [ErrorKind::Interrupted, ErrorKind::WouldBlock].contains(&error.kind()) => {}
                Err(error) => {
                    log::info!("{}: {error}", self.settings.port);
                    return Some(Trouble::Unplugged { port: self.settings.port.clone() });
                }
            }
            if lines.awaits_more() && SILENCE <= heard.elapsed() {
                lines.fall_silent(&mut self.tell);
            }
        }
        None
    }
}

fn open(settings: &PortSettings) -> io::Result<SerialPort> {
    let mut port = SerialPort::open(&settings.port, |given: Settings| apply(settings, given))?;
    port.set_read_timeout(LOOK)?;
    own(&port)?;
    // Many cables take their power from these two lines; a port without them is one, too.
    for error in [port.set_dtr(true), port.set_rts(true)].into_iter().filter_map(Result::err) {
        log::debug!("{}: {error}", settings.port);
    }
    // What came while nobody listened is no measurement of now.
    port.discard_input_buffer()?;
    Ok(port)
}

fn apply(settings: &PortSettings, mut given: Settings) -> io::Result<Settings> {
    given.set_raw();
    given.set_baud_rate(settings.speed)?;
    given.set_char_size(match settings.bits {
        DataBits::Seven => CharSize::Bits7,
        DataBits::Eight => CharSize::Bits8,
    });
    given.set_parity(match settings.parity {
        Parity::None => serial2::Parity::None,
        Parity::Even => serial2::Parity::Even,
        Parity::Odd => serial2::Parity::Odd,
    });
    given.set_stop_bits(match settings.stop {
        StopBits::One => serial2::StopBits::One,
        StopBits::Two => serial2::StopBits::Two,
    });
    Ok(given)
}

/// Nobody else opens it from now on.
#[cfg(unix)]
fn own(port: &SerialPort) -> io::Result<()> {
    Ok(rustix::termios::ioctl_tiocexcl(port)?)
}

/// The system lets one program open a port.
#[cfg(not(unix))]
fn own(_port: &SerialPort) -> io::Result<()> {
    Ok(())
}

fn trouble(port: &str, error: &io::Error) -> Trouble {
    let port = port.to_owned();
    match error.kind() {
        ErrorKind::NotFound => Trouble::Missing { port },
        ErrorKind::ResourceBusy => Trouble::Busy { port },
        // Windows says the same of a port that another program has.
        ErrorKind::PermissionDenied if cfg!(windows) => Trouble::Busy { port },
        ErrorKind::PermissionDenied => Trouble::NotAllowed { port },
        _ => Trouble::Other { port, reason: error.to_string() },
    }
}

#[cfg(target_os = "linux")]
#[cfg(test)]
mod tests {
    use std::fs::File;
    use std::io::Write as _;
    use std::os::unix::ffi::OsStrExt as _;
    use std::path::{Path, PathBuf};

    use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};

    use super::*;
    use crate::news::Refusal;

    /// A port without a device: a link to a pseudo-terminal, which goes when it is unplugged.
    struct Device {
        file: File,
        link: PathBuf,
    }

    impl Device {
        fn plug(link: &Path) -> Self {
            let own = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY).unwrap();
            grantpt(&own).unwrap();
            unlockpt(&own).unwrap();
            let name = ptsname(&own, Vec::new()).unwrap();
            std::os::unix::fs::symlink(std::ffi::OsStr::from_bytes(name.to_bytes()), link).unwrap();
            Self { file: File::from(own), link: link.to_owned() }
        }

        fn send(&mut self, bytes: &[u8]) {
            self.file.write_all(bytes).unwrap();
        }

        fn unplug(self) {
            std::fs::remove_file(&self.link).unwrap();
        }
    }

    struct Bench {
        folder: tempfile::TempDir,
        news: Receiver<News>,
        port: Port,
    }

    impl Bench {
        fn link(folder: &tempfile::TempDir) -> PathBuf {
            folder.path().join("gauge")
        }

        fn listen(folder: tempfile::TempDir) -> Self {
            let (sender, news) = channel();
            let port = Self::link(&folder).to_string_lossy().into_owned();
            let tell = Box::new(move |news| sender.send(news).unwrap());
            Self { folder, news, port: Port::open(PortSettings { port, ..PortSettings::default() }, tell).unwrap() }
        }

        fn plugged() -> (Self, Device) {
            let folder = tempfile::tempdir().unwrap();
            let mut device = Device::plug(&Self::link(&folder));
            let bench = Self::listen(folder);
            bench.hears(&News::Opened);
            // The end of a line of which nothing is known.
            device.send(b"\n");
            (bench, device)
        }

        #[track_caller]
        fn hears(&self, wanted: &News) {
            assert_eq!(self.news.recv_timeout(Duration::from_secs(20)).as_ref(), Ok(wanted));
        }

        #[track_caller]
        fn hears_line(&self, line: &str) {
            self.hears(&News::Line(line.to_owned()));
        }
    }

    #[test]
    fn lines_come_as_they_were_sent() {
        let (bench, mut device) = Bench::plugged();
        for line in ["25.012 mm", "01A+0025.012", "\u{2}25,012"] {
            device.send(format!("{line}\r\n").as_bytes());
            bench.hears_line(line);
        }
    }

    #[test]
    fn ten_values_a_second_come_in_their_order() {
        let (bench, mut device) = Bench::plugged();
        let values: Vec<String> = (0..10).map(|tenth| format!("25.0{tenth}0 mm")).collect();
        device.send(format!("{}\r\n", values.join("\r\n")).as_bytes());
        for value in &values {
            bench.hears_line(value);
        }
    }

    #[test]
    fn garbage_is_told_and_what_comes_after_it_is_read() {
        let (bench, mut device) = Bench::plugged();
        device.send(b"\x80\xff\xc3\n\x80\n25.0 mm\n");
        bench.hears(&News::Refused(Refusal::NotText { given: "\\x80\\xff\\xc3".to_owned() }));
        bench.hears_line("25.0 mm");
    }

    #[test]
    fn half_a_line_is_told_after_a_silence() {
        let (bench, mut device) = Bench::plugged();
        device.send(b"25.0");
        bench.hears(&News::Refused(Refusal::Half { given: "25.0".to_owned() }));
        device.send(b"25.1 mm\r");
        bench.hears_line("25.1 mm");
    }

    #[test]
    fn an_unplugged_gauge_is_told_once_and_is_back_when_it_is_plugged_in_again() {
        let (bench, mut device) = Bench::plugged();
        device.send(b"25.0 mm\n25.");
        bench.hears_line("25.0 mm");
        device.unplug();
        let link = Bench::link(&bench.folder);
        let port = link.to_string_lossy().into_owned();
        bench.hears(&News::Lost(Trouble::Unplugged { port }));
        assert_eq!(bench.news.recv_timeout(RETRY * 2), Err(RecvTimeoutError::Timeout));
        let mut device = Device::plug(&link);
        bench.hears(&News::Back);
        // It goes on in the middle of a line: not with what was there before.
        device.send(b"3 mm\n25.4 mm\n");
        let joined = News::Refused(Refusal::Joined { given: "3 mm".to_owned() });
        let first = bench.news.recv_timeout(Duration::from_secs(20)).unwrap();
        assert!(first == joined || first == News::Line("3 mm".to_owned()), "{first:?}");
        bench.hears_line("25.4 mm");
    }

    #[test]
    fn a_port_that_is_not_there_yet_is_opened_when_it_is() {
        let folder = tempfile::tempdir().unwrap();
        let bench = Bench::listen(folder);
        let link = Bench::link(&bench.folder);
        bench.hears(&News::Lost(Trouble::Missing { port: link.to_string_lossy().into_owned() }));
        let _device = Device::plug(&link);
        bench.hears(&News::Opened);
    }

    #[test]
    fn it_ends_at_once_also_while_it_waits_for_a_port() {
        for is_plugged in [true, false] {
            let folder = tempfile::tempdir().unwrap();
            let device = is_plugged.then(|| Device::plug(&Bench::link(&folder)));
            let Bench { news, port, .. } = Bench::listen(folder);
            assert!(news.recv_timeout(Duration::from_secs(20)).is_ok());
            drop(port);
            // The thread has let go of what it told.
            assert_eq!(news.try_recv(), Err(TryRecvError::Disconnected), "{}", device.is_some());
        }
    }
}
