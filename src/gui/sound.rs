//! The sounds of verdicts, on a thread of their own: they are made here and played by a program of the system, so that Fitcheck starts on
//! computers that have no sound, too.

use std::io::{self, Write as _};
use std::path::Path;
use std::process::{Command as Process, Stdio};
use std::sync::Mutex;
use std::sync::mpsc::{Receiver, Sender, channel};

use super::errands::Errands;
use super::gauges::Listener;
use crate::message::{Message, message};
use crate::session::{Command, Rhythm};

/// Samples in a second.
const RATE: u16 = 22_050;

/// How a rhythm sounds: how many tones, how long each is and the pause behind it in samples, and its pitch in hertz.
const fn tones(rhythm: Rhythm) -> (usize, u16, u16, u16) {
    match rhythm {
        Rhythm::Long => (1, RATE / 5 * 2, 0, 880),
        Rhythm::Two => (2, RATE / 6, RATE / 9, 660),
        Rhythm::Three => (3, RATE / 9, RATE / 14, 440),
    }
}

/// The samples of a rhythm: triangles, which are softer than squares and need no arithmetic that differs between systems. A tone comes and
/// goes softly, so that it does not crack.
fn samples(rhythm: Rhythm) -> Vec<i16> {
    /// A third of the loudest that there is.
    const LOUD: i64 = 11_000;
    let (count, long, pause, pitch) = tones(rhythm);
    let (rate, pitch, length) = (i64::from(RATE), i64::from(pitch), i64::from(long));
    // A tenth of it comes, and a tenth goes.
    let soft = length / 10;
    let tone = (0..length).map(|at| {
        let place = at * pitch % rate;
        let wave = if place * 2 < rate { place * 4 - rate } else { rate * 3 - place * 4 };
        let sample = wave * LOUD / rate * at.min(length - at).min(soft) / soft;
        i16::try_from(sample).unwrap_or(i16::MAX)
    });
    let one: Vec<i16> = tone.chain((0..pause).map(|_| 0)).collect();
    one.repeat(count)
}

/// A file of 16 bits in one channel, as every player reads it: RIFF WAVE with a chunk of format 1 (Microsoft, "Multimedia Programming
/// Interface and Data Specifications 1.0", 1991).
fn write_wav(out: &mut impl io::Write, samples: &[i16]) -> io::Result<()> {
    let bytes = u32::try_from(samples.len() * 2).map_err(io::Error::other)?;
    out.write_all(b"RIFF")?;
    out.write_all(&(bytes + 36).to_le_bytes())?;
    out.write_all(b"WAVEfmt ")?;
    out.write_all(&16_u32.to_le_bytes())?;
    // Uncompressed, one channel.
    out.write_all(&[1, 0, 1, 0])?;
    out.write_all(&u32::from(RATE).to_le_bytes())?;
    out.write_all(&(u32::from(RATE) * 2).to_le_bytes())?;
    // Two bytes and 16 bits a sample.
    out.write_all(&[2, 0, 16, 0])?;
    out.write_all(b"data")?;
    out.write_all(&bytes.to_le_bytes())?;
    samples.iter().try_for_each(|sample| out.write_all(&sample.to_le_bytes()))
}

/// The players of the system with what they are given before the file, the first one that is there plays.
const PLAYERS: &[(&str, &[&str])] = if cfg!(windows) {
    &[(
        "powershell",
        &["-NoProfile", "-NonInteractive", "-Command", "& { (New-Object Media.SoundPlayer $args[0]).PlaySync() }"],
    )]
} else if cfg!(target_os = "macos") {
    &[("afplay", &[])]
} else {
    &[("pw-play", &[]), ("paplay", &[]), ("aplay", &["-q"])]
};

