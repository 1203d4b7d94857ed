//! What a solution shall be at places.

use std::collections::BTreeMap;

use heatwalk_base::sort;
use heatwalk_base::union_find::UnionFind;
use heatwalk_sparse::Functional;
use heatwalk_surface::VertexId;

/// The value that a solution shall have at a place: at a vertex, or as a weighted mean of vertices.
#[derive(Debug, Clone, PartialEq)]
pub struct Constraint {
    pub(super) functional: Functional,
    pub(super) value: f64,
}

impl Constraint {
    /// At the mean of vertices by weights that sum to 1, such as barycentric ones.
    ///
    /// # Panics
    /// Without a vertex.
    pub fn new(support: impl IntoIterator<Item = (VertexId, f64)>, value: f64) -> Self {
        let functional: Functional = support.into_iter().map(|(vertex, weight)| (vertex.0, weight)).collect();
        assert!(!functional.is_empty(), "a constraint is at some vertex");
        Self { functional, value }
    }

    /// At a vertex.
    pub fn at_vertex(vertex: VertexId, value: f64) -> Self {
        Self::new([(vertex, 1.0)], value)
    }

    /// What a potential has to meet beyond a region of known values: on the rim of each patch of the region, the mean of the
    /// values there. `touched` are the elements with corners in the region, each with whether all of them are; `value` tells
    /// that of a vertex in the region, of `vertices` in all. A patch that covers its whole component has no rim, and there is
    /// nothing beyond it.
    pub fn of_rims<const N: usize>(
        vertices: usize,
        touched: impl IntoIterator<Item = ([u32; N], bool)>,
        value: impl Fn(u32) -> Option<f64>,
    ) -> Vec<Self> {
        let patches = UnionFind::new(vertices);
        let mut rim: Vec<(u32, f64)> = Vec::new();
        for (corners, is_inside) in touched {
            if is_inside {
                corners.windows(2).for_each(|side| patches.join(side[0], side[1]));
            } else {
                rim.extend(corners.into_iter().filter_map(|vertex| Some((vertex, value(vertex)?))));
            }
        }
        sort::sort_by_key(&mut rim, |&(vertex, _)| vertex);
        rim.dedup_by_key(|&mut (vertex, _)| vertex);
        let mut rims: BTreeMap<u32, Vec<(u32, f64)>> = BTreeMap::new();
        for (vertex, value) in rim {
            rims.entry(patches.least(vertex)).or_default().push((vertex, value));
        }
        let mean = |rim: Vec<(u32, f64)>| {
            let weight = 1.0 / rim.len() as f64;
            let value = rim.iter().map(|&(_, value)| weight * value).sum();
            Self::new(rim.into_iter().map(|(vertex, _)| (VertexId(vertex), weight)), value)
        };
        rims.into_values().map(mean).collect()
    }

    /// The vertex, where it is at one.
    pub(super) fn vertex(&self) -> Option<u32> {
        match self.functional[..] {
            [(vertex, _)] => Some(vertex),
            _ => None,
        }
    }
}
