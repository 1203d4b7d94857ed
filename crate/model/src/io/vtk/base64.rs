//! Base64 (RFC 4648), one text after another: a header and what it is of may be encoded apart.

use base64::Engine as _;

use crate::io::base64::BASE64;
use crate::io::budget::Budget;

/// Text that is decoded as far as it is taken.
pub struct Base64<'a> {
    text: &'a [u8],
    /// Decoded and not taken yet.
    rest: Vec<u8>,
}

impl<'a> Base64<'a> {
    pub fn new(text: &'a [u8]) -> Self {
        Self { text, rest: Vec::new() }
    }

    /// The next bytes, which are lent; none where there are not so many, or the budget has no room for them.
    pub fn take(&mut self, budget: &Budget, count: usize) -> Option<Vec<u8>> {
        if count / 3 > self.text.len() / 4 + 1 {
            return None;
        }
        budget.lend(count as u64).ok()?;
        let mut bytes = Vec::with_capacity(count + 3);
        bytes.append(&mut self.rest);
        while bytes.len() < count {
            self.group(&mut bytes)?;
        }
        self.rest = bytes.split_off(count);
        Some(bytes)
    }

    /// Decodes four letters, of which padding may be the last two.
    fn group(&mut self, bytes: &mut Vec<u8>) -> Option<()> {
        let (mut group, mut length) = ([0; 4], 0);
        while length < group.len() {
            let (&letter, rest) = self.text.split_first()?;
            self.text = rest;
            if !letter.is_ascii_whitespace() {
                group[length] = letter;
                length += 1;
            }
        }
        BASE64.decode_vec(group, bytes).ok()
    }
}
