//! Roots: what windows and straight lines start from, each by a number, and the sources that they lead back to.

use heatwalk_surface::{Element, VertexId};

use super::origin::Origin;
use super::portals::Portals;
use super::wavefront::Wavefront;

/// What windows start from, and straight lines.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Root {
    /// One that paths bend at.
    Vertex(VertexId),
    /// The number of a source.
    Source(usize),
    /// An end of a portal, reached through the portal.
    End(u32),
    /// A side of a segment.
    Side(u32),
}

impl Wavefront {
    /// What a root is the number of.
    pub(super) fn root(&self, root: u32) -> Root {
        let (vertices, sources) = (self.values.len() as u32, self.sources.len() as u32);
        match root.checked_sub(vertices) {
            None => Root::Vertex(VertexId(root)),
            Some(number) if number < sources => Root::Source(number as usize),
            Some(number) => match (number - sources).checked_sub(self.ends.values.len() as u32) {
                None => Root::End(number - sources),
                Some(side) => Root::Side(side),
            },
        }
    }

    pub(super) fn root_of_side(&self, side: u32) -> u32 {
        self.root_of_end(self.ends.values.len() as u32) + side
    }

    pub(super) fn root_of_end(&self, end: u32) -> u32 {
        (self.values.len() + self.sources.len()) as u32 + end
    }

    /// The distance at a root.
    #[cold]
    pub(super) fn value_of_root(&self, root: u32) -> f64 {
        match self.root(root) {
            Root::Vertex(vertex) => self.values[vertex],
            Root::Source(number) => self.sources[number].initial_distance(),
            Root::End(end) => self.ends.values[end as usize],
            Root::Side(_) => 0.0,
        }
    }

    /// The number of the source that a root's distance comes from.
    pub(crate) fn source_of(&self, mut root: u32) -> u32 {
        loop {
            let origin = match self.root(root) {
                Root::Source(number) => return number as u32,
                Root::Side(_) => return u32::MAX,
                Root::Vertex(vertex) => self.origins[vertex.index()],
                Root::End(end) => self.ends.origins[Portals::across(end) as usize],
            };
            root = match origin {
                Origin::Straight { root, .. } | Origin::Window { root, .. } => root,
                Origin::None | Origin::Portal => return u32::MAX,
            };
        }
    }

    /// The number of the source that a vertex's distance comes from; none where none is reached.
    pub(crate) fn source_of_vertex(&self, vertex: VertexId) -> Option<u32> {
        self.source_of_origin(self.origins[vertex.index()])
    }

    /// The same of a target.
    pub(crate) fn source_of_target(&self, target: usize) -> Option<u32> {
        self.source_of_origin(self.targets.origins[target])
    }

    fn source_of_origin(&self, origin: Origin) -> Option<u32> {
        match origin {
            Origin::Straight { root, .. } | Origin::Window { root, .. } => Some(self.source_of(root)),
            Origin::None | Origin::Portal => None,
        }
    }

    /// The number of the source that the distance of an end of a portal comes from.
    pub(crate) fn source_of_end(&self, end: u32) -> u32 {
        match self.ends.origins[end as usize] {
            Origin::None => u32::MAX,
            Origin::Portal => self.source_of(self.root_of_end(end)),
            Origin::Straight { root, .. } | Origin::Window { root, .. } => self.source_of(root),
        }
    }
}
