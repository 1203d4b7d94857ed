//! What the readers of XML formats share. Namespaces are not told apart: the names of these formats do not clash.

use std::borrow::Cow;

use quick_xml::events::{BytesStart, Event};
use quick_xml::{Reader, XmlVersion};

use super::reader::Reporter;
use crate::error::Result;

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
    #[cfg(feature = "vtk")]
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
                #[cfg(feature = "vtk")]
                Event::Text(text) => Node::Text(text.into_inner()),
                Event::Eof => return Ok(None),
                _ => continue,
            }));
        }
    }

    /// Says what is wrong here.
    pub fn broken(&self, problem: &str) -> crate::Error {
        self.reporter.at(format!("{}, byte {}", self.name, self.reader.buffer_position()), problem)
    }
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
