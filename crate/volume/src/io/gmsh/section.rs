//! The sections of nodes and of elements.

use super::element::element;
use super::format::{Header, Layout, TEXT};
use super::nodes::Nodes;
use crate::io::cells::NamedCells;
use crate::io::error::Result;
use crate::io::input::Input;

/// The number of an element, which nothing here needs.
const ELEMENT: &str = "the number of an element";

/// A section whose contents come next.
pub struct Section<'a, 'b> {
    input: Input<'a>,
    header: &'b Header,
}

impl<'a, 'b> Section<'a, 'b> {
    pub fn new(mut input: Input<'a>, header: &'b Header) -> Self {
        if header.encoding != TEXT {
            // Bytes begin after the end of the line.
            input.line();
        }
        Self { input, header }
    }

    /// A count, or a number of a node in version 4.1.
    fn size(&mut self, what: &str) -> Result<usize> {
        let number = if self.header.has_long_sizes { self.input.long(what)? } else { self.input.int(what)? };
        self.input.count(number, what)
    }

    fn int_size(&mut self, what: &str) -> Result<usize> {
        let number = self.input.int(what)?;
        self.input.count(number, what)
    }

    /// The number of rows of versions 2, which is text on a line of its own even before bytes.
    fn row_count(&mut self, what: &str) -> Result<usize> {
        let count = self.int_size(what)?;
        if self.header.encoding != TEXT {
            self.input.line();
        }
        self.input.encoding = self.header.encoding;
        Ok(count)
    }

    /// The number of blocks of versions 4.
    fn block_count(&mut self) -> Result<usize> {
        self.input.encoding = self.header.encoding;
        let blocks = self.size("the number of blocks")?;
        self.size("the number of all rows")?;
        if self.header.layout == Layout::Blocks {
            self.size("the least number")?;
            self.size("the greatest number")?;
        }
        Ok(blocks)
    }

    /// What comes after the section, as text.
    fn rest(mut self) -> Input<'a> {
        self.input.encoding = TEXT;
        self.input
    }

    /// Reads the section of nodes. Returns what comes after it. `is_parametric`: rows of versions 2 go on with the entity that a node
    /// is on, and its parameters there.
    pub fn nodes(mut self, nodes: &mut Nodes, is_parametric: bool) -> Result<Input<'a>> {
        if self.header.layout == Layout::Rows {
            for _ in 0..self.row_count("the number of nodes")? {
                let number = self.node_number()?;
                nodes.add(number, self.position()?)?;
                if is_parametric {
                    let dimension = self.input.int("the dimension of an entity")?;
                    self.input.int("an entity")?;
                    self.parameters(if (1..=2).contains(&dimension) { dimension } else { 0 })?;
                }
            }
            return Ok(self.rest());
        }
        for _ in 0..self.block_count()? {
            let first = self.input.int("an entity")?;
            let second = self.input.int("an entity")?;
            let dimension = if self.header.layout == Layout::Blocks { first } else { second };
            let is_parametric = self.input.int("whether nodes have parameters")? != 0;
            let parameters = if is_parametric { dimension.clamp(0, 3) } else { 0 };
            let count = self.size("the number of nodes of a block")?;
            let mut numbers = Vec::new();
            if self.header.layout == Layout::Blocks {
                nodes.budget.reserve(&mut numbers, self.input.plausible(count))?;
                for _ in 0..count {
                    let number = self.size("the number of a node")? as u64;
                    nodes.budget.push(&mut numbers, number)?;
                }
            }
            for row in 0..count {
                let number = match numbers.get(row) {
                    Some(&number) => number,
                    None => self.node_number()?,
                };
                nodes.add(number, self.position()?)?;
                self.parameters(parameters)?;
            }
        }
        Ok(self.rest())
    }

    fn parameters(&mut self, count: i64) -> Result<()> {
        (0..count).try_for_each(|_| self.input.double("a parameter of a node").map(drop))
    }

    fn node_number(&mut self) -> Result<u64> {
        Ok(self.int_size("the number of a node")? as u64)
    }

    fn position(&mut self) -> Result<[f64; 3]> {
        let mut position = [0.0; 3];
        for coordinate in &mut position {
            *coordinate = self.input.double("a coordinate of a node")?;
        }
        Ok(position)
    }

    /// Reads the section of elements. Returns what comes after it.
    pub fn elements(mut self, cells: &mut NamedCells) -> Result<Input<'a>> {
        if self.header.layout != Layout::Rows {
            for _ in 0..self.block_count()? {
                self.input.int("an entity")?;
                self.input.int("an entity")?;
                let kind = self.input.int("the type of elements")?;
                for _ in 0..self.size("the number of elements of a block")? {
                    if self.header.layout == Layout::Blocks {
                        self.size(ELEMENT)?
                    } else {
                        self.int_size(ELEMENT)?
                    };
                    self.element(kind, cells)?;
                }
            }
            return Ok(self.rest());
        }
        let count = self.row_count("the number of elements")?;
        let mut rows = 0;
        while rows < count {
            // Bytes come in blocks, whose rows have no type of their own.
            let is_text = self.header.encoding == TEXT;
            if is_text {
                self.int_size(ELEMENT)?;
            }
            let kind = self.input.int("the type of an element")?;
            let own = if is_text { 1 } else { self.int_size("the number of elements of a block")? };
            let tags = self.int_size("the number of tags")?;
            for _ in 0..own {
                if !is_text {
                    self.int_size(ELEMENT)?;
                }
                for _ in 0..tags {
                    self.input.int("a tag of an element")?;
                }
                self.element(kind, cells)?;
            }
            // Without elements, a block counts as one: it must not go on for ever.
            rows = rows.saturating_add(own.max(1));
        }
        Ok(self.rest())
    }

    /// The nodes of an element.
    fn element(&mut self, kind: i64, cells: &mut NamedCells) -> Result<()> {
        let Some(element) = element(kind) else {
            let feature = format!("an element of type {kind}");
            return Err(self.input.unsupported(feature, "save the tetrahedra alone").into());
        };
        let corners = element.kind.corner_count();
        for node in 0..element.nodes {
            let what = "a node of an element";
            let number = if self.header.layout == Layout::Blocks { self.size(what)? } else { self.int_size(what)? };
            if node < corners {
                cells.corner(element.kind, number as u64)?;
            }
        }
        cells.end(element.kind, element.nodes > corners)?;
        Ok(())
    }
}