/// Plays a file, or says why that cannot be.
fn play_file(file: &Path) -> Result<(), Message> {
    let failed = |player: &str, reason: &dyn std::fmt::Display| {
        message!("sounds-failed").text("reason", format_args!("{player}: {reason}"))
    };
    let players: Vec<&str> = PLAYERS.iter().map(|(player, _)| *player).collect();
    let mut why = message!("sounds-no-player").text("players", players.join(", "));
    for (player, before) in PLAYERS {
        let mut process = Process::new(player);
        process.args(*before).arg(file).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped());
        match process.output() {
            Ok(output) if output.status.success() => return Ok(()),
            // Its server may not run where another player needs none.
            Ok(output) => why = failed(player, &String::from_utf8_lossy(&output.stderr).trim()),
            Err(error) if error.kind() == io::ErrorKind::NotFound => {}
            Err(error) => why = failed(player, &error),
        }
    }
    Err(why)
}

fn play(rhythm: Rhythm) -> Result<(), Message> {
    let failed = |error: io::Error| message!("sounds-failed").text("reason", error);
    let mut file = tempfile::Builder::new().prefix("fitcheck").suffix(".wav").tempfile().map_err(failed)?;
    write_wav(&mut file, &samples(rhythm)).and_then(|()| file.flush()).map_err(failed)?;
    // Windows lets nobody read what is open for writing.
    play_file(&file.into_temp_path())
}

/// The thread of the sounds, once one was asked for.
#[derive(Debug, Default)]
pub(super) struct Sounds(Mutex<Option<Sender<(Rhythm, Listener)>>>);

impl Sounds {
    /// Plays a rhythm after the one that is heard. Tests play none.
    pub fn play(&self, errands: Errands, rhythm: Rhythm, listener: Listener) {
        if errands == Errands::AtOnce {
            return;
        }
        let mut thread = self.0.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        let sounds = thread.get_or_insert_with(|| {
            let (sender, sounds) = channel();
            if let Err(error) = std::thread::Builder::new().name("sounds".to_owned()).spawn(move || serve(&sounds)) {
                log::error!("no thread for sounds: {error}");
            }
            sender
        });
        if sounds.send((rhythm, listener)).is_err() {
            log::error!("the thread of the sounds has ended");
        }
    }
}

/// Of those that came while one was heard, the last one is the one that counts. That there is no sound is told once.
fn serve(sounds: &Receiver<(Rhythm, Listener)>) {
    let mut is_told = false;
    while let Ok(first) = sounds.recv() {
        let (rhythm, listener) = sounds.try_iter().last().unwrap_or(first);
        match play(rhythm) {
            Ok(()) => is_told = false,
            Err(_) if is_told => {}
            Err(why) => {
                is_told = true;
                listener.say(Command::SoundFailed(why));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Runs of samples that are heard, with silence between them.
    fn heard(rhythm: Rhythm) -> usize {
        let samples = samples(rhythm);
        // A wave passes through zero; a pause is longer than any wave.
        let loud: Vec<bool> = samples.chunks(200).map(|part| part.iter().any(|sample| 500 < sample.abs())).collect();
        loud.iter().zip(std::iter::once(&false).chain(&loud)).filter(|(now, before)| **now && !**before).count()
    }

    #[test]
    fn each_verdict_is_heard_by_its_number_of_tones_and_by_its_pitch() {
        assert_eq!(Rhythm::ALL.map(heard), [1, 2, 3]);
        let pitches = Rhythm::ALL.map(|rhythm| tones(rhythm).3);
        assert!(pitches.is_sorted_by(|before, after| after < before), "{pitches:?}");
    }

    #[test]
    fn a_sound_is_over_before_the_next_value_is_typed() {
        for rhythm in Rhythm::ALL {
            assert!(samples(rhythm).len() < usize::from(RATE), "{rhythm:?}");
        }
    }

    #[test]
    fn the_file_says_how_long_it_is() -> io::Result<()> {
        for rhythm in Rhythm::ALL {
            let mut file = Vec::new();
            write_wav(&mut file, &samples(rhythm))?;
            let size = |at: usize| file.get(at..at + 4).and_then(|four| four.try_into().ok()).map(u32::from_le_bytes);
            assert_eq!(size(4), u32::try_from(file.len() - 8).ok());
            assert_eq!(size(40), u32::try_from(file.len() - 44).ok());
        }
        Ok(())
    }
}
