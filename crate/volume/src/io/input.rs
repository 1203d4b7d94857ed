//! Numbers of a file, whether written as text or as bytes.

use heatwalk_model::Error;
use heatwalk_model::io::text;

use super::error::Result;

/// How numbers are written.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Encoding {
    /// Words between white space. What follows `comment` on a line is none of them.
    Text { comment: Option<u8> },
    /// Bytes, in ascending order of significance where `is_little`.
    Binary { is_little: bool },
}

/// What is left of a file.
pub struct Input<'a> {
    bytes: &'a [u8],
    at: usize,
    format: &'static str,
    pub encoding: Encoding,
}

impl<'a> Input<'a> {
    pub fn new(format: &'static str, bytes: &'a [u8], encoding: Encoding) -> Self {
        Self { bytes, at: 0, format, encoding }
    }

    /// Bytes before the next one.
    pub fn position(&self) -> usize {
        self.at
    }

    /// Goes on at a byte, not beyond the end.
    pub fn seek(&mut self, position: usize) {
        self.at = position.min(self.bytes.len());
    }

    /// Bytes that are left.
    pub fn rest(&self) -> &'a [u8] {
        &self.bytes[self.at..]
    }

    /// Says what is wrong here, and that the file is damaged.
    pub fn damaged(&self, problem: &str) -> Error {
        let place = match self.encoding {
            Encoding::Text { .. } => {
                format!("line {}", text::line_number(&self.bytes[..self.at]))
            }
            Encoding::Binary { .. } => format!("byte {}", self.at),
        };
        let problem = format!("{problem}; the file is damaged or cut short, save it again");
        Error::Malformed { format: self.format, place, problem }
    }

    /// Says that something is not read.
    pub fn unsupported(&self, feature: String, remedy: &str) -> Error {
        Error::Unsupported { format: self.format, feature, remedy: remedy.to_owned() }
    }

    /// How many items may be expected of so many that are announced, by what is left: room for more must not be made.
    pub fn plausible(&self, announced: usize) -> usize {
        announced.min(self.rest().len())
    }

    /// The rest of the line; none at the end.
    pub fn line(&mut self) -> Option<&'a [u8]> {
        let rest = self.rest();
        if rest.is_empty() {
            return None;
        }
        let (length, text) = text::line_length(rest);
        self.at += length;
        Some(&rest[..text])
    }

    /// The next word of text; none at the end.
    pub fn word(&mut self) -> Option<&'a str> {
        let comment = if let Encoding::Text { comment } = self.encoding { comment } else { None };
        loop {
            let rest = self.rest();
            let start = rest.iter().position(|byte| !byte.is_ascii_whitespace())?;
            if Some(rest[start]) == comment {
                self.at += start;
                self.line();
                continue;
            }
            let word = &rest[start..];
            let end = word.iter().position(u8::is_ascii_whitespace).unwrap_or(word.len());
            let end = comment.and_then(|sign| text::comment(&word[..end], sign)).unwrap_or(end);
            self.at += start + end;
            // What is not text is no number or name either.
            return Some(std::str::from_utf8(&word[..end]).unwrap_or("\u{FFFD}"));
        }
    }

    /// The words of the next line that has some, without its comment.
    pub fn words(&mut self) -> Vec<&'a str> {
        let Encoding::Text { comment } = self.encoding else { return Vec::new() };
        while let Some(line) = self.line() {
            let end = comment.and_then(|sign| text::comment(line, sign)).unwrap_or(line.len());
            let words: Vec<&str> = line[..end]
                .split(u8::is_ascii_whitespace)
                .filter(|word| !word.is_empty())
                .map(|word| std::str::from_utf8(word).unwrap_or("\u{FFFD}"))
                .collect();
            if !words.is_empty() {
                return words;
            }
        }
        Vec::new()
    }

    /// The next word, as `parse` takes it.
    fn parsed<T>(&mut self, what: &str, parse: impl Fn(&str) -> Option<T>) -> Result<T> {
        let start = self.at;
        let word = self.word();
        Ok(word.and_then(parse).ok_or_else(|| {
            // The line of the word, not the end of the white space before it.
            let space = self.bytes[start..].iter().take_while(|byte| byte.is_ascii_whitespace()).count();
            self.seek(start + space);
            let found = word.map_or("the file ends".to_owned(), |word| text::why_no_number(Some(word)));
            self.damaged(&format!("{what} is expected, but {found}"))
        })?)
    }

    fn whole(&mut self, what: &str) -> Result<i64> {
        self.parsed(what, |word| word.parse().ok())
    }

    fn bytes<const N: usize>(&mut self, is_little: bool, what: &str) -> Result<[u8; N]> {
        let Some(&(mut own)) = self.rest().first_chunk::<N>() else {
            return Err(self.damaged(&format!("{what} is expected, but the file ends")).into());
        };
        self.at += N;
        if !is_little {
            own.reverse();
        }
        Ok(own)
    }

    /// A whole number of four bytes.
    pub fn int(&mut self, what: &str) -> Result<i64> {
        match self.encoding {
            Encoding::Text { .. } => self.whole(what),
            Encoding::Binary { is_little } => Ok(i32::from_le_bytes(self.bytes(is_little, what)?).into()),
        }
    }

    /// A whole number of eight bytes.
    pub fn long(&mut self, what: &str) -> Result<i64> {
        match self.encoding {
            Encoding::Text { .. } => self.whole(what),
            Encoding::Binary { is_little } => Ok(i64::from_le_bytes(self.bytes(is_little, what)?)),
        }
    }

    /// A number of four bytes.
    pub fn float(&mut self, what: &str) -> Result<f64> {
        match self.encoding {
            Encoding::Text { .. } => self.parsed(what, text::number),
            Encoding::Binary { is_little } => Ok(f32::from_le_bytes(self.bytes(is_little, what)?).into()),
        }
    }

    /// A number of eight bytes.
    pub fn double(&mut self, what: &str) -> Result<f64> {
        match self.encoding {
            Encoding::Text { .. } => self.parsed(what, text::number),
            Encoding::Binary { is_little } => Ok(f64::from_le_bytes(self.bytes(is_little, what)?)),
        }
    }

    /// A number of things, which must not be negative.
    pub fn count(&self, number: i64, what: &str) -> Result<usize> {
        Ok(usize::try_from(number).map_err(|_| self.damaged(&format!("{what} is {number}")))?)
    }
}
