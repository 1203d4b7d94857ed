//! Nodes by the numbers that the file gives them, which need not be in order nor without gaps.

use std::collections::HashMap;

use glam::DVec3;
use heatwalk_model::io::Budget;

use super::format::GMSH;
use crate::io::cells::Numbers;
use crate::io::error::Result;

pub struct Nodes<'a> {
    pub budget: &'a Budget,
    positions: Vec<DVec3>,
    numbers: Vec<u64>,
}

impl<'a> Nodes<'a> {
    pub fn new(budget: &'a Budget) -> Self {
        Self { budget, positions: Vec::new(), numbers: Vec::new() }
    }

    pub fn add(&mut self, number: u64, position: [f64; 3]) -> Result<()> {
        self.budget.push(&mut self.numbers, number)?;
        Ok(self.budget.push(&mut self.positions, position.into())?)
    }

    /// Positions in file order, and how the file numbers them.
    pub fn finish(self) -> Result<(Vec<DVec3>, Numbers)> {
        let first = self.numbers.first().copied().unwrap_or_default();
        let count = self.positions.len() as u32;
        if self.numbers.iter().zip(first..).all(|(&number, expected)| number == expected) {
            return Ok((self.positions, Numbers::From(first, count)));
        }
        // Half as many places again, and a byte for each, as hash maps have.
        self.budget.take_items::<(u64, u64)>(2 * self.numbers.len())?;
        let mut vertices = HashMap::with_capacity(self.numbers.len());
        for (&number, vertex) in self.numbers.iter().zip(0..) {
            if vertices.insert(number, vertex).is_some() {
                let problem = "its number is given to another node, too; repair the file".to_owned();
                let place = format!("node {number}");
                return Err(heatwalk_model::Error::Malformed { format: GMSH, place, problem }.into());
            }
        }
        Ok((self.positions, Numbers::Any(vertices)))
    }
}
