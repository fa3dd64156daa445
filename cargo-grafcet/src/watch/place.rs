//! Where frames come from.

use std::fmt;
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::net::{TcpStream, ToSocketAddrs};
use std::path::PathBuf;
use std::str::FromStr;
use std::thread::sleep;
use std::time::Duration;

/// A connection that is not made in this time is tried again.
const CONNECT: Duration = Duration::from_secs(5);
/// So often it is looked whether a file has grown.
const GROWS: Duration = Duration::from_millis(200);
/// A serial port that is silent is asked again after this time.
const SILENT: Duration = Duration::from_secs(1);
const BAUD: u32 = 115_200;
/// A line that takes nothing in this time is not written to.
const TAKES: Duration = Duration::from_secs(1);

/// A source that is open.
pub(crate) struct Opened {
    pub(crate) read: Box<dyn Read>,
    /// The way back, where there is one.
    pub(crate) write: Option<Box<dyn Write + Send>>,
}

/// A source of the command line.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Wanted {
    /// The chart that runs there, where that was said.
    pub(crate) chart: Option<String>,
    pub(crate) place: Place,
}

#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum Place {
    Input,
    Tcp(String),
    Serial(String, u32),
    File(PathBuf),
}

impl FromStr for Wanted {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let is_name = |name: &str| {
            let starts = name.chars().next().is_some_and(|first| first.is_alphabetic() || first == '_');
            starts && name.chars().all(|one| one.is_alphanumeric() || one == '_')
        };
        match text.split_once('=').filter(|(name, _)| is_name(name)) {
            Some((name, place)) => Ok(Self { chart: Some(name.to_owned()), place: place.parse()? }),
            None => Ok(Self { chart: None, place: text.parse()? }),
        }
    }
}

impl FromStr for Place {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text == "-" {
            return Ok(Self::Input);
        }
        if let Some(address) = text.strip_prefix("tcp:") {
            let port =
                address.rsplit_once(':').filter(|(host, _)| !host.is_empty()).map(|(_, port)| port.parse::<u16>());
            return match port {
                Some(Ok(_)) => Ok(Self::Tcp(address.to_owned())),
                _ => Err("a host and a port, as in tcp:192.168.1.7:4000".to_owned()),
            };
        }
        let Some(port) = text.strip_prefix("serial:") else {
            return if text.is_empty() { Err("it has no name".to_owned()) } else { Ok(Self::File(text.into())) };
        };
        let (port, baud) = match port.rsplit_once(':') {
            Some((port, baud)) => (port, baud.parse().ok().filter(|baud| *baud > 0)),
            None => (port, Some(BAUD)),
        };
        match baud {
            Some(baud) if !port.is_empty() => Ok(Self::Serial(port.to_owned(), baud)),
            _ => Err("a port and perhaps its speed, as in serial:/dev/ttyUSB0:115200".to_owned()),
        }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Input => f.write_str("standard input"),
            Self::Tcp(address) => write!(f, "tcp:{address}"),
            Self::Serial(port, baud) => write!(f, "serial:{port}:{baud}"),
            Self::File(path) => write!(f, "{}", path.display()),
        }
    }
}

impl Place {
    /// Whether it is opened again where it has ended.
    pub(crate) fn comes_again(&self) -> bool {
        matches!(self, Self::Tcp(_) | Self::Serial(..))
    }

    /// Whether what is written to it gets to the controller.
    pub(crate) fn leads_back(&self) -> bool {
        matches!(self, Self::Tcp(_) | Self::Serial(..))
    }

    /// Opens it.
    ///
    /// # Errors
    /// As the system says; whoever listens may not be there yet.
    pub(crate) fn open(&self) -> io::Result<Opened> {
        Ok(match self {
            Self::Input => Opened { read: Box::new(io::stdin()), write: None },
            Self::Tcp(address) => {
                let stream = connect(address)?;
                stream.set_write_timeout(Some(TAKES))?;
                stream.set_nodelay(true)?;
                let back = stream.try_clone()?;
                Opened { read: Box::new(stream), write: Some(Box::new(back)) }
            }
            Self::Serial(port, baud) => {
                let port = Serial::open(port, *baud)?;
                let mut back = port.0.try_clone()?;
                back.set_write_timeout(TAKES)?;
                Opened { read: Box::new(port), write: Some(Box::new(back)) }
            }
            Self::File(path) => Opened { read: Box::new(Growing { file: File::open(path)?, at: 0 }), write: None },
        })
    }
}

fn connect(address: &str) -> io::Result<TcpStream> {
    let mut failed = io::Error::new(io::ErrorKind::NotFound, "the host has no address");
    for address in address.to_socket_addrs()? {
        match TcpStream::connect_timeout(&address, CONNECT) {
            Ok(stream) => return Ok(stream),
            Err(error) => failed = error,
        }
    }
    Err(failed)
}

/// A port that may be silent for long.
struct Serial(serial2::SerialPort);

impl Serial {
    fn open(port: &str, baud: u32) -> io::Result<Self> {
        let mut port = serial2::SerialPort::open(port, baud)?;
        port.set_read_timeout(SILENT)?;
        Ok(Self(port))
    }
}

impl Read for Serial {
    fn read(&mut self, to: &mut [u8]) -> io::Result<usize> {
        loop {
            match Read::read(&mut self.0, to) {
                Err(error) if error.kind() == io::ErrorKind::TimedOut => {}
                other => return other,
            }
        }
    }
}

/// A file to which somebody adds; its end is not the end. What is no file, such as a pipe, ends.
struct Growing {
    file: File,
    at: u64,
}

impl Read for Growing {
    fn read(&mut self, to: &mut [u8]) -> io::Result<usize> {
        loop {
            let read = self.file.read(to)?;
            self.at += read as u64;
            let data = self.file.metadata()?;
            if read > 0 || !data.is_file() {
                return Ok(read);
            }
            // It was written anew.
            if data.len() < self.at {
                self.at = self.file.seek(SeekFrom::Start(0))?;
            }
            sleep(GROWS);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Place, Wanted};

    #[test]
    fn sources_as_they_are_written() {
        let place = |text: &str| text.parse::<Wanted>().map(|wanted| (wanted.chart, wanted.place));
        let named = |name: &str| Some(name.to_owned());
        assert_eq!(place("-"), Ok((None, Place::Input)));
        assert_eq!(place("Press=-"), Ok((named("Press"), Place::Input)));
        assert_eq!(place("tcp:[::1]:4000"), Ok((None, Place::Tcp("[::1]:4000".to_owned()))));
        assert_eq!(place("Cell=serial:COM3:9600"), Ok((named("Cell"), Place::Serial("COM3".to_owned(), 9600))));
        assert_eq!(place("serial:/dev/ttyUSB0"), Ok((None, Place::Serial("/dev/ttyUSB0".to_owned(), 115_200))));
        assert_eq!(place("runs/a=b.frames"), Ok((None, Place::File("runs/a=b.frames".into()))));
        for wrong in ["tcp:host", "tcp::4000", "tcp:host:99999", "serial:", "serial:COM3:fast", "serial:COM3:0", ""] {
            assert!(place(wrong).is_err(), "{wrong}");
        }
    }
}
