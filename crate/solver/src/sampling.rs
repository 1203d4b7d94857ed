//! Samples spread over a surface: each is a vertex that is farthest from those before it, by exact distances.
//!
//! Such samples cover a surface within twice the least radius by which as many places could (Gonzalez, "Clustering to minimize the
//! maximum intercluster distance", 1985; on surfaces Peyré and Cohen, "Geodesic remeshing using front propagation", 2006).

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::sync::Arc;

use heatwalk_sparse::Progress;
use heatwalk_surface::{VertexData, VertexId};

use crate::error::{Error, Result};
use crate::exact::{ExactGeometry, Wavefront};

/// How many samples are wanted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SampleCount {
    /// So many, or as many as there are vertices.
    Exactly(usize),
    /// Until no vertex is farther than this from one, in the file's unit. No two are nearer to each other.
    Within(f64),
}

/// Vertices spread over a surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Samples {
    /// In the order in which they were found: any first so many are spread over the surface.
    pub vertices: Vec<VertexId>,
    /// `#V`, the exact distance of each vertex from the nearest of them, in the file's unit; infinite on components without one.
    pub distances: VertexData<f64>,
    /// `#V`, the number of the nearest sample of each vertex; of several, of the first. `None` on components without one.
    pub nearest: VertexData<Option<u32>>,
}

impl Samples {
    /// The distance of the vertex that is farthest from all samples; infinite where components have none.
    pub fn covering_radius(&self) -> f64 {
        self.distances.iter().copied().fold(0.0, f64::max)
    }
}

/// Begins with a vertex, and adds the one that is farthest until there are enough. Components without a sample come first, in the order of
/// their vertices.
///
/// Each search goes as far as the new sample was from those before, so that a thousand take about ten times as long as one.
///
/// # Errors
/// [`Error::BadParameter`] for a count of 0, or a radius that is not positive and finite; [`Error::NotExact`] where faces have different
/// costs; [`Error::Surface`] for a vertex that does not exist; [`Error::OutOfMemory`]; [`Error::Cancelled`].
pub fn farthest_samples(
    geometry: &Arc<ExactGeometry>,
    first: VertexId,
    count: SampleCount,
    progress: Progress<'_>,
) -> Result<Samples> {
    match count {
        SampleCount::Exactly(0) => {
            return Err(Error::BadParameter { name: "count", value: "0".to_owned(), range: "1 or more" });
        }
        SampleCount::Within(radius) if !(radius > 0.0 && radius.is_finite()) => {
            let value = radius.to_string();
            return Err(Error::BadParameter { name: "radius", value, range: "a positive number" });
        }
        _ => {}
    }
    let vertices = geometry.surface().vertex_count();
    let mut samples = Samples {
        vertices: Vec::new(),
        distances: vec![f64::INFINITY; vertices].into(),
        nearest: vec![None; vertices].into(),
    };
    let mut front = Wavefront::new(Arc::clone(geometry), &[first])?;
    // Bits of numbers that are not negative order as the numbers do. Distances only fall: what waits with more waits anew.
    let key = |vertex: VertexId, distance: f64| (distance.to_bits(), Reverse(vertex.0));
    let mut farthest: BinaryHeap<_> = geometry.surface().vertices().map(|vertex| key(vertex, f64::INFINITY)).collect();
    let mut next = Some((first, f64::INFINITY));
    while let Some((sample, reach)) = next {
        front.grow(reach, progress)?;
        let number = samples.vertices.len() as u32;
        samples.vertices.push(sample);
        for &vertex in front.reached() {
            let distance = front.values()[vertex];
            if distance < samples.distances[vertex] {
                (samples.distances[vertex], samples.nearest[vertex]) = (distance, Some(number));
            }
        }
        next = loop {
            let Some((bits, Reverse(vertex))) = farthest.pop() else { break None };
            let (vertex, known) = (VertexId(vertex), samples.distances[VertexId(vertex)]);
            if known.to_bits() == bits {
                break Some((vertex, known));
            }
            farthest.push(key(vertex, known));
        };
        next = next.filter(|&(_, distance)| match count {
            SampleCount::Exactly(count) => samples.vertices.len() < count && distance > 0.0,
            SampleCount::Within(radius) => distance > radius,
        });
        if let Some((vertex, _)) = next {
            front.restart(&[vertex])?;
        }
    }
    Ok(samples)
}
