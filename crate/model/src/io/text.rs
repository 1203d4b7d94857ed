//! What text files have in common, whatever their format: how it is encoded, where lines end, how numbers are written.

use crate::error::{Error, Result};

/// Bytes that tell how text is encoded.
const HEAD: usize = 64;

/// Without the mark that some programs put before text in UTF-8.
///
/// # Errors
/// [`Error::Malformed`] for text in UTF-16, which no mesh format is.
pub fn decoded(bytes: &[u8]) -> Result<&[u8]> {
    if is_utf16(bytes) {
        let problem = "this is UTF-16 text; save it as UTF-8".to_owned();
        return Err(Error::Malformed { format: "text", place: "byte 0".to_owned(), problem });
    }
    Ok(without_mark(bytes))
}

pub(super) fn without_mark(bytes: &[u8]) -> &[u8] {
    bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes)
}

/// Whether every other byte of the head is zero and the ones between are printable, after a mark of the order of bytes or without.
fn is_utf16(bytes: &[u8]) -> bool {
    let (units, _) = bytes[..bytes.len().min(HEAD)].as_chunks::<2>();
    let units = if let [[0xFF, 0xFE] | [0xFE, 0xFF], rest @ ..] = units { rest } else { units };
    let is_letter = |byte: u8| byte.is_ascii_graphic() || byte.is_ascii_whitespace();
    let is_text = |high: usize| units.iter().all(|unit| unit[high] == 0 && is_letter(unit[1 - high]));
    !units.is_empty() && (is_text(0) || is_text(1))
}

/// Whether bytes are text and not numbers: their head has no control characters but white space.
pub(super) fn is_text(bytes: &[u8]) -> bool {
    bytes.iter().take(512).all(|byte| !byte.is_ascii_control() || byte.is_ascii_whitespace())
}

/// The lines of a text with their numbers from 1. They end by LF, by CR LF or by CR alone, mixed or not.
pub fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> + Clone {
    let lines = text.split_terminator('\n').flat_map(|line| line.strip_suffix('\r').unwrap_or(line).split('\r'));
    (1..).zip(lines)
}

/// Where the comment of a line begins by this sign. It begins none inside of numbers that are none, such as `1.#QNAN`.
pub fn comment(line: &[u8], sign: u8) -> Option<usize> {
    let is_number =
        |index: usize| index > 0 && line[index - 1] == b'.' && line.get(index + 1).is_some_and(u8::is_ascii_alphabetic);
    (0..line.len()).find(|&index| line[index] == sign && !is_number(index))
}

/// A line without the comment that begins by `#`, and without white space around.
pub fn statement(line: &str) -> &str {
    line[..comment(line.as_bytes(), b'#').unwrap_or(line.len())].trim()
}

/// Words whatever lines they are on.
#[derive(Clone)]
pub struct Words<'a, I> {
    lines: I,
    number: usize,
    line: &'a str,
    /// What is left of the line.
    rest: &'a str,
}

impl<'a, I: Iterator<Item = (usize, &'a str)>> Words<'a, I> {
    /// Of lines with their numbers.
    pub fn new(lines: I) -> Self {
        Self { lines, number: 0, line: "", rest: "" }
    }

    /// Goes to the next line with a word where this one has no more.
    pub fn turn(&mut self) {
        while self.rest.is_empty() {
            let Some((number, line)) = self.lines.next() else { return };
            (self.number, self.line, self.rest) = (number, line, line.trim_ascii());
        }
    }

    /// The next word.
    pub fn peek(&mut self) -> Option<&'a str> {
        self.turn();
        word(&mut { self.rest })
    }

    /// Takes the next word.
    pub fn take(&mut self) -> Option<&'a str> {
        self.turn();
        let word = word(&mut self.rest);
        self.rest = self.rest.trim_ascii_start();
        word
    }

    /// The number of the line of the last word, or of the next one after [`Self::turn`].
    pub fn line(&self) -> usize {
        self.number
    }

    /// What is left of the line.
    pub fn rest(&self) -> &'a str {
        self.rest
    }

    /// Goes on at the end of the line, given of what is left of it.
    pub fn skip_to(&mut self, rest: &'a str) {
        self.rest = rest.trim_ascii();
    }

    /// Whether a word of the line was taken.
    pub fn is_begun(&self) -> bool {
        self.rest.len() < self.line.trim_ascii().len()
    }
}

/// Takes the next word.
pub fn word<'a>(rest: &mut &'a str) -> Option<&'a str> {
    let text = rest.trim_ascii_start();
    let end = text.bytes().position(|byte| byte.is_ascii_whitespace()).unwrap_or(text.len());
    let (word, tail) = text.split_at(end);
    *rest = tail;
    (!word.is_empty()).then_some(word)
}

/// How many bytes a line takes, its end included, and how many without; by the rule of [`lines`].
pub fn line_length(bytes: &[u8]) -> (usize, usize) {
    let length = bytes.iter().position(|&byte| byte == b'\n' || byte == b'\r').unwrap_or(bytes.len());
    let end = match bytes[length..] {
        [] => 0,
        [b'\r', b'\n', ..] => 2,
        _ => 1,
    };
    (length + end, length)
}

