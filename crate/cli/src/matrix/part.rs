//! A file that is written in blocks of rows, and that another run can go on with.
//!
//! The rows are in `FILE.part`. A line of `FILE.part.log` for each block says how many rows and bytes there are with it, and its checksum; it is
//! written after the block is on the disk, so that a block counts only where all of it is there.

use std::ffi::OsString;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail, ensure};
use rawzip::Crc32;

use crate::checksum::checksum;

/// What the log begins with, before the fingerprint.
const MARK: &str = "heatwalk matrix 1";

pub struct Part {
    target: PathBuf,
    path: PathBuf,
    log_path: PathBuf,
    file: File,
    log: File,
    rows: usize,
    length: u64,
}

/// How much is finished with a block.
#[derive(Clone, Copy)]
struct Block {
    rows: usize,
    length: u64,
    checksum: u32,
}

impl Block {
    fn parse(line: &str) -> Option<Self> {
        let mut words = line.strip_suffix('\n')?.split(' ');
        let block = Self {
            rows: words.next()?.parse().ok()?,
            length: words.next()?.parse().ok()?,
            checksum: u32::from_str_radix(words.next()?, 16).ok()?,
        };
        words.next().is_none().then_some(block)
    }

    fn line(self) -> String {
        format!("{} {} {:08x}\n", self.rows, self.length, self.checksum)
    }
}

impl Part {
    /// Goes on with what an earlier run has left beside a file, or begins. `head`: what the file begins with.
    ///
    /// # Errors
    /// Where another run writes it, where it was begun with another fingerprint, and where it cannot be written.
    pub fn open(target: &Path, head: &[u8], fingerprint: &str) -> Result<Self> {
        let [path, log_path] = [".part", ".part.log"].map(|suffix| with_suffix(target, suffix));
        let open = |path: &Path| {
            let file = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(path);
            file.with_context(|| format!("cannot write {}", path.display()))
        };
        let file = open(&path)?;
        match file.try_lock() {
            Err(TryLockError::WouldBlock) => bail!("{} is being written by another run; wait for it", path.display()),
            // A file system without locks has to do without.
            Ok(()) | Err(TryLockError::Error(_)) => {}
        }
        let log = open(&log_path)?;
        let mut part = Self { target: target.to_owned(), path, log_path, file, log, rows: 0, length: 0 };
        let first = format!("{MARK} {fingerprint}\n");
        let begun = part.resume(&first, head);
        if !begun.with_context(|| part.path.display().to_string())? {
            let begin = part.begin(&first, head);
            begin.with_context(|| format!("cannot write {}", part.path.display()))?;
        }
        Ok(part)
    }

    fn begin(&mut self, first: &str, head: &[u8]) -> io::Result<()> {
        self.log.set_len(0)?;
        self.file.set_len(0)?;
        self.file.seek(SeekFrom::Start(0))?;
        self.file.write_all(head)?;
        self.file.sync_data()?;
        self.log.seek(SeekFrom::Start(0))?;
        self.log.write_all(first.as_bytes())?;
        self.log.sync_data()?;
        (self.rows, self.length) = (0, head.len() as u64);
        Ok(())
    }

    /// Takes up the blocks that are whole, and drops what is after them. Returns whether anything was begun.
    fn resume(&mut self, first: &str, head: &[u8]) -> Result<bool> {
        let mut lines = BufReader::new(&self.log);
        let mut line = String::new();
        // A line without an end was not written as a whole.
        if lines.read_line(&mut line)? == 0 || !line.ends_with('\n') {
            return Ok(false);
        }
        ensure!(
            line == first,
            "it was begun with another mesh, other places or other options; remove it and {}, or choose another --output",
            self.log_path.display()
        );
        let mut log_length = line.len() as u64;
        let mut bytes = vec![0; head.len()];
        self.file.seek(SeekFrom::Start(0))?;
        if self.file.read_exact(&mut bytes).is_err() || bytes != head {
            return Ok(false);
        }
        let mut last = Block { rows: 0, length: head.len() as u64, checksum: 0 };
        loop {
            line.clear();
            lines.read_line(&mut line)?;
            let Some(block) = Block::parse(&line) else { break };
            let follows = block.rows > last.rows && block.length >= last.length;
            if !follows || checksum(&mut self.file, block.length - last.length)? != Some(block.checksum) {
                break;
            }
            log_length += line.len() as u64;
            last = block;
        }
        self.file.set_len(last.length)?;
        self.file.seek(SeekFrom::End(0))?;
        self.log.set_len(log_length)?;
        self.log.seek(SeekFrom::End(0))?;
        (self.rows, self.length) = (last.rows, last.length);
        Ok(true)
    }

    /// Rows that are finished.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Writes a block of rows.
    ///
    /// # Errors
    /// As the disk is full; then the rows before are as they were.
    pub fn append(&mut self, rows: &[Vec<u8>]) -> Result<()> {
        let mut checksum = Crc32::new();
        rows.iter().for_each(|row| checksum.update(row));
        let length = rows.iter().map(|row| row.len() as u64).sum::<u64>();
        let block = Block { rows: self.rows + rows.len(), length: self.length + length, checksum: checksum.checksum() };
        let mut write = || -> io::Result<()> {
            rows.iter().try_for_each(|row| self.file.write_all(row))?;
            self.file.sync_data()?;
            self.log.write_all(block.line().as_bytes())?;
            self.log.sync_data()
        };
        write().with_context(|| format!("cannot write {}", self.path.display()))?;
        (self.rows, self.length) = (block.rows, block.length);
        Ok(())
    }

    /// The rows so far, after the head.
    pub fn file(&self) -> &File {
        &self.file
    }

    /// The file that is made of it.
    pub fn target(&self) -> &Path {
        &self.target
    }

    /// Takes the place of the file.
    pub fn persist(self) -> Result<()> {
        let renamed = fs::rename(&self.path, &self.target);
        renamed.with_context(|| {
            format!("cannot write {}; all rows are in {}", self.target.display(), self.path.display())
        })?;
        remove(&self.log_path)
    }

    /// Removes what was kept for another run.
    pub fn remove(self) -> Result<()> {
        remove(&self.log_path)?;
        remove(&self.path)
    }
}

fn remove(path: &Path) -> Result<()> {
    fs::remove_file(path).with_context(|| format!("cannot remove {}", path.display()))
}

fn with_suffix(path: &Path, suffix: &str) -> PathBuf {
    let mut name = OsString::from(path);
    name.push(suffix);
    name.into()
}
