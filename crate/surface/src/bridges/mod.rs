//! Bridges between connected components that touch, pierce or nearly touch each other.
//!
//! Models are assembled of parts that share no vertex: each is a component of its own, and no path on the surface leads from one
//! to another. Portals let distance and paths across. They lead across cracks within a component, too.

mod boxes;
mod budget;
mod cells;
mod cracks;
mod distances;
mod find;
mod hierarchy;
mod links;
mod portals;
mod rule;
mod scene;
mod search;
#[cfg(test)]
mod tests;
mod tolerance;
mod triangles;
mod visit;
mod walls;

pub use links::Link;
pub use rule::BridgeRule;
pub(crate) use triangles::nearest_on_triangle;

use heatwalk_base::union_find::UnionFind;

use crate::point::Place;
use crate::surface::Surface;
use crate::triangle;

/// A place to cross from one component to another, or across a crack within one, either way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Portal {
    /// Points of two components, or on both sides of a crack.
    pub ends: [Place; 2],
    /// Distance between them in space, in the file's unit: what crossing costs.
    pub gap: f64,
}

/// Where two components meet, or cracks within one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Contact {
    /// The components, the lower number first; twice the same for cracks within it.
    pub components: [u32; 2],
    /// The first of the contact's portals.
    pub first: u32,
    /// How many it has.
    pub count: u32,
}

/// What joins the components of a surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Bridges {
    /// Contact after contact.
    portals: Vec<Portal>,
    contacts: Vec<Contact>,
    /// `#components`, the number of the group of each, from 0; empty for no surface in particular.
    groups: Vec<u32>,
    is_complete: bool,
}

/// Of no surface in particular.
impl Default for Bridges {
    fn default() -> Self {
        Self { portals: Vec::new(), contacts: Vec::new(), groups: Vec::new(), is_complete: true }
    }
}

impl Bridges {
    /// Of a surface's contacts: two components, the lower number first, and their portals.
    pub fn new(surface: &Surface, contacts: Vec<([u32; 2], Vec<Portal>)>) -> Self {
        let components = surface.report().components;
        let sets = UnionFind::new(components);
        let mut bridges = Self::default();
        for (components, portals) in contacts {
            let [first, count] = [bridges.portals.len(), portals.len()].map(|number| number as u32);
            sets.join(components[0], components[1]);
            bridges.contacts.push(Contact { components, first, count });
            bridges.portals.extend(portals);
        }
        let mut groups = 0;
        for component in 0..components as u32 {
            // The least component of a group comes first.
            let least = sets.least(component);
            let group = bridges.groups.get(least as usize).copied().unwrap_or(groups);
            groups += u32::from(least == component);
            bridges.groups.push(group);
        }
        bridges
    }

    /// The same portals on the surface in another pose, as far apart as they are there.
    #[must_use]
    pub fn carried(&self, to: &Surface) -> Self {
        let moved = |portal: &Portal| {
            let [start, end] = portal.ends.map(|place| place.position(to));
            Portal { gap: triangle::length(end - start), ..*portal }
        };
        Self { portals: self.portals.iter().map(moved).collect(), ..self.clone() }
    }

    /// Components that are joined count once.
    pub fn group_count(&self) -> usize {
        self.groups.iter().max().map_or(0, |&last| last as usize + 1)
    }

    /// Contact after contact.
    pub fn portals(&self) -> &[Portal] {
        &self.portals
    }

    /// Pairs of components that meet, and components with cracks within.
    pub fn contacts(&self) -> &[Contact] {
        &self.contacts
    }

    /// Whether all contacts were looked at. Where parts meet far more often than those of an assembly do, some are not, and
    /// components that are joined by these alone are of different groups.
    pub fn is_complete(&self) -> bool {
        self.is_complete
    }

    /// The portals across cracks within components.
    pub fn across_cracks(&self) -> impl Iterator<Item = &Portal> {
        let cracks = self.contacts.iter().filter(|contact| contact.components[0] == contact.components[1]);
        cracks.flat_map(|contact| &self.portals[contact.first as usize..][..contact.count as usize])
    }

    /// The widest gap between the boundaries on both sides of them, in the file's unit; 0 without any.
    pub fn crack_width(&self) -> f64 {
        self.across_cracks().map(|portal| portal.gap).fold(0.0, f64::max)
    }

    /// The group of a component: components of one group are reached from each other.
    pub fn group(&self, component: u32) -> u32 {
        self.groups.get(component as usize).copied().unwrap_or(component)
    }
}