/// The number of the line that begins after these bytes, or goes on there; by the rule of [`lines`].
pub fn line_number(before: &[u8]) -> usize {
    let is_end = |(index, &byte): (usize, &u8)| match byte {
        b'\n' => true,
        b'\r' => before.get(index + 1) != Some(&b'\n'),
        _ => false,
    };
    1 + before.iter().enumerate().filter(|&byte| is_end(byte)).count()
}

/// A number as it is written in text. C libraries write what is none in ways of their own: `-nan(ind)`, `-1.#IND`, `1.#QNAN`,
/// `1.#INF`.
pub fn number(word: &str) -> Option<f64> {
    word.parse().ok().or_else(|| no_number(word))
}

#[cold]
fn no_number(word: &str) -> Option<f64> {
    let digits = word.trim_start_matches(['+', '-']);
    let sign = if word.starts_with('-') { -1.0 } else { 1.0 };
    if let Some((whole, kind)) = digits.split_once(".#") {
        let is_infinite = kind.get(..3).is_some_and(|kind| kind.eq_ignore_ascii_case("inf"));
        return whole.parse::<u32>().ok().map(|_| if is_infinite { sign * f64::INFINITY } else { f64::NAN });
    }
    let is_nan = digits.get(..3).is_some_and(|start| start.eq_ignore_ascii_case("nan"));
    (is_nan && digits[3..].starts_with(['(', 's', 'q', 'S', 'Q'])).then_some(f64::NAN)
}

/// Letters of a file that a sentence quotes at most.
const MOST_QUOTED: usize = 60;

/// What is written in a file, in quotation marks, without control characters, and no longer than one reads.
pub fn quoted(text: &str) -> String {
    match text.char_indices().nth(MOST_QUOTED) {
        Some((end, _)) => format!("{:?}...", &text[..end]),
        None => format!("{text:?}"),
    }
}

/// Why a word is no number, or what is missing instead; without a full stop.
pub fn why_no_number(word: Option<&str>) -> String {
    match word {
        None => "it is missing".to_owned(),
        Some(word) if number(&word.replacen(',', ".", 1)).is_some() => {
            format!("{} has a decimal comma; save the file with decimal points", quoted(word))
        }
        Some(word) => format!("{} is found", quoted(word)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    #[test]
    fn long_texts_are_quoted_in_part() {
        assert_eq!(quoted("v 1\u{1}2"), r#""v 1\u{1}2""#);
        let long = "\u{fffd}".repeat(MOST_QUOTED);
        assert_eq!(quoted(&long), format!("{long:?}"));
        assert_eq!(quoted(&(long.clone() + "x")), format!("{long:?}..."));
    }

    #[test]
    fn lines_end_by_any_of_three_signs() {
        let numbered: Vec<_> = lines("a\r\nb\rc\n\nd\r\r\ne").collect();
        assert_eq!(numbered, [(1, "a"), (2, "b"), (3, "c"), (4, ""), (5, "d"), (6, ""), (7, "e")]);
        for text in ["a\nb\n", "a\rb\r", "a\r\nb\r\n", "a\nb", "a\rb"] {
            let lines: Vec<_> = lines(text).map(|(_, line)| line).filter(|line| !line.is_empty()).collect();
            assert_eq!(lines, ["a", "b"], "{text:?}");
        }
    }

    #[test]
    fn what_is_no_number_is_read_as_that_in_all_spellings() {
        for word in ["nan", "-NaN", "-nan(ind)", "NAN(0x7)", "nan(snan)", "1.#QNAN", "-1.#IND", "1.#SNAN0", "1.#J"] {
            assert!(number(word).is_some_and(f64::is_nan), "{word}");
        }
        assert_eq!(
            ["1.#INF", "-1.#INF00", "inf", "-Infinity"].map(|word| number(word).unwrap().signum()),
            [1.0, -1.0, 1.0, -1.0]
        );
        for word in ["", "nano", "1.#", "x.#IND", "0,5", "1.2.3", "--", "nä"] {
            assert!(number(word).is_none() || word == "1.#", "{word}");
        }
        assert!(why_no_number(Some("-0,5")).contains("decimal comma"));
        assert!(!why_no_number(Some("a,5")).contains("decimal comma"));
    }

    #[test]
    fn utf_16_is_told_from_bytes_and_text() {
        let utf16 = |text: &str, is_little: bool| -> Vec<u8> {
            text.encode_utf16()
                .flat_map(|unit| if is_little { unit.to_le_bytes() } else { unit.to_be_bytes() })
                .collect()
        };
        for text in ["v 0 0 0\n", "\u{feff}OFF\n3 1 0\n"] {
            assert!(is_utf16(&utf16(text, true)) && is_utf16(&utf16(text, false)) && !is_utf16(text.as_bytes()));
        }
        for bytes in [&b""[..], b"\0\0\0\0", b"\xFF\xFE", b"a\0\x01\0", b"glTF\x02\0\0\0"] {
            assert!(!is_utf16(bytes), "{bytes:?}");
        }
    }
}
