//! Closing of a function on the vertices of a mesh: valleys are filled up, as far as they are narrow.
//!
//! Serra, "Image Analysis and Mathematical Morphology" (1982), chapter XII: a dilation, which takes the largest value within so many
//! edges, then an erosion, which takes the smallest. The result is nowhere below the function.

use heatwalk_surface::VertexId;
use heatwalk_surface::csr::Csr;

/// The closing by `edges` edges of `values` (`#V`), none of which is above `top`. Vertices at the top, which most are, take
/// no time.
pub(super) fn closed(adjacent: &Csr<VertexId, VertexId>, values: &[f32], top: f32, edges: usize) -> Vec<f32> {
    let mut values = values.to_vec();
    let mut next = values.clone();
    for _ in 0..edges {
        for ((vertex, others), next) in adjacent.rows().zip(&mut next) {
            let own = values[vertex.0 as usize];
            if own < top {
                *next = others.iter().map(|other| values[other.0 as usize]).fold(own, f32::max);
            }
        }
        values.copy_from_slice(&next);
    }
    for _ in 0..edges {
        for (vertex, others) in adjacent.rows() {
            let own = values[vertex.0 as usize];
            if own < top {
                for other in others {
                    next[other.0 as usize] = next[other.0 as usize].min(own);
                }
            }
        }
        values.copy_from_slice(&next);
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Vertices in a row.
    fn row(count: usize) -> Csr<VertexId, VertexId> {
        let edges: Vec<[VertexId; 2]> = (1..count as u32).map(|end| [VertexId(end - 1), VertexId(end)]).collect();
        Csr::adjacent(count, &edges)
    }

    #[test]
    fn narrow_valleys_are_filled() {
        assert_eq!(closed(&row(6), &[1.0, 0.8, 0.2, 0.8, 1.0, 1.0], 1.0, 2), [1.0; 6]);
        assert_eq!(closed(&row(5), &[0.9, 0.8, 0.1, 0.6, 0.5], 1.0, 1), [0.9, 0.8, 0.6, 0.6, 0.6]);
    }

    #[test]
    fn what_falls_on_and_on_stays() {
        let slope = [1.0, 0.9, 0.7, 0.6, 0.3, 0.2, 0.2, 0.2];
        assert_eq!(closed(&row(8), &slope, 1.0, 2), slope);
    }
}
