//! What the readers of XML formats share. Namespaces are not told apart: the names of these formats do not clash.

use std::borrow::Cow;

use quick_xml::events::{BytesStart, Event};
use quick_xml::{Reader, XmlVersion};

use super::reader::Reporter;
use crate::error::Result;

/// Bytes in which the root element begins.
#[cfg(any(feature = "gifti", feature = "vtk"))]
const HEAD: usize = 1024;

/// A document, event by event.
pub struct Document<'a> {
    reporter: Reporter,
    /// Of the document, for errors.
    name: &'a str,
    reader: Reader<&'a [u8]>,
}

/// What comes next in a document.
pub enum Node<'a> {
    /// An element begins; `is_empty` where it ends at once.
    Start { element: BytesStart<'a>, is_empty: bool },
    /// The element of this name ends.
    End(String),
    #[cfg(any(feature = "gifti", feature = "vtk"))]
    Text(Cow<'a, str>),
}

impl<'a> Document<'a> {
    pub fn new(reporter: Reporter, name: &'a str, text: &'a str) -> Self {
        Self { reporter, name, reader: Reader::from_str(text) }
    }

    /// None at the end.
    ///
    /// # Errors
    /// Where it is not well-formed.
    pub fn next(&mut self) -> Result<Option<Node<'a>>> {
        loop {
            let event = self.reader.read_event();
            let event =
                event.map_err(|_| self.broken("the XML is not well-formed; the file is damaged, save it again"))?;
            return Ok(Some(match event {
                Event::Start(element) => Node::Start { element, is_empty: false },
                Event::Empty(element) => Node::Start { element, is_empty: true },
                Event::End(element) => Node::End(element.local_name().as_ref().to_owned()),
                #[cfg(any(feature = "gifti", feature = "vtk"))]
                Event::Text(text) => Node::Text(text.into_inner()),
                #[cfg(any(feature = "gifti", feature = "vtk"))]
                Event::CData(text) => Node::Text(text.into_inner()),
                Event::Eof => return Ok(None),
                _ => continue,
            }));
        }
    }

    /// The text up to the end of the element of this name.
    ///
    /// # Errors
    /// As [`Self::next`], and where the document ends before.
    #[cfg(any(feature = "gifti", feature = "vtk"))]
    pub fn text(&mut self, name: &str) -> Result<String> {
        let mut text = String::new();
        loop {
            match self.next()? {
                Some(Node::Text(more)) => text.push_str(&more),
                Some(Node::End(ended)) if ended == name => return Ok(text),
                Some(_) => {}
                None => return Err(self.broken("the file is cut short; copy it again")),
            }
        }
    }

    /// Says what is wrong here.
    pub fn broken(&self, problem: &str) -> crate::Error {
        self.reporter.at(format!("{}, byte {}", self.name, self.reader.buffer_position()), problem)
    }
}

/// Whether the root element of a document begins so, soon enough.
#[cfg(any(feature = "gifti", feature = "vtk"))]
pub fn has_root(bytes: &[u8], start: &[u8]) -> bool {
    find(&bytes[..bytes.len().min(HEAD)], start).is_some()
}

/// Where bytes are in others first.
#[cfg(any(feature = "gifti", feature = "vtk"))]
pub fn find(bytes: &[u8], wanted: &[u8]) -> Option<usize> {
    bytes.windows(wanted.len()).position(|window| window == wanted)
}

/// The attributes of an element by their local names; broken ones are left out.
pub fn attributes<'a>(element: &'a BytesStart) -> impl Iterator<Item = (&'a str, Cow<'a, str>)> {
    let mut attributes = element.attributes();
    attributes.with_checks(false);
    attributes.flatten().map(|attribute| {
        let name = attribute.key.local_name().into_inner();
        if !attribute.value.contains('&') {
            return (name, attribute.value);
        }
        let value = attribute.normalized_value(XmlVersion::Explicit1_0).map(Cow::into_owned);
        (name, value.unwrap_or_default().into())
    })
}
